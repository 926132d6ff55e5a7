# SPDX-License-Identifier: Apache-2.0
"""Evidence that a surer finding causes: what is left of it without the lines of that finding?

The strikes of a damaged bearing are a pulse train. What changes their size (the load zone through which the
damage goes) and what they shake (the meshes) puts lines next to their harmonics, and a long train has so many
of them that some lie on lines of other parts. They are known to a fraction of a line of the record. So they
are taken out of the signal, and the test of the other part is made again on what is left.

Derivation: docs/theory/signals.md, "Statistical tests".
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.bearing_tests import HARMONICS as TESTED
from pitchpoint.analysis.bearing_tests import BearingView, alike
from pitchpoint.analysis.findings import Evidence
from pitchpoint.analysis.line_tests import FineSpectrum, fine_spectrum
from pitchpoint.analysis.passage_sidebands import passage_sidebands
from pitchpoint.analysis.remarks import Note
from pitchpoint.analysis.sampled import Array
from pitchpoint.analysis.shaft_tests import HARMONICS, LOW_ORDERS, OFF, SIDEBANDS, SLIP, Measured, ShaftView
from pitchpoint.analysis.tones import without_tones
from pitchpoint.analysis.turning_parts import Bearing, TurningParts

BESIDE, ABOUT = 3, 2
"""Lines on either side of a harmonic of the strikes, at the turns of what carries it through the load; and of
their products with mesh harmonics, where it also is the highest harmonic of the strikes in the signal."""
REACH = 2.0
"""How far about lines that are tested others are taken out, in lines of the record: a tone is no wider."""
COARSE, FINE = 8, 64
"""Harmonics by which the rate of the strikes is found, first within the slip, then about that."""


@dataclass(frozen=True)
class Channel:
    """What tests of one channel look at.

    Attributes
    ----------
    values
        Signal over the angle of the reference shaft, shape (n,), any unit.
    samples_per_turn
        Samples in one turn of the reference shaft [-].
    shafts
        Orders by shaft.
    bearings
        Envelopes, if there are bearings to look for.
    """

    values: Array
    samples_per_turn: float
    shafts: Mapping[str, ShaftView]
    bearings: BearingView | None


@dataclass(frozen=True)
class Strikes:
    """Lines that the strikes of one part of a bearing have.

    Attributes
    ----------
    rate
        Strikes in one turn of the reference shaft [-].
    modulation
        Turns of what carries the damage through the load [-]; 0 if nothing does.
    meshes
        Orders of the mesh harmonics that the strikes shake, shape (n,) [-].
    ball
        Whether the damage is on a rolling element, which the cage carries.
    """

    rate: float
    modulation: float
    meshes: Array
    ball: bool = False

    def lines(self, highest: float, *, envelope: bool) -> Array:
        """Orders of the lines up to a highest one, of the signal or of its envelope, shape (n,)."""
        # a spot on a ball meets one ring after the other, and need not strike both alike
        own = 0.5 * self.rate if self.ball else self.rate
        # without a strike it is a line of the shaft or of the mesh itself; nothing else turns with a cage
        alone = self.modulation * np.arange(1, BESIDE + 1) if self.ball else np.empty(0)
        strikes = own * np.arange(1, int(highest / own) + 1)
        single = np.add.outer(strikes, self._sides(BESIDE)).ravel()
        # an envelope holds what lies between a line of the strikes and one of a mesh
        count = int(highest / self.rate) + 1 if envelope else ABOUT
        about = self.rate * np.concatenate([np.arange(-count, 0), np.arange(1, count + 1)])
        both = np.add.outer(np.add.outer(self.meshes, about).ravel(), self._sides(ABOUT)).ravel()
        place = np.concatenate([alone, single, both])
        return np.asarray(place[(place > 0.0) & (place < highest)], dtype=np.float64)

    def have_sideband(self, order: float, spectrum: FineSpectrum) -> bool:
        """Whether a line is a sideband of strikes, not on them, and is not larger than these.

        The load that a damage goes through only pushes, and no line of a function without negative values is
        larger than its mean: none next to the strikes is larger than the largest of their own.
        """
        sides = self._sides(BESIDE)
        strikes = self.rate * np.arange(1, np.ceil(order / self.rate) + BESIDE)
        places = np.add.outer(strikes, sides[sides != 0.0])
        there = np.abs(places - order) <= OFF * spectrum.resolution
        largest = spectrum.power(self.rate * np.arange(1, TESTED + 1)).max()
        return bool(there.any() and spectrum.power(order) <= largest)

    def _sides(self, most: int) -> Array:
        """Distances of the lines next to a harmonic."""
        sides = self.modulation * np.arange(-most, most + 1, dtype=np.float64)
        return np.asarray(sides if self.modulation else sides[:1], dtype=np.float64)


def explain(
    evidence: tuple[Evidence, ...],
    channels: Mapping[str, Channel],
    parts: TurningParts,
    tests: int,
) -> tuple[tuple[Evidence, ...], list[Note]]:
    """Evidence without that which surer bearings bring about.

    Parameters
    ----------
    evidence
        All tests.
    channels
        What they looked at, by channel.
    parts
        What turns.
    tests
        Number of tests that share the false alarms [-].

    Returns
    -------
    tuple of Evidence
        The same, with what is explained no longer found.
    list of Note
        What was explained, and by what.

    Notes
    -----
    From the surest ring or ball on, its lines k f ± j n, alone and about mesh harmonics, are fitted to
    signal and envelopes by least squares and taken out; tests that no longer exceed their limit are
    explained. The strike rate f is where these lines are strongest; n is the speed of what carries the
    damage through the load: the shaft for the rings, the cage for a ball [1]_, whose own test a ball
    explains at any certainty. A tone at a fraction d of a line of the record from one of those keeps
    1 - sinc²(d) of its power, so that a second fault stays found unless it lies on them. Valid for strikes
    whose rate does not wander by more than the record resolves.

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
    reported: dict[tuple[str, str], Strikes] = {}
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
    """Passages in one turn of the reference shaft of balls that are seen to modulate, but not to strike."""
    seen = [e for e in evidence if e.kind == "bearing" and e.shaft == "outer ring" and e.explained]
    found: dict[str, float] = {}
    for e in sorted(seen, key=lambda e: e.threshold - e.value):
        # the harmonic that stands out gives their slip
        found.setdefault(f"balls that pass in {e.gear}", e.order / round(e.order / _nominal(e, parts)))
    return found


