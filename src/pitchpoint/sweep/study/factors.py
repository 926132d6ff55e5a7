# SPDX-License-Identifier: Apache-2.0
"""Factors of a study for its model: values by probability, and the changes of the model for a value.

Every value is a function of one number between 0 and 1, its probability. So all samplings and both kinds of
sensitivities apply to all factors, including random pitch deviations: each of its numbers selects a pattern.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from pitchpoint.model.study_plan import EQUAL, INDEPENDENT, LEFT, RIGHT

Array: TypeAlias = NDArray[np.float64]
LAST = 2.0**-32
"""Distance of probabilities from 0 and 1, where normal values are infinite."""
DIGITS = 12
"""Significant digits of values in the model: the last bits of a function may depend on the processor."""


@dataclass(frozen=True)
class Number:
    """A factor with continuous values.

    Parameters
    ----------
    name, unit
        Name, and SI unit of its values.
    numbers
        Number of the model at each path, SI.
    apply
        As in `model.study_plan`.
    distribution
        Frozen distribution of SciPy.
    nominal
        Value of the factor that does not change the model; NaN if the numbers at its paths differ.
    """

    name: str
    unit: str
    numbers: Mapping[str, float]
    apply: str
    distribution: Any
    nominal: float

    def values(self, u: Array) -> Array:
        """Values at probabilities."""
        return np.asarray(self.distribution.ppf(np.clip(u, LAST, 1.0 - LAST)), np.float64)

    def changes(self, u: float, value: float) -> dict[str, Any]:
        """New values of the model by path."""
        return {path: rounded(applied(self.apply, old, value)) for path, old in self.numbers.items()}

    def label(self, value: float) -> str:
        """Value as text."""
        return repr(float(value))


@dataclass(frozen=True)
class Choice:
    """A factor with discrete values.

    Parameters
    ----------
    name, unit
        Name, and SI unit of its values; empty if they are not numbers.
    numbers
        Number of the model at each path, SI; NaN where there is none.
    apply
        As in `model.study_plan`.
    written
        Values as written.
    amounts
        Their numbers in SI; None if any of them is not a number: then their index represents them.
    weights
        Probability of each value.
    nominal
        Value that does not change the model; NaN if it is not known.
    """

    name: str
    unit: str
    numbers: Mapping[str, float]
    apply: str
    written: tuple[Any, ...]
    amounts: tuple[float, ...] | None
    weights: tuple[float, ...]
    nominal: float = float("nan")

    def index(self, u: Array) -> NDArray[np.intp]:
        """Index of the value at each probability."""
        upper = np.cumsum(self.weights)[:-1]
        return np.searchsorted(upper / np.sum(self.weights), u, side="right")

    def values(self, u: Array) -> Array:
        """Numbers, or indices of values that are not numbers, at probabilities."""
        index = self.index(u)
        return index.astype(np.float64) if self.amounts is None else np.asarray(self.amounts)[index]

    def changes(self, u: float, value: float) -> dict[str, Any]:
        """New values of the model by path."""
        if self.amounts is None or self.apply == "absolute":
            chosen = self.written[int(self.index(np.array([u]))[0])]
            return dict.fromkeys(self.numbers, chosen)
        return {path: rounded(applied(self.apply, old, value)) for path, old in self.numbers.items()}

    def label(self, value: float) -> str:
        """Value as text."""
        return repr(float(value)) if self.amounts is not None else str(self.written[int(value)])


@dataclass(frozen=True)
class Pitch:
    """Random single pitch deviations of gears; the value of the factor is their largest F_p.

    Parameters
    ----------
    name
        Name.
    teeth, deviation
        Number of teeth, and standard deviation of the single pitch deviations [m], of each gear.
    flanks
        As in `model.study_plan`.
    paths, kept
        Path of the pitch deviations of each gear, and those of its left and right flanks in the model [m].
    """

    name: str
    teeth: Mapping[str, int]
    deviation: Mapping[str, float]
    flanks: str
    paths: Mapping[str, str]
    kept: Mapping[str, tuple[tuple[float, ...], tuple[float, ...]]]
    unit: str = "m"
    nominal: float = 0.0

    def values(self, u: Array) -> Array:
        """Largest total cumulative pitch deviation F_p of the gears at probabilities [m]."""
        return np.array([max(cumulative_range(p) for p in self._all_patterns(float(one))) for one in u])

    def patterns(self, u: float) -> dict[str, tuple[Array, ...]]:
        """Single pitch deviations of each gear [m], shape (z,): equal ones, or those of its random flanks."""
        seed = int(u * 2.0**53)
        count = 2 if self.flanks == INDEPENDENT else 1
        return {
            gear: tuple(
                self.deviation[gear]
                * closed_pattern(z, np.random.default_rng([seed, k] if flank == 0 else [seed, k, flank]))
                for flank in range(count)
            )
            for k, (gear, z) in enumerate(self.teeth.items())
        }

    def _all_patterns(self, u: float) -> list[Array]:
        return [pattern for own in self.patterns(u).values() for pattern in own]

    def changes(self, u: float, value: float) -> dict[str, Any]:
        """New values of the model by path."""
        found: dict[str, Any] = {}
        for gear, own in self.patterns(u).items():
            lists = [[rounded(f) for f in pattern.tolist()] for pattern in own]
            if self.flanks == EQUAL:
                found[self.paths[gear]] = lists[0]
                continue
            left, right = self.kept[gear]
            found[self.paths[gear]] = {
                "left": list(left) if self.flanks == RIGHT else lists[0],
                "right": list(right) if self.flanks == LEFT else lists[-1],
            }
        return found

    def label(self, value: float) -> str:
        """Value as text."""
        return repr(float(value))


StudyFactor: TypeAlias = Number | Choice | Pitch


def applied(apply: str, number: float, value: float) -> float:
    """Number of the model changed by the value of a factor.

    Examples
    --------
    >>> applied("absolute", 3.0, 2.0), applied("add", 3.0, 2.0), applied("multiply", 3.0, 2.0)
    (2.0, 5.0, 6.0)
    """
    return {"absolute": value, "add": number + value, "multiply": number * value}[apply]


def rounded(value: float) -> float:
    """Number with `DIGITS` significant digits.

    Examples
    --------
    >>> rounded(0.1 + 0.2)
    0.3
    """
    return float(f"{value:.{DIGITS}g}")


def closed_pattern(z: int, random: np.random.Generator) -> Array:
    """Normal deviations with zero sum and unit standard deviation, shape (z,).

    Without its mean a sample of z has the variance (z - 1)/z, which is compensated.

    Examples
    --------
    >>> pattern = closed_pattern(20, np.random.default_rng(1))
    >>> abs(float(pattern.sum())) < 1e-12
    True
    """
    plain = random.standard_normal(z)
    return np.asarray((plain - plain.mean()) * np.sqrt(z / max(z - 1.0, 1.0)))


def cumulative_range(pitch: Array) -> float:
    """Total cumulative pitch deviation F_p: range of the sums of single pitch deviations.

    Examples
    --------
    >>> cumulative_range(np.array([2.0, -3.0, 1.0]))
    3.0
    """
    return float(np.ptp(np.cumsum(pitch)))
