# SPDX-License-Identifier: Apache-2.0
"""Search for the lines of a damaged bearing part in a squared envelope spectrum, at all possible scales.

Derivation: docs/theory/signals.md, "Statistical tests".
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.family_lines import HIGHEST_HARMONIC, SPARE, FamilyLines
from pitchpoint.analysis.line_prominence import OMITTED, prominence_probability
from pitchpoint.analysis.sampled import Array
from pitchpoint.analysis.turning_parts import TurningParts

Places = NDArray[np.int64]

HARMONICS = 3
"""Harmonics of a part that must be prominent together."""
CAGE_HARMONICS = HIGHEST_HARMONIC - SPARE
"""The same for a cage: unequal rolling elements that pass the load zone cause the lowest ones, too."""
SIDEBANDS = 3
"""Sidebands on either side of the harmonics of a clearer part that are not evidence for others."""
SPREAD, STRONG = 4.0, 3.0
"""How far a single line may be below the limit of all lines if their mean is as far above it [dB]: impacts
whose sharpness varies with the load have weak higher harmonics."""
MIN_EVENTS = 16.0
SUPPLY, MUCH = 0.01, 3.0
"""Largest slip of a shaft behind the lines of its supply, and how much clearer its own lines are [dB]."""
SEPARATE = 2.5
"""Distance of lines of the record from which they are separate with a Hann window."""
MODULATION = {"outer ring": "shaft", "inner ring": "shaft", "rolling element": "cage"}
"""Whose speed the sidebands of a part are apart: that at which the damage passes the load zone, and for the
outer ring that of an unbalance."""


@dataclass(frozen=True)
class BearingPart:
    """Part of a bearing to be tested.

    Attributes
    ----------
    bearing, name
        Names of the bearing and the part.
    order
        Fault order [-].
    spacing
        Order of the shaft or cage that modulates the impacts [-]; 0 for none.
    """

    bearing: str
    name: str
    order: float
    spacing: float = 0.0

    @property
    def harmonics(self) -> int:
        """Number of harmonics that must be prominent together."""
        return CAGE_HARMONICS if self.name == "cage" else HARMONICS


@dataclass(frozen=True)
class LevelLimits:
    """Limit of the lines of a part.

    Attributes
    ----------
    level
        Limit of the level of all lines [dB].
    line
        Probability in noise of a line at this level [-].
    freedom
        Half of the degrees of freedom of the median of the noise [-]; infinite if the noise is known.
    """

    level: float
    line: float
    freedom: float

    @classmethod
    def of_envelope(cls, level: float, background: int) -> LevelLimits:
        """Limit in the spectrum of a squared envelope, for a level above a median of some lines [dB]."""
        line = prominence_probability(10.0 ** (0.1 * level), background)
        return cls(level, float(line), 0.5 * background * np.log(2.0) ** 2)

    @classmethod
    def of_probability(cls, level: float) -> LevelLimits:
        """Limit for a level that states the probability of a line in noise of known level [dB]."""
        return cls(level, float(np.exp2(-(10.0 ** (0.1 * level)))), np.inf)

    def levels(self, probability: Array) -> Array:
        """Levels of single lines of given probabilities in noise [dB], shape (n,).

        The inverse of `prominence_probability`.

        Examples
        --------
        >>> limits = LevelLimits.of_envelope(15.0, 128)
        >>> round(float(limits.levels(np.array([limits.line]))[0]), 9)
        15.0
        """
        chance = -np.log(np.maximum(probability, 1e-300))
        ratio = chance if np.isinf(self.freedom) else self.freedom * np.expm1(chance / self.freedom)
        return np.asarray(10.0 * np.log10(np.maximum(ratio / np.log(2.0), 1e-3)))


@dataclass(frozen=True)
class FaultFamily:
    """Evidence of one part of a bearing.

    Attributes
    ----------
    bearing, part
        Names of the bearing and its part.
    order
        Fault order [-].
    scale
        Factor on the order with the most significant lines [-]: deviation of the speed, and slip.
    harmonic
        Shape (n,). Harmonics of the part that are compared [-]: three, five of a cage.
    prominence
        Shape (n,). Levels of their lines above the local median [dB].
    level
        Shape (n,). The same of averaged lines: levels of single lines of equal probability in noise [dB].
    line_probability
        Shape (n,). Probability of each line in noise, by itself [-].
    average
        Number of lines of the spectrum that are averaged [-], see `line_prominence`.
    probability
        Probability that noise alone has n lines as significant at any scale and average [-].
    spacing
        Distance of the sidebands [orders]; 0 for a part without.
    sidebands
        Shape (n, 4). Levels of the lines two spacings and one below and one and two above each harmonic,
        above the local median [dB]; NaN if there is none.
    same_lines
        Parts from which a detected part is not distinguished; of another part, detected ones that explain all
        its lines.
    named
        Whether this part is detected.
    """

    bearing: str
    part: str
    order: float
    scale: float
    harmonic: Places
    prominence: Array
    level: Array
    line_probability: Array
    average: int
    probability: float
    spacing: float
    sidebands: Array
    same_lines: tuple[str, ...] = ()
    named: bool = False

    @property
    def name(self) -> str:
        """Part and bearing."""
        return f"{self.part} of {self.bearing}" if self.bearing else self.part

    def is_clear(self, limits: LevelLimits, chance: float) -> bool:
        """Whether the lines reach the limit, and not by chance."""
        return self.strength >= limits.level and self.probability <= chance

    @property
    def strength(self) -> float:
        """Level to which the limit applies [dB]: that of the least line; more if the mean is far above it."""
        least, mean = float(self.level.min()), float(self.level.mean())
        return least if self.part == "cage" else max(least, min(least + SPREAD, mean - STRONG))

    @property
    def lines(self) -> Array:
        """Orders of the compared lines, shape (n,) [-]."""
        return np.asarray(self.harmonic * (self.order * self.scale))

    def comb(self, highest: float) -> Array:
        """Orders of all lines up to `highest` that the damage can cause, shape (n,) [-].

        A spot on a rolling element touches both rings in turn, and the impacts may differ: every second line
        is half-way between the harmonics. It also causes the lines of its cage.
        """
        step = self.order * self.scale * (0.5 if self.part == "rolling element" else 1.0)
        harmonics = step * np.arange(0.0, highest / step + 1.0)
        lines = harmonics[:, None] + np.arange(-SIDEBANDS, SIDEBANDS + 1) * self.spacing
        alone = np.arange(1.0, CAGE_HARMONICS + SPARE + 1.0) * self.spacing
        lines = np.unique(np.append(lines, alone if self.part == "rolling element" else []))
        return np.asarray(lines[lines > 0.0])


class FamilySearch:
    """Spectra with different averages, their lines that are not yet explained, and tests of families.

    Parameters
    ----------
    lines
        Lines of the spectrum.
    turns
        Revolutions of the reference shaft in the record [-].
    limits
        Limits of the lines.
    """

    def __init__(self, lines: FamilyLines, turns: float, limits: LevelLimits) -> None:
        self.turns, self.step, self.spectra = turns, lines.step, lines.levels
        self.available = {m: np.ones(s.probability.size, dtype=bool) for m, s in self.spectra.items()}
        self.highest = (OMITTED + self.spectra[1].probability.size - 1) * self.step
        self.limits = limits

    def testable(self, parts: TurningParts, within: float) -> tuple[list[BearingPart], list[str]]:
        """Parts with enough events and harmonics, and notes on the others."""
        tested: list[BearingPart] = []
        notes: list[str] = []
        orders = {shaft.name: float(shaft.order) for shaft in parts.shafts}
        for bearing in parts.bearings:
            speeds = {
                "shaft": orders.get(bearing.shaft, float(parts.shafts[0].order)),
                "cage": bearing.orders.get("cage", 0.0),
            }
            for name, order in bearing.orders.items():
                whose, events = f"{name} of {bearing.name}", order * self.turns
                part = BearingPart(bearing.name, name, order, speeds.get(MODULATION.get(name, ""), 0.0))
                if events < MIN_EVENTS:
                    notes.append(f"{whose}: {events:.2g} events (limit {MIN_EVENTS:g}); use a longer record")
                elif part.harmonics * order * within > self.highest:
                    text = f"harmonic {part.harmonics} is above half the sample rate; not tested"
                    notes.append(f"{whose}: {text}")
                else:
                    tested.append(part)
        return tested, notes

    def shaft_scale(self, parts: TurningParts, tolerance: float) -> float:
        """Scale of the lines of the reference shaft; NaN if it is not known and they are not prominent.

        Otherwise the lines of all shafts are removed: they are not evidence for bearings.
        """
        order = float(parts.shafts[0].order)
        if order * self.turns < MIN_EVENTS:
            return float("nan")
        lines = self._shaft_lines(BearingPart("", "shaft", order), tolerance)
        prominent = bool(np.all(lines.line_probability <= self.limits.line))
        if tolerance > 0.0 and not prominent:
            return float("nan")
        for shaft in parts.shafts:
            step = float(shaft.order) * lines.scale
            if step > 2.0 * (2.0 * SEPARATE + 1.0) * self.step:
                multiples = np.arange(step, self.highest, step)
                width = self._width(lines, multiples) if prominent else np.full(multiples.size, SEPARATE)
                self._remove(multiples, width)
        return lines.scale

    def _shaft_lines(self, shaft: BearingPart, tolerance: float) -> FaultFamily:
        """Lines of the reference shaft within the tolerance; those nearby if they are much clearer.

        A known speed may be that of the electric supply, behind which an induction motor slips; impacts are
        modulated at the speed of the shaft.
        """
        lines = self.family(shaft, (1.0 - tolerance, 1.0 + tolerance), 0.0)
        reach = max(tolerance, SUPPLY)
        near = self.family(shaft, (1.0 - reach, 1.0 + reach), 0.0)
        prominent = bool(np.all(near.line_probability <= self.limits.line))
        return near if prominent and near.strength > lines.strength + MUCH else lines

    def family(self, part: BearingPart, span: tuple[float, float], slip: float) -> FaultFamily:
        """Most significant scale of a part, at the least average for which its lines are prominent."""
        needed = part.harmonics
        step = 0.5 * self.step / (needed * part.order)
        scales = np.linspace(*span, int((span[1] - span[0]) / step) + 2)
        places = self._at(np.arange(1, needed + SPARE + 1)[:, None] * (part.order * scales))
        trials, best = 0, (2.0, 1, 0)
        for m in self.spectra:
            chance, _, chosen = self._chances(m, places, needed)
            trials += np.unique(np.where(chosen, places, -1), axis=1).shape[1]
            at = int(np.argmin(chance))
            # averaged only as far as necessary: a wide mean has the same maximum at many scales
            if best[0] > self.limits.line:
                best = min(best, (float(chance[at]), m, at))
        _, m, at = best
        _, each, chosen = self._chances(m, places[:, at : at + 1], needed)
        rows = np.flatnonzero(chosen[:, 0]) if chosen.sum() == needed else np.arange(needed)
        same = np.all(places == places[:, at : at + 1], axis=0)
        joint = float(each[rows, 0].max()) ** needed
        levels = self._levels(m, places[rows, at])
        found = FaultFamily(
            bearing=part.bearing,
            part=part.name,
            order=part.order,
            scale=float(scales[same].mean()),
            harmonic=rows + 1,
            prominence=levels,
            level=levels if m == 1 else self.limits.levels(each[rows, 0]),
            line_probability=each[rows, 0],
            average=m,
            probability=float(-np.expm1(trials * np.log1p(-min(joint, 1.0 - 1e-16)))),
            spacing=part.spacing,
            sidebands=np.full((needed, 4), np.nan),
        )
        return self._with_sidebands(found, slip) if part.spacing else found

    def at(self, order: float, spacing: float) -> FaultFamily:
        """Lines of impacts of an order with sidebands at a spacing, of no given part."""
        reach = 1.5 * self.step / (HARMONICS * order)
        return self.family(BearingPart("", "impacts", order, spacing), (1.0 - reach, 1.0 + reach), 0.0)

    def explains(self, one: FaultFamily, other: FaultFamily) -> bool:
        """Whether one part can cause all lines of the other, but not vice versa."""
        return self._on(other, one, one.comb(self.highest)) and not self._on(
            one, other, other.comb(self.highest)
        )

    def alike(self, one: FaultFamily, other: FaultFamily) -> bool:
        """Whether the lines of either part are harmonics of the other."""
        many = np.arange(1.0, len(one.harmonic) + len(other.harmonic))
        pairs = ((one, other), (other, one))
        return all(self._on(a, b, many * (b.order * b.scale)) for a, b in pairs)

    def remove(self, family: FaultFamily) -> None:
        """Remove all lines of a part from those available to others.

        At most half of the spectrum is removed where its harmonics are not resolved.
        """
        comb = family.comb(self.highest)
        self._remove(comb, np.minimum(self._width(family, comb), self._resolved(family)))

    def _width(self, family: FaultFamily, orders: Array) -> Array:
        """Distance, in lines, at which lines of a part are not resolved, at any orders, shape of `orders`.

        It grows beyond the compared lines: with the order due to the error of the scale, half a line, and
        with its square due to random slip.
        """
        beyond = np.maximum(orders / family.lines[-1], 1.0)
        return np.asarray(SEPARATE + 0.5 * beyond + (family.average - 1) * beyond**2)

    def _resolved(self, family: FaultFamily) -> float:
        """Quarter of the distance of the harmonics, in lines, or the resolution if this is more."""
        return max(SEPARATE + 1.0, 0.25 * family.order / self.step)

    def _with_sidebands(self, family: FaultFamily, slip: float) -> FaultFamily:
        """Family with the spacing, within the slip, at which the sidebands are clearest."""
        side = np.array([-2.0, -1.0, 1.0, 2.0])
        middle = family.spacing * family.scale
        half = int(np.ceil(2.0 * side[-1] * slip * middle / self.step))
        spacings = middle * (1.0 + slip * np.linspace(-1.0, 1.0, 2 * half + 1))
        orders = family.lines[:, None, None] + side[:, None] * spacings
        places = self._at(orders)
        _, chance = self._probabilities(family.average, places)
        best = int(np.argmin(np.log(np.maximum(chance, 1e-6)).sum(axis=(0, 1))))
        levels = np.where(orders[..., best] > 0.0, self._levels(family.average, places[..., best]), np.nan)
        return replace(family, spacing=float(spacings[best]), sidebands=levels)

    def _at(self, orders: Array) -> Places:
        """Indices of the lines at given orders; outside the spectrum -1."""
        at = np.rint(orders / self.step).astype(np.int64) - OMITTED
        return np.where((at >= 0) & (at < self.spectra[1].probability.size), at, -1)

    def _levels(self, average: int, places: Places) -> Array:
        """Levels of lines above the local median [dB]; outside the spectrum NaN."""
        levels = self.spectra[average].prominence[places].astype(np.float64)
        return np.where(places >= 0, levels, np.nan)

    def _probabilities(self, average: int, places: Places) -> tuple[NDArray[np.bool_], Array]:
        """Which lines are available, and their probabilities; 1 if they are not."""
        free = (places >= 0) & self.available[average][places]
        return free, np.where(free, self.spectra[average].probability[places], 1.0)

    def _chances(self, average: int, places: Places, needed: int) -> tuple[Array, Array, NDArray[np.bool_]]:
        """Largest probability of the first `needed` available harmonics at every scale; each; which."""
        free, each = self._probabilities(average, places)
        count = np.cumsum(free, axis=0)
        chosen = free & (count <= needed)
        worst = np.where(chosen, each, 0.0).max(axis=0)
        return np.where(count[-1] >= needed, worst, 1.0), each, chosen

    def _on(self, family: FaultFamily, other: FaultFamily, comb: Array) -> bool:
        """Whether all lines of a family are among those of another one (comb), which are resolved there."""
        reach = self._width(other, family.lines)
        if np.any(reach > self._resolved(other)):
            return False
        distance = np.abs(family.lines[:, None] - comb).min(axis=1)
        return bool(np.all(distance <= (reach + family.average - 1) * self.step))

    def _remove(self, orders: Array, width: Array) -> None:
        """Remove lines at given orders and those within a width, in lines, shapes (n,)."""
        for m, available in self.available.items():
            reach = np.ceil(width).astype(np.int64) + m - 1
            middle = np.rint(orders / self.step).astype(np.int64) - OMITTED
            depth = np.zeros(available.size + 1)
            np.add.at(depth, np.clip(middle - reach, 0, available.size), 1.0)
            np.add.at(depth, np.clip(middle + reach + 1, 0, available.size), -1.0)
            available[np.cumsum(depth[:-1]) > 0.0] = False
