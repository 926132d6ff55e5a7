# SPDX-License-Identifier: Apache-2.0
"""Cylindrical gears: tooth data of the gear, of its two flanks and of its tool."""

from __future__ import annotations

import math
from typing import Any

from pitchpoint.io.rexs.conversion.hubs import shaft_of
from pitchpoint.io.rexs.conversion.materials import material_of
from pitchpoint.io.rexs.conversion.modifications import modifications_of
from pitchpoint.io.rexs.conversion.state import Conversion, q
from pitchpoint.io.rexs.document import RexsComponent

CYLINDRICAL = ("cylindrical_gear", "ring_gear")
SHIFT, ANGLE = "addendum_modification_coefficient", "normal_pressure_angle"
FLANKS = ("cylindrical_gear_flank", "flank_geometry")
SAME = 1e-9
OWN_DIAMETER = "custom_pitchpoint_outer_diameter"
"""Outside diameter of an internal gear in files of pitchpoint [mm]: REXS has none."""
TIPS = (-2.0, 3.0)
"""Smallest and largest height of a tip circle over the shifted reference circle, in modules."""
ROOTS = (0.5, 3.0)
"""The same of a root circle below it."""


def gear_data(conversion: Conversion, gear: RexsComponent, path: str) -> dict[str, Any] | None:
    """Data of a gear for the model file; None if a value without which there is no gear is missing.

    Parameters
    ----------
    conversion
        The conversion.
    gear
        The gear.
    path
        Key of the gear in the model file.
    """
    need = {
        "number_of_teeth": conversion.need(gear, "number_of_teeth", "none", f"{path}.number_of_teeth"),
        "normal_module": conversion.need(gear, "normal_module", "mm", f"{path}.normal_module"),
        "face_width": conversion.need(gear, "face_width", "mm", f"{path}.face_width"),
    }
    if any(value is None for value in need.values()):
        return None
    z, m_n, b = (float(value) for value in need.values() if value is not None)
    if not (z >= 1 and m_n > 0.0 and b > 0.0):
        key = "number_of_teeth" if z < 1 else "normal_module" if m_n <= 0.0 else "face_width"
        conversion.problem(gear, "is not above zero", key, str(gear.get(key)))
        return None
    internal = gear.type == "ring_gear"
    values: dict[str, Any] = {
        **({"type": "internal"} if internal else {}),
        "number_of_teeth": int(z),
        "normal_module": q(m_n, "length"),
    }
    alpha, x = _flanks(conversion, gear, path)
    if alpha is None:
        conversion.default(gear, ANGLE, "20 deg", f"{path}.normal_pressure_angle")
    elif abs(alpha - math.radians(20.0)) > SAME:
        values["normal_pressure_angle"] = q(alpha, "angle")
    beta = conversion.number(gear, "helix_angle_reference_diameter", f"{path}.helix_angle")
    if beta is None:
        conversion.default(gear, "helix_angle_reference_diameter", "0 deg", f"{path}.helix_angle")
    elif abs(beta) > SAME:
        values["helix_angle"] = q(abs(beta), "angle")
        # the signs of a ring and its planet differ in REXS, as those of an external pair, but not their hands
        values["hand"] = "right" if (beta > 0.0) != internal else "left"
    values["face_width"] = q(b, "length")
    if x is not None:
        values["profile_shift_coefficient"] = x
    _diameters(conversion, gear, path, values, (z, m_n, beta or 0.0, x))
    _tools(conversion, gear, path, values, m_n)
    bore = conversion.number(
        gear, "outer_diameter" if internal else "inner_diameter", f"{path}.bore_diameter"
    )
    bore = bore or _own_diameter(conversion, gear, f"{path}.bore_diameter")
    if bore:
        values["bore_diameter"] = q(bore, "length")
    modifications = modifications_of(conversion, gear, flanks_of(conversion, gear), path)
    if modifications:
        values["modifications"] = modifications
    mass = conversion.number(gear, "mass_of_component", f"{path}.mass")
    if mass:
        values["mass"] = q(mass, "mass")
    return values


def _own_diameter(conversion: Conversion, gear: RexsComponent, target: str) -> float | None:
    """Outside diameter of an internal gear in a file of pitchpoint [m]; a text in XML files."""
    found = conversion.value(gear, OWN_DIAMETER, target)
    try:
        return 1e-3 * float(found)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        return None


def add_material(conversion: Conversion, gear: RexsComponent, path: str, values: dict[str, Any]) -> None:
    """Add the material of a gear, by default that of its shaft."""
    shaft = shaft_of(conversion, gear)
    part = gear if conversion.referenced(gear, "material") or shaft is None else shaft
    if part is not gear and conversion.referenced(part, "material"):
        conversion.default(gear, "material", f"that of {conversion.name(part)}", f"{path}.material")
    material = material_of(conversion, part, f"{path}.material")
    if material != "steel":
        values["material"] = material


