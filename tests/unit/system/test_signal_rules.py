# SPDX-License-Identifier: Apache-2.0
"""Sensors, blocks, actuators and controllers as a user describes them, as signals."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.elements.signals import record as sr
from pitchpoint.elements.signals.net import SignalNet
from pitchpoint.model.components import block as bl
from pitchpoint.model.components.actuator import ACTUATORS, ForceActuator, Strut, TorqueActuator
from pitchpoint.model.components.controller import CONTROLLERS, PythonController, SampledPid
from pitchpoint.model.components.law import PythonLaw
from pitchpoint.model.components.sensor import SENSORS, FrameSensor, JointSensor, Listener, LoadSensor
from pitchpoint.multibody.bodies import TORSION, Body
from pitchpoint.multibody.joints import FLOATING
from pitchpoint.system import evaluate
from pitchpoint.system.rules.places import Places
from pitchpoint.system.rules.signals import Machine, signal_net
from pitchpoint.system.signals import assemble_controlled
from tests.support.forces import moving

TURN = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
INERTIA = {"mass": 1.0, "com": (0.0, 0.0, 0.0), "inertia": np.diag([0.1, 0.1, 0.15])}
BODIES = [
    Body(motion=FLOATING, name="frame", **INERTIA),
    Body(motion=TORSION, parent=1, position=(0.2, 0.0, 0.0), name="arm", **INERTIA),
]
NUMBER = {"ground": 0, "frame": 1, "arm": 2}


def end(name):
    body, _, marker = name.partition(".")
    return NUMBER[body], np.array([0.0, 0.3, 0.0]) if marker else np.zeros(3), TURN if marker else np.eye(3)


PLACES = Places(end, lambda n: end(n)[1], lambda n: end(n)[2], {}.__getitem__)


def made(sensors=None, blocks=None, actuators=None, controllers=None, functions=None):
    parts = (sensors or {}, blocks or {}, actuators or {}, controllers or {})
    machine = Machine(BODIES, PLACES, {"arm": (2, 0)}.__getitem__, functions or {})
    net, loops = signal_net(machine, *parts)
    return assemble_controlled(net, {}, controllers=loops)


def test_a_description_makes_the_same_system_as_its_numbers():
    described = made(
        {
            "way": FrameSensor(quantity="position", ends=("arm.tip", "frame.eye"), axis="x"),
            "turn": FrameSensor(quantity="angle", ends=("arm", "frame.eye")),
            "joint": JointSensor(coordinate="arm", derivative=1),
        },
        {
            "sum": bl.Sum(inputs={"way": 2.0, "turn": -1.0, "joint": 0.5}, offset=0.1),
            "kept": bl.Limits(input="sum", limits=(-50.0, 50.0)),
            "bent": bl.Curve(input="kept", points=((-60.0, -50.0), (0.0, 1.0), (60.0, 90.0))),
            "mixed": bl.FormulaBlock(formula="bent + slow*t", inputs=("bent", "slow", "t")),
            "slow": bl.Filter(input="sum", time_constant=0.1),
            "smooth": bl.Filter(input="sum", time_constant=0.1, damping_ratio=0.7),
            "integral": bl.Integrator(input="sum", start=2.0),
            "shaped": bl.TransferFunction(input="sum", numerator=(1.0,), denominator=(0.1, 1.0)),
            "law": bl.LawBlock(input="sum", function=PythonLaw("f.py", "f"), parameters=(3.0,)),
            "u": bl.Pid(input="sum", proportional=2.0, integral=1.0, limits=(-9.0, 9.0)),
        },
        {
            "motor": TorqueActuator(signal="mixed", bodies=("arm", "frame")),
            "jack": Strut(signal="u", ends=("arm.tip", "ground")),
            "jet": ForceActuator(signal="law", ends=("arm.tip", "ground"), axis="y", along="first"),
        },
        functions={"blocks.law.function": lambda t, x, p: p[0] * x},
    )
    point = (0.0, 0.3, 0.0)
    net = SignalNet(BODIES)
    net.sensor("way", sr.POSITION, 2, 1, axis=TURN[:, 0], point_i=point, point_j=point)
    net.sensor("turn", sr.ANGLE, 2, 1, direction_i=(1.0, 0.0, 0.0), direction_j=TURN[:, 0])
    net.joint_sensor("joint", 2, "spin", 1)
    net.linear("sum", {"way": 2.0, "turn": -1.0, "joint": 0.5}, 0.1)
    state = moving(described, np.random.default_rng(2))
    state.t = 0.4
    row = evaluate.observe(described, state)

    def seen(name):
        return row[described.layout.channel(f"signal[{name}]")]

    plain = assemble_controlled(net, {})
    few = plain.initial_state()
    for name in plain.layout.coordinates:
        k, m = plain.layout.coordinate(name), described.layout.coordinate(name)
        few.q[k], few.v[k] = state.q[m], state.v[m]
    total = evaluate.observe(plain, few)[plain.layout.channel("signal[sum]")]
    assert seen("sum") == pytest.approx(total, rel=1e-13)
    slow = state.v[described.spin("state.slow")]
    bent = 1.0 + (89.0 / 60.0 if total > 0.0 else 51.0 / 60.0) * total
    assert seen("motor") == pytest.approx(bent + 0.4 * slow)
    assert seen("jet") == pytest.approx(3.0 * total)
    integral = state.v[described.spin("state.u.integral")]
    assert seen("u.free") == pytest.approx(2.0 * total + integral)
    assert seen("jack") == pytest.approx(np.clip(2.0 * total + integral, -9.0, 9.0))
    assert described.initial_state().v[described.spin("state.integral")] == 2.0


def test_angles_count_from_marker_to_marker():
    """The marker of the frame is turned by a right angle, so the arm starts at minus that."""
    system = made({"turn": FrameSensor(quantity="angle", ends=("arm", "frame.eye"))})
    state = system.initial_state()
    for angle, turns in ((0.3, 0), (-0.2, 4), (3.0, -1), (-3.0, 1)):
        state.q[system.spin("arm")], state.turns[2] = angle, turns
        found = evaluate.observe(system, state)[system.layout.channel("signal[turn]")]
        assert found == pytest.approx(angle - 0.5 * np.pi + 2.0 * np.pi * turns, abs=1e-12)


def test_loads_and_observations():
    system = made(
        {
            "load": LoadSensor(at="arm.tip", quantity="moment", seen_from="frame", axis="z"),
            "heard": Listener(channel="angle[arm]"),
        }
    )
    assert list(system.records) == ["signal_of_loads"]
    assert system.layout.channel("signal[load]") >= 0


def test_controllers_make_signals():
    system = made(
        {"turn": FrameSensor(quantity="angle", ends=("arm", "frame"))},
        {"all": bl.Sum(inputs={"u": 1.0, "w": 2.0})},
        {"motor": TorqueActuator(signal="all", bodies=("arm",))},
        {
            "one": PythonController(
                function=PythonLaw("f.py", "f"),
                inputs=("turn",),
                outputs=("u",),
                start=(0.5,),
                period=0.1,
                delay=0.05,
            ),
            "two": SampledPid(input="turn", output="w", proportional=2.0, limits=(-1.0, 1.0), period=0.2),
        },
        {"controllers.one.function": lambda t, x, s, p: 1.0},
    )
    assert [c.period for c in system.controllers] == [0.1, 0.2]
    row = evaluate.observe(system, system.initial_state())
    assert row[system.layout.channel("signal[all]")] == 0.5


def test_forms_have_different_names():
    for table in (SENSORS, bl.BLOCKS, ACTUATORS, CONTROLLERS):
        assert all(cls.form == name for name, cls in table.items())
