# SPDX-License-Identifier: Apache-2.0
"""Imports: downward only, and nothing heavy before it is needed. Module lists, never timings."""

from __future__ import annotations

import ast
import importlib
import importlib.util
import subprocess
import sys
import tomllib

import pytest

import pitchpoint
from tests.contracts.source import PACKAGE, ROOT, circles, import_graph, name_of, python_files, tree

HEAVY = (
    "numba",
    "llvmlite",
    "scipy",
    "xarray",
    "pandas",
    "h5py",
    "h5netcdf",
    "plotly",
    "pint",
    "pydantic",
    "pywt",
)

HOUSE = ("pitchpoint", "tests", "benchmarks")

CIRCLES_LEFT = ({"core.compiler.public_numba", "core.compiler.private_numba", "core.kernel"},)
"""Groups of modules that import each other through imports inside functions; only to be shortened."""


def loaded_by(statement: str) -> set[str]:
    """Top-level packages in a fresh interpreter after a statement."""
    code = f"import sys\n{statement}\nprint('\\n'.join(sorted({{m.split('.')[0] for m in sys.modules}})))"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT)
    return set(run.stdout.split())


@pytest.mark.parametrize("statement", ["import pitchpoint", "import pitchpoint.cli.main"])
def test_the_package_and_its_command_load_nothing_heavy(statement):
    assert not loaded_by(statement) & {*HEAVY, "numpy", "rich"}


def test_help_loads_nothing_heavy():
    statement = (
        "import io, contextlib\nfrom pitchpoint.cli.main import run_command\n"
        "with contextlib.redirect_stdout(io.StringIO()): assert run_command(['--help']) == 0"
    )
    assert not loaded_by(statement) & {*HEAVY, "numpy"}


@pytest.mark.parametrize(
    "module", ["geometry", "analysis", "model.model", "core.units", "core.formula.formula"]
)
def test_these_need_no_heavy_library(module):
    assert not loaded_by(f"import pitchpoint.{module}") & set(HEAVY)


def test_a_file_is_read_without_the_compiler():
    example = sorted((ROOT / "examples" / "backlash-oscillator").glob("*.yaml"))[0]
    loaded = loaded_by(f"import pitchpoint; pitchpoint.load_model({str(example)!r})")
    assert not loaded & {"numba", "llvmlite", "scipy", "xarray", "h5py", "plotly"}


def test_import_contracts_hold():
    run = subprocess.run(
        [
            sys.executable,
            "-c",
            "from importlinter.cli import lint_imports_command; lint_imports_command()",
            "--no-logo",
        ],
        capture_output=True,
        text=True,
        check=False,
        cwd=ROOT,
    )
    assert run.returncode == 0, run.stdout


def test_no_modules_import_each_other():
    """Imports inside functions count: they hide a circle, they do not open it."""
    found = circles(import_graph())
    assert not [group for group in found if any(name.startswith("pitchpoint.model.") for name in group)]
    left = [{f"pitchpoint.{name}" for name in group} for group in CIRCLES_LEFT]
    new = [sorted(group) for group in found if not any(group <= known for known in left)]
    assert not new, f"modules import each other; move what both need into a third one: {new}"
    assert all(any(group == known for group in found) for known in left), "opened: shorten CIRCLES_LEFT"


def test_circles_are_found():
    graph = {"a": {"b"}, "b": {"c"}, "c": {"a", "d"}, "d": set(), "e": {"f"}, "f": {"e"}}
    assert circles(graph) == [{"a", "b", "c"}, {"e", "f"}]


def test_the_layer_contract_names_every_layer():
    """A new folder of the package has to take its place in the order of imports."""
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    contracts = settings["tool"]["importlinter"]["contracts"]
    layers = next(c for c in contracts if c["type"] == "layers")["layers"]
    named = {name.strip() for row in layers for name in row.split("|")}
    folders = {f"pitchpoint.{p.name}" for p in PACKAGE.iterdir() if (p / "__init__.py").exists()}
    assert named == folders
    analysis = next(c for c in contracts if c.get("source_modules") == ["pitchpoint.analysis"])
    assert set(analysis["forbidden_modules"]) == folders - {"pitchpoint.analysis", "pitchpoint.core"}


@pytest.mark.parametrize("name", pitchpoint.__all__)
def test_every_public_name_can_be_imported(name):
    assert getattr(pitchpoint, name) is not None


@pytest.mark.parametrize("path", python_files("benchmarks", "docs", "examples"), ids=name_of)
def test_names_imported_within_functions_exist(path):
    """Benchmarks and scripts run rarely, and import within functions."""
    missing = []
    for node in ast.walk(tree(path)):
        if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] in HOUSE:
            module = importlib.import_module(str(node.module))
            missing += [
                f"{node.module}.{name.name}"
                for name in node.names
                if not hasattr(module, name.name)
                and importlib.util.find_spec(f"{node.module}.{name.name}") is None
            ]
    assert not missing


def test_type_checkers_see_the_same_names():
    block = next(n for n in tree(PACKAGE / "__init__.py").body if isinstance(n, ast.If))
    seen = {a.name for n in block.body if isinstance(n, ast.ImportFrom) for a in n.names}
    assert seen | {"__version__"} == set(pitchpoint.__all__)
    assert sorted(pitchpoint.__all__) == dir(pitchpoint)
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        _ = pitchpoint.nothing
