# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint diagnose` on measured files and on a run with a broken tooth."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.io import savemat

from pitchpoint.cli.main import run_command
from tests.support.cli_files import json_of, written
from tests.support.rig_records import BROKEN_PAIR, rig_file


@pytest.mark.parametrize("speed", ["10Hz", "600rpm", "9.95 Hz"])
def test_a_measured_file_with_tooth_counts_and_speed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], speed: str
) -> None:
    found = json_of(["diagnose", rig_file(tmp_path), "--train", "32/95", "--speed", speed, "--json"], capsys)
    (finding,) = found["findings"]
    assert (finding["kind"], finding["gears"]) == ("local fault", ["Z1"])
    assert finding["by_noise"] < 0.01
    assert found["reference_frequency"] == pytest.approx(10.0, rel=1e-3)


def test_a_healthy_file_ends_with_nothing_found(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_command(["diagnose", rig_file(tmp_path, 0.0), "--train", "32/95", "--speed", "10Hz"]) == 0
    assert "nothing found: none of 7 tests exceeds its limit" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ([], "does not describe the machine; give --speed, and --bearing or --train"),
        (["--train", "32/95"], "the speed is not known; give --speed"),
        (["--train", "31/95", "--speed", "10Hz"], "no mesh line at 310 Hz"),
        (["--train", "32/95", "--speed", "11Hz"], "strongest lines at 320 Hz"),
        (["--train", "32-95", "--speed", "10Hz"], "is not a pair of tooth counts"),
        (["--train", "32/95", "--speed", "10Hz", "-c", "ac"], "no channel 'ac'; did you mean acc?"),
        (["--train", "32/95", "--tacho", "acc"], "--tacho requires --pulses N"),
        (
            ["--train", "32/95", "--speed", "10Hz", "--bearing", "DE:6205-2RS JEM"],
            "'DE:6205-2RS JEM' has no shaft; write 'DE:6205-2RS JEM@SHAFT'; there are: 1, 2",
        ),
    ],
)
def test_what_is_missing_or_wrong_is_a_sentence(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], options: list[str], words: str
) -> None:
    assert run_command(["diagnose", rig_file(tmp_path), *options]) == 2
    assert words in capsys.readouterr().err


def test_harmonics_that_the_sample_rate_loses_are_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = rig_file(tmp_path, 0.0, rate=1600.0)
    found = json_of(["diagnose", file, "--train", "32/95", "--speed", "10Hz", "--json"], capsys)
    assert any(
        "above half of it, not testable: harmonics 3, 4, 5 of mesh 1 (320 Hz)" in text
        for text in found["remarks"]
    )


@pytest.mark.parametrize(("severity", "kinds"), [("1", ["local fault"]), ("0", [])])
def test_a_run_with_and_without_a_broken_tooth(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], severity: str, kinds: list[str]
) -> None:
    model = written(tmp_path, BROKEN_PAIR.replace("severity: 1", f"severity: {severity}"))
    result = str(tmp_path / "run.h5")
    assert run_command(["run", model, "-o", result, "-q"]) == 0
    capsys.readouterr()
    found = json_of(["diagnose", result, "--json"], capsys)
    assert [finding["kind"] for finding in found["findings"]] == kinds
    assert all(finding["gears"] == ["pinion"] for finding in found["findings"])


