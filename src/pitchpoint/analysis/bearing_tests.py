# SPDX-License-Identifier: Apache-2.0
"""Evidence for damage of rolling bearings: lines of the envelope at the orders of their parts."""

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
    FEWEST_NEIGHBOURS,
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
"""Chance of being taken for impacts that is left to envelopes which a few lines of the signal make, over all
parts of bearings and both tests of each."""
FEWEST_EVENTS = 16.0
NOTHING = 1e-9
"""What is left of a signal, as a part of it, that is round-off."""
FEWEST_SAMPLES = 1024

FROM_SHAFTS = (
    "{} cannot be distinguished from the turns of a shaft: the record does not resolve their harmonics"
)
FROM_MESHES = (
    "{}: lines in the envelope that few lines of the signal make: meshes that passing balls modulate do "
    "that, impacts do not"
)

Row = tuple[str, str, Measured]


class BearingView:
    """Envelopes of one channel in which the parts of bearings are looked for.

    Parameters
    ----------
    values
        Signal over the angle of the reference shaft, shape (n,), any unit.
    samples_per_turn
        Samples in one turn of the reference shaft [-].
    parts
        What turns.
    """

    def __init__(self, values: Array, samples_per_turn: float, parts: TurningParts) -> None:
        self.samples_per_turn, self.parts = samples_per_turn, parts
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
        # the envelope holds nothing above the width of its band, and little close to it
        self.impacts = IMPACTS / (2 * max(sum(len(b.orders) for b in alike(parts.bearings)), 1))
        self.end = min(self.spectra[0].highest, 0.8 * (high - low))

    def part(self, order: float, known: Sequence[Array] = ()) -> tuple[Measured, bool]:
        """Test of a part, and whether impacts may make its lines; lines that are known are taken out before.

        `known` are orders, shapes (n,), for the signal, for its envelope and for that of the whitened signal.
        """
        lines, envelope, white = self._without(known) if known else self.spectra
        found = _part(envelope, order, self.parts, self.end)
        if found.probability >= IMPACTS:
            return found, True
        impacts = _part(white, order, self.parts, self.end).probability
        if min(impacts, _comb(lines, order, self.parts, self.samples_per_turn)) > self.impacts:
            return replace(found, probability=1.0), False
        return found, True

    def resolves(self, order: float) -> bool:
        """Whether two of the harmonics of a part are apart from the orders of all shafts."""
        harmonic = order * np.arange(1.0, HARMONICS + 1)
        return int(np.sum(_free(harmonic, self.spectra[0], self.parts))) >= 2

    def _without(self, known: Sequence[Array]) -> list[FineSpectrum]:
        rate = self.samples_per_turn
        pairs = zip(self.signals, known, strict=True)
        return [fine_spectrum(without_tones(x, rate, lines), rate) for x, lines in pairs]


def bearing_evidence(
    values: Array, samples_per_turn: float, parts: TurningParts
) -> tuple[list[Row], list[Note], BearingView | None]:
    """Lines of all parts of all bearings in the spectrum of the squared envelope.

    Parameters
    ----------
    values
        Signal over the angle of the reference shaft, shape (n,), any unit.
    samples_per_turn
        Samples in one turn of the reference shaft [-].
    parts
        What turns.

    Returns
    -------
    list of tuples
        Bearing, part, test.
    list of Note
        What could not be tested.
    BearingView or None
        The envelopes, if there are any.

    Notes
    -----
    Lines of a healthy machine are taken out, the band is the one of the largest kurtosis [1]_. The squared
    envelope of that band is searched within 1 % about each order, as rolling elements slip [2]_: two of the
    first three harmonics must stand out, and impacts must make them. Orders of shafts are omitted. Equal
    bearings on one shaft are one. Valid for many events per record.

    References
    ----------
    .. [1] J. Antoni, Fast computation of the kurtogram for the detection of transient faults, Mechanical
    Systems
       and Signal Processing 21(1), 2007, 108-124.
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
    few = f"needs about {FEWEST_EVENTS:g}"
    if values.size < FEWEST_SAMPLES:
        text = f"record: {values.size} samples are too few for bearings, needs about {FEWEST_SAMPLES}"
        return [], [Note(text)], None
    turns = values.size / samples_per_turn
    if all(order * turns < FEWEST_EVENTS for bearing in parts.bearings for order in bearing.orders.values()):
        return [], [Note(f"too few events of all bearings, {few} of each")], None
    view = BearingView(values, samples_per_turn, parts)
    if view.empty:
        text = "bearings not tested: lines of a healthy machine fill the spectrum of so short a record"
        return [], [Note(text)], None
    rows, remarks = [], []
    for bearing in alike(parts.bearings):
        for part, order in bearing.orders.items():
            whose = f"{part} of {bearing.name}"
            if order * turns < FEWEST_EVENTS:
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
    """Bearings of equal orders as one, with all their names.

    Parameters
    ----------
    bearings
        Rolling bearings.

    Notes
    -----
    Orders count as equal within 1e-9 of their size; no record distinguishes them [1]_.

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
    """Probability that noise raises all multiples of an order: what elements without slip do."""
    shaft = Shaft("", Fraction(order).limit_denominator(10**9))
    view = ShaftView(lines, parts, shaft, 0.0, samples_per_turn)
    return view.comb().probability if view.testable else 1.0


