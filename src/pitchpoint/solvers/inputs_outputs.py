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
from pitchpoint.solvers.cycle_means import observe_at, observed_phases
from pitchpoint.solvers.linear_system import Linearised
from pitchpoint.solvers.mesh_law import mesh_law, stiffness_now
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import mesh_names, mesh_record
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

LOADS = ("fx", "fy", "fz", "mx", "my", "mz")
MOTIONS = ("ux", "uy", "uz", "rx", "ry", "rz")
MESH_FORCES = ("mesh_force", "normal_force", "circumferential_force", "radial_force", "axial_force")
"""Channels of a mesh that are parts of its force along the base tangent."""
STEP = 2e-10
"""Step of finite differences [m]: below the penetration at which unloaded flanks are assumed in contact."""
RATE = 1e-6
"""Step of finite differences of the rates [m/s]."""


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


def find_inputs(linear: Linearised, names: Sequence[str], rates: Array | None = None) -> tuple[Input, ...]:
    """Excitations by name; the names exist, see `check_names`.

    An unbalance rotates as its body does at `rates`, by default those of the operating point.
    """
    system = linear.system
    units, nd, meshes = coordinate_units(system), system.sizes["nd"], mesh_names(system)
    zero = np.zeros(nd)
    found, J = [], None
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
        J = body_motions(system, linear.state, np.eye(nd)).real if J is None else J
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


def _by_travel(system, k: int, request) -> Array:  # type: ignore[no-untyped-def]
    """Derivative of the result of `request` with respect to the assembled travel of a mesh."""
    record = mesh_record(system, k)
    kept, sides = float(record["u0"]), []
    for sign in (1.0, -1.0):
        record["u0"] = kept + sign * STEP
        sides.append(request())
    record["u0"] = kept
    return np.asarray((sides[0] - sides[1]) / (2.0 * STEP))


def find_outputs(linear: Linearised, names: Sequence[str]) -> Outputs:
    """Output rows by name; channels are differentiated at the operating point.

    Mesh forces follow the law of the mesh in use, such as the mean over the cycle. The names exist, see
    `check_names`.
    """
    system = linear.system
    nd, nc = system.sizes["nd"], system.sizes["nc"]
    units = coordinate_units(system)
    channels = {c.name: c for c in system.layout.channels}
    meshes = len(mesh_names(system))
    place, rate = np.zeros((len(names), nd)), np.zeros((len(names), nd))
    react, feed = np.zeros((len(names), nc)), np.zeros((len(names), meshes))
    found, J, slopes = [], None, None
    for row, name in enumerate(names):
        if name in units:
            place[row, system.layout.coordinate(name)] = 1.0
            found.append(units[name])
        elif name in channels:
            slopes = _slopes(linear, meshes) if slopes is None else slopes
            o = system.layout.channel(name)
            place[row], rate[row], react[row], feed[row] = (part[o] for part in slopes)
            found.append(channels[name].unit)
        else:
            J = body_motions(system, linear.state, np.eye(nd)).real if J is None else J
            body, _, word = name.rpartition(".")
            place[row] = J[:, system.layout.bodies.index(body), MOTIONS.index(word)]
            found.append("m" if word[0] == "u" else "rad")
    return Outputs(tuple(names), tuple(found), place, rate, react, feed)


def _slopes(linear: Linearised, meshes: int) -> tuple[Array, Array, Array, Array]:
    """Derivatives of all channels with respect to coordinates, rates, multipliers and flank errors."""
    system, state = linear.system, linear.state
    weight = system.weight
    largest = float(np.abs(state.lam).max(initial=0.0))
    place, rate, react = (
        _differences(system, state, "q", STEP / weight),
        _differences(system, state, "v", RATE / weight),
        _differences(system, state, "lam", np.full(state.lam.size, 1e-3 * (1.0 + largest))),
    )
    feed = np.zeros((system.sizes["no"], meshes))
    for k, name in enumerate(mesh_names(system)):
        by_travel = _by_travel(system, k, lambda: evaluate.observe(system, state))
        by_travel[system.layout.channel(f"transmission_error[{name}]")] = 0.0  # independent of the flanks
        _follow_the_law(linear, k, by_travel, (place, rate))
        feed[:, k] = -by_travel
    return place, rate, react, feed


def _follow_the_law(linear: Linearised, k: int, by_travel: Array, slopes: tuple[Array, Array]) -> None:
    """Replace slopes of the channels of a mesh by those of its law; `by_travel`: theirs over the travel.

    A rotation of the gears acts through the travel alone. Forces are parts of the force along the base
    tangent; displaced gears change in addition their direction.
    """
    system, (place, rate) = linear.system, slopes
    law = mesh_law(system, linear.at_rest, k)
    name, turning = mesh_names(system)[k], law.travel != 0.0
    own = [o for o in np.flatnonzero(by_travel).tolist() if _is_of(system.layout.channels[o].name, name)]
    if not law.turn.any():
        return
    stiffness = stiffness_now(system, linear.state, k, law)
    for o in own:
        place[o, turning] = by_travel[o] * law.travel[turning]
        rate[o, turning] = float(rate[o] @ law.turn) * law.travel[turning]
    along = system.layout.channel(f"mesh_force[{name}]")
    found = place[along].copy()
    for word in MESH_FORCES if stiffness > 0.0 else ():
        o = system.layout.channel(f"{word}[{name}]")
        part = 1.0 if o == along else by_travel[o] / stiffness
        of_direction = np.where(turning, 0.0, place[o] - by_travel[o] / by_travel[along] * found)
        place[o] = part * law.force + (0.0 if o == along else of_direction)
        by_travel[o] = float(place[o] @ law.turn)
    rate[along] = law.force_by_rate


def _is_of(channel: str, mesh: str) -> bool:
    """Whether a channel is one of a mesh or of its tooth pairs, such as `pair_force[stage.0]`."""
    inside = channel.partition("[")[2].rstrip("]")
    return inside == mesh or inside.startswith(f"{mesh}.")


def _differences(system, state: State, key: str, steps: Array) -> Array:  # type: ignore[no-untyped-def]
    """Central differences of all channels with respect to one part of the state, shape (no, n).

    The phases of the meshes are fixed, as in the matrices.
    """
    found = np.zeros((system.sizes["no"], steps.size))
    phases = {
        m: (flank, phase[flank])
        for m, (contact, phase) in observed_phases(system, state, range(len(mesh_names(system))))
        for flank in (-1 if contact < 0.0 else 1,)
    }
    for k, step in enumerate(steps):
        sides = []
        for sign in (1.0, -1.0):
            moved = state.copy()
            getattr(moved, key)[k] += sign * step
            sides.append(observe_at(system, moved, phases if key == "q" else {}))
        found[:, k] = (sides[0] - sides[1]) / (2.0 * step)
    return found
