# SPDX-License-Identifier: Apache-2.0
"""Files of named arrays (MAT, HDF5): identification of channels, time axis and sample rate.

Vectors and columns of matrices are channels. A vector named `time` or `t` is the time axis, and so is the
data of a structure `X` next to `Y`; no other arrays are used for it. Numbers named `sample_rate`, `fs`,
`dt`, `rpm` or similar give sample rate and speed (`stated`); numbers and texts become attributes. A structure
with data and a name, such as `Y(2).Data` and `Y(2).Name`, is a channel of this name.
"""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Callable, Collection
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.io.measured.record import (
    TIME_NAMES,
    Column,
    Record,
    Wanted,
    as_floats,
    key_of,
    refused,
)
from pitchpoint.io.measured.stated import Statements
from pitchpoint.io.measured.units import to_si

MAX_BYTES = 1_000_000_000
"""Size of the unpacked arrays of one file, and of the chosen ones in double precision [bytes]: 18 MB of
packed zeros may become a thousand times as much."""
_MAX_COLUMNS = 4096
_TEXT = 200
_SHORT, _LONG = 32, 1024
"""An array of up to `_SHORT` numbers, such as a date, is not a channel next to one of `_LONG` or more."""
_DATA = ("data", "values", "value", "y", "signal")
_SCALES = ("scale", "scaling", "scale_factor", "scalefactor", "gain", "sensitivity", "slope", "resolution")
"""Names of numbers that convert integer samples, in one direction or the other."""
_NAMES, _UNITS, _GRIDS = ("name", "channel", "label"), ("unit", "units"), ("raster",)


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
    start
        Time of the first sample [s] given with this array.
    stored
        Name in the file, if a text next to the array gives the channel its name.
    """

    name: str
    values: NDArray[Any] | Callable[[], NDArray[Any]]
    shape: tuple[int, ...] | None = None
    unit: str = ""
    long_name: str = ""
    scale: str = ""
    start: float = 0.0
    stored: str = ""

    @property
    def place(self) -> str:
        """Name in the file."""
        return self.stored or self.name

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
        self._stated = Statements()
        self._notes: list[str] = []
        self._skipped: dict[str, list[str]] = {}
        self._attributes: dict[str, str | float | int] = {}
        self._texts: dict[str, dict[str, str]] = {}
        self._names: dict[str, int] = {}
        self._renamed: dict[str, str] = {}

    def unique(self, name: str) -> str:
        """Name for a variable; a repeated one has a number at its end, as in `x_2`.

        Call it once for each variable of the file.
        """
        if name not in self._names:
            self._names[name] = 1
            return name
        new = name
        while new in self._names:
            self._names[name] += 1
            new = f"{name}_{self._names[name]}"
        self._names[new] = 1
        self._renamed[new] = name
        self._notes.append(f"{name} is in the file more than once: the next one is named {new}")
        return new

    def add(self, found: Found) -> None:
        """Add an array; single numbers become sample rate, speed or attribute."""
        if not found.extent:
            self.number(found.name, float(as_floats(found.read()).reshape(())), found.unit)
        elif 0 in found.extent:
            self.skip(found.name, "empty")
        elif len(found.extent) > 2:
            self.skip(found.name, f"an array of {len(found.extent)} dimensions")
        else:
            self._found.append(found)

    def number(self, name: str, value: float, unit: str = "") -> None:
        """Add a single number: a statement if it has such a name, and an attribute."""
        self._stated.number(self._renamed.get(name, name), value, unit)
        self._attributes[name] = value

    def state(self, name: str, value: float) -> None:
        """Add a number at an array, such as its sample rate; it is not an attribute of the file."""
        self._stated.number(name, value)

    def text(self, name: str, value: str) -> None:
        """Add a text: an attribute, and a statement if it is a number with such a name."""
        if value.strip():
            owner, _, last = _parts(name)
            self._texts.setdefault(owner, {})[last.lower()] = value.strip()
            self._stated.text(name, value)
            self._attributes[name] = value[:_TEXT]

    def skip(self, name: str, why: str) -> None:
        """Record an omitted array."""
        self._skipped.setdefault(why, []).append(name)

    def record(self, wanted: Wanted) -> Record:
        """Record of the requested channels."""
        found = self._named()
        places = {f.place for f in found}
        times = [f for f in found if len(f.extent) == 1 and _is_time(f, places)]
        others = self._long([f for f in found if f not in times], wanted)
        for f in others:
            if wanted.channels and f.name in wanted.channels and len(f.extent) == 2:
                names = tuple(n for n, _ in _split(f, None))
                wanted = Wanted((*wanted.channels, *names))
        chosen = [f for f in others if any(wanted.takes(name) for name, _ in _split(f, None))]
        count = sum(math.prod(f.extent) for f in (*chosen, *times))
        if count > self._most:
            remedy = "choose fewer channels by channels="
            limit = f"{self._most / 1e6:.0f} million"
            raise refused(
                self._path, "", f"{count / 1e6:.0f} million samples", "are chosen at once", limit, remedy
            )
        axis = self._one_time(times, chosen)
        time = None if axis is None else Column(axis.name, as_floats(axis.read()), axis.unit)
        columns = self._columns(chosen, wanted, axis.extent[0] if axis else None)
        given = self._stated.on([f.place for f in chosen], [f.place for f in others], _rate_of(time))
        starts = {f.start for f in chosen}
        notes = [
            f"omitted because it is {why}: {', '.join(names[:8])}" for why, names in self._skipped.items()
        ]
        return Record(
            form=self._form,
            columns=tuple(columns),
            time=time,
            resolution=_resolution(axis),
            rates=given.rates,
            start=starts.pop() if len(starts) == 1 else 0.0,
            speed=given.speed,
            fault_orders=given.fault_orders,
            notes=(*self._notes, *notes, *given.notes),
            attributes=self._attributes,
        )

    def _columns(self, chosen: list[Found], wanted: Wanted, length: int | None) -> list[Column]:
        """Requested channels; `length` is that of the time axis, if any."""
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
            self._unscaled(f)
            if len(f.extent) == 2:
                n, m = max(f.extent), min(f.extent)
                self._notes.append(f"{f.name}: {m} channels of {n} samples")
        return columns

    def _unscaled(self, found: Found) -> None:
        """Note on a scale next to whole numbers, whose meaning is not certain: it is not used."""
        values = found.read() if isinstance(found.values, np.ndarray) else None
        if values is None or values.dtype.kind not in "iu" or found.scale:
            return
        for name, value in self._attributes.items():
            if _owner(name) == _owner(found.place) and _parts(name)[2].lower() in _SCALES:
                unit = (
                    f" (if it is the value of 1, give units={{{found.name!r}: '{value} m/s^2'}} or similar)"
                )
                self._notes.append(f"{found.name} has whole numbers, and {name} = {value} is not used{unit}")

    def _named(self) -> list[Found]:
        """Arrays with the names and units that texts in their structures give them."""
        found = []
        for f in self._found:
            owner, _, last = _parts(f.name)
            if not owner or last.lower() not in _DATA:
                found.append(f)
                continue
            name, unit = self._next_to(owner, _NAMES), f.unit or self._next_to(owner, _UNITS)
            found.append(replace(f, name=name or f.name, stored=f.name, unit=unit))
        count = Counter(f.name for f in found)
        return [f if count[f.name] == 1 else replace(f, name=f.place) for f in found]

    def _next_to(self, owner: str, keys: Collection[str]) -> str:
        """Text of one of these names in a structure or group; empty if none."""
        texts = self._texts.get(owner, {})
        return next((texts[key][:_TEXT] for key in keys if key in texts), "")

    def _long(self, found: list[Found], wanted: Wanted) -> list[Found]:
        """Arrays without the short ones next to long channels, unless they are requested."""
        sizes = [math.prod(f.extent) for f in found]
        if max(sizes, default=0) < _LONG:
            return found
        kept = []
        for f, size in zip(found, sizes, strict=True):
            if size > _SHORT or wanted.channels and any(wanted.takes(name) for name, _ in _split(f, None)):
                kept.append(f)
            else:
                self.skip(f"{f.name} ({size})", "shorter than a channel")
        return kept

    def _one_time(self, times: list[Found], chosen: list[Found]) -> Found | None:
        """Time axis of these channels: the one in the same group, or with the same raster."""
        if len(times) > 1:
            grids = {grid for f in chosen if (grid := self._next_to(_owner(f.place), _GRIDS))}
            times = [t for t in times if self._next_to(_owner(t.place), _GRIDS) in grids] or times
            owners = {_owner(f.place) for f in chosen}
            times = [t for t in times if _owner(t.place) in owners] or times
        if len(times) > 1 and any(not np.array_equal(times[0].read(), t.read()) for t in times[1:]):
            listed = ", ".join(t.place for t in times)
            raise refused(
                self._path, "time", listed, "are different time axes", "one", "choose channels of one of them"
            )
        return times[0] if times else None


def _parts(name: str) -> tuple[str, str, str]:
    """Structure or group, separator and last part of a name."""
    owner = _owner(name)
    return owner, name[len(owner) : len(owner) + 1] if owner else "", name[len(owner) + bool(owner) :]


def _is_time(found: Found, places: Collection[str]) -> bool:
    """Whether a vector is a time axis: by its name, or as the data of `X` next to `Y`."""
    if key_of(found.name) in TIME_NAMES or key_of(found.place) in TIME_NAMES:
        return True
    owner, _, last = _parts(found.place)
    before, sign, group = _parts(owner)
    match = re.fullmatch(r"([xX])(_values|_data|)(?:\[\d+\])?", group)
    if last.lower() not in _DATA or match is None:
        return False
    y = f"{before}{sign}{'Y' if match[1] == 'X' else 'y'}{match[2]}"
    return any(re.fullmatch(re.escape(y) + r"(\[\d+\])?", _owner(other)) for other in places)


def _rate_of(time: Column | None) -> float | None:
    """Mean sample rate of a time axis [Hz]; None if it has none."""
    if time is None or time.values.size < 2:
        return None
    span = float(time.values[-1] - time.values[0]) * to_si(time.unit)[1]
    return (time.values.size - 1) / span if span > 0.0 else None


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
