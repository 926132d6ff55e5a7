# SPDX-License-Identifier: Apache-2.0
"""An elastic body from finite-element matrices."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.components.marker import Axes, Marker, Triple
from pitchpoint.model.keys import boolean, component, integer, key, positive, quantities, quantity

MAX_MODES = 30
"""Maximum number of modes of one elastic body."""


@dataclass(frozen=True, kw_only=True)
class ElasticBody(Component):
    """An elastic body with free boundaries: large rigid-body motion and deformation in a few of its modes.

    Joints and forces act at its nodes, referred to as BODY.NODE.
    """

    file: str | None = key(
        "file",
        "finite-element matrices: a NumPy archive (.npz) with K, M and places, or a Nastran punch file with "
        "the matrices KAAX and MAAX and the GRID points; in SI units",
        None,
    )
    stiffness_file: str | None = key(
        "file", "instead of file: stiffness matrix as a Matrix Market file (.mtx, .mtx.gz)", None
    )
    mass_file: str | None = key("file", "with stiffness_file: mass matrix as a Matrix Market file", None)
    place_file: str | None = key(
        "file",
        "with stiffness_file: table of the nodes, one per line in the order of the matrices: x y z in m, "
        "then the digits of their degrees of freedom (123 translations, 456 rotations) unless all are 123 "
        "or all 123456",
        None,
    )
    spin_stiffness_file: str | None = key(
        "file",
        "with stiffness_file: stress stiffness (centrifugal stiffening) of a spin about the z axis of the "
        "file, per (rad/s)^2; K_spin in an archive",
        None,
    )
    nodes: Mapping[str, Marker] = key(
        "components",
        "nodes for joints and forces, by name, with positions in the axes of the file",
        of=Marker,
    )
    rotor: bool = boolean(
        "rotor: spins about its z axis like a shaft; its revolutions are counted, it can be driven, and "
        "bodies fixed to its nodes can carry gears and run in bearings",
        False,
    )
    static_shapes: bool = boolean(
        "includes the static deflection shapes of all forces at the nodes (six fewer than the nodes have "
        "degrees of freedom); the other modes are the lowest with fixed nodes (Craig-Bampton)",
        False,
    )
    modes: int | None = integer(
        "number of modes, lowest first", None, minimum=1, maximum=MAX_MODES, one_of="count"
    )
    below: float | None = positive(
        "frequency", "instead of modes: all modes up to this frequency, at most 30", None, one_of="count"
    )
    damping_ratio: float = quantity(
        "dimensionless", "damping ratio of every mode", 0.0, minimum=0.0, maximum=1.0
    )
    position: Triple | None = quantities(
        "length",
        "origin of the file in the world [x, y, z]",
        None,
        length=(3, 3),
        display="from joints",
    )
    axes: Axes | None = component(
        Axes, "directions of the axes of the file in the world; default: those of the world"
    )

    @property
    def files(self) -> tuple[str, ...]:
        """The one file, or the files of stiffness, mass, nodes and stress stiffness."""
        if self.file is not None:
            return (self.file,)
        given = (self.stiffness_file, self.mass_file, self.place_file, self.spin_stiffness_file)
        return tuple(f for f in given if f is not None)
