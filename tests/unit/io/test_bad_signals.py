# SPDX-License-Identifier: Apache-2.0
"""Wrong signals: every fault is told with its line, what is wrong and what to do, and nothing else is."""

from __future__ import annotations

from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.system.compile import compile_model

DRIVE = """\
bodies:
  motor: {motion: torsion, inertia: 1 kg m^2, position: [0, 0, 0]}
  drum: {motion: torsion, inertia: 2 kg m^2, position: [0, 0, 1]}
  cross: {motion: torsion, inertia: 1 kg m^2, position: [0, 1, 0], axes: {z: [1, 0, 0]}}
  shaft: {motion: free, inertia: 1 kg m^2, mass: 1 kg, transverse_inertia: 1 kg m^2, position: [1, 0, 0]}
torsion_springs:
  link: {bodies: [motor, drum], stiffness: 100 N m/rad}
bearings:
  seat: {body: shaft, stiffness: {radial: 1e6, axial: 1e6, tilt: 1e3}}
sensors:
  speed: {type: joint, coordinate: motor, derivative: 1}
  turn: {type: joint, coordinate: motor}
blocks:
  error: {type: sum, inputs: {speed: -1}, offset: 100 rad/s}
  u: {type: pid, input: error, proportional: 2, integral: 3, limits: [-5, 5]}
controllers:
  loop: {type: python, function: 'laws.py:loop', inputs: [error], outputs: [extra], period: 1 ms}
actuators:
  drive: {type: torque, signal: u, bodies: [motor]}
  trim: {type: torque, signal: extra, bodies: [drum, motor]}
scenarios:
  run: {speed: {motor: 100 rad/s}, duration: 20 ms, step: 0.1 ms, settle_time: 0 s}
"""
LAWS = "def loop(t, inputs, state, parameters):\n    return 0.0\n\n\ndef law(t, x, p):\n    return x\n"
LAWS += "\n\ndef scaled(t, x, p):\n    return p[0] + p[1] * x\n"
LOOP = "'laws.py:loop'"


def sensor(text: str) -> tuple[str, str]:
    return "sensors:\n", f"sensors:\n  more: {text}\n"


def block(text: str) -> tuple[str, str]:
    return "blocks:\n", f"blocks:\n  more: {text}\n"


def actuator(text: str) -> tuple[str, str]:
    return "actuators:\n", f"actuators:\n  more: {text}\n"


def controller(text: str) -> tuple[str, str]:
    return "controllers:\n", f"controllers:\n  more: {text}\n"


