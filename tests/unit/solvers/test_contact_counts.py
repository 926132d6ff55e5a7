# SPDX-License-Identifier: Apache-2.0
"""Impacts counted in the loop: closed form of the free gap, agreement with stored samples, rattle index."""

from __future__ import annotations

import math
from dataclasses import asdict, fields

import numpy as np
import pytest

from pitchpoint import compile_model, solve_time
from pitchpoint.analysis.rattle import Rattle, rattle
from pitchpoint.io.contact_numbers import RATTLE
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.contact_counts import CONTACT_NUMBERS, new_counts, read_counts
from pitchpoint.solvers.time import run_time
from tests.support.planet_stages import stage_file
from tests.support.planetary import gear_pairs, planetary
from tests.validation.test_free_gap import INERTIA, MODEL, RADIUS, STIFFNESS, closed_form

TORQUE, GAP = 5.0, 0.43


def test_names_agree():
    """The solver, the files and the analysis have the same numbers."""
    assert {name for name, _, _ in RATTLE} == set(CONTACT_NUMBERS)
    assert {f.name for f in fields(Rattle)} == set(CONTACT_NUMBERS[:-5])  # the others require inertias
    assert CONTACT_NUMBERS[-5] == "rattle_index"


@pytest.fixture(scope="module")
def free_gap():
    """Free vibration through the backlash: statistics over five periods, from one front contact on."""
    share, frequency = closed_form(TORQUE, GAP)
    text = MODEL.format(torque=TORQUE, gap=GAP).replace("duration: 1.3 s, step: 10 us", "{}")
    # the gear is let go in contact with the front flank, which it leaves a quarter of a period later
    natural = math.sqrt(STIFFNESS * RADIUS**2 / INERTIA)
    begin = 0.1 + 0.25 * 2.0 * math.pi / natural + 2e-3
    times = f"duration: {begin + 5.0 / frequency} s, settle_time: {begin} s, step: 20 us"
    model = loads_model(text.replace("{}", times))
    return solve_time(compile_model(model, "fixed"))["contact_state[pair]"], share, frequency, natural


def test_free_gap(free_gap):
    """Closing speed omega delta_0, impulse 2 m omega delta_0, two impacts per period, time in the gap j/v."""
    state, share, frequency, natural = free_gap
    found = state.attrs
    speed = natural * TORQUE / RADIUS / STIFFNESS
    assert (found["front_impacts"], found["back_impacts"]) == (5, 5)
    assert found["impact_rate"] == pytest.approx(2.0 * frequency, rel=1e-4)
    # between contacts, not over the window: a step of 20 us in four periods
    assert found["contact_frequency"] == pytest.approx(frequency, rel=2e-5)
    assert found["contact_loss_share"] == pytest.approx(share, abs=1e-4)
    assert found["front_contact_share"] == pytest.approx(0.5 * (1.0 - share), abs=1e-4)
    for word in ("mean", "rms", "max"):
        assert found[f"closing_speed_{word}"] == pytest.approx(speed, rel=1e-6)  # (omega h)^2/6 = 6e-8
    assert found["impulse_max"] == pytest.approx(2.0 * INERTIA / RADIUS**2 * speed, rel=1e-6)
    assert found["longest_loss"] == pytest.approx(GAP * 1e-3 / speed, abs=40e-6)
    assert found["shortest_contact"] == pytest.approx(math.pi / natural, abs=40e-6)
    assert found["resolution"] == pytest.approx(20e-6, rel=1e-3)


IDLE = """\
gears:
  driver: {number_of_teeth: 20, normal_module: 2 mm, face_width: 10 mm, profile_shift_coefficient: 0}
  idle: {number_of_teeth: 40, normal_module: 2 mm, face_width: 10 mm, profile_shift_coefficient: 0}
bodies:
  input: {gears: [driver], inertia: 1e-3 kg m^2}
  output: {gears: [idle], inertia: 2e-4 kg m^2}
meshes:
  stage: {gears: [driver, idle], backlash: {base_tangent: 0.1 mm},
          stiffness: {law: constant, value: 1e8 N/m}, damping: {ratio: 0.05, s_0: 0.001 um}}
loads:
  drag: {body: output, torque: DRAG}
scenarios:
  idle: {drive: {input: {angle: "TURN*(25*pi*t + RIPPLE*sin(50*pi*t))"}}, duration: 0.28 s,
         settle_time: 0.12 s, step: 10 us}
"""


BASE_RADIUS = 0.04 * math.cos(math.radians(20.0))
IDLE_MASS = 2e-4 / BASE_RADIUS**2
PERIOD = 2.0 * math.pi * math.sqrt(IDLE_MASS / 1e8)
"""Natural period of the idle gear on the flank; the driven gear does not vibrate."""


