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
CORNERS = 24
"""Corners of a section."""
THICKNESS = 0.22
"""Thickness of sections with lift over the chord; airfoil files have no shapes."""
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
    """Sections of one blade: pointed at the trailing edge where there is lift, circles elsewhere."""
    angle = 2.0 * np.pi * np.arange(CORNERS) / CORNERS
    lifting = [separation(polar) is not None for polar in rotor.blade.polars]
    found = []
    for station, chord, polar in zip(stations, rotor.blade.chord, rotor.blade.polar_index, strict=True):
        normal = np.cross(station.span, station.chord)
        along = 0.5 * np.cos(angle)
        if lifting[polar]:
            thick = 0.5 * THICKNESS * np.sin(angle) * (0.55 + along) ** 0.6 * 1.4
            along = along - (0.5 - AHEAD)
        else:
            thick = 0.5 * np.sin(angle)
        ring = chord * (along[:, None] * station.chord + thick[:, None] * normal)
        found.append(station.place + ring)
    return np.array(found)
