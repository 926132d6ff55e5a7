# SPDX-License-Identifier: Apache-2.0
"""Blades of wind turbines in a scene: sections from chord, twist and place of the aerodynamic stations."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.rotor.separation import separation
from pitchpoint.report.scene.shapes import skin
from pitchpoint.viz.scene.content import SceneSolid

if TYPE_CHECKING:
    from pitchpoint.geometry.rotor.blade import Rotor
    from pitchpoint.model.model import Model
    from pitchpoint.report.scene.places import Places
    from pitchpoint.system.rules.wind_rotor import Station

Array = NDArray[np.float64]
CORNERS = 32
"""Corners of a section."""
BETWEEN = 4
"""Sections drawn per distance of two stations."""
THIN, THICK, DECAY = 0.18, 0.35, 10.0
"""Thickness over the chord at the tip, at a root with lift, and how fast it decreases over the radius; files
have no shapes of sections. A cylindrical root has a thickness of 1."""
ROUND, SHARP = 1.0, 0.45
"""Thickness over the chord from which a section is a circle, and below which it has a sharp edge."""
AHEAD = 0.25
"""Distance of the aerodynamic centre from the leading edge over the chord."""


def blade_rings(model: Model) -> dict[str, Array]:
    """Sections of the blades on beams by the name of the beam: corners in the world, shape (n, k, 3) [m]."""
    from pitchpoint.system.rules.wind_rotor import blades_of

    found: dict[str, Array] = {}
    for name, part in model.wind_rotors.items():
        if part.beams:
            rotor, blades = blades_of(model, name)
            found |= {b: _rings(rotor, s) for b, s in zip(part.beams, blades, strict=True)}
    return found


def rigid_blades(model: Model, at: Places) -> list[SceneSolid]:
    """Solids of the blades that are fixed to a hub or to a body each."""
    from pitchpoint.model.frames import split
    from pitchpoint.system.rules.wind_rotor import blades_of

    found = []
    for name, part in model.wind_rotors.items():
        if part.beams:
            continue
        rotor, blades = blades_of(model, name)
        for k, stations in enumerate(blades):
            rings = _rings(rotor, stations)
            owner = part.bodies[k] if part.bodies else split(part.hub)[0]
            body, origin, axes = at.seat(owner)
            found.append(
                SceneSolid(
                    name=f"{name}, blade {k + 1}",
                    kind="body",
                    body=body,
                    points=(rings.reshape(-1, 3) - origin) @ axes,
                    triangles=skin(len(rings), CORNERS),
                )
            )
    return found


def _rings(rotor: Rotor, stations: list[Station]) -> Array:
    """Sections of one blade from the root to the tip: circles, then sections with lift that become thin."""
    from scipy.interpolate import PchipInterpolator

    places = np.array([station.place for station in stations])
    chords = rotor.blade.chord[:, None] * np.array([station.chord for station in stations])
    spans = np.array([station.span for station in stations])
    way = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(places, axis=0), axis=1)))
    _, kept = np.unique(way, return_index=True)
    columns = np.column_stack([places, chords, spans, _thickness(rotor, way)])[kept]
    count = BETWEEN * (len(kept) - 1) + 1
    fine = np.interp(np.arange(count) / BETWEEN, np.arange(len(kept)), way[kept])
    found = PchipInterpolator(way[kept], columns)(fine)
    place, chord, span, thick = found[:, :3], found[:, 3:6], found[:, 6:9], found[:, 9]
    normal = np.cross(span / np.linalg.norm(span, axis=1)[:, None], chord)
    angle = 2.0 * np.pi * np.arange(CORNERS) / CORNERS
    x, y = 0.5 * np.cos(angle), 0.5 * np.sin(angle)
    circle = np.clip((thick - SHARP) / (ROUND - SHARP), 0.0, 1.0)[:, None]
    along = x - (1.0 - circle) * (0.5 - AHEAD)
    height = thick[:, None] * y * (circle + (1.0 - circle) * 1.4 * (0.55 + x) ** 0.6)
    rings: Array = place[:, None] + along[:, :, None] * chord[:, None] + height[:, :, None] * normal[:, None]
    return rings


def _thickness(rotor: Rotor, way: Array) -> Array:
    """Thickness over the chord of the stations at some distances from the root [m]."""
    lifting = [separation(polar) is not None for polar in rotor.blade.polars]
    first = next((k for k, row in enumerate(rotor.blade.polar_index) if lifting[row]), len(way))
    start = way[max(first - 1, 0)]
    most = ROUND if first else THICK
    share = np.maximum(way - start, 0.0) / max(float(way[-1] - start), 1e-9)
    return THIN + (most - THIN) * np.exp(-DECAY * share)
