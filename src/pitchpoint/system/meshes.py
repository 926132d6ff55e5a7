# SPDX-License-Identifier: Apache-2.0
"""Meshes of a system, of cylindrical and bevel gears alike, as solvers and reports use them.

Records of both kinds have the same names for what solvers read (`elements/mesh/bevel/record.py`). Meshes
count through the kinds in alphabetical order, as their observations and event functions do.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.kind import MESH

if TYPE_CHECKING:
    from pitchpoint.system.system import System


def mesh_places(system: System) -> list[tuple[str, int]]:
    """Kind and number of the record of every mesh."""
    return [(kind, k) for kind in system.kinds(MESH) for k in range(system.records[kind].size)]


def mesh_records(system: System) -> list[np.void]:
    """Records of all meshes; what is written into them goes to the system."""
    return [system.records[kind][k] for kind, k in mesh_places(system)]


def mesh_record(system: System, mesh: int) -> np.void:
    """Record of one mesh; what is written into it goes to the system."""
    kind, k = mesh_places(system)[mesh]
    return system.records[kind][k]


def one_mesh(system: System, mesh: int) -> dict[str, slice]:
    """One mesh as a choice of records."""
    kind, k = mesh_places(system)[mesh]
    return {kind: slice(k, k + 1)}


def is_bevel(record: np.void) -> bool:
    """Whether a mesh is one of bevel gears."""
    return "apex" in (record.dtype.names or ())


def shared_width(record: np.void) -> tuple[float, float]:
    """Ends of the face width that both gears share, of an evaluated mesh [m].

    They count from the pitch point along parallel axes; of bevel gears, whose faces do not move, from the
    mean cone distance.
    """
    part = record if is_bevel(record) else record["now"]
    return float(part["z_lo"]), float(part["z_hi"])


def force_directions(record: np.void) -> NDArray[np.float64]:
    """Directions of the circumferential, radial and axial force on gear 2 of an evaluated mesh, rows."""
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
