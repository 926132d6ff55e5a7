# SPDX-License-Identifier: Apache-2.0
"""Path of a varying speed of a machine without gears, from shaft orders and impacts of bearings together.

Harmonics of a shaft alone are also every second line of half the speed. Impacts of a bearing have orders that
are not integers, so that their lines exclude such multiples; and a shaft with unbalance has its first order.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from pitchpoint.analysis.envelope import band_envelope
from pitchpoint.analysis.orders import resample_over_angle
from pitchpoint.analysis.sampled import Array, SignalError
from pitchpoint.analysis.speed_path import Comb, SpeedPath, level_along, speed_path
from pitchpoint.analysis.speed_search import at_mains
from pitchpoint.analysis.turning_parts import TurningParts

SHAFT_HARMONICS, IMPACT_HARMONICS = 6, 3
"""Harmonics of a shaft and of impacts."""
BETWEEN = np.array([1 / 3, 1 / 2, 2 / 3, 4 / 3, 3 / 2, 5 / 3])
"""Orders at which a speed that is twice or three times too high has lines, over that of the shaft or of the
impacts."""
TURNS = (6, 12, 24, 48)
"""Lengths of the frames tried [revolutions at the mean speed]."""
SECOND_TURNS = (16, 32, 64)
"""Lengths of the frames of the second search, over the angle of the first one [revolutions]."""
NEAR = 0.06
"""Relative range of the second search."""
SHORTEST, FRAMES = 64, 8
"""Smallest number of samples of a frame, and of frames of a record."""
SPREADS = 6.0
"""Smallest distance of a level from that of chance [standard deviations]."""
ALIKE = 0.8
"""Level above chance, over that of the best path, from which another path fits as well [-]."""
VISIBLE = 5.0
"""Smallest mean level of a line, times the root of the number of separate frames [-]: the standard deviation
of the level of noise is 0.65."""
CLEAR = 0.5
"""Smallest mean level of the lines of impacts along a path [-]."""
HELD = 0.02
"""Largest share of the frames with the speed at a limit of the range if impacts alone determine it: only the
range excludes impacts of another part at another speed."""
SAME = 1e-6
"""Relative difference of the orders of equal parts."""
SLIP = 0.01
"""Relative slip of rolling elements."""
OTHER = 0.05
"""Relative difference of the speeds of two paths from which they are different [-]."""


@dataclass(frozen=True)
class MotorPath:
    """Path of the speed of a machine without gears.

    Attributes
    ----------
    path
        The path, at the times of the frames of the first search.
    signals
        Channels, and squared envelopes of the whitened channels, shape (n,) each.
    combs
        Lines by which the path was found, one comb for each of the signals.
    impacts
        Bearing part whose impacts agree with the path, as in "outer ring of left"; empty if none do.
    orders
        Shaft orders that are visible along the path [-]; if there are none, the impacts alone determine the
        speed, which contains their slip.
    tolerance
        Relative tolerance of the speed [-].
    """

    path: SpeedPath
    signals: tuple[Array, ...]
    combs: tuple[Comb, ...]
    impacts: str
    orders: tuple[float, ...]
    tolerance: float


def motor_path(
    signals: Sequence[Array], rate: float, parts: TurningParts, limits: tuple[float, float]
) -> MotorPath:
    """Path of the speed of a machine without gears.

    Parameters
    ----------
    signals
        Values of the channels, shape (n,) each, any unit.
    rate
        Sample rate [Hz].
    parts
        Shafts and bearings.
    limits
        Lowest and highest rotation frequency of the reference shaft [Hz].

    Returns
    -------
    MotorPath
        The path.

    Raises
    ------
    SignalError
        If the record is too short, or two paths fit equally well.

    Notes
    -----
    Shaft orders in the spectra of frames, with weights that are reciprocals of their numbers, since rotor
    lines fall with the order; lines between them count against a speed, and those of the mains are removed.
    Impacts in the squared envelope of the whitened signal [1]_, of no part and of each ring and rolling
    element in turn; the part with the clearest path is taken [2]_. `finer_path` makes it more accurate. Valid
    if the shaft does not stop and its speed changes by less than 3 % per revolution.

    References
    ----------
    .. [1] P. Borghesani, P. Pennacchi, R. B. Randall, N. Sawalhi, R. Ricci, Application of cepstrum
       pre-whitening for the diagnosis of bearing faults under variable speed conditions, Mechanical Systems
       and Signal Processing 36(2), 2013, 370-384.
    .. [2] Q. Leclère, H. André, J. Antoni, A multi-order probabilistic approach for instantaneous angular
       speed tracking, Mechanical Systems and Signal Processing 81, 2016, 375-386.

    Examples
    --------
    >>> from fractions import Fraction
    >>> from pitchpoint.analysis.turning_parts import Shaft
    >>> t = np.arange(20_000) / 2000.0
    >>> turns = 10 * t + t**2
    >>> x = sum(np.cos(2 * np.pi * k * turns) / k for k in (1, 2, 3))
    >>> x = x + 0.3 * np.random.default_rng(1).standard_normal(t.size)
    >>> found = motor_path([x], 2000.0, TurningParts((Shaft("motor", Fraction(1)),)), (4.0, 40.0))
    >>> found = finer_path(found, 2000.0)
    >>> error = found.path.frequency / (10 + 2 * found.path.time) - 1
    >>> bool(np.median(np.abs(error)) < 0.01), found.orders
    (True, (1.0, 2.0, 3.0))
    """
    kept = [_without_mains(x, rate) for x in signals]
    both = [*kept, *(band_envelope(x, rate, whiten=True).envelope ** 2 for x in kept)]
    covered = 0.475 * rate / limits[1]
    shafts = _covered(_shaft_comb(parts), covered)
    if not shafts.orders.size:
        raise SignalError(
            f"sample rate: {rate:.6g} Hz; at {limits[1]:.6g} Hz the lowest shaft order is at "
            f"{shafts.lowest * limits[1]:.6g} Hz (limit {0.475 * rate:.6g} Hz); give a lower range, or a "
            "record with a higher rate"
        )
    combs = {"": Comb(np.empty(0), np.empty(0), shafts.lowest), **impact_combs(parts, covered)}
    every = {name: [shafts] * len(signals) + [comb] * len(signals) for name, comb in combs.items()}
    middle = float(np.sqrt(limits[0] * limits[1])) * shafts.lowest
    lengths = _frames(signals[0].size, rate, [turns / middle for turns in TURNS])
    found: dict[str, SpeedPath] = {}
    for name, lines in every.items():
        paths = [speed_path(both, rate, lines, limits, n) for n in lengths]
        found[name] = max(paths, key=lambda path: path.gain)
    best = max(found, key=lambda name: found[name].score - found[name].chance)
    _check_alone(found, best)
    return MotorPath(found[best], tuple(both), tuple(every[best]), best, (), NEAR)


def _without_mains(x: Array, rate: float) -> Array:
    """Signal without the lines of the mains, which do not follow the speed of a shaft."""
    lines = np.fft.rfft(x)
    resolution = rate / x.size
    lines[at_mains(resolution * np.arange(lines.size, dtype=np.float64), resolution)] = 0.0
    return np.asarray(np.fft.irfft(lines, x.size))


def _frames(size: int, rate: float, lengths: Sequence[float]) -> list[int]:
    """Numbers of samples of frames of some lengths that fit into the record."""
    samples = [max(round(one * rate), SHORTEST) for one in lengths]
    fit = sorted({n for n in samples if FRAMES * n <= size})
    if not fit:
        raise SignalError(
            f"record: {size / rate:.4g} s are too short to find a speed that varies (limit "
            f"{FRAMES * min(samples) / rate:.3g} s); use a longer record"
        )
    return fit


def _check_alone(found: dict[str, SpeedPath], best: str) -> None:
    """Refuse a record in which impacts of another part at another speed fit as well."""
    own = found[best]
    for name, path in found.items():
        ratio = float(np.median(np.interp(own.time, path.time, path.frequency) / own.frequency))
        level = (path.score - path.chance) / max(own.score - own.chance, 1e-300)
        if abs(ratio - 1.0) > OTHER and level > ALIKE and path.score > path.chance + SPREADS * path.spread:
            spans = [
                f"{f'impacts of {part}' if part else 'shaft orders'} from "
                f"{60.0 * one.frequency.min():.4g} to {60.0 * one.frequency.max():.4g} rpm"
                for part, one in ((best, own), (name, path))
            ]
            raise SignalError(
                f"speed: {' and '.join(spans)} fit equally well; give a narrower range, --tacho or --angle"
            )


def finer_path(motor: MotorPath, rate: float) -> MotorPath:
    """Second search over the angle of the first path, in longer frames, by shaft orders or impacts alone.

    Parameters
    ----------
    motor
        Path of `motor_path`.
    rate
        Sample rate [Hz].

    Raises
    ------
    SignalError
        If neither shaft orders nor impacts are visible, or impacts alone lead to a limit of the range.

    Notes
    -----
    Lines of a speed that varies are wider than the resolution of a frame; over the angle they are not [1]_.
    Valid if the first path is within 6 % of the speed.

    References
    ----------
    .. [1] K. R. Fyfe, E. D. S. Munck, Analysis of computed order tracking, Mechanical Systems and Signal
       Processing 11(2), 1997, 187-205.
    """
    both, path, combs, part = motor.signals, motor.path, motor.combs, motor.impacts
    clock = np.arange(both[0].size) / rate
    speed = np.interp(clock, path.time, path.frequency)
    turned = np.r_[0.0, np.cumsum(0.5 * (speed[1:] + speed[:-1]))] / rate
    over = [resample_over_angle(x, 2.0 * np.pi * turned) for x in both]
    per_turn, values = over[0].samples_per_revolution, [one.values for one in over]
    half = len(both) // 2
    shafts, impacts = combs[0], combs[-1]
    limits = 1.0 - NEAR, 1.0 + NEAR
    lengths = [round(turns * per_turn) for turns in SECOND_TURNS]
    lengths = [n for n in lengths if FRAMES * n <= values[0].size] or [values[0].size // FRAMES]

    def clearest(signals: Sequence[Array], comb: Comb) -> SpeedPath:
        """Path in frames of the length with which it is clearest."""
        return max((speed_path(signals, per_turn, comb, limits, n) for n in lengths), key=lambda p: p.gain)

    finer = clearest(values[:half], shafts)
    orders = _visible(values[:half], per_turn, shafts, finer)
    by_shaft = bool(orders) and finer.score > finer.chance + SPREADS * finer.spread
    if not by_shaft and part:
        orders, finer = (), clearest(values[half:], impacts)
    agree = part if part and level_along(values[half:], per_turn, impacts, finer) > CLEAR else ""
    if not by_shaft and not agree:
        raise SignalError(
            "speed: neither shaft orders nor impacts of a bearing are visible along the clearest path; check "
            "the range, or give --tacho or --angle"
        )
    at = np.interp(path.time, clock, turned)
    frequency = path.frequency * np.interp(at, finer.time, finer.frequency)
    top = max(orders, default=float(impacts.orders.max(initial=shafts.lowest)))
    tolerance = finer.resolution / (2.0 * top) + (0.0 if by_shaft else SLIP)
    if not by_shaft and path.at_limit > HELD:
        raise SignalError(
            f"speed: no shaft orders are visible, and by impacts it is at a limit of the range in "
            f"{100.0 * path.at_limit:.0f} % of the record (limit {100.0 * HELD:.0f} %); give a wider range, "
            "--tacho or --angle"
        )
    return MotorPath(replace(path, frequency=frequency), both, combs, agree, orders, tolerance)


def _visible(signals: Sequence[Array], rate: float, comb: Comb, path: SpeedPath) -> tuple[float, ...]:
    """Orders of a comb that are above chance along a path."""
    least = VISIBLE / np.sqrt(0.5 * path.time.size * len(signals))
    alone = {float(order): Comb(np.array([order]), np.empty(0), comb.lowest) for order in comb.orders}
    return tuple(order for order, one in alone.items() if level_along(signals, rate, one, path) > least)


def _shaft_comb(parts: TurningParts) -> Comb:
    """Orders of all shafts, with the reciprocals of their numbers as weights."""
    shafts = sorted({float(shaft.order) for shaft in parts.shafts})
    weights: dict[float, float] = {}
    for order in shafts:
        for k in range(1, SHAFT_HARMONICS + 1):
            weights[k * order] = max(weights.get(k * order, 0.0), 1.0 / k)
    own = np.array(sorted(weights))
    between = {part * order for order in shafts for part in BETWEEN}
    against = [b for b in sorted(between) if np.abs(own / b - 1.0).min() > 0.02]
    return Comb(own, np.array(against), min(shafts), np.array([weights[order] for order in own]))


def impact_combs(parts: TurningParts, highest: float) -> dict[str, Comb]:
    """Lines of the envelope of impacts of each ring and rolling element up to an order, by name.

    Bearings with equal orders are one, by the name of the first.

    Parameters
    ----------
    parts
        Shafts and bearings.
    highest
        Highest order of the record [-].

    Notes
    -----
    Harmonics of the fault orders [1]_, with the reciprocals of their numbers as weights. Cages are omitted,
    of whose lines too few are in a frame. Valid for given orders, without slip.

    References
    ----------
    .. [1] R. B. Randall, J. Antoni, Rolling element bearing diagnostics - a tutorial, Mechanical Systems and
       Signal Processing 25(2), 2011, 485-520.
    """
    found: dict[str, Comb] = {}
    for bearing in parts.bearings:
        for part, order in bearing.orders.items():
            if part != "cage":  # of its lines too few are in a frame
                k = np.arange(1.0, IMPACT_HARMONICS + 1.0)
                if all(abs(order / one.lowest - 1.0) > SAME for one in found.values()):
                    found[f"{part} of {bearing.name}"] = Comb(k * order, BETWEEN * order, order, 1.0 / k)
    return {name: _covered(comb, highest) for name, comb in found.items() if comb.lowest < highest}


def _covered(comb: Comb, highest: float) -> Comb:
    """Lines up to the highest order of the record."""
    kept = comb.orders < highest
    against = comb.against[comb.against < highest]
    return Comb(
        comb.orders[kept], against, comb.lowest, comb.weights[kept] if comb.weights.size else comb.weights
    )
