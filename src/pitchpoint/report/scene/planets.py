# SPDX-License-Identifier: Apache-2.0
"""Planets of a model: equal gears that mesh with one gear; their curves belong together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from pitchpoint.model.frames import GROUND, split
from pitchpoint.model.rings import ring_ends
from pitchpoint.viz.scene.content import SceneChannel

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

FEWEST = 3
"""Minimum number of equal gears on one gear that count as planets."""


class Member(NamedTuple):
    """Role of a component among those of all planets, and the number of its planet, from 1."""

    role: str
    planet: int


def planet_members(model: Model) -> dict[str, Member]:
    """Meshes, bodies, bearings and joints that each planet of a set has, by name.

    Parameters
    ----------
    model
        The model.
    """
    sets: dict[tuple[str, ...], list[tuple[str, list[str]]]] = {}
    for partner in model.gears:
        for meshes in _equal_meshes(model, partner).values():
            bodies = tuple(b for b in model.bodies if b in meshes)
            if len(bodies) >= FEWEST:
                sets.setdefault(bodies, []).append((partner, [meshes[b] for b in bodies]))
    sets = {b: p for b, p in sets.items() if len(p) > 1 or _carrier(model, b)}
    found: dict[str, Member] = {}
    for k, (bodies, partners) in enumerate(sets.items(), start=1):
        stage = model.bodies[bodies[0]].stage
        word = "planets" if len(sets) == 1 else f"planets of {stage or f'set {k}'}"
        for partner, names in partners:
            for number, name in enumerate(names, start=1):
                found.setdefault(name, Member(f"{word} with {partner}", number))
        for number, body in enumerate(bodies, start=1):
            found.setdefault(body, Member(word, number))
            for role, name in _carrying(model, body):
                found.setdefault(name, Member(f"{role} of {word}", number))
    for name, part in model.planetary_stages.items():  # in series: each planet meets one inner planet
        for group in part.groups:
            if group.side == "planet" and len(group.names) >= FEWEST:
                for number, mesh in enumerate(group.names, start=1):
                    found[mesh] = Member(f"planets of {name} with {group.mate}", number)
    return found


def _equal_meshes(model: Model, partner: str) -> dict[object, dict[str, str]]:
    """Meshes of a gear with gears of equal data on different bodies: by these data, mesh by body."""
    found: dict[object, dict[str, str]] = {}
    for name, mesh in model.meshes.items():
        if partner not in mesh.gears:
            continue
        other = mesh.gears[1 - mesh.gears.index(partner)]
        body, gear = model.body_of(other), model.gears[other]
        if body is not None:
            data = (gear.number_of_teeth, gear.normal_module, gear.face_width, gear.type)
            found.setdefault(data, {}).setdefault(body, name)
    return found


def _carrier(model: Model, bodies: Sequence[str]) -> str | None:
    """Body that carries all of several bodies by a joint or a bearing each; None for ground."""
    carriers = [
        {
            other
            for ends in (
                *(joint.bodies for joint in model.joints.values()),
                *(ring_ends(part) for part in model.rolling_bearings.values()),
                *(ring_ends(part) for part in model.plain_bearings.values()),
                *((part.body, part.housing or GROUND) for part in model.bearings.values()),
            )
            if body in (names := [split(end)[0] for end in ends])
            for other in names
            if other not in (body, GROUND)
        }
        for body in bodies
    ]
    common = set.intersection(*carriers)
    return min(common) if common else None


def _carrying(model: Model, body: str) -> list[tuple[str, str]]:
    """Bearings and joints of a planet, each with its role."""
    linear = [n for n, part in model.bearings.items() if part.body == body]
    ends = {
        **{n: ring_ends(part) for n, part in model.rolling_bearings.items()},
        **{n: ring_ends(part) for n, part in model.plain_bearings.items()},
        **{n: part.ends for n, part in model.bushings.items()},
    }
    others = [n for n, named in ends.items() if body in {split(end)[0] for end in named}]
    joints = [n for n, part in model.joints.items() if body in {split(end)[0] for end in part.bodies}]
    bearings = [*linear, *others]
    many = len(bearings) > 1
    found = [(f"bearings {k}" if many else "bearings", n) for k, n in enumerate(bearings, start=1)]
    return found + [("pins", n) for n in joints]


def grouped(channels: Sequence[SceneChannel], model: Model) -> list[SceneChannel]:
    """Channels with the names of their groups, for those that all planets of a set have.

    Parameters
    ----------
    channels
        Channels of a result.
    model
        Its model.
    """
    members = planet_members(model)
    found = []
    for channel in channels:
        quantity, _, rest = channel.name.partition("[")
        item, dot, part = rest.rstrip("]").partition(".")
        role = members.get(item)
        if role is None:
            found.append(channel)
            continue
        label = channel.label.replace(item, role.role, 1)
        # the same quantity of other components of the same name has another unit
        group = f"{quantity}[{role.role}{dot}{part}]"
        found.append(replace(channel, group=group, group_label=label, planet=role.planet))
    return found