# (changes of the drive, place, words that the sentence must hold)
CASES: dict[str, tuple[list[tuple[str, str]], str, str]] = {
    "no type": ([("{type: sum, ", "{")], "blocks.error.type", "types are sum, limits, table"),
    "unknown type": ([("{type: sum,", "{type: sun,")], "blocks.error.type", "did you mean sum?"),
    "no mapping": ([block("5")], "blocks.more", "write {type: sum}; types are"),
    "unknown key": ([("integral: 3,", "integrall: 3,")], "blocks.u.integrall", "did you mean integral?"),
    "unknown signal": ([("{speed: -1}", "{sped: -1}")], "blocks.error.inputs.sped", "did you mean speed?"),
    "unknown input": ([("input: error,", "input: eror,")], "blocks.u.input", "did you mean error?"),
    "unknown input of a controller": (
        [("inputs: [error]", "inputs: [speed, errr]")],
        "controllers.loop.inputs[1]",
        "does not exist",
    ),
    "unknown signal of an actuator": ([("signal: u,", "signal: v,")], "actuators.drive.signal", "there are"),
    "an actuator as input": (
        [("input: error,", "input: drive,")],
        "blocks.u.input",
        "is an actuator; name the signal that it follows, u",
    ),
    "time is no input of a sum": ([("{speed: -1}", "{t: -1}")], "blocks.error.inputs.t", "does not exist"),
    "a signal called t": ([("  turn: {", "  t: {")], "sensors.t", "is the name of the time"),
    "a name twice": (
        [("  error: {", "  turn: {"), ("input: error", "input: turn"), ("[error]", "[turn]")],
        "blocks.turn",
        "sensors.turn defines signal[turn]",
    ),
    "an output twice": ([("[extra]", "[extra, extra]")], "controllers.loop.outputs[1]", "is already used"),
    "an actuator with the name of a signal": ([("  drive: {", "  u: {")], "actuators.u", "is already used"),
    "an output with a dot": (
        [("[extra]", "[ex.tra]"), ("signal: extra", "signal: u")],
        "controllers.loop.ex.tra",
        "is not a usable name",
    ),
    "a loop": ([("{speed: -1}", "{speed: -1, u: 1}")], "blocks.error", "error <- u <- error"),
    "a loop over a transfer function": (
        [
            ("{speed: -1}", "{speed: -1, more: 1}"),
            block("{type: transfer_function, input: u, numerator: [1, 2], denominator: [3, 4]}"),
        ],
        "blocks.more",
        "is part of an algebraic loop: more <- u <- error <- more",
    ),
    "a loop over a load": (
        [sensor("{type: load, at: drum, quantity: moment}"), ("{speed: -1}", "{speed: -1, more: 1}")],
        "actuators.drive",
        "drive <- u <- error <- more <- drive",
    ),
    "unknown body": (
        [sensor("{type: frames, quantity: angle, ends: [moter, ground]}")],
        "sensors.more.ends[0]",
        "did you mean motor?",
    ),
    "unknown marker": (
        [sensor("{type: frames, quantity: angle, ends: [motor.tip, ground]}")],
        "sensors.more.ends[0]",
        "motor has no markers",
    ),
    "unknown quantity": (
        [sensor("{type: frames, quantity: speed, ends: [motor, ground]}")],
        "sensors.more.quantity",
        "allowed are position, velocity",
    ),
    "one body": (
        [sensor("{type: frames, quantity: angle, ends: [motor, motor]}")],
        "sensors.more.ends",
        "are on the same body",
    ),
    "unknown coordinate": (
        [sensor("{type: joint, coordinate: axle.spin}")],
        "sensors.more.coordinate",
        "names the joint 'axle', which does not exist",
    ),
    "a turn among others": (
        [sensor("{type: joint, coordinate: shaft, derivative: 1}")],
        "sensors.more.coordinate",
        "write {type: frames, quantity: angular_velocity, ends: [shaft, ground]}",
    ),
    "third derivative": (
        [("derivative: 1", "derivative: 3")],
        "sensors.speed.derivative",
        "limit >= 0 and <=",
    ),
    "load of nothing": (
        [sensor("{type: load, at: shaft}")],
        "sensors.more.at",
        "which has no joint reaction",
    ),
    "load of ground": ([sensor("{type: load, at: ground}")], "sensors.more.at", "which no joint carries"),
    "unknown observation": (
        [sensor("{type: observation, channel: 'tensin[link]'}")],
        "sensors.more.channel",
        "did you mean tension?",
    ),
    "observation of nothing": (
        [sensor("{type: observation, channel: 'torque[lnk]'}")],
        "sensors.more.channel",
        "did you mean link?",
    ),
    "no observation": (
        [sensor("{type: observation, channel: torque}")],
        "sensors.more.channel",
        "not an obs",
    ),
    "a signal heard": (
        [sensor("{type: observation, channel: 'signal[speed]'}")],
        "sensors.more.channel",
        "use the signal by its name",
    ),
    "limits the wrong way": ([("[-5, 5]", "[5, -5]")], "blocks.u.limits", "5 to -5 are not increasing"),
    "one limit": ([("[-5, 5]", "[5]")], "blocks.u.limits", "limit 2 entries"),
    "no number": ([("proportional: 2", "proportional: two")], "blocks.u.proportional", "such as 1500 rpm"),
    "NaN": ([("proportional: 2", "proportional: .nan")], "blocks.u.proportional", "not a finite number"),
    "unit that is none": ([("100 rad/s", "100 rod/s")], "blocks.error.offset", "cannot be read"),
    "gains in a list": ([("{speed: -1}", "[speed]")], "blocks.error.inputs", "write {speed: -1}"),
    "no gain": ([("{speed: -1}", "{speed: }")], "blocks.error.inputs.speed", "is empty"),
    "derivative without filter": (
        [("integral: 3,", "integral: 3, derivative: 1,")],
        "blocks.u.filter_time",
        "required for the derivative part",
    ),
    "no tracking time": (
        [("integral: 3,", "integral: -3,")],
        "blocks.u.tracking_time",
        "proportional over integral is not positive",
    ),
    "formula that cannot be read": (
        [block("{type: formula, formula: 2 * (turn, inputs: [turn]}")],
        "blocks.more.formula",
        "cannot be read as a formula",
    ),
    "formula of something else": (
        [block("{type: formula, formula: 2 * spin, inputs: [turn]}")],
        "blocks.more.formula",
        "unknown name 'spin'",
    ),
    "input that a formula leaves out": (
        [block("{type: formula, formula: 2 * turn, inputs: [turn, t]}")],
        "blocks.more.inputs[1]",
        "is not in the formula",
    ),
    "input that no formula can use": (
        [("  turn: {", "  tu-rn: {"), block("{type: formula, formula: 2, inputs: [tu-rn]}")],
        "blocks.more.inputs[0]",
        "not a name that a formula can use",
    ),
    "points that fall": (
        [block("{type: table, input: turn, points: [[0, 1], [0, 2]]}")],
        "blocks.more.points[1]",
        "larger in input",
    ),
    "points of three": (
        [block("{type: table, input: turn, points: [[0, 1], [1, 2, 3]]}")],
        "blocks.more.points[1]",
        "is not a row of two values",
    ),
    "no file of points": (
        [block("{type: table, input: turn, points: map.csv}")],
        "blocks.more.points",
        "there is no file 'map.csv'",
    ),
    "differentiating": (
        [block("{type: transfer_function, input: turn, numerator: [1, 0], denominator: [1]}")],
        "blocks.more.denominator",
        "has 1 entry (limit at least 2 entries)",
    ),
    "order": (
        [block("{type: transfer_function, input: turn, numerator: [1, 0, 0], denominator: [1, 2]}")],
        "blocks.more.numerator",
        "order 2 is of higher order",
    ),
    "leading zero": (
        [block("{type: transfer_function, input: turn, numerator: [1], denominator: [0, 2]}")],
        "blocks.more.denominator[0]",
        "remove leading zeros",
    ),
    "no time constant": (
        [block("{type: filter, input: turn, time_constant: 0 s}")],
        "blocks.more.time_constant",
        "limit > 0",
    ),
    "too many inputs of a formula": (
        [block("{type: formula, formula: speed + turn + error + u, inputs: [speed, turn, error, u]}")],
        "blocks.more.inputs",
        "has 4 entries (limit at most 3 entries)",
    ),
    "a mapping of inputs": (
        [block("{type: formula, formula: a + b + c + d, inputs: {a: speed, b: turn, c: error, d: u}}")],
        "blocks.more.inputs",
        "a mapping is not a list (limit at most 3 entries); write [a, b]",
    ),
    "missing parameter of a block": (
        [block("{type: python, input: speed, function: 'laws.py:scaled', parameters: [1]}")],
        "blocks.more.function",
        "has 1 parameter, but scaled of 'laws.py' uses p[1] (its line 10) (limit >= 2); add the numbers",
    ),
    "missing parameter of a load": (
        [("actuators:\n", "loads:\n  l: {body: drum, torque: {python: 'laws.py:scaled'}}\nactuators:\n")],
        "loads.l.torque",
        "has no parameters, but scaled of 'laws.py' uses p[1]",
    ),
    "missing file of a load": (
        [("actuators:\n", "loads:\n  l: {body: drum, torque: {python: 'lows.py:law'}}\nactuators:\n")],
        "loads.l.torque",
        "'lows.py', which does not exist",
    ),
    "no file": ([(LOOP, "'lows.py:loop'")], "controllers.loop.function", "'lows.py', which does not exist"),
    "no function": ([(LOOP, "'laws.py:lop'")], "controllers.loop.function", "did you mean loop?"),
    "too few arguments": (
        [(LOOP, "'laws.py:law'")],
        "controllers.loop.function",
        "3 arguments (limit 4)",
    ),
    "too many arguments": (
        [block("{type: python, input: turn, function: 'laws.py:loop'}")],
        "blocks.more.function",
        "define it as loop(t, x, p)",
    ),
    "no Python": ([(LOOP, "'bad.py:loop'")], "controllers.loop.function", "which is not valid Python"),
    "no reference": ([(LOOP, "laws.py")], "controllers.loop.function", "write 'file.py:function'"),
    "function as a mapping": (
        [(LOOP, "{python: 'laws.py:loop'}")],
        "controllers.loop.function",
        "its numbers under parameters next to it",
    ),
    "no period": ([("period: 1 ms", "period: 0 ms")], "controllers.loop.period", "limit > 0"),
    "missing period": ([(", period: 1 ms", "")], "controllers.loop.period", "is missing"),
    "negative delay": (
        [("period: 1 ms", "period: 1 ms, delay: -1 ms")],
        "controllers.loop.delay",
        "limit >= 0",
    ),
    "two starts": (
        [("period: 1 ms", "period: 1 ms, start: [1, 2]")],
        "controllers.loop.start",
        "has 2 numbers for 1 outputs",
    ),
    "limits of a sampled controller": (
        [controller("{type: pid, input: error, output: w, proportional: 1, period: 1 ms, limits: [1, 1]}")],
        "controllers.more.limits",
        "are not increasing",
    ),
    "askew": ([("[drum, motor]", "[drum, cross]")], "actuators.trim.bodies", "are tilted by 90 deg"),
    "ground first": (
        [("[drum, motor]", "[ground, motor]")],
        "actuators.trim.bodies",
        "the driven body first",
    ),
    "unknown driven body": ([("[drum, motor]", "[drm, motor]")], "actuators.trim.bodies[0]", "mean drum?"),
    "three bodies": ([("[drum, motor]", "[drum, motor, cross]")], "actuators.trim.bodies", "has 3 entries"),
    "strut on one body": (
        [actuator("{type: strut, signal: u, ends: [motor, motor]}")],
        "actuators.more.ends",
        "are on the same body",
    ),
}


