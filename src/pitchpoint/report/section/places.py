# SPDX-License-Identifier: Apache-2.0
"""Positions of gears and bodies along their axes: those of the model, or schematic ones next to each other.

Models that need torques only often give no positions: gears of one body, or coaxial bodies, then cover each
other. Gears in mesh get a common plane, and planes and bodies without gears follow each other in the order of
the power flow.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations
from typing import TYPE_CHECKING, Any

from pitchpoint.model.frames import GROUND, body_frame
from pitchpoint.report.scene.gear_room import seated
from pitchpoint.report.section.axes import Line

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

GAP = 0.6
"""Gap between schematic planes, relative to the mean face width."""
COVER = 0.25
"""Share of the narrower width by which gears may cover each other before the positions become schematic."""


@dataclass
class Positions:
    """Positions along the axes [m].

    Attributes
    ----------
    starts
        Position of the origin of every body along its axis.
    gears
        Middle of every gear along its axis.
    schematic
        Whether the positions are not those of the model.
    """

    starts: dict[str, float]
    gears: dict[str, float] = field(default_factory=dict)
    schematic: bool = False


def flow_order(model: Model, bodies: Sequence[str], first: str | None) -> list[str]:
    """Bodies in the order of the power flow from the input.

    Parameters
    ----------
    model
        The model.
    bodies
        The bodies.
    first
        The input; None for the first body.
    """
    from pitchpoint.model.mechanism import base_of
    from pitchpoint.model.speed_ratios import links_of

    machine: Any = model
    near: dict[str, list[str]] = {name: [] for name in bodies}
    pairs = [(one, two) for _, one, two, _ in links_of(machine)]
    pairs += [(base_of(model, model.mechanism, name), name) for name in bodies]
    pairs += [(c.bodies[0], c.bodies[1]) for c in model.clutches.values() if len(c.bodies) == 2]
    for one, two in pairs:
        if one in near and two in near and one != GROUND:
            near[one].append(two)
            near[two].append(one)
    found: dict[str, None] = {}
    for root in [*([first] if first in near else []), *bodies]:
        queue = deque([root])
        while queue:
            here = queue.popleft()
            if here in found:
                continue
            found[here] = None
            queue.extend(near[here])
    return list(found)


def positions_of(model: Model, lines: Sequence[Line], order: Sequence[str]) -> Positions:
    """Positions of the model, or schematic ones if gears cover each other.

    Parameters
    ----------
    model
        The model.
    lines
        The axes with the bodies to draw.
    order
        Bodies in the order of the power flow.
    """
    starts, gears = {}, {}
    for line in lines:
        for body, sign in line.bodies.items():
            origin, _ = body_frame(model, body)
            starts[body] = 0.0 if origin is None else float(origin @ line.way)
            for name, room in seated(model, body).items():
                gears[name] = starts[body] + sign * room.middle
    found = Positions(starts, gears)
    if model.bevel_gears or not any(_cover(model, line, gears) for line in lines):
        return found
    return _schematic(model, found, order)


def _cover(model: Model, line: Line, gears: Mapping[str, float]) -> bool:
    """Whether external gears of an axis, or internal ones, cover each other."""
    for internal in (False, True):
        names = [
            g
            for body in line.bodies
            for g in model.bodies[body].gears
            if model.gears[g].geometry.is_internal == internal
        ]
        for one, two in combinations(names, 2):
            widths = [model.gears[g].face_width for g in (one, two)]
            shared = 0.5 * sum(widths) - abs(gears[one] - gears[two])
            if shared > COVER * min(widths):
                return True
    return False


def _schematic(model: Model, found: Positions, order: Sequence[str]) -> Positions:
    """Planes of meshing gears and bodies without gears, one after the other."""
    planes: list[set[str]] = [{g} for g in found.gears]
    for mesh in model.meshes.values():
        joined = [p for p in planes if p & {*mesh.gears}]
        planes = [p for p in planes if not p & {*mesh.gears}] + [set().union(*joined)]
    widths = [gear.face_width for gear in model.gears.values()]
    gap = GAP * sum(widths) / len(widths)
    at, gears, starts = 0.0, dict(found.gears), dict(found.starts)
    done: set[int] = set()
    for body in order:
        own = [p for p in planes if p & {*model.bodies[body].gears}]
        if not own:
            starts[body] = at + 0.5 * gap
            at += 2.0 * gap
        for plane in own:
            if id(plane) in done:
                continue
            done.add(id(plane))
            wide = max(model.gears[g].face_width for g in plane)
            gears |= dict.fromkeys(plane, at + 0.5 * wide)
            at += wide + gap
    for body in order:
        mine = [gears[g] for g in model.bodies[body].gears]
        if mine:
            starts[body] = sum(mine) / len(mine)
    return Positions(starts, gears, schematic=True)


def span(values: Iterable[float], default: float = 0.0) -> tuple[float, float]:
    """Smallest and largest of some numbers."""
    known = list(values)
    return (min(known), max(known)) if known else (default, default)
