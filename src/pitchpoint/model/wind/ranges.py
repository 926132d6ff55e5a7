# SPDX-License-Identifier: Apache-2.0
"""Ranges of the numbers that describe wind; all problems of a description are reported together."""

from __future__ import annotations

import math
from typing import Any

from pitchpoint.core.errors import Message, ModelError


class Ranges:
    """Problems of one description.

    Parameters
    ----------
    where
        Name of the description in messages.
    """

    def __init__(self, where: str) -> None:
        self.where = where
        self.problems: list[Message] = []

    def within(self, name: str, value: Any, low: float, high: float, unit: str) -> bool:
        """Whether a number is finite and from `low` to `high`; otherwise a problem is added.

        Parameters
        ----------
        name, value
            Name of the number, and the number in the SI unit.
        low, high
            Limits, both permitted.
        unit
            Unit of the message.
        """
        number = isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
        if number and low <= value <= high:
            return True
        limit = f"{low:g} to {high:g} {unit}".rstrip()
        text = "is out of range" if number else "is not a finite number"
        place = f"{self.where}.{name}"
        shown = f"{value:.6g}" if number else f"{value}"
        self.problems.append(Message(place, text, f"{shown} {unit}".rstrip(), limit, "correct this value"))
        return False

    def count(self, name: str, value: Any, low: int, high: int) -> bool:
        """Whether a number is an integer from `low` to `high`; otherwise a problem is added.

        Parameters
        ----------
        name, value
            Name of the number, and the number.
        low, high
            Limits, both permitted.
        """
        if isinstance(value, int) and not isinstance(value, bool) and low <= value <= high:
            return True
        place = f"{self.where}.{name}"
        text = "is not a permitted number"
        self.problems.append(Message(place, text, f"{value}", f"{low} to {high}", "write a whole number"))
        return False

    def choice(self, name: str, value: Any, names: tuple[str, ...]) -> bool:
        """Whether a word is one of `names`; otherwise a problem is added.

        Parameters
        ----------
        name, value
            Name of the choice, and the word.
        names
            Permitted words.
        """
        if value in names:
            return True
        place = f"{self.where}.{name}"
        self.problems.append(
            Message(place, "is not known", repr(value), ", ".join(names), "write one of these")
        )
        return False

    def finish(self) -> None:
        """Report the problems.

        Raises
        ------
        ModelError
            If there are any.
        """
        if self.problems:
            raise ModelError(self.problems)
