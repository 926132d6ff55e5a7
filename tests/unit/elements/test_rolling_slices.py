# SPDX-License-Identifier: Apache-2.0
"""Rollers in slices, double rows, self-aligning and floating bearings, preload: closed forms, quadrature."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from pitchpoint.contact.rolling import LINE, Raceways, in_series, roller_stiffness
from pitchpoint.elements import rolling_bearing
from pitchpoint.multibody.bodies import FREE, Body
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import frame
from tests.support.forces import (
    ENDS,
    check_balance,
    check_matrices,
    markers,
    mechanism,
    moved_world,
    moving,
    power,
    wrenches,
)
from tests.support.markers import set_markers

K, P, PITCH, LENGTH = 200.0, LINE, 0.3, 0.2
STEEL = 2.0 * 0.91 / 206e9


def bearing(bodies, i, j, position=(0.0, 0.0, 0.0), axes=None, slices=None, **numbers):
    """A large soft bearing with its pool."""
    record = np.zeros(1, rolling_bearing.RECORD)
    record["i"], record["j"], record["n"], record["exponent"] = i, j, 9, P
    record["pitch"], record["element"], record["stiffness"] = PITCH, 0.06, K
    pool = np.zeros(0)
    if slices is not None:
        record["n_slices"], pool = len(slices), np.ascontiguousarray(slices).ravel()
    for name, value in numbers.items():
        record[name] = value
    set_markers(record[0], bodies, position, axes)
    return record, pool


def system_of(bodies, made):
    record, pool = made
    return assemble(bodies, {"rolling_bearing": record}, pools={"rolling_bearing": pool})


SLICES = np.column_stack([LENGTH * ((np.arange(7) + 0.5) / 7 - 0.5), 1e-3 * (np.arange(7) - 3.0) ** 2])
KINDS = {
    "tapered": {"slices": SLICES, "gap": -0.1, "angle": 0.4},
    "cylindrical": {"slices": SLICES, "gap": -0.05, "azimuth": 0.2},
    "spherical": {"slices": SLICES, "gap": -0.1, "angle": 0.3, "rows": 2, "aligns": 1},
    "floating": {"slices": SLICES, "gap": -0.1, "angle": 0.3, "rows": 2, "aligns": 1, "floats": 1},
    "two rows of balls": {"gap": -0.1, "angle": 0.3, "grooves": 0.4, "rows": 2, "exponent": 1.5},
    "preloaded balls": {"gap": 0.01, "angle": 0.3, "grooves": 0.4, "shift": 0.08, "exponent": 1.5},
}


def loads(b, pool, r, A, rate):
    """Power, and axial force of every slice, by plain vectors: d of each slice from the moved rings."""
    (x, y, z), n = A[1].T @ (r[0] - r[1]), A[1].T @ A[0][:, 2]
    B = A[1].T @ A[0]
    v = np.cross([0.0, 0.0, 1.0], n)
    swing = np.eye(3) * n[2] + np.array([[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]])
    swing += np.outer(v, v) / (1.0 + n[2])
    twist = swing.T @ B
    turn = math.atan2(twist[1, 0], twist[0, 0])
    share = 0.5 * (1.0 - b["element"] / b["pitch"] * np.cos(b["angle"]))
    rows = pool.reshape(-1, 2) if b["n_slices"] else np.zeros((1, 2))
    found = []
    for row in range(2 if b["rows"] == 2 else 1):
        psi = b["azimuth"] + share * turn + 2.0 * np.pi * (np.arange(b["n"]) + 0.5 * row) / b["n"]
        angle = b["angle"] * (1 - 2 * row)
        lever = 0.0 if b["aligns"] or b["floats"] else 0.5 * b["pitch"]
        tilt = n[0] * np.cos(psi) + n[1] * np.sin(psi)
        radial = x * np.cos(psi) + y * np.sin(psi) - b["gap"]
        axial = z + b["shift"] - lever * tilt
        s = 0.0 if b["floats"] else np.sin(angle)
        if b["grooves"] > 0.0:
            q = np.hypot(b["grooves"] * np.cos(angle) + radial, b["grooves"] * s + axial) - b["grooves"]
        else:
            q = radial * np.cos(angle) + axial * s
        if b["aligns"]:  # the rollers follow the inner ring in the sphere of the outer one
            tilt = 0.0 * tilt
        found.append(q[:, None] + tilt[:, None] * rows[:, 0] - rows[:, 1])
    return np.concatenate(found)


@pytest.mark.nojit
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(("i", "j"), [ENDS[0], ENDS[3]])
def test_energy_balance_and_tangents(i, j, kind):
    """Exact tangents, balance of forces and moments, power of the loads by independent kinematics."""
    rng = np.random.default_rng(10 * i + j)
    bodies = mechanism(rng)
    made = bearing(bodies, i, j, 0.2 * rng.normal(size=3), frame(rng), chi=0.3, **KINDS[kind])
    system = system_of(bodies, made)
    state = moving(system, rng, 0.1)
    state.v *= 0.3
    check_matrices(system, state, most=3e-7)
    check_balance(system, state)
    b, h = made[0][0], 1e-4
    near, here, far = (
        loads(b, made[1], *markers(system, made[0], later), 0.0)
        for later in (moved(state, -h), state, moved(state, h))
    )
    rate = (far - near) / (2.0 * h)
    force = K / max(1, b["n_slices"]) * np.maximum(here, 0.0) ** b["exponent"]
    force *= np.maximum(1.0 + 0.3 * rate, 0.0)
    assert np.count_nonzero(here > 0.0) >= 4
    assert power(system, state) == pytest.approx(-np.sum(force * rate), rel=3e-6)


def moved(state, step):
    """State a moment later along its rates."""
    later = state.copy()
    later.q = state.q + step * state.v
    return later


def test_a_bearing_in_slices_moves_with_the_world():
    rng = np.random.default_rng(6)
    bodies, place, axes = mechanism(rng), np.array([0.1, 0.2, 0.3]), frame(rng)
    one = system_of(bodies, bearing(bodies, 3, 0, place, axes, chi=0.3, **KINDS["tapered"]))
    state = moving(one, rng, 0.1)
    turned, turn, shift = moved_world(bodies, rng)
    two = system_of(
        turned, bearing(turned, 3, 0, turn @ place + shift, turn @ axes, chi=0.3, **KINDS["tapered"])
    )
    before = evaluate.residual(one, state)
    np.testing.assert_allclose(evaluate.residual(two, state), before, atol=1e-11 * np.abs(before).max())


def on_axis(**numbers):
    """Round body on the axis of its bearing: system and initial state."""
    bodies = [Body(motion=FREE, mass=1.0, polar_inertia=0.1, transverse_inertia=0.1)]
    system = system_of(bodies, bearing(bodies, 1, 0, **numbers))
    return system, system.initial_state()


def straight(count):
    """Slices of a roller without profile."""
    return np.column_stack([LENGTH * ((np.arange(count) + 0.5) / count - 0.5), np.zeros(count)])


def test_load_distribution_with_clearance():
    """Sjoevall: F_r = Z Q_max J_r(epsilon) by quadrature over the loaded zone of a bearing with clearance."""
    gap, shift, n = 1e-3, 3e-3, 400
    system, state = on_axis(n=n, gap=gap, slices=straight(3), element=1e-3)
    state.q[0] = shift
    end = math.acos(gap / shift)
    wanted = n / (2.0 * np.pi) * K * quad(lambda a: (shift * np.cos(a) - gap) ** P * np.cos(a), -end, end)[0]
    assert -wrenches(system, state)[1, 0] == pytest.approx(wanted, rel=1e-4)


def test_tilting_moment_of_straight_rollers():
    """Small tilt of preloaded cylindrical rollers: M = (Z/2) K P d^(P-1) L^2/12 times the tilt."""
    depth, n, count = 0.02, 90, 40
    system, state = on_axis(n=n, gap=-depth, slices=straight(count), element=1e-3)
    state.q[3] = 1e-6
    slope = 0.5 * n * K * P * depth ** (P - 1.0) * LENGTH**2 / 12.0 * (1.0 - 1.0 / count**2)
    # the radial force of the preload has no moment: it acts through the centre whatever the tilt
    assert wrenches(system, state)[1, 3] == pytest.approx(-slope * 1e-6, rel=1e-6)


def test_tilting_moment_of_tapered_rollers():
    """The lever of a slice about the centre is xi - (d_m/2) sin(alpha) along the roller."""
    depth, n, count, angle = 0.02, 90, 40, 0.4
    system, state = on_axis(n=n, gap=-depth, slices=straight(count), element=1e-3, angle=angle)
    before = wrenches(system, state)[1]
    state.q[3] = 1e-6
    arm = LENGTH**2 / 12.0 * (1.0 - 1.0 / count**2) + (0.5 * PITCH * math.sin(angle)) ** 2
    slope = 0.5 * n * K * P * (depth * math.cos(angle)) ** (P - 1.0) * arm
    assert (wrenches(system, state)[1] - before)[3] == pytest.approx(-slope * 1e-6, rel=1e-4)


def test_a_spherical_bearing_tilts_freely_and_holds_axially():
    """No moment at any tilt; axial stiffness 2 Z K P d^(P-1) sin^2(alpha) of both preloaded rows."""
    depth, n, angle = 0.02, 60, 0.2
    for slices in (SLICES, None):
        system, state = on_axis(n=n, gap=-depth, element=1e-3, angle=angle, rows=2, aligns=1, slices=slices)
        state.q[3:5] = 0.05, -0.02
        np.testing.assert_allclose(wrenches(system, state)[1], 0.0, atol=1e-10)
    state.q[:] = 0.0
    state.q[2] = 1e-6
    slope = 2 * n * K * P * (depth * math.cos(angle)) ** (P - 1.0) * math.sin(angle) ** 2
    assert wrenches(system, state)[1, 2] == pytest.approx(-slope * 1e-6, rel=1e-4)


def test_a_floating_bearing_carries_no_axial_force():
    system, state = on_axis(gap=-0.05, angle=0.3, grooves=0.4, exponent=1.5, floats=1)
    state.q[:] = 0.01, 0.02, 0.1, 0.02, -0.01, 0.3
    found = wrenches(system, state)[1]
    assert found[2] == 0.0
    assert np.hypot(*found[:2]) > 1.0
    np.testing.assert_allclose(found[3:5], 0.0, atol=1e-9)


def test_edge_loading_of_a_tilted_roller():
    """One misaligned roller: the load of its slices against quadrature of the lamina model along the line."""
    slices, tilt, depth = straight(2000), 0.05, 0.003
    system, state = on_axis(n=2, gap=-depth, slices=slices, element=1e-3)
    state.q[3:5] = 0.0, math.asin(tilt)  # rotation about y: n = (sin, 0, cos), rollers at psi = 0 and pi
    state.q[5] = 0.0
    edge = quad(
        lambda xi: max(depth + xi * tilt, 0.0) ** P * xi, -0.5 * LENGTH, 0.5 * LENGTH, points=[-0.06]
    )[0]
    assert wrenches(system, state)[1, 4] == pytest.approx(
        -2.0 * K / LENGTH * edge * math.cos(math.asin(tilt)), rel=1e-5
    )


def test_contact_constant_of_iso_16281():
    """c_L = 35 948 L_we^(8/9) N/mm^(10/9) between both raceways; the constants of Palmgren give 4 % more."""
    one = roller_stiffness(10e-3, STEEL)
    found = in_series(one, one, LINE) * 1e-3**LINE
    assert found == pytest.approx(35948 * 10.0 ** (8.0 / 9.0), rel=0.05)


def test_axial_displacement_for_a_preload():
    """Angular contact with clearance, and tapered rollers with profile: forces of the displaced kernel."""
    slices = np.column_stack([SLICES[:, 0], 0.01 * SLICES[:, 1]])
    for keys in (
        {"angle": 0.5, "grooves": 0.4, "gap": 0.01, "exponent": 1.5},
        {"angle": 0.3, "slices": slices, "exponent": LINE},
    ):
        row = Raceways(
            9,
            K,
            keys["exponent"],
            keys["angle"],
            keys.get("gap", 0.0),
            keys.get("grooves", 0.0),
            keys.get("slices"),
        )
        shift = row.shift_for(25.0)
        system, state = on_axis(shift=shift, **keys)
        assert wrenches(system, state)[1, 2] == pytest.approx(-25.0, rel=1e-9)
    simple = Raceways(9, K, 1.5, 0.5)
    assert simple.shift_for(25.0) == pytest.approx(
        brentq(lambda x: 9 * K * math.sin(0.5) * (x * math.sin(0.5)) ** 1.5 - 25.0, 0.0, 1.0), rel=1e-9
    )
