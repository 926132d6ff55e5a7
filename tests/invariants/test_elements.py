# SPDX-License-Identifier: Apache-2.0
"""Physics that every registered element kind obeys. A kind that nobody prepared a sample for fails."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.elements import (
    bushing,
    clearance_bearing,
    drive,
    friction_clutch,
    gravity,
    loose_bearing,
    maxwell,
    registry,
    rolling_bearing,
    spring_damper,
    torsion_maxwell,
)
from pitchpoint.elements.beam import beam_row
from pitchpoint.elements.force import RECORD as FORCE
from pitchpoint.elements.kind import FRAME
from pitchpoint.elements.ratio import SPIN
from pitchpoint.elements.shaft_beam import shaft_row
from pitchpoint.multibody.beam_section import Beam, rectangle, tube
from pitchpoint.multibody.bodies import FREE, Body
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.blade_stations import stations_between
from tests.support.engine import (
    bearings,
    couplings,
    damping_records,
    differences,
    gear_rows,
    positive,
    torques,
)

#: Kinds with a contract suite of their own.
ELSEWHERE = {
    "bevel_mesh": "tests/invariants/test_bevel_mesh.py",
    "closure": "tests/unit/elements/test_closure.py",
    "flexible_body": "tests/unit/elements/test_flexible_body.py",
    "housing_matrix": "tests/unit/system/test_housing_matrix.py",
    "joint_friction": "tests/unit/elements/test_joint_friction.py",
    "guide": "tests/unit/elements/test_guide.py",
    "linear_hold": "tests/unit/elements/test_linear_part.py",
    "linear_modes": "tests/unit/elements/test_linear_part.py",
    "linear_part": "tests/unit/elements/test_linear_part.py",
    "gear_mesh": "tests/invariants/test_gear_mesh.py",
    "rim_support": "tests/invariants/test_flexible_rims.py",
    "ball_on_surface": "tests/unit/elements/test_permanent_contact.py",
    "curve_on_curve": "tests/unit/elements/test_permanent_contact.py",
    "curve_curve": "tests/unit/elements/test_planar_contact.py",
    "point_curve": "tests/unit/elements/test_planar_contact.py",
    "point_on_curve": "tests/unit/elements/test_point_on_curve.py",
    "point_surface": "tests/unit/elements/test_surface_contact.py",
    "signal_flow": "tests/unit/elements/test_signals.py",
    "signal_of_loads": "tests/unit/elements/test_signals.py",
    "surface_surface": "tests/unit/elements/test_surface_contact.py",
}


def _bearing(rng):
    K, D = positive(rng), 0.1 * positive(rng)
    K[5, :] = K[:, 5] = D[5, :] = D[:, 5] = 0.0
    records = bearings([(1, 0, K, D), (1, 2, K, D)])
    records["zi"], records["zj"] = 0.1, -0.05
    records["d0"][:, 2] = 0.15, 0.12  # assembled without force
    return records


def _bushing(rng):
    records = np.zeros(2, bushing.RECORD)
    records["i"], records["j"] = 1, (0, 2)
    records["p_i"], records["p_j"] = 0.1 * rng.normal(size=(2, 2, 3))
    for record in records:
        bushing.defaults(record)
        record["K"], record["D"] = positive(rng), 0.1 * positive(rng)
    return records


def _ring(kind, rng, **numbers):
    """Bearing between both bodies, in contact."""
    records = np.zeros(1, kind.RECORD)
    records["i"], records["j"], records["A_i"], records["A_j"] = 1, 2, np.eye(3), np.eye(3)
    records["p_i"], records["p_j"] = (0.02, 0.0, 0.04), (0.0, 0.01, 0.0)
    if kind is not loose_bearing:
        records["stiffness"], records["exponent"], records["chi"] = 1e3, 1.5, 0.1
    for name, value in numbers.items():
        records[name] = value
    return records


def _rolling_bearing(rng):
    """A healthy bearing, one with spalls in an uneven cage, and a double-row one with a flange."""
    numbers = {"n": 9, "pitch": 0.1, "element": 0.02, "angle": 0.4, "gap": -0.05}
    spalls = [(0, -1, 0.1, 0.5, 0.3, 0.01), (1, -1, 0.2, 0.5, 0.4, 0.01), (2, 3, -0.3, 0.9, 0.9, 0.01)]
    records = np.concatenate([_ring(rolling_bearing, rng, **numbers) for _ in range(3)])
    records["rows"][2], records["offset"][2], records["grooves"][2] = 2, 0.03, 0.01
    records["one_sided"][2] = 1
    records["flange"][2], records["flange_low"][2], records["flange_high"][2] = 50.0, -0.5, -0.4
    records["n_faults"][1], records["uneven"][1], records["spacing"][1] = len(spalls), 1, np.size(spalls)
    return records, np.append(spalls, 0.05 * rng.normal(size=9))


def _loose_bearing(rng):
    Kt, Dt = positive(rng, 3), 0.1 * positive(rng, 3)
    return _ring(loose_bearing, rng, gap=0.01, seat=0.004, k=1e3, d=10.0, Kt=Kt, Dt=Dt)


def _friction_clutch(rng):
    records = np.zeros(2, friction_clutch.RECORD)
    records["i"], records["j"], records["k"] = 1, 2, (0, 3)
    records["sticking"] = friction_clutch.REGULARISED, friction_clutch.BRISTLE
    records["value"], records["ratio"], records["v_s"], records["v_eps"] = 2.0, 1.3, 0.5, 3.0
    records["stiffness"], records["onset"], records["sigma"] = 10.0, 0.3, 0.01
    return records


def _maxwell(rng, kind=maxwell):
    records = np.zeros(1, kind.RECORD)
    records["i"], records["j"], records["k"] = 1, 2, 3
    records["stiffness"], records["damping"] = 40.0, 3.0
    if kind is maxwell:
        records["p_i"] = rng.normal(size=3)
    return records


def _spring_damper(rng):
    records = np.zeros(2, spring_damper.RECORD)
    records["i"], records["j"], records["free"] = 1, (0, 2), 0.2
    records["p_i"], records["p_j"] = rng.normal(size=(2, 2, 3))
    records["k"], records["d"] = 40.0, 2.0
    return records


def _beam(rng):
    beam = Beam(section=rectangle(0.02, 0.01), length=0.03, E=1e4, G=4e3, rho=2e3)
    return beam_row(beam, bodies=(1, 2), eta=1e-2)


def _shaft_beam(rng):
    return shaft_row(Beam(section=tube(0.02), length=0.03, E=1e4, G=4e3, rho=2e3), bodies=(1, 2), eta=1e-2)


def _force(rng):
    records = np.zeros(1, FORCE)
    records["i"], records["value"], records["z"] = 1, 1.0, 0.3
    records["F"] = rng.normal(size=6)
    return records


def _gravity(rng):
    records = np.zeros(2, gravity.RECORD)
    records["i"], records["round"] = (1, 2), 1
    records["weight"], records["com"][:, 2] = rng.normal(size=(2, 3)), 0.2
    return records


def _torque(rng):
    records = torques([(1, 3.0), (1, 2.0)])
    records["j"] = [0, 2]
    return records


def _damping(rng):
    return damping_records(positive(rng, 12), [(0, 0), (0, 6), (6, 6)])


def _drive(rng):
    records = np.zeros(1, drive.RECORD)
    records["i"], records["q_i"], records["speed"] = 1, SPIN, 3.0
    return records


SAMPLES = {
    "beam": _beam,
    "blade_station": stations_between,
    "bearing": _bearing,
    "bushing": _bushing,
    "clearance_bearing": lambda rng: _ring(clearance_bearing, rng, gap=1e-3),
    "coupling": lambda rng: couplings([(1, 2, 50.0, 0.5, 0.0), (1, 0, 20.0, 0.2, 0.1)]),
    "damping": _damping,
    "drive": _drive,
    "force": _force,
    "friction_clutch": _friction_clutch,
    "gravity": _gravity,
    "loose_bearing": _loose_bearing,
    "maxwell": _maxwell,
    "ratio": lambda rng: gear_rows([(1, 2, 20, 41)]),
    "rolling_bearing": _rolling_bearing,
    "spring_damper": _spring_damper,
    "shaft_beam": _shaft_beam,
    "torque": _torque,
    "torsion_maxwell": lambda rng: _maxwell(rng, torsion_maxwell),
}
MADE = sorted(SAMPLES)
ON_FRAMES = [n for n in MADE if registry.find(n).channel == FRAME]


def build(name, tilt=1e-3):
    rng = np.random.default_rng(7)
    bodies = [
        Body(motion=FREE, position=p, mass=1.0, polar_inertia=0.2, transverse_inertia=0.1, name=n)
        for n, p in (("a", (0.0, 0.0, 0.0)), ("b", (0.0, 0.0, 0.03)))
    ]
    records = SAMPLES[name](rng)
    records, pool = records if isinstance(records, tuple) else (records, None)
    if "k" in records.dtype.names and "kk" in records.dtype.names:  # a state, as the spin rate of a body
        bodies.append(Body(polar_inertia=1.0, name="hidden", state=True))
    system = assemble(bodies, {name: records}, pools={} if pool is None else {name: pool})
    state = system.initial_state()
    n = system.sizes["nd"]
    state.q, state.v = tilt * rng.normal(size=n), rng.normal(size=n)
    for k, coordinate in enumerate(system.layout.coordinates):
        if not coordinate.endswith("spin"):
            state.v[k] *= tilt
    state.q[[system.spin("a"), system.spin("b")]] = 0.7, -0.4
    return system, state


def test_every_registered_kind_is_tested():
    # other tests of the same process may have registered kinds of their own
    shipped = {name for name in registry.names() if registry.find(name).module.startswith("pitchpoint.")}
    assert shipped == set(SAMPLES) | set(ELSEWHERE)


@pytest.mark.nojit
@pytest.mark.parametrize("name", ON_FRAMES)
def test_action_is_reaction_about_a_common_point(name):
    system, state = build(name, tilt=0.1)
    state.v[:] = 0.0
    evaluate.residual(system, state)
    fr = system.workspace.fr
    # at rest inertia adds nothing; ground's accumulator takes the rest of the sum about its origin
    fr = fr[:3]  # states are no bodies
    total = sum(f["F"][:3] for f in fr)
    if name in ("blade_station", "force", "gravity"):  # an applied load has no partner
        return
    np.testing.assert_allclose(total, 0.0, atol=1e-12)
    moments = sum(f["F"][3:] + np.cross(f["r"], f["F"][:3]) for f in fr)
    np.testing.assert_allclose(moments, 0.0, atol=1e-12)


@pytest.mark.nojit
@pytest.mark.parametrize("name", MADE)
def test_tangents_are_derivatives_of_the_force(name):
    system, state = build(name)
    _, D, K = evaluate.linearize(system, state)
    dense = np.abs(D).max() + np.abs(K).max() + 1e-3
    np.testing.assert_allclose(D, differences(system, state, "v"), atol=1e-3 * dense)
    np.testing.assert_allclose(K, differences(system, state, "q"), atol=5e-3 * dense)


@pytest.mark.parametrize("name", MADE)
def test_observations_are_declared_and_finite(name):
    system, state = build(name)
    row = evaluate.observe(system, state)
    assert row.size == len(system.layout.channels)
    assert np.all(np.isfinite(row))
    assert len({c.name for c in system.layout.channels}) == row.size


@pytest.mark.parametrize("name", [n for n in ON_FRAMES if registry.find(n).massless])
def test_kinds_without_inertia_observe_nothing_of_accelerations(name):
    """Explicit methods let them say what they observe before the accelerations are known."""
    system, state = build(name, tilt=0.1)
    row = evaluate.observe(system, state)
    state.a[:] = np.random.default_rng(3).normal(size=state.a.size)
    np.testing.assert_array_equal(evaluate.observe(system, state), row)


@pytest.mark.parametrize("name", MADE)
def test_whole_turns_change_nothing(name):
    system, state = build(name)
    if name in ("drive", "coupling"):  # they hold the spin against time or ground
        return
    before = evaluate.residual(system, state)
    state.turns[1] += 41 if name == "ratio" else 5
    state.turns[2] += -20 if name == "ratio" else 5
    np.testing.assert_array_equal(evaluate.residual(system, state), before)
    assert np.all(np.abs(system.workspace.g) < 10.0)
