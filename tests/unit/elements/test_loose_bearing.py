# SPDX-License-Identifier: Apache-2.0
"""Linear bearings with play in their seat: the tight limit, energy, tangents, no pulling, rest, modes."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.elements import loose_bearing
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.multibody.bodies import FREE, Body
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.modal import solve_modal
from pitchpoint.solvers.time import solve_time
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.rules.loose_bearing import TILTS
from pitchpoint.system.system import assemble
from tests.support.engine import bearings, frame, positive
from tests.support.forces import ENDS, check_balance, check_matrices, mechanism, moving, power, wrenches
from tests.support.markers import set_markers


def loose(bodies, i, j, place=(0.0, 0.0, 0.0), axes=None, **numbers):
    record = np.zeros(1, loose_bearing.RECORD)
    record["i"], record["j"], record["k"] = i, j, 300.0
    for name, value in numbers.items():
        record[name] = value
    set_markers(record[0], bodies, place, axes)
    return record


def energy(system, state):
    """Stored energy from the displacements that the element has left in its record."""
    evaluate.residual(system, state)
    b = system.records["loose_bearing"][0]
    x = np.hypot(*b["x"][:2]) - b["gap"] + 0.5 * b["seat"]
    w = b["seat"]
    inside = min(max(x, 0.0), w)
    radial = inside**3 / (6.0 * w) + (0.5 * (x - 0.5 * w) ** 2 - 0.125 * w * w if x > w else 0.0)
    return b["k"] * radial + 0.5 * b["x"][2:5] @ b["Kt"] @ b["x"][2:5]


@pytest.mark.nojit
@pytest.mark.parametrize("gap", [0.0, 0.05, 0.15])
@pytest.mark.parametrize(("i", "j"), ENDS)
def test_tangents_and_balance_anywhere_in_a_tree(i, j, gap):
    rng = np.random.default_rng(10 * i + j)
    bodies = mechanism(rng)
    place, axes = 0.2 * rng.normal(size=3), frame(rng)
    numbers = {"gap": gap, "seat": 0.06, "d": 20.0, "Kt": positive(rng, 3), "Dt": positive(rng, 3)}
    system = assemble(bodies, {"loose_bearing": loose(bodies, i, j, place, axes, **numbers)})
    state = moving(system, rng, 0.1)
    state.v *= 0.3
    check_matrices(system, state)
    check_balance(system, state)


@pytest.mark.parametrize("x", [0.8e-3, 1.01e-3, 1.2e-3])
def test_forces_are_the_slope_of_the_energy(x):
    """In the gap, where the seat gives way, and beyond; along the seat and across it."""
    bodies = [Body(motion=FREE, mass=1.0, polar_inertia=0.1, transverse_inertia=0.1)]
    Kt = positive(np.random.default_rng(1), 3)
    system = assemble(bodies, {"loose_bearing": loose(bodies, 1, 0, gap=1e-3, seat=1e-4, k=1e6, Kt=Kt)})
    state = system.initial_state()
    state.q[:5] = 0.6 * x, 0.8 * x, 1e-4, 1e-3, -2e-3
    force = evaluate.residual(system, state)
    for c in range(6):
        sides = []
        for s in (-1.0, 1.0):
            moved = state.copy()
            moved.q[c] += s * 1e-8
            sides.append(energy(system, moved))
        assert force[c] == pytest.approx((sides[1] - sides[0]) / 2e-8, rel=1e-6, abs=1e-6)


@pytest.mark.nojit
def test_without_play_it_is_the_linear_bearing():
    """The springs of both kinds on one body, tilted by degrees: forces and exact matrices to round-off."""
    rng = np.random.default_rng(3)
    matrices = []
    for scale in (1.0, 0.02):
        A = np.zeros((6, 6))
        A[2:5, 2:5] = scale * positive(rng, 3)
        A[0, 0] = A[1, 1] = scale * 7.0
        matrices.append(A)
    K, D = matrices
    bodies = [Body(motion=FREE, mass=1.0, polar_inertia=0.1, transverse_inertia=0.15)]
    linear = bearings([(1, 0, K, D)])
    linear["zi"], linear["d0"][:, 2] = 0.2, 0.2
    Kt, Dt = (TILTS.T @ A[2:5, 2:5] @ TILTS for A in (K, D))
    play = loose(bodies, 1, 0, (0.0, 0.0, 0.2), np.eye(3), k=7.0, d=0.14, Kt=Kt, Dt=Dt)
    one, two = assemble(bodies, {"bearing": linear}), assemble(bodies, {"loose_bearing": play})
    for _ in range(5):
        state = moving(one, rng, 0.2)
        np.testing.assert_allclose(wrenches(two, state), wrenches(one, state), atol=1e-14)
        for a, b in zip(evaluate.linearize(one, state), evaluate.linearize(two, state), strict=True):
            np.testing.assert_allclose(b, a, atol=1e-12)


def test_it_never_pulls_and_costs_energy_only_by_its_damping():
    bodies = [Body(motion=FREE, mass=1.0, polar_inertia=0.1, transverse_inertia=0.1)]
    numbers = {"gap": 1e-3, "seat": 1e-4, "k": 1e6, "d": 1e4}
    system = assemble(bodies, {"loose_bearing": loose(bodies, 1, 0, **numbers)})
    state = system.initial_state()
    for x, y in ((0.9e-3, 0.0), (0.96e-3, 0.0), (0.8e-3, 0.7e-3), (2e-3, -1e-3)):
        last = math.inf
        for speed in (0.3, 0.1, 0.0, -0.01, -0.1, -1.0):
            state.q[:2] = x, y
            state.v[:2] = speed * np.array([x, y]) / math.hypot(x, y)
            force = wrenches(system, state)[1, :2]
            push = -force @ [x, y] / math.hypot(x, y)
            assert 0.0 <= push <= last
            last = push
            state.v[:2] += speed * np.array([-y, x]) / math.hypot(x, y)
            elastic = -wrenches(system, replace_rates(state))[1, :2] @ state.v[:2]
            assert power(system, state) <= -elastic + 1e-12 or push == 0.0


def replace_rates(state):
    """The same place at rest."""
    still = state.copy()
    still.v[:] = 0.0
    return still


MASS, RADIAL = 2.0, 1e8
FILE = """\
gravity: [0, -9.81, 0]
bodies:
  rotor: {{motion: planar, mass: 2 kg, inertia: 0.01 kg m^2}}
