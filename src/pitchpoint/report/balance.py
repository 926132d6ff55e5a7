# SPDX-License-Identifier: Apache-2.0
"""Loads with `torque: balance`: what they balance, in words, and their torques in all scenarios."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import PitchpointError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.words import listed

if TYPE_CHECKING:
    from pitchpoint.model.components.bevel_mesh import BevelMesh
    from pitchpoint.model.components.mesh import Mesh
    from pitchpoint.model.model import Model


def balanced_loads(model: Model) -> dict[str, Any]:
    """Balancing loads of a model and what they balance, without solving.

    Parameters
    ----------
    model
        The model.

    Returns
    -------
    dict
        Names of the `loads` with `torque: balance`, and in words what they `balance` over which time; empty
        without such loads.
    """
    from pitchpoint.model.components.law import Balance, Constant

    torques = {name: load.torque for name, load in model.loads.items() if load.torque is not None}
    loads = [name for name, torque in torques.items() if isinstance(torque, Balance)]
    if not loads:
        return {}
    parts = ["the loads at the start"]
    varying = [name for name, torque in torques.items() if not isinstance(torque, Balance | Constant)]
    if varying:
        over = "its period if it repeats" if len(varying) == 1 else "their common period if they repeat"
        parts.append(f"the mean of {listed(varying)} over {over} over angle or time")
    meshes: list[Mesh | BevelMesh] = [*model.meshes.values(), *model.bevel_meshes.values()]
    rough = any(mesh.friction is not None and mesh.friction.mu > 0.0 for mesh in meshes)
    surface = any(mesh.contact is not None for mesh in model.meshes.values())
    if rough or surface:
        forces = listed(["flank friction"] * rough + ["flank contact"] * surface)
        parts.append(f"the mean of {forces} over {'the mesh cycle' if len(meshes) == 1 else 'mesh cycles'}")
    return {"loads": loads, "balance": listed(parts)}


def balancing_torques(model: Model, progress: Progress = silent) -> dict[str, dict[str, Any]]:
    """Balancing torques at the start of every time and quasi-static scenario.

    Parameters
    ----------
    model
        A model with `torque: balance`.
    progress
        Receives the number of completed scenarios.

    Returns
    -------
    dict
        By scenario: `torques` [N m] by load, in words what they `balance` over which cycle, and `notes`, for
        example on an unstable operating point; or `failure`, why there is none. Losses of vibrating flanks
        are determined by runs only.
    """
    names = [name for name, chosen in model.scenarios.items() if chosen.kind != "sweep"]
    found = {}
    for done, name in enumerate(names):
        progress(done, len(names), name)
        found[name] = _of(model, name)
    progress(len(names), len(names))
    return found


def _of(model: Model, name: str) -> dict[str, Any]:
    from pitchpoint.solvers.equilibrium.balancing import LOAD, balancing_loads
    from pitchpoint.solvers.initial_state.start import prepare_start
    from pitchpoint.solvers.mean_balance import balanced_words
    from pitchpoint.solvers.speed_drift import instability
    from pitchpoint.system.compile import compile_model

    scenario = model.scenarios[name]
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # remarks on the model, which `check` lists
            start = prepare_start(compile_model(model, scenario), scenario)
    except PitchpointError as error:
        return {"failure": str(error)}
    system, unstable = start.system, instability(start)
    return {
        "torques": {
            system.names[LOAD][k]: float(system.records[LOAD]["value"][k]) for k in balancing_loads(system)
        },
        "balance": balanced_words(system, start.state, start.cycle),
        "notes": [*start.notes, *([unstable.note()] if unstable else [])],
    }
