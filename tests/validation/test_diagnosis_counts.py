# SPDX-License-Identifier: Apache-2.0
"""How often `pitchpoint diagnose` is right about the rig of the PHM challenge, as docs/diagnosis.md counts.

160 records of 2 s at four to eight speeds and two loads, with a tacho of ten pulses in a turn. Each is
simulated once and gets five draws of white noise 20 dB below the signal: what one draw shows may be its luck.
Modulation counts as named: with eccentric gears it is what is observed, and nothing else may be modulated.
A record is wrong if any part is named that has no fault; as many may be as the rate of false alarms gives.
"""

from __future__ import annotations

import csv
from collections.abc import Iterator
from concurrent.futures import Executor, ProcessPoolExecutor
from functools import cache
from multiprocessing import get_context
from pathlib import Path

import numpy as np
import pytest
from scipy.stats import binom

from pitchpoint.analysis.diagnosis import diagnose
from pitchpoint.analysis.noise import with_white_noise
from pitchpoint.analysis.tacho import tacho_angle
from pitchpoint.analysis.turning_parts import TurningParts
from pitchpoint.cli.main import run_command
from pitchpoint.io.yaml_model import load_model
from pitchpoint.report.diagnosis.over_angle import over_angle
from pitchpoint.report.diagnosis.record import read_record
from pitchpoint.report.frequencies import turning_speeds
from pitchpoint.report.machine_parts import parts_of

pytestmark = pytest.mark.study

Named = set[tuple[str, frozenset[str]]]
"""Shaft or part with its gears or bearing, of all findings of a record."""

MODEL = Path(__file__).parents[2] / "examples" / "phm-2009-rig" / "model.yaml"
PLAN = """
title: rig
model: {model}
scenario: rig
factors:
  speed: {{scenarios.rig.drive.input.speed: [{speeds}]}}
  load:
    low: {{loads.brake.torque: -20 N m}}
    high: {{loads.brake.torque: -60 N m}}
  fault:
    {fault}: {{{keys}}}
seeds: {seeds}
jitter: {{scenarios.rig.drive.input.speed: 0.5 %, loads.brake.torque: 2 %}}
sample_rate: 25.6 kHz
length: 2 s
settle_time: 0.2 s
oversampling: 2
channels:
  vibration_input: {{type: observation, channel: "signal[acceleration_input]"}}
  vibration_output: {{type: observation, channel: "signal[acceleration_output]"}}
  tacho: {{type: tacho, body: input, pulses: 10}}
"""
DRAWS = range(1, 6)
"""Seeds of the noise. With 201 to 205, which no rule has seen, the counts were those of the page as well."""
NOISE, FALSE_ALARM = 20.0, 0.01
FAULTY = "30 Hz, 37.1 Hz, 43.7 Hz, 47 Hz"
HEALTHY = "30 Hz, 33.3 Hz, 37.1 Hz, 40 Hz, 43.7 Hz, 45 Hz, 47 Hz, 50 Hz"
BEARING = "rolling_bearings.input_a.faults"
TEETH_32, TEETH_IDLER, TEETH_80 = ("input", {"z32"}), ("idler", {"z48", "z96"}), ("output", {"z80"})
INPUT = {"input_a or input_b"}


@cache
def machine() -> TurningParts:
    """What turns, in turns of the input."""
    model = load_model(MODEL)
    return parts_of(model, turning_speeds(model, {"input": 1.0}), "input")[0]


@pytest.fixture(scope="module")
def workers() -> Iterator[Executor]:
    """A process for each core: most of the time goes into the diagnoses."""
    with ProcessPoolExecutor(mp_context=get_context("spawn")) as pool:
        yield pool


def findings(
    workers: Executor, folder: Path, fault: str, keys: str, speeds: str, seeds: int
) -> list[list[Named]]:
    """Findings of every draw of noise, by record."""
    plan = folder / "plan.yaml"
    plan.write_text(
        PLAN.format(model=MODEL, speeds=speeds, fault=fault, keys=keys, seeds=seeds), encoding="utf-8"
    )
    assert run_command(["dataset", str(plan), "-o", str(folder / "data"), "-q"]) == 0
    table = folder / "data" / "index.csv"
    with table.open(encoding="utf-8") as file:
        paths = [table.parent / row["file"] for row in csv.DictReader(file)]
    return list(workers.map(draws, paths))


