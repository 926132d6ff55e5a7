# SPDX-License-Identifier: Apache-2.0
"""Tables of the stiffness of meshes: of one tooth pair, of the mesh, and about the axes of the gears."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.io.csv_cells import plain_cell
from pitchpoint.io.target import STIFFNESS_HEAD

if TYPE_CHECKING:
    from pitchpoint.contact.mesh_cycle import MeshCycle
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]
COLUMNS = ("stiffness", "torsional_stiffness_1", "torsional_stiffness_2")
UNITS = ("N/m", "N m/rad", "N m/rad")


@dataclass(frozen=True)
class StiffnessTable:
    """Stiffness over a position.

    Parameters
    ----------
    position
        Mesh phase, or position of a tooth pair from A to E, in base pitches, shape (n,).
    stiffness
        Along the base tangent [N/m], shape (n,).
    base_radii
        Base radii of both gears [m]. The torsional stiffness about the axis of a gear, with the other gear
        fixed, is the stiffness times the square of its base radius.
    """

    position: Array
    stiffness: Array
    base_radii: tuple[float, float]

    def columns(self) -> dict[str, Array]:
        """Stiffness [N/m] and torsional stiffness about the axes of gears 1 and 2 [N m/rad]."""
        one, two = (self.stiffness * r * r for r in self.base_radii)
        return dict(zip(COLUMNS, (self.stiffness, one, two), strict=True))


def base_radii(model: Model, mesh: str) -> tuple[float, float]:
    """Base radii of both gears of a mesh, of bevel gears at the mean cone distance [m]."""
    if mesh in model.bevel_meshes:
        pair = model.bevel_pairs[mesh]
        return pair.R_m * math.sin(pair.gear1.delta_b), pair.R_m * math.sin(pair.gear2.delta_b)
    one, two = model.pairs[mesh].gear1, model.pairs[mesh].gear2
    return 0.5 * abs(one.d_b), 0.5 * abs(two.d_b)


def mesh_table(model: Model, mesh: str, cycle: MeshCycle, unit: float | None) -> StiffnessTable | None:
    """Stiffness over the mesh phase; None if the law has no stiffness (`unit` is the reference of ratios)."""
    if unit is None:
        return None
    return StiffnessTable(cycle.phase, cycle.stiffness_ratio * unit, base_radii(model, mesh))


def pair_table(model: Model, mesh: str, points: int) -> StiffnessTable | None:
    """Stiffness of one tooth pair along its path of contact from A to E; None for laws of the whole mesh.

    That of a pair over the whole common width, as for a spur gear; a helical pair enters gradually.
    """
    from pitchpoint.contact.stiffness.description import PairShape
    from pitchpoint.system.rules.bevel_mesh import bevel_stiffness, square_mean
    from pitchpoint.system.rules.stiffness import describe_stiffness

    bevel = mesh in model.bevel_meshes
    law = bevel_stiffness(model, mesh) if bevel else describe_stiffness(model, mesh)
    if not isinstance(law, PairShape) or law.power != 1.0:
        return None
    pair: Any = model.bevel_pairs[mesh] if bevel else model.pairs[mesh]
    whole = law.c_prime * (square_mean(pair) if bevel else pair.b_w)
    position = np.linspace(0.0, pair.eps_alpha, points)
    return StiffnessTable(position, whole * law.along(position, pair.eps_alpha), base_radii(model, mesh))


def csv_text(tables: Sequence[tuple[str, str, StiffnessTable]]) -> str:
    """CSV file of tables, each with the name of its mesh and "mesh" or "pair", one after another."""
    heads = [f"{name} [{unit}]" for name, unit in zip(COLUMNS, UNITS, strict=True)]
    lines = [",".join([STIFFNESS_HEAD, "of", "position [base pitches]", *heads])]
    for mesh, of, table in tables:
        columns = table.columns().values()
        for values in zip(table.position, *columns, strict=True):
            lines.append(f"{plain_cell(mesh)},{of}," + ",".join(f"{float(v):.10g}" for v in values))
    return "\n".join(lines) + "\n"
