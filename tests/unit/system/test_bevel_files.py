# SPDX-License-Identifier: Apache-2.0
"""Bevel meshes from the model file to modes, statics, roll and time, against closed forms."""

import math

import numpy as np
import pytest

from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.solvers.frequency_response import find_response
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.bevel_files import bevel_file
from tests.support.turned_world import about, turned

FREE = "motion: free, mass: 2 kg, inertia: {inertia}, transverse_inertia: 2e-2 kg m^2"
BEARINGS = """
bearings:
  one: {body: first, position: [0, 0, 120 mm], stiffness: {radial: 3e8, axial: 2e8, tilt: 3e5}}
  two: {body: second, position: [0, 0, 60 mm], stiffness: {radial: 4e8, axial: 3e8, tilt: 5e5}}
"""
LOADS = "loads:\n  in: {body: first, torque: 80 N m}\n  out: {body: second, torque: balance}\n"


def base_radii(model):
    """At the mean cone distance [m]."""
    pair = model.bevel_pairs["m"]
    return [pair.R_m * math.sin(gear.delta_b) for gear in (pair.gear1, pair.gear2)]


@pytest.mark.parametrize("shaft, spiral", [(90.0, 0.0), (75.0, 35.0), (110.0, -20.0)])
def test_natural_frequency_of_two_inertias(shaft, spiral):
    """omega^2 = k (r_b1^2/J1 + r_b2^2/J2) with the base radii at the mean cone distance."""
    model = loads_model(bevel_file(shaft=shaft, spiral=spiral, rest=LOADS))
    r1, r2 = base_radii(model)
    found = find_modes(compile_model(model))
    expected = math.sqrt(3e8 * (r1**2 / 2e-3 + r2**2 / 3e-2)) / math.tau
    assert found.frequency[-1] == pytest.approx(expected, rel=1e-9)
    assert found.frequency[0] == pytest.approx(0.0, abs=1e-3)


@pytest.mark.nojit
@pytest.mark.parametrize("opens", [("+z", "+z"), ("-z", "+z"), ("+z", "-z"), ("-z", "-z")])
def test_speeds_and_torques_follow_the_side_that_the_cones_open_to(opens):
    """The machine is the same whichever way z of its bodies points; signs of spins and torques follow."""
    scenario = "scenarios:\n  s: {speed: {first: 100 rpm}, quasi_static: {points: 2}}\n"
    model = loads_model(bevel_file(opens=opens, rest=LOADS + scenario))
    sign = -1.0 if opens[0] == opens[1] else 1.0
    speeds = model.start_speeds("s")
    assert speeds["second"] == pytest.approx(sign * 0.5 * speeds["first"], rel=1e-12)
    found = solve_equilibrium(compile_model(model))
    assert float(found["torque[out]"]) == pytest.approx(-sign * 160.0, rel=1e-9)
    r1 = base_radii(model)[0]
    assert float(found["mesh_force[m]"]) == pytest.approx(
        80.0 / r1 * (1 if opens[0] == "+z" else -1), rel=1e-9
    )


@pytest.mark.parametrize("spiral", [0.0, 35.0])
@pytest.mark.parametrize("torque", [80.0, -80.0])
def test_bearings_carry_the_textbook_forces(spiral, torque):
    """F_t = T/r_m but for the width, over which a rigid turn loads the larger cone distance more: less by
    1 + b^2/(12 R_m^2). F_r and F_a from it as in ISO 23509; stiff bearings leave the load where it is."""
    rest = BEARINGS.replace("e8", "e11").replace("e5", "e8") + LOADS.replace("80", str(torque))
    model = loads_model(bevel_file(spiral=spiral, bodies=FREE, rest=rest))
    found = solve_equilibrium(compile_model(model))
    pair = model.bevel_pairs["m"]
    F_t = torque / (0.5 * pair.gear1.d_m) / (1.0 + (pair.b / pair.R_m) ** 2 / 12.0)
    sin_b, cos_b, tan = math.sin(pair.gear1.beta_m), math.cos(pair.gear1.beta_m), math.tan(pair.gear1.alpha_n)
    for body, gear, side in (("one", pair.gear1, math.copysign(1.0, torque)), ("two", pair.gear2, 0.0)):
        sense = side or -math.copysign(1.0, torque)
        F_a = abs(F_t) / cos_b * (tan * math.sin(gear.delta) + sense * sin_b * math.cos(gear.delta))
        F_r = abs(F_t) / cos_b * (tan * math.cos(gear.delta) - sense * sin_b * math.sin(gear.delta))
        fx, fy, fz = (float(found[f"bearing_force[{body}.{c}]"]) for c in ("fx", "fy", "fz"))
        assert -fz == pytest.approx(F_a, rel=3e-3, abs=1e-3 * abs(F_t))  # bearings hold the gear back
        assert math.hypot(fx, fy) == pytest.approx(math.hypot(F_t, F_r), rel=3e-3)


