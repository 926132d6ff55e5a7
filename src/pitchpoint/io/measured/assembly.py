# SPDX-License-Identifier: Apache-2.0
"""Dataset from the contents of a file, with all checks that do not depend on the format."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import join_notes
from pitchpoint.core.nearest import hint
from pitchpoint.io.measured.record import Column, MeasuredError, Record, refused
from pitchpoint.io.measured.units import to_si

if TYPE_CHECKING:
    import xarray as xr

UNIFORM = 1e-6
"""Tolerance of the times of a uniform record, relative to the step, as in `analysis.sampled`."""
_AGREE = 1e-3
_SHOWN = 12


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
    _known(path, "units", units, [c.name for c in columns])
    columns = [replace(c, unit=units.get(c.name, c.unit)) for c in columns]
    count = _one_length(path, columns, record)
    _finite(path, columns)
    time, rate, notes = _time_axis(path, record, count, sample_rate)
    notes = [*record.notes, *notes]
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
        **({"sample_rate": rate} if rate is not None else {}),
        **{key: value for key, value in record.attributes.items() if key not in ("format", "sha256")},
        "notes": join_notes(notes),
    }
    axis = ("time", time, {"units": "s", "long_name": "time"})
    return xr.Dataset(variables, coords={"time": axis}, attrs=about)


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
    _known(path, "channels", [name for name in asked if not _columns_of(name, names)], names)


def _known(path: Path, what: str, asked: Any, names: Sequence[str]) -> None:
    for name in asked:
        if name not in names:
            remedy = hint(name, names, 3)
            raise refused(path, what, repr(name), "is not a channel of the file", None, remedy)


def _one_length(path: Path, columns: Sequence[Column], record: Record) -> int:
    """Number of samples of all channels and of the time axis."""
    lengths = {c.name: c.values.size for c in columns}
    if record.time is not None:
        lengths = {record.time.name: record.time.values.size} | lengths
    if len(set(lengths.values())) > 1:
        usual = Counter(lengths.values()).most_common(1)[0][0]
        if record.time is not None:
            usual = record.time.values.size
        odd = [f"{name} {n}" for name, n in lengths.items() if n != usual]
        listed = ", ".join(odd[:_SHOWN])
        remedy = "choose channels of one length with channels="
        raise refused(path, "samples", listed, "differ in length from the rest", str(usual), remedy)
    count = next(iter(lengths.values()))
    if count < 2:
        raise refused(
            path, "samples", str(count), "is too short for a record", "2 or more", "record for longer"
        )
    return count


def _finite(path: Path, columns: Sequence[Column]) -> None:
    """Reject samples that are NaN or infinite; all channels are reported together."""
    problems = []
    for c in columns:
        bad = np.flatnonzero(~np.isfinite(c.values))
        if bad.size:
            k = int(bad[0])
            problems.append(
                f"{c.name}: {bad.size} of {c.values.size} samples, first {c.values[k]} at sample {k}"
            )
    if problems:
        raise refused(
            path,
            "; ".join(problems[:_SHOWN]),
            "",
            "are not finite numbers",
            "0",
            "cut the record before them, repair them, or leave the channel out with channels=",
        )


def _time_axis(
    path: Path, record: Record, count: int, sample_rate: float | None
) -> tuple[NDArray[np.float64], float | None, list[str]]:
    """Times [s], sample rate [Hz] if they are uniform, and notes."""
    if sample_rate is not None and not (np.isfinite(sample_rate) and sample_rate > 0.0):
        raise refused(path, "sample_rate", f"{sample_rate:g} Hz", "is impossible", "> 0", "give it in Hz")
    stated = record.rate
    if stated is not None and not (np.isfinite(stated) and stated > 0.0):
        raise refused(
            path, "sample rate", f"{stated:g} Hz", "is given in the file", "> 0", "give sample_rate="
        )
    if stated is not None and sample_rate is not None:
        _agree(path, sample_rate, stated)
    rate = sample_rate if sample_rate is not None else stated
    if record.time is not None:
        return _stored_axis(path, record, rate)
    if rate is None:
        raise refused(
            path,
            "time",
            "",
            "the file has neither a time axis nor a sample rate",
            "one of them",
            "give sample_rate= in Hz (--sample-rate on the command line)",
        )
    return record.start + np.arange(count) / rate, rate, []


def _agree(path: Path, given: float, stated: float) -> None:
    if abs(given - stated) > _AGREE * stated:
        message = "contradicts the file"
        raise refused(
            path, "sample_rate", f"{given:g} Hz", message, f"{stated:.6g} Hz", "leave it out or correct it"
        )


def _stored_axis(
    path: Path, record: Record, rate: float | None
) -> tuple[NDArray[np.float64], float | None, list[str]]:
    """Time axis of the file; rounded times are moved to an even grid."""
    assert record.time is not None
    unit, factor, known = to_si(record.time.unit)
    if unit not in ("", "s") or not known:
        message, remedy = "is not a unit of time", "correct it in the file, such as time [s]"
        raise refused(path, record.time.name, repr(record.time.unit), message, "s, ms, min, h", remedy)
    time, own = record.time.values * factor, record.form.startswith("pitchpoint")
    _finite(path, [record.time])
    steps = np.diff(time)
    step = float(time[-1] - time[0]) / steps.size
    grid = time[0] + np.arange(time.size) * step
    off = float(np.abs(time - grid).max())
    exact = UNIFORM * step + 4.0 * np.finfo(np.float64).eps * float(np.abs(time).max())
    resolution = record.resolution * factor
    if step > 0.0 and off > exact and off <= 1.001 * resolution and resolution <= 0.25 * step:
        found = rate if rate is not None else 1.0 / step
        _agree(path, found, 1.0 / step)
        note = f"times are rounded to {resolution:g} s and were moved to an even grid"
        return time[0] + np.arange(time.size) / found, found, [note]
    back = np.flatnonzero(steps <= 0.0)
    if back.size:
        k = int(back[0])
        coarse = resolution > 0.25 * abs(step)
        message = "does not increase" + (f" (times are written to {resolution:g} s only)" if coarse else "")
        remedy = (
            "leave the column out and give sample_rate=" if coarse else "sort the file, drop repeated samples"
        )
        raise _uneven(
            path, record, f"sample {k + 1} at {time[k + 1]:.9g} s after {time[k]:.9g} s", message, remedy
        )
    if off <= exact:
        if rate is not None:
            _agree(path, rate, 1.0 / step)
        return time, 1.0 / step, []
    if own:  # adaptive solvers store variable steps; functions that require even steps report it
        return time, None, ["times are not evenly spaced"]
    usual = float(np.median(steps))
    k = int(np.argmax(np.abs(steps - usual)))
    value = f"step {steps[k]:.6g} s after sample {k}"
    raise _uneven(
        path,
        record,
        value,
        f"differs from the usual {usual:.6g} s: samples are missing or unevenly spaced",
        "resample the record evenly, or cut it where samples are missing",
    )


def _uneven(path: Path, record: Record, value: str, message: str, remedy: str) -> MeasuredError:
    assert record.time is not None
    return refused(path, record.time.name, value, message, "even steps", remedy)
