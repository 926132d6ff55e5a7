# SPDX-License-Identifier: Apache-2.0
"""Faults of rolling bearings: approach lost by plain vectors, energy, tangents, whole turns, edges."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from scipy.integrate import simpson
from scipy.optimize import brentq

from pitchpoint.contact.spall import spall_drop
from pitchpoint.elements import rolling_bearing
from pitchpoint.elements.bearing_fault import ELEMENT, INNER, OUTER, spall_shape
from pitchpoint.elements.rolling_bearing import roll_angle
from pitchpoint.multibody.bodies import FREE, Body
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import frame
from tests.support.forces import (
    ENDS,
    along,
    check_balance,
    check_matrices,
    markers,
    mechanism,
    moving,
    power,
    wrenches,
)
from tests.support.markers import set_markers

SPALLS = [
    (OUTER, -1, 0.3, 0.5, 0.4, 0.05),
    (INNER, -1, -1.0, 0.4, 0.4, 0.03),
    (ELEMENT, 2, 0.5, 0.9, 0.7, 0.04),
    (ELEMENT, 2, 0.5 + np.pi, 0.9, 0.5, 0.06),
    (ELEMENT, 7, -0.2, 1.2, 0.7, 0.04),
]
SPACING = 0.1 * np.sin(np.arange(9.0))


def faulty(bodies, i, j, place=(0.0, 0.0, 0.0), axes=None, spalls=SPALLS, spacing=SPACING, **numbers):
    """Record and pool of a bearing with nine elements."""
    record = np.zeros(1, rolling_bearing.RECORD)
    record["i"], record["j"], record["n"], record["exponent"] = i, j, 9, 1.5
    record["pitch"], record["element"], record["stiffness"] = 0.3, 0.06, 200.0
    record["n_faults"], record["uneven"], record["spacing"] = len(spalls), 1, 6 * len(spalls)
    for name, value in numbers.items():
        record[name] = value
    set_markers(record[0], bodies, place, axes)
    return record, np.concatenate([np.ravel(np.array(spalls, float)), spacing])


def system_of(bodies, record, pool):
    return assemble(bodies, {"rolling_bearing": record}, pools={"rolling_bearing": pool})


def lost(angle, half, ramp, drop):
    """Loss of approach at an angle from the middle of a spall, by interpolation of the same shape."""
    t = np.clip((half - abs((angle + np.pi) % (2.0 * np.pi) - np.pi)) / ramp, 0.0, 1.0)
    return drop * t**3 * (10.0 - 15.0 * t + 6.0 * t * t)


def approaches(system, record, state):
    """Approach at every element less what it lost, by plain vectors; turns within half a turn."""
    r, A = markers(system, record, state)
    (x, y, z), n = A[1].T @ (r[0] - r[1]), A[1].T @ A[0][:, 2]
    B = A[1].T @ A[0]
    swing = np.eye(3) * n[2]
    v = np.cross([0.0, 0.0, 1.0], n)
    swing += np.array([[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]])
    swing += np.outer(v, v) / (1.0 + n[2])
    twist = swing.T @ B
    turn = np.arctan2(twist[1, 0], twist[0, 0])
    b = record[0]
    gamma = b["element"] / b["pitch"] * np.cos(b["angle"])
    psi = b["azimuth"] + 0.5 * (1.0 - gamma) * turn + 2.0 * np.pi * np.arange(9) / 9 + SPACING
    c, s = np.cos(psi), np.sin(psi)
    radial = x * c + y * s - b["gap"]
    axial = z - 0.5 * b["pitch"] * (n[0] * c + n[1] * s)
    d = radial * np.cos(b["angle"]) + axial * np.sin(b["angle"])
    if b["grooves"] > 0.0:
        A = b["grooves"]
        d = np.hypot(A * np.cos(b["angle"]) + radial, A * np.sin(b["angle"]) + axial) - A
    spin = -0.5 * b["pitch"] / b["element"] * (1.0 - gamma**2) * turn
    for place, element, at, *shape in SPALLS:
        for k in range(9):
            if place == OUTER:
                d[k] -= lost(psi[k] - at, *shape)
            elif place == INNER:
                d[k] -= lost(psi[k] - turn - at, *shape)
            elif k == element:
                d[k] -= lost(spin - at, *shape)
    return d


KINDS = {
    "roller": {"gap": -0.2, "angle": 0.6, "azimuth": 0.1, "exponent": 10.0 / 9.0},
    "play": {"gap": 0.01, "angle": 0.2},
    "grooves": {"gap": -0.1, "angle": 0.3, "grooves": 0.4},
}


@pytest.mark.nojit
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(("i", "j"), ENDS)
def test_energy_balance_and_tangents_over_spalls(i, j, kind):
    """Forces are conjugate to the approach that is left: their power is that of Q d' with d by vectors."""
    rng = np.random.default_rng(10 * i + j)
    bodies = mechanism(rng)
    record, pool = faulty(bodies, i, j, 0.2 * rng.normal(size=3), frame(rng), chi=0.3, **KINDS[kind])
    system = system_of(bodies, record, pool)
    state = moving(system, rng, 0.1)
    state.v *= 0.3
    check_matrices(system, state)
    check_balance(system, state)
    h = 1e-4
    near, far = (approaches(system, record, along(system, state, s * h)) for s in (-1.0, 1.0))
    here, rate = approaches(system, record, state), (far - near) / (2.0 * h)
    force = 200.0 * np.maximum(here, 0.0) ** record["exponent"] * np.maximum(1.0 + 0.3 * rate, 0.0)
    assert np.count_nonzero(force) >= (1 if kind == "play" else 5)
    assert power(system, state) == pytest.approx(-force @ rate, rel=2e-6)


