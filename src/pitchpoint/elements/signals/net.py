# SPDX-License-Identifier: Apache-2.0
"""Signal nets by name: sensors, blocks with and without states, actuators.

A signal is a named scalar. Names may be used before they are defined; `SignalNet.records` sorts all signals
into evaluation order. Blocks with states consist of integrators and linear combinations::

    net = SignalNet(bodies)
    net.sensor("angle", ANGLE, 1)
    net.linear("error", {"angle": -1.0}, offset=0.5)
    net.pid("control", "error", kp=4.0, ki=2.0, kd=0.1, filter_time=0.01)
    net.torque("motor", "control", 1)
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.elements.signals import record as sr
from pitchpoint.elements.signals.graph import LOADS, Node, make_records, unit_code
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.joints import AXES, DISPLACEMENTS, TORSION

_UNIT_OF = {
    sr.POSITION: "m",
    sr.VELOCITY: "m/s",
    sr.ACCELERATION: "m/s^2",
    sr.DISTANCE: "m",
    sr.DISTANCE_RATE: "m/s",
    sr.ANGLE: "rad",
    sr.ANGULAR_VELOCITY: "rad/s",
    sr.ANGULAR_ACCELERATION: "rad/s^2",
    sr.REACTION_FORCE: "N",
    sr.REACTION_MOMENT: "N m",
}
_BY_RATE = (
    (sr.POSITION, sr.VELOCITY, sr.ACCELERATION),
    (sr.ANGLE, sr.ANGULAR_VELOCITY, sr.ANGULAR_ACCELERATION),
)
Three = ArrayLike


class SignalNet:
    """Signals of a system.

    Parameters
    ----------
    bodies
        Bodies of the system without hidden bodies of states, in their order.
    """

    def __init__(self, bodies: Sequence[Body]) -> None:
        self.bodies = tuple(bodies)
        self.nodes: dict[str, Node] = {}
        self.states: list[Body] = []
        self.listened: dict[str, str] = {}

    def _add(self, node: Node) -> None:
        if node.name in self.nodes or node.name == "t":
            raise CompileError(f"signal {node.name!r}: the name is already in use")
        for key, value in node.fields.items():
            if not np.all(np.isfinite(value)) and key not in ("low", "high"):
                raise CompileError(f"signal {node.name!r}: {key} is {value}, not a finite number")
        if node.op not in (sr.FORMULA, sr.TABLE) and not np.all(np.isfinite(np.asarray(node.numbers, float))):
            raise CompileError(f"signal {node.name!r}: its numbers must be finite")
        node.fields.setdefault("unit", 1)
        self.nodes[node.name] = node

    # ------------------------------------------------------------------------------------------- sensors

    def sensor(
        self,
        name: str,
        quantity: int,
        i: int,
        j: int = 0,
        *,
        axis: Three = (0.0, 0.0, 1.0),
        point_i: Three = (0.0, 0.0, 0.0),
        point_j: Three = (0.0, 0.0, 0.0),
        direction_i: Three | None = None,
        direction_j: Three | None = None,
    ) -> None:
        """Add a sensor of a kinematic quantity between two frames.

        Parameters
        ----------
        name, quantity
            Name of the signal; POSITION to ANGULAR_ACCELERATION of `signals.record`.
        i, j
            Body whose motion is measured, and reference body (0 = ground).
        axis
            Axis of a component or of an angle, fixed to body j; any nonzero length.
        point_i, point_j
            Points on both bodies, in body axes [m].
        direction_i, direction_j
            Directions normal to the axis; the angle is from j to i. Default: the angle is zero with all
            coordinates zero.
        """
        e = _unit(name, axis)
        fields: dict[str, Any] = {"i": i, "j": j, "p_i": point_i, "p_j": point_j, "e": e}
        if quantity == sr.ANGLE:
            fields |= self._angle(name, i, j, e, direction_i, direction_j)
        if quantity not in _UNIT_OF or quantity in LOADS:
            raise CompileError(f"signal {name!r}: {quantity} is not a kinematic quantity")
        fields["unit"] = unit_code(_UNIT_OF[quantity])
        self._add(Node(name, quantity, (), fields))

    def _axes(self, b: int) -> NDArray[np.float64]:
        return np.asarray(self.bodies[b - 1].axes, float) if b else np.eye(3)

    def _angle(
        self, name: str, i: int, j: int, axis: NDArray[np.float64], from_i: Three | None, from_j: Three | None
    ) -> dict[str, Any]:
        """Record fields of an angle: its directions, and its value with all coordinates zero."""
        across = np.eye(3)[int(np.argmin(np.abs(axis)))] if from_j is None else np.asarray(from_j, float)
        e = _unit(name, across - (across @ axis) * axis)
        turned = self._axes(i).T @ self._axes(j)
        x = turned @ e if from_i is None else _unit(name, from_i)
        y = np.cross(axis, e)
        rest = turned.T @ x
        return {"e": e, "y": y, "x_i": x, "low": math.atan2(rest @ y, rest @ e)}

    def joint_sensor(self, name: str, body: int, coordinate: str, derivative: int = 0) -> None:
        """Add a sensor of a joint coordinate, its rate (`derivative` 1) or acceleration (2).

        A rotation requires a joint whose only rotation is the spin: other joints have no plane angle.
        """
        b = self.bodies[body - 1]
        m = [d for d, _ in DISPLACEMENTS].index(coordinate)
        free = AXES[b.motion]
        if m not in free or m in (3, 4) or (m == 5 and (3 in free or 4 in free)):
            raise CompileError(
                f"signal {name!r}: {coordinate} of {b.name!r} is not measurable; use an angle between frames"
            )
        outer = self.bodies[b.parent - 1] if b.parent else Body(name="ground")
        frame = np.asarray(outer.axes, float).T @ np.asarray(b.axes, float)
        place = np.asarray(outer.axes, float).T @ (np.asarray(b.position) - np.asarray(outer.position))
        axis = frame[:, 2 if m == 5 else m]
        quantity = _BY_RATE[m == 5][derivative]
        self.sensor(name, quantity, body, b.parent, axis=axis, point_j=place)

    def reaction(
        self,
        name: str,
        body: int,
        *,
        moment: bool = False,
        axis: Three = (0.0, 0.0, 1.0),
        axis_on: int = 0,
        point: Three = (0.0, 0.0, 0.0),
    ) -> None:
        """Add a sensor of the joint reaction on a body: component along an axis fixed to a body.

        Parameters
        ----------
        name, body
            Name of the signal; body whose joint reaction is measured.
        moment
            True: moment about the point [N m]; False: force [N].
        axis, axis_on
            Axis of the component and the body it is fixed to (0 = ground).
        point
            Point on the body, in body axes [m].
        """
        beyond = [k for k in range(1, len(self.bodies) + 1) if body in self._way(k)]
        op = sr.REACTION_MOMENT if moment else sr.REACTION_FORCE
        fields = {"i": body, "j": axis_on, "p_i": point, "e": _unit(name, axis), "n": len(beyond)}
        fields["unit"] = unit_code(_UNIT_OF[op])
        self._add(Node(name, op, (), fields, [float(k) for k in beyond]))

    def _way(self, k: int) -> list[int]:
        """A body and its parents up to ground."""
        found = []
        while k:
            found.append(k)
            k = self.bodies[k - 1].parent
        return found

    def listen(self, name: str, channel: str, unit: str = "1") -> None:
        """Add a sensor of an observation of another element by its name, such as ``tension[spring]``.

        The value may be one iteration old, and tangents do not contain its derivative: put a state between
        the sensor and its actuators.
        """
        self._add(Node(name, sr.CHANNEL, (), {"unit": unit_code(unit)}))
        self.listened[name] = channel

    # -------------------------------------------------------------------------------------------- blocks

    def linear(self, name: str, terms: Mapping[str, float], offset: float = 0.0, unit: str = "1") -> None:
        """Add a sum of signals times gains, plus a constant."""
        fields = {"value": offset, "unit": unit_code(unit)}
        self._add(Node(name, sr.LINEAR, tuple(terms), fields, list(terms.values())))

    def saturation(self, name: str, x: str, low: float, high: float) -> None:
        """Add a saturation: a signal limited to a range."""
        if not low < high:
            raise CompileError(f"signal {name!r}: lower limit {low} (limit below the upper limit {high})")
        self._add(Node(name, sr.SATURATION, (x,), {"low": low, "high": high}))

    def table(self, name: str, x: str, xs: ArrayLike, ys: ArrayLike) -> None:
        """Add a table over another signal, linear between its points, constant beyond the ends."""
        a, b = np.asarray(xs, float), np.asarray(ys, float)
        if a.ndim != 1 or a.shape != b.shape or a.size < 2 or np.any(np.diff(a) <= 0.0):
            raise CompileError(f"signal {name!r}: a table needs two points or more with increasing abscissa")
        self._add(Node(name, sr.TABLE, (x,), {"n": a.size}, np.concatenate([a, b])))

    def formula(self, name: str, formula: Any, inputs: Sequence[str], unit: str = "1") -> None:
        """Add a `Formula` of up to three inputs in the order of its variables; "t" is the time."""
        if len(inputs) != len(formula.variables):
            raise CompileError(f"signal {name!r}: its formula has {len(formula.variables)} inputs")
        numbers = np.concatenate([formula.ops.view(np.float64), formula.workspace()])
        fields = {"n": formula.ops.size, "unit": unit_code(unit)}
        self._add(Node(name, sr.FORMULA, tuple(inputs), fields, numbers))

    def law(
        self, name: str, x: str, function: Callable[..., float] | int, parameters: Sequence[float] = ()
    ) -> None:
        """Add a user law f(t, x, p) of the time and another signal; it should be differentiable in x."""
        numbers = np.asarray([*parameters, 0.0], float)
        self._add(Node(name, sr.LAW, (x,), {"n": len(parameters)}, numbers, law=function))

    def held(self, name: str, start: float = 0.0, unit: str = "1") -> None:
        """Add the output of a sampled controller: constant between sampling instants."""
        self._add(Node(name, sr.HELD, (), {"value": start, "unit": unit_code(unit)}, [start]))

    def integrator(self, name: str, rate: str, start: float = 0.0, unit: str = "1") -> None:
        """Add a state whose rate is another signal."""
        k = len(self.states)
        # start angle 1, on which nothing depends: error norms are relative to the size of coordinates
        hidden = Body(
            motion=TORSION, polar_inertia=1.0, start=(1.0,), rate=(start,), name=f"state.{name}", state=True
        )
        self.states.append(hidden)
        self._add(Node(name, sr.STATE, (), {"unit": unit_code(unit)}, state=k))
        self._add(Node(f"{name}.rate", sr.RATE, (rate,), {}, state=k))

    def low_pass(self, name: str, x: str, time_constant: float, start: float = 0.0, unit: str = "1") -> None:
        """Add a first-order low-pass filter, T y' + y = x."""
        if not time_constant > 0.0:
            raise CompileError(f"signal {name!r}: its time constant must be positive, not {time_constant}")
        self.linear(f"{name}.change", {x: 1.0 / time_constant, name: -1.0 / time_constant})
        self.integrator(name, f"{name}.change", start, unit)

    def rate_limit(self, name: str, x: str, rate: float, time_constant: float, start: float = 0.0) -> None:
        """Add a first-order lag with limited rate, y' = (x - y)/T within -rate and rate."""
        if not (time_constant > 0.0 and rate > 0.0):
            raise CompileError(f"signal {name!r}: its time constant and rate must be positive")
        self.linear(f"{name}.change", {x: 1.0 / time_constant, name: -1.0 / time_constant})
        self.saturation(f"{name}{sr.LIMITED}", f"{name}.change", -rate, rate)
        self.integrator(name, f"{name}{sr.LIMITED}", start)

    def second_order(self, name: str, x: str, omega: float, zeta: float) -> None:
        """Add a second-order filter, y'' + 2 zeta omega y' + omega^2 y = omega^2 x."""
        self.transfer_function(name, x, [omega**2], [1.0, 2.0 * zeta * omega, omega**2])

    def transfer_function(self, name: str, x: str, num: Sequence[float], den: Sequence[float]) -> None:
        """Add a transfer function (descending powers of s) in controllable canonical form, from rest.

        T. Kailath, Linear Systems (1980), 2.1.
        """
        if not len(den) > 1 or den[0] == 0.0 or len(num) > len(den):
            raise CompileError(f"signal {name!r}: order of the numerator above that of {list(den)}")
        order = len(den) - 1
        a = np.asarray(den[1:], float)[::-1] / den[0]
        b = np.zeros(order + 1)
        b[: len(num)] = np.asarray(num, float)[::-1] / den[0]
        through = b[order]
        states = [f"{name}.x{k}" for k in range(order)]
        for k, state in enumerate(states[:-1]):
            self.integrator(state, states[k + 1])
        self.linear(f"{name}.top", {x: 1.0, **{s: -float(c) for s, c in zip(states, a, strict=True)}})
        self.integrator(states[-1], f"{name}.top")
        out = {s: float(b[k] - a[k] * through) for k, s in enumerate(states)}
        self.linear(name, {**out, x: float(through)} if through else out)

    def pid(
        self,
        name: str,
        error: str,
        *,
        kp: float,
        ki: float = 0.0,
        kd: float = 0.0,
        filter_time: float = 0.0,
        limits: tuple[float, float] | None = None,
        tracking_time: float = 0.0,
    ) -> None:
        """Add a PID controller with filtered derivative and, with limits, back-calculation anti-windup.

        u = kp e + I + kd (e - x)/T_f,  T_f x' = e - x,  I' = ki e + (sat(u) - u)/T_t.
        K. J. Astrom, T. Hagglund, PID Controllers (1995), 3.3 and 3.5.

        Parameters
        ----------
        name, error
            Name of the output; signal of the control error.
        kp, ki, kd
            Proportional, integral and derivative gain.
        filter_time
            Time constant of the derivative filter [s]; required with kd.
        limits
            Limits of the output.
        tracking_time
            T_t [s]; default sqrt(T_i T_d), or T_i without kd, with T_i = kp/ki and T_d = kd/kp.
        """
        if kd != 0.0 and not filter_time > 0.0:
            raise CompileError(f"signal {name!r}: the derivative requires a positive filter_time")
        free = name if limits is None else f"{name}.free"
        terms = {error: kp}
        if kd != 0.0:
            self.low_pass(f"{name}.filtered", error, filter_time)
            terms = {error: kp + kd / filter_time, f"{name}.filtered": -kd / filter_time}
        if ki != 0.0:
            terms[f"{name}.integral"] = 1.0
            rate = {error: ki}
            if limits is not None:
                t_i = kp / ki
                track = tracking_time or (math.sqrt(t_i * kd / kp) if kd and kp else t_i)
                if not track > 0.0:
                    raise CompileError(f"signal {name!r}: give a positive tracking_time")
                rate |= {name: 1.0 / track, free: -1.0 / track}
            self.linear(f"{name}.integrand", rate)
            self.integrator(f"{name}.integral", f"{name}.integrand")
        self.linear(free, terms)
        if limits is not None:
            self.saturation(name, free, *limits)

    # ----------------------------------------------------------------------------------------- actuators

    def torque(self, name: str, x: str, i: int, j: int = 0) -> None:
        """Add a torque on body i about the common spin axis, reaction on body j, as of the kind torque."""
        self._add(Node(name, sr.TORQUE, (x,), {"i": i, "j": j, "unit": unit_code("N m")}))

    def strut(
        self,
        name: str,
        x: str,
        i: int,
        j: int = 0,
        *,
        point_i: Three = (0.0, 0.0, 0.0),
        point_j: Three = (0.0, 0.0, 0.0),
    ) -> None:
        """Add a force between a point of body i and one of body j; a positive signal pushes them apart."""
        fields = {"i": i, "j": j, "p_i": point_i, "p_j": point_j, "unit": unit_code("N")}
        self._add(Node(name, sr.STRUT, (x,), fields))

    def force(
        self,
        name: str,
        x: str,
        i: int,
        j: int = 0,
        *,
        load: Three,
        axes: int = sr.WORLD,
        point: Three = (0.0, 0.0, 0.0),
    ) -> None:
        """Add a force and moment, `load` (6) at a signal of 1, at a point of body i, with reaction on j."""
        fields = {"i": i, "j": j, "F": load, "axes": axes, "p_i": point, "unit": unit_code("N")}
        self._add(Node(name, sr.FORCE, (x,), fields))

    # ------------------------------------------------------------------------------------------- records

    @property
    def kind(self) -> str:
        """Kind of the records; it runs after all other kinds if loads are measured."""
        late = any(node.op in LOADS for node in self.nodes.values())
        return "signal_of_loads" if late or self._bent_acceleration() else "signal_flow"

    def _bent_acceleration(self) -> bool:
        """Whether measured accelerations may pass a nonlinear block, so that one solve is not sufficient."""
        sensed = any(n.op in (sr.ACCELERATION, sr.ANGULAR_ACCELERATION) for n in self.nodes.values())
        return sensed and any(sr.LINEAR < n.op < sr.HELD for n in self.nodes.values())

    def records(self) -> tuple[NDArray[np.void], list[str], NDArray[np.float64], list[Any]]:
        """Records, names, pool and laws; the bodies of the states follow those of the system."""
        return make_records(self.nodes, len(self.bodies) + 1)


def _unit(name: str, vector: Three) -> NDArray[np.float64]:
    """Unit vector in the direction of a vector."""
    v = np.asarray(vector, float)
    size = float(np.linalg.norm(v))
    if v.shape != (3,) or not (size > 0.0 and math.isfinite(size)):
        raise CompileError(f"signal {name!r}: {v} is not a direction")
    return v / size
