# SPDX-License-Identifier: Apache-2.0
"""Detection in noise: detection rates of fault indicators at a given false alarm rate.

A detector is any function from a signal to one number that increases with the fault. Its threshold follows
from healthy signals with the same noise and from the allowed false alarm rate; a second set of healthy
signals verifies the rate. Indicators of all kinds can thus be compared.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.noise import with_white_noise
from pitchpoint.analysis.sampled import Array, SignalError, as_signal, same_length

Detector = Callable[[Array], float]
"""Function from a signal to a number that is larger for a fault."""

CALIBRATION, CHECK, TRIAL = 0, 1, 2
"""Noise streams of a seed: healthy signals for the threshold, healthy for false alarms, faulty."""


@dataclass(frozen=True)
class DetectionCurves:
    """Detection rates over the signal-to-noise ratio.

    Attributes
    ----------
    detectors
        Shape (n_detector,). Names of the detectors.
    snr
        Shape (n_snr,). Signal-to-noise ratio [dB]: alternating RMS of the faulty signal over that of the
        noise.
    threshold
        Shape (n_detector, n_snr). Alarm threshold of a detector, in its unit.
    rate, rate_low, rate_high
        Shape (n_detector, n_snr). Detection rate of the faulty signal, and its confidence interval [-].
    false_alarm_rate, false_alarm_low, false_alarm_high
        Shape (n_detector, n_snr). Alarm rate of healthy signals not used for the threshold, and its
        confidence interval [-].
    false_alarm
        Allowed false alarm rate [-].
    confidence
        Confidence level of the intervals [-].
    seeds
        Number of signals of each kind at each ratio [-].
    """

    detectors: tuple[str, ...]
    snr: Array
    threshold: Array
    rate: Array
    rate_low: Array
    rate_high: Array
    false_alarm_rate: Array
    false_alarm_low: Array
    false_alarm_high: Array
    false_alarm: float
    confidence: float
    seeds: int


def detection_curves(
    healthy: ArrayLike,
    faulty: ArrayLike,
    detectors: Mapping[str, Detector],
    *,
    snr: ArrayLike,
    seeds: int = 100,
    first_seed: int = 0,
    false_alarm: float = 0.05,
    confidence: float = 0.95,
) -> DetectionCurves:
    """Detection rates of several detectors over the signal-to-noise ratio.

    Parameters
    ----------
    healthy
        Signal of the healthy machine without noise, shape (n,), any unit.
    faulty
        Signal of the faulty machine without noise, shape (n,), in the same unit.
    detectors
        Functions from a signal to a number that is larger for a fault, by name. A value that is not finite
        raises no alarm.
    snr
        Signal-to-noise ratios [dB], shape (n_snr,).
    seeds
        Number of signals of each kind at each ratio [-].
    first_seed
        First seed; the same seeds are used at every ratio, which makes the curves smooth.
    false_alarm
        Allowed false alarm rate at every ratio [-], at least 1/(seeds + 1).
    confidence
        Confidence level of the intervals [-].

    Returns
    -------
    DetectionCurves
        Detection rates, thresholds and observed false alarm rates.

    Raises
    ------
    SignalError
        If the signals differ in length, a number is out of range, or the seeds are too few for the false
        alarm rate.

    Notes
    -----
    `noise.with_white_noise` scales the noise by the alternating RMS of the faulty signal; the healthy signal
    has noise of the same level. The threshold is the k-th largest of m healthy values,
    k = ⌊false_alarm (m + 1)⌋: a further healthy value exceeds it with the probability k/(m + 1) for any
    distribution [1]_. Intervals are those of Wilson.

    References
    ----------
    .. [1] S. S. Wilks, Determination of sample sizes for setting tolerance limits, Annals of Mathematical
       Statistics 12(1), 1941, 91-96.

    Examples
    --------
    The mean detects a step of one at low noise only:

    >>> up = np.where(np.arange(100) < 50, 1.0, 0.0)
    >>> found = detection_curves(0.0 * up, up, {"mean": np.mean}, snr=[20.0, -40.0], false_alarm=0.1)
    >>> float(found.rate[0, 0]), bool(found.rate[0, 1] < 0.25)
    (1.0, True)
    """
    well, ill = as_signal(healthy, "healthy"), as_signal(faulty, "faulty")
    same_length(well, ill, "healthy, faulty")
    ratios = as_signal(snr, "snr", 1)
    count = _checked(detectors, seeds, false_alarm, confidence)
    names = tuple(detectors)
    values = np.empty((3, len(names), ratios.size, seeds))
    for seed in range(seeds):
        for stream, signal in ((CALIBRATION, well), (CHECK, well), (TRIAL, ill)):
            for j, ratio in enumerate(ratios):
                drawn = with_white_noise(ill, signal_to_noise=float(ratio), seed=[first_seed + seed, stream])
                noisy = signal + drawn.noise
                for i, name in enumerate(names):
                    values[stream, i, j, seed] = detectors[name](noisy)
    values[~np.isfinite(values)] = -np.inf
    threshold = np.sort(values[CALIBRATION], axis=-1)[..., -count]
    alarms = (values > threshold[None, :, :, None]).sum(axis=-1)
    rate_low, rate_high = wilson_interval(alarms[TRIAL], seeds, confidence)
    false_low, false_high = wilson_interval(alarms[CHECK], seeds, confidence)
    return DetectionCurves(
        detectors=names,
        snr=ratios,
        threshold=threshold,
        rate=alarms[TRIAL] / seeds,
        rate_low=rate_low,
        rate_high=rate_high,
        false_alarm_rate=alarms[CHECK] / seeds,
        false_alarm_low=false_low,
        false_alarm_high=false_high,
        false_alarm=float(false_alarm),
        confidence=float(confidence),
        seeds=int(seeds),
    )


def least_ratio(curves: DetectionCurves, rate: float = 0.9) -> Array:
    """Lowest signal-to-noise ratio at and above which each detector reaches a detection rate.

    Parameters
    ----------
    curves
        Result of `detection_curves`.
    rate
        Required detection rate [-].

    Returns
    -------
    NDArray
        Ratios [dB], shape (n_detector,), from `curves.snr`; NaN if the highest ratio is not sufficient.

    Examples
    --------
    >>> t = np.arange(200) / 10.0
    >>> found = detection_curves(0.0 * t, np.sin(t), {"power": np.var}, snr=[-30.0, 0.0, 10.0])
    >>> least_ratio(found)
    array([0.])
    """
    order = np.argsort(curves.snr)[::-1]
    kept = np.logical_and.accumulate(curves.rate[:, order] >= rate, axis=1).sum(axis=1)
    falling = curves.snr[order]
    return np.array([falling[k - 1] if k else np.nan for k in kept])


def wilson_interval(successes: ArrayLike, trials: int, confidence: float = 0.95) -> tuple[Array, Array]:
    """Wilson confidence interval of a rate, also valid near 0 and 1.

    Parameters
    ----------
    successes
        Number of successes [-], any shape.
    trials
        Number of trials [-].
    confidence
        Confidence level [-].

    Returns
    -------
    tuple
        Lower and upper limit [-], in the shape of `successes`.

    Notes
    -----
    (p + z²/2n ± z √(p(1-p)/n + z²/4n²))/(1 + z²/n) with the normal quantile z [1]_. Valid for any n; the
    coverage equals the confidence level on average over p.

    References
    ----------
    .. [1] E. B. Wilson, Probable inference, the law of succession, and statistical inference, Journal of the
       American Statistical Association 22(158), 1927, 209-212.

    Examples
    --------
    Twenty of twenty successes; the lower limit is 84 %:

    >>> low, high = wilson_interval(20, 20)
    >>> round(float(low), 4), round(float(high), 4)
    (0.8389, 1.0)
    """
    from scipy.special import ndtri

    z2 = float(ndtri(0.5 + 0.5 * confidence)) ** 2 / trials
    p = np.asarray(successes, dtype=np.float64) / trials
    half = np.sqrt(z2 * (p * (1.0 - p) + 0.25 * z2))
    low, high = (p + 0.5 * z2 - half) / (1.0 + z2), (p + 0.5 * z2 + half) / (1.0 + z2)
    return np.clip(low, 0.0, 1.0), np.clip(high, 0.0, 1.0)


def _checked(detectors: Mapping[str, Detector], seeds: int, false_alarm: float, confidence: float) -> int:
    """Check the arguments; number of healthy values allowed at or above the threshold."""
    if not detectors:
        raise SignalError("detectors: none given; pass at least one function")
    if isinstance(seeds, bool) or int(seeds) != seeds or seeds < 1:
        raise SignalError(f"seeds: {seeds} (limit 1 or more); use a whole number")
    for name, value in (("false_alarm", false_alarm), ("confidence", confidence)):
        if not 0.0 < value < 1.0:
            raise SignalError(f"{name}: {value} (limits 0 and 1)")
    count = int(false_alarm * (seeds + 1) * (1.0 + 1e-12))
    if count < 1:
        least = int(np.ceil(1.0 / false_alarm - 1.0 - 1e-9))
        raise SignalError(f"seeds: {seeds} (limit {least} for false_alarm {false_alarm:g}); use more seeds")
    return count
