# SPDX-License-Identifier: Apache-2.0
"""Planetary stages: equal planets on the pins of a carrier, in mesh with a sun, a ring or both."""

from __future__ import annotations

import math
from typing import Any, TypeAlias

import numpy as np

from pitchpoint.io.rexs.conversion.bearings import (
    CONTACT_DAMPING,
    LINEAR_DAMPING,
    ROLLING,
    rolling_data,
    sides_of,
    stiffness_of,
    sum_of_stiffness,
)
from pitchpoint.io.rexs.conversion.carriers import convert_carrier
from pitchpoint.io.rexs.conversion.frames import frame_of
from pitchpoint.io.rexs.conversion.gears import CYLINDRICAL, add_material, gear_data
from pitchpoint.io.rexs.conversion.meshes import (
    MESH_DAMPING,
    backlash_of,
    gears_of_stage,
    seat_gear,
)
from pitchpoint.io.rexs.conversion.shafts import sections_of
from pitchpoint.io.rexs.conversion.state import Conversion, Meshing, q
from pitchpoint.io.rexs.document import RexsComponent

EQUAL = 1e-6
"""Largest difference of distances that count as equal [m]."""
OF_TEETH = (
    *("number_of_teeth", "normal_module", "helix_angle_reference_diameter", "face_width"),
    *("tip_diameter", "root_diameter", "u_coordinate_on_shaft"),
)
"""Attributes in which planets must agree."""

Planet: TypeAlias = tuple[RexsComponent, RexsComponent]
"""Shaft and gear of a planet."""


def planet_shafts(conversion: Conversion, stage: RexsComponent) -> list[RexsComponent]:
    """Shafts of the planets of a stage."""
    return [
        conversion.source.components[r.roles["shaft"]]
        for r in conversion.source.related("planet_shaft", planetary_stage=stage.id)
    ]


def convert_carriers(conversion: Conversion) -> dict[int, str]:
    """Add the carriers of all planetary stages; their names by the id of the stage."""
    found = {}
    for stage in conversion.source.of_type("planetary_stage"):
        conversion.done.update(shaft.id for shaft in planet_shafts(conversion, stage))
        name = convert_carrier(conversion, stage)
        if name is not None:
            found[stage.id] = name
    return found


def convert_planetary_stage(conversion: Conversion, stage: RexsComponent, carrier: str) -> None:
    """Add a planetary stage with its sun, its ring, its planets and their bearings."""
    before = len(conversion.problems)
    conversion.done.add(stage.id)
    name = conversion.name(stage)
    planets = _planets(conversion, stage)
    mates = _mates(conversion, stage, [gear.id for _, gear in planets]) if planets else {}
    for number in mates:
        seat_gear(conversion, conversion.source.components[number])
    if len(conversion.problems) > before or not mates:
        return
    axis = conversion.owner(conversion.source.components[next(iter(mates))], "shaft")
    places = None if axis is None else _places(conversion, planets, axis)
    if places is None:
        return
    planets, angles, distance = places
    shaft, first = planets[0]
    path = f"planetary_stages.{name}.planet"
    data = gear_data(conversion, first, path)
    if data is None:
        return
    add_material(conversion, first, path, data)
    _same_planets(conversion, planets)
    _bore(conversion, shaft, first, path, data)
    values: dict[str, Any] = {}
    meshes: dict[str, RexsComponent] = {}
    for number, (mesh, sides) in mates.items():
        _check_distances(conversion, stage, number, distance)
        role = "ring" if conversion.source.components[number].type == "ring_gear" else "sun"
        values[role], meshes[role] = conversion.names[number], mesh
        entries = [
            conversion.data["gears"][conversion.names[g.id]] if g.id == number else data for g in sides
        ]
        pair = [g if g.id == number else first for g in sides]
        conversion.meshings.append(Meshing(mesh, pair, entries, distance))
    values["carrier"] = carrier
    values["planet"] = data
    values["angles"] = [q(a, "angle") for a in angles]
    values["center_distance"] = q(distance, "length")
    planet_name = "planet"
    if len(conversion.source.of_type("planetary_stage")) > 1:
        values["planet_name"] = planet_name = f"{name}_planet"
    _bearings(conversion, stage, planets, planet_name, carrier, values)
    for role in ("sun", "ring"):
        if role in values:
            target = f"planetary_stages.{name}.{role}_mesh"
            values[f"{role}_mesh"] = {
                "damping": {"ratio": MESH_DAMPING},
                "backlash": backlash_of(conversion, meshes[role], f"{target}.backlash"),
            }
            text = f"ratio {MESH_DAMPING}"
            conversion.default(stage, "damping", text, f"{target}.damping", "REXS has no damping")
            conversion.default(stage, "mesh stiffness", "law din3990", f"{target}.stiffness", "by geometry")
    if len(conversion.problems) == before:
        conversion.put("planetary_stages", stage, values, name)


