# SPDX-License-Identifier: Apache-2.0
"""What `pitchpoint diagnose` says about simulated machines whose state is known: nothing about healthy ones.

Both examples, through the files that a user has. Bearings of healthy machines shake as often as balls pass,
meshes change each other, and records of simulations have no filter: none of that is damage. More speeds,
loads, seeds and faults of the rig are in `test_diagnosis_counts`.
"""

from __future__ import annotations

import csv
import re
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
  fault: {{{fault}}}
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
FAULTS = {
    "healthy": "{}",
    "broken": "{gears.z48.faults.broken.severity: 0.4}",
    "spall": "{rolling_bearings.input_a.faults.outer.severity: 1}",
}
Found = list[tuple[str, str, tuple[str, ...]]]


def found_in(file: Path, **options: object) -> Found:
    diagnosis = diagnose_file(Request(file=str(file), **options)).diagnosis  # type: ignore[arg-type]
    return [(finding.kind, finding.shaft, finding.gears) for finding in diagnosis.findings]


def rig(folder: Path, fault: str) -> Found:
    """Findings in a record of the rig."""
    plan = folder / "plan.yaml"
    text = PLAN.format(model=EXAMPLES / "phm-2009-rig" / "model.yaml", fault=f"{fault}: {FAULTS[fault]}")
    plan.write_text(text, encoding="utf-8")
    assert run_command(["dataset", str(plan), "-o", str(folder / "data"), "-q"]) == 0
    table = folder / "data" / "index.csv"
    options = {"model": str(EXAMPLES / "phm-2009-rig" / "model.yaml"), "tacho": "tacho@input", "pulses": 10}
    with table.open(encoding="utf-8") as file:
        (row,) = csv.DictReader(file)
    assert row["fault"] == fault
    return found_in(table.parent / row["file"], **options)


@pytest.mark.study
def test_the_healthy_rig_is_not_accused(tmp_path: Path) -> None:
    assert rig(tmp_path, "healthy") == []


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
    tmp_path: Path, fault: str, expected: tuple[str, str, tuple[str, ...]]
) -> None:
    assert rig(tmp_path, fault)[:1] == [expected]


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


WIDTHS = {"Z1": 65, "Z2": 60, "Z3": 105, "Z4": 100, "Z5": 140, "Z6": 135}
"""Half of the face widths [mm], as of the tooth of Z5 in the example."""
GEARS_OF = {"input": {"Z1"}, "second": {"Z2", "Z3"}, "third": {"Z4", "Z5"}}


@pytest.mark.study
def test_which_gear_of_the_shovel_is_named(tmp_path: Path) -> None:
    """A broken tooth of every gear, also of the side without sensors, through the default channels.

    A gear is named alone only if it has the fault; Z6 has 1.4 turns, too few. The page has these counts.
    """
    text = (EXAMPLES / "shovel-gearbox" / "paper.yaml").read_text(encoding="utf-8")
    text = re.sub(r"density: 7850 kg/m\^3\},\n    faults: .*\}\}\}", "density: 7850 kg/m^3}}", text)
    for gear, width in WIDTHS.items():
        fault = f"{{type: broken_tooth, tooth: 0, at: end, width: {width} mm, shape: straight, severity: 0}}"
        text = re.sub(rf"^(  {gear}(_right)?: \{{)", rf"\1faults: {{broken: {fault}}}, ", text, flags=re.M)
    model, result = tmp_path / "shovel.yaml", tmp_path / "run.h5"
    model.write_text(text, encoding="utf-8")
    cases = [(gear, severity) for gear in WIDTHS for severity in (0.2, 0.5, 1.0)]
    cases += [("Z2_right", 1.0), ("Z3_right", 0.5), ("Z3_right", 1.0), ("Z5_right", 1.0)]
    alone, found = {}, 0
    for gear, severity in cases:
        sets = [f"gears.{gear}.faults.broken.severity={severity}", "scenarios.rated.duration=18 s"]
        options = [word for one in sets for word in ("--set", one)]
        run = ["run", str(model), "--scenario", "rated", "-o", str(result), "-q", *options]
        result.unlink(missing_ok=True)
        assert run_command(run) == 0
        named = found_in(result)
        if gear == "Z6":
            assert named == []
            continue
        ((kind, shaft, gears),) = named
        single, own = {one.split(" or ")[0] for one in gears}, gear.removesuffix("_right")
        assert kind == "local fault" and own in single <= GEARS_OF[shaft.split(" or ")[0]]
        found += 1
        alone[gear, severity] = single == {own}
    assert found == 19
    of_the_coarse = [one for (gear, _), one in alone.items() if gear[:2] in ("Z3", "Z5")]
    assert sum(of_the_coarse) == 8 and len(of_the_coarse) == 9
    assert not any(one for (gear, _), one in alone.items() if gear[:2] in ("Z2", "Z4"))
