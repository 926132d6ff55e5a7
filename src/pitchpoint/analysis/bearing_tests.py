# SPDX-License-Identifier: Apache-2.0
"""Evidence for damage of rolling bearings: lines of the envelope at the orders of their parts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.envelope import band_envelope
from pitchpoint.analysis.kurtogram import kurtogram
from pitchpoint.analysis.line_tests import FineSpectrum, beside, fine_spectrum, line_probability
from pitchpoint.analysis.sampled import Array, as_signal
from pitchpoint.analysis.shaft_tests import (
    FEWEST_NEIGHBOURS,
    NEIGHBOURS,
    RESOLVED,
    SLIP,
    Measured,
    ShaftView,
    passing_balls,
)
from pitchpoint.analysis.turning_parts import Bearing, Shaft, TurningParts

HARMONICS = 3
IMPACTS = 0.01
"""Chance of being taken for impacts that is left to envelopes which a few lines of the signal make."""
FEWEST_EVENTS = 16.0
NOTHING = 1e-9
"""What is left of a signal, as a part of it, that is round-off."""
FEWEST_SAMPLES = 1024

Row = tuple[str, str, Measured]


def bearing_evidence(
    values: Array, samples_per_turn: float, parts: TurningParts
) -> tuple[list[Row], list[str]]:
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
    list of str
        What could not be tested.

    Notes
    -----
    Lines of a healthy machine are taken out, the band is the one of the largest kurtosis [1]_. The squared
    envelope of that band is searched within 1 % about each order, as rolling elements slip [2]_: two of the
    first three harmonics must stand out, and impacts must make them. Orders of shafts are left out. Equal
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
    >>> rows, _ = bearing_evidence(2 * knock + 0.3 * noise, 500.0, parts)
    >>> rows[0][1], bool(rows[0][2].probability < 1e-6), round(rows[0][2].order / 3.57) in (1, 2, 3)
    ('outer ring', True, True)
    """
    if not parts.bearings:
        return [], []
    if values.size < FEWEST_SAMPLES:
        return [], [f"record: {values.size} samples are too few for bearings, needs about {FEWEST_SAMPLES}"]
    turns = values.size / samples_per_turn
    if all(order * turns < FEWEST_EVENTS for bearing in parts.bearings for order in bearing.orders.values()):
        return [], [f"too few events of all bearings, needs about {FEWEST_EVENTS:g} of each"]
    x = without_healthy_lines(values, samples_per_turn, parts)
    if float(x.std()) <= NOTHING * float(np.std(values)):
        return [], ["bearings not tested: lines of a healthy machine fill the spectrum of so short a record"]
    low, high = envelope_band(x, samples_per_turn, parts)
    spectrum, white = (
        fine_spectrum(band_envelope(y, samples_per_turn, band=(low, high)).envelope ** 2, samples_per_turn)
        for y in (x, whitened(values))
    )
    # the envelope holds nothing above the width of its band, and little close to it
    end = min(spectrum.highest, 0.8 * (high - low))
    lines = fine_spectrum(values, samples_per_turn)
    rows, remarks = [], []
    for bearing in alike(parts.bearings):
        for part, order in bearing.orders.items():
            if order / spectrum.resolution < FEWEST_EVENTS:
                count = order / spectrum.resolution
                remarks.append(
                    f"too few events of {bearing.name}, {part}: {count:.2g}, needs about {FEWEST_EVENTS:g}"
                )
                continue
            harmonic = order * np.arange(1.0, HARMONICS + 1)
            if np.sum(_free(harmonic, spectrum, parts)) < 2:
                remarks.append(
                    f"{part} of {bearing.name} cannot be told from the turns of a shaft: the record does not "
                    "resolve their harmonics"
                )
            found = _part(spectrum, order, parts, end)
            if found.probability < IMPACTS:
                impacts = _part(white, order, parts, end).probability
                if min(impacts, _comb(lines, order, parts, samples_per_turn)) > IMPACTS:
                    remarks.append(
                        f"{part} of {bearing.name}: its lines in the envelope are made by few of the signal: "
                        "meshes that passing balls modulate do that, impacts do not"
                    )
                    found = replace(found, probability=1.0)
            rows.append((bearing.name, part, found))
    return rows, remarks


