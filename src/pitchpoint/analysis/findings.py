# SPDX-License-Identifier: Apache-2.0
"""Findings from the evidence of one record, and their ambiguities."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from statistics import median

from numpy.typing import ArrayLike

from pitchpoint.analysis.bearing_tests import alike
from pitchpoint.analysis.mean_turns import MeanTurn, mean_turn
from pitchpoint.analysis.remarks import Note
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.shaft_periods import level_of
from pitchpoint.analysis.shaft_tests import SLIP, ShaftView
from pitchpoint.analysis.tooth_energy import peaked_as_trains, share_of_finer
from pitchpoint.analysis.turning_parts import TurningParts

COMBS = ("comb", "period")
"""Tests of one event per revolution: of all orders, and of the lowest ones in the level of a mesh."""
COARSE, TIMES = 0.75, 4.0
"""Largest share of the energy in one pitch of the coarse gear that is within two pitches of a finer gear, for
an event of the coarse gear; smallest ratio of the numbers of teeth. With simulated broken teeth of the finer
gear the share is above 0.75 in 203 of 204 channels, with those of the coarse gear below it in 197 of 248
(docs/diagnosis.md, measured records)."""
ONE_PLACE, ONE_TOOTH, PEAKED = 2e-3, 1e-2, 4.0
"""Conditions for a local fault: probability that a random signal of the same spectrum, and that a train with
impacts at all teeth, is as peaked as the mean revolution; minimum kurtosis of its residual, 3 for noise. The
tooth-to-tooth differences of a gear of 11 teeth have five harmonics, whose random phases agree by chance
about once in a hundred cases. The residuals of sound gears of a real machine reach 3.7 in whole records, 5.6
in parts of 2 s at low load (docs/diagnosis.md, measured records)."""


@dataclass(frozen=True)
class Evidence:
    """One test of one channel.

    Attributes
    ----------
    channel
        Name of the channel.
    kind
        `comb`, `period`, `low order`, `sidebands` or `bearing`.
    shaft
        Tested shaft, or tested part of a bearing.
    gear
        Gear of the tested mesh or level, or the bearing; empty for the shaft itself.
    value, threshold
        Test value and its threshold: normal score of a comb or a period, otherwise level above the adjacent
        noise in dB.
    probability
        Probability that any test of a record of noise reaches this value [-], for all tests together.
    order
        Order of the strongest line, relative to the reference shaft [-].
    amplitude
        Amplitude of the line or of the whole comb, in the unit of the channel.
    sideband
        Number of the sideband, 0 if it is not a sideband [-].
    found
        Whether the probability is below the allowed one and no more certain finding explains the test.
    allowed
        Allowed probability [-].
    explained
        Cause that explains the test, such as a bearing part with the same lines; empty if there is none.
    alike
        Parts of bearings with the same lines, which this record does not distinguish.
    detectors
        Detector of the value of a bearing part, then others that name the part; empty for other tests.
    levels
        Values and limits of a bearing part in all detectors, by detector [dB]; empty for other tests.
    """

    channel: str
    kind: str
    shaft: str
    gear: str
    value: float
    threshold: float
    probability: float
    order: float
    amplitude: float
    sideband: int
    found: bool
    allowed: float = 0.0
    explained: str = ""
    alike: tuple[str, ...] = ()
    detectors: tuple[str, ...] = ()
    levels: Mapping[str, tuple[float, float]] = field(default_factory=dict)


@dataclass(frozen=True)
class Finding:
    """Finding of a diagnosis.

    Attributes
    ----------
    kind
        Findings: `local fault` or `bearing`. Observations: `modulation`, `once per turn`, or `every order`.
    shaft
        Shaft, or part of the bearing.
    gears
        Candidate gears, or the bearing; empty for the shaft alone.
    channel
        Channel of the strongest evidence.
    probability
        Probability of the strongest evidence [-].
    bearings
        Parts of bearings that the record cannot distinguish from the gears.
    amplitude
        Amplitude of the strongest line, or of the whole comb, in the unit of the channel.
    level
        Gear in whose wavelet level the event is visible; empty for the whole signal.
    """

    kind: str
    shaft: str
    gears: tuple[str, ...]
    channel: str
    probability: float
    bearings: tuple[str, ...] = ()
    amplitude: float = 0.0
    level: str = ""


@dataclass(frozen=True)
class _Record:
    """Signals of the record, for the checks that findings need in addition to the evidence."""

    signals: Mapping[str, ArrayLike]
    samples_per_turn: float
    parts: TurningParts
    turns: dict[tuple[str, str, int, str], MeanTurn | None] = field(default_factory=dict)

    def at_one_place(self, e: Evidence) -> bool:
        """Whether the residual of the mean revolution is concentrated at one angle, more than by chance.

        The comparison is with random signals of the same spectrum and, if products of meshes fill the orders
        of the shaft, with trains of impacts at every tooth.
        """
        level = e.gear if e.kind == "period" else ""
        for teeth in self._counts(e.shaft):
            turn = self._turn(e.channel, e.shaft, teeth, level)
            if turn is None:
                continue
            value, limit, part = turn.indicators["kurtosis"]
            if value <= max(PEAKED, limit) or part >= ONE_PLACE:
                return False
            return all(peaked_as_trains(turn.residual, teeth=z) < ONE_TOOTH for z in turn.trains)
        return False

    def suspected(self, places: list[Evidence]) -> tuple[str, ...]:
        """Gears of a shaft that may have the fault: the coarsest if the event lasts as long as its pitch.

        A short impact may come from any of the gears. The event is measured in the level of the finest gear.
        """
        shaft = places[0].shaft
        gears = self.parts.gears_of(shaft)
        counts = self._counts(shaft)
        if counts[-1] < TIMES * counts[0] or (len(counts) > 2 and counts[1] < TIMES * counts[0]):
            return tuple(gears)
        finest = next(gear for gear, (_, z) in gears.items() if z == counts[-1])
        shares = []
        for channel in dict.fromkeys(e.channel for e in places):
            turn = self._turn(channel, shaft, counts[-1], finest)
            if turn is not None:
                shares.append(share_of_finer(turn.residual, coarse=counts[0], fine=counts[-1]))
        if not shares or median(shares) > COARSE:
            return tuple(gears)
        return tuple(gear for gear, (_, z) in gears.items() if z == counts[0])

    def _counts(self, shaft: str) -> list[int]:
        """Numbers of teeth on a shaft, increasing."""
        return sorted({z for _, z in self.parts.gears_of(shaft).values()})

    def _turn(self, channel: str, shaft: str, teeth: int, level: str) -> MeanTurn | None:
        """Mean revolution, in the level of a gear if one is given; None if the record is too short for it."""
        key = (channel, shaft, teeth, level)
        if key not in self.turns:
            try:
                x, rate = level_of(self.signals[channel], self.samples_per_turn, self.parts, shaft, level)
                self.turns[key] = mean_turn(x, rate, self.parts, self.parts.shaft(shaft), teeth)
            except SignalError:
                self.turns[key] = None
        return self.turns[key]


def findings_of(
    evidence: tuple[Evidence, ...],
    views: Mapping[tuple[str, str], ShaftView],
    signals: Mapping[str, ArrayLike],
    samples_per_turn: float,
    parts: TurningParts,
) -> tuple[tuple[Finding, ...], tuple[Finding, ...], list[Note]]:
    """Combine the evidence into findings, at most one per shaft and one per bearing part, and observations.

    Every real machine has raised orders and sidebands: without damage at one place they are observations.

    Parameters
    ----------
    evidence
        All tests.
    views
        Orders by channel and shaft.
    signals
        Channels over the angle of the reference shaft, shape (n,) each, any unit.
    samples_per_turn
        Samples per revolution of the reference shaft [-].
    parts
        Rotating parts of the machine.

    Returns
    -------
    tuple of Finding
        Findings, the most certain first.
    tuple of Finding
        Observations, the most certain first.
    list of Note
        Remarks on significant tests that are not findings.

    Notes
    -----
    A comb or a period is a local fault if the mean revolution is peaked too [1]_, a period in its level.
    Lines at harmonics of a bearing finding are attributed to the bearing. Valid for one record.

    References
    ----------
    .. [1] P. D. McFadden, A revised model for the extraction of periodic waveforms by time domain averaging,
       Mechanical Systems and Signal Processing 1(1), 1987, 83-95.

    Examples
    --------
    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> findings_of((), {}, {}, 100.0, train_parts([(21, 40)]))
    ((), (), [])
    """
    record = _Record(signals, samples_per_turn, parts)
    bearings, spread = _bearings(evidence, parts)
    found, observed = list(bearings), []
    for shaft in parts.shafts:
        mine = [e for e in evidence if e.shaft == shaft.name and e.kind != "bearing" and e.found]
        mine = [e for e in mine if e.kind in COMBS or not _of_bearings(e, bearings, views, parts)]
        mine.sort(key=lambda e: (e.probability, -e.value))
        gears = parts.gears_of(shaft.name)
        combs = sorted((e for e in mine if e.kind in COMBS), key=lambda e: e.kind)
        bands = [e for e in mine if e.kind == "sidebands"]
        places = [e for e in (*combs, *bands[:1]) if gears and record.at_one_place(e)]
        if places:
            best = places[0]
            seen = [views[e.channel, shaft.name] for e in places if e.kind == "comb"]
            others = _like_bearings(parts, seen, best.threshold) if seen else ()
            # a damaged tooth modulates the meshes of all gears of its shaft: lines do not identify the gear
            found.append(_finding("local fault", shaft.name, record.suspected(places), best, others))
            continue
        if combs:
            observed.append(_finding("every order", shaft.name, (), combs[0]))
        if bands:
            named = tuple(dict.fromkeys(e.gear for e in bands))
            observed.append(_finding("modulation", shaft.name, named, bands[0]))
        lowest = [e for e in mine if e.kind == "low order"]
        if lowest:
            observed.append(_finding("once per turn", shaft.name, (), lowest[0]))
    for some in (found, observed):
        some.sort(key=lambda finding: finding.probability)
    return tuple(found), tuple(observed), spread


def _finding(
    kind: str, shaft: str, gears: tuple[str, ...], best: Evidence, bearings: tuple[str, ...] = ()
) -> Finding:
    """Finding or observation with its strongest evidence."""
    level = best.gear if best.kind == "period" else ""
    return Finding(kind, shaft, gears, best.channel, best.probability, bearings, best.amplitude, level)


def _bearings(evidence: tuple[Evidence, ...], parts: TurningParts) -> tuple[list[Finding], list[Note]]:
    """Bearing findings; of parts with common harmonics only the most certain one."""
    reported: list[Evidence] = []
    found, spread = [], []
    orders = _orders(parts)
    tests = [e for e in evidence if e.kind == "bearing" and e.found]
    # lines of an outer ring are harmonics of its cage: the cage explains them only if no ring is found
    for e in sorted(tests, key=lambda e: (e.shaft == "cage", *_least_clear_last(e))):
        if any((e.gear, e.shaft) == (other.gear, other.shaft) for other in reported):
            continue
        own = orders[e.gear, e.shaft]
        same = [other for other in reported if _whole(own, orders[other.gear, other.shaft])]
        if same:
            cause = f"{same[0].shaft} of {same[0].gear}"
            why = f"{{}}: not reported in addition to {cause}, which is more certain and shares harmonics"
            spread.append(Note(why, f"{e.shaft} of {e.gear}"))
            continue
        reported.append(e)
        found.append(Finding("bearing", e.shaft, (e.gear,), e.channel, e.probability, e.alike))
    return found, spread


def _least_clear_last(e: Evidence) -> tuple[float, float]:
    """Order of bearing parts: by the level above the limit of the detector, else by the probability."""
    below = e.threshold - e.value
    return (below, e.probability) if e.detectors else (e.probability, below)


def _orders(parts: TurningParts) -> dict[tuple[str, str], float]:
    """Orders by names of bearing and part."""
    return {(b.name, part): order for b in alike(parts.bearings) for part, order in b.orders.items()}


def _of_bearings(
    e: Evidence,
    found: list[Finding],
    views: Mapping[tuple[str, str], ShaftView],
    parts: TurningParts,
) -> bool:
    """Whether a shaft line is, within the resolution, a harmonic of a more certain bearing finding."""
    orders = _orders(parts)
    for finding in found:
        order = orders[finding.gears[0], finding.shaft]
        off = abs(e.order - round(e.order / order) * order)
        if finding.probability < e.probability and off < 2.0 * views[e.channel, e.shaft].spectrum.resolution:
            return True
    return False


def _whole(one: float, other: float) -> bool:
    """Whether one order is a multiple of the other within the slip of rolling bearings."""
    ratio = max(one, other) / min(one, other)
    return abs(ratio - round(ratio)) < SLIP * ratio


def _like_bearings(parts: TurningParts, views: list[ShaftView], threshold: float) -> tuple[str, ...]:
    """Bearing parts with impacts at the significant orders of a shaft, which cannot be distinguished."""
    found = []
    line = views[0].spectrum.resolution
    for bearing in alike(parts.bearings):
        for part, order in bearing.orders.items():
            times = round(order / views[0].order)
            if times < 1 or abs(order - times * views[0].order) > 2.0 * line:
                continue
            if times == 1 or all(view.comb(without=times).score < threshold for view in views):
                found.append(f"{part} of {bearing.name}")
    return tuple(found)
