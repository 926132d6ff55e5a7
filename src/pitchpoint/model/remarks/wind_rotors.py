# SPDX-License-Identifier: Apache-2.0
"""Remarks on the files of the rotors of wind turbines."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, remark
from pitchpoint.model.rotor_input import rotor_input

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def unused_polars(model: Model) -> tuple[Message, ...]:
    """A remark for every airfoil or polar of a windIO file that is not used."""
    return tuple(
        remark(f"wind_rotors.{name}.windio", each)
        for name, part in model.wind_rotors.items()
        for each in rotor_input(part).notes
    )
