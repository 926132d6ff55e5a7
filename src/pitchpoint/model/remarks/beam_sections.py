# SPDX-License-Identifier: Apache-2.0
"""Remarks on sections of beams in files, whose mass and stiffness no material has."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import Message, remark
from pitchpoint.geometry.section_table import SectionTable
from pitchpoint.model.beam_tables import beam_table_of
from pitchpoint.model.components.beam import FILES
from pitchpoint.model.frames import beam_length

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

SLOWEST_SOUND, FASTEST_SOUND = 500.0, 13_000.0
"""Speeds of sound in bars: below that of lead, above that of carbon fibres and beryllium [m/s]."""
THICK = 0.1
"""Radius of gyration over the length that no slender beam has."""


def implausible_sections(model: Model) -> tuple[Message, ...]:
    """A remark for every file whose mass and stiffness contradict each other, as in other units.

    The square root of the axial stiffness over the mass is the speed of sound in the bar. That of the bending
    stiffness over the mass is this speed times the radius of gyration of the section, which is small compared
    with the length.
    """
    found: dict[str, Message] = {}
    for name, beam in model.beams.items():
        if (
            beam.properties is None
            or (key := next((k for k in FILES if getattr(beam.properties, k)), None)) is None
        ):
            continue
        table, length = beam_table_of(beam.properties), beam_length(model, beam)
        file = str(getattr(beam.properties, key))
        if isinstance(table, SectionTable):
            mass, axial = table.inertia[:, 0, 0], table.stiffness[:, 2, 2]
            bending = np.maximum(table.stiffness[:, 3, 3], table.stiffness[:, 4, 4])
        else:
            mass, axial = table.mass, table.axial
            bending = np.maximum(table.bending_1, table.bending_2)
        heavy = mass > 0.0
        if file in found or not heavy.any() or not length:
            continue
        text = ""
        if axial.size and "axial" not in beam.properties.lists:
            sound = np.sqrt(axial[heavy] / mass[heavy])
            worst = sound.max() if sound.max() > FASTEST_SOUND else sound.min()
            if not SLOWEST_SOUND <= worst <= FASTEST_SOUND:
                limit = f"{SLOWEST_SOUND:g} to {FASTEST_SOUND:g} m/s"
                text = f"axial stiffness and mass give a speed of sound of {worst:.3g} m/s (limit {limit})"
        radius = float(np.sqrt(bending[heavy] / mass[heavy]).max()) / FASTEST_SOUND
        if not text and radius > THICK * length:
            text = (
                f"bending stiffness and mass require a radius of gyration of the section of {radius:.3g} m "
                f"even for the stiffest material (limit {THICK * length:.3g} m, a tenth of the length)"
            )
        if text:
            found[file] = remark(f"beams.{name}.properties.{key}", text, "check units: N, N m^2 and kg/m")
    return tuple(found.values())
