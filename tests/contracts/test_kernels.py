# SPDX-License-Identifier: Apache-2.0
"""Kernels keep to the scalar dialect, and only one module knows the compiler, another its machine code."""

from __future__ import annotations

import ast

import pytest

from tests.contracts.source import PACKAGE, functions, is_kernel, name_of, python_files, tree

FORBIDDEN = {
    ast.Try: "try",
    ast.Raise: "raise",
    ast.Assert: "assert",
    ast.With: "with",
    ast.Lambda: "lambda",
    ast.FunctionDef: "nested function",
    ast.ListComp: "list comprehension",
    ast.DictComp: "dict comprehension",
    ast.SetComp: "set comprehension",
    ast.GeneratorExp: "generator",
    ast.List: "list",
    ast.Dict: "dict",
    ast.Set: "set",
    ast.JoinedStr: "formatted text",
    ast.Global: "global",
    ast.Nonlocal: "nonlocal",
    ast.Import: "import",
    ast.ImportFrom: "import",
    ast.Starred: "star argument",
    ast.Yield: "yield",
}
NUMPY_VALUES = {"pi", "inf", "nan", "e"}
METHODS_THAT_ALLOCATE = {"copy", "astype", "reshape", "flatten", "ravel", "sum", "dot", "tolist", "append"}

KERNELS = {
    f"{name_of(path)}::{name}": function
    for path in python_files("src")
    for name, function in functions(path)
    if is_kernel(function) and path != PACKAGE / "core" / "kernel.py"
}


def faults(function: ast.FunctionDef) -> list[str]:
    """Everything in a kernel that is outside the dialect, with its line."""
    found = []
    keys = set()
    for node in ast.walk(function):
        if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Constant):
            keys.add(node.slice)
    doc = ast.get_docstring(function, clean=False)
    for statement in function.body:
        for node in ast.walk(statement):
            kind = FORBIDDEN.get(type(node))
            text = isinstance(node, ast.Constant) and isinstance(node.value, str)
            if text and node not in keys and node.value != doc:
                kind = "text"
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "np":
                kind = None if node.attr in NUMPY_VALUES else f"np.{node.attr}"
            called = node.func if isinstance(node, ast.Call) else None
            if isinstance(called, ast.Attribute) and called.attr in METHODS_THAT_ALLOCATE:
                kind = f".{called.attr}()"
            if isinstance(called, ast.Name) and called.id == "print":
                kind = "print"
            if kind:
                found.append(f"line {node.lineno}: {kind}")
    return found


def test_kernels_keep_to_the_scalar_dialect():
    assert len(KERNELS) > 600
    assert not [f"{name}: {fault}" for name, function in KERNELS.items() for fault in faults(function)]


@pytest.mark.parametrize(
    ("line", "fault"),
    [
        ("x = np.zeros(3)", "np.zeros"),
        ("x = [1, 2]", "list"),
        ("raise ValueError('no')", "raise"),
        ("x = b['K'].copy()", ".copy()"),
        ("mode = 'fast'", "text"),
        ("return lambda y: y", "lambda"),
    ],
)
def test_the_check_itself_finds_faults(line, fault):
    function = ast.parse(f"def f(b):\n    '''Doc.'''\n    {line}").body[0]
    assert isinstance(function, ast.FunctionDef)
    assert any(fault in f for f in faults(function))


def test_the_check_itself_accepts_the_dialect():
    source = "def f(b, u):\n    k = b['K'][0, 0]\n    return k * math.sin(u) if u > np.pi else np.nan, 0.0"
    function = ast.parse(source).body[0]
    assert isinstance(function, ast.FunctionDef)
    assert faults(function) == []


def test_only_the_compiler_modules_import_the_compiler():
    found: dict[str, set[str]] = {}
    for path in python_files("src"):
        for node in ast.walk(tree(path)):
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else []
            names += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            for top in {n.split(".")[0] for n in names} & {"numba", "llvmlite"}:
                found.setdefault(top, set()).add(name_of(path))
    core = "src/pitchpoint/core"
    code = {f"{core}/compiler.py", f"{core}/compiler_parts.py"}
    assert found == {
        "numba": code | {f"{core}/compiler_cache.py", f"{core}/compiler_passes.py"},
        "llvmlite": code | {f"{core}/machine_code.py"},
    }
