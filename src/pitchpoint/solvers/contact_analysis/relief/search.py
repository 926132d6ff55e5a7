# SPDX-License-Identifier: Apache-2.0
"""Search for the best design: differential evolution, then linear programmes; every design is recorded."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.progress import Progress
from pitchpoint.solvers.contact_analysis.relief.analyses import Analyses
from pitchpoint.solvers.contact_analysis.relief.curves import Curves
from pitchpoint.solvers.contact_analysis.relief.minimax import Point, polish
from pitchpoint.solvers.contact_analysis.relief.plan import ReliefPlan
from pitchpoint.solvers.contact_analysis.relief.target import tolerance_samples
from pitchpoint.solvers.contact_analysis.relief.variables import Flanks

Array = NDArray[np.float64]

_EVOLUTION = 0.6
"""Share of the analyses for differential evolution."""
_POPULATION = 10
"""Designs of a generation per variable, between the two limits."""
_SMALLEST, _LARGEST = 16, 64
_SETTLED = 1e-4
"""Spread of a generation, relative, at which the evolution ends."""
_STARTS, _APART = 4, 0.1
"""Designs from which linear programmes start, and their distance relative to the bounds."""
_ROUNDING = 0.15
"""Share of the analyses up to which all roundings are compared."""


class ExhaustedError(Exception):
    """The permitted number of analyses is used up."""


class Search:
    """Search of one plan.

    Parameters
    ----------
    plan
        The plan.
    flanks
        Loaded flanks as functions of the paths of the plan.
    analyses
        Analyses at the torques of the plan.
    pool
        Threads.
    progress
        Called after each analysis.
    """

    def __init__(
        self,
        plan: ReliefPlan,
        flanks: Flanks,
        analyses: Analyses,
        pool: ThreadPoolExecutor,
        progress: Progress,
    ) -> None:
        self.plan, self.flanks, self.analyses, self.pool = plan, flanks, analyses, pool
        self.progress = progress
        self.target = plan.target()
        self.n = len(plan.vary)
        self.low = np.array([v.low for v in plan.vary])
        self.span = np.array([v.high for v in plan.vary]) - self.low
        wide = [plan.tolerances.get(path, 0.0) for path in plan.paths]
        self.deviations = tolerance_samples(wide, plan.samples, plan.seed)
        self.count = 0
        self.values: list[Array] = []
        self.scores: list[float] = []
        self.best: Point | None = None

    def rows(self, values: Array, deviation: Array) -> Array:
        """Rows of a design, values of the variables [m], with a deviation of all paths."""
        others = self.flanks.start[self.n :]
        return self.flanks.rows(np.concatenate([values, others]) + deviation)

    def curves(self, values: Array) -> list[Curves]:
        """Analyses of a design at all deviations, not recorded."""
        designs = [self.rows(values, deviation) for deviation in self.deviations]
        return self.analyses.curves_of(designs, self.pool)

    def evaluate(self, points: Sequence[Array]) -> list[Point]:
        """Analyse designs given by values relative to the bounds, and record them.

        Raises
        ------
        ExhaustedError
            If these need more analyses than are left.
        """
        size = len(self.deviations)
        if self.count + size * len(points) > self.plan.analyses:
            raise ExhaustedError
        values = [self.low + point * self.span for point in points]
        designs = [self.rows(one, deviation) for one in values for deviation in self.deviations]
        curves = self.analyses.curves_of(designs, self.pool, self._count)
        found = []
        for k, point in enumerate(points):
            samples = curves[k * size : (k + 1) * size]
            new = Point(np.asarray(point), samples, self.target.score(samples))
            self.values.append(values[k])
            self.scores.append(new.score)
            if self.best is None or new.score < self.best.score:
                self.best = new
            found.append(new)
        return found

    def _count(self) -> None:
        """Count one analysis."""
        self.count += 1
        note = "" if self.best is None else f"best {self.best.score:.4g} µm"
        self.progress(self.count, self.plan.analyses, note)

    def run(self, start: Array) -> None:
        """Search from a start, values of the variables relative to the bounds; the result is `best`."""
        try:
            self._evolve(start)
            for start in self._starts():
                polish(self.evaluate, self.evaluate([start])[0], self.target)
        except ExhaustedError:
            pass

    def _evolve(self, start: Array) -> None:
        """Differential evolution; the first generation is a Sobol sequence and the start."""
        from scipy.optimize import Bounds, differential_evolution
        from scipy.stats import qmc

        count = int(min(max(_POPULATION * self.n, _SMALLEST), _LARGEST))
        designs = int(_EVOLUTION * self.plan.analyses) // len(self.deviations)
        count = min(count, designs)
        sobol = qmc.Sobol(self.n, seed=self.plan.seed).random(1 << (count - 1).bit_length())
        first = np.concatenate([start[None, :], sobol[: count - 1]])
        generations = designs // count - 1
        if generations < 1 or count < 5:
            self.evaluate(list(first))
            return

        def scores(x: Array, /) -> Any:
            """Scores of a generation, shape (variables, designs)."""
            return np.array([point.score for point in self.evaluate(list(x.T))])

        differential_evolution(
            scores,
            Bounds(np.zeros(self.n), np.ones(self.n)),
            init=first,
            maxiter=generations,
            tol=_SETTLED,
            polish=False,
            vectorized=True,
            updating="deferred",
            seed=self.plan.seed,
        )

    def _starts(self) -> list[Array]:
        """Best designs that differ from each other."""
        chosen: list[Array] = []
        for k in np.argsort(self.scores, kind="stable"):
            at = (self.values[k] - self.low) / self.span
            if all(np.abs(at - other).max() > _APART for other in chosen):
                chosen.append(at)
            if len(chosen) == _STARTS:
                break
        return chosen

    def rounded(self) -> Array:
        """Best values rounded to drawing precision [m]: the best of all neighbours, or the nearest."""
        assert self.best is not None
        exact = self.low + self.best.at * self.span
        choices = []
        for variable, value in zip(self.plan.vary, exact, strict=True):
            below = variable.step * np.floor(value / variable.step + 1e-9)
            near = [round(k, 12) for k in (below, below + variable.step)]
            inside = [k for k in near if variable.low - 1e-12 <= k <= variable.high + 1e-12] or [value]
            choices.append([inside[k] for k in np.argsort(np.abs(np.array(inside) - value), kind="stable")])
        nearest = np.array([one[0] for one in choices])
        if 2**self.n * len(self.deviations) > _ROUNDING * self.plan.analyses:
            return nearest
        every = [np.array(one) for one in itertools.product(*choices)]
        scores = [self.target.score(self.curves(values)) for values in every]
        return every[int(np.argmin(scores))]
