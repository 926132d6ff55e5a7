# SPDX-License-Identifier: Apache-2.0
"""Rolling and plain bearings: load distribution, varying compliance, whole turns, energy, tangents."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from pitchpoint.contact.rolling import ball_bearing_stiffness
from pitchpoint.elements import clearance_bearing, rolling_bearing
from pitchpoint.elements.rolling_bearing import cage_angle
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
    moved_world,
    moving,
    power,
    wrenches,
)
from tests.support.markers import set_markers

STEEL = 2.0 * 0.91 / 207e9


def rolling(bodies, i, j, position=(0.0, 0.0, 0.0), axes=None, **numbers):
    record = np.zeros(1, rolling_bearing.RECORD)
    record["i"], record["j"], record["n"], record["exponent"] = i, j, 9, 1.5
    record["pitch"], record["element"], record["stiffness"] = 0.3, 0.06, 200.0
    for name, value in numbers.items():
        record[name] = value
    set_markers(record[0], bodies, position, axes)
    return record


def journal(bodies, i, j, position=(0.0, 0.0, 0.0), axes=None, **numbers):
    record = np.zeros(1, clearance_bearing.RECORD)
    record["i"], record["j"], record["gap"], record["exponent"], record["stiffness"] = i, j, 0.01, 1.5, 500.0
    for name, value in numbers.items():
        record[name] = value
    set_markers(record[0], bodies, position, axes)
    return record


def approaches(system, record, state):
    """Approach of the raceways at every element, by plain vectors; turns within half a turn."""
    r, A = markers(system, record, state)
    (x, y, z), n = A[1].T @ (r[0] - r[1]), A[1].T @ A[0][:, 2]
    if "n" not in record.dtype.names:
        return np.array([np.hypot(x, y) - record["gap"][0]])
    B = A[1].T @ A[0]
    swing = np.eye(3) * n[2]  # shortest rotation that takes e_z to n, then the twist that is left
    v = np.cross([0.0, 0.0, 1.0], n)
    swing += np.array([[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]])
    swing += np.outer(v, v) / (1.0 + n[2])
    twist = swing.T @ B
    turn = np.arctan2(twist[1, 0], twist[0, 0])
    b = record[0]
    share = 0.5 * (1.0 - b["element"] / b["pitch"] * np.cos(b["angle"]))
    psi = b["azimuth"] + share * turn + 2.0 * np.pi * np.arange(b["n"]) / b["n"]
    c, s = np.cos(psi), np.sin(psi)
    radial = x * c + y * s - b["gap"]
    axial = z - 0.5 * b["pitch"] * (n[0] * c + n[1] * s)
    if b["grooves"] > 0.0:
        A = b["grooves"]
        p, q = A * np.cos(b["angle"]) + radial, A * np.sin(b["angle"]) + axial + b["shift"]
        # deepest point of the arc of a groove, a right angle to either side of the radial direction
        deepest = np.clip(np.arctan2(q, p), -0.5 * np.pi, 0.5 * np.pi)
        return p * np.cos(deepest) + q * np.sin(deepest) - A
    return radial * np.cos(b["angle"]) + axial * np.sin(b["angle"])


KINDS = {
    "roller": (rolling, {"gap": -0.2, "angle": 0.6, "azimuth": 0.1, "exponent": 10.0 / 9.0}),
    "play": (rolling, {"gap": 0.01, "angle": 0.2, "n": 12}),
    "grooves": (rolling, {"gap": -0.1, "angle": 0.3, "grooves": 0.4}),
    "grooves passed": (rolling, {"gap": 0.2, "angle": 1.2, "grooves": 0.4, "shift": 0.25}),
    "journal": (journal, {}),
}


@pytest.mark.nojit
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(("i", "j"), ENDS)
def test_energy_balance_and_tangents_anywhere_in_a_tree(i, j, kind):
    rng = np.random.default_rng(10 * i + j)
    bodies = mechanism(rng)
    make, numbers = KINDS[kind]
    record = make(bodies, i, j, 0.2 * rng.normal(size=3), frame(rng), chi=0.3, **numbers)
    name = "clearance_bearing" if make is journal else "rolling_bearing"
    system = assemble(bodies, {name: record})
    state = moving(system, rng, 0.1)
    state.v *= 0.3
    check_matrices(system, state)
    check_balance(system, state)
    h = 1e-4
    near, far = (approaches(system, record, along(system, state, s * h)) for s in (-1.0, 1.0))
    here, rate = approaches(system, record, state), (far - near) / (2.0 * h)
    assert np.count_nonzero(here > 0.0) >= (1 if kind in ("play", "grooves passed", "journal") else 5)
    force = (
        record["stiffness"] * np.maximum(here, 0.0) ** record["exponent"] * np.maximum(1.0 + 0.3 * rate, 0.0)
    )
    assert power(system, state) == pytest.approx(-force @ rate, rel=2e-6)


@pytest.mark.parametrize("make", [rolling, journal])
def test_a_bearing_moves_with_the_world(make):
    rng = np.random.default_rng(6)
    bodies, place, axes = mechanism(rng), np.array([0.1, 0.2, 0.3]), frame(rng)
    name = "clearance_bearing" if make is journal else "rolling_bearing"
    one = assemble(bodies, {name: make(bodies, 3, 0, place, axes, chi=0.3)})
    state = moving(one, rng, 0.1)
    moved, turn, shift = moved_world(bodies, rng)
    two = assemble(moved, {name: make(moved, 3, 0, turn @ place + shift, turn @ axes, chi=0.3)})
    before = evaluate.residual(one, state)
    np.testing.assert_allclose(evaluate.residual(two, state), before, atol=1e-11 * np.abs(before).max())


def shaft():
    """Round body on the axis of its bearing."""
    return [Body(motion=FREE, mass=1.0, polar_inertia=0.1, transverse_inertia=0.1)]


@pytest.mark.parametrize(("exponent", "most", "thrust"), [(1.5, 4.37, 1.216), (1.1, 4.08, 1.260)])
def test_load_distribution_without_clearance(exponent, most, thrust):
    """Half a ring of loaded elements: Q_max = most F_r/(Z cos(alpha)), F_a = thrust F_r tan(alpha).

    The two numbers as printed by NSK (*Rolling Bearings*, technical report E728g, 5.1) for point and line
    contact, the latter with the exponent 1.1; Sjoevall's integrals by quadrature beside them. With 360
    elements the sums differ from the integrals by the kinks at the ends, below 1e-4.
    """
    bodies = shaft()
    angle = 0.5
    record = rolling(bodies, 1, 0, n=360, exponent=exponent, element=0.001, angle=angle)
    system = assemble(bodies, {"rolling_bearing": record})
    state = system.initial_state()
    state.q[0] = 1e-3
    force = -wrenches(system, state)[1]
    largest = 200.0 * (1e-3 * np.cos(angle)) ** exponent
    J_r = quad(lambda psi: np.cos(psi) ** (1.0 + exponent), -np.pi / 2, np.pi / 2)[0] / (2.0 * np.pi)
    assert force[0] == pytest.approx(360 * largest * np.cos(angle) * J_r, rel=1e-4)
    assert largest * 360 * np.cos(angle) / force[0] == pytest.approx(most, abs=0.006)
    assert force[2] / (force[0] * np.tan(angle)) == pytest.approx(thrust, abs=0.0006)


def test_thrust_on_an_angular_contact_bearing():
    """Bearing 218 of Harris (16 balls of 22.23 mm on 125.3 mm, f 0.5232, 40 deg) under 17 800 N.

    Jones's equation F/(Z D^2 C) = sin(a) (cos(a0)/cos(a) - 1)^1.5 with his constant C = 896.7 N/mm^2 (Hertz's
    is 10 % larger); the contact angle of the example is 41.6 deg.
    """
    D, pitch, f, a0 = 22.23e-3, 125.3e-3, 0.5232, np.radians(40.0)
    A = (2.0 * f - 1.0) * D
    bodies = shaft()
    constant = 896.7e6 * D**2 / A**1.5
    record = rolling(
        bodies, 1, 0, n=16, pitch=pitch, element=D, angle=a0, grooves=A, stiffness=constant, azimuth=0.3
    )
    assert ball_bearing_stiffness(D, pitch, (f, f), a0, STEEL) == pytest.approx(constant, rel=0.12)
    system = assemble(bodies, {"rolling_bearing": record})
    state = system.initial_state()

    def excess(z):
        state.q[2] = z
        return wrenches(system, state)[1, 2] + 17800.0

    def jones(a):
        return 16 * D**2 * 896.7e6 * np.sin(a) * (np.cos(a0) / np.cos(a) - 1.0) ** 1.5 - 17800.0

    a = brentq(jones, a0 + 1e-6, 1.0, xtol=1e-14)
    z = brentq(excess, 0.0, 1e-3, xtol=1e-14)
    assert z == pytest.approx(A * np.sin(a - a0) / np.cos(a), rel=1e-8)
    assert np.degrees(a) == pytest.approx(41.6, abs=0.05)


def test_varying_compliance_has_the_ball_pass_frequency():
    """A fixed eccentricity: the force repeats after 1/(n c) turns of the inner ring, not before."""
    bodies = shaft()
    record = rolling(bodies, 1, 0, n=8, gap=1e-3)
    system = assemble(bodies, {"rolling_bearing": record})
    state = system.initial_state()
    state.q[0] = 2e-3
    share = 0.5 * (1.0 - 0.06 / 0.3)

    def force(turn):
        state.turns[1] = int(np.round(turn / (2.0 * np.pi)))
        state.q[5] = turn - 2.0 * np.pi * state.turns[1]
        return wrenches(system, state)[1]

    period = 2.0 * np.pi / (8 * share)
    for turn in (0.1, 0.9, 3.0, 7.7, -4.0):
        np.testing.assert_allclose(force(turn + period), force(turn), rtol=1e-9, atol=1e-9)
    one, half = force(0.1), force(0.1 + 0.5 * period)
    assert abs(one[0] - half[0]) > 1e-3 * abs(one[0])


def test_the_outer_ring_carries_the_cage_too():
    """Outer ring turning against a fixed inner one: the cage follows by (1 + g)/2 turns in the world."""
    bodies = [*shaft(), Body(motion=FREE, mass=1.0, polar_inertia=0.1, transverse_inertia=0.1, name="b")]
    system = assemble(bodies, {"rolling_bearing": rolling(bodies, 1, 2)})
    state = system.initial_state()
    state.q[system.spin("b")], state.turns[2] = 0.4, 3
    cage = evaluate.observe(system, state)[system.layout.channel("cage_angle[rolling_bearing0]")]
    turn = 0.4 + 6.0 * np.pi
    in_world = 0.5 * (1.0 + 0.2) * turn
    assert (cage + turn - in_world) % (2.0 * np.pi) == pytest.approx(0.0, abs=1e-12)


@pytest.mark.nojit
@pytest.mark.parametrize("turns", [0, 1, -1, 1000, 12_345_678, -98_765_432])
def test_whole_turns_of_the_cage_are_exact(turns):
    share = 0.5 * (1.0 - 0.2043871)
    found = cage_angle(share, 0.3, turns)
    rest = float((Fraction(share) * turns) % 1)
    assert abs((found - 0.3 * share) / (2.0 * np.pi) - rest) % 1.0 == pytest.approx(0.0, abs=2e-15)


def test_turns_are_counted_where_the_angle_wraps():
    """From below to above half a turn, in the coordinate and in the count: nothing jumps."""
    bodies = shaft()
    system = assemble(bodies, {"rolling_bearing": rolling(bodies, 1, 0, n=7, gap=-1e-3)})
    state = system.initial_state()
    state.q[:5] = 1e-3, 2e-3, 0.0, 1e-2, -2e-2
    found = []
    for q, turns in ((np.pi - 1e-9, 0), (np.pi + 1e-9, 0), (-np.pi + 1e-9, 1)):
        state.q[5], state.turns[1] = q, turns
        found.append(wrenches(system, state)[1])
    np.testing.assert_allclose(found[1], found[0], rtol=1e-6, atol=1e-6)
    np.testing.assert_allclose(found[2], found[1], rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("make", [rolling, journal])
def test_nothing_pulls_however_fast_it_opens(make):
    bodies = shaft()
    name = "clearance_bearing" if make is journal else "rolling_bearing"
    system = assemble(bodies, {name: make(bodies, 1, 0, gap=1e-3, chi=5.0)})
    state = system.initial_state()
    forces = []
    for speed in (-1.0, -0.21, -0.19, 0.0, 1.0):
        state.q[0], state.v[0] = 3e-3, speed
        forces.append(-wrenches(system, state)[1, 0])
    assert np.all(np.diff(forces) >= 0.0)
    assert forces[0] == 0.0
    assert forces[-1] > 0.0
    state.q[0] = 0.9e-3
    assert not np.any(wrenches(system, state))


def test_tilting_moments_of_an_angular_contact_bearing():
    """Small tilt of a preloaded bearing: M = n/2 (d_m/2)^2 sin^2(alpha) Q'(d0) times the tilt."""
    bodies = shaft()
    angle, play = 0.5, 0.02
    record = rolling(bodies, 1, 0, n=90, angle=angle, gap=-play, element=0.001)
    system = assemble(bodies, {"rolling_bearing": record})
    state = system.initial_state()
    before = wrenches(system, state)[1]
    state.q[3] = 1e-6
    moment = (wrenches(system, state)[1] - before)[3]
    d = play * np.cos(angle)
    wanted = -45.0 * 0.15**2 * np.sin(angle) ** 2 * 1.5 * 200.0 * np.sqrt(d) * 1e-6
    # and the axial preload turns with the axis: its line of force stays in the centre, no further moment
    assert moment == pytest.approx(wanted, rel=1e-3)


