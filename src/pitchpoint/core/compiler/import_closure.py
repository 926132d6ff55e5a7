# SPDX-License-Identifier: Apache-2.0
"""Import closure of a source file: all source files that it imports directly or indirectly.

The cache of compiled kernels is stamped with this closure (see `pitchpoint.core.compiler.machine_code`): all
functions that a kernel calls are in files of its closure.
"""

from __future__ import annotations

import importlib.util
import os
import re
from functools import cache
from pathlib import Path

_PACKAGES = {"pitchpoint"}
_INIT = "__init__.py"
_FROM = re.compile(r"^[ \t]*from[ \t]+(\.*[\w.]*)[ \t]+import[ \t]+(\([^)]*\)|[^\n#;]*)", re.MULTILINE)
_IMPORT = re.compile(r"^[ \t]*import[ \t]+([^\n#;]+)", re.MULTILINE)


def _root(file: Path) -> tuple[Path, str]:
    """Folder of the top-level package of a file, and the dotted name of the package of the file."""
    folder = file.parent
    parts: list[str] = []
    while (folder / "__init__.py").exists():
        parts.insert(0, folder.name)
        folder = folder.parent
    return folder, ".".join(parts)


def _locate(name: str, roots: dict[str, Path]) -> str | None:
    """File of a dotted module name in one of the `roots`, else None."""
    folder = roots.get(name.partition(".")[0])
    if folder is None:
        return None
    base = os.path.join(folder, *name.split("."))  # strings are three times as fast as Path objects
    for candidate in (base + ".py", os.path.join(base, _INIT)):
        if os.path.isfile(candidate):
            return candidate
    return None


def _imported(text: str, package: str) -> dict[str, set[str]]:
    """Dotted module names in the import statements of a source text, with the names imported from each."""
    names: dict[str, set[str]] = {}
    for match in _IMPORT.finditer(text):
        for part in match.group(1).split(","):
            names.setdefault(part.split(" as ")[0].strip(), set())
    for match in _FROM.finditer(text):
        base, what = match.group(1), match.group(2).strip("()")
        dots = len(base) - len(base.lstrip("."))
        if dots:
            stem = package.split(".")[: len(package.split(".")) - dots + 1]
            base = ".".join([*stem, *filter(None, [base.lstrip(".")])])
        parts = what.replace("\n", ",").split(",")
        names.setdefault(base, set()).update(part.split(" as ")[0].strip() for part in parts)
    return names


@cache
def _neighbours(path: Path, _age: int, roots: tuple[tuple[str, Path], ...]) -> tuple[Path, ...]:
    """Files that a file imports directly; cached, since closures of one package overlap."""
    text = path.read_text(encoding="utf-8", errors="replace")
    known, found = dict(roots), set()
    for base, parts in _imported(text, _root(path)[1]).items():
        file = _locate(base, known)
        found.add(file)
        if file is None or os.path.basename(file) == _INIT:  # names imported from a package may be modules
            found.update(_locate(f"{base}.{part}", known) for part in parts)
    return tuple(Path(f) for f in found if f is not None)


def import_closure(file: str | os.PathLike[str]) -> list[Path]:
    """Source files that a file imports directly or indirectly, within this package and its own.

    Parameters
    ----------
    file
        Source file to start from.

    Returns
    -------
    list of Path
        The file itself and all imported files, sorted, without third-party packages and the standard library.
    """
    start = Path(file).resolve()
    folder, package = _root(start)
    own = package.split(".")[0] if package else start.stem
    roots = {own: folder}
    for name in _PACKAGES - {own}:
        spec = importlib.util.find_spec(name)
        if spec is not None and spec.origin:
            roots[name] = Path(spec.origin).resolve().parent.parent
    if not package:  # a script may import modules of its folder
        roots.update({p.stem: folder for p in folder.glob("*.py") if p.stem not in roots})
    key = tuple(sorted(roots.items()))
    seen: set[Path] = set()
    stack = [start]
    while stack:
        path = stack.pop()
        if path in seen:
            continue
        seen.add(path)
        stack.extend(_neighbours(path, path.stat().st_mtime_ns, key))
    return sorted(seen)
