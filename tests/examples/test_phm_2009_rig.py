# SPDX-License-Identifier: Apache-2.0
"""The example `phm-2009-rig` and the page on data sets: frequencies, what faults do, the step."""

from __future__ import annotations

import csv
import dataclasses
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.dataset import checked
from pitchpoint.io.results import open_result
from pitchpoint.io.yaml_plan import load_plan
from pitchpoint.model.dataset_plan import DatasetPlan, PlannedCase
from pitchpoint.model.model import Model
from pitchpoint.sweep.dataset import CaseRecord, compute_case
from tests.support.cli_files import json_of

FOLDER = Path(__file__).parents[2] / "examples" / "phm-2009-rig"
PAGE = Path(__file__).parents[2] / "docs" / "datasets.md"
CHIP = {"gears.z32.faults.chip.severity": 1.0}
PITCH = {"gears.z80.faults.pitch.severity": 1.0}


@pytest.fixture(scope="module")
def rig() -> tuple[DatasetPlan, Model]:
    """The plan without noise and jitter, 0.4 s long."""
    plan, model = checked(load_plan(FOLDER / "plan.yaml"), False, True)
    bare = {
        n: dataclasses.replace(c, noise=None) if hasattr(c, "noise") else c for n, c in plan.channels.items()
    }
    return dataclasses.replace(plan, channels=bare, jitter={}, length=0.4), model


def computed(rig: tuple[DatasetPlan, Model], changes: dict[str, object]) -> CaseRecord:
    record = compute_case(*rig, PlannedCase(0, {}, changes, 1), "key")
    assert record.status == 1, record.sentence
    return record


@pytest.fixture(scope="module")
def healthy(rig: tuple[DatasetPlan, Model]) -> CaseRecord:
    return computed(rig, {})


def vibration(record: CaseRecord) -> np.ndarray:
    values = record.channels["vibration_input"].values
    return values - values.mean()


def lines(values: np.ndarray, rate: float = 25600.0) -> tuple[np.ndarray, np.ndarray]:
    """Frequencies and amplitudes of a windowed spectrum."""
    window = np.hanning(values.size)
    return np.fft.rfftfreq(values.size, 1.0 / rate), np.abs(np.fft.rfft(values * window)) * 2.0 / window.sum()


def test_the_plan_is_a_thousand_cases_of_a_second() -> None:
    plan, _ = checked(load_plan(FOLDER / "plan.yaml"), False, True)
    assert len(plan) == 1000
    assert plan.samples == 25600
    assert len({(c.seed, repr(c.changes)) for c in plan.cases()}) == 1000


def test_speeds_and_mesh_frequencies(rig: tuple[DatasetPlan, Model], healthy: CaseRecord) -> None:
    """Shafts 30, 10, 6 Hz; the strongest line is 960 Hz to the width of a line of 0.4 s (2.5 Hz)."""
    speeds = rig[1].start_speeds(dataclasses.replace(rig[1].scenarios["rig"], speed={"input": 60.0 * np.pi}))
    hertz = [abs(speeds[n]) / (2.0 * np.pi) for n in ("input", "idler", "output")]
    np.testing.assert_allclose(hertz, [30.0, 10.0, 6.0], rtol=1e-12)
    f, a = lines(vibration(healthy))
    assert abs(f[np.argmax(a)] - 960.0) < 2.5
    for mesh in (480.0, 1920.0):
        near = np.abs(f - mesh) < 2.6
        assert a[near].max() > 10.0 * np.median(a[(f > mesh - 100.0) & (f < mesh + 100.0)])
    begun = healthy.pulses["tacho"]
    assert begun.size == pytest.approx(0.4 * 300.0, abs=1)
    np.testing.assert_allclose(np.diff(begun), 1.0 / 300.0, rtol=1e-6)  # the drive holds the speed


def test_faults_show(rig: tuple[DatasetPlan, Model], healthy: CaseRecord) -> None:
    """The figures of the README, at its accuracy, from 0.4 s instead of 1 s."""
    usual = vibration(healthy)
    assert usual.std() == pytest.approx(2.57, rel=0.03)
    assert vibration(computed(rig, CHIP)).std() == pytest.approx(2.73, rel=0.03)
    struck = vibration(computed(rig, PITCH))
    assert struck.std() == pytest.approx(5.98, rel=0.1)
    assert ((struck / struck.std()) ** 4).mean() > 8.0
    assert ((usual / usual.std()) ** 4).mean() < 3.0


def test_half_the_step_changes_little(rig: tuple[DatasetPlan, Model], healthy: CaseRecord) -> None:
    """rms below 0.3 %, as the README says; of a machine without impacts."""
    finer = computed(rig, {"scenarios.rig.step": 9.8e-6})
    for name, channel in healthy.channels.items():
        if name != "tacho":
            assert finer.channels[name].values.std() == pytest.approx(channel.values.std(), rel=3e-3)


def test_severity_zero_is_the_healthy_rig(rig: tuple[DatasetPlan, Model], healthy: CaseRecord) -> None:
    whole = rig[1].replace_all({"gears.z32.faults.chip": None, "gears.z48.faults.broken": None})
    bare = compute_case(rig[0], whole, PlannedCase(0, {}, {}, 1), "key")
    np.testing.assert_allclose(vibration(bare), vibration(healthy), atol=1e-9)


def test_the_small_plan(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "set"
    found = json_of(["dataset", str(FOLDER / "small.yaml"), "-o", str(out)], capsys)
    assert (found["cases"], found["finished"]) == (24, 24)
    with (out / "index.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert {r["fault"] for r in rows} == {"healthy", "chipped_pinion"}
    with open_result(out / rows[0]["file"]) as data:
        assert data.sizes["time"] == 1280
        assert data["force_input"].attrs["units"] == "N"


def test_the_page_on_data_sets(tmp_path: Path) -> None:
    text = PAGE.read_text(encoding="utf-8")
    block = text.split("```yaml\n")[1].split("```")[0]
    (tmp_path / "plan.yaml").write_text(block, encoding="utf-8")
    (tmp_path / "model.yaml").write_text(
        (FOLDER / "model.yaml").read_text(encoding="utf-8"), encoding="utf-8"
    )
    plan, _ = checked(load_plan(tmp_path / "plan.yaml"), False, True)
    assert len(plan) == 3 * 2 * 4 * 10
