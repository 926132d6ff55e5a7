# SPDX-License-Identifier: Apache-2.0
"""Folder of many cases: one file per case, named by the hash of its inputs, and a table of all cases.

A case is written to a temporary file, which is renamed when it is complete and on the disk: a file with the
name of a case is always complete, even if a process was killed. The checksum follows the contents: a file
that has changed since is recomputed. The table is created from these files and replaced as a whole. Files
contain no creation time: equal inputs give equal files.
"""

from __future__ import annotations

import contextlib
import csv
import io
import os
import threading
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, ClassVar

from pitchpoint.io.csv_cells import plain_cell
from pitchpoint.io.sealed_file import sealed, unsealed
from pitchpoint.io.target import (
    INDEX_HEAD,
    OutputError,
    cannot_be_written,
    check_target,
    replacing,
    write_draft,
)
from pitchpoint.io.write_lock import is_held

CASES = "cases"
DRAFT = ".draft-"
ATTEMPTS = 3
"""Maximum number of attempts to write a temporary file that another process removed."""


class CaseFolder:
    """Folder of many cases.

    Parameters
    ----------
    path
        Folder, created if necessary. A folder with files of other kinds is rejected.
    """

    suffix: ClassVar[str] = ".h5"
    """End of the names of case files."""
    products: ClassVar[frozenset[str]] = frozenset()
    """Further files of the folder."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = Path(path)
        self.cases = self.path / CASES
        self._check()

    def _check(self) -> None:
        """Reject a path that is not a folder, or a folder with other files."""
        known = {CASES, "plan.yaml", "model.yaml", *self.products}
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
                put(self.path / name, text.encode())
            for draft in (*self.cases.glob(f"{DRAFT}*"), *self.path.glob(f"{DRAFT}*")):
                with contextlib.suppress(OSError):
                    if not is_held(draft):
                        draft.unlink()
        except OSError as error:
            raise OutputError(cannot_be_written(self.path, error)) from error

    def file_of(self, key: str) -> Path:
        """File of a case."""
        return self.cases / f"{key}{self.suffix}"

    def others(self, keys: Iterable[str]) -> int:
        """Number of case files that are not among these."""
        return len(self.complete() - set(keys))

    def complete(self) -> set[str]:
        """Keys of all case files."""
        return {p.stem for p in self.cases.glob(f"*{self.suffix}")} if self.cases.is_dir() else set()

    def contents(self, keys: Iterable[str]) -> Iterator[tuple[str, memoryview]]:
        """Contents of the complete files of some cases, without their checksums."""
        there = self.complete()
        for key in keys:
            if key in there and (data := _whole(self.file_of(key))) is not None:
                yield key, data

    def put_case(self, key: str, contents: bytes | memoryview) -> None:
        """Write the file of a case with its checksum."""
        try:
            put(self.file_of(key), sealed(contents))
        except OSError as error:
            raise OutputError(cannot_be_written(self.file_of(key), error)) from error

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
            put(target, text.getvalue().encode())
        except OSError as error:
            raise OutputError(cannot_be_written(target, error)) from error
        return target


def _whole(path: Path) -> memoryview | None:
    """Contents of a case file with a valid checksum."""
    try:
        return unsealed(path.read_bytes())
    except OSError:
        return None


def put(target: Path, data: bytes) -> None:
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
