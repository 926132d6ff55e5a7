# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint diagnose` on files of all kinds, complete, damaged, and about another machine than is said."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np
import pytest
from scipy.io import savemat, wavfile

from pitchpoint.cli.main import run_command
from tests.support.cli_files import json_of, written
from tests.unit.cli.test_frequencies import grc

RATE = 6400.0
TRAIN = ["--train", "32/95"]
Table = dict[str, np.ndarray]


def rig(*, fault: float = 2.0, run_up: bool = False, rate: float = RATE) -> Table:
    """Three seconds of a pair 32/95 from 10 Hz, up to 16 Hz in a run-up, whose pinion has a damaged tooth."""
    time = np.arange(int(3 * rate)) / rate
    turned = 10.0 * time + (1.0 * time**2 if run_up else 0.0)
    since = (turned + 0.3) % 1
    knock = np.exp(-(((since - 0.5) / 0.01) ** 2)) * np.cos(2 * np.pi * 140 * since)
    noise = 0.4 * np.random.default_rng(3).standard_normal(time.size)
    mesh = np.cos(2 * np.pi * 32 * turned) + 0.4 * np.cos(2 * np.pi * 64 * turned)
    tacho = ((4 * turned) % 1 < 0.5).astype(float)
    return {"time": time, "acc": mesh + noise + fault * knock, "tacho": tacho, "angle": 2 * np.pi * turned}


def csv_of(folder: Path, table: Table, name: str = "rig.csv") -> str:
    units = {"time": "s", "acc": "m/s^2", "tacho": "V", "angle": "rad"}
    heads = ",".join(f"{key} [{units.get(key, 'm/s^2')}]" for key in table)
    rows = np.column_stack(list(table.values()))
    np.savetxt(folder / name, rows, delimiter=",", header=heads, comments="", fmt="%.8g")
    return str(folder / name)


def only(table: Table, *names: str) -> Table:
    return {name: table[name] for name in ("time", *names)}


def told(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> str:
    """The sentence with which a command refuses; nothing but it may be said."""
    assert run_command(["diagnose", *arguments]) == 2
    said = capsys.readouterr()
    assert not said.out
    assert "Traceback" not in said.err
    return said.err


def gears_found(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> list[tuple[str, list[str]]]:
    found = json_of(["diagnose", *arguments], capsys)
    return [(finding["kind"], finding["gears"]) for finding in found["findings"]]


@pytest.mark.parametrize("fault", [2.0, 0.0])
@pytest.mark.parametrize("by", [["--tacho", "tacho", "--pulses", "4"], ["--angle", "angle"]])
def test_a_run_up_with_a_tacho_or_an_angle(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], by: list[str], fault: float
) -> None:
    table = only(rig(fault=fault, run_up=True), "acc", by[1])
    expected = [("local fault", ["Z1"])] if fault else []
    file = csv_of(tmp_path, table)
    assert gears_found([file, *TRAIN, *by], capsys) == expected
    found = json_of(["diagnose", file, *TRAIN, *by], capsys)
    assert found["reference_frequency"] is None
    assert any("rpm: orders instead of frequencies" in text for text in found["remarks"])


def test_a_run_up_told_to_be_steady_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = csv_of(tmp_path, only(rig(run_up=True), "acc"))
    assert "no mesh line at 320 Hz" in told([file, *TRAIN, "--speed", "10Hz"], capsys)


def _wav(path: Path, table: Table) -> None:
    wavfile.write(path, int(RATE), (table["acc"] * 5000).astype(np.int16))


def _mat(path: Path, table: Table) -> None:
    savemat(path, {"rig": {"acc": table["acc"]}, "fs": RATE})


def _hdf5(path: Path, table: Table) -> None:
    with h5py.File(path, "w") as file:
        file.create_dataset("rig/acc", data=table["acc"].astype("f4")).attrs["units"] = "m/s^2"
        file.attrs["sample_rate"] = RATE


def _uff(path: Path, table: Table) -> None:
    import pyuff

    data = {
        "type": 58, "func_type": 1, "rsp_node": 1, "rsp_dir": 1, "ref_node": 0, "ref_dir": 0, "binary": 0,
        "data": table["acc"], "x": table["time"], "id1": "acc", "rsp_ent_name": "acc",
        "num_pts": table["acc"].size,
        "abscissa_spacing": 1, "abscissa_inc": 1 / RATE, "abscissa_min": 0.0, "abscissa_axis_units_lab": "s",
        "abscissa_axis_lab": "time", "abscissa_spec_data_type": 17, "ordinate_axis_lab": "acc",
        "ordinate_axis_units_lab": "m/s^2", "ordinate_spec_data_type": 12, "orddenom_spec_data_type": 0,
        "ord_data_type": 4, "n_bytes": 0, "load_case_id": 0, "version_num": 1,
    }  # fmt: skip
    pyuff.UFF(str(path)).write_sets(data, "overwrite")


@pytest.mark.parametrize("fault", [2.0, 0.0])
@pytest.mark.parametrize(("ending", "write"), [("wav", _wav), ("mat", _mat), ("h5", _hdf5), ("uff", _uff)])
def test_other_formats(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    ending: str,
    write: Callable[[Path, Table], None],
    fault: float,
) -> None:
    path = tmp_path / f"rig.{ending}"
    write(path, rig(fault=fault))
    expected = [("local fault", ["Z1"])] if fault else []
    assert gears_found([str(path), *TRAIN, "--speed", "10Hz"], capsys) == expected


@pytest.mark.parametrize(("ending", "write"), [("wav", _wav), ("mat", _mat), ("h5", _hdf5), ("uff", _uff)])
def test_half_a_file_is_a_sentence(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], ending: str, write: Callable[[Path, Table], None]
) -> None:
    path = tmp_path / f"rig.{ending}"
    write(path, rig())
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    assert f"rig.{ending}" in told([str(path), *TRAIN, "--speed", "10Hz"], capsys)


