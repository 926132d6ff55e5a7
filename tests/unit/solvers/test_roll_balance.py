# SPDX-License-Identifier: Apache-2.0
"""Slow rolls under pulsating loads: the torques on every body balance at every position.

Without inertia and friction the torques of a train are those of its tooth ratios at every instant: on an
intermediate shaft the mesh forces on the base radii cancel, and the balancing torque is the sum of the loads,
reduced by their ratios.
"""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

from pitchpoint.solvers.equilibrium.balancing import LOAD
from pitchpoint.solvers.quasistatic.notes import balance_notes
from pitchpoint.solvers.quasistatic.roll import solve_quasistatic
from tests.support.machines import compiled

TEETH = "normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
TRAIN = """\
gears:
  a: {{number_of_teeth: 20, {teeth}{right}}}
  b: {{number_of_teeth: 50, {teeth}{left}}}
  c: {{number_of_teeth: 18, {teeth}{left}}}
  d: {{number_of_teeth: 45, {teeth}{right}}}
bodies:
  one: {{gears: [a], inertia: 0.01 kg m^2, motion: torsion}}
  two: {{gears: {{b: 0, c: 50 mm}}, inertia: 0.1 kg m^2, motion: torsion}}
  three: {{gears: [d], inertia: 0.5 kg m^2, motion: torsion}}
  pump: {{inertia: 0.2 kg m^2, motion: torsion}}
couplings: {{cpl: {{bodies: [three, pump], stiffness: {{torsion: 3e4 N m/rad}}}}}}
meshes:
  first: {{gears: [a, b]}}
  second: {{gears: [c, d]}}
loads:
  motor: {{body: one, torque: {motor}}}
  aux: {{body: two, torque: "{aux}"}}
  pump: {{body: pump, torque: {pump}}}
scenarios:
  slow: {{{given} quasi_static: {{mesh: {mesh}, points: 6}}}}
"""
PULSATING = '"400 N m * (1 + 0.25 * sin(3 * angle + 0.4))"'
TOLERANCE = 1e-9


def train(mesh, motor="balance", pump=PULSATING, aux="0 N m", helix="", given=""):
    hands = [f", helix_angle: {helix}, hand: {hand}" if helix else "" for hand in ("right", "left")]
    text = TRAIN.format(
        teeth=TEETH, right=hands[0], left=hands[1], motor=motor, pump=pump, aux=aux, mesh=mesh, given=given
    )
    return solve_quasistatic(compiled(text, "slow")[1])


def base_radius(z, helix):
    beta = math.radians(float(helix.split()[0])) if helix else 0.0
    alpha_t = math.atan(math.tan(math.radians(20.0)) / math.cos(beta))
    return 0.5 * z * 3e-3 / math.cos(beta) * math.cos(alpha_t)


def mid_torques(data, helix=""):
    """Torques of both meshes on the intermediate shaft; forces pull equally on both gears of a mesh."""
    forces = (data[f"mesh_force[{mesh}]"].values for mesh in ("first", "second"))
    return [-base_radius(z, helix) * force for z, force in zip((50, 18), forces, strict=True)]


@pytest.mark.parametrize("helix", ["", "15 deg"])
@pytest.mark.parametrize("mesh", ["first", "second"])
@pytest.mark.parametrize("given", ["", "speed: {one: -1450 rpm},"])
def test_a_balancing_torque_follows_a_pulsating_load(mesh, helix, given):
    """At rest and with speeds: 400 N m on average, at every position the torque of the pump over 6.25."""
    data = train(mesh, helix=helix, given=given)
    on_one, on_pump = (data[f"torque[{name}]"].values for name in ("motor", "pump"))
    assert np.ptp(on_pump) > 0.02 * 400.0
    first, second = mid_torques(data, helix)
    np.testing.assert_allclose(first, -second, rtol=TOLERANCE)
    np.testing.assert_allclose(on_one * 2.5 * 2.5, -on_pump, rtol=TOLERANCE)
    np.testing.assert_allclose(on_one, base_radius(20, helix) * data["mesh_force[first]"], rtol=TOLERANCE)
    assert not any(name.startswith("holding_torque") for name in data)
    low, high = (f"{edge:.4g}" for edge in (on_one.min(), on_one.max()))
    note = f"motor balances pump at every position, with {low} to {high} N m, and its mean over the whole "
    assert note in data.attrs["notes"]
    assert "cycle of the loads is -64 N m" in data.attrs["notes"]


