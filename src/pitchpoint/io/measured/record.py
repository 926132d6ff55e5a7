# SPDX-License-Identifier: Apache-2.0
"""Contents of a measured file, before they are checked: columns of numbers, units, time or sample rate."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, PitchpointError
from pitchpoint.io.measured.stated import Stated

TIME_NAMES = ("time", "t", "zeit", "temps", "tiempo", "timestamp")
"""Common names of a time axis."""


OPTIONS = {"sample_rate": "--sample-rate", "channels": "--channel", "units": "--unit"}
"""Options of the command line for the arguments of `read_measured`."""


class MeasuredError(PitchpointError, ValueError):
    """A measured file cannot be used; the message gives place, value, limit and remedy."""


def as_options(text: str) -> str:
    """Message with the options of the command line in place of the arguments of `read_measured`.

    Examples
    --------
    >>> as_options("choose fewer channels by channels=, or give units={'a': '2 N'}")
    "choose fewer channels by --channel, or give --unit 'a=2 N'"
    """
    text = re.sub(r"units=\{'([^'{}]*)': '([^'{}]*)'\}", r"--unit '\1=\2'", text)
    return re.sub(r"\b(sample_rate|channels|units)=(?![\w'\"])", lambda found: OPTIONS[found[1]], text)


@dataclass(frozen=True)
class Column:
    """One channel of a file.

    Attributes
    ----------
    name
        As in the file.
    values
        Shape (n,), as in the file.
    unit
        Text of the unit, empty if not given.
    long_name
        Description, if the file has one.
    scale
        Conversion of the numbers in the file to `values`, if any.
    """

    name: str
    values: NDArray[np.float64]
    unit: str = ""
    long_name: str = ""
    scale: str = ""


@dataclass(frozen=True)
class Record:
    """Contents of one file.

    Attributes
    ----------
    form
        Format in words, as in "CSV".
    columns
        Channels, without the time axis.
    time
        Time axis with its unit, None if the file has none.
    resolution
        Resolution of the times in the file, in the unit of `time`.
    rates
        Sample rates given in the file; they may contradict each other.
    start
        Time of the first sample [s] given in the file.
    speed
        Rotation frequency of a shaft given in the file [Hz], or None.
    fault_orders
        Orders of the fault frequencies of a bearing given in the file [-].
    notes
        Remarks, such as omitted columns.
    attributes
        Other metadata of the file.
    """

    form: str
    columns: tuple[Column, ...]
    time: Column | None = None
    resolution: float = 0.0
    rates: tuple[Stated, ...] = ()
    start: float = 0.0
    speed: Stated | None = None
    fault_orders: Mapping[str, float] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    attributes: Mapping[str, str | float | int] = field(default_factory=dict)


@dataclass(frozen=True)
class Wanted:
    """Requested channels: names, or None for all."""

    channels: tuple[str, ...] | None = None

    def takes(self, name: str) -> bool:
        """Whether a channel of this name is to be read."""
        return self.channels is None or name in self.channels


def refused(
    path: Path,
    where: str,
    value: str,
    message: str,
    limit: str | None = None,
    remedy: str | None = None,
    *,
    line: int | None = None,
) -> MeasuredError:
    """Error with place, value, limit and remedy."""
    place = f"{path}: {where}" if where else str(path)
    return MeasuredError(str(Message(place, message, value or None, limit, remedy, line)))


def truncated(path: Path, promised: int, there: int, what: str = "bytes") -> MeasuredError:
    """Error for a file that ends before the size given in its header."""
    return refused(
        path,
        "",
        f"{there} {what}",
        "are there, the file promises more; it is damaged or was cut off",
        f"{promised} {what}",
        "copy it again from where it was recorded",
    )


def header_rate(rate: float) -> Stated:
    """Sample rate [Hz] in the header of a format."""
    return Stated("header", float(rate), f"{rate:g} Hz")


def as_floats(values: NDArray[Any]) -> NDArray[np.float64]:
    """Numbers in double precision; invalid bit patterns become NaN without a warning."""
    with np.errstate(all="ignore"):
        return np.ascontiguousarray(values, np.float64)


def key_of(name: str) -> str:
    """Normalised name without case, spaces and hyphens, for comparison with `TIME_NAMES`.

    Examples
    --------
    >>> key_of(" Sample Rate "), key_of("bearing.sr")
    ('sample_rate', 'sr')
    """
    return re.sub(r"[\s\-]+", "_", re.split(r"[./]", name.strip().lower())[-1])


_HEAD = re.compile(r"^(.*?)(\s*)[\[(]([^\[\]()]*(?:\([^()]*\))?[^\[\]()]*)[\])]$")


def split_name(text: str) -> tuple[str, str]:
    """Split `name [unit]`; round brackets, or brackets without a space before them, hold only known units.

    Examples
    --------
    >>> split_name("acceleration [m/s^2]"), split_name("speed (rpm)"), split_name("front (left)")
    (('acceleration', 'm/s^2'), ('speed', 'rpm'), ('front (left)', ''))
    >>> split_name("mesh_force[stage]"), split_name("mesh_force[stage] [N]"), split_name("sound [Furz]")
    (('mesh_force[stage]', ''), ('mesh_force[stage]', 'N'), ('sound', 'Furz'))
    """
    from pitchpoint.io.measured.units import is_unit

    text = text.strip()
    found = _HEAD.match(text)
    if found is None or not found[1].strip():
        return text, ""
    unit = found[3].strip()
    stated = bool(found[2]) and text.endswith("]")
    return (found[1].strip(), unit) if stated or is_unit(unit) else (text, "")
