# SPDX-License-Identifier: Apache-2.0
"""From evidence to findings: the combined result of the tests of one record and its ambiguities."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from numpy.typing import ArrayLike

from pitchpoint.analysis.bearing_tests import alike
from pitchpoint.analysis.mean_turns import mean_turn
from pitchpoint.analysis.remarks import Note
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.shaft_tests import SLIP, ShaftView
from pitchpoint.analysis.tooth_energy import peaked_as_trains
from pitchpoint.analysis.turning_parts import TurningParts

ONE_PLACE, ONE_TOOTH, GAUSSIAN = 2e-3, 1e-2, 3.0
"""Part of signals of the same spectrum that may be more peaked than a mean turn with a local fault, and of
trains with strikes at all teeth; the kurtosis that it exceeds in any case. The teeth of a gear of 11 differ
in five ways: that random phases of these agree by chance is no rarer than one in some hundred."""
EVERYWHERE = (
    "all orders stand out of {}, but not at one place of the turn: meshes that change each other do that, "
    "one damaged tooth does not"
)


@dataclass(frozen=True)
class Evidence:
    """One test of one channel.

    Attributes
    ----------
    channel
        Name of the channel.
    kind
        `comb`, `low order`, `sidebands` or `bearing`.
    shaft
        Shaft, or the part of a bearing that is tested.
    gear
        Gear whose mesh is looked at, or the bearing; empty for the shaft itself.
    value, threshold
        Normal score for a comb, level over what lies next to the line in dB for others; what it must exceed.
    probability
        Probability that some test of a healthy record does as much [-]: already for all tests together.
    order
        Order of the strongest line [-], in turns of the reference shaft.
    amplitude
        Its amplitude, or that of the whole comb, in the unit of the channel.
    sideband
        Number of the sideband, 0 for others [-].
    found
        Whether the probability is below the one allowed, and nothing surer explains it.
    allowed
        The probability that is allowed [-].
    explained
        What explains it, such as a part of a bearing whose lines it is made of; empty if nothing does.
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


@dataclass(frozen=True)
class Finding:
    """Findings from the evidence.

    Attributes
    ----------
    kind
        `local fault`, `modulation`, `once per turn` or `bearing`.
    shaft
        The shaft, or the part of the bearing.
    gears
        Gears that come into question, or the bearing; empty if it is only the shaft.
    channel
        Channel of the strongest evidence.
    probability
        That of the strongest evidence [-].
    bearings
        Parts of bearings that the record cannot distinguish from the gears.
    """

    kind: str
    shaft: str
    gears: tuple[str, ...]
    channel: str
    probability: float
    bearings: tuple[str, ...] = ()


@dataclass(frozen=True)
class _Record:
    """What findings ask besides the evidence."""

    signals: Mapping[str, ArrayLike]
    samples_per_turn: float
    parts: TurningParts

    def at_one_place(self, channel: str, shaft: str) -> bool:
        """Whether something in the mean turn is at one place: its residual is more peaked than by chance.

        Chance are signals of the same spectrum and, where products of meshes fill the orders of the shaft,
        trains with a strike at every tooth.
        """
        counts = sorted({z for _, z in self.parts.gears_of(shaft).values()})
        for teeth in counts:
            try:
                turn = mean_turn(
                    self.signals[channel], self.samples_per_turn, self.parts, self.parts.shaft(shaft), teeth
                )
            except SignalError:
                continue
            value, limit, part = turn.indicators["kurtosis"]
            if value <= max(GAUSSIAN, limit) or part >= ONE_PLACE:
                return False
            return all(peaked_as_trains(turn.residual, teeth=z) < ONE_TOOTH for z in turn.trains)
        return False


