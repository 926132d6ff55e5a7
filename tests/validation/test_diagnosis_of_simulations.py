# SPDX-License-Identifier: Apache-2.0
"""What `pitchpoint diagnose` says about simulated machines whose state is known: nothing about healthy ones.

Both examples, through the files that a user has. Bearings of healthy machines shake as often as balls pass,
meshes change each other, and records of simulations have no filter: none of that is damage. More speeds,
loads, seeds and faults of the rig are in `test_diagnosis_counts`.
"""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.report.diagnosis.request import Request, diagnose_file

EXAMPLES = Path(__file__).parents[2] / "examples"
PLAN = """
title: rig, healthy and with faults
model: {model}
scenario: rig
factors:
  speed: {{scenarios.rig.drive.input.speed: [43.7 Hz]}}
  fault:
    healthy: {{}}
    broken: {{gears.z48.faults.broken.severity: 0.4}}
    spall: {{rolling_bearings.input_a.faults.outer.severity: 1}}
seeds: 1
jitter: {{scenarios.rig.drive.input.speed: 0.5 %, loads.brake.torque: 2 %}}
sample_rate: 25.6 kHz
length: 2 s
settle_time: 0.2 s
oversampling: 2
channels:
  vibration_input: {{type: observation, channel: "signal[acceleration_input]", noise: {{snr: 20}}}}
  vibration_output: {{type: observation, channel: "signal[acceleration_output]", noise: {{snr: 20}}}}
  tacho: {{type: tacho, body: input, pulses: 10}}
"""
Found = list[tuple[str, str, tuple[str, ...]]]


def found_in(file: Path, **options: object) -> Found:
    diagnosis = diagnose_file(Request(file=str(file), **options)).diagnosis  # type: ignore[arg-type]
    return [(finding.kind, finding.shaft, finding.gears) for finding in diagnosis.findings]


@pytest.fixture(scope="module")
def rig(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Found]:
    """Findings by fault."""
    folder = tmp_path_factory.mktemp("rig")
    plan = folder / "plan.yaml"
    plan.write_text(PLAN.format(model=EXAMPLES / "phm-2009-rig" / "model.yaml"), encoding="utf-8")
    assert run_command(["dataset", str(plan), "-o", str(folder / "data"), "-q"]) == 0
    table = folder / "data" / "index.csv"
    options = {"model": str(EXAMPLES / "phm-2009-rig" / "model.yaml"), "tacho": "tacho@input", "pulses": 10}
    with table.open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {row["fault"]: found_in(table.parent / row["file"], **options) for row in rows}


@pytest.mark.study
def test_the_healthy_rig_is_not_accused(rig: dict[str, Found]) -> None:
    assert rig["healthy"] == []


@pytest.mark.parametrize(
    ("fault", "expected"),
    [
        # 96 teeth are twice 48: the comb gathers about both meshes alike
        ("broken", ("local fault", "idler", ("z96", "z48"))),
        # both bearings of the shaft are alike
        ("spall", ("bearing", "outer ring", ("input_a or input_b",))),
    ],
)
def test_a_fault_of_the_rig_is_named(
    rig: dict[str, Found], fault: str, expected: tuple[str, str, tuple[str, ...]]
) -> None:
    assert rig[fault][:1] == [expected]


# 2220 Hz are 180 samples in a turn of the input: images of high mesh harmonics lie on its orders
@pytest.mark.parametrize(
    ("severity", "rate"),
    [
        pytest.param(0, "2152 Hz", marks=pytest.mark.study),
        (0, "2220 Hz"),
        pytest.param(1, "2152 Hz", marks=pytest.mark.study),
    ],
)
def test_the_shovel(tmp_path: Path, severity: int, rate: str) -> None:
    result = tmp_path / "run.h5"
    model = str(EXAMPLES / "shovel-gearbox" / "paper.yaml")
    changes = [f"gears.Z5.faults.broken.severity={severity}", f"scenarios.rated.sample_rate={rate}"]
    sets = [text for change in changes for text in ("--set", change)]
    assert run_command(["run", model, "--scenario", "rated", "-o", str(result), "-q", *sets]) == 0
    found = found_in(result)
    if not severity:
        assert found == []
        return
    ((kind, shaft, gears),) = found
    assert (kind, shaft) == ("local fault", "third or third_right")
    assert "Z5 or Z5_right" in gears


@pytest.mark.study
@pytest.mark.parametrize("severity", [0, 1])
def test_the_housing_of_the_elastic_shovel(tmp_path: Path, severity: int) -> None:
    """All orders of the third shaft stand out of the healthy housing: its 11 teeth strike, and unequally."""
    result = tmp_path / "run.h5"
    changes = [f"gears.Z5.faults.broken.severity={severity}", "scenarios.rated.sample_rate=5003.7 Hz"]
    sets = [text for change in changes for text in ("--set", change)]
    model = str(EXAMPLES / "shovel-gearbox" / "model.yaml")
    assert run_command(["run", model, "--scenario", "rated", "-o", str(result), "-q", *sets]) == 0
    diagnosis = diagnose_file(Request(file=str(result))).diagnosis
    named = [(finding.kind, finding.shaft, finding.channel) for finding in diagnosis.findings]
    combs = {e.channel for e in diagnosis.evidence if e.found and e.shaft == "third or third_right"}
    assert "signal[housing_x]" in combs
    assert named == [("local fault", "third or third_right", "signal[housing_z]")] * severity
