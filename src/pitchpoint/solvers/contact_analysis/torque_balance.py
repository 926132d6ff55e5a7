# SPDX-License-Identifier: Apache-2.0
"""Torque of a mesh from the loads of its gear train: balance of torques with the numbers of teeth.

Every element that transmits torque applies its factors of `torque_paths` times one unknown torque to the
spins. With the loads, the sum on each spin is zero; a load `balance` is a further unknown.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.model.components.law import Balance, Constant
from pitchpoint.multibody.bodies import spin_of
from pitchpoint.solvers.torque_paths import spins_of, torque_paths
from pitchpoint.system.compile import compile_model
from pitchpoint.system.meshes import mesh_names, mesh_places, mesh_record

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.system.system import System

Array = NDArray[np.float64]

SAME = 1e-9
"""Relative error of torques in balance."""


def torque_of_train(model: Model, mesh: str) -> float:
    """Torque on gear 1 of a mesh from the constant loads of its gear train [N m], counter-clockwise positive.

    Parameters
    ----------
    model
        The model; one load may be `balance`. If the body of gear 1 is the end of the train and has no load,
        its torque is what holds the train.
    mesh
        Name of the mesh.

    Raises
    ------
    SolverError
        If the loads do not determine the torque, with the reason.

    Notes
    -----
    Without friction, deflections, and the variation over the mesh cycle: T_1 z_2 = T_2 z_1.
    """
    gears = model.meshes[mesh].gears
    bodies = [model.body_of(gear) for gear in gears]
    if None in bodies:
        raise SolverError("its gears are not on bodies", INCONSISTENT)
    system = compile_model(model)
    place, spins = mesh_places(system)[mesh_names(system).index(mesh)], spins_of(system)
    row_of = {spin: k for k, spin in enumerate(spins)}
    paths = torque_paths(system)
    columns = []
    for path in paths:
        column = np.zeros(len(spins))
        column[[row_of[s] for s in path.row]] = list(path.row.values())
        columns.append(column)
    known, unknown = _loads(model, system, row_of)
    of_body = [
        name for name, other in model.every_mesh.items() if bodies[0] in map(model.body_of, other.gears)
    ]
    if of_body == [mesh] and not any(load.body == bodies[0] for load in model.loads.values()):
        unknown.append(_on(system, row_of, {bodies[0]: 1.0}))
    A = np.array([*columns, *unknown]).T
    found = np.linalg.lstsq(A, -known, rcond=SAME)[0]
    scale = float(np.abs(known).max(initial=0.0))
    if scale == 0.0:
        raise SolverError("the loads have no constant torque", INCONSISTENT)
    if float(np.abs(A @ found + known).max()) > SAME * scale:
        raise SolverError("the torques of the loads do not balance; set one to `balance`", INCONSISTENT)
    m = next(k for k, path in enumerate(paths) if (path.kind, path.number) == place)
    _, sizes, basis = np.linalg.svd(A)
    free = basis[int(np.sum(sizes > SAME * sizes.max())) :, m]
    if np.abs(free).max(initial=0.0) > 1e-6:
        raise SolverError("its share of the load depends on deflections, as for planets", INCONSISTENT)
    return float(-found[m] * mesh_record(system, mesh_names(system).index(mesh))["z1"])


def _on(system: System, row_of: dict[int, int], bodies: dict[str | None, float]) -> Array:
    """Vector over the spins with factors at those of bodies; bodies that do not rotate are omitted."""
    found = np.zeros(len(row_of))
    for body, factor in bodies.items():
        if body in system.layout.bodies:
            spin = spin_of(system.program["body"], system.layout.bodies.index(body))
            if spin in row_of:
                found[row_of[spin]] += factor
    return found


def _loads(model: Model, system: System, row_of: dict[int, int]) -> tuple[Array, list[Array]]:
    """Constant torques on the spins [N m], and directions of balancing torques."""
    known, unknown = np.zeros(len(row_of)), []
    for name, load in model.loads.items():
        if load.torque is None:
            continue
        on = _on(system, row_of, {load.body: 1.0, load.reaction: -1.0})
        if isinstance(load.torque, Balance):
            unknown.append(on)
        elif isinstance(load.torque, Constant):
            known += load.torque.value * on
        else:
            raise SolverError(f"the torque of the load {name} is not constant", INCONSISTENT)
    return known, unknown
