# SPDX-License-Identifier: Apache-2.0
"""The example `wind-drive-grc`: kinematics exact, modes against masses by hand, emergency stop, planet loads.

Published (F. Oyague, NREL/TP-500-41160, 2009): teeth 21/39/99, 82/23, 88/22, so ratios 5.714286, 3.565217,
4.000 and 81.490683; 22.09 rpm of the rotor are 1800 rpm of the generator; orders of the tapered roller
bearings of the high-speed shaft with 20 rollers 8.490, 11.510, 0.425 and 6.234.
"""

from __future__ import annotations

import math
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import pitchpoint
from pitchpoint.report.frequencies import frequencies_of, turning_speeds

FOLDER = Path(__file__).parents[2] / "examples" / "wind-drive-grc"
RATIOS = (1 + Fraction(99, 21), Fraction(82, 23), Fraction(88, 22))
TOTAL = RATIOS[0] * RATIOS[1] * RATIOS[2]
ROTOR = 22.09 * math.pi / 30.0


@pytest.fixture(scope="module", params=["torsion", "linear_bearings", "model"])
def model(request):
    return pitchpoint.load_model(FOLDER / f"{request.param}.yaml")


@pytest.fixture(scope="module")
def torsion():
    return pitchpoint.load_model(FOLDER / "torsion.yaml")


@pytest.fixture(scope="module")
def whole():
    return pitchpoint.load_model(FOLDER / "model.yaml")


def found(model):
    """Speeds and frequencies at rated speed, as `pitchpoint frequencies` prints them."""
    return frequencies_of(model, turning_speeds(model, model.scenarios["rated"].speed))


def test_the_speeds_are_exact(model):
    """Products of tooth counts, for all models: 22.09 rpm and 1800.129 rpm, to rounding."""
    shafts = found(model)["shafts"]
    assert [round(float(r), 6) for r in (*RATIOS, TOTAL)] == [5.714286, 3.565217, 4.0, 81.490683]
    by_hand = {
        "carrier": Fraction(1),
        "sun": RATIOS[0],
        "low_speed": RATIOS[0],
        "planet_1": 1 - Fraction(99, 39),
        "intermediate": -RATIOS[0] * RATIOS[1],
        "high_speed": TOTAL,
        "generator": TOTAL,
    }
    for body, ratio in by_hand.items():
        assert shafts[body]["speed"] == pytest.approx(float(ratio) * ROTOR, rel=1e-13), body
    assert shafts["generator"]["speed"] * 30.0 / math.pi == pytest.approx(1800.0, rel=1e-4)


def test_mesh_and_planet_pass_frequencies(model):
    """99 meshes per turn of the carrier; the wheels by their own speeds; three planets pass per turn."""
    frequencies = found(model)
    turn = 22.09 / 60.0
    by_hand = {
        "sun-planet_1": 99 * turn,
        "planet_3-ring": 99 * turn,
        "stage_2": float(82 * RATIOS[0]) * turn,
        "stage_3": float(22 * TOTAL) * turn,
    }
    for mesh, frequency in by_hand.items():
        assert frequencies["meshes"][mesh]["frequency"] == pytest.approx(frequency, rel=1e-13), mesh
    (carrier,) = frequencies["planet_sets"].values()
    assert carrier["planet_pass"] == pytest.approx(3 * turn, rel=1e-13)


def test_all_planets_are_in_phase(model):
    """21 and 99 are multiples of three: every harmonic of the mesh excites rotational modes only."""
    (carrier,) = found(model)["planet_sets"].values()
    for gear in ("sun", "ring"):
        assert list(carrier["central"][gear]["phases"].values()) == pytest.approx([0.0] * 3, abs=1e-9)
        assert carrier["central"][gear]["excites"] == ["rotational"] * 3


