# SPDX-License-Identifier: Apache-2.0
"""Numbers beyond the model are computed, and said to be so."""

from __future__ import annotations

import math

import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.quasistatic.roll import solve_quasistatic
from pitchpoint.solvers.time import run_time, solve_time
from pitchpoint.sweep.cases import cases_dataset, run_cases
from pitchpoint.sweep.speed import sweep_speed
from pitchpoint.system.compile import compile_model
from pitchpoint.system.remarks import deep_contacts
from tests.support.model_files import TORSIONAL_PAIR

LIMIT = 0.3e-3  # a tenth of the module


@pytest.mark.parametrize(
    ("depth", "told"),
    [(0.99 * LIMIT, ""), (1.01 * LIMIT, "0.303 mm"), (2.0 * LIMIT, "0.6 mm"), (math.nan, "")],
)
def test_penetration_beyond_a_tenth_of_the_module_is_named(depth: float, told: str) -> None:
    """That at the actual centre distance: a shaft that bends away from its mate increases the gap."""
    model = loads_model(TORSIONAL_PAIR)
    tables = [
        {"penetration[stage]": {"min": 0.0, "max": 0.0}},
        {"penetration[stage]": {"min": 0.0, "max": depth}, "deflection[stage]": {"min": 0.0, "max": 1.0}},
    ]
    found = deep_contacts(model, tables)
    assert bool(found) == bool(told)
    if told:
        assert found[0].startswith("meshes.stage: the flank penetration reaches ")
        assert told in found[0]
        assert "limit about 0.1 m_n" in found[0]


def test_results_of_all_kinds_say_it_once() -> None:
    """A torque in the wrong unit: 150 kN m instead of 150 N m, with which the sweep loses its speed."""
    text = TORSIONAL_PAIR.replace("150 N m", "150 kN m").replace("duration: 0.5 s", "duration: 1 ms")
    text = text.replace("points: 81", "points: 2").replace("direction: both", "direction: up")
    text = text.replace("settle_periods: 200, measure_periods: 50", "settle_periods: 1, measure_periods: 1")
    model = loads_model(text + "  roll: {quasi_static: {points: 4}}\n")
    with pytest.raises(SolverError, match="the mean speed left the speed of the sweep") as caught:
        sweep_speed(compile_model(model, "sweep"))
    assert caught.value.partial is not None
    notes = [
        caught.value.partial.attrs["notes"],
        solve_time(compile_model(model, "steady")).attrs["notes"],
        solve_quasistatic(compile_model(model, "roll")).attrs["notes"],
        *cases_dataset(run_cases(model, [{}], "steady")).attrs["notes"],
    ]
    assert [note.count("the flank penetration reaches ") for note in notes] == [1, 1, 1, 1]


@pytest.mark.parametrize(("torque", "share"), [(10.0, None), (1000.0, 1.0)])
def test_contact_damping_that_a_light_load_does_not_reach(torque: float, share: float | None) -> None:
    """The flanks overlap by T/(r_b k); the ramp of the damping is in proportion up to s_0 = 1 um."""
    r_b, k = 0.075 * math.cos(math.radians(20.0)), 4e8
    share = share or torque / (r_b * k) / 1e-6
    text = TORSIONAL_PAIR.replace("150 N m", f"{torque:g} N m").replace("duration: 0.5 s", "duration: 2 ms")
    text = text.replace(
        "law: fourier, mean: 4.0e8 N/m, cosine: [-0.2, -0.1, -0.05]", "law: constant, value: 4e8"
    )
    text = text.replace("{cosine: [1.0e-6, 0.5e-6]}", "{cosine: [1e-15]}")
    text = text.replace("damper: {ratio: 0.05} ", "damping: {ratio: 0.05} ")
    notes = run_time(compile_model(loads_model(text), "steady")).notes
    assert len(notes) == (share < 1.0)
    for note in notes:
        assert note.startswith(
            "mesh stage: the mean penetration of the flanks is 0.355 µm, less than s_0 = 1 µm"
        )
        assert f"reaches {100.0 * share:.3g} % of its value (ratio 0.05 acts as {0.05 * share:.2g})" in note
