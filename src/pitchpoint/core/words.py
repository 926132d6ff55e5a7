# SPDX-License-Identifier: Apache-2.0
"""Lists of names in sentences."""

from __future__ import annotations

import re
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


def ranges(names: Iterable[str]) -> str:
    """List of names as text, with three and more that differ only by a number as a range; may be empty.

    Examples
    --------
    >>> ranges(["motor", "sun-planet_1", "sun-planet_2", "sun-planet_3"]), ranges([])
    ('motor and sun-planet_1 … sun-planet_3', '')
    """
    groups: dict[str, list[str]] = {}
    for name in dict.fromkeys(names):
        groups.setdefault(re.sub(r"\d+", "#", name), []).append(name)
    parts = [
        part
        for group in groups.values()
        for part in ([f"{group[0]} … {group[-1]}"] if len(group) > 2 else group)
    ]
    return listed(parts) if parts else ""
