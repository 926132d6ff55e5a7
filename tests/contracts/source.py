# SPDX-License-Identifier: Apache-2.0
"""What the contract tests read: files of the project, their syntax trees, their kernels."""

from __future__ import annotations

import ast
import importlib
import pkgutil
from collections.abc import Iterator
from functools import lru_cache
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


@lru_cache(maxsize=1024)
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
