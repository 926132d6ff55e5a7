# SPDX-License-Identifier: Apache-2.0
"""Evidence of damage on one shaft in an order spectrum: comb, lowest orders, sidebands.

A local fault causes one impact per revolution and raises all orders of its shaft. Eccentricity, a bent shaft
or unbalance vary slowly over the revolution and raise a few low orders and a few sidebands of mesh lines.
Points between the orders are the reference of both tests. If the ratio of two shafts is a whole number, all
orders of the faster shaft are orders of the slower one too: the other orders of the slower shaft are then an
additional reference.

Source: van Elteren (1960) for the rank sum within blocks.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.line_tests import (
    BLOCK,
    FineSpectrum,
    comb_score,
    line_probability,
    neighbours,
)
from pitchpoint.analysis.sampled import Array
from pitchpoint.analysis.turning_parts import Shaft, TurningParts

MIN_TURNS = 3.0
"""Minimum number of shaft revolutions for points between the orders that are free of leakage."""
RESOLVED = 8.0
"""Minimum number of revolutions of another shaft whose orders are single lines that can be omitted."""
FROM_MESH = 2
"""Orders next to a mesh line that are not part of a comb."""
MAX_ORDERS = 6000
MIN_LINES = 6
"""Minimum number of comb lines for a rank test."""
SMALLEST_COMB, SMALLEST_LINE, SMALLEST_SIDEBAND = 1e-4, 1e-2, 3e-2
"""Minimum amplitudes that are reported: of a comb and of a line over the RMS of the signal, of a sideband
also over its mesh line. Every machine has smaller lines, and simulations without noise show them."""
FOLDED = 40
"""Number of mesh harmonics whose alias images are omitted, for records without an anti-aliasing filter."""
NEIGHBOURS, MIN_NEIGHBOURS = 16, 6
SIDEBANDS, HARMONICS, LOW_ORDERS, BANDS = 3, 5, 3, 6
PASSES, SLIP = 3, 0.01
"""Maximum sideband number of ball passages, of one or several bearings, around mesh lines of healthy
machines; maximum relative slip."""
TOGETHER = 3
"""Maximum number of types of bearings whose passages are combined."""
OFF = 0.5
"""Maximum distance of the maximum of a line from its order, in lines of the record."""


@dataclass(frozen=True)
class Measured:
    """Result of a single test, before correction for the number of all tests.

    Attributes
    ----------
    score
        Normal score of a comb, or power of a line over its reference [-].
    probability
        Probability that noise alone reaches this score [-].
    order
        Order of the strongest line [-]; the middle of the best band of a comb.
    amplitude
        Amplitude of the line, or of the whole comb above the noise, in the unit of the signal.
    lines
        Number of lines tested [-].
    sideband
        Number of the sideband, 0 if it is not a sideband [-].
    choices
        Number of bands of a comb from which the best was chosen [-].
    rule
        Why the test is not significant at any score, such as a line below 1 % of the rms; empty for none.
    """

    score: float
    probability: float
    order: float
    amplitude: float
    lines: int
    sideband: int = 0
    choices: int = 1
    rule: str = ""


class ShaftView:
    """Orders of one shaft in a spectrum, and points between them that are free of known lines.

    Parameters
    ----------
    spectrum
        Spectrum over orders of the reference shaft.
    parts
        Rotating parts of the machine.
    shaft
        The shaft.
    rms
        RMS of the signal.
    sampled
        Samples per revolution of the reference shaft in the original record [-].
    """

    def __init__(
        self, spectrum: FineSpectrum, parts: TurningParts, shaft: Shaft, rms: float, sampled: float
    ) -> None:
        self.spectrum, self.parts, self.shaft, self.rms, self.sampled = spectrum, parts, shaft, rms, sampled
        self.folded = _images(parts, sampled)
        self.passing = passing_balls(parts, spectrum.highest, harmonics=HARMONICS)
        self.order = float(shaft.order)
        self.turns = self.order / spectrum.resolution
        top = 0.9 * spectrum.highest
        self.highest = int(min(top / self.order, MAX_ORDERS))
        self.slower = [
            other
            for other in parts.shafts
            if other.order < shaft.order
            and (shaft.order / other.order).denominator == 1
            and float(other.order) / spectrum.resolution >= MIN_TURNS
        ]
        self.measures = [self._between(), *(self._orders_of(other) for other in self.slower)]

    @property
    def testable(self) -> bool:
        """Whether the record has enough revolutions."""
        return self.turns >= MIN_TURNS and self.highest >= 1

    def free(self, order: NDArray[Any]) -> NDArray[np.bool_]:
        """Mask of orders, shape (n,), that are separate from mesh lines and orders of other shafts."""
        line = self.spectrum.resolution
        apart = order > 2.0 * line
        for mesh in self.parts.meshes:
            apart &= _distance(order, self.parts.mesh_order(mesh)) > 2.0 * line
        for other in self.parts.shafts:
            step = float(other.order)
            if other is self.shaft or other in self.slower or step / line < RESOLVED:
                continue
            apart &= _distance(order, step) > 1.5 * line
        if self.folded.size:
            at = np.searchsorted(self.folded, order)
            near = [np.abs(order - self.folded[np.clip(at + k, 0, self.folded.size - 1)]) for k in (-1, 0)]
            apart &= np.minimum(*near) > 2.5 * line
        return apart

    def comb(self, without: int = 0) -> Measured:
        """Test whether the orders exceed the points between them, away from mesh lines and sidebands.

        Multiples of `without` are omitted, if given.
        """
        number = np.arange(1, self.highest + 1)
        keep = self.free(number * self.order)
        for mesh, teeth in self.parts.gears_of(self.shaft.name).values():
            if teeth >= 4 * FROM_MESH and mesh:
                keep &= _distance(number.astype(np.float64), float(teeth)) > FROM_MESH
        if without:
            keep &= number % without != 0
        number = number[keep & (number > LOW_ORDERS)]
        if number.size < MIN_LINES:
            return Measured(0.0, 1.0, self.order, 0.0, 0)
        power = self.spectrum.power(number * self.order)
        worst = None
        for place, level in self.measures:
            found = _best_band(number, power, place / self.order, level)
            worst = found if worst is None or found.probability > worst.probability else worst
        assert worst is not None
        small = worst.amplitude < SMALLEST_COMB * self.rms
        return replace(
            worst,
            probability=1.0 if small else worst.probability,
            order=worst.order * self.order,
            rule=f"below {100.0 * SMALLEST_COMB:g} % of the rms" if small else "",
        )

    def lines(self, orders: NDArray[Any], sideband: NDArray[Any], least: Array | None = None) -> Measured:
        """Test of the least probable of several lines, shape (n,); lines near known ones are omitted."""
        limits = np.zeros(orders.size) if least is None else least
        best, looked = None, 0
        for place, number, limit in zip(orders, sideband, limits, strict=True):
            if not 0.0 < place < 0.9 * self.spectrum.highest or not self.free(np.array([place]))[0]:
                continue
            one = None if self._passed(float(place)) else self.line(float(place))
            if one is None:
                continue
            looked += 1
            if one.amplitude < limit:
                one = replace(
                    one, probability=1.0, rule=f"below {100.0 * SMALLEST_SIDEBAND:g} % of its mesh line"
                )
            elif not one.rule and not self.has_top_at(float(place)):
                one = replace(one, probability=1.0, rule="slope of another line")
            if best is None or one.probability < best[0].probability:
                best = one, int(number)
        if best is None:
            return Measured(0.0, 1.0, float(orders[0]) if orders.size else self.order, 0.0, 0)
        one, number = best
        some = float(-np.expm1(looked * np.log1p(-min(one.probability, 1.0 - 1e-16))))
        return replace(one, probability=some, lines=looked, sideband=number)

    def line(self, order: float) -> Measured | None:
        """Test of one line against the higher of both sides; None without enough neighbours."""
        power = float(self.spectrum.power(order))
        probability, score = 0.0, np.inf
        for place, level in self.measures:
            for side in neighbours(level, place, order, NEIGHBOURS):
                if side.size < MIN_NEIGHBOURS:
                    return None
                rank = (3 * side.size) // 4
                base = float(np.sort(side)[rank - 1])
                ratio = power / base if base > 0.0 else np.inf
                found = line_probability(min(ratio, 1e30), side.size, rank)
                if found >= probability:
                    probability, score = found, ratio
        amplitude = float(np.sqrt(power))
        small = amplitude < SMALLEST_LINE * self.rms
        rule = f"below {100.0 * SMALLEST_LINE:g} % of the rms" if small else ""
        return Measured(score, 1.0 if small else probability, order, amplitude, 1, rule=rule)

    def _passed(self, order: float) -> bool:
        """Whether an order may be due to ball passage, within the resolution of the record."""
        off = np.abs(self.passing[:, 0] - order)
        return bool(np.any(off < self.passing[:, 1] + 2.0 * self.spectrum.resolution))

    def has_top_at(self, order: float) -> bool:
        """Whether there is a line at an order, and not the slope of an adjacent line."""
        spectrum = self.spectrum
        reach = int(round(1.25 * spectrum.resolution / spectrum.step))
        off = np.arange(-reach, reach + 1)
        top = int(np.argmax(spectrum.power(order + off * spectrum.step)))
        return bool(abs(off[top]) * spectrum.step <= (OFF + 0.01) * spectrum.resolution)

    def low_orders(self) -> Measured:
        """Test of the first orders of the shaft."""
        number = np.arange(1, LOW_ORDERS + 1)
        return self.lines(number * self.order, np.zeros(number.size))

    def sidebands(self, mesh_order: float, teeth: int) -> Measured:
        """Test of the sidebands of the mesh harmonics at multiples of the shaft order."""
        most = max(1, min(SIDEBANDS, (teeth - 1) // 2))
        offset = np.concatenate([np.arange(-most, 0), np.arange(1, most + 1)])
        harmonic = np.arange(1, HARMONICS + 1)
        orders = harmonic[:, None] * mesh_order + offset[None, :] * self.order
        mesh = np.sqrt(self.spectrum.power(harmonic * mesh_order))
        least = SMALLEST_SIDEBAND * np.repeat(mesh, offset.size)
        return self.lines(orders.ravel(), np.tile(offset, HARMONICS), least)

    def _between(self) -> tuple[Array, Array]:
        """Points between the orders, at least two lines from each."""
        count = int(min(8, max(1, np.floor(self.turns / 2.0) - 1)))
        part = np.arange(1, count + 1) / (count + 1)
        place = ((np.arange(self.highest + 1)[:, None] + part[None, :]) * self.order).ravel()
        place = place[self.free(place)]
        return place, self.spectrum.power(place)

    def _orders_of(self, other: Shaft) -> tuple[Array, Array]:
        """Orders of a slower shaft that are not orders of this one."""
        times = int(self.shaft.order / other.order)
        number = np.arange(1, self.highest * times + 1)
        place = number[number % times != 0] * float(other.order)
        place = place[self.free(place)]
        return place, self.spectrum.power(place)


def _distance(place: Array, step: float) -> Array:
    """Distance to the nearest positive multiple of a step."""
    distance: Array = np.abs(place - np.maximum(np.rint(place / step), 1.0) * step)
    return distance


def _images(parts: TurningParts, sampled: float) -> Array:
    """Orders of the alias images of mesh harmonics above half the sample rate."""
    found = []
    for mesh in parts.meshes:
        harmonic = parts.mesh_order(mesh) * np.arange(1, FOLDED + 1)
        harmonic = harmonic[harmonic > 0.5 * sampled]
        found.append(np.abs(harmonic - np.rint(harmonic / sampled) * sampled))
    return np.sort(np.concatenate(found)) if found else np.empty(0)


def passing_balls(parts: TurningParts, highest: float, *, harmonics: int | None = None) -> Array:
    """Orders of lines due to ball passage in healthy bearings.

    Parameters
    ----------
    parts
        Rotating parts of the machine.
    highest
        Highest order [-].
    harmonics
        Number of harmonics of each mesh whose sidebands are included [-]; default all.

    Returns
    -------
    ndarray
        Shape (n, 2). Orders, and their uncertainty due to the slip of the rolling elements [-].

    Notes
    -----
    A bearing is slightly stiffer with a ball below the load than between two balls: it vibrates and modulates
    all meshes at the ball pass order of the outer ring [1]_. Combinations of several bearings are included
    for at most three types (with more, no order would be free). Up to three passages and 1 % slip. Valid for
    bearings with a load of fixed direction.

    References
    ----------
    .. [1] C. S. Sunnersjö, Varying compliance vibrations of rolling bearings, Journal of Sound and Vibration
       58(3), 1978, 363-373.

    Examples
    --------
    >>> from pitchpoint.analysis.turning_parts import Bearing, train_parts
    >>> parts = train_parts([(21, 40)], [Bearing("left", {"outer ring": 3.5})])
    >>> passing_balls(parts, 22.0)[:, 0].tolist()
    [3.5, 7.0, 10.5, 10.5, 14.0, 17.5]
    """
    off, slip = passages(parts)
    if not off.size:
        return np.empty((0, 2))
    middle = {0.0}
    for step in (parts.mesh_order(mesh) for mesh in parts.meshes):
        last = int(highest / step) if harmonics is None else harmonics
        middle |= {step * k for k in range(1, last + 1)}
    place = np.add.outer(sorted(middle), off).ravel()
    found = np.c_[place, np.tile(slip, len(middle))]
    found = found[(place > 0.0) & (place < highest)]
    return np.asarray(found[np.argsort(found[:, 0])], dtype=np.float64)


def passages(parts: TurningParts) -> tuple[Array, Array]:
    """Offsets of ball passage sidebands from a line, and their uncertainty due to slip, shape (n,) [-]."""
    rates = sorted({b.orders["outer ring"] for b in parts.bearings if "outer ring" in b.orders})
    if not rates:
        return np.empty(0), np.empty(0)
    if len(rates) <= TOGETHER:
        times = product(range(-PASSES, PASSES + 1), repeat=len(rates))
        many = np.array([m for m in times if 0 < np.abs(m).sum() <= PASSES], dtype=np.float64)
    else:
        each = np.eye(len(rates))
        many = np.concatenate([k * each for k in range(-PASSES, PASSES + 1) if k])
    return np.asarray(many @ rates), np.asarray(SLIP * (np.abs(many) @ rates))


def _best_band(number: NDArray[Any], power: Array, between: Array, level: Array) -> Measured:
    """Most significant band of the comb, with the probability corrected for the choice of the band."""
    from scipy.stats import norm

    block, block_between = number // BLOCK, np.floor(between / BLOCK)
    edges = np.linspace(0, int(number[-1]) // BLOCK + 1, BANDS + 1).round()
    bands = [(0.0, edges[-1])]
    if edges[-1] >= 2 * BANDS:
        bands += [(float(a), float(b)) for a, b in zip(edges[:-1], edges[1:], strict=True)]
    best = Measured(0.0, 1.0, float(number[0]), 0.0, 0)
    for low, high in bands:
        mine, theirs = (block >= low) & (block < high), (block_between >= low) & (block_between < high)
        if not mine.any() or not theirs.any():
            continue
        score = comb_score(power[mine], level[theirs], block[mine], block_between[theirs])
        probability = float(norm.sf(score))
        if probability < best.probability:
            # medians are insensitive to single lines from other sources
            above = float(np.median(power[mine]) - np.median(level[theirs])) / np.log(2.0)
            amplitude = float(np.sqrt(max(above, 0.0) * mine.sum()))
            best = Measured(score, probability, float(number[mine].mean()), amplitude, int(mine.sum()))
    some = float(-np.expm1(len(bands) * np.log1p(-min(best.probability, 1.0 - 1e-16))))
    return replace(best, probability=some, choices=len(bands))
