# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint examples`: list and copy, from the source tree and from an installed package."""

from __future__ import annotations

import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from pitchpoint.cli import examples
from pitchpoint.cli.main import run_command
from pitchpoint.io.yaml_model import load_model
from tests.support.cli_files import json_of


@pytest.fixture
def shelf(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Make a folder with one example and things that are none."""
    folder = tmp_path / "shelf"
    example = folder / "backlash"
    (example / "build").mkdir(parents=True)
    (example / "README.md").write_text("# A pair with backlash\n\ntext\n", encoding="utf-8")
    (example / "model.yaml").write_text("title: x\n", encoding="utf-8")
    (example / "build" / "old.h5").write_text("", encoding="utf-8")
    (example / "run.h5").write_text("", encoding="utf-8")
    (folder / "half").mkdir()
    monkeypatch.setattr(examples, "examples_folder", lambda: folder)
    return folder


def test_list(shelf: Path, capsys: pytest.CaptureFixture[str]) -> None:
    found = json_of(["examples", "list"], capsys)["examples"]
    assert found == [{"name": "backlash", "title": "A pair with backlash", "files": ["model.yaml"]}]
    assert run_command(["examples", "list"]) == 0
    assert "A pair with backlash" in capsys.readouterr().out


def test_copy(shelf: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "mine"
    assert run_command(["examples", "copy", "backlash", str(target)]) == 0
    assert sorted(path.name for path in target.iterdir()) == ["README.md", "model.yaml"]
    assert f"pitchpoint check {target / 'model.yaml'}" in capsys.readouterr().out
    assert run_command(["examples", "copy", "backlash", str(target)]) == 2
    assert "--force" in capsys.readouterr().err
    assert run_command(["examples", "copy", "backlash", str(target), "--force"]) == 0


def test_nearest_spelling(shelf: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["examples", "copy", "backlsh"]) == 2
    assert "did you mean backlash?" in capsys.readouterr().err


def test_the_source_tree_has_a_folder_of_examples() -> None:
    assert examples.examples_folder().name == "examples"


def test_a_wheel_brings_the_examples_and_everything_else_that_is_no_code(tmp_path: Path) -> None:
    root = examples.examples_folder().parent
    command = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(tmp_path)]
    subprocess.run(command, cwd=root, check=True, capture_output=True)
    (wheel,) = tmp_path.glob("*.whl")
    names = set(zipfile.ZipFile(wheel).namelist())
    pages = [
        f"viz/assets/{name}" for name in ("report.css", "report.js", "inflate.js", "plots.js", "viewer.js")
    ]
    for name in ("py.typed", "core/nomenclature.csv", *pages):
        assert f"pitchpoint/{name}" in names
    for name in examples.example_names():
        assert f"pitchpoint/examples/{name}/README.md" in names
    assert not [n for n in names if n.endswith((".h5", ".html", ".pyc"))]


def test_examples_with_files_of_others(tmp_path, capsys):
    """The wind turbine includes the gearbox of `wind-drive-5mw`: both are copied, or none."""
    assert run_command(["examples", "copy", "wind-turbine", str(tmp_path / "mine")]) == 0
    said = capsys.readouterr().out
    assert "model.yaml" in said and "gearbox.yaml" not in said
    assert (tmp_path / "wind-drive-5mw" / "gears.yaml").is_file()
    model = load_model(tmp_path / "mine" / "model.yaml", changes={"include": "gearbox.yaml"})
    assert model.gears["ring_1"].number_of_teeth == 56
    assert run_command(["examples", "copy", "wind-turbine", str(tmp_path / "other")]) == 2
    assert "wind-drive-5mw is not empty" in capsys.readouterr().err
    assert not (tmp_path / "other").exists()


def test_copy_to_the_present_folder(tmp_path, monkeypatch):
    """Its folder is that above: ../wind-drive-5mw."""
    folder = tmp_path / "here"
    folder.mkdir()
    monkeypatch.chdir(folder)
    assert run_command(["examples", "copy", "wind-turbine", "."]) == 0
    assert (folder / "gearbox.yaml").is_file() and not (folder / "wind-drive-5mw").exists()
    assert (tmp_path / "wind-drive-5mw" / "gears.yaml").is_file()


def test_included_files_that_include_others(shelf: Path, tmp_path: Path) -> None:
    """As a list over several lines, and in a file of another example."""
    for name, text in {
        "backlash": "title: x\ninclude:\n  - ../second/parts.yaml\n",
        "second": "include: ../third/parts.yaml\n",
        "third": "title: z\n",
    }.items():
        (shelf / name).mkdir(exist_ok=True)
        (shelf / name / ("model.yaml" if name == "backlash" else "parts.yaml")).write_text(text)
    assert run_command(["examples", "copy", "backlash", str(tmp_path / "mine")]) == 0
    assert (tmp_path / "second" / "parts.yaml").is_file() and (tmp_path / "third" / "parts.yaml").is_file()
