# SPDX-License-Identifier: Apache-2.0
"""Events and notes of a run in the dataset of `solve_time`."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.time import run_time, solve_time
from pitchpoint.system.compile import compile_model
from tests.support.machines import compiled, pair
from tests.support.model_files import TORSIONAL_PAIR


def test_events_have_a_dimension_of_their_own() -> None:
    text = TORSIONAL_PAIR.replace("duration: 0.5 s", "duration: 0.02 s, events: [pair_entry]")
    model = loads_model(text)
    scenario = model.scenarios["steady"]
    data = solve_time(compile_model(model, scenario))
    # 25 Hz, 50 teeth, 0.02 s
    assert data.sizes["event"] == pytest.approx(25, abs=1)
    assert set(data["event_name"].values) == {"pair_entry[stage]"}
    assert set(data["event_direction"].values) == {1}
    np.testing.assert_allclose(np.diff(data["event_time"]), 1.0 / 1250.0, rtol=0.02)
    assert data["mesh_force[stage]"].dims == ("time",)
    assert isinstance(data.attrs["notes"], str)


def test_both_methods_find_the_same_events_where_the_gears_turn_back() -> None:
    """Several functions change sign at the instant of the reversal: a restart there loses none."""
    found = []
    for method in ("generalized_alpha", "runge_kutta"):
        scenario = (
            'scenarios:\n  to_and_fro: {drive: {driver: {speed: "20*cos(2*pi*10*t)"}}, duration: 0.1 s, '
            f"method: {method}, events: [pair_entry, pair_exit, sliding_reversal]}}\n"
        )
        text = pair("{law: constant, value: 3e8 N/m}, damper: {ratio: 0.1}", rest=scenario)
        done = run_time(compiled(text, "to_and_fro")[1])
        assert done.status == OK
        found.append(sorted((done.event_names[int(e[1])], e[0], e[2]) for e in done.events))
    assert [(name, direction) for name, _, direction in found[0]] == [(n, d) for n, _, d in found[1]]
    assert [t for _, t, _ in found[0]] == pytest.approx([t for _, t, _ in found[1]], abs=2e-5)


@pytest.mark.parametrize("method", ["generalized_alpha", "runge_kutta"])
def test_events_of_gears_that_turn_to_and_fro(method: str) -> None:
    """Against the phase itself: a pair enters at A or, backwards, at E; every reversal and passage counts."""
    scenario = (
        'scenarios:\n  to_and_fro: {drive: {driver: {speed: "60*cos(2*pi*10*t)"}}, duration: 0.2 s, '
        f"method: {method}, events: [pair_entry, pair_exit, sliding_reversal]}}\n"
    )
    text = pair("{law: constant, value: 3e8 N/m}, damper: {ratio: 0.1}", rest=scenario)
    system = compiled(text, "to_and_fro")[1]
    done = run_time(system)
    assert done.status == OK
    record = system.records["gear_mesh"][0]
    eps, pitch = float(record["now"]["eps"]), -float(record["now"]["xi_A"]) / float(record["p_bt"])
    # travel of 30 teeth at the driven speed; the load keeps the front flanks in contact
    t = np.linspace(0.0, 0.2, 400_001)
    psi = float(record["now"]["start"][0] + record["xi_0"] / record["p_bt"])
    psi += 30.0 / (2.0 * np.pi) * 60.0 / (20.0 * np.pi) * np.sin(20.0 * np.pi * t)
    expected = []
    for place, forward, backward in (
        (0.0, "pair_entry", "pair_exit"),
        (eps, "pair_exit", "pair_entry"),
        (pitch, "sliding_reversal", "sliding_reversal"),
    ):
        step = np.diff(np.floor(psi - place))
        for k in np.flatnonzero(step):
            expected.append((forward if step[k] > 0 else backward, t[k], step[k]))
    expected += [
        ("turning_reversal", t0, way) for t0, way in ((0.025, -1), (0.075, 1), (0.125, -1), (0.175, 1))
    ]
    found = [(done.event_names[int(e[1])].partition("[")[0], e[0], e[2]) for e in done.events]
    assert len(found) == len(expected) > 60
    for (name, when, way), (a_name, a_when, a_way) in zip(sorted(expected), sorted(found), strict=True):
        assert (name, way) == (a_name, a_way)
        assert when == pytest.approx(a_when, abs=2e-4)


def test_events_of_the_back_flanks_have_names_of_their_own() -> None:
    """Gears pressed on their back flanks and turning forward: the back path is run through backwards."""
    scenario = (
        "scenarios:\n  on: {speed: {driver: 500 rpm}, duration: 0.02 s, events: [pair_entry, pair_exit]}\n"
    )
    text = pair("{law: constant, value: 3e8 N/m}", torque="-200 N m", rest=scenario)
    done = run_time(compiled(text, "on")[1])
    found = {(done.event_names[int(e[1])].partition("[")[0], e[2]) for e in done.events}
    assert found == {("back_pair_entry", -1.0), ("back_pair_exit", -1.0)}


PITCH = ", ".join(f"{8 * math.sin(k * k):.1f} um" for k in range(30))
FLAWS = {
    "perfect": "",
    "pitch": f"deviations: {{pitch: [{PITCH}]}}, ",
    "runout": "deviations: {runout: {amount: 20 um}}, ",
    "modified": "modifications: {both: {tip_relief: {amount: 15 um, length: 1 mm}, helix_slope: 10 um}}, ",
    "next to perfect": "modifications: {both: {tip_relief: {amount: 1e-12, length: 1 mm}}}, ",
}
WITH_FINE_SAMPLES = [
    "perfect",
    pytest.param("pitch", marks=pytest.mark.study),
    "runout",
    "modified",
    pytest.param("next to perfect", marks=pytest.mark.study),
]
STEP = "duration: 0.02 s, step: 2 us"
SPARSE = "duration: 0.003 s, method: runge_kutta"
FINE = f"{SPARSE}, sample_rate: 200 MHz"


def rattling(flaw: str, run: str, *, beta: str = "", damping: str = "damper: {ratio: 0.05}", hertz: float):
    """A pair under a torque that changes sides: results of a run.

    It starts as assembled. In the steady vibration, the wheel swings within the backlash and touches nothing.
    """
    rest = (
        f"scenarios:\n  on: {{drive: {{driver: {{speed: 300 rpm}}}}, {run}, settle_time: 0 s, "
        "events: [contact], start: assembled}\n"
    )
    text = pair(f"{{law: din3990}}, width: slices, slices: 5, {damping}", beta=beta, rest=rest)
    text = text.replace("balance", f'"60 N m*sin({2 * math.pi * hertz}*t/(1 s))"')
    text = text.replace("number_of_teeth: 30", f"{FLAWS[flaw]}number_of_teeth: 30")
    return solve_time(compiled(text.replace("  input: {body: driver, torque: 200 N m}\n", ""), "on")[1])


def compare_contacts(data) -> int:
    """One event for each change of the contact of a flank, none besides; returns their number."""
    time, state = data["time"].values, data["contact_state[stage]"].values
    expected = []
    for name, touches in (
        ("front_gap", (state == 1) | (state == 2)),
        ("back_gap", (state == -1) | (state == 2)),
    ):
        steps = np.diff(touches.astype(int))
        expected += [(time[k], time[k + 1], f"{name}[stage]", steps[k]) for k in np.flatnonzero(steps)]
    found = zip(*(data[f"event_{key}"].values for key in ("time", "name", "direction")), strict=True)
    for (before, after, name, way), (at, an_event, direction) in zip(
        sorted(expected), sorted(found), strict=True
    ):
        assert (an_event, direction) == (name, way)
        # just behind the change, which rounding may put on either side of a sample
        assert before * (1.0 - 1e-12) <= at <= after * (1.0 + 1e-12)
    return len(expected)


@pytest.mark.parametrize("beta", ["", "20 deg"])
@pytest.mark.parametrize("flaw", FLAWS)
def test_contact_events_are_where_the_real_flanks_meet_and_part(flaw: str, beta: str) -> None:
    assert compare_contacts(rattling(flaw, STEP, beta=beta, hertz=127.0)) > 10


@pytest.mark.parametrize("flaw", WITH_FINE_SAMPLES)
def test_runge_kutta_finds_contact_events_to_rounding(flaw: str) -> None:
    """Samples 5 ns apart, hundreds within a step."""
    assert compare_contacts(rattling(flaw, FINE, hertz=1273.0)) >= 2


@pytest.mark.parametrize(
    ("flaw", "run"),
    [
        *((flaw, STEP) for flaw in FLAWS),
        ("perfect", FINE),
        *(pytest.param(f, FINE, marks=pytest.mark.study) for f in ("pitch", "runout", "next to perfect")),
        ("modified", FINE),
    ],
)
def test_flanks_part_where_contact_damping_would_pull(flaw: str, run: str) -> None:
    """At a penetration still, on perfect flanks as on others: what counts is the contact state."""
    damping = "damping: {ratio: 0.3}"
    assert compare_contacts(rattling(flaw, run, damping=damping, hertz=637.0)) >= 2


def test_flanks_that_are_modified_by_next_to_nothing_part_when_perfect_ones_do() -> None:
    """To what the integration leaves: 2e-10 s at this tolerance, 2e-9 s at 1e-7, 4e-12 s at 1e-11."""
    data = [
        rattling(f, f"{SPARSE}, tolerance: 1e-9", damping="damping: {ratio: 0.3}", hertz=637.0)
        for f in ("perfect", "next to perfect")
    ]
    assert data[0]["event_time"].values == pytest.approx(data[1]["event_time"].values, abs=1e-9)
