# SPDX-License-Identifier: Apache-2.0
"""HTML page of a study: spread, distribution, sensitivities and convergence of each result."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from html import escape
from typing import Any

import numpy as np

from pitchpoint.analysis.study.statistics import QUANTILES, Estimate
from pitchpoint.analysis.study.summary import ResultSummary, StudySummary
from pitchpoint.viz.quantities import number
from pitchpoint.viz.report.page import Section, page
from pitchpoint.viz.study_plots import (
    factor_scale,
    plot_coefficients,
    plot_convergence,
    plot_convergence_of_deviation,
    plot_cumulative,
    plot_distribution,
    plot_over_factors,
    plot_sensitivities,
    result_scale,
)
from pitchpoint.viz.tables import plain_table

NOTHING = "–"
METHODS = {
    "latin_hypercube": "Latin hypercube",
    "sobol": "Sobol' sequence",
    "random": "random",
    "full_factorial": "full factorial",
}


def study_page(summary: StudySummary, title: str, options: Mapping[str, Any], version: str) -> str:
    """Page of a study.

    Parameters
    ----------
    summary
        Its statistics.
    title
        Title of the page.
    options
        Options of the study: sampling, samples, seed, evaluate.
    version
        Version of the package.
    """
    count, done = len(summary.finished), int(np.count_nonzero(summary.finished))
    facts = [
        ("cases", f"{count}" if done == count else f"{done} of {count} finished"),
        ("sampling", METHODS[str(options["sampling"])]),
        ("seed", str(options["seed"])),
        ("confidence level", f"{100.0 * summary.confidence:g} %"),
    ]
    sections = [_overview(summary), _factors(summary), *result_sections(summary)]
    footer = f"pitchpoint {version}. Intervals are those of independent random samples."
    return page(title, facts, sections, footer, summary.notes)


def result_sections(summary: StudySummary) -> list[Section]:
    """One section with the pictures of each result."""
    return [_result(summary, one, k) for k, one in enumerate(summary.results)]


def _overview(summary: StudySummary) -> Section:
    """Spread of all results."""
    section = Section("spread", "Spread of the results")
    limited = any(one.within is not None for one in summary.results)
    head = ["result", "without changes", "mean", "standard deviation", "minimum", "maximum"]
    body, quantiles = [], []
    for one in summary.results:
        s = one.spread
        unit = result_scale(one)
        cells = [unit.title(one.sample.name), _number(one.sample.nominal * unit.factor)]
        cells += [_estimate(e, unit.factor) for e in (s.mean, s.deviation)]
        cells += [_number(s.minimum * unit.factor), _number(s.maximum * unit.factor)]
        if limited:
            cells.append(_estimate(one.within, 100.0) if one.within is not None else NOTHING)
        body.append(_row(cells))
        quantiles.append(_row([cells[0], *(_estimate(q, unit.factor) for q in s.quantiles)]))
    section.add(plain_table([*head, *(["within limits [%]"] if limited else [])], body, words=1))
    section.add("<h3>Quantiles</h3>")
    section.add(plain_table(["result", *(f"{100.0 * p:g} %" for p in QUANTILES)], quantiles, words=1))
    section.add("<p>In brackets: limits of the confidence intervals.</p>")
    return section


def _factors(summary: StudySummary) -> Section:
    """What varies."""
    section = Section("factors", "Factors")
    body = []
    for factor in summary.factors:
        unit = factor_scale(factor)
        values = factor.values[summary.counted]
        if factor.labels:
            cells = [factor.name, factor.words, NOTHING, NOTHING, NOTHING, ", ".join(factor.labels)]
        else:
            sizes = (factor.nominal, float(values.mean()), float(values.std(ddof=1)))
            ends = " to ".join(_number(float(x) * unit.factor) for x in (values.min(), values.max()))
            cells = [unit.title(factor.name), factor.words, *(_number(x * unit.factor) for x in sizes), ends]
        body.append(_row(cells, words=2))
    head = ["factor", "varies", "without changes", "mean", "standard deviation", "values"]
    section.add(plain_table(head, body, words=2))
    return section


def _result(summary: StudySummary, one: ResultSummary, index: int) -> Section:
    """Pictures of one result."""
    name = one.sample.name
    section = Section(f"result-{index}", name)
    section.add(f"<p>{escape(_sentence(summary, one))}</p>")
    section.add_figure(
        plot_distribution(summary, one),
        "Histogram.",
        name=f"distribution[{name}]",
        beside=plot_cumulative(summary, one),
        beside_caption="Cumulative distribution.",
        beside_name=f"cumulative[{name}]",
    )
    coefficients = plot_coefficients(summary, one)
    indices = one.total is not None
    words = "total Sobol' indices with interactions" if indices else "linear regression over all factors"
    section.add_figure(
        plot_sensitivities(summary, one),
        f"Share of each factor in the variance: {words}. Lines: confidence intervals.",
        name=f"sensitivities[{name}]",
        beside=coefficients,
        beside_caption="Standard deviations of the result for one standard deviation of the factor.",
        beside_name=f"coefficients[{name}]",
    )
    section.add_figure(
        plot_over_factors(summary, one),
        "Scatter of the result over the factors; diamond: the model without changes.",
        name=f"over_factors[{name}]",
    )
    section.add_figure(
        plot_convergence(summary, one),
        "Convergence of the mean with the number of cases.",
        name=f"convergence[{name}]",
        beside=plot_convergence_of_deviation(summary, one),
        beside_caption="Convergence of the total indices."
        if indices
        else "Convergence of the standard deviation.",
        beside_name=f"convergence_of_deviation[{name}]",
    )
    return section


def _sentence(summary: StudySummary, one: ResultSummary) -> str:
    """Result in words: what it is, its spread and the share within limits."""
    unit, s = result_scale(one), one.spread
    text = f"{one.sample.words[:1].upper()}{one.sample.words[1:]}."
    if s.count:
        mean, deviation = unit.text(s.mean.value), unit.text(s.deviation.value)
        text += f" {s.count} values, mean {mean}, standard deviation {deviation}."
    if one.within is not None:
        w = one.within
        text += (
            f" {100.0 * w.value:.4g} % of the cases are within the limits (interval {100.0 * w.low:.4g} to "
            f"{100.0 * w.high:.4g} %)."
        )
    if one.linear is not None and math.isfinite(one.linear.determination):
        text += f" The regression explains R² = {100.0 * one.linear.determination:.1f} % of the variance."
    return text


def _row(cells: Sequence[str], words: int = 1) -> str:
    """Row of a table."""
    html = [f'<th scope="row">{escape(cells[0])}</th>']
    for k, cell in enumerate(cells[1:], start=1):
        text = escape(cell).replace("\n", "<br>")
        html.append(f"<td{'' if k < words else ' class=num'}>{text}</td>")
    return f"<tr>{''.join(html)}</tr>"


def _number(value: float) -> str:
    return number(float(value), 4) if math.isfinite(value) else NOTHING


def _estimate(estimate: Estimate, factor: float) -> str:
    """Number with its interval."""
    value, low, high = (factor * x for x in (estimate.value, estimate.low, estimate.high))
    if not math.isfinite(value):
        return NOTHING
    return f"{_number(value)}\n({_number(low)} to {_number(high)})"