@pytest.mark.nojit
def test_a_spall_is_smooth_to_the_second_derivative():
    """The third derivative jumps by 60 drop/ramp^3 at both ends of a ramp: h/2 of it is 0.02 there."""
    h = 1e-5
    for angle in (-0.49, -0.3, -0.2, 0.0, 0.15, 0.2, 0.35, 0.4999, 0.6):
        near, here, far = (spall_shape(angle + s * h, 0.5, 0.3, 2.0) for s in (-1, 0, 1))
        assert here[1] == pytest.approx((far[0] - near[0]) / (2.0 * h), abs=1e-6)
        assert here[2] == pytest.approx((far[1] - near[1]) / (2.0 * h), abs=0.03)
    # at both ends of a ramp: 60 drop/ramp^2 times a share of 1e-6
    for end in (0.5, 0.2):
        assert abs(spall_shape(end - 1e-7, 0.5, 0.3, 2.0)[2]) < 1e-3


@pytest.mark.nojit
@pytest.mark.parametrize("turns", [0, 1, -1, 1000, 12_345_678, -98_765_432])
def test_whole_turns_of_the_elements_are_exact(turns):
    share = -0.5 * 39.04 / 7.94 * (1.0 - (7.94 / 39.04) ** 2)
    found = roll_angle(share, 0.3, turns)
    rest = float((Fraction(share) * turns) % 1)
    away = ((found - 0.3 * share) / (2.0 * np.pi) - rest) % 1.0
    assert min(away, 1.0 - away) < 4e-15


