# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint diagnose --reference`: one record and a folder compared with healthy ones of a rig."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import numpy as np
import pytest
from scipy.io import savemat

from pitchpoint.analysis.sampled import SignalError
from pitchpoint.cli.main import run_command
from pitchpoint.io.target import written_by_diagnose
from pitchpoint.report.diagnosis.record_files import record_file, record_files
from tests.support.cli_files import json_of

RATE = 6400.0
MACHINE = ["--train", "32/95", "--speed", "10Hz"]


def record(path: Path, load: float, seed: int, fault: float = 0.0, name: str = "acc") -> str:
    """4.2 s of a pair 32/95 whose mesh grows by 6 dB with the load, with a damaged tooth of Z1."""
    rng = np.random.default_rng(seed)
    turned = (10.0 + rng.uniform(-0.02, 0.02)) * np.arange(int(4.2 * RATE)) / RATE
    size = 10.0 ** ((6.0 * load / 100.0 + rng.normal(0.0, 0.2)) / 20.0)
    mesh = size * (np.cos(2 * np.pi * 32 * turned) + 0.4 * np.cos(2 * np.pi * 64 * turned))
    since = (turned + 0.3) % 1
    knock = np.exp(-(((since - 0.5) / 0.01) ** 2)) * np.cos(2 * np.pi * 140 * since)
    savemat(path, {name: mesh + 0.2 * rng.standard_normal(turned.size) + fault * knock, "fs": RATE})
    return str(path)


