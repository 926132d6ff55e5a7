# SPDX-License-Identifier: Apache-2.0
"""Named inputs and outputs of a linear system, as columns and rows of its matrices.

Inputs: a coordinate (`BODY.spin`), a force or moment on a body in world axes (`BODY.fx` ... `BODY.mz`),
`transmission_error[MESH]`, `unbalance[BODY]`. Outputs: a coordinate, a motion of a body in world axes
(`BODY.ux` ... `BODY.rz`), any channel.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.core.nearest import hint
from pitchpoint.solvers.body_shapes import body_motions
from pitchpoint.solvers.channel_slopes import channel_slopes
from pitchpoint.solvers.linear_system import Linearised
from pitchpoint.solvers.mesh_law import mesh_law
from pitchpoint.solvers.missing_motions import missing_motions
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import mesh_names
from pitchpoint.system.system import System

Array = NDArray[np.float64]

LOADS = ("fx", "fy", "fz", "mx", "my", "mz")
MOTIONS = ("ux", "uy", "uz", "rx", "ry", "rz")


@dataclass(frozen=True)
class Input:
    """Generalised forces of a unit excitation: force + i omega rate + omega^2 turning.

    Parameters
    ----------
    name, unit
        Name and unit.
    force, rate, turning
        Shape (nd,), real or complex; `turning` is complex.
    follows
        Motion of the coordinates equivalent to a transmission error of the flanks (`mesh_law`), or zeros,
        shape (nd,).
    mesh
        Index of the mesh of a transmission error, -1 for other inputs.
    direct
        Transmission error per unit that outputs contain in addition to its rate.
    speed
        Speed of the body of an unbalance about its axis [rad/s], for the rates of the analysis; else None.
    """

    name: str
    unit: str
    force: NDArray[np.inexact]
    rate: NDArray[np.inexact]
    turning: NDArray[np.complex128]
    follows: NDArray[np.inexact]
    mesh: int = -1
    direct: complex = 1.0
    speed: float | None = None

    def at(self, omega: float) -> NDArray[np.complex128]:
        """Generalised forces at a circular frequency [rad/s], shape (nd,)."""
        return np.asarray(self.force + 1j * omega * self.rate + omega**2 * self.turning)


@dataclass(frozen=True)
class Outputs:
    """Output equations: y = place q + rate q' + react lambda + feed e.

    Parameters
    ----------
    names, units
        Names and units of the `no` outputs.
    place, rate, react
        Shape (no, nd), (no, nd), (no, nc).
    feed
        Feedthrough of the transmission errors of the flanks, shape (no, number of meshes).
    """

    names: tuple[str, ...]
    units: tuple[str, ...]
    place: Array
    rate: Array
    react: Array
    feed: Array


def coordinate_units(system: System) -> dict[str, str]:
    """Unit of every coordinate."""
    names = system.layout.bodies[1:]
    return {
        f"{name}.{word}": unit
        for body, name in zip(system.bodies, names, strict=True)
        for word, unit in body.coordinates
    }


def input_names(system: System) -> list[str]:
    """Names of all inputs of a system."""
    bodies = system.layout.bodies[1:]
    loads = [f"{b}.{w}" for b in bodies for w in LOADS]
    errors = [f"transmission_error[{m}]" for m in mesh_names(system)]
    return [*coordinate_units(system), *loads, *errors, *(f"unbalance[{b}]" for b in bodies)]


def output_names(system: System) -> list[str]:
    """Names of all outputs of a system."""
    motions = [f"{b}.{w}" for b in system.layout.bodies[1:] for w in MOTIONS]
    return [*coordinate_units(system), *(c.name for c in system.layout.channels), *motions]


def check_names(
    system: System, inputs: Sequence[str], outputs: Sequence[str], bodies: Sequence[str] = ()
) -> None:
    """Refuse unknown names before the computation.

    Parameters
    ----------
    system
        The compiled model.
    inputs, outputs, bodies
        Names as given.

    Raises
    ------
    ModelError
        With all unknown names and their nearest ones.
    """
    kinds = (
        ("input", inputs, input_names(system)),
        ("output", outputs, output_names(system)),
        ("body", bodies, list(system.layout.bodies[1:])),
    )
    problems = [
        Message("", f"no {kind} is called {name!r}", remedy=hint(name, known, 3))
        for kind, given, known in kinds
        for name in given
        if name not in known
    ]
    if problems:
        raise ModelError(problems)


def find_ports(
    linear: Linearised, inputs: Sequence[str], outputs: Sequence[str], rates: Array | None = None
) -> tuple[tuple[Input, ...], Outputs]:
    """Inputs and outputs by name, see `find_inputs` and `find_outputs`.

    Raises
    ------
    ModelError
        With the problems of both.
    """
    problems: list[Message] = []
    try:
        ins = find_inputs(linear, inputs, rates)
    except ModelError as error:
        problems += error.problems
    try:
        outs = find_outputs(linear, outputs)
    except ModelError as error:
        problems += error.problems
    if problems:
        raise ModelError(problems)
    return ins, outs


def find_inputs(linear: Linearised, names: Sequence[str], rates: Array | None = None) -> tuple[Input, ...]:
    """Excitations by name; the names exist, see `check_names`.

    An unbalance rotates as its body does at `rates`, by default those of the operating point.

    Raises
    ------
    ModelError
        If a body cannot move in the direction of its load.
    """
    system = linear.system
    units, nd, meshes = coordinate_units(system), system.sizes["nd"], mesh_names(system)
    zero = np.zeros(nd)
    loads = [n for n in names if n not in units and not n.startswith("transmission_error[")]
    J = body_motions(system, linear.state, np.eye(nd)).real if loads else np.zeros((nd, 0, 6))
    if problems := missing_motions(system, J, loads, LOADS, "input"):
        raise ModelError(problems)
    found = []
    for name in names:
        if name in units:
            force = np.zeros(nd)
            force[system.layout.coordinate(name)] = 1.0
            unit = "N" if units[name] == "m" else "N m"
            found.append(Input(name, unit, force, zero, zero.astype(complex), zero))
            continue
        if name.startswith("transmission_error["):
            found.append(_error_of(linear, name, meshes.index(name[19:-1])))
            continue
        if name.startswith("unbalance["):
            b = system.layout.bodies.index(name[10:-1])
            turning, speed = _turning(linear, J, b, linear.state.v if rates is None else rates)
            found.append(Input(name, "kg m", zero, zero, turning, zero, speed=speed))
            continue
        body, _, word = name.rpartition(".")
        force = J[:, system.layout.bodies.index(body), LOADS.index(word)]
        unit = "N" if word[0] == "f" else "N m"
        found.append(Input(name, unit, force, zero, zero.astype(complex), zero))
    return tuple(found)


def _turning(linear: Linearised, J: Array, b: int, rates: Array) -> tuple[NDArray[np.complex128], float]:
    """Force of an unbalance over omega^2, which rotates with its body, and the speed of the body in space.

    A body at rest counts as rotating from the first axis of its frame to the second.
    """
    state = linear.state.copy()
    state.v[:] = rates
    evaluate.residual(linear.system, state)
    frame = linear.system.workspace.fr[b]
    R, speed = np.array(frame["R"]), float(frame["tw"][3:] @ frame["R"][:, 2])
    evaluate.residual(linear.system, linear.state)
    direction = R[:, 0] - 1j * (-1.0 if speed < 0.0 else 1.0) * R[:, 1]
    return np.asarray(J[:, b, :3] @ direction, dtype=np.complex128), speed


def _error_of(linear: Linearised, name: str, k: int) -> Input:
    """Unloaded transmission error of the flanks of a mesh: travel of the gears less the deflection."""
    law = mesh_law(linear.system, linear.at_rest, k)
    return Input(name, "m", law.stiffness, law.damping, np.zeros(law.turn.size, complex), law.turn, k)


def find_outputs(linear: Linearised, names: Sequence[str]) -> Outputs:
    """Output rows by name; channels are differentiated at the operating point.

    Mesh forces follow the law of the mesh in use, such as the mean over the cycle. The names exist, see
    `check_names`.

    Raises
    ------
    ModelError
        If a body cannot move in a direction, or a channel has no derivative.
    """
    system = linear.system
    nd, nc = system.sizes["nd"], system.sizes["nc"]
    units = coordinate_units(system)
    channels = {c.name: c for c in system.layout.channels}
    meshes = len(mesh_names(system))
    place, rate = np.zeros((len(names), nd)), np.zeros((len(names), nd))
    react, feed = np.zeros((len(names), nc)), np.zeros((len(names), meshes))
    of_channels = [n for n in names if n in channels and n not in units]
    motions = [n for n in names if n not in units and n not in channels]
    J = body_motions(system, linear.state, np.eye(nd)).real if motions else np.zeros((nd, 0, 6))
    problems = missing_motions(system, J, motions, MOTIONS, "output")
    slopes = channel_slopes(linear, of_channels) if of_channels else None
    problems += slopes.problems if slopes else ()
    if problems:
        raise ModelError(problems)
    found = []
    for row, name in enumerate(names):
        if name in units:
            place[row, system.layout.coordinate(name)] = 1.0
            found.append(units[name])
        elif slopes is not None and name in channels:
            o = system.layout.channel(name)
            place[row], rate[row], react[row], feed[row] = (
                part[o] for part in (slopes.place, slopes.rate, slopes.react, slopes.feed)
            )
            found.append(channels[name].unit)
        else:
            body, _, word = name.rpartition(".")
            place[row] = J[:, system.layout.bodies.index(body), MOTIONS.index(word)]
            found.append("m" if word[0] == "u" else "rad")
    return Outputs(tuple(names), tuple(found), place, rate, react, feed)
