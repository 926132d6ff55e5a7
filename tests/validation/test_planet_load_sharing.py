# SPDX-License-Identifier: Apache-2.0
"""Load sharing of planets with a pin error, against closed forms of springs in parallel.

A planet between two meshes of stiffness k, pushed by a tangential pin force 2 F along the circle of its pin,
deflects both meshes by F/k: along the circle of the pins by F/(k cos alpha) (planet free to spin, ring and
sun rigid), and its bearing of stiffness k_b by 2 F cos alpha / k_b. Seen along the base tangent of the sun
mesh each planet is a spring of stiffness

    K = 1/(2/k + 4 cos^2 alpha/k_b)

from sun to carrier, over the travel of the sun along its base tangent plus that of the carrier (the sun moves
by u and both meshes share it). A tangential pin error e shifts this spring by 2 e cos alpha. With sun and
carrier on fixed axes the springs are in parallel: F_n = K (u - e_n'), sum F_n = T/r_b, so that

    F_n = T/(N r_b) + K (mean(e') - e_n'),   e' = 2 e cos alpha (a pin that runs ahead of the carrier in the
    direction in which the sun drives loses load),

the springs of A. Singh, Epicyclic load sharing map - application as a design tool, Gear Solutions. A sun
that floats has no net force: for N = 3 the three forces are equal (statically determinate); for N = 4 only
opposite planets are equal, and the part of the errors with alternating sign, K (e_1 - e_2 + e_3 - e_4)/4,
remains.

Tolerances: the errors of 20 and 40 µm are 3e-4 rad of the circle of 90 mm; a sun that moves by 4/3 of them
turns its lines of action by as much: 1e-3 of the mean force.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import pitchpoint
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.quasistatic.roll import solve_quasistatic
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from tests.support.planet_stages import stage_file

K, K_PIN = 5e8, 5e8
ALPHA = math.radians(20.0)
R_B = 0.5 * 21 * 3e-3 * math.cos(ALPHA)
MESH = "stiffness: {law: constant, value: 5e8 N/m}, damper: {ratio: 0.05}, backlash: {normal: 0.2 mm}"


def stage(errors, torque=600.0, sun="torsion", motion="planar"):
    """Stage with tangential pin errors [m]."""
    pins = ", ".join(f"planet_{k}: {{tangential: {e!r} m}}" for k, e in enumerate(errors, start=1))
    more = f"planets: {len(errors)}\npin_errors: {{{pins}}}\nmotion: {motion}"
    more += "\nbearing: {stiffness: {radial: 5e8 N/m}}" if motion != "torsion" else ""
    return loads_model(stage_file(more, torque=torque, mesh=MESH, sun=sun))


def forces(errors, **how):
    """Forces of the sun meshes in equilibrium [N]."""
    found = solve_equilibrium(compile_model(stage(errors, **how)))
    return np.array([float(found[f"mesh_force[sun-planet_{k}]"]) for k in range(1, len(errors) + 1)])


def on_fixed_axes(errors, torque, k_pin):
    """Closed form for sun and carrier that only turn."""
    each = 1.0 / (2.0 / K + (4.0 * math.cos(ALPHA) ** 2 / k_pin if k_pin else 0.0))
    ahead = 2.0 * math.cos(ALPHA) * np.array(errors)
    return torque / (len(errors) * R_B) + each * (ahead.mean() - ahead)


@pytest.mark.parametrize("torque", [300.0, 600.0, 1500.0])
@pytest.mark.parametrize("errors", [(5e-6, 0, 0), (-8e-6, 0, 0), (5e-6, 0, -3e-6, 0)])
@pytest.mark.parametrize(("motion", "k_pin"), [("torsion", 0.0), ("planar", K_PIN)])
def test_fixed_axes(errors, torque, motion, k_pin):
    wanted = on_fixed_axes(errors, torque, k_pin)
    assert wanted.min() > 0.0
    found = forces(errors, torque=torque, motion=motion)
    assert found == pytest.approx(wanted, abs=1e-3 * wanted.mean())


@pytest.mark.parametrize("torque", [100.0, 600.0, 1500.0])
@pytest.mark.parametrize("error", [20e-6, -20e-6, 40e-6, -40e-6])
@pytest.mark.parametrize("motion", ["torsion", "planar"])
def test_a_floating_sun_makes_three_planets_equal(error, torque, motion):
    """On fixed axes the 40 µm would leave planet 1 without load below 1000 N m."""
    found = forces((error, 0.0, 0.0), torque=torque, sun="planar", motion=motion)
    assert found == pytest.approx(torque / (3 * R_B), rel=3e-3)


@pytest.mark.parametrize("error", [8e-6, -8e-6])
@pytest.mark.parametrize("torque", [600.0, 1500.0])
def test_a_floating_sun_and_four_planets(error, torque):
    """What remains alternates: K e'/4 less load on the faulty planet and the one opposite."""
    found = forces((error, 0.0, 0.0, 0.0), torque=torque, sun="planar")
    each = 1.0 / (2.0 / K + 4.0 * math.cos(ALPHA) ** 2 / K_PIN)
    rest = 0.25 * each * 2.0 * math.cos(ALPHA) * error * np.array([-1.0, 1.0, -1.0, 1.0])
    assert found == pytest.approx(torque / (4 * R_B) + rest, abs=1e-3 * torque / (4 * R_B))


