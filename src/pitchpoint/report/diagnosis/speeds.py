# SPDX-License-Identifier: Apache-2.0
"""Speeds as users know them: a nominal value with a tolerance, or a range."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from pitchpoint.analysis.sampled import SignalError
from pitchpoint.core.errors import UnitError

TOLERANCE = 0.02
"""Relative tolerance of a speed without a stated one: nominal speeds deviate by the slip of the motor and by
the accuracy of drives and displays."""
LARGEST = 0.1
"""Largest relative tolerance: beyond it harmonics of neighbouring numbers overlap."""
_SIGN = re.compile(r"\s*(?:±|\+/-|\+-)\s*")
_NUMBER = re.compile(r"\s*[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?\s*")
_HERTZ = re.compile(r"\s*[-+.\deE]+\s*[kM]?Hz\s*")


@dataclass(frozen=True)
class GivenSpeed:
    """Speed of a shaft.

    Attributes
    ----------
    shaft
        Name of the shaft; empty if not given.
    frequency
        Nominal rotation frequency [Hz]; of a range the upper limit.
    tolerance
        Relative tolerance [-].
    stated
        Whether the tolerance was stated.
    lowest
        Lower limit of a range [Hz]; None if the speed is constant.
    """

    shaft: str
    frequency: float
    tolerance: float
    stated: bool
    lowest: float | None = None


def given_speed(text: str) -> GivenSpeed:
    """Speed of `[SHAFT=]QUANTITY[±TOLERANCE]` or `[SHAFT=]LOW..HIGH`.

    Parameters
    ----------
    text
        Such as "30Hz", "fan=1750rpm±2%", "1750 rpm +- 20 rpm" or "600..1800rpm".

    Raises
    ------
    SignalError
        If the speed or its tolerance is not a quantity, the tolerance is not below 10 %, or a range is empty.

    Examples
    --------
    >>> given_speed("fan=1500rpm±1%")
    GivenSpeed(shaft='fan', frequency=25.0, tolerance=0.01, stated=True, lowest=None)
    >>> given_speed("25 Hz +- 0.5 Hz").tolerance, given_speed("25 Hz").stated
    (0.02, False)
    >>> given_speed("10..30Hz")
    GivenSpeed(shaft='', frequency=30.0, tolerance=0.0, stated=True, lowest=10.0)
    """
    name, equals, quantity = text.rpartition("=")
    if ".." in quantity:
        low, high = _limits(quantity)
        return GivenSpeed(name.strip() if equals else "", high, 0.0, True, low)
    nominal, *rest = _SIGN.split(quantity.strip())
    value = _frequency(nominal)
    tolerance = TOLERANCE
    if rest:
        tolerance = _tolerance(rest, value)
    return GivenSpeed(name.strip() if equals else "", value, tolerance, bool(rest))


def _limits(text: str) -> tuple[float, float]:
    """Limits of a range [Hz]; the lower one has the unit of the upper one unless it has its own."""
    low, _, high = (part.strip() for part in text.partition(".."))
    if not low or not high or high[0] == "." or ".." in high or _SIGN.search(text):
        raise SignalError(f"--speed: {text!r} is not a range; write it as in 600..1800rpm")
    if _NUMBER.fullmatch(high):
        raise SignalError(f"--speed: {text!r} has no unit; write it as in {low}..{high}rpm")
    if _NUMBER.fullmatch(low):
        unit = _NUMBER.match(high)
        low += high[unit.end() :] if unit else ""
    limits = _frequency(low), _frequency(high)
    if not limits[0] < limits[1]:
        raise SignalError(
            f"--speed: range {text} (limit: the lower speed first); write it as in 600..1800rpm"
        )
    return limits


def _tolerance(rest: list[str], frequency: float) -> float:
    """Relative tolerance of a percentage or a speed."""
    from pitchpoint.core.units import parse_quantity

    [text] = rest if len(rest) == 1 else [" ± ".join(rest)]
    if _NUMBER.fullmatch(text):
        number = text.strip()
        raise SignalError(f"--speed: tolerance {number} has no unit; write ±{number}% or ±{number}rpm")
    try:
        if text.rstrip().endswith("%"):
            found = parse_quantity(text, "dimensionless", nonnegative=True)
        else:
            found = _frequency(text, zero=True) / frequency
    except UnitError as error:
        raise SignalError(
            f"--speed: {text!r} is not a tolerance; write it as in 1750rpm±2% or 1750rpm±20rpm"
        ) from error
    if found > LARGEST:
        raise SignalError(
            f"--speed: tolerance {100.0 * found:.3g} % (limit 10 %); give the speed more closely"
        )
    return found


def _frequency(text: str, *, zero: bool = False) -> float:
    """Rotation frequency [Hz]."""
    from pitchpoint.core.units import parse_quantity

    limit = {"nonnegative": True} if zero else {"positive": True}
    try:
        if _HERTZ.fullmatch(text):
            return float(parse_quantity(text, "frequency", **limit))
        return float(parse_quantity(text, "angular_speed", **limit)) / math.tau
    except UnitError as error:
        raise SignalError(f"--speed: {error}") from None
