# SPDX-License-Identifier: Apache-2.0
"""Error of the communication steps of FMUs in a model, from a second run with half of them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.model.components.controller import FmuController
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model


def estimate_communication_error(model: Model, scenario: str, *, progress: Progress = silent) -> xr.Dataset:
    """Time response with half of the communication steps of all FMUs, and an estimate of its error.

    Signals are held constant in a communication step, so the error is of first order: the run with half of
    the steps has half of the error, which is the difference of the two runs.

    Parameters
    ----------
    model
        Model with FMUs in its `controllers`.
    scenario
        Name of the scenario.
    progress
        Called with the time reached.

    Returns
    -------
    xarray.Dataset
        As of `solve_time`, of the run with half of the steps. The attribute `communication_error` of every
        variable is the largest difference to the run with the given steps, in its unit. If twice as many
        steps do not halve it, the steps are too long for the estimate.

    Raises
    ------
    ModelError
        If the model has no FMU.
    SolverError
        If a run fails.
    """
    model = with_samples(model, scenario)
    coarse = solve_time(compile_model(model, scenario), progress=progress)
    return finer_run(model, scenario, coarse, progress=progress)


def with_samples(model: Model, scenario: str) -> Model:
    """Model whose samples do not depend on the communication steps: by default the shortest of them.

    Raises
    ------
    ModelError
        If the model has no FMU.
    """
    periods = _periods(model)
    if not periods:
        raise ModelError([Message("controllers", "contain no FMU", remedy="name a model with an FMU")])
    if model.scenarios[scenario].sample_rate is not None:
        return model
    return model.replace(f"scenarios.{scenario}.sample_rate", 1.0 / min(periods.values()))


def finer_run(model: Model, scenario: str, coarse: xr.Dataset, *, progress: Progress = silent) -> xr.Dataset:
    """Run with half of the communication steps, and its `communication_error`.

    Parameters
    ----------
    model, scenario
        From `with_samples`.
    coarse
        Result of the given steps.
    progress
        Called with the time reached.
    """
    halves = {f"controllers.{n}.period": 0.5 * period for n, period in _periods(model).items()}
    fine = solve_time(compile_model(model.replace_all(halves), scenario), progress=progress)
    for name in fine.data_vars:
        if fine[name].dims == ("time",):
            error = np.abs(coarse[name].values - fine[name].values).max()
            fine[name].attrs["communication_error"] = float(error)
    return fine


def _periods(model: Model) -> dict[str, float]:
    """Communication step of each FMU [s]."""
    return {n: c.period for n, c in model.controllers.items() if isinstance(c, FmuController)}
