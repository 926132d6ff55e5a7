# SPDX-License-Identifier: Apache-2.0
"""Cylindrical stages: gears on their shafts, and the meshes between them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from pitchpoint.io.rexs.conversion.gears import CYLINDRICAL, add_material, gear_data
from pitchpoint.io.rexs.conversion.hubs import shaft_of, shaft_of_gear
from pitchpoint.io.rexs.conversion.state import Conversion, Meshing, q
from pitchpoint.io.rexs.document import RexsComponent

MESH_DAMPING = 0.05
"""Default damping ratio of meshes: REXS has no damping."""
BACKLASH = 0.04
"""Default circumferential backlash over module: without it both flanks would be in contact."""
AGREE = 1e-6
"""Difference of centre distances that counts as rounding [m]."""
ROUNDED = 2e-6
"""Rounding of reference centre distances in files [m]."""
PARALLEL = 1e-9


def gears_of_stage(conversion: Conversion, stage: RexsComponent) -> list[RexsComponent]:
    """Gear 1 and gear 2 of a stage; empty with a problem if they are not two."""
    for relation in conversion.source.related("stage", stage=stage.id):
        ids = [relation.roles.get(role) for role in ("gear_1", "gear_2")]
        if None not in ids:
            return [conversion.source.components[i] for i in ids if i is not None]
    conversion.problem(stage, "has no two gears", remedy="give a relation 'stage' with gear_1 and gear_2")
    return []


def seat_gear(conversion: Conversion, gear: RexsComponent) -> str | None:
    """Add a gear to its shaft or body; its name, None with a problem if it has no place."""
    name = conversion.name(gear)
    values = gear_data(conversion, gear, f"gears.{name}")
    shaft = shaft_of_gear(conversion, gear)
    if shaft is None:
        return None
    seat = conversion.seats.get(shaft.id)
    u = conversion.need(gear, "u_coordinate_on_shaft", "mm")
    if values is None or seat is None or u is None:
        return None
    add_material(conversion, gear, f"gears.{name}", values)
    if gear.type == "ring_gear" and "bore_diameter" not in values:
        _rim(conversion, gear, values, seat.bore_at(u))
    conversion.put("gears", gear, values, name)
    section = "shafts" if seat.body in conversion.data.get("shafts", {}) else "bodies"
    body = conversion.data[section][seat.body]
    body.setdefault("gears", {})[name] = q(seat.place(u), "length")
    for key in ("support_vector", "u_axis_vector", "w_axis_vector", "reference_component_for_position"):
        if key in gear.attributes:
            conversion.used.add((gear.id, key))
    return name


def _rim(conversion: Conversion, gear: RexsComponent, values: dict[str, Any], bore: float) -> None:
    """Outside diameter of a ring: the inner diameter of the shaft that holds it."""
    root = conversion.number(gear, "number_of_teeth") or 0.0
    m_n = conversion.number(gear, "normal_module") or 0.0
    beta = conversion.number(gear, "helix_angle_reference_diameter") or 0.0
    least = root * m_n / math.cos(beta) + 2.5 * m_n
    target = f"gears.{conversion.name(gear)}.bore_diameter"
    if bore > least:
        values["bore_diameter"] = q(bore, "length")
        conversion.default(gear, "outer_diameter", str(q(bore, "length")), target, "bore of its shaft")


def convert_stage(conversion: Conversion, stage: RexsComponent) -> None:
    """Add the mesh of a cylindrical stage, and its gears."""
    gears = gears_of_stage(conversion, stage)
    if not gears:
        return
    wrong = [g for g in gears if g.type not in CYLINDRICAL]
    if wrong:
        conversion.problem(
            stage, f"has the gear {wrong[0]}", remedy="cylindrical stages have cylindrical gears"
        )
        return
    names = [
        conversion.names.get(g.id) if g.id in conversion.done else seat_gear(conversion, g) for g in gears
    ]
    if None in names:
        conversion.done.add(stage.id)
        return
    missing = [g for g, n in zip(gears, names, strict=True) if n not in conversion.data.get("gears", {})]
    if missing:
        conversion.problem(
            stage,
            f"has the gear {missing[0]}, which is not a gear of its own in the model",
            remedy="give planets in mesh with each other in one planetary_stage",
        )
        return
    values: dict[str, Any] = {"gears": names, "damping": {"ratio": MESH_DAMPING}}
    name = conversion.name(stage)
    distance = conversion.number(stage, "center_distance", f"meshes.{name}.center_distance")
    placed = _distance_of_places(conversion, gears)
    if (
        placed is not None
        and distance is not None
        and abs(distance - _reference(gears)) < ROUNDED < abs(placed - distance)
    ):
        reason = f"{_mm(distance)} is the reference centre distance, without profile shift"
        target = f"meshes.{name}.center_distance"
        conversion.changed(stage, "center_distance", _mm(placed), target, reason)
        distance = placed
    if placed is not None and distance is not None and abs(placed - distance) > AGREE:
        conversion.problem(
            stage,
            "differs from the distance of the axes of the shafts",
            "center_distance",
            f"{1e3 * distance:.6g} mm",
            f"{1e3 * placed:.6g} mm by support_vector",
            "correct one of the two",
        )
        return
    if distance is None:
        conversion.default(stage, "center_distance", _mm(placed), f"meshes.{name}", "from the positions")
    final = distance if distance is not None else placed
    if final is not None:
        values["center_distance"] = q(final, "length")
        entries = [conversion.data["gears"][str(n)] for n in names]
        conversion.meshings.append(Meshing(stage, gears, entries, final))
    values["backlash"] = backlash_of(conversion, stage, f"meshes.{name}.backlash")
    conversion.put("meshes", stage, values)
    conversion.default(
        stage, "damping", f"ratio {MESH_DAMPING}", f"meshes.{name}.damping", "REXS has no damping"
    )
    conversion.default(
        stage, "mesh stiffness", "law din3990", f"meshes.{name}.stiffness", "from the geometry"
    )


def _reference(gears: list[RexsComponent]) -> float:
    """Reference centre distance of two gears [m]."""
    teeth = [float(g.get("number_of_teeth") or 0.0) for g in gears]  # type: ignore[arg-type]
    signs = [-1.0 if g.type == "ring_gear" else 1.0 for g in gears]
    m_n = float(gears[0].get("normal_module") or 0.0)  # type: ignore[arg-type]
    beta = float(gears[0].get("helix_angle_reference_diameter") or 0.0)  # type: ignore[arg-type]
    return abs(sum(s * z for s, z in zip(signs, teeth, strict=True))) * m_n / (2.0 * math.cos(beta))


def backlash_of(conversion: Conversion, stage: RexsComponent, target: str) -> dict[str, Any]:
    """Backlash of a mesh: the mean of the limits of the file, else one that is usual."""
    for key, attribute in (("normal", "normal_backlash"), ("circumferential", "transverse_backlash")):
        ends = [conversion.number(stage, f"{end}_{attribute}", f"{target}.{key}") for end in _ENDS]
        given = [value for value in ends if value is not None]
        if given and (max(given) > 0.0 or conversion.own):
            return {key: q(sum(given) / len(given), "length")}
    text = f"factor {BACKLASH}"
    conversion.default(stage, "minimum_normal_backlash", text, target, "circumferential, over the module")
    return {"factor": BACKLASH}


_ENDS = ("minimum", "maximum")


def _distance_of_places(conversion: Conversion, gears: list[RexsComponent]) -> float | None:
    """Distance of the axes of two gears by the positions of their shafts [m]; None if not parallel."""
    seats = []
    for gear in gears:
        shaft = shaft_of(conversion, gear)
        seats.append(None if shaft is None else conversion.seats.get(shaft.id))
    one, two = seats
    if one is None or two is None:
        return None
    z = one.frame.z
    if 1.0 - abs(float(z @ two.frame.z)) > PARALLEL:
        conversion.problem(
            gears[1],
            "has an axis that is not parallel to that of its mate",
            remedy="axes of cylindrical gears are parallel",
        )
        return None
    between = two.frame.origin - one.frame.origin
    return float(np.linalg.norm(between - (between @ z) * z))


def _mm(value: float | None) -> str:
    return "" if value is None else f"{1e3 * value:.6g} mm"
