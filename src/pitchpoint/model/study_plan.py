# SPDX-License-Identifier: Apache-2.0
"""Plan of a study: random or systematic variation of numbers of a model, and the results that are evaluated.

Numbers of a factor are kept as written: their dimension is that of the path in the model.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar, TypeAlias

from pitchpoint.model.keys import Place, choice, integer, key, positive, quantity, text

APPLY = ("absolute", "add", "multiply")
"""How the value of a factor changes the number of the model."""
STATISTICS = ("mean", "rms", "min", "max", "magnitude", "peak_to_peak")
"""Statistics of a channel: mean, rms of the alternating part, extremes, their magnitude, range."""
LATIN, SOBOL, RANDOM, FACTORIAL = SAMPLINGS = ("latin_hypercube", "sobol", "random", "full_factorial")
RUN, EQUILIBRIUM, MODES = EVALUATIONS = ("run", "equilibrium", "modes")
EQUAL, INDEPENDENT, LEFT, RIGHT = FLANKS = ("equal", "independent", "left", "right")
"""Flanks with random pitch deviations."""
REGRESSION, INDICES = SENSITIVITIES = ("regression", "sobol_indices")


def _path() -> Any:
    return text("path of a number of the model, such as loads.drive.torque", None, one_of="place")


def _paths() -> Any:
    return key("names", "paths of several numbers that vary together", None, length=(1, 1000), one_of="place")


def _apply(default: str) -> Any:
    words = "absolute: the value replaces the number; add: it is added; multiply: a factor of the number"
    return choice(APPLY, words, default)


@dataclass(frozen=True, kw_only=True)
class Varied:
    """A factor that varies the number at one path, or the numbers at several paths together."""

    path: str | None = _path()
    paths: tuple[str, ...] | None = _paths()

    @property
    def every_path(self) -> tuple[str, ...]:
        """All paths."""
        return (self.path,) if self.path is not None else self.paths or ()


@dataclass(frozen=True, kw_only=True)
class Normal(Varied):
    """Normal distribution, truncated if `low` or `high` is given."""

    form: ClassVar[str] = "normal"
    deviation: str = text("standard deviation (of the distribution before truncation)")
    mean: str | None = text("mean", None, display="the number of the model; 0 if added, 1 if multiplied")
    low: str | None = text("no value is below this limit", None)
    high: str | None = text("no value is above this limit", None)
    apply: str = _apply("absolute")


@dataclass(frozen=True, kw_only=True)
class Uniform(Varied):
    """Uniform distribution between two limits."""

    form: ClassVar[str] = "uniform"
    low: str | None = text("lower limit", None, needs="high")
    high: str | None = text("upper limit", None, needs="low")
    plus_minus: str | None = text("limits on both sides of the number of the model", None)
    apply: str = _apply("absolute")


@dataclass(frozen=True, kw_only=True)
class Triangular(Varied):
    """Triangular distribution between two limits."""

    form: ClassVar[str] = "triangular"
    low: str = text("lower limit")
    high: str = text("upper limit")
    mode: str | None = text("most probable value", None, display="the middle of the limits")
    apply: str = _apply("absolute")


@dataclass(frozen=True, kw_only=True)
class Lognormal(Varied):
    """Lognormal distribution: the logarithm of the value is normal."""

    form: ClassVar[str] = "lognormal"
    deviation: float = positive("dimensionless", "standard deviation of the natural logarithm")
    median: str | None = text("median", None, display="the number of the model; 1 if multiplied")
    apply: str = _apply("absolute")


@dataclass(frozen=True, kw_only=True)
class Tolerance(Varied):
    """Limits as in a drawing, normal distribution with the capability of the process."""

    form: ClassVar[str] = "tolerance"
    limits: tuple[str, ...] = key(
        "names", "lower and upper limit, deviations from the number of the model", length=(2, 2)
    )
    capability: float = positive(
        "dimensionless",
        "process capability index C_p: width of the tolerance over six standard deviations",
        sample="1.33",
    )
    mean: str | None = text("mean deviation", None, display="the middle of the limits")
    inspected: bool = key("boolean", "parts beyond the limits are rejected: truncated distribution", False)
    apply: ClassVar[str] = "add"


@dataclass(frozen=True, kw_only=True)
class Levels(Varied):
    """Discrete values, of equal probability or with weights."""

    form: ClassVar[str] = "levels"
    weights: tuple[float, ...] | None = key(
        "quantities", "relative probability of each value", None, dimension="dimensionless", minimum=0.0
    )
    apply: str = _apply("absolute")
    values: tuple[Any, ...] = ()
    """Values as written; texts and mappings are permitted if they replace the value of the model."""


@dataclass(frozen=True, kw_only=True)
class PitchDeviations:
    """Random single pitch deviations of all teeth of gears, different in each case and for each gear.

    They are normal, and their sum over a gear is zero.
    """

    form: ClassVar[str] = "pitch_deviations"
    gears: tuple[str, ...] = key("names", "gears", length=(1, 1000), names="gears")
    deviation: float | None = positive(
        "length", "standard deviation of the single pitch deviations f_p", None, one_of="size"
    )
    tolerance_class: int | None = integer(
        "flank tolerance class of ISO 1328-1:2013, whose single pitch tolerance f_pT is three standard "
        "deviations",
        None,
        minimum=1,
        maximum=11,
        one_of="size",
    )
    flanks: str = choice(
        FLANKS,
        "equal: both flanks have the same deviations; independent: each flank has its own; left, right: this "
        "flank has deviations, the other one keeps those of the model",
        EQUAL,
    )


Factor: TypeAlias = Normal | Uniform | Triangular | Lognormal | Tolerance | Levels | PitchDeviations
FACTORS: dict[str, type] = {
    c.form: c for c in (Normal, Uniform, Triangular, Lognormal, Tolerance, Levels, PitchDeviations)
}


@dataclass(frozen=True, kw_only=True)
class Correlation:
    """Correlation of two factors: that of the normal variables of which the values are functions."""

    factors: tuple[str, ...] = key("names", "two factors", length=(2, 2))
    coefficient: float = quantity(
        "dimensionless", "coefficient", minimum=-1.0, maximum=1.0, above=True, below=True
    )


@dataclass(frozen=True, kw_only=True)
class StudyResult:
    """One evaluated result, with its permitted range for the yield."""

    channel: str = text("name of the result, such as mesh_force[stage] or contact_loss_share[stage]")
    statistic: str | None = choice(STATISTICS, "statistic of a channel", None)
    low: str | None = text("smallest permitted value", None)
    high: str | None = text("largest permitted value", None)


@dataclass(frozen=True, kw_only=True)
class StudyPlan:
    """Contents of a study; created by `model.reading.study_plan`, checked with its model by `sweep.study`."""

    title: str = text("title of the study", "")
    model: str = text("model file, relative to the folder of the plan")
    evaluate: str = choice(
        EVALUATIONS,
        "run: the scenario, a time response, slow roll or speed sweep; equilibrium: the loaded state at its "
        "start; modes: natural frequencies about this state",
        RUN,
    )
    scenario: str | None = text("scenario of the model", None, display="the only one; at rest for modes")
    sampling: str = choice(
        SAMPLINGS,
        "latin_hypercube: one value in each of `samples` intervals of equal probability; sobol: points of a "
        "scrambled Sobol' sequence; random; full_factorial: all combinations",
        LATIN,
    )
    samples: int = integer(
        "number of samples; of a full factorial: values of each continuous factor", minimum=2, maximum=10**6
    )
    seed: int = integer("seed of the random numbers", 1, minimum=0, maximum=2**31 - 1)
    sensitivity: str = choice(
        SENSITIVITIES,
        "regression: standardised regression coefficients; sobol_indices: shares of the variance, with "
        "`samples` x (number of factors + 2) cases",
        REGRESSION,
    )
    confidence: float = quantity(
        "dimensionless", "level of all confidence intervals", 0.95, minimum=0.5, maximum=0.999
    )
    factors: Mapping[str, Factor] = key("components", "varied numbers by name", of=FACTORS)
    correlations: tuple[Correlation, ...] = key("list", "correlated factors", (), of=Correlation)
    results: Mapping[str, StudyResult] = key("components", "evaluated results by name", of=StudyResult)
    file: str | None = None
    lines: Mapping[Place, int] = field(default_factory=dict, compare=False)
    allow_code: bool = field(default=False, compare=False)
    """Whether levels may name Python functions."""
