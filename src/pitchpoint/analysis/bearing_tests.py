# SPDX-License-Identifier: Apache-2.0
"""Evidence of rolling bearing damage: envelope lines at the orders of the bearing parts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.bearing_signals import envelope_band, whitened, without_healthy_lines
from pitchpoint.analysis.envelope import band_envelope
from pitchpoint.analysis.line_tests import FineSpectrum, fine_spectrum, line_probability, neighbours
from pitchpoint.analysis.remarks import Note
from pitchpoint.analysis.sampled import Array
from pitchpoint.analysis.shaft_tests import (
    MIN_NEIGHBOURS,
    NEIGHBOURS,
    OFF,
    RESOLVED,
    SLIP,
    Measured,
    ShaftView,
)
from pitchpoint.analysis.tones import without_tones
from pitchpoint.analysis.turning_parts import Bearing, Shaft, TurningParts

HARMONICS = 3
IMPACTS = 0.01
"""Probability that an envelope formed by a few lines of the signal is taken for impacts, over all bearing
parts and both tests of each."""
ORDERS = 8
"""Number of orders of a shaft on either side of a line whose width is compared."""
WIDE = 1.4
"""Ratio of the levels next to orders and in the noise around above which orders are wide; noise exceeds it in
5 % of cases (quantiles of 17 and of twice 16 exponentially distributed powers)."""
MIN_EVENTS = 16.0
NOTHING = 1e-9
"""Share of a signal below which a residual is round-off."""
MIN_SAMPLES = 1024

FROM_SHAFTS = "{} cannot be distinguished from shaft orders: the record does not resolve their harmonics"
FROM_MESHES = (
    "{}: envelope lines that are due to a few lines of the signal: typical of meshes modulated by ball "
    "passage, not of impacts"
)

Row = tuple[str, str, Measured]


class BearingView:
    """Envelopes of one channel that are tested for bearing damage.

    Parameters
    ----------
    values
        Signal over the angle of the reference shaft, shape (n,), any unit.
    samples_per_turn
        Samples per revolution of the reference shaft [-].
    parts
        Rotating parts of the machine.
    slip
        Maximum relative deviation of the orders [-].
    """

    def __init__(
        self, values: Array, samples_per_turn: float, parts: TurningParts, slip: float = SLIP
    ) -> None:
        self.samples_per_turn, self.parts, self.slip = samples_per_turn, parts, slip
        x = without_healthy_lines(values, samples_per_turn, parts)
        self.empty = float(x.std()) <= NOTHING * float(np.std(values))
        low, high = (0.0, 0.0) if self.empty else envelope_band(x, samples_per_turn, parts)
        self.signals = [values]
        if not self.empty:
            self.signals += [
                band_envelope(y, samples_per_turn, band=(low, high)).envelope ** 2
                for y in (x, whitened(values))
            ]
        self.spectra = [fine_spectrum(y, samples_per_turn) for y in self.signals]
        # the envelope has no content above the width of its band, and little close to it
        self.impacts = IMPACTS / (2 * max(sum(len(b.orders) for b in alike(parts.bearings)), 1))
        self.end = min(self.spectra[0].highest, 0.8 * (high - low))

    def part(self, order: float, known: Sequence[Array] = ()) -> tuple[Measured, bool]:
        """Test of a part, and whether its lines may be due to impacts; known lines are removed first.

        `known` holds orders, shapes (n,), of the signal, of its envelope and of that of the whitened signal.
        """
        lines, envelope, white = self._without(known) if known else self.spectra
        found = _part(envelope, order, self.parts, self.end, self.slip)
        if found.probability >= IMPACTS:
            return found, True
        impacts = _part(white, order, self.parts, self.end, self.slip).probability
        if min(impacts, _comb(lines, order, self.parts, self.samples_per_turn)) > self.impacts:
            return replace(found, probability=1.0), False
        return found, True

    def resolves(self, order: float) -> bool:
        """Whether at least two harmonics of a part are resolved from the orders of all shafts."""
        harmonic = order * np.arange(1.0, HARMONICS + 1)
        return int(np.sum(_free(harmonic, self.spectra[0], self.parts))) >= 2

    def _without(self, known: Sequence[Array]) -> list[FineSpectrum]:
        rate = self.samples_per_turn
        pairs = zip(self.signals, known, strict=True)
        return [fine_spectrum(without_tones(x, rate, lines), rate) for x, lines in pairs]


def bearing_evidence(
    values: Array, samples_per_turn: float, parts: TurningParts, slip: float = SLIP
) -> tuple[list[Row], list[Note], BearingView | None]:
    """Test all bearing parts for lines in the spectrum of the squared envelope.

    Parameters
    ----------
    values
        Signal over the angle of the reference shaft, shape (n,), any unit.
    samples_per_turn
        Samples per revolution of the reference shaft [-].
    parts
        Rotating parts of the machine.
    slip
        Maximum relative deviation of the orders [-].

    Returns
    -------
    list of tuples
        Bearing, part, test.
    list of Note
        Remarks on parts that were not tested or not resolved.
    BearingView or None
        Envelopes, if there are any.

    Notes
    -----
    Lines of a healthy machine are removed; the band is that of the most significant kurtosis [1]_. Its
    squared envelope is searched within the slip of each order [2]_: two of the first three
    harmonics must exceed the noise and be due to impacts. Shaft orders are omitted. Equal bearings on one
    shaft are treated as one. Valid for many events per record.

    References
    ----------
    .. [1] J. Antoni, Fast computation of the kurtogram for the detection of transient faults, Mechanical
       Systems and Signal Processing 21(1), 2007, 108-124.
    .. [2] R. B. Randall, J. Antoni, Rolling element bearing diagnostics - a tutorial, Mechanical Systems and
       Signal Processing 25(2), 2011, 485-520.

    Examples
    --------
    >>> from pitchpoint.analysis.turning_parts import Bearing, train_parts
    >>> parts = train_parts([(21, 40)], [Bearing("left", {"outer ring": 3.57})])
    >>> turned = np.arange(50_000) / 500.0
    >>> noise = np.random.default_rng(1).standard_normal(turned.size)
    >>> since = turned * 3.57 % 1
    >>> knock = np.exp(-20 * since) * np.sin(2 * np.pi * 42 * since)
    >>> rows, _, _ = bearing_evidence(2 * knock + 0.3 * noise, 500.0, parts)
    >>> rows[0][1], bool(rows[0][2].probability < 1e-6), round(rows[0][2].order / 3.57) in (1, 2, 3)
    ('outer ring', True, True)
    """
    if not parts.bearings:
        return [], [], None
    few = f"needs about {MIN_EVENTS:g}"
    if values.size < MIN_SAMPLES:
        text = f"record: {values.size} samples are too few for bearings, needs about {MIN_SAMPLES}"
        return [], [Note(text)], None
    turns = values.size / samples_per_turn
    if all(order * turns < MIN_EVENTS for bearing in parts.bearings for order in bearing.orders.values()):
        return [], [Note(f"too few events of all bearings, {few} of each")], None
    view = BearingView(values, samples_per_turn, parts, slip)
    if view.empty:
        text = "bearings not tested: lines of a healthy machine fill the spectrum of so short a record"
        return [], [Note(text)], None
    rows, remarks = [], []
    for bearing in alike(parts.bearings):
        for part, order in bearing.orders.items():
            whose = f"{part} of {bearing.name}"
            if order * turns < MIN_EVENTS:
                remarks.append(Note(f"too few events of {{}}; {few}", f"{whose} ({order * turns:.2g})"))
                continue
            if not view.resolves(order):
                remarks.append(Note(FROM_SHAFTS, whose))
            found, impacts = view.part(order)
            if not impacts:
                remarks.append(Note(FROM_MESHES, whose))
            rows.append((bearing.name, part, found))
    return rows, remarks, view


def alike(bearings: Sequence[Bearing]) -> list[Bearing]:
    """Merge bearings of equal orders into one with all their names.

    Parameters
    ----------
    bearings
        Rolling bearings.

    Notes
    -----
    Orders are equal within a relative difference of 1e-9; no record distinguishes them [1]_.

    References
    ----------
    .. [1] R. B. Randall, J. Antoni, Rolling element bearing diagnostics - a tutorial, Mechanical Systems and
       Signal Processing 25(2), 2011, 485-520.

    Examples
    --------
    >>> one, two = Bearing("a", {"cage": 0.4}), Bearing("b", {"cage": 0.4})
    >>> [bearing.name for bearing in alike([one, two, Bearing("c", {"cage": 0.41})])]
    ['a or b', 'c']
    """
    groups: dict[tuple[tuple[str, str], ...], list[Bearing]] = {}
    for bearing in bearings:
        key = tuple(sorted((part, f"{order:.9e}") for part, order in bearing.orders.items()))
        groups.setdefault(key, []).append(bearing)
    return [replace(group[0], name=" or ".join(b.name for b in group)) for group in groups.values()]


def _comb(lines: FineSpectrum, order: float, parts: TurningParts, samples_per_turn: float) -> float:
    """Probability that noise alone raises all multiples of an order, as damage without slip does."""
    shaft = Shaft("", Fraction(order).limit_denominator(10**9))
    view = ShaftView(lines, parts, shaft, 0.0, samples_per_turn)
    return view.comb().probability if view.testable else 1.0


def _part(spectrum: FineSpectrum, order: float, parts: TurningParts, end: float, slip: float) -> Measured:
    """Second least probable of the first three harmonics, with the slip that makes it least probable.

    Impacts have many harmonics. A single one may be that of another part, so that two of them must exceed the
    noise with the same slip.
    """
    slips = np.arange(-slip, slip, min(spectrum.step / (HARMONICS * order), slip))
    chance, power, ratio = (np.full((HARMONICS, slips.size), fill) for fill in (1.0, 0.0, 0.0))
    held = 0
    for k in range(1, HARMONICS + 1):
        place = k * order
        reach = max(slip * place, spectrum.resolution)
        if place + 80.0 * spectrum.resolution > end:
            break
        near = np.asarray(place * (1.0 + slips), dtype=np.float64)
        free = _free(near, spectrum, parts)
        off = reach + np.arange(2.0, 120.0, 2.0) * spectrum.resolution
        around = np.concatenate([(place - off)[::-1], place + off])
        around = around[(around > 3.0 * spectrum.resolution)]
        around = around[_free(around, spectrum, parts)]
        sides = neighbours(spectrum.power(around), around, place, NEIGHBOURS)
        if not free.any() or min(side.size for side in sides) < MIN_NEIGHBOURS:
            continue
        held += 1
        # the higher quantile of both sides, with the rank of the side with fewer points
        points = min(side.size for side in sides)
        rank = (3 * points) // 4
        base = max(float(np.sort(side)[(3 * side.size) // 4 - 1]) for side in sides)
        power[k - 1] = np.where(free & ~_skirts(near, spectrum), spectrum.power(near), 0.0)
        ratio[k - 1] = power[k - 1] / base
        chance[k - 1] = [line_probability(float(x), points, rank) for x in ratio[k - 1]]
        for shaft in parts.shafts:
            other_side, over = _next_to_orders(near, power[k - 1], float(shaft.order), base, spectrum, parts)
            chance[k - 1] = np.maximum(chance[k - 1], other_side)
            ratio[k - 1] = np.minimum(ratio[k - 1], over)
    if held < 2:
        return Measured(0.0, 1.0, order, 0.0, 0)
    second = np.sort(chance, axis=0)[1]
    best = int(np.argmin(second))
    p = float(second[best])
    # distribution of the second smallest of n uniform probabilities
    both = min(1.0, p**2 if held == 2 else 3.0 * p**2 - 2.0 * p**3)
    k = int(np.argsort(chance[:, best], kind="stable")[1])
    some = float(-np.expm1(slips.size * np.log1p(-min(both, 1.0 - 1e-16))))
    place = float((k + 1) * order * (1.0 + slips[best]))
    return Measured(float(ratio[k, best]), some, place, float(np.sqrt(power[k, best])), slips.size)


def _skirts(place: Array, spectrum: FineSpectrum) -> NDArray[np.bool_]:
    """Mask of increasing orders on the slope of a line outside their range, which is due to another source.

    A line is outside if its maximum is more than half a line of the record away.
    """
    beyond = spectrum.step * np.arange(1, int(OFF * spectrum.resolution / spectrum.step) + 2)
    rise = np.diff(spectrum.power(np.concatenate([place[0] - beyond[::-1], place, place[-1] + beyond])))
    left, right = np.cumprod(rise <= 0.0)[:-1], np.cumprod(rise[:0:-1] >= 0.0)[::-1]
    inside = slice(beyond.size - 1, beyond.size - 1 + place.size)
    return np.asarray((left[inside] > 0) | (right[inside] > 0))


def _next_to_orders(
    place: Array, power: Array, step: float, base: float, spectrum: FineSpectrum, parts: TurningParts
) -> tuple[Array, Array]:
    """Test of lines next to wide orders of a shaft against the points on the other side of these orders.

    Orders of a shaft are wider than the resolution where speed and vibration change within the record, or
    where the angle is not exact: to both sides alike, and neighbouring orders alike. Points at the same
    distance on the other side have this width, but neither the line of a bearing nor its sidebands at the
    speed of the shaft.

    Returns
    -------
    tuple of ndarray
        Shape (n,) each. Probability of noise of this level [-], 0 where it does not exceed `base`, the level
        of the noise around; power over its reference [-].
    """
    chance, over = np.zeros(place.size), np.full(place.size, np.inf)
    if step / spectrum.resolution < RESOLVED:
        return chance, over
    number = np.rint(place / step)
    off = place - number * step
    image = (number[:, None] + np.arange(-ORDERS, ORDERS + 1)) * step - off[:, None]
    usable = _free(image.ravel(), spectrum, parts).reshape(image.shape)
    usable &= (image > 3.0 * spectrum.resolution) & (np.abs(off) < 0.25 * step)[:, None]
    level = np.sort(np.where(usable, spectrum.power(image), np.inf), axis=1)
    for row, points in enumerate(usable.sum(axis=1)):
        rank = int(3 * points) // 4
        if points < MIN_NEIGHBOURS or level[row, rank - 1] < WIDE * base:
            continue
        over[row] = power[row] / level[row, rank - 1]
        chance[row] = line_probability(float(over[row]), int(points), rank)
    return chance, over


def _free(place: Array, spectrum: FineSpectrum, parts: TurningParts) -> NDArray[np.bool_]:
    """Mask of points that are resolved from the orders of all shafts."""
    apart = np.ones(place.size, dtype=bool)
    for shaft in parts.shafts:
        step = float(shaft.order)
        if step / spectrum.resolution >= RESOLVED:
            apart &= np.abs(place - np.rint(place / step) * step) > 2.0 * spectrum.resolution
    return apart
