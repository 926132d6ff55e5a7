# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings by designation, by load ratings, or by their rolling elements; bearings of two rows."""

from __future__ import annotations

import math
import re
from typing import Any

from pitchpoint.core.errors import PitchpointError
from pitchpoint.core.units import parse_quantity
from pitchpoint.io.rexs.conversion.state import Conversion, q
from pitchpoint.io.rexs.document import RexsComponent

TYPES = {
    "radial_grooved_ball_bearing": "deep_groove_ball",
    "angular_contact_ball_bearing": "angular_contact_ball",
    "radial_self_aligning_ball_bearing": "self_aligning_ball",
    "axial_grooved_ball_bearing": "thrust_ball",
    "radial_roller_bearing": "cylindrical_roller",
    "radial_needle_roller_bearing": "needle_roller",
    "radial_tapered_roller_bearing": "tapered_roller",
    "radial_self_aligning_roller_bearing": "spherical_roller",
}
"""Type of the model file for each `bearing_type`; the others have no rolling elements in a model."""
CONTACT_DAMPING = 2.0
"""Default: damping over elastic force of rolling bearings [s/m]."""
SINGLE_ROW = ("tapered_roller", "angular_contact_ball")
"""Types that support one axial direction: two directions require a pair."""
PAIR = {"tapered_roller": 7.0 / 9.0, "angular_contact_ball": 0.7}
"""Exponent of 2 in the dynamic load rating of a pair over that of one bearing (ISO 281)."""


Row = tuple[float, dict[str, Any]]
"""Distance of a bearing from the place of the file along z [m], and its data for the model file."""


def rolling_rows(conversion: Conversion, bearing: RexsComponent, path: str, sign: float = 1.0) -> list[Row]:
    """Data of a rolling bearing for the model file, without its place; empty if they are not sufficient.

    By designation if the catalogue has it, else by type, dimensions and load ratings, else by elements. A
    bearing of two rows that support one direction each is a pair of bearings, as is one by elements.

    Parameters
    ----------
    conversion, bearing
        The conversion and the bearing.
    path
        Key of the bearing in the model file.
    sign
        -1 if u of its shaft is opposite to the z axis of its body.
    """
    values = _by_designation(conversion, bearing, path) or _by_ratings(conversion, bearing, path)
    both = bearing.get("axial_force_absorption") == "both_directions"
    if values is not None and both and bearing.get("number_of_bearing_rows") == 2 and _single(values):
        return _pair(conversion, bearing, path, sign, values)
    if values is not None and _possible(values):
        rows: list[Row] = [(0.0, values)]
    else:
        rows = _by_elements(conversion, bearing, path, sign)
    for _, data in rows:
        _add_details(conversion, bearing, (path, sign, len(rows) == 1), data)
    return rows


def _add_details(
    conversion: Conversion, bearing: RexsComponent, how: tuple[str, float, bool], values: dict[str, Any]
) -> None:
    """Add axial support, clearance, preload and damping."""
    path, sign, alone = how
    absorption = conversion.word(bearing, "axial_force_absorption", f"{path}.axial_force_absorption")
    if sign < 0.0:
        absorption = _OPPOSITE.get(absorption or "", absorption)
    if absorption is not None and alone and _takes_absorption(values, absorption):
        values["axial_force_absorption"] = absorption
    elif absorption is not None and alone:
        target, reason = (
            f"{path}.axial_force_absorption",
            f"a bearing of this type does not support {absorption}",
        )
        conversion.changed(bearing, "axial_force_absorption", "that of its type", target, reason)
    clearance = conversion.number(bearing, "operating_radial_bearing_clearance", f"{path}.clearance")
    if clearance is not None:
        values["clearance"] = q(clearance, "length")
    preload = conversion.number(bearing, "preload_force", f"{path}.preload")
    if preload:
        values["preload"] = q(preload, "force")
    values["damping"] = CONTACT_DAMPING


def _single(values: dict[str, Any]) -> bool:
    """Whether a bearing is of a type that supports one axial direction."""
    from pitchpoint.geometry.bearings.designation import by_designation

    if "designation" in values:
        return str(by_designation(values["designation"]).kind) in SINGLE_ROW
    return values.get("type") in SINGLE_ROW


