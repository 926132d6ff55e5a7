# SPDX-License-Identifier: Apache-2.0
"""Speed and angle of a machine whose speed varies widely, from the lines of its record and without a tacho.

The speed follows from a path through short-time spectra, the angle from the phase of the clearest line. What
confirms both is part of the result; a record that does not determine them is refused.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from pitchpoint.analysis.envelope import band_envelope
from pitchpoint.analysis.mesh_angle import HARMONICS, LineAngle, line_angle
from pitchpoint.analysis.orders import resample_over_angle
from pitchpoint.analysis.sampled import Array, SignalError, as_signal, positive
from pitchpoint.analysis.speed_path import Comb, SpeedPath, speed_path
from pitchpoint.analysis.speed_without_gears import (
    IMPACT_HARMONICS,
    MotorPath,
    finer_path,
    impact_combs,
    motor_path,
)
from pitchpoint.analysis.turning_parts import TurningParts

PERIODS = (16, 32, 64, 128, 256, 512)
"""Lengths of the frames tried [periods of the lowest mesh line, or of the slowest shaft]."""
SHORTEST = 64
"""Smallest number of samples of a frame."""
FRAMES = 8
"""Smallest number of whole frames in a record."""
SHAFT_HARMONICS = 3
"""Harmonics of the shafts of a machine with gears."""
SAME = 0.02
"""Relative difference of orders within which a line between those of the machine may be one of them."""
MARGIN = 0.05
"""Relative part of the range by which the search extends beyond its limits."""
AT_LIMIT = 0.1
"""Largest share of the frames with the speed at a limit."""
WIDER, OUTSIDE = 1.5, 0.03
"""Factor by which a second search extends the range, and largest share of the frames outside the range."""
SPREADS = 6.0
"""Smallest distance of the level from that of chance [standard deviations]."""
APART = 0.1
"""Smallest distance of the level from that of the best other path over its distance from chance [-]."""
HIDDEN = 0.5
"""Largest share of the frames in which no line is above chance."""
UNCERTAIN = 0.25
"""Level above chance over that of the whole path below which the speed of a frame is uncertain [-]."""
PHASE = 0.5
"""Largest error of the phase of the highest line of a bearing that is compared [rad]."""


@dataclass(frozen=True)
class SpeedTrack:
    """Angle and speed found in a record.

    Attributes
    ----------
    angle
        Shape (n,). Angle of the reference shaft at the samples [rad], 0 at the first one.
    path
        Path of the speed from which the angle was found.
    orders
        Orders of the lines whose phases refine the angle [-], the clearest first; empty if none is clear.
    agreement
        Agreement of the lines on the angle [rad], not its error, see `LineAngle`; NaN without such lines.
    lowest
        Lowest order of the strong lines [-].
    hidden
        Times between which the lines are hardly above chance [s], shape (k, 2).
    motor
        What determines the speed of a machine without gears.
    """

    angle: Array
    path: SpeedPath
    orders: tuple[float, ...]
    agreement: float
    lowest: float
    hidden: Array
    motor: MotorPath | None = None


def speed_track(
    signals: Mapping[str, Array], sample_rate: float, parts: TurningParts, low: float, high: float
) -> SpeedTrack:
    """Angle and speed of the reference shaft in a record at varying speed.

    Parameters
    ----------
    signals
        Values by channel, shape (n,) each, any unit.
    sample_rate
        Sample rate [Hz].
    parts
        Rotating parts; orders refer to the reference shaft.
    low, high
        Lowest and highest rotation frequency of the reference shaft [Hz].

    Returns
    -------
    SpeedTrack
        Angle and speed.

    Raises
    ------
    SignalError
        If the record is too short, its sample rate too low, or nothing in it determines the speed.

    Notes
    -----
    Path of the highest levels of mesh harmonics and shaft orders, see `speed_path`, in frames of the length
    with the clearest path. A path at a multiple of the speed is a competitor: levels half-way between mesh
    harmonics count against a speed. The record is resampled over the angle of the path and the phase of the
    clear lines followed, in bands that exclude the sidebands of ever slower shafts [1]_. Where a line crosses
    a resonance its phase changes by up to π, and the angle by π over its order if this line is followed. The
    delay that all lines have from mesh to sensor is part of the angle. Valid if the shaft does not stop.

    References
    ----------
    .. [1] F. Bonnardot, M. El Badaoui, R. B. Randall, J. Danière, F. Guillet, Use of the acceleration signal
       of a gearbox in order to perform angular resampling (with limited speed fluctuation), Mechanical
       Systems and Signal Processing 19(4), 2005, 766-785.

    Examples
    --------
    Run-up from 10 to 30 Hz in noise with the power of the signal; error of the angle [rad]:

    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> t = np.arange(80_000) / 8000.0
    >>> angle = 2 * np.pi * (10 * t + t**2)
    >>> x = np.cos(20 * angle) + 0.5 * np.cos(40 * angle) + np.random.default_rng(1).standard_normal(t.size)
    >>> found = speed_track({"acc": x}, 8000.0, train_parts([(20, 31)]), 8.0, 40.0)
    >>> found.orders, round(float(np.std(found.angle - angle)), 3)
    ((20.0, 40.0), 0.003)
    """
    rate = positive(sample_rate, "sample_rate")
    limits = positive(low, "low"), positive(high, "high")
    if not limits[0] < limits[1]:
        raise SignalError(f"low, high: {low:.6g} and {high:.6g} Hz (limit: low below high)")
    x = [as_signal(values, name, SHORTEST) for name, values in signals.items()]
    if not x:
        raise SignalError("signals: there is no channel (limit 1)")
    motor, comb = None, None
    if parts.meshes:
        comb = _comb_of(parts, limits[1], rate)
        path, lowest = _clearest_path(x, rate, comb, limits), comb.lowest
        _check(path, parts, limits)
        _check_range(x, rate, comb, path, limits)
    else:
        wide = (1.0 - MARGIN) * limits[0], (1.0 + MARGIN) * limits[1]
        motor = motor_path(x, rate, parts, wide)
        _check(motor.path, parts, limits)
        _check_range(motor.signals, rate, motor.combs, motor.path, limits)
        motor = finer_path(motor, rate)
        path, lowest = motor.path, motor.combs[0].lowest
    clock = np.arange(x[0].size) / rate
    angle = _integral(np.interp(clock, path.time, path.frequency), rate)
    refined, line = _refined(x, angle, parts, list(motor.orders) if motor else _lines(parts))
    if motor and line and line.agreement * _fastest(parts) > PHASE:
        line = None  # the scatter of these phases would smear the lines of the bearings
    angle = angle if line is None else refined
    if comb and line is None:
        _check_impacts(x, rate, comb, path, parts)
    if line is not None and line.agreement * lowest > math.pi:
        listed = ", ".join(f"{order:.5g}" for order in line.orders)
        raise SignalError(
            f"speed: the phases of the lines at orders {listed} give angles that differ by "
            f"{line.agreement:.2g} rad (limit {math.pi / lowest:.2g} rad, half a tooth pitch); check "
            "the tooth numbers"
        )
    return SpeedTrack(
        angle - angle[0],
        path,
        line.orders if line else (),
        line.agreement if line else math.nan,
        lowest,
        _hidden(path),
        motor,
    )


def _comb_of(parts: TurningParts, highest: float, rate: float) -> Comb:
    """Lines of a machine with gears that a record covers up to the highest speed.

    Parameters
    ----------
    parts
        Rotating parts.
    highest
        Highest rotation frequency of the reference shaft [Hz].
    rate
        Sample rate [Hz].

    Raises
    ------
    SignalError
        If the record covers no mesh line.

    Examples
    --------
    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> comb = _comb_of(train_parts([(20, 40)]), 30.0, 3000.0)
    >>> comb.orders.tolist(), comb.against.tolist(), comb.lowest
    ([0.5, 1.0, 1.5, 2.0, 3.0, 20.0, 40.0], [10.0, 30.0], 20.0)
    """
    meshes = sorted({parts.mesh_order(mesh) for mesh in parts.meshes})
    shafts = sorted({float(shaft.order) for shaft in parts.shafts})
    covered = 0.475 * rate / highest
    orders = {k * order for order in meshes for k in range(1, HARMONICS + 1) if k * order < covered}
    if not orders:
        raise SignalError(
            f"sample rate: {rate:.6g} Hz; at {highest:.6g} Hz the lowest mesh line is at "
            f"{meshes[0] * highest:.6g} Hz (limit {0.475 * rate:.6g} Hz); give a lower range, or a record "
            "with a higher rate"
        )
    own = orders | {k * s for s in shafts for k in range(1, SHAFT_HARMONICS + 1) if k * s < covered}
    between = {(k - 0.5) * order for order in meshes for k in range(1, HARMONICS + 1)}
    every = np.array(sorted(orders))
    against = [b for b in sorted(between) if b < covered and np.abs(every / b - 1.0).min() > SAME]
    return Comb(np.array(sorted(own)), np.array(against), meshes[0])


def _clearest_path(
    signals: Sequence[Array], rate: float, comb: Comb, limits: tuple[float, float]
) -> SpeedPath:
    """Path in frames of the length with which it is clearest."""
    middle = float(np.sqrt(limits[0] * limits[1])) * comb.lowest
    wide = (1.0 - MARGIN) * limits[0], (1.0 + MARGIN) * limits[1]
    lengths = [round(periods * rate / middle) for periods in PERIODS]
    fit = [n for n in lengths if n >= SHORTEST and FRAMES * n <= signals[0].size]
    if not fit:
        least = FRAMES * max(lengths[0], SHORTEST)
        raise SignalError(
            f"record: {signals[0].size / rate:.4g} s are too short to find a speed that varies (limit "
            f"{least / rate:.3g} s); use a longer record"
        )
    return max((speed_path(signals, rate, comb, wide, n) for n in fit), key=lambda path: path.gain)


def _check(path: SpeedPath, parts: TurningParts, limits: tuple[float, float]) -> None:
    """Refuse a path that nothing distinguishes from noise or from another path."""
    what = "mesh lines and shaft orders" if parts.meshes else "shaft orders"
    least = path.chance + SPREADS * path.spread
    span = f"{60.0 * limits[0]:.6g} to {60.0 * limits[1]:.6g} rpm"
    remedy = "check range and tooth numbers, or give --tacho or --angle"
    if not parts.meshes:
        remedy = "check the range, or give --tacho or --angle"
    seen = float(np.mean(path.seen))
    short = [
        f"the level of the best path is {path.score:.2f} (limit {least:.2f}: {SPREADS:g} standard deviations "
        "above chance)"
    ] * (path.score < least)
    short += [
        f"it is above chance in {100.0 * seen:.0f} % of the record (limit {100.0 * (1.0 - HIDDEN):.0f} %)"
    ] * (seen < 1.0 - HIDDEN)
    if short:
        raise SignalError(f"speed: no {what} determine it within {span}: {', '.join(short)}; {remedy}")
    if path.at_limit > AT_LIMIT:
        raise SignalError(
            f"speed: is at a limit of the range {span} in {100.0 * path.at_limit:.0f} % of the record (limit "
            f"{100.0 * AT_LIMIT:.0f} %); give a wider range"
            + ", or check the tooth numbers"
            * bool(parts.meshes)
        )
    if path.score - path.rival < APART * (path.score - path.chance):
        raise SignalError(
            f"speed: a path at {path.rival_ratio:.3f} times the speed fits as well within {span} (levels "
            f"{path.score:.2f} and {path.rival:.2f}, {path.chance:.2f} by chance); give a narrower range, "
            "--tacho or --angle"
        )


def _check_range(
    signals: Sequence[Array],
    rate: float,
    comb: Comb | Sequence[Comb],
    path: SpeedPath,
    limits: tuple[float, float],
) -> None:
    """Refuse a range that the speed leaves: a wider search then finds a clearer path."""
    wide = limits[0] / WIDER, limits[1] * WIDER
    other = speed_path(signals, rate, comb, wide, round(rate / path.resolution))
    low, high = (1.0 - MARGIN) * limits[0], (1.0 + MARGIN) * limits[1]
    outside = float(np.mean((other.frequency < low) | (other.frequency > high)))
    if outside > OUTSIDE and other.score > path.score + SPREADS * path.spread:
        span = f"{60.0 * limits[0]:.6g} to {60.0 * limits[1]:.6g} rpm"
        found = f"{60.0 * other.frequency.min():.4g} to {60.0 * other.frequency.max():.4g} rpm"
        raise SignalError(
            f"speed: leaves the range {span} in {100.0 * outside:.0f} % of the record (limit "
            f"{100.0 * OUTSIDE:.0f} %): {found} agrees better with the lines; give a wider range, or check "
            "tooth numbers and bearings"
        )


def _check_impacts(
    signals: Sequence[Array], rate: float, comb: Comb, path: SpeedPath, parts: TurningParts
) -> None:
    """Refuse a path without a clear mesh line if impacts of a bearing lead to another one."""
    envelopes = [band_envelope(x, rate, whiten=True).envelope ** 2 for x in signals]
    limits = float(path.frequency.min()) / WIDER, float(path.frequency.max()) * WIDER
    found = {}
    for name, impacts in impact_combs(parts, 0.475 * rate / limits[1]).items():
        combs = [comb] * len(signals) + [impacts] * len(envelopes)
        found[name] = speed_path([*signals, *envelopes], rate, combs, limits, round(rate / path.resolution))
    best = max(found, key=lambda name: found[name].score - found[name].chance, default="")
    if not best:
        return
    other = np.interp(path.time, found[best].time, found[best].frequency)
    differs = float(np.mean(np.abs(other / path.frequency - 1.0) > SAME))
    if differs > AT_LIMIT:
        spans = [f"{60.0 * one.min():.4g} to {60.0 * one.max():.4g} rpm" for one in (path.frequency, other)]
        raise SignalError(
            f"speed: no mesh line is clear; mesh lines agree best with {spans[0]}, together with impacts of "
            f"the {best} with {spans[1]}; they differ in {100.0 * differs:.0f} % of the record (limit "
            f"{100.0 * AT_LIMIT:.0f} %); give --tacho or --angle"
        )


def _over(signals: Sequence[Array], angle: Array) -> tuple[dict[str, Array], float]:
    """Channels over an angle by number, and their samples per revolution."""
    found = [resample_over_angle(x, angle) for x in signals]
    return {str(k): one.values for k, one in enumerate(found)}, found[0].samples_per_revolution


def _refined(
    signals: Sequence[Array], angle: Array, parts: TurningParts, lines: Sequence[float]
) -> tuple[Array, LineAngle | None]:
    """Angle that follows clear lines in bands without the sidebands of ever slower shafts."""
    line = None
    for slowest in sorted({float(shaft.order) for shaft in parts.shafts}, reverse=True):
        over, per_turn = _over(signals, angle)
        found = line_angle(over, per_turn, lines, slowest)
        if found is None:
            continue
        turned = 2.0 * np.pi * np.arange(found.angle.size) / per_turn
        moved = angle + np.interp(angle - angle[0], turned, found.angle - turned)
        if np.any(np.diff(moved) <= 0.0):
            continue
        angle, line = moved, found
    return angle, line


def _fastest(parts: TurningParts) -> float:
    """Highest order of a bearing that is compared [-]; 0 without bearings."""
    rates = (order for bearing in parts.bearings for order in bearing.orders.values())
    return IMPACT_HARMONICS * max(rates, default=0.0)


def _lines(parts: TurningParts) -> list[float]:
    """Orders of the mesh lines whose phases are followed."""
    meshes = {parts.mesh_order(mesh) for mesh in parts.meshes}
    return sorted({k * order for order in meshes for k in range(1, HARMONICS + 1)})


def _integral(frequency: Array, rate: float) -> Array:
    """Angle [rad] of a rotation frequency [Hz] over time."""
    return np.asarray(2.0 * np.pi / rate * np.r_[0.0, np.cumsum(0.5 * (frequency[1:] + frequency[:-1]))])


def _hidden(path: SpeedPath) -> Array:
    """Times between which the lines are hardly above chance [s], shape (k, 2), with the gaps to other frames.

    A single frame covers the time to the middles between it and its neighbours.
    """
    uncertain = path.level < path.chance + UNCERTAIN * (path.score - path.chance)
    edges = np.diff(np.r_[0, uncertain.astype(np.int64), 0])
    first, last = np.flatnonzero(edges == 1), np.flatnonzero(edges == -1) - 1
    between = 0.5 * (path.time[1:] + path.time[:-1])
    limits = np.r_[path.time[0], between, path.time[-1]]
    return np.column_stack([limits[first], limits[last + 1]])
