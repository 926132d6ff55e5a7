# SPDX-License-Identifier: Apache-2.0
"""Housing of a gearbox: rigid on mounts, a stiffness matrix between the seats, or a body of the model."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar, TypeAlias

from pitchpoint.model.component import Component
from pitchpoint.model.components.marker import Axes, Triple
from pitchpoint.model.components.six import Damping6, Stiffness6
from pitchpoint.model.keys import component, integer, key, positive, quantities, quantity, text

PARTS = "bodies fixed in the housing, such as that of a ring gear"


@dataclass(frozen=True, kw_only=True)
class Mount(Component):
    """Foot or rubber mount between a rigid housing and ground."""

    position: Triple = quantities("length", "position in the world", length=(3, 3))
    stiffness: Stiffness6 = component(
        Stiffness6, "stiffness along and about the axes of the world", Stiffness6()
    )
    damping: Damping6 | None = component(Damping6, "damping in the same directions; not a ratio")


@dataclass(frozen=True, kw_only=True)
class Foot(Component):
    """Foot of a housing matrix, fixed to ground or on an elastic support."""

    position: Triple = quantities("length", "position in the world", length=(3, 3))
    stiffness: Stiffness6 | None = component(
        Stiffness6, "stiffness of the support along and about the axes of the matrix; default: fixed"
    )


@dataclass(frozen=True, kw_only=True)
class RigidHousing(Component):
    """Rigid housing: ground, or with a mass a rigid body on mounts."""

    type: ClassVar[str] = "rigid"

    mass: float | None = positive("mass", "mass without shafts", None, display="fixed to ground")
    center_of_mass: Triple = quantities(
        "length", "centre of mass in the world", (0.0, 0.0, 0.0), length=(3, 3)
    )
    inertia_tensor: tuple[float, ...] | None = quantities(
        "inertia",
        "Ixx, Iyy, Izz, Ixy, Iyz, Izx about the centre of mass in the axes of the world; the products are "
        "matrix entries, Ixy = -(sum of m x y)",
        None,
        length=(6, 6),
        needs="mass",
    )
    mounts: Mapping[str, Mount] = key("components", "mounts on ground, by name", {}, of=Mount, also=("feet",))
    parts: tuple[str, ...] = key("names", PARTS, (), names="bodies")


@dataclass(frozen=True, kw_only=True)
class HousingMatrix(Component):
    """Elastic housing as a stiffness matrix between the seats of the bearings."""

    type: ClassVar[str] = "stiffness_matrix"

    stiffness_file: str = key(
        "file",
        "stiffness matrix in SI units: CSV (.csv, .txt), Matrix Market (.mtx, .mtx.gz) or NumPy (.npy, .npz "
        "with one array); displacements x, y, z, then rotations about x, y, z of each node",
    )
    nodes: tuple[str, ...] = key(
        "names", "nodes in the order of the matrix: names of bearings, feet and parts", length=(1, 1000)
    )
    rows_per_node: int = integer(
        "rows of the matrix per node: 6, or 3 without rotations, whose seats do not tilt",
        6,
        minimum=3,
        maximum=6,
    )
    mass_file: str | None = key("file", "mass matrix of the same nodes, formats as for stiffness_file", None)
    damping_file: str | None = key("file", "damping matrix of the same nodes [N s/m, ...]", None)
    stiffness_damping: float = quantity(
        "time", "factor of the stiffness matrix in the damping matrix", 0.0, minimum=0.0
    )
    axes: Axes | None = component(Axes, "axes of the matrix in the world; default: those of the world")
    feet: Mapping[str, Foot] = key(
        "components", "feet among the nodes, by name", {}, of=Foot, also=("mounts",)
    )
    parts: tuple[str, ...] = key("names", PARTS, (), names="bodies")


@dataclass(frozen=True, kw_only=True)
class HousingBody(Component):
    """Housing that is a body of the model, such as an elastic body from finite-element matrices.

    A bearing is at the node (marker) of its own name, otherwise at the nearest one; of a body without
    markers anywhere.
    """

    type: ClassVar[str] = "body"

    body: str = text("name in bodies or elastic_bodies", names="bodies")
    within: float = positive(
        "length",
        "elastic body: maximum distance of the nearest node from a bearing without a node of its name",
        1e-3,
    )
    parts: tuple[str, ...] = key("names", PARTS, (), names="bodies")


HOUSINGS = {one.type: one for one in (RigidHousing, HousingMatrix, HousingBody)}
"""Class of each type of housing."""
Housing: TypeAlias = RigidHousing | HousingMatrix | HousingBody
