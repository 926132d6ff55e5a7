# SPDX-License-Identifier: Apache-2.0
"""Unit expressions such as "N m/rad": names, products, powers, divisions, brackets; in SI units."""

from __future__ import annotations

import re
from functools import lru_cache

from pitchpoint.core.errors import UnitError
from pitchpoint.core.unit_table import (
    JOINED,
    ONE,
    ONLY_IN_SPEEDS,
    REFUSED,
    UNITS,
    WORDS,
    Unit,
)

_MAX_TEXT = 100
_MAX_POWER = 12
# A power may follow its symbol directly (m2, s-1). A hyphen is a product only between two symbols without
# spaces (N-m), so that a missing operand is detected; a 1 is the numerator of a division or the whole unit.
_TOKEN = re.compile(
    r"\s*(?:(?P<power>(?:\^|\*\*)\s*[+-]?\d+|(?<=[A-Za-zµ°])-?\d+)|(?P<name>[A-Za-zµ°_]+|%)"
    r"|(?P<op>[*/()]|(?<=[\w°%)])-(?=[^\W\d]|[°(]))|(?P<one>(?<![\w°%)\s])1(?=\s*(?:/|$))))\s*"
)
_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_ONE_SIGN = str.maketrans({"μ": "µ", "º": "°"} | dict.fromkeys("·⋅∙•×", "*") | dict.fromkeys("−‐‑–", "-"))
_BRACKETED_POWER = re.compile(r"(\^|\*\*)\s*\(\s*([+-]?\d+)\s*\)")


@lru_cache(maxsize=1024)
def parse_unit(text: str) -> Unit:
    """Parse a unit expression: names, products, powers, one or more divisions, brackets.

    Factors are separated by a space, `*`, `·`, `.` or a hyphen; powers are `^2`, `**2`, `²` or a 2 directly
    after the symbol. A power after a product in one word applies to its last symbol: `kgm2` is `kg m^2`.

    Parameters
    ----------
    text
        Unit such as "kg m^2", "kg-m2", "N/(mm um)", "N·m·s/rad", "N.m", "kNm/rad", "min^-1", "/min".

    Examples
    --------
    >>> parse_unit("N m/rad")[:5]
    (Fraction(1, 1), 2, 1, -2, 0)
    """
    if len(text) > _MAX_TEXT:
        raise UnitError("the unit is too long")
    clean = _BRACKETED_POWER.sub(r"\1\2", text.strip().translate(_ONE_SIGN))
    clean = re.sub(r"(?<=[\w)])\s*\.\s*(?=[^\W\d_(])", "*", clean)
    clean = re.sub(r"[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+", lambda m: "^" + m.group().translate(_SUPERSCRIPTS), clean)
    clean = re.sub(r"^/", "1/", clean)
    tokens: list[tuple[str, str]] = []
    at = 0
    while at < len(clean):
        match = _TOKEN.match(clean, at)
        if match is None or match.lastgroup is None:
            raise UnitError(f"'{text}' is not a unit: unexpected '{clean[at]}'")
        tokens.append((match.lastgroup, match.group(match.lastgroup)))
        at = match.end()
    unit, at = _product(tokens, 0, text, 0)
    if at != len(tokens):
        raise UnitError(f"'{text}' is not a unit: unexpected '{tokens[at][1]}'")
    for kind, word in tokens:
        if kind == "name" and word in ONLY_IN_SPEEDS and unit[1:] != UNITS["rpm"][1:]:
            raise UnitError(f"'{word}' is a revolution in {word}/min only; write rev or rad")
    return unit


def _product(tokens: list[tuple[str, str]], at: int, text: str, depth: int) -> tuple[Unit, int]:
    """Parse factors up to a closing bracket or the end."""
    unit, divided, empty = Unit(ONE), False, True
    while at < len(tokens) and tokens[at] != ("op", ")"):
        sign = 1
        if tokens[at] == ("op", "/") and not empty:
            sign, divided, at = -1, True, at + 1
        elif tokens[at] in (("op", "*"), ("op", "-")) and not empty:
            at += 1
        if sign == 1 and divided:
            raise UnitError(
                f"'{text}' is ambiguous: put everything below the line into brackets, as in N/(mm um)"
            )
        factor, at = _factor_at(tokens, at, text, depth)
        unit, empty = unit.times(factor, sign), False
    if empty:
        raise UnitError(f"'{text}' is not a unit")
    return unit, at


def _factor_at(tokens: list[tuple[str, str]], at: int, text: str, depth: int) -> tuple[Unit, int]:
    """Parse one name, a 1, or a bracket, with its power."""
    kind, word = tokens[at] if at < len(tokens) else ("end", "")
    ahead = Unit(ONE)
    if kind == "name":
        *front, last = JOINED.get(word, (word,))
        unit, at = _lookup(last), at + 1
        for part in front:
            ahead = ahead.times(UNITS[part])
    elif kind == "one":
        unit, at = Unit(ONE), at + 1
    elif word == "(" and depth < 2:
        unit, at = _product(tokens, at + 1, text, depth + 1)
        if at >= len(tokens):
            raise UnitError(f"'{text}' lacks a closing bracket")
        at += 1
    else:
        raise UnitError(f"'{text}' is not a unit")
    if at < len(tokens) and tokens[at][0] == "power":
        power = int(tokens[at][1].lstrip("^*").replace(" ", ""))
        if abs(power) > _MAX_POWER:
            raise UnitError(f"'{text}' has a power beyond {_MAX_POWER}")
        unit, at = Unit(ONE).times(unit, power), at + 1
    return ahead.times(unit), at


def _lookup(name: str) -> Unit:
    """Unit of a name, from the table or from pint."""
    if name in UNITS:
        return UNITS[name]
    if name in REFUSED:
        raise UnitError(f"'{name}' is refused: {REFUSED[name]}")
    one = name.removesuffix("s")
    if one in UNITS and one not in JOINED and (len(one) > 3 or one == "rev"):
        return UNITS[one]
    for word in (name, one):
        if word.lower() in WORDS and word[1:].islower():
            return WORDS[word.lower()]
    from pitchpoint.core._pint import foreign_unit

    try:
        return Unit(*foreign_unit(name))
    except UnitError as error:
        near = [known for known in UNITS if known.lower() == name.lower()]
        guess = f" (did you mean {' or '.join(near)}?)" if near else ""
        raise UnitError(f"{error}{guess}") from None