def test_a_csv_that_ends_within_a_line_is_a_sentence(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = Path(csv_of(tmp_path, only(rig(), "acc")))
    lines = file.read_text().splitlines()[:9000]
    file.write_text("\n".join([*lines, lines[-1].split(",")[0]]))
    assert "9001" in told([str(file), *TRAIN, "--speed", "10Hz"], capsys)


def test_samples_that_are_no_numbers_are_refused_with_their_place(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table = only(rig(), "acc")
    table["acc"][1000] = math.nan
    said = told([csv_of(tmp_path, table), *TRAIN, "--speed", "10Hz"], capsys)
    assert "acc" in said
    assert "100" in said


def test_constant_channels_are_left_out_and_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table = only(rig(), "acc")
    flat = np.full(table["acc"].size, 4.0)
    file = csv_of(tmp_path, {**table, "flat": flat})
    found = json_of(["diagnose", file, *TRAIN, "--speed", "10Hz"], capsys)
    assert [finding["gears"] for finding in found["findings"]] == [["Z1"]]
    assert "flat: is constant; omitted" in found["remarks"]
    said = told([file, *TRAIN, "--speed", "10Hz", "-c", "flat"], capsys)
    assert "no channel can be used: flat: is constant" in said


def test_without_speed_or_tacho_it_says_what_to_give(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = csv_of(tmp_path, only(rig(), "acc"))
    assert "give --speed, such as --speed 30Hz, --tacho CHANNEL" in told([file, *TRAIN], capsys)
    said = told([file, *TRAIN, "--tacho", "tacho", "--pulses", "4"], capsys)
    assert "no channel 'tacho'; there are acc" in said


def test_a_tacho_that_is_none_is_a_sentence(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table = only(rig(), "acc", "tacho")
    table["tacho"] = 0.0 * table["tacho"]
    table["tacho"][0] = 1e-3
    said = told([csv_of(tmp_path, table), *TRAIN, "--tacho", "tacho", "--pulses", "4"], capsys)
    assert "pulse" in said


@pytest.mark.parametrize("fault", [2.0, 0.0])
def test_a_sample_rate_below_the_mesh_says_so_and_names_no_gear(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], fault: float
) -> None:
    """At 500 Hz the record ends at 250 Hz: no harmonic of 320 Hz is left, so nothing confirms the teeth."""
    table = rig(fault=fault)
    low = np.fft.irfft(np.fft.rfft(table["acc"])[: 3 * 250 + 1], 3 * 500) * 500 / RATE
    table = {"time": np.arange(1500) / 500.0, "acc": low}
    found = json_of(["diagnose", csv_of(tmp_path, table), *TRAIN, "--speed", "10Hz±0%"], capsys)
    assert any(
        "above half of it, not testable: harmonics 1, 2, 3, 4, 5 of mesh 1 (320 Hz)" in text
        for text in found["remarks"]
    )
    assert all(finding["gears"] == [] for finding in found["findings"])
    if not fault:
        assert found["findings"] == []


@pytest.mark.parametrize("train", ["31/95", "33/95", "17/95"])
def test_wrong_tooth_counts_of_the_pinion_are_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], train: str
) -> None:
    said = told([csv_of(tmp_path, only(rig(), "acc")), "--train", train, "--speed", "10Hz"], capsys)
    assert "check tooth counts and speed" in said
    assert "strongest lines at 320 Hz" in said


def test_a_stage_that_does_not_show_has_no_gear_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The second stage is made up: no gear of its shafts is named, and its missing lines are told."""
    table = rig()
    turned = 10.0 * table["time"] * 32 / 95
    table["acc"] += 3.0 * np.exp(-((((turned + 0.2) % 1 - 0.5) / 0.004) ** 2))
    file = csv_of(tmp_path, only(table, "acc"))
    found = json_of(["diagnose", file, "--train", "32/95-41/67", "--speed", "10Hz"], capsys)
    assert {finding["shaft"]: finding["gears"] for finding in found["findings"]} == {
        "shaft 1": ["Z1"],
        "shaft 2": [],
    }
    assert "no gear of shaft 2 is named: no mesh line of Z3 is visible" in found["remarks"]
    assert any(text.startswith("mesh 2: no mesh line at") for text in found["remarks"])


def test_planet_sets_are_refused_with_a_sentence(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    model = written(tmp_path, grc("ring", "sun: 600 rpm"))
    file = csv_of(tmp_path, only(rig(), "acc"))
    said = told([file, "--model", model, "--speed", "sun=10Hz"], capsys)
    assert "all are on a rotating carrier" in said
    assert "pitchpoint frequencies" in said


def test_a_file_that_is_still_written_is_a_sentence(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    from pitchpoint.report.diagnosis import record as records
    from pitchpoint.report.diagnosis.record import Record

    table = rig()
    growing = Record(table["time"][:-100], {"acc": table["acc"]})
    monkeypatch.setattr(records, "read_record", lambda *_: growing)
    said = told([csv_of(tmp_path, only(table, "acc")), *TRAIN, "--speed", "10Hz"], capsys)
    assert "if the run has not ended, wait for it" in said


def test_a_tacho_among_the_channels_is_no_vibration(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A healthy gear stays healthy, and the remark says how to use the pulses."""
    file = csv_of(tmp_path, only(rig(fault=0.0), "acc", "tacho"))
    known = [*TRAIN, "--speed", "10Hz"]
    found = json_of(["diagnose", file, *known], capsys)
    assert found["findings"] == []
    remarks = " ".join(found["remarks"])
    assert "channels: acc" in remarks
    assert "tacho: looks like tacho pulses, not vibration; omitted" in remarks
    assert "--tacho tacho --pulses N" in remarks


def test_one_file_for_each_channel_with_the_speed_in_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The files are one record; the speed is that of the file, and the option wins."""
    acc = rig()["acc"]
    paths = []
    for k, cut in enumerate((0, 5)):
        paths.append(str(tmp_path / f"ch{k}.mat"))
        noise = 0.1 * np.random.default_rng(k).standard_normal(acc.size)
        header = {"SampFreq": RATE, "Date": np.arange(6.0)}
        content = {"Data": (acc + noise)[None, : acc.size - cut], "Header": header, "Shaft_RPM": 600.0}
        savemat(paths[-1], content)
    found = json_of(["diagnose", *paths, *TRAIN], capsys)
    assert [(one["kind"], one["gears"]) for one in found["findings"]] == [("local fault", ["Z1"])]
    assert {row["channel"] for row in found["evidence"]} == {"ch0", "ch1"}
    origin = {row[0]: row[1:] for row in found["origin"]}
    assert origin["speed"][1] == "file, variable Shaft_RPM ±2 %, refined by the mesh lines"
    assert origin["sample rate"] == ["6400 Hz", "file, Header.SampFreq"] and "ch1.mat" in origin["file"][0]
    assert any(text.startswith("speed of shaft 1 from the file") for text in found["remarks"])
    found = json_of(["diagnose", paths[0], *TRAIN, "--speed", "2=3.3684Hz"], capsys)
    assert "--speed 2=3.3684Hz" in str(found["origin"]) and not any("no shaft" in t for t in found["remarks"])
    said = told([paths[0], *TRAIN, "--speed", "620rpm"], capsys)
    assert "speed: the file states 600 rpm (Shaft_RPM), the speed of no shaft; by --speed " in said
    assert "rotates at 620 rpm, 3.2 % faster; --speed is used, omit it if the file is right" in said
    listed = json_of(["analyse", *paths], capsys)
    assert list(listed["channels"]) == ["ch0", "ch1"] and listed["samples"] == acc.size - 5


def test_a_chosen_channel_is_read_although_others_do_not_fit(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    acc = rig()["acc"]
    savemat(tmp_path / "a.mat", {"acc": acc, "other": acc[:-100], "fs": RATE})
    assert "differ in length" in told([str(tmp_path / "a.mat"), *TRAIN, "--speed", "10Hz"], capsys)
    command = [str(tmp_path / "a.mat"), *TRAIN, "--speed", "10Hz", "-c", "acc"]
    assert gears_found(command, capsys) == [("local fault", ["Z1"])]
