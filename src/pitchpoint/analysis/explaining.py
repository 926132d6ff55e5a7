# SPDX-License-Identifier: Apache-2.0
"""Evidence explained by a more certain finding: tests repeated without the lines of that finding.

The impacts of a damaged bearing are a pulse train. Modulation by the load zone and products with the meshes
add lines around its harmonics, and a long train has so many lines that some coincide with lines of other
parts. Their frequencies are known to a fraction of a line of the record. They are therefore removed from the
signal, and the test of the other part is repeated on the residual.

Derivation: docs/theory/signals.md, "Statistical tests".
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.bearing_tests import HARMONICS as TESTED
from pitchpoint.analysis.bearing_tests import BearingView, alike
from pitchpoint.analysis.findings import COMBS, Evidence
from pitchpoint.analysis.line_tests import FineSpectrum, fine_spectrum
from pitchpoint.analysis.passage_sidebands import passage_sidebands
from pitchpoint.analysis.remarks import Note
from pitchpoint.analysis.sampled import Array
from pitchpoint.analysis.shaft_periods import MESH_HARMONICS, shaft_period
from pitchpoint.analysis.shaft_tests import HARMONICS, LOW_ORDERS, OFF, SIDEBANDS, SLIP, Measured, ShaftView
from pitchpoint.analysis.tones import without_tones
from pitchpoint.analysis.turning_parts import Bearing, TurningParts

BESIDE, ABOUT = 3, 2
"""Sidebands on either side of an impact harmonic, at the speed of the part that carries the damage through
the load; and of products with mesh harmonics, where it is also the highest impact harmonic in the signal."""
REACH = 2.0
"""Distance from tested lines within which others are removed, in lines of the record: the width of a tone."""
COARSE, FINE = 8, 64
"""Number of harmonics used to estimate the impact rate, first within the slip, then around that estimate."""


@dataclass(frozen=True)
class Channel:
    """Data of one channel that the tests use.

    Attributes
    ----------
    values
        Signal over the angle of the reference shaft, shape (n,), any unit.
    samples_per_turn
        Samples per revolution of the reference shaft [-].
    shafts
        Orders by shaft.
    bearings
        Envelopes, if there are bearings.
    """

    values: Array
    samples_per_turn: float
    shafts: Mapping[str, ShaftView]
    bearings: BearingView | None


@dataclass(frozen=True)
class ImpactLines:
    """Lines of the impacts of one damaged bearing part.

    Attributes
    ----------
    rate
        Impacts per revolution of the reference shaft [-].
    modulation
        Order of the part that carries the damage through the load [-]; 0 if there is none.
    meshes
        Orders of the mesh harmonics modulated by the impacts, shape (n,) [-].
    ball
        Whether the damage is on a rolling element, which is carried by the cage.
    """

    rate: float
    modulation: float
    meshes: Array
    ball: bool = False

    def lines(self, highest: float, *, envelope: bool) -> Array:
        """Orders of the lines below `highest`, in the signal or in its envelope, shape (n,)."""
        # a spot on a ball touches both rings in turn, and the impacts may differ
        own = 0.5 * self.rate if self.ball else self.rate
        # harmonics of the modulation alone are lines of shaft or mesh, except for those of a cage
        alone = self.modulation * np.arange(1, BESIDE + 1) if self.ball else np.empty(0)
        strikes = own * np.arange(1, int(highest / own) + 1)
        single = np.add.outer(strikes, self._sides(BESIDE)).ravel()
        # an envelope has the difference orders of impact and mesh lines
        count = int(highest / self.rate) + 1 if envelope else ABOUT
        about = self.rate * np.concatenate([np.arange(-count, 0), np.arange(1, count + 1)])
        both = np.add.outer(np.add.outer(self.meshes, about).ravel(), self._sides(ABOUT)).ravel()
        place = np.concatenate([alone, single, both])
        return np.asarray(place[(place > 0.0) & (place < highest)], dtype=np.float64)

    def have_sideband(self, order: float, spectrum: FineSpectrum) -> bool:
        """Whether a line is a sideband of the impacts and not larger than the impact harmonics.

        The load on a damage is never negative, and no line of a nonnegative function exceeds its mean:
        therefore no sideband is larger than the largest impact harmonic.
        """
        sides = self._sides(BESIDE)
        strikes = self.rate * np.arange(1, np.ceil(order / self.rate) + BESIDE)
        places = np.add.outer(strikes, sides[sides != 0.0])
        there = np.abs(places - order) <= OFF * spectrum.resolution
        largest = spectrum.power(self.rate * np.arange(1, TESTED + 1)).max()
        return bool(there.any() and spectrum.power(order) <= largest)

    def _sides(self, most: int) -> Array:
        """Distances of the sidebands from a harmonic, 0 included."""
        sides = self.modulation * np.arange(-most, most + 1, dtype=np.float64)
        return np.asarray(sides if self.modulation else sides[:1], dtype=np.float64)


def explain(
    evidence: tuple[Evidence, ...],
    channels: Mapping[str, Channel],
    parts: TurningParts,
    tests: int,
) -> tuple[tuple[Evidence, ...], list[Note]]:
    """Mark evidence that is explained by more certain bearing findings.

    Parameters
    ----------
    evidence
        All tests.
    channels
        Data of the tests, by channel.
    parts
        Rotating parts of the machine.
    tests
        Number of tests that share the false alarm probability [-].

    Returns
    -------
    tuple of Evidence
        All tests; explained ones are marked and no longer found.
    list of Note
        Remarks on explained tests and their causes.

    Notes
    -----
    Starting with the most certain ring or ball, its lines k f ± j n, alone and around mesh harmonics, are
    fitted to signal and envelopes by least squares and removed; tests that no longer exceed their limit are
    explained. The impact rate f is where these lines are strongest; n is the speed of the part that carries
    the damage through the load: the shaft for the rings, the cage for a ball [1]_. A ball explains the test
    of its cage at any certainty. A tone at a distance of d lines of the record from a removed line keeps
    1 - sinc²(d) of its power, so that a second fault is still found unless it coincides. Valid for impacts
    whose rate is constant within the resolution of the record.

    References
    ----------
    .. [1] P. D. McFadden, J. D. Smith, Model for the vibration produced by a single point defect in a rolling
       element bearing, Journal of Sound and Vibration 96(1), 1984, 69-82.

    Examples
    --------
    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> explain((), {}, train_parts([(21, 40)]), 1)
    ((), [])
    """
    left = list(evidence)
    notes: list[Note] = []
    reported: dict[tuple[str, str], ImpactLines] = {}
    bearings = [k for k, e in enumerate(evidence) if e.kind == "bearing" and e.shaft != "cage"]
    for number in sorted(bearings, key=lambda k: evidence[k].probability):
        now = left[number]
        if not now.found or (now.gear, now.shaft) in reported:
            continue
        other = _among_others(now, left, channels, parts, list(reported.values()), tests)
        if other is not None:
            left[number] = _explained(now, other, notes)
            continue
        reported[now.gear, now.shaft] = _strikes_of(now, channels[now.channel], parts)
        for k, e in enumerate(left):
            if not e.found or (e.gear, e.shaft) in reported or not _may_explain(now, e):
                continue
            if _vanishes(e, channels, parts, list(reported.values()), tests):
                left[k] = _explained(e, f"{now.shaft} of {now.gear}", notes)
    loud = {f"{part} of {bearing}": one.rate for (bearing, part), one in reported.items()}
    loud |= _passing(evidence, parts)
    for k, e in enumerate(left):
        asked = bool(loud) and e.found and e.kind in ("sidebands", "low order")
        if asked and _vanishes(e, channels, parts, list(reported.values()), tests, tuple(loud.values())):
            left[k] = _explained(e, " and ".join(loud), notes)
    return tuple(left), notes


def _passing(evidence: tuple[Evidence, ...], parts: TurningParts) -> dict[str, float]:
    """Ball passes per revolution of the reference shaft in bearings that modulate meshes without impacts."""
    seen = [e for e in evidence if e.kind == "bearing" and e.shaft == "outer ring" and e.explained]
    found: dict[str, float] = {}
    for e in sorted(seen, key=lambda e: e.threshold - e.value):
        # the significant harmonic gives the slip
        found.setdefault(f"ball passage in {e.gear}", e.order / round(e.order / _nominal(e, parts)))
    return found


def _vanishes(
    e: Evidence,
    channels: Mapping[str, Channel],
    parts: TurningParts,
    reported: list[ImpactLines],
    tests: int,
    loud: Sequence[float] = (),
) -> bool:
    """Whether a test is no longer significant without the lines of reported or loud impacts."""
    rest = _again(e, channels[e.channel], parts, reported, loud)
    chance = float(-np.expm1(tests * np.log1p(-min(rest.probability, 1.0 - 1e-16))))
    return chance >= e.allowed


def _explained(e: Evidence, cause: str, notes: list[Note]) -> Evidence:
    """The test marked as explained; appends a note."""
    notes.append(Note(f"explained by {cause}, without whose lines it is not significant: {{}}", _what(e)))
    return replace(e, found=False, explained=cause)


def _among_others(
    now: Evidence,
    evidence: list[Evidence],
    channels: Mapping[str, Channel],
    parts: TurningParts,
    reported: list[ImpactLines],
    tests: int,
) -> str | None:
    """Cause of the lines of a bearing part in several less certain parts together, or None.

    Impacts at three times the rate have every third line of slower impacts; ball passage of healthy bearings
    adds the others. A ball with nearly four impacts per revolution has lines near those of a broken tooth and
    near the sidebands of an inner ring with nearly five. The part that has all these lines appears the most
    certain. Without the lines of the others it is then not significant, while impacts of its own would leave
    the lines in between. Parts whose lines do not coincide with those of another are not tested.
    """
    trains, names, together = list(reported), [], False
    rate = _nominal(now, parts)
    for e in evidence:
        if not e.found or (e.gear, e.shaft) == (now.gear, now.shaft):
            continue
        if e.kind == "bearing" and e.shaft != "cage":
            trains.append(_strikes_of(e, channels[e.channel], parts))
            names.append(f"{e.shaft} of {e.gear}")
            together |= _runs_with(_nominal(e, parts) / rate, 2)
            seen = channels[now.channel].bearings
            assert seen is not None
            if not together and trains[-1].have_sideband(now.order, seen.spectra[1]):
                # a part that has lines of its own is not explained
                mine = _strikes_of(now, channels[now.channel], parts)
                together = not _vanishes(e, channels, parts, [mine], tests)
        elif e.kind in COMBS:
            turn = float(parts.shaft(e.shaft).order)
            trains.append(ImpactLines(turn, 0.0, np.empty(0)))
            names.append(f"the local fault on {e.shaft}")
            together |= _runs_with(rate / turn, 1)
    if together and _vanishes(now, channels, parts, trains, tests):
        return " and ".join(dict.fromkeys(names))
    return None


def _runs_with(ratio: float, least: int) -> bool:
    """Whether the ratio of two rates is a whole number within the slip of rolling bearings."""
    return round(ratio) >= least and abs(ratio - round(ratio)) <= SLIP * ratio


def _nominal(e: Evidence, parts: TurningParts) -> float:
    """Kinematic impact rate of a bearing part per revolution of the reference shaft."""
    return float(next(b for b in alike(parts.bearings) if b.name == e.gear).orders[e.shaft])


def _strikes_of(e: Evidence, channel: Channel, parts: TurningParts) -> ImpactLines:
    """Impacts of a part that was found, at the rate at which their lines are strongest."""
    bearing = next(b for b in alike(parts.bearings) if b.name == e.gear)
    nominal = _nominal(e, parts)
    modulation = _carried(bearing, e.shaft, parts)
    meshes = {h * parts.mesh_order(mesh) for mesh in parts.meshes for h in range(1, HARMONICS + 1)}
    assert channel.bearings is not None
    spectra = channel.bearings.spectra[:2]
    rate, reach = nominal, SLIP
    for harmonics in (COARSE, FINE):
        step = 0.25 * spectra[0].resolution / (harmonics * nominal)
        tried = rate * (1.0 + step * np.arange(-np.ceil(reach / step), np.ceil(reach / step) + 1))
        gain = sum(_gain(one, tried, modulation, harmonics) for one in spectra)
        rate, reach = float(tried[int(np.argmax(gain))]), 2.0 * step
    return ImpactLines(rate, modulation, np.array(sorted(meshes)), e.shaft == "rolling element")


def _may_explain(cause: Evidence, e: Evidence) -> bool:
    """Whether a test is less certain than the cause, or is that of the cage of a damaged ball."""
    carries = e.shaft == "cage" and cause.shaft == "rolling element" and e.gear == cause.gear
    return carries or e.probability > cause.probability


def _carried(bearing: Bearing, part: str, parts: TurningParts) -> float:
    """Order of the part that carries the damage through the load."""
    if part == "rolling element":
        return bearing.orders.get("cage", 0.0)
    return float(parts.shaft(bearing.shaft).order) if bearing.shaft else 0.0


def _gain(spectrum: FineSpectrum, tried: Array, modulation: float, harmonics: int) -> Array:
    """Sum of the log levels at the lines of the impacts, for each trial rate."""
    total = np.zeros(tried.size)
    for k in range(1, harmonics + 1):
        for side in (-modulation, 0.0, modulation):
            place = k * tried + side
            if place[0] > 0.0 and place[-1] < 0.9 * spectrum.highest:
                total += np.log(np.maximum(spectrum.power(place), 1e-300))
    return total


def _again(
    e: Evidence, channel: Channel, parts: TurningParts, reported: list[ImpactLines], loud: Sequence[float]
) -> Measured:
    """Repeat the test of a part without the lines of reported or loud impacts."""
    if e.kind == "bearing":
        return _bearing_again(e, channel, parts, reported)
    rate, view = channel.samples_per_turn, channel.shafts[e.shaft]
    order: Array = view.order * np.arange(1, view.highest + 1, dtype=np.float64)
    mesh, teeth = parts.gears_of(e.shaft).get(e.gear, (None, 0))
    if e.kind == "low order":
        order = order[:LOW_ORDERS]
    elif e.kind == "period":
        order = order[: MESH_HARMONICS * teeth]
    elif mesh is not None:
        about = parts.mesh_order(mesh) * np.arange(1, HARMONICS + 1)
        off = np.abs(order[:, None] - about).min(axis=1)
        order = order[off < (SIDEBANDS + 0.5) * view.order]
    known = _near(_lines(reported, 0.5 * rate), order, REACH * view.spectrum.resolution)
    if loud:
        known = np.union1d(known, passage_sidebands(view, order, loud, REACH))
    values = without_tones(channel.values, rate, known)
    if e.kind == "period":
        return shaft_period(values, rate, view, teeth)
    rest = ShaftView(fine_spectrum(values, rate), parts, view.shaft, view.rms, view.sampled)
    if e.kind == "comb":
        return rest.comb()
    return rest.low_orders() if mesh is None else rest.sidebands(parts.mesh_order(mesh), teeth)


def _bearing_again(
    e: Evidence, channel: Channel, parts: TurningParts, reported: list[ImpactLines]
) -> Measured:
    """Repeat the test of a bearing part without the lines of reported impacts in signal and envelopes."""
    assert channel.bearings is not None
    order = _nominal(e, parts)
    highest, line = 0.5 * channel.samples_per_turn, channel.bearings.spectra[0].resolution
    every: Array = order * np.arange(1, int(highest / order), dtype=np.float64)
    comb = _near(_lines(reported, highest), every, REACH * line)
    tested = every[:TESTED]
    between = _lines(reported, min(float(2.0 * tested[-1]), highest), envelope=True)
    envelope = _near(between, tested, SLIP * tested + REACH * line)
    return channel.bearings.part(order, (comb, envelope, envelope))[0]


def _lines(reported: list[ImpactLines], highest: float, *, envelope: bool = False) -> Array:
    """Orders of the lines of all reported impacts, increasing."""
    lines = [one.lines(0.999 * highest, envelope=envelope) for one in reported]
    return np.sort(np.concatenate([np.empty(0), *lines]))


def _near(place: Array, tested: Array, reach: ArrayLike) -> Array:
    """Lines within `reach` of tested orders, which are increasing, shape (n,)."""
    limit = np.broadcast_to(np.asarray(reach, dtype=np.float64), tested.shape)
    at = np.searchsorted(tested, place)
    near = np.zeros(place.size, dtype=bool)
    for k in (np.maximum(at - 1, 0), np.minimum(at, tested.size - 1)):
        near |= np.abs(place - tested[k]) <= limit[k]
    return place[near]


def _what(e: Evidence) -> str:
    """Short name of a test in messages."""
    if e.kind == "sidebands":
        return f"sidebands of {e.gear} at the speed of {e.shaft} in {e.channel}"
    if e.kind == "period":
        return f"period of {e.shaft} in the level of {e.gear} in {e.channel}"
    what = {"comb": "all orders", "low order": "lowest orders"}.get(e.kind, e.shaft)
    return f"{what} of {e.gear or e.shaft} in {e.channel}"