def _planets(conversion: Conversion, stage: RexsComponent) -> list[Planet]:
    """Shaft and gear of every planet; empty with a problem."""
    found = []
    for shaft in planet_shafts(conversion, stage):
        gears = conversion.parts(shaft, *CYLINDRICAL)
        if len(gears) != 1:
            what = "has no cylindrical gear" if not gears else "has several gears"
            conversion.problem(shaft, what, remedy="planets of a stage have one gear each")
            return []
        found.append((shaft, gears[0]))
    if not found:
        conversion.problem(stage, "has no planets", remedy="give relations 'planet_shaft'")
    return found


def _mates(
    conversion: Conversion, stage: RexsComponent, planets: list[int]
) -> dict[int, tuple[RexsComponent, list[RexsComponent]]]:
    """Sun and ring by their ids, each with one of its cylindrical stages and the gears of that."""
    found: dict[int, tuple[RexsComponent, list[RexsComponent]]] = {}
    for mesh in conversion.source.of_type("cylindrical_stage"):
        gears = gears_of_stage(conversion, mesh)
        inside = [g for g in gears if g.id in planets]
        if not inside:
            continue
        conversion.done.add(mesh.id)
        if len(inside) == 2:
            conversion.problem(
                mesh, "is between two planets", remedy="planets of a stage mesh with sun and ring"
            )
            return {}
        mate = next(g for g in gears if g.id not in planets)
        found.setdefault(mate.id, (mesh, gears))
        conversion.number(mesh, "center_distance", f"planetary_stages.{conversion.name(stage)}")
    kinds = [conversion.source.components[i].type for i in found]
    if not found or len(set(kinds)) < len(kinds):
        what = "has no meshes of its planets" if not found else "has several suns or rings"
        conversion.problem(stage, what, remedy="a stage has one sun, one ring, or both")
        return {}
    return dict(sorted(found.items(), key=lambda one: conversion.source.components[one[0]].type))


def _same_planets(conversion: Conversion, planets: list[Planet]) -> None:
    """Check that all planets have the teeth of the first one."""
    first = planets[0][1]
    for _, gear in planets[1:]:
        conversion.done.add(gear.id)
        for key in OF_TEETH:
            one, two = first.get(key), gear.get(key)
            conversion.used.add((gear.id, key))
            if one != two and abs(float(one or 0.0) - float(two or 0.0)) > EQUAL:  # type: ignore[arg-type]
                conversion.problem(
                    gear, f"differs from that of {first}", key, str(two), str(one), "planets are equal"
                )


def _places(
    conversion: Conversion, planets: list[Planet], axis: RexsComponent
) -> tuple[list[Planet], list[float], float] | None:
    """Planets in the order of their angles, the angles [rad], and the distance of their axes [m]."""
    base = conversion.seats[axis.id].frame
    found = []
    for shaft, gear in planets:
        frame = frame_of(conversion, shaft)
        if frame is None:
            conversion.problem(
                shaft, "has no position", "support_vector", remedy="give support_vector and axes"
            )
            return None
        offset = base.axes.T @ (frame.origin - base.origin)
        found.append(
            (math.atan2(offset[1], offset[0]) % math.tau, math.hypot(offset[0], offset[1]), shaft, gear)
        )
    # an angle of 360 deg less rounding is 0
    found = [(0.0 if math.tau - a < 1e-9 else a, d, s, g) for a, d, s, g in found]
    found.sort(key=lambda one: one[0])
    distances = [d for _, d, *_ in found]
    if max(distances) - min(distances) > EQUAL:
        far = max(found, key=lambda one: abs(one[1] - np.median(distances)))
        conversion.problem(
            far[2],
            "is at another distance from the axis than the other planets",
            "support_vector",
            f"{1e3 * far[1]:.6g} mm",
            f"{1e3 * float(np.median(distances)):.6g} mm",
            "give pin errors in the model file",
        )
        return None
    return [(s, g) for _, _, s, g in found], [a for a, *_ in found], float(np.median(distances))


