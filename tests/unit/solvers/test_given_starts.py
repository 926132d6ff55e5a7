# SPDX-License-Identifier: Apache-2.0
"""Start values of joints in a closed loop: a run begins with them, or says where it begins and why."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.model.remarks.keys_without_effect import keys_without_effect
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.system.compile import compile_model
from tests.support.mechanism_files import SLIDER_CRANK

CRANK, ROD = 0.1, 0.3
START = math.radians(30.0)
MAIN = "main: {type: revolute, bodies: [ground, crank], position: [0, 0, 0]"
GIVEN = SLIDER_CRANK.replace(MAIN, f"{MAIN}, start: {{spin: 30 deg}}")
LINE = 1 + GIVEN[: GIVEN.index("  main:")].count("\n")
PIN = "crank_pin: {type: revolute, bodies: [crank.pin, rod.big]"
TIMES = "duration: 1 ms, step: 0.1 ms, settle_time: 0 s"


def travel(angle: float) -> float:
    """Way of the piston from where the crank points at it [m]."""
    return CRANK * math.cos(angle) + math.sqrt(ROD**2 - (CRANK * math.sin(angle)) ** 2) - CRANK - ROD


def begun(scenario: str, text: str = GIVEN, gravity: bool = True):
    """Coordinates at the start, rates and notes."""
    head = "gravity: [0, -9.81 m/s^2, 0]\n" if gravity else ""
    model = loads_model(f"{head}{text}scenarios:\n  s: {{{scenario}{TIMES}}}\n")
    system = compile_model(model, "s")
    start = prepare_start(system, model.scenarios["s"])
    names = system.layout.coordinates
    return (
        dict(zip(names, start.state.q, strict=True)),
        dict(zip(names, start.state.v, strict=True)),
        start.notes,
    )


@pytest.mark.parametrize(
    "scenario",
    [
        "drive: {crank: {speed: 300 rpm}}, ",
        "drive: {main.spin: {speed: {table: [[0 s, 300 rpm], [1 s, 0 rpm]]}}}, ",
        "speed: {crank: 300 rpm}, hold: [crank], ",
        "speed: {crank: 300 rpm}, start: assembled, ",
    ],
)
def test_what_turns_begins_where_its_joint_says(scenario: str) -> None:
    """A speed goes on from the start value: angles in closed form, closed loops to 1e-12."""
    q, v, notes = begun(scenario)
    assert q["crank.spin"] == pytest.approx(START, abs=1e-12)
    assert q["piston.z"] == pytest.approx(travel(START), abs=1e-12)
    assert v["crank.spin"] == pytest.approx(10.0 * math.pi, rel=1e-12)
    assert not [note for note in notes if note.startswith("joints.")]


def test_without_loads_the_start_is_an_equilibrium() -> None:
    """Nothing pushes, so nothing moves away from what is given; the loop is closed around it."""
    q, _, notes = begun("", gravity=False)
    assert q["crank.spin"] == pytest.approx(START, abs=1e-12)
    assert q["piston.z"] == pytest.approx(travel(START), abs=1e-12)
    assert notes == ()


def test_loads_that_move_a_start_are_told() -> None:
    """Under gravity the crank hangs down at rest, and the note says so with the line of the joint.

    Masses times heights: 1 kg (40 mm sin + 5 mm cos) of the crank and 0.8 kg (100 - 120/3) mm sin of the rod.
    """
    q, _, notes = begun("")
    assert q["crank.spin"] == pytest.approx(math.atan2(-0.04 - 0.8 * 0.06, -0.005), abs=1e-6)
    (note,) = [note for note in notes if note.startswith("joints.")]
    assert note.startswith(f"joints.main.start (line {LINE + 1}): spin starts at -93.25 deg, not at 30 deg: ")
    assert "start: assembled" in note


def test_loops_that_move_a_start_are_told() -> None:
    """The driven crank leaves the rod one place, whatever its joint gives."""
    text = SLIDER_CRANK.replace(PIN, f"{PIN}, start: {{spin: 30 deg}}")
    q, _, notes = begun("drive: {crank: {speed: 300 rpm}}, ", text)
    assert q["rod.spin"] == pytest.approx(0.0, abs=1e-9)
    (note,) = [note for note in notes if note.startswith("joints.crank_pin.start")]
    assert "spin starts at 0 deg, not at 30 deg" in note


@pytest.mark.filterwarnings("default::pitchpoint.core.errors.ValidityWarning")
def test_a_drive_that_gives_the_angle_decides(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Check and run say that start and speed of the joint have no effect, with its line, once."""
    text = GIVEN.replace("{spin: 30 deg}", "{spin: 30 deg}, speed: {spin: 5 rpm}")
    scenario = "drive: {crank: {angle: '10 deg + 300 rpm*t'}}, "
    file = tmp_path / "crank.yaml"
    file.write_text(f"{text}scenarios:\n  s: {{{scenario}{TIMES}}}\n", encoding="utf-8")
    for command in ("check", "run"):
        assert run_command([command, str(file)]) == 0
        shown = capsys.readouterr()
        said = " ".join((shown.out + shown.err).split())
        for key in ("start", "speed"):
            words = "spin has no effect in s, where the drive of crank determines it"
            told = f"joints.main.{key} (line {LINE}): {words}"
            assert said.count(told) == 1
            assert said.count(f"joints.main.{key}") == 1
    assert len(keys_without_effect(load_model(file))) == 2


def test_a_hanging_body_without_a_loop() -> None:
    """A weight on a spring settles; its start is told too, and holds with start: assembled."""
    text = """\
gravity: [0, 0, -10 m/s^2]
bodies:
  weight: {mass: 2 kg, markers: {eye: {}}}
  post: {motion: fixed, position: [0, 0, 1], markers: {eye: {}}}
joints:
  slide: {type: prismatic, bodies: [ground, weight], position: [0, 0, 0], start: {z: -50 mm}}
springs: {spring: {ends: [weight.eye, post.eye], stiffness: 1e3 N/m}}
"""
    q, _, notes = begun("", text, gravity=False)
    assert q["weight.z"] == pytest.approx(-0.02, abs=1e-9)  # m g / k
    assert notes[0].startswith(
        "joints.slide.start (line 6): z starts at -20 mm, not at -50 mm: it follows from loads"
    )
    q, _, notes = begun("start: assembled, ", text, gravity=False)
    assert q["weight.z"] == -0.05
    assert notes == ()