def _pair(
    conversion: Conversion, bearing: RexsComponent, path: str, sign: float, values: dict[str, Any]
) -> list[Row]:
    """Two bearings in X or O arrangement: of load ratings each has its share of those of the pair."""
    text = str(bearing.get("catalogue_designation") or "").upper()
    face = bool(re.search(r"(^|[^A-Z])DF([^A-Z]|$)", text))
    width = conversion.number(bearing, "width") or 0.0
    shared = dict(values)
    if "designation" not in values:
        exponent = PAIR[str(values["type"])]
        dynamic = conversion.number(bearing, "radial_dynamic_load_rating") or 0.0
        static = conversion.number(bearing, "radial_static_load_rating") or 0.0
        shared["width"] = q(0.5 * width, "length")
        shared["radial_dynamic_load_rating"] = q(dynamic / 2.0**exponent, "force")
        shared["radial_static_load_rating"] = q(0.5 * static, "force")
        if not _possible(shared | {"axial_force_absorption": "positive"}):
            return []
    name = "X" if face else "O"
    reason = f"two rows in {name} arrangement, each with its share of the load ratings of the pair"
    conversion.changed(bearing, "number_of_bearing_rows", "2 bearings", path, reason)
    # face to face, the row at the smaller z supports the shaft against motion towards smaller z
    ends = ("negative", "positive") if face else ("positive", "negative")
    rows = []
    for side, direction in zip((-1.0, 1.0), ends, strict=True):
        data = {**shared, "axial_force_absorption": direction}
        _add_details(conversion, bearing, (path, sign, False), data)
        rows.append((side * 0.25 * width, data))
    return rows


def _possible(values: dict[str, Any]) -> bool:
    """Whether rolling elements follow from the data of a bearing."""
    if "designation" in values:
        return True
    single = values.get("type") in SINGLE_ROW and "axial_force_absorption" not in values
    return _has_geometry(values | ({"axial_force_absorption": "positive"} if single else {}))


def _has_geometry(values: dict[str, Any]) -> bool:
    from pitchpoint.model.components.rolling_bearing import RollingBearing

    numbers = {
        key: parse_quantity(value, _DIMENSIONS[key]) if key in _DIMENSIONS else value
        for key, value in values.items()
    }
    try:
        RollingBearing(body="shaft", **({"clearance": 0.0} | numbers)).geometry  # noqa: B018
    except PitchpointError:
        return False
    return True


_DIMENSIONS = {
    **dict.fromkeys(("inner_diameter", "outer_diameter", "width"), "length"),
    **dict.fromkeys(("element_diameter", "pitch_diameter", "effective_length"), "length"),
    **dict.fromkeys(("radial_dynamic_load_rating", "radial_static_load_rating"), "force"),
    "contact_angle": "angle",
}
_OPPOSITE = {"positive": "negative", "negative": "positive"}


def _takes_absorption(values: dict[str, Any], absorption: str) -> bool:
    """Whether a bearing of these data can support axial forces as given; else its type determines it."""
    return _has_geometry(values | {"axial_force_absorption": absorption})


def _by_designation(conversion: Conversion, bearing: RexsComponent, path: str) -> dict[str, Any] | None:
    text = bearing.get("catalogue_designation")
    if not isinstance(text, str):
        return None
    from pitchpoint.geometry.bearings.designation import by_designation

    plain = re.sub(r"\s+", " ", text).strip()
    try:
        by_designation(plain)
    except PitchpointError:
        return None
    conversion.value(bearing, "catalogue_designation", f"{path}.designation")
    return {"designation": plain}


def _by_ratings(conversion: Conversion, bearing: RexsComponent, path: str) -> dict[str, Any] | None:
    kind = TYPES.get(str(bearing.get("bearing_type")))
    load = "axial" if kind == "thrust_ball" else "radial"
    keys = {
        "inner_diameter": ("inner_diameter", "length"),
        "outer_diameter": ("outer_diameter", "length"),
        "width": ("width", "length"),
        "radial_dynamic_load_rating": (f"{load}_dynamic_load_rating", "force"),
        "radial_static_load_rating": (f"{load}_static_load_rating", "force"),
    }
    if kind is None or any(not bearing.get(attribute) for attribute, _ in keys.values()):
        return None
    values: dict[str, Any] = {"type": kind}
    conversion.value(bearing, "bearing_type", f"{path}.type")
    for key, (attribute, dimension) in keys.items():
        values[key] = q(conversion.number(bearing, attribute, f"{path}.{key}") or 0.0, dimension)
    if kind in ("tapered_roller", "spherical_roller", "self_aligning_ball", "angular_contact_ball"):
        angle = _angle(conversion, bearing, path)
        if angle:
            values["contact_angle"] = q(angle, "angle")
    return values