def _check_distances(conversion: Conversion, stage: RexsComponent, mate: int, distance: float) -> None:
    """Check that the centre distances of the meshes with a sun or ring are that of the pins."""
    for mesh in conversion.source.of_type("cylindrical_stage"):
        if mate not in [g.id for g in gears_of_stage(conversion, mesh)]:
            continue
        given = conversion.number(mesh, "center_distance")
        if given is not None and abs(abs(given) - distance) > EQUAL:
            conversion.problem(
                mesh,
                f"differs from the distance of the planets of {stage} from the axis",
                "center_distance",
                f"{1e3 * given:.6g} mm",
                f"{1e3 * distance:.6g} mm by support_vector",
                "correct one of the two",
            )


def _bore(
    conversion: Conversion, shaft: RexsComponent, gear: RexsComponent, path: str, data: dict[str, Any]
) -> None:
    """Bore of the planets: that of their shafts, whose mass is then part of the gear."""
    sections = sections_of(conversion, shaft)
    inner = max((bore for *_, bore in sections), default=0.0)
    if "bore_diameter" not in data and inner > 0.0:
        data["bore_diameter"] = q(inner, "length")
        reason = "bore of the planet shaft, whose mass is part of the gear"
        conversion.default(gear, "inner_diameter", str(q(inner, "length")), f"{path}.bore_diameter", reason)


def _bearings(
    conversion: Conversion,
    stage: RexsComponent,
    planets: list[Planet],
    planet_name: str,
    carrier: str,
    values: dict[str, Any],
) -> None:
    """Bearings of the planets: the sum of linear ones, or rolling bearings one by one."""
    shafts = {shaft.id: k for k, (shaft, _) in enumerate(planets)}
    linear: list[list[tuple[dict[str, float], float]]] = [[] for _ in planets]
    rolling = False
    for bearing in conversion.source.of_type("concept_bearing", *ROLLING):
        sides = {role: part.id for role, part in sides_of(conversion, bearing).items()}
        inner = sides.get("inner_part") in shafts
        number = sides.get("inner_part" if inner else "outer_part")
        if number not in shafts:
            continue
        conversion.done.add(bearing.id)
        k = shafts[number]
        u = conversion.need(bearing, f"u_coordinate_on_shaft_{'inner' if inner else 'outer'}_side", "mm")
        middle = conversion.need(planets[k][1], "u_coordinate_on_shaft", "mm")
        if u is None or middle is None:
            return
        name = conversion.name(bearing)
        frame = frame_of(conversion, planets[k][0])
        sign = 1.0 if frame is None else conversion.aligned(frame)[1]
        path = f"rolling_bearings.{name}"
        data = rolling_data(conversion, bearing, path, sign) if bearing.type in ROLLING else None
        if data is None:
            target = f"planetary_stages.{conversion.name(stage)}.bearing.stiffness"
            linear[k].append((stiffness_of(conversion, bearing, target), sign * (u - middle)))
            continue
        rolling = True
        planet = f"{planet_name}_{k + 1}"
        ends = [planet, carrier] if inner else [carrier, planet]
        entry = {"ends": ends, "position": [0, 0, q(sign * (u - middle), "length")], **data}
        conversion.put("rolling_bearings", bearing, entry, name)
        text = f"{CONTACT_DAMPING:g} s/m"
        conversion.default(
            bearing, "damping", text, f"rolling_bearings.{name}.damping", "REXS has no damping"
        )
    values["motion"] = "free"
    if rolling:
        return
    matrices = [sum_of_stiffness(parts) for parts in linear]
    if not matrices[0].any():
        values["motion"] = "torsion"
        text = "planets turn on rigid pins"
        conversion.default(stage, "bearings of the planets", text, f"{conversion.name(stage)}.motion")
        return
    if any(not np.allclose(m, matrices[0], rtol=1e-9) for m in matrices[1:]):
        conversion.changed(stage, "bearings", "those of the first planet", "", "planets of a stage are equal")
    values["bearing"] = {"stiffness": _entry(matrices[0]), "damping": {"ratio": LINEAR_DAMPING}}
    text = f"ratio {LINEAR_DAMPING}"
    conversion.default(
        stage, "damping of the planet bearings", text, "bearing.damping", "REXS has no damping"
    )


def _entry(matrix: np.ndarray) -> dict[str, Any]:
    """Stiffness by direction of bearings that are symmetric about the middle of the planet, else a matrix."""
    coupled = abs(matrix[0, 4]) > 1e-9 * math.sqrt(matrix[0, 0] * matrix[4, 4] or 1.0)
    if coupled:
        return {"matrix": [[float(x) for x in row] for row in matrix]}
    keys = {"radial": (0, "stiffness"), "axial": (2, "stiffness"), "tilt": (3, "torsional_stiffness")}
    return {key: q(matrix[i, i], unit) for key, (i, unit) in keys.items() if matrix[i, i] > 0.0}
