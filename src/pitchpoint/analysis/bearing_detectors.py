# SPDX-License-Identifier: Apache-2.0
"""Detectors of bearing damage, and their common verdict.

Every detector leads to an envelope spectrum, in which families of lines are searched. On a real machine
lines of sound parts are prominent as well, more so in some detectors than in others. The limit of a detector
is therefore above the highest level of a sound part on all machines whose records were counted:
docs/diagnosis.md, "Verdict of all detectors". A part is named if one detector names it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from pitchpoint.analysis.envelope import band_envelope, square_in_parts
from pitchpoint.analysis.family_lines import (
    FamilyLines,
    background,
    coherence_lines,
    envelope_lines,
    highest_order,
)
from pitchpoint.analysis.family_search import FamilySearch, FaultFamily, LevelLimits
from pitchpoint.analysis.fault_families import FaultFamilies, families_in
from pitchpoint.analysis.kurtogram import kurtogram
from pitchpoint.analysis.line_tests import LONG
from pitchpoint.analysis.sampled import Array, SignalError
from pitchpoint.analysis.spectral_coherence import LONGEST
from pitchpoint.analysis.turning_parts import TurningParts
from pitchpoint.analysis.whitening import limited_tones

COHERENCE, TONES = "spectral coherence", "squared envelope"
LIMITS = {
    "cepstral whitening": 15.0,
    "median whitening": 17.0,
    "kurtogram band": 22.0,
    COHERENCE: 27.0,
    TONES: 30.0,
}
"""Level of the lines of a damaged part above the surroundings, by detector [dB]."""
ABOVE = 1.25
"""Highest order of a squared envelope over that of the search: the background of its last lines."""
SEGMENTS = 16
"""Segments of a long record whose spectral coherence is averaged."""
WIDE, BLOCKS = 3.0, 8
"""Minimum width of the band of the kurtogram in highest fault orders, and blocks against single shocks."""


@dataclass(frozen=True)
class PartLevels:
    """Levels of one part of a bearing in all detectors.

    Attributes
    ----------
    bearing, part
        Names of the bearing and its part.
    families
        Evidence by detector.
    """

    bearing: str
    part: str
    families: Mapping[str, FaultFamily]

    @property
    def by(self) -> tuple[str, ...]:
        """Detectors that name the part; if none does, that whose level is nearest to its limit.

        In the order of `LIMITS`: levels of the first one are compared between channels.
        """
        named = tuple(name for name, family in self.families.items() if family.named)
        below = {name: LIMITS[name] - family.strength for name, family in self.families.items()}
        return named or (min(below, key=lambda name: below[name]),)

    @property
    def named(self) -> bool:
        """Whether a detector names the part."""
        return any(family.named for family in self.families.values())


def detector_lines(values: Array, rate: float, parts: TurningParts) -> dict[str, FamilyLines]:
    """Lines of the envelope spectra of all detectors that the record allows, by detector.

    Parameters
    ----------
    values
        Signal over the angle, shape (n,), any unit.
    rate
        Samples per revolution of the reference shaft [-].
    parts
        Shafts and bearings.

    Raises
    ------
    SignalError
        If the record is too short for cepstral whitening.

    Notes
    -----
    Squared envelopes of the whole signal after cepstrum pre-whitening [1]_ and after division of its spectrum
    by the running median; of the band of the largest spectral kurtosis without tones [2]_; the enhanced
    envelope spectrum of the signal without tones [3]_; and the squared envelope of the signal itself, because
    impacts without slip are tones: without gears, only bearings have families of them at orders that are not
    those of shafts. Valid for steady speed or signals over the angle.

    References
    ----------
    .. [1] P. Borghesani, P. Pennacchi, R. B. Randall, N. Sawalhi, R. Ricci, Application of cepstrum
       pre-whitening for the diagnosis of bearing faults under variable speed conditions, Mechanical Systems
       and Signal Processing 36(2), 2013, 370-384.
    .. [2] R. B. Randall, J. Antoni, Rolling element bearing diagnostics - a tutorial, Mechanical Systems and
       Signal Processing 25(2), 2011, 485-520.
    .. [3] J. Antoni, G. Xin, N. Hamzaoui, Fast computation of the spectral correlation, Mechanical Systems
       and Signal Processing 92, 2017, 248-277.
    """
    found = {}
    for number, (name, way) in enumerate(WAYS.items()):
        try:
            found[name] = way(values, rate, parts, LIMITS[name])
        except SignalError:
            if number == 0:
                raise
    return found


def _after_cepstral_whitening(values: Array, rate: float, parts: TurningParts, level: float) -> FamilyLines:
    """Squared envelope of the signal after cepstrum pre-whitening."""
    return _lines(values, rate, parts, level, lambda x: band_envelope(x, rate, whiten=True).envelope ** 2)


def _after_median_whitening(values: Array, rate: float, parts: TurningParts, level: float) -> FamilyLines:
    """Squared envelope of the signal divided by the running median of its spectrum."""
    return _lines(
        values, rate, parts, level, lambda x: band_envelope(limited_tones(x, whiten=True), rate).envelope ** 2
    )


def _in_kurtogram_band(values: Array, rate: float, parts: TurningParts, level: float) -> FamilyLines:
    """Squared envelope of the band of the largest kurtosis, that in the middle of a long record."""
    least = WIDE * max(order for bearing in parts.bearings for order in bearing.orders.values())
    start = max(values.size - LONG, 0) // 2
    middle = limited_tones(values[start : start + LONG])
    found = kurtogram(middle, rate, least_width=least, blocks=BLOCKS)
    band = found.best_low, found.best_high
    return _lines(
        values, rate, parts, level, lambda x: band_envelope(limited_tones(x), rate, band=band).envelope ** 2
    )


def _by_coherence(values: Array, rate: float, parts: TurningParts, level: float) -> FamilyLines:
    """Enhanced envelope spectrum of the signal without tones, of a long record that of some segments."""
    if values.size <= LONG:
        return coherence_lines(limited_tones(values), rate, parts)
    starts = np.linspace(0, values.size - LONGEST, SEGMENTS).astype(np.int64)
    segments = [limited_tones(values[start : start + LONGEST]) for start in starts]
    return coherence_lines(np.concatenate(segments), rate, parts)


def _with_tones(values: Array, rate: float, parts: TurningParts, level: float) -> FamilyLines:
    """Squared envelope of the whole signal: impacts without slip are tones, which the others remove."""
    return _lines(values, rate, parts, level, lambda x: band_envelope(x, rate).envelope ** 2)


def _lines(
    values: Array, rate: float, parts: TurningParts, level: float, square: Callable[[Array], Array]
) -> FamilyLines:
    """Lines of a squared envelope, of a long record at a lower rate."""
    squared, lower = square_in_parts(values, rate, ABOVE * highest_order(parts), square)
    return envelope_lines(squared, lower, parts, level)


WAYS = dict(
    zip(
        LIMITS,
        (_after_cepstral_whitening, _after_median_whitening, _in_kurtogram_band, _by_coherence, _with_tones),
        strict=True,
    )
)
"""Function of each detector from signal, samples per revolution, parts and limit to the lines."""


def part_levels(
    values: Array,
    rate: float,
    parts: TurningParts,
    *,
    tolerance: float,
    slip: float,
    false_alarm: float,
) -> tuple[list[PartLevels], tuple[str, ...]]:
    """Levels of all bearing parts in all detectors, and notes on parts that were not tested.

    Parameters
    ----------
    values
        Signal over the angle, shape (n,), any unit.
    rate
        Samples per revolution of the reference shaft [-].
    parts
        Shafts and bearings.
    tolerance
        Relative tolerance of the speed [-].
    slip
        Maximum relative deviation of the bearing orders due to slip [-].
    false_alarm
        Probability that noise alone leads to a detection [-], shared by the detectors.

    Raises
    ------
    SignalError
        If the record is too short or no part can be tested.

    Notes
    -----
    `fault_families` in the lines of each detector [1]_. Valid as `detector_lines`.

    References
    ----------
    .. [1] R. B. Randall, J. Antoni, Rolling element bearing diagnostics - a tutorial, Mechanical Systems and
       Signal Processing 25(2), 2011, 485-520.
    """
    lines = detector_lines(values, rate, parts)
    share = false_alarm / len(lines)
    found: dict[str, FaultFamilies] = {}
    turns = values.size / rate
    envelopes = [one for name, one in lines.items() if name not in (COHERENCE, TONES)]
    searches: dict[str, FamilySearch] = {}
    for name, one in lines.items():
        limits = (
            LevelLimits.of_probability(LIMITS[name])
            if name == COHERENCE
            else LevelLimits.of_envelope(LIMITS[name], background(turns))
        )
        search = searches[name] = FamilySearch(one, turns, limits)
        spectra = [*envelopes, one] if name in (COHERENCE, TONES) else envelopes
        try:
            found[name] = families_in(search, parts, tolerance, slip, share, spectra)
        except SignalError:
            if not found:
                raise
    first = next(iter(found.values()))
    rows = []
    for family in first.families:
        whose = family.bearing, family.part
        mine = {
            name: one
            for name, families in found.items()
            for one in families.families
            if (one.bearing, one.part) == whose
        }
        rows.append(PartLevels(*whose, mine))
    return _reconciled(rows, searches), first.notes


def _reconciled(rows: list[PartLevels], searches: Mapping[str, FamilySearch]) -> list[PartLevels]:
    """Parts of one channel without those whose lines another part has that is clearer in another detector."""

    def above(row: PartLevels) -> float:
        """Highest level above the limit of a detector that names the part [dB]."""
        return max(one.strength - LIMITS[name] for name, one in row.families.items() if one.named)

    kept: list[PartLevels] = []
    for row in sorted((row for row in rows if row.named), key=above, reverse=True):
        mine = row.families
        causes = [
            other
            for other in kept
            for name in other.by
            if not any(other.families[by].named for by in row.by if by in other.families)
            and searches[name].explains(other.families[name], mine[row.by[0]])
        ]
        if not causes:
            kept.append(row)
            continue
        cause = f"{causes[0].part} of {causes[0].bearing}"
        plain = {name: replace(one, named=False, same_lines=(cause,)) for name, one in mine.items()}
        rows = [replace(one, families=plain) if one is row else one for one in rows]
    return rows
