# SPDX-License-Identifier: Apache-2.0
"""Bevel stages: bevel gears with their common apex where the axes of their shafts intersect.

The origin of a bevel gear of REXS is the middle of its face, projected on its axis: R_m cos δ from the apex.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from pitchpoint.io.rexs.conversion.gears import add_material, flanks_of
from pitchpoint.io.rexs.conversion.hubs import shaft_of_gear
from pitchpoint.io.rexs.conversion.meshes import BACKLASH, MESH_DAMPING, gears_of_stage
from pitchpoint.io.rexs.conversion.state import Conversion, Seat, q
from pitchpoint.io.rexs.document import RexsComponent

OFFSET = 1e-6
"""Distance of the axes above which a stage is a hypoid one [m]."""
ANGLE = 1e-4
"""Difference of shaft angles that counts as rounding [rad]."""
PLACE = 1e-4
"""Distance of a gear from its place on the pitch cone that is listed [m]."""
FINE = 1e-6
"""Rounding of the factors of a basic rack."""


def convert_bevel_stage(conversion: Conversion, stage: RexsComponent) -> None:
    """Add the mesh of a bevel stage, and its gears."""
    gears = gears_of_stage(conversion, stage)
    if not gears:
        return
    before = len(conversion.problems)
    if any(gear.type != "bevel_gear" for gear in gears):
        conversion.problem(
            stage, "has a gear that is not a bevel gear", remedy="give two components bevel_gear"
        )
        return
    seats = [seat for gear in gears if (seat := _seat(conversion, gear)) is not None]
    if len(seats) < 2:
        conversion.done.update(gear.id for gear in gears)
        return
    apex = _apex(conversion, stage, seats)
    teeth = [conversion.need(gear, "number_of_teeth", "none") for gear in gears]
    if apex is None or None in teeth:
        return
    ways = [_way(conversion, gear, seat, apex) for gear, seat in zip(gears, seats, strict=True)]
    sigma = math.acos(float(np.clip(ways[0] * ways[1] * (seats[0].frame.z @ seats[1].frame.z), -1.0, 1.0)))
    given = conversion.number(stage, "shaft_angle")
    if given is not None and abs(abs(given) - sigma) > ANGLE:
        conversion.problem(
            stage,
            "differs from the angle of the axes of the shafts",
            "shaft_angle",
            f"{math.degrees(abs(given)):.6g} deg",
            f"{math.degrees(sigma):.6g} deg by u_axis_vector",
            "correct one of the two",
        )
        return
    alpha = _pressure_angle(conversion, stage)
    z = [int(count) for count in teeth if count is not None]
    names = []
    for k, (gear, seat) in enumerate(zip(gears, seats, strict=True)):
        values = _gear(conversion, gear, alpha, (z[k], z[1 - k], sigma))
        if values is None:
            return
        values["opens"] = "+z" if ways[k] > 0.0 else "-z"
        names.append(_put(conversion, gear, seat, values, apex))
        middle = seat.point(conversion.number(gear, "u_coordinate_on_shaft") or 0.0)
        _compare_place(conversion, gear, float(np.linalg.norm(middle - apex)), (z[k], z[1 - k], sigma))
    if len(conversion.problems) > before:
        return
    entry: dict[str, Any] = {"gears": names, "damping": {"ratio": MESH_DAMPING}}
    target = f"bevel_meshes.{conversion.name(stage)}"
    entry["backlash"] = _backlash(conversion, stage, gears, f"{target}.backlash")
    conversion.put("bevel_meshes", stage, entry)
    conversion.default(stage, "damping", f"ratio {MESH_DAMPING}", f"{target}.damping", "REXS has no damping")
    conversion.default(stage, "mesh stiffness", "law din3990", f"{target}.stiffness", "from the geometry")


def _seat(conversion: Conversion, gear: RexsComponent) -> Seat | None:
    """Seat of the shaft of a gear; None with a problem if it has none, or is in the model already."""
    shaft = shaft_of_gear(conversion, gear)
    if shaft is None:
        return None
    seat = conversion.seats.get(shaft.id)
    if seat is None:
        if shaft.id not in conversion.done:
            conversion.problem(gear, f"is on {shaft}, not on a shaft of the model")
        elif not conversion.problems:
            conversion.problem(
                gear, "is on a planet", remedy="remove it, and write this part by hand: bevel_gears"
            )
        return None
    return seat


def _apex(conversion: Conversion, stage: RexsComponent, seats: list[Seat]) -> np.ndarray | None:
    """Point where the axes of two shafts intersect in the world [m]; None with a problem."""
    one, two = (seat.frame for seat in seats)
    normal = np.cross(one.z, two.z)
    length = float(np.linalg.norm(normal))
    between = two.origin - one.origin
    offset = conversion.number(stage, "hypoid_offset") or 0.0
    if length < OFFSET:
        conversion.problem(
            stage, "has parallel axes", remedy="correct support_vector and u_axis_vector of the shafts"
        )
        return None
    apart = abs(float(between @ normal)) / length
    if max(apart, abs(offset)) > OFFSET:
        conversion.problem(
            stage,
            "is a hypoid stage, which a model does not have: the axes do not intersect",
            "hypoid_offset",
            f"{1e3 * max(apart, abs(offset)):.6g} mm",
            "0",
            "remove it with its gears",
        )
        return None
    along = float(np.cross(between, two.z) @ normal) / length**2
    return one.origin + along * one.z


def _way(conversion: Conversion, gear: RexsComponent, seat: Seat, apex: np.ndarray) -> float:
    """Direction of a gear from the apex along the z axis of its body: +1 or -1."""
    u = conversion.need(gear, "u_coordinate_on_shaft", "mm")
    conversion.value(gear, "bevel_cone_orientation")
    if u is None:
        return 1.0
    return 1.0 if float((seat.point(u) - apex) @ seat.frame.z) > 0.0 else -1.0


def _pressure_angle(conversion: Conversion, stage: RexsComponent) -> float:
    """Pressure angle of a stage [rad]: the mean of drive and coast side."""
    for word in ("generated", "effective", "nominal_design"):
        ends = [
            conversion.number(stage, f"{word}_pressure_angle_on_{side}_side") for side in ("drive", "coast")
        ]
        given = [abs(value) for value in ends if value]
        if not given:
            continue
        mean = sum(given) / len(given)
        if max(given) - min(given) > ANGLE:
            text = f"{math.degrees(given[0]):.6g} and {math.degrees(given[-1]):.6g} deg"
            conversion.changed(
                stage,
                f"{word}_pressure_angle_on_coast_side",
                str(q(mean, "angle")),
                "bevel_gears.*.normal_pressure_angle",
                f"mean of {text}: the flanks of a model have one pressure angle",
            )
        return mean
    conversion.default(
        stage, "generated_pressure_angle_on_drive_side", "20 deg", "bevel_gears.*.normal_pressure_angle"
    )
    return math.radians(20.0)


def _gear(
    conversion: Conversion,
    gear: RexsComponent,
    alpha: float,
    pair: tuple[int, int, float],
) -> dict[str, Any] | None:
    """Data of a bevel gear for the model file; None with a problem.

    Parameters
    ----------
    conversion, gear
        The conversion and the gear.
    alpha
        Pressure angle [rad].
    pair
        Numbers of teeth of the gear and of its mate, and the shaft angle [rad].
    """
    path = f"bevel_gears.{conversion.name(gear)}"
    z, mate, sigma = pair
    m = conversion.need(gear, "mean_normal_module", "mm", f"{path}.mean_normal_module")
    b = conversion.need(gear, "face_width", "mm", f"{path}.face_width")
    if m is None or b is None:
        return None
    if min(m, b) <= 0.0 or z < 3:
        key = "number_of_teeth" if z < 3 else "mean_normal_module" if m <= 0.0 else "face_width"
        conversion.problem(gear, "is too small", key, str(gear.get(key)), "3 teeth" if z < 3 else "above 0")
        return None
    values: dict[str, Any] = {"number_of_teeth": z, "mate_teeth": mate, "mean_normal_module": q(m, "length")}
    if abs(sigma - math.pi / 2.0) > 1e-9:
        values["shaft_angle"] = q(sigma, "angle")
    if abs(alpha - math.radians(20.0)) > 1e-9:
        values["normal_pressure_angle"] = q(alpha, "angle")
    beta = conversion.number(gear, "mean_spiral_angle", f"{path}.spiral_angle")
    if beta is None:
        conversion.default(gear, "mean_spiral_angle", "0 deg", f"{path}.spiral_angle")
    elif abs(beta) > 1e-9:
        hand = conversion.word(gear, "spiral_angle_pitch_direction", f"{path}.hand")
        values["spiral_angle"] = q(abs(beta), "angle")
        values["hand"] = hand if hand in ("left", "right") else "right" if beta > 0.0 else "left"
    values["face_width"] = q(b, "length")
    for key in ("profile_shift_coefficient", "thickness_modification_coefficient"):
        found = conversion.number(gear, key, f"{path}.{key}")
        if found:
            values[key] = found
        elif found is None:
            conversion.default(gear, key, "0", f"{path}.{key}")
    rack = _rack(conversion, gear, m, path)
    if rack:
        values["rack"] = rack
    mass = conversion.number(gear, "mass_of_component", f"{path}.mass")
    if mass:
        values["mass"] = q(mass, "mass")
    add_material(conversion, gear, path, values)
    return values


def _rack(conversion: Conversion, gear: RexsComponent, m: float, path: str) -> dict[str, Any]:
    """Heights of the basic rack and root radius, in mean normal modules."""
    found: dict[str, Any] = {}
    for key in ("addendum", "dedendum"):
        value = conversion.number(gear, f"basic_crown_gear_{key}_factor", f"{path}.rack.{key}")
        if value is None:
            default = "1" if key == "addendum" else "1.25"
            conversion.default(gear, f"basic_crown_gear_{key}_factor", default, f"{path}.rack.{key}")
        elif value > 0.0:
            found[key] = round(value / FINE) * FINE
    radii = [
        conversion.number(flank, "tool_edge_radius", f"{path}.rack.root_radius")
        for flank in flanks_of(conversion, gear).values()
    ]
    given = [radius for radius in radii if radius]
    if given:
        found["root_radius"] = float(f"{min(given) / m:.6g}")
    usual = {"addendum": 1.0, "dedendum": 1.25}
    return {key: float(f"{v:.6g}") for key, v in found.items() if abs(v - usual.get(key, -1.0)) > FINE}


def _put(
    conversion: Conversion, gear: RexsComponent, seat: Seat, values: dict[str, Any], apex: np.ndarray
) -> str:
    """Add a bevel gear to its body at the place of its apex; its name is returned."""
    if gear.id in conversion.done:
        return conversion.name(gear)
    name = conversion.put("bevel_gears", gear, values)
    section = "shafts" if seat.body in conversion.data.get("shafts", {}) else "bodies"
    place = seat.place(seat.coordinate(apex))
    conversion.data[section][seat.body].setdefault("bevel_gears", {})[name] = q(place, "length")
    for key in ("support_vector", "u_axis_vector", "w_axis_vector", "reference_component_for_position"):
        if key in gear.attributes:
            conversion.used.add((gear.id, key))
    return name


def _compare_place(
    conversion: Conversion, gear: RexsComponent, apart: float, pair: tuple[int, int, float]
) -> None:
    """List the distance between the place of a gear in the file and that of its pitch cone.

    Parameters
    ----------
    conversion, gear
        The conversion and the gear.
    apart
        Distance from the apex in the file [m].
    pair
        Numbers of teeth of the gear and of its mate, and the shaft angle [rad].
    """
    z, mate, sigma = pair
    m, beta = gear.get("mean_normal_module"), gear.get("mean_spiral_angle") or 0.0
    delta = math.atan2(math.sin(sigma), mate / z + math.cos(sigma))
    right = z * float(m) / (2.0 * math.cos(float(beta)) * math.tan(delta))  # type: ignore[arg-type]
    if abs(apart - right) > PLACE:
        target = f"bevel_gears.{conversion.name(gear)}"
        reason = f"its middle is {1e3 * apart:.6g} mm from the apex, {1e3 * right:.6g} mm on the pitch cone"
        conversion.changed(gear, "u_coordinate_on_shaft", "on the pitch cone", target, reason)


def _backlash(
    conversion: Conversion, stage: RexsComponent, gears: list[RexsComponent], target: str
) -> dict[str, Any]:
    """Backlash of a bevel mesh at the mean cone distance; a usual one if the file has none."""
    mean = conversion.number(stage, "mean_normal_backlash", f"{target}.normal")
    if mean or (conversion.own and mean is not None):
        return {"normal": q(mean, "length")}
    text = f"factor {BACKLASH}"
    conversion.default(stage, "mean_normal_backlash", text, target, "circumferential, over the module")
    return {"factor": BACKLASH}
