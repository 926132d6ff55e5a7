# SPDX-License-Identifier: Apache-2.0
"""Conversion of units that are not in the unit table, by pint.

A separate module, so that pint is imported only if a file uses such a unit. Rates (per time alone) are
refused here, because pint does not distinguish revolutions, cycles and radians.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from pitchpoint.core.errors import UnitError


@lru_cache(maxsize=1)
def _registry() -> Any:
    import pint

    return pint.UnitRegistry(cache_folder=None)


def foreign_unit(name: str) -> tuple[float, int, int, int, int]:
    """Resolve a unit name to its SI factor and the exponents of m, kg, s, K.

    Parameters
    ----------
    name
        A single unit name, without operators.

    Examples
    --------
    >>> foreign_unit("yard")
    (0.9144, 1, 0, 0, 0)
    """
    try:
        registry = _registry()
        unit = registry.Unit(name)
        quantity = registry.Quantity(1.0, unit).to_base_units()
        shift = registry.Quantity(0.0, unit).to_base_units().magnitude
        dims = {str(k): v for k, v in unit.dimensionality.items()}
    except Exception:  # noqa: BLE001
        # pint raises various exceptions for unknown names, depending on its version
        raise UnitError(f"unknown unit '{name}'") from None
    powers = [dims.pop(f"[{d}]", 0) for d in ("length", "mass", "time", "temperature")]
    if dims or any(p != int(p) for p in powers):
        raise UnitError(f"the unit '{name}' is not a mechanical unit")
    if shift != 0.0:
        raise UnitError(f"the unit '{name}' has an offset from the SI zero point; use an absolute unit")
    if powers[0] == powers[1] == powers[3] == 0:
        raise UnitError(f"the unit '{name}' is ambiguous; use rad, deg, rpm, Hz or rad/s")
    m, kg, s, kelvin = (int(p) for p in powers)
    return float(quantity.magnitude), m, kg, s, kelvin
