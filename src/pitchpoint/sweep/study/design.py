# SPDX-License-Identifier: Apache-2.0
"""Samples of a study: probabilities of all factors in each case, and the resulting changes of the model."""

from __future__ import annotations

import itertools
import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.model.study_plan import FACTORIAL, INDICES, LATIN, RANDOM, SOBOL
from pitchpoint.sweep.study.check import Study, correlation_matrix
from pitchpoint.sweep.study.factors import LAST, Array, Choice

MOST = 1_000_000
"""Maximum number of cases."""
FIRST, SECOND = 0, 1
"""Groups of the cases of sobol_indices: two independent samples. Group 2 + k is the first sample with the
values of factor k from the second."""


@dataclass(frozen=True)
class StudyCase:
    """One case: index, value of each factor by name, group (see `FIRST`), changes of the model by path."""

    index: int
    values: dict[str, float]
    group: int
    changes: dict[str, Any]


def count_of(study: Study) -> int:
    """Number of cases without the nominal one.

    Raises
    ------
    ModelError
        If there are more than `MOST`.
    """
    plan = study.plan
    count = plan.samples
    if plan.sampling == FACTORIAL:
        count = 1
        for factor in study.factors:
            count *= len(factor.written) if isinstance(factor, Choice) else plan.samples
    elif plan.sensitivity == INDICES:
        count *= len(study.factors) + 2
    if count > MOST:
        remedy = "reduce samples or the number of factors"
        line = plan.lines.get(("samples",))
        message = Message("samples", f"give {count} cases", None, f"at most {MOST}", remedy, line)
        raise ModelError([message], plan.file)
    return count


def probabilities(study: Study) -> Array:
    """Probabilities of the factors, shape (number of cases, number of factors).

    Those of sobol_indices are ordered by point: first sample, second sample, and the mixed ones, so that a
    longer plan begins with the cases of a shorter one (A. Saltelli et al., Computer Physics Communications
    181 (2010) 259-270).
    """
    plan, n = study.plan, len(study.factors)
    count_of(study)
    if plan.sampling == FACTORIAL:
        return _grid(study)
    if plan.sensitivity == INDICES:
        points = _points(study, 2 * n)
        first, second = points[:, :n], points[:, n:]
        blocks = [first, second]
        for k in range(n):
            mixed = first.copy()
            mixed[:, k] = second[:, k]
            blocks.append(mixed)
        return np.stack(blocks, axis=1).reshape(-1, n)
    points = _points(study, n)
    return _correlated(points, study) if plan.correlations else points


def _points(study: Study, dimensions: int) -> Array:
    """Points in the unit cube by the sampling of the plan."""
    from scipy.stats import qmc

    plan = study.plan
    random = np.random.default_rng(plan.seed)
    if plan.sampling == RANDOM:
        return random.random((plan.samples, dimensions))
    if plan.sampling == LATIN:
        return np.asarray(qmc.LatinHypercube(dimensions, rng=random).random(plan.samples))
    assert plan.sampling == SOBOL
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # not a power of two: a remark of the command
        return np.asarray(qmc.Sobol(dimensions, rng=random).random(plan.samples))


def _grid(study: Study) -> Array:
    """Middle of each of `samples` intervals of equal probability, or each level, in all combinations."""
    columns = []
    for factor in study.factors:
        n = len(factor.written) if isinstance(factor, Choice) else study.plan.samples
        columns.append((np.arange(n) + 0.5) / n)
    return np.array(list(itertools.product(*columns)))


def _correlated(points: Array, study: Study) -> Array:
    """Probabilities of normal variables with the correlation coefficients of the plan."""
    from scipy.special import ndtr, ndtri

    root = np.linalg.cholesky(correlation_matrix(study.plan))
    return np.asarray(ndtr(ndtri(np.clip(points, LAST, 1.0 - LAST)) @ root.T))


def cases_of(study: Study) -> list[StudyCase]:
    """All cases in the order of the plan, without the nominal one."""
    u = probabilities(study)
    values = np.column_stack([f.values(u[:, k]) for k, f in enumerate(study.factors)])
    groups = len(study.factors) + 2 if study.plan.sensitivity == INDICES else 1
    cases = []
    for index in range(len(u)):
        changes: dict[str, Any] = {}
        for k, factor in enumerate(study.factors):
            changes |= factor.changes(float(u[index, k]), float(values[index, k]))
        own = {f.name: float(values[index, k]) for k, f in enumerate(study.factors)}
        cases.append(StudyCase(index, own, index % groups, changes))
    return cases


def nominal_case(study: Study) -> StudyCase:
    """The model without changes, as case -1."""
    return StudyCase(-1, {f.name: f.nominal for f in study.factors}, FIRST, {})
