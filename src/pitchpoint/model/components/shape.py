# SPDX-License-Identifier: Apache-2.0
"""Shapes of bodies in the scene: boxes and bodies of revolution, without mass."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.components.marker import Axes, Triple
from pitchpoint.model.keys import boolean, component, quantities, quantity


@dataclass(frozen=True, kw_only=True)
class Shape(Component):
    """A box, or a body of revolution about its z axis, for the scene; it has no mass."""

    box: Triple | None = quantities(
        "length", "size of a box along x, y and z, with the position in its middle", None, length=(3, 3)
    )
    rounding: float = quantity("length", "radius of the edges of the box", 0.0, minimum=0.0)
    heights: tuple[float, ...] = quantities(
        "length",
        "body of revolution: positions along z from its position, in the order of the diameters, which they "
        "connect by cones; equal ones make a step",
        (),
    )
    diameters: tuple[float, ...] = quantities("length", "its outer diameters at the heights", (), minimum=0.0)
    position: Triple = quantities(
        "length", "position from the origin of the body, in its axes", (0.0, 0.0, 0.0), length=(3, 3)
    )
    axes: Axes | None = component(
        Axes, "directions of the axes in the axes of the body; default: those of the body"
    )
    cover: bool = boolean("whether it covers other parts: transparent, solid or hidden in the view", False)