def alike(bearings: Sequence[Bearing]) -> list[Bearing]:
    """Bearings of equal orders as one, with all their names.

    Parameters
    ----------
    bearings
        Rolling bearings.

    Notes
    -----
    Orders count as equal within 1e-9 of their size; no record tells them apart [1]_.

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


def envelope_band(values: Array, samples_per_turn: float, parts: TurningParts) -> tuple[float, float]:
    """Band of the largest kurtosis among those that are wide enough for the orders of the bearings.

    Parameters
    ----------
    values
        Signal over the angle, shape (n,), any unit.
    samples_per_turn
        Samples in one turn of the reference shaft [-].
    parts
        What turns.

    Returns
    -------
    tuple of float
        Edges of the band, as orders of the reference shaft [-].

    Notes
    -----
    Bands of the kurtogram [1]_ from three times the highest order on; all of the signal if none is. Valid for
    impacts that ring in one band.

    References
    ----------
    .. [1] J. Antoni, Fast computation of the kurtogram for the detection of transient faults, Mechanical
    Systems
       and Signal Processing 21(1), 2007, 108-124.

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
    best = int(np.argmax(np.where(wide, found.kurtosis, -np.inf)))
    return float(found.low[best]), float(found.high[best])


def without_healthy_lines(values: ArrayLike, samples_per_turn: float, parts: TurningParts) -> Array:
    """Signal without the lines of a healthy machine: mesh harmonics, passing balls, and both together.

    Parameters
    ----------
    values
        Signal over the angle of the reference shaft, shape (n,), any unit.
    samples_per_turn
        Samples in one turn of the reference shaft [-].
    parts
        What turns.

    Notes
    -----
    Five lines about each are set to zero [1]_, more where balls may slip: were only the mesh taken out, its
    sidebands would beat with each other as often as balls pass. Valid for a steady mesh.

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


def whitened(values: ArrayLike) -> Array:
    """Signal with lines of one size, but with their phases.

    Parameters
    ----------
    values
        Signal, shape (n,), any unit.

    Notes
    -----
    Cepstrum pre-whitening [1]_: meshes, their sidebands and what modulates them are few lines and lose their
    weight, impacts fill a band and keep it. Valid for impacts that fill a band with many lines.

    References
    ----------
    .. [1] P. Borghesani, P. Pennacchi, R. B. Randall, N. Sawalhi, R. Ricci, Application of cepstrum
       pre-whitening for the diagnosis of bearing faults under variable speed conditions, Mechanical Systems
       and Signal Processing 36(2), 2013, 370-384.

    Examples
    --------
    A single pulse is white already:

    >>> pulse = np.zeros(8)
    >>> pulse[3] = 2.0
    >>> (np.abs(whitened(pulse) + 1 / 8) > 1e-9).tolist().index(True)
    3
    """
    lines = np.fft.rfft(as_signal(values))
    lines[0] = 0.0
    size = np.abs(lines)
    lines /= np.where(size > 0.0, size, 1.0)
    return np.asarray(np.fft.irfft(lines, np.size(values)), dtype=np.float64)


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
        near = place * (1.0 + slips)
        free = _free(near, spectrum, parts)
        off = reach + np.arange(2.0, 120.0, 2.0) * spectrum.resolution
        around = np.concatenate([(place - off)[::-1], place + off])
        around = around[(around > 3.0 * spectrum.resolution)]
        around = around[_free(around, spectrum, parts)]
        sides = beside(spectrum.power(around), around, place, NEIGHBOURS)
        if not free.any() or min(side.size for side in sides) < FEWEST_NEIGHBOURS:
            continue
        held += 1
        # the higher one of both sides, with the rank of the shorter one
        points = min(side.size for side in sides)
        rank = (3 * points) // 4
        base = max(float(np.sort(side)[(3 * side.size) // 4 - 1]) for side in sides)
        power[k - 1] = np.where(free, spectrum.power(near), 0.0)
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


def _free(place: Array, spectrum: FineSpectrum, parts: TurningParts) -> Array:
    """Whether points are apart from the orders of all shafts."""
    apart = np.ones(place.size, dtype=bool)
    for shaft in parts.shafts:
        step = float(shaft.order)
        if step / spectrum.resolution >= RESOLVED:
            apart &= np.abs(place - np.rint(place / step) * step) > 2.0 * spectrum.resolution
    return apart
