# SPDX-License-Identifier: Apache-2.0
"""Remarks on sections of beams in files, whose mass and stiffness no material has."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, remark
from pitchpoint.geometry.beam_table import BeamTable
from pitchpoint.geometry.section_table import SectionTable
from pitchpoint.model.beam_tables import beam_table_of, part_in_file
from pitchpoint.model.components.beam import FILES
from pitchpoint.model.frames import beam_length

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

FloatArray = NDArray[np.float64]
POINTS = 401
"""Points of the integrals over a beam."""

SLOWEST_SOUND, FASTEST_SOUND = 500.0, 13_000.0
"""Speeds of sound in bars: below that of lead, above that of carbon fibres and beryllium [m/s]."""
THICK = 0.1
"""Radius of gyration over the length that no slender beam has."""
WEIGHT = 9.81
"""Gravity [m/s²] of the deflection of a beam by its own weight."""
LIMP = 0.25
"""Deflection of a horizontal cantilever by its own weight, over its length, that no blade or tower has: it is
0.019 for the blades of the NREL 5 MW and the IEA 15 MW turbines, 0.006 for their towers."""


def implausible_sections(model: Model) -> tuple[Message, ...]:
    """A remark for every file whose mass and stiffness contradict each other, as in other units.

    The square root of the axial stiffness over the mass is the speed of sound in the bar. That of the bending
    stiffness over the mass is this speed times the radius of gyration of the section, which is small compared
    with the length. A beam of a turbine carries its own weight.
    """
    found: dict[str, Message] = {}
    for name, beam in model.beams.items():
        key = (
            None if beam.properties is None else next((k for k in FILES if getattr(beam.properties, k)), None)
        )
        if beam.properties is None or key is None:
            continue
        table, length = beam_table_of(beam.properties), beam_length(model, beam)
        file = str(getattr(beam.properties, key))
        if file in found or not length:
            continue
        text = _contradiction(table, length, "axial" in beam.properties.lists)
        if text:
            found[file] = remark(f"beams.{name}.properties.{key}", text, "check units: N, N m^2 and kg/m")
    return tuple(found.values())


def _contradiction(table: BeamTable | SectionTable, length: float, own_axial: bool) -> str:
    """What is implausible in the properties of a beam; "" if nothing is."""
    if isinstance(table, SectionTable):
        mass, axial = table.inertia[:, 0, 0], table.stiffness[:, 2, 2]
        both = table.stiffness[:, 3, 3], table.stiffness[:, 4, 4]
    else:
        mass, axial, both = table.mass, table.axial, (table.bending_1, table.bending_2)
    heavy = mass > 0.0
    if not heavy.any():
        return ""
    if axial.size and not own_axial:
        sound = np.sqrt(axial[heavy] / mass[heavy])
        worst = sound.max() if sound.max() > FASTEST_SOUND else sound.min()
        if not SLOWEST_SOUND <= worst <= FASTEST_SOUND:
            limit = f"{SLOWEST_SOUND:g} to {FASTEST_SOUND:g} m/s"
            return f"axial stiffness and mass give a speed of sound of {worst:.3g} m/s (limit {limit})"
    radius = float(np.sqrt(np.maximum(*both)[heavy] / mass[heavy]).max()) / FASTEST_SOUND
    if radius > THICK * length:
        return (
            f"bending stiffness and mass require a radius of gyration of the section of {radius:.3g} m "
            f"even for the stiffest material (limit {THICK * length:.3g} m, a tenth of the length)"
        )
    sag = _sag(table.position * length, mass, np.minimum(*both))
    if sag > LIMP * length:
        return (
            f"as a horizontal cantilever it deflects by {sag:.3g} m under its own weight "
            f"(limit {LIMP * length:.3g} m, a quarter of the length)"
        )
    return ""


def _sag(at: FloatArray, mass: FloatArray, bending: FloatArray) -> float:
    """Deflection of the end of a cantilever by its own weight [m], linear.

    Examples
    --------
    The closed form of a uniform beam is m g L^4/(8 EI).

    >>> L = np.array([0.0, 10.0])
    >>> round(_sag(L, np.array([8.0, 8.0]), np.array([9810.0, 9810.0])), 3)
    10.0
    """
    x = np.linspace(0.0, at[-1], POINTS)
    m, stiffness = (np.interp(x, at, values) for values in (mass, bending))
    dx = x[1] - x[0]
    beyond = [np.cumsum((values[1:] + values[:-1])[::-1])[::-1] * 0.5 * dx for values in (m, m * x)]
    weight, first = (np.r_[values, 0.0] for values in beyond)
    moment = WEIGHT * (first - x * weight)
    return float(np.trapezoid(moment * (at[-1] - x) / stiffness, x))


def parts_of_other_files(model: Model) -> tuple[Message, ...]:
    """A remark for every blade file of a beam that is not a blade, next to rotors with elastic blades."""
    blades = {beam for rotor in model.wind_rotors.values() for beam in rotor.beams}
    found = []
    for name, beam in model.beams.items():
        if (
            not blades
            or name in blades
            or beam.properties is None
            or part_in_file(beam.properties) != "blade"
        ):
            continue
        key = next(k for k in FILES if getattr(beam.properties, k))
        text = "describes a blade, and the beam is not among the beams of a wind rotor"
        found.append(remark(f"beams.{name}.properties.{key}", text, "give the file of the tower"))
    return tuple(found)
