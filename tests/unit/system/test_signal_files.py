# SPDX-License-Identifier: Apache-2.0
"""Signals in files against their twins built from numbers: the same values, forces and accelerations."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pitchpoint.core.formula.formula import Formula
from pitchpoint.elements.signals import record as sr
from pitchpoint.elements.signals.dry_friction import add_dry_friction
from pitchpoint.elements.signals.net import SignalNet
from pitchpoint.io.yaml_model import dump_model, load_model, loads_model
from pitchpoint.model.components.actuator import ACTUATORS
from pitchpoint.model.components.block import BLOCKS
from pitchpoint.model.components.controller import CONTROLLERS
from pitchpoint.model.components.sensor import QUANTITIES, SENSORS
from pitchpoint.solvers.initial_state.start import Start
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.controller import SampledController, sampled_pid
from pitchpoint.system.rules.signals import QUANTITY
from pitchpoint.system.signals import assemble_controlled
from tests.support.forces import moving
from tests.support.mechanism_files import accelerations

# bodies whose own axes are those of their joints: a marker of the file lies where the engine has it
MACHINE = """\
bodies:
  frame:
    mass: 2 kg
    inertia_tensor: [0.2, 0.25, 0.3, 0.01, 0.02, 0.0]
    position: [0, 0, 0]
    markers: {eye: {position: [0.1, 0.2, 0.3], axes: {z: [0, 1, 0], x: [1, 0, 0]}}}
  arm:
    mass: 1 kg
    center_of_mass: [0.1, 0, 0]
    inertia_tensor: [0.1, 0.12, 0.15, 0, 0, 0]
    markers: {tip: {position: [0.4, 0.1, 0], axes: {z: [1, 0, 0], x: [0, 0, 1]}}}
  slide:
    mass: 0.5 kg
    inertia_tensor: [0.01, 0.01, 0.02, 0, 0, 0]
    axes: {z: [1, 0, 0], x: [0, 1, 0]}
    markers: {end: {position: [0, 0.05, 0.2]}}
  disc: {mass: 0.4 kg, inertia_tensor: [0.01, 0.01, 0.02, 0, 0, 0]}
joints:
  hold: {type: free, bodies: [ground, frame]}
  pin: {type: revolute, bodies: [frame, arm], position: [0.2, 0, 0]}
  way: {type: prismatic, bodies: [arm, slide], position: [0.5, 0, 0], axes: {z: [1, 0, 0], x: [0, 1, 0]}}
  axle: {type: revolute, bodies: [frame, disc], position: [-0.2, 0, 0]}
springs:
  tie: {ends: [arm.tip, ground], stiffness: 100 N/m, damping: 3 N s/m}
