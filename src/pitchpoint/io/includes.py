# SPDX-License-Identifier: Apache-2.0
"""Model files of several parts: sections of included files are merged by name.

``include: [gears.yaml, ../common/bearings.yaml]`` names model files, by their paths from the folder of the
model file. Every name may be given once: a second one, also in another file, is an error. All file names of
all parts are relative to the folder of the model file.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from pitchpoint.core.errors import FileLine, Message, ModelError
from pitchpoint.core.nearest import similar_file
from pitchpoint.model import sections
from pitchpoint.model.keys import INCLUDE, Place, keys_of, remedy_for_key
from pitchpoint.model.model import Model
from pitchpoint.model.reading.yaml_tree import Tree, TreeError, text_of
from pitchpoint.model.show import dotted, shown

SUFFIXES = (".yaml", ".yml")
MAX_FILES = 200
MEANT = f"did you mean {INCLUDE}?"
SHOWN = 3
"""Names given twice in the same two files that are reported one by one."""


@dataclass
class Whole:
    """Contents of a model file and all included files, as of a single file.

    `incomplete` states that a file is missing or has no usable contents: its names are unknown everywhere.
    """

    data: Any
    lines: dict[Place, int] = field(default_factory=dict)
    problems: list[Message] = field(default_factory=list)
    files: list[str] = field(default_factory=list)
    incomplete: bool = False


def with_included(tree: Tree, folder: Path, name: str) -> Whole:
    """Contents of a model file with its included files.

    Parameters
    ----------
    tree
        Contents of the model file.
    folder
        Folder of the model file, the base of the names of included files.
    name
        Name of the model file, for messages.
    """
    if not isinstance(tree.data, dict) or not any(key == INCLUDE or means_include(key) for key in tree.data):
        return Whole(tree.data, tree.lines, tree.problems)
    whole = Whole({})
    merger = _Merger(whole, folder)
    merger.add(tree, (name,), "")
    merger.report_twice()
    return whole


class _Merger:
    """Adds the contents of files to a whole; `path` is the chain of files that include each other."""

    def __init__(self, whole: Whole, folder: Path) -> None:
        self.whole, self.folder = whole, folder
        self.twice: dict[tuple[str, str], list[tuple[Place, int, int]]] = {}

    def add(self, tree: Tree, path: tuple[str, ...], file: str) -> None:
        """Add the files that a file includes, then the file itself; `file` is empty for the first one."""
        lines = {at: FileLine(line, file) if file else line for at, line in tree.lines.items()}
        self.whole.lines.setdefault((), lines.get((), 1))
        self.whole.problems += [
            p.changed(line=FileLine(p.line or 1, file)) if file else p for p in tree.problems
        ]
        if not isinstance(tree.data, dict):
            if tree.data is not None:
                self.missing((), "is not a mapping of keys", lines.get((), 1), "begin with gears:")
            return
        for key in filter(means_include, tree.data):
            self.missing((key,), "is an unknown key", lines[(key,)], MEANT)
        wanted = tree.data.get(INCLUDE)
        if isinstance(wanted, str):
            wanted = [wanted]
        if wanted is not None and not isinstance(wanted, list):
            self.missing(
                (INCLUDE,), "is not a list of files", lines[(INCLUDE,)], "write [gears.yaml]", shown(wanted)
            )
        for k, name in enumerate(wanted if isinstance(wanted, list) else ()):
            self.include(name, path, lines.get((INCLUDE, k), lines[(INCLUDE,)]))
        for key, value in tree.data.items():
            if key != INCLUDE:
                self.merge(key, value, lines)

    def include(self, name: Any, path: tuple[str, ...], line: int) -> None:
        """Read one included file, unless it has been read."""
        place: Place = (INCLUDE,)
        if not isinstance(name, str) or not name.strip():
            self.missing(place, "is not the name of a file", line, "write [gears.yaml]", shown(name))
            return
        try:
            file = (self.folder / name).resolve()
            own = Path(os.path.relpath(file, self.folder.resolve())).as_posix()
        except (OSError, ValueError):
            file, own = Path(), name
        if Path(name).is_absolute() or own.split("/")[0] == ".." and file.suffix.lower() not in SUFFIXES:
            remedy = (
                "include files by their paths from the folder of the model file; outside of it, .yaml files"
            )
            self.missing(place, "is not the relative name of a model file", line, remedy, shown(name))
            return
        if own in path:
            chain = " -> ".join([*path[path.index(own) :], own])
            self.missing(place, f"forms a circle: {chain}", line, "remove one of these includes")
            return
        if own in self.whole.files:
            return
        if len(self.whole.files) >= MAX_FILES:
            self.missing(place, f"leads to more than {MAX_FILES} files", line, "join some of them")
            return
        if not file.is_file():
            text = "names a folder" if file.is_dir() else "names a file that does not exist"
            near = similar_file(self.folder, name, SUFFIXES)
            remedy = f"{near}file names are relative to the folder of the model file"
            self.missing(place, text, line, remedy, shown(name))
            return
        self.whole.files.append(own)
        try:
            tree = Tree(text_of(file))
        except TreeError as error:
            self.whole.incomplete = True
            self.whole.problems.append(error.problem.changed(line=FileLine(error.problem.line or 1, own)))
            return
        except ModelError as error:
            self.whole.incomplete = True
            self.whole.problems += [p.changed(line=FileLine(p.line or 1, own)) for p in error.problems]
            return
        self.add(tree, (*path, own), own)

    def merge(self, key: str, value: Any, lines: Mapping[Place, int]) -> None:
        """Add a key of a file: sections by name, other keys as a whole."""
        data = self.whole.data
        if key not in data:
            data[key] = dict(value) if isinstance(value, dict) else value
            self.adopt((key,), lines)
        elif value is None:
            return
        elif is_section(key) and isinstance(value, dict) and isinstance(data[key] or {}, dict):
            data[key] = data[key] or {}
            for name, part in value.items():
                if self.is_new((key, name), name in data[key], lines):
                    data[key][name] = part
                    self.adopt((key, name), lines)
        elif self.is_new((key,), data[key] is not None, lines):
            data[key] = value
            self.adopt((key,), lines)

    def is_new(self, place: Place, known: bool, lines: Mapping[Place, int]) -> bool:
        """Report a path that another file contains already."""
        if known:
            first, second = self.whole.lines[place], lines[place]
            of = getattr(first, "file", "the model file")
            self.twice.setdefault((of, getattr(second, "file", "")), []).append((place, first, second))
        return not known

    def report_twice(self) -> None:
        """Report names that are given twice; many of the same two files in one sentence."""
        for (of, _), found in self.twice.items():
            many = len(found) > SHOWN
            for place, first, line in found[: 1 if many else SHOWN]:
                text, remedy = f"is given twice, also in {of}, line {first}", "rename or remove one of them"
                if many:
                    plural = "s" if len(found) > SHOWN + 1 else ""
                    others = ", ".join(dotted(each) for each, _, _ in found[1:SHOWN])
                    text += f"; so are {others} and {len(found) - SHOWN} other{plural} of these two files"
                    remedy = "include one of them only"
                self.problem(place, text, line, remedy)
            self.whole.incomplete |= many

    def adopt(self, place: Place, lines: Mapping[Place, int]) -> None:
        """Take over the lines of a path and all paths below it."""
        self.whole.lines |= {at: line for at, line in lines.items() if at[: len(place)] == place}

    def missing(
        self, place: Place, text: str, line: int, remedy: str | None = None, value: str | None = None
    ) -> None:
        """Add a problem due to which contents are missing."""
        self.whole.incomplete = True
        self.problem(place, text, line, remedy, value)

    def problem(
        self, place: Place, text: str, line: int, remedy: str | None = None, value: str | None = None
    ) -> None:
        """Add a problem."""
        self.whole.problems.append(Message(dotted(place), text, value, None, remedy, line))


def is_section(key: str) -> bool:
    """Whether a key is a section with names."""
    known = keys_of(Model).get(key)
    return sections.find(key) is not None if known is None else known.kind in ("components", "parameters")


def means_include(key: object) -> bool:
    """Whether an unknown key probably means `include`."""
    if not isinstance(key, str) or key == INCLUDE or key in keys_of(Model) or sections.find(key) is not None:
        return False
    return remedy_for_key(key, {INCLUDE: None, **keys_of(Model)})[0] == INCLUDE
