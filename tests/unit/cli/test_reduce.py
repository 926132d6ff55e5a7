# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint reduce`, and `pitchpoint run --reduce`."""

from __future__ import annotations

from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.reading import open_result
from tests.support.cli_files import json_of, written
from tests.support.gearbox_files import GEARBOX, TAILS


def test_what_is_left_and_its_error(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, GEARBOX)
    found = json_of(["reduce", file, "--limit", "2 kHz", "-s", "run"], capsys)
    assert found["kept"] == ["driver", "driven"]
    assert found["coordinates"] == [19, 19]
    assert found["frequency_error"] < 1e-9
    assert len(found["full"]) == len(found["reduced"]) == 18
    kept = json_of(["reduce", file, "--limit", "2 kHz", "-s", "run", "--keep", "housing"], capsys)
    assert kept["kept"] == ["driver", "driven", "housing"]


def test_people_get_a_table(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["reduce", written(tmp_path, GEARBOX), "--limit", "100 Hz"]) == 0
    out = capsys.readouterr().out
    assert "of 19 coordinates: natural frequencies up to 100 Hz differ by up to" in out
    assert "retained bodies: driver, driven" in out


def test_a_run_with_the_reduced_system(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The mesh force of both runs agrees (1e-6 of its mean, the condensed parts are linear here), and the
    error of the reduction stands among the notes."""
    file = written(tmp_path, GEARBOX)
    found = []
    for more in ([], ["--reduce", "2 kHz"]):
        target = str(tmp_path / f"{len(more)}.h5")
        summary = json_of(["run", file, "-o", target, *more], capsys)
        with open_result(target) as data:
            found.append((summary, data["mesh_force[stage]"].values))
    (full, force), (less, again) = found
    assert again == pytest.approx(force, rel=1e-6)
    assert any("of 19 coordinates" in note for note in less["notes"])
    assert "displacement[housing.x]" in full["channels"]
    assert "displacement[housing.x]" not in less["channels"]
    lost = "".join(note for note in less["notes"] if note.startswith("not recorded"))
    gone = {name.partition("[")[0] for name in full["channels"]} - {
        name.partition("[")[0] for name in less["channels"]
    }
    assert gone
    assert all(f"{quantity} of " in lost for quantity in gone)


def test_condensed_parts_stay_out_of_the_table_of_a_run(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Their channels are in the file; elements of the model stay in the table, whatever they are called."""
    file, target = written(tmp_path, GEARBOX), str(tmp_path / "r.h5")
    assert run_command(["run", file, "-o", target, "--reduce", "20 kHz"]) == 0
    out = capsys.readouterr().out
    assert "mesh_force[stage]" in out
    assert "[condensed" not in out
    assert "[part1" not in out
    with open_result(target) as data:
        assert any("[part1.mode1" in name for name in data.data_vars)
        assert any("[condensed1" in name for name in data.data_vars)


def test_small_negative_frequencies_are_printed_as_zero(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A free body on one spring: forces left over at rest hold it, or not, at some mHz."""
    file = written(tmp_path, TAILS)
    rough = json_of(["modes", file, "-s", "run"], capsys)["modes"]
    assert 0.0 < max(abs(mode["frequency"]) for mode in rough[:6]) < 1e-2
    for command in (["reduce", file, "--limit", "500 Hz", "-s", "run"], ["modes", file, "-s", "run"]):
        assert run_command(command) == 0
        out = capsys.readouterr().out
        assert "71.1763 Hz" in out
        assert " -0" not in out


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["reduce", "FILE"], "--limit is required"),
        (["reduce", "FILE", "--limit", "3 mm"], "--limit"),
        (["reduce", "FILE", "--limit", "1 kHz", "--keep", "lid"], "no body or element lid"),
        (["reduce", "FILE", "--limit", "1 kHz", "--keep", "hausing"], "did you mean housing? there are: "),
        (["run", "FILE", "--reduce", "1 kHz", "--vary", "meshes.stage.damping.ratio=0.1"], "--reduce"),
    ],
)
def test_wrong_input(
    arguments: list[str], words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = written(tmp_path, GEARBOX)
    assert run_command([file if a == "FILE" else a for a in arguments]) == 2
    out = capsys.readouterr()
    assert words in out.err + out.out
    assert "Traceback" not in out.err
