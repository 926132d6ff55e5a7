# SPDX-License-Identifier: Apache-2.0
"""Parameters: named values for the keys and formulas of a model file."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.keys import key, text


@dataclass(frozen=True)
class Parameter(Component):
    """A value with a name, used in other values and in formulas."""

    value: float | str = key(
        "parameter", "number with its unit, or a formula of other parameters", sample="25 mm"
    )
    text: str = text("description for reports", "")
