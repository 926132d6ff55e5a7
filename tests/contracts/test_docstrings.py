# SPDX-License-Identifier: Apache-2.0
"""Docstrings: everywhere, and with the parameters of the signature in the layers that carry equations."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

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
_ARRAYS = re.compile(r"Array|ndarray")
_TERMS = (ast.Mult, ast.Div, ast.Pow, ast.MatMult)
_FORMULA = 3
"""Products, quotients and powers from which on a function counts as a formula."""
_SOURCE = re.compile(
    r"\b(?:ISO|DIN|VDI|AGMA|IEC|BS)(?:/TR|/TS)? ?\d|\b(?:1[6-9]|20)\d\d\b|References\n---|Derivation: "
)
_DERIVATION = re.compile(r'Derivation:\s+(\S+\.md),\s+"([^"]+)"')
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


def described() -> Iterator[tuple[str, Function, str]]:
    """Public functions of the layers with equations: name, syntax tree, docstring. Without kernels."""
    for path in FILES:
        if path.relative_to(PACKAGE).parts[0] != "core":
            for name, function in functions(path):
                if is_public(name) and not is_kernel(function):
                    yield f"{name_of(path)}: {name}", function, ast.get_docstring(function) or ""


def test_shapes_of_arrays_are_given():
    """Of arguments and results: "shape (n,)", or the one that a result shares with an argument."""
    without = []
    for name, function, doc in described():
        a = function.args
        notes = [x.annotation for x in (*a.posonlyargs, *a.args, *a.kwonlyargs)] + [function.returns]
        arrays = any(note is not None and _ARRAYS.search(ast.unparse(note)) for note in notes)
        if arrays and not re.search(r"shape", doc, re.IGNORECASE):
            without.append(name)
    assert not without


def test_raised_errors_are_listed():
    """A function that raises has a section Raises."""
    raising = (
        (name, doc)
        for name, f, doc in described()
        if any(isinstance(n, ast.Raise) and n.exc for n in ast.walk(f))
    )
    assert not [name for name, doc in raising if "\nRaises\n------" not in doc]


def formulas() -> Iterator[tuple[str, str]]:
    """Public functions of geometry, contact and analysis with a formula: name, and docstrings around it."""
    for path in FILES:
        around = {n.name: ast.get_docstring(n) or "" for n in tree(path).body if isinstance(n, ast.ClassDef)}
        whole = ast.get_docstring(tree(path)) or ""
        for name, function in functions(path) if path.relative_to(PACKAGE).parts[0] != "core" else ():
            terms = [n for n in ast.walk(function) if isinstance(n, ast.BinOp) and isinstance(n.op, _TERMS)]
            if is_public(name) and len(terms) >= _FORMULA:
                docs = (ast.get_docstring(function) or "", around.get(name.split(".")[0], ""), whole)
                yield f"{name_of(path)}: {name}", "\n".join(docs)


def test_formulas_name_their_source():
    """A standard, a publication with its year, or the section of the theory that derives them."""
    assert not [name for name, doc in formulas() if not _SOURCE.search(doc)]


def test_derivations_are_where_docstrings_say():
    wrong = []
    for name, doc in formulas():
        for page, heading in _DERIVATION.findall(doc):
            text = (PACKAGE.parents[1] / page).read_text(encoding="utf-8")
            section = re.search(
                rf"^#+ {re.escape(' '.join(heading.split()))}\n(.*?)(?=^#|\Z)", text, re.M | re.S
            )
            if not section or name.split(": ")[0].removeprefix("src/pitchpoint/") not in section[1]:
                wrong.append(name)
    assert not wrong
