# SPDX-License-Identifier: Apache-2.0
"""Files in folders that do not exist yet: every command makes them and says so, or says why it cannot."""

from __future__ import annotations

from pathlib import Path

import click
import pytest

from pitchpoint.cli.main import COMMANDS, LazyGroup, run_command
from pitchpoint.cli.options import report_folders
from tests.support.cli_files import TORSION, written

FRF = ["-i", "transmission_error[stage]", "-r", "mesh_force[stage]", "--to", "5 kHz", "--points", "2"]
WRITE = {
    "gears --export": ["--gear", "g1", "--export", "{}.svg"],
    "gears --preview": ["--gear", "g1", "--preview", "{}.svg"],
    "modes --animation": ["--animation", "{}.npz"],
    "modes --output": ["-o", "{}.h5"],
    "frf --picture": [*FRF, "--picture", "{}.html"],
    "view --output": ["-o", "{}.html"],
}


def called(command: str, file: str, target: Path, *more: str) -> int:
    given = [word.format(target) for word in WRITE[command]]
    return run_command([command.split()[0], file, *given, *more])


@pytest.mark.parametrize("command", WRITE)
def test_folders_are_made_and_told(command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, new = written(tmp_path, TORSION), tmp_path / "new"
    assert called(command, file, new / "deep" / "x") == 0
    assert f"note: the folder {new} is new" in capsys.readouterr().err
    (made,) = (new / "deep").iterdir()
    assert made.stat().st_size > 500
    # a second time it replaces its own file and makes no folder
    assert called(command, file, new / "deep" / "x") == 0
    assert "note: the folder" not in capsys.readouterr().err


@pytest.mark.parametrize("command", WRITE)
def test_neither_inputs_nor_places_below_files(
    command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Said before anything is computed, with code 2; nothing is left behind."""
    file = written(tmp_path, TORSION)
    assert called(command, file, Path(file) / "x") == 2
    err = capsys.readouterr().err
    assert "cannot be written" in err
    assert "note: the folder" not in err
    other = tmp_path / ("x" + WRITE[command][-1].removeprefix("{}"))
    other.write_text("notes of mine")
    assert called(command, file, tmp_path / "x") == 2
    assert "exists and is not" in capsys.readouterr().err
    assert other.read_text() == "notes of mine"


def test_quiet_runs_say_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert called("view --output", written(tmp_path, TORSION), tmp_path / "new" / "x", "--quiet") == 0
    assert capsys.readouterr().err == ""


def test_all_options_that_write_are_of_this_kind() -> None:
    """Every path that need not exist is written to, but the folder into which examples are copied."""
    group = LazyGroup()
    missing = [
        (name, option.name)
        for name in COMMANDS
        for option in group.get_command(click.Context(group), name).params  # type: ignore[union-attr]
        if isinstance(option, click.Option) and isinstance(option.type, click.Path) and not option.type.exists
        if option.callback is not report_folders
    ]
    assert missing == []
