# SPDX-License-Identifier: Apache-2.0
"""Loads and damping of the 5 MW drive train in all directions, against equilibrium and published damping.

Sources: torsional stiffness and damping of the drive train 867.637e6 N m/rad and 6.215e6 N m s/rad, a
damping ratio of 5 % (J. Jonkman et al., NREL/TP-500-38060, 2009, table 5-1); gearbox as in the example.
Everything else is equilibrium of forces, in these frames: z from the rotor to the generator, y upwards,
gravity tilted by 5 deg; forces of the bearings on the planets in axes that follow the carrier, which pushes
them in the sense of its turn.

Weight turns once per turn against the carrier, so that the pin of a planet carries a force of this
amplitude and direction besides the sum of both mesh forces, which push along their lines of action.
Tolerances: the lines of action are those without deflection; planets, suns and carrier move by up to 0.4 mm
of 863 mm, which turns forces of 831 kN by 5e-4, 1 % of the weight of 15.1 kN.
"""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pitchpoint
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.quasistatic.roll import roll_through

pytestmark = pytest.mark.filterwarnings("ignore:profile shifts:pitchpoint.ValidityWarning")
FOLDER = Path(__file__).parents[2] / "examples" / "wind-drive-5mw"
QUARTERS = [0, 14, 28, 42]
"""Mesh periods of stage 1 at four angles of the carrier, 90 deg apart: 56 periods are one turn."""
POINTS = 12
PLANETS = (1, 2, 3)


@pytest.fixture(scope="module")
def model():
    return pitchpoint.load_model(FOLDER / "model.yaml")


@pytest.fixture(scope="module")
def quarters(model):
    """Channels of a slow roll through one mesh period at each of four positions of the carrier."""
    system = pitchpoint.compile_model(model, "slow")
    scenario = replace(model.scenarios["slow"], quasi_static=None)
    roll = roll_through(system, scenario, POINTS, mesh="sun_1-planet_1", others=False, at=QUARTERS)
    assert roll.sentence == "finished"
    rows = roll.rows[:-1]
    return lambda name: rows[:, system.layout.channel(name)]


@pytest.mark.parametrize("planet", PLANETS)
def test_the_pin_carries_the_weight_of_its_planet_once_per_turn(model, quarters, planet):
    """Force of the pin plus forces of sun and ring: amplitude and phase of the weight, nothing else."""
    sun, ring = f"sun_1-planet_{planet}", f"planet_{planet}-ring_1"
    angles = [abs(model.pairs[name].alpha_wt) for name in (sun, ring)]
    on_sun, on_ring = (np.abs(quarters(f"mesh_force[{name}]")) for name in (sun, ring))
    outward = on_sun * math.sin(angles[0]) - on_ring * math.sin(angles[1])
    along = on_sun * math.cos(angles[0]) + on_ring * math.cos(angles[1])
    place = np.exp(1j * (planet - 1) * math.tau / 3.0)
    pin = [quarters(f"bearing_force[planet_{planet}-bearing.{axis}]") for axis in ("fx", "fy")]
    rest = pin[0] + 1j * pin[1] + (outward - 1j * along) * place
    turned = np.exp(1j * quarters("angle[main_shaft]"))
    weight = model.body_inertia(f"planet_{planet}").mass * complex(*model.gravity[:2])
    once = np.mean(rest * turned)
    assert abs(once) == pytest.approx(abs(weight), rel=0.01)
    assert np.degrees(np.angle(-once / weight)) == pytest.approx(0.0, abs=1.0)
    assert np.abs(rest - once / turned).max() < 0.03 * abs(weight)


def test_mean_pin_force_is_that_of_the_torque(model, quarters):
    """Tangential: T/(3 a); radial: 829.5 kN (sin 28.118 deg - sin 17.161 deg), of both meshes."""
    for planet in PLANETS:
        place = np.exp(-1j * (planet - 1) * math.tau / 3.0)
        fx, fy = (quarters(f"bearing_force[planet_{planet}-bearing.{axis}]") for axis in ("fx", "fy"))
        mean = np.mean((fx + 1j * fy) * place)
        assert mean.imag == pytest.approx(3945.99e3 / (3.0 * 0.863), rel=1e-3)
        radial = 829.5e3 * (math.sin(math.radians(28.118)) - math.sin(math.radians(17.161)))
        assert -mean.real == pytest.approx(radial, rel=0.02)


