# SPDX-License-Identifier: Apache-2.0
"""Local search for the least maximum of peak-to-peak values: linear programmes within a trust region.

The values are max − min of curves over the mesh phase: kinked in the design, but the curves themselves are
smooth in it. A linear programme with all points of the linearised curves has their kinks exactly. At an
optimum with as many active points as variables the steps converge quadratically.

Source: K. Madsen, An algorithm for minimax solution of overdetermined systems of non-linear equations, IMA J.
Appl. Math. 16 (1975) 321-328.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.solvers.contact_analysis.relief.curves import Curves
from pitchpoint.solvers.contact_analysis.relief.target import MICRO, PENALTY, Target

Array = NDArray[np.float64]

_DIFFERENCES = (2e-2, -2e-2, 1e-3, -1e-3, 1e-5, -1e-5)
"""Steps of differences, relative to the bounds. Where the start of a relief passes a contact node, the curves
themselves have kinks: long steps average over them, both signs see both sides."""
_FIRST, _LEAST = 5.0, 0.05
"""First and smallest size of the trust region over the difference."""
_WIDEST = 0.01
"""Smallest first size of the trust region, relative to the bounds."""
_GAIN = 1e-7
"""Expected gain of a step [µm] below which a series of steps ends."""
_ENOUGH = 1e-4
"""Gain [µm] of a series over all differences below which the search ends."""
_NEAR = 0.5
"""Limits this close to a violation enter the linear programme."""


@dataclass(frozen=True, eq=False)
class Point:
    """A design with its analyses: values relative to the bounds, samples of the tolerances, score [µm]."""

    at: Array
    samples: Sequence[Curves]
    score: float


Evaluate = Callable[[Sequence[Array]], Sequence[Point]]
"""Analysis of several designs, given by values relative to the bounds, 0 to 1."""


def polish(evaluate: Evaluate, starts: Sequence[Point], target: Target) -> None:
    """Improve designs, after a series of steps of each the best one first, until none improves any more.

    Parameters
    ----------
    evaluate
        Analyses designs, and keeps the best.
    starts
        The designs.
    target
        What is minimised.
    """
    designs = [_series(evaluate, start, target) for start in sorted(starts, key=_score)]
    while designs:
        best = min(designs, key=_score)
        designs.remove(best)
        better = _series(evaluate, best, target)
        if best.score - better.score >= _ENOUGH:
            designs.append(better)


def _score(point: Point) -> float:
    return point.score


def _series(evaluate: Evaluate, start: Point, target: Target) -> Point:
    """Steps with all differences."""
    for difference in _DIFFERENCES:
        start = _descend(evaluate, start, target, difference)
    return start


def _descend(evaluate: Evaluate, start: Point, target: Target, difference: float) -> Point:
    """Steps of linear programmes with slopes from one kind of difference."""
    best, radius = start, max(_FIRST * abs(difference), _WIDEST)
    slopes: Sequence[Point] | None = None
    while radius > _LEAST * abs(difference):
        ends = best.at + difference
        steps = np.where((ends > 1.0) | (ends < 0.0), -difference, difference)
        if slopes is None:
            slopes = evaluate([best.at + step for step in np.diag(steps)])
        step, expected = _programme(best, slopes, steps, target, radius)
        gain = best.score - expected
        if gain < _GAIN:
            break
        (new,) = evaluate([np.clip(best.at + step, 0.0, 1.0)])
        actual = best.score - new.score
        if actual < 0.25 * gain:
            radius = 0.25 * min(radius, float(np.abs(step).max()))
        elif actual > 0.75 * gain:
            radius = min(2.0 * radius, 1.0)
        if actual > 0.0:
            best, slopes = new, None
    return best


def _programme(
    best: Point, slopes: Sequence[Point], steps: Array, target: Target, radius: float
) -> tuple[Array, float]:
    """Step of the linear programme, and the score that it predicts.

    Unknowns: step d; upper and lower end u, l of each curve; objective and violation. Rows: curve + slope d
    <= u, >= l; weighted sums of u - l <= objective; limits + slope d <= violation.
    """
    from scipy.optimize import linprog
    from scipy.sparse import block_array, coo_array

    n = best.at.size
    curves = np.array([c.points for c in best.samples]) / MICRO
    shape = curves.shape[:3]  # samples, misalignments, torques
    flat = curves.reshape(-1, curves.shape[3])
    by = np.array([[c.points for c in point.samples] for point in slopes]).reshape(n, *flat.shape) / MICRO
    by = (by - flat) / steps[:, None, None]
    room = radius * np.abs(by).sum(axis=0)  # not a number where a curve has no kink: never in the programme
    base = np.nanmean(flat, axis=1)[:, None]
    high = np.argwhere(flat + room >= np.nanmax(flat - room, axis=1)[:, None])
    low = np.argwhere(flat - room <= np.nanmin(flat + room, axis=1)[:, None])
    ends = len(flat)
    blocks, right = [], []
    for sign, chosen, at in ((1.0, high, 0), (-1.0, low, 1)):
        k, p = chosen.T
        rows = np.arange(k.size)
        slope = coo_array(sign * by[:, k, p].T)
        end = coo_array((np.full(k.size, -sign), (rows, k)), shape=(k.size, ends))
        none = coo_array((k.size, ends))
        blocks.append([slope, *((end, none) if at == 0 else (none, end)), coo_array((k.size, 2))])
        right.append(-sign * (flat - base)[k, p])
    groups, factors = _groups(shape, target)
    part = coo_array((factors, (groups, np.arange(ends))), shape=(int(groups.max()) + 1, ends))
    value = coo_array(np.tile([-1.0, 0.0], (part.shape[0], 1)))
    blocks.append([coo_array((part.shape[0], n)), part, -part, value])
    right.append(np.zeros(part.shape[0]))
    limits, limit_slopes = _limits(best, slopes, steps, target)
    if limits.size:
        outside = coo_array(np.tile([0.0, -1.0], (limits.size, 1)))
        none = coo_array((limits.size, ends))
        blocks.append([coo_array(limit_slopes), none, none, outside])
        right.append(-limits)
    bounds = [(max(-radius, -x), min(radius, 1.0 - x)) for x in best.at]
    bounds += [(None, None)] * (2 * ends) + [(None, None), (0.0, None)]
    cost = np.zeros(n + 2 * ends + 2)
    cost[-2:] = 1.0, PENALTY
    found = linprog(
        cost, A_ub=block_array(blocks).tocsr(), b_ub=np.concatenate(right), bounds=bounds, method="highs"
    )
    if found.status != 0 or found.x is None:
        return np.zeros(n), best.score
    return np.asarray(found.x[:n]), float(cost @ found.x)


def _groups(shape: tuple[int, int, int], target: Target) -> tuple[NDArray[np.int64], Array]:
    """Number of the row of the objective of each curve, and its factor."""
    samples, cases, torques = shape
    factors = np.tile(target.factors(), samples * cases)
    if target.mean:
        return np.repeat(np.arange(samples * cases), torques), factors
    return np.arange(factors.size), factors


def _limits(best: Point, slopes: Sequence[Point], steps: Array, target: Target) -> tuple[Array, Array]:
    """Limits near violation, shape (limits,), and their slopes, shape (limits, variables)."""
    here = np.concatenate([target.excess(c) for c in best.samples])
    near = here > -_NEAR
    found = [(np.concatenate([target.excess(c) for c in p.samples]) - here)[near] for p in slopes]
    return here[near], np.array(found).T / steps