def test_a_roll_of_rigid_bodies_has_no_unloaded_error_and_repeats_with_the_teeth():
    law = "stiffness: {law: din3990, single_stiffness: 14 N/(mm um), stiffness_ratio: 0.8}"
    roll = "scenarios:\n  r: {quasi_static: {points: 21}}\n"
    model = loads_model(bevel_file(spiral=30.0, mesh=law, rest=LOADS + roll))
    system = compile_model(model)
    found = roll_through(system, "r")
    mesh = found.meshes["m"]
    assert np.ptp(mesh.unloaded) < 1e-12
    te = found.rows[:, system.layout.channel("transmission_error[m]")]
    assert te[0] == pytest.approx(te[-1], abs=1e-12)
    force = found.rows[:, system.layout.channel("mesh_force[m]")]
    assert np.allclose(force, 80.0 / base_radii(model)[0], rtol=1e-9)
    stiffness = found.rows[:, system.layout.channel("mesh_stiffness[m]")]
    assert mesh.tangent_stiffness == pytest.approx(stiffness, rel=1e-6)
    assert mesh.share.sum(axis=1) == pytest.approx(np.ones(len(te)))


def test_mean_stiffness_over_the_cycle_is_that_of_the_roll():
    """Closed form: c' (1 - (1 - S_R)/3) eps_alpha times the integral of (R/R_m)^2; modes take it too."""
    law = "stiffness: {law: din3990, single_stiffness: 14 N/(mm um), stiffness_ratio: 0.7}"
    model = loads_model(bevel_file(spiral=30.0, mesh=law, rest=LOADS))
    system = compile_model(model)
    pair = model.bevel_pairs["m"]
    k = 14e9 * (1.0 - 0.1) * pair.eps_alpha * pair.b * (1.0 + (pair.b / pair.R_m) ** 2 / 12.0)
    assert float(system.records["bevel_mesh"]["contact"]["k_ref"][0]) == pytest.approx(k, rel=1e-12)
    r1, r2 = base_radii(model)
    expected = math.sqrt(k * (r1**2 / 2e-3 + r2**2 / 3e-2)) / math.tau
    assert find_modes(system).frequency[-1] == pytest.approx(expected, rel=1e-6)


def energy(system, state):
    """Kinetic energy, springs of the bearings (small displacements), flanks."""
    M = evaluate.matrix(system, state, 1.0, 0.0, 0.0)
    total = 0.5 * state.v @ M @ state.v
    total += evaluate.observe(system, state)[system.layout.channel("elastic_energy[m]")]
    for record in system.records["bearing"]:
        first = int(system.program["body"][int(record["i"])]["dof"])
        z, u = float(record["zi"]), state.q[first : first + 6].copy()
        u[0], u[1] = u[0] + z * u[4], u[1] - z * u[3]
        total += 0.5 * u[:5] @ np.array(record["K"])[:5, :5] @ u[:5]
    return total


@pytest.mark.parametrize("spiral", [0.0, 35.0])
def test_energy_is_kept_through_impacts_on_both_flanks(spiral):
    """A rattling pair on elastic bearings without damping and friction, thrown against its flanks."""
    system = compile_model(loads_model(bevel_file(spiral=spiral, bodies=FREE, rest=BEARINGS)))
    state = system.initial_state()
    approach = 0.6
    state.v[system.spin("first")] = 50.0
    state.v[system.spin("second")] = -25.0 + approach
    start = energy(system, state)
    run = runge_kutta.start_adaptive(system, state, rtol=1e-9, atol=1e-14, atol_rate=1e-10)
    touched = set()
    for t in np.linspace(2e-4, 1e-2, 50):
        assert run.advance_to(t).status == 1
        state = run.state()
        touched.add(float(evaluate.observe(system, state)[system.layout.channel("contact_state[m]")]))
    assert touched >= {1.0, 0.0, -1.0}
    thrown = 0.5 * approach**2 / (4.0 / 2e-3 + 1.0 / 3e-2) * 4.0
    assert abs(energy(system, state) - start) < 2e-4 * thrown


def test_a_model_is_written_and_read_back():
    model = loads_model(bevel_file(spiral=25.0, mounting=(0.02, -0.03), rest=LOADS))
    again = loads_model(dump_model(model))
    assert again.bevel_meshes == model.bevel_meshes and again.bevel_gears == model.bevel_gears
    changed = model.replace("bevel_meshes.m.stiffness.value", "2e8 N/m")
    assert float(compile_model(changed).records["bevel_mesh"]["c_prime"][0]) == 2e8


def test_the_place_of_the_apex_on_a_body_changes_nothing():
    """Bodies told from another origin: the same records of places, forces and phases."""
    results = []
    for mounting in ((0.0, 0.0), (0.05, -0.02)):
        model = loads_model(bevel_file(spiral=25.0, mounting=mounting, rest=LOADS))
        system = compile_model(model)
        evaluate.residual(system, system.initial_state())
        record = system.records["bevel_mesh"][0]
        results.append([record["now"][n].copy() for n in ("P", "m", "e", "t", "u", "gap", "eps", "psi")])
    for one, two in zip(*results, strict=True):
        assert np.allclose(one, two, rtol=1e-9, atol=1e-12)


