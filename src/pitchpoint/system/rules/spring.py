# SPDX-License-Identifier: Apache-2.0
"""Springs, dampers and Maxwell elements as records."""

from __future__ import annotations

from typing import Any

import numpy as np

from pitchpoint.elements import coupling, maxwell, spring_damper, torsion_maxwell
from pitchpoint.elements import signal as sig
from pitchpoint.model.components.law import Law
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bank import Law as Function
from pitchpoint.system.rules.load import set_signal
from pitchpoint.system.rules.places import Places

TURN = 2.0 * np.pi


def spring_bank(places: Places) -> Bank:
    """Springs and dampers along lines; the default free length is the distance as assembled."""
    springs = places.model.springs
    pool, rows = sig.Pool(), []
    laws: list[Function | None] = []
    for name, part in springs.items():
        row = np.zeros(1, spring_damper.RECORD)[0]
        places.mark(row, part.ends)
        one, two = (places.world(end) for end in part.ends)
        row["free"] = np.linalg.norm(one - two) if part.free_length is None else part.free_length
        row["k"], row["d"] = part.stiffness, part.damping
        laws.append(_parallel_law(row, pool, part.force, f"springs.{name}.force"))
        rows.append(row)
    return pack(
        "spring_damper", spring_damper.RECORD, rows, list(springs), pool=pool.array(), laws=tuple(laws)
    )


def _parallel_law(row: Any, pool: sig.Pool, law: Law | None, where: str) -> Function | None:
    """Set the law in parallel with stiffness and damping; a Python function is also passed the rate."""
    function = None if law is None else set_signal(row, pool, law, where)
    if row["form"] == sig.LAW:
        row["over"] = sig.OVER_BOTH
    return function


def maxwell_bank(places: Places) -> Bank:
    """Maxwell elements along lines."""
    elements = places.model.maxwells
    rows = []
    for name, part in elements.items():
        row = np.zeros(1, maxwell.RECORD)[0]
        places.mark(row, part.ends)
        row["k"] = places.state(name)
        row["stiffness"], row["damping"] = part.stiffness, part.damping
        rows.append(row)
    return pack("maxwell", maxwell.RECORD, rows, list(elements))


def torsion_spring_bank(places: Places) -> Bank:
    """Torsion springs and dampers; only tables over 2 pi are periodic, others are constant at their ends."""
    springs = places.model.torsion_springs
    pool, rows, laws = sig.Pool(), [], []
    for name, part in springs.items():
        row = np.zeros(1, coupling.RECORD)[0]
        places.pair(row, part.bodies)
        row["k"], row["d"], row["u0"], row["gap"] = part.stiffness, part.damping, part.angle, part.play
        laws.append(_parallel_law(row, pool, part.torque, f"torsion_springs.{name}.torque"))
        if row["form"] == sig.TABLE and row["period"] != TURN:
            row["period"] = 0.0
        rows.append(row)
    return pack("coupling", coupling.RECORD, rows, list(springs), pool=pool.array(), laws=tuple(laws))


def torsion_maxwell_bank(places: Places) -> Bank:
    """Maxwell elements in torsion."""
    elements = places.model.torsion_maxwells
    rows = []
    for name, part in elements.items():
        row = np.zeros(1, torsion_maxwell.RECORD)[0]
        places.pair(row, part.bodies)
        row["k"] = places.state(name)
        row["stiffness"], row["damping"] = part.stiffness, part.damping
        rows.append(row)
    return pack("torsion_maxwell", torsion_maxwell.RECORD, rows, list(elements))
