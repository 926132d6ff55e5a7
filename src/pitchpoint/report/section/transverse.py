# SPDX-License-Identifier: Apache-2.0
"""`transverse_of`: gears on parallel axes seen along these, with directions of rotation."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.units import format_quantity
from pitchpoint.core.words import ranges
from pitchpoint.model.frames import body_frame
from pitchpoint.report.section.axes import lines_of
from pitchpoint.report.section.pieces import pitch_diameter
from pitchpoint.viz.transverse_drawing import Transverse, Wheel

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

ROUND = 6
"""Decimals of positions and radii [m] by which gears look alike."""


def transverse_of(model: Model, flow: Mapping[str, Any] | None = None) -> Transverse | None:
    """Transverse view of the axes with most gears; None without meshes of cylindrical gears.

    Parameters
    ----------
    model
        The model.
    flow
        Power flow with the speeds of the shafts, as of `report.static_power`.
    """
    meshed = {gear for mesh in model.meshes.values() for gear in mesh.gears}
    bodies = [name for name, body in model.bodies.items() if meshed & {*body.gears}]
    if not bodies:
        return None
    lines = lines_of(model, bodies)
    ways: list[Any] = []
    for line in lines:
        if not any(line.way is way for way in ways):
            ways.append(line.way)
    way = max(ways, key=lambda w: sum(line.way is w for line in lines))
    first = next(body for line in lines if line.way is way for body in line.bodies)
    frame = body_frame(model, first)[1]
    looks: dict[Any, list[tuple[str, str]]] = {}
    places = {}
    for line in lines:
        if line.way is not way:
            continue
        centre = frame[:, :2].T @ line.point
        for body in line.bodies:
            for gear in model.bodies[body].gears:
                if gear not in meshed:
                    continue
                shape = model.gears[gear].geometry
                radii = 0.5 * pitch_diameter(model, gear), 0.5 * abs(shape.d_a), 0.5 * abs(shape.d_f)
                key = (
                    *(round(float(x), ROUND) for x in (*centre, *radii)),
                    model.gears[gear].number_of_teeth,
                )
                looks.setdefault(key, []).append((gear, body))
                places[gear] = centre
    groups: dict[Any, list[Any]] = {}
    for key, members in looks.items():  # planets: equal gears whose names differ by a number
        pattern = tuple(re.sub(r"\d+", "#", gear) for gear, _ in members)
        groups.setdefault((key[2:], pattern), []).append(key)
    wheels = []
    for key, members in looks.items():
        group = next(keys for keys in groups.values() if key in keys)
        gears = [gear for each in group for gear, _ in looks[each]]
        wheels.append(
            Wheel(
                centre=np.array(key[:2]),
                pitch=key[2],
                tip=key[3],
                root=key[4],
                name=f"{ranges([g for g, _ in members])} ({key[5]})",
                speed=_speed(flow, members[0][1]),
                group=f"{ranges(gears)} ({key[5]})" if len(group) > 2 else "",
                first=key is group[0],
            )
        )
    distances = []
    seen: dict[frozenset[Any], str] = {}
    for mesh in model.meshes.values():
        one, two = mesh.gears
        if one not in places or two not in places:
            continue
        ends = frozenset(tuple(np.round(places[gear], ROUND).tolist()) for gear in mesh.gears)
        if ends in seen:
            continue
        size = format_quantity(abs(mesh.a_w or 0.0), "length", 5)
        alike = any(size == words and ends & other for other, words in seen.items())
        seen[ends] = size  # equal distances from one axis, as of planets, have one label
        distances.append((places[one], places[two], "" if alike else size))
    return Transverse(wheels=wheels, distances=distances, supports=_supports(model, frame[:, :2]))


def _supports(model: Model, across: Any) -> list[tuple[Any, str]]:
    """Feet or mounts of the housing; those at one place of the view together.

    Parameters
    ----------
    model
        The model.
    across
        Axes of the view, shape (3, 2).
    """
    housing = model.housing
    parts = getattr(housing, "feet", None) or getattr(housing, "mounts", None) or {}
    found: dict[tuple[float, ...], list[str]] = {}
    for name, part in parts.items():
        place = across.T @ np.array(part.position)
        found.setdefault(tuple(np.round(place, ROUND).tolist()), []).append(name)
    return [(np.array(place), ranges(names)) for place, names in found.items()]


def _speed(flow: Mapping[str, Any] | None, body: str) -> float | None:
    """Speed of a body; at rest the sign of its ratio."""
    row = None if flow is None else flow["shafts"].get(body)
    if row is None:
        return None
    return row["speed"] if row["speed"] is not None else row["ratio"]
