# SPDX-License-Identifier: Apache-2.0
"""Dataset from the contents of a file, with all checks that do not depend on the format."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import join_notes
from pitchpoint.core.nearest import hint
from pitchpoint.io.measured.clock import clock_of, finite
from pitchpoint.io.measured.record import Column, Record, refused
from pitchpoint.io.measured.stated import family_of
from pitchpoint.io.measured.units import to_si

if TYPE_CHECKING:
    import xarray as xr

_SHOWN = 12
_OWN = ("format", "sha256", "sample_rate", "sample_rate_from", "shaft_speed", "shaft_speed_from")
"""Attributes with this meaning only; numbers of the file with these names are not repeated."""


def assemble(
    path: Path,
    record: Record,
    *,
    sample_rate: float | None,
    channels: Sequence[str] | None,
    units: Mapping[str, str],
    digest: str,
) -> xr.Dataset:
    """Check a record and create its dataset with the dimension `time` [s].

    Parameters
    ----------
    path
        File, for messages and provenance.
    record
        Contents of the file.
    sample_rate
        Sample rate given by the user [Hz], or None.
    channels
        Channels requested by the user, in this order, or None for all.
    units
        Units given by the user, by channel.
    digest
        SHA-256 of the file.
    """
    import xarray as xr

    from pitchpoint.core.provenance import package_version

    columns = _chosen(path, record, channels)
    known_names(path, "units", units, [c.name for c in columns])
    columns = [replace(c, unit=units.get(c.name, c.unit)) for c in columns]
    count = _one_length(path, columns, record)
    finite(path, columns)
    clock = clock_of(path, record, count, sample_rate)
    notes = [*record.notes, *clock.notes]
    variables: dict[str, Any] = {}
    for column in columns:
        unit, factor, known = to_si(column.unit)
        values = column.values if factor == 1.0 else column.values * factor
        attributes: dict[str, Any] = {"units": unit, "long_name": column.long_name or column.name}
        scale = [column.scale] if column.scale else []
        if column.unit and (factor != 1.0 or not known):
            attributes["units_in_file"] = column.unit
            scale.append(f"{factor:.9g} times the number in the file" if factor != 1.0 else "")
        if any(scale):
            attributes["scale"] = "; ".join(text for text in scale if text)
        if not known:
            gravity = f" (if it is an acceleration, give units={{{column.name!r}: '9.80665 m/s^2'}})"
            notes.append(
                f"{column.name}: unit {unit!r} is not converted to SI{gravity if unit == 'g' else ''}"
            )
        if np.ptp(values) == 0.0:
            notes.append(f"{column.name}: is constant ({values[0]:g} {unit}".rstrip() + ")")
        variables[column.name] = ("time", values, attributes)
    about: dict[str, Any] = {
        "source_file": path.name,
        "format": record.form,
        "sha256": digest,
        "package_version": package_version(),
        **({"sample_rate": clock.rate} if clock.rate is not None else {}),
        **({"sample_rate_from": clock.source} if clock.source else {}),
        **_stated(record),
        **{key: value for key, value in record.attributes.items() if key not in _OWN},
        "notes": join_notes(notes),
    }
    axis = ("time", clock.time, {"units": "s", "long_name": "time"})
    return xr.Dataset(variables, coords={"time": axis}, attrs=about)


def _stated(record: Record) -> dict[str, str | float]:
    """Attributes of the speed and the bearing given in the file."""
    found: dict[str, str | float] = {f"fault_order[{k}]": v for k, v in record.fault_orders.items()}
    if record.speed is not None:
        found |= {"shaft_speed": math.tau * record.speed.value, "shaft_speed_from": record.speed.name}
    return found


def _chosen(path: Path, record: Record, channels: Sequence[str] | None) -> list[Column]:
    """Requested channels in order, each name once."""
    names = [c.name for c in record.columns]
    twice = [name for name, count in Counter(names).items() if count > 1]
    if twice:
        places = ", ".join(f"{name!r} {names.count(name)} times" for name in twice[:_SHOWN])
        raise refused(
            path, "channels", places, "are in the file", "each name once", "rename them in the file"
        )
    if not names and channels is None:
        remedy = "name a file with a record, or export the signals as columns of numbers"
        raise refused(path, "", "no channel", "of numbers is in the file", "1 or more", remedy)
    if channels is None:
        return list(record.columns)
    asked = [name for name, count in Counter(channels).items() if count > 1]
    if asked:
        raise refused(path, "channels", repr(asked[0]), "is asked for more than once", "once", "name it once")
    by_name = {c.name: c for c in record.columns}
    expanded = [n for name in channels for n in _columns_of(name, names)]
    if not expanded:
        raise refused(path, "channels", "none", "is requested", "1 or more", "omit channels for all of them")
    return [by_name[name] for name in expanded]


def _columns_of(name: str, names: Sequence[str]) -> list[str]:
    """Channel, or all columns of a matrix, of this name."""
    return [name] if name in names else [n for n in names if n.startswith(f"{name}[")]


def unknown_channels(path: Path, asked: Sequence[str], names: Sequence[str]) -> None:
    """Reject unknown channel names, with the closest names.

    Parameters
    ----------
    path
        File, for the message.
    asked
        Names given by the user.
    names
        Channels of the file.
    """
    known_names(path, "channels", [name for name in asked if not _columns_of(name, names)], names)


def known_names(path: Path, what: str, asked: Any, names: Sequence[str]) -> None:
    """Reject names of the option `what` that are not among those of the channels."""
    for name in asked:
        if name not in names:
            remedy = hint(name, names, 3)
            raise refused(path, what, repr(name), "is not a channel of the file", None, remedy)


def _one_length(path: Path, columns: Sequence[Column], record: Record) -> int:
    """Number of samples of all channels and of the time axis."""
    lengths = {c.name: c.values.size for c in columns}
    if record.time is not None:
        lengths = {record.time.name: record.time.values.size} | lengths
    families: dict[str, set[int]] = {}
    for name, n in lengths.items():
        families.setdefault(family_of(name), set()).add(n)
    if len(families) > 1 and "" not in families and all(len(sizes) == 1 for sizes in families.values()):
        listed = ", ".join(f"{family} {min(sizes)}" for family, sizes in list(families.items())[:_SHOWN])
        last = [name for name in lengths if family_of(name) == next(reversed(families))]
        remedy = f"choose the channels of one, such as channels={last[:_SHOWN]} (-c on the command line)"
        if len(set.union(*families.values())) > 1:
            raise refused(path, "samples", listed, "are records of different length", "one record", remedy)
    if len(set(lengths.values())) > 1:
        usual = Counter(lengths.values()).most_common(1)[0][0]
        if record.time is not None:
            usual = record.time.values.size
        odd = [f"{name} {n}" for name, n in lengths.items() if n != usual]
        listed = ", ".join(odd[:_SHOWN])
        remedy = "choose channels of one length by channels="
        raise refused(path, "samples", listed, "differ in length from the rest", str(usual), remedy)
    count = next(iter(lengths.values()))
    if count < 2:
        raise refused(
            path, "samples", str(count), "is too short for a record", "2 or more", "record for longer"
        )
    return count