def idle_gear(index: float, *, turn: int = 1, drag: float = 0.2):
    """Contact numbers of an idle gear with this index; alpha has the amplitude (50 pi)^2 RIPPLE/2."""
    ripple = index * abs(drag) / 2e-4 / (0.5 * (50.0 * math.pi) ** 2)
    text = IDLE.replace("RIPPLE", repr(ripple)).replace("TURN", str(turn)).replace("DRAG", f"{drag} N m")
    model = loads_model(text)
    return run_time(compile_model(model, "idle")).channels["contact_state[stage]"]


@pytest.mark.parametrize(("turn", "drag"), [(1, 0.2), (-1, -0.2), (1, -0.2)])
def test_index_of_an_idle_gear(turn: int, drag: float):
    """Below one the flanks stay in contact, above one they separate: J alpha/T, on either flank."""
    quiet, loud = (idle_gear(index, turn=turn, drag=drag) for index in (0.95, 1.05))
    assert quiet["rattle_index"] == pytest.approx(0.95, rel=2e-3)
    assert quiet["contact_loss_share"] == 0.0
    assert loud["rattle_index"] == pytest.approx(1.05, rel=2e-3)
    assert loud["contact_loss_share"] > 0.0
    assert loud["front_impacts"] + loud["back_impacts"] > 0


def reversal_under_drag(index: float) -> float:
    """Load T (1 - I sin) of an idle gear: impulse of its negative over that of its positive part."""
    if index <= 1.0:
        return 0.0
    negative = math.sqrt(index**2 - 1.0) - math.acos(1.0 / index)
    return negative / (math.pi + negative)


@pytest.mark.parametrize("index", [0.95, 1.5, 4.0, 50.0])
def test_load_reversal_of_an_idle_gear(index: float):
    """It depends on the loads alone, not on the impacts: the closed form holds while the gear rattles. The
    tolerances are those of differences over steps of 10 us, (50 pi h)^2, and of impacts within a step."""
    found = idle_gear(index)
    assert found["load_reversal"] == pytest.approx(reversal_under_drag(index), rel=2e-4, abs=1e-9)
    assert found["rattle_index"] == pytest.approx(index, rel=1e-4)


BOUNCE = """\
gears:
  driver: {number_of_teeth: 20, normal_module: 2 mm, face_width: 10 mm, profile_shift_coefficient: 0}
  idle: {number_of_teeth: 40, normal_module: 2 mm, face_width: 10 mm, profile_shift_coefficient: 0}
bodies:
  input: {gears: [driver], inertia: 1e-3 kg m^2}
  output: {gears: [idle], inertia: 2e-4 kg m^2}
meshes:
  stage: {gears: [driver, idle], backlash: {base_tangent: 0.1 mm},
          stiffness: {law: constant, value: 1e8 N/m}, damping: {d_in: DAMPING, d_out: DAMPING, s_0: 0}}
scenarios:
  free: {drive: {input: {angle: "25*pi*t + RIPPLE*sin(50*pi*t + PHASE)"}}, speed: {output: SPEED},
         start: assembled, duration: 0.48 s, settle_time: 0.16 s, step: 1 us}
"""