"""
FRAME, ARM, SLIDE, DISC = 1, 2, 3, 4
TIP, EYE, END = (0.4, 0.1, 0.0), (0.1, 0.2, 0.3), (0.0, 0.05, 0.2)
EYE_AXES = np.column_stack([(1.0, 0.0, 0.0), (0.0, 0.0, -1.0), (0.0, 1.0, 0.0)])
TIP_AXES = np.column_stack([(0.0, 0.0, 1.0), (0.0, 1.0, 0.0), (1.0, 0.0, 0.0)])[:, [0, 1, 2]]
TIP_AXES[:, 1] = np.cross(TIP_AXES[:, 2], TIP_AXES[:, 0])

pytestmark = pytest.mark.filterwarnings("ignore:.*is not used")


def described(text, folder=None):
    """System of a file with signals, which survives a round trip."""
    if folder is None:
        model = loads_model(MACHINE + text)
        assert loads_model(dump_model(model)) == model
    else:
        (folder / "model.yaml").write_text(MACHINE + text, encoding="utf-8")
        model = load_model(folder / "model.yaml", allow_code=True)
        (folder / "again.yaml").write_text(dump_model(model), encoding="utf-8")
        assert load_model(folder / "again.yaml", allow_code=True) == model
    return compile_model(model)


def plain():
    """The machine without signals, and an empty net of its bodies."""
    system = compile_model(loads_model(MACHINE))
    return system, SignalNet(system.bodies)


def twin_of(net, system, controllers=()):
    kept = {k: v for k, v in system.records.items() if k != "closure"}
    return assemble_controlled(
        net, {k: v.copy() for k, v in kept.items()}, controllers=controllers, names=system.names
    )


def compare(one, two, names, seed=3):
    """All signals at random states and the accelerations that follow, of both systems."""
    assert one.layout.coordinates == two.layout.coordinates
    for k in range(3):
        state = moving(one, np.random.default_rng(seed + k))
        state.t = 0.3
        both = []
        for system in (one, two):
            here = state.copy()
            here.a, _ = accelerations(system, here)
            row = evaluate.observe(system, here)
            both.append((here.a, [row[system.layout.channel(f"signal[{n}]")] for n in names]))
        # the same arithmetic but for the last bits of directions
        np.testing.assert_allclose(both[0][0], both[1][0], rtol=1e-10, atol=1e-10)
        np.testing.assert_allclose(both[0][1], both[1][1], rtol=1e-10, atol=1e-10)


UNITS = ("m", "m/s", "m/s^2", "m", "m/s", "rad", "rad/s", "rad/s^2")


@pytest.mark.parametrize(("quantity", "unit"), list(zip(QUANTITIES, UNITS, strict=True)))
def test_every_quantity_between_frames(quantity, unit):
    axis = "z" if quantity.startswith("ang") else "x"
    one = described(
        f"sensors:\n  s: {{type: frames, quantity: {quantity}, ends: [arm.tip, frame.eye], axis: {axis}}}\n"
    )
    system, net = plain()
    k = "xyz".index(axis)
    across = {}
    if quantity == "angle":
        across = {"direction_i": TIP_AXES[:, 0], "direction_j": EYE_AXES[:, 0]}
    net.sensor("s", QUANTITY[quantity], ARM, FRAME, axis=EYE_AXES[:, k], point_i=TIP, point_j=EYE, **across)
    compare(one, twin_of(net, system), ["s"])
    assert one.layout.channels[one.layout.channel("signal[s]")].unit == unit


@pytest.mark.parametrize("derivative", [0, 1, 2])
def test_joint_sensors(derivative):
    one = described(
        f"sensors:\n  a: {{type: joint, coordinate: pin.spin, derivative: {derivative}}}\n"
        f"  b: {{type: joint, coordinate: way.z, derivative: {derivative}}}\n"
        f"  c: {{type: joint, coordinate: disc, derivative: {derivative}}}\n"
    )
    system, net = plain()
    net.joint_sensor("a", ARM, "spin", derivative)
    net.joint_sensor("b", SLIDE, "z", derivative)
    net.joint_sensor("c", DISC, "spin", derivative)
    compare(one, twin_of(net, system), ["a", "b", "c"])
    state = moving(one, np.random.default_rng(1))
    row = evaluate.observe(one, state)
    for name, coordinate in (("a", "arm.spin"), ("b", "slide.z"), ("c", "disc.spin")):
        wanted = (state.q, state.v, state.a)[derivative][one.layout.coordinate(coordinate)]
        assert row[one.layout.channel(f"signal[{name}]")] == pytest.approx(wanted, abs=1e-12)


def test_joints_turned_round_keep_the_meaning_of_their_coordinates():
    turned = MACHINE.replace("[frame, arm]", "[arm, frame]").replace("[ground, frame]", "[ground, arm]")
    sensor = "sensors:\n  a: {type: joint, coordinate: pin.spin, derivative: 1}\n"
    model = loads_model(turned.replace("[frame, arm]", "[arm, frame]") + sensor)
    system = compile_model(model)
    state = system.initial_state()
    number = system.layout.coordinate("frame.spin")
    state.v[number] = 2.0
    row = evaluate.observe(system, state)
    assert row[system.layout.channel("signal[a]")] == pytest.approx(2.0, abs=1e-12)


def test_load_sensors_and_observations():
    one = described(
        """\