def test_several_pulsating_loads_and_a_balance_at_the_output():
    """A load on the intermediate shaft: it takes its part of the torque between both meshes."""
    data = train("first", motor='"60 N m * (1 + 0.1*sin(angle + 1))"', pump="balance", aux=PULSATING[1:-1])
    motor, aux, pump = (data[f"torque[{name}]"].values for name in ("motor", "aux", "pump"))
    assert min(np.ptp(motor), np.ptp(aux), np.ptp(pump)) > 0.1
    # bodies one and three turn the same way round, body two the other way
    np.testing.assert_allclose(pump, -6.25 * motor + 2.5 * aux, rtol=TOLERANCE)
    first, second = mid_torques(data)
    np.testing.assert_allclose(first + second, -aux, rtol=TOLERANCE)
    assert "pump balances motor and aux at every position" in data.attrs["notes"]


def test_a_pulsation_of_rounding_is_not_noted():
    """Without torque of the loads a balancing torque of 1e-36 N m is rounding, not a pulsation."""
    text = TRAIN.format(
        teeth=TEETH, right="", left="", motor="balance", pump="0 N m", aux="0 N m", mesh="first", given=""
    )
    system = compiled(text, "slow")[1]
    rows = np.zeros((3, len(system.layout.channels)))
    rows[:, system.layout.channel("torque[motor]")] = -7e-36, 0.0, 7e-36
    cycle = SimpleNamespace(means={list(system.names[LOAD]).index("pump"): 0.0})
    assert balance_notes(system, cycle, rows) == ()
    rows *= 1e37
    assert balance_notes(system, cycle, rows)[0].startswith("motor balances pump at every position")


def test_a_drive_takes_the_pulsating_part():
    """Its torque is that of the load over the ratio; without a balancing torque nothing is noted."""
    data = train("second", motor="0 N m", given="drive: {one: {speed: 100 rpm}},")
    np.testing.assert_allclose(data["torque[one]"] * 6.25, -data["torque[pump]"], rtol=TOLERANCE)
    assert "balance" not in data.attrs["notes"]


def test_loads_without_drive_and_balance_show_the_holding_torque():
    """64 N m balance the pump in the mean only: the gear of the mesh is held, in a channel and a note."""
    data = train("second", motor="-64 N m")
    held = data["holding_torque[two]"].values
    np.testing.assert_allclose(held, data["torque[pump]"] / 2.5 - 160.0, atol=1e-7)
    low, high = (f"{edge:.4g}" for edge in (-held.max(), -held.min()))
    assert (
        f"the loads do not balance: {low} to {high} N m on two are balanced by holding torques"
        in (data.attrs["notes"])
    )


SET = f"""\
gears:
  sun: {{number_of_teeth: 30, {TEETH}}}
  ring: {{type: internal, number_of_teeth: 78, {TEETH}, tip_diameter: 229.2 mm, bore_diameter: 264 mm}}
bodies:
  sun_shaft: {{gears: [sun], inertia: 2e-2 kg m^2}}
  carrier: {{inertia: 2e-1 kg m^2, mass: 3 kg}}
  ring_body: {{gears: [ring], motion: MOTION, inertia: 0.5 kg m^2}}
planetary_stages:
  set: {{sun: sun, ring: ring, carrier: carrier, planets: 4,
    planet: {{number_of_teeth: 24, {TEETH}, bore_diameter: 16 mm}}}}
loads:
  in: {{body: sun_shaft, torque: SUN}}
  out: {{body: carrier, torque: CARRIER}}
scenarios:
  slow: {{quasi_static: {{mesh: MESH, points: 6}}}}
"""


@pytest.mark.parametrize("mesh", ["sun-planet_1", "planet_1-ring"])
@pytest.mark.parametrize("balanced", ["SUN", "CARRIER"])
def test_a_planetary_set_is_in_balance_at_every_position(mesh, balanced):
    """Ring held: the carrier has 1 + 78/30 times the torque of the sun (Willis)."""
    text = SET.replace("MOTION", "fixed").replace("MESH", mesh).replace(balanced, "balance")
    text = text.replace({"SUN": "CARRIER", "CARRIER": "SUN"}[balanced], PULSATING)
    data = solve_quasistatic(compiled(text, "slow")[1])
    sun, carrier = (data[f"torque[{name}]"].values for name in ("in", "out"))
    assert np.ptp(sun) > 0.02 * np.abs(sun).max()
    np.testing.assert_allclose(carrier, -(1.0 + 78.0 / 30.0) * sun, rtol=1e-6)
