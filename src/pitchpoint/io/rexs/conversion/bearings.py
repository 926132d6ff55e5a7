# SPDX-License-Identifier: Apache-2.0
"""Bearings: concept bearings by stiffness, rolling bearings by designation, catalogue data or elements."""

from __future__ import annotations

from typing import Any

import numpy as np

from pitchpoint.core.units import parse_quantity
from pitchpoint.io.rexs.conversion.rolling import CONTACT_DAMPING, TYPES, rolling_rows
from pitchpoint.io.rexs.conversion.state import Conversion, q
from pitchpoint.io.rexs.document import RexsComponent

ROLLING = ("rolling_bearing_with_catalog_geometry", "rolling_bearing_with_detailed_geometry")
RIGID, RIGID_TILT = 1e11, 1e7
"""Stiffness [N/m], [N m/rad] of rigid supports, for which REXS files have 1e15 to 1e23."""
LINEAR_DAMPING = 0.03
"""Default damping ratio of linear bearings."""
SIDES = ("inner_part", "outer_part")
CASING = ("gear_casing",)
HUBS = (
    *("cylindrical_interference_fit", "tapered_interference_fit"),
    *("feather_key_connection", "involute_spline_connection"),
)
"""Connections of shaft and hub."""
COUPLINGS = ("coupling", "switchable_coupling", *HUBS)


def sides_of(conversion: Conversion, part: RexsComponent) -> dict[str, RexsComponent]:
    """Inner and outer part that a bearing or coupling connects."""
    for relation in conversion.source.related("side", assembly=part.id):
        return {
            role: conversion.source.components[relation.roles[role]]
            for role in SIDES
            if role in relation.roles
        }
    return {}


def convert_bearing(conversion: Conversion, bearing: RexsComponent) -> None:
    """Add a bearing between a shaft and the casing or another shaft."""
    found = place_of(conversion, bearing)
    if found is None:
        return
    if bearing.type == "concept_bearing":
        _linear(conversion, bearing, found)
        return
    name = conversion.name(bearing)
    rows = rolling_rows(conversion, bearing, f"rolling_bearings.{name}", _sign(conversion, bearing))
    for k, (offset, values) in enumerate(rows):
        own = name if len(rows) == 1 else conversion.free(f"{name}_{k + 1}")
        place = found if not offset else _beside(conversion, found, offset, own)
        conversion.put("rolling_bearings", bearing, {**place, **values}, own)
        _say_contact_damping(conversion, bearing, own)
    if len(rows) > 1 and "housing" in found:
        body, _, marker = str(found["housing"]).partition(".")
        section = "shafts" if body in conversion.data.get("shafts", {}) else "bodies"
        del conversion.data[section][body]["markers"][marker]
    if rows:
        return
    if bearing.get("radial_stiffness") is not None:
        _linear(conversion, bearing, found)
        conversion.changed(
            bearing,
            "bearing",
            "linear",
            f"bearings.{name}",
            "no data of a rolling bearing, but its stiffness",
        )
    else:
        _without_data(conversion, bearing)


def _beside(conversion: Conversion, found: dict[str, Any], offset: float, name: str) -> dict[str, Any]:
    """Place of a bearing at a distance along the axis from that of the file."""
    place = dict(found)
    place["position"] = [0, 0, _sum(found["position"][2], offset)]
    body, _, marker = str(found.get("housing", "")).partition(".")
    if marker:
        section = "shafts" if body in conversion.data.get("shafts", {}) else "bodies"
        markers = conversion.data[section][body]["markers"]
        x, y, z = markers[marker]["position"]
        markers[name] = {"position": [x, y, _sum(z, offset)]}
        place["housing"] = f"{body}.{name}"
    return place


def _sum(length: Any, offset: float) -> Any:
    return q(parse_quantity(length, "length") + offset, "length")


def _say_contact_damping(conversion: Conversion, bearing: RexsComponent, name: str) -> None:
    target = f"rolling_bearings.{name}.damping"
    conversion.default(bearing, "damping", f"{CONTACT_DAMPING:g} s/m", target, "REXS has no damping")


def place_of(conversion: Conversion, part: RexsComponent) -> dict[str, Any] | None:
    """`body`, `position` and `housing` of a bearing; None with a problem without a shaft."""
    sides = sides_of(conversion, part)
    inner, outer = sides.get("inner_part"), sides.get("outer_part")
    if inner is None or outer is None:
        conversion.problem(part, "connects no two parts", remedy="give a relation 'side' with both parts")
        return None
    keys = ("u_coordinate_on_shaft_inner_side", "u_coordinate_on_shaft_outer_side")
    if inner.id not in conversion.seats and outer.id in conversion.seats:
        inner, outer, keys = outer, inner, (keys[1], keys[0])
    seat = conversion.seats.get(inner.id)
    if seat is None:
        if inner.type == "shaft" and inner.id in conversion.done:
            return None  # the shaft has a problem of its own
        conversion.problem(part, f"is on {inner}, not on a shaft of the model")
        return None
    u = conversion.need(part, keys[0], "mm")
    if u is None:
        return None
    values: dict[str, Any] = {"body": seat.body, "position": [0, 0, q(seat.place(u), "length")]}
    if outer.type in CASING:
        return values
    other = conversion.seats.get(outer.id)
    if other is None:
        if outer.id not in conversion.done:
            conversion.problem(part, f"is on {outer}, not on a shaft of the model")
        return None
    u_other = conversion.number(part, keys[1])
    if u_other is None:
        u_other = other.coordinate(seat.point(u))
    if other.body == seat.body:
        conversion.ignored(part, "all", f"connects parts of the rigid body {seat.body}")
        return None
    section = "shafts" if other.body in conversion.data.get("shafts", {}) else "bodies"
    markers = conversion.data[section][other.body].setdefault("markers", {})
    marker = conversion.name(part)
    markers[marker] = {"position": [0, 0, q(other.place(u_other), "length")]}
    values["housing"] = f"{other.body}.{marker}"
    return values


