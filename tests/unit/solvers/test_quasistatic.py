# SPDX-License-Identifier: Apache-2.0
"""Slow roll against closed forms: TE = gap/2 + e + T/(r_b k), tangent stiffness, sharing, unloaded error."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from pitchpoint.contact.cycle_pieces import cycle_pieces
from pitchpoint.contact.mesh_cycle import mesh_cycle
from pitchpoint.contact.stiffness.description import PairShape
from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import SINGULAR
from pitchpoint.solvers.quasistatic import holding
from pitchpoint.solvers.quasistatic.roll import roll_through, solve_quasistatic, statistics, tables
from tests.support.machines import R_B1, STAGES, compiled, pair

E_COS = (1e-6, 0.5e-6)
WAVE = "{law: fourier, mean: 4.0e8 N/m, cosine: [-0.2, -0.1]}, transmission_error: {cosine: [1.0e-6, 0.5e-6]}"


def channel(system, roll, name):
    return roll.rows[:, system.layout.channel(name)]


FAN = """\
gears:
  p: {number_of_teeth: 24, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0.2}
  w: {number_of_teeth: 49, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  i: {gears: [p], inertia: 2.0e-3 kg m^2}
  o: {gears: [w], inertia: 4.0e-2 kg m^2}
meshes:
  stage: {gears: [p, w], center_distance: 73.5 mm}
loads:
  d: {body: i, torque: balance}
  fan: {body: o, torque: "60 N m*(speed/(77 rad/s))^2"}
scenarios:
  slow: {quasi_static: {mesh: stage, points: 4}, speed: {i: 2000 rpm}}
  steady: {speed: {i: 2000 rpm}, duration: 1 ms}
"""


@pytest.mark.parametrize("what", ["slow", "stage"])
def test_torques_over_the_speed_are_those_of_the_scenario(what: str):
    """60 N m (w_o/77)^2 at w_o = 2000 rpm 24/49 is 52.16 N m at the pinion."""
    speed = 2000.0 * math.pi / 30.0 * 24.0 / 49.0
    expected = 60.0 * (speed / 77.0) ** 2 * 24.0 / 49.0 / (24e-3 * math.cos(math.radians(20.0)))
    system = compiled(FAN, "slow" if what == "slow" else "steady")[1]
    roll = roll_through(system, what, 4)
    assert channel(system, roll, "mesh_force[stage]") == pytest.approx(expected, rel=1e-9)
    assert channel(system, roll, "torque[d]") == pytest.approx(52.1594, rel=1e-6)
    assert roll.notes == ()


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_transmission_error_of_a_torsional_pair(sign):
    """Both flanks: u = +-(gap/2 + T/(r_b k)) + e at the phase of the loaded flank."""
    system = compiled(pair(WAVE, torque=f"{sign * 200.0} N m"))[1]
    roll = roll_through(system, "stage", 24)
    te = channel(system, roll, "transmission_error[stage]")
    k = channel(system, roll, "mesh_stiffness[stage]")
    psi = channel(system, roll, "mesh_phase[stage]")
    e = sum(a * np.cos(2 * math.pi * (h + 1) * psi) for h, a in enumerate(E_COS))
    assert te == pytest.approx(sign * (5e-5 + 200.0 / R_B1 / k) + e, abs=1e-13)
    if sign > 0:
        ratio = 1 - 0.2 * np.cos(2 * math.pi * psi) - 0.1 * np.cos(4 * math.pi * psi)
        assert k == pytest.approx(4e8 * ratio, rel=1e-9)
    unloaded = roll.meshes["stage"].unloaded
    # the touching flank stands a little earlier in its cycle than the loaded one
    shift = sign * 0.5 * 200.0 / R_B1 / 4e8 / (2 * math.pi * R_B1 / 30)
    assert unloaded == pytest.approx(sign * 5e-5 + e, abs=2 * math.pi * 3e-6 * abs(shift))
    assert roll.meshes["stage"].tangent_stiffness == pytest.approx(k, rel=1e-9)
    assert max((np.abs(torque).max() for torque in roll.holding.values()), default=0.0) < 1e-6


@pytest.mark.parametrize("beta", ["", "17 deg"])
@pytest.mark.parametrize("relief", [0.0, 0.5])
def test_stiffness_is_that_of_the_mesh_cycle(beta, relief):
    model, system = compiled(
        pair(f"{{law: din3990, stiffness_ratio: 0.8, tip_relief_factor: {relief}}}", beta=beta)
    )
    geometry = model.pairs["stage"]
    roll = roll_through(system, "stage", 25)
    record = system.records["gear_mesh"][0]
    psi = channel(system, roll, "mesh_phase[stage]")
    cycle = mesh_cycle(geometry.eps_alpha_form, geometry.eps_beta, 0.8, relief, 4001)
    for stiffness in (channel(system, roll, "mesh_stiffness[stage]"), roll.meshes["stage"].tangent_stiffness):
        ratio = stiffness / (record["c_prime"] * geometry.b_w)
        assert ratio == pytest.approx(np.interp(psi, cycle.phase, cycle.stiffness_ratio), abs=1e-4)
        shape = PairShape(c_prime=1.0, S_R=0.8, T_R=relief)
        exact = cycle_pieces(shape, geometry.eps_alpha_form, geometry.eps_beta).at(psi)
        assert ratio == pytest.approx(exact, rel=1e-9)
    share = roll.meshes["stage"].share
    assert share.sum(axis=1) == pytest.approx(np.ones(len(psi)), rel=1e-12)


def test_unloaded_error_shows_tip_relief_only_where_it_is_alone():
    """With relief on a spur pair the unloaded error keeps the unrelieved flank: zero relief somewhere."""
    text = pair("{law: din3990}")
    relieved = text.replace(
        "profile_shift_coefficient: 0}",
        "profile_shift_coefficient: 0, modifications: {both: {tip_relief: {amount: 20 um, length: 0.5 mm}}}}",
    )
    system = compiled(relieved)[1]
    roll = roll_through(system, "stage", 30)
    unloaded = roll.meshes["stage"].unloaded - 5e-5
    assert unloaded.min() > -1e-9
    assert unloaded.min() == pytest.approx(0.0, abs=1e-7)
    loaded = channel(system, roll, "transmission_error[stage]") - 5e-5
    assert np.all(loaded > unloaded)


def test_dataset_and_scenario():
    text = pair(WAVE, rest="scenarios:\n  slow: {quasi_static: {points: 10, periods: 2}}\n")
    system = compiled(text)[1]
    data = solve_quasistatic(system, "slow")
    assert data.sizes == {"mesh_phase_position": 21}
    assert data["transmission_error[stage]"].attrs["units"] == "m"
    te = data["transmission_error[stage]"].values
    assert float(data["transmission_error_peak_to_peak[stage]"]) == pytest.approx(np.ptp(te), rel=1e-15)
    assert te[:11] == pytest.approx(te[10:], abs=1e-13)


def test_what_cannot_be_rolled():
    system = compiled(pair(WAVE))[1]
    with pytest.raises(SolverError, match="no mesh or scenario 'gear'"):
        roll_through(system, "gear")
    with pytest.raises(SolverError, match="at least 2 points"):
        roll_through(system, "stage", 1)


def test_the_touching_flank_of_pitch_deviations_is_found_at_every_phase():
    """Where the leading tooth changes while the gap closes, the edge is where the force of any begins."""
    text = """\
gears:
  g1: {number_of_teeth: 17, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0.2,
       deviations: {pitch: [10 um, -10 um, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]}}
  g2: {number_of_teeth: 23, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies: {b1: {gears: [g1]}, b2: {gears: [g2]}}
meshes: {stage: {gears: [g1, g2], center_distance: 60.7 mm}}
loads: {l: {body: b2, torque: 100 N m}}
scenarios: {slow: {quasi_static: {points: 21, periods: 17}, hold: [b1]}}
"""
    model, system = compiled(text)
    roll = roll_through(system, "slow")
    error = roll.meshes["stage"].unloaded - 0.5 * model.pairs["stage"].j_bt
    # one pair leads, tooth 0 by its 10 um for as long as it is in contact
    assert len(error) == 17 * 21 + 1
    ahead_by = 10e-6 * math.cos(math.radians(20.0))
    mean = ahead_by / 17.0
    assert error.min() == pytest.approx(mean - ahead_by, abs=1e-9)
    assert error.max() == pytest.approx(mean, abs=1e-9)
    share = np.mean(error[:-1] < mean - 0.5 * ahead_by)
    assert share == pytest.approx(model.pairs["stage"].eps_alpha / 17.0, abs=1.0 / 17 / 21)


ROLLED = (
    STAGES
    + """\
scenarios:
  one: {quasi_static: {mesh: first, points: 30, periods: 1}}
  three: {quasi_static: {mesh: first, points: 30, periods: 3}}
  four: {quasi_static: {mesh: second, points: 30, periods: 4}}
"""
)


@pytest.mark.parametrize(
    ("scenario", "notes"),
    [
        ("one", "mesh second repeats after 3 periods of first, and its peak to peak is that of 1"),
        ("three", ""),  # 57/19: the second stage has turned by one tooth
        ("four", ""),
    ],
)
def test_meshes_whose_cycles_a_roll_does_not_complete_are_named(scenario, notes):
    system = compiled(ROLLED, scenario)[1]
    data = solve_quasistatic(system)
    assert data.attrs["notes"] == notes
    span = float(data["transmission_error_peak_to_peak[second]"])
    # k from 0.8 to 1.2 of its mean over a whole cycle, under 60 N m * 57/21 at the base radius of c
    force = 60.0 * 57 / 21 / (0.5 * 19 * 3e-3 * math.cos(math.radians(20.0)))
    whole = force / 4e8 * (1 / 0.8 - 1 / 1.2)
    assert (span == pytest.approx(whole, rel=1e-2)) is not bool(notes)


def test_a_mesh_that_turns_faster_than_the_rolled_one_has_a_partial_mean():
    text = ROLLED.replace("19", "20").replace(
        "mesh: first, points: 30, periods: 1", "mesh: second, periods: 1"
    )
    roll = roll_through(compiled(text, "one")[1])  # 57/20: 2.85 cycles of the first stage
    assert roll.cycle_notes == ("mesh first repeats after 20 periods of second, and its mean is that of 1",)
    assert roll.meshes["first"].repeats_after == 20


@pytest.mark.parametrize(
    ("torque", "words", "sign"),
    [
        ("balance", (), 1.0),
        (
            "0 N m",
            ("meshes first and second carry no load, and 60 N m on input are balanced by holding torques",),
            0.0,
        ),
        ("-200 N m", ("the loads do not balance: 36.67 N m on input are balanced by holding torques",), 1.0),
        (
            "514.3 N m",
            (
                "the loads do not balance: 120 N m on input are balanced by holding torques",
                "motor and brake drive the train in the same direction",
            ),
            -1.0,
        ),
    ],
)
def test_loads_that_do_not_balance_are_told_as_what_they_mean_for_a_roll(torque, words, sign):
    """60 N m times 57/21 times 60/19 are 514.3 N m; input and output turn the same way round."""
    text = ROLLED.replace("torque: balance", f"torque: {torque}")
    system = compiled(text, "three")[1]
    roll = roll_through(system)
    assert len(roll.notes) == len(words), roll.notes
    for note, expected in zip(roll.notes, words, strict=True):
        assert note.startswith(expected)
        assert "speed" not in note
    force = channel(system, roll, "mesh_force[first]")
    assert np.all(np.sign(np.round(force, 3)) == sign)


def test_a_model_without_loads_is_rolled_without_a_word():
    text = re.sub(r"loads: .*\n", "", ROLLED)
    assert roll_through(compiled(text, "three")[1]).notes == ()


def test_extremes_of_a_part_of_a_cycle_are_those_of_all_points():
    system = compiled(ROLLED, "one")[1]
    roll = roll_through(system)
    table = {t.name: t for t in tables(system, roll)}
    found = statistics(table["transmission_error[second]"])
    span = table["transmission_error_peak_to_peak[second]"].values
    assert found["max"] - found["min"] == pytest.approx(span, rel=1e-15)


@pytest.mark.parametrize("exponent", [1.0, 1.5, 3.0, 5.0])
def test_tooth_pairs_of_any_exponent(exponent):
    """F_n = K delta^e over the contact lines: 1.54 of them in a spur pair are one or two; gap/2 unloaded."""
    text = pair(f"{{law: hertz, exponent: {exponent}, force: 10 kN, depth: 30 um}}")
    model, system = compiled(text)
    roll = roll_through(system, "stage", 24)
    delta = channel(system, roll, "penetration[stage]")
    pairs = 200.0 / R_B1 / 1e4 / (delta / 30e-6) ** exponent
    assert pairs == pytest.approx(np.round(pairs), rel=1e-7)
    assert set(np.round(pairs)) == {1.0, 2.0}
    assert roll.meshes["stage"].unloaded == pytest.approx(5e-5, abs=1e-12)
    slope = exponent * 200.0 / R_B1 / delta
    assert roll.meshes["stage"].tangent_stiffness == pytest.approx(slope, rel=1e-6)


def test_friction_that_a_slow_roll_leaves_out_is_reported():
    text = re.sub(r"stiffness: {law: fourier[^}]*}", "friction: {mu: 0.05}", ROLLED)
    (note,) = roll_through(compiled(text, "three")[1]).notes
    assert note.startswith(
        "friction of meshes first and second is neglected, since a slow roll is computed at zero speed"
    )


def test_a_balanced_torque_of_a_slow_roll_holds_no_friction():
    """At speed friction takes part of the torque; the roll has none, so the teeth carry all of it."""
    text = (
        "gears:\n"
        "  a: {number_of_teeth: 30, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}\n"
        "  b: {number_of_teeth: 45, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}\n"
        "bodies:\n  one: {gears: [a], position: [0, 0, 0]}\n  two: {gears: [b], motion: torsion}\n"
        "joints:\n  pin: {type: revolute, bodies: [ground, one], "
        "friction: {coefficient: 0.1, radius: 20 mm}}\n"
        "meshes:\n  stage: {gears: [a, b], stiffness: {law: din3990}, friction: {mu: 0.05}}\n"
        "loads:\n  in: {body: one, torque: 200 N m}\n  out: {body: two, torque: balance}\n"
        "scenarios:\n  slow: {speed: {one: 1000 rpm}, quasi_static: {mesh: stage, points: 12}}\n"
    )
    system = compiled(text, "slow")[1]
    roll = roll_through(system, system.scenario)
    (note,) = roll.notes
    assert note.startswith("friction of mesh stage and of joint pin is neglected")
    assert channel(system, roll, "mesh_force[stage]") == pytest.approx(200.0 / R_B1, rel=1e-9)


def test_a_roll_goes_on_in_smaller_steps(monkeypatch):
    """An equilibrium that is not found from the rolled state is reached in parts of the step before."""
    system = compiled(FAN, "slow")[1]
    expected = roll_through(system, "stage", 4).rows
    search, calls = holding.find_equilibrium, []

    def fails_twice(own, state, held):
        """Search that fails for the third point, and once more at the middle of the way."""
        calls.append(state)
        if len(calls) in (3, 4):
            raise SolverError("no equilibrium", SINGULAR)
        return search(own, state, held)

    monkeypatch.setattr(holding, "find_equilibrium", fails_twice)
    roll = roll_through(system, "stage", 4)
    assert roll.sentence == "finished" and len(calls) == 5 + 2 + 2
    assert roll.rows == pytest.approx(expected, rel=1e-9, abs=1e-9)
