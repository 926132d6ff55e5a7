# SPDX-License-Identifier: Apache-2.0
"""Faults of teeth in model files: what is read, what is refused and at which line."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.write import plain
from pitchpoint.report.flanks import flank_lines
from pitchpoint.system.compile import compile_model

TEXT = """\
gears:
  a:
    number_of_teeth: 20
    normal_module: 3 mm
    face_width: 20 mm
    profile_shift_coefficient: 0
    faults:
      one: {{{fault}}}
  b: {{number_of_teeth: 60, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
bodies:
  shaft: {{gears: [a]}}
  wheel: {{gears: [b]}}
meshes:
  s: {{gears: [a, b], stiffness: {{{law}}}}}
"""
PAIRS = "law: din3990"


def model(fault, law=PAIRS):
    return loads_model(TEXT.format(fault=fault, law=law))


PATCH = "gears.a.faults.one.patches[0]."
PITS = (
    "type: pitting, tooth: 1, flank: left, patches: [{{{}, {}, length: {} mm, height: 1 mm, depth: 0.1 mm}}]"
)
WRONG = {
    "type: broken_tooth, tooth: 20": ("gears.a.faults.one.tooth", "limit <= 19"),
    "type: broken_tooth": ("gears.a.faults.one.tooth", "is missing"),
    "type: broken, tooth: 1": ("gears.a.faults.one.type", "did you mean broken_tooth"),
    "type: broken_tooth, tooth: 1, width: 21 mm": ("gears.a.faults.one.width", "limit 20 mm"),
    "type: broken_tooth, tooth: 1, height: 7 mm": ("gears.a.faults.one.height", "limit 6.75 mm"),
    "type: broken_tooth, tooth: 1, severity: 1.2": ("gears.a.faults.one.severity", "out of range"),
    "type: root_crack, tooth: 1, depth: 1 mm": ("gears.a.faults.one.flank", "is missing"),
    "type: root_crack, tooth: 1, flank: left, depth: 5 mm": (
        "gears.a.faults.one.depth",
        "beyond the centre line",
    ),
    "type: root_crack, tooth: 1, flank: left, depth: 1 mm, length: 30 mm": (
        "gears.a.faults.one.length",
        "20 mm",
    ),
    "type: root_crack, tooth: 1, flank: left, depth: 1 mm, angle: 0 deg": (
        "gears.a.faults.one.angle",
        "range",
    ),
    "type: pitting, tooth: 1, flank: left": ("gears.a.faults.one.patches", "is missing, and pattern too"),
    PITS.format("position: 21 mm", "diameter: 60 mm", 2): (PATCH + "position", "lies outside the face width"),
    PITS.format("position: 1 mm", "diameter: 50 mm", 2): (
        PATCH + "diameter",
        "lies outside the usable flank",
    ),
    PITS.format("position: 1 mm", "diameter: 60 mm", 0.3): (
        PATCH + "length",
        "limit 0.3125 mm, 1/64 of the face",
    ),
    "type: pitting, tooth: 1, flank: left, pattern: {number: 3, length: 2 mm, height: 0.1 mm, depth: 1 um}": (
        "gears.a.faults.one.pattern.height",
        "of the smallest random pit",
    ),
    "type: wear, flank: left": ("gears.a.faults.one.depth", "does not define the wear uniquely"),
    "type: wear, flank: left, depth: 9 um, cycles: 1e6": (
        "gears.a.faults.one.depth",
        "does not define the wear uniquely",
    ),
    "type: wear, flank: left, depth: 9": ("gears.a.faults.one.depth", "larger than the module"),
    "type: pitch_error, tooth: 1, amount: 5": ("gears.a.faults.one.amount", "larger than the module"),
}


@pytest.mark.parametrize("fault", WRONG)
def test_wrong_faults_are_told_with_their_line(fault):
    where, words = WRONG[fault]
    with pytest.raises(ModelError) as caught:
        model(fault)
    problem = caught.value.problems[0]
    assert problem.where == where
    assert words in str(problem)
    assert problem.line == 8


def test_a_law_of_the_whole_mesh_knows_no_teeth():
    with pytest.raises(
        ModelError, match=r"gears\.a\.faults\.one \(line 8\): has no effect in the mesh s, whose law"
    ):
        model("type: broken_tooth, tooth: 1", "law: constant, value: 4e8 N/m")


def test_faults_are_written_as_they_are_read():
    fault = "type: broken_tooth, tooth: 3, at: end, width: 5 mm, height: 2 mm, shape: corner, severity: 0.5"
    found = plain(model(fault))["gears"]["a"]["faults"]
    pairs = (pair.split(": ") for pair in fault.split(", "))
    assert found["one"] | {"tooth": "3", "severity": "0.5"} == dict(pairs)


def test_severity_can_be_swept():
    """The records keep their layout, so that `with_params` takes those of another severity."""
    healthy = model("type: broken_tooth, tooth: 3, severity: 0")
    worse = healthy.replace("gears.a.faults.one.severity", 0.4)
    assert worse.gears["a"].faults["one"].severity == 0.4
    systems = [compile_model(m) for m in (healthy, worse)]
    records = [s.records["gear_mesh"] for s in systems]
    assert records[0].dtype == records[1].dtype
    # a table for 20 teeth, one row for both flanks each of the one that is broken
    assert records[1]["n_t"][0].tolist() == [20, 1]


def test_only_faulty_teeth_have_grids():
    found = compile_model(model("type: broken_tooth, tooth: 3")).records["gear_mesh"][0]
    assert found["n_sep"] == 1
    assert found["slices"] == 0
    assert np.array_equal(found["n_sz"], [33, 33, 33, 33])


def test_reports_list_faults():
    lines = flank_lines(model("type: root_crack, tooth: 3, flank: left, depth: 1 mm, severity: 0.5"))
    assert lines == [("a", "left", "one: root crack", "severity 0.5", "tooth 3")]
    assert flank_lines(model("type: wear, flank: both, depth: 9 um"))[0][1::3] == (
        "left and right",
        "all teeth",
    )
