# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint diagnose --speed LOW..HIGH`: run-ups without a tacho."""

from __future__ import annotations

import csv
import re
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.analysis.sampled import SignalError
from pitchpoint.cli.main import run_command
from pitchpoint.report.diagnosis.request import Request, diagnose_file
from pitchpoint.report.diagnosis.speeds import given_speed
from tests.support.cli_files import json_of
from tests.support.motor_run_ups import ORDERS, RATE, motor_record
from tests.unit.cli.test_diagnose_files import csv_of, gears_found, only, rig, told

NAMES = {"BPFO": "outer ring", "BPFI": "inner ring", "FTF": "cage"}
RUN_UP = ["--train", "32/95", "-c", "acc"]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A run-up with a damaged tooth and a healthy one."""
    made = tmp_path_factory.mktemp("run_ups")
    csv_of(made, rig(run_up=True), "damaged.csv")
    csv_of(made, rig(run_up=True, fault=0.0), "healthy.csv")
    return made


def test_a_run_up_has_the_verdict_of_its_tacho(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = str(folder / "damaged.csv")
    of_tacho = gears_found([file, *RUN_UP, "--tacho", "tacho", "--pulses", "4"], capsys)
    assert gears_found([file, *RUN_UP, "--speed", "500..1100rpm"], capsys) == of_tacho
    assert of_tacho == [("local fault", ["Z1"])]
    assert gears_found([str(folder / "healthy.csv"), *RUN_UP, "--speed", "500..1100rpm"], capsys) == []


def test_the_result_states_how_the_speed_was_found(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    found = json_of(["diagnose", str(folder / "damaged.csv"), *RUN_UP, "--speed", "8..18Hz"], capsys)
    (row,) = [row for row in found["origin"] if row[0] == "speed"]
    assert row[2] == "--speed 8..18Hz, found in the record"
    low, high = (float(word) for word in row[1].removeprefix("shaft 1: ").removesuffix(" rpm").split(" to "))
    assert 590 < low < 620
    assert 940 < high < 970
    said = " ".join(found["remarks"])
    assert "speed of shaft 1 found in the record" in said
    assert "of the best other path" in said
    assert "by the phases of the lines at orders 32, 64; agreement of the lines 0.0" in said


def test_unconfirmed_tooth_numbers_are_part_of_the_verdict(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The mesh lines have no sidebands; a second stage that is not there has no line."""
    file = [str(folder / "damaged.csv"), "-c", "acc", "--speed", "500..1100rpm"]
    (alone,) = json_of(["diagnose", *file, "--train", "32/95"], capsys)["findings"]
    assert alone["gears"] == ["Z1"]
    assert (
        "the tooth numbers, on which the speed depends, are not confirmed by sidebands" in alone["sentence"]
    )
    (more,) = json_of(["diagnose", *file, "--train", "32/95-20/41"], capsys)["findings"]
    assert more["shaft"] == "shaft 1" and more["gears"] == []
    assert more["sentence"].endswith("are not confirmed by mesh 2; no gear is named")


def test_a_range_of_another_shaft(folder: Path) -> None:
    """Shaft 2 rotates at 32/95 of the speed of shaft 1."""
    found = diagnose_file(
        Request(str(folder / "damaged.csv"), train="32/95", channels=("acc",), speeds=("2=170..370rpm",))
    )
    assert [finding.gears for finding in found.diagnosis.findings] == [("Z1",)]


