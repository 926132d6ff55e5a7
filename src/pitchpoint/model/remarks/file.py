# SPDX-License-Identifier: Apache-2.0
"""Remarks on what is written in a model file: numbers without unit, parameters without use."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, remark
from pitchpoint.model.reading.bare_numbers import messages_on

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

_WORDS = re.compile(r"[A-Za-z_]\w*")


def numbers_without_unit(model: Model) -> tuple[Message, ...]:
    """A remark for every number without unit that is rarely meant in SI units."""
    return messages_on(model.origin.bare, model.line)


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
