# SPDX-License-Identifier: Apache-2.0
"""Shift table of an eight-speed automatic with four planetary sets: ratios, torques and modes of its gears.

The ratios are those published for the ZF 8HP 70 (2008) with sun and ring teeth 48/96, 48/96, 69/111 and
23/85, to their last digit. Members, brakes and clutches are those of its gearset: brake A on the suns of
the first two sets, B on the first ring; clutch C between input and fourth sun, D between third and
fourth carrier, E between second and third ring. Torques of brakes follow from the external balance and
from Willis's relation.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.static_power import static_power
from pitchpoint.report.statics import idle_meshes
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from tests.support.planet_gearboxes import eight_speed

GEARS = {
    "1": ("A, B, C", 4.6957),
    "2": ("A, B, E", 3.1304),
    "3": ("B, C, E", 2.1039),
    "4": ("B, D, E", 1.6667),
    "5": ("B, C, D", 1.2845),
    "6": ("C, D, E", 1.0000),
    "7": ("A, C, D", 0.8392),
    "8": ("A, D, E", 0.6667),
    "R": ("A, B, D", -3.2968),
}
"""Engaged elements and published ratio of every gear."""


@pytest.fixture(scope="module")
def gearbox():
    """The gearbox with one scenario for each gear, and one in which all elements are open."""
    rows = [
        f"  g{name}: {{engaged: [{names}], speed: {{input: 2000 rpm}}, duration: 2 ms, step: 2 us}}\n"
        for name, (names, _) in GEARS.items()
    ]
    neutral = "  neutral: {engaged: [], speed: {input: 2000 rpm}, duration: 2 ms}\n"
    return loads_model(eight_speed("".join(rows) + neutral))


@pytest.mark.parametrize("name", GEARS)
def test_ratios_of_all_gears(gearbox, name):
    """Speeds from the engaged elements, equal powers at both ends, and the sum of all external torques."""
    engaged, ratio = GEARS[name]
    speeds = gearbox.start_speeds(f"g{name}")
    assert round(speeds["input"] / speeds["output"], 4) == pytest.approx(ratio, abs=6e-5)  # published digits
    flow = static_power(gearbox, gearbox.scenarios[f"g{name}"], f"g{name}")
    torques = {row["name"]: row["torque"] for row in flow["external"]}
    assert flow["power_in"] == pytest.approx(300.0 * 2000.0 * math.tau / 60.0, rel=1e-9)
    assert flow["power_out"] == pytest.approx(flow["power_in"], rel=1e-9)
    assert sum(torques.values()) == pytest.approx(0.0, abs=1e-6)
    assert torques.keys() - {"engine", "road"} == set(engaged.split(", ")) & {"A", "B"}
    assert not [note for note in flow["notes"] if "slip" in note or "do not follow" in note]


def test_torques_of_both_brakes_in_first_gear(gearbox):
    """The fourth ring takes 300 85/23 N m to the first carrier; its set divides them 48 : 96."""
    flow = static_power(gearbox, gearbox.scenarios["g1"], "g1")
    torques = {row["name"]: row["torque"] for row in flow["external"]}
    support = 300.0 * 85.0 / 23.0
    assert torques["A"] == pytest.approx(support / 3.0, rel=1e-9)
    assert torques["B"] == pytest.approx(2.0 * support / 3.0, rel=1e-9)


def test_a_run_in_first_gear(gearbox):
    """The engaged elements stick and carry their torques; D and E are open."""
    run = solve_time(compile_model(gearbox, "g1"))
    support, speed = 300.0 * 85.0 / 23.0, 2000.0 * math.tau / 60.0
    # 3 %: mean over 2 ms of the vibration after the start at constant speed
    assert float(run["torque[A]"].mean()) == pytest.approx(support / 3.0, rel=0.03)
    assert float(run["torque[B]"].mean()) == pytest.approx(2.0 * support / 3.0, rel=0.03)
    assert float(run["torque[C]"].mean()) == pytest.approx(-300.0, rel=0.03)
    assert not run["torque[D]"].any() and not run["torque[E]"].any()
    assert np.abs(run["slip_speed[C]"]).max() < 1e-3 * speed
    assert float(run["slip_speed[E]"].mean()) == pytest.approx(0.5 * speed, rel=1e-3)  # ring 2 at 1.5


def test_engaged_elements_are_springs_of_the_modes(gearbox):
    """With three engaged elements one free rotation remains, that of the gear; without any there are four."""
    modes = find_modes(compile_model(gearbox, "g3"))
    assert np.count_nonzero(modes.frequency == 0.0) == 1
    assert {"friction clutch B", "friction clutch C", "friction clutch E"} <= set(modes.elements)
    modes = find_modes(compile_model(gearbox, "neutral"))
    assert np.count_nonzero(modes.frequency == 0.0) == 4


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("engaged: [A, B, F]", "names the clutch 'F', which does not exist"),
        ("engaged: [A, A]", "names A twice"),
        ("engaged: [A, B, C, E]", "cannot be: the train is locked with A, B, C and E engaged"),
    ],
)
def test_wrong_shift_tables_are_refused(line, words):
    text = eight_speed(f"  wrong: {{{line}, speed: {{input: 2000 rpm}}, duration: 2 ms}}\n")
    with pytest.raises(ModelError, match=words):
        loads_model(text)


def test_undetermined_speeds_and_overloaded_clutches_are_named(gearbox):
    """Two engaged elements leave a freedom; 40 kN m on the input exceed the capacity of clutch C."""
    two = gearbox.replace("scenarios.g1.engaged", ["A", "B"])
    notes = static_power(two, two.scenarios["g1"], "g1")["notes"]
    assert any("do not follow from those of input" in note and "engaged: [...]" in note for note in notes)
    heavy = gearbox.replace("loads.engine.torque", "40 kN m")
    notes = static_power(heavy, heavy.scenarios["g1"], "g1")["notes"]
    assert "C: 40 kN m exceed its capacity of 3000 N m, so that it slips" in notes


def test_idle_sets_are_not_rolled_in_a_report(gearbox):
    """In first gear the second and third set carry no load."""
    idle = idle_meshes(gearbox, gearbox.scenarios["g1"])
    assert idle == {m for m in gearbox.meshes if any(f"{p}_" in m for p in ("p2", "p3"))}