def test_axial_bearing_forces_carry_the_axial_weight(model, quarters):
    """The axial forces of the helical stage cancel; each train is held by its own axial bearings."""
    along = model.gravity[2]
    mass = {name: model.body_inertia(name).mass for name in model.bodies}
    trains = {
        ("INP_B", "PLC_A", "PLC_B"): ["main_shaft", "rotor", "carrier_1", *(f"planet_{k}" for k in PLANETS)],
        ("IMS_PLC_A", "IMS_PLC_B"): ["shaft_1", "carrier_2", *(f"small_planet_{k}" for k in PLANETS)],
    }
    for bearings, bodies in trains.items():
        force = sum(np.mean(quarters(f"bearing_force[{name}.axial]")) for name in bearings)
        assert force == pytest.approx(-along * sum(mass[name] for name in bodies), rel=1e-3)


def test_bearings_and_rings_carry_the_weight(model, quarters):
    """At every position: bearings of the housing, forces of the rings on the planets, and all weights."""
    ground = [name for name, part in model.bearings.items() if not part.stage]
    total = sum(
        quarters(f"bearing_force[{name}.fx]") + 1j * quarters(f"bearing_force[{name}.fy]") for name in ground
    )
    for body, planet, ring in (("main_shaft", "planet", "ring_1"), ("shaft_1", "small_planet", "ring_2")):
        angle = abs(model.pairs[f"{planet}_1-{ring}"].alpha_wt)
        for k in PLANETS:
            force = np.abs(quarters(f"mesh_force[{planet}_{k}-{ring}]"))
            place = np.exp(1j * (quarters(f"angle[{body}]") + (k - 1) * math.tau / 3.0))
            total = total - force * (math.sin(angle) + 1j * math.cos(angle)) * place
    fixed = ("ring_1", "ring_2", "generator")  # the generator only rotates
    mass = sum(model.body_inertia(name).mass for name in model.bodies if name not in fixed)
    weight = -mass * complex(*model.gravity[:2])
    assert np.abs(total - weight).max() < 2e-3 * abs(weight)


def test_the_loads_of_the_planets_vary_once_per_turn(quarters):
    """Shares in the mean over a mesh period: 1/3 + A cos(angle in space), the same for all planets.

    Four positions of three planets are 12 places 30 deg apart, at which the sun floats under its weight: the
    largest factor is 1 + 3 A, and over the turn every planet carries one third.
    """
    forces = np.array([quarters(f"mesh_force[sun_1-planet_{k}]") for k in PLANETS])
    by_quarter = forces.reshape(3, len(QUARTERS), POINTS).mean(axis=2)
    shares = by_quarter / by_quarter.sum(axis=0)
    assert shares.mean(axis=1) == pytest.approx(1.0 / 3.0, abs=2e-4)
    angle = quarters("angle[main_shaft]").reshape(len(QUARTERS), POINTS).mean(axis=1)
    place = angle + np.arange(3)[:, None] * math.tau / 3.0
    once = 2.0 * np.mean((shares - 1.0 / 3.0) * np.exp(-1j * place))
    expected = 1.0 / 3.0 + np.abs(once) * np.cos(place + np.angle(once))
    assert shares == pytest.approx(expected, abs=0.03 * abs(once))
    assert abs(once) > 0.01


def test_published_damping_is_five_per_cent():
    """c omega/(2 K) of rotor against generator: 4.9 %."""
    two = pitchpoint.load_model(FOLDER / "two_mass.yaml")
    ratios = find_modes(pitchpoint.compile_model(two, "free")).damping_ratio
    by_hand = 6.215e6 * math.tau * 2.17976 / (2.0 * 867.637e6)
    assert max(ratios) == pytest.approx(by_hand, rel=1e-4)
    assert by_hand == pytest.approx(0.05, rel=0.02)


def test_torque_reversal_after_the_loss_of_the_generator():
    """Two masses: the torque of the shaft swings to T (J_g - J_r d)/(J_r + J_g), d decay per half period."""
    model = pitchpoint.load_model(FOLDER / "torsion.yaml")
    changed = model.replace_all({"parameters.stop": 0.02, "scenarios.stop.duration": 0.32})
    run = pitchpoint.solve_time(pitchpoint.compile_model(changed, "stop"))
    torque = -run["coupling_force[main_shaft.mz]"]
    rotor, ratio = 5.81164e7, 96.354167
    generator = 1.14 * 534.116 * ratio**2  # with the gears
    decay = math.exp(-math.pi * 0.039)
    by_hand = (generator - rotor * decay) / (rotor + generator)
    assert float(torque.min()) / 3945.99e3 == pytest.approx(by_hand, rel=0.02)
