# SPDX-License-Identifier: Apache-2.0
"""Synchronous average of a shaft for one of its gears: residual, indicators with limits, fault angle."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import gcd

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.gear_signals import MIN_TEETH, gear_signals
from pitchpoint.analysis.indicators import standardised_moment
from pitchpoint.analysis.sampled import Array, SignalError, as_signal
from pitchpoint.analysis.shaft_tests import FOLDED
from pitchpoint.analysis.synchronous_average import synchronous_average
from pitchpoint.analysis.tooth_energy import ToothEnergy, tooth_energy
from pitchpoint.analysis.turning_parts import Shaft, TurningParts

SURROGATES = 999
MOMENTS = {
    "residual": {"kurtosis": 4},
    "difference": {"fm4": 4, "m6a": 6, "m8a": 8},
}
"""Indicators of each signal and the order of their moment [-]."""


@dataclass(frozen=True)
class MeanTurn:
    """Mean revolution of a shaft, for one of its gears.

    Attributes
    ----------
    angle
        Shape (n,). Angle of the shaft [rad], from the zero of the record, in its sense of rotation.
    average, residual
        Shape (n,). Synchronous average, and the same without mesh harmonics and the two lowest orders, in the
        unit of the signal.
    averages
        Number of revolutions [-].
    indicators
        By name: value, limit exceeded by 1 % of Gaussian signals of the same spectrum, and share of these
        signals that reach the value [-].
    energy
        Energy within the angle of one tooth.
    trains
        Numbers of teeth of impact trains that other meshes may modulate [-]; empty if all products of meshes
        are mesh orders, which are not in the residual.
    """

    angle: Array
    average: Array
    residual: Array
    averages: int
    indicators: dict[str, tuple[float, float, float]]
    energy: ToothEnergy
    trains: tuple[int, ...]


def mean_turn(
    values: ArrayLike, samples_per_turn: float, parts: TurningParts, shaft: Shaft, teeth: int
) -> MeanTurn:
    """Synchronous average, residual and indicators of a gear.

    Parameters
    ----------
    values
        Signal over the angle of the reference shaft, shape (n,), any unit.
    samples_per_turn
        Samples per revolution of the reference shaft [-].
    parts
        Rotating parts of the machine; the lines of all meshes are removed from the residual.
    shaft
        Shaft of the gear.
    teeth
        Number of teeth of the gear [-].

    Returns
    -------
    MeanTurn
        Mean revolution with residual and indicators.

    Raises
    ------
    SignalError
        If the record has no whole revolution, or the first harmonic of the gear is above its bandwidth.

    Notes
    -----
    Limits are from surrogate signals with the amplitudes of the residual and random phases [1]_, which have
    no distinguished angle. Valid for several revolutions; with few, contributions of other shafts remain in
    the average.

    References
    ----------
    .. [1] J. Theiler, S. Eubank, A. Longtin, B. Galdrikian, J. D. Farmer, Testing for nonlinearity in time
       series: the method of surrogate data, Physica D 58, 1992, 77-94.

    Examples
    --------
    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> parts = train_parts([(20, 31)])
    >>> turned = np.arange(40_000) / 400.0
    >>> noise = np.random.default_rng(1).standard_normal(turned.size)
    >>> x = np.cos(2 * np.pi * 20 * turned) + 2 * ((turned + 0.005) % 1 < 0.02) + noise
    >>> found = mean_turn(x, 400.0, parts, parts.shafts[0], 20)
    >>> value, limit, part = found.indicators["fm4"]
    >>> value > limit, part < 0.01, found.averages, bool(found.energy.probability < 1e-6)
    (True, True, 99, True)
    """
    x = as_signal(values, minimum=16)
    turned = np.arange(x.size) * (2.0 * np.pi / samples_per_turn)
    resolved = samples_per_turn / float(shaft.order)
    # use the full bandwidth: an impact may excite a resonance in the highest octave only
    wanted = 2 * int(max(resolved, 8.0) // 2)
    if 2 * teeth >= wanted:
        raise SignalError(
            f"teeth: {wanted} samples per revolution are too few for {teeth} teeth "
            f"(limit above {2 * teeth}); use a higher sample rate"
        )
    # meshes of other shafts at whole orders of this shaft remain in its average
    ratios = [parts.shaft(mesh.shafts[0]).order * mesh.teeth[0] / shaft.order for mesh in parts.meshes]
    whole = {int(ratio) for ratio in ratios if ratio.denominator == 1 and ratio >= MIN_TEETH}
    # mesh harmonics at whole orders, up to the relevant harmonic number
    steps = [ratio.numerator for ratio in ratios if ratio.denominator <= FOLDED]
    counts = sorted({teeth} | {z for z in whole if 2 * z < wanted})
    mean = synchronous_average(x, turned, ratio=shaft.order, samples_per_turn=wanted)
    signals = gear_signals(mean.values, teeth=counts)
    looked = {kind: getattr(signals, kind) for kind in MOMENTS}
    indicators = {}
    for kind, drawn in _surrogate_moments(looked).items():
        for row, (name, power) in enumerate(MOMENTS[kind].items()):
            value = standardised_moment(looked[kind], power)
            limit, part = np.quantile(drawn[row], 0.99), np.mean(drawn[row] >= value)
            indicators[name] = (value, float(limit), float(part))
    return MeanTurn(
        angle=mean.angle,
        average=mean.values,
        residual=signals.residual,
        averages=mean.averages,
        indicators=indicators,
        energy=tooth_energy(signals.residual, teeth=teeth),
        trains=() if gcd(*steps) in counts else tuple(counts),
    )


def _surrogate_moments(signals: Mapping[str, Array]) -> dict[str, Array]:
    """Moments, shape (n_moment, n_draw), of surrogate signals with the same amplitudes and random phases.

    The random phases depend only on the length of the signals, which must be equal.
    """
    from scipy.fft import irfft

    size = {kind: np.abs(np.fft.rfft(signal)) for kind, signal in signals.items()}
    found = {kind: np.empty((len(MOMENTS[kind]), SURROGATES)) for kind in signals}
    [length] = {signal.size for signal in signals.values()}
    dice = np.random.default_rng(length)
    for start in range(0, SURROGATES, 111):
        turned = np.exp(1j * dice.uniform(0.0, 2.0 * np.pi, (111, length // 2 + 1)))
        for kind in signals:
            x = irfft(size[kind] * turned, length, axis=1)
            x -= x.mean(axis=1, keepdims=True)
            square = x * x
            variance = square.mean(axis=1)
            for row, power in enumerate(MOMENTS[kind].values()):
                moment = (square ** (power // 2)).mean(axis=1)
                found[kind][row, start : start + 111] = moment / variance ** (power // 2)
    return found