def test_orders_of_the_high_speed_bearings(whole):
    bearings = found(whole)["rolling_bearings"]
    turn = 22.09 / 60.0 * float(TOTAL)
    for name in ("high_speed_b", "high_speed_c"):
        orders = [abs(bearings[name][key]) / turn for key in ("bpfo", "bpfi", "ftf", "bsf_double")]
        assert orders == pytest.approx([8.490, 11.510, 0.425, 6.234], abs=1.1e-3), name


def test_torsional_modes_against_three_masses(torsion):
    """Rotor, gearbox and generator, referred to the rotor, on couplings and meshes in series."""
    from pitchpoint.solvers.modal import find_modes

    r_1, r_2, r = float(RATIOS[0]), float(RATIOS[0] * RATIOS[1]), float(TOTAL)
    inertia = {name: torsion.body_inertia(name) for name in torsion.bodies}
    planet = inertia["planet_1"].mass * 0.3025887**2 + inertia["planet_1"].polar * (1 - 99 / 39) ** 2
    gearbox = inertia["carrier"].polar + 3.0 * planet + inertia["sun"].polar * r_1**2
    gearbox += inertia["low_speed"].polar * r_1**2 + inertia["intermediate"].polar * r_2**2
    gearbox += inertia["high_speed"].polar * r**2
    slow, fast = 1.0 / (1.0 / 1.6e8 + 1.0 / (1e8 * r_1**2)), 5e4 * r**2
    stiffness = np.array([[slow, -slow, 0.0], [-slow, slow + fast, -fast], [0.0, -fast, fast]])
    masses = np.array([1.0e6, gearbox, 24.0 * r**2])
    by_hand = np.sqrt(np.sort(np.linalg.eigvals(stiffness / masses[:, None]).real)[1:]) / (2.0 * math.pi)
    modes = find_modes(pitchpoint.compile_model(torsion, "rated")).frequency
    # the meshes, taken as rigid, are in series with the shafts: they lower the first mode by 3 %
    assert modes[1:3] == pytest.approx(by_hand, rel=0.03)
    assert all(modes[1:3] < by_hand)


STOP = {"parameters.stop": 0.2, "scenarios.stop.duration": 2.2, "scenarios.stop.step": 2e-4}


@pytest.fixture(scope="module")
def stopped(torsion):
    return pitchpoint.solve_time(pitchpoint.compile_model(torsion.replace_all(STOP), "stop"))


def test_the_stop_crosses_the_backlash(stopped):
    """The brake reverses the torque of the train: the high-speed mesh leaves one flank and hits the other."""
    state = stopped["contact_state[stage_3]"]
    assert set(np.unique(state)) == {-1.0, 0.0, 1.0}
    force = stopped["mesh_force[stage_3]"]
    assert float(force.min()) < -100e3 and float(force.max()) > 50e3
    before = force.sel(time=slice(0.0, 0.19))
    by_hand = 324.2e3 / float(TOTAL) / (0.5 * 22 * 5e-3 / math.cos(math.radians(14.0)))
    alpha_t = math.atan(math.tan(math.radians(20.0)) / math.cos(math.radians(14.0)))
    assert float(before.mean()) == pytest.approx(-by_hand / math.cos(alpha_t), rel=2e-3)


