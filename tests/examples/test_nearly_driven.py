# SPDX-License-Identifier: Apache-2.0
"""The example `nearly-driven`: flanks cross the backlash in j_bt/|u_bt rate|.

Source: SIMPACK User Meeting 2006, external spur pair "kinematical driven by a transmission ratio which is not
exactly the ratio of the teeth numbers"; the time is closed form. Tolerance 1e-6: the travel is linear in
time, so linear interpolation of the roots is exact but for round-off of the angles.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.time import run_time
from pitchpoint.system.compile import compile_model

FOLDER = Path(__file__).parents[2] / "examples" / "nearly-driven"


@pytest.mark.parametrize(
    ("file", "mismatch_rpm", "gap"), [("spur", 0.2, 138.172e-6), ("internal", 0.1, 150.832e-6)]
)
def test_transit_time(file, mismatch_rpm, gap):
    model = load_model(FOLDER / f"{file}.yaml")
    done = run_time(compile_model(model, "walk"))
    names = [name.partition("[")[0] for name in done.event_names]
    seen = [(names[int(e)], int(sign), t) for t, e, sign in done.events]
    assert [(name, sign) for name, sign, _ in seen] == [
        ("front_gap", 1),
        ("front_gap", -1),
        ("back_gap", 1),
        ("back_gap", -1),
        ("front_gap", 1),
        ("front_gap", -1),
    ]
    pair = model.pairs["stage"]
    assert pair.j_bt == pytest.approx(gap, abs=0.5e-9)
    rate = 0.5 * abs(pair.gear2.d_b) * mismatch_rpm * math.pi / 30.0
    times = [t for _, _, t in seen]
    assert times[2] - times[1] == pytest.approx(pair.j_bt / rate, rel=1e-6)
    assert times[4] - times[3] == pytest.approx(pair.j_bt / rate, rel=1e-6)
    force = done.channels["mesh_force[stage]"]
    assert force["min"] < -1e3 and force["max"] > 1e3


@pytest.mark.parametrize("file", ["spur", "internal"])
def test_every_driven_body_starts_at_the_speed_of_its_drive(file):
    """At the ratio of the teeth it would have to be jerked to its drive in the first step."""
    model = load_model(FOLDER / f"{file}.yaml")
    start = prepare_start(compile_model(model, "walk"), model.scenarios["walk"])
    rpm = start.state.v[start.system.spin("driven")] * 30.0 / math.pi
    assert rpm == pytest.approx({"spur": -199.8, "internal": 99.9}[file], rel=1e-9)