def test_given_angles_of_both_gears_leave_the_offset_in_the_travel():
    """One gear 3 deg from the pitch ray, its mate where the teeth mesh and 0.01 deg on: r_b2 times that."""
    text = bevel_file(rest=LOADS, mesh="backlash: {normal: 0.2 mm}")
    one = text.replace("opens: +z}", "opens: +z, initial_angle: 3 deg}", 1)
    model = loads_model(one)
    right = model.bevel_angles["b"]
    both = model.replace("bevel_gears.b.initial_angle", right + math.radians(0.01))
    record = compile_model(both).records["bevel_mesh"][0]
    assert record["u0"] == pytest.approx(base_radii(model)[1] * math.radians(0.01), rel=1e-9)
    assert compile_model(model).records["bevel_mesh"][0]["u0"] == pytest.approx(0.0, abs=1e-15)


def test_a_machine_may_stand_along_any_axis_of_the_world():
    """Turned as a whole it does the same; an equilibrium leaves 1e-9 of the largest load over."""
    model = loads_model(bevel_file(shaft=75.0, spiral=25.0, bodies=FREE, rest=BEARINGS + LOADS))
    other = turned(model, about([1.0, -2.0, 0.5], 1.1))
    one, two = (find_modes(compile_model(m)).frequency for m in (model, other))
    assert two == pytest.approx(one, rel=1e-6, abs=1e-3)
    one, two = (solve_equilibrium(compile_model(m)) for m in (model, other))
    for name in ("mesh_force[m]", "axial_force_1[m]", "bearing_force[two.fz]", "displacement[first.z]"):
        assert float(two[name]) == pytest.approx(float(one[name]), rel=1e-5)


def test_errors_of_the_flanks_shake_two_inertias_as_the_closed_form_says():
    """F/e = k omega^2/(omega_0^2 - omega^2): two inertias on a spring whose rest length goes to and fro."""
    model = loads_model(bevel_file(rest=LOADS))
    r1, r2 = base_radii(model)
    omega_0 = math.sqrt(3e8 * (r1**2 / 2e-3 + r2**2 / 3e-2))
    frequency = np.array([10.0, 900.0, 5000.0])
    omega = math.tau * frequency
    system = compile_model(model)
    found = find_response(system, ["transmission_error[m]"], ["mesh_force[m]"], frequency)
    expected = 3e8 * omega**2 / (omega_0**2 - omega**2)
    assert found.response[:, 0, 0].real == pytest.approx(expected, rel=1e-5)


def test_the_backlash_factor_counts_in_mean_normal_modules():
    """j_mt = factor m_mn at the mean cone distance; along the base tangent times cos(alpha_t)."""
    text = bevel_file(shaft=80.0, spiral=30.0, rest=LOADS)
    model = loads_model(text).replace("bevel_meshes.m.backlash", {"factor": 0.05})
    pair = model.bevel_pairs["m"]
    assert model.backlash("m") == pytest.approx(0.05 * pair.gear1.m_mn * math.cos(pair.alpha_t), rel=1e-12)


@pytest.mark.parametrize("opens", [("+z", "+z"), ("-z", "+z")])
@pytest.mark.parametrize("shaft, spiral", [(90.0, 0.0), (75.0, 20.0), (110.0, -35.0)])
def test_the_backlash_of_a_bevel_mesh_follows_the_distance_of_the_apexes(shaft, spiral, opens):
    """At rest that of the model. A gear pulled out of its apex by h opens it by 2 h sin(delta) sin(alpha_t).

    Its pitch cone moves by h sin(delta) away from the mate, normal to the pitch plane, which counts as a
    change of the centre distance of the virtual cylindrical gears does: on both flanks, by sin(alpha_t) each
    along the base tangent. A motion across both axes is a travel and opens nothing.
    """
    text = bevel_file(shaft=shaft, spiral=spiral, opens=opens, bodies=FREE, rest=BEARINGS + LOADS)
    model = loads_model(text)
    system = compile_model(model)
    at, pair = system.layout.channel("backlash[m]"), model.bevel_pairs["m"]
    rest = evaluate.observe(system, system.initial_state())[at]
    assert rest == pytest.approx(model.backlash("m"), abs=1e-14)
    for body, gear, name in (
        ("first", pair.gear1, model.bevel_meshes["m"].gears[0]),
        ("second", pair.gear2, model.bevel_meshes["m"].gears[1]),
    ):
        out = model.bevel_gears[name].direction
        for h in (1e-4, -4e-5):
            state = system.initial_state()
            state.q[system.layout.coordinate(f"{body}.z")] += h * out
            opened = 2.0 * h * math.sin(gear.delta) * math.sin(pair.alpha_t)
            assert evaluate.observe(system, state)[at] - rest == pytest.approx(opened, rel=1e-9)
    state = system.initial_state()
    axes = [system.bodies[k].axes[:, 2] for k in (0, 1)]
    across = np.cross(*axes) / np.linalg.norm(np.cross(*axes))
    moved = 1e-4 * system.bodies[0].axes.T @ across
    for c, x in zip("xyz", moved, strict=True):
        state.q[system.layout.coordinate(f"first.{c}")] += x
    assert evaluate.observe(system, state)[at] == pytest.approx(rest, abs=1e-13)
