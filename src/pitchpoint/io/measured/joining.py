# SPDX-License-Identifier: Apache-2.0
"""One record from several files that were recorded together, such as one file per channel."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import join_notes, split_notes
from pitchpoint.io.measured.assembly import assemble, known_names, unknown_channels
from pitchpoint.io.measured.record import MeasuredError, Record, refused
from pitchpoint.io.measured.stated import SAME_SPEED

if TYPE_CHECKING:
    import xarray as xr

_DRIFT = 0.5
"""Difference of the times of files at the end of the record [samples], and that of their starts."""
_SHORTEST = 0.5
"""Length of the shortest file relative to the longest one."""
_SHOWN = 4


def read_joined(
    paths: Sequence[Path],
    read: Callable[[Path, None], tuple[Record, str]],
    *,
    sample_rate: float | None,
    channels: Sequence[str] | None,
    units: Mapping[str, str],
) -> xr.Dataset:
    """Read files of equal sample rate and start as one record.

    Parameters
    ----------
    paths
        Files, two or more.
    read
        Reads a file: its contents and SHA-256.
    sample_rate
        Sample rate given by the user [Hz], or None.
    channels
        Channels requested by the user, in this order, or None for all.
    units
        Units given by the user, by channel.
    """
    import xarray as xr

    if not paths:
        raise MeasuredError("read_measured: no file is given (limit 1 or more); name a file")
    twice = [path for path, count in Counter(p.resolve() for p in paths).items() if count > 1]
    if twice:
        raise refused(twice[0], "", "", "is given more than once", "once", "name each file once")
    records = _named(paths, _every(paths, read))
    names = [column.name for record, _ in records.values() for column in record.columns]
    together = Path(_few([str(path) for path in paths]))
    if channels is not None:
        unknown_channels(together, channels, names)
    if channels is not None and not channels:
        raise refused(together, "channels", "none", "is requested", "1 or more", "omit channels for all")
    known_names(together, "units", units, names)
    parts: dict[Path, xr.Dataset] = {}
    for path, (record, digest) in records.items():
        own = [c.name for c in record.columns]
        chosen = None if channels is None else [n for n in channels if n in own or _has_columns(n, own)]
        if chosen == []:
            continue
        parts[path] = assemble(
            path,
            record,
            sample_rate=sample_rate,
            channels=chosen,
            units={name: unit for name, unit in units.items() if name in own},
            digest=digest,
        )
    _one_clock(parts)
    count = min(part.sizes["time"] for part in parts.values())
    notes = _notes(parts, count)
    joined = {
        str(name): ("time", values.values[:count], values.attrs)
        for part in parts.values()
        for name, values in part.data_vars.items()
    }
    first = list(joined) if channels is None else [name for name in channels if name in joined]
    axis = next(iter(parts.values()))["time"]
    data = xr.Dataset(
        {name: joined[name] for name in dict.fromkeys((*first, *joined))},
        coords={"time": ("time", axis.values[:count], axis.attrs)},
    )
    data.attrs = _attributes(parts, notes)
    return data


def _every(
    paths: Sequence[Path], read: Callable[[Path, None], tuple[Record, str]]
) -> dict[Path, tuple[Record, str]]:
    """All files; those that cannot be read are named together."""
    found, problems = {}, []
    for path in paths:
        try:
            found[path] = read(path, None)
        except MeasuredError as error:
            problems.append(str(error))
    if problems:
        raise MeasuredError("; ".join(problems))
    return found


def _has_columns(name: str, names: Sequence[str]) -> bool:
    return any(other.startswith(f"{name}[") for other in names)


def _named(
    paths: Sequence[Path], records: Mapping[Path, tuple[Record, str]]
) -> dict[Path, tuple[Record, str]]:
    """Records whose channels have different names: equal ones are named after their files."""
    count = Counter(c.name for record, _ in records.values() for c in record.columns)
    stems = [_stem(path) for path in paths]
    if len(set(stems)) < len(stems):
        stems = [f"{path.parent.name}/{stem}" for path, stem in zip(paths, stems, strict=True)]
    if len(set(stems)) < len(stems):
        stems = [path.as_posix() for path in paths]
    found = {}
    for path, stem in zip(paths, stems, strict=True):
        record, digest = records[path]
        single = len(record.columns) == 1
        columns = [
            c if count[c.name] == 1 else replace(c, name=stem if single else f"{stem}.{c.name}")
            for c in record.columns
        ]
        found[path] = (replace(record, columns=tuple(columns)), digest)
    names = Counter(c.name for record, _ in found.values() for c in record.columns)
    for name, times in names.items():
        if times > 1 and count[name] == 1:
            raise refused(paths[0], "channels", repr(name), "has the name of a file", None, "rename the file")
    return found


def _stem(path: Path) -> str:
    return path.name.partition(".")[0] or path.name


def _one_clock(parts: Mapping[Path, xr.Dataset]) -> None:
    """Reject files with different sample rates, starts or very different lengths."""
    first_path, first = next(iter(parts.items()))
    uneven = [path for path, part in parts.items() if "sample_rate" not in part.attrs]
    if uneven and len(parts) > 1:
        remedy = "read this file alone, or run the scenario with a sample_rate"
        raise refused(uneven[0], "time", "", "is not evenly spaced", "even steps", remedy)
    longest = max(part.sizes["time"] for part in parts.values())
    for path, part in parts.items():
        if part is first:
            continue
        rate, other = float(first.attrs["sample_rate"]), float(part.attrs["sample_rate"])
        count = min(part.sizes["time"], first.sizes["time"])
        if abs(other / rate - 1.0) * count > _DRIFT:
            raise refused(
                path,
                "sample rate",
                f"{other:.9g} Hz",
                f"differs from that of {first_path.name}",
                f"{rate:.9g} Hz",
                "read files of one sample rate together, or resample them",
            )
        start, begun = float(first["time"][0]), float(part["time"][0])
        if abs(begun - start) * rate > _DRIFT:
            remedy = "cut the files to a common start"
            value, limit = f"{begun:.9g} s", f"{start:.9g} s"
            raise refused(
                path, "time", value, f"starts at another time than {first_path.name}", limit, remedy
            )
    for path, part in parts.items():
        if part.sizes["time"] < _SHORTEST * longest:
            raise refused(
                path,
                "samples",
                str(part.sizes["time"]),
                "is much shorter than the longest of the files",
                f"{longest * _SHORTEST:.0f} or more",
                "read it alone, or cut the other files",
            )


def _notes(parts: Mapping[Path, xr.Dataset], count: int) -> list[str]:
    """Notes of all files, and on what was cut off."""
    by_text: dict[str, list[str]] = {}
    for path, part in parts.items():
        for text in split_notes(str(part.attrs.get("notes", ""))):
            by_text.setdefault(text, []).append(path.name)
    found = [
        text if len(names) == len(parts) else f"{_few(names)}: {text}" for text, names in by_text.items()
    ]
    longer = [
        f"{path.name} {part.sizes['time']}" for path, part in parts.items() if part.sizes["time"] > count
    ]
    if longer:
        found.append(f"{count} samples are used, as in the shortest file (longer: {_few(longer)})")
    return found


def _few(names: Sequence[str]) -> str:
    """First of some names, and the number of the others."""
    more = len(names) - _SHOWN
    return ", ".join(names[:_SHOWN]) + (f" and {more} more" if more > 0 else "")


def _attributes(parts: Mapping[Path, xr.Dataset], notes: list[str]) -> dict[str, Any]:
    """Attributes of the joined record; those in which the files differ are omitted."""
    every = [part.attrs for part in parts.values()]
    first = every[0]
    shared = {k: v for k, v in first.items() if all(k in a and _equal(a[k], v) for a in every)}
    speeds = [(float(a["shaft_speed"]), str(a["shaft_speed_from"])) for a in every if "shaft_speed" in a]
    if speeds and max(speeds)[0] <= (1.0 + SAME_SPEED) * min(speeds)[0]:
        shared |= {"shaft_speed": speeds[0][0], "shaft_speed_from": speeds[0][1]}
    elif speeds:
        shared = {k: v for k, v in shared.items() if not k.startswith("shaft_speed")}
        notes.append("the speeds of the files differ, none is used")
    return shared | {
        "source_file": ", ".join(path.name for path in parts),
        "format": ", ".join(dict.fromkeys(str(a["format"]) for a in every)),
        "sha256": ", ".join(str(a["sha256"]) for a in every),
        "sample_rate": first["sample_rate"],
        "notes": join_notes(notes),
    }


def _equal(one: Any, other: Any) -> bool:
    return type(one) is type(other) and bool(np.all(one == other))
