# SPDX-License-Identifier: Apache-2.0
"""Files of named arrays (MAT, HDF5): identification of channels, time axis and sample rate.

Vectors and columns of matrices are channels. A vector named `time` or `t` is the time axis, a single number
named `sample_rate`, `fs`, `dt` or similar gives the sample rate; no other arrays are used for these. Other
single numbers and texts become attributes.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.io.measured.record import (
    RATE_NAMES,
    STEP_NAMES,
    TIME_NAMES,
    Column,
    Record,
    Wanted,
    as_floats,
    key_of,
    refused,
)

MAX_BYTES = 1_000_000_000
"""Size of the unpacked arrays of one file, and of the chosen ones in double precision [bytes]: 18 MB of
packed zeros may become a thousand times as much."""
_MAX_COLUMNS = 4096
_TEXT = 200


@dataclass(frozen=True)
class Found:
    """One array of a file.

    Attributes
    ----------
    name
        Full name, `bearing.gs` or `group/force`.
    values
        Numbers, or a function that reads them.
    shape
        Shape of the array; omitted if `values` are given.
    unit, long_name, scale
        As in `record.Column`.
    rate, start
        Sample rate [Hz] and start [s] given with this array, or None.
    """

    name: str
    values: NDArray[Any] | Callable[[], NDArray[Any]]
    shape: tuple[int, ...] | None = None
    unit: str = ""
    long_name: str = ""
    scale: str = ""
    rate: float | None = None
    start: float = 0.0

    @property
    def extent(self) -> tuple[int, ...]:
        """Lengths of the dimensions longer than one."""
        shape = self.values.shape if isinstance(self.values, np.ndarray) else self.shape or ()
        return tuple(int(n) for n in shape if n != 1)

    def read(self) -> NDArray[Any]:
        """Numbers without dimensions of length one."""
        values = self.values if isinstance(self.values, np.ndarray) else self.values()
        return values.reshape(self.extent)


class Arrays:
    """Collects the arrays of one file.

    Parameters
    ----------
    path
        File, for messages.
    form
        Format in words.
    most
        Maximum number of samples of all chosen channels and time axes.
    """

    def __init__(self, path: Path, form: str, most: int) -> None:
        self._path, self._form, self._most = path, form, most
        self._found: list[Found] = []
        self._rate: float | None = None
        self._notes: list[str] = []
        self._skipped: dict[str, list[str]] = {}
        self._attributes: dict[str, str | float | int] = {}

    def add(self, found: Found) -> None:
        """Add an array; single numbers become sample rate or attribute."""
        if not found.extent:
            self.number(found.name, float(as_floats(found.read()).reshape(())), found.unit)
        elif 0 in found.extent:
            self.skip(found.name, "empty")
        elif len(found.extent) > 2:
            self.skip(found.name, f"an array of {len(found.extent)} dimensions")
        else:
            self._found.append(found)

    def number(self, name: str, value: float, unit: str = "") -> None:
        """Add a single number: a sample rate if it has such a name, else an attribute."""
        rate = stated_rate(self._path, name, value, unit)
        if rate is None:
            self._attributes[name] = value
        elif self._rate is None:
            self._rate = rate

    def text(self, name: str, value: str) -> None:
        """Add a text as attribute."""
        if value.strip():
            self._attributes[name] = value[:_TEXT]

    def skip(self, name: str, why: str) -> None:
        """Record an omitted array."""
        self._skipped.setdefault(why, []).append(name)

    def record(self, wanted: Wanted) -> Record:
        """Record of the requested channels."""
        times = [f for f in self._found if key_of(f.name) in TIME_NAMES and len(f.extent) == 1]
        others = [f for f in self._found if f not in times]
        for f in others:
            if wanted.channels and f.name in wanted.channels and len(f.extent) == 2:
                names = tuple(n for n, _ in _split(f, None))
                wanted = Wanted((*wanted.channels, *names))
        chosen = [f for f in others if any(wanted.takes(name) for name, _ in _split(f, None))]
        count = sum(math.prod(f.extent) for f in (*chosen, *times))
        if count > self._most:
            remedy = "choose fewer channels with channels="
            limit = f"{self._most / 1e6:.0f} million"
            raise refused(
                self._path, "", f"{count / 1e6:.0f} million samples", "are chosen at once", limit, remedy
            )
        axis = self._one_time(times, chosen)
        length = axis.extent[0] if axis else None
        columns = []
        for f in chosen:
            if len(f.extent) == 2 and f.extent[0] == f.extent[1] != length:
                raise refused(
                    self._path,
                    f.name,
                    f"an array of {f.extent[0]} × {f.extent[1]}",
                    "does not define the direction of time",
                    None,
                    "store each channel as a vector, or a vector time with it",
                )
            values = as_floats(f.read())
            for name, place in _split(f, length):
                if wanted.takes(name):
                    part = values[place]
                    columns.append(Column(name, np.ascontiguousarray(part), f.unit, f.long_name, f.scale))
            if len(f.extent) == 2:
                n, m = max(f.extent), min(f.extent)
                self._notes.append(f"{f.name}: {m} channels of {n} samples")
        rates = {f.rate for f in chosen if f.rate is not None}
        if len(rates) > 1:
            listed = ", ".join(f"{f.name} {f.rate:g} Hz" for f in chosen if f.rate is not None)
            raise refused(
                self._path,
                "sample rate",
                listed,
                "differ",
                "one for all",
                "choose channels that belong together",
            )
        starts = {f.start for f in chosen}
        notes = [
            f"omitted because it is {why}: {', '.join(names[:8])}" for why, names in self._skipped.items()
        ]
        return Record(
            form=self._form,
            columns=tuple(columns),
            time=None if axis is None else Column(axis.name, as_floats(axis.read()), axis.unit),
            resolution=_resolution(axis),
            rate=next(iter(rates), self._rate),
            start=starts.pop() if len(starts) == 1 else 0.0,
            notes=(*self._notes, *notes),
            attributes=self._attributes,
        )

    def _one_time(self, times: list[Found], chosen: list[Found]) -> Found | None:
        """Time axis of these channels: the one in the same group."""
        if len(times) > 1:
            owners = {_owner(f.name) for f in chosen}
            times = [t for t in times if _owner(t.name) in owners] or times
        if len(times) > 1 and any(not np.array_equal(times[0].read(), t.read()) for t in times[1:]):
            listed = ", ".join(t.name for t in times)
            raise refused(
                self._path, "time", listed, "are different time axes", "one", "choose channels of one of them"
            )
        return times[0] if times else None


def stated_rate(path: Path, name: str, value: float, unit: str = "") -> float | None:
    """Sample rate [Hz] given by a number of this name, None for other names."""
    from pitchpoint.io.measured.units import to_si

    key = key_of(name)
    if key not in (*RATE_NAMES, *STEP_NAMES):
        return None
    stated = value * to_si(unit)[1]
    rate = stated if key in RATE_NAMES else (1.0 / stated if stated else 0.0)
    if not (np.isfinite(rate) and rate > 0.0):
        raise refused(path, name, f"{value:g}", "is not a sample rate", "> 0", "give sample_rate=")
    return rate


def _owner(name: str) -> str:
    return name[: max(name.rfind("."), name.rfind("/"), 0)]


def _split(found: Found, length: int | None) -> list[tuple[str, Any]]:
    """Names of the channels of an array, and their indices; samples are along the time axis."""
    if len(found.extent) == 1:
        return [(found.name, slice(None))]
    n, m = found.extent
    rows = (n == length) if length in (n, m) else n > m
    count = m if rows else n
    if count > _MAX_COLUMNS:
        return []
    return [(f"{found.name}[{k}]", (slice(None), k) if rows else k) for k in range(count)]


def _resolution(axis: Found | None) -> float:
    """Resolution of a stored time axis: single precision has seven digits."""
    if axis is None:
        return 0.0
    values = axis.read()
    if values.dtype.kind != "f" or values.dtype.itemsize >= 8:
        return 0.0
    return float(np.finfo(values.dtype).eps * np.abs(as_floats(values)).max())
