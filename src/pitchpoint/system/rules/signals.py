# SPDX-License-Identifier: Apache-2.0
"""Sensors, blocks, actuators and controllers of a model as a signal network."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core import nomenclature
from pitchpoint.core.errors import CompileError
from pitchpoint.core.fmi import fmu_process
from pitchpoint.core.fmi.fmu_file import read_fmu
from pitchpoint.core.fmi.fmu_process import FmuFunction, check_importer
from pitchpoint.core.formula.formula import Formula
from pitchpoint.core.user_law import load_function
from pitchpoint.elements.signals import record as sr
from pitchpoint.elements.signals.dry_friction import add_dry_friction
from pitchpoint.elements.signals.graph import unit_code
from pitchpoint.elements.signals.net import SignalNet
from pitchpoint.elements.signals.record import UNITS
from pitchpoint.model import mechanism
from pitchpoint.model.components import block as bl
from pitchpoint.model.components.actuator import Actuator, ForceActuator, TorqueActuator
from pitchpoint.model.components.controller import (
    Controller,
    DisconController,
    FmuController,
    PythonController,
)
from pitchpoint.model.components.sensor import AXES, FrameSensor, JointSensor, Listener, LoadSensor, Sensor
from pitchpoint.model.signal_units import source_of
from pitchpoint.model.signals import CONTROLLER_ARGUMENTS, LAW_ARGUMENTS, TIME
from pitchpoint.multibody import joints
from pitchpoint.multibody.bodies import Body
from pitchpoint.system.controller import SampledController, sampled_pid
from pitchpoint.system.rules.bodies import body_numbers
from pitchpoint.system.rules.discon import discon_controller
from pitchpoint.system.rules.places import Places

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Course

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


def net_of_model(
    model: Model, bodies: Sequence[Body], places: Places
) -> tuple[SignalNet, list[SampledController]]:
    """Signals and sampled controllers of a model.

    Parameters
    ----------
    model
        The model.
    bodies
        Bodies of its system, including hidden bodies of elements.
    places
        Mapping of ends and markers to records.
    """
    number = body_numbers(model)

    def coordinate(name: str) -> tuple[int, int]:
        """Numbers of body and coordinate of a sensor."""
        found = mechanism.coordinate(model.mechanism, model, name)
        if isinstance(found, str):
            raise CompileError(f"the sensor of {name} {found}")
        return number[found[0]], found[1]

    functions = {}
    for section, arguments in ((model.blocks, LAW_ARGUMENTS), (model.controllers, CONTROLLER_ARGUMENTS)):
        for name, part in section.items():
            if isinstance(part, bl.LawBlock | PythonController):
                where = f"{'blocks' if section is model.blocks else 'controllers'}.{name}.function"
                file = Path(part.function.file)
                functions[where] = load_function(
                    f"{file.name}:{part.function.function}",
                    file.parent,
                    arguments,
                    allow_code=True,
                    where=where,
                )
    courses = places.scenario.inputs if places.scenario is not None else {}
    machine = Machine(bodies, places, coordinate, functions, courses)
    return signal_net(machine, model.sensors, model.blocks, model.actuators, model.controllers)


@dataclass(frozen=True)
class Machine:
    """Mapping of the names used in signals to the system.

    Parameters
    ----------
    bodies
        All bodies of the system so far, including hidden bodies of other elements.
    places
        Mapping of ends and markers to records.
    coordinate
        Function of JOINT.COORDINATE, or of a body for its spin: body number and index of the coordinate.
    functions
        Python functions by their path in the model: "blocks.NAME.function", "controllers.NAME.function".
    courses
        Courses of inputs in the scenario, by the name of the block.
    """

    bodies: Sequence[Body]
    places: Places
    coordinate: Callable[[str], tuple[int, int]]
    functions: Mapping[str, Function]
    courses: Mapping[str, Course] = field(default_factory=dict)


def signal_net(
    machine: Machine,
    sensors: Mapping[str, Sensor],
    blocks: Mapping[str, bl.Block],
    actuators: Mapping[str, Actuator],
    controllers: Mapping[str, Controller],
) -> tuple[SignalNet, list[SampledController]]:
    """Signals of a model and its sampled controllers, for `system.signals.assemble_controlled`.

    Parameters
    ----------
    machine
        Mapping of names to bodies, coordinates and functions.
    sensors, blocks, actuators, controllers
        Components by name; sensors and blocks give their names to their signals.
    """
    net = SignalNet(machine.bodies)
    for name, sensor in sensors.items():
        _sense(net, name, sensor, machine)
    for name, block in blocks.items():
        if isinstance(block, bl.Input):
            _input(net, name, block, machine.courses.get(name))
        else:
            _compute(net, name, block, machine.functions)
    made = [_controller(net, name, part, machine.functions) for name, part in controllers.items()]
    for name in blocks:
        net.nodes[name].fields["unit"] = unit_code(_unit_of(net, name, blocks))
    for name, actuator in actuators.items():
        _act(net, name, actuator, machine.places)
    return net, made


def _unit_of(net: SignalNet, name: str, blocks: Mapping[str, bl.Block]) -> str:
    """Unit of a signal; limits and filters have the unit of their input."""
    name = source_of(blocks, name)
    if name in blocks:
        return str(getattr(blocks[name], "unit", "1"))
    return UNITS[net.nodes[name].fields["unit"]] if name in net.nodes else "1"


def _sense(net: SignalNet, name: str, part: Sensor, machine: Machine) -> None:
    places = machine.places
    if isinstance(part, FrameSensor):
        (i, p_i, _), (j, p_j, axes) = (places.end(end) for end in part.ends)
        k = AXES.index(part.axis)
        across: dict[str, Any] = {}
        if part.quantity == "angle":  # between the markers, about the axis of the second
            own = places.end(part.ends[0])[2]
            across = {"direction_i": own[:, (k + 1) % 3], "direction_j": axes[:, (k + 1) % 3]}
        net.sensor(name, QUANTITY[part.quantity], i, j, axis=axes[:, k], point_i=p_i, point_j=p_j, **across)
    elif isinstance(part, JointSensor):
        body, place = machine.coordinate(part.coordinate)
        moved = joints.AXES[machine.bodies[body - 1].motion][place]
        net.joint_sensor(name, body, joints.DISPLACEMENTS[moved][0], part.derivative)
    elif isinstance(part, LoadSensor):
        body, point, _ = places.end(part.at)
        seen, _, axes = places.end(part.seen_from)
        axis = axes[:, AXES.index(part.axis)]
        net.reaction(name, body, moment=part.quantity == "moment", axis=axis, axis_on=seen, point=point)
    elif isinstance(part, Listener):
        known = nomenclature.unit(part.channel)
        net.listen(name, part.channel, known if known in UNITS else "1")


def _compute(net: SignalNet, name: str, part: bl.Block, functions: Mapping[str, Function]) -> None:
    if isinstance(part, bl.Sum):
        net.linear(name, part.inputs, part.offset)
    elif isinstance(part, bl.Limits):
        net.saturation(name, part.input, *part.limits)
    elif isinstance(part, bl.Curve):
        net.table(name, part.input, *zip(*part.points, strict=True))
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
    elif isinstance(part, bl.RateLimit):
        net.rate_limit(name, part.input, part.rate, part.time_constant, part.start)
    elif isinstance(part, bl.DryFriction):
        add_dry_friction(net, name, part.input, part.wind_up, part.holding, part.damping_time)
    elif isinstance(part, bl.TransferFunction):
        net.transfer_function(name, part.input, part.numerator, part.denominator)
    elif isinstance(part, bl.Pid):
        net.pid(
            name,
            part.input,
            kp=part.proportional,
            ki=part.integral,
            kd=part.derivative,
            filter_time=part.filter_time,
            limits=part.limits,
            tracking_time=part.tracking_time or 0.0,
        )


def _input(net: SignalNet, name: str, part: bl.Input, course: Course | None) -> None:
    """Signal of an input with its course in the scenario."""
    if course is not None and course.formula is not None:
        net.formula(name, Formula.parse(course.formula, (TIME,)), (TIME,))
    elif course is not None and course.points is not None:
        net.formula(f"{name}.time", Formula.parse(TIME, (TIME,)), (TIME,))
        net.table(name, f"{name}.time", *zip(*course.points, strict=True))
    else:
        value = course.value if course is not None and course.value is not None else part.value
        net.linear(name, {}, value)


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
    net.nodes[name].fields["unit"] = unit_code("N m" if first else "N")


def _controller(
    net: SignalNet, name: str, part: Controller, functions: Mapping[str, Function]
) -> SampledController:
    if isinstance(part, PythonController):
        start = part.start or (0.0,) * len(part.outputs)
        for output, value in zip(part.outputs, start, strict=True):
            net.held(output, value, part.unit)
        function = functions[f"controllers.{name}.function"]
        return SampledController(
            name, function, part.inputs, part.outputs, part.period, part.delay, {}, part.parameters
        )
    if isinstance(part, DisconController):
        return discon_controller(net, name, part)
    if isinstance(part, FmuController):
        return _fmu(net, name, part)
    net.held(part.output, part.start, part.unit)
    numbers = {
        "kp": part.proportional,
        "ki": part.integral,
        "kd": part.derivative,
        "period": part.period,
    }
    if part.limits is not None:
        numbers |= {"low": part.limits[0], "high": part.limits[1]}
    state = {"integral": part.start, "error": None}
    return SampledController(
        name, sampled_pid, (part.input,), (part.output,), part.period, part.delay, state, numbers
    )


def _fmu(net: SignalNet, name: str, part: FmuController) -> SampledController:
    """Functional mock-up unit as a sampled controller: it is called at its communication points."""
    check_importer()
    file = read_fmu(part.file)
    inputs, outputs, numbers = (
        tuple(file.variables[variable] for variable in group)
        for group in (part.inputs, part.outputs, part.parameters)
    )
    start = part.start or (0.0,) * len(outputs)
    for signal, value, variable in zip(part.outputs.values(), start, outputs, strict=True):
        net.held(signal, value, variable.unit if variable.unit in UNITS[1:] else "1")
    parameters = tuple(zip(numbers, part.parameters.values(), strict=True))
    function = FmuFunction(file, inputs, outputs, parameters, part.time_limit)
    signals = tuple(part.inputs.values()), tuple(part.outputs.values())
    keeping = fmu_process.save, fmu_process.restore
    return SampledController(
        name, function, *signals, part.period, 0.0, {}, finish=fmu_process.finish, keeping=keeping
    )
