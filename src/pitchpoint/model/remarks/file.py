# SPDX-License-Identifier: Apache-2.0
"""Remarks on what is written in a model file: numbers without unit, parameters without use."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from pitchpoint.core.errors import FileLine, Message, remark
from pitchpoint.model.reading.bare_numbers import messages_on
from pitchpoint.model.reading.laws import material_source
from pitchpoint.model.signal_units import doubtful

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

_WORDS = re.compile(r"[A-Za-z_]\w*")


def numbers_without_unit(model: Model) -> tuple[Message, ...]:
    """A remark for every number without unit that is rarely meant in SI units."""
    return messages_on(doubtful(model, model.origin.bare), model.line)


def unused_materials(model: Model) -> tuple[Message, ...]:
    """A remark for every material of a file that no part uses; included files may contain a list for several
    models."""
    if model.file is None:
        return ()
    used = {name for source in model.origin.sources.values() for name in source.names}
    return tuple(
        remark(f"materials.{name}", "is not used", "use or remove it", model.line(("materials", name)))
        for name in model.materials
        if material_source(name) not in used
        and not isinstance((model.lines or {}).get(("materials", name)), FileLine)
    )


def temperatures_without_oil(model: Model) -> tuple[Message, ...]:
    """A remark for every load case with the temperature of a lubricant that the file does not have."""
    return tuple(
        remark(
            f"load_cases.{name}.temperature",
            "has no effect without lubricant",
            "add lubricant: {grade: ISO VG 220, temperature: 70 degC}, or remove it",
        )
        for name, case in model.load_cases.items()
        if case.temperature is not None and model.lubricant is None
    )


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
