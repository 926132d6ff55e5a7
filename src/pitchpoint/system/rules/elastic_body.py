# SPDX-License-Identifier: Apache-2.0
"""Elastic bodies from finite-element matrices: floating frame, modal coordinates and nodes."""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import CompileError, Message, ModelError, PitchpointError
from pitchpoint.elements.flexible_body import (
    GROUP,
    MAX_MODES,
    RECORD,
    flexible_row,
    interface_bodies,
    interface_count,
    modal_bodies,
)
from pitchpoint.model.checks.elastic_bodies import ALL_FILES
from pitchpoint.model.frames import axes_of
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.craig_bampton import Modes, craig_bampton, modal_damping
from pitchpoint.multibody.joints import FLOATING, FREE
from pitchpoint.multibody.mass_invariants import mass_invariants
from pitchpoint.multibody.structure import Structure, check_speed, turned_stiffening
from pitchpoint.system.rules.bank import Bank
from pitchpoint.system.rules.flexible_rim import rims
from pitchpoint.system.rules.places import Places
from pitchpoint.system.rules.structure_files import node_near, read_structure
from pitchpoint.system.source import with_lines

if TYPE_CHECKING:
    from pitchpoint.model.components.elastic_body import ElasticBody
    from pitchpoint.model.model import Model


@dataclass(frozen=True)
class ElasticParts:
    """Bodies and records of one elastic body.

    Parameters
    ----------
    bodies
        Floating frame, hidden bodies of the modal coordinates, bodies of the nodes.
    flexible, guides
        Records of the kinds flexible_body and guide.
    nodes
        Number of the body of each named node.
    coordinates
        Names of the modal coordinates.
    """

    bodies: tuple[Body, ...]
    flexible: NDArray[np.void]
    guides: NDArray[np.void]
    nodes: Mapping[str, int]
    coordinates: tuple[str, ...]


def elastic_parts(
    name: str,
    structure: Structure,
    modes: Modes,
    nodes: Mapping[str, int],
    *,
    first: int,
    frame: Body | None = None,
    pose: tuple[ArrayLike, ArrayLike] | None = None,
    damping_ratio: float = 0.0,
    stiffening: Sequence[Any] | None = None,
    gravity: ArrayLike = (0.0, 0.0, 0.0),
) -> ElasticParts:
    """Bodies and records of an elastic body.

    Parameters
    ----------
    name
        Name of the body and of its frame.
    structure, modes
        Matrices of the body and at most `MAX_MODES` modes, from `craig_bampton` or with the nodes at a joint
        fixed.
    nodes
        Nodes for joints, forces and constraints, by name.
    first
        Number of its first body in the records.
    frame
        Massless floating frame with joint, parent, and position and axes in the world. None: free body with
        the axes of the structure.
    pose
        Origin and axes (columns) of the structure in the world with all coordinates zero; None: world frame.
    damping_ratio
        Damping ratio of all modes [-].
    stiffening
        Stress stiffness of the structure per unit of each of nine loads, sparse or dense or None: the three
        components of the frame acceleration, and the products xx, yy, zz, xy, yz, zx of the angular velocity
        components.
    gravity
        Gravity in world axes [m/s^2].

    Raises
    ------
    CompileError
        If there are too many modes, or the frame has a mass.
    """
    n = modes.frequency.size
    if not 0 < n <= MAX_MODES:
        raise CompileError(f"{name}: {n} modes (limit 1 to {MAX_MODES}); select modes with Modes.select")
    place, world = (np.asarray(x, float) for x in pose or (np.zeros(3), np.eye(3)))
    base = _massless(
        frame or Body(motion=FLOATING, position=place, axes=world, inertia=np.zeros((3, 3)), name=name), name
    )
    own, at = np.asarray(base.axes, float), np.asarray(base.position, float)
    Q = world.T @ own  # axes of the frame in those of the structure
    integrals = mass_invariants(structure, modes.shape, world.T @ (at - place)).turned(Q)
    hidden, guides = modal_bodies(name, n, first + 1)
    numbers = tuple(range(first + 1, first + 1 + len(hidden)))
    row = flexible_row(
        integrals,
        (2.0 * math.pi * modes.frequency) ** 2,
        frame=first,
        hidden=numbers,
        damping=modal_damping(modes, damping_ratio),
        stiffening=None if stiffening is None else _modal_stiffening(modes, stiffening, Q),
        gravity=gravity,
    )
    bodies, rows, found = [base, *hidden], [guides], {}
    for word, node in nodes.items():
        shape = modes.at_node(structure, node)
        chain, records = interface_bodies(
            f"{name}.{word}",
            np.vstack([Q.T @ shape[:3], Q.T @ shape[3:]]),
            place=place + world @ structure.places[node],
            axes=own,
            frame=first,
            hidden=numbers,
            first=first + len(bodies),
        )
        bodies += chain
        rows.append(records)
        found[word] = first + len(bodies) - 1
    names = tuple(f"{name}.{k // GROUP + 1}.eta{k + 1}" for k in range(n))
    return ElasticParts(tuple(bodies), row, np.concatenate(rows), found, names)


