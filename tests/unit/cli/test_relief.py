# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint relief`: tables, JSON, files, and what it refuses."""

from __future__ import annotations

from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.reading import open_result
from pitchpoint.io.yaml_model import load_model
from pitchpoint.solvers.contact_analysis.relief import design
from tests.support.cli_files import json_of, written
from tests.support.relief_models import TIP

MODEL = """
title: Spur pair  # a remark
gears:
  pinion: {number_of_teeth: 25, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  wheel:
    number_of_teeth: 31
    normal_module: 3 mm
    face_width: 20 mm
    profile_shift_coefficient: 0
    modifications: {both: {tip_relief: {amount: 4 um, length: 5.635 mm}}}
meshes:
  stage: {gears: [pinion, wheel], contact: {level: rigid, stiffness: 300 N/um, planes: 1}}  # constant
"""
AMOUNTS = [f"{TIP.format(gear, 'amount')}=0:40um" for gear in ("pinion", "wheel")]
LENGTH = f"{TIP.format('pinion', 'length')}=5:6.5 mm"
SHORT = ["-t", "80:200:2", "--analyses", "120", "--positions", "8"]


def vary(*texts: str) -> list[str]:
    return [part for text in texts for part in ("--vary", text)]


@pytest.fixture
def file(tmp_path: Path) -> str:
    return written(tmp_path, MODEL)


def test_people_get_modifications_and_errors(file: str, capsys: pytest.CaptureFixture[str]) -> None:
    tolerance = f"{TIP.format('wheel', 'amount')}=±1.5 um"
    options = [*SHORT, *vary(*AMOUNTS, LENGTH), "--tolerance", tolerance]
    assert run_command(["relief", file, *options]) == 0
    text = capsys.readouterr().out
    for words in ("Spur pair: relief of stage", "wheel.modifications.both.tip_relief.amount", "±1.5 µm"):
        assert words in text
    rows = {line.split()[0]: line for line in text.splitlines() if line.strip()}
    assert "4 µm" in rows["wheel.modifications.both.tip_relief.amount"]
    assert " – " in rows["pinion.modifications.both.tip_relief.amount"]
    assert [line.split()[0] for line in text.splitlines() if " N m " in line] == ["80", "200"]
    assert "rounded, worst" in text
    assert "objective" in text
    assert "analyses" in text


def test_json(file: str, capsys: pytest.CaptureFixture[str]) -> None:
    data = json_of(["relief", file, *SHORT, *vary(*AMOUNTS, LENGTH)], capsys)
    assert data["status"] == "finished"
    assert data["mesh"] == "stage"
    assert data["torque"] == [80.0, 200.0]
    assert data["analyses"] <= 120
    one, two, three = data["variables"]
    assert one["path"] == TIP.format("pinion", "amount")
    assert (one["low"], one["high"], one["start"]) == (0.0, 40e-6, None)
    assert two["start"] == 4e-6
    assert (three["low"], three["high"]) == (5e-3, 6.5e-3)
    for name in ("start", "optimum", "rounded"):
        worst = max(data["peak_to_peak"][name])
        assert data["objective"][name] == pytest.approx(worst, rel=1e-12)
        assert len(data["map"]["peak_to_peak"][name]) == len(data["map"]["torque"])
    assert data["objective"]["optimum"] <= data["objective"]["start"]


def test_files(file: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    names = {"--write": "new.yaml", "--picture": "map.html", "-o": "result.h5"}
    files = [part for flag, name in names.items() for part in (flag, str(tmp_path / name))]
    data = json_of(["relief", file, *SHORT, *vary(*AMOUNTS, LENGTH), *files], capsys)
    text = (tmp_path / "new.yaml").read_text()
    assert "# a remark" in text
    assert "# constant" in text
    model = load_model(tmp_path / "new.yaml")
    for variable in data["variables"]:
        _, gear, *_, key = variable["path"].split(".")
        relief = model.gears[gear].modifications.both.tip_relief
        assert getattr(relief, key) == pytest.approx(variable["rounded"], rel=1e-12)
    assert "<html" in (tmp_path / "map.html").read_text()[:200]
    with open_result(tmp_path / "result.h5") as result:
        assert result.attrs["kind"] == "relief"
        found = result["objective"].sel(design="rounded")
        assert float(found) == pytest.approx(data["objective"]["rounded"], rel=1e-12)
    # its own model may be replaced, that of the user not
    again = ["relief", file, *SHORT, *vary(*AMOUNTS, LENGTH), "--write"]
    assert run_command([*again, str(tmp_path / "new.yaml"), "-q"]) == 0
    assert run_command([*again, file]) == 2


def test_interrupted(file: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """The best so far is shown and written; exit code of Ctrl-C."""
    begin = design.Search._count

    def stop(self):
        begin(self)
        if self.count > 40:
            raise KeyboardInterrupt

    monkeypatch.setattr(design.Search, "_count", stop)
    assert run_command(["relief", file, *SHORT, *vary(*AMOUNTS, LENGTH)]) == 130
    text = capsys.readouterr()
    assert "tip_relief.amount" in text.out
    assert "interrupted" in text.err


def test_a_limit_that_is_not_met_is_named(file: str, capsys: pytest.CaptureFixture[str]) -> None:
    options = [*SHORT, *vary(*AMOUNTS, LENGTH), "--max-pressure", "100 MPa"]
    assert run_command(["relief", file, *options]) == 0
    assert "a limit is exceeded by" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (vary("gears.pinion=0:1um"), "is not a modification of a gear of mesh stage"),
        (vary(TIP.format("pinion", "amount")), "is not of the form PATH=LOW:HIGH"),
        (vary(f"{TIP.format('pinion', 'amount')}=0:10"), "10 has no unit"),
        (vary(f"{TIP.format('pinion', 'amount')}=5um:1um"), "not below the upper"),
        (vary(AMOUNTS[0], AMOUNTS[0]), "is varied twice"),
        (vary(f"{TIP.format('pinion', 'amount')}=0:40kg"), "'kg' is not the unit of a length"),
        (vary(f"{TIP.format('wheel', 'length')}=1:90mm"), "longer than the flank"),
        (vary(AMOUNTS[0]), "start_diameter"),
        ([*vary(AMOUNTS[0]), "--tolerance", TIP.format("pinion", "amount")], "PATH=LENGTH"),
        ([*vary(AMOUNTS[0]), "--weights", "1,x"], "numbers such as"),
        ([*vary(AMOUNTS[0]), "--weights", "1"], "one weight for each torque"),
        ([*vary(AMOUNTS[0]), "--misalignment", "20"], "has no unit"),
        ([*vary(AMOUNTS[0]), "--mesh", "other"], "no mesh 'other'"),
        (
            [
                *vary(*AMOUNTS, LENGTH),
                "--tolerance",
                f"{TIP.format('wheel', 'amount')}=2um",
                "--analyses",
                "59",
            ],
            "59 analyses are too few for 3 deviations within the tolerances; give at least 60",
        ),
    ],
)
def test_refused(file: str, options: list[str], words: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["relief", file, *SHORT, *options]) == 2
    assert words in capsys.readouterr().err


def test_variables_are_required(file: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["relief", file, *SHORT]) == 2
    assert "--vary" in capsys.readouterr().err