def test_a_journal_tells_when_it_touches():
    """The event function is the distance beyond the play: it changes its sign with the contact."""
    bodies = shaft()
    system = assemble(bodies, {"clearance_bearing": journal(bodies, 1, 0, gap=1e-3)})
    assert [event.name for event in system.layout.events] == ["contact[clearance_bearing0]"]
    state = system.initial_state()
    for x, y in ((0.3e-3, 0.4e-3), (0.9e-3, 1.2e-3)):
        state.q[:2] = x, y
        assert evaluate.event_values(system, state)[0] == pytest.approx(np.hypot(x, y) - 1e-3)


@pytest.mark.nojit
@pytest.mark.parametrize(("angle", "one_sided"), [(0.0, 0), (0.7, 1), (-0.7, 1), (0.5 * np.pi, 1)])
def test_grooves_that_have_passed_each_other_carry_nothing(angle, one_sided):
    """The largest distance of a groove arc from the ball, by search over its directions.

    Arcs are a right angle to either side of the radial direction, with one shoulder only the quarter towards
    it, and the half circle around the axis in washers. Displacements range over five groove distances.
    """
    bodies = shaft()
    record = rolling(
        bodies, 1, 0, n=1, angle=angle, grooves=0.05, one_sided=one_sided, pitch=1e-9, element=0.0
    )
    system = assemble(bodies, {"rolling_bearing": record})
    state = system.initial_state()
    ends = (0.0, 0.5 * np.pi) if one_sided else (-0.5 * np.pi, 0.5 * np.pi)
    ends = (0.0, np.pi) if angle > 1.5 else tuple(np.copysign(1.0, angle) * np.array(ends))
    arc = np.linspace(*ends, 20001)
    rng, carried = np.random.default_rng(2), 0
    for x, z in rng.uniform(-0.25, 0.25, (200, 2)):
        state.q[:] = 0.0
        state.q[0], state.q[2] = x, z
        p, q = 0.05 * np.cos(angle) + x, 0.05 * np.sin(angle) + z
        reach = p * np.cos(arc) + q * np.sin(arc)
        d, at = reach.max() - 0.05, arc[reach.argmax()]
        load = 200.0 * max(d, 0.0) ** 1.5
        force = evaluate.residual(system, state)[[0, 2]]
        np.testing.assert_allclose(
            force, load * np.array([np.cos(at), np.sin(at)]), atol=2e-3 * (load + 1e-6)
        )
        carried += d > 0.0
    assert 30 < carried < 195
