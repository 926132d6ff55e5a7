# SPDX-License-Identifier: Apache-2.0
"""Summary of a computed study, and its table as a dataset."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.analysis.study.sensitivity import Indices
from pitchpoint.analysis.study.statistics import QUANTILES
from pitchpoint.analysis.study.summary import FactorSample, ResultSample, StudySummary, summary_of
from pitchpoint.core.provenance import content_hash, provenance
from pitchpoint.core.status import INTERRUPTED, OK, sentence
from pitchpoint.model.study_plan import INDICES
from pitchpoint.sweep.study.check import Study
from pitchpoint.sweep.study.design import StudyCase
from pitchpoint.sweep.study.factors import Choice, Pitch, StudyFactor
from pitchpoint.sweep.study.remarks import remarks
from pitchpoint.sweep.study.run import Record, values_of

if TYPE_CHECKING:
    import xarray as xr

SENSITIVITIES = {
    "regression_coefficient": "standardised regression coefficient",
    "rank_correlation": "rank correlation (Spearman)",
    "variance_share": "share of the variance by linear regression",
    "first_order_index": "first-order Sobol' index",
    "total_index": "total Sobol' index",
}
"""Sensitivities over result and factor: name in the dataset, description."""


def words_of(factor: StudyFactor) -> str:
    """Factor in words: its paths, or the gears with random pitch deviations."""
    if isinstance(factor, Pitch):
        return f"pitch deviations of {', '.join(factor.teeth)}, largest F_p"
    how = {"absolute": "", "add": ", deviation", "multiply": ", factor"}[factor.apply]
    return ", ".join(factor.numbers) + how


def summarised(
    study: Study, cases: Sequence[tuple[StudyCase, str]], records: Mapping[str, Record]
) -> StudySummary:
    """Statistics of a study from its records.

    Parameters
    ----------
    study
        The checked study.
    cases
        Nominal case and all cases, with their hashes.
    records
        Records by hash; cases without one count as failed.
    """
    plan, own = study.plan, cases[1:]
    rows = [values_of(study, records.get(key)) for _, key in own]
    nominal = values_of(study, records.get(cases[0][1]))
    factors = [
        FactorSample(
            f.name,
            words_of(f),
            f.unit,
            np.array([case.values[f.name] for case, _ in own]),
            tuple(map(str, f.written)) if isinstance(f, Choice) and f.amounts is None else (),
            f.nominal,
        )
        for f in study.factors
    ]
    results = [
        ResultSample(
            r.name, r.words, r.unit, np.array([row[r.name] for row in rows]), nominal[r.name], r.low, r.high
        )
        for r in study.results
    ]
    finished = np.array([records.get(key, {}).get("status") == OK for _, key in own], bool)
    groups = np.array([case.group for case, _ in own])
    return summary_of(
        factors,
        results,
        groups,
        finished,
        confidence=plan.confidence,
        indices=plan.sensitivity == INDICES,
    )


def study_dataset(
    study: Study, cases: Sequence[tuple[StudyCase, str]], records: Mapping[str, Record]
) -> xr.Dataset:
    """Table of a study.

    Parameters
    ----------
    study, cases, records
        As for `summarised`.

    Returns
    -------
    xarray.Dataset
        `factor[NAME]`, `result[NAME]`, `status` and `group` (of Sobol' indices) over `case`; `nominal`,
        limits, `mean`, `standard_deviation`, `share_within_limits` over `result`, `quantile` over `result`
        and `probability`, sensitivities over `result` and `factor`, all in SI units, estimates with `_low`
        and `_high` of the confidence interval. `unit` over `result` has the units. The attributes contain
        the notes.
    """
    import xarray as xr

    summary = summarised(study, cases, records)
    data: dict[str, Any] = {}
    for factor in summary.factors:
        values: Any = factor.values
        if factor.labels:
            values = np.array([factor.labels[int(k)] for k in factor.values], object)
        data[f"factor[{factor.name}]"] = ("case", values, {"units": factor.unit, "long_name": factor.words})
    for one in summary.results:
        sample = one.sample
        words = {"units": sample.unit, "long_name": sample.words}
        data[f"result[{sample.name}]"] = ("case", sample.values, words)
    status = [int(records[key]["status"]) if key in records else INTERRUPTED for _, key in cases[1:]]
    data["status"] = ("case", status, {"long_name": "status of the case; 1: no error"})
    data["group"] = ("case", [case.group for case, _ in cases[1:]], {"long_name": "sample of sobol_indices"})
    data |= statistics_tables(summary)
    coords = {
        "case": np.arange(len(cases) - 1),
        "factor": [f.name for f in summary.factors],
        "result": [one.sample.name for one in summary.results],
        "probability": list(QUANTILES),
        "unit": ("result", [one.sample.unit for one in summary.results]),
    }
    bad = next((code for code in status if code != OK), OK)
    attrs = provenance(
        model_hash=content_hash(study.model),
        solver="study",
        options=options_of(study),
        status=bad,
        wall_s=0.0,
    )
    sentences = [
        str(records[key]["sentence"]) if key in records else sentence(INTERRUPTED) for _, key in cases[1:]
    ]
    notes = [*map(str, remarks(study)), *summary.notes]
    return xr.Dataset(data, coords, {**attrs, "sentences": sentences, "notes": notes})


def options_of(study: Study) -> dict[str, Any]:
    """Options of a study for the provenance of its table."""
    plan = study.plan
    return {
        "evaluate": plan.evaluate,
        "sampling": plan.sampling,
        "samples": plan.samples,
        "seed": plan.seed,
        "sensitivity": plan.sensitivity,
        "confidence": plan.confidence,
        "paths": {f.name: words_of(f) for f in study.factors},
        "results": {r.name: [r.channel, r.statistic or ""] for r in study.results},
    }


def statistics_tables(summary: StudySummary) -> dict[str, Any]:
    """Statistics and sensitivities as variables over result, probability and factor."""
    found: dict[str, Any] = {}

    def put(name: str, dims: Any, values: Any, words: str) -> None:
        """Add one variable."""
        found[name] = (dims, np.array(values, float), {"long_name": words})

    def put_estimates(name: str, dims: Any, estimates: Any, words: str) -> None:
        """Add a variable and the limits of its interval."""
        ends = {"": "value", "_low": "low", "_high": "high"}
        for end, part in ends.items():
            put(name + end, dims, _parts(estimates, part), words + ("" if not end else f", limit {part}"))

    results = summary.results
    put("factor_nominal", "factor", [f.nominal for f in summary.factors], "value without changes")
    put("lower_limit", "result", [one.sample.low for one in results], "smallest permitted value")
    put("upper_limit", "result", [one.sample.high for one in results], "largest permitted value")
    put("nominal", "result", [one.sample.nominal for one in results], "value of the model without changes")
    put_estimates("mean", "result", [one.spread.mean for one in results], "mean")
    put_estimates(
        "standard_deviation", "result", [one.spread.deviation for one in results], "standard deviation"
    )
    quantiles = [one.spread.quantiles for one in results]
    put_estimates("quantile", ("result", "probability"), quantiles, "quantile")
    put("minimum", "result", [one.spread.minimum for one in results], "smallest value")
    put("maximum", "result", [one.spread.maximum for one in results], "largest value")
    put("count", "result", [one.spread.count for one in results], "number of values")
    within = [one.within for one in results]
    put_estimates("share_within_limits", "result", within, "share of the samples within the permitted range")
    for name, words in SENSITIVITIES.items():
        tables = sensitivity_tables(summary, name)
        if tables is not None:
            put_estimates(name, ("result", "factor"), tables, words)
    if results[0].linear is not None:
        r2 = [one.linear.determination if one.linear else np.nan for one in results]
        put("determination", "result", r2, "share of the variance that the regression explains, R^2")
    return found


def sensitivity_tables(summary: StudySummary, name: str) -> list[Indices] | None:
    """One sensitivity of every result; None if the study does not have it."""
    if summary.results[0].linear is None:
        parts = {"first_order_index": "first", "total_index": "total"}
        return [getattr(one, parts[name]) for one in summary.results] if name in parts else None
    parts = {"regression_coefficient": "coefficient", "rank_correlation": "rank", "variance_share": "share"}
    return [getattr(one.linear, parts[name]) for one in summary.results] if name in parts else None


def _parts(estimates: Any, part: str) -> Any:
    """One part of nested estimates; NaN for None."""
    if isinstance(estimates, list | tuple):
        return [_parts(one, part) for one in estimates]
    return np.nan if estimates is None else getattr(estimates, part)
