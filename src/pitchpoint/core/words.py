# SPDX-License-Identifier: Apache-2.0
"""Lists of names in sentences."""

from __future__ import annotations

from collections.abc import Iterable


def listed(names: Iterable[str]) -> str:
    """List of names as text, with `and` before the last.

    Examples
    --------
    >>> listed(["motor"]), listed(["motor", "fan", "pump"])
    ('motor', 'motor, fan and pump')
    """
    found = list(names)
    return found[0] if len(found) == 1 else f"{', '.join(found[:-1])} and {found[-1]}"