def _angle(conversion: Conversion, bearing: RexsComponent, path: str) -> float | None:
    """Contact angle of the rows, else by the factor e of the catalogue: tan(alpha) = e/1.5 [rad]."""
    for row in conversion.parts(bearing, "rolling_bearing_row"):
        angle = conversion.number(row, "pressure_angle", f"{path}.contact_angle")
        if angle is not None:
            return abs(angle)
    e = conversion.number(bearing, "catalogue_value_e", f"{path}.contact_angle")
    return None if e is None else math.atan(e / 1.5)


def _by_elements(conversion: Conversion, bearing: RexsComponent, path: str, sign: float) -> list[Row]:
    """Bearings by the rolling elements of one or two rows; empty if they are not sufficient."""
    rows = conversion.parts(bearing, "rolling_bearing_row")
    if len(rows) not in (1, 2):
        return []
    found = [_row(conversion, bearing, row, (path, sign)) for row in rows]
    data = [one for one in found if one is not None]
    if len(data) < len(rows):
        return []
    if len(data) == 1:
        return [(0.0, data[0])]
    apart = conversion.number(bearing, "distance_between_bearing_rows")
    if apart is None:
        apart = 0.5 * (conversion.number(bearing, "width") or 0.0)
        conversion.default(bearing, "distance_between_bearing_rows", str(q(apart, "length")), path, "width/2")
    reason = "a bearing for each row of rolling elements"
    conversion.changed(bearing, "number_of_bearing_rows", "2 bearings", path, reason)
    return [(sign * side * 0.5 * apart, one) for side, one in zip((-1.0, 1.0), data, strict=True)]


def _row(
    conversion: Conversion, bearing: RexsComponent, row: RexsComponent, how: tuple[str, float]
) -> dict[str, Any] | None:
    """Data of one row of rolling elements."""
    path, sign = how
    elements = conversion.parts(row, "rolling_element")
    others = conversion.parts(bearing, "rolling_bearing_row")
    if not elements and row is not others[0]:
        elements = conversion.parts(others[0], "rolling_element")
        conversion.default(row, "rolling_element", f"those of {others[0]}", path)
    number = row.get("number_of_rolling_elements") or len(elements)
    diameter = next((e.get("diameter_of_rolling_element") for e in elements), None)
    length = next((e.get("length_of_rolling_element") for e in elements), None)
    bounds = [bearing.get(key) for key in ("inner_diameter", "outer_diameter")]
    pitch = row.get("reference_diameter_rolling_bearing")
    if pitch is None and None not in bounds:
        pitch = 0.5 * (float(bounds[0]) + float(bounds[1]))  # type: ignore[arg-type]
        conversion.default(
            row,
            "reference_diameter_rolling_bearing",
            str(q(pitch, "length")),
            f"{path}.pitch_diameter",
            "(d + D)/2",
        )
    if not isinstance(number, int) or number < 2 or not diameter or not pitch:
        return None
    values: dict[str, Any] = {
        "type": "roller" if length else "ball",
        "elements": number,
        "element_diameter": q(float(diameter), "length"),  # type: ignore[arg-type]
        "pitch_diameter": q(float(pitch), "length"),  # type: ignore[arg-type]
    }
    if length:
        values["effective_length"] = q(float(length), "length")  # type: ignore[arg-type]
    else:
        grooves = [row.get(f"raceway_radius_of_{ring}_ring") for ring in ("inner", "outer")]
        values["grooves"] = [
            float(g) / float(diameter) if g else default  # type: ignore[arg-type]
            for g, default in zip(grooves, (0.52, 0.53), strict=True)
        ]
    angle = conversion.number(row, "pressure_angle", f"{path}.contact_angle")
    if angle:
        own = row.get("axial_force_absorption_of_row") or bearing.get("axial_force_absorption")
        supports = -1.0 if own == "negative" else 1.0
        values["contact_angle"] = q(sign * supports * abs(angle), "angle")
    return values
