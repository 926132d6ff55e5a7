# SPDX-License-Identifier: Apache-2.0
"""Start values of joints that a run does not begin with, in words."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import Message
from pitchpoint.core.units import format_quantity
from pitchpoint.model.components.joint import COORDINATES, RATES

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.system.system import State, System

SAME = 1e-6
"""Difference from a given value up to which it counts as held [m, rad, m/s, rad/s], as in closing loops."""
WHY = {
    "start": "loads, loops and drives decide; start: assembled in the scenario keeps what joints give",
    "speed": "speeds of the scenario and ratios of teeth decide",
}


def given_starts(model: Model, key: str) -> Iterator[tuple[str, str, str, float]]:
    """Joint, its coordinate, the name that the system gives it, and the value, for all that joints give.

    Parameters
    ----------
    model
        The model.
    key
        "start" for values of coordinates, "speed" for their rates.
    """
    for seat in model.mechanism.seats.values():
        if seat.joint is None:
            continue
        values = getattr(model.joints[seat.joint], key)
        words = COORDINATES[seat.kind] or seat.coordinates
        for word, own in zip(words, seat.coordinates, strict=True):
            if own in values:
                yield seat.joint, own, f"{seat.body}.{word}", values[own]


def start_notes(system: System, state: State, driven: Collection[int]) -> tuple[Message, ...]:
    """A note on every start value or rate of a joint that the run does not begin with.

    Parameters
    ----------
    system
        The system.
    state
        Where the run begins.
    driven
        Coordinates whose motion is prescribed; what they cannot begin with is known without a run
        (`model.keys_without_effect`).
    """
    model = system.model
    if model is None:
        return ()
    found = []
    turns = {int(spin): 2.0 * np.pi * state.turns[body] for spin, body in system.program["spins"]}
    for key in ("start", "speed"):
        for joint, word, name, value in given_starts(model, key):
            k = system.layout.coordinate(name)
            if k in driven:
                continue
            at = float(state.v[k] if key == "speed" else state.q[k] + turns.get(k, 0.0))
            tumbled = key == "start" and _tumbled(system, state, name)
            if abs(at - value) <= SAME and not tumbled:
                continue
            dimension = model.joints[joint].dimension(word)
            unit = RATES[dimension] if key == "speed" else dimension
            now = "elsewhere" if tumbled else f"at {format_quantity(round(at, 9) + 0.0, unit, 4)}"
            found.append(
                Message(
                    f"joints.{joint}.{key}",
                    f"{word} begins {now}, not at {format_quantity(value, unit, 4)}: {WHY[key]}",
                    line=model.line(("joints", joint, key)),
                    kind="note",
                )
            )
    return tuple(found)


def _tumbled(system: System, state: State, name: str) -> bool:
    """Whether the turns of a body count from another attitude than that of the file."""
    number = system.layout.bodies.index(name.rpartition(".")[0])
    chart = int(system.program["body"]["chart"][number])
    return chart >= 0 and not np.allclose(state.charts[chart], np.eye(3))
