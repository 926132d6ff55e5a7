# SPDX-License-Identifier: Apache-2.0
"""Storage of a data set: one file per case, named by the hash of its inputs, and a table of all cases.

A case is written to a temporary file, which is renamed when it is complete and on the disk: a file with the
name of a case is always complete, even if a process was killed. The checksum follows the HDF5 contents: a
file that has changed since is recomputed. The table is created from these files and replaced as a whole.
Files contain no creation time: equal inputs give equal files.
"""

from __future__ import annotations

import contextlib
import csv
import io
import os
import threading
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from pitchpoint.core.status import OK
from pitchpoint.io.container import FAILED, FINISHED, Header, MemoryContainer
from pitchpoint.io.csv_cells import plain_cell
from pitchpoint.io.reading import header_in
from pitchpoint.io.sealed_file import sealed, unsealed
from pitchpoint.io.target import (
    INDEX_HEAD,
    OutputError,
    cannot_be_written,
    check_target,
    replacing,
    write_draft,
)
from pitchpoint.io.unmarked_file import DAMAGE
from pitchpoint.io.write_lock import is_held

CASES = "cases"
DRAFT = ".draft-"
_ROWS = 8192
ATTEMPTS = 3
"""Maximum number of attempts to write a temporary file that another process removed."""


class DatasetFolder:
    """Folder of a data set.

    Parameters
    ----------
    path
        Folder, created if necessary. A folder with files other than a data set is rejected.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = Path(path)
        self.cases = self.path / CASES
        self._check()

    def _check(self) -> None:
        """Reject a path that is not a folder, or a folder with other files."""
        known = {CASES, "plan.yaml", "model.yaml"}
        try:
            others = [p.name for p in self.path.iterdir()] if self.path.exists() else []
        except OSError as error:
            raise OutputError(cannot_be_written(self.path, error)) from error
        strange = [n for n in others if n not in known and not n.startswith(("index", DRAFT))]
        if strange and not self.cases.is_dir():
            raise OutputError(
                f"output: {self.path} contains files of other kinds ({', '.join(sorted(strange)[:3])}); "
                "use a separate folder"
            )

    def begin(self, plan: str, model: str) -> None:
        """Create the folder, store plan and model, remove abandoned temporary files."""
        try:
            self.cases.mkdir(parents=True, exist_ok=True)
            for name, text in (("plan.yaml", plan), ("model.yaml", model)):
                _put(self.path / name, text.encode())
            for draft in (*self.cases.glob(f"{DRAFT}*"), *self.path.glob(f"{DRAFT}*")):
                with contextlib.suppress(OSError):
                    if not is_held(draft):
                        draft.unlink()
        except OSError as error:
            raise OutputError(cannot_be_written(self.path, error)) from error

    def file_of(self, key: str) -> Path:
        """File of a case."""
        return self.cases / f"{key}.h5"

    def known(self, keys: Iterable[str]) -> dict[str, dict[str, Any]]:
        """Metadata of the complete files of some cases: status, sentence, options."""
        import h5py

        there = {p.stem for p in self.cases.glob("*.h5")} if self.cases.is_dir() else set()
        found = {}
        for key in keys:
            if key in there and _is_whole(self.file_of(key)):
                with contextlib.suppress(*DAMAGE), h5py.File(self.file_of(key), "r") as file:
                    found[key] = header_in(file)
        return found

    def others(self, keys: Iterable[str]) -> int:
        """Number of case files that are not among these."""
        there = {p.stem for p in self.cases.glob("*.h5")} if self.cases.is_dir() else set()
        return len(there - set(keys))

    def write(self, record: Any, header: Header, sample_rate: float, samples: int) -> None:
        """Write one case: a `CaseRecord`, or anything with its attributes."""
        import numpy as np

        container = MemoryContainer(self.cases / f"{DRAFT}{record.key}", header)
        if record.channels:
            clock = {"units": "s", "long_name": "time", "symbol": "t"}
            time = container.dimension("time", np.arange(samples) / sample_rate, attributes=clock)
            for name, channel in record.channels.items():
                whole = np.issubdtype(channel.values.dtype, np.integer)
                made = container.variable(
                    name,
                    [time],
                    dtype="i1" if whole else "f4",
                    chunks=(min(_ROWS, samples),),
                    packed=True,
                    attributes={"units": channel.unit, "long_name": channel.long_name},
                )
                made[...] = channel.values
                made.attrs["noise_rms"] = channel.noise_rms
            for name, begun in record.pulses.items():
                words = {"units": "s", "long_name": f"times at which pulses of {name} begin"}
                container.dimension(f"{name}_times", begun, attributes=words)
        status = FINISHED if record.status == OK else FAILED
        container.finish(status, record.sentence, code=record.status, steps=record.steps, notes=record.notes)
        try:
            _put(self.file_of(record.key), sealed(container.image))
        except OSError as error:
            raise OutputError(cannot_be_written(self.file_of(record.key), error)) from error

    def write_index(self, name: str, columns: Sequence[str], rows: Iterable[Mapping[str, Any]]) -> Path:
        """Write the table of the cases (CSV); missing values are empty."""
        target = check_target(self.path / name, "index")
        text = io.StringIO()
        head = INDEX_HEAD.split(",")
        names = [*head, *columns]
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow([plain_cell(name) for name in names])
        writer.writerows([plain_cell(row.get(name, "")) for name in names] for row in rows)
        try:
            _put(target, text.getvalue().encode())
        except OSError as error:
            raise OutputError(cannot_be_written(target, error)) from error
        return target


def _is_whole(path: Path) -> bool:
    """Whether the checksum of a case file is valid."""
    try:
        return unsealed(path.read_bytes()) is not None
    except OSError:
        return False


def _put(target: Path, data: bytes) -> None:
    """Replace a file atomically by data that are on the disk."""
    draft = target.parent / f"{DRAFT}{target.name}-{os.getpid()}-{threading.get_ident()}"
    for attempt in range(ATTEMPTS):
        try:
            with replacing(target, draft):
                write_draft(draft, data)
            return
        except FileNotFoundError:  # another run removed the temporary file as abandoned
            if attempt + 1 == ATTEMPTS:
                raise