def flanks_of(conversion: Conversion, gear: RexsComponent) -> dict[str, RexsComponent]:
    """Left and right flank of a gear."""
    found = {}
    for relation in conversion.source.related("flank", gear=gear.id):
        for side in ("left", "right"):
            if side in relation.roles:
                found[side] = conversion.source.components[relation.roles[side]]
                conversion.done.add(relation.roles[side])
    return found


def _flanks(conversion: Conversion, gear: RexsComponent, path: str) -> tuple[float | None, float | None]:
    """Pressure angle and profile shift coefficient of the flanks, which must be equal."""
    flanks = flanks_of(conversion, gear)
    result: list[float | None] = []
    for key, target in ((ANGLE, "normal_pressure_angle"), (SHIFT, "profile_shift_coefficient")):
        values = {side: conversion.number(f, key, f"{path}.{target}") for side, f in flanks.items()}
        given = {side: value for side, value in values.items() if value is not None}
        if len(given) == 2 and abs(given["left"] - given["right"]) > SAME:
            conversion.problem(
                flanks["right"],
                f"differs from that of the left flank of {gear}",
                key,
                f"{given['right']:.6g}",
                f"{given['left']:.6g}",
                "gears of a model have equal flanks",
            )
        result.append(next(iter(given.values()), None))
    return result[0], result[1]


def _diameters(
    conversion: Conversion,
    gear: RexsComponent,
    path: str,
    values: dict[str, Any],
    teeth: tuple[float, float, float, float | None],
) -> None:
    """Tip and root diameters, if they can be those of the gear."""
    z, m_n, beta, x = teeth
    sign = -1.0 if gear.type == "ring_gear" else 1.0
    reference = z * m_n / math.cos(beta) + sign * 2.0 * (x or 0.0) * m_n
    for key, limits, outwards in (("tip_diameter", TIPS, sign), ("root_diameter", ROOTS, -sign)):
        value = conversion.number(gear, key, f"{path}.{key}")
        if value is None:
            conversion.default(gear, key, "from the basic rack", f"{path}.{key}")
            continue
        height = outwards * (value - reference) / (2.0 * m_n)
        if limits[0] <= height <= limits[1] and value > 0.0:
            values[key] = q(value, "length")
            continue
        ends = sorted(reference + outwards * 2.0 * m_n * limit for limit in limits)
        conversion.changed(
            gear,
            key,
            "from the basic rack",
            f"{path}.{key}",
            f"{q(value, 'length')} is a placeholder (limit {1e3 * ends[0]:.1f} to {1e3 * ends[1]:.1f} mm)",
        )


def _tools(
    conversion: Conversion, gear: RexsComponent, path: str, values: dict[str, Any], m_n: float
) -> None:
    """Basic rack from the rack-shaped tool of a gear, and the cutter of an internal gear."""
    found = conversion.referenced(gear, "rack_shaped_tool", "cutter_wheel_tool")
    for piece in (gear, *flanks_of(conversion, gear).values()):
        for relation in conversion.source.related("manufacturing_step", workpiece=piece.id):
            tool = conversion.source.components.get(relation.roles.get("tool", -1))
            if tool is not None and tool.type in ("rack_shaped_tool", "cutter_wheel_tool"):
                found.append(tool)
    cutter = gear.type == "ring_gear"
    tools = [t for t in found if t.type == ("cutter_wheel_tool" if cutter else "rack_shaped_tool")]
    target = f"{path}.{'cutter' if cutter else 'rack'}"
    for other in found:
        if other not in tools:
            conversion.ignored(other, "all", f"no tool of a {gear.type} in a model")
    if not tools:
        conversion.default(gear, "tool", "1.0/1.25/0.38", f"{path}.rack", "basic rack of ISO 53, profile A")
        return
    tool = tools[0]
    conversion.done.add(tool.id)
    height = _relative(conversion, tool, "addendum", m_n, target)
    radius = _relative(conversion, tool, "tip_corner_radius", m_n, target)
    if cutter:
        teeth = conversion.number(tool, "number_of_teeth", f"{target}.number_of_teeth")
        if teeth is None:
            conversion.default(tool, "number_of_teeth", "none", target, "without it the cutter is not used")
            return
        shift = conversion.number(tool, SHIFT, f"{target}.profile_shift_coefficient")
        values["cutter"] = {
            "number_of_teeth": int(teeth),
            **({"profile_shift_coefficient": shift} if shift else {}),
            **({} if height is None else {"addendum": height}),
            **({} if radius is None else {"tip_radius": radius}),
        }
        return
    rack = {
        **({} if height is None else {"dedendum": height}),
        **({} if radius is None else {"root_radius": radius}),
    }
    if rack:
        values["rack"] = rack


def _relative(
    conversion: Conversion, tool: RexsComponent, what: str, m_n: float, target: str
) -> float | None:
    """Height or radius of a tool in modules, from the relative or the absolute value."""
    factor = "factor" if what == "tip_corner_radius" else "coefficient"
    found = conversion.number(tool, f"{what}_{factor}_reference_profile", target)
    if found is not None:
        return found
    absolute = conversion.number(tool, f"{what}_reference_profile", target)
    return None if absolute is None else absolute / m_n