def findings_of(
    evidence: tuple[Evidence, ...],
    views: Mapping[tuple[str, str], ShaftView],
    signals: Mapping[str, ArrayLike],
    samples_per_turn: float,
    parts: TurningParts,
) -> tuple[tuple[Finding, ...], list[Note]]:
    """One finding per shaft at most, and one per part of a bearing.

    Parameters
    ----------
    evidence
        All tests.
    views
        Orders by channel and shaft.
    signals
        Channels over the angle of the reference shaft, shape (n,) each, any unit.
    samples_per_turn
        Samples in one turn of the reference shaft [-].
    parts
        What turns.

    Returns
    -------
    tuple of Finding
        The most certain first.
    list of Note
        What stands out and is not a finding, and why.

    Notes
    -----
    A comb is a local fault if the mean turn is peaked as well [1]_. Lines at harmonics of a bearing that is
    found are its own. Valid for one record.

    References
    ----------
    .. [1] P. D. McFadden, A revised model for the extraction of periodic waveforms by time domain averaging,
       Mechanical Systems and Signal Processing 1(1), 1987, 83-95.

    Examples
    --------
    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> findings_of((), {}, {}, 100.0, train_parts([(21, 40)]))
    ((), [])
    """
    record = _Record(signals, samples_per_turn, parts)
    bearings, spread = _bearings(evidence, parts)
    found = list(bearings)
    for shaft in parts.shafts:
        mine = [e for e in evidence if e.shaft == shaft.name and e.kind != "bearing" and e.found]
        mine = [e for e in mine if e.kind == "comb" or not _of_bearings(e, bearings, views, parts)]
        mine.sort(key=lambda e: (e.probability, -e.value))
        combs = [e for e in mine if e.kind == "comb"]
        bands = [e for e in mine if e.kind == "sidebands"]
        places = [e for e in combs if record.at_one_place(e.channel, shaft.name)]
        if combs and not places:
            spread += [Note(EVERYWHERE, f"{shaft.name} (in {e.channel})") for e in combs]
        combs = places
        if combs:
            best = combs[0]
            seen = [views[e.channel, shaft.name] for e in combs]
            others = _like_bearings(parts, seen, best.threshold)
            # a tooth of one gear shakes the meshes of all gears of its shaft: where lines gather gives no
            # information
            gears = tuple(parts.gears_of(shaft.name))
            found.append(Finding("local fault", shaft.name, gears, best.channel, best.probability, others))
        elif bands:
            best = bands[0]
            gears = tuple(dict.fromkeys(e.gear for e in bands))
            local = record.at_one_place(best.channel, shaft.name)
            kind = "local fault" if local else "modulation"
            found.append(Finding(kind, shaft.name, gears, best.channel, best.probability))
        elif lowest := [e for e in mine if e.kind == "low order"]:
            best = lowest[0]
            found.append(Finding("once per turn", shaft.name, (), best.channel, best.probability))
    return tuple(sorted(found, key=lambda finding: finding.probability)), spread


def _bearings(evidence: tuple[Evidence, ...], parts: TurningParts) -> tuple[list[Finding], list[Note]]:
    """Parts of bearings, but of those with common harmonics only the most certain one."""
    reported: list[Evidence] = []
    found, spread = [], []
    orders = _orders(parts)
    for e in sorted((e for e in evidence if e.kind == "bearing" and e.found), key=lambda e: e.probability):
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
        found.append(Finding("bearing", e.shaft, (e.gear,), e.channel, e.probability))
    return found, spread


def _orders(parts: TurningParts) -> dict[tuple[str, str], float]:
    """Orders by the names of bearing and part."""
    return {(b.name, part): order for b in alike(parts.bearings) for part, order in b.orders.items()}


def _of_bearings(
    e: Evidence,
    found: list[Finding],
    views: Mapping[tuple[str, str], ShaftView],
    parts: TurningParts,
) -> bool:
    """Whether the line of a shaft is a harmonic of a bearing that is surer, as far as is resolved."""
    orders = _orders(parts)
    for finding in found:
        order = orders[finding.gears[0], finding.shaft]
        off = abs(e.order - round(e.order / order) * order)
        if finding.probability < e.probability and off < 2.0 * views[e.channel, e.shaft].spectrum.resolution:
            return True
    return False


def _whole(one: float, other: float) -> bool:
    """Whether one order is a multiple of the other, within what rolling elements slip."""
    ratio = max(one, other) / min(one, other)
    return abs(ratio - round(ratio)) < SLIP * ratio


def _like_bearings(parts: TurningParts, views: list[ShaftView], threshold: float) -> tuple[str, ...]:
    """Parts of bearings that would strike at the same orders of a shaft, if only those stand out."""
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