def _massless(frame: Body, name: str) -> Body:
    """The frame, checked to be massless."""
    if frame.mass or frame.polar_inertia or np.any(frame.tensor()):
        raise CompileError(f"{name}: its frame has a mass; the mass must be in the matrices only")
    return frame


def _modal_stiffening(modes: Modes, stiffening: Sequence[Any], Q: NDArray[np.float64]) -> Any:
    """Modal stress stiffness per unit of nine loads along the frame axes, the columns of Q."""
    nothing = np.zeros((modes.frequency.size, modes.frequency.size))
    loads = [nothing if k is None else modes.shape.T @ (k @ modes.shape) for k in stiffening]
    return turned_stiffening(loads, Q)


# --- of a model ---------------------------------------------------------------------------------------------
def elastic_of(model: Model, name: str, first: int) -> ElasticParts:
    """Bodies and records of an elastic body of a model; `first` is the number of its frame."""
    part, body = model.elastic_bodies[name], model.bodies[name]
    structure, modes, nodes = _reduced(model, name)
    return elastic_parts(
        name,
        structure,
        modes,
        dict(zip(part.nodes, nodes, strict=True)),
        first=first,
        frame=_spinning_frame(model, name) if part.rotor else None,
        pose=(body.origin or (0.0, 0.0, 0.0), axes_of(model, name)),
        damping_ratio=part.damping_ratio,
        stiffening=None if structure.K_spin is None else [*[None] * 5, structure.K_spin, *[None] * 3],
        gravity=model.gravity or (0.0, 0.0, 0.0),
    )


def _spinning_frame(model: Model, name: str) -> Body:
    """Floating frame of a rotor, whose spin is a coordinate with counted revolutions."""
    origin = model.bodies[name].origin or (0.0, 0.0, 0.0)
    return Body(motion=FREE, position=origin, axes=axes_of(model, name), inertia=np.zeros((3, 3)), name=name)


def elastic_bank(places: Places) -> Bank:
    """All elastic bodies and flexible rims of gears."""
    model, numbers = places.model, places.numbers
    parts = {name: elastic_of(model, name, numbers[name]).flexible for name in model.elastic_bodies}
    parts |= {rim.name: rim.flexible for rim in rims(model, numbers)}
    return Bank("flexible_body", np.concatenate([np.zeros(0, RECORD), *parts.values()]), tuple(parts))