def _part(spectrum: FineSpectrum, order: float, parts: TurningParts, end: float) -> Measured:
    """The second most unlikely of the first three harmonics, with the slip for which it is that.

    Impacts have many harmonics. A single one is what other parts have in common with this one, so two of them
    must stand out, with one slip.
    """
    slips = np.arange(-SLIP, SLIP, min(spectrum.step / (HARMONICS * order), SLIP))
    chance, power, ratio = (np.full((HARMONICS, slips.size), fill) for fill in (1.0, 0.0, 0.0))
    held = 0
    for k in range(1, HARMONICS + 1):
        place = k * order
        reach = max(SLIP * place, spectrum.resolution)
        if place + 80.0 * spectrum.resolution > end:
            break
        near = np.asarray(place * (1.0 + slips), dtype=np.float64)
        free = _free(near, spectrum, parts)
        off = reach + np.arange(2.0, 120.0, 2.0) * spectrum.resolution
        around = np.concatenate([(place - off)[::-1], place + off])
        around = around[(around > 3.0 * spectrum.resolution)]
        around = around[_free(around, spectrum, parts)]
        sides = neighbours(spectrum.power(around), around, place, NEIGHBOURS)
        if not free.any() or min(side.size for side in sides) < FEWEST_NEIGHBOURS:
            continue
        held += 1
        # the higher one of both sides, with the rank of the shorter one
        points = min(side.size for side in sides)
        rank = (3 * points) // 4
        base = max(float(np.sort(side)[(3 * side.size) // 4 - 1]) for side in sides)
        power[k - 1] = np.where(free & ~_skirts(near, spectrum), spectrum.power(near), 0.0)
        ratio[k - 1] = power[k - 1] / base
        chance[k - 1] = [line_probability(float(x), points, rank) for x in ratio[k - 1]]
    if held < 2:
        return Measured(0.0, 1.0, order, 0.0, 0)
    second = np.sort(chance, axis=0)[1]
    best = int(np.argmin(second))
    p = float(second[best])
    # the second smallest of n equal chances
    both = min(1.0, p**2 if held == 2 else 3.0 * p**2 - 2.0 * p**3)
    k = int(np.argsort(chance[:, best], kind="stable")[1])
    some = float(-np.expm1(slips.size * np.log1p(-min(both, 1.0 - 1e-16))))
    place = float((k + 1) * order * (1.0 + slips[best]))
    return Measured(float(ratio[k, best]), some, place, float(np.sqrt(power[k, best])), slips.size)


def _skirts(place: Array, spectrum: FineSpectrum) -> NDArray[np.bool_]:
    """Which of rising places lie on the slope of a line outside of them: it belongs to something else.

    Outside is what has its top more than half a line of the record away.
    """
    beyond = spectrum.step * np.arange(1, int(OFF * spectrum.resolution / spectrum.step) + 2)
    rise = np.diff(spectrum.power(np.concatenate([place[0] - beyond[::-1], place, place[-1] + beyond])))
    left, right = np.cumprod(rise <= 0.0)[:-1], np.cumprod(rise[:0:-1] >= 0.0)[::-1]
    inside = slice(beyond.size - 1, beyond.size - 1 + place.size)
    return np.asarray((left[inside] > 0) | (right[inside] > 0))


def _free(place: Array, spectrum: FineSpectrum, parts: TurningParts) -> NDArray[np.bool_]:
    """Whether points are apart from the orders of all shafts."""
    apart = np.ones(place.size, dtype=bool)
    for shaft in parts.shafts:
        step = float(shaft.order)
        if step / spectrum.resolution >= RESOLVED:
            apart &= np.abs(place - np.rint(place / step) * step) > 2.0 * spectrum.resolution
    return apart
