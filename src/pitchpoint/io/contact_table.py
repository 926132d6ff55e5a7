# SPDX-License-Identifier: Apache-2.0
"""File of a pre-computed flank contact, `NAME.gcp.h5`: table of the elastic potential with its origin.

An HDF5 file followed by its checksum, written as a whole: it is complete or absent. `description` is a text
(JSON) with the inputs that the table depends on, axes, measured errors, version and date; the other objects
are arrays. A table computed from other inputs is refused with the names of what differs.
"""

from __future__ import annotations

import datetime
import io
import json
import math
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pitchpoint.contact.potential_axes import MOST_POINTS, TableAxis
from pitchpoint.contact.potential_fit import PotentialTable, coefficients_shape
from pitchpoint.core.errors import ModelError, PitchpointError
from pitchpoint.core.provenance import content_hash, package_version, plain_data
from pitchpoint.io.opening import member
from pitchpoint.io.sealed_file import sealed, unsealed
from pitchpoint.io.target import CONTACT_TABLE, HDF5, check_target, reason_of, write_file
from pitchpoint.io.unmarked_file import DAMAGE

if TYPE_CHECKING:
    import h5py
    import numpy as np
    from numpy.typing import NDArray

SUFFIX = ".gcp.h5"
"""Usual extension."""
VERSION = 3
"""Version of the format."""
LARGEST_FILE = 1 << 28
"""Largest size of a file that is read [bytes]."""
LARGEST_ARRAY = 1 << 24
"""Largest number of values of an array."""
LONGEST_TEXT = 1 << 22
"""Largest size of the description [bytes]."""
FLANKS = ("front", "back")
"""Flanks whose tables a file contains."""
AXES = {"phase": "1", "approach": "m", "misalignment": "rad", "centre_distance": "m"}
"""Names and units of the axes."""
_PERIODS = {"phase": 1.0}
_OF_RATIOS = "f4"
"""Type of the ratios, which are linear between the points: single precision is far below their error."""
_NAMED = 3
"""Differing inputs that a message names."""
_PACKING: dict[str, Any] = {"compression": "gzip", "compression_opts": 4, "shuffle": True}


class ContactTableError(PitchpointError, OSError):
    """A contact table cannot be read, or is not the one for the model."""


class StaleTableError(ContactTableError):
    """A contact table was computed from other inputs.

    `differences` has stored and required value of each input that differs, by its path; None: missing.
    """

    def __init__(self, path: str, differences: Mapping[str, tuple[Any, Any]]) -> None:
        self.differences = dict(differences)
        parts = [f"{k} is {_shown(new)}, was {_shown(old)}" for k, (old, new) in self.differences.items()]
        more = f" and {len(parts) - _NAMED} more" if len(parts) > _NAMED else ""
        words = "; ".join(parts[:_NAMED])
        super().__init__(
            f"{path}: was computed from other inputs: {words}{more}; compute the table again by "
            "`pitchpoint contact-table` with level: flexible in the model"
        )


@dataclass(frozen=True)
class StoredTable:
    """Contents of a file: tables by flank, inputs as plain data, package version and date."""

    tables: Mapping[str, PotentialTable]
    inputs: Mapping[str, Any]
    version: str
    created: str


def write_contact_table(
    path: str | os.PathLike[str], tables: Mapping[str, PotentialTable], inputs: Mapping[str, Any]
) -> Path:
    """Write the tables of a mesh; an older file of the same name remains until the new one is complete.

    Parameters
    ----------
    path
        File to write, usually with the extension `.gcp.h5`.
    tables
        Tables by flank, `FLANKS`.
    inputs
        All that the tables depend on: both gears with micro-geometry, materials, options of the computation;
        nested data as for `content_hash`.

    Raises
    ------
    OutputError
        If the file cannot be written or must not be replaced.
    """
    import h5py
    import numpy as np

    target = check_target(path, "contact")
    plain = plain_data(inputs)
    description = {
        "version": package_version(),
        "created": datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds"),
        "inputs_hash": content_hash(plain),
        "inputs": plain,
        "tables": {flank: _described(table) for flank, table in tables.items()},
    }
    text = np.bytes_(json.dumps(description, sort_keys=True, allow_nan=False).encode("ascii"))
    file = h5py.File(target.name, "w", driver="core", backing_store=False, libver="latest")
    with file:
        file.attrs["format"] = np.bytes_(f"{CONTACT_TABLE}{VERSION}")
        file.attrs["source"] = np.bytes_(f"pitchpoint {package_version()}".encode("ascii", "replace"))
        file.create_dataset("description", data=text)
        for flank, table in tables.items():
            _write_table(file.create_group(flank), table)
        file.flush()
        image = file.id.get_file_image()
    return write_file(target, sealed(image))