bearings:
  b: {{body: rotor, stiffness: {{{springs}}}, damping: {{radial: 2e3 N s/m}}{faults}}}
scenarios:
  s: {{duration: 5 ms, step: 5 us, settle_time: 0 s}}
"""


def model_of(fault=None, springs="radial: 1e8 N/m", rest=""):
    faults = "" if fault is None else f", faults: {{f: {fault}}}"
    return loads_model(FILE.format(faults=faults, springs=springs) + rest)


def test_a_rotor_rests_in_its_seat_and_swings_there():
    """Rest at the play and the sag W/k; modes sqrt(k/m) along the load, a pendulum sqrt(g/rho) across it."""
    load = "loads:\n  w: {body: rotor, force: [0, -1000 N, 0]}\n"
    system = compile_model(model_of("{type: loose, clearance: 40 um, severity: 0.5}", rest=load))
    weight = MASS * 9.81
    rest = solve_equilibrium(system)
    assert float(rest["bearing_force[b.fy]"]) == pytest.approx(1000.0 + weight, rel=1e-9)
    sag = 10e-6 + (1000.0 + weight) / RADIAL
    modes = solve_modal(system)["undamped_frequency"].values
    found = np.sort(modes[modes > 1e-3])
    wanted = np.sqrt(np.array([(1000.0 + weight) / sag, RADIAL]) / MASS) / (2.0 * math.pi)
    np.testing.assert_allclose(found, wanted, rtol=1e-3)  # with damping: 0.07 of critical


def test_no_severity_is_the_linear_bearing_to_the_bit():
    healthy = solve_time(compile_model(model_of(), "s"))
    none = solve_time(compile_model(model_of("{type: loose, clearance: 40 um, severity: 0}"), "s"))
    loose_one = solve_time(compile_model(model_of("{type: loose, clearance: 40 um}"), "s"))
    assert set(none) == set(healthy) == set(loose_one)
    for name in healthy:
        np.testing.assert_array_equal(none[name].values, healthy[name].values)


def test_a_loose_bearing_in_a_housing():
    """Shaft pushed against the side of the seat of a housing that moves: N = k (rho - play)."""
    text = """\
bodies:
  house:
    {motion: planar, position: [0, 0, 0], mass: 5 kg, inertia: 0.1, markers: {seat: {position: [0, 0, 0.2]}}}
  rotor: {motion: planar, position: [0, 0, 0], mass: 2 kg, inertia: 0.01}
bearings:
  b: {body: rotor, position: [0, 0, 0.2], housing: house.seat, stiffness: {radial: 1e8},
      faults: {f: {type: loose, clearance: 40 um}}}
"""
    system = compile_model(loads_model(text))
    state = system.initial_state()
    state.q[system.layout.coordinate("rotor.x")] = 80e-6
    state.q[system.layout.coordinate("house.x")] = 30e-6
    values = evaluate.observe(system, state)
    assert values[system.layout.channel("bearing_force[b.fx]")] == pytest.approx(-1e8 * 30e-6)


def test_files_are_written_and_values_replaced():
    model = model_of("{type: loose, clearance: 40 um}")
    assert loads_model(dump_model(model)) == model
    half = compile_model(model.replace("bearings.b.faults.f.severity", 0.5))
    assert half.records["loose_bearing"]["gap"] == pytest.approx(10e-6)


FAULT = "{type: loose, clearance: 1 um}"
WRONG = {
    "a number": ("3", "radial: 1", "faults.f", "is not a mapping"),
    "another type": ("{type: slack}", "radial: 1", "faults.f.type", "allowed are loose"),
    "no clearance": ("{type: loose}", "radial: 1", "faults.f.clearance", "is missing"),
    "torsion": (FAULT, "radial: 1, torsion: 1", "faults.f", "constrains the spin of rotor"),
    "not round": (FAULT, "x: 1, y: 3", "stiffness", "is not radially isotropic"),
}


@pytest.mark.parametrize("case", WRONG)
def test_wrong_faults_are_told_with_their_lines(case):
    fault, springs, where, words = WRONG[case]
    with pytest.raises(ModelError) as caught:
        model_of(fault, springs)
    (problem,) = caught.value.problems
    assert problem.where == f"bearings.b.{where}"
    assert words in str(problem)
    assert problem.line == 5


def test_a_loose_rolling_bearing_has_more_clearance():
    text = (
        "bodies: {rotor: {motion: planar, position: [0, 0, 0], mass: 2 kg, inertia: 0.01}}\n"
        "rolling_bearings:\n  b: {ends: [rotor, ground], elements: 9, element_diameter: 8 mm, "
        "pitch_diameter: 40 mm, stiffness: 1e9, clearance: 10 um, "
        "faults: {f: {type: loose, clearance: 30 um, severity: 0.5}}}\n"
    )
    assert compile_model(loads_model(text)).records["rolling_bearing"]["gap"] == pytest.approx(12.5e-6)