def _vanishes(
    e: Evidence,
    channels: Mapping[str, Channel],
    parts: TurningParts,
    reported: list[Strikes],
    tests: int,
    loud: Sequence[float] = (),
) -> bool:
    """Whether nothing of a test stands out without the lines of reported or loud strikes."""
    rest = _again(e, channels[e.channel], parts, reported, loud)
    chance = float(-np.expm1(tests * np.log1p(-min(rest.probability, 1.0 - 1e-16))))
    return chance >= e.allowed


def _explained(e: Evidence, cause: str, notes: list[Note]) -> Evidence:
    """The test, no longer found, and a note about it."""
    notes.append(Note(f"explained by {cause}, without whose lines nothing of it stands out: {{}}", _what(e)))
    return replace(e, found=False, explained=cause)


def _among_others(
    now: Evidence,
    evidence: list[Evidence],
    channels: Mapping[str, Channel],
    parts: TurningParts,
    reported: list[Strikes],
    tests: int,
) -> str | None:
    """What brings the lines of a bearing's part about, although each of these parts is less sure.

    Strikes that come three times as often have every third line of the slower ones, to which passing healthy
    balls add the others. A ball that strikes nearly four times a turn has lines near those of a broken tooth,
    and near the sidebands of an inner ring that strikes nearly five times. Whoever has all these lines looks
    the surest. Without the lines of the others nothing of it stands out then, while strikes of its own would
    leave the lines in between. Parts whose lines do not run together with those of another are not asked.
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
                # what has lines of its own stays
                mine = _strikes_of(now, channels[now.channel], parts)
                together = not _vanishes(e, channels, parts, [mine], tests)
        elif e.kind == "comb":
            turn = float(parts.shaft(e.shaft).order)
            trains.append(Strikes(turn, 0.0, np.empty(0)))
            names.append(f"the local fault on {e.shaft}")
            together |= _runs_with(rate / turn, 1)
    if together and _vanishes(now, channels, parts, trains, tests):
        return " and ".join(dict.fromkeys(names))
    return None


def _runs_with(ratio: float, least: int) -> bool:
    """Whether a ratio of two rates is a whole number to within the slip of rolling."""
    return round(ratio) >= least and abs(ratio - round(ratio)) <= SLIP * ratio


def _nominal(e: Evidence, parts: TurningParts) -> float:
    """Strikes of a part of a bearing in one turn of the reference shaft, by kinematics."""
    return float(next(b for b in alike(parts.bearings) if b.name == e.gear).orders[e.shaft])


def _strikes_of(e: Evidence, channel: Channel, parts: TurningParts) -> Strikes:
    """Strikes of a part that was found, with the rate at which their lines are strongest."""
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
    return Strikes(rate, modulation, np.array(sorted(meshes)), e.shaft == "rolling element")


def _may_explain(cause: Evidence, e: Evidence) -> bool:
    """Whether a test is less certain than the cause, or one of the cage that carries a ball about."""
    carries = e.shaft == "cage" and cause.shaft == "rolling element" and e.gear == cause.gear
    return carries or e.probability > cause.probability


def _carried(bearing: Bearing, part: str, parts: TurningParts) -> float:
    """Turns of what carries a damage through the load."""
    if part == "rolling element":
        return bearing.orders.get("cage", 0.0)
    return float(parts.shaft(bearing.shaft).order) if bearing.shaft else 0.0


def _gain(spectrum: FineSpectrum, tried: Array, modulation: float, harmonics: int) -> Array:
    """Sum of the levels at the lines of strikes, for each rate that is tried."""
    total = np.zeros(tried.size)
    for k in range(1, harmonics + 1):
        for side in (-modulation, 0.0, modulation):
            place = k * tried + side
            if place[0] > 0.0 and place[-1] < 0.9 * spectrum.highest:
                total += np.log(np.maximum(spectrum.power(place), 1e-300))
    return total


def _again(
    e: Evidence, channel: Channel, parts: TurningParts, reported: list[Strikes], loud: Sequence[float]
) -> Measured:
    """The test of a part on what is left without the lines of reported or loud strikes."""
    if e.kind == "bearing":
        return _bearing_again(e, channel, parts, reported)
    rate, view = channel.samples_per_turn, channel.shafts[e.shaft]
    order: Array = view.order * np.arange(1, view.highest + 1, dtype=np.float64)
    mesh, teeth = parts.gears_of(e.shaft).get(e.gear, (None, 0))
    if e.kind == "low order":
        order = order[:LOW_ORDERS]
    elif mesh is not None:
        about = parts.mesh_order(mesh) * np.arange(1, HARMONICS + 1)
        off = np.abs(order[:, None] - about).min(axis=1)
        order = order[off < (SIDEBANDS + 0.5) * view.order]
    known = _near(_lines(reported, 0.5 * rate), order, REACH * view.spectrum.resolution)
    if loud:
        known = np.union1d(known, passage_sidebands(view, order, loud, REACH))
    spectrum = fine_spectrum(without_tones(channel.values, rate, known), rate)
    rest = ShaftView(spectrum, parts, view.shaft, view.rms, view.sampled)
    if e.kind == "comb":
        return rest.comb()
    return rest.low_orders() if mesh is None else rest.sidebands(parts.mesh_order(mesh), teeth)


def _bearing_again(e: Evidence, channel: Channel, parts: TurningParts, reported: list[Strikes]) -> Measured:
    """The test of a part of a bearing on what is left of the signal and of both envelopes."""
    assert channel.bearings is not None
    order = _nominal(e, parts)
    highest, line = 0.5 * channel.samples_per_turn, channel.bearings.spectra[0].resolution
    every: Array = order * np.arange(1, int(highest / order), dtype=np.float64)
    comb = _near(_lines(reported, highest), every, REACH * line)
    tested = every[:TESTED]
    between = _lines(reported, min(float(2.0 * tested[-1]), highest), envelope=True)
    envelope = _near(between, tested, SLIP * tested + REACH * line)
    return channel.bearings.part(order, (comb, envelope, envelope))[0]


def _lines(reported: list[Strikes], highest: float, *, envelope: bool = False) -> Array:
    """Lines of all reported strikes, rising."""
    lines = [one.lines(0.999 * highest, envelope=envelope) for one in reported]
    return np.sort(np.concatenate([np.empty(0), *lines]))


def _near(place: Array, tested: Array, reach: ArrayLike) -> Array:
    """Lines that are near to others, which rise and are tested, shape (n,)."""
    limit = np.broadcast_to(np.asarray(reach, dtype=np.float64), tested.shape)
    at = np.searchsorted(tested, place)
    near = np.zeros(place.size, dtype=bool)
    for k in (np.maximum(at - 1, 0), np.minimum(at, tested.size - 1)):
        near |= np.abs(place - tested[k]) <= limit[k]
    return place[near]


def _what(e: Evidence) -> str:
    """A test in a few words."""
    if e.kind == "sidebands":
        return f"sidebands of {e.gear} at the turns of {e.shaft} in {e.channel}"
    what = {"comb": "all orders", "low order": "lowest orders"}.get(e.kind, e.shaft)
    return f"{what} of {e.gear or e.shaft} in {e.channel}"