def centre_of(conversion: Conversion, part: RexsComponent) -> np.ndarray | None:
    """Centre of a bearing or coupling on its shaft in the world [m]; None if it has none."""
    for role, side in sides_of(conversion, part).items():
        seat = conversion.seats.get(side.id)
        u = part.get(f"u_coordinate_on_shaft_{role.removesuffix('_part')}_side")
        if seat is not None and isinstance(u, float):
            return seat.point(u)
    return None


# --- linear bearings ----------------------------------------------------------------------------------------
def stiffness_of(conversion: Conversion, part: RexsComponent, target: str) -> dict[str, float]:
    """Stiffness by direction of a concept bearing or coupling, at most that of a rigid one [SI units]."""
    found = {}
    radial = conversion.flag(part, "radial_force_absorption") is not False
    direction = conversion.word(part, "axial_force_absorption")
    if direction is None and part.type not in COUPLINGS:
        conversion.default(part, "axial_force_absorption", "both_directions", f"{target}.axial")
    axial = direction != "no_direction"
    for key, attribute, limit, carries in (
        ("radial", "radial_stiffness", RIGID, radial),
        ("axial", "axial_stiffness", RIGID, axial),
        ("tilt", "bending_stiffness", RIGID_TILT, True),
        ("torsion", "rotational_stiffness", RIGID_TILT, part.type in COUPLINGS),
    ):
        value = conversion.number(part, attribute, f"{target}.{key}") if carries else None
        unit = "N/m" if limit == RIGID else "N m/rad"
        if value is None and carries and (key in ("radial", "axial") or part.type in COUPLINGS):
            value = limit
            conversion.default(
                part, attribute, f"{limit:g} {unit}", f"{target}.{key}", "rigid in this direction"
            )
        elif value is not None and value > limit:
            reason = f"{value:.4g} {unit} is rigid"
            conversion.changed(part, attribute, f"{limit:g} {unit}", f"{target}.{key}", reason)
            value = limit
        if value:
            found[key] = value
    return found


def stiffness_entry(values: dict[str, float]) -> dict[str, Any]:
    """Stiffness for the model file."""
    return {
        key: q(value, "stiffness" if key in ("radial", "axial") else "torsional_stiffness")
        for key, value in values.items()
    }


def _linear(conversion: Conversion, part: RexsComponent, place: dict[str, Any]) -> None:
    """Add a linear bearing."""
    name = conversion.name(part)
    stiffness = stiffness_of(conversion, part, f"bearings.{name}.stiffness")
    if conversion.word(part, "axial_force_absorption") in ("positive", "negative"):
        conversion.changed(
            part,
            "axial_force_absorption",
            "both directions",
            f"bearings.{name}.stiffness.axial",
            "a linear bearing supports both directions",
        )
    values = {**place, "stiffness": stiffness_entry(stiffness), "damping": {"ratio": LINEAR_DAMPING}}
    conversion.put("bearings", part, values, name)
    conversion.default(
        part, "damping", f"ratio {LINEAR_DAMPING}", f"bearings.{name}.damping", "REXS has no damping"
    )


def _sign(conversion: Conversion, bearing: RexsComponent) -> float:
    """-1 for a bearing on a shaft whose u is opposite to the z axis of its body, else +1."""
    seats = [conversion.seats.get(part.id) for part in sides_of(conversion, bearing).values()]
    return next((seat.sign for seat in seats if seat is not None), 1.0)


def _without_data(conversion: Conversion, bearing: RexsComponent) -> None:
    """Problem of a rolling bearing without sufficient data."""
    text, kind = bearing.get("catalogue_designation"), str(bearing.get("bearing_type"))
    if kind in TYPES or "bearing_type" not in bearing.attributes:
        what = "has no data of a rolling bearing"
    else:
        what = f"is a {kind}, which a model does not have"
    conversion.problem(
        bearing,
        what,
        value=None if text is None else f"{text!r}, which is not in the catalogue,",
        remedy="give a designation of the catalogue, or bearing_type with inner_diameter, outer_diameter, "
        "width, radial_dynamic_load_rating and radial_static_load_rating, or radial_stiffness",
    )


def sum_of_stiffness(parts: list[tuple[dict[str, float], float]]) -> np.ndarray:
    """Stiffness matrix of several bearings at distances along the axis, about their common origin.

    Parameters
    ----------
    parts
        Stiffness by direction, and distance from the origin [m].
    """
    total = np.zeros((6, 6))
    for values, z in parts:
        k, tilt = values.get("radial", 0.0), values.get("tilt", 0.0)
        total[0, 0] += k
        total[1, 1] += k
        total[2, 2] += values.get("axial", 0.0)
        # a rotation about y moves the bearing along x by z, one about x along y by -z
        total[3, 3] += tilt + k * z * z
        total[4, 4] += tilt + k * z * z
        total[0, 4] += k * z
        total[1, 3] -= k * z
        total[5, 5] += values.get("torsion", 0.0)
    return total + np.triu(total, 1).T