def test_all_channels_of_a_result_are_those_of_vibration(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """By default the first quantity that the result has: the sensor, if there is one."""
    result = str(tmp_path / "run.h5")
    sensor = "sensors:\n  torque_meter: {type: observation, channel: 'mesh_force[stage]'}\n"
    assert run_command(["run", written(tmp_path, BROKEN_PAIR + sensor), "-o", result, "-q"]) == 0
    capsys.readouterr()

    def tested(*more: str) -> set[str]:
        """Channels with tests."""
        return {row["channel"] for row in json_of(["diagnose", result, *more], capsys)["evidence"]}

    assert tested() == {"signal[torque_meter]"}
    every = tested("--all-channels")
    assert every > {"signal[torque_meter]", "mesh_force[stage]"} and "speed[shaft]" not in every
    assert run_command(["diagnose", result, "--unit", "signal[torque_meter]=m/s"]) == 2
    assert "results have units; omit the option" in capsys.readouterr().err


def test_an_unknown_designation_names_the_nearest_and_the_options(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The keys of a model file do not help with an option."""
    options = ["--train", "32/95", "--speed", "10Hz", "--bearing", "left:6025@2"]
    assert run_command(["diagnose", rig_file(tmp_path), *options]) == 2
    said = capsys.readouterr().err
    assert "6025 is not in the table of bearings" in said and "did you mean" in said
    assert "BPFO=3.58" in said and "radial_static_load_rating" not in said


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--bearing", "8,7.9mm,33.5mm"], "'8,7.9mm,33.5mm' is not NAME:BEARING@SHAFT"),
        (["--bearing", "a:6205", "--slip", "30%"], "--slip: 0.3 (limit 0 to 0.1)"),
        (["--bearing", "a:BPFO=5.4,BPFI=3.6"], "BPFO 5.4 (limit below BPFI 3.6 if the inner ring rotates)"),
        (["--bearing", "a:9,7.94mm,39mm,15"], "contact angle 859.4 deg (limit 0 to 90 deg)"),
        (["--bearing", "a:40,7.9mm,33.5mm"], "40 rolling elements (limit 13 on this pitch diameter)"),
        (["--bearing", "a:6205", "--speed", "600..900rpm"], "no shaft orders determine it within 600 to 900"),
    ],
)
def test_impossible_bearings_slips_and_ranges_are_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], options: list[str], words: str
) -> None:
    path = tmp_path / "noise.csv"
    np.savetxt(path, np.random.default_rng(1).standard_normal(20_000), header="acc", comments="")
    speed = [] if "--speed" in options else ["--speed", "900rpm"]
    assert run_command(["diagnose", str(path), "--sample-rate", "2kHz", *speed, *options]) == 2
    assert words in capsys.readouterr().err


def test_all_problems_of_options_are_stated_before_anything_is_read(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise AssertionError("read before the options were checked")

    monkeypatch.setattr("pitchpoint.report.diagnosis.record.read_record", fail)
    file = rig_file(tmp_path)
    wrong = ["--speed", "abc", "--train", "3-4", "--bearing", "b:BPFO=x", "--shaft", "a", "--slip", "30%"]
    more = ["--machine-group", "9", "--reference", str(tmp_path / "nothere"), "--load", "half"]
    assert run_command(["diagnose", file, *wrong, *more]) == 2
    said = capsys.readouterr().err
    assert said.startswith("error: 7 problems")
    for words in (
        "--train: '3' is not a pair",
        "--speed: 'abc'",
        "--shaft: 'a' is not NAME=RATIO",
        "--bearing: 'b:BPFO=x': 'BPFO=x' is not a fault order",
        "--slip: 0.3 (limit 0 to 0.1)",
        "--machine-group: no group '9'",
        "nothere' does not exist and matches no file",
        "--load: load 'half' is not a number",
    ):
        assert words in said
    contradictions = ["--load-from", "{load}", "--all-channels", "-c", "acc", "--pulses", "3"]
    assert run_command(["diagnose", file, "--speed", "10Hz", *contradictions]) == 2
    said = capsys.readouterr().err
    for words in ("both choose channels", "--pulses requires --tacho", "--load-from requires --reference"):
        assert words in said


def test_a_scenario_of_a_file_without_a_model_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    options = ["--speed", "10Hz", "--bearing", "left:6205", "--scenario", "rated"]
    assert run_command(["diagnose", rig_file(tmp_path), *options]) == 2
    assert "--scenario rated: " in capsys.readouterr().err


def test_messages_about_files_state_options_of_the_command(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """In Python the same messages state the arguments of `read_measured`."""
    from pitchpoint.io.measured.reading import read_measured
    from pitchpoint.io.measured.record import MeasuredError

    path = tmp_path / "a.mat"
    signal = np.random.default_rng(1).standard_normal(2000)
    options = ["--speed", "10Hz", "--bearing", "left:6205"]
    for content, argument, option in (
        ({"x": signal}, "give sample_rate=", "give --sample-rate"),
        ({"x": signal, "y": signal[:-7], "fs": 5e3}, "by channels=", "by --channel"),
    ):
        savemat(path, content)
        with pytest.raises(MeasuredError, match=argument):
            read_measured(path)
        assert run_command(["diagnose", str(path), *options]) == 2
        said = capsys.readouterr().err
        assert option in said and argument not in said
    savemat(path, {"x": np.round(100 * signal).astype("i2"), "scale": 0.5, "fs": 1000.0})
    assert run_command(["analyse", str(path)]) == 0
    assert "give --unit 'x=0.5 m/s^2'" in capsys.readouterr().out