def test_the_energy_of_the_stop_is_balanced(torsion, stopped):
    """Kinetic energy and work of the wind less that of the grid become heat in brake and dampers."""
    t = stopped.time.values

    def work(*channels):
        product = np.ones_like(t)
        for channel in channels:
            product = product * stopped[channel].values
        return float(np.trapezoid(product, t))

    def kinetic(k):
        total = 0.0
        for name in ("rotor", "carrier", "sun", "low_speed", "intermediate", "high_speed", "generator"):
            total += 0.5 * torsion.body_inertia(name).polar * float(stopped[f"speed[{name}]"][k]) ** 2
        for name in ("planet_1", "planet_2", "planet_3"):
            inertia = torsion.body_inertia(name)
            orbit = 0.3025887 * float(stopped["speed[carrier]"][k])
            total += (
                0.5 * inertia.polar * float(stopped[f"speed[{name}]"][k]) ** 2 + 0.5 * inertia.mass * orbit**2
            )
        return total

    def elastic(k):
        stored = sum(float(v[k]) for n, v in stopped.data_vars.items() if str(n).startswith("elastic_energy"))
        for name, c in torsion.couplings.items():
            stored += 0.5 * float(stopped[f"coupling_force[{name}.mz]"][k]) ** 2 / c.stiffness.torsion
        return stored

    given = work("torque[wind]", "speed[rotor]") + work("torque[grid]", "speed[generator]")
    brake = -work("torque[brake]", "slip_speed[brake]")
    lost = kinetic(0) - kinetic(-1) + elastic(0) - elastic(-1) + given - brake
    assert brake > 1.0e6
    assert 0.0 < lost < 0.05 * brake  # dampers of meshes and couplings


@pytest.fixture(scope="module")
def at_rest(whole):
    """Static solution under gravity at rated torque."""
    return pitchpoint.solve_equilibrium(pitchpoint.compile_model(whole, "rated"))


ANGLES = np.radians([0.0, 120.0, 240.0])
ALPHA_T = math.atan(math.tan(math.radians(20.0)) / math.cos(math.radians(7.5)))
ROUND = np.column_stack([-np.sin(ANGLES), np.cos(ANGLES)])
OUT = np.column_stack([np.cos(ANGLES), np.sin(ANGLES)])


def test_the_floating_sun_shares_the_load_by_its_equilibrium(whole, at_rest):
    """Three mesh forces balance the torque, the weight of the sun and the force of the spline on it.

    At the three angles of the planets this is one turn of the carrier: the loads of a planet vary by
    2/3 of the lateral load of the sun, once per turn.
    """
    lines = math.cos(ALPHA_T) * ROUND - math.sin(ALPHA_T) * OUT  # of the forces of the planets on the sun
    weight = whole.body_inertia("sun").mass * np.array(whole.gravity[:2])
    spline = np.array([float(at_rest[f"coupling_force[spline.{k}]"]) for k in ("fx", "fy")])
    torque = float(at_rest["coupling_force[spline.mz]"])
    r_b = 0.5 * 21 * 10e-3 / math.cos(math.radians(7.5)) * math.cos(ALPHA_T)
    balance = np.vstack([lines.T, [r_b] * 3])
    by_hand = np.linalg.solve(balance, [*(spline - weight), torque])
    found = [-float(at_rest[f"mesh_force[sun-planet_{k}]"]) for k in (1, 2, 3)]
    assert found == pytest.approx(by_hand, rel=1e-3)
    amplitude = 2.0 / 3.0 * np.linalg.norm(spline - weight)
    first = 2.0 / 3.0 * abs(np.sum(np.array(found) * np.exp(-1j * ANGLES)))
    assert first == pytest.approx(amplitude, rel=0.05)


def test_the_pins_carry_the_weight_of_the_planets(whole, at_rest):
    """Sun and ring push a planet by 2 F cos(alpha_t) against the turn; the rest of the pin force is weight.

    The sum over the planets is not changed by the twist of the main shaft, which turns all forces.
    """
    weight = whole.body_inertia("planet_1").mass * np.array(whole.gravity[:2])
    rest = np.zeros(2)
    for k in range(3):
        rest += [float(at_rest[f"bearing_force[planet_{k + 1}-bearing.{c}]"]) for c in ("fx", "fy")]
        meshes = [f"mesh_force[sun-planet_{k + 1}]", f"mesh_force[planet_{k + 1}-ring]"]
        rest -= sum(abs(float(at_rest[name])) for name in meshes) * math.cos(ALPHA_T) * ROUND[k]
    assert rest == pytest.approx(-3.0 * weight, abs=0.02 * 3.0 * np.linalg.norm(weight))
