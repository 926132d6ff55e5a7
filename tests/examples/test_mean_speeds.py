# SPDX-License-Identifier: Apache-2.0
"""No run of an example leaves the speeds of its scenario, and those that are meant to are not watched."""

from __future__ import annotations

from pathlib import Path

from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.speed_drift import watched
from pitchpoint.solvers.time import run_time
from pitchpoint.system.compile import compile_model

EXAMPLES = Path(__file__).parents[2] / "examples"
WATCHED = {
    "advanced-contact/rigid.yaml": {"steady": {"input"}},
    "backlash-oscillator/model.yaml": {"steady": {"driver"}},
    "backlash-oscillator/tip-relief.yaml": {"steady": {"driver"}},
    "bevel-drive/differential.yaml": {"bend": {"cage", "one"}},
    "bevel-drive/spiral.yaml": {"steady": {"motor"}},
    "bevel-drive/straight.yaml": {"steady": {"motor"}},
    "clutch-driveline/engagement.yaml": {"pull_away": set()},
    "clutch-driveline/judder.yaml": {"creep": set()},
    "geared-rotor/model.yaml": {"fast": {"rotor"}},
    "overlap-ratio/pairs.yaml": {"steady": {"driver_070", "driver_085", "driver_100"}},
    "speed-control/model.yaml": {"step": set()},
}
"""Bodies whose mean speed counts, by scenario: a clutch and a controller change the speed on purpose."""


def test_examples_keep_the_speeds_of_their_scenarios():
    wrong = []
    for file, scenarios in WATCHED.items():
        model = load_model(EXAMPLES / file, allow_code=True)
        for name, bodies in scenarios.items():
            scenario = model.scenarios[name]
            system = compile_model(model, scenario)
            start = prepare_start(system, scenario)
            if set(watched(start, scenario)) != bodies:
                wrong.append(f"{file} {name}: watches {sorted(watched(start, scenario))}")
            elif bodies:
                notes = run_time(system, scenario, start=start).notes
                wrong += [f"{file} {name}: {note}" for note in notes if "of the scenario" in note]
    assert wrong == []
