# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint study`: tables, page, continuation after a kill, more samples, shards, failed cases."""

from __future__ import annotations

import csv
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.cli.main import run_command
from pitchpoint.io.results import open_result
from tests.support.cli_files import json_of
from tests.support.model_files import TORSIONAL_PAIR
from tests.support.study_files import FREQUENCY, SERIES, written

TWIST = """\
model: model.yaml
evaluate: equilibrium
samples: 16
factors:
  inner: {type: normal, path: loads.inner.torque, deviation: 3 N m}
  outer: {type: levels, path: loads.outer.torque, values: [10 N m, 20 N m, 25 N m]}
results:
  twist: {channel: "angle[two]", high: 0.02 rad}
"""


def rows(folder: Path, name: str = "index.csv") -> list[dict[str, str]]:
    with (folder / name).open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_a_whole_study_and_again(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plan, out = written(tmp_path), tmp_path / "out"
    first = json_of(["study", plan, "-o", str(out)], capsys)
    assert (first["cases"], first["known"], first["finished"], first["failed"]) == (32, 0, 32, 0)
    frequency = first["results"]["frequency"]
    assert frequency["unit"] == "Hz" and frequency["count"] == 32
    assert frequency["nominal"] == pytest.approx(94.158, abs=1e-3)
    assert set(frequency["variance_share"]) == {"stiffness", "first inertia", "second inertia"}
    table = rows(out)
    assert [int(r["case"]) for r in table] == list(range(32))
    assert list(table[0])[5:9] == [
        "stiffness [N m/rad]",
        "first inertia [kg m^2]",
        "second inertia [kg m^2]",
        "frequency [Hz]",
    ]
    found = [float(r["frequency [Hz]"]) for r in table]
    assert frequency["mean"]["value"] == pytest.approx(np.mean(found))
    inside = sum(90.0 <= f <= 100.0 for f in found)
    assert frequency["share_within_limits"]["value"] == inside / 32
    with open_result(out / "study.h5") as data:
        assert data["result[frequency]"].values == pytest.approx(found)
        assert data["result[frequency]"].attrs["units"] == "Hz"
        assert float(data["mean"].sel(result="frequency")) == pytest.approx(np.mean(found))
        assert data["variance_share"].dims == ("result", "factor")
        assert len(pp.plot(data, "sensitivities[damping]").data) == 1
        assert pp.plot(data).data[0].type == "bar"  # the distribution of the first result
        pp.write_report(str(tmp_path / "model.yaml"), tmp_path / "shown.html", data)
    assert (out / "study.html").read_text("utf-8").startswith("<!DOCTYPE html>")
    report = ["report", str(tmp_path / "model.yaml"), str(out / "study.h5"), "-q", "-o"]
    assert run_command([*report, str(tmp_path / "report.html")]) == 0
    for name in ("report", "shown"):
        text = (tmp_path / f"{name}.html").read_text("utf-8")
        assert 'id="studies"' in text and "Spread of the results" in text and "94.16" in text
    before = {
        p: p.read_bytes() for p in out.rglob("*") if p.is_file() and p.suffix != ".h5"
    }  # with wall time
    again = json_of(["study", plan, "-o", str(out)], capsys)
    assert again["known"] == 33 and again["results"] == first["results"]
    assert {p: p.read_bytes() for p in before} == before


def test_more_samples_and_other_results_reuse_the_cases(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = str(tmp_path / "out")
    short = FREQUENCY.replace("samples: 32", "samples: 4")
    json_of(["study", written(tmp_path, short), "-o", out], capsys)
    longer = short.replace("samples: 4", "samples: 8").replace(
        "undamped_frequency[2]", "natural_frequency[2]"
    )
    found = json_of(["study", written(tmp_path, longer), "-o", out, "--dry-run"], capsys)
    assert (found["cases"], found["known"], found["left"]) == (8, 5, 4)
    indices = short + "sensitivity: sobol_indices\n"
    more = json_of(["study", written(tmp_path, indices), "-o", out, "--dry-run"], capsys)
    assert more["cases"] == 4 * (3 + 2)


def test_the_seed_gives_the_samples(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    found = []
    for name, seed in (("a", 1), ("b", 1), ("c", 2)):
        text = FREQUENCY.replace(
            "samples: 32", f"samples: 4\nseed: {seed}\nsampling: latin_hypercube"
        ).replace("sampling: sobol\n", "")
        json_of(
            ["study", written(tmp_path / name, text), "-o", str(tmp_path / name / "out"), "-j", "1"], capsys
        )
        found.append((tmp_path / name / "out" / "index.csv").read_bytes())
    assert found[0] == found[1] != found[2]


def test_a_killed_study_continues(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plan, out = written(tmp_path, FREQUENCY.replace("samples: 32", "samples: 4096")), tmp_path / "out"
    command = [sys.executable, "-m", "pitchpoint", "study", plan, "-o", str(out), "-q"]
    process = subprocess.Popen(command, stderr=subprocess.DEVNULL)
    until = time.monotonic() + 60.0
    while time.monotonic() < until and len(list(out.glob("cases/*.json"))) < 8:
        time.sleep(0.05)
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    stored = len([p for p in out.glob("cases/*.json") if not p.name.startswith(".")])
    assert stored >= 8
    short = written(tmp_path, FREQUENCY.replace("samples: 32", "samples: 4"))
    found = json_of(["study", short, "-o", str(out)], capsys)
    assert found["known"] == 5 and found["finished"] == 4


def test_shards_and_levels(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plan, out = written(tmp_path, TWIST, SERIES), tmp_path / "out"
    part = json_of(["study", plan, "-o", str(out), "--shard", "1/2"], capsys)
    assert "results" not in part and len(rows(out, "index-1-of-2.csv")) == 8
    whole = json_of(["study", plan, "-o", str(out)], capsys)
    names = TWIST.replace("[10 N m, 20 N m, 25 N m]", "[10 N m, 20 N m, 10 N m + 15 N m]")
    labels = pp.run_study(written(tmp_path / "labels", names, SERIES), jobs=1)
    assert set(labels["factor[outer]"].values) == {"10 N m", "20 N m", "10 N m + 15 N m"}
    assert pp.plot(labels, "over_factors[twist]").layout.xaxis2.ticktext[0] == "10 N m"
    assert whole["known"] == 9 and whole["finished"] == 16
    assert {r["outer [N m]"] for r in rows(out)} == {"10.0", "20.0", "25.0"}
    assert whole["results"]["twist"]["determination"] == pytest.approx(1.0, abs=1e-6)


def test_a_result_that_does_not_vary_is_noted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The first frequency is that of the rigid rotation: 0 Hz, or rounding."""
    rigid = FREQUENCY.replace("samples: 32", "samples: 4").replace("damping_ratio[2]", "natural_frequency[1]")
    assert run_command(["study", written(tmp_path, rigid), "-o", str(tmp_path / "out")]) == 0
    assert "damping is equal in all cases: no factor has an influence on it" in capsys.readouterr().out


def test_failed_cases_are_counted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The model accepts the middle of the distribution and refuses teeth that are too thin at its ends."""
    plan = """\
model: model.yaml
evaluate: equilibrium
sampling: full_factorial
samples: 3
factors:
  shift: {type: uniform, path: gears.g1.profile_shift_coefficient, low: -1.2, high: 1.2}
  torques: {type: levels, paths: [loads.input.torque, loads.output.torque], values: [100 N m, 150 N m]}
results:
  force: {channel: "mesh_force[stage]"}
"""
    out = tmp_path / "out"
    assert run_command(["study", written(tmp_path, plan, TORSIONAL_PAIR), "-o", str(out), "--json"]) == 3
    printed = capsys.readouterr()
    found = json.loads(printed.out)
    failed = [r for r in rows(out) if r["status"] == "failed"]
    assert found["failed"] == len(failed) == 6 - found["results"]["force"]["count"] > 0
    assert all(r["force [N]"] == "" and r["sentence"] for r in failed)
    assert f"{len(failed)} of 6 cases failed" in printed.err
    assert f"{len(failed)} of 6 cases failed; the statistics are those of the others" in found["notes"]
    assert (
        run_command(["study", str(tmp_path / "plan.yaml"), "-o", str(out), "-q"]) == 3
    )  # not computed again
