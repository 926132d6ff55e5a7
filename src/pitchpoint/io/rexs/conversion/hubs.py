# SPDX-License-Identifier: Apache-2.0
"""Connections of shaft and hub: gears fixed to their shaft, and couplings between two shafts."""

from __future__ import annotations

from pitchpoint.io.rexs.conversion.bearings import HUBS, sides_of
from pitchpoint.io.rexs.conversion.frames import Frame, frame_of
from pitchpoint.io.rexs.conversion.state import Conversion
from pitchpoint.io.rexs.document import RexsComponent

GEARS = ("cylindrical_gear", "ring_gear", "bevel_gear")


def shaft_of(conversion: Conversion, part: RexsComponent) -> RexsComponent | None:
    """Shaft of a gear: its assembly, or the other side of its connection, such as a press fit."""
    found = conversion.owner(part, "shaft")
    return found if found is not None else _by_hub(conversion, part)


def shaft_of_gear(conversion: Conversion, gear: RexsComponent) -> RexsComponent | None:
    """Shaft of a gear; None with a problem if it has none."""
    shaft = shaft_of(conversion, gear)
    if shaft is None:
        conversion.problem(
            gear, "is on no shaft", remedy="give a relation 'assembly' of a shaft with this gear"
        )
    return shaft


def _by_hub(conversion: Conversion, part: RexsComponent) -> RexsComponent | None:
    for role in ("outer_part", "inner_part"):
        for relation in conversion.source.related("side", **{role: part.id}):
            hub = conversion.source.components.get(relation.roles.get("assembly", -1))
            if hub is None or hub.type not in HUBS:
                continue
            for other in sides_of(conversion, hub).values():
                if other.type == "shaft":
                    return other
    return None


def gears_on(conversion: Conversion, shaft: RexsComponent, *types: str) -> list[RexsComponent]:
    """Gears of a shaft, also those on a press fit, a key or a spline."""
    types = types or GEARS
    found = conversion.parts(shaft, *types)
    for hub in conversion.source.of_type(*HUBS):
        sides = sides_of(conversion, hub).values()
        if shaft.id in [one.id for one in sides]:
            found += [one for one in sides if one.type in types and one not in found]
    return found


def fixed_gear(conversion: Conversion, hub: RexsComponent) -> bool:
    """Whether a connection fixes a gear to its shaft, or is part of another connection: then it is listed."""
    if hub.type not in HUBS:
        return False
    outer = conversion.owner(hub, *HUBS)
    if outer is not None:
        conversion.ignored(hub, "all", f"part of {outer}")
        return True
    gears = [one for one in sides_of(conversion, hub).values() if one.type in GEARS]
    if not gears:
        return False
    conversion.done.add(hub.id)
    used = {(hub.id, name) for name in hub.attributes}
    conversion.used |= used
    reason = "gears are fixed rigidly to their shaft"
    conversion.changed(hub, "stiffness", "rigid", f"gears.{conversion.name(gears[0])}", reason)
    return True


def frame_of_hub(conversion: Conversion, hub: RexsComponent) -> Frame | None:
    """Frame of a connection, of a spline without its own that of the teeth of the shaft."""
    found = frame_of(conversion, hub)
    if found is not None:
        return found
    for relation in conversion.source.related("stage", stage=hub.id):
        teeth = conversion.source.components.get(relation.roles.get("gear_1", -1))
        if teeth is not None:
            return frame_of(conversion, teeth)
    return None
