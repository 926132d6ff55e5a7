# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint fatigue` and `pitchpoint wind`: closed forms on short runs, load cases, files, refusals."""

from __future__ import annotations

import csv
import math
import shutil

import h5py
import numpy as np
import pytest

import pitchpoint
from pitchpoint.cli.main import run_command
from tests.support.cli_files import json_of, written

PAIR = """\
title: pair on a shaft
gears:
  pinion: {number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  wheel: {number_of_teeth: 30, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  motor: {inertia: 0.01 kg m^2}
  a: {gears: [pinion], inertia: 0.01 kg m^2}
  b: {gears: [wheel], inertia: 0.02 kg m^2}
couplings: {shaft: {bodies: [motor, a], stiffness: {torsion: 2e4 N m/rad}, damping: {torsion: 10}}}
meshes:
  stage: {gears: [pinion, wheel], stiffness: {law: din3990}, damper: {ratio: 0.3}}
loads:
  drive: {body: motor, torque: 50 N m}
  machine: {body: b, torque: balance}
scenarios:
  run: {speed: {a: 600 rpm}, duration: 0.4 s, step: 50 us, settle_time: 0.1 s}
"""


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    folder = tmp_path_factory.mktemp("fatigue")
    file = written(folder, PAIR)
    assert run_command(["run", file, "-q", "-o", str(folder / "run.h5")]) == 0
    return str(folder / "run.h5")


def test_results_without_loads_of_parts_need_channels(tmp_path, capsys):
    """A table without rows would look like a result."""
    text = """\
bodies: {wheel: {inertia: 1 kg m^2}}
loads: {drive: {body: wheel, torque: 1 N m}}
scenarios: {run: {speed: {wheel: 60 rpm}, duration: 0.1 s, step: 1 ms}}
"""
    file, target = written(tmp_path, text), str(tmp_path / "run.h5")
    assert run_command(["run", file, "-q", "-o", target]) == 0
    assert run_command(["fatigue", target]) == 2
    assert "have no moments of beams" in (told := capsys.readouterr().err) and "-c" in told
    assert run_command(["fatigue", target, "-c", "speed[wheel]"]) == 0


def test_pulses_of_a_pair_at_constant_torque(result, capsys):
    """0.3 s at 10 Hz: 3 turns of the pinion, 2 of the wheel; all pulses are equal."""
    found = json_of(["fatigue", result], capsys)
    with pitchpoint.open_result(result) as data:
        pairs = [np.asarray(data[n])[data["time"] > 0.11] for n in data.data_vars if "pair_force" in str(n)]
    force = float(np.max(pairs))
    assert force > 50.0 / (0.5 * 0.06 * math.cos(math.radians(20)))
    for gear, teeth in (("pinion", 20), ("wheel", 30)):
        row = found["teeth"][gear]["front"]
        assert len(row["pulses"]) == teeth and max(row["largest"]) == pytest.approx(force, rel=1e-3)
        assert 57 <= sum(row["pulses"]) <= 60 and max(row["pulses"]) - min(row["pulses"]) <= 1
        share = np.array(row["pulses"]) / np.mean(row["pulses"])
        assert np.array(row["equivalent"]) == pytest.approx(force * share ** (1 / 8.738), rel=1e-2)
    torque = found["channels"]["coupling_force[shaft.mz]"]
    assert abs(torque["mean"]) == pytest.approx(50.0, rel=1e-3)
    assert found["duration"] == pytest.approx(0.3, rel=1e-3)
    [note] = found["notes"]
    assert note.startswith("fewer than 10 pulses per tooth of pinion, wheel")


def test_meshes_without_single_pairs(capsys, tmp_path):
    file = written(tmp_path, PAIR.replace("law: din3990", "law: constant, value: 4e8 N/m"))
    target = str(tmp_path / "run.h5")
    assert run_command(["run", file, "-q", "-o", target]) == 0
    found = json_of(["fatigue", target], capsys)
    row = found["teeth"]["pinion"]["front"]
    assert row["largest"] == pytest.approx([50.0 / (0.03 * math.cos(math.radians(20)))] * 20, rel=1e-3)
    assert "the whole mesh force counts" in found["notes"][0]
    assert run_command(["fatigue", target, "-q"]) == 0
    assert "Teeth: forces of whole meshes" in capsys.readouterr().out


