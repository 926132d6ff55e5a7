# SPDX-License-Identifier: Apache-2.0
"""Docstrings: everywhere, and with the parameters of the signature in the layers that carry equations."""

from __future__ import annotations

import ast
import re

from tests.contracts.source import (
    PACKAGE,
    Function,
    functions,
    is_kernel,
    is_public,
    name_of,
    python_files,
    tree,
)

MAKEFILE = PACKAGE.parents[1] / "Makefile"
LAYERS = ("geometry", "contact", "analysis", "core")
FILES = [p for p in python_files("src") if p.relative_to(PACKAGE).parts[0] in LAYERS]
_SECTION = re.compile(r"^(\w[\w ]*)\n-{3,}\n", re.MULTILINE)


def documented(doc: str) -> list[str] | None:
    """Names in the Parameters section of a numpydoc text, or None without such a section."""
    parts = _SECTION.split(doc)
    for title, body in zip(parts[1::2], parts[2::2], strict=True):
        if title == "Parameters":
            heads = [line for line in body.splitlines() if line and not line.startswith(" ")]
            return [n.strip().lstrip("*") for head in heads for n in head.split(":")[0].split(",")]
    return None


def parameters(function) -> list[str]:
    """Parameter names of a signature, in order, without self and cls."""
    a = function.args
    every = [*a.posonlyargs, *a.args, *([a.vararg] if a.vararg else []), *a.kwonlyargs]
    every += [a.kwarg] if a.kwarg else []
    return [x.arg for x in every if x.arg not in ("self", "cls")]


def test_all_public_names_say_what_they_are():
    """Functions, kernels, classes and methods of the whole package, those inside functions among them."""
    silent = [
        f"{name_of(path)}:{node.lineno}: {node.name}"
        for path in python_files("src")
        for node in ast.walk(tree(path))
        if isinstance(node, Function | ast.ClassDef)
        and is_public(node.name)
        and not (ast.get_docstring(node) or "").strip()
    ]
    assert not silent


def test_examples_of_every_package_are_run():
    """Those of packages that `make test` leaves out run in tests of their own."""
    (command,) = (line for line in MAKEFILE.read_text().splitlines() if "--doctest-modules" in line)
    assert " --doctest-modules src/pitchpoint " in command
    for package in re.findall(r"--ignore=src/pitchpoint/(\w+)", command):
        tests = (MAKEFILE.parent / "tests" / "unit" / package).glob("test_*docstrings.py")
        assert any("doctest" in path.read_text() for path in tests), package


def undocumented(path):
    """Public functions of a file whose documented parameters are not those of their signature."""
    wrong = []
    for name, function in functions(path):
        doc = ast.get_docstring(function)
        names = parameters(function)
        if not doc or not is_public(name):
            continue
        found = documented(doc)
        # a single parameter may be explained by the summary line
        needed = "." not in name and not is_kernel(function) and len(names) > 1
        if found is None and needed:
            wrong.append(f"{name_of(path)}: {name}: no Parameters section")
        elif found is not None and found != names:
            wrong.append(f"{name_of(path)}: {name}: documented {found}, signature {names}")
    return wrong


def test_documented_parameters_are_those_of_the_signature():
    assert not [line for path in FILES for line in undocumented(path)]
