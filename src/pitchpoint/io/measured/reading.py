# SPDX-License-Identifier: Apache-2.0
"""Common entry point for signals in files: measured files of several formats, and results of pitchpoint."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from pitchpoint.core.errors import UnitError
from pitchpoint.io.measured.mat4 import is_mat4
from pitchpoint.io.measured.packed import suffix_of, unpacked
from pitchpoint.io.measured.record import MeasuredError, Record, Wanted, refused

if TYPE_CHECKING:
    import xarray as xr

_HDF5 = b"\x89HDF\r\n\x1a\n"
EXPECTED = {
    ".wav": ("WAV",),
    ".wave": ("WAV",),
    ".mat": ("MAT", "MAT 4", "HDF5"),
    ".h5": ("HDF5",),
    ".hdf5": ("HDF5",),
    ".hdf": ("HDF5",),
    ".nc": ("HDF5",),
    ".uff": ("UFF",),
    ".unv": ("UFF",),
    ".csv": ("text",),
    ".tsv": ("text",),
}
"""Required contents of files with this extension; for other extensions the contents decide."""


def read_measured(
    path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]],
    *,
    sample_rate: float | str | None = None,
    channels: Sequence[str] | str | None = None,
    units: Mapping[str, str] | None = None,
) -> xr.Dataset:
    """Read a measured file: CSV, TSV, MAT, HDF5, WAV, UFF data set 58, or a result of pitchpoint.

    A file without a time axis (a channel named `time` or `t`) and without a sample rate is rejected; no
    assumptions are made.

    Parameters
    ----------
    path
        File; its contents decide the format. Several files are joined to one record: they have the same
        sample rate and start, and the record has the length of the shortest. Channels with equal names are
        named after their files: `front.x`, or `front` if the file has no other channel.
    sample_rate
        Sample rate [Hz] or a text such as "25.6 kHz", if the file has none; it must not contradict a time
        axis, and it decides between contradictory statements of the file.
    channels
        Names of the channels to read, in this order; default: all of them.
    units
        Unit of a channel, if the file has none or a wrong one: "m/s^2", or the quantity that a value of 1 in
        the file represents: "50 m/s^2".

    Returns
    -------
    xarray.Dataset
        One variable per channel over `time` [s]. Attributes of a channel: `units` (SI where the unit is
        known), `long_name`, `scale` and `units_in_file` where numbers were converted. Attributes of the
        dataset: `source_file`, `format`, `sha256`, `sample_rate` [Hz], `sample_rate_from` (name of the number
        in the file), `notes` (what was omitted, constant channels) and other metadata of the file; if the
        file states them, `shaft_speed` [rad/s], `shaft_speed_from`, and `fault_order[BPFO]` [-] or similar.

    Raises
    ------
    MeasuredError
        If the file cannot be used; the message gives place, value, limit and remedy.
    MissingDependencyError
        If a universal file is read without the extra `uff`.

    Examples
    --------
    >>> import tempfile
    >>> file = Path(tempfile.mkdtemp()) / "rig.csv"
    >>> _ = file.write_text("time [ms];force [kN]" + chr(10) + "0;1,5" + chr(10) + "0,5;2,5")
    >>> data = read_measured(file)
    >>> data["force"].values.tolist(), data["force"].units, data.sample_rate
    ([1500.0, 2500.0], 'N', 2000.0)
    """
    from pitchpoint.io.measured.assembly import assemble
    from pitchpoint.io.measured.joining import read_joined

    asked = (channels,) if isinstance(channels, str) else None if channels is None else tuple(channels)
    paths = [Path(path)] if isinstance(path, str | os.PathLike) else [Path(one) for one in path]
    if len(paths) != 1:
        rate = _hertz(paths[0] if paths else Path(), sample_rate)
        return read_joined(paths, _read, sample_rate=rate, channels=asked, units=dict(units or {}))
    place = paths[0]
    record, digest = _read(place, asked)
    return assemble(
        place,
        record,
        sample_rate=_hertz(place, sample_rate),
        channels=asked,
        units=dict(units or {}),
        digest=digest,
    )


def _read(path: Path, asked: tuple[str, ...] | None) -> tuple[Record, str]:
    """Contents of a file with the requested channels, and its SHA-256."""
    data = _contents(path)
    digest = hashlib.sha256(data).hexdigest()
    try:
        return _record(path, data, asked), digest
    except MemoryError:
        remedy = "choose fewer channels by channels=, or cut it into shorter records"
        raise refused(path, "", "", "requires more memory than there is", None, remedy) from None


def _record(path: Path, packed: bytes, asked: tuple[str, ...] | None) -> Record:
    """Contents of the file with the requested channels."""
    from pitchpoint.io.measured.assembly import unknown_channels

    data = unpacked(path, packed)
    form = form_of(path, data)
    if data is not packed and form in ("HDF5", "UFF"):
        raise refused(path, "", form, "is packed", "CSV, MAT 4 to 7 or WAV", "unpack the file first")
    reader = _reader(path, data, form)
    record = reader(Wanted(asked))
    if asked is not None and len(record.columns) < len(asked):
        unknown_channels(path, asked, [c.name for c in reader(Wanted()).columns])
    return record


def _contents(path: Path) -> bytes:
    """All bytes of a regular file; pipes and devices, which may never end, are rejected."""
    try:
        if not path.exists():
            raise refused(path, "", "", "there is no such file", None, "check the path")
        if not path.is_file():
            raise refused(
                path, "", "", "is not an ordinary file", "a file", "name a file, not a folder or a device"
            )
        data = path.read_bytes()
    except (OSError, ValueError) as error:
        if isinstance(error, MeasuredError):
            raise
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise refused(
            path, "", "", f"cannot be read ({reason.lower()})", None, "check its permissions"
        ) from error
    except MemoryError as error:
        raise refused(
            path, "", "", "is larger than the memory", None, "cut it into shorter records"
        ) from error
    if data.count(0) == len(data):
        what = f"contains only zeros, {len(data)} bytes" if data else "is empty"
        raise refused(path, "", "", what, None, "copy it again from where it was recorded")
    return data


def form_of(path: Path, data: bytes) -> str:
    """Format by contents; an extension of another format is an error."""
    if data.startswith(_HDF5) or data[512:520] == _HDF5:
        form = "HDF5"
    elif data[:4] in (b"RIFF", b"RIFX", b"RF64"):
        form = "WAV"
    elif data[:19] == b"MATLAB 5.0 MAT-file" or data[126:128] in (b"IM", b"MI") and b"\0" in data[:256]:
        form = "MAT"
    elif data[:4096].lstrip(b"\r\n")[:80].split(b"\n")[0].rstrip() == b"    -1":
        form = "UFF"
    elif is_mat4(data):
        form = "MAT 4"
    else:
        form = "text"
    suffix = suffix_of(path)
    expected = EXPECTED.get(suffix, (form,))
    if form not in expected:
        first = data[:8].decode("latin-1")
        what = {"text": "no known format", "MAT": "MAT 5"}.get(form, form)
        raise refused(
            path,
            "first bytes",
            f"{first!r}",
            f"identify {what}, but the extension is {suffix}",
            " or ".join(expected),
            "copy or export the file again, or correct the extension",
        )
    return form


def _reader(path: Path, data: bytes, form: str) -> Callable[[Wanted], Record]:
    """Function that reads this format."""
    if form == "HDF5":
        from pitchpoint.io.measured.hdf5 import is_own, read_hdf5, read_own

        read = read_own if is_own(path, data) else read_hdf5
        return lambda wanted: read(path, wanted)
    if form == "WAV":
        from pitchpoint.io.measured.wav import read_wav as decode
    elif form == "MAT":
        from pitchpoint.io.measured.mat import read_mat5 as decode
    elif form == "MAT 4":
        from pitchpoint.io.measured.mat4 import read_mat4 as decode
    elif form == "UFF":
        from pitchpoint.io.measured.uff import read_uff as decode
    else:
        from pitchpoint.io.measured.text import read_text as decode
    return lambda wanted: decode(path, data, wanted)


def _hertz(path: Path, value: float | str | None) -> float | None:
    """Sample rate in Hz."""
    from pitchpoint.core.units import parse_quantity

    if value is None:
        return None
    try:
        return parse_quantity(value, "frequency", positive=True)
    except UnitError as error:
        raise refused(path, "sample_rate=", "", str(error), "> 0", "such as 25.6 kHz") from error