@pytest.mark.parametrize("inner", [True, False])
@pytest.mark.parametrize(("length", "depth"), [(2e-3, 1e-3), (2e-3, 10e-6), (8e-3, 30e-6)])
def test_drop_into_a_spall_with_sharp_edges(inner, length, depth):
    """Centre of the element by circles: on its race, on both edges, on the floor, over one edge.

    The length is taken as a chord, here it is an arc: drops differ by (l/r)^2/12, 1e-3 at most for spanned
    spalls. The way down the edge is exact to the first order of depth over radius, 1 % here.
    """
    R, r = 5e-3, 25e-3 if inner else 35e-3
    half = 0.5 * length / r
    edge = np.array([r * np.cos(half), r * np.sin(half)])
    side = 1.0 if inner else -1.0
    healthy, floor = r + side * R, r - side * depth + side * R
    spanned = edge[0] + side * np.sqrt(R * R - edge[1] ** 2)
    reach = min(side * healthy - side * floor, side * healthy - side * spanned)
    drop, ramp = spall_drop(length, depth, R, side * r)
    assert drop == pytest.approx(reach, rel=1e-3)
    if drop < 0.99 * depth:  # spanned: down to the middle
        assert ramp == pytest.approx(0.5 * length, rel=0.02)
        return

    def over_edge(angle):
        centre = floor * np.array([np.cos(angle), np.sin(angle)])
        return np.hypot(*(centre - edge)) - R

    there = brentq(over_edge, 0.0, half)
    assert ramp == pytest.approx((half - there) * r, rel=0.01)


def test_no_severity_is_healthy_to_round_off():
    """Elements with faults of no size go another way through the same sums: some units of rounding."""
    bodies = [Body(motion=FREE, mass=1.0, polar_inertia=0.1, transverse_inertia=0.1)]
    flat = [(*spall[:3], 0.0, 0.0, 0.0) for spall in SPALLS]
    one = system_of(bodies, *faulty(bodies, 1, 0, spalls=flat, spacing=0.0 * SPACING, chi=0.3))
    healthy = faulty(bodies, 1, 0, chi=0.3)[0]
    healthy["n_faults"], healthy["uneven"] = 0, 0
    two = assemble(bodies, {"rolling_bearing": healthy})
    rng = np.random.default_rng(3)
    for _ in range(20):
        state = one.initial_state()
        state.q, state.v = 0.1 * rng.normal(size=6), rng.normal(size=6)
        state.turns[1] = rng.integers(-1000, 1000)
        for found, wanted in zip(evaluate.linearize(one, state), evaluate.linearize(two, state), strict=True):
            np.testing.assert_allclose(found, wanted, rtol=1e-13, atol=1e-13 * np.abs(wanted).max())
        found, wanted = wrenches(one, state), wrenches(two, state)
        np.testing.assert_allclose(found, wanted, rtol=1e-13, atol=1e-13 * np.abs(wanted).max())


@pytest.mark.study
def test_an_element_that_climbs_out_of_a_spall_brakes_the_shaft():
    """Static turn through an outer spall: work of the torque is the change of the stored energy."""
    bodies = [Body(motion=FREE, mass=1.0, polar_inertia=0.1, transverse_inertia=0.1)]
    spall = (OUTER, -1, 0.3, 0.25, 0.2, 0.05)
    record, pool = faulty(bodies, 1, 0, spalls=[spall], spacing=0.0 * SPACING, gap=-0.2)
    system = system_of(bodies, record, pool)
    state = system.initial_state()
    share = 0.5 * (1.0 - 0.2)

    def torque(turn):
        state.q[5] = turn
        return wrenches(system, state)[1, 5]

    grid = np.linspace((0.3 - 0.26) / share, 0.3 / share, 4001)  # from before the edge to the middle
    work = simpson([torque(t) for t in grid], x=grid)

    def stored(turn):
        state.q[5] = turn
        psi = share * turn + 2.0 * np.pi * np.arange(9) / 9
        d = 0.2 - np.array([lost(p - 0.3, *spall[3:]) for p in psi])
        return 200.0 / 2.5 * (d**2.5).sum()

    assert work == pytest.approx(stored(grid[0]) - stored(grid[-1]), rel=1e-6)
    assert work > 0.05 * stored(0.0)
    climbing = torque((0.3 + 0.2) / share)  # element 0 leaves: the ring is held back
    assert climbing < 0.0