sensors:
  f: {type: load, at: arm.tip, axis: y, seen_from: frame.eye}
  m: {type: load, at: slide.end, quantity: moment, axis: x}
  h: {type: observation, channel: 'tension[tie]'}
"""
    )
    system, net = plain()
    net.reaction("f", ARM, axis=EYE_AXES[:, 1], axis_on=FRAME, point=TIP)
    net.reaction("m", SLIDE, moment=True, axis=(1.0, 0.0, 0.0), point=END)
    net.listen("h", "tension[tie]", "N")
    compare(one, twin_of(net, system), ["f", "m", "h"])
    units = [one.layout.channels[one.layout.channel(f"signal[{n}]")].unit for n in "fmh"]
    assert units == ["N", "N m", "N"]


SENSED = """\
sensors:
  turn: {type: joint, coordinate: pin.spin}
  rate: {type: joint, coordinate: pin.spin, derivative: 1}
"""
BLOCK_FILES = {
    "sum": "{type: sum, inputs: {turn: 2, rate: -0.5 N m s}, offset: 6.283185307179586 N m, unit: N m}",
    "limits": "{type: limits, input: rate, limits: [-0.3, 0.4 rad/s]}",
    "table": "{type: table, input: rate, points: [[-1, -3], [0, 0.5], [2, 4]]}",
    "formula": "{type: formula, formula: 3 * sin(turn) * rate + t, inputs: [turn, rate, t]}",
    "python": "{type: python, input: rate, function: 'laws.py:cubic', parameters: [0.5, 2]}",
    "integrator": "{type: integrator, input: rate, start: 0.7}",
    "filter": "{type: filter, input: rate, time_constant: 20 ms}",
    "rate_limit": "{type: rate_limit, input: rate, rate: 3, time_constant: 20 ms, start: 0.7}",
    "friction": "{type: friction, input: rate, wind_up: 2e-3, holding: 0.6, damping_time: 2 ms}",
    "input": "{type: input, value: 0.3}",
    "second_order": "{type: filter, input: rate, time_constant: 20 ms, damping_ratio: 0.4}",
    "transfer_function": "{type: transfer_function, input: rate, numerator: [1, 2, 3], "
    "denominator: [2, 5, 4]}",
    "pid": "{type: pid, input: turn, proportional: 3, integral: 2, derivative: 0.4, filter_time: 5 ms, "
    "limits: [-1, 1.5]}",
    "free_pid": "{type: pid, input: turn, proportional: 3, integral: 2}",
}
LAWS = """\
def cubic(t, x, p):
    return p[0] * x**3 + p[1] * x


def follow(t, inputs, state, parameters):
    state["sum"] = state.get("sum", 0.0) + inputs[0]
    return [parameters[0] * inputs[0], 0.1 * state["sum"]]
