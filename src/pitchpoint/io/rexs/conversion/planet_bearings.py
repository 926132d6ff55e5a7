# SPDX-License-Identifier: Apache-2.0
"""Bearings of planets on their pins: one linear bearing for each planet, or rolling bearings."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from pitchpoint.io.rexs.conversion.bearings import (
    LINEAR_DAMPING,
    ROLLING,
    sides_of,
    stiffness_of,
    sum_of_stiffness,
)
from pitchpoint.io.rexs.conversion.planets import Circle
from pitchpoint.io.rexs.conversion.rolling import CONTACT_DAMPING, rolling_rows
from pitchpoint.io.rexs.conversion.state import Conversion, q
from pitchpoint.io.rexs.document import RexsComponent


def convert_planet_bearings(
    conversion: Conversion,
    stage: RexsComponent,
    circle: Circle,
    carrier: str,
    values: dict[str, Any],
) -> None:
    """Add the bearings of the planets: the sum of linear ones, and rolling bearings one by one.

    Parameters
    ----------
    conversion, stage, circle
        The conversion, the planetary stage and the circle of planets.
    carrier
        Name of the carrier.
    values
        Entry of the model file, to which `motion` and `bearing` are added.
    """
    planets, planet_name = circle.planets, circle.planet_name
    main = circle.order[0]
    shafts = {planet.shaft.id: k for k, planet in enumerate(planets)}
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
        middle = conversion.need(planets[k].gears[main], "u_coordinate_on_shaft", "mm")
        if u is None or middle is None:
            return
        name = conversion.name(bearing)
        sign = planets[k].sign
        path = f"rolling_bearings.{name}"
        rows = rolling_rows(conversion, bearing, path, sign) if bearing.type in ROLLING else []
        if not rows:
            target = f"planetary_stages.{circle.name}.bearing.stiffness"
            linear[k].append((stiffness_of(conversion, bearing, target), sign * (u - middle)))
            continue
        rolling = True
        planet = f"{planet_name}_{k + 1}"
        ends = [planet, carrier] if inner else [carrier, planet]
        for number, (offset, data) in enumerate(rows):
            own = name if len(rows) == 1 else conversion.free(f"{name}_{number + 1}")
            place = q(sign * (u - middle) + offset, "length")
            entry = {"ends": ends, "position": [0, 0, place], **data}
            conversion.put("rolling_bearings", bearing, entry, own)
            text, target = f"{CONTACT_DAMPING:g} s/m", f"rolling_bearings.{own}.damping"
            conversion.default(bearing, "damping", text, target, "REXS has no damping")
    values["motion"] = "free"
    matrices = [sum_of_stiffness(parts) for parts in linear]
    stiff = [m for m in matrices if m.any()]
    if not stiff and rolling:
        return
    if not stiff:
        values["motion"] = "torsion"
        text = "planets turn on rigid pins"
        conversion.default(stage, "bearings of the planets", text, f"planetary_stages.{circle.name}.motion")
        return
    if any(not np.allclose(m, stiff[0], rtol=1e-9) for m in matrices):
        conversion.changed(stage, "bearings", "those of the first planet", "", "planets of a stage are equal")
    values["bearing"] = {"stiffness": _entry(stiff[0]), "damping": {"ratio": LINEAR_DAMPING}}
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
