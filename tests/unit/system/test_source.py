# SPDX-License-Identifier: Apache-2.0
"""Failed computations name component and line of the file: loops, rates, elements of every kind."""

from __future__ import annotations

import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.core.provenance import content_hash
from pitchpoint.elements.registry import find, names
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.model import GROUPS, Model
from pitchpoint.solvers.start import prepare_start
from pitchpoint.system.compile import compile_model
from pitchpoint.system.source import SECTIONS, source
from tests.support.mechanism_files import SLIDER_CRANK, system_of

ARM = "{mass: 1 kg, inertia_tensor: [1e-3, 1e-3, 1e-3, 0, 0, 0], markers: {pin: {position: %s}}}"
FOUR_BAR = f"""\
bodies:
  crank: {ARM % "[0.1, 0, 0]"}
  rod: {ARM % "[0.3, 0, 0]"}
  rocker: {ARM % "[0, 0.15, 0]"}
joints:
  main:
    type: revolute
    bodies: [ground, crank]
    position: [0, 0, 0]
    start: {{spin: 180 deg}}
  crank_pin:
    {{type: revolute, bodies: [crank.pin, rod], position: [0.1, 0, 0]}}
  rocker_pin: {{type: revolute, bodies: [ground, rocker], position: [0.4, -0.15, 0]}}
  end_pin: {{type: revolute, bodies: [rod.pin, rocker.pin]}}
"""
NO_COMPONENT = {"damping", "drive", "gravity", "linear_hold", "linear_modes", "linear_part"}
"""Kinds that are keys of the whole file, of a scenario or of no file at all."""


def begin(text):
    """Start of the scenario of a text."""
    model = loads_model(f"{text}scenarios:\n  run: {{start: assembled, duration: 1 s}}\n")
    return prepare_start(compile_model(model, "run"), model.scenarios["run"])


def test_every_kind_is_found_in_its_section():
    own = {name for name in names() if find(name).module.startswith("pitchpoint.")}
    assert set(SECTIONS) == own - NO_COMPONENT
    assert {s for sections in SECTIONS.values() for s in sections} <= set(GROUPS)


def test_a_loop_that_cannot_close_names_its_joint_and_line():
    # the crank pin lies 500 mm across and 150 mm up from the pivot of the rocker: rod and rocker leave 72 mm
    with pytest.raises(SolverError, match=r"joints\.end_pin\.x \(line 14\) is off by 0\.072 m at best"):
        begin(FOUR_BAR)


def test_rates_that_contradict_name_the_joint_and_line():
    text = SLIDER_CRANK.replace("position: [0, 0, 0]}", "position: [0, 0, 0], speed: {spin: 9 rad/s}}")
    text = text.replace("axes: {z: [1, 0, 0]}", "axes: {z: [1, 0, 0]}, speed: {z: 5 m/s}")
    with pytest.raises(
        SolverError, match=r"joints\.piston_pin\.x \(line 17\) would move apart at 5 m per second"
    ):
        begin(text)


def test_without_a_model_it_is_kind_and_name():
    _, system = system_of({"bodies": {"a": {"motion": "torsion", "inertia": 1.0}}})
    assert source(system, "spring_damper", "s") == "spring damper 's'"


def test_a_changed_model_keeps_its_lines():
    model = loads_model("bodies:\n  a: {motion: torsion, inertia: 1 kg m^2}\n")
    assert model.replace("bodies.a.inertia", 2.0).line(("bodies", "a")) == 2
    assert Model(bodies=model.bodies).line(("bodies", "a")) is None


def test_lines_and_folders_do_not_change_the_hash_of_a_model(tmp_path):
    text = "bodies:\n  a: {motion: torsion, inertia: 1 kg m^2}\n"
    plain = content_hash(loads_model(text))
    assert content_hash(loads_model(f"# a remark\n{text}", file=str(tmp_path / "m.yaml"))) == plain
    assert content_hash(loads_model(text.replace("1 kg", "2 kg"))) != plain