def draws(path: Path) -> list[Named]:
    """Findings of one record with one draw of noise after the other."""
    record = read_record([str(path)])
    shaft = tacho_angle(record.channels["tacho"], record.time, pulses_per_revolution=10)
    held = slice(shaft.first_sample, shaft.first_sample + shaft.angle.size)
    clean = {name: values for name, values in record.channels.items() if name != "tacho"}
    named = []
    for draw in DRAWS:
        noisy = {
            name: with_white_noise(x, signal_to_noise=NOISE, seed=[draw, k]).values[held]
            for k, (name, x) in enumerate(clean.items())
        }
        over = over_angle(noisy, shaft.time, shaft.angle)
        found = diagnose(
            over.signals,
            over.samples_per_turn,
            machine(),
            false_alarm=FALSE_ALARM,
            sampled_per_turn=over.sampled_per_turn,
        )
        modulated = [one for one in found.observations if one.kind == "modulation"]
        named.append({(one.shaft, frozenset(one.gears)) for one in (*found.findings, *modulated)})
    return named


def most_by_chance(records: int) -> int:
    """More records than these are accused wrongly once in a hundred times."""
    return int(binom.isf(0.01, records, FALSE_ALARM))


def test_healthy_records_are_accused_by_chance_only(workers: Executor, tmp_path: Path) -> None:
    """Of 160, 1 % each, more than five would be accused once in a hundred times: none was."""
    records = findings(workers, tmp_path, "healthy", "", HEALTHY, 2)
    accused = [named for record in records for named in record if named]
    assert len(records) == 32 and all(len(record) == len(DRAWS) for record in records)
    assert len(accused) <= most_by_chance(160) == 5


@pytest.mark.parametrize(
    ("fault", "keys", "right", "least"),
    [
        ("chip", "gears.z32.faults.chip.severity: [0.5, 1]", TEETH_32, 15),
        ("crack", "gears.z32.faults.crack.severity: 1", TEETH_32, 8),
        ("broken", "gears.z48.faults.broken.severity: [0.15, 0.35]", TEETH_IDLER, 16),
        ("pitted", "gears.z48.faults.spall.severity: 1", TEETH_IDLER, 8),
        ("pitch", "gears.z80.faults.pitch.severity: 1", TEETH_80, 8),
        ("wear", "gears.z32.faults.wear.severity: 1", TEETH_32, 0),
        ("eccentric", "gears.z48.faults.bore.severity: [0.5, 1]", TEETH_IDLER, 12),
        ("outer", f"{BEARING}.outer.severity: 1", ("outer ring", INPUT), 7),
        ("inner", f"{BEARING}.inner.severity: 1", ("inner ring", INPUT), 8),
        ("ball", f"{BEARING}.ball.severity: 1", ("rolling element", INPUT), 7),
        ("cage", f"{BEARING}.cage.severity: 1", ("cage", INPUT), 0),
        ("loose", f"{BEARING}.loose.severity: 1", ("outer ring", INPUT), 2),
    ],
)
def test_what_is_named_has_the_fault(
    workers: Executor, tmp_path: Path, fault: str, keys: str, right: tuple[str, set[str]], least: int
) -> None:
    """`least` is how many of 8 (16 with two severities) were found with the worst of fifteen draws."""
    records = findings(workers, tmp_path, fault, keys, FAULTY, 1)
    per_draw = np.zeros(len(DRAWS))
    wrong = 0
    for record in records:
        for draw, named in enumerate(record):
            true = {(where, gears) for where, gears in named if where == right[0] and gears <= right[1]}
            per_draw[draw] += bool(true)
            wrong += bool(named - true)
    assert per_draw.min() >= least
    assert wrong <= most_by_chance(len(records) * len(DRAWS))


def test_two_faults_are_both_named(workers: Executor, tmp_path: Path) -> None:
    """An inner ring and a broken tooth."""
    keys = f"{BEARING}.inner.severity: 1, gears.z48.faults.broken.severity: 0.35"
    both = {("inner ring", frozenset(INPUT)), ("idler", frozenset(TEETH_IDLER[1]))}
    records = findings(workers, tmp_path, "both", keys, FAULTY, 1)
    every = [named for record in records for named in record]
    assert sum(named >= both for named in every) == len(every) == 8 * len(DRAWS)
    assert sum(bool(named - both) for named in every) <= most_by_chance(len(every))
