# SPDX-License-Identifier: Apache-2.0
"""Periods of repeated impacts: tests of given periods, and search for an unknown period.

A damaged tooth causes one event per revolution of its shaft. The meshes of the shaft have the same period: z
tooth meshes are exactly one revolution, so that an autocorrelation cannot distinguish them. Their lines are
different: a mesh has lines at the multiples of z/T only, a single event per revolution at all multiples of
1/T. The evidence used here is the presence of most lines at multiples of 1/T that are not multiples of a
known frequency.

Assumptions: constant speed over the record (otherwise resample over the angle; periods are then in
revolutions); Gaussian noise with a density that is constant over the distance 1/T of two lines, such as white
noise of any level, also after a filter or in a wavelet level.

Source: Quinn and Hannan, The Estimation and Tracking of Frequency (2001).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.analysis.comb_chance import (
    CLIP,
    MIN_LINES,
    SHARES,
    chance_of_comb,
    evidence_of_comb,
    limited_sum_chance,
)
from pitchpoint.analysis.comb_fit import fitted_period, period_deviation
from pitchpoint.analysis.combs import (
    CLEARANCE,
    CombLines,
    Record,
    comb_lines,
    is_clear,
    record_for_combs,
    turns_in,
)
from pitchpoint.analysis.sampled import Array, SignalError, as_signal, positive

STEPS_PER_LINE = 2.0
"""Trial frequencies per line width 1/record at the highest line of the comb."""
EXAMINED, IMPROVED = 12, 3
"""Number of highest peaks of the coarse score that are tested, and number of these that are refined."""
HIGHEST_SHARE = 0.45
"""Highest line over the sample rate, below the transition band of anti-aliasing filters."""
CLEAR_LINE = 0.1
"""p-value below which a high line is used to fit the period."""
MAX_TRIALS = 200_000
"""Maximum number of trial periods of one search."""


@dataclass(frozen=True)
class PeriodEvidence:
    """Evidence for given periods.

    Attributes
    ----------
    period
        Shape (n_period,). Periods [s]; the best within the tolerance, if there is one.
    p_value
        Shape (n_period,). Probability that noise alone gives the same evidence for this period [-], corrected
        for the tolerance; NaN if there is no result.
    turns
        Shape (n_period,). Whole periods in the record [-]; no result below 2.
    lines
        Shape (n_period,). Number of usable multiples of 1/T [-]; no result below 3.
    """

    period: Array
    p_value: Array
    turns: NDArray[np.int64]
    lines: NDArray[np.int64]


@dataclass(frozen=True)
class PeriodSearch:
    """Result of the search for the period of repeated impacts between two limits.

    Attributes
    ----------
    found
        Whether `p_value` is at most `false_alarm`.
    period
        Period T [s]; NaN if not found.
    deviation
        Standard deviation of the period due to the noise around the lines [s]; NaN if not found.
    p_value
        Probability that noise alone gives the same evidence anywhere between the limits [-], at most 1.
    false_alarm
        Allowed false alarm probability [-].
    turns
        Whole periods in the record [-]; 0 if not found.
    lines
        Comb of the period; empty if not found.
    trial_period, trial_score
        Shape (n_trial,). Periods [s] and -log10 of the individual probability of each, from the coarse
        search; for plots.
    """

    found: bool
    period: float
    deviation: float
    p_value: float
    false_alarm: float
    turns: int
    lines: CombLines
    trial_period: Array
    trial_score: Array


def period_evidence(
    values: ArrayLike,
    sample_rate: float,
    periods: ArrayLike,
    *,
    known: ArrayLike = (),
    harmonics: int = 20,
    highest_frequency: float | None = None,
    tolerance: float = 0.0,
) -> PeriodEvidence:
    """Test given periods, such as those of the shafts, for an event once per period.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Sample rate f_s [Hz].
    periods
        Periods T [s], shape (n_period,).
    known
        Frequencies that are not faults, with all their multiples [Hz], shape (n_known,): mesh frequencies.
    harmonics
        Highest multiple K of 1/T [-].
    highest_frequency
        Highest frequency of a line [Hz]; default K over the shortest period, at most 0.45 f_s.
    tolerance
        Relative uncertainty of the periods [-].

    Returns
    -------
    PeriodEvidence
        One p-value per period, not corrected for the number of periods.

    Raises
    ------
    SignalError
        If a number is not positive or a highest frequency is not below f_s/2.

    Notes
    -----
    Each line of the comb gives an F test against its neighbours; `evidence_of_comb` combines those of all
    lines up to K, K/2 or K/4, whichever gives the strongest evidence, with a correction for the choice. The
    evidence must remain without the multiples of every prime: otherwise the lines are those of a shorter
    period. The p-value is the largest of these. A few strong lines (unbalance, bent shaft) are not evidence
    of impacts, most of the twenty lines are. Valid for at least two periods in the record; the test is weak
    for few periods.

    Examples
    --------
    A dip every 2 s and a strong tone of 3.5 Hz with seven periods in 2 s:

    >>> t = np.arange(4000) / 200.0
    >>> noise = np.random.default_rng(1).normal(size=t.size)
    >>> tone = 3.0 * np.sin(2 * np.pi * 3.5 * t)
    >>> dip = -4.0 * (np.mod(t, 2.0) < 0.1)
    >>> [bool(period_evidence(x, 200.0, [2.0], known=[3.5]).p_value[0] < 1e-4) for x in (tone + noise,
    ...  tone + dip + noise)]
    [False, True]
    """
    wanted = as_signal(periods, "periods", 1)
    harmonics = _whole(harmonics)
    shortest = min(positive(float(T), "period") for T in wanted)
    top = _top(highest_frequency, harmonics, shortest, sample_rate)
    record = record_for_combs(values, sample_rate, top, known)
    found = np.array(wanted)
    p_values = np.full(wanted.size, np.nan)
    lines = np.zeros(wanted.size, dtype=np.int64)
    turns = np.array([turns_in(record, T) for T in wanted], dtype=np.int64)
    for i, T in enumerate(wanted):
        half = int(np.ceil(abs(tolerance) * harmonics * record.duration * STEPS_PER_LINE / T))
        best: tuple[float, ...] = (np.inf, np.inf)
        # in order of distance from the given period: of equal results the nearest is chosen
        for step in sorted(range(-half, half + 1), key=abs):
            trial = T / (1.0 + abs(tolerance) * step / max(half, 1))
            comb = comb_lines(record, trial, harmonics)
            lines[i] = max(lines[i], comb.orders.size)
            if comb.orders.size >= MIN_LINES:
                # the probability of very many lines saturates; the sum of log p-values breaks ties
                chance, own, _ = evidence_of_comb(comb, harmonics)
                grade = (max(chance, own), float(np.log(np.maximum(comb.p_value, 1e-300)).sum()))
                if grade < best:
                    best, found[i] = grade, trial
        if np.isfinite(best[0]):
            p_values[i] = min(1.0, best[0] * (2 * half + 1))
    return PeriodEvidence(period=found, p_value=p_values, turns=turns, lines=lines)


def find_period(
    values: ArrayLike,
    sample_rate: float,
    shortest: float,
    longest: float,
    *,
    known: ArrayLike = (),
    harmonics: int = 20,
    highest_frequency: float | None = None,
    false_alarm: float = 1e-3,
) -> PeriodSearch:
    """Search for the period of a repeated event between two limits.

    Parameters
    ----------
    values
        Samples, shape (n,), any unit.
    sample_rate
        Sample rate f_s [Hz].
    shortest
        Shortest period [s].
    longest
        Longest period [s], at most half the record.
    known
        Frequencies that are not faults, with all their multiples [Hz], shape (n_known,): mesh frequencies.
    harmonics
        Highest multiple K of 1/T [-].
    highest_frequency
        Highest frequency of a line [Hz]; default K over the shortest period, at most 0.45 f_s.
    false_alarm
        Allowed false alarm probability of the whole search [-].

    Returns
    -------
    PeriodSearch
        `found` is False if noise may explain the evidence.

    Raises
    ------
    SignalError
        If the limits are not in order, exceed half the record, or require too many trials.

    Notes
    -----
    A coarse score over all trial frequencies, in steps of half a line at K/T, selects candidates, which are
    tested as in `period_evidence`. The probability is multiplied by the number of trials (Bonferroni), which
    is conservative [1]_. Of a period and its multiples the longest is chosen that has lines of its own. The
    period is then a simultaneous least-squares fit of K sines; its deviation is the Cramér-Rao bound. A
    period longer than `longest` may be found as one of its fractions. Valid for at least two periods in the
    record.

    References
    ----------
    .. [1] B. G. Quinn, E. J. Hannan, The Estimation and Tracking of Frequency, Cambridge University Press,
       2001, chapters 3 and 4.

    Examples
    --------
    >>> t = np.arange(6000) / 200.0
    >>> noise = np.random.default_rng(1).normal(size=t.size)
    >>> dip = -3.0 * (np.mod(t, 2.345) < 0.15)
    >>> found = find_period(dip + noise, 200.0, 1.0, 5.0)
    >>> found.found, round(found.period, 2), found.turns
    (True, 2.34, 12)
    >>> find_period(noise, 200.0, 1.0, 5.0).found
    False
    """
    low, high = positive(shortest, "shortest"), positive(longest, "longest")
    allowed = positive(false_alarm, "false_alarm")
    harmonics = _whole(harmonics)
    top = _top(highest_frequency, harmonics, low, sample_rate)
    record = record_for_combs(values, sample_rate, top, known)
    if not low < high <= 0.5 * record.duration * (1.0 + 1e-9):
        raise SignalError(
            f"shortest, longest: {low:.6g} and {high:.6g} s (limits 0 to {0.5 * record.duration:.6g} s, half "
            "the record, in rising order); use a longer record or narrower limits"
        )
    frequency, score = _coarse(record, low, high, harmonics)
    trials = frequency.size
    p_value, period = _best(record, _peaks(frequency, score), harmonics, trials)
    found = p_value <= allowed
    if found:
        p_value, period = _longest_multiple(record, (p_value, period), high, harmonics, trials, allowed)
    comb = comb_lines(record, period if found else 0.0, harmonics)
    return PeriodSearch(
        found=found,
        period=period if found else np.nan,
        deviation=period_deviation(record, period, comb) if found else np.nan,
        p_value=p_value,
        false_alarm=allowed,
        turns=turns_in(record, period) if found else 0,
        lines=comb,
        trial_period=1.0 / frequency[::-1],
        trial_score=score[::-1],
    )


def _whole(harmonics: int) -> int:
    if isinstance(harmonics, bool) or int(harmonics) != harmonics or harmonics < MIN_LINES:
        raise SignalError(f"harmonics: {harmonics} (limit {MIN_LINES} or more); use a whole number")
    return int(harmonics)


def _top(highest_frequency: float | None, harmonics: int, shortest: float, sample_rate: float) -> float:
    """Highest frequency of a line, limited by K, the sample rate and the caller."""
    top = min(harmonics / shortest, HIGHEST_SHARE * positive(sample_rate, "sample_rate"))
    return top if highest_frequency is None else min(top, positive(highest_frequency, "highest_frequency"))


def _coarse(record: Record, low: float, high: float, harmonics: int) -> tuple[Array, Array]:
    """Trial frequencies and -log10 of the probability of each, from one transform of the whole record."""
    from scipy.fft import next_fast_len

    step = 1.0 / (STEPS_PER_LINE * harmonics * record.duration)
    trials = int((1.0 / low - 1.0 / high) / step) + 2
    if trials > MAX_TRIALS:
        raise SignalError(
            f"{trials} trial periods (limit {MAX_TRIALS}); use a shorter record, narrower limits or fewer "
            "harmonics"
        )
    frequency = np.linspace(1.0 / high, 1.0 / low, trials)
    length = next_fast_len(8 * record.values.size)
    power = np.abs(np.fft.rfft(record.values, length)) ** 2 + record.floor
    per_line = length / record.rate
    level, noise = np.empty((2, harmonics, trials))
    used = np.empty((harmonics, trials), dtype=np.bool_)
    for row in range(harmonics):
        line = (row + 1) * frequency
        used[row] = (line <= record.top * (1.0 + 1e-9)) & is_clear(
            line, record.tones, CLEARANCE / record.duration
        )
        # four points between this line and the adjacent ones give the noise
        places = [line, *(np.abs(line + d * frequency) for d in (-0.5, -0.3, 0.3, 0.5))]
        at = np.minimum(np.rint(np.array(places) * per_line).astype(np.int64), power.size - 1)
        level[row] = power[at[0]]
        noise[row] = power[at[1:]].mean(axis=0)
    # smooth the noise estimate over three lines of the comb
    noise[1:-1] = (noise[:-2] + noise[1:-1] + noise[2:]) / 3.0
    evidence = np.minimum(8.0 * np.log1p(level / (8.0 * noise)), CLIP) * used
    score = np.zeros(trials)
    for share in SHARES:
        total, count = evidence[: harmonics // share].sum(axis=0), used[: harmonics // share].sum(axis=0)
        for n in np.unique(count[count >= MIN_LINES]):
            rows = count == n
            chances = [limited_sum_chance(s, int(n) * ((1, 8),)) for s in total[rows]]
            score[rows] = np.maximum(score[rows], -np.log10(chances))
    return frequency, score


def _peaks(frequency: Array, score: Array) -> Array:
    """Trial frequencies of the highest local maxima of the score, at most `EXAMINED`."""
    beyond = np.concatenate([[-1.0], score, [-1.0]])
    tops = np.flatnonzero((score > beyond[:-2]) & (score >= beyond[2:]))
    return frequency[tops[np.argsort(-score[tops], kind="stable")][:EXAMINED]]


def _best(record: Record, frequencies: Array, harmonics: int, trials: int) -> tuple[float, float]:
    """Probability and period of the best trial frequency."""
    tested = []
    for f in frequencies:
        comb = comb_lines(record, 1.0 / f, harmonics)
        tested.append((min(1.0, trials * evidence_of_comb(comb, harmonics)[0]), 1.0 / f))
    tested.sort()
    # candidates explained by noise are not refined
    improved = [_improved(record, T, harmonics, trials) for p, T in tested[:IMPROVED] if p < 1.0]
    return min(improved, default=tested[0] if tested else (1.0, 0.0))


def _improved(record: Record, period: float, harmonics: int, trials: int) -> tuple[float, float]:
    """Probability and period of a trial period after a fit to its lines."""
    comb = comb_lines(record, period, harmonics)
    highest = evidence_of_comb(comb, harmonics)[2]
    # first fit the lines with most evidence, then add those that only an accurate period resolves
    for last in (highest, harmonics):
        orders = comb.orders[(comb.orders <= highest) | ((comb.orders <= last) & (comb.p_value < CLEAR_LINE))]
        reach = 2.0 * period / (STEPS_PER_LINE * last * record.duration)
        period = fitted_period(record, period, orders, reach)
        comb = comb_lines(record, period, harmonics)
    chance, own, _ = evidence_of_comb(comb, harmonics)
    # the test against shorter periods is made for one period only: its probability is not multiplied
    return max(min(1.0, trials * chance), own), period


def _longest_multiple(
    record: Record, best: tuple[float, float], longest: float, harmonics: int, trials: int, allowed: float
) -> tuple[float, float]:
    """Longest multiple of a period within the limits that has lines of its own, or the period itself."""
    for q in range(int(longest / best[1] * (1.0 + 1e-9)), 1, -1):
        comb = comb_lines(record, q * best[1], harmonics)
        own = comb.orders % q != 0
        if min(chance_of_comb(comb, own & (comb.orders <= harmonics // k)) for k in SHARES) <= allowed:
            longer = _improved(record, q * best[1], harmonics, trials)
            if longer[0] <= allowed:
                return longer
    return best
