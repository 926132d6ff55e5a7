# SPDX-License-Identifier: Apache-2.0
"""Notes on redundant and contradictory constraint rows of a run."""

from __future__ import annotations

import numpy as np

from pitchpoint.core.errors import Message, note
from pitchpoint.core.status import INCONSISTENT, OK
from pitchpoint.system import evaluate
from pitchpoint.system.source import row_source, row_unit
from pitchpoint.system.system import System
from pitchpoint.system.workspace import FACTORISATIONS

ROW_TOLERANCE = 1e-5
"""Residual of a redundant row [rad, m] from which it contradicts the rows enforced by explicit methods."""


def redundant_rows(system: System) -> tuple[str, ...]:
    """Names of the redundant rows; none before the first factorisation in the workspace."""
    w = system.workspace
    if system.sizes["nc"] == 0 or w.clock[FACTORISATIONS] == 0:
        return ()
    return tuple(system.layout.rows[r] for r in np.flatnonzero(w.arrays["used"] == 0))


def row_notes(system: System) -> tuple[Message, ...]:
    """Notes on redundant rows."""
    names = redundant_rows(system)
    loops = [name.removeprefix("closure ") for name in names if name.startswith("closure ")]
    others = [name for name in names if not name.startswith("closure ")]
    found = []
    if loops:
        found.append(
            note(
                "redundant with other joints: the motion is the same without, but the distribution of the "
                "reactions is not unique",
                ", ".join(loops),
            )
        )
    if others:
        found.append(note("redundant with other prescribed motions, without load", ", ".join(others)))
    return tuple(found)


def rows_agree(system: System, t: float) -> int:
    """Status of the redundant rows at the state in the workspace: INCONSISTENT if one is violated."""
    w = system.workspace
    if not redundant_rows(system):
        return OK
    evaluate.residual(system, evaluate.store(system, t))
    broken = np.flatnonzero((w.arrays["used"] == 0) & (np.abs(w.g) > ROW_TOLERANCE))
    if broken.size:
        w.ctl[0]["bad"] = broken[0]
        return INCONSISTENT
    return OK


def explain(system: System, status: int) -> str:
    """Sentence for a status, with the element or the constraint row that reported it if one did."""
    text = evaluate.explain(system, status)
    row = int(system.workspace.ctl[0]["bad"])
    if status == INCONSISTENT and 0 <= row < system.sizes["nc"]:
        off = f"{abs(system.workspace.g[row]):.3g}{row_unit(system, row)}"
        text += f" ({row_source(system, row)} is off by {off})"
    return text
