# SPDX-License-Identifier: Apache-2.0
"""Every kind of result that a command writes, and every tool of `analyse`, has a picture."""

from __future__ import annotations

import ast
from pathlib import Path

from pitchpoint.report import result_pictures
from pitchpoint.report.result_kinds import KINDS

CLI = Path(__file__).parents[2] / "src/pitchpoint/cli"


def written_kinds() -> set[str]:
    """Kinds of result files: the fourth argument of `header_of`."""
    found = set()
    for file in CLI.glob("*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            named = isinstance(node, ast.Call) and getattr(node.func, "id", "") == "header_of"
            if named and len(node.args) > 3 and isinstance(node.args[3], ast.Constant):
                found.add(str(node.args[3].value))
    return found


def test_every_kind_of_result_has_a_picture() -> None:
    kinds = written_kinds()
    assert {"time", "sweep", "modes", "campbell", "cases"} <= kinds
    assert not kinds - set(KINDS)
    drawn = {name.removesuffix("_figures") for name in vars(result_pictures) if name.endswith("_figures")}
    assert not {*KINDS, "analysis"} - drawn - {"time"}
