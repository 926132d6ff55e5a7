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

from pitchpoint.core.errors import SolverError
from pitchpoint.core.nearest import hint
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.solvers.body_shapes import body_motions
from pitchpoint.solvers.element_tangents import tangents
from pitchpoint.solvers.linear_system import Linearised
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import mesh_names, mesh_record, one_mesh
from pitchpoint.system.system import State

Array = NDArray[np.float64]

LOADS = ("fx", "fy", "fz", "mx", "my", "mz")
MOTIONS = ("ux", "uy", "uz", "rx", "ry", "rz")
MESH_FORCES = ("mesh_force", "normal_force", "circumferential_force", "radial_force", "axial_force")
"""Channels of a mesh that are proportional to its stiffness."""
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
        Shape (nd,); `turning` is complex.
    follows
        Motion of the coordinates equivalent to a transmission error of the flanks, or zeros, shape (nd,).
    mesh
        Index of the mesh of a transmission error, -1 for other inputs.
    """

    name: str
    unit: str
    force: Array
    rate: Array
    turning: NDArray[np.complex128]
    follows: Array
    mesh: int = -1

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


def coordinate_units(linear: Linearised) -> dict[str, str]:
    """Unit of every coordinate."""
    system = linear.system
    names = system.layout.bodies[1:]
    return {
        f"{name}.{word}": unit
        for body, name in zip(system.bodies, names, strict=True)
        for word, unit in body.coordinates
    }


def _unknown(name: str, known: Sequence[str], what: str) -> SolverError:
    return SolverError(f"no {what} is called {name!r}; {hint(name, known)}", INCONSISTENT)


def find_inputs(linear: Linearised, names: Sequence[str]) -> tuple[Input, ...]:
    """Excitations by name.

    Raises
    ------
    SolverError
        If there is no such coordinate, body or mesh.
    """
    system = linear.system
    units, nd = coordinate_units(linear), system.sizes["nd"]
    meshes, bodies = mesh_names(system), system.layout.bodies[1:]
    known = [*units, *(f"{b}.{w}" for b in bodies for w in LOADS)]
    known += [f"transmission_error[{m}]" for m in meshes] + [f"unbalance[{b}]" for b in bodies]
    zero = np.zeros(nd)
    found, J = [], None
    for name in names:
        if name not in known:
            raise _unknown(name, known, "input")
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
            found.append(Input(name, "kg m", zero, zero, _turning(linear, J, b), zero))
            continue
        body, _, word = name.rpartition(".")
        force = J[:, system.layout.bodies.index(body), LOADS.index(word)]
        unit = "N" if word[0] == "f" else "N m"
        found.append(Input(name, unit, force, zero, zero.astype(complex), zero))
    return tuple(found)


def _turning(linear: Linearised, J: Array, b: int) -> NDArray[np.complex128]:
    """Force of an unbalance over omega^2; it rotates from the first axis of the frame to the second."""
    evaluate.residual(linear.system, linear.state)
    frame = linear.system.workspace.fr[b]
    sense = -1.0 if frame["spin"] < 0.0 else 1.0
    direction = frame["R"][:, 0] - 1j * sense * frame["R"][:, 1]
    return np.asarray(J[:, b, :3] @ direction, dtype=np.complex128)


def _error_of(linear: Linearised, name: str, k: int) -> Input:
    """Unloaded transmission error of the flanks of a mesh: relative travel of the gears less the deflection.

    It acts like a relative travel of the gears, through the stiffness in use (mean over the cycle or that of
    one phase) and the damping of the mesh.
    """
    system, stopped = linear.system, linear.state.copy()
    stopped.v[:] = 0.0
    force = _by_travel(system, k, lambda: evaluate.residual(system, stopped))
    D, K = (evaluate.dense(system, A) for A in tangents(system, stopped, one_mesh(system, k)))
    used = np.flatnonzero(np.any(K != 0.0, axis=0) | (force != 0.0))
    weight = system.weight[used]
    scaled = np.linalg.lstsq(
        K[np.ix_(used, used)] / np.outer(weight, weight), force[used] / weight, rcond=1e-9
    )[0]
    follows = np.zeros_like(force)
    follows[used] = scaled / weight
    share = linear.at_rest.shares[linear.at_rest.elements.index(f"mesh {mesh_names(system)[k]}")]
    mean = np.zeros_like(force)
    mean[share.places] = share.matrix @ follows[share.places]
    nothing = np.zeros(force.size, complex)
    return Input(name, "m", mean, D @ follows, nothing, follows, k)


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

    Mesh forces are scaled to the stiffness in use, such as the mean over the cycle.

    Raises
    ------
    SolverError
        If there is no such coordinate, body or channel.
    """
    system = linear.system
    nd, nc = system.sizes["nd"], system.sizes["nc"]
    units = coordinate_units(linear)
    channels = {c.name: c for c in system.layout.channels}
    bodies = system.layout.bodies[1:]
    known = [*units, *channels, *(f"{b}.{w}" for b in bodies for w in MOTIONS)]
    meshes = len(mesh_names(system))
    place, rate = np.zeros((len(names), nd)), np.zeros((len(names), nd))
    react, feed = np.zeros((len(names), nc)), np.zeros((len(names), meshes))
    found, J, slopes = [], None, None
    for row, name in enumerate(names):
        if name not in known:
            raise _unknown(name, known, "output")
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
    nothing = np.zeros((system.sizes["no"], 0))
    largest = float(np.abs(state.lam).max(initial=0.0))
    found = [
        _differences(system, state, "q", STEP / weight),
        _differences(system, state, "v", RATE / weight),
        _differences(system, state, "lam", np.full(state.lam.size, 1e-3 * (1.0 + largest))),
    ]
    errors = [-_by_travel(system, k, lambda: evaluate.observe(system, state)) for k in range(meshes)]
    feed = np.column_stack(errors) if errors else nothing
    for o, channel in enumerate(system.layout.channels):
        if channel.name.startswith("transmission_error["):
            feed[o] = 0.0  # it is the travel of the gears, independent of their flanks
    for k, name in enumerate(mesh_names(system)):
        ratio = _mean_ratio(linear, k, name)
        for word in MESH_FORCES:
            o = system.layout.channel(f"{word}[{name}]")
            found[0][o] *= ratio
            feed[o] *= ratio
    return found[0], found[1], found[2], feed


def _mean_ratio(linear: Linearised, k: int, name: str) -> float:
    """Stiffness of a mesh in use (mean over its cycle) over its stiffness at the operating point."""
    stopped = linear.state.copy()
    stopped.v[:] = 0.0
    _, now = tangents(linear.system, stopped, one_mesh(linear.system, k))
    share = linear.at_rest.shares[linear.at_rest.elements.index(f"mesh {name}")]
    own = evaluate.dense(linear.system, now)[np.ix_(share.places, share.places)]
    size = float(np.sum(own * own))
    return float(np.sum(own * share.matrix)) / size if size > 0.0 else 1.0


def _differences(system, state: State, key: str, steps: Array) -> Array:  # type: ignore[no-untyped-def]
    """Central differences of all channels with respect to one part of the state, shape (no, n)."""
    found = np.zeros((system.sizes["no"], steps.size))
    for k, step in enumerate(steps):
        sides = []
        for sign in (1.0, -1.0):
            moved = state.copy()
            getattr(moved, key)[k] += sign * step
            sides.append(evaluate.observe(system, moved))
        found[:, k] = (sides[0] - sides[1]) / (2.0 * step)
    return found
