# SPDX-License-Identifier: Apache-2.0
"""Faults put into a model that has none, or others: by `replace`, on the command line, by plans."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.components.tooth_faults import BrokenTooth, PitchError

TEXT = """\
gears:
  a:
    number_of_teeth: 20
    normal_module: 3 mm
    face_width: 20 mm
    profile_shift_coefficient: 0
    faults: {old: {type: pitch_error, tooth: 1, amount: 3 um}}
  b: {number_of_teeth: 60, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  shaft: {gears: [a], inertia: 0.001 kg m^2, motion: torsion}
  wheel: {gears: [b], inertia: 0.1 kg m^2, motion: torsion}
meshes:
  s: {gears: [a, b], center_distance: 120.1 mm, damper: {ratio: 0.1}}
loads:
  motor: {body: shaft, torque: balance}
  brake: {body: wheel, torque: 100 N m}
scenarios:
  run: {speed: {shaft: 600 rpm}, duration: 2 ms, step: 5 us}
"""
BROKEN: dict[str, Any] = {"type": "broken_tooth", "tooth": 3, "width": "8 mm"}


@pytest.fixture(scope="module")
def model():
    return loads_model(TEXT)


def test_a_mapping_takes_the_place_of_a_fault_or_adds_one(model):
    """Of any type, under a label that is there or not, on a gear with or without faults."""
    other = model.replace("gears.a.faults.old", BROKEN)
    assert other.gears["a"].faults == {"old": BrokenTooth(tooth=3, width=8e-3)}
    more = model.replace("gears.a.faults.new", BROKEN)
    assert list(more.gears["a"].faults) == ["old", "new"]
    first = model.replace("gears.b.faults.new", BrokenTooth(tooth=59))
    assert first.gears["b"].faults["new"] == BrokenTooth(tooth=59)
    assert not model.gears["b"].faults
    assert not model.replace("gears.a.faults.old", None).gears["a"].faults


def test_a_new_fault_and_its_severity_at_once(model):
    both = model.replace_all({"gears.b.faults.new": BROKEN, "gears.b.faults.new.severity": 0.25})
    assert both.gears["b"].faults["new"].severity == 0.25


REFUSED = {
    "a label that is not there": (
        "gears.a.faults.nwe.severity",
        0.2,
        "does not exist; there are old; a new one",
    ),
    "no mapping": ("gears.a.faults.new", 3, "does not exist; there are old; a new one is a whole mapping"),
    "nothing to take away": ("gears.b.faults.new", None, "does not exist; there are none; a new one"),
    "no type": (
        "gears.a.faults.new",
        {"tooth": 3},
        "gears.a.faults.new.type: is missing; types are broken_tooth",
    ),
    "no such tooth": (
        "gears.a.faults.new",
        BROKEN | {"tooth": 20},
        "faults.new.tooth: 20 is not a tooth of this gear",
    ),
    "unknown key": (
        "gears.a.faults.new",
        BROKEN | {"widht": 1},
        "faults.new.widht: is an unknown key; did you mean width",
    ),
    "the type alone": (
        "gears.a.faults.old.type",
        "wear",
        "cannot change alone; replace the whole mapping gears.a.faults.old",
    ),
    "no name": ("gears.a.faults.", BROKEN, "is not a usable name"),
    "another component": ("gears.a.faults.new", PitchError, "does not exist"),
    "a section": ("gears.c", {"number_of_teeth": 20}, "gears.c: does not exist; there are a, b"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_no_fault_is_told(model, case):
    path, value, words = REFUSED[case]
    with pytest.raises(ModelError) as caught:
        model.replace(path, value)
    assert words in str(caught.value)


def test_bearings_take_new_faults_too():
    text = (
        "bodies: {rotor: {motion: planar, position: [0, 0, 0], mass: 2 kg, inertia: 0.01 kg m^2}}\n"
        "rolling_bearings:\n"
        "  front: {ends: [rotor, ground], elements: 9, element_diameter: 7.94 mm, pitch_diameter: 39.04 mm, "
        "grooves: [0.52, 0.52], damping: 5}\n"
    )
    pit = {"type": "outer_race", "length": "1 mm", "depth": "0.1 mm"}
    found = loads_model(text).replace("rolling_bearings.front.faults.pit", pit)
    assert found.rolling_bearings["front"].faults["pit"].length == 1e-3


def test_a_run_sets_a_whole_fault(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "pair.yaml"
    file.write_text(TEXT, encoding="utf-8")
    fault = "gears.b.faults.chip={type: broken_tooth, tooth: 0, width: 8 mm, severity: 0.5}"
    command = ["run", str(file), "-s", "run", "-o", str(tmp_path / "out.h5"), "--quiet", "--set"]
    assert run_command([*command, fault]) == 0
    assert run_command([*command, "gears.b.faults.chip={type: broken_tooth, tooth: 60}"]) == 2
    assert "gears.b.faults.chip.tooth (--set): 60 is not a tooth of this gear" in capsys.readouterr().err


PLAN = """\
title: one fault or another
model: pair.yaml
factors:
  condition:
    healthy: {gears.a.faults.old.severity: 0}
    chipped: {gears.a.faults.old: {type: broken_tooth, tooth: 0, width: 8 mm}}
    cracked: {gears.b.faults.crack: {type: root_crack, tooth: 0, flank: left, depth: 2 mm}}
sample_rate: 10 kHz
length: 1 ms
channels:
  force: {type: observation, channel: "mesh_force[s]"}
"""


def test_a_plan_puts_faults_in(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "pair.yaml").write_text(TEXT, encoding="utf-8")
    (tmp_path / "plan.yaml").write_text(PLAN, encoding="utf-8")
    out = tmp_path / "set"
    assert run_command(["dataset", str(tmp_path / "plan.yaml"), "-o", str(out), "--quiet"]) == 0
    with (out / "index.csv").open(encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert [(row["condition"], row["status"]) for row in rows] == [
        ("healthy", "finished"),
        ("chipped", "finished"),
        ("cracked", "finished"),
    ]
    assert len({row["file"] for row in rows}) == 3
    wrong = PLAN.replace("tooth: 0, width: 8 mm", "tooth: 20, width: 8 mm")
    (tmp_path / "plan.yaml").write_text(wrong, encoding="utf-8")
    capsys.readouterr()
    assert run_command(["dataset", str(tmp_path / "plan.yaml"), "-o", str(out), "--quiet"]) == 2
    assert "(line 6): is rejected: gears.a.faults.old.tooth: 20 is not a tooth" in capsys.readouterr().err


WRONG = """\
      one: {type: broken_tooth, tooth: 33, height: 7 mm}
      two: {type: root_crack, tooth: 1, flank: left, depth: 5 mm}
      three: {type: broken, tooth: 1}
      four: {type: wear, flank: up, depth: 1 um}
      five: {type: eccentricity, amount: 5}
      six: {type: pitch_error, tooth: 1, amount: 3 um, severity: 2}
      seven: {type: pitting, tooth: 25, flank: left}
"""


def test_all_wrong_faults_of_a_gear_are_told_at_once():
    """Those that cannot be read, and those that this gear cannot have, with their lines."""
    text = TEXT.replace(
        "    faults: {old: {type: pitch_error, tooth: 1, amount: 3 um}}\n", "    faults:\n" + WRONG
    )
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    told = [(p.where.removeprefix("gears.a.faults."), p.line) for p in caught.value.problems]
    assert told == [
        ("one.tooth", 8),
        ("one.height", 8),
        ("two.depth", 9),
        ("three.type", 10),
        ("four.flank", 11),
        ("five.amount", 12),
        ("six.severity", 13),
        ("seven.tooth", 14),
        ("seven.patches", 14),
    ]