@pytest.fixture(scope="module")
def rig(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Five healthy records at loads of 20 to 100 %, and a history: a tooth breaks after the third record."""
    folder = tmp_path_factory.mktemp("rig")
    (folder / "healthy").mkdir()
    (folder / "history").mkdir()
    for k, load in enumerate((20, 40, 60, 80, 100)):
        record(folder / "healthy" / f"h_{load}pc.mat", load, k)
    rows = ["file,load,speed,time"]
    for k, (load, fault) in enumerate([(30, 0.0), (90, 0.0), (50, 0.0), (70, 2.0), (40, 2.5), (80, 3.0)]):
        record(folder / "history" / f"run{9 - k}.mat", load, 20 + k, fault)
        rows.append(f"run{9 - k}.mat,{load} %,10 Hz,2026-03-{k + 10}")
    (folder / "history" / "records.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
    return folder


def test_a_damaged_tooth_is_named_by_its_residual_at_a_load_between_the_healthy_ones(
    rig: Path, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    arguments = [*MACHINE, "--reference", str(rig / "healthy"), "--load-from", "_{load}pc"]
    page = tmp_path / "change.html"
    file = str(rig / "history" / "run6.mat")
    found = json_of(["diagnose", file, *arguments, "--load", "70%", "-o", str(page)], capsys)["change"]
    assert found["differs"] and found["interpolated_over"] == ["load"]
    assert found["named"] == ["Z1"]
    first = json_of(["diagnose", file, *arguments, "--load", "70%", "-c", "acc"], capsys)["sentences"][0]
    by_itself = "by itself nothing found: "
    assert (by_itself in first and first.startswith("differs from 5 healthy records (distance ")) or (
        "a local fault on gear Z1" in first
    )
    assert found["probability"] == pytest.approx(1 / 6)
    assert len(found["healthy"]) == 5 and found["distance"] > found["limit"]
    assert max(one["distance"] for one in found["healthy"]) == found["limit"]
    text = page.read_text(encoding="utf-8")
    assert "Differs from 5 healthy records, interpolated over load" in text
    assert "Named: Z1, whose residual rises more than that of the other gears" in text
    # the load of 30 % comes from the table of the folder
    assert run_command(["diagnose", str(rig / "history" / "run9.mat"), *arguments]) == 0
    said = capsys.readouterr().out
    # the first sentence contains the result of the comparison
    assert said.startswith("within the range of 5 healthy records (distance ")
    assert "); by itself nothing found: " in said.splitlines()[0]
    assert "within the range of 5 healthy records, interpolated over load" in said
    assert "Largest deviations from healthy records" in said


def test_without_loads_their_effect_is_part_of_the_spread(
    rig: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = record(rig / "light.mat", 0.0, 77)
    arguments = ["diagnose", file, *MACHINE, "--reference", str(rig / "healthy")]
    plain = json_of(arguments, capsys)["change"]
    assert plain["interpolated_over"] == []
    known = json_of([*arguments, "--load", "0", "--load-from", "_{load}pc"], capsys)["change"]
    mesh = {one["feature"]: one for one in known["features"]}["harmonic 1 of mesh 1"]
    assert abs(mesh["deviation"]) < 1.0 and mesh["spread"] < 1.0
    mesh = {one["feature"]: one for one in plain["features"]}["harmonic 1 of mesh 1"]
    assert mesh["deviation"] < -2.5 and mesh["spread"] > 1.0
    assert any("outside the healthy records, 20 to 100: extrapolated" in note for note in known["notes"])


def test_one_healthy_record_gives_differences_without_a_rate(
    rig: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    # channels that are named after the number of the record
    file, sound = (
        record(rig / "X105.mat", 60, 5, 2.0, "X105_DE"),
        record(rig / "X097.mat", 60, 6, 0.0, "X097_DE"),
    )
    found = json_of(["diagnose", file, *MACHINE, "--reference", sound], capsys)["change"]
    assert found["limit"] is None and found["distance"] is None and not found["differs"]
    assert "without a limit, and without a rate of false alarms" in found["sentences"][1]
    assert found["notes"] == ["channels are named after the records: X105_DE is compared with X097_DE"]
    residual = {one["feature"]: one["deviation"] for one in found["features"]}
    assert residual["residual of Z1"] > 3.0


def test_the_trend_of_a_folder_leaves_the_healthy_range_at_the_fourth_record(
    rig: Path, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    # the table gives the order, the loads and the speed
    train = MACHINE[:2]
    page = tmp_path / "trend.html"
    history = str(rig / "history")
    arguments = ["diagnose", history, *train, "--speed", "10Hz", "--load-from", "_{load}pc"]
    healthy = ["--reference", str(rig / "healthy" / "*.mat"), "--reference", f"{history}/run9.mat"]
    found = json_of([*arguments, *healthy, "-o", str(page)], capsys)
    assert [Path(one["file"]).name for one in found["records"]] == [f"run{k}.mat" for k in range(9, 3, -1)]
    assert Path(found["left_at"]).name == "run6.mat" and found["rate"] == pytest.approx(1 / 7)
    assert [one["differs"] for one in found["records"][1:]] == [False, False, True, True, True]
    assert "record 4 of 6" in found["sentences"][0]
    assert "Trend of history" in page.read_text(encoding="utf-8")
    for ending in ("csv", "json"):
        assert run_command([*arguments, *healthy, "-o", str(tmp_path / f"trend.{ending}")]) == 0
    said = capsys.readouterr().out
    assert "above the limit" in said and "healthy" in said and "table written to" in said
    with (tmp_path / "trend.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["file"] for row in rows] == [f"run{k}.mat" for k in range(9, 3, -1)]
    assert [row["state"] for row in rows] == ["healthy", *["compared"] * 5]
    assert [row["above the limit"] for row in rows] == ["", "no", "no", "yes", "yes", "yes"]
    assert [row["load"] for row in rows] == ["30", "90", "50", "70", "40", "80"]
    for row, one in zip(rows, found["records"], strict=True):
        assert float(row["distance"]) == pytest.approx(one["distance"], rel=1e-3)
        assert float(row["speed [rpm]"]) == pytest.approx(600.0, rel=0.01)
    text = (tmp_path / "trend.json").read_text(encoding="utf-8")
    assert {key: value for key, value in json.loads(text).items() if key != "about"} == found
    # a table may be replaced, and in the folder it is not a record
    assert all(written_by_diagnose(tmp_path / f"trend.{ending}") for ending in ("csv", "json"))
    with pytest.raises(SignalError, match="has no records"):
        record_files([str(tmp_path)], None, "FILES")


def test_what_cannot_be_compared_is_refused(
    rig: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, healthy = str(rig / "history" / "run9.mat"), str(rig / "healthy")

    def told(*arguments: str) -> str:
        """Message of a refused command."""
        assert run_command(["diagnose", *arguments, *MACHINE]) == 2
        return capsys.readouterr().err

    (tmp_path / "empty").mkdir()
    assert "has no records" in told(file, "--reference", str(tmp_path / "empty"))
    assert "compared with itself" in told(file, "--reference", file)
    assert "is a folder" in told(healthy, file, "--reference", healthy)
    assert "'pc{load}' matches none of the 6 file names, such as run9.mat" in told(
        file, "--reference", healthy, "--load-from", "pc{load}"
    )
    assert "--load: is the load of one record" in told(
        str(rig / "history"), "--reference", healthy, "--load", "40%"
    )
    assert "must contain {load}" in told(file, "--reference", healthy, "--load-from", "pc")
    assert "is not a number" in told(file, "--reference", healthy, "--load", "half")
    assert "different units" in told(
        file, "--reference", str(rig / "history"), "--reference", healthy, "--load", "30 N m"
    )
    other = record(tmp_path / "other.mat", 20, 1, 0.0, "velocity")
    assert "no channel in common" in told(file, "--reference", other)
    assert "no trend" in told(str(rig / "history"), "--reference", f"{healthy}/h_20pc.mat")
    (tmp_path / "broken.mat").write_bytes(b"nothing")
    (tmp_path / "torn.mat").write_bytes(b"nothing")
    said = told(file, "--reference", str(tmp_path))
    assert "broken.mat" in said and "torn.mat" in said


def test_tables_and_names_of_folders(tmp_path: Path) -> None:
    for name in ("r10.csv", "r2.csv", "r1.csv.gz", "notes.md", ".hidden.csv"):
        (tmp_path / name).touch()
    assert [f.name for f in record_files([str(tmp_path)], None, "--reference")] == [
        "r1.csv.gz",
        "r2.csv",
        "r10.csv",
    ]
    table = tmp_path / "records.csv"
    table.write_text("file, load, time\nr10.csv, 1.5 kN, 3\nr2.csv, -2 kN, 12\n", encoding="utf-8")
    found = record_files([str(tmp_path)], None, "--reference")
    assert [(f.name, f.load, f.unit) for f in found] == [("r10.csv", 1.5, "kN"), ("r2.csv", -2.0, "kN")]
    assert record_file(str(tmp_path / "r10.csv"), "r{load}.").load == 10.0
    for text, message in (
        ("file,lod\nr2.csv,1\n", "did you mean"),
        ("load\n1\n", "has no column 'file'"),
        ("file\nr3.csv\n", "r3.csv is not in the folder"),
    ):
        table.write_text(text, encoding="utf-8")
        with pytest.raises(SignalError, match=message):
            record_files([str(tmp_path)], None, "--reference")


def test_an_interrupted_trend_has_the_records_so_far(
    rig: Path, capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The five healthy records and three of the history are read; the command ends with exit code 130."""
    from pitchpoint.report.diagnosis import described_record

    own, read = described_record.prepare, []

    def stops(request: object) -> object:
        """Interrupted at the ninth record."""
        read.append(request)
        if len(read) == 9:
            raise KeyboardInterrupt
        return own(request)

    monkeypatch.setattr(described_record, "prepare", stops)
    page = tmp_path / "trend.html"
    arguments = [*MACHINE, "--reference", str(rig / "healthy"), "--load-from", "_{load}pc", "-o", str(page)]
    assert run_command(["diagnose", str(rig / "history"), *arguments]) == 130
    assert "interrupted by the user: 3 of 6 records are not compared" in capsys.readouterr().out
    text = page.read_text(encoding="utf-8")
    assert "run7.mat" in text and "run6.mat" not in text
