# SPDX-License-Identifier: Apache-2.0
"""Signal conditioning for bearing diagnosis: removal of healthy lines, pre-whitening, choice of the band."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.cepstrum import whitened
from pitchpoint.analysis.kurtogram import kurtogram
from pitchpoint.analysis.sampled import Array, as_signal
from pitchpoint.analysis.shaft_tests import passing_balls
from pitchpoint.analysis.turning_parts import TurningParts

__all__ = ["envelope_band", "whitened", "without_healthy_lines"]


def envelope_band(values: Array, samples_per_turn: float, parts: TurningParts) -> tuple[float, float]:
    """Band of the most significant kurtosis among the bands wide enough for the orders of the bearings.

    Parameters
    ----------
    values
        Signal over the angle, shape (n,), any unit.
    samples_per_turn
        Samples per revolution of the reference shaft [-].
    parts
        Rotating parts of the machine.

    Returns
    -------
    tuple of float
        Edges of the band, as orders of the reference shaft [-].

    Notes
    -----
    Bands of the kurtogram [1]_ at least three times as wide as the highest order; the whole signal if there
    is none. The kurtosis of a band counts in standard deviations of that of noise: narrow bands have few
    samples, and the largest of their kurtoses is often one of noise. Valid for impacts that excite a
    resonance in one band.

    References
    ----------
    .. [1] J. Antoni, Fast computation of the kurtogram for the detection of transient faults, Mechanical
       Systems and Signal Processing 21(1), 2007, 108-124.

    Examples
    --------
    >>> from pitchpoint.analysis.turning_parts import Bearing, train_parts
    >>> parts = train_parts([(21, 40)], [Bearing("left", {"outer ring": 3.57})])
    >>> turned = np.arange(50_000) / 500.0
    >>> noise = np.random.default_rng(1).standard_normal(turned.size)
    >>> knock = np.exp(-20 * (turned * 3.57 % 1)) * np.sin(2 * np.pi * 150 * turned)
    >>> low, high = envelope_band(2 * knock + 0.3 * noise, 500.0, parts)
    >>> low < 150 < high
    True
    """
    found = kurtogram(values, samples_per_turn)
    highest = max(order for bearing in parts.bearings for order in bearing.orders.values())
    wide = found.high - found.low >= 3.0 * highest
    if not wide.any():
        return 0.0, 0.5 * samples_per_turn
    best = int(np.argmax(np.where(wide, found.kurtosis / found.spread, -np.inf)))
    return float(found.low[best]), float(found.high[best])


def without_healthy_lines(values: ArrayLike, samples_per_turn: float, parts: TurningParts) -> Array:
    """Signal without the lines of a healthy machine: mesh harmonics, ball passage, and their products.

    Parameters
    ----------
    values
        Signal over the angle of the reference shaft, shape (n,), any unit.
    samples_per_turn
        Samples per revolution of the reference shaft [-].
    parts
        Rotating parts of the machine.

    Notes
    -----
    Five lines around each are set to zero [1]_, more where slip is possible. The sidebands of the meshes are
    removed too, because they would beat with each other at the ball pass order. Valid for a steady mesh.

    References
    ----------
    .. [1] R. B. Randall, Vibration-based Condition Monitoring, Wiley, 2011.

    Examples
    --------
    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> turned = np.arange(5000) / 100.0
    >>> x = np.cos(2 * np.pi * 21 * turned)
    >>> bool(np.abs(without_healthy_lines(x, 100.0, train_parts([(21, 40)]))).max() < 1e-9)
    True
    """
    lines = np.fft.rfft(as_signal(values))
    lines[0] = 0.0
    per_order = np.size(values) / samples_per_turn
    highest = 0.5 * samples_per_turn
    meshes = [parts.mesh_order(mesh) for mesh in parts.meshes]
    places = [(k * step, 0.0) for step in meshes for k in range(1, int(highest / step) + 1)]
    middle, reach = np.array([*places, *passing_balls(parts, highest)]).reshape(-1, 2).T
    first = np.clip(np.rint((middle - reach) * per_order).astype(np.int64) - 2, 0, lines.size)
    last = np.clip(np.rint((middle + reach) * per_order).astype(np.int64) + 3, 0, lines.size)
    depth = np.zeros(lines.size + 1)
    np.add.at(depth, first, 1.0)
    np.add.at(depth, last, -1.0)
    lines[np.cumsum(depth[:-1]) > 0.0] = 0.0
    return np.asarray(np.fft.irfft(lines, np.size(values)), dtype=np.float64)
