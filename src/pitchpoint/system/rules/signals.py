# SPDX-License-Identifier: Apache-2.0
"""Sensors, blocks, actuators and controllers of a model as a net of signals."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from pitchpoint.core.errors import CompileError
from pitchpoint.core.formula import Formula
from pitchpoint.elements import signal_record as sr
from pitchpoint.elements.signal_net import SignalNet
from pitchpoint.model.components import block as bl
from pitchpoint.model.components.actuator import Actuator, ForceActuator, TorqueActuator
from pitchpoint.model.components.controller import Controller, PythonController
from pitchpoint.model.components.sensor import AXES, FrameSensor, JointSensor, Listener, LoadSensor, Sensor
from pitchpoint.multibody.bodies import Body
from pitchpoint.system.controller import SampledController, sampled_pid
from pitchpoint.system.rules.places import Places

Function = Callable[..., Any]

QUANTITY = {
    "position": sr.POSITION,
    "velocity": sr.VELOCITY,
    "acceleration": sr.ACCELERATION,
    "distance": sr.DISTANCE,
    "distance_rate": sr.DISTANCE_RATE,
    "angle": sr.ANGLE,
    "angular_velocity": sr.ANGULAR_VELOCITY,
    "angular_acceleration": sr.ANGULAR_ACCELERATION,
}
SIDE = {"world": sr.WORLD, "first": sr.BODY_I, "second": sr.BODY_J}


def signal_net(
    bodies: Sequence[Body],
    sensors: Mapping[str, Sensor],
    blocks: Mapping[str, bl.Block],
    actuators: Mapping[str, Actuator],
    controllers: Mapping[str, Controller],
    places: Places,
    functions: Mapping[str, Function],
) -> tuple[SignalNet, list[SampledController]]:
    """Signals of a model and its sampled controllers, for `system.signals.assemble_controlled`.

    Parameters
    ----------
    bodies
        All bodies of the system so far, hidden ones of other elements among them.
    sensors, blocks, actuators, controllers
        Components by name; the names of sensors and blocks are those of their signals.
    places
        How ends and markers are found.
    functions
        Python functions by the place that names them: "blocks.NAME.function", "controllers.NAME.function".
    """
    net = SignalNet(bodies)
    for name, sensor in sensors.items():
        _sense(net, name, sensor, places)
    for name, block in blocks.items():
        _compute(net, name, block, functions)
    made = [_controller(net, name, controller, functions) for name, controller in controllers.items()]
    for name, actuator in actuators.items():
        _act(net, name, actuator, places)
    return net, made


def _sense(net: SignalNet, name: str, part: Sensor, places: Places) -> None:
    if isinstance(part, FrameSensor):
        (i, p_i, _), (j, p_j, axes) = (places.end(end) for end in part.ends)
        k = AXES.index(part.axis)
        across: dict[str, Any] = {}
        if part.quantity == "angle":  # from marker to marker, both about the axis of the second
            own = places.end(part.ends[0])[2]
            across = {"direction_i": own[:, (k + 1) % 3], "direction_j": axes[:, (k + 1) % 3]}
        net.sensor(name, QUANTITY[part.quantity], i, j, axis=axes[:, k], point_i=p_i, point_j=p_j, **across)
    elif isinstance(part, JointSensor):
        net.joint_sensor(name, places.end(part.body)[0], part.coordinate, part.derivative)
    elif isinstance(part, LoadSensor):
        body, point, _ = places.end(part.at)
        seen, _, axes = places.end(part.seen_from)
        axis = axes[:, AXES.index(part.axis)]
        net.reaction(name, body, moment=part.quantity == "moment", axis=axis, axis_on=seen, point=point)
    elif isinstance(part, Listener):
        net.listen(name, part.channel, part.unit)


def _compute(net: SignalNet, name: str, part: bl.Block, functions: Mapping[str, Function]) -> None:
    if isinstance(part, bl.Sum):
        if len(part.inputs) != len(part.gains):
            raise CompileError(f"blocks.{name}: {len(part.gains)} gains for {len(part.inputs)} inputs")
        net.linear(name, dict(zip(part.inputs, part.gains, strict=True)), part.offset)
    elif isinstance(part, bl.Limits):
        net.saturation(name, part.input, *part.limits)
    elif isinstance(part, bl.Curve):
        net.table(name, part.input, part.x, part.y)
    elif isinstance(part, bl.FormulaBlock):
        net.formula(name, Formula.parse(part.formula, part.inputs), part.inputs)
    elif isinstance(part, bl.LawBlock):
        net.law(name, part.input, functions[f"blocks.{name}.function"], part.parameters)
    elif isinstance(part, bl.Integrator):
        net.integrator(name, part.input, part.start)
    elif isinstance(part, bl.Filter):
        if part.damping_ratio is None:
            net.low_pass(name, part.input, part.time_constant)
        else:
            net.second_order(name, part.input, 1.0 / part.time_constant, part.damping_ratio)
    elif isinstance(part, bl.TransferFunction):
        net.transfer_function(name, part.input, part.numerator, part.denominator)
    else:
        net.pid(
            name,
            part.input,
            kp=part.proportional,
            ki=part.integral,
            kd=part.derivative,
            filter_time=part.filter_time,
            limits=_limits(f"blocks.{name}", part.limits),
            tracking_time=part.tracking_time or 0.0,
        )


def _limits(where: str, limits: Sequence[float]) -> tuple[float, float] | None:
    if not limits:
        return None
    if len(limits) != 2:
        raise CompileError(f"{where}.limits: {len(limits)} numbers; give the least and the greatest value")
    return float(limits[0]), float(limits[1])


def _act(net: SignalNet, name: str, part: Actuator, places: Places) -> None:
    if isinstance(part, TorqueActuator):
        numbers = [places.end(body)[0] for body in part.bodies]
        net.torque(name, part.signal, numbers[0], numbers[1] if len(numbers) > 1 else 0)
        return
    (i, p_i, axes_i), (j, p_j, axes_j) = (places.end(end) for end in part.ends)
    if not isinstance(part, ForceActuator):
        net.strut(name, part.signal, i, j, point_i=p_i, point_j=p_j)
        return
    axes = {"world": np.eye(3), "first": axes_i, "second": axes_j}[part.along]
    load = np.zeros(6)
    first = 3 if part.quantity == "moment" else 0
    load[first : first + 3] = axes[:, AXES.index(part.axis)]
    net.force(name, part.signal, i, j, load=load, axes=SIDE[part.along], point=p_i)


def _controller(
    net: SignalNet, name: str, part: Controller, functions: Mapping[str, Function]
) -> SampledController:
    if isinstance(part, PythonController):
        start = part.start or (0.0,) * len(part.outputs)
        if len(start) != len(part.outputs):
            raise CompileError(
                f"controllers.{name}.start: {len(start)} numbers for {len(part.outputs)} outputs"
            )
        for output, value in zip(part.outputs, start, strict=True):
            net.held(output, value)
        function = functions[f"controllers.{name}.function"]
        return SampledController(
            name, function, part.inputs, part.outputs, part.period, part.delay, {}, part.parameters
        )
    net.held(part.output)
    numbers = {
        "kp": part.proportional,
        "ki": part.integral,
        "kd": part.derivative,
        "period": part.period,
    }
    limits = _limits(f"controllers.{name}", part.limits)
    if limits is not None:
        numbers |= {"low": limits[0], "high": limits[1]}
    state = {"integral": 0.0, "error": 0.0}
    return SampledController(
        name, sampled_pid, (part.input,), (part.output,), part.period, part.delay, state, numbers
    )