def test_a_nominal_speed_of_a_run_up_names_the_option(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    said = told([str(folder / "damaged.csv"), *RUN_UP, "--speed", "780rpm"], capsys)
    assert "give the range, --speed 5" in said


def test_a_folder_of_run_ups(folder: Path, tmp_path: Path) -> None:
    table = tmp_path / "table.csv"
    assert (
        run_command(["diagnose", str(folder), *RUN_UP, "--speed", "500..1100rpm", "-o", str(table), "-q"])
        == 0
    )
    with table.open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [row["verdict"] for row in rows] == ["local fault on Z1", "nothing found"]


def test_the_page_shows_the_speed_over_the_spectrogram(folder: Path, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    arguments = [str(folder / "damaged.csv"), *RUN_UP, "--speed", "500..1100rpm", "-o", str(page), "-q"]
    assert run_command(["diagnose", *arguments]) == 0
    assert "Speed found in the record" in page.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("speeds", "words"),
    [
        (["1100..500rpm"], "the lower speed first"),
        (["500..rpm"], "'rpm' does not begin with a number"),
        (["..500rpm"], "write it as in 600..1800rpm"),
        (["500..1100rpm±2%"], "write it as in 600..1800rpm"),
        (["500..1100rpm", "2=200rpm"], "limit: a range alone"),
        (["1000..3000rpm"], "check the"),
        (["3=500..1100rpm"], "no shaft '3'"),
    ],
)
def test_bad_ranges(folder: Path, speeds: list[str], words: str, capsys: pytest.CaptureFixture[str]) -> None:
    options = [text for speed in speeds for text in ("--speed", speed)]
    assert words in told([str(folder / "damaged.csv"), *RUN_UP, *options], capsys)


def test_noise_has_no_speed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table = only(rig(run_up=True), "acc")
    table["acc"] = np.random.default_rng(1).standard_normal(table["time"].size)
    said = told([csv_of(tmp_path, table), *RUN_UP, "--speed", "500..1100rpm"], capsys)
    assert "no mesh lines and shaft orders determine it" in said


def test_bearings_of_a_motor_in_a_run_up(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Shaft orders 1 to 4 and impacts; the range begins below half the speed."""
    x, turns = motor_record("up", "inner ring", seed=3)
    file = csv_of(tmp_path, {"time": np.arange(x.size) / RATE, "acc": x})
    rates = "DE:" + ",".join(f"{name}={ORDERS[part]}" for name, part in NAMES.items())
    found = json_of(["diagnose", file, "--bearing", rates, "--speed", "240..2400rpm"], capsys)
    assert [one["shaft"] for one in found["findings"]] == ["inner ring"]
    said = " ".join(found["remarks"])
    assert "by the shaft orders 1, 2, 3, 4 and impacts of inner ring of DE" in said
    (row,) = [row for row in found["origin"] if row[0] == "speed"]
    assert row[1].split(":")[1].split("±")[0].strip() in said  # one range in all places


def test_a_steady_speed_of_a_motor_that_varies_names_the_option(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    x, _ = motor_record("up", seed=3)
    file = csv_of(tmp_path, {"time": np.arange(x.size) / RATE, "acc": x})
    found = json_of(["diagnose", file, "--bearing", "DE:6205", "--speed", "1200rpm"], capsys)
    assert "give the range, --speed" in " ".join(found["remarks"])


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("1797rpm±2", "tolerance 2 has no unit; write ±2% or ±2rpm"),
        ("600..3000", "has no unit; write it as in 600..3000rpm"),
        ("600rpm..3000", "has no unit; write it as in 600rpm..3000rpm"),
    ],
)
def test_numbers_without_a_unit_are_refused(text: str, words: str) -> None:
    with pytest.raises(SignalError, match=re.escape(words)):
        given_speed(text)


def test_a_sample_rate_without_its_prefix(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "noise.csv"
    np.savetxt(path, np.random.default_rng(1).standard_normal(20_000), header="acc", comments="")
    options = ["--bearing", "a:6205", "--speed", "1797rpm", "--sample-rate", "12"]
    said = told([str(path), *options], capsys)
    assert "0.4 samples per turn" in said and "--sample-rate 12kHz" in said


def test_a_unit_of_the_upper_limit_is_that_of_both() -> None:
    assert given_speed("600..1800rpm") == given_speed("600 rpm .. 1800 rpm")
    assert given_speed("fan=10..30Hz").shaft == "fan"
