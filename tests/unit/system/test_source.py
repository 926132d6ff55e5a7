# SPDX-License-Identifier: Apache-2.0
"""Failed computations name component and line of the file: loops, rates, elements of every kind."""

from __future__ import annotations

import pytest

from pitchpoint.core.errors import SolverError
from pitchpoint.core.provenance import content_hash
from pitchpoint.core.status import NOT_FINITE
from pitchpoint.elements.registry import find, names
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.model import Model
from pitchpoint.model.sections import GROUPS
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system.compile import compile_model
from pitchpoint.system.source import source
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
NO_COMPONENT = {"damping", "drive", "gravity", "housing_matrix", "linear_hold", "linear_modes", "linear_part"}
"""Kinds that are keys of the whole file, of a scenario or of no file at all."""


def begin(text):
    """Start of the scenario of a text."""
    model = loads_model(f"{text}scenarios:\n  run: {{start: assembled, duration: 1 s}}\n")
    return prepare_start(compile_model(model, "run"), model.scenarios["run"])


def test_every_kind_is_found_in_its_section():
    own = {name: find(name) for name in names() if find(name).module.startswith("pitchpoint.")}
    assert {name for name, kind in own.items() if not kind.sections} == NO_COMPONENT
    assert {section for kind in own.values() for section in kind.sections} <= set(GROUPS)


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


@pytest.mark.parametrize("method", ["kinematics", "generalized_alpha", "gstiff"])
def test_a_drive_that_ends_names_its_scenario_and_line(method):
    law = '"1 rad * log(0.02 - t/(1 s))"'
    text = "bodies: {a: {motion: torsion, inertia: 0.1 kg m^2}}\nscenarios:\n"
    text += f"  go: {{method: {method}, duration: 1 s, step: 1 ms, drive: {{a: {{angle: {law}}}}}}}\n"
    model = loads_model(text)
    done = run_time(compile_model(model, "go"), sink=Memory())
    assert done.status == NOT_FINITE
    assert done.sentence.startswith("scenarios.go.drive.a (line 3): ")
    assert 0.0 < done.t_end < 0.02


def test_a_moved_frame_that_ends_names_its_joint_and_line():
    text = """\
bodies:
  base: {mass: 1 kg}
  arm: {mass: 1 kg, inertia_tensor: [1e-3, 1e-3, 1e-3, 0, 0, 0]}
joints:
  shake: {type: moved, bodies: [ground, base], motion: {x: "1 m * sqrt(0.02 - t/(1 s))"}}
  pin: {type: revolute, bodies: [base, arm], position: [0, 0, 0]}
scenarios: {go: {start: assembled, duration: 1 s, step: 1 ms}}
"""
    done = run_time(compile_model(loads_model(text), "go"), sink=Memory())
    assert done.status == NOT_FINITE
    assert done.sentence.startswith("joints.shake.x (line 5): ")


@pytest.mark.parametrize("start", ["equilibrium", "assembled"])
def test_speeds_that_joints_give_hold_in_loops_at_rest(start):
    text = """\
bodies:
  crank: {mass: 1 kg, inertia: 0.01 kg m^2, position: [0, 0, 0], markers: {e: {position: [100 mm, 0, 0]}}}
  slider: {mass: 20 kg, inertia_tensor: [0.01, 0.01, 0.01, 0, 0, 0], position: [100 mm, 300 mm, 0]}
joints:
  pin: {type: revolute, bodies: [ground, crank], position: [0, 0, 0], speed: {spin: 10 rad/s}}
  guide: {type: prismatic, bodies: [ground, slider], position: [100 mm, 300 mm, 0], axes: {z: [0, 1, 0]}}
rods: {rod: {ends: [crank.e, slider]}}
"""
    model = loads_model(f"{text}scenarios: {{go: {{start: {start}, duration: 1 ms}}}}\n")
    system = compile_model(model, "go")
    found = prepare_start(system, model.scenarios["go"]).state
    assert found.v[system.layout.coordinate("crank.spin")] == pytest.approx(10.0, rel=1e-12)
    assert abs(found.v[system.layout.coordinate("slider.z")]) == pytest.approx(1.0, rel=1e-9)
