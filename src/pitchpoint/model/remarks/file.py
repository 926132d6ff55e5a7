# SPDX-License-Identifier: Apache-2.0
"""Remarks on what is written in a model file: numbers without unit, parameters without use."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, remark
from pitchpoint.core.unit_table import DIMENSIONS
from pitchpoint.core.units import format_quantity
from pitchpoint.model.show import dotted

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

USUAL = {"angular_speed": "rpm", "length": "mm", "angle": "deg"}
"""Unit that a number without unit is probably in."""
_WORDS = re.compile(r"[A-Za-z_]\w*")


def numbers_without_unit(model: Model) -> tuple[Message, ...]:
    """A remark for every number without unit that is rarely meant in SI units."""
    return tuple(
        remark(
            dotted(place),
            f"{value:g} has no unit and is read as {_both(value, dimension)}",
            f"write {value:g} {USUAL[dimension]}, or {value:g} {DIMENSIONS[dimension].si} if that is meant",
            model.line(place),
        )
        for place, value, dimension in model.origin.bare
    )


def _both(value: float, dimension: str) -> str:
    """A value in SI and in its customary unit."""
    in_si, usual = f"{value:g} {DIMENSIONS[dimension].si}", format_quantity(value, dimension)
    return in_si if in_si == usual else f"{in_si} = {usual}"


def unused_parameters(model: Model) -> tuple[Message, ...]:
    """A remark for every parameter of a file that no value uses."""
    if model.file is None and not model.origin.sources:
        return ()
    used = {name for source in model.origin.sources.values() for name in source.names}
    used |= {word for part in model.parameters.values() for word in _WORDS.findall(str(part.value))}
    return tuple(
        remark(f"parameters.{name}", "is not used", "use or remove it", model.line(("parameters", name)))
        for name in model.parameters
        if name not in used
    )