def test_a_gear_that_bounces_in_the_backlash():
    """A free gear between flanks that move as X sin(Omega t), 5 X being the backlash j: it hits each flank
    once per period. At the impact, at the phase p, the flank moves at w = X Omega cos(p); the gear comes at V
    and leaves at -V, so that V = -w (1 + e)/(1 - e), and crosses V pi/Omega = j + 2 X sin(p) in between
    (A. E. Kobrinskii, Dynamics of Mechanisms with Elastic Connections and Impact Systems, Iliffe 1969).

    A flank with the damping ratio zeta that never pulls has the restitution
    e = exp(-zeta (pi - 2 arcsin zeta)/sqrt(1 - zeta^2)): its force ends where the acceleration is zero. The
    tolerances are the contact time over the period, pi/(26.6e3 rad/s)/40 ms = 0.3 %, and the deceleration
    within a step before a contact is noticed, 2 zeta omega h/2 = 0.3 %; twice in energies.
    """
    zeta, stiffness, backlash, omega = 0.1, 1e8, 1e-4, 50.0 * math.pi
    e = math.exp(-zeta * (math.pi - 2.0 * math.asin(zeta)) / math.sqrt(1.0 - zeta**2))
    X = backlash / 5.0
    gain = (1.0 + e) / (1.0 - e)
    # 2 sin(p) + pi gain cos(p) = -j/X, the solution with the faster impacts
    size, lead = math.hypot(2.0, math.pi * gain), math.atan2(2.0, math.pi * gain)
    p = lead + math.acos(-5.0 / size)
    w = X * omega * math.cos(p)
    speed = -gain * w
    r_b1 = 0.5 * BASE_RADIUS
    damping = 2.0 * zeta * math.sqrt(stiffness * IDLE_MASS)
    text = BOUNCE.replace("DAMPING", repr(damping)).replace("RIPPLE", repr(X / r_b1))
    # half-way between two impacts the gear is in the middle
    text = text.replace("PHASE", repr(p + 0.5 * math.pi))
    text = text.replace("SPEED", repr(-(25.0 * math.pi * r_b1 - speed) / BASE_RADIUS))
    channels = run_time(compile_model(loads_model(text), "free")).channels
    found = channels["contact_state[stage]"]
    assert (found["front_impacts"], found["back_impacts"]) == (8, 8)
    closing = speed - w
    assert found["closing_speed_mean"] == pytest.approx(closing, rel=4e-3)
    # 4 revolutions: 16 changes, without that before the first contact
    assert found["flank_changes_per_revolution"] == pytest.approx(15.0 / 4.0, rel=1e-3)
    energy = 4.0 * 0.5 * IDLE_MASS * closing**2
    assert found["impact_energy_per_revolution"] == pytest.approx(energy, rel=8e-3)
    lost = channels["damping_power[stage]"]["mean"] * 0.08  # [J] per revolution
    assert lost == pytest.approx((1.0 - e**2) * found["impact_energy_per_revolution"], rel=8e-3)
    # with its flanks held together the mesh would transmit m X Omega^2 sin
    assert found["load_reversal"] == pytest.approx(1.0, abs=5e-3)
    mean = IDLE_MASS * X * omega**2 * 2.0 / math.pi
    root = math.sqrt(1.0 - zeta**2)
    turned = np.linspace(0.0, math.pi, 10001)
    bend = 2.0 * zeta * np.cos(turned) + (1.0 - 2.0 * zeta**2) / root * np.sin(turned)
    hardest = math.sqrt(stiffness * IDLE_MASS) * found["closing_speed_max"]
    peak = hardest * np.max(np.exp(-zeta * turned / root) * bend)
    assert found["peak_force_ratio"] == pytest.approx(peak / mean, rel=6e-3)
    assert math.isnan(found["rattle_index"])  # there is no drag torque


def test_counters_equal_the_analysis_of_all_samples():
    """Hammering on both flanks: the numbers of the loop are those of the stored samples at every step."""
    ripple = 6.0 * 0.2 / 2e-4 / (0.5 * (50.0 * math.pi) ** 2)
    text = IDLE.replace("RIPPLE", repr(ripple)).replace("TURN", "1").replace("DRAG", "0.2 N m")
    found = solve_time(
        compile_model(loads_model(text.replace("settle_time: 0.12", "settle_time: 0")), "idle")
    )
    # the statistics begin after the first step
    names = ("contact_state", "deflection", "mesh_force")
    later = [found[f"{name}[stage]"].values[1:] for name in names]
    whole = rattle(found["time"].values[1:], *later, period=PERIOD)
    counted = found["contact_state[stage]"].attrs
    assert whole.front_impacts > 5
    assert whole.back_impacts > 5
    for name, value in asdict(whole).items():
        assert counted[name] == pytest.approx(value, rel=1e-9), name
    assert np.isfinite(counted["rattle_index"])


def test_a_contact_that_carries_the_load_has_no_impulse_of_an_impact():
    """Above an index of one the flanks lift off once per cycle and carry the drag for the rest of it.

    Every impact transfers less than that of the idle gear thrown back at its speed, 2 m v; the drag alone
    transfers 0.2 N m over the base radius times 40 ms, hundred times as much.
    """
    loud = idle_gear(1.05)
    assert loud["front_impacts"] > 0
    most = 2.0 * IDLE_MASS * loud["closing_speed_max"]
    assert 0.2 / BASE_RADIUS * 0.03 > 20.0 * most
    assert loud["impulse_max"] <= 1.2 * most


def test_no_index_for_gears_on_a_carrier():
    """The acceleration of a planet is not that of its mesh; the other numbers are known."""
    pairs = gear_pairs(20, 25, 2e-3, math.radians(20.0))
    system = planetary(pairs, (1e-4, 1e-3, 1e-2, 1e-4), (1e8, 1e8))
    counts = new_counts(system)
    counts["total"], counts["momentum"], counts["front"], counts["least_1"] = 1.0, 5.0, 1.0, -7.0
    for numbers in read_counts(system, counts).values():
        assert all(math.isnan(numbers[name]) for name in CONTACT_NUMBERS[-5:])
        assert numbers["front_contact_share"] == 1.0


def test_no_index_for_planets_in_a_fixed_ring():
    """The ring is at rest, but the line of centres turns with the carrier."""
    system = compile_model(loads_model(stage_file()))
    counts = new_counts(system)
    counts["total"], counts["momentum"], counts["least_1"], counts["least_2"] = 1.0, 5.0, -7.0, -7.0
    for mesh, numbers in read_counts(system, counts).items():
        assert math.isnan(numbers["rattle_index"]), mesh