def elastic_count(model: Model, name: str) -> int:
    """Number of body records of an elastic body: frame, hidden bodies (`GROUP` modes each), nodes."""
    modes = _reduced(model, name)[1].frequency.size
    return 1 - (-modes // GROUP) + interface_count(modes) * len(model.elastic_bodies[name].nodes)


def node_at(model: Model, name: str, place: NDArray[np.float64]) -> tuple[int, NDArray[np.float64]]:
    """Body number of the nearest named node relative to the frame, and its position in the world [m]."""
    body = model.bodies[name]
    structure, modes, nodes = _reduced(model, name)
    origin, axes = np.array(body.origin or (0.0, 0.0, 0.0)), axes_of(model, name)
    places = origin + structure.places[list(nodes)] @ axes.T
    k = int(np.argmin(np.linalg.norm(places - place, axis=1)))
    n = modes.frequency.size
    return -(-n // GROUP) + interface_count(n) * (k + 1), places[k]


def file_nodes(model: Model, name: str) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """All nodes of the file of an elastic body, in frame axes.

    Returns
    -------
    places, shape
        Positions from the origin of the frame (k, 3) [m]; translations per modal coordinate (k, 3, n).
    """
    structure, modes, _ = _reduced(model, name)
    shape = np.zeros((len(structure.places), 3, modes.frequency.size))
    rows = np.flatnonzero(structure.direction < 3)
    shape[structure.node[rows], structure.direction[rows]] = modes.shape[rows]
    return structure.places, shape


def _reduced(model: Model, name: str) -> tuple[Structure, Modes, tuple[int, ...]]:
    """Matrices, modes and named nodes of an elastic body; cached."""
    part = model.elastic_bodies[name]
    places = tuple((n, m.position) for n, m in part.nodes.items())
    try:
        stamps = tuple(Path(f).stat().st_mtime_ns for f in part.files)
        return _read(part.files, stamps, places, part.modes, part.below, part.static_shapes)
    except (PitchpointError, OSError, MemoryError, np.linalg.LinAlgError, RuntimeError) as fault:
        raise ModelError([_message(name, part, fault)], model.file) from None


def _message(name: str, part: ElasticBody, fault: Exception) -> Message:
    """Convert an error in the files of an elastic body to a problem of the model."""
    at = f"elastic_bodies.{name}"
    if isinstance(fault, ModelError):
        found = fault.problems[0]
        keys = [k for k in ALL_FILES if fault.file is not None and getattr(part, k) == fault.file]
        inner = found.changed(where=found.where or Path(fault.file or at).name, remedy=None)
        return Message(f"{at}.{keys[0]}" if keys else at, str(inner), remedy=found.remedy)
    if isinstance(fault, CompileError):
        head, _, rest = str(fault).partition(": ")
        if head.startswith("nodes."):
            return Message(f"{at}.{head}", rest)
        return Message(at, str(fault))
    return Message(
        at,
        f"has matrices whose modes cannot be computed ({fault})",
        remedy="K must be positive semidefinite and M positive definite",
    )


def elastic_facts(model: Model) -> dict[str, tuple[float, NDArray[np.float64]]]:
    """Mass [kg] and free-free natural frequencies [Hz] of each elastic body.

    Raises
    ------
    ModelError
        If files of elastic bodies are invalid; lists the problems of all of them.
    """
    found = {}
    problems: list[Message] = []
    for name in model.elastic_bodies:
        try:
            structure, modes, _ = _reduced(model, name)
        except ModelError as fault:
            problems += fault.problems
            continue
        along = structure.rigid()[:, 0]
        found[name] = float(along @ (structure.M @ along)), modes.frequency
    if problems:
        raise with_lines(model, ModelError(problems, model.file))
    return found


@functools.lru_cache(maxsize=8)
def _read(
    files: tuple[str, ...],
    stamps: tuple[int, ...],
    wanted: tuple[tuple[str, tuple[float, float, float]], ...],
    count: int | None,
    below: float | None,
    static_shapes: bool,
) -> tuple[Structure, Modes, tuple[int, ...]]:
    """Read and reduce the files; `stamps` are their modification times and part of the cache key."""
    structure = read_structure(files)
    nodes = tuple(node_near(structure, f"nodes.{word}", np.array(place)) for word, place in wanted)
    if static_shapes:
        modes = _static(structure, nodes, count or MAX_MODES)
    elif below is not None:
        modes = craig_bampton(structure, nodes, below=6.0 * below).select(below=below)
    else:
        modes = craig_bampton(structure, nodes, 2 * (count or MAX_MODES)).select(count=count)
    if below is not None and not 0 < modes.frequency.size <= MAX_MODES:
        raise CompileError(
            f"{modes.frequency.size} modes below {below:g} Hz (limit 1 to {MAX_MODES}); use `modes` instead"
        )
    if modes.frequency.size:
        check_speed(structure, float(modes.frequency[0]))
    return structure, modes, nodes


def _static(structure: Structure, nodes: tuple[int, ...], count: int) -> Modes:
    """All static shapes of the nodes, filled up to `count` with fixed-interface modes."""
    needed = int(np.isin(structure.node, nodes).sum()) - 6
    if needed > count:
        raise CompileError(
            f"static_shapes: the nodes can deflect in {needed} shapes, and {count} modes are requested "
            f"(limit {MAX_MODES}); use fewer nodes, or omit static_shapes"
        )
    return craig_bampton(structure, nodes, count - needed)
