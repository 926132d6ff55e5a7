# SPDX-License-Identifier: Apache-2.0
"""Path of a varying speed through short-time spectra, along which the lines of a machine are strongest.

Each frame rates each speed by the levels of all lines at their orders. The path with the highest sum and a
bounded acceleration follows by dynamic programming.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.sampled import Array
from pitchpoint.analysis.time_frequency import time_frequency_map

LIMIT = float(np.log1p(100.0))
"""Largest contribution of one line, that of 20 dB above the noise: no single line decides."""
OF_NOISE = 0.596347
"""Mean of ln(1 + r) over exponentially distributed r [-]: a line that is not there contributes 0."""
BLOCK = 32
"""Number of lines of a frame in which the noise is taken as constant."""
FLOOR = 1e-6
"""Smallest noise over the power of the strongest line of a frame: without noise there is its leakage."""
FINE = 0.5
"""Distance of adjacent speeds [lines of a frame at the highest order]."""
SMEAR = 1.0
"""Largest change of the lowest strong order between adjacent frames [lines of a frame]: faster changes smear
the lines of a frame."""
BEND = 3.0
"""Cost of the largest change of speed between adjacent frames, quadratic below it [-]."""
LOBE = 3.0
"""Half width of a line with a Hann window and its slope [lines of a frame]."""
LOWEST = 4
"""Number of the lowest line of a frame that is used: the window spreads the mean over the lower ones."""
DRAWS = 12
"""Number of random shifts of the frames by which the level of chance is found."""
CLEAR = float(np.log1p(8.0)) - OF_NOISE
"""Level above which the maximum of a line refines the speed."""
SMOOTH = 5
"""Number of frames of a running median over the refined speed: an impact displaces the maxima of a frame."""

Places = list[tuple[float, NDArray[np.int64]]]


@dataclass(frozen=True)
class Comb:
    """Lines expected at a speed.

    Attributes
    ----------
    orders
        Shape (n,). Orders of lines of the machine [-].
    against
        Shape (m,). Orders at which a wrong multiple of the speed has lines [-]; their levels are subtracted.
    lowest
        Lowest order of the strong lines [-], which sets the width of a path.
    weights
        Shape (n,). Weights of the levels of the lines [-]; empty for 1.
    """

    orders: Array
    against: Array
    lowest: float
    weights: Array = field(default_factory=lambda: np.empty(0))

    def lines(self) -> list[tuple[float, float]]:
        """Weight and order of all lines; negative weights of those that count against a speed."""
        weights = self.weights if self.weights.size else np.ones(self.orders.size)
        own = list(zip(weights.tolist(), self.orders.tolist(), strict=True))
        return [*own, *((-1.0, order) for order in self.against.tolist())]


@dataclass(frozen=True)
class SpeedPath:
    """Best path of the speed, compared with others.

    Levels are sums of the levels of all lines, ln(1 + power/noise) less its mean in noise, averaged over the
    frames.

    Attributes
    ----------
    time, frequency
        Shape (n,). Middle of the frames [s], rotation frequency [Hz].
    resolution
        Distance of the lines of a frame [Hz].
    score
        Level of the path [-].
    rival, rival_ratio
        Level of the best path that is apart from it in every frame [-], and its speed over that of the best
        path, median [-].
    chance, spread
        Level of the best path through randomly shifted frames, mean and standard deviation [-].
    at_limit
        Share of the frames in which the speed is at a limit of the range [-].
    level
        Shape (n,). Level of the path around a frame [-].
    """

    time: Array
    frequency: Array
    resolution: float
    score: float
    rival: float
    rival_ratio: float
    chance: float
    spread: float
    at_limit: float
    level: Array

    @property
    def seen(self) -> NDArray[np.bool_]:
        """Whether the lines are above chance around a frame, shape (n,)."""
        return np.asarray(self.level > self.chance)

    @property
    def gain(self) -> float:
        """Level above the best other path and above chance, times the square of the share of the frames with
        visible lines [-]: a path must hold everywhere."""
        return (self.score - max(self.rival, self.chance)) * float(self.seen.mean()) ** 2


def speed_path(
    signals: Sequence[Array],
    rate: float,
    comb: Comb | Sequence[Comb],
    limits: tuple[float, float],
    frame: int,
) -> SpeedPath:
    """Path of the speed with the highest levels of the lines of a comb.

    Parameters
    ----------
    signals
        Values of the channels, shape (n,) each, any unit.
    rate
        Sample rate [Hz].
    comb
        Expected lines, of all channels or of each one; the first comb sets the width of a path.
    limits
        Lowest and highest rotation frequency [Hz].
    frame
        Samples per frame [-].

    Returns
    -------
    SpeedPath
        The path.

    Notes
    -----
    Viterbi algorithm [1]_ over the levels of a comb in short-time spectra [2]_. The chance of a path is found
    from the same spectra, each shifted along the frequency by a random number of lines: lines of other
    sources then do not agree with the comb. Valid if the speed changes little within a frame.

    References
    ----------
    .. [1] A. J. Viterbi, Error bounds for convolutional codes and an asymptotically optimum decoding
       algorithm, IEEE Transactions on Information Theory 13(2), 1967, 260-269.
    .. [2] Q. Leclère, H. André, J. Antoni, A multi-order probabilistic approach for instantaneous angular
       speed tracking, Mechanical Systems and Signal Processing 81, 2016, 375-386.

    Examples
    --------
    >>> t = np.arange(50_000) / 5000.0
    >>> x = np.cos(2 * np.pi * 20 * (10 * t + t**2)) + np.random.default_rng(1).standard_normal(t.size)
    >>> comb = Comb(np.array([20.0]), np.array([]), 20.0)
    >>> path = speed_path([x], 5000.0, comb, (8.0, 35.0), 1000)
    >>> bool(np.abs(path.frequency - 10 - 2 * path.time).max() < 0.2)
    True
    """
    resolution = rate / frame
    combs = [comb] * len(signals) if isinstance(comb, Comb) else list(comb)
    lowest = combs[0].lowest
    top = max(float(one.orders.max()) for one in combs if one.orders.size)
    count = max(int(np.ceil((limits[1] - limits[0]) * top / (FINE * resolution))), LOWEST)
    speeds = np.linspace(*limits, count + 1)
    frames = int(np.ceil(2.0 * signals[0].size / frame))
    highest = max(max(order for _, order in one.lines()) for one in combs if one.orders.size)
    highest = highest * limits[1] + BLOCK * resolution
    powers = []
    time = np.empty(0)
    for x in signals:
        found = time_frequency_map(
            x, rate, frame=frame, frames=frames, highest_frequency=min(highest, 0.5 * rate)
        )
        time = found.time
        powers.append(found.amplitude**2)
    levels = [_levels(power) for power in powers]
    places = [
        [(weight, _lines_at(order * speeds, resolution, levels[0].shape[1])) for weight, order in one.lines()]
        for one in combs
    ]
    reach = min(max(int(SMEAR * top / lowest / FINE), 1), speeds.size - 1)
    rated = _rated(levels, places)
    path, score = _best_path(rated, reach)
    near = np.abs(speeds - speeds[path][:, None]) <= LOBE * resolution / lowest
    other, rival = _best_path(np.where(near, -LIMIT * max(c.orders.size for c in combs), rated), reach)
    chance = _by_chance(levels, places, reach)
    own = rated[np.arange(path.size), path]
    around = np.convolve(np.pad(own, SMOOTH // 2, mode="edge"), np.full(SMOOTH, 1.0 / SMOOTH), mode="valid")
    return SpeedPath(
        time,
        _refined(powers, levels, [one.orders for one in combs], speeds[path], resolution),
        resolution,
        score,
        rival,
        float(np.median(speeds[other] / speeds[path])),
        float(chance.mean()),
        float(chance.std()),
        float(np.mean((path <= 1) | (path >= count - 1))),
        around,
    )


def level_along(signals: Sequence[Array], rate: float, comb: Comb, path: SpeedPath) -> float:
    """Mean level of the lines of a comb along a path [-], 0 in noise; mean of the channels.

    Parameters
    ----------
    signals
        Values of the channels, shape (n,) each, any unit, the record of the path.
    rate
        Sample rate [Hz].
    comb
        Lines.
    path
        Path of the speed.

    Notes
    -----
    ln(1 + power/noise) less its mean in noise, in the frames of the path [1]_. Valid as `speed_path`.

    References
    ----------
    .. [1] Q. Leclère, H. André, J. Antoni, A multi-order probabilistic approach for instantaneous angular
       speed tracking, Mechanical Systems and Signal Processing 81, 2016, 375-386.
    """
    frame = round(rate / path.resolution)
    total = 0.0
    for x in signals:
        found = time_frequency_map(x, rate, frame=frame, frames=int(np.ceil(2.0 * x.size / frame)))
        level = np.pad(_levels(found.amplitude**2), ((0, 0), (0, 1)))
        rows, count = np.arange(level.shape[0]), level.shape[1] - 1
        for weight, order in comb.lines():
            total += weight * float(
                level[rows, _lines_at(order * path.frequency, path.resolution, count)].mean()
            )
    return total / len(signals)


def _levels(power: Array) -> Array:
    """Limited logarithm of power over noise of each line, less its mean in noise."""
    edges = np.linspace(0, power.shape[1], max(power.shape[1] // BLOCK, 1) + 1).astype(int)
    middle = 0.5 * (edges[:-1] + edges[1:] - 1)
    parts = [np.median(power[:, a:b], axis=1) for a, b in zip(edges[:-1], edges[1:], strict=True)]
    # the median of an exponential distribution is ln 2 times its mean
    noise = np.maximum(np.stack(parts, axis=1) / np.log(2.0), FLOOR * power.max(axis=1, keepdims=True))
    noise = np.log(np.maximum(noise, 1e-300))
    line = np.arange(power.shape[1], dtype=np.float64)
    local = np.stack([np.interp(line, middle, row) for row in noise])
    return np.asarray(np.minimum(np.log1p(power / np.exp(local)), LIMIT) - OF_NOISE)


def _lines_at(frequency: Array, resolution: float, count: int) -> NDArray[np.int64]:
    """Numbers of the lines at frequencies [Hz]; `count` outside the spectrum."""
    at = np.rint(frequency / resolution).astype(np.int64)
    return np.where((at >= LOWEST) & (at < count), at, count)


def _rated(levels: Sequence[Array], places: Sequence[Places]) -> Array:
    """Level of each speed in each frame, mean of the channels, shape (n_frame, n_speed)."""
    total = np.zeros((levels[0].shape[0], max(at.size for lines in places for _, at in lines)))
    for level, lines in zip(levels, places, strict=True):
        padded = np.pad(level, ((0, 0), (0, 1)))
        for weight, at in lines:
            total += weight * padded[:, at]
    return total / len(levels)


def _by_chance(levels: Sequence[Array], places: Sequence[Places], reach: int) -> Array:
    """Levels of the best paths through randomly shifted frames, shape (DRAWS,)."""
    random = np.random.default_rng(1)
    found = []
    for _ in range(DRAWS):
        moved = []
        for level in levels:
            by = random.integers(0, level.shape[1], (level.shape[0], 1))
            at = (np.arange(level.shape[1]) - by) % level.shape[1]
            moved.append(np.take_along_axis(level, at, axis=1))
        found.append(_best_path(_rated(moved, places), reach)[1])
    return np.array(found)


def _best_path(rated: Array, reach: int) -> tuple[NDArray[np.int64], float]:
    """Numbers of the speeds of the best path, shape (n_frame,), and its mean level."""
    frames, count = rated.shape
    cost = BEND * (np.arange(-reach, reach + 1) / reach) ** 2
    came = np.empty((frames, count), dtype=np.int64)
    padded = np.full(count + 2 * reach, -np.inf)
    reached = np.lib.stride_tricks.sliding_window_view(padded, 2 * reach + 1)
    total, number = rated[0].copy(), np.arange(count)
    for k in range(1, frames):
        padded[reach : reach + count] = total
        gain = reached - cost
        best = np.argmax(gain, axis=1)
        came[k] = number + best - reach
        total = gain[number, best] + rated[k]
    path = np.empty(frames, dtype=np.int64)
    path[-1] = int(np.argmax(total))
    for k in range(frames - 1, 0, -1):
        path[k - 1] = came[k, path[k]]
    return path, float(total.max()) / frames


def _refined(
    powers: Sequence[Array],
    levels: Sequence[Array],
    combs: Sequence[Array],
    frequency: Array,
    resolution: float,
) -> Array:
    """Weighted mean of the rotation frequencies of all lines of a frame, from parabolas through maxima."""
    from scipy.ndimage import median_filter

    row, near = np.arange(frequency.size), np.arange(-LOWEST + 1, LOWEST)
    total, weight = np.zeros(frequency.size), np.zeros(frequency.size)
    for power, level, orders in zip(powers, levels, combs, strict=True):
        logarithm = np.log(np.maximum(power, 1e-300))
        for order in orders:
            at = np.rint(order * frequency / resolution).astype(np.int64)
            inside = (at >= LOWEST) & (at < power.shape[1] - LOWEST)
            at = np.where(inside, at, LOWEST)
            top = at + near[np.argmax(power[row[:, None], at[:, None] + near], axis=1)]
            left, peak, right = (logarithm[row, top + k] for k in (-1, 0, 1))
            height = level[row, top]
            good = inside & (left < peak) & (peak >= right) & (height > CLEAR)
            shift = 0.5 * (right - left) / np.where(good, 2.0 * peak - left - right, 1.0)
            # the variance of a frequency is inversely proportional to the power of its line
            own = np.where(good, order**2 * np.expm1(height + OF_NOISE), 0.0)
            total += own * (top + shift) * resolution / order
            weight += own
    found = np.where(weight > 0.0, total / np.maximum(weight, 1e-300), frequency)
    return np.asarray(median_filter(found, size=SMOOTH, mode="nearest"))
