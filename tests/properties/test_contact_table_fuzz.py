# SPDX-License-Identifier: Apache-2.0
"""Damaged contact tables: an error with a sentence or the same table, never a crash or other numbers.

Files are cut, or have bits, bytes or sectors changed; others have objects changed and a valid checksum.
"""

from __future__ import annotations

import io
import os
import random
import subprocess
import sys
import textwrap
from pathlib import Path

import h5py
import numpy as np
import pytest

from pitchpoint.contact.potential_fit import PotentialTable
from pitchpoint.io.contact_table import write_contact_table
from pitchpoint.io.sealed_file import sealed, unsealed

SOON = 120.0
"""Seconds for all cases, many times what they need."""

READ = """
    import hashlib, sys
    from pathlib import Path
    import numpy as np
    from pitchpoint.core.errors import PitchpointError
    from pitchpoint.io.contact_table import read_contact_table

    for path in sorted(Path(sys.argv[1]).glob("*.h5")):
        print(path.name, end=" ", flush=True)
        try:
            tables = read_contact_table(path).tables
        except PitchpointError as error:
            assert str(path) in str(error) and "\\n" not in str(error), error
            print("refused", flush=True)
        else:
            packed = np.concatenate([table.packed for table in tables.values()])
            assert np.all(np.isfinite(packed))
            print(hashlib.sha256(packed.tobytes()).hexdigest(), flush=True)
"""


def outcomes(folder: Path) -> list[str]:
    """Word for each file in a process of its own, as a crash would end this one."""
    command = [sys.executable, "-c", textwrap.dedent(READ), str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=SOON, check=False)
    lines = done.stdout.splitlines()
    assert done.returncode == 0, (lines[-1:], done.stderr[-2000:])
    return [line.split()[1] for line in lines]


def good_file(folder: Path) -> bytes:
    """A file with small tables of both flanks."""
    springs = {
        "front": PotentialTable.of_spring(2e8, 0.0, 3e-5, 0.02),
        "back": PotentialTable.of_spring(1e8, 0.0, 3e-5),
    }
    return write_contact_table(folder / "good", springs, {"z": [17, 43]}).read_bytes()


def damaged(data: bytes, chance: random.Random) -> bytes:
    """Cut, or change bits, bytes or a sector."""
    raw, kind = bytearray(data), chance.choice(("cut", "bit", "bytes", "sector", "end", "none"))
    if kind == "cut":
        return bytes(raw[: chance.randrange(len(raw))])
    if kind == "bit":
        raw[chance.randrange(len(raw))] ^= 1 << chance.randrange(8)
    elif kind == "bytes":
        for _ in range(chance.randrange(1, 5)):
            raw[chance.randrange(len(raw))] = chance.randrange(256)
    elif kind == "sector":
        at = chance.randrange(len(raw) - 512)
        raw[at : at + 512] = bytes(512)
    elif kind == "end":
        raw += bytes(chance.randrange(1, 100))
    return bytes(raw)


@pytest.mark.parametrize("count", [150, pytest.param(5000, marks=pytest.mark.study)])
def test_damaged_files_are_refused(count: int, tmp_path: Path) -> None:
    data, chance, folder = good_file(tmp_path), random.Random(count), tmp_path / "damaged"
    folder.mkdir()
    (folder / "0000.h5").write_bytes(data)
    same = [True]
    for k in range(1, count):
        raw = damaged(data, chance)
        same.append(raw == data)
        (folder / f"{k:04d}.h5").write_bytes(raw)
    found = outcomes(folder)
    assert len(found) == count
    assert found[0] != "refused"
    for equal, outcome in zip(same, found, strict=True):
        assert outcome == (found[0] if equal else "refused")


def change_object(inside: h5py.File, chance: random.Random) -> None:
    """Remove, retype or reshape an object, or change an attribute, as HDF5 itself allows it."""
    names: list[str] = []
    inside.visit(names.append)
    name = chance.choice(names)
    item, kind = inside[name], chance.choice(("delete", "retype", "reshape", "group", "attribute", "number"))
    if kind == "attribute":
        at = chance.choice((inside, item))
        key = chance.choice([*at.attrs, "format"])
        at.attrs.pop(key, None)
        at.attrs[key] = chance.choice((b"\xff\xfe", 3.5, np.zeros(4), "", h5py.Empty("f"), -1))
        return
    if kind == "number" and isinstance(item, h5py.Dataset) and item.dtype.kind == "f" and item.size:
        item[tuple(chance.randrange(n) for n in item.shape)] = chance.choice(
            (np.nan, np.inf, -1.0, 1e30, 0.0)
        )
        return
    shape = item.shape if isinstance(item, h5py.Dataset) else (3,)
    del inside[name]
    if kind == "group":
        inside.create_group(name)
    elif kind == "retype":
        new = (np.full(shape, b"x"), np.zeros(shape, "i4"), np.zeros(shape, "c16"), np.float64(1.0))
        inside[name] = chance.choice(new)
    elif kind == "reshape":
        inside[name] = np.zeros(chance.choice(((0,), (1,), (2, 3), (7,), (), (1, 0, 0, 0, 0))))


@pytest.mark.parametrize("count", [40, pytest.param(2000, marks=pytest.mark.study)])
def test_changed_objects_under_a_valid_checksum(count: int, tmp_path: Path) -> None:
    image = bytes(unsealed(good_file(tmp_path)) or b"")
    chance, folder = random.Random(count), tmp_path / "changed"
    folder.mkdir()
    for k in range(count):
        contents = io.BytesIO(image)
        with h5py.File(contents, "r+") as inside:
            change_object(inside, chance)
        (folder / f"{k:04d}.h5").write_bytes(sealed(contents.getvalue()))
        os.utime(folder / f"{k:04d}.h5", (0.0, 0.0))
    found = outcomes(folder)
    assert len(found) == count
    assert found.count("refused") > 0.5 * count
