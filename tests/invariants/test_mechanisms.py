# SPDX-License-Identifier: Apache-2.0
"""All joints times all elements with markers: the description of a mechanism must not matter.

The world may be moved and turned, the two bodies of an element may be swapped, and a mechanism may hang
from its other end: accelerations of all centres and angular accelerations stay what they are.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import least_squares

from pitchpoint.elements import joint_friction, torsion_maxwell
from pitchpoint.elements.beam import beam_row
from pitchpoint.elements.gravity import gravity_records
from pitchpoint.elements.signal import Pool
from pitchpoint.multibody.beam_section import Beam, rectangle
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.joints import FLOATING, SCREW, UNIVERSAL
from pitchpoint.solvers.constraints.assembly import assemble_state
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import bearings, couplings, frame, gear_rows, torques
from tests.support.forces import check_matrices, moved_world, moving, shafts, swapped
from tests.support.mechanisms import four_bar
from tests.support.trees import accelerated, positive_inertia
from tests.unit.elements.test_all_joints import ELEMENTS, JOINTS

KINDS = sorted({*ELEMENTS, "beam"})
GRAVITY = np.array([1.0, -9.0, 3.0])


def beam(i, j, bodies, place, axes):
    """A beam with mass from a place to another further along its third axis."""
    shape = Beam(section=rectangle(0.1, 0.08), length=0.3, E=2e5, G=8e4, rho=900.0)
    frames = [np.eye(3) if k == 0 else np.asarray(bodies[k - 1].axes) for k in (i, j)]
    origins = [np.zeros(3) if k == 0 else np.asarray(bodies[k - 1].position) for k in (i, j)]
    ends = (place, place + 0.3 * axes[:, 2])
    nodes = tuple(E.T @ (x - o) for E, x, o in zip(frames, ends, origins, strict=True))
    return beam_row(shape, bodies=(i, j), nodes=nodes, axes=tuple(E.T @ axes for E in frames), eta=1e-2)


MAKERS = {**ELEMENTS, "beam": beam}


def pair(rng, joint):
    """A tumbling body, one that hangs on it by a joint, and a state for elements that have one."""
    bodies = [
        Body(
            motion=motion,
            parent=parent,
            position=0.3 * rng.normal(size=3),
            axes=frame(rng),
            mass=1.0 + parent,
            com=0.1 * rng.normal(size=3),
            inertia=positive_inertia(rng),
            lead=0.2 if motion == SCREW else 0.0,
            name=f"b{parent}",
        )
        for parent, motion in enumerate((FLOATING, JOINTS[joint]))
    ]
    return [*bodies, Body(polar_inertia=1.0, name="state", state=True)]


def on_common_axis(kind, bodies):
    """For a clutch, the first body with the axes of the second; all else may lie anywhere.

    A clutch has no axis of its own: it acts about those of its bodies, which are those of their joints. A
    body that hangs by another joint keeps its clutch only where that joint has the same axis. Its capacity
    may not follow the angle here: every joint counts that from an attitude of its own.
    """
    if kind != "friction_clutch":
        return bodies
    return [replace(bodies[0], axes=bodies[1].axes), *bodies[1:]]


def hung_again(body, place, axes, **more):
    """The same body with its origin and axes at another place of the assembled world."""
    turn = axes.T @ body.axes
    com = axes.T @ (body.position + body.axes @ body.com - place)
    inertia = turn @ np.asarray(body.inertia) @ turn.T
    return replace(body, position=place, axes=axes, com=com, inertia=inertia, **more)


def reversed_pair(bodies):
    """The second body tumbles, the first hangs on it by the same joint, with other signs of coordinates.

    A universal joint keeps x on the body it hangs on and y on its own: both change places.
    """
    one, two, state = bodies
    E = np.asarray(two.axes)
    joint_axes = np.column_stack([E[:, 1], E[:, 0], -E[:, 2]]) if two.motion == UNIVERSAL else E
    base = replace(two, motion=FLOATING, parent=0, lead=0.0)
    other = hung_again(one, two.position, joint_axes, motion=two.motion, parent=1, lead=two.lead)
    return [base, other, state]


def moved_record(record, before, after, number):
    """A record whose body i or j hangs from another place: its markers, seen from there."""
    found = record.copy()
    turn = np.asarray(after.axes).T @ before.axes
    shift = np.asarray(after.axes).T @ (np.asarray(before.position) - after.position)
    for end in "ij":
        if record[end] != number:
            continue
        for name in (f"p_{end}", "p"):
            if name in record.dtype.names and record[name].shape == (3,) and (name != "p" or end == "i"):
                found[name] = turn @ record[name] + shift
        for name in (f"A_{end}", f"B_{end}"):
            if name in record.dtype.names:
                found[name] = turn @ record[name]
    if "F" in record.dtype.names and record["F"].shape == (6,) and record["i"] == number:
        found["F"] = np.concatenate([turn @ record["F"][:3], turn @ record["F"][3:]])
    return found


def motion_of(system, state, order, places):
    """Centres, attitudes, twists at the centres of bodies; `places` are their axes in the assembled world."""
    evaluate.residual(system, state)
    return at_centres(system.workspace.fr, system.bodies, order, places)


def at_centres(frames, bodies, order, places):
    """The same of frames as they are."""
    rows = []
    for k, axes in zip(order, places, strict=True):
        f, body = frames[k], bodies[k - 1]
        arm, omega, alpha = f["S"] @ body.center_of_mass(), f["tw"][3:], f["ac"][3:]
        turn = f["S"] @ np.asarray(body.axes).T @ axes  # whatever axes the body has in its tree
        speed = f["tw"][:3] + np.cross(omega, arm)
        acceleration = f["ac"][:3] + np.cross(alpha, arm) + np.cross(omega, np.cross(omega, arm))
        twist, second = np.concatenate([speed, omega]), np.concatenate([acceleration, alpha])
        rows.append((f["r"] + arm, turn, twist, second))
    return rows


def same_state(system, wanted, order, places, hidden):
    """State of another tree with the same centres, attitudes and twists."""
    state = system.initial_state()
    n = system.sizes["nd"]
    live = [k for k in range(n) if not system.layout.coordinates[k].startswith("state")]

    def off(x):
        state.q[live] = x
        found = motion_of(system, state, order, places)
        parts = [
            (a - b).ravel()
            for f, w in zip(found, wanted, strict=True)
            for a, b in zip(f[:2], w[:2], strict=True)
        ]
        return np.concatenate(parts)

    done = least_squares(off, np.zeros(len(live)), method="lm", xtol=1e-15, ftol=1e-15, gtol=1e-15)
    assert np.abs(done.fun).max() < 1e-10
    state.q[live] = done.x
    twists = np.concatenate([row[2] for row in wanted])
    state.v[:] = 0.0
    by_itself = np.concatenate([row[2] for row in motion_of(system, state, order, places)])  # moved joints
    columns = []
    for k in live:
        state.v[:] = 0.0
        state.v[k] = 1.0
        moving_one = np.concatenate([row[2] for row in motion_of(system, state, order, places)])
        columns.append(moving_one - by_itself)
    twists = twists - by_itself
    state.v[:] = 0.0
    state.v[live], *_ = np.linalg.lstsq(np.transpose(columns), twists, rcond=None)
    spin = system.layout.coordinate("state.spin")
    state.q[spin], state.v[spin] = hidden
    return state


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("joint", JOINTS)
@pytest.mark.parametrize(("i", "j"), [(2, 0), (1, 2)])
def test_a_mechanism_may_hang_from_its_other_end(i, j, joint, kind):
    rng = np.random.default_rng(5)
    bodies = on_common_axis(kind, pair(rng, joint))
    place, axes = 0.2 * rng.normal(size=3), frame(rng)
    record = MAKERS[kind](i, j, bodies, place, axes)
    there = reversed_pair(bodies)
    number = {0: 0, 1: 2, 2: 1, 3: 3}
    again = record.copy()
    if kind == "gravity":
        record, again = (gravity_records(b[:2], GRAVITY) for b in (bodies, there))
    else:
        again[0] = moved_record(record[0], bodies[0], there[1], 1)
        again["i"], again["j"] = number[i], number[j]
    one, two = assemble(bodies, {kind: record}), assemble(there, {kind: again})
    state = moving(one, rng, 0.2)
    state.v *= 0.3
    world = [np.asarray(bodies[0].axes), np.asarray(bodies[1].axes)]
    wanted = motion_of(one, state, (1, 2), world)
    spin = one.layout.coordinate("state.spin")
    # the axis of the first body of a clutch points the other way there, and so do the bristles
    flips = -1.0 if kind == "friction_clutch" and i == 1 and joint == "universal" else 1.0
    other = same_state(two, wanted, (2, 1), world, (flips * state.q[spin], flips * state.v[spin]))
    expected = at_centres(accelerated(one, state), one.bodies, (1, 2), world)
    found = at_centres(accelerated(two, other), two.bodies, (2, 1), world)
    for a, b in zip(found, expected, strict=True):
        np.testing.assert_allclose(a[3], b[3], atol=1e-7 * max(1.0, np.abs(b[3]).max()))


@pytest.mark.parametrize("kind", ["bushing", "maxwell", "spring_damper"])
@pytest.mark.parametrize("joint", JOINTS)
def test_the_bodies_of_an_element_may_be_swapped(joint, kind):
    """Laws without preference: a bushing that is alike in all directions, undamped in turns."""
    rng = np.random.default_rng(6)
    bodies = pair(rng, joint)
    record = ELEMENTS[kind](1, 2, bodies, 0.2 * rng.normal(size=3), frame(rng))
    if kind == "bushing":
        record["K"], record["D"] = np.diag([9.0] * 3 + [4.0] * 3), 0.0
    one, two = (assemble(bodies, {kind: r}) for r in (record, swapped(record)))
    state = moving(one, rng, 0.2)
    state.v *= 0.3
    expected, found = (accelerated(s, state)["ac"] for s in (one, two))
    np.testing.assert_allclose(found, expected, atol=1e-11 * max(1.0, np.abs(expected).max()))


@pytest.mark.parametrize("joint", JOINTS)
def test_the_world_may_be_moved_and_turned(joint):
    """With all elements at once on all bodies: accelerations turn with the world, matrices stay."""
    rng = np.random.default_rng(7)
    bodies = pair(rng, joint)
    place, axes = 0.2 * rng.normal(size=3), frame(rng)
    ends = ((2, 0), (1, 2), (1, 0))
    moved, turn, shift = moved_world(bodies, rng)

    def build(parts, point, directions, gravity):
        banks = {
            kind: np.concatenate([MAKERS[kind](i, j, parts, point, directions) for i, j in ends])
            for kind in ("beam", "bushing", "clearance_bearing", "force", "rolling_bearing", "spring_damper")
        }
        return assemble(parts, {**banks, "gravity": gravity_records(parts[:2], gravity)})

    one = build(bodies, place, axes, GRAVITY)
    two = build(moved, turn @ place + shift, turn @ axes, turn @ GRAVITY)
    state = moving(one, rng, 0.2)
    state.v *= 0.3
    check_matrices(one, state)
    for a, b in zip(evaluate.linearize(one, state), evaluate.linearize(two, state), strict=True):
        np.testing.assert_allclose(b, a, atol=1e-10 * max(1.0, np.abs(a).max()))
    expected, found = accelerated(one, state), accelerated(two, state)
    for half in (slice(0, 3), slice(3, 6)):
        there = expected["ac"][:3, half] @ turn.T
        np.testing.assert_allclose(found["ac"][:3, half], there, atol=1e-10 * max(1.0, np.abs(there).max()))


@pytest.mark.parametrize("kind", KINDS)
def test_a_loop_may_be_cut_at_its_other_end(kind):
    """A four-bar from crank to rocker and back again, an element on its coupler."""
    rng = np.random.default_rng(8)
    corners = ((0.0, 0.0), (0.1, 0.9), (1.2, 1.1), (1.0, 0.0))
    there, back = (four_bar(c) for c in (corners, corners[::-1]))
    place, axes = np.array([0.5, 0.8, 0.1]), frame(rng)
    hidden = Body(polar_inertia=1.0, name="state", state=True)
    one = [*there.bodies, hidden]
    two = [*back.bodies, hidden]
    record = MAKERS[kind](2, 0, one, place, axes)
    if "k" in record.dtype.names and record["k"].dtype.kind == "i":
        record["k"] = 4
    again = record.copy()
    if kind == "gravity":
        record, again = (gravity_records(b[:3], GRAVITY) for b in (one, two))
    else:
        again[0] = moved_record(record[0], one[1], two[1], 2)
    names = there.names
    systems = [
        assemble(bodies, {kind: r}, {"closure": old.records["closure"]}, names=names)
        for bodies, r, old in ((one, record, there), (two, again, back))
    ]
    found, rate = [], 2.0
    for system, order in zip(systems, ((1, 2, 3), (3, 2, 1)), strict=True):
        state = system.initial_state()
        crank = system.layout.coordinate("crank.spin")
        state.v[crank] = rate
        state = assemble_state(system, state, keep_rates=[crank]).state
        state.v[system.layout.coordinate("state.spin")] = 0.3
        evaluate.residual(system, state)
        rate = float(system.workspace.fr["tw"][3][5])  # of the rocker, which is the other crank
        frames = accelerated(system, state)
        found.append(at_centres(frames, system.bodies, order, [np.eye(3)] * 3))
    for a, b in zip(*found, strict=True):
        np.testing.assert_allclose(b[2], a[2], atol=1e-12)
        np.testing.assert_allclose(b[3], a[3], atol=1e-9 * max(1.0, np.abs(a[3]).max()))
    assert max(np.abs(row[3]).max() for row in found[0]) > 1.0


def _about_axes(bodies, turn):
    """What acts about the axes of shafts, with all kinds at once."""
    damper = np.zeros(1, torsion_maxwell.RECORD)
    damper["i"], damper["j"], damper["k"] = 1, 3, 5
    damper["stiffness"], damper["damping"] = 40.0, 3.0
    loads = torques([(1, 2.0), (3, -1.0)])
    loads["j"] = 0, 4
    hold = bearings([(1, 0, np.diag([900.0, 800.0, 700.0, 40.0, 30.0, 0.0]), 2.0 * np.eye(6))])
    hold["D"][:, 5] = 0.0
    hold["B"] = turn
    hold["d0"] = turn.T @ np.asarray(bodies[0].position)  # from the origin of the world
    rubbed, pool = np.zeros(1, joint_friction.RECORD), Pool()
    rubbed["i"], rubbed["j"], rubbed["form"], rubbed["ratio"] = 3, 2, joint_friction.TURN, 1.0
    rubbed["mu"], rubbed["c_r"], rubbed["v_eps"] = 0.2, 0.05, 0.1
    carrier, planet = bodies[1], bodies[2]
    rubbed["p_j"] = np.asarray(carrier.axes).T @ np.subtract(planet.position, carrier.position)
    rubbed["axis"] = np.asarray(carrier.axes).T @ np.asarray(planet.axes)[:, 2]
    beyond = joint_friction.bodies_beyond(bodies, 3)
    rubbed["n_beyond"], rubbed["beyond"] = beyond.size, pool.add(beyond.view(np.float64))
    banks = {
        "bearing": hold,
        "coupling": couplings([(1, 2, 30.0, 0.4, 0.1), (3, 4, 20.0, 0.3, 0.0), (2, 0, 15.0, 0.2, 0.0)]),
        "gravity": gravity_records(bodies[:4], turn @ GRAVITY),
        "joint_friction": rubbed,
        "torque": loads,
        "torsion_maxwell": damper,
    }
    ratio = {"ratio": gear_rows([(2, 4, 20, 41)])}
    return assemble(bodies, banks, ratio, pools={"joint_friction": pool.array()})


def test_elements_about_axes_in_a_moved_world():
    """Accelerations of joint coordinates, and the reaction of a gear ratio, know nothing of the world."""
    rng = np.random.default_rng(9)
    bodies = shafts(rng, states=1)
    moved, turn, _ = moved_world(bodies, rng)
    one, two = _about_axes(bodies, np.eye(3)), _about_axes(moved, turn)
    state = moving(one, rng, 0.3, 0.05)
    found = []
    for system in (one, two):
        accelerated(system, state)
        found.append(np.concatenate([system.workspace.a, system.workspace.lam]))
    assert np.abs(found[0]).min() > 1e-3
    np.testing.assert_allclose(found[1], found[0], atol=1e-10 * np.abs(found[0]).max())


@pytest.mark.nojit
@pytest.mark.parametrize("joint", ["universal", "screw"])
def test_other_ends_without_the_compiler(joint):
    test_a_mechanism_may_hang_from_its_other_end(1, 2, joint, "bushing")
