# SPDX-License-Identifier: Apache-2.0
"""Remarks on the files of the rotors of wind turbines."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, remark
from pitchpoint.model.checks.wind_boxes import box_extent, winds_of_scenario
from pitchpoint.model.rotor_input import rotor_input

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

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


def unused_polars(model: Model) -> tuple[Message, ...]:
    """A remark for every airfoil or polar of a windIO file that is not used."""
    return tuple(
        remark(f"wind_rotors.{name}.windio", each)
        for name, part in model.wind_rotors.items()
        for each in rotor_input(part).notes
    )
