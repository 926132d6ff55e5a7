# SPDX-License-Identifier: Apache-2.0
"""Mesh frequencies of a planetary set in sweeps, Campbell diagrams and slow rolls.

With the ring held, the sun at n_s turns the carrier at n_c = n_s z_s / (z_s + z_r), and both meshes have
f = z_s (n_s - n_c) = z_r n_c (R. Willis, Principles of Mechanism, 1841).
"""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.report.rolls import periods_until_repeat
from pitchpoint.solvers.campbell import follow_modes
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.sweep.speed import plan_sweep, run_sweep
from tests.support.machines import compiled

SUN, PLANET, RING = 20, 31, 82
ORDER = SUN * RING / (SUN + RING)
"""Mesh periods in a revolution of the sun."""


def planetary(rest: str) -> str:
    """One planet between sun and held ring, the torque of the carrier balanced."""
    teeth = "normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    mesh = "stiffness: {law: rectangular, high: 4e8 N/m, low: 3e8 N/m, duty: 0.7}, damper: {ratio: 0.1}"
    return f"""\
gears:
  s: {{number_of_teeth: {SUN}, {teeth}}}
  p: {{number_of_teeth: {PLANET}, {teeth}}}
  r: {{type: internal, number_of_teeth: {RING}, {teeth}}}
bodies:
  sun: {{gears: [s], motion: torsion, inertia: 1e-3 kg m^2, position: [0, 0, 0]}}
  carrier: {{motion: torsion, inertia: 2e-2 kg m^2, mass: 3 kg, position: [0, 0, 0]}}
  planet: {{gears: [p], inertia: 2e-3 kg m^2, mass: 0.5 kg, position: [51 mm, 0, 0]}}
  ring: {{gears: [r], motion: fixed, position: [0, 0, 0]}}
joints:
  pin: {{type: revolute, bodies: [carrier, planet]}}
meshes:
  sp: {{gears: [s, p], {mesh}}}
  pr: {{gears: [p, r], {mesh}}}
loads:
  motor: {{body: sun, torque: 20 N m}}
  brake: {{body: carrier, torque: balance}}
{rest}"""


SWEEP = (
    "scenarios:\n  up: {sweep: {body: sun, mesh: sp, mesh_frequency: [300 Hz, 400 Hz], points: 2, "
    "direction: up, settle_periods: 2, measure_periods: 2}}\n"
)


def test_a_sweep_counts_mesh_frequencies_against_the_carrier():
    """At the point labelled 300 Hz the speeds of sun and carrier give 300 Hz by Willis."""
    model, system = compiled(planetary(SWEEP), "up")
    plan = plan_sweep(system, model.scenarios["up"])
    assert plan.frequencies == pytest.approx([300.0, 400.0])
    assert plan.speeds / (2.0 * math.pi) == pytest.approx(np.array([300.0, 400.0]) / ORDER)
    assert plan.fastest == pytest.approx(1.0)
    for point in run_sweep(system, model.scenarios["up"]).points:
        sun, carrier = (
            point["channels"][f"speed[{b}]"]["mean"] / (2.0 * math.pi) for b in ("sun", "carrier")
        )
        assert SUN * (sun - carrier) == pytest.approx(point["mesh_frequency"], rel=1e-3)


def test_a_fan_on_the_carrier_is_balanced_at_every_speed_of_a_sweep():
    """The carrier turns at n_s z_s / (z_s + z_r), and so do the torques: T_s = T_c z_s / (z_s + z_r)."""
    text = planetary(SWEEP).replace("sun, torque: 20 N m", "sun, torque: balance")
    text = text.replace("carrier, torque: balance", 'carrier, torque: "-100*(speed/(20 rad/s))^2"')
    model, system = compiled(text.replace("direction: up", "direction: both"), "up")
    points = run_sweep(system, model.scenarios["up"]).points
    assert [round(point["mesh_frequency"]) for point in points] == [300, 400, 400, 300]
    for point in points:
        ratio = SUN / (SUN + RING)
        torque = 100.0 * (ratio * point["speed"] / 20.0) ** 2 * ratio
        assert point["channels"]["torque[motor]"]["mean"] == pytest.approx(torque, rel=1e-6)
        assert point["channels"]["speed[sun]"]["mean"] == pytest.approx(point["speed"], rel=1e-3)


def test_meshes_that_repeat_together_share_one_note():
    """Two planets of one set behind a pair 21/58: both their meshes repeat with it only."""
    text = planetary("").replace("direction: up", "direction: both")
    teeth = "normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    text = text.replace("gears: [s],", "gears: {s: 0, w: 60 mm},").replace(
        "gears:\n",
        f"gears:\n  m: {{number_of_teeth: 21, {teeth}}}\n  w: {{number_of_teeth: 58, {teeth}}}\n",
        1,
    )
    text = text.replace(
        "bodies:\n",
        "bodies:\n  shaft: {gears: [m], motion: torsion, inertia: 1e-3, position: [79 mm, 0, 60 mm]}\n",
        1,
    )
    text = text.replace("meshes:\n", "meshes:\n  first: {gears: [m, w]}\n", 1)
    notes = roll_through(compiled(text)[1], "first", 20).cycle_notes
    after = Fraction(ORDER / 58).limit_denominator(10000).denominator
    assert notes == (
        f"meshes sp and pr repeat after {after} periods of first, and their peak to peak is that of 1",
    )