def test_load_cases_are_added(result, capsys, tmp_path):
    """Hours of the life scale the equivalent by the Wöhler line; two results are one table."""
    one = json_of(["fatigue", result, "-c", "speed*"], capsys)
    assert one["tooth_force"] is None and not one["teeth"]
    assert set(one["channels"]) == {"speed[motor]", "speed[a]", "speed[b]"}
    name = "mesh_force[stage]"
    once = json_of(["fatigue", result, "-c", name, "--slope", "5", "--cycles", "100"], capsys)
    life = ["--hours", f"{result}=10", "--cycles", "100"]
    longer = json_of(["fatigue", result, "-c", name, "--slope", "5", *life], capsys)
    factor = (10 * 3600 / once["duration"]) ** 0.2
    before, after = (f["channels"][name]["equivalent"][0] for f in (once, longer))
    assert after == pytest.approx(before * factor, rel=1e-9)
    target = tmp_path / "loads.csv"
    assert run_command(["fatigue", result, result, "--csv", str(target)]) == 0
    assert "loads of" not in capsys.readouterr().err
    rows = list(csv.reader(target.read_text().splitlines()[1:]))
    assert rows[0] == ["kind", "name", "item", "value", "unit"]
    assert {row[0] for row in rows[1:]} == {"channel", "equivalent", "exceeded", "pulses", "largest"}


def test_few_samples_per_mesh_are_named(result, capsys, tmp_path):
    model = tmp_path / "model.yaml"
    model.write_text(PAIR.replace("step: 50 us", "step: 50 us, sample_rate: 1 kHz"), encoding="utf-8")
    thin = str(tmp_path / "thin.h5")
    assert run_command(["run", str(model), "-q", "-o", thin]) == 0
    assert "5.0 samples per mesh period" in json_of(["fatigue", thin], capsys)["notes"][0]


def test_a_run_that_has_not_finished(result, capsys, tmp_path):
    """The samples in the file count, with a note."""
    target = tmp_path / "part.h5"
    shutil.copy(result, target)
    with h5py.File(target, "r+") as file:
        file.attrs["status"] = "running"
    found = json_of(["fatigue", str(target)], capsys)
    assert "has not finished: running" in found["notes"][0] and found["teeth"]["pinion"]["front"]


@pytest.mark.parametrize(
    ("more", "words"),
    [
        (["-c", "torque[nothing]"], "no channel"),
        (["--hours", "other.h5=3"], "is not one of the files"),
        (["--hours", "{}=-3"], "is not a number of hours"),
        (["--slope", "0"], "slope"),
    ],
)
def test_what_is_refused(result, capsys, more, words):
    assert run_command(["fatigue", result, *(m.format(result) for m in more)]) == 2
    assert words in capsys.readouterr().err


def test_wind_from_a_seed(tmp_path, capsys):
    """Normal turbulence of class IB at 12 m/s, 2.04 m/s; the same seed gives the same file."""
    given = ["--speed", "12 m/s", "--height", "90 m", "--width", "100 m", "--points", "5"]
    files = [tmp_path / f"{k}.bts" for k in range(3)]
    for file, seed in zip(files, ("1", "1", "2"), strict=True):
        found = json_of(["wind", str(file), *given, "--duration", "60 s", "--seed", seed], capsys)
    assert found["deviation"] == pytest.approx(0.14 * (0.75 * 12 + 5.6)) and found["samples"] == 600
    assert files[0].read_bytes() == files[1].read_bytes() != files[2].read_bytes()
    box = pitchpoint.read_turbsim(files[0])
    assert box.velocity[:, 2, 2, 0].mean() == pytest.approx(12.0, abs=1.0)
    assert run_command(["wind", str(tmp_path / "x.bts"), "--speed", "12 m/s"]) == 2
    both = ["--deviation", "1 m/s", "--extreme"]
    assert run_command(["wind", str(tmp_path / "x.bts"), *given, *both]) == 2
