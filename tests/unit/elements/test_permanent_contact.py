# SPDX-License-Identifier: Apache-2.0
"""Curves and spheres that never part: rows, rates and loads against differences, cams in closed form."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.curve import Curve, chain, circle, polygon
from pitchpoint.core.errors import SolverError
from pitchpoint.elements import drive
from pitchpoint.elements.ball_on_surface import set_surface
from pitchpoint.elements.contacts.record import new_records, set_marker
from pitchpoint.elements.curve_on_curve import set_held_curves
from pitchpoint.elements.force import RECORD as FORCE
from pitchpoint.elements.point_on_curve import RECORD as POINT
from pitchpoint.elements.point_on_curve import set_point_on_curve
from pitchpoint.elements.signal import Pool
from pitchpoint.multibody.bodies import FREE, TORSION, Body
from pitchpoint.multibody.joints import FLOATING, PRISMATIC
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.closures import row_over_time
from tests.support.contacts import solid
from tests.support.engine import differences, frame
from tests.unit.elements.test_planar_contact import BLOCK, CAM, FLANK, OPPOSITE, ROOF

FACE = chain([polygon([(-0.05, 0.0), (0.05, 0.0)], closed=False).rows[0]], False)
"""A flat face with its material above."""

#: kind, shapes, place of the first body in the axes of the second one
PLACES = {
    "cam on cam": ("curve_on_curve", (CAM, CAM), (0.12, 0.002, 0.001)),
    "circles": ("curve_on_curve", (circle(0.05), circle(0.03)), (0.08, 0.001, 0.0)),
    "pin in hole": ("curve_on_curve", (circle(0.03), circle(0.032, hole=True)), (0.001, 0.0018, 0.0)),
    "flat on cam": ("curve_on_curve", (BLOCK, CAM), (0.06, 0.002, 0.0)),
    "cam on flat": ("curve_on_curve", (CAM, BLOCK), (0.11, 0.002, 0.0)),
    "corner on circle": ("curve_on_curve", (ROOF, circle(0.05)), (0.001, 0.05, 0.0)),
    "involutes": ("curve_on_curve", (OPPOSITE, FLANK), (0.105, 0.012, 0.0)),
    "on a plane": ("ball_on_surface", ("plane", (), 0.02), (0.1, 0.2, 0.02)),
    "on a sphere": ("ball_on_surface", ("sphere", 0.03, 0.02), (0.03, 0.03, 0.026)),
    "in a cup": ("ball_on_surface", ("sphere", 0.06, 0.02, True), (0.02, 0.02, 0.028)),
    "in a bore": ("ball_on_surface", ("cylinder", 0.06, 0.02, True), (0.02, 0.035, 0.1)),
    "on a cone": ("ball_on_surface", ("cone", 0.5, 0.02), (0.03, 0.04, -0.05)),
    "on a torus": ("ball_on_surface", ("torus", (0.1, 0.03), 0.02), (0.0, 0.13, 0.04)),
}


def held(kind, shapes, i=1, j=2):
    """One record and its pool."""
    pool, records = Pool(), new_records(1)
    records["i"], records["j"] = i, j
    if kind == "curve_on_curve":
        set_held_curves(records[0], pool, shapes)
    else:
        set_surface(records[0], *shapes)
    return records, {kind: pool.array()}


def build(name, where, tilt=0.0):
    """Two bodies with the constraint, and a state in which all moves and the row carries a load."""
    kind, shapes, apart = PLACES[name]
    rng = np.random.default_rng(5)
    E, base = frame(rng), rng.normal(size=3)
    at = base + E @ np.asarray(apart)
    records, pools = held(kind, shapes, *((2, 3) if where == "tree" else (1, 2)))
    bodies = [solid("a", at, E), solid("b", base, E)]
    if where == "tree":
        arm = Body(motion=TORSION, axes=frame(rng), mass=1.0, polar_inertia=0.5, name="arm")
        bodies = [arm, solid("a", at, E, 1, FLOATING), solid("b", base, E, 1, FREE)]
    elif where == "ground":
        records["j"] = 0
        set_marker(records[0], "j", base, E)
        bodies = bodies[:1]
    system = assemble(bodies, {}, {kind: records}, pools=pools)
    state = system.initial_state()
    n = system.sizes["nd"]
    state.q, state.v, state.a = 1e-3 * rng.normal(size=n), 0.1 * rng.normal(size=n), 0.2 * rng.normal(size=n)
    if tilt:
        state.q[4 if where != "tree" else 5] += tilt
    return system, state


@pytest.mark.parametrize("where", ["free", "ground", "tree"])
@pytest.mark.parametrize("name", PLACES)
def test_the_place_runs_with_the_load(name, where):
    """K with a multiplier against differences over 1e-7: normal and place turn and run.

    Differences are good to 2e-7 of the largest, and to the rounding of 500 N over the step.
    """
    system, state = build(name, where, 0.02 if PLACES[name][0] == "curve_on_curve" else 0.0)
    state.lam[:] = -500.0
    found = evaluate.linearize(system, state)[2]
    wanted = differences(system, state, "q", 1e-7)
    np.testing.assert_allclose(found, wanted, atol=2e-7 * np.abs(wanted).max() + 2e-6)


@pytest.mark.nojit
@pytest.mark.parametrize("where", ["free", "ground", "tree"])
@pytest.mark.parametrize("name", PLACES)
def test_rates_are_derivatives_of_the_row(name, where):
    """G v and gtt against differences of sixth order of g along q + v t + a t^2/2."""
    system, state = build(name, where, 0.02 if PLACES[name][0] == "curve_on_curve" else 0.0)
    evaluate.residual(system, state)
    first, second = float((system.workspace.G @ state.v)[0]), float(system.workspace.gtt[0])
    rate, bend = row_over_time(system, state, 3e-4)
    # rounding of places of 1 m over 3e-4 and 1e-7
    assert first == pytest.approx(rate, abs=1e-8)
    assert second == pytest.approx(bend, abs=1e-6 + 1e-6 * abs(bend))


def test_the_stiffness_of_a_load_is_that_of_the_rolling_place():
    """Two circles under a load F: a step sideways turns the normal by its share of R1 + R2.

    With the place frozen on either curve the stiffness would be F/R1, F/R2 or nothing.
    """
    F, radii = 700.0, (0.05, 0.03)
    records, pools = held("curve_on_curve", tuple(circle(r) for r in radii), 1, 0)
    system = assemble(
        [solid("a", (0.0, sum(radii), 0.0), np.eye(3))], {}, {"curve_on_curve": records}, pools=pools
    )
    state = system.initial_state()
    state.lam[:] = -F
    K = evaluate.linearize(system, state)[2]
    # residual G^T lambda: along x the force on the body is F x/(R1 + R2), so K = -F/(R1 + R2)
    assert K[0, 0] == pytest.approx(-F / sum(radii), rel=1e-12)
    assert K[1, 1] == pytest.approx(0.0, abs=1e-9)


def test_a_round_follower_is_a_roller():
    """Circle on a cam, turning or not, has row, rates and stiffness of the point on the curve."""
    found = []
    for kind in ("curve_on_curve", "point_on_curve"):
        if kind == "curve_on_curve":
            records, pools = held(kind, (circle(0.01), CAM))
        else:
            pool, records = Pool(), np.zeros(1, POINT)
            records["i"], records["j"] = 1, 2
            set_point_on_curve(records[0], pool, CAM, 0.01)
            pools = {kind: pool.array()}
        rng = np.random.default_rng(3)
        bodies = [solid("a", (0.07, 0.003, 0.0), np.eye(3)), solid("b", (0, 0, 0), np.eye(3))]
        system = assemble(bodies, {}, {kind: records}, pools=pools)
        state = system.initial_state()
        n = system.sizes["nd"]
        state.q, state.v, state.a = (s * rng.normal(size=n) for s in (1e-3, 0.1, 0.2))
        state.q[[2, 3, 4, 8, 9, 10]] = 0.0  # a tilted circle is no roller
        state.v[[2, 3, 4, 8, 9, 10]] = 0.0
        state.lam[:] = -300.0
        K = evaluate.linearize(system, state)[2]
        w = system.workspace
        flat = np.ix_([0, 1, 5, 6, 7, 11], [0, 1, 5, 6, 7, 11])
        found.append((w.g[0], w.gtt[0], w.G[0].copy(), K[flat]))
    for one, two in zip(*found, strict=True):
        np.testing.assert_allclose(one, two, atol=1e-11 * max(1.0, np.abs(two).max()))


E, R, MASS, OMEGA, WEIGHT = 0.01, 0.03, 0.7, 30.0, 9.81


def flat_follower(start=0.0):
    """A flat follower on a circle that is off its axis, driven at a constant speed."""
    upward = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])  # third axis along y
    records, pools = held("curve_on_curve", (FACE, circle(R, (0.0, E))))
    set_marker(records[0], "i", (0, 0, 0), upward.T)
    bodies = [
        Body(motion=PRISMATIC, position=(0, 0.05, 0.02), axes=upward, mass=MASS, name="follower"),
        Body(motion=TORSION, polar_inertia=0.01, name="cam"),
    ]
    drives, weights = np.zeros(1, drive.RECORD), np.zeros(1, FORCE)
    drives["i"], drives["speed"], drives["angle"] = 2, OMEGA, start
    weights["i"], weights["value"], weights["F"] = 1, 1.0, (0, -MASS * WEIGHT, 0, 0, 0, 0)
    constraints = {"curve_on_curve": records, "drive": drives}
    return assemble(bodies, {"force": weights}, constraints, pools=pools)


def observed(system, state):
    return dict(zip([c.name for c in system.layout.channels], evaluate.observe(system, state), strict=True))


def test_a_flat_follower_moves_like_a_sine():
    """Lift R + e cos a: force m (g - e w^2 cos a), place e sin a off the middle, torque F dy/da."""
    system = flat_follower()
    torque = next(c.name for c in system.layout.channels if "torque" in c.name)
    for a in np.linspace(-3.0, 3.0, 13):
        state = system.initial_state()
        state.t = a / OMEGA
        state.q[:] = R + E * math.cos(a) - 0.05, a
        state.v[:] = -E * math.sin(a) * OMEGA, OMEGA
        evaluate.residual(system, state)
        row = system.records["curve_on_curve"]["row"][0]
        assert system.workspace.g[row] == pytest.approx(0.0, abs=1e-16)
        evaluate.prepare(system)
        evaluate.load(system, state)
        evaluate.check(system, evaluate.accelerations(system, state.t))
        after = evaluate.store(system, state.t)
        assert after.a[0] == pytest.approx(-E * math.cos(a) * OMEGA**2, rel=1e-10, abs=1e-12)
        seen = observed(system, after)
        force = MASS * (WEIGHT - E * math.cos(a) * OMEGA**2)
        assert seen["contact_force[curve_on_curve0]"] == pytest.approx(force, rel=1e-9)
        assert seen["contact_path[curve_on_curve0.i]"] == pytest.approx(0.05 - E * math.sin(a), abs=1e-12)
        assert abs(seen[torque]) == pytest.approx(abs(force * E * math.sin(a)), rel=1e-9, abs=1e-9)


def test_a_flat_follower_in_motion():
    """A turn by generalised-alpha: the cam prescribes the sine of the follower, whatever the step."""
    system = flat_follower()
    state = system.initial_state()
    state.q[:], state.v[:], state.a[0] = (R + E - 0.05, 0.0), (0.0, OMEGA), -E * OMEGA**2
    run = generalized_alpha.start(system, state, 1e-3)
    assert run.advance(209).status == 1
    now = run.state()
    assert now.q[0] == pytest.approx(R + E * math.cos(OMEGA * now.t) - 0.05, abs=1e-9)


def test_curves_that_nowhere_face_each_other_are_reported():
    two = chain([polygon([(0.05, 0.0), (-0.05, 0.0)], closed=False).rows[0]], False)
    records, pools = held("curve_on_curve", (two, two), 1, 0)
    system = assemble([solid("a", (0.0, 0.1, 0.0), np.eye(3))], {}, {"curve_on_curve": records}, pools=pools)
    with pytest.raises(SolverError, match="curve on curve"):
        evaluate.residual(system, system.initial_state())
    assert isinstance(two, Curve)
