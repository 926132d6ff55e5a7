# SPDX-License-Identifier: Apache-2.0
"""Balancing torques of the scenarios of a model, and what they balance."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import PitchpointError

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def balancing_torques(model: Model) -> dict[str, dict[str, Any]]:
    """Balancing torques at the start of every time and quasi-static scenario.

    Parameters
    ----------
    model
        The model.

    Returns
    -------
    dict
        By scenario: `torques` [N m] by load, and in words what they `balance` over which cycle; or `failure`,
        why there is none. Losses of vibrating flanks are determined by runs only. Empty without
        `torque: balance`, or without scenarios.
    """
    from pitchpoint.model.components.law import Balance

    if not any(isinstance(load.torque, Balance) for load in model.loads.values()):
        return {}
    return {name: _of(model, name) for name, chosen in model.scenarios.items() if chosen.kind != "sweep"}


def _of(model: Model, name: str) -> dict[str, Any]:
    from pitchpoint.solvers.equilibrium.solve import LOAD, balancing_loads
    from pitchpoint.solvers.initial_state.start import prepare_start
    from pitchpoint.solvers.mean_balance import balanced_words
    from pitchpoint.system.compile import compile_model

    scenario = model.scenarios[name]
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # remarks on the model, which `check` lists
            start = prepare_start(compile_model(model, scenario), scenario)
    except PitchpointError as error:
        return {"failure": str(error)}
    system = start.system
    return {
        "torques": {
            system.names[LOAD][k]: float(system.records[LOAD]["value"][k]) for k in balancing_loads(system)
        },
        "balance": balanced_words(system, start.state, start.cycle),
    }
