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


def shortened(words: str, most: int) -> str:
    """Text in which longer names have … in the middle.

    Parameters
    ----------
    words
        Names, separated by spaces or commas.
    most
        Largest number of letters of a name.

    Examples
    --------
    >>> shortened("shaft_1 and not_a_catalogue_bearing_33016_rolling_60", 20)
    'shaft_1 and not_a_cat…rolling_60'
    """

    def short(name: re.Match[str]) -> str:
        """One name."""
        word, head = name[0], (most - 1) // 2
        return word if len(word) <= most else f"{word[:head]}…{word[head + 1 - most :]}"

    return re.sub(r"[^\s,]+", short, words)
