# SPDX-License-Identifier: Apache-2.0
"""Remarks on gear trains that cannot rotate, and on shafts that nothing connects or loads."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import fields, is_dataclass
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import Message, remark
from pitchpoint.core.words import listed
from pitchpoint.model.frames import split
from pitchpoint.model.locked_loops import locked_loops
from pitchpoint.model.speed_ratios import joined

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

NO_MACHINE = (
    "gears",
    "bevel_gears",
    "bodies",
    "shafts",
    "parameters",
    "sensors",
    "blocks",
    "winds",
    "scenarios",
)
"""Sections that connect no bodies."""
NAMING = ("bodies", "ends", "gears", "terms", "body", "housing", "reaction", "hub")
"""Keys of components that name bodies, their gears or joints."""


def contradictory_loops(model: Model) -> Iterator[Message]:
    """Trains that their own ratios lock; with a given speed they are an error."""
    machine: Any = model
    for loop in locked_loops(machine):
        value, limit = loop.words
        one, two = loop.bodies
        yield remark(
            ".".join(map(str, loop.link)),
            f"locks {one} and {two}: {value}, but {limit}; nothing in this loop can rotate",
            "correct a number of teeth, or remove one link of the loop",
        )


def unconnected_shafts(model: Model) -> Iterator[Message]:
    """Bodies that rotate, without any mesh, coupling, load or drive that acts on them or on what they connect
    to.

    Single rotors and models without loads and scenarios are complete without.
    """
    groups = _groups(model)
    if len(groups) < 2 or not (model.loads or model.scenarios):
        return
    acted = {name for part in model.scenarios.values() for name in (*part.speed, *part.hold)}
    acted |= {key.split(".")[0] for part in model.scenarios.values() for key in part.drive}
    acted |= {part.sweep.body for part in model.scenarios.values() if part.sweep is not None}
    for name in ("loads", "actuators", "controllers", "unbalances", "springs", "torsion_springs", "clutches"):
        acted |= {body for part in getattr(model, name).values() for body in named_bodies(model, part)}
    acted |= {seat.joint for seat in model.mechanism.seats.values() if seat.joint in acted and seat.joint}
    for group in groups:
        turning = [
            name
            for name in group
            if "spin" in model.mechanism.seats[name].coordinates
            and (model.bodies[name].gears or model.bodies[name].bevel_gears or name in model.shafts)
        ]
        joints = {str(model.mechanism.seats[name].joint) for name in group}
        if not turning or acted & (group | joints):
            continue
        first = turning[0]
        section = "shafts" if first in model.shafts else "bodies"
        verb = "is" if len(turning) == 1 else "are"
        whom = listed(turning)
        yield remark(
            f"{section}.{first}",
            f"{whom} {verb} not connected with any other shaft, and no load or drive acts on "
            f"{'it' if len(turning) == 1 else 'them'}",
            "add the missing mesh, coupling or load, or remove the shaft",
        )


def _groups(model: Model) -> list[set[str]]:
    """Sets of bodies that any component connects."""
    links = [{seat.body, seat.parent} for seat in model.mechanism.seats.values()]
    for field in fields(model):
        parts = getattr(model, field.name)
        if field.name in NO_MACHINE or not hasattr(parts, "values"):
            continue
        links += [named_bodies(model, part) for part in parts.values() if is_dataclass(part)]
    links += [named_bodies(model, part) for group in model.others.values() for part in group.values()]
    return joined(model.mechanism.seats, links)


def named_bodies(model: Model, part: Any) -> set[str]:
    """Bodies that a component names, directly, by a gear, or by a joint."""
    found = set()
    for key in NAMING:
        value = getattr(part, key, None)
        names: Iterable[Any] = (value,) if isinstance(value, str) else value or ()
        for name in names:
            if not isinstance(name, str):
                continue
            body = model.body_of(name) or split(name)[0]
            joint = model.joints.get(body)
            found |= {split(end)[0] for end in joint.bodies} if joint is not None else {body}
    return found & model.bodies.keys()
