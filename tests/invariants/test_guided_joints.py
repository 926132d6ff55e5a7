# SPDX-License-Identifier: Apache-2.0
"""Joints made of functions times all elements: the grids of `test_mechanisms` for moved and user joints.

The joint moves in its own plane and along its axis, so that its inverse is again made of functions of one
variable: where a body has displaced by (x, y, z) and turned by a, its neighbour sees the displacement
-(x cos a + y sin a), x sin a - y cos a, -z and the turn -a.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from pitchpoint.core.formula.formula import Formula
from pitchpoint.elements import guide
from pitchpoint.elements.gravity import gravity_records
from pitchpoint.elements.signal import Pool
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.joints import FLOATING, GUIDED
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.invariants.test_mechanisms import (
    GRAVITY,
    KINDS,
    MAKERS,
    hung_again,
    motion_of,
    moved_record,
    on_common_axis,
    pair,
    same_state,
)
from tests.invariants.test_mechanisms import at_centres as centres_of
from tests.support.engine import frame
from tests.support.forces import check_balance, check_matrices, moved_world, moving, swapped
from tests.support.trees import accelerated
from tests.unit.elements.test_all_joints import ELEMENTS

X, Y, TURN = "(0.3*sin(0.9*t + 0.4))", "(0.2*cos(t) + 0.1*t^2)", "(0.7*t + 0.2*sin(t + 0.5))"
THERE = {0: X, 1: Y, 5: TURN}
BACK = {
    0: f"-{X}*cos{TURN} - {Y}*sin{TURN}",
    1: f"{X}*sin{TURN} - {Y}*cos{TURN}",
    5: f"-{TURN}",
}
TABLE = np.linspace(-4.05, 4.0, 24)  # no point of it near a state of these tests
HEIGHT = 0.2 * np.sin(TABLE + 0.3)
#: Coordinates of the joint by its name; a moved joint has none.
GUIDES = {"moved": (), "user": (("s", "rad"),), "user of two": (("s", "rad"), ("u", "m"))}
JOINTS = [*GUIDES, "function"]


def guided(joint, body, back=False):
    """Records of the functions of a body and their pool.

    A second coordinate moves along the axis too; where a joint is a `function`, Python gives that height.
    """
    pool, rows = Pool(), []

    def row(displacement, coordinate):
        rows.append(np.zeros(1, guide.RECORD)[0])
        rows[-1]["i"], rows[-1]["m"], rows[-1]["k"] = body, displacement, coordinate
        rows[-1]["first"] = len(rows) == 1
        return rows[-1]

    of = 0 if joint in GUIDES and GUIDES[joint] else guide.TIME
    sign = -1.0 if back else 1.0
    for displacement, text in (BACK if back else THERE).items():
        guide.set_formula(row(displacement, of), pool, Formula.parse(text, ("t",)))
    if joint == "function":
        guide.set_function(row(2, of), pool, lambda t: sign * 0.2 * np.sin(t + 0.3), -4.0, 4.0)
    else:
        guide.set_table(row(2, of), pool, TABLE, sign * HEIGHT)
    if joint == "user of two":
        guide.set_formula(row(2, 1), pool, Formula.parse(f"{sign}*0.3*sin(2*t)", ("t",)))
    return np.array(rows), pool.array()


def guided_pair(rng, joint):
    """A tumbling body, one that functions guide on it, and a state for elements that have one."""
    one, two, state = pair(rng, "floating")
    return [one, replace(two, motion=GUIDED, guided_by=GUIDES.get(joint, ())), state]


def built(bodies, banks, joint, body=2, back=False):
    records, pool = guided(joint, body, back)
    return assemble(bodies, {**banks, "guide": records}, pools={"guide": pool})


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("joint", JOINTS)
@pytest.mark.parametrize(("i", "j"), [(2, 0), (1, 2)])
def test_every_element_on_every_guided_joint(i, j, joint, kind):
    """Exact matrices are slopes, actions are reactions, and the world may be moved and turned."""
    rng = np.random.default_rng(11)
    bodies = guided_pair(rng, joint)
    place, axes = 0.2 * rng.normal(size=3), frame(rng)
    system = built(bodies, {kind: MAKERS[kind](i, j, bodies, place, axes)}, joint)
    state = moving(system, rng, 0.2)
    state.v *= 0.3
    check_matrices(system, state)
    if kind not in ("beam", "gravity"):  # these carry inertia or weight, whose reaction is elsewhere
        check_balance(system, state)
    moved, turn, shift = moved_world(bodies, rng)
    again = built(moved, {kind: MAKERS[kind](i, j, moved, turn @ place + shift, turn @ axes)}, joint)
    before, after = (evaluate.residual(s, state) for s in (system, again))
    np.testing.assert_allclose(after, before, atol=1e-11 * max(1.0, np.abs(before).max()))
    expected, found = (accelerated(s, state)["ac"][1:3] for s in (system, again))
    there = np.concatenate([expected[:, :3] @ turn.T, expected[:, 3:] @ turn.T], axis=1)
    np.testing.assert_allclose(found, there, atol=1e-10 * max(1.0, np.abs(there).max()))


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("joint", JOINTS)
@pytest.mark.parametrize(("i", "j"), [(2, 0), (1, 2)])
def test_a_guided_mechanism_may_hang_from_its_other_end(i, j, joint, kind):
    rng = np.random.default_rng(12)
    bodies = on_common_axis(kind, guided_pair(rng, joint))
    place, axes = 0.2 * rng.normal(size=3), frame(rng)
    record = MAKERS[kind](i, j, bodies, place, axes)
    one, two, hidden = bodies
    base = replace(two, motion=FLOATING, parent=0, guided_by=())
    other = hung_again(
        one, two.position, np.asarray(two.axes), motion=GUIDED, parent=1, guided_by=two.guided_by
    )
    there: list[Body] = [base, other, hidden]
    number = {0: 0, 1: 2, 2: 1}
    again = record.copy()
    if kind == "gravity":
        record, again = (gravity_records(b[:2], GRAVITY) for b in (bodies, there))
    else:
        again[0] = moved_record(record[0], one, other, 1)
        again["i"], again["j"] = number[i], number[j]
    first, second = built(bodies, {kind: record}, joint), built(there, {kind: again}, joint, 2, True)
    state = moving(first, rng, 0.2)
    state.v *= 0.3
    world = [np.asarray(one.axes), np.asarray(two.axes)]
    wanted = motion_of(first, state, (1, 2), world)
    spin = first.layout.coordinate("state.spin")
    beside = same_state(second, wanted, (2, 1), world, (state.q[spin], state.v[spin]))
    expected = centres_of(accelerated(first, state), first.bodies, (1, 2), world)
    found = centres_of(accelerated(second, beside), second.bodies, (2, 1), world)
    for a, b in zip(found, expected, strict=True):
        np.testing.assert_allclose(a[3], b[3], atol=1e-7 * max(1.0, np.abs(b[3]).max()))


@pytest.mark.parametrize("kind", ["bushing", "maxwell", "spring_damper"])
@pytest.mark.parametrize("joint", JOINTS)
def test_the_bodies_of_an_element_may_be_swapped(joint, kind):
    rng = np.random.default_rng(13)
    bodies = guided_pair(rng, joint)
    record = ELEMENTS[kind](1, 2, bodies, 0.2 * rng.normal(size=3), frame(rng))
    if kind == "bushing":  # alike in all directions, so that it does not matter in whose axes
        record["K"], record["D"] = np.diag([9.0] * 3 + [4.0] * 3), 0.0
    one, two = (built(bodies, {kind: r}, joint) for r in (record, swapped(record)))
    state = moving(one, rng, 0.2)
    state.v *= 0.3
    expected, found = (accelerated(s, state)["ac"] for s in (one, two))
    np.testing.assert_allclose(found, expected, atol=1e-11 * max(1.0, np.abs(expected).max()))


@pytest.mark.nojit
@pytest.mark.parametrize("joint", ["moved", "user"])
def test_other_ends_without_the_compiler(joint):
    test_a_guided_mechanism_may_hang_from_its_other_end(1, 2, joint, "bushing")
