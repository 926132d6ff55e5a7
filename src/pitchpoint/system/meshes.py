# SPDX-License-Identifier: Apache-2.0
"""Access to the meshes of a system, cylindrical and bevel gears, for solvers and reports.

Fields that solvers read have the same names in the records of both kinds (`elements/mesh/bevel/record.py`).
Meshes are numbered over the kinds in alphabetical order, like their observations and event functions.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.kind import MESH

if TYPE_CHECKING:
    from pitchpoint.system.system import System


def mesh_places(system: System) -> list[tuple[str, int]]:
    """Kind and record number of each mesh."""
    return [(kind, k) for kind in system.kinds(MESH) for k in range(system.records[kind].size)]


def mesh_records(system: System) -> list[np.void]:
    """Records of all meshes, as views: writing to them changes the system."""
    return [system.records[kind][k] for kind, k in mesh_places(system)]


def mesh_record(system: System, mesh: int) -> np.void:
    """Record of one mesh, as a view: writing to it changes the system."""
    kind, k = mesh_places(system)[mesh]
    return system.records[kind][k]


def one_mesh(system: System, mesh: int) -> dict[str, slice]:
    """Selection of records with one mesh: {kind: slice}."""
    kind, k = mesh_places(system)[mesh]
    return {kind: slice(k, k + 1)}


def forget_contacts(system: System) -> None:
    """Delete what the contact of tooth surfaces keeps between evaluations: same input, same bits."""
    for record in mesh_records(system):
        if not is_bevel(record):
            record["n_slots"], record["beyond"], record["tip_share"] = -1, 0, -1.0


def is_bevel(record: np.void) -> bool:
    """Whether a record is that of a bevel mesh."""
    return "apex" in (record.dtype.names or ())


def shared_width(record: np.void) -> tuple[float, float]:
    """Ends of the common face width of an evaluated mesh [m].

    Measured from the pitch point along parallel axes; for bevel gears from the mean cone distance (constant).
    """
    part = record if is_bevel(record) else record["now"]
    return float(part["z_lo"]), float(part["z_hi"])


def force_directions(record: np.void) -> NDArray[np.float64]:
    """Directions of tangential, radial and axial force on gear 2 of an evaluated mesh, rows of (3, 3)."""
    now = record["now"]
    if is_bevel(record):
        return np.array((now["t"], now["away"][1], now["axis"][1]))
    return np.array([now[field] for field in "tem"])


def mesh_names(system: System) -> tuple[str, ...]:
    """Names of all meshes, as in the observations."""
    found = []
    for kind, k in mesh_places(system):
        given = system.names.get(kind, ())
        found.append(given[k] if k < len(given) else f"{kind}{k}")
    return tuple(found)