"""


def cubic(t, x, p):
    return p[0] * x**3 + p[1] * x


def add_block(net, form):
    """The same block by numbers."""
    made = {
        "sum": lambda: net.linear("b", {"turn": 2.0, "rate": -0.5}, 2.0 * np.pi, "N m"),
        "limits": lambda: net.saturation("b", "rate", -0.3, 0.4),
        "table": lambda: net.table("b", "rate", [-1.0, 0.0, 2.0], [-3.0, 0.5, 4.0]),
        "formula": lambda: net.formula(
            "b", Formula.parse("3*sin(turn)*rate + t", ("turn", "rate", "t")), ("turn", "rate", "t")
        ),
        "python": lambda: net.law("b", "rate", cubic, (0.5, 2.0)),
        "integrator": lambda: net.integrator("b", "rate", 0.7),
        "filter": lambda: net.low_pass("b", "rate", 0.02),
        "rate_limit": lambda: net.rate_limit("b", "rate", 3.0, 0.02, 0.7),
        "friction": lambda: add_dry_friction(net, "b", "rate", 2e-3, 0.6, 2e-3),
        "input": lambda: net.linear("b", {}, 0.3),
        "second_order": lambda: net.second_order("b", "rate", 50.0, 0.4),
        "transfer_function": lambda: net.transfer_function("b", "rate", [1.0, 2.0, 3.0], [2.0, 5.0, 4.0]),
        "pid": lambda: net.pid("b", "turn", kp=3.0, ki=2.0, kd=0.4, filter_time=0.005, limits=(-1.0, 1.5)),
        "free_pid": lambda: net.pid("b", "turn", kp=3.0, ki=2.0),
    }
    made[form]()


@pytest.mark.parametrize("form", list(BLOCK_FILES))
def test_every_block_driving_a_torque(form, tmp_path: Path):
    (tmp_path / "laws.py").write_text(LAWS, encoding="utf-8")
    text = f"{SENSED}blocks:\n  b: {BLOCK_FILES[form]}\n"
    one = described(text + "actuators:\n  m: {type: torque, signal: b, bodies: [arm, frame]}\n", tmp_path)
    system, net = plain()
    net.joint_sensor("turn", ARM, "spin")
    net.joint_sensor("rate", ARM, "spin", 1)
    add_block(net, form)
    net.torque("m", "b", ARM, FRAME)
    compare(one, twin_of(net, system), ["b", "m"])
    start = one.initial_state().v[one.states]
    begins = form in ("integrator", "rate_limit")
    np.testing.assert_array_equal(start, [0.7] if begins else np.zeros(start.size))


def test_units_of_signals():
    one = described(
        SENSED
        + """\
blocks:
  seen: {type: filter, input: kept, time_constant: 1 ms}
  kept: {type: limits, input: rate, limits: [-1, 1]}
  u: {type: pid, input: seen, proportional: 2, unit: N m}
  w: {type: sum, inputs: {u: 1}}
"""
    )
    units = [one.layout.channels[one.layout.channel(f"signal[{n}]")].unit for n in ("seen", "kept", "u", "w")]
    assert units == ["rad/s", "rad/s", "N m", "1"]


ACTUATOR_FILES = {
    "torque on ground": ("{type: torque, signal: turn, bodies: [disc]}", ("torque", DISC, 0)),
    "torque between": ("{type: torque, signal: turn, bodies: [arm, disc]}", ("torque", ARM, DISC)),
    "strut": ("{type: strut, signal: rate, ends: [arm.tip, frame.eye]}", ("strut", ARM, FRAME, TIP, EYE)),
    "strut on ground": (
        "{type: strut, signal: rate, ends: [ground, slide.end]}",
        ("strut", 0, SLIDE, (0.0, 0.0, 0.0), END),
    ),
    "force in the world": (
        "{type: force, signal: rate, ends: [arm.tip, frame], axis: y}",
        ("force", ARM, FRAME, TIP, (0.0, 1.0, 0.0, 0.0, 0.0, 0.0), sr.WORLD),
    ),
    "force with the first": (
        "{type: force, signal: rate, ends: [arm.tip, ground], axis: x, along: first}",
        ("force", ARM, 0, TIP, (*TIP_AXES[:, 0], 0.0, 0.0, 0.0), sr.BODY_I),
    ),
    "moment with the second": (
        "{type: force, signal: rate, ends: [slide.end, frame.eye], axis: y, along: second, quantity: moment}",
        ("force", SLIDE, FRAME, END, (0.0, 0.0, 0.0, *EYE_AXES[:, 1]), sr.BODY_J),
    ),
}


@pytest.mark.parametrize("kind", list(ACTUATOR_FILES))
def test_every_actuator(kind):
    line, numbers = ACTUATOR_FILES[kind]
    one = described(f"{SENSED}actuators:\n  m: {line}\n")
    system, net = plain()
    net.joint_sensor("turn", ARM, "spin")
    net.joint_sensor("rate", ARM, "spin", 1)
    form, i, j, *rest = numbers
    if form == "torque":
        net.torque("m", "turn", i, j)
    elif form == "strut":
        net.strut("m", "rate", i, j, point_i=rest[0], point_j=rest[1])
    else:
        net.force("m", "rate", i, j, load=rest[1], axes=rest[2], point=rest[0])
    compare(one, twin_of(net, system), ["m"])
    unit = "N m" if form == "torque" or "moment" in kind else "N"
    assert one.layout.channels[one.layout.channel("signal[m]")].unit == unit


def test_all_forms_are_tried():
    assert set(SENSORS) == {"frames", "joint", "load", "observation"}
    assert set(BLOCKS) <= set(BLOCK_FILES)
    assert {numbers[0] for _, numbers in ACTUATOR_FILES.values()} == set(ACTUATORS)
    # discon: tests/unit/cli/test_discon.py, fmu: tests/unit/system/test_fmu_controllers.py
    assert set(CONTROLLERS) == {"python", "pid", "discon", "fmu"}


CONTROLLED = f"""\
{SENSED}blocks:
  error: {{type: sum, inputs: {{turn: -1}}, offset: 0.3}}
  all: {{type: sum, inputs: {{u: 1, v: 1, w: 0.5}}}}
