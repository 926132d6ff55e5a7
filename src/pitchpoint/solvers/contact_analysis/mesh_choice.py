# SPDX-License-Identifier: Apache-2.0
"""Meshes of a machine for contact analyses on shafts: which can be analysed, and which roll together."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from pitchpoint.core.errors import SolverError
from pitchpoint.core.nearest import hint
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.solvers.equilibrium.closed_loops import is_looped
from pitchpoint.solvers.gear_trains import mesh_orders, rotations
from pitchpoint.solvers.quasistatic.path import turned_gear
from pitchpoint.system.meshes import mesh_names

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.system.system import System

SAME = 1e-9
"""Relative difference of equal mesh frequencies."""


def unsuitable(model: Model) -> dict[str, str]:
    """Reasons by mesh why meshes cannot be analysed on shafts, and what to do."""
    found = {}
    for name in model.every_mesh:
        part = model.meshes.get(name)
        if part is None:
            found[name] = "the contact of bevel gears is not analysed"
        elif part.contact is None:
            found[name] = "it has a stiffness law; give the mesh `contact: {level: flexible}`"
        elif any(model.body_of(gear) is None for gear in part.gears):
            found[name] = "its gears are not on bodies; put both on bodies or shafts"
    return found


def chosen_meshes(model: Model, names: Sequence[str] | None) -> tuple[str, ...]:
    """Meshes to analyse: the given ones, or all that can be analysed.

    Raises
    ------
    SolverError
        If a given mesh does not exist or cannot be analysed, or if none can be.
    """
    reasons = unsuitable(model)
    if names is None:
        suitable = tuple(name for name in model.meshes if name not in reasons)
        if not suitable:
            every = "; ".join(f"mesh {name}: {reason}" for name, reason in reasons.items())
            raise SolverError(every or "the model has no mesh", INCONSISTENT)
        return suitable
    for name in names:
        if name not in model.every_mesh:
            raise SolverError(f"no mesh {name!r}; {hint(name, list(model.every_mesh))}", INCONSISTENT)
        if name in reasons:
            raise SolverError(f"mesh {name}: {reasons[name]}", INCONSISTENT)
    return tuple(dict.fromkeys(names))


def rolled_together(system: System, names: Sequence[str]) -> dict[str, list[str]]:
    """Meshes by the mesh with which they roll through one base pitch in the same time.

    The meshes of a planetary gear set, or of several planets with one sun, have the same mesh frequency: one
    roll is sufficient for all. The result for a mesh does not depend on the others in `names`.

    Parameters
    ----------
    system
        The compiled model.
    names
        Meshes to analyse.
    """
    model = system.model
    assert model is not None
    reasons = unsuitable(model)
    left = [name for name in mesh_names(system) if name not in reasons]
    found = {}
    while left:
        first = left[0]
        spin, _ = turned_gear(system, mesh_names(system).index(first))
        orders = mesh_orders(system, rotations(system, (spin,))[:, 0])
        same = [
            m for m in left if math.isclose(orders[m], orders[first], rel_tol=SAME) and orders[first] > 0.0
        ]
        group = [first] if is_looped(system) or not same else same
        found[first] = [name for name in names if name in group]
        left = [name for name in left if name not in group]
    return {first: group for first, group in found.items() if group}
