# SPDX-License-Identifier: Apache-2.0
"""A rigid body with its gears, mass properties and degrees of freedom."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from pitchpoint.model.component import Component
from pitchpoint.model.components.marker import Axes, Marker, Triple
from pitchpoint.model.components.shape import Shape
from pitchpoint.model.components.solid import SolidReference
from pitchpoint.model.keys import choice, component, derived, key, quantities, quantity

if TYPE_CHECKING:
    from pitchpoint.model.components.elastic_body import ElasticBody
    from pitchpoint.model.components.shaft import Shaft

MOTIONS = ("torsion", "planar", "free", "fixed")


@dataclass(frozen=True, kw_only=True)
class Body(Component):
    """A rigid body; its spin axis is the z axis of its own frame."""

    gears: dict[str, float] = key(
        "gears",
        "names of the gears, or a mapping of names to axial positions of their mid-faces [m]",
        {},
        names="gears",
    )
    bevel_gears: dict[str, float] = key(
        "gears",
        "names of the bevel gears, or a mapping of names to axial positions of their apexes [m]",
        {},
        later=True,
        names="bevel_gears",
    )
    motion: str | None = choice(
        MOTIONS,
        "degrees of freedom against ground, for a body without joint; torsion: spin only; planar: x, y, "
        "spin; free: all six; fixed: none",
        None,
        display="torsion",
    )
    inertia: float | None = quantity(
        "inertia",
        "polar moment of inertia about the spin axis; mass and transverse inertia do not change",
        None,
        minimum=0.0,
        range_words="> 0 for a body that moves, else >= 0",
        display="sum over the gears",
    )
    transverse_inertia: float | None = quantity(
        "inertia",
        "moment of inertia about a diameter through the origin, not through the centre of mass: it includes "
        "mass * center_of_mass^2",
        None,
        minimum=0.0,
        range_words="> mass * center_of_mass^2 with motion: free, else >= 0",
        display="sum over the gears",
    )
    mass: float | None = quantity(
        "mass",
        "mass; if given alone, the centre of mass and the inertia about it remain those of the gears",
        None,
        minimum=0.0,
        range_words="> 0 with motion: planar or free, else >= 0",
        display="sum over the gears",
    )
    center_of_mass: float | Triple | None = key(
        "center",
        "axial position of the centre of mass from the origin, or [x, y, z] along the axes of the body; "
        "if given alone, the gears keep their positions and their transverse inertia is summed about it",
        None,
        dimension="length",
        display="that of the gears",
    )
    inertia_tensor: tuple[float, ...] | None = quantities(
        "inertia",
        "Ixx, Iyy, Izz, Ixy, Iyz, Izx about the centre of mass in the axes of the body, instead of inertia "
        "and transverse_inertia; the products are matrix entries, Ixy = -(sum of m x y)",
        None,
        length=(6, 6),
        display="axisymmetric about z",
    )
    solid: SolidReference | None = component(
        SolidReference,
        "solid of the whole body including its gears; supplies mass, centre of mass and inertia that are not "
        "given",
    )
    position: Triple | None = quantities(
        "length",
        "origin of the body [x, y, z]",
        None,
        length=(3, 3),
        display="from joints, meshes and couplings",
    )
    axes: Axes | None = component(
        Axes,
        "directions of its axes in the world; default: those of a body that its gears mesh with, else those "
        "of the world",
    )
    markers: Mapping[str, Marker] = key("components", "points with axes of their own, by name", {}, of=Marker)
    shapes: Mapping[str, Shape] = key(
        "components", "boxes and bodies of revolution for the scene, by name", {}, of=Shape, later=True
    )
    origin: Triple | None = derived()
    """Origin of the body in the world [m]: as given, or from its joints, meshes and couplings."""
    orientation: Axes | None = derived()
    """Effective axes: as given, or those of a body in mesh; None for those of the world."""
    joint: str | None = derived()
    """Name of the joint that carries the body, if any."""
    shaft: Shaft | None = derived()
    """The elastic shaft that the body represents, if any; its origin is the start of the shaft."""
    elastic: ElasticBody | None = derived()
    """The elastic body that the body represents, if any; its markers are the nodes."""

    stage: str | None = derived()
    """Planetary stage, or path of the scissor gear, that contains the body, if any."""
    of_housing: bool = derived(False)
    """Whether the body is a part of the housing of the model."""

    @property
    def moves(self) -> str:
        """Type of motion: `motion` against ground, or 'joint' for a body on a joint."""
        return "joint" if self.joint is not None else self.motion or "torsion"

    @property
    def stands_in(self) -> bool:
        """Whether the body represents an elastic shaft, elastic body, planet or part of the housing."""
        other = self.shaft or self.elastic or self.stage
        return self.of_housing or other is not None

    @property
    def center(self) -> Triple | None:
        """Given centre of mass relative to the origin, in the axes of the body [m]."""
        given = self.center_of_mass
        return (0.0, 0.0, given) if isinstance(given, int | float) else given

    @property
    def is_round(self) -> bool:
        """Whether the mass distribution is axisymmetric about the z axis."""
        center = self.center
        if self.inertia_tensor is not None:
            return False
        if self.solid is not None:
            from pitchpoint.model.solids import solid_mass

            found = solid_mass(self.solid)
            return found.tensor is None and (center or found.center)[:2] == (0.0, 0.0)
        return center is None or center[:2] == (0.0, 0.0)
