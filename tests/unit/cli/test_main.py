# SPDX-License-Identifier: Apache-2.0
"""The command line itself: help, speed of starting, exit codes, sentences instead of tracebacks."""

from __future__ import annotations

import errno
import json
import os
import subprocess
import sys
from pathlib import Path

import click
import pytest

from pitchpoint.cli import failure, main
from pitchpoint.core import status as st
from pitchpoint.core.errors import (
    CompileError,
    GeometryError,
    Message,
    MissingDependencyError,
    ModelError,
    SolverError,
    UnitError,
)
from tests.support.model_files import TORSIONAL_PAIR


def test_help_lists_every_command_and_every_command_exists(capsys: pytest.CaptureFixture[str]) -> None:
    assert main.run_command(["--help"]) == 0
    out = capsys.readouterr().out
    for name, words in main.COMMANDS.items():
        assert name in out
        assert words in out
        assert main.run_command([name, "--help"]) == 0
        assert name in capsys.readouterr().out


def test_help_imports_nothing_heavy() -> None:
    code = """
import sys
from pitchpoint.cli.main import run_command
run_command(["--help"])
heavy = {"numpy", "scipy", "numba", "xarray", "h5py", "pint", "plotly", "pydantic", "rich", "ruamel"}
print(sorted(heavy & set(sys.modules)))
"""
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert out.splitlines()[-1] == "[]"


def test_version(capsys: pytest.CaptureFixture[str]) -> None:
    assert main.run_command(["--version"]) == 0
    assert capsys.readouterr().out.startswith("pitchpoint ")


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (["chek"], "did you mean check?"),
        (["check"], "Missing argument 'FILE'"),
        (["check", "no_such.yaml"], "does not exist"),
        (["mesh", "--eps-alpha", "1.3", "--epsbeta", "1"], "No such option"),
        (["mesh"], "give a model FILE"),
        (["mesh", "--eps-alpha", "-1"], "eps-alpha"),
        (["mesh", "--eps-alpha", "nan"], "eps_alpha"),
        (["mesh", "--eps-alpha", "1.3", "--stiffness-ratio", "2"], "stiffness_ratio"),
        (["examples", "copy", "no-such"], "no example"),
    ],
)
def test_bad_command_lines_exit_2(
    arguments: list[str], expected: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main.run_command(arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert expected in captured.err
    assert "Traceback" not in captured.err


@pytest.mark.parametrize(
    ("error", "code", "expected"),
    [
        (
            ModelError([Message("gears.g1.b", "is negative", "-1 mm", line=4)]),
            2,
            "gears.g1.b (line 4): -1 mm",
        ),
        (UnitError("'4 kg' is not a length"), 2, "error: '4 kg'"),
        (GeometryError("no contact", where="meshes.stage"), 2, "meshes.stage"),
        (CompileError("body b floats"), 2, "body b floats"),
        (SolverError("diverged at t = 0.1 s", st.DIVERGED, Path("out.h5")), 3, "in out.h5"),
        (SolverError("NaN", st.NOT_FINITE), 3, f"(status {st.NOT_FINITE}): NaN"),
        (SolverError("stopped at t = 0.1 s", st.INTERRUPTED, "out.h5"), 130, "interrupted"),
        (MissingDependencyError("install pitchpoint[cad]"), 2, "pitchpoint[cad]"),
        (KeyboardInterrupt(), 130, "interrupted"),
        (MemoryError(), 3, "not enough memory"),
        (PermissionError(13, "Permission denied", "x.h5"), 2, "x.h5: permission denied"),
        (ZeroDivisionError("division by zero"), 1, "bug in pitchpoint"),
        (click.UsageError("no"), 2, "no"),
    ],
)
def test_every_error_becomes_a_sentence_and_a_code(
    error: BaseException, code: int, expected: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert failure.exit_code_of(error) == code
    captured = capsys.readouterr()
    assert captured.out == ""
    assert expected in captured.err
    assert "Traceback" not in captured.err


def test_debug_shows_the_traceback(capsys: pytest.CaptureFixture[str]) -> None:
    try:
        raise ZeroDivisionError("division by zero")
    except ZeroDivisionError as error:
        assert failure.exit_code_of(error, debug=True) == 1
    assert "Traceback" in capsys.readouterr().err


def test_the_script_exits_with_the_code() -> None:
    command = [sys.executable, "-c", "from pitchpoint.cli.main import main; main()", "mesh"]
    done = subprocess.run(
        [*command, "--eps-alpha", "1.3", "--json"], capture_output=True, text=True, check=True
    )
    assert list(json.loads(done.stdout)["meshes"]) == ["mesh"]
    assert done.stderr == ""
    assert subprocess.run(command, capture_output=True, check=False).returncode == 2


def test_a_closed_pipe_is_no_error(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def closed(data: object) -> None:
        raise BrokenPipeError(errno.EPIPE, "Broken pipe")

    monkeypatch.setattr(sys, "stdout", sys.stdout)  # click wraps both for the rest of the process
    monkeypatch.setattr(sys, "stderr", sys.stderr)
    monkeypatch.setattr("pitchpoint.cli.mesh.emit_json", closed)
    assert main.run_command(["mesh", "--eps-alpha", "1.3", "--json"]) == 1
    assert capsys.readouterr().err == ""


def test_the_page_of_commands_shows_what_help_prints(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    import runpy

    monkeypatch.setenv("COLUMNS", "102")  # the page is 100 wide; click keeps two columns free
    folder = Path(__file__).parents[3] / "docs"
    monkeypatch.syspath_prepend(folder)  # it imports its neighbours
    page = runpy.run_path(str(folder / "generate.py"))["commands"]()
    for command in (["run"], ["examples"], ["examples", "copy"]):
        assert main.run_command([*command, "--help"]) == 0
        said = capsys.readouterr().out
        assert "-h, --help" in said
        assert f"```\n{said}```" in page


def test_a_terminal_that_knows_ascii_only(tmp_path: Path) -> None:
    file = tmp_path / "pair.yaml"
    file.write_text("title: Ω and δ\n" + TORSIONAL_PAIR.partition("\n")[2], encoding="utf-8")
    for command in (["gears", str(file)], ["check", str(file)], ["modes", str(file)]):
        code = "from pitchpoint.cli.main import main; main()"
        done = subprocess.run(
            [sys.executable, "-c", code, *command],
            env={**os.environ, "PYTHONIOENCODING": "ascii"},
            capture_output=True,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        assert b"UnicodeEncodeError" not in done.stderr


def test_bytecode_that_a_full_disk_has_cut_is_named(tmp_path: Path) -> None:
    """Python keeps what fits; it ends with an EOFError, which click would call an interruption."""
    command = [sys.executable, "-c", "from pitchpoint.cli.main import main; main()", "examples", "list"]
    environment = {**os.environ, "PYTHONPYCACHEPREFIX": str(tmp_path), "PYTHONDONTWRITEBYTECODE": ""}
    runs = []
    for _ in range(2):
        runs.append(subprocess.run(command, env=environment, capture_output=True, text=True, check=False))
        (file,) = tmp_path.rglob("cli/examples.*.pyc")
        file.write_bytes(file.read_bytes()[:1000])
    assert [run.returncode for run in runs] == [0, 3], runs[1].stderr
    assert "compiled Python files of the installation are damaged" in runs[1].stderr
    assert "__pycache__" in runs[1].stderr
