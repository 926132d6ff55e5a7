# SPDX-License-Identifier: Apache-2.0
"""Meshes of a system, of cylindrical and bevel gears alike: solvers and pages ask for them here.

Records of both kinds have the same names for what solvers read (`elements/bevel_mesh_record.py`). Meshes
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


def force_directions(record: np.void) -> NDArray[np.float64]:
    """Directions of the circumferential, radial and axial force on gear 2 of an evaluated mesh, rows."""
    if is_bevel(record):
        return np.array((record["t"], record["away"][1], record["axis"][1]))
    return np.array([record[field] for field in "tem"])


def mesh_names(system: System) -> tuple[str, ...]:
    """Names of all meshes, as in the observations."""
    found = []
    for kind, k in mesh_places(system):
        given = system.names.get(kind, ())
        found.append(given[k] if k < len(given) else f"{kind}{k}")
    return tuple(found)
