# SPDX-License-Identifier: Apache-2.0
"""Options with ranges of quantities, `300..7200 rpm`, and with selections of modes."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any, TypeVar

import click

F = TypeVar("F", bound=Callable[..., Any])

_NUMBER = re.compile(r"\s*[-+]?[\d.]*\d(?:[eE][-+]?\d+)?\s*")


def range_of(text: str, dimension: str) -> tuple[float, float]:
    """Range LOW..HIGH in SI; a low end without unit has that of the high end, a single value is both ends.

    Examples
    --------
    >>> range_of("0..2 kHz", "frequency"), range_of("50 Hz", "frequency")
    ((0.0, 2000.0), (50.0, 50.0))
    """
    from pitchpoint.core.errors import UnitError
    from pitchpoint.core.units import parse_quantity

    low, dots, high = text.partition("..")
    if not dots:
        high = low
    elif _NUMBER.fullmatch(low):
        low += " " + high[match.end() :] if (match := _NUMBER.match(high)) else ""
    try:
        found = parse_quantity(low.strip(), dimension), parse_quantity(high.strip(), dimension)
    except UnitError as error:
        raise click.BadParameter(str(error)) from None
    if found[0] > found[1] or found[0] < 0.0:
        raise click.BadParameter(f"{text!r}: a range is LOW..HIGH with 0 <= LOW <= HIGH")
    return found


def quantities(flag: str, dimension: str, metavar: str, description: str) -> Callable[[F], F]:
    """Option that takes a range of a quantity and returns its ends in SI."""

    def convert(_: click.Context, __: click.Parameter, text: str | None) -> tuple[float, float] | None:
        """Convert the text of the option."""
        if text is None:
            return None
        from pitchpoint.cli.settings import say_bare_option

        found = range_of(text, dimension)
        say_bare_option(text.rpartition("..")[2], dimension, flag)
        return found

    return click.option(flag, metavar=metavar, callback=convert, help=description)


def modes_of(text: str | None) -> tuple[int | None, range | str | None]:
    """Number of modes to compute, and the selection among them: a number, a range A..B, or part of a name.

    Examples
    --------
    >>> modes_of("12"), modes_of("3..8"), modes_of("bending"), modes_of(None)
    ((12, None), (8, range(3, 9)), (None, 'bending'), (None, None))
    """
    if text is None:
        return None, None
    found = re.fullmatch(r"\s*(\d+)\s*(?:\.\.\s*(\d+)\s*)?", text)
    if found is None:
        return None, text.strip()
    first, last = int(found[1]), int(found[2] or found[1])
    if not 0 < first <= last:
        raise click.BadParameter(
            f"{text!r}: give a number of modes, a range such as 3..8 or a part of a name"
        )
    return last, range(first, last + 1) if found[2] else None
