# SPDX-License-Identifier: Apache-2.0
"""Angle of a shaft from the phase of a line: drift of a nearly constant speed, without a tacho."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.sampled import Array, SignalError, as_signal, positive
from pitchpoint.analysis.turning_parts import TurningParts

HARMONICS = 3
"""Harmonics of every mesh that may be used."""
HALF_WIDTH = 0.3
"""Half width of the band about a mesh line over the order of the slowest shaft: sidebands are excluded."""
CLEAR = 10.0
"""Smallest power of the band over that of the two adjacent half bands."""
PASSES = 3
"""Number of passes over the phases."""
WIDE = 4.0
"""Half width of the extracted band [half widths of the band about a line]."""
LINES = 4.0
"""Smallest half width of the band [lines of the record]."""


def mesh_angle(signals: Mapping[str, Array], samples_per_turn: float, parts: TurningParts) -> Array | None:
    """Angle of the reference shaft that follows the clear mesh lines of a record at nearly constant speed.

    Parameters
    ----------
    signals
        Values by channel, shape (n,) each, any unit, at a constant mean speed.
    samples_per_turn
        Samples per revolution of the reference shaft at the mean speed [-].
    parts
        Rotating parts; orders refer to the reference shaft.

    Returns
    -------
    NDArray or None
        Angle at the samples [rad], shape (n,); None if no mesh line is clear.

    Raises
    ------
    SignalError
        If a signal is not finite, there is none, or the rate is not positive.

    Notes
    -----
    Phases of bands about the lines k z, without the sidebands of the slowest shaft, over k z [1]_, see
    `line_angle`. Phase steps of all channels are added with their powers as weights, because the line of one
    channel may vanish for a moment; constant phase differences of the channels have no effect. Changes faster
    than 0.3 times the speed of the slowest shaft are not followed; within two revolutions of this shaft from
    the ends the angle is less accurate. Valid for speeds that change by less than 0.3 times the speed of the
    slowest shaft over the mesh order.

    References
    ----------
    .. [1] F. Bonnardot, M. El Badaoui, R. B. Randall, J. Danière, F. Guillet, Use of the acceleration signal
       of a gearbox in order to perform angular resampling (with limited speed fluctuation), Mechanical
       Systems and Signal Processing 19(4), 2005, 766-785.

    Examples
    --------
    A drift of 0.05 revolutions over 100, of which the mean speed contains nothing:

    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> turned = 2 * np.pi * np.arange(40_000) / 400.0
    >>> angle = turned + 2 * np.pi * 0.05 * np.sin(turned / 100)
    >>> found = mesh_angle({"a": np.cos(20 * angle)}, 400.0, train_parts([(20, 31)]))
    >>> bool(np.ptp((found - angle)[2000:-2000]) < 1e-4)
    True
    """
    found = line_angle(signals, samples_per_turn, *_mesh_lines(parts))
    return None if found is None else found.angle


def has_clear_mesh(signals: Mapping[str, Array], samples_per_turn: float, parts: TurningParts) -> bool:
    """Whether a mesh line is clear and as narrow as at a nearly constant speed.

    Parameters
    ----------
    signals
        Values by channel, shape (n,) each, any unit.
    samples_per_turn
        Samples per revolution of the reference shaft at the mean speed [-].
    parts
        Rotating parts; orders refer to the reference shaft.
    """
    return bool(clear_lines(signals, samples_per_turn, *_mesh_lines(parts)))


def _mesh_lines(parts: TurningParts) -> tuple[list[float], float]:
    """Orders of mesh harmonics, and that of the slowest shaft."""
    orders = {k * parts.mesh_order(mesh) for mesh in parts.meshes for k in range(1, HARMONICS + 1)}
    return sorted(orders), float(min(shaft.order for shaft in parts.shafts))


@dataclass(frozen=True)
class LineAngle:
    """Angle that follows the phases of lines.

    Attributes
    ----------
    angle
        Shape (n,). Angle of the reference shaft [rad].
    orders
        Orders of the lines [-], the clearest first.
    agreement
        Agreement of the lines [rad]: standard deviation of the angles of single lines from the common one, or
        that due to the noise about the lines if it is larger. It is not the error of the angle: phase and
        delay that all lines have in common are not contained.
    """

    angle: Array
    orders: tuple[float, ...]
    agreement: float


def line_angle(
    signals: Mapping[str, Array], samples_per_turn: float, orders: Sequence[float], slowest: float
) -> LineAngle | None:
    """Angle of the reference shaft that follows all clear lines among some orders.

    Parameters
    ----------
    signals
        Values by channel, shape (n,) each, any unit, at a constant mean speed.
    samples_per_turn
        Samples per revolution of the reference shaft at the mean speed [-].
    orders
        Orders of the lines [-].
    slowest
        Order of the slowest shaft [-].

    Returns
    -------
    LineAngle or None
        The angle; None if no line is clear.

    Raises
    ------
    SignalError
        If a signal is not finite, there is none, or the rate is not positive.

    Notes
    -----
    White noise in the band of a line with the power N, line of the power P: the variance of its phase is
    N/(2 P) [1]_, that of the angle is smaller by the square of the order. Phase steps of the lines are
    averaged with the weights k²/(1 + N/P) for the order k: a line that vanishes for a moment has none, and
    one that crosses a resonance, where its phase changes, has not more than others.

    References
    ----------
    .. [1] D. C. Rife, R. R. Boorstyn, Single-tone parameter estimation from discrete-time observations, IEEE
       Transactions on Information Theory 20(5), 1974, 591-598.

    Examples
    --------
    >>> turned = 2 * np.pi * np.arange(20_000) / 200.0
    >>> found = line_angle({"a": np.cos(5 * turned)}, 200.0, [3.0, 5.0], 1.0)
    >>> found.orders, bool(np.ptp((found.angle - turned)[1000:-1000]) < 1e-4)
    ((5.0,), True)
    """
    from scipy.interpolate import CubicSpline

    rate = positive(samples_per_turn, "samples_per_turn")
    clear = clear_lines(signals, rate, orders, slowest)
    if not clear:
        return None
    half = HALF_WIDTH * slowest
    ordered = sorted(clear, key=lambda order: -clear[order])
    turns, bands = _bands(list(signals.values()), rate, ordered, half)
    # a window whose response is halved at the edges of the band; at the ends of the record it is cut
    weights = np.hanning(max(round(1.0 / half / (turns[1] - turns[0])), 3) | 1)
    moved = np.zeros(turns.size)
    each = np.zeros((len(ordered), turns.size - 1))
    share = np.zeros_like(each)
    # the phases that remain are followed again, as a cut window shifts changing phases
    for _ in range(PASSES):
        for row, (order, channels) in enumerate(zip(ordered, bands, strict=True)):
            back = np.exp(-1j * order * moved)
            smooth = [np.convolve(band * back, weights, mode="same") for band in channels]
            steps = np.asarray(sum(one[1:] * one[:-1].conj() for one in smooth))
            each[row] = np.angle(steps) / order
            power = np.abs(steps)
            ratio = clear[order] * power / max(float(power.mean()), 1e-300)
            share[row] = order**2 * ratio / (1.0 + ratio)
        total = np.maximum(share.sum(axis=0), 1e-300)
        moved[1:] += np.cumsum((share * each).sum(axis=0) / total)
    weight = share.mean(axis=1) / share.mean() / len(ordered)
    apart = np.cumsum(each, axis=1).std(axis=1)
    noise = np.array([0.5 / clear[order] / order**2 for order in ordered])
    agreement = np.sqrt(max(float(weight @ apart**2), float(1.0 / np.sum(1.0 / noise))))
    clock = np.arange(next(iter(signals.values())).size) / rate
    angle = 2.0 * np.pi * clock + CubicSpline(turns, moved)(clock)
    return LineAngle(angle, tuple(ordered), float(agreement))


def _bands(
    signals: Sequence[Array], rate: float, orders: Sequence[float], half: float
) -> tuple[Array, list[list[NDArray[np.complex128]]]]:
    """Revolutions, and bands about the orders by channel, moved to zero frequency, at a reduced rate."""
    from scipy.fft import next_fast_len

    length = signals[0].size
    size = next_fast_len(length + int(2.0 * rate / half), real=True)
    count = int(np.ceil(2.0 * WIDE * half * size / rate)) | 1
    turns: Array = np.arange(count, dtype=np.float64) * (size / rate / count)
    inside = turns <= (length - 1) / rate
    inside[np.count_nonzero(inside)] = True
    found: list[list[NDArray[np.complex128]]] = [[] for _ in orders]
    for one in signals:
        lines = np.fft.rfft(one - one.mean(), size)
        for row, order in enumerate(orders):
            middle = round(order * size / rate)
            at = middle + np.arange(-(count // 2), count // 2 + 1)
            kept = np.where((at > 0) & (at < lines.size), lines[np.clip(at, 0, lines.size - 1)], 0.0)
            band = np.fft.ifft(np.fft.ifftshift(kept))
            # the middle of the band is a line of the transform, the order is not
            found[row].append((band * np.exp(2j * np.pi * (middle * rate / size - order) * turns))[inside])
    return turns[inside], found


def clear_lines(
    signals: Mapping[str, Array], samples_per_turn: float, orders: Sequence[float], slowest: float
) -> dict[float, float]:
    """Orders of clear lines, each with the power of its band over that of the adjacent half bands.

    Parameters
    ----------
    signals
        Values by channel, shape (n,) each, any unit, at a constant mean speed.
    samples_per_turn
        Samples per revolution of the reference shaft at the mean speed [-].
    orders
        Orders of the lines [-].
    slowest
        Order of the slowest shaft [-].

    Raises
    ------
    SignalError
        If a signal is not finite, there is none, or the rate is not positive.

    Notes
    -----
    Bands of 0.3 times the order of the slowest shaft on either side, within which its sidebands are not [1]_.
    Valid for bands of at least eight lines of the record.

    References
    ----------
    .. [1] F. Bonnardot, M. El Badaoui, R. B. Randall, J. Danière, F. Guillet, Use of the acceleration signal
       of a gearbox in order to perform angular resampling (with limited speed fluctuation), Mechanical
       Systems and Signal Processing 19(4), 2005, 766-785.

    Examples
    --------
    >>> turned = 2 * np.pi * np.arange(20_000) / 200.0
    >>> list(clear_lines({"a": np.cos(5 * turned)}, 200.0, [3.0, 5.0], 1.0))
    [5.0]
    """
    rate = positive(samples_per_turn, "samples_per_turn")
    x = [as_signal(values, name, 64) for name, values in signals.items()]
    if not x:
        raise SignalError("signals: there is no channel (limit 1)")
    length = x[0].size
    half = HALF_WIDTH * slowest * length / rate
    if half < LINES:
        return {}
    powers = np.sum([np.abs(np.fft.rfft(one - one.mean())) ** 2 for one in x], axis=0)
    found = {}
    for order in orders:
        middle = order * length / rate
        if not 2.0 * half + 1.0 <= middle < powers.size - 1 - 2.0 * half:
            continue
        edges = np.rint(middle + half * np.array([-2.0, -1.0, 1.0, 2.0])).astype(int)
        below, inside, above = (
            float(np.sum(powers[a:b])) for a, b in zip(edges[:-1], edges[1:], strict=True)
        )
        ratio = inside / max(below + above, 1e-300)
        if ratio > CLEAR:
            found[float(order)] = ratio
    return found