def _described(table: PotentialTable) -> dict[str, Any]:
    """Options of the axes, quantities and errors of a table as plain data."""
    return {
        "axes": [{"doubled": a.doubled, "tolerance": float(a.tolerance)} for a in table.axes],
        "quantities": [[name, unit] for name, unit in table.quantities.items()],
        "errors": {name: list(map(float, sizes)) for name, sizes in table.errors.items()},
    }


def _write_table(group: h5py.Group, table: PotentialTable) -> None:
    """Write the arrays of a table."""
    import numpy as np

    for (name, unit), axis in zip(AXES.items(), table.axes, strict=True):
        group.create_dataset(name, data=axis.points, dtype="f8").attrs["units"] = np.bytes_(unit)
    group.create_dataset("coefficients", data=table.coefficients, dtype="f8", **_PACKING)
    packing = _PACKING if table.ratios.size else {}
    group.create_dataset("ratios", data=table.ratios, dtype=_OF_RATIOS, **packing)


def read_contact_table(path: str | os.PathLike[str], inputs: Mapping[str, Any] | None = None) -> StoredTable:
    """Read a table, and check that it was computed from the given inputs.

    Parameters
    ----------
    path
        File to read.
    inputs
        Inputs as for `write_contact_table`; None: not compared.

    Raises
    ------
    ContactTableError
        If the file is missing, damaged, too large, or of another kind or version.
    StaleTableError
        If inputs differ.
    """
    name = os.fspath(path)
    image = _contents(name)
    import h5py

    try:
        with h5py.File(io.BytesIO(image), "r") as file:
            found = _stored(name, file)
    except ModelError as error:
        raise ContactTableError(f"{name}: {_reason(error.problems[0])}") from error
    except PitchpointError:
        raise
    except DAMAGE as error:
        reason = _reason(error) or type(error).__name__
        raise ContactTableError(f"{name}: is not a contact table ({reason}); compute it again") from error
    if inputs is not None:
        differing = _differences(found.inputs, plain_data(inputs))
        if differing:
            raise StaleTableError(name, differing)
    return found


def _contents(name: str) -> memoryview:
    """Bytes of the file before its checksum."""
    try:
        size = os.stat(name).st_size
        if size > LARGEST_FILE:
            words = f"has {size} bytes (limit {LARGEST_FILE})"
            raise ContactTableError(f"{name}: {words} and is not read; compute a smaller table")
        data = Path(name).read_bytes()
    except FileNotFoundError as error:
        raise ContactTableError(f"{name}: there is no such contact table") from error
    except (OSError, ValueError) as error:
        if isinstance(error, ContactTableError):
            raise
        raise ContactTableError(f"{name}: cannot be read ({reason_of(error)})") from error
    image = unsealed(data)
    if image is None or image[: len(HDF5)] != HDF5:
        words = "is not a contact table, or is damaged: its checksum is missing or wrong"
        raise ContactTableError(f"{name}: {words}; compute it again")
    return image


