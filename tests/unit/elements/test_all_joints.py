# SPDX-License-Identifier: Apache-2.0
"""Every element with markers on bodies of every joint: tangents, balance, moved worlds, bodies swapped."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.elements import (
    bushing,
    clearance_bearing,
    force,
    friction_clutch,
    loose_bearing,
    maxwell,
    rolling_bearing,
    spring_damper,
)
from pitchpoint.elements.gravity import gravity_records
from pitchpoint.multibody.bodies import FREE, PLANAR, TORSION, Body
from pitchpoint.multibody.joints import (
    CYLINDRICAL,
    FIXED,
    FLOATING,
    PRISMATIC,
    SCREW,
    SPHERICAL,
    UNIVERSAL,
)
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import frame, positive
from tests.support.forces import check_balance, check_matrices, moved_world, moving, swapped, wrenches
from tests.support.markers import set_markers

JOINTS = {
    "fixed": FIXED,
    "torsion": TORSION,
    "planar": PLANAR,
    "free": FREE,
    "prismatic": PRISMATIC,
    "cylindrical": CYLINDRICAL,
    "universal": UNIVERSAL,
    "spherical": SPHERICAL,
    "screw": SCREW,
    "floating": FLOATING,
}


def make(kind, i, j, bodies, place, axes):
    """A record with markers that coincide at a place of the assembled world."""
    record = np.zeros(1, kind.RECORD)
    record["i"], record["j"] = i, j
    if "p_i" in record.dtype.names:
        set_markers(record[0], bodies, place, axes)
    return record


def stiff(record, **numbers):
    for name, value in numbers.items():
        record[name] = value
    return record


RNG = np.random.default_rng(1)
K, D, LOAD = positive(RNG), 0.2 * positive(RNG), RNG.normal(size=6)

ELEMENTS = {
    "bushing": lambda *a: stiff(make(bushing, *a), K=K, D=D),
    "clearance_bearing": lambda *a: stiff(
        make(clearance_bearing, *a), gap=1e-3, stiffness=300.0, exponent=1.5, chi=0.2
    ),
    "loose_bearing": lambda *a: stiff(
        make(loose_bearing, *a), gap=1e-3, seat=1e-3, k=300.0, d=20.0, Kt=K[2:5, 2:5], Dt=D[2:5, 2:5]
    ),
    "force": lambda *a: stiff(make(force, *a), F=LOAD, value=1.0, axes=force.BODY, p=(0.1, 0.2, 0.3)),
    "friction_clutch": lambda *a: stiff(
        make(friction_clutch, *a),
        value=3.0,
        ratio=1.3,
        v_s=0.5,
        v_eps=9.0,
        k=3,
        sticking=1,
        onset=0.3,
        stiffness=9.0,
    ),
    "gravity": lambda i, j, bodies, place, axes: gravity_records(bodies[:2], axes @ (1.0, 2.0, 3.0)),
    "maxwell": lambda *a: stiff(make(maxwell, *a), k=3, stiffness=30.0, damping=2.0, p_i=(0.3, 0.2, 0.4)),
    "rolling_bearing": lambda *a: stiff(
        make(rolling_bearing, *a),
        n=7,
        pitch=0.3,
        element=0.05,
        angle=0.4,
        gap=-0.3,
        stiffness=90.0,
        exponent=1.5,
    ),
    "spring_damper": lambda *a: stiff(make(spring_damper, *a), k=30.0, d=2.0, free=0.1, p_i=(0.3, 0.2, 0.4)),
}


def chain(rng, motion):
    """A body on ground with a joint, a second one on it with the same joint, and a state."""
    bodies = []
    for parent in range(2):
        spread = positive(rng, 3)
        bodies.append(
            Body(
                motion=motion,
                parent=parent,
                position=0.3 * rng.normal(size=3),
                axes=frame(rng),
                mass=1.0 + parent,
                com=0.1 * rng.normal(size=3),
                inertia=np.trace(spread) * np.eye(3) - spread,
                lead=0.2 if motion == SCREW else 0.0,
                name=f"b{parent}",
            )
        )
    return [*bodies, Body(polar_inertia=1.0, name="state")]


@pytest.mark.parametrize("kind", ELEMENTS)
@pytest.mark.parametrize("joint", JOINTS)
@pytest.mark.parametrize(("i", "j"), [(2, 0), (1, 2)])
def test_every_element_on_every_joint(i, j, joint, kind):
    """A clutch has constant capacity here: angles between bodies are those of their joints, whose slopes by
    turns of the bodies are exact only where all axes on the way are parallel (see `elements.torsion`)."""
    rng = np.random.default_rng(7)
    bodies, place, axes = chain(rng, JOINTS[joint]), 0.2 * rng.normal(size=3), frame(rng)
    system = assemble(bodies, {kind: ELEMENTS[kind](i, j, bodies, place, axes)})
    state = moving(system, rng, 0.2)
    state.v *= 0.3
    check_matrices(system, state)
    if kind != "gravity":
        check_balance(system, state)
    moved, turn, shift = moved_world(bodies, rng)
    other = ELEMENTS[kind](i, j, moved, turn @ place + shift, turn @ axes)
    again = assemble(moved, {kind: other})
    before = evaluate.residual(system, state)
    after = evaluate.residual(again, state)
    np.testing.assert_allclose(after, before, atol=1e-11 * max(1.0, np.abs(before).max()))


@pytest.mark.parametrize("kind", ["bushing", "clearance_bearing", "maxwell", "spring_damper"])
def test_bodies_may_be_swapped(kind):
    """Which body comes first changes nothing where the law has no preference (a symmetric bushing)."""
    rng = np.random.default_rng(3)
    bodies, place, axes = chain(rng, FLOATING), 0.2 * rng.normal(size=3), frame(rng)
    record = ELEMENTS[kind](1, 2, bodies, place, axes)
    if kind == "bushing":  # alike in all directions, so that it does not matter in whose axes
        record["K"], record["D"] = np.diag([9.0] * 3 + [4.0] * 3), 0.0
    one, two = (assemble(bodies, {kind: r}) for r in (record, swapped(record)))
    state = moving(one, rng, 0.2)
    if kind == "clearance_bearing":  # the plane of the forces is that of the bore
        state.q[:] = 0.0
        state.v[:] = 0.0
        state.q[one.layout.coordinate("b1.x")] = 0.1
    found, wanted = wrenches(two, state), wrenches(one, state)
    if kind == "clearance_bearing":  # and they act at the journal
        found, wanted = found[:, :3], wanted[:, :3]
    assert np.abs(wanted).max() > 0.1
    np.testing.assert_allclose(found, wanted, atol=1e-12)