@pytest.mark.parametrize("torque", [300.0, 600.0, 1200.0, 2400.0])
def test_the_factor_of_one_pin_error_over_the_torque(torque):
    """K_gamma of a pin that is ahead by e, with the mean force F: 1 for three planets with a floating sun and
    1 + K e'/(3 F) on fixed axes; 1 + K e'/(4 F) for four planets with either sun."""
    error = 4e-6
    spring = 2.0 * math.cos(ALPHA) * error / (2.0 / K + 4.0 * math.cos(ALPHA) ** 2 / K_PIN)
    for count, sun, wanted in (
        (3, "planar", 1.0),
        (3, "torsion", 1.0 + spring * R_B / torque),
        (4, "planar", 1.0 + spring * R_B / torque),
        (4, "torsion", 1.0 + spring * R_B / torque),
    ):
        model = stage((error, *[0.0] * (count - 1)), torque=torque, sun=sun)
        loads = pitchpoint.planet_loads(model, solve_equilibrium(compile_model(model)))["set"]
        assert loads.factor == pytest.approx(wanted, abs=1e-3), (count, sun)


def test_the_factor_in_static_solution_roll_and_run():
    """K_gamma of planets 2 and 3, which carry more; alike in all three, as the stiffness is constant."""
    errors = (8e-6, 0.0, 0.0)
    model = stage(errors)
    wanted = on_fixed_axes(errors, 600.0, K_PIN)
    factor = 3.0 * wanted.max() / wanted.sum()
    assert factor == pytest.approx(1.0670, abs=5e-4)
    system = compile_model(model)
    results = [
        solve_equilibrium(system),
        solve_quasistatic(compile_model(model, "slow")),
        solve_time(compile_model(model, "steady")),
    ]
    for result in results:
        loads = pitchpoint.planet_loads(model, result)["set"]
        assert loads.factor == pytest.approx(factor, rel=1e-3)
        assert loads.share == pytest.approx(wanted / wanted.sum(), abs=1e-3)


@pytest.mark.parametrize("share", [0.5, -0.5, 1.0, -1.0, 3.0, -3.0])
@pytest.mark.parametrize("torque", [100.0, 600.0])
def test_errors_of_a_multiple_of_the_backlash(share, torque):
    """The set centres itself: torques balance, nothing is refused, and up to 1.1 times the backlash the three
    forces are equal. Beyond it, the sun would have to move so far that the backlash of one mesh is used up:
    2 tan alpha sin 120 deg 4/3 e = 0.84 e; front and back flanks then share the load."""
    error = share * 20e-6
    pins = f"planets: 3\npin_errors: {{planet_1: {{tangential: {error!r} m}}}}"
    model = loads_model(stage_file(pins, torque=torque, mesh=MESH.replace("0.2 mm", "0.02 mm"), sun="planar"))
    found = solve_equilibrium(compile_model(model))
    assert float(found["torque[brake]"]) == pytest.approx(-torque * (1.0 + 99 / 21), rel=1e-9)
    sun = np.array([float(found[f"mesh_force[sun-planet_{k}]"]) for k in (1, 2, 3)])
    ring = np.array([float(found[f"mesh_force[planet_{k}-ring]"]) for k in (1, 2, 3)])
    assert ring == pytest.approx(-sun, rel=1e-6)
    # lines of action turn with the sun, by 3e-4, as does the moment of forces beside the axis
    assert sun.sum() == pytest.approx(torque / R_B, rel=1e-3)
    if abs(share) <= 1.0:
        assert sun == pytest.approx(torque / (3 * R_B), rel=2e-3)
