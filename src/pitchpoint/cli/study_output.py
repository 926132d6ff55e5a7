# SPDX-License-Identifier: Apache-2.0
"""Printed tables, JSON and table of cases of `pitchpoint study`."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from pitchpoint.cli.output import NOTHING, show, show_notes, table

if TYPE_CHECKING:
    from pitchpoint.analysis.study.sensitivity import Indices
    from pitchpoint.analysis.study.statistics import Estimate
    from pitchpoint.analysis.study.summary import ResultSummary, StudySummary
    from pitchpoint.io.study_store import StudyFolder
    from pitchpoint.sweep.study.check import Study
    from pitchpoint.sweep.study.design import StudyCase
    from pitchpoint.sweep.study.run import Record

SHOWN = {0.05: "5 %", 0.95: "95 %"}
"""Quantiles in the printed table."""
DIGITS = 4


def title_of(study: Study) -> str:
    """Title of a study: that of the plan, or of its model, or the name of its file."""
    return study.plan.title or study.model.title or str(study.plan.file)


def show_factors(study: Study) -> None:
    """Print the distributions of all factors."""
    from pitchpoint.sweep.study.factors import Choice, Pitch
    from pitchpoint.sweep.study.summary import words_of
    from pitchpoint.viz.quantities import amount

    rows = []
    for factor in study.factors:
        if isinstance(factor, Pitch):
            sizes = ", ".join(f"{gear} {amount(s, 'm')}" for gear, s in factor.deviation.items())
            rows.append(
                [factor.name, words_of(factor), f"standard deviation of f_p: {sizes}", NOTHING, NOTHING]
            )
            continue
        if isinstance(factor, Choice):
            levels = ", ".join(map(str, factor.written))
            rows.append([factor.name, words_of(factor), levels, NOTHING, NOTHING])
            continue
        d = factor.distribution
        low, high = (amount(float(d.ppf(p)), factor.unit) for p in (0.00135, 0.99865))
        mean, deviation = amount(float(d.mean()), factor.unit), amount(float(d.std()), factor.unit)
        rows.append([factor.name, words_of(factor), f"{low} to {high}", mean, deviation])
    title = title_of(study)
    heads = ["factor", "varies", "values (99.7 %)", "mean", "standard deviation"]
    table(f"{title}: factors", heads, rows, keys=1)


def forecast_words(summary: Mapping[str, Any]) -> str:
    """Number of cases and time in words."""
    from pitchpoint.cli.progress import duration_text

    text = f"{summary['cases']} cases and the model without changes, {summary['known']} completed"
    if not summary["left"]:
        return text
    return (
        f"{text}, {summary['left']} remaining: about {duration_text(summary['seconds'])} on "
        f"{summary['jobs']} cores (estimated from one case: {summary['tried_case']})"
    )


def index_rows(
    study: Study, cases: Sequence[tuple[StudyCase, str]], known: Mapping[str, Record], folder: StudyFolder
) -> tuple[list[str], list[dict[str, Any]]]:
    """Columns and rows of the table of cases; numbers in SI units."""
    from pitchpoint.cli.results import how_a_status_ends
    from pitchpoint.core.status import OK
    from pitchpoint.sweep.study.run import values_of

    def titled(name: str, unit: str) -> str:
        """Heading of a column with its unit."""
        return f"{name} [{unit}]" if unit not in ("", "1") else name

    heads = {f.name: titled(f.name, f.unit) for f in study.factors}
    results = {r.name: titled(r.name, r.unit) for r in study.results}
    rows = []
    for case, key in cases:
        record = known.get(key)
        row: dict[str, Any] = {
            "case": case.index,
            "file": "",
            "status": "waiting",
            "status_code": "",
            "sentence": "",
        }
        row |= {heads[f.name]: f.label(case.values[f.name]) for f in study.factors}
        if record is not None:
            code = int(record["status"])
            there = folder.file_of(key)
            row |= {
                "file": str(there.relative_to(folder.path)) if there.exists() else "",
                "status": how_a_status_ends(code),
                "status_code": code,
                "sentence": "" if code == OK else record["sentence"],
                "steps": record["steps"],
            }
            values = values_of(study, record)
            row |= {results[n]: repr(v) if math.isfinite(v) else "" for n, v in values.items()}
        rows.append(row)
    return [*heads.values(), *results.values(), "steps"], rows


def show_summary(study: Study, found: StudySummary) -> None:
    """Print spread, yield and sensitivities."""
    title = title_of(study)
    heads = ["result", "without changes", "mean", "standard deviation", *SHOWN.values(), "minimum", "maximum"]
    limited = any(one.within is not None for one in found.results)
    if limited:
        heads.append("within limits")
    table(f"{title}: spread of the results", heads, [_spread_row(one, limited) for one in found.results])
    factors = [f.name for f in found.factors]
    indices = found.results[0].total is not None
    what = "total Sobol' index" if indices else "share of the variance"
    rows = []
    for one in found.results:
        rows.append([one.sample.name, *_sensitivity_cells(one.sensitivity)])
        if indices and one.first is not None:
            rows.append(["  first-order index", *_sensitivity_cells(one.first)])
        elif one.linear is not None:
            rows.append(
                ["  regression coefficient", *_sensitivity_cells(one.linear.coefficient, percent=False)]
            )
    level = f"{100.0 * found.confidence:g} %"
    notes = [f"in brackets: limits of the {level} confidence intervals"]
    if not indices:
        explained = [
            f"{one.sample.name} {100.0 * one.linear.determination:.0f} %"
            for one in found.results
            if one.linear is not None and math.isfinite(one.linear.determination)
        ]
        notes.append(f"the regression explains (R²): {', '.join(explained) or NOTHING}")
    table(f"{what} of each factor", [what, *factors], rows, notes)
    show_notes(found.notes)
    show()


def _spread_row(one: ResultSummary, limited: bool) -> list[str]:
    """Row of a result in the table of spreads."""
    import numpy as np

    from pitchpoint.analysis.study.statistics import QUANTILES
    from pitchpoint.viz.quantities import number, scale

    spread = one.spread
    shown = scale(one.sample.unit, np.array([spread.minimum, spread.maximum, one.sample.nominal]))

    def text(value: float) -> str:
        """Value in the unit of the row."""
        if not math.isfinite(value):
            return NOTHING
        return f"{number(value * shown.factor, DIGITS)} {shown.unit}".rstrip()

    chosen = [spread.quantiles[QUANTILES.index(p)].value for p in SHOWN]
    values = [
        one.sample.nominal,
        spread.mean.value,
        spread.deviation.value,
        *chosen,
        spread.minimum,
        spread.maximum,
    ]
    cells = [one.sample.name, *map(text, values)]
    if limited:
        cells.append(NOTHING if one.within is None else _share(one.within))
    return cells


def _share(estimate: Estimate) -> str:
    """Share with its interval in per cent."""
    value, low, high = (100.0 * x for x in (estimate.value, estimate.low, estimate.high))
    return f"{value:.4g} % ({low:.4g} to {high:.4g})"


def _sensitivity_cells(indices: Indices, percent: bool = True) -> list[str]:
    """Sensitivities with their intervals, of shares in per cent."""
    cells = []
    for value, low, high in zip(indices.value, indices.low, indices.high, strict=True):
        if not math.isfinite(value):
            cells.append(NOTHING)
        elif percent:
            whole = [round(100.0 * x) for x in (value, low, high)]
            cells.append(f"{whole[0]} % ({whole[1]} to {whole[2]})")
        else:
            cells.append(f"{value:.2f} ({low:.2f} to {high:.2f})")
    return cells


def as_data(found: StudySummary) -> dict[str, Any]:
    """Statistics and sensitivities for `--json`, in SI units."""
    from pitchpoint.analysis.study.statistics import QUANTILES

    def plain(estimate: Estimate | None) -> Any:
        """Estimate as value and limits."""
        return (
            None
            if estimate is None
            else {"value": estimate.value, "low": estimate.low, "high": estimate.high}
        )

    names = [f.name for f in found.factors]

    def by_factor(indices: Indices) -> dict[str, Any]:
        """Sensitivity by factor."""
        return {
            name: {"value": indices.value[k], "low": indices.low[k], "high": indices.high[k]}
            for k, name in enumerate(names)
        }

    results: dict[str, Any] = {}
    for one in found.results:
        own: dict[str, Any] = {
            "unit": one.sample.unit,
            "nominal": one.sample.nominal,
            "count": one.spread.count,
            "mean": plain(one.spread.mean),
            "standard_deviation": plain(one.spread.deviation),
            "minimum": one.spread.minimum,
            "maximum": one.spread.maximum,
            "quantiles": {f"{p:g}": plain(q) for p, q in zip(QUANTILES, one.spread.quantiles, strict=True)},
            "share_within_limits": plain(one.within),
        }
        if one.linear is not None:
            own |= {
                "variance_share": by_factor(one.linear.share),
                "regression_coefficient": by_factor(one.linear.coefficient),
                "rank_correlation": by_factor(one.linear.rank),
                "determination": one.linear.determination,
            }
        if one.first is not None and one.total is not None:
            own |= {"first_order_index": by_factor(one.first), "total_index": by_factor(one.total)}
        results[one.sample.name] = own
    return {"confidence": found.confidence, "results": results, "notes": list(found.notes)}
