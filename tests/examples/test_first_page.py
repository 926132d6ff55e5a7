# SPDX-License-Identifier: Apache-2.0
"""The first page: its model file, its commands, its Python and its numbers are tried as they stand there."""

from __future__ import annotations

import json
import re
import shlex
from pathlib import Path

import pytest

from pitchpoint.cli.main import COMMANDS, run_command
from pitchpoint.geometry import GearPair
from pitchpoint.io.yaml_model import load_model

ROOT = Path(__file__).parents[2]
TEXT = (ROOT / "README.md").read_text(encoding="utf-8")


def block(language: str) -> str:
    """Contents of the first code block in a language."""
    found = re.search(rf"^```{language}\n(.*?)^```", TEXT, re.DOTALL | re.MULTILINE)
    assert found
    return found[1]


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the commands of the page run, and leave the files that its Python reads."""
    found = tmp_path_factory.mktemp("first")
    (found / "pair.yaml").write_text(block("yaml"), encoding="utf-8")
    return found


@pytest.fixture
def folder(place: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(place)
    return place


def test_commands_run_and_numbers_are_right(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Numbers of runs are those that the same command prints for other programs."""
    lines = re.findall(r"^pitchpoint (\w+ pair\.yaml.*)$", TEXT, re.MULTILINE)
    assert [line.split()[0] for line in lines] == [
        "check",
        "gears",
        "mesh",
        "modes",
        "campbell",
        "run",
        "sweep",
        "report",
        "view",
        "clearance",
        "gears",
    ]
    numbers = {}
    for line in lines:
        words = shlex.split(line, comments=True)
        told = words[0] in ("modes", "run", "sweep")
        assert run_command([*words, *["--json"] * told]) == 0, line
        said = capsys.readouterr().out
        if told:
            numbers[words[0]] = json.loads(said)
    assert (folder / "pair.html").stat().st_size > 1e5
    assert "2728 Hz" in TEXT
    assert numbers["modes"]["modes"][1]["frequency"] == pytest.approx(2728.0, abs=0.5)
    deflection = numbers["run"]["channels"]["deflection[stage]"]
    assert "The mean deflection is 51 µm: 38.5 µm" in " ".join(TEXT.split())
    assert deflection["mean"] == pytest.approx(51e-6, abs=0.5e-6)
    sweep = numbers["sweep"]
    assert "jumps at 2225 Hz upwards, at 1525 Hz downwards" in " ".join(TEXT.split())
    jumps = [(j["direction"], j["mesh_frequency"]) for j in sweep["jumps"]]
    assert jumps == [("up", pytest.approx(2225.0)), ("down", pytest.approx(1525.0))]
    assert max(p["contact_loss_share"] for p in sweep["points"]) == pytest.approx(2 / 3, abs=0.02)


def test_geometry_is_right(folder: Path) -> None:
    pair: GearPair = load_model("pair.yaml").pairs["stage"]
    assert "contact ratio 1.568, backlash 77.0 µm" in TEXT
    assert pair.eps_alpha == pytest.approx(1.568, abs=5e-4)
    assert pair.j_bt == pytest.approx(77.0e-6, abs=5e-8)
    assert run_command(shlex.split("gears pair.yaml --export pinion.dxf --gear pinion")) == 0
    assert (folder / "pinion.dxf").exists()


def test_python_runs(folder: Path) -> None:
    if not (folder / "steady.h5").exists():
        assert run_command(shlex.split("run pair.yaml -s steady -o steady.h5 -q")) == 0
    code = compile(block("python"), "README.md", "exec")
    names: dict = {}
    exec(code, names)
    assert names["pp"].open_result("steady.h5").sizes["time"] > 1000


def test_links_and_commands_exist() -> None:
    # those between pages of docs are verified by tests/contracts/test_docs.py
    for page in (ROOT / "README.md", ROOT / "CONTRIBUTING.md"):
        for link in re.findall(r"\]\(([^)#:]+)\)", page.read_text(encoding="utf-8")):
            assert (page.parent / link).exists(), f"{page.name}: {link}"
    for command in re.findall(r"^pitchpoint (\w+) pair|`pitchpoint (\w+)", TEXT, re.MULTILINE):
        assert set(command) - {""} <= set(COMMANDS)
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    for target in re.findall(r"^make (\w+)|`make (\w+)", TEXT, re.MULTILINE):
        assert re.search(rf"^{''.join(target)}:", makefile, re.MULTILINE), target
