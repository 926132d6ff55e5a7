# SPDX-License-Identifier: Apache-2.0
"""An elastic body from finite-element matrices."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from pitchpoint.model.components.marker import Axes, Marker, Triple
from pitchpoint.model.keys import boolean, component, integer, key, positive, quantities, quantity

MOST_MODES = 30
"""Modes that one elastic body can have."""


@dataclass(frozen=True, kw_only=True)
class ElasticBody:
    """An unsupported elastic body that moves through space and bends in a few of its modes.

    Joints and forces hold it at nodes, named elsewhere as BODY.NODE.
    """

    file: str | None = key(
        "file",
        "matrices of the finite elements: a NumPy archive (.npz) with K, M and places, or a Nastran punch "
        "file with the matrices KAAX and MAAX and the GRID points; in SI units",
        None,
    )
    stiffness_file: str | None = key(
        "file", "instead of file: the stiffness matrix as a Matrix Market file (.mtx, .mtx.gz)", None
    )
    mass_file: str | None = key("file", "and the mass matrix, likewise", None)
    place_file: str | None = key(
        "file",
        "and a table of the nodes, one per line in the order of the matrices: x y z in m, and the digits of "
        "their displacements (123 translations, 456 turns) where they are neither 123 nor 123456 throughout",
        None,
    )
    spin_stiffness_file: str | None = key(
        "file",
        "and what a spin about the z axis of the file adds to the stiffness, per (rad/s)^2: the stress "
        "stiffness of its loads at 1 rad/s; in an archive it is K_spin",
        None,
    )
    nodes: Mapping[str, Marker] = key(
        "components",
        "nodes for joints and forces by name, with their places in the axes of the file",
        of=Marker,
    )
    rotor: bool = boolean(
        "whether it turns about the z axis of its axes as a shaft does: its turns are counted, it can be "
        "driven, and what is fixed to its nodes can carry gears and run in bearings",
        False,
    )
    static_shapes: bool = boolean(
        "whether the modes hold every shape into which forces at the nodes can bend the body, six fewer than "
        "the nodes have displacements, and the rest of them the lowest with the nodes held",
        False,
    )
    modes: int | None = integer(
        "number of modes, the lowest ones", None, minimum=1, maximum=MOST_MODES, one_of="count"
    )
    below: float | None = positive(
        "frequency", "instead of a number: all modes up to this frequency, 30 at most", None, one_of="count"
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
        Axes, "directions of the axes of the file in the world; without them those of the world"
    )

    @property
    def files(self) -> tuple[str, ...]:
        """One file, or those of K, M, the places and what a spin adds."""
        if self.file is not None:
            return (self.file,)
        given = (self.stiffness_file, self.mass_file, self.place_file, self.spin_stiffness_file)
        return tuple(f for f in given if f is not None)
