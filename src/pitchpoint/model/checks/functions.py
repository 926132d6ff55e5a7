# SPDX-License-Identifier: Apache-2.0
"""Checks of Python functions named in a model: file, function, number of arguments and of parameters.

The file is parsed, not run.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any, NamedTuple

from pitchpoint.core.nearest import did_you_mean
from pitchpoint.model.components.law import PythonLaw
from pitchpoint.model.keys import Place
from pitchpoint.model.parts import Parts
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.signals import APPENDED, CONTROLLER_ARGUMENTS, LAW_ARGUMENTS

Definition = ast.FunctionDef | ast.AsyncFunctionDef


class Named(NamedTuple):
    """A function named in a model: its place, its arguments and the number of parameters that it receives."""

    law: PythonLaw
    at: Place
    arguments: tuple[str, ...]
    parameters: int


def check_functions(parts: Parts, report: Reader) -> None:
    """Check that files and functions exist and have the required arguments and parameters."""
    groups = {name: group for name, group in vars(parts).items() if name in GROUPS} | parts.sections
    for section, group in groups.items():
        for found in _named(group, (section,)):
            _function(found, report)


GROUPS = ("meshes", "bearings", "couplings", "loads", "scenarios")
"""Sections with attributes of their own in `Parts` that may name functions."""


def _named(part: Any, at: Place) -> Iterator[Named]:
    """All functions within a component, mapping or sequence."""
    if isinstance(part, PythonLaw):
        yield Named(part, at, LAW_ARGUMENTS, len(part.parameters) + APPENDED.get(str(at[0]), 0))
    elif isinstance(getattr(part, "function", None), PythonLaw):  # blocks and controllers have `parameters`
        arguments = CONTROLLER_ARGUMENTS if at[0] == "controllers" else LAW_ARGUMENTS
        yield Named(part.function, (*at, "function"), arguments, len(part.parameters))
    elif is_dataclass(part):
        for field in fields(part):
            yield from _named(getattr(part, field.name), (*at, field.name))
    elif isinstance(part, Mapping):
        for name, value in part.items():
            yield from _named(value, (*at, name))
    elif isinstance(part, list | tuple):
        for i, value in enumerate(part):
            if is_dataclass(value) or isinstance(value, list | tuple):
                yield from _named(value, (*at, i))


def _function(found: Named, report: Reader) -> None:
    law, at, arguments, _ = found
    file = Path(law.file)
    try:
        tree = ast.parse(file.read_bytes(), file.name)
    except OSError:
        report.problem(
            at,
            f"names the file '{file.name}', which does not exist",
            remedy="give it relative to the model file",
        )
        return
    except SyntaxError as error:
        report.problem(
            at, f"names '{file.name}', which is not valid Python: {error.msg} (its line {error.lineno})"
        )
        return
    except ValueError:
        report.problem(at, f"names '{file.name}', which is not Python text")
        return
    known = {node.name: node for node in tree.body if isinstance(node, Definition)}
    if law.function not in known:
        if not _may_bind(tree, law.function):
            listed = ", ".join(known) or "none"
            report.problem(
                at,
                f"names the function {law.function!r}, which '{file.name}' does not define",
                remedy=f"{did_you_mean(law.function, known)}functions there: {listed}",
            )
        return
    node = known[law.function]
    count = len(node.args.posonlyargs) + len(node.args.args)
    if count != len(arguments) and not node.decorator_list:
        report.problem(
            at,
            f"names {law.function} of '{file.name}' (its line {node.lineno}), which takes {count} arguments",
            limit=str(len(arguments)),
            remedy=f"define it as {law.function}({', '.join(arguments)})",
        )
        return
    if count == len(arguments):
        _parameters(found, node, report)


def _parameters(found: Named, node: Definition, report: Reader) -> None:
    """Compare the given parameters with the largest constant index of the last argument.

    Compiled functions do not check their indices: a missing parameter would be whatever follows in memory.
    """
    last = [*node.args.posonlyargs, *node.args.args][-1].arg
    used = [
        (n.slice.value, n.lineno)
        for n in ast.walk(node)
        if isinstance(n, ast.Subscript)
        and isinstance(n.value, ast.Name)
        and n.value.id == last
        and isinstance(n.slice, ast.Constant)
        and type(n.slice.value) is int
    ]
    index, line = max(used, default=(-1, 0))
    if index >= found.parameters:
        file = Path(found.law.file).name
        have = f"{found.parameters or 'no'} parameter{'' if found.parameters == 1 else 's'}"
        report.problem(
            found.at,
            f"has {have}, but {found.law.function} of '{file}' uses {last}[{index}] (its line {line})",
            limit=f">= {index + 1}",
            remedy="add the numbers: parameters: [...], in the order of the function",
        )


def _may_bind(tree: ast.Module, name: str) -> bool:
    """Whether statements other than definitions may define a name, which cannot be decided without running
    them."""
    simple = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Expr)
    for node in tree.body:
        if isinstance(node, ast.Import | ast.ImportFrom):
            if any((a.asname or a.name).split(".")[0] in (name, "*") for a in node.names):
                return True
        elif (
            isinstance(node, ast.ClassDef)
            and node.name == name
            or not isinstance(node, simple)
            and any(
                isinstance(n, ast.Name) and n.id == name or isinstance(n, Definition) and n.name == name
                for n in ast.walk(node)
            )
        ):
            return True
    return False
