# SPDX-License-Identifier: Apache-2.0
"""Loads and motions of bodies in directions in which the bodies cannot move."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message
from pitchpoint.multibody.bodies import FIXED, PLANAR, TORSION
from pitchpoint.system.system import System

Array = NDArray[np.float64]

NOTHING = 1e-9
"""Motion of a body per unit of a coordinate [m, rad] that counts as round-off."""
HOW = {
    FIXED: "is fixed",
    TORSION: "only rotates about its axis",
    PLANAR: "moves only in its plane",
}
"""Motion of bodies on ground in words."""
MORE = {FIXED: "torsion, planar or free", TORSION: "planar or free", PLANAR: "free"}
"""Key `motion` of bodies that move more."""


def missing_motions(
    system: System, motions: Array, names: Sequence[str], words: Sequence[str], kind: str
) -> list[Message]:
    """Problems of names of loads or motions in directions in which their body does not move.

    Parameters
    ----------
    system
        The system.
    motions
        Motion of all bodies per unit of each coordinate, shape (nd, nb, 6).
    names
        Names `BODY.WORD`, or `unbalance[BODY]`.
    words
        Words of the six directions.
    kind
        "input" or "output".
    """
    free = np.abs(motions).max(axis=0) > NOTHING
    problems = []
    for name in names:
        body, _, word = name.rpartition(".")
        unbalance = name.startswith("unbalance[")
        body = name[len("unbalance[") : -1] if unbalance else body
        b = system.layout.bodies.index(body)
        if free[b, :3].any() if unbalance else free[b, words.index(word)]:
            continue
        motion = system.bodies[b - 1].motion if system.bodies[b - 1].parent == 0 else -1
        how = f"{body} {HOW.get(motion, 'does not move in this direction')}"
        effect = "excites nothing" if kind == "input" else "is always zero"
        others = [f"{body}.{w}" for w, there in zip(words, free[b], strict=True) if there]
        remedy = f"use {', '.join(others)}, or give" if others else "give"
        more = f"more freedom (motion: {MORE[motion]}, or a joint)" if motion in MORE else "another joint"
        problems.append(Message(name, f"{effect}, since {how}", remedy=f"{remedy} the body {more}"))
    return problems
