# SPDX-License-Identifier: Apache-2.0
"""Every function of the contact layer explains itself, and the numbers in its docstring are right."""

from __future__ import annotations

import ast
import doctest
import importlib
import io
import json
import os
import pkgutil
import subprocess
import sys
from pathlib import Path

import pytest

import pitchpoint.contact

MODULES = sorted(m.name for m in pkgutil.walk_packages(pitchpoint.contact.__path__, "pitchpoint.contact."))


@pytest.fixture(scope="module")
def reports() -> dict[str, str]:
    """What the examples of each module report, nothing if they are right.

    Kernels run as plain Python in a process of their own: calls from Python would compile each of them with a
    wrapper, which no solver uses and which takes ten times as long as all examples.
    """
    command = [sys.executable, "-m", "tests.unit.contact.test_docstrings"]
    environment = {**os.environ, "NUMBA_DISABLE_JIT": "1"}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    return dict(json.loads(done.stdout))


@pytest.mark.parametrize("name", MODULES)
def test_examples_are_right(name, reports):
    assert reports[name] == ""


def report_of(name: str) -> str:
    """What the examples of a module report."""
    module, said = importlib.import_module(name), io.StringIO()
    runner, finder = doctest.DocTestRunner(verbose=False), doctest.DocTestFinder()
    for key, value in list(vars(module).items()):
        if getattr(value, "__module__", None) == name and getattr(value, "__doc__", None):
            for test in finder.find(value, key, globs=dict(vars(module))):
                runner.run(test, out=said.write)
    return said.getvalue()


@pytest.mark.parametrize("name", MODULES)
def test_public_functions_have_an_example(name):
    module = importlib.import_module(name)
    tree = ast.parse(Path(module.__file__).read_text(encoding="utf-8"))
    without = [
        node.name
        for node in tree.body
        if isinstance(node, ast.FunctionDef)
        and not node.name.startswith("_")
        and ">>>" not in (ast.get_docstring(node) or "")
    ]
    assert without == []


if __name__ == "__main__":
    print(json.dumps({name: report_of(name) for name in MODULES}))
