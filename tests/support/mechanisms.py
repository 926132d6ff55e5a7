# SPDX-License-Identifier: Apache-2.0
"""Small mechanisms made from numbers: four-bar, slider-crank."""

from __future__ import annotations

import numpy as np

from pitchpoint.elements.closure_rows import cut_joint
from pitchpoint.multibody.bodies import TORSION, Body
from pitchpoint.multibody.joints import PLANAR, PRISMATIC
from pitchpoint.system.system import assemble


def bar(start, end, mass=1.0, **more):
    """Slender bar in the x-y plane from one point to another, hung at its start."""
    start, end = np.array([*start, 0.0]), np.array([*end, 0.0])
    along = end - start
    length = float(np.linalg.norm(along))
    x = along / length
    axes = np.column_stack([x, np.cross([0.0, 0.0, 1.0], x), [0.0, 0.0, 1.0]])
    inertia = mass * length**2 / 12.0 * np.diag([1e-6, 1.0, 1.0])
    inertia[0, 0] = 1e-6 * inertia[1, 1]
    return Body(
        position=start,
        axes=axes,
        mass=mass,
        com=(0.5 * length, 0.0, 0.0),
        inertia=inertia,
        **{"motion": TORSION, **more},
    )


def four_bar(points=((0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)), cut=TORSION, **kinds):
    """Crank, coupler and rocker between four points, the last joint cut to a revolute on ground."""
    a, b, c, d = points
    bodies = [
        bar(a, b, name="crank"),
        bar(b, c, name="coupler", parent=1),
        bar(c, d, name="rocker", parent=2),
    ]
    records, words = cut_joint(cut, bodies, 3, 0, (*d, 0.0), np.eye(3))
    names = {"closure": [f"pivot {word}" for word in words]}
    return assemble(bodies, kinds, {"closure": records}, names=names)


def slider_crank(crank=0.3, rod=1.0, angle=0.4, **kinds):
    """Crank on ground, rod, slider along x held to the rod's end by a cut revolute joint (planar)."""
    pin = (crank * np.cos(angle), crank * np.sin(angle))
    end = (pin[0] + np.sqrt(rod**2 - pin[1] ** 2), 0.0)
    along_x = np.column_stack([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])
    slider = Body(
        motion=PRISMATIC, position=(*end, 0.0), axes=along_x, mass=1.0, inertia=np.eye(3), name="slider"
    )
    bodies = [bar((0.0, 0.0), pin, name="crank"), bar(pin, end, name="rod", parent=1), slider]
    records, words = cut_joint(PLANAR, bodies, 2, 3, (*end, 0.0), np.eye(3))
    point, at = cut_joint(TORSION, bodies, 2, 3, (*end, 0.0), np.eye(3))
    rows = np.concatenate([point[:2], records[:0]])
    assert words[0] == "z"
    return assemble(bodies, kinds, {"closure": rows}, names={"closure": [f"pin {w}" for w in at[:2]]})
