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
from pitchpoint.report.planets import stages_of_model

FOLDER = Path(__file__).parents[2] / "examples" / "wind-drive-grc"
RATIOS = (1 + Fraction(99, 21), Fraction(82, 23), Fraction(88, 22))
TOTAL = RATIOS[0] * RATIOS[1] * RATIOS[2]
ROTOR = 22.09 * math.pi / 30.0


@pytest.fixture(scope="module", params=["torsion", "model"])
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
    """Products of tooth counts, for both models: 22.09 rpm and 1800.129 rpm, to rounding."""
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
    for row in stages_of_model(model)["stage_1"]["planets"].values():
        assert (row["phase_sun"] % 1.0, row["phase_ring"] % 1.0) == pytest.approx((0.0, 0.0), abs=1e-9)


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
    assert modes[1:3] == pytest.approx(by_hand, rel=0.02)


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
