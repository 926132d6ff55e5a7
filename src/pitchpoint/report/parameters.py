# SPDX-License-Identifier: Apache-2.0
"""Parameters of a model as written, with their values."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.formula.dimension import readable
from pitchpoint.core.unit_table import DIMENSIONS
from pitchpoint.core.units import format_quantity

if TYPE_CHECKING:
    from pitchpoint.core.formula.formula import Amount
    from pitchpoint.model.model import Model

HEAD = ("parameter", "as written", "value", "description")


def parameter_lines(model: Model) -> list[tuple[str, str, str, str]]:
    """Name, text of the file, value in a customary unit and description of every parameter."""
    return [
        (name, str(part.value), value_of(model.amounts[name]), part.text)
        for name, part in model.parameters.items()
    ]


def value_of(amount: Amount) -> str:
    """Value of a parameter in a customary unit.

    Examples
    --------
    >>> from pitchpoint.core.formula.formula import Amount
    >>> value_of(Amount(0.003, "m")), value_of(Amount(100.0, "s^-1 rad")), value_of(Amount(2.0, "m^7"))
    ('3 mm', '954.9297 rpm', '2 m^7')
    """
    unit = readable(amount.unit)
    found = next((name for name, row in DIMENSIONS.items() if row.si == unit), None)
    if found is None:
        return f"{amount.value:.7g} {unit}"
    return format_quantity(amount.value, found, 7)