def _stored(name: str, file: h5py.File) -> StoredTable:
    """Checked contents of an open file."""
    form = _text(file.attrs["format"]) if "format" in file.attrs else ""
    if not form.startswith(CONTACT_TABLE):
        raise ValueError("of another format")
    if form != f"{CONTACT_TABLE}{VERSION}":
        words = f"has the version {form.removeprefix(CONTACT_TABLE)[:20]} of the format, not {VERSION}"
        raise ContactTableError(f"{name}: {words}; compute it again")
    text = _dataset(file, "description")
    if text.shape != () or text.dtype.kind != "S" or text.dtype.itemsize > LONGEST_TEXT:
        raise ValueError("the description is not a text")
    said = json.loads(text[()].decode("ascii"))
    tables = {}
    for flank in FLANKS:
        group, options = member(file, flank), dict(said["tables"])[flank]
        axes = _axes(group, options["axes"])
        quantities = _quantities(options["quantities"])
        coefficients = _array(group, "coefficients", coefficients_shape(axes))
        ratios = _array(group, "ratios", (len(quantities), *(axis.count for axis in axes)), _OF_RATIOS)
        errors = {str(key): _errors(sizes) for key, sizes in dict(options["errors"]).items()}
        tables[flank] = PotentialTable(axes, coefficients, ratios, quantities, errors)
    stored, digest = dict(said["inputs"]), said["inputs_hash"]
    if content_hash(stored) != digest:
        raise ValueError("the inputs differ from their checksum")
    return StoredTable(tables, stored, str(said["version"]), str(said["created"]))


def _axes(file: h5py.Group, options: Any) -> tuple[TableAxis, TableAxis, TableAxis, TableAxis]:
    """The four axes."""
    found = []
    for name, option in zip(AXES, options, strict=True):
        item = _dataset(file, name)
        doubled, tolerance = option["doubled"], option["tolerance"]
        if math.prod(item.shape) > MOST_POINTS:
            raise ValueError(f"{name} has {math.prod(item.shape)} points (limit {MOST_POINTS})")
        if not isinstance(doubled, bool) or not _is_number(tolerance):
            raise ValueError(f"the options of the axis {name} are not valid")
        points = _array(file, name, item.shape[:1])
        found.append(TableAxis(name, points, doubled, _PERIODS.get(name, 0.0), float(tolerance)))
    if found[0].count < 2 or found[1].count < 2:
        raise ValueError("phase and approach have too few points")
    return found[0], found[1], found[2], found[3]


def _array(file: h5py.Group, name: str, shape: tuple[int, ...], kind: str = "f8") -> NDArray[np.float64]:
    """Array of a given shape and type, checked before memory is reserved."""
    item = _dataset(file, name)
    if item.shape != shape or item.dtype != kind:
        words = f"has the shape {item.shape} and type {item.dtype} instead of {shape}, {kind}"
        raise ValueError(f"{name} {words}")
    if math.prod(shape) > LARGEST_ARRAY:
        raise ValueError(f"{name} has {math.prod(shape)} values (limit {LARGEST_ARRAY})")
    values: NDArray[np.float64] = item[...].astype("f8", copy=False)
    return values


def _dataset(file: h5py.Group, name: str) -> h5py.Dataset:
    """Array stored in the file itself."""
    import h5py

    item = member(file, name)
    if not isinstance(item, h5py.Dataset):
        raise ValueError(f"{name} is not an array")
    return item


def _quantities(said: Any) -> dict[str, str]:
    """Units of further quantities by name."""
    found = dict(said)
    if not all(isinstance(unit, str) for unit in found.values()):
        raise ValueError("the further quantities are not valid")
    return found


def _errors(sizes: Any) -> tuple[float, float, float]:
    """Three finite sizes of an error."""
    if len(sizes) != 3 or not all(_is_number(v) and v >= 0.0 for v in sizes):
        raise ValueError("the measured errors are not valid")
    return float(sizes[0]), float(sizes[1]), float(sizes[2])


def _is_number(value: Any) -> bool:
    return isinstance(value, float | int) and not isinstance(value, bool) and math.isfinite(value)


def _text(value: Any) -> str:
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def _differences(stored: Any, wanted: Any) -> dict[str, tuple[Any, Any]]:
    """Stored and required values that differ, by path."""
    old, new = dict(_leaves(stored)), dict(_leaves(wanted))
    keys = [*new, *(key for key in old if key not in new)]
    pairs = {key: (old.get(key), new.get(key)) for key in keys}
    return {k: pair for k, pair in pairs.items() if k not in old or k not in new or pair[0] != pair[1]}


def _leaves(data: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    """Paths and values of nested plain data."""
    items = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else None
    if items is None or not data:
        yield path, data
        return
    for key, value in items:
        yield from _leaves(value, f"{path}.{key}" if path else str(key))


def _reason(error: object) -> str:
    """Message in one line."""
    return " ".join(str(error).split())[:200]


def _shown(value: Any) -> str:
    return "missing" if value is None else str(value)[:60]
