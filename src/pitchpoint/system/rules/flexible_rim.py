# SPDX-License-Identifier: Apache-2.0
"""Flexible rims of internal gears: hidden bodies of their coordinates, inertia, stiffness and shapes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.flexible_body import GROUP, LOADS, flexible_row, modal_bodies
from pitchpoint.elements.kind import RIM
from pitchpoint.elements.mesh.flexible_rim import rim_room
from pitchpoint.model.rims import rim_modes, ring_section
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.ring_modes import ring_invariants, ring_terms

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

SPIN = 5
"""Load with geometric stiffness: square of the spin about the z axis."""


@dataclass(frozen=True)
class RimParts:
    """Bodies and records of one flexible rim.

    Parameters
    ----------
    name
        Name of the element.
    gear
        Name of the gear.
    bodies
        Hidden bodies of the modal coordinates.
    flexible, guides
        Records of the kinds flexible_body and guide.
    """

    name: str
    gear: str
    bodies: tuple[Body, ...]
    flexible: NDArray[np.void]
    guides: NDArray[np.void]


def rims_of(model: Model, body: str) -> list[str]:
    """Gears with flexible rims on a body."""
    if body in model.shafts or body in model.elastic_bodies:
        return []
    return [gear for gear in model.bodies[body].gears if model.gears[gear].flexible_rim is not None]


def rim_count(model: Model, body: str) -> int:
    """Number of hidden bodies of the flexible rims of a body; they follow it in the records."""
    return sum(_groups(model, gear) for gear in rims_of(model, body))


def _groups(model: Model, gear: str) -> int:
    return -(-2 * len(rim_modes(model.gears[gear])) // GROUP)


def hidden_of(model: Model, body: str, gear: str, number: int) -> tuple[int, ...]:
    """Numbers of the hidden bodies of a rim; `number` is that of its body."""
    first = number + 1
    for other in rims_of(model, body):
        count = _groups(model, other)
        if other == gear:
            return tuple(range(first, first + count))
        first += count
    return ()


def rim_parts(model: Model, body: str, number: int) -> Iterator[RimParts]:
    """Bodies and records of all flexible rims of a body with this number."""
    for name in rims_of(model, body):
        gear = model.gears[name]
        modes = rim_modes(gear)
        hidden = hidden_of(model, body, name, number)
        words = [f"{word}{mode.waves}" for mode in modes for word in ("cos", "sin")]
        bodies, guides = modal_bodies(f"{name}.rim", len(words), hidden[0], words)
        stiffness = np.repeat([m.stiffness for m in modes], 2)
        mass = np.repeat([m.mass for m in modes], 2)
        damping = 2.0 * (gear.flexible_rim.damping_ratio if gear.flexible_rim else 0.0)
        stiffening = np.zeros((LOADS, mass.size, mass.size))
        stiffening[SPIN] = np.diag(np.repeat([m.stretch for m in modes], 2))
        row = flexible_row(
            ring_invariants(modes),
            stiffness,
            frame=number,
            hidden=hidden,
            damping=damping * np.sqrt(stiffness * mass),
            stiffening=stiffening,
        )
        yield RimParts(f"{name}.rim", name, tuple(bodies), row, guides)


def rims(model: Model, numbers: Mapping[str, int]) -> list[RimParts]:
    """All flexible rims of a model."""
    return [part for body in model.mechanism.seats for part in rim_parts(model, body, numbers[body])]


def set_rim(row: Any, model: Model, name: str, keep: Callable[[NDArray[np.float64]], int]) -> None:
    """Set the fields of the flexible rim of gear 2 of a mesh record; unchanged for a rigid rim."""
    gear = model.meshes[name].gears[1]
    modes = rim_modes(model.gears[gear])
    if not modes:
        return
    terms = ring_terms(modes, ring_section(model.gears[gear]).radius)
    row["n_rim"], row["rim"] = 2 * len(modes), keep(rim_room(terms))
    hidden = hidden_of(model, str(model.body_of(gear)), gear, int(row["j"]))
    for field, number in zip(RIM[2:], hidden, strict=False):
        row[field] = number
