# SPDX-License-Identifier: Apache-2.0
"""Bodies of a model as bodies of the multibody layer."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.multibody.bodies import FIXED, FREE, PLANAR, TORSION, Body

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

MOTION = {"fixed": FIXED, "torsion": TORSION, "planar": PLANAR, "free": FREE}


def bodies(model: Model) -> list[Body]:
    """All bodies in the order of the file; body k of the list is number k + 1 in the records."""
    found = []
    for name, body in model.bodies.items():
        inertia = model.body_inertia(name)
        found.append(
            Body(
                name=name,
                motion=MOTION[body.motion],
                position=body.origin or (0.0, 0.0, 0.0),
                mass=inertia.mass,
                polar_inertia=inertia.polar,
                transverse_inertia=inertia.central,
                center=inertia.center,
            )
        )
    return found


def body_numbers(model: Model) -> dict[str, int]:
    """Number of every body in the records; ground is 0."""
    return {name: k for k, name in enumerate(model.bodies, start=1)}
