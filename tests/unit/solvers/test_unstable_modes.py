# SPDX-License-Identifier: Apache-2.0
"""Unstable modes of a Campbell diagram: limit speeds and growth by hand, and what feeds energy in."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import pitchpoint as pp
from pitchpoint.analysis.campbell_ranking import ranked_speeds, select_modes, unstable_ranges
from pitchpoint.solvers.campbell import follow_modes
from pitchpoint.solvers.critical_speeds import DAMPED
from pitchpoint.solvers.linear_system import linearise
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.modes.unstable import unstable_modes, unstable_notes
from tests.support.machines import compiled
from tests.unit.solvers.test_modal import TWO_ROTORS, whirl_roots

EXAMPLE = Path(__file__).parents[3] / "examples" / "geared-rotor" / "model.yaml"
RPM = math.pi / 30.0
I_P, I_T, K_TILT = 0.006, 0.012, 4e4
DISC = f"""\
bodies:
  disc: {{motion: free, mass: 3, inertia: {I_P}, transverse_inertia: {I_T}}}
bearings:
  support: {{body: disc, stiffness: {{radial: 2e6, axial: 1e8, tilt: {K_TILT}, torsion: 1}}}}
"""


def test_internal_damping_is_unstable_above_a_limit_speed():
    """The damper of the coupling rotates: above the speed at which the largest real part by hand is zero."""
    limit = brentq(lambda speed: whirl_roots(speed).real.max(), 100.0, 1500.0)
    system = compiled(TWO_ROTORS, "s")[1]
    data = pp.solve_campbell(system, np.linspace(0.0, 1500.0, 11), "a", "s")
    (found,) = unstable_ranges(data)
    assert found.low == pytest.approx(limit, rel=1e-6)
    assert found.high == 1500.0
    assert found.source == "coupling c"
    assert "dissipation" not in data.attrs and "no damping" not in data.attrs["notes"]
    assert "forward" in found.mode
    roots = whirl_roots(1500.0)
    worst = roots[np.argmax(roots.real)]
    assert found.damping_ratio == pytest.approx(-worst.real / abs(worst), rel=1e-6)
    assert unstable_ranges(data.isel(speed=slice(0, 1)).drop_vars("unstable_mode")) == ()
    others = [n for n in data["mode"].values if data["name"].values[n - 1] != found.mode]
    assert unstable_ranges(select_modes(data, others)) == ()


@pytest.mark.parametrize("speeds", [(0.0, 2000.0, 4000.0, 6000.0), (300.0, 3150.0, 6000.0)])
def test_limits_of_stability_do_not_depend_on_the_speeds_of_the_diagram(speeds: tuple[float, ...]):
    limit = brentq(lambda speed: whirl_roots(speed).real.max(), 100.0, 1500.0)
    data = pp.solve_campbell(compiled(TWO_ROTORS, "s")[1], speeds, "a", "s")
    assert min(found.low for found in unstable_ranges(data)) == pytest.approx(limit, rel=1e-8)


SET = """\
gears:
  sun: {number_of_teeth: 21, normal_module: 3 mm, face_width: 40 mm, profile_shift_coefficient: 0,
    tooth_thickness_allowance: -40 um}
  ring: {type: internal, number_of_teeth: 99, normal_module: 3 mm, face_width: 40 mm, bore_diameter: 340 mm,
    profile_shift_coefficient: 0, tip_diameter: 292.5 mm, tooth_thickness_allowance: -40 um}
bodies:
  sun: {gears: [sun], motion: planar, mass: 3 kg, inertia: 3e-3 kg m^2, position: [0, 0, 0]}
  ring: {gears: [ring], motion: fixed}
  carrier: {mass: 12 kg, inertia: 0.12 kg m^2}
planetary_stages:
  set:
    {sun: sun, ring: ring, carrier: carrier, planets: 3, motion: planar,
     planet: {number_of_teeth: 39, normal_module: 3 mm, face_width: 40 mm, profile_shift_coefficient: 0,
       tooth_thickness_allowance: -40 um, bore_diameter: 60 mm},
     bearing: {stiffness: {radial: 8e8 N/m}, damping: {ratio: 0.03}},
     pin_errors: {planet_1: {tangential: 30 um}},
     sun_mesh: {stiffness: {law: constant, value: 6e8 N/m}, damper: {ratio: 0.05}},
     ring_mesh: {stiffness: {law: constant, value: 6e8 N/m}, damper: {ratio: 0.05}}}
