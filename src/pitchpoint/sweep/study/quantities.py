# SPDX-License-Identifier: Apache-2.0
"""Results of a case by name: those that an evaluation gives, with units, and their numbers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from pitchpoint.analysis.mesh_sweep import swept_meshes
from pitchpoint.core.extremes import greatest
from pitchpoint.core.load_sharing import is_factor
from pitchpoint.io.contact_numbers import RATTLE
from pitchpoint.io.sweep_store import CONTACTS, QUANTITIES, STATISTICS
from pitchpoint.model.model import Model
from pitchpoint.model.study_plan import EQUILIBRIUM, MODES
from pitchpoint.sweep.case_channels import case_channels
from pitchpoint.sweep.cases import CaseResult
from pitchpoint.sweep.states import MODE_NUMBERS
from pitchpoint.system.compile import compile_model

JUMPS = "jumps"
"""Number of jumps of a speed sweep."""

Numbers = dict[str, list[float]]
"""Numbers by name, in the order of `STATISTICS`; those of a single number are equal."""


@dataclass(frozen=True)
class Quantity:
    """Result that can be evaluated: SI unit, description, whether it is a single number."""

    unit: str
    words: str
    single: bool


def available(model: Model, scenario: str | None, evaluate: str) -> dict[str, Quantity]:
    """All results of an evaluation by name; modes up to the number of coordinates.

    Parameters
    ----------
    model, scenario, evaluate
        Model, name of its scenario, and evaluation.
    """
    if evaluate == MODES:
        count = len(compile_model(model, scenario).layout.coordinates)
        return {
            f"{name}[{k}]": Quantity(unit, f"{words} of mode {k}", True)
            for name, unit, words in MODE_NUMBERS
            for k in range(1, count + 1)
        }
    if evaluate == EQUILIBRIUM:
        observed = compile_model(model, scenario).layout.channels
        return {c.name: Quantity(c.unit, c.long_name, True) for c in observed}
    channels, more = case_channels(model, model.scenarios[str(scenario)])
    found = {name: Quantity(unit, words, is_factor(name)) for name, unit, words in channels}
    meshes = more.get("meshes", ())
    if "directions" in more:
        found |= {f"{n}[{m}]": Quantity(unit, words, False) for m in meshes for n, unit, words in QUANTITIES}
        found |= {f"{n}[{m}]": Quantity(unit, words, True) for m in meshes for n, unit, words in CONTACTS}
        return found | {JUMPS: Quantity("1", "number of jumps", True)}
    return found | {f"{n}[{m}]": Quantity(unit, words, True) for m in meshes for n, unit, words in RATTLE}


def numbers_of(result: CaseResult) -> Numbers:
    """Numbers of all results of a case."""
    if result.points:
        return _of_sweep(result)
    found: Numbers = {}
    for name, row in result.channels.items():
        found[name] = [float(row[key]) for key in STATISTICS]
        owner = name.partition("[")[2]
        found |= {f"{n}[{owner}": _single(row[n]) for n, _, _ in RATTLE if n in row}
    return found


def value_of(numbers: Mapping[str, list[float]], channel: str, statistic: str | None) -> float:
    """Value of a result of the plan in a case; NaN if the case has no such number.

    Examples
    --------
    >>> value_of({"mesh_force[st]": [1.0, 0.5, -3.0, 2.0]}, "mesh_force[st]", "peak_to_peak")
    5.0
    """
    if channel not in numbers:
        return float("nan")
    row = dict(zip(STATISTICS, numbers[channel], strict=True))
    if statistic == "peak_to_peak":
        return row["max"] - row["min"]
    return abs(greatest(row)) if statistic == "magnitude" else row[statistic or "mean"]


def _single(value: float) -> list[float]:
    return [float(value)] * len(STATISTICS)


def _of_sweep(result: CaseResult) -> Numbers:
    """Extremes over all points of a sweep, the largest rms and the mean of the means; largest numbers."""
    found: Numbers = {JUMPS: _single(len(result.jumps))}
    for mesh in swept_meshes(result.points):
        own = [p["meshes"][mesh] for p in result.points]
        for name, _, _ in QUANTITIES:
            rows = [point[name] for point in own]
            found[f"{name}[{mesh}]"] = [
                sum(r["mean"] for r in rows) / len(rows),
                max(r["rms"] for r in rows),
                min(r["min"] for r in rows),
                max(r["max"] for r in rows),
            ]
        found |= {f"{name}[{mesh}]": _single(max(point[name] for point in own)) for name, _, _ in CONTACTS}
    factors: dict[str, Any] = {name: None for point in result.points for name in point if is_factor(name)}
    found |= {n: _single(max(p[n] for p in result.points if n in p)) for n in factors}
    return found
