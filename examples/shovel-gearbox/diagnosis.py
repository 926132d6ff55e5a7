# SPDX-License-Identifier: Apache-2.0
"""Detection of the broken tooth in noise: wavelet levels of a bearing force, its period, detection rates.

As the paper does it: white noise on the bearing force, Db5, five levels, the period read from a5. What is
added: many seeds, the healthy gearbox next to it, and other indicators on the same signals.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from study import HERE, RATE, Run, frequencies

from pitchpoint import load_model
from pitchpoint.analysis.detection import DetectionCurves, detection_curves
from pitchpoint.analysis.envelope import envelope_spectrum
from pitchpoint.analysis.gear_indicators import gear_indicators
from pitchpoint.analysis.harmonics import read_tones
from pitchpoint.analysis.indicators import signal_indicators
from pitchpoint.analysis.periodicity import PeriodSearch, find_period, period_evidence
from pitchpoint.analysis.synchronous_average import synchronous_average
from pitchpoint.analysis.wavelets import WaveletLevels, wavelet_levels

CHANNEL = "signal[third_a_y]"
"""Vertical force of the first bearing of the third shaft, which carries Z5."""
TRAIN = frequencies(load_model(HERE / "paper.yaml"))
MESHES, TURN = TRAIN.mesh, 1.0 / TRAIN.shaft[2]
"""Mesh frequencies [Hz] and period of the third shaft [s]."""
SHORTEST, LONGEST = 1.0, 7.4
"""Limits between which a period is searched [s]: half of the record is the longest that can be read."""
RATIOS = (10.0, 5.0, 0.0, -5.0, -10.0, -15.0, -20.0, -25.0)
ENVELOPE_BAND = (1.6, 4.9)
"""Band about the mesh of the third stage [Hz]: the broken tooth hardly modulates the faster meshes."""
Detector = Callable[[np.ndarray], float]


@dataclass(frozen=True)
class Pair:
    """The same bearing force of the healthy and of the faulty gearbox, at the paper's sample rate.

    Attributes
    ----------
    healthy, faulty
        Shape (6456,). Forces [N].
    angle
        Shape (6456,). Angle of the third shaft [rad].
    """

    healthy: np.ndarray
    faulty: np.ndarray
    angle: np.ndarray

    def noisy(self, faulty: bool, ratio: float, seed: int) -> np.ndarray:
        """Force with white noise: alternating rms of the faulty force over that of the noise [dB]."""
        signal = self.faulty if faulty else self.healthy
        # the healthy gearbox gets other noise of the same strength
        noise = np.random.default_rng([seed, int(faulty)]).normal(size=signal.size)
        return np.asarray(signal + self.faulty.std() * 10.0 ** (-ratio / 20.0) * noise)


@dataclass(frozen=True)
class Readings:
    """Periods read from a5 of many noisy signals.

    Attributes
    ----------
    ratio
        Signal-to-noise ratio [dB].
    faulty
        Shape (n,). Periods of the faulty gearbox [s]; not a number where none was found.
    healthy
        Shape (m,). Periods that the healthy gearbox seems to have [s]; not a number where none was found.
    """

    ratio: float
    faulty: np.ndarray
    healthy: np.ndarray

    @property
    def hits(self) -> int:
        """Readings within 0.5 % of the period of the shaft."""
        return int(np.sum(np.abs(self.faulty / TURN - 1.0) <= 5e-3))

    @property
    def worst(self) -> float:
        """Largest relative error of a reading [-]."""
        return float(np.max(np.abs(self.faulty / TURN - 1.0)))

    @property
    def false_alarms(self) -> int:
        """Healthy signals in which a period was found."""
        return int(np.sum(np.isfinite(self.healthy)))


def pair_of(healthy: Run, faulty: Run, channel: str = CHANNEL) -> Pair:
    """The forces of both runs and the angle of the third shaft."""
    return Pair(healthy.thinned(channel), faulty.thinned(channel), faulty.record("angle[third]")[::5])


def levels_of(values: np.ndarray) -> WaveletLevels:
    """Db5, five levels."""
    return wavelet_levels(values, RATE, wavelet="db5", levels=5)


def period_of(values: np.ndarray) -> PeriodSearch:
    """The period that shows in a5, if there is one; mesh frequencies are known."""
    found = levels_of(values)
    return find_period(
        found.signals[0],
        RATE,
        SHORTEST,
        LONGEST,
        known=MESHES,
        highest_frequency=float(found.band[0, 1]),
    )


def readings(pair: Pair, ratio: float, *, seeds: int = 20, healthy_seeds: int = 100) -> Readings:
    """Periods of many noisy signals, faulty and healthy."""
    found = [
        np.array([period_of(pair.noisy(faulty, ratio, seed)).period for seed in range(count)])
        for faulty, count in ((True, seeds), (False, healthy_seeds))
    ]
    return Readings(ratio, *found)


def detectors(angle: np.ndarray) -> dict[str, Detector]:
    """Numbers that grow with the fault: the comb of lines in a5 and other indicators.

    Parameters
    ----------
    angle
        Angle of the third shaft [rad], shape (n,): what the synchronous average refers to.
    """
    shaft = 1.0 / TURN

    def comb(x: np.ndarray) -> float:
        level = levels_of(x)
        top = float(level.band[0, 1])
        found = period_evidence(level.signals[0], RATE, [TURN], known=MESHES, highest_frequency=top)
        return -float(np.log10(max(found.p_value[0], 1e-300)))

    def average(x: np.ndarray) -> float:
        turn = synchronous_average(x, angle, samples_per_turn=1024)
        return gear_indicators(turn.values, teeth=11, other_teeth=(68,)).fm4

    def envelope(x: np.ndarray) -> float:
        spectrum = envelope_spectrum(x, RATE, band=ENVELOPE_BAND)
        lines = np.interp(shaft * np.arange(1, 6), spectrum.frequency, spectrum.amplitude)
        return float(lines.sum())

    def line(x: np.ndarray) -> float:
        return float(read_tones(x, RATE, [shaft], reach=0.02 * shaft).amplitude[0])

    return {
        "comb in a5": comb,
        "FM4 of the synchronous average": average,
        "kurtosis": lambda x: signal_indicators(x).kurtosis,
        "envelope, lines of the shaft": envelope,
        "line at the speed of the shaft": line,
    }


def curves(pair: Pair, *, seeds: int = 100, snr: tuple[float, ...] = RATIOS) -> DetectionCurves:
    """Rates of detection over the signal-to-noise ratio at 5 % false alarms."""
    return detection_curves(pair.healthy, pair.faulty, detectors(pair.angle), snr=snr, seeds=seeds)