def test_both_meshes_of_a_campbell_diagram_have_one_frequency():
    found = follow_modes(compiled(planetary(""))[1], [100.0], "sun")
    assert found.orders == pytest.approx({"sp": ORDER, "pr": ORDER})


SPEEDS = {
    "drive at rest": ("drive: {ring: {speed: 0 rpm}}, speed: {sun: 900 rpm}", 0.0),
    "both driven, run-up": (
        "drive: {ring: {speed: 0 rpm}, sun: {speed: {table: [[0 s, 0 rpm], [1 s, 900 rpm]]}}}",
        0.0,
    ),
    "hold": ("hold: [ring], speed: {sun: 900 rpm}", 0.0),
    "two speeds": ("speed: {sun: 900 rpm, ring: -300 rpm}", -1 / 3),
    "two drives": ("drive: {sun: {speed: 900 rpm}, ring: {speed: -300 rpm}}", -1 / 3),
}


@pytest.mark.parametrize("case", SPEEDS)
def test_a_free_ring_turns_as_the_scenario_says(case):
    """Three free members: n_c = (z_s n_s + z_r n_r) / (z_s + z_r), with n_r / n_s as in the scenario."""
    scenario, ratio = SPEEDS[case]
    text = planetary(f"scenarios:\n  on: {{{scenario}, duration: 1 s}}\n")
    text = text.replace("motion: fixed", "motion: torsion, inertia: 1 kg m^2")
    order = SUN * (1.0 - (SUN + RING * ratio) / (SUN + RING))
    found = follow_modes(compiled(text, "on")[1], [100.0], "sun")
    assert found.orders == pytest.approx({"sp": order, "pr": order})


def test_a_diagram_over_the_carrier_keeps_the_ratio_of_the_speeds():
    """Of the carrier itself, which has no teeth: n_s and n_c as given, f = z_s (n_s - n_c)."""
    text = planetary("scenarios:\n  on: {speed: {sun: 900 rpm, carrier: 300 rpm}, duration: 1 s}\n")
    text = text.replace("motion: fixed", "motion: torsion, inertia: 1 kg m^2")
    found = follow_modes(compiled(text, "on")[1], [100.0], "carrier")
    assert found.orders == pytest.approx({"sp": 2.0 * SUN, "pr": 2.0 * SUN})


def test_a_ring_that_is_held_stands_still_in_a_sweep():
    text = planetary(SWEEP.replace("{sweep:", "{hold: [ring], sweep:"))
    text = text.replace("motion: fixed", "motion: torsion, inertia: 1 kg m^2")
    model, system = compiled(text, "up")
    for point in run_sweep(system, model.scenarios["up"]).points:
        sun, carrier, ring = (point["channels"][f"speed[{b}]"]["mean"] for b in ("sun", "carrier", "ring"))
        assert SUN * (sun - carrier) / math.tau == pytest.approx(point["mesh_frequency"], rel=1e-3)
        assert abs(ring) < 1e-9 * sun


def test_a_report_rolls_both_meshes_of_a_planet_through_the_same_periods():
    """Both meshes have one frequency whatever is fixed, so everything repeats after one period."""
    model = compiled(planetary(""))[0]
    assert [periods_until_repeat(model, mesh) for mesh in ("sp", "pr")] == [1, 1]


def test_one_period_of_a_slow_roll_is_one_base_pitch():
    """Phases go through exactly one cycle, so the mean stiffness is that of the law."""
    roll = roll_through(compiled(planetary(""))[1], "sp", 200)
    system = compiled(planetary(""))[1]
    phase = roll.rows[:, system.layout.channel("mesh_phase[sp]")]
    turned = np.unwrap(2.0 * math.pi * phase) / (2.0 * math.pi)
    assert abs(turned[-1] - turned[0]) == pytest.approx(1.0, abs=1e-3)
    assert roll.meshes["sp"].tangent_stiffness[:-1].mean() == pytest.approx(3.7e8, rel=5e-3)
    assert {name: mesh.pitches for name, mesh in roll.meshes.items()} == {
        "sp": Fraction(1),
        "pr": Fraction(1),
    }


def test_a_mesh_that_stands_still_cannot_be_swept():
    """A locked set turns as one body."""
    text = planetary(SWEEP).replace("joints:", "ratios:\n  lock: {terms: {sun: 1, carrier: -1}}\njoints:")
    text = text.replace("motion: fixed", "motion: torsion, inertia: 1 kg m^2")
    model, system = compiled(text, "up")
    with pytest.raises(SolverError, match="mesh sp is at rest while sun rotates"):
        plan_sweep(system, model.scenarios["up"])
