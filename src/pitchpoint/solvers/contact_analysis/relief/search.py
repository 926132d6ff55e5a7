# SPDX-License-Identifier: Apache-2.0
"""Search for the best design: differential evolution, then linear programmes; every design is recorded."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.progress import Progress
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.solvers.contact_analysis.relief.analyses import Analyses
from pitchpoint.solvers.contact_analysis.relief.curves import Curves
from pitchpoint.solvers.contact_analysis.relief.minimax import Point, polish
from pitchpoint.solvers.contact_analysis.relief.plan import FINER, LEAST_ANALYSES, ReliefPlan
from pitchpoint.solvers.contact_analysis.relief.target import tolerance_samples
from pitchpoint.solvers.contact_analysis.relief.variables import Flanks

Array = NDArray[np.float64]

_NOMINAL, _EVOLUTION, _COARSE = 0.1, 0.5, 0.75
"""Shares of the analyses up to the end of the search without tolerances, of differential evolution, and of
linear programmes without more positions."""
_POPULATION = 10
"""Designs of a generation per variable, between the two limits."""
_SMALLEST, _LARGEST, _FEWEST = 16, 64, 5
_SETTLED = 1e-4
"""Spread of a generation, relative, at which the evolution ends."""
_STARTS, _FINAL, _APART = 4, 2, 0.05
"""Designs from which linear programmes start, those with more positions, and their distance relative to the
bounds."""
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
        self.low = np.array([v.low for v in plan.variables])
        self.span = np.array([v.high for v in plan.variables]) - self.low
        wide = [plan.tolerances.get(path, 0.0) for path in plan.paths]
        self.every = tolerance_samples(wide, plan.samples, plan.seed)
        least = LEAST_ANALYSES * len(self.every)
        if plan.analyses < least:
            raise SolverError(
                f"relief design: {plan.analyses} analyses are too few for {len(self.every)} deviations "
                f"within the tolerances; give at least {least}",
                INCONSISTENT,
            )
        self.count, self.weight, self.limit = 0, 1, 0.0
        self.deviations, self.first = self.every, 0
        self.values: list[Array] = []
        self.scores: list[float] = []
        self.effort: list[tuple[int, int]] = []
        self.best: Point | None = None

    def _begin(self, deviations: Array, share: float) -> None:
        """Begin a stage up to a share of the analyses; its scores are not comparable with those before."""
        self.deviations, self.limit = deviations, share * self.plan.analyses
        self.first = len(self.values)

    def refine(self) -> None:
        """Begin the last stage, with more positions."""
        if self.weight < FINER:
            conditions = self.plan.conditions(self.plan.loads, FINER * self.plan.positions)
            self.analyses, self.weight = self.analyses.under(conditions), FINER
        self._begin(self.every, 1.0)

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
        if self.count + self.weight * size * len(points) > self.limit:
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
            self.effort.append((self.analyses.conditions.positions, size))
            if self.best is None or new.score < self.best.score:
                self.best = new
            found.append(new)
        return found

    def _count(self) -> None:
        """Count one analysis."""
        self.count += self.weight
        note = "" if self.best is None else f"best {self.best.score:.4g} µm"
        self.progress(self.count, self.plan.analyses, note)

    def run(self, start: Array) -> None:
        """Search from a start, values of the variables relative to the bounds; the result is `best`."""
        first = [start]
        if len(self.every) > 1:
            self._begin(self.every[:1], _NOMINAL)
            self._explore(first, 0.5 * _NOMINAL)
            first += self._leading(_STARTS)
        self.best = None
        self._begin(self.every, _COARSE)
        self._explore(first, _EVOLUTION)
        leading, coarse = self._leading(_FINAL), self.best
        self.refine()
        self.best = None
        try:
            self._polish(leading)
        finally:
            self.best = self.best or coarse

    def _explore(self, first: Sequence[Array], share: float) -> None:
        """Differential evolution up to a share of the analyses, then linear programmes."""
        with suppress(ExhaustedError):
            self._evolve(first, int(share * self.plan.analyses - self.count) // len(self.deviations))
        self._polish(self._leading(_STARTS))

    def _polish(self, designs: Sequence[Array]) -> None:
        """Linear programmes from several designs."""
        with suppress(ExhaustedError):
            polish(self.evaluate, [self.evaluate([at])[0] for at in designs], self.target)

    def _evolve(self, given: Sequence[Array], designs: int) -> None:
        """Differential evolution; the first generation is a Sobol sequence and the given designs."""
        from scipy.optimize import Bounds, differential_evolution
        from scipy.stats import qmc

        count = int(min(max(_POPULATION * self.n, _SMALLEST), _LARGEST))
        count = max(min(count, designs), len(given))
        sobol = qmc.Sobol(self.n, seed=self.plan.seed).random(1 << (count - 1).bit_length())
        first = np.concatenate([np.array(given), sobol[: count - len(given)]])
        generations = designs // count - 1
        if generations < 1 or count < _FEWEST:
            self.evaluate(list(first))
            return

        def scores(x: Array, /) -> Any:
            """Scores of a generation, shape (variables, designs)."""
            return np.array([point.score for point in self.evaluate(list(x.T))])

        differential_evolution(
            scores,
            Bounds(np.zeros(self.n), np.ones(self.n)),
            strategy="rand1bin",
            init=first,
            maxiter=generations,
            tol=_SETTLED,
            polish=False,
            vectorized=True,
            updating="deferred",
            seed=self.plan.seed,
        )

    def _leading(self, count: int) -> list[Array]:
        """Best designs of this stage that differ from each other."""
        chosen: list[Array] = []
        for k in self.first + np.argsort(self.scores[self.first :], kind="stable"):
            at = (self.values[k] - self.low) / self.span
            if all(np.abs(at - other).max() > _APART for other in chosen):
                chosen.append(at)
            if len(chosen) == count:
                break
        return chosen

    def rounded(self) -> Array:
        """Best values rounded to drawing precision [m]: the best of all neighbours, or the nearest."""
        assert self.best is not None
        exact = self.low + self.best.at * self.span
        choices = []
        for variable, value in zip(self.plan.variables, exact, strict=True):
            below = variable.step * np.floor(value / variable.step + 1e-9)
            near = [round(k, 12) for k in (below, below + variable.step)]
            inside = [k for k in near if variable.low - 1e-12 <= k <= variable.high + 1e-12] or [value]
            choices.append([inside[k] for k in np.argsort(np.abs(np.array(inside) - value), kind="stable")])
        nearest = np.array([one[0] for one in choices])
        if 2**self.n * len(self.deviations) * self.weight > _ROUNDING * self.plan.analyses:
            return nearest
        every = [np.array(one) for one in itertools.product(*choices)]
        scores = [self.target.score(self.curves(values)) for values in every]
        return every[int(np.argmin(scores))]
