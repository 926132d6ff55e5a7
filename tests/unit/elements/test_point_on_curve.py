# SPDX-License-Identifier: Apache-2.0
"""Points that stay on curves: rows and second derivatives against differences, a cam in closed form."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.contact.curve import circle, polygon
from pitchpoint.core.errors import SolverError
from pitchpoint.elements import drive
from pitchpoint.elements.force import RECORD as FORCE
from pitchpoint.elements.point_on_curve import RECORD, set_point_on_curve
from pitchpoint.elements.signal import Pool
from pitchpoint.multibody.bodies import FREE, TORSION, Body
from pitchpoint.multibody.joints import FLOATING, PRISMATIC
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.closures import row_over_time
from tests.support.contacts import solid
from tests.support.engine import differences, frame
from tests.unit.elements.test_planar_contact import BLOCK, CAM, FLANK


def follower(curve, radius, i=1, j=2):
    """One record and its pool."""
    pool, records = Pool(), np.zeros(1, RECORD)
    records["i"], records["j"] = i, j
    set_point_on_curve(records[0], pool, curve, radius)
    return records, {"point_on_curve": pool.array()}


PLACES = {
    "cam": (CAM, 0.01, (0.07, 0.01, 0.2)),
    "inside": (circle(0.05, hole=True), 0.01, (0.03, 0.02, 0.0)),
    "line": (BLOCK, 0.0, (0.02, 0.03, 0.0)),
    "corner": (BLOCK, 0.006, (0.055, 0.034, 0.1)),
    "involute": (FLANK, 0.002, (0.055, 0.0, 0.0)),
}


def build(name, tree):
    """Two bodies with the constraint, and a state in which all moves and the row carries a load."""
    curve, radius, apart = PLACES[name]
    rng = np.random.default_rng(5)
    E, base = frame(rng), rng.normal(size=3)
    at = base + E @ np.asarray(apart)
    records, pools = follower(curve, radius, *((2, 3) if tree else (1, 2)))
    bodies = [solid("a", at, E), solid("b", base, E)]
    if tree:
        arm = Body(motion=TORSION, axes=frame(rng), mass=1.0, polar_inertia=0.5, name="arm")
        bodies = [arm, solid("a", at, E, 1, FLOATING), solid("b", base, E, 1, FREE)]
    system = assemble(bodies, {}, {"point_on_curve": records}, pools=pools)
    state = system.initial_state()
    n = system.sizes["nd"]
    state.q, state.v, state.a = 1e-3 * rng.normal(size=n), 0.1 * rng.normal(size=n), 0.2 * rng.normal(size=n)
    return system, state


@pytest.mark.parametrize("tree", [False, True])
@pytest.mark.parametrize("name", PLACES)
def test_the_load_of_the_row_is_part_of_the_stiffness(name, tree):
    """K with a multiplier against differences of the residual; 1e-7 for differences over 1e-7."""
    system, state = build(name, tree)
    state.lam[:] = -500.0
    found = evaluate.linearize(system, state)[2]
    wanted = differences(system, state, "q", 1e-7)
    np.testing.assert_allclose(found, wanted, atol=1e-7 * np.abs(wanted).max())


@pytest.mark.nojit
@pytest.mark.parametrize("tree", [False, True])
@pytest.mark.parametrize("name", PLACES)
def test_rates_are_derivatives_of_the_row(name, tree):
    """G v and gtt against differences of g along q + v t + a t^2/2, bodies turning in all directions."""
    system, state = build(name, tree)
    evaluate.residual(system, state)
    first, second = float((system.workspace.G @ state.v)[0]), float(system.workspace.gtt[0])
    rate, bend = row_over_time(system, state, 2e-3)
    # differences of sixth order: (0.1 m/s 2 ms/5 mm)^6 = 4e-9 on the smallest radius, and rounding over h^2
    assert first == pytest.approx(rate, abs=1e-8)
    assert second == pytest.approx(bend, abs=1e-7 + 1e-6 * abs(bend))


def test_roller_on_an_eccentric_cam_in_closed_form():
    """Lift y = e cos a + sqrt(l^2 - e^2 sin^2 a) at constant speed; the cam carries m (y'' + g)/cos b."""
    e, radius, roller, mass, omega, weight = 0.01, 0.03, 0.008, 0.7, 30.0, 9.81
    reach = radius + roller
    upward = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])  # third axis along y
    records, pools = follower(circle(radius, (0.0, e)), roller)
    bodies = [
        Body(motion=PRISMATIC, position=(0, 0.05, 0.02), axes=upward, mass=mass, name="follower"),
        Body(motion=TORSION, polar_inertia=0.01, name="cam"),
    ]
    drives, weights = np.zeros(1, drive.RECORD), np.zeros(1, FORCE)
    drives["i"], drives["speed"] = 2, omega
    weights["i"], weights["value"], weights["F"] = 1, 1.0, (0, -mass * weight, 0, 0, 0, 0)
    constraints = {"point_on_curve": records, "drive": drives}
    system = assemble(bodies, {"force": weights}, constraints, pools=pools)
    channel = [c.name for c in system.layout.channels].index("contact_force[point_on_curve0]")
    for a in np.linspace(-3.0, 3.0, 13):
        root = math.sqrt(reach**2 - (e * math.sin(a)) ** 2)
        lift = e * math.cos(a) + root
        slope = -e * math.sin(a) - e**2 * math.sin(2 * a) / (2 * root)
        bend = -e * math.cos(a) - e**2 * math.cos(2 * a) / root - e**4 * math.sin(2 * a) ** 2 / (4 * root**3)
        state = system.initial_state()
        state.t = a / omega
        state.q[:] = lift - 0.05, a
        state.v[:] = slope * omega, omega
        evaluate.prepare(system)
        evaluate.load(system, state)
        evaluate.check(system, evaluate.accelerations(system, state.t))
        after = evaluate.store(system, state.t)
        assert np.abs(system.workspace.G @ state.v - [omega, 0.0]).max() < 1e-12
        assert after.a[0] == pytest.approx(bend * omega**2, rel=1e-10, abs=1e-12)
        cos_b = math.sqrt(1.0 - (e * math.sin(a) / reach) ** 2)
        force = mass * (bend * omega**2 + weight) / cos_b
        assert evaluate.observe(system, after)[channel] == pytest.approx(force, rel=1e-9)


def test_a_point_beyond_the_ends_of_a_curve_is_reported():
    records, pools = follower(polygon([(0, 0), (1, 0)], closed=False), 0.0)
    bodies = [solid("a", (2.0, 0.5, 0.0), np.eye(3)), solid("b", (0, 0, 0), np.eye(3))]
    system = assemble(bodies, {}, {"point_on_curve": records}, pools=pools)
    with pytest.raises(SolverError, match="point on curve '?1'?"):
        evaluate.residual(system, system.initial_state())
