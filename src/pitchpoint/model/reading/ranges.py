# SPDX-License-Identifier: Apache-2.0
"""Comparison of quantities with the ranges of their keys, and corrections of those that are outside."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pitchpoint.core.unit_table import DIMENSIONS
from pitchpoint.core.units import parse_quantity
from pitchpoint.model.keys import Key, Place
from pitchpoint.model.reading import formulas
from pitchpoint.model.reading.bare_numbers import USUAL, is_without_unit, note_number, said_of
from pitchpoint.model.reading.formula_text import WORDS, is_formula
from pitchpoint.model.show import SI, example, limit_text

if TYPE_CHECKING:
    from pitchpoint.model.reading.reader import Reader

HUGE, TINY = 1e60, 1e-60
"""Limits of SI values, so that products of a few quantities neither overflow nor underflow."""
FASTEST = 1e9
"""Maximum rotational speed [rad/s]: the rim of a gear of 1 mm would move at 0.2 % of the speed of light."""


def within(reader: Reader, key: Key, data: Any, value: float, path: Place) -> Any:
    """The value if it is in the range of its key, else BAD with a problem.

    Parameters
    ----------
    reader
        Collects the problem, and numbers without unit that are rarely meant in SI units.
    key
        Description of the key.
    data
        Value as written.
    value
        Value in SI units.
    path
        Path of the key.
    """
    most = FASTEST if key.dimension == "angular_speed" else HUGE
    if not abs(value) <= most or 0.0 < abs(value) < TINY:
        return reader.problem(
            path,
            "is out of the range of computation",
            value=formulas.with_value(reader, key, data, value),
            limit=f"0, or {TINY:g} to {most:g} in SI units",
            remedy=f"write {example(key)}",
        )
    if not key.allows(value):
        return reader.problem(
            path,
            "is out of range",
            value=formulas.with_value(reader, key, data, value),
            limit=limit_text(key),
            remedy=_remedy(reader, key, data, value),
        )
    note_number(reader, key, data, value, path)
    return value


def _remedy(reader: Reader, key: Key, data: Any, value: float) -> str:
    """Remedy for a quantity out of range: the number with its customary unit, or without its sign."""
    if isinstance(data, str) and is_formula(data, reader.parameters):
        for name in WORDS.findall(data):
            if found := said_of(reader, ("parameters", name)):
                return f"{name}: {found}"
        if key.dimension in SI.keys() & USUAL.keys() and is_without_unit(reader, key, data):
            return (
                f"a formula without unit is in {SI[key.dimension]}; multiply it by 1 {USUAL[key.dimension]}"
            )
        return f"correct the formula; the value is {example(key)}, for instance"
    if key.dimension in SI and is_without_unit(reader, key, data):
        meant = f"{str(data).strip()} {DIMENSIONS[key.dimension].example.partition(' ')[2]}"
        fits = key.allows(parse_quantity(meant, key.dimension))
        better = meant if fits else example(key)
        return f"a bare number is in {SI[key.dimension]}; write {better}"
    if isinstance(data, str) and key.allows(-value):
        return f"write {data.strip().lstrip('+-−').strip()}"
    sample = example(key)
    usual = DIMENSIONS[key.dimension].example.split(" or ")[0]
    if key.dimension == "dimensionless" and sample == usual and not key.allows(float(usual)):
        closest = min(max(value, key.minimum), key.maximum)
        sample = f"{closest:g}" if key.allows(closest) else f"a number {limit_text(key)}"
    elif not sample.startswith(("[", "{")) and not key.allows(parse_quantity(sample, key.dimension)):
        sample = f"a value {limit_text(key)}"
    return f"write {sample}"


def is_quoted_number(data: Any) -> bool:
    """Whether a value is a whole number in quotes."""
    return isinstance(data, str) and data.strip().isascii() and data.strip().isdigit()
