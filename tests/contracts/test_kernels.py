# SPDX-License-Identifier: Apache-2.0
"""Kernels keep to the scalar dialect, and only one module knows the compiler, another its machine code."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache

import pytest

from pitchpoint.core import kernel
from pitchpoint.elements import registry
from tests.contracts.source import PACKAGE, Function, functions, is_kernel, name_of, python_files, tree

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


@cache
def kernels() -> dict[str, Function]:
    """Syntax trees of all kernels by file and name; not when the file is imported: each process does that."""
    return {
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
    assert len(kernels()) > 600
    assert not [f"{name}: {fault}" for name, function in kernels().items() for fault in faults(function)]


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
    public = {"public_numba", "intrinsics"}
    private = {"cache", "parts", "passes", "portable", "private_numba"}
    wanted = {
        "numba": public | private,
        "llvmlite": public | {"parts", "portable", "private_numba", "machine_code"},
    }
    assert found == {
        top: {f"src/pitchpoint/core/compiler/{name}.py" for name in names} for top, names in wanted.items()
    }


def test_the_door_uses_what_numba_documents_and_nothing_else():
    """What replaces the private way for other versions of Numba must not depend on its inside itself."""
    documented = {
        "numba": {"carray", "cfunc", "config", "njit", "typeof", "types"},
        "numba.extending": {"intrinsic", "typeof_impl"},
        "llvmlite": {"binding", "ir"},
    }
    for name in ("public_numba", "intrinsics"):
        for node in ast.walk(tree(PACKAGE / "core" / "compiler" / f"{name}.py")):
            source = (node.module or "") if isinstance(node, ast.ImportFrom) else ""
            if source.startswith(("numba", "llvmlite")):
                assert {a.name for a in node.names} <= documented[source]
            if isinstance(node, ast.Import):
                assert not [a.name for a in node.names if a.name.startswith(("numba.", "llvmlite."))]


OF_THE_LAW = {"power_force", "low_load", "stored_energy", "series_energy", "static_dynamic"}
OF_THE_LAW |= {"ramp", "linear_ramp"}
STATUS_OF_THE_CONTROL = {"bad", "badkind"}


def test_flanks_take_their_law_from_one_place() -> None:
    """No mesh, solver or page repeats force over penetration; remarks give the share of damping."""
    meshes = [
        path
        for path in python_files("src/pitchpoint/elements")
        if "mesh" in path.stem or "mesh" in path.parts
    ]
    assert len(meshes) > 10
    layers = ("solvers", "system", "report", "sweep", "analysis", "io", "viz")
    above = [path for layer in layers for path in python_files(f"src/pitchpoint/{layer}")]
    for path in (*meshes, *above):
        if path.match("system/remarks.py"):
            continue
        imported = {
            alias.name
            for node in ast.walk(tree(path))
            if isinstance(node, ast.ImportFrom)
            for alias in node.names
        }
        assert not imported & OF_THE_LAW, path


def test_elements_leave_the_control_record_alone() -> None:
    """All elements share it: one that rewrites it for its own evaluation changes the others if it stops."""
    from pitchpoint.multibody.channels import CTL

    fields = set(CTL.names or ()) - STATUS_OF_THE_CONTROL
    elements = {name: f for name, f in kernels().items() if name.startswith("src/pitchpoint/elements")}
    assert len(elements) > 400
    assert not [
        f"{name}, line {line}" for name, f in elements.items() for key, line in written(f) if key in fields
    ]


def written(function: Function) -> Iterator[tuple[object, int]]:
    """Fields of the control record that a function writes, with their lines."""
    for node in ast.walk(function):
        targets = node.targets if isinstance(node, ast.Assign) else ()
        targets = (node.target,) if isinstance(node, ast.AugAssign) else targets
        flat = [t for one in targets for t in (one.elts if isinstance(one, ast.Tuple) else (one,))]
        for target in flat:
            if not isinstance(target, ast.Subscript) or not isinstance(target.slice, ast.Constant):
                continue
            base = target.value.value if isinstance(target.value, ast.Subscript) else target.value
            if isinstance(base, ast.Name) and base.id in {"c", "ctl", "control"}:
                yield target.slice.value, target.lineno


def test_the_check_of_the_control_record_finds_what_is_written() -> None:
    function = ast.parse("def f(c, b):\n    c['t'] = b['t'] = 1.0\n    c['jac'] += 1").body[0]
    assert isinstance(function, ast.FunctionDef)
    assert list(written(function)) == [("t", 2), ("jac", 3)]


@pytest.mark.parametrize("name", registry.names())
def test_machine_code_of_elements_is_stored(name):
    """Every process would compile code again that could raise exceptions, such as an index of a tuple."""
    if not kernel.COMPILING:
        pytest.skip("no compiler")
    from pitchpoint.core.compiler import machine_code

    found = registry.find(name)
    for entry in (found.entry, *(entry for entry, _ in found.some.values())):
        kernel.address(entry)
        assert not machine_code.is_refused(entry.py_func), entry.py_func.__name__
