# SPDX-License-Identifier: Apache-2.0
"""Whether the Python functions that signals name are there, without running anything of their files."""

from __future__ import annotations

import ast
from pathlib import Path
from typing import TYPE_CHECKING

from pitchpoint.core.nearest import did_you_mean
from pitchpoint.model.components.block import LawBlock
from pitchpoint.model.components.controller import PythonController
from pitchpoint.model.keys import Place
from pitchpoint.model.read import Reader
from pitchpoint.model.signal_names import CONTROLLER_ARGUMENTS, LAW_ARGUMENTS

if TYPE_CHECKING:
    from pitchpoint.model.components.law import PythonLaw
    from pitchpoint.model.parts import Parts

Definition = ast.FunctionDef | ast.AsyncFunctionDef


def check_functions(parts: Parts, report: Reader) -> None:
    """Files and functions exist and take what they are called with."""
    for name, block in parts.blocks.items():
        if isinstance(block, LawBlock):
            _function(block.function, LAW_ARGUMENTS, ("blocks", name, "function"), report)
    for name, part in parts.controllers.items():
        if isinstance(part, PythonController):
            _function(part.function, CONTROLLER_ARGUMENTS, ("controllers", name, "function"), report)


def _function(law: PythonLaw, arguments: tuple[str, ...], at: Place, report: Reader) -> None:
    file = Path(law.file)
    try:
        tree = ast.parse(file.read_bytes(), file.name)
    except OSError:
        report.problem(
            at,
            f"names the file '{file.name}', which is not there",
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


def _may_bind(tree: ast.Module, name: str) -> bool:
    """Whether statements other than definitions may define a name, which only running them would show."""
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
