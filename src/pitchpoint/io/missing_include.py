# SPDX-License-Identifier: Apache-2.0
"""Unknown names that another file of the folder has: the cause is a missing `include`."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.io.includes import SUFFIXES, Whole, is_section
from pitchpoint.model.keys import INCLUDE
from pitchpoint.model.reading.yaml_tree import Tree, TreeError, text_of

LARGEST = 100_000
"""Size of the files that are looked at [bytes]."""
MOST = 30
"""Number of files that are looked at."""
LEAST = 3
"""Unknown names in problems from which a file may be missing."""
FEWEST = 2
"""Number of these names that the file must have."""
LISTED = 4
ABSENT = "which does not exist"
"""Words of problems with the name of a component of another section, or of none."""
_QUOTED = re.compile(r"'([^']*)'")
_WORD = re.compile(r"[A-Za-z_]\w*")
_KEY = re.compile(r"""([A-Za-z_]\w*)["']?\s*:""")


def with_missing_include(problems: Sequence[Message], whole: Whole, file: Path) -> list[Message]:
    """Problems of a file, with those due to one file that is not included in one, the first.

    Parameters
    ----------
    problems
        Problems of the file.
    whole
        Its contents, with included files.
    file
        The file.
    """
    own = set(_names(whole.data))
    known = {name for _, name in own}
    unknown = [(p, _words(p) - (known if ABSENT not in p.text else set())) for p in problems]
    if sum(bool(words) for _, words in unknown) < LEAST:
        return list(problems)
    wanted = set().union(*(words for _, words in unknown))
    found: dict[str, set[str]] = {}
    for other in _files(file, whole.files):
        data = _data(other, wanted)
        there = set(_names(data))
        if data is None or there & own or any(key in whole.data for key in data if not is_section(key)):
            continue  # not a part of this model, which would have a name twice
        if shared := {name for _, name in there} & wanted:
            found[other.relative_to(file.parent).as_posix()] = shared
    if not found:
        return list(problems)
    most = max(map(len, found.values()))
    best = [name for name, shared in found.items() if len(shared) == most]
    names = found[best[0]]
    due = [problem for problem, words in unknown if words & names]
    if len(due) < LEAST or len(names) < FEWEST:
        return list(problems)
    return [_cause(due, names, best, whole), *(problem for problem in problems if problem not in due)]


def _cause(due: Sequence[Message], names: set[str], files: Sequence[str], whole: Whole) -> Message:
    """The missing file as one problem."""
    order = sorted(sorted(names), key=lambda name: next(k for k, p in enumerate(due) if name in _words(p)))
    listed = ", ".join(order[:LISTED]) + (f" and {len(order) - LISTED} more" if order[LISTED:] else "")
    have = f"{files[0]} has" if not files[1:] else f"each of {', '.join(files[:-1])} and {files[-1]} has"
    lacks = "lacks a file" if whole.files else "is missing"
    add = ", ".join([*whole.files, files[0]])
    return Message(
        INCLUDE,
        f"{lacks}: {len(due)} problems are names that this model does not define, and that {have} ({listed})",
        remedy=f"write include: [{add}]{', or another of them' if files[1:] else ''}",
        line=whole.lines.get((INCLUDE,), 1),
    )


def _words(problem: Message) -> set[str]:
    """Words in the quotations of a problem."""
    quoted = _QUOTED.findall(f"{problem.value or ''} {problem.text}")
    return {word for text in quoted for word in _WORD.findall(text)}


def _names(data: Any) -> Iterator[tuple[str, str]]:
    """Sections and names of the components of a file."""
    for key, part in data.items() if isinstance(data, Mapping) else ():
        if isinstance(part, Mapping) and is_section(key):
            yield from ((key, str(name)) for name in part)


def _files(file: Path, included: Iterable[str]) -> list[Path]:
    """Other small files of the folder that are not included."""
    there = {file.resolve(), *((file.parent / name).resolve() for name in included)}
    found = sorted(path for path in file.parent.glob("*") if path.suffix.lower() in SUFFIXES)
    small = [p for p in found if p.is_file() and p.stat().st_size <= LARGEST and p.resolve() not in there]
    return small[:MOST]


def _data(path: Path, wanted: set[str]) -> dict[str, Any] | None:
    """Contents of a file; None if it is not a mapping, or its text has too few of the names as keys."""
    try:
        text = text_of(path)
        if len(wanted.intersection(_KEY.findall(text))) < FEWEST:
            return None  # parsing takes half a second for the largest file
        data = Tree(text).data
    except (ModelError, TreeError):
        return None
    return data if isinstance(data, dict) else None
