# SPDX-License-Identifier: Apache-2.0
"""What the contract tests read: files of the project, their syntax trees, their kernels."""

from __future__ import annotations

import ast
import importlib
import pkgutil
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from types import ModuleType

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "src" / "pitchpoint"
FOLDERS = ("src", "tests", "benchmarks", "examples", "docs")

Function = ast.FunctionDef | ast.AsyncFunctionDef


def python_files(*folders: str) -> list[Path]:
    """Python files below folders of the project, sorted."""
    found = [p for f in (folders or FOLDERS) for p in (ROOT / f).rglob("*.py")]
    return sorted(p for p in found if "__pycache__" not in p.parts)


def name_of(path: Path) -> str:
    """Path relative to the project, for test ids and messages."""
    return path.relative_to(ROOT).as_posix()


@cache
def tree(path: Path) -> ast.Module:
    """Syntax tree of a file."""
    return ast.parse(path.read_text(encoding="utf-8"))


def is_kernel(function: Function) -> bool:
    """True for functions marked with the kernel decorator."""
    for decorator in function.decorator_list:
        target = decorator.func if isinstance(decorator, ast.Call) else decorator
        if isinstance(target, ast.Name) and target.id == "kernel":
            return True
    return False


def functions(path: Path) -> Iterator[tuple[str, Function]]:
    """Functions and methods of a file with their dotted names; nested functions belong to their owner."""
    for node in tree(path).body:
        if isinstance(node, Function):
            yield node.name, node
        elif isinstance(node, ast.ClassDef):
            for item in node.body:
                if isinstance(item, Function):
                    yield f"{node.name}.{item.name}", item


def is_public(dotted: str) -> bool:
    """True if no part of a dotted name is private."""
    return not any(part.startswith("_") for part in dotted.split("."))


def modules(*layers: str) -> Iterator[ModuleType]:
    """Import every module of some layers of the package."""
    for layer in layers:
        package = importlib.import_module(f"pitchpoint.{layer}")
        yield package
        for info in pkgutil.walk_packages(package.__path__, f"{package.__name__}."):
            yield importlib.import_module(info.name)


@cache
def imports_that_run(path: Path) -> tuple[ast.Import | ast.ImportFrom, ...]:
    """Import statements of a file at any depth, those inside functions too; not those for type checkers."""
    stack: list[ast.AST] = [tree(path)]
    found: list[ast.Import | ast.ImportFrom] = []
    while stack:
        node = stack.pop()
        if isinstance(node, ast.Import | ast.ImportFrom):
            found.append(node)
        elif isinstance(node, ast.If) and ast.unparse(node.test).endswith("TYPE_CHECKING"):
            stack += node.orelse
        elif not isinstance(node, ast.expr):
            stack += ast.iter_child_nodes(node)
    return tuple(found)


def import_graph() -> dict[str, set[str]]:
    """Modules of the package by module that imports them at any time."""
    places = {p: ".".join(p.relative_to(PACKAGE.parent).with_suffix("").parts) for p in PACKAGE.rglob("*.py")}
    names = {p: name.removesuffix(".__init__") for p, name in places.items()}
    modules = set(names.values())
    graph: dict[str, set[str]] = {}
    for path, name in names.items():
        found: set[str] = set()
        for node in imports_that_run(path):
            if isinstance(node, ast.Import):
                found |= {alias.name for alias in node.names}
            elif node.module is not None:
                members = {f"{node.module}.{alias.name}" for alias in node.names}
                found |= (members & modules) or {node.module}
        graph[name] = (found & modules) - {name}
    return graph


def circles(graph: dict[str, set[str]]) -> list[set[str]]:
    """Groups of modules of which each reaches all others of its group, largest first."""
    reached: dict[str, set[str]] = {}
    for name in graph:
        seen: set[str] = set()
        stack = [name]
        while stack:
            new = graph[stack.pop()] - seen
            seen |= new
            stack += new
        reached[name] = seen
    found: list[set[str]] = []
    for name, seen in reached.items():
        if name in seen and not any(name in group for group in found):
            found.append({other for other in seen if name in reached[other]})
    return sorted(found, key=lambda group: (-len(group), min(group)))
