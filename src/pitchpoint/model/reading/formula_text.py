# SPDX-License-Identifier: Apache-2.0
"""Distinction between a formula and a number with a unit."""

from __future__ import annotations

import re
from collections.abc import Collection

WORDS = re.compile(r"(?<![\w.])[A-Za-z_]\w*")
_CALL = re.compile(r"[A-Za-z_]\w*\s*\([^()]*[,\d]|\b(?:sin|cos|tan|sqrt|exp|log|abs)\s*\(")
_POWER = re.compile(r"(?:\^|\*\*)\s*\(?\s*[+-]?\d+\s*\)?|(?<=[A-Za-zµ°])-?\d+|(?<![\d.])1\s*(?=/)")
_NUMBER = re.compile(r"(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?")
_OPERATOR = re.compile(r"[+*/^()-]|\s−")
_BEGINS = re.compile(r"\s*[-+(\s]*[A-Za-z_]")


def is_formula(text: str, names: Collection[str]) -> bool:
    """Whether a text is a formula rather than a number with a unit.

    Parameters
    ----------
    text
        The text.
    names
        Names of parameters.

    Examples
    --------
    >>> is_formula("302.585 mm * cos(120 deg)", ()), is_formula("14 N/(mm um)", ()), is_formula("a/2", {"a"})
    (True, False, True)
    """
    words = set(WORDS.findall(text))
    if words & {"pi", *names} or _CALL.search(text):
        return True
    if "," in text:
        return False
    rest = _POWER.sub(" ", text)
    numbers = _NUMBER.findall(rest)
    plain = _NUMBER.sub(" ", rest)
    if len(numbers) > 1 and _OPERATOR.search(plain.strip().lstrip("+-")):
        return True
    return "+" in plain.strip().lstrip("+-") or (bool(names) and _BEGINS.match(text) is not None)
