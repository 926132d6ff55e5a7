# SPDX-License-Identifier: Apache-2.0
"""Draft of a REXS model: components, relations, and the list of what REXS cannot express."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.io.rexs import tables
from pitchpoint.io.rexs.conversion.frames import TO_MODEL
from pitchpoint.io.rexs.document import RexsAttribute, RexsComponent, RexsRelation, Value

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from pitchpoint.model.model import Model

MILLI = 1e-3
"""Length of the vectors of directions [m]: 1 mm, because REXS gives them in mm."""
OWN = "custom_pitchpoint_"
"""Beginning of the ids of values that REXS does not define."""


@dataclass(frozen=True)
class Omission:
    """Something of the model that is not in the file, or not as in the model.

    Attributes
    ----------
    where
        Key of the model file.
    reason
        What is missing, and why.
    """

    where: str
    reason: str

    def __str__(self) -> str:
        """Key and reason."""
        return f"{self.where}: {self.reason}"


@dataclass
class Draft:
    """What the exporters of the parts share.

    Attributes
    ----------
    model
        The model.
    shafts, stages, gears, meshes, supports, loads
        Components by the names of the bodies, planetary stages, gears, meshes, bearings with couplings, and
        loads.
    """

    model: Model
    components: dict[int, RexsComponent] = field(default_factory=dict)
    relations: list[RexsRelation] = field(default_factory=list)
    omissions: list[Omission] = field(default_factory=list)
    unit: int = 0
    casing: int = 0
    shafts: dict[str, int] = field(default_factory=dict)
    stages: dict[str, int] = field(default_factory=dict)
    gears: dict[str, int] = field(default_factory=dict)
    meshes: dict[str, int] = field(default_factory=dict)
    supports: dict[str, int] = field(default_factory=dict)
    loads: dict[str, int] = field(default_factory=dict)
    materials: dict[Any, int] = field(default_factory=dict)

    def add(self, type: str, name: str = "", **values: Value | None) -> int:
        """Add a component with values in SI units; its id is returned. Values of None are omitted."""
        id = len(self.components) + 1
        given = {key: attribute(key, value, type) for key, value in values.items() if value is not None}
        self.components[id] = RexsComponent(id, type, name, given)
        return id

    def part(self, type: str, name: str, of: int, **values: Value | None) -> int:
        """Add a component as a part of another one."""
        id = self.add(type, name, **values)
        self.relate("assembly", assembly=of, part=id)
        return id

    def custom(self, id: int, name: str, value: Value, unit: str) -> None:
        """Add a value that REXS does not define, in a unit of REXS, under an id of pitchpoint."""
        key, one = OWN + name, self.components[id]
        given = {**one.attributes, key: RexsAttribute(key, None, value, key, unit)}
        self.components[id] = replace(one, attributes=given)

    def relate(self, type: str, order: int | None = None, **roles: int) -> None:
        """Add a relation."""
        self.relations.append(RexsRelation(len(self.relations) + 1, type, roles, order))

    def omit(self, where: str, reason: str) -> None:
        """List something that the file does not have."""
        found = Omission(where, reason)
        if found not in self.omissions:
            self.omissions.append(found)

    def place(self, body: str) -> dict[str, Value]:
        """Values of the position of a body."""
        return placed(*self.frame(body), self.unit)

    def frame(self, body: str) -> tuple[np.ndarray, np.ndarray]:
        """Origin [m] and axes (3, 3) of a body in the world."""
        from pitchpoint.model.frames import frame

        found = self.model.bodies[body]
        origin = np.zeros(3) if found.origin is None else np.array(found.origin)
        return origin, np.eye(3) if found.orientation is None else frame(found.orientation)

    def material(self, material: Any) -> int:
        """Component of a material, one for all parts of the same material."""
        key = (material.youngs_modulus, material.poisson_ratio, material.density)
        if key not in self.materials:
            names = ("elastic_modulus", "poisson_ratio", "density")
            values = {n: float(v) for n, v in zip(names, key, strict=True)}
            self.materials[key] = self.add("material", str(material.name or "material"), **values)
        return self.materials[key]


def attribute(name: str, value: Value, type: str) -> RexsAttribute:
    """Value under an id of the newest version of REXS.

    Raises
    ------
    KeyError
        If REXS has no such id.
    """
    known = tables.definition(tables.NEWEST, name, type)
    if known is None or tables.newest(known.number).id != name:
        raise KeyError(f"{name} of {type}")
    return RexsAttribute(name, known.number, value, name, known.unit)


def placed(origin: np.ndarray, axes: np.ndarray, reference: int) -> dict[str, Value]:
    """Values of a position in the gear unit.

    Parameters
    ----------
    origin, axes
        Origin [m] and axes x, y, z as columns, in the world of the model.
    reference
        Id of the gear unit.
    """
    return {
        "reference_component_for_position": reference,
        "support_vector": uvw(origin),
        "u_axis_vector": uvw(MILLI * axes[:, 2]),
        "w_axis_vector": uvw(MILLI * axes[:, 0]),
    }


def uvw(vector: ArrayLike) -> tuple[float, float, float]:
    """Vector of the model along u, v, w of the gear unit.

    Examples
    --------
    >>> uvw([1.0, 2.0, 3.0])
    (3.0, -2.0, 1.0)
    """
    u, v, w = (float(x) + 0.0 for x in TO_MODEL @ np.asarray(vector, float))
    return u, v, w
