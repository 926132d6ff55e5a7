# SPDX-License-Identifier: Apache-2.0
"""Two bodies that touch, anywhere in the world, on ground or in a tree: for tests of contact kinds."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from pitchpoint.contact.impact import set_friction, set_impact
from pitchpoint.contact.triangles import TriangleSurface
from pitchpoint.elements.contacts.record import new_records
from pitchpoint.elements.signal import Pool
from pitchpoint.multibody.bodies import FREE, TORSION, Body
from pitchpoint.multibody.joints import FLOATING
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.engine import frame


def contact(kind, setup, law=None):
    """Record of one contact and its pool; `setup(record, pool)` gives the shapes."""
    pool, records = Pool(), new_records(1)
    records["i"], records["j"] = 1, 2
    set_impact(records[0], 1e6, 1.5, 30.0, 1e-3)
    set_friction(records[0], 0.3, 0.2, 0.05, 0.2)
    setup(records[0], pool)
    if law is not None:
        law(records[0])
    return records, {kind: pool.array()}


def solid(name, position, axes, parent=0, motion=FREE, mass=1.0):
    """A body of any inertia."""
    inertia = np.diag([0.011, 0.012, 0.013])
    return Body(
        motion=motion,
        parent=parent,
        position=position,
        axes=axes,
        mass=mass,
        com=(0.01, 0.02, -0.01),
        inertia=inertia,
        name=name,
    )


def pair(kind, made, apart, rng, where="free"):
    """System of two bodies, the first at `apart` in the axes of the second, somewhere in the world.

    `where` is free (both on ground), ground (the second is ground itself), tree (both hang on a turning arm).
    """
    records, pools = made
    E = frame(rng)
    base = rng.normal(size=3)
    at = base + E @ np.asarray(apart, float)
    if where == "ground":
        records["j"] = 0
        records["pj"] = base + records["pj"] @ E.T
        records["Bj"] = E @ records["Bj"]
        bodies = [solid("a", at, E)]
    elif where == "tree":
        records["i"], records["j"] = 2, 3
        arm = Body(
            motion=TORSION,
            position=rng.normal(size=3),
            axes=frame(rng),
            mass=1.0,
            polar_inertia=0.5,
            name="arm",
        )
        bodies = [arm, solid("a", at, E, 1, FLOATING), solid("b", base, E, 1)]
    else:
        bodies = [solid("a", at, E), solid("b", base, E)]
    return assemble(bodies, {kind: records}, pools=pools)


def shaken(system, rng, places=1e-4, rates=0.1):
    """State near the assembled one, with rates in all directions."""
    state = system.initial_state()
    n = system.sizes["nd"]
    state.q, state.v = places * rng.normal(size=n), rates * rng.normal(size=n)
    if system.bodies[0].name == "arm":
        state.q[0] = 0.7
    return state


def read(system, state, name):
    """One observation by the first part of its name."""
    values = evaluate.observe(system, state)
    return float(values[[c.name for c in system.layout.channels].index(name)])


def unmoved(system, state):
    """Wrenches of the contacts alone on all bodies, shape (n, 6): with less without their laws."""
    w = system.workspace
    evaluate.residual(system, state)
    whole = w.fr["F"].copy()
    kind = next(iter(system.records))
    bank = system.records[kind]
    stiffness, damping, depth = bank["k"].copy(), bank["c"].copy(), bank["depth"].copy()
    bank["k"], bank["c"] = 0.0, 0.0
    evaluate.residual(system, state)
    without = w.fr["F"].copy()
    bank["k"], bank["c"], bank["depth"] = stiffness, damping, depth
    evaluate.residual(system, state)
    return whole - without


def ball(radius, times):
    """Sphere of triangles: an icosahedron whose faces are cut into four several times."""
    g = 0.5 * (1.0 + np.sqrt(5.0))
    points = [(0, s, t * g) for s in (-1, 1) for t in (-1, 1)]
    points = np.array([np.roll(p, k) for k in range(3) for p in points], float)
    points /= np.linalg.norm(points, axis=1)[:, None]
    faces = [
        f
        for f in combinations(range(12), 3)
        if max(np.linalg.norm(points[f[a]] - points[f[b]]) for a, b in ((0, 1), (1, 2), (2, 0))) < 1.1
    ]
    triangles = points[np.array(faces)]
    for _ in range(times):
        a, b, c = (triangles[:, k] for k in range(3))
        ab, bc, ca = (0.5 * (x + y) for x, y in ((a, b), (b, c), (c, a)))
        triangles = np.concatenate(
            [np.stack(t, axis=1) for t in ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))]
        )
        triangles /= np.linalg.norm(triangles, axis=2)[:, :, None]
    out = np.einsum(
        "ij,ij->i",
        np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]),
        triangles[:, 0],
    )
    triangles[out < 0.0] = triangles[out < 0.0][:, ::-1]
    return TriangleSurface.from_triangles(radius * triangles)


def box(sides, cuts=4):
    """Box of triangles about the origin, every side cut into squares and these into two triangles."""
    found = []
    x = np.linspace(-0.5, 0.5, cuts + 1)
    for axis in range(3):
        for side in (-0.5, 0.5):
            for a in range(cuts):
                for b in range(cuts):
                    corners = [(x[a], x[b]), (x[a + 1], x[b]), (x[a + 1], x[b + 1]), (x[a], x[b + 1])]
                    p = np.array([np.roll((side, u, w), axis) for u, w in corners]) * np.asarray(sides)
                    p = p if side > 0.0 else p[::-1]
                    found += [p[[0, 1, 2]], p[[0, 2, 3]]]
    return TriangleSurface.from_triangles(np.array(found))