def faulty(changes: list[tuple[str, str]]) -> str:
    text = DRIVE
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new, 1)
    return text


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "laws.py").write_text(LAWS, encoding="utf-8")
    (tmp_path / "bad.py").write_text("def loop(:\n", encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize("name", list(CASES))
def test_each_fault_alone(name: str, folder: Path) -> None:
    changes, place, words = CASES[name]
    (folder / "model.yaml").write_text(faulty(changes), encoding="utf-8")
    with pytest.raises(ModelError) as error:
        load_model(folder / "model.yaml", allow_code=True)
    found = error.value.problems
    assert [p.where for p in found] == [place], [str(p) for p in found]
    assert words in str(found[0])
    assert found[0].line is not None
    assert found[0].line > 1


def test_the_drive_is_right(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "model.yaml").write_text(DRIVE, encoding="utf-8")
    model = load_model(folder / "model.yaml", allow_code=True)
    assert compile_model(model, "run").controllers[0].name == "loop"
    assert run_command(["check", str(folder / "model.yaml"), "--allow-code"]) == 0
    shown = capsys.readouterr()
    assert "controller loop (python), every 1 ms" in " ".join(shown.out.split())


def test_all_at_once(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    changes = [("{speed: -1}", "{sped: -1}"), ("[-5, 5]", "[5, -5]"), (LOOP, "'laws.py:lop'")]
    (folder / "model.yaml").write_text(faulty(changes), encoding="utf-8")
    assert run_command(["check", str(folder / "model.yaml"), "--allow-code"]) == 2
    said = capsys.readouterr().err
    assert "3 problems" in said
    assert "blocks.error.inputs.sped (line 14)" in said


def test_code_needs_permission() -> None:
    with pytest.raises(ModelError, match="is not run unless allowed"):
        loads_model(DRIVE)


def test_an_observation_that_nothing_makes(folder: Path) -> None:
    """Which observations an element has is known when it is compiled."""
    old, new = sensor("{type: observation, channel: 'slip_speed[link]'}")
    (folder / "model.yaml").write_text(DRIVE.replace(old, new), encoding="utf-8")
    model = load_model(folder / "model.yaml", allow_code=True)
    with pytest.raises(
        ModelError, match=r"sensors.more.channel \(line \d+\): nothing observes 'slip_speed\[link\]'"
    ):
        compile_model(model)


# faults of sensors and torques, each beside a fault elsewhere: (change elsewhere, its place)
ELSEWHERE = {
    "a spring between nothing": (
        ("[motor, drum], stiffness", "[moter, drum], stiffness"),
        "torsion_springs.link.bodies",
    ),
    "a joint of nothing": (
        ("torsion_springs:\n", "joints:\n  pin: {type: revolute, bodies: [drm, shaft]}\ntorsion_springs:\n"),
        "joints.pin.bodies[0]",
    ),
    "a body out of range": (("inertia: 2 kg m^2", "inertia: -2 kg m^2"), "bodies.drum.inertia"),
    "a word in place of a body": (
        ("  motor: {motion: torsion, inertia: 1 kg m^2, position: [0, 0, 0]}", "  motor: {motion: torsin}"),
        "bodies.motor.motion",
    ),
    "a gain": (("proportional: 2", "proportional: two"), "blocks.u.proportional"),
    "a scenario": (("duration: 20 ms", "duration: 20 mm"), "scenarios.run.duration"),
}
NAMED = {
    "unknown coordinate": "coordinate",
    "unknown observation": "channel",
    "observation of nothing": "channel",
    "load of ground": "at",
}


@pytest.mark.parametrize("sensor_fault", NAMED)
@pytest.mark.parametrize("other", ELSEWHERE)
def test_a_sensor_is_told_beside_other_faults(sensor_fault: str, other: str, folder: Path) -> None:
    """What a sensor names is no less wrong because something else is: both with their lines."""
    changes, place, words = CASES[sensor_fault]
    change, second = ELSEWHERE[other]
    text = faulty([change, *changes])
    (folder / "model.yaml").write_text(text, encoding="utf-8")
    with pytest.raises(ModelError) as error:
        load_model(folder / "model.yaml", allow_code=True)
    found = {p.where: p for p in error.value.problems}
    assert place in found, [str(p) for p in found.values()]
    assert words in str(found[place])
    assert found[place].line == 1 + text[: text.index("  more:")].count("\n")
    assert second in found


@pytest.mark.parametrize("fault", ["a turn among others", "load of nothing", "askew", "ground first"])
def test_what_the_tree_decides_is_told_beside_other_faults(fault: str, folder: Path) -> None:
    """Wrong numbers elsewhere leave no doubt about how the bodies hang on each other."""
    changes, place, _ = CASES[fault]
    text = faulty([ELSEWHERE["a gain"][0], ("inertia: 2 kg m^2", "inertia: -2 kg m^2"), *changes])
    (folder / "model.yaml").write_text(text, encoding="utf-8")
    with pytest.raises(ModelError) as error:
        load_model(folder / "model.yaml", allow_code=True)
    found = sorted(p.where for p in error.value.problems)
    assert found == sorted([place, "blocks.u.proportional", "bodies.drum.inertia"])


def test_no_sensor_is_blamed_for_what_could_not_be_read(folder: Path) -> None:
    """Names of a section that is spelled wrong, and joints that cannot be read, may be right."""
    text = faulty(
        [
            ("torsion_springs:\n", "torsion_spring:\n"),
            sensor("{type: observation, channel: 'torque[link]'}"),
            ("bodies:\n", "joints:\n  pin: {type: revolut, bodies: [motor, drum]}\nbodies:\n"),
            ("  turn: {type: joint, coordinate: motor}", "  turn: {type: joint, coordinate: pin.spin}"),
        ]
    )
    (folder / "model.yaml").write_text(text, encoding="utf-8")
    with pytest.raises(ModelError) as error:
        load_model(folder / "model.yaml", allow_code=True)
    assert sorted(p.where for p in error.value.problems) == ["joints.pin.type", "torsion_spring"]


CARRIED = """
bodies:
  carrier: {inertia: 1 kg m^2, mass: 5 kg, position: [0, 0, 0]}
  wheel: {inertia: 0.1 kg m^2, mass: 1 kg, position: [0.2 m, 0, 0], axes: {z: AXIS}}
joints:
  pin: {type: revolute, bodies: [carrier, wheel], axes: {z: AXIS}}
sensors:
  speed: {type: joint, coordinate: wheel, derivative: 1}
actuators:
  motor: {type: torque, signal: speed, bodies: [wheel, carrier]}
"""


@pytest.mark.parametrize(("axis", "ok"), [("[1, 0, 0]", True), ("[0, 0, 1]", True), ("[1, 0, 2]", False)])
def test_a_torque_between_a_body_and_its_carrier(axis, ok):
    """A motor on the carrier turns the wheel about the axis of the wheel, across that of the carrier. Where
    the axes are less than 45 deg apart, the remedy is not what the model has already."""
    text = CARRIED.replace("AXIS", axis)
    if ok:
        assert loads_model(text).actuators["motor"].bodies == ("wheel", "carrier")
        return
    with pytest.raises(ModelError) as caught:
        loads_model(text)
    (problem,) = caught.value.problems
    assert str(problem).startswith("actuators.motor.bodies (line 10): are tilted by 26.57 deg")
    assert str(problem).endswith("(limit 0 deg, or above 45 deg); write {type: force, quantity: moment, ...}")
