# SPDX-License-Identifier: Apache-2.0
"""Note on mean loads of planets over a part of a turn of their carrier."""

from __future__ import annotations

import math
from collections.abc import Container, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import Message, note
from pitchpoint.model.components.law import Constant
from pitchpoint.model.frames import body_frame

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

WHOLE = 0.02
"""Turns of the carrier by which a window may differ from whole turns."""
STILL = 1e-3
"""Turns of the carrier up to which it is at rest."""
ACROSS = 1e-6
"""Component of gravity across the axis of the carrier, over gravity, from which it counts."""


def window_notes(
    model: Model | None, statistics: Mapping[str, Mapping[str, Any]], window: float
) -> tuple[Message, ...]:
    """Notes on stages whose planets go round under gravity or lateral forces for a part of a turn.

    Each planet has its largest and its smallest load once per turn of the carrier, so that means over a part
    of a turn depend on this part.

    Parameters
    ----------
    model
        The computed model; None: no notes.
    statistics
        Statistics by channel, with the `mean` of the speeds.
    window
        Length of the window of the statistics [s].
    """
    found = []
    for name, stage in model.planetary_stages.items() if model is not None else ():
        assert model is not None
        body = turning_body(model, stage.carrier, "speed", statistics)
        what = _lateral(model, stage.carrier)
        if body is None or not what:
            continue
        turns = abs(float(statistics[f"speed[{body}]"]["mean"])) * window / math.tau
        if not math.isfinite(turns) or turns <= STILL:  # a run may end before its window begins
            continue
        if abs(turns - round(turns)) <= WHOLE and turns > 0.5:
            continue
        found.append(
            note(
                f"the statistics are those of {turns:.3g} turns of {body}; under {what} the loads of the "
                "planets vary over a turn, so that their means and K_γ depend on the window",
                f"planetary_stages.{name}",
                remedy="take the largest K_γ at a carrier position, or use a window of whole turns",
            )
        )
    return tuple(found)


def turning_body(model: Model, carrier: str, kind: str, channels: Container[str]) -> str | None:
    """Body with the channel `kind` of a carrier: itself, or the one to which it is fixed; None if at rest."""
    seats = model.mechanism.seats
    name = carrier
    while f"{kind}[{name}]" not in channels:
        seat = seats.get(name)
        if seat is None or seat.coordinates:
            return None
        name = seat.parent
    return name


def _lateral(model: Model, carrier: str) -> str:
    """Weight across the axis of a carrier, and forces on bodies, in words; "" without effect."""
    if not any({"x", "y"} & set(seat.coordinates) for seat in model.mechanism.seats.values()):
        return ""
    words = []
    if model.gravity is not None and any(model.gravity):
        weight = np.array(model.gravity, dtype=float)
        along = float(weight @ body_frame(model, carrier)[1][:, 2])
        across = float(np.linalg.norm(weight)) ** 2 - along**2
        words += ["weight"] if across > (ACROSS * float(np.linalg.norm(weight))) ** 2 else []
    if any(_acts(load) for load in model.loads.values()):
        words.append("forces")
    return " and ".join(words)


def _acts(load: Any) -> bool:
    """Whether a load is a force or moment other than zero."""
    parts = (*(load.force or ()), *(load.moment or ()))
    return any(not isinstance(part, Constant) or part.value != 0.0 for part in parts)