controllers:
  one: {{type: pid, input: error, output: u, proportional: 4, integral: 30, derivative: 0.1, limits: [-3, 3],
    period: 4 ms, start: 0.5}}
  two: {{type: python, function: 'laws.py:follow', inputs: [rate], outputs: [v, w], start: [0.1, 0.2],
    period: 6 ms, delay: 2 ms, parameters: [-0.4]}}
actuators:
  m: {{type: torque, signal: all, bodies: [arm, frame]}}
scenarios:
  run: {{start: assembled, duration: 60 ms, step: 0.5 ms, settle_time: 0 s, sample_rate: 1 kHz}}
"""


def samples(system, state, scenario):
    memory = Memory()
    done = run_time(system, scenario, sink=memory, start=Start(system, state))
    assert done.status == 1, done.sentence
    return np.concatenate(memory.times), np.concatenate(memory.rows)


def test_sampled_controllers_run_as_their_twins(tmp_path: Path):
    (tmp_path / "laws.py").write_text(LAWS, encoding="utf-8")
    one = described(CONTROLLED, tmp_path)
    system, net = plain()
    net.joint_sensor("turn", ARM, "spin")
    net.joint_sensor("rate", ARM, "spin", 1)
    net.linear("error", {"turn": -1.0}, 0.3)
    for name, start in (("u", 0.5), ("v", 0.1), ("w", 0.2)):
        net.held(name, start)
    net.linear("all", {"u": 1.0, "v": 1.0, "w": 0.5})
    net.torque("m", "all", ARM, FRAME)

    def follow(t, inputs, state, parameters):
        state["sum"] = state.get("sum", 0.0) + inputs[0]
        return [-0.4 * inputs[0], 0.1 * state["sum"]]

    numbers = {"kp": 4.0, "ki": 30.0, "kd": 0.1, "period": 0.004, "low": -3.0, "high": 3.0}
    fresh = {"integral": 0.5, "error": None}
    loops = [
        SampledController("one", sampled_pid, ("error",), ("u",), 0.004, 0.0, fresh, numbers),
        SampledController("two", follow, ("rate",), ("v", "w"), 0.006, 0.002, {}),
    ]
    two = twin_of(net, system, loops)
    model = load_model(tmp_path / "model.yaml", allow_code=True)
    state = moving(one, np.random.default_rng(8), 0.2)
    (t, rows), (_, others) = (samples(s, state.copy(), model.scenarios["run"]) for s in (one, two))
    assert t[-1] == pytest.approx(0.06)
    for name in ("turn", "rate", "u", "v", "w", "m"):
        a, b = (
            rows[:, one.layout.channel(f"signal[{name}]")],
            others[:, two.layout.channel(f"signal[{name}]")],
        )
        assert np.ptp(a) > 0.0
        np.testing.assert_allclose(a, b, rtol=1e-9, atol=1e-9)
