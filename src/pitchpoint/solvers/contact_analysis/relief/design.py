# SPDX-License-Identifier: Apache-2.0
"""Relief design of one mesh: search, rounding to drawing precision, Harris map, result."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import INTERRUPTED, OK, sentence
from pitchpoint.model.numbers import number_at
from pitchpoint.solvers.contact_analysis.flank_states import housing_misalignment
from pitchpoint.solvers.contact_analysis.relief.analyses import Analyses
from pitchpoint.solvers.contact_analysis.relief.curves import Curves
from pitchpoint.solvers.contact_analysis.relief.plan import FINER, ReliefPlan
from pitchpoint.solvers.contact_analysis.relief.search import Search
from pitchpoint.solvers.contact_analysis.relief.target import MICRO
from pitchpoint.solvers.contact_analysis.relief.variables import (
    AMOUNT_STEP,
    Flanks,
    check_paths,
    with_values,
)
from pitchpoint.solvers.contact_analysis.solve import mesh_of

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

DESIGNS = ("start", "optimum", "rounded")
MAP_TORQUES = 24
"""Torques of the Harris map, from 1/20 of the highest torque to `MAP_END` times it."""
MAP_END = 1.2


def design_relief(
    model: Model,
    mesh: str | None,
    plan: ReliefPlan,
    *,
    jobs: int | None = None,
    progress: Progress = silent,
) -> xr.Dataset:
    """Find the flank modifications of least peak-to-peak transmission error over a range of torques.

    Parameters
    ----------
    model
        The model; the mesh has `contact`.
    mesh
        Name of the mesh; may be None if there is only one.
    plan
        Variables, torques, tolerances, limits, effort.
    jobs
        Number of threads; default one per core. The numbers do not depend on it.
    progress
        Called after each analysis of the search.

    Returns
    -------
    xarray.Dataset
        Over `design` (start, optimum, rounded): value by `variable` [m] (NaN: not in the model), objective
        [m], peak_to_peak by `misalignment` and `torque` [m], its minimum and maximum over tolerances and
        misalignments, pressure [Pa] and edge_share by torque, transmission_error over the mesh phase [m],
        and peak-to-peak errors over `map_torque` (Harris map). Over `evaluation`: all designs of the search.

    Raises
    ------
    ModelError
        If a variable is not a modification of a loaded flank, or a bound does not fit the gear.
    SolverError
        If the mesh has no contact of tooth surfaces; after Ctrl-C or a failure of the search with the best
        design so far as partial result.
    """
    name = mesh_of(model, mesh)
    began = time.perf_counter()
    check_paths(model, name, plan.paths)
    if not plan.misalignments:
        plan = replace(plan, misalignments=(housing_misalignment(model, name, plan.flank),))
    complete = start_model(model, plan)
    flanks = Flanks(complete, name, plan.flank, plan.paths)
    over = np.linspace(0.05, MAP_END, MAP_TORQUES) * plan.loads[-1]
    rows = flanks.rows(flanks.start)
    deepest = _deepest(plan, flanks)
    every = Analyses(complete, name, plan.conditions(over, plan.positions), rows, deepest, jobs)
    status, text = OK, sentence(OK)
    with every.pool() as pool:
        coarse = every.under(plan.conditions(plan.loads, plan.positions))
        search = Search(plan, flanks, coarse, pool, progress)
        try:
            search.run(np.clip((flanks.start[: search.n] - search.low) / search.span, 0.0, 1.0))
        except (KeyboardInterrupt, SolverError) as stopped:
            if search.best is None:
                raise
            status = stopped.status if isinstance(stopped, SolverError) else INTERRUPTED
            text = str(stopped) if isinstance(stopped, SolverError) else sentence(INTERRUPTED)
        assert search.best is not None
        optimum = search.low + search.best.at * search.span
        search.refine()
        designs = [flanks.start[: search.n], optimum, search.rounded()]
        data = _dataset(search, designs, every.under(plan.conditions(over, FINER * plan.positions)))
    absent = [number_at(model, path) is None for path in plan.vary]
    data["value"][0, absent] = np.nan
    data.attrs |= _attributes(model, name, plan, status, time.perf_counter() - began, search.count)
    if status != OK:
        raise SolverError(text, status, data)
    return data


def start_model(model: Model, plan: ReliefPlan) -> Model:
    """Model that has all modifications of a plan.

    Missing amounts are zero, missing lengths in the middle of the bounds.

    Raises
    ------
    ModelError
        If a path does not exist, or a bound does not fit the gear.
    """
    bounds = {v.path: v for v in plan.variables}
    missing: dict[str, float] = {}
    for path in plan.paths:
        if number_at(model, path) is None:
            variable = bounds.get(path)
            is_length = variable is not None and variable.step > AMOUNT_STEP
            missing[path] = (
                0.5 * (variable.low + variable.high) if variable is not None and is_length else 0.0
            )
    complete = with_values(model, missing)
    for end in ("low", "high"):
        with_values(complete, {path: getattr(variable, end) for path, variable in bounds.items()})
    return complete


def _deepest(plan: ReliefPlan, flanks: Flanks) -> float:
    """Upper bound of the gap that any design adds at a point of both flanks [m]."""
    from pitchpoint.geometry.modification_terms import END, ROOT, TIP

    amounts = [0, 1, 2, 3, TIP, ROOT, END]
    wide = np.array([plan.tolerances.get(path, 0.0) for path in plan.paths])
    most = np.abs(flanks.start) + wide
    for k, variable in enumerate(plan.variables):
        most[k] = max(abs(variable.low), abs(variable.high)) + wide[k]
    base = np.abs(flanks.rows(flanks.start))[:, amounts].sum()
    return float(
        base + np.abs(flanks.rows(most))[:, amounts].sum() + np.abs(flanks.rows(-most))[:, amounts].sum()
    )


def _dataset(search: Search, designs: Sequence[Array], maps: Analyses) -> xr.Dataset:
    import xarray as xr

    plan, positions = search.plan, maps.conditions.positions
    over = np.array(maps.conditions.torques)
    found = [search.curves(values) for values in designs]
    nominal = [samples[0] for samples in found]
    peaks = np.array([[c.peak_to_peak for c in samples] for samples in found])
    harris = np.array([_map(search, maps, values) for values in designs])
    positions_of, samples_of = np.array(search.effort).T
    by_torque, by_map = ("design", "torque"), ("design", "map_torque")
    variables: dict[str, tuple[tuple[str, ...], Any, str, str]] = {
        "value": (("design", "variable"), np.array(designs), "m", "values of the variables"),
        "lower_bound": (("variable",), search.low, "m", "lower bound"),
        "upper_bound": (("variable",), search.low + search.span, "m", "upper bound"),
        "tolerance": (
            ("variable",),
            [plan.tolerances.get(path, 0.0) for path in plan.vary],
            "m",
            "tolerance of the variable, ±",
        ),
        "objective": (
            ("design",),
            [search.target.objective(samples) for samples in found],
            "m",
            "maximum or mean of the peak-to-peak errors, worst of the tolerances",
        ),
        "nominal_objective": (
            ("design",),
            [search.target.objective(samples[:1]) for samples in found],
            "m",
            "the same without deviations",
        ),
        "peak_to_peak": (
            ("design", "misalignment", "torque"),
            np.array([c.peak_to_peak for c in nominal]),
            "m",
            "peak-to-peak transmission error",
        ),
        "peak_to_peak_min": (
            by_torque,
            peaks.min(axis=(1, 2)),
            "m",
            "least over tolerances and misalignments",
        ),
        "peak_to_peak_max": (
            by_torque,
            peaks.max(axis=(1, 2)),
            "m",
            "largest over tolerances and misalignments",
        ),
        "pressure": (
            by_torque,
            np.array([c.pressure.max(axis=(0, 2)) for c in nominal]),
            "Pa",
            "maximum Hertzian pressure on the path of contact",
        ),
        "excess": (
            ("design",),
            [max(float(search.target.excess(c).max(initial=0.0)) for c in samples) for samples in found],
            "1",
            "largest violation of a limit, relative",
        ),
        "edge_share": (
            by_torque,
            np.array([c.edge.max(axis=(0, 2)) for c in nominal]),
            "1",
            "maximum share of the load on tip edges",
        ),
        "transmission_error": (
            ("design", "misalignment", "torque", "mesh_phase_position"),
            np.array([_errors(c) for c in nominal]),
            "m",
            "approach of the flanks along the base tangent, from its minimum at the lowest torque",
        ),
        "map_peak_to_peak": (by_map, harris[:, 0], "m", "peak-to-peak transmission error"),
        "map_min": (by_map, harris[:, 1], "m", "least over tolerances and misalignments"),
        "map_max": (by_map, harris[:, 2], "m", "largest over tolerances and misalignments"),
        "evaluated_value": (
            ("evaluation", "variable"),
            np.array(search.values),
            "m",
            "values of the variables",
        ),
        "evaluated_score": (
            ("evaluation",),
            MICRO * np.array(search.scores),
            "m",
            "objective, with a penalty for violated limits",
        ),
        "evaluated_positions": (("evaluation",), positions_of, "1", "number of mesh phases"),
        "evaluated_deviations": (("evaluation",), samples_of, "1", "number of deviations, nominal included"),
    }
    coords = {
        "design": list(DESIGNS),
        "variable": list(plan.vary),
        "torque": (("torque",), plan.loads, {"units": "N m", "long_name": "torque on gear 1"}),
        "map_torque": (("map_torque",), over, {"units": "N m", "long_name": "torque on gear 1"}),
        "misalignment": (("misalignment",), np.array(plan.misalignments), {"units": "rad"}),
        "mesh_phase_position": (
            ("mesh_phase_position",),
            (np.arange(positions) + 0.5) / positions,
            {"units": "1", "long_name": "mesh phase, 0 when a pair reaches A at mid-face"},
        ),
    }
    return xr.Dataset(
        {
            name: (dims, values, {"units": u, "long_name": t})
            for name, (dims, values, u, t) in variables.items()
        },
        coords=coords,
    )


def _errors(curves: Curves) -> Array:
    """Transmission error from its minimum at the lowest torque [m]."""
    return np.asarray(curves.approach - curves.approach[:, 0].min(axis=1)[:, None, None])


def _map(search: Search, maps: Analyses, values: Array) -> Array:
    """Peak-to-peak errors over the torques of the map: nominal, least and largest, shape (3, torques)."""
    designs = [search.rows(values, deviation) for deviation in search.deviations]
    peaks = np.array([c.peak_to_peak for c in maps.curves_of(designs, search.pool)])
    return np.array([peaks[0].max(axis=0), peaks.min(axis=(0, 1)), peaks.max(axis=(0, 1))])


def _attributes(
    model: Model, mesh: str, plan: ReliefPlan, status: int, wall_s: float, analyses: int
) -> dict[str, Any]:
    from pitchpoint.core.provenance import content_hash, provenance
    from pitchpoint.model.write import model_text

    options = {
        "mesh": mesh,
        "tolerances": dict(plan.tolerances),
        "mean": plan.mean,
        "positions": plan.positions,
        "flank": plan.flank,
        "seed": plan.seed,
        "analyses": analyses,
    }
    found = provenance(
        model_hash=content_hash(model), solver="relief", options=options, status=status, wall_s=wall_s
    )
    return {
        "title": model.title,
        "model_text": model_text(model),
        "mesh": mesh,
        "analyses": analyses,
        **found,
    }
