# SPDX-License-Identifier: Apache-2.0
"""Position in which a set of gears with position errors has no load: its members centre themselves.

A pin error can be larger than the backlash, so that teeth overlap where the machine is assembled. Newton's
method from there meets forces of deep penetrations on both flanks. The start is therefore the position of
least energy of the supports and of springs between the teeth that pull every mesh to the middle of its
backlash: a floating sun moves sideways, stiff supports stay where they are. With loads, these springs also
show the flank that each mesh presses; then they pull every mesh to that flank.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from pitchpoint.solvers.equilibrium.closed_loops import is_looped
from pitchpoint.solvers.equilibrium.unknowns import inverse_of, rest_matrix
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import mesh_records
from pitchpoint.system.residual import NEWTON
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

CLOSE = 1e-9
"""Overlap of unloaded teeth that is left to the equilibrium [m]."""
STEP = 1e-7
"""Step of a coordinate for the travel of the meshes [m, rad]; exact for lines of action that hardly turn."""
SOFTEST, STIFFEST = 1e5, 1e13
"""Stiffness of teeth that act as springs [N/m]."""
PULL = 1e8
"""Stiffness of the springs between teeth with another law [N/m]."""
HOLD = 1e-3
"""Stiffness, over that of the teeth, that holds every body at its place of the last pass: a planet that
floats in its bearing has no other stiffness in one direction."""
PASSES = 3
"""Linear solutions; lines of action turn by a displacement over the centre distance."""


def centred(system: System, state: State, held: Iterable[int] = (), *, loaded: bool = True) -> State:
    """Start of an equilibrium for a set whose teeth overlap as assembled; else the state is returned.

    Parameters
    ----------
    system
        The system. Sets in closed loops of joints keep their state.
    state
        Assembled position.
    held
        Coordinates that keep their values.
    loaded
        Whether the meshes touch on the flank that the loads press, else they are in the middle of their
        backlash.
    """
    if is_looped(system) or not _overlap(system, state):
        return state
    free = np.setdiff1d(np.arange(system.sizes["nd"]), [*held, *system.states])
    records = mesh_records(system)
    kept = [float(record["c_prime"]) for record in records]
    pull = np.array([k if SOFTEST < k < STIFFEST else PULL for k in kept])
    for record in records:
        record["c_prime"] = 0.0
    try:
        mass = rest_matrix(system, state, NEWTON, (1.0, 0.0, 0.0))[free][:, free]
        root, new = np.sqrt(mass.diagonal()), state.copy()
        hold = np.diag(HOLD * pull.max() * system.weight[free] ** 2)
        aim, flank = np.zeros(len(records)), np.zeros(len(records))
        for count in range(2 * PASSES if loaded else PASSES):
            supports = rest_matrix(system, new, NEWTON, (0.0, 0.0, 1.0))[free][:, free]
            supports = supports if isinstance(supports, np.ndarray) else supports.toarray()
            residual = evaluate.residual(system, new)[free] if loaded else np.zeros(free.size)
            moved = np.zeros(free.size) if loaded else supports @ (new.q[free] - state.q[free])
            stretch, slopes = _travel(system, new) - aim, _slopes(system, new, free)
            inverse = inverse_of(supports + hold + slopes.T @ (pull[:, None] * slopes), root)
            step = -inverse(residual + moved + slopes.T @ (pull * stretch))
            new.q[free] += step
            if loaded and count == PASSES - 1:
                flank = np.sign(stretch + slopes @ step)
            if loaded and count >= PASSES - 1:  # the backlash changes with the centre distances
                _travel(system, new)
                aim = flank * np.array([0.5 * max(0.0, float(r["now"]["gap"])) for r in records])
    finally:
        for record, value in zip(records, kept, strict=True):
            record["c_prime"] = value
    return new


def _overlap(system: System, state: State) -> bool:
    """Whether teeth overlap because of the assembly of their gears."""
    records = mesh_records(system)
    if not any(record["u0"] != 0.0 for record in records):
        return False
    _travel(system, state)
    return any(
        abs(r["now"]["u"] - r["now"]["e_t"]) - 0.5 * r["now"]["gap"] > CLOSE
        for r in records
        if abs(r["u0"]) > CLOSE
    )


def _travel(system: System, state: State) -> Array:
    """Distance of every mesh from the middle of its backlash [m]."""
    evaluate.residual(system, state)
    return np.array([float(r["now"]["u"] - r["now"]["e_t"]) for r in mesh_records(system)])


def _slopes(system: System, state: State, free: NDArray[np.int64]) -> Array:
    """Derivative of the travel of the meshes with respect to the free coordinates."""
    found = np.zeros((len(mesh_records(system)), free.size))
    for k, place in enumerate(free):
        sides = []
        for step in (STEP, -STEP):
            moved = state.copy()
            moved.q[place] += step
            sides.append(_travel(system, moved))
        found[:, k] = (sides[0] - sides[1]) / (2.0 * STEP)
    return found
