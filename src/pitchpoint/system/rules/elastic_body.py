# SPDX-License-Identifier: Apache-2.0
"""An elastic body from finite-element matrices: the floating frame, its modal coordinates, its nodes."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.elements.flexible_body import GROUP, MOST, flexible_row, interface_bodies, modal_bodies
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.craig_bampton import Modes, modal_damping
from pitchpoint.multibody.joints import FLOATING
from pitchpoint.multibody.mass_invariants import mass_invariants
from pitchpoint.multibody.structure import Structure, turned_stiffening


@dataclass(frozen=True)
class ElasticParts:
    """Bodies and records of one elastic body.

    Parameters
    ----------
    bodies
        The floating frame, the hidden bodies of the modal coordinates, the bodies of the nodes.
    flexible, guides
        Records of the kinds flexible_body and guide.
    nodes
        Number of the body that goes with each named node.
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
    stiffening: ArrayLike | None = None,
    gravity: ArrayLike = (0.0, 0.0, 0.0),
) -> ElasticParts:
    """Put an elastic body into a system.

    Parameters
    ----------
    name
        Name of the body; its frame has this name, too.
    structure, modes
        Its matrices and at most twelve modes, of `craig_bampton`, or of `held_modes` if a joint holds a node.
    nodes
        Nodes for joints, forces and constraints, by name.
    first
        Number of its first body in the records.
    frame
        Its floating frame: joint, parent, place and axes in the world, no mass. None is a body that flies,
        with the axes of the structure.
    pose
        Origin and axes (columns) of the structure in the world with all coordinates zero; None is the world.
    damping_ratio
        Of every mode [-].
    stiffening
        Stiffness of the displacements of the structure by loads (9, size, size), see `axial_stiffening`.
    gravity
        World axes [m/s^2].

    Raises
    ------
    CompileError
        If there are too many modes, or the frame has a mass.
    """
    n = modes.frequency.size
    if not 0 < n <= MOST:
        raise CompileError(f"{name}: {n} modes (limit 1 to {MOST}); choose some with Modes.select")
    place, world = (np.asarray(x, float) for x in pose or (np.zeros(3), np.eye(3)))
    base = frame or Body(motion=FLOATING, position=place, axes=world, inertia=np.zeros((3, 3)), name=name)
    if base.mass or base.polar_inertia or np.any(base.tensor()):
        raise CompileError(f"{name}: its frame has a mass; that of the elastic body is in its matrices")
    own, at = np.asarray(base.axes, float), np.asarray(base.position, float)
    Q = world.T @ own  # axes of the frame in those of the structure
    integrals = mass_invariants(structure, modes.shape, world.T @ (at - place)).turned(Q)
    hidden, guides = modal_bodies(name, n, first + 1)
    numbers = tuple(range(first + 1, first + 1 + len(hidden)))
    extra = None
    if stiffening is not None:
        loads = [modes.shape.T @ (part @ modes.shape) for part in np.asarray(stiffening, float)]
        extra = turned_stiffening(loads, Q)
    row = flexible_row(
        integrals,
        (2.0 * math.pi * modes.frequency) ** 2,
        frame=first,
        hidden=numbers,
        damping=modal_damping(modes, damping_ratio),
        stiffening=extra,
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
