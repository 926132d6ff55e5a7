# SPDX-License-Identifier: Apache-2.0
"""Counters of the contact solver, and remarks on the contact of tooth surfaces after a computation."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.contact.potential_table import BEYOND_APPROACH, BEYOND_CENTRE, BEYOND_MISALIGNMENT
from pitchpoint.contact.unilateral_work import CONTACT_STATE
from pitchpoint.core.errors import Message, note
from pitchpoint.elements.mesh.surface.scratch import state_offset
from pitchpoint.system.meshes import is_bevel, mesh_names, mesh_places

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from pitchpoint.system.system import System

COUNTERS = ("newton", "factorisations", "pivoted", "blocks", "singles")
"""Counters of the contact solver since the compilation; `pivoted`: solutions that required pivoting."""
AXES = {
    BEYOND_APPROACH: "approach",
    BEYOND_MISALIGNMENT: "misalignment",
    BEYOND_CENTRE: "centre distance",
}


def solver_counters(record: np.void, pool: NDArray[np.float64]) -> dict[str, int]:
    """Counters of one mesh whose flexible contact is solved in the run; empty for all others.

    Parameters
    ----------
    record
        Record of the mesh.
    pool
        Pool of its kind, shape (n,).
    """
    if is_bevel(record) or not record["is_flexible"] or record["is_tabulated"]:
        return {}
    first = state_offset(record)
    state = pool[first : first + CONTACT_STATE.itemsize // 8].view(CONTACT_STATE)[0]
    return {name: int(state[name]) for name in COUNTERS}


def contact_counters(system: System) -> dict[str, dict[str, int]]:
    """Counters of the contact solver of all meshes with flexible contact."""
    found = {}
    for name, (kind, k) in zip(mesh_names(system), mesh_places(system), strict=True):
        counters = solver_counters(system.records[kind][k], system.pools.get(kind, np.zeros(0)))
        if counters:
            found[name] = counters
    return found


def counter_notes(system: System) -> tuple[Message, ...]:
    """A note with the counters of every mesh with flexible contact."""
    return tuple(
        note(
            f"contact solver of mesh {name}: {found['newton']} Newton steps, {found['factorisations']} "
            f"factorisations, {found['pivoted']} solutions by pivoting ({found['singles']} exchanges of "
            "single nodes)"
        )
        for name, found in contact_counters(system).items()
    )


def table_remarks(system: System) -> tuple[Message, ...]:
    """A note for every mesh whose flanks in contact have left the range of its contact table."""
    found = []
    for name, (kind, k) in zip(mesh_names(system), mesh_places(system), strict=True):
        record = system.records[kind][k]
        if is_bevel(record) or not record["is_tabulated"] or not record["beyond"]:
            continue
        axes = [word for bit, word in AXES.items() if int(record["beyond"]) & bit]
        found.append(
            note(
                f"mesh {name} left the range of its contact table: {' and '.join(axes)}, and forces "
                "there continue linearly",
                remedy="compute a table with a wider range",
            )
        )
    return tuple(found)


def flank_remarks(system: System) -> tuple[Message, ...]:
    """All notes on the contact of tooth surfaces after a time response."""
    return (*table_remarks(system), *counter_notes(system))
