# SPDX-License-Identifier: Apache-2.0
"""Remarks on the files of the rotors of wind turbines."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import Message, remark
from pitchpoint.model.checks.wind_boxes import box_extent, rotor_reach, winds_of_scenario
from pitchpoint.model.frames import axes_of
from pitchpoint.model.rotor_input import rotor_input

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

FLAT = 1.0
"""Largest twist of a blade that may be in another unit [deg]."""
ACROSS = 1e-6
"""Cosine of the angle between an axis and the wind that is across it, rounding errors included."""
MAKE = "use a longer file, such as with pitchpoint wind --duration"


def repeated_turbulence(model: Model) -> tuple[Message, ...]:
    """A remark for every scenario in which the turbulence of a file repeats."""
    found = {}
    for part in model.wind_rotors.values():
        for name, wind in winds_of_scenario(model, part):
            box, lasts = model.winds[wind].box, model.scenarios[name].duration or 0.0
            extent = None if box is None else box_extent(box)
            if extent is not None and extent.periodic and lasts > extent.duration * (1.0 + 1e-6):
                text = f"lasts {lasts:.6g} s, and the turbulence of wind {wind} repeats after"
                found[name] = remark(f"scenarios.{name}", f"{text} {extent.duration:.6g} s", MAKE)
    return tuple(found.values())


def flat_blades(model: Model) -> tuple[Message, ...]:
    """A remark for every blade of a file whose twist is so small that it may be in another unit."""
    found = []
    for name, part in model.wind_rotors.items():
        file = "aerodyn" if part.aerodyn is not None else "windio"
        most = float(np.degrees(np.abs(rotor_input(part).rotor.blade.twist).max()))
        if part.blade is None and 0.0 < most < FLAT:
            unit = "AeroDyn and windIO 2 have degrees, windIO 1 has radians"
            text = f"the twist of the blade is at most {most:.3g} deg"
            found.append(remark(f"wind_rotors.{name}.{file}", text, f"check its unit: {unit}"))
    return tuple(found)


def low_rotors(model: Model) -> tuple[Message, ...]:
    """A remark for every rotor whose blades reach the ground, where there is no wind."""
    found = []
    for name, part in model.wind_rotors.items():
        reach = rotor_reach(model, part)
        if reach is not None and reach[2, 0] <= 0.0:
            text = f"the blades reach a height of {reach[2, 0]:.3g} m, and there is no wind at and below 0"
            found.append(remark(f"wind_rotors.{name}.hub", text, "place the hub above ground, z upward"))
    return tuple(found)


def upwind_axes(model: Model) -> tuple[Message, ...]:
    """A remark for every rotor whose axis points upwind, or is across the wind, in all scenarios."""
    found = []
    for name, part in model.wind_rotors.items():
        axis = axes_of(model, part.hub)[:, 2]
        directions = [model.winds[wind].direction for _, wind in winds_of_scenario(model, part)]
        along = [axis[0] * math.cos(angle) + axis[1] * math.sin(angle) for angle in directions]
        if along and max(along) <= ACROSS:
            angle = math.degrees(math.acos(np.clip(max(along), -1.0, 1.0)))
            text = f"the z axis of {part.hub} has an angle of {angle:.3g} deg to the wind"
            remedy = "the blades require an axis downwind: change axes of the hub, or direction of the wind"
            found.append(remark(f"wind_rotors.{name}.hub", text, remedy))
    return tuple(found)


def unused_polars(model: Model) -> tuple[Message, ...]:
    """A remark for every airfoil or polar of a windIO file that is not used."""
    return tuple(
        remark(f"wind_rotors.{name}.windio", each)
        for name, part in model.wind_rotors.items()
        for each in rotor_input(part).notes
    )
