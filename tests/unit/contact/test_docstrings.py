# SPDX-License-Identifier: Apache-2.0
"""Every function of the contact layer explains itself, and the numbers in its docstring are right."""

from __future__ import annotations

import ast
import doctest
import importlib
import pkgutil
from pathlib import Path

import pytest

import pitchpoint.contact

MODULES = sorted(m.name for m in pkgutil.walk_packages(pitchpoint.contact.__path__, "pitchpoint.contact."))


@pytest.mark.parametrize("name", MODULES)
def test_examples_are_right(name):
    module = importlib.import_module(name)
    runner, finder = doctest.DocTestRunner(), doctest.DocTestFinder()
    for key, value in list(vars(module).items()):
        if getattr(value, "__module__", None) == name and getattr(value, "__doc__", None):
            plain = getattr(value, "py_func", value)
            for test in finder.find(plain, key, globs=dict(vars(module))):
                runner.run(test)
    assert runner.failures == 0


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
