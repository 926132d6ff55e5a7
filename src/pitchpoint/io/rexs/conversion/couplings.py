# SPDX-License-Identifier: Apache-2.0
"""Couplings between two shafts, and between a shaft and the casing; switched ones only if engaged."""

from __future__ import annotations

from typing import Any

from pitchpoint.io.rexs.conversion.bearings import (
    CASING,
    COUPLINGS,
    LINEAR_DAMPING,
    RIGID,
    RIGID_TILT,
    sides_of,
    stiffness_entry,
    stiffness_of,
)
from pitchpoint.io.rexs.conversion.frames import frame_of
from pitchpoint.io.rexs.conversion.hubs import fixed_gear, frame_of_hub
from pitchpoint.io.rexs.conversion.shafts import axes_of, sections_of
from pitchpoint.io.rexs.conversion.state import Conversion, Seat, q, vector
from pitchpoint.io.rexs.document import RexsComponent

__all__ = ["COUPLINGS", "convert_coupling", "convert_held_shaft", "engaged"]


def engaged(conversion: Conversion, coupling: RexsComponent) -> bool:
    """Whether a coupling is engaged in the gear of the gear unit; those without a switch are."""
    states = conversion.value(coupling, "is_engaged")
    if coupling.type != "switchable_coupling" or states is None:
        if coupling.type == "switchable_coupling":
            conversion.default(coupling, "is_engaged", "engaged", "", "it has no states")
        return True
    if not isinstance(states, tuple):
        return bool(states)
    index = 1
    for unit in conversion.source.of_type("gear_unit"):
        number = conversion.value(unit, "gear_shift_index")
        index = number if isinstance(number, int) else 1
    if not 1 <= index <= len(states):
        limit = f"1 to {len(states)}, the number of its states"
        what = "is the gear_shift_index of the gear unit"
        conversion.problem(coupling, what, "is_engaged", str(index), limit, "give a state for every gear")
        return False
    return bool(states[index - 1])


def holding(conversion: Conversion, shaft: RexsComponent) -> list[RexsComponent]:
    """Engaged couplings that hold a shaft rigidly in the casing, in all directions."""
    found = []
    for coupling in conversion.source.of_type(*COUPLINGS):
        sides = sides_of(conversion, coupling)
        grounded = any(part.type in CASING for part in sides.values())
        if (
            shaft.id not in [p.id for p in sides.values()]
            or not grounded
            or not engaged(conversion, coupling)
        ):
            continue
        limits = {"radial": RIGID, "axial": RIGID, "bending": RIGID_TILT, "rotational": RIGID_TILT}
        values = {key: coupling.get(f"{key}_stiffness") for key in limits}
        if all(v is None or float(v) >= limits[key] for key, v in values.items()):  # type: ignore[arg-type]
            found.append(coupling)
    return found


def convert_held_shaft(conversion: Conversion, shaft: RexsComponent) -> None:
    """Add a shaft that is held rigidly in the casing, such as that of a fixed ring, as a fixed body."""
    couplings = holding(conversion, shaft)
    frame = frame_of(conversion, shaft)
    if not couplings or frame is None:
        return
    name = conversion.name(shaft)
    sections = sections_of(conversion, shaft)
    frame, sign = conversion.aligned(frame)
    conversion.put("bodies", shaft, {"motion": "fixed", "position": vector(frame.origin), **axes_of(frame)})
    conversion.seats[shaft.id] = Seat(name, 0.0, frame, sections, sign)
    conversion.done.update(material.id for material in conversion.referenced(shaft, "material"))
    reason = f"held rigidly in the casing by {couplings[0]}"
    conversion.changed(shaft, "shaft_section", "fixed body", f"bodies.{name}", reason)
    for part in conversion.source.of_type(*COUPLINGS, "concept_bearing"):
        sides = [side.id for side in sides_of(conversion, part).values()]
        if shaft.id in sides and any(conversion.source.components[i].type in CASING for i in sides):
            conversion.ignored(part, "all", f"within the fixed body {name}")


def convert_coupling(conversion: Conversion, coupling: RexsComponent) -> None:
    """Add a coupling: between shafts as such, to the casing as a bearing that also holds the rotation."""
    if fixed_gear(conversion, coupling):
        return
    if not engaged(conversion, coupling):
        conversion.ignored(coupling, "all", "not engaged in the gear of the file")
        return
    sides = sides_of(conversion, coupling)
    if len(sides) < 2:
        conversion.problem(coupling, "connects no two parts", remedy="give a relation 'side' with both parts")
        return
    inner, outer = sides["inner_part"], sides["outer_part"]
    key = "u_coordinate_on_shaft_inner_side"
    if inner.id not in conversion.seats:
        inner, outer, key = outer, inner, "u_coordinate_on_shaft_outer_side"
    seat = conversion.seats.get(inner.id)
    if seat is None:
        if inner.id not in conversion.done:
            conversion.problem(coupling, f"is on {inner}, not on a shaft of the model")
        return
    other = conversion.seats.get(outer.id)
    if other is not None and other.body == seat.body:
        conversion.ignored(coupling, "all", f"connects parts of the rigid body {seat.body}")
        return
    u = conversion.number(coupling, key)
    if u is None:
        frame = frame_of_hub(conversion, coupling)
        u = 0.0 if frame is None else seat.coordinate(frame.origin)
        conversion.default(coupling, key, str(q(u, "length")), "", "from its position")
    grounded = outer.type in CASING
    section = "bearings" if grounded else "couplings"
    name = conversion.name(coupling)
    stiffness = stiffness_of(conversion, coupling, f"{section}.{name}.stiffness")
    place = [0, 0, q(seat.place(u), "length")]
    values: dict[str, Any] = {"stiffness": stiffness_entry(stiffness), "damping": {"ratio": LINEAR_DAMPING}}
    if grounded:
        conversion.put("bearings", coupling, {"body": seat.body, "position": place, **values}, name)
    elif other is None:
        if outer.id not in conversion.done:
            conversion.problem(coupling, f"is on {outer}, not on a shaft of the model")
        return
    else:
        bodies = [seat.body, other.body]
        conversion.put("couplings", coupling, {"bodies": bodies, "position": place, **values}, name)
    conversion.default(
        coupling, "damping", f"ratio {LINEAR_DAMPING}", f"{section}.{name}.damping", "REXS has no damping"
    )
