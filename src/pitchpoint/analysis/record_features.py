# SPDX-License-Identifier: Apache-2.0
"""Named features of one record to compare it with others: levels of lines, bands and synchronous averages."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import chain

import numpy as np

from pitchpoint.analysis.envelope import band_envelope
from pitchpoint.analysis.fault_families import fault_families
from pitchpoint.analysis.gear_signals import MIN_TEETH, gear_signals
from pitchpoint.analysis.indicators import signal_indicators, standardised_moment
from pitchpoint.analysis.line_tests import FineSpectrum, fine_spectrum
from pitchpoint.analysis.sampled import Array, SignalError, as_signal, positive
from pitchpoint.analysis.synchronous_average import synchronous_average
from pitchpoint.analysis.turning_parts import Shaft, TurningParts

MESH_HARMONICS, MODULATED, SIDEBANDS, SHAFT_ORDERS = 5, 3, 3, 3
"""Mesh harmonics with a level, those with sidebands, sidebands on either side, orders of every shaft."""
REACH = 2.0
"""Half width of a line of a steady tone with a Hann window [lines of the record]."""
PER_OCTAVE = 3
"""Bands per octave."""
BAND_LINES = 8.0
"""Smallest width of a band [lines of the record]."""
MIN_TURNS = 8
"""Smallest number of averaged revolutions of a gear."""
LEAST = 1e-12
"""Smallest power relative to that of the signal: -120 dB; lower levels are round-off."""


@dataclass(frozen=True)
class Feature:
    """A number that describes one channel of a record.

    Attributes
    ----------
    channel
        Name of the channel.
    kind
        `level`, `shape`, `mesh`, `sidebands`, `shaft`, `band`, `residual`, `residual shape` or `bearing`.
    part
        Mesh, shaft, gear, or part of a bearing; of a band its limits; empty for the whole signal.
    detail
        Which of several features of the part; empty if there is one.
    """

    channel: str
    kind: str
    part: str = ""
    detail: str = ""


def record_features(
    signals: Mapping[str, Array],
    samples_per_turn: float,
    parts: TurningParts,
    *,
    frequency: float = 1.0,
    tolerance: float = 0.0,
    slip: float = 0.01,
) -> dict[Feature, float]:
    """Features of the channels of a record, all in decibels.

    Parameters
    ----------
    signals
        Values by channel over the angle of the reference shaft, shape (n,) each, any unit.
    samples_per_turn
        Samples per revolution of the reference shaft [-].
    parts
        Rotating parts; orders refer to the reference shaft.
    frequency
        Rotation frequency of the reference shaft, for bands with limits in Hz [Hz]; 1 for limits in orders.
    tolerance
        Relative tolerance of the speed [-]; lines of shafts and meshes require 0.
    slip
        Maximum relative deviation of the orders of bearings [-].

    Returns
    -------
    dict
        Values by feature [dB]: 10 lg of powers in the squared unit of the signal, of kurtosis, and of squared
        crest factors; for bearings the mean level of three lines of the squared envelope above the local
        median.

    Raises
    ------
    SignalError
        If a signal is constant or not finite, or a rate is not positive.

    Notes
    -----
    Power of a line: sum of the Hann-windowed spectrum within one line of the record, over the noise bandwidth
    of the window, so that a level does not depend on the position between two lines [1]_. Bands are thirds of
    octaves with limits at 10^(k/10) times 10^(1/20) [2]_. Residual: synchronous average without mesh
    harmonics and the two lowest orders. Logarithms, because the scatter of powers of healthy machines is
    proportional to their values. Valid for records of at least eight revolutions of a gear; features that a
    record cannot show are omitted.

    References
    ----------
    .. [1] F. J. Harris, On the use of windows for harmonic analysis with the discrete Fourier transform,
       Proceedings of the IEEE 66(1), 1978, 51-83.
    .. [2] IEC 61260-1:2014, Electroacoustics - Octave-band and fractional-octave-band filters, base ten.

    Examples
    --------
    A mesh line with the amplitude 2, power 2, has 3.01 dB:

    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> turned = np.arange(40_000) / 400.0
    >>> noise = 0.01 * np.random.default_rng(1).standard_normal(turned.size)
    >>> signal = 2.0 * np.cos(2 * np.pi * 20 * turned) + noise
    >>> found = record_features({"a": signal}, 400.0, train_parts([(20, 31)]))
    >>> round(found[Feature("a", "mesh", "mesh 1", "harmonic 1")], 2), round(found[Feature("a", "level")], 2)
    (3.01, 3.01)
    """
    rate = positive(samples_per_turn, "samples_per_turn")
    hertz = positive(frequency, "frequency")
    found: dict[Feature, float] = {}
    for channel, values in signals.items():
        x = as_signal(values, channel, minimum=1024)
        whole = signal_indicators(x)
        found[Feature(channel, "level")] = 20.0 * float(np.log10(whole.rms))
        found[Feature(channel, "shape", "", "kurtosis")] = 10.0 * float(np.log10(whole.kurtosis))
        found[Feature(channel, "shape", "", "crest factor")] = 20.0 * float(np.log10(whole.crest_factor))
        spectrum = fine_spectrum(x, rate)
        powers = chain(_bands(spectrum, parts, hertz), () if tolerance else _lines(spectrum, parts))
        for (kind, part, detail), power in powers:
            level = 10.0 * float(np.log10(max(power, LEAST * whole.rms**2)))
            found[Feature(channel, kind, part, detail)] = level
        if not tolerance:
            for (kind, part, detail), value in _averages(x, rate, parts, whole.rms):
                found[Feature(channel, kind, part, detail)] = value
        for (part, detail), value in _bearings(x, rate, parts, tolerance, slip):
            found[Feature(channel, "bearing", part, detail)] = value
    return found


def _lines(spectrum: FineSpectrum, parts: TurningParts) -> Iterator[tuple[tuple[str, str, str], float]]:
    """Powers of mesh harmonics, groups of sidebands, and lowest orders of the shafts."""
    summed = np.r_[0.0, np.cumsum(spectrum.amplitude**2)]
    for mesh in parts.meshes:
        order = parts.mesh_order(mesh)
        for k in range(1, MESH_HARMONICS + 1):
            if (k + 0.5) * order < spectrum.highest:
                yield ("mesh", mesh.name, f"harmonic {k}"), _power(spectrum, summed, k * order)
        for name in dict.fromkeys(mesh.shafts):
            turn = float(parts.shaft(name).order)
            for k in range(1, MODULATED + 1):
                places = [k * order + j * turn for j in range(-SIDEBANDS, SIDEBANDS + 1) if j]
                if turn >= 2.0 * REACH * spectrum.resolution and max(places) < spectrum.highest:
                    power = sum(_power(spectrum, summed, place) for place in places)
                    yield ("sidebands", mesh.name, f"of {name}, harmonic {k}"), power
    for shaft in parts.shafts:
        turn = float(shaft.order)
        if turn >= 2.0 * REACH * spectrum.resolution:
            for k in range(1, SHAFT_ORDERS + 1):
                yield ("shaft", shaft.name, f"order {k}"), _power(spectrum, summed, k * turn)


def _power(spectrum: FineSpectrum, summed: Array, place: float) -> float:
    """Power of a line: half its squared amplitude."""
    return _between(
        spectrum, summed, place - REACH * spectrum.resolution, place + REACH * spectrum.resolution
    )


def _between(spectrum: FineSpectrum, summed: Array, low: float, high: float) -> float:
    """Power between two orders, from sums of squared amplitudes, noise bandwidth of a Hann window 1.5."""
    first, last = np.clip(
        np.rint(np.array([low, high]) / spectrum.step), 0, spectrum.amplitude.size - 1
    ).astype(int)
    return float(summed[last + 1] - summed[first]) * 0.5 * spectrum.step / (1.5 * spectrum.resolution)


def _bands(
    spectrum: FineSpectrum, parts: TurningParts, hertz: float
) -> Iterator[tuple[tuple[str, str, str], float]]:
    """Powers of fractional-octave bands above the slowest shaft."""
    summed = np.r_[0.0, np.cumsum(spectrum.amplitude**2)]
    slowest = min(float(shaft.order) for shaft in parts.shafts) * hertz
    step = 10.0 ** (0.3 / PER_OCTAVE)
    number = int(np.ceil(np.log(slowest) / np.log(step)))
    while (high := step ** (number + 0.5)) <= spectrum.highest * hertz:
        low = step ** (number - 0.5)
        number += 1
        if (high - low) / hertz >= BAND_LINES * spectrum.resolution:
            ends = " to ".join(f"{float(f'{end:.3g}'):g}" for end in (low, high))
            name = f"orders {ends}" if hertz == 1.0 else f"{ends} Hz"
            yield ("band", name, ""), _between(spectrum, summed, low / hertz, high / hertz)


def _averages(
    x: Array, rate: float, parts: TurningParts, rms: float
) -> Iterator[tuple[tuple[str, str, str], float]]:
    """Residuals of the synchronous averages of all gears."""
    turned = np.arange(x.size) * (2.0 * np.pi / rate)
    for shaft in parts.shafts:
        gears = parts.gears_of(shaft.name)
        samples = 2 * int(max(rate / float(shaft.order), 8.0) // 2)
        counts = _whole_orders(parts, shaft, samples)
        turns = x.size / rate * float(shaft.order)
        if not gears or turns < MIN_TURNS + 1 or any(2 * z >= samples for _, z in gears.values()):
            continue
        mean = synchronous_average(x, turned, ratio=shaft.order, samples_per_turn=samples)
        residual = gear_signals(mean.values, teeth=counts).residual
        power = max(float(np.mean(residual**2)), LEAST * rms**2)
        who = " and ".join(gears)
        yield ("residual", who, "rms"), 10.0 * float(np.log10(power))
        if power > LEAST * rms**2:
            yield (
                ("residual shape", who, "kurtosis"),
                10.0 * float(np.log10(standardised_moment(residual, 4))),
            )


def _whole_orders(parts: TurningParts, shaft: Shaft, samples: int) -> list[int]:
    """Orders of all meshes that are whole orders of a shaft and remain in its average."""
    ratios = [parts.shaft(mesh.shafts[0]).order * mesh.teeth[0] / shaft.order for mesh in parts.meshes]
    return sorted({int(r) for r in ratios if r.denominator == 1 and r >= MIN_TEETH and 2 * r < samples})


def _bearings(
    x: Array, rate: float, parts: TurningParts, tolerance: float, slip: float
) -> Iterator[tuple[tuple[str, str], float]]:
    """Mean levels of the lines of all parts of bearings."""
    if not parts.bearings:
        return
    try:
        squared = band_envelope(x, rate, whiten=True).envelope ** 2
        found = fault_families(squared, rate, parts, tolerance=tolerance, slip=slip)
    except SignalError:
        return
    for family in found.families:
        yield (family.name, "lines"), float(family.level.mean())
