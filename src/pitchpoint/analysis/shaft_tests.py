# SPDX-License-Identifier: Apache-2.0
"""Evidence for damage on one shaft in one spectrum over its orders: comb, lowest orders, sidebands.

A local fault strikes once per turn: it raises all orders of its shaft. What is out of true (eccentric, bent,
out of balance) changes slowly over the turn: it raises few orders and few sidebands of mesh lines. Points
between the orders are the measure of both. With a whole ratio of shafts, all orders of the faster one are
orders of the slower one too: the measure then also is the other orders of that one.

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

FEWEST_TURNS = 3.0
"""Turns of a shaft from which points between its orders see nothing of the orders themselves."""
RESOLVED = 8.0
"""Turns of another shaft from which its orders are single lines that can be omitted."""
MOST_ORDERS = 6000
FEWEST_LINES = 6
"""Lines of a comb from which on their ranks are conclusive."""
SMALLEST_COMB, SMALLEST_LINE, SMALLEST_SIDEBAND = 1e-4, 1e-2, 3e-2
"""Amplitudes below which nothing is reported: of a comb and of a line as a part of the rms of the "
"signal, of a sideband
as a part of its mesh line as well. Every machine has such lines, and simulations without noise show them."""
FOLDED = 40
"""Harmonics of a mesh whose images are omitted where the record was sampled without a filter."""
NEIGHBOURS, FEWEST_NEIGHBOURS = 16, 6
SIDEBANDS, HARMONICS, LOW_ORDERS, BANDS = 3, 5, 3, 6
PASSES, SLIP = 3, 0.01
"""Passages of balls, of one bearing or of several, that appear next to mesh lines of healthy machines; how
far they slip, as a part of their order."""
TOGETHER = 3
"""Kinds of bearings whose passages are combined."""
OFF = 0.5
"""How far the top of a line may be from an order that it belongs to, in lines of the record."""


@dataclass(frozen=True)
class Measured:
    """Outcome of a test before it is set against the number of all tests.

    Attributes
    ----------
    score
        Normal score of a comb, or power over that next to a line [-].
    probability
        Probability that noise alone does as much [-].
    order
        Order of the strongest line [-]; the middle of the best band of a comb.
    amplitude
        Amplitude of the line, or of the whole comb above the noise, in the unit of the signal.
    lines
        Lines that were looked at [-].
    sideband
        Number of the sideband, 0 for others [-].
    choices
        Bands of a comb of which the best one was taken [-].
    """

    score: float
    probability: float
    order: float
    amplitude: float
    lines: int
    sideband: int = 0
    choices: int = 1


class ShaftView:
    """Orders of one shaft in a spectrum, and the points between that are free of everything known.

    Parameters
    ----------
    spectrum
        Spectrum over orders of the reference shaft.
    parts
        All that turns.
    shaft
        The shaft.
    rms
        Rms of the signal.
    sampled
        Samples in one turn of the reference shaft with which the record was taken [-].
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
        self.highest = int(min(top / self.order, MOST_ORDERS))
        self.slower = [
            other
            for other in parts.shafts
            if other.order < shaft.order
            and (shaft.order / other.order).denominator == 1
            and float(other.order) / spectrum.resolution >= FEWEST_TURNS
        ]
        self.measures = [self._between(), *(self._orders_of(other) for other in self.slower)]

    @property
    def testable(self) -> bool:
        """Whether the record holds enough turns."""
        return self.turns >= FEWEST_TURNS and self.highest >= 1

    def free(self, order: NDArray[Any]) -> NDArray[np.bool_]:
        """Whether orders, shape (n,), are separate from mesh lines and from orders of other shafts."""
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

    def comb(self, from_mesh: int = 2, *, without: int = 0) -> Measured:
        """Whether the orders are above what is between them, away from mesh lines and their sidebands.

        Multiples of `without` may be omitted.
        """
        number = np.arange(1, self.highest + 1)
        keep = self.free(number * self.order)
        for mesh, teeth in self.parts.gears_of(self.shaft.name).values():
            if teeth >= 4 * from_mesh and mesh:
                keep &= _distance(number.astype(np.float64), float(teeth)) > from_mesh
        if without:
            keep &= number % without != 0
        number = number[keep & (number > LOW_ORDERS)]
        if number.size < FEWEST_LINES:
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
        )

    def lines(self, orders: NDArray[Any], sideband: NDArray[Any], least: Array | None = None) -> Measured:
        """The least likely of some lines, shape (n,); lines near others are omitted."""
        limits = np.zeros(orders.size) if least is None else least
        best, looked = None, 0
        for place, number, limit in zip(orders, sideband, limits, strict=True):
            if not 0.0 < place < 0.9 * self.spectrum.highest or not self.free(np.array([place]))[0]:
                continue
            one = None if self._passed(float(place)) else self.line(float(place))
            if one is None:
                continue
            looked += 1
            if one.amplitude < limit or not self.has_top_at(float(place)):
                one = replace(one, probability=1.0)
            if best is None or one.probability < best[0].probability:
                best = one, int(number)
        if best is None:
            return Measured(0.0, 1.0, float(orders[0]) if orders.size else self.order, 0.0, 0)
        one, number = best
        some = float(-np.expm1(looked * np.log1p(-min(one.probability, 1.0 - 1e-16))))
        return Measured(one.score, some, one.order, one.amplitude, looked, number)

    def line(self, order: float) -> Measured | None:
        """One line against the higher one of both sides; None without enough neighbours."""
        power = float(self.spectrum.power(order))
        probability, score = 0.0, np.inf
        for place, level in self.measures:
            for side in neighbours(level, place, order, NEIGHBOURS):
                if side.size < FEWEST_NEIGHBOURS:
                    return None
                rank = (3 * side.size) // 4
                base = float(np.sort(side)[rank - 1])
                ratio = power / base if base > 0.0 else np.inf
                found = line_probability(min(ratio, 1e30), side.size, rank)
                if found >= probability:
                    probability, score = found, ratio
        amplitude = float(np.sqrt(power))
        if amplitude < SMALLEST_LINE * self.rms:
            probability = 1.0
        return Measured(score, probability, order, amplitude, 1)

    def _passed(self, order: float) -> bool:
        """Whether balls that pass may show there, within what the record resolves."""
        off = np.abs(self.passing[:, 0] - order)
        return bool(np.any(off < self.passing[:, 1] + 2.0 * self.spectrum.resolution))

    def has_top_at(self, order: float) -> bool:
        """Whether what is seen at an order is a line there, and not the skirt of one next to it."""
        spectrum = self.spectrum
        reach = int(round(1.25 * spectrum.resolution / spectrum.step))
        off = np.arange(-reach, reach + 1)
        top = int(np.argmax(spectrum.power(order + off * spectrum.step)))
        return bool(abs(off[top]) * spectrum.step <= (OFF + 0.01) * spectrum.resolution)

    def low_orders(self) -> Measured:
        """The first orders of the shaft."""
        number = np.arange(1, LOW_ORDERS + 1)
        return self.lines(number * self.order, np.zeros(number.size))

    def sidebands(self, mesh_order: float, teeth: int) -> Measured:
        """Sidebands of the mesh harmonics at multiples of the turns of the shaft."""
        most = max(1, min(SIDEBANDS, (teeth - 1) // 2))
        offset = np.concatenate([np.arange(-most, 0), np.arange(1, most + 1)])
        harmonic = np.arange(1, HARMONICS + 1)
        orders = harmonic[:, None] * mesh_order + offset[None, :] * self.order
        mesh = np.sqrt(self.spectrum.power(harmonic * mesh_order))
        least = SMALLEST_SIDEBAND * np.repeat(mesh, offset.size)
        return self.lines(orders.ravel(), np.tile(offset, HARMONICS), least)

    def _between(self) -> tuple[Array, Array]:
        """Points between the orders: two lines or more from each of them."""
        count = int(min(8, max(1, np.floor(self.turns / 2.0) - 1)))
        part = np.arange(1, count + 1) / (count + 1)
        place = ((np.arange(self.highest + 1)[:, None] + part[None, :]) * self.order).ravel()
        place = place[self.free(place)]
        return place, self.spectrum.power(place)

    def _orders_of(self, other: Shaft) -> tuple[Array, Array]:
        """Orders of a slower shaft that are none of this one."""
        times = int(self.shaft.order / other.order)
        number = np.arange(1, self.highest * times + 1)
        place = number[number % times != 0] * float(other.order)
        place = place[self.free(place)]
        return place, self.spectrum.power(place)


def _distance(place: Array, step: float) -> Array:
    """Distance to the next multiple of a step from one on."""
    distance: Array = np.abs(place - np.maximum(np.rint(place / step), 1.0) * step)
    return distance


def _images(parts: TurningParts, sampled: float) -> Array:
    """Orders at which harmonics of meshes above half the sampling rate come out if nothing held them back."""
    found = []
    for mesh in parts.meshes:
        harmonic = parts.mesh_order(mesh) * np.arange(1, FOLDED + 1)
        harmonic = harmonic[harmonic > 0.5 * sampled]
        found.append(np.abs(harmonic - np.rint(harmonic / sampled) * sampled))
    return np.sort(np.concatenate(found)) if found else np.empty(0)


def passing_balls(parts: TurningParts, highest: float, *, harmonics: int | None = None) -> Array:
    """Orders at which balls that pass under the load of healthy bearings may show.

    Parameters
    ----------
    parts
        What turns.
    highest
        Highest order [-].
    harmonics
        Harmonics of each mesh around which they are searched [-]; all if omitted.

    Returns
    -------
    ndarray
        Shape (n, 2). Orders, and how far about them the slip of the rolling elements may take them [-].

    Notes
    -----
    A bearing is a little stiffer with a ball below the load than between two: it shakes, and modulates all
    meshes, as often as balls pass the outer ring [1]_; several bearings do so together, which counts where
    there are at most three kinds (with more, no order would be free). Up to three passages and 1 % of slip.
    Valid for bearings whose load is at rest.

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
    """Distances of what passing balls put next to a line, and how far slip may take it, shape (n,) [-]."""
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
    """The band of the comb that stands out most; probability of the best one of all bands."""
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
            # medians: single lines that come from elsewhere are not part of the comb
            above = float(np.median(power[mine]) - np.median(level[theirs])) / np.log(2.0)
            amplitude = float(np.sqrt(max(above, 0.0) * mine.sum()))
            best = Measured(score, probability, float(number[mine].mean()), amplitude, int(mine.sum()))
    some = float(-np.expm1(len(bands) * np.log1p(-min(best.probability, 1.0 - 1e-16))))
    return replace(best, probability=some, choices=len(bands))