bearings:
  spline: {body: sun, stiffness: {radial: 1e6 N/m}, damping: {ratio: 0.05}}
loads:
  motor: {body: sun, torque: MOTOR}
  output: {body: carrier, torque: balance}
scenarios:
  s: {speed: {sun: 1500 rpm}, duration: 1 ms}
"""
FILTER = """\
sensors: {n: {type: joint, coordinate: carrier, derivative: 1}}
blocks: {f: {type: filter, input: n, time_constant: 0.01 s}, g: {type: sum, inputs: {f: 0}, unit: N m}}
actuators: {a: {type: torque, bodies: [carrier], signal: g}}
"""
SLOPE = "2e-3 N m s*(speed - 1500 rpm)"


@pytest.mark.parametrize(
    "motor, more, unstable",
    [
        pytest.param("2 N m", "", [], id="constant"),
        pytest.param("2 N m", FILTER, [], id="filter"),
        pytest.param(f"2 N m - {SLOPE}", "", [], id="falling"),
        pytest.param(f"2 N m + {SLOPE}", "", ["rigid rotation"], id="rising"),
    ],
)
def test_a_rigid_rotation_is_unstable_only_if_a_load_drives_it(motor: str, more: str, unstable: list[str]):
    """Rounding of the double zero eigenvalue, up to 1e-7 of the largest, is no growth; a motor whose torque
    rises with the speed is one."""
    system = compiled(SET.replace("MOTOR", motor) + more, "s")[1]
    data = pp.solve_campbell(system, np.linspace(0.0, 190.0, 41), "sun", "s")
    assert [u.mode for u in unstable_ranges(data)] == unstable
    assert np.all(data["frequency"].values[:, 0] == 0.0)


def test_unloaded_flanks_are_closed_at_every_speed_of_a_diagram():
    """The pin error leaves planet 1 without load. Weight of the planets and 190 rad/s move them by nanometres
    only, so that no frequency changes by more than gyroscopic terms do, here 2e-4."""
    system = compiled(SET.replace("MOTOR", "2 N m"), "s")[1]
    modes = pp.solve_modal(system)
    assert "planet_1-ring carry no load" in modes.attrs["notes"]
    data = pp.solve_campbell(system, np.linspace(0.0, 190.0, 5), "sun", "s")
    expected = np.broadcast_to(modes["frequency"].values, data["frequency"].shape)
    np.testing.assert_allclose(data["frequency"].values, expected, rtol=5e-4, atol=1e-6)


def test_modes_without_damping_are_not_unstable():
    data = pp.solve_campbell(compiled(DISC)[1], np.linspace(0.0, 3000.0, 21), "disc", orders=["1x"])
    assert np.abs(data["damping_ratio"].values).max() < 1e-9
    assert unstable_ranges(data) == ()
    assert all(math.isinf(c.amplification) for c in ranked_speeds(data))


def test_undamped_modes_rank_by_what_excites_them():
    """The fan torque of 20 N m feeds the forward whirl of the disc, -0.006 %: it is reported as unstable.

    Unbalance at 1x of the rotor ranks first, since it drives nearly the whole mode; 2x of the drive does not.
    """
    system = pp.compile_model(pp.load_model(EXAMPLE), "fast")
    speeds = np.linspace(300.0, 18000.0, 21) * RPM
    data = select_modes(pp.solve_campbell(system, speeds, "rotor"), frequency=(0.0, 240.0))
    ranked = ranked_speeds(data, least=0.0)
    assert (ranked[0].mode, ranked[0].order) == ("1st bending of rotor (forward)", "1× rotor")
    assert math.isinf(ranked[0].amplification)
    ranks = {(c.mode, c.order): k for k, c in enumerate(ranked)}
    weak = ranks["1st bending of rotor (forward)", "2× drive"]
    assert ranks["torsion of rotor against drive", "2× rotor"] < weak
    assert DAMPED == pytest.approx(0.0019, abs=1e-4)
    (found,) = unstable_ranges(data)
    assert (found.mode, found.source) == ("1st bending of rotor (forward)", "torque fan")
    assert -1e-4 < found.damping_ratio < -5e-5
    assert "dissipation" not in data.attrs  # that of the meshes


PINION = """\
gears:
  a: {number_of_teeth: 23, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  b: {number_of_teeth: 67, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  pinion: {gears: [a], motion: free, position: [0, 0, 0]}
  wheel: {gears: [b], motion: torsion, position: [90 mm, 0, 0]}
bearings:
  support: {body: pinion, stiffness: {radial: 2e8, axial: 1e8, tilt: 4e4}DAMPING}
meshes:
  m: {gears: [a, b], stiffness: {law: constant, value: 3e8 N/m}}
loads: {t: {body: pinion, torque: 60 N m}, o: {body: wheel, torque: balance}}
scenarios:
  s: {speed: {pinion: 1500 rpm}, duration: 1 ms}
"""


def test_a_model_without_damping_is_noted_with_its_unstable_modes():
    """The torque feeds one whirl of the tilting pinion and brakes the other; nothing in the model resists."""
    speeds = np.linspace(50.0, 300.0, 3)
    data = pp.solve_campbell(compiled(PINION.replace("DAMPING", ""), "s")[1], speeds, "pinion")
    found = unstable_ranges(data)
    assert {one.source for one in found} == {"torque t"}
    assert data.attrs["dissipation"] == "none"
    least = f"damping ratios above {-100.0 * found[0].damping_ratio:.2g} % make all listed modes stable"
    assert "the model has no damping" in data.attrs["notes"] and least in data.attrs["notes"]
    damped = PINION.replace("DAMPING", ", damping: {ratio: 0.02}")
    data = pp.solve_campbell(compiled(damped, "s")[1], speeds, "pinion")
    assert unstable_ranges(data) == () and "dissipation" not in data.attrs


def test_modes_at_one_speed_name_unstable_ones_and_their_source():
    linear = linearise(compiled(PINION.replace("DAMPING", ""), "s")[1], "s")
    (said,) = unstable_notes(linear, find_modes(linear.system, "s", linear=linear))
    assert "unstable" in str(said) and "fed by torque t)" in str(said)
    damped = PINION.replace("DAMPING", ", damping: {ratio: 0.02}")
    linear = linearise(compiled(damped, "s")[1], "s")
    modes = find_modes(linear.system, "s", linear=linear)
    assert unstable_notes(linear, modes) == ()
    for value, count in ((1e-14, 0), (0.1, 1)):  # a rigid rotation by rounding, and one that a load drives
        values, ratios = modes.eigenvalue.copy(), modes.damping_ratio.copy()
        values[0], ratios[0] = value, -1.0
        turned = replace(modes, eigenvalue=values, damping_ratio=ratios)
        assert len(unstable_notes(linear, turned)) == count


def test_a_mode_near_another_is_that_of_all_modes_with_states_of_a_brake():
    """Inverse iteration from 50 to 60 rad/s, against all modes there; the brake has a state."""
    text = (
        SET.replace("MOTOR", "2 N m")
        + "clutches:\n  b: {bodies: [carrier], capacity: 1 N m, wind_up: 0.002}\n"
    )
    found = follow_modes(compiled(text, "s")[1], [50.0, 60.0], "sun", "s")
    assert not found.modes.reducible
    for mode in (1, 4):
        value, shape = found.modes.near(60.0, complex(found.eigenvalue[0, mode]), found.shape[0, mode])
        assert value == pytest.approx(complex(found.eigenvalue[1, mode]), rel=1e-9)
        M = found.modes.at(60.0).at_rest.M
        assert abs(shape.conj() @ M @ found.shape[1, mode]) == pytest.approx(1.0, abs=1e-6)


def test_rounding_of_a_rigid_rotation_is_not_an_unstable_mode():
    """Its eigenvalue is zero: the sign of the computed one, a damping ratio of -1, has no meaning."""
    eigenvalue = np.array([[1e-15 * sign, complex(-3.0, 700.0)] for sign in (1.0, -1.0, 2.0)])
    found: Any = SimpleNamespace(
        speed=np.arange(3.0),
        eigenvalue=eigenvalue,
        damping_ratio=-eigenvalue.real / np.abs(eigenvalue),
        rotors=(),
    )
    assert unstable_modes(found) == ()
