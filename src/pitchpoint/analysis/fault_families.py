# SPDX-License-Identifier: Apache-2.0
"""Joint test of all parts of rolling bearings: families of lines in a squared envelope spectrum.

A damaged part has lines at all multiples of its fault order. Lines of another part coincide with some of
them, such as every third line of the outer ring with every second one of the inner ring, but not with the
first three at a common scale. All parts compete: the clearest one is accepted, and its lines with their
sidebands are not evidence for the others.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.family_lines import FamilyLines, background, envelope_lines
from pitchpoint.analysis.family_search import BearingPart, FamilySearch, FaultFamily, LevelLimits
from pitchpoint.analysis.impact_orders import impact_order
from pitchpoint.analysis.sampled import SignalError, as_signal, positive
from pitchpoint.analysis.turning_parts import TurningParts
from pitchpoint.core.errors import join_notes

UNKNOWN = "no given part"
"""Cause of impacts that are not those of a given bearing."""
UNLOADED = 0.05
"""Largest slip of a bearing whose load is too low for rolling."""


@dataclass(frozen=True)
class FaultFamilies:
    """Evidence of all parts of all bearings.

    Attributes
    ----------
    families
        All tested parts, detected ones first, in the order of their significance.
    shaft_scale
        Factor on the shaft orders, from the lines of the reference shaft [-]; NaN if they are not prominent.
    resolution
        Distance of the lines of the spectrum [orders].
    notes
        Parts that were not tested, with the reason.
    """

    families: tuple[FaultFamily, ...]
    shaft_scale: float
    resolution: float
    notes: tuple[str, ...] = ()

    @property
    def named(self) -> tuple[FaultFamily, ...]:
        """The detected parts."""
        return tuple(family for family in self.families if family.named)


def fault_families(
    squared_envelope: ArrayLike,
    samples_per_turn: float,
    parts: TurningParts,
    *,
    tolerance: float = 0.02,
    slip: float = 0.01,
    prominence: float = 12.0,
    false_alarm: float = 0.01,
) -> FaultFamilies:
    """Test all parts of all bearings jointly for families of lines at their fault orders.

    Parameters
    ----------
    squared_envelope
        Squared envelope over the angle of the reference shaft, shape (n,), any unit; that of the whitened
        signal has a flat background.
    samples_per_turn
        Samples per revolution of the reference shaft [-]; sample rate over assumed speed for a signal over
        time at constant speed.
    parts
        Shafts, the first one as reference, and bearings.
    tolerance
        Maximum relative deviation of the assumed speed [-], common to all parts.
    slip
        Maximum relative deviation of the orders of a bearing due to slip [-].
    prominence
        Minimum level of each of the first three harmonics, five of a cage, above the local median [dB]; for
        averaged lines the level of the same probability. A level may be 4 dB lower if their mean is 3 dB
        higher.
    false_alarm
        Probability that noise alone leads to any detection [-].

    Returns
    -------
    FaultFamilies
        All parts with their evidence.

    Raises
    ------
    SignalError
        If the record is too short, there is no bearing, or a limit is out of range.

    Notes
    -----
    For every part, the scale s and the number of averaged lines are determined at which the largest of the
    probabilities p_k of its lines k o s, k = 1 ... n, is smallest. Independent lines of noise are all as
    significant with the probability p^n at each of N scales and averages, 1 - (1 - p^n)^N in total (Šidák
    [1]_). If all lines of a part are lines k o ± j m of another one, but not vice versa, it is explained by
    the latter; m is the speed of the shaft for rings, of the cage for rolling elements [2]_. The clearest of
    the other parts is accepted, and the test of the rest is repeated without its lines, at scales that differ
    from its own by at most twice the slip. Parts that are harmonics of each other cannot be distinguished:
    both are named. A cage is not distinguished from a damaged rolling element, which modulates the signal at
    the speed of the cage. Lines of the shafts are removed if the speed is known or the first three of the
    reference shaft are prominent, which correct a known speed by at most 1 %. Valid for steady speed or
    signals over the angle, and at least 16 events of a part.

    References
    ----------
    .. [1] Z. Šidák, Rectangular confidence regions for the means of multivariate normal distributions,
       Journal of the American Statistical Association 62, 1967, 626-633.
    .. [2] R. B. Randall, J. Antoni, Rolling element bearing diagnostics - a tutorial, Mechanical Systems and
       Signal Processing 25(2), 2011, 485-520.

    Examples
    --------
    Impacts at 3.62 per revolution in noise: the outer ring with 1 % deviation.

    >>> from fractions import Fraction
    >>> from pitchpoint.analysis.turning_parts import Bearing, Shaft
    >>> orders = {"outer ring": 3.585, "inner ring": 5.415, "rolling element": 4.714, "cage": 0.398}
    >>> parts = TurningParts((Shaft("rotor", Fraction(1)),), (), (Bearing("left", orders, "rotor"),))
    >>> turned = np.arange(60_000) / 300
    >>> impacts = np.exp(-20 * (turned * 3.62 % 1)) + np.random.default_rng(1).exponential(0.3, turned.size)
    >>> [(family.name, round(family.scale, 4)) for family in fault_families(impacts, 300, parts).named]
    [('outer ring of left', 1.0098)]
    """
    x = as_signal(squared_envelope, "squared_envelope", minimum=1024)
    rate = positive(samples_per_turn, "samples_per_turn")
    turns = x.size / rate
    level = positive(prominence, "prominence")
    limits = LevelLimits.of_envelope(level, background(turns))
    lines = envelope_lines(x, rate, parts, level)
    search = FamilySearch(lines, turns, limits)
    return families_in(search, parts, tolerance, slip, false_alarm, (lines,))


def families_in(
    search: FamilySearch,
    parts: TurningParts,
    tolerance: float,
    slip: float,
    false_alarm: float,
    spectra: Sequence[FamilyLines],
) -> FaultFamilies:
    """Test all parts of all bearings jointly in given lines, as `fault_families` does.

    Parameters
    ----------
    search
        Lines of an envelope spectrum.
    parts
        Shafts, the first one as reference, and bearings.
    tolerance, slip, false_alarm
        As in `fault_families` [-].
    spectra
        Lines of squared envelopes of the same signal, in which impacts of parts that are not given are
        clearer than their sidebands.

    Raises
    ------
    SignalError
        As `fault_families`.

    Notes
    -----
    As `fault_families`, with probabilities shared among the parts [1]_. Valid as there.

    References
    ----------
    .. [1] Z. Šidák, Rectangular confidence regions for the means of multivariate normal distributions,
       Journal of the American Statistical Association 62, 1967, 626-633.
    """
    limits = (("tolerance", tolerance, 0.1), ("slip", slip, 0.1), ("false_alarm", false_alarm, 0.5))
    for name, value, limit in limits:
        if not 0.0 <= value <= limit:
            raise SignalError(f"{name}: {value:g} (limit 0 to {limit:g}); correct it")
    within = (1.0 + tolerance) * (1.0 + slip)
    tested, notes = search.testable(parts, within)
    if not tested:
        raise SignalError("bearings: none can be tested; " + (join_notes(notes) or "state their orders"))
    chance = false_alarm / len(tested)
    scale = search.shaft_scale(parts, tolerance)
    span = (2.0 - within, within) if np.isnan(scale) else (scale * (1.0 - slip), scale * (1.0 + slip))
    first = trials = {part: search.family(part, span, slip) for part in tested}
    found: dict[BearingPart, FaultFamily] = {}
    others: dict[BearingPart, tuple[FaultFamily, str]] = {}
    turning = [] if np.isnan(scale) else [scale * float(shaft.order) for shaft in parts.shafts]
    while clear := {part: t for part, t in trials.items() if t.is_clear(search.limits, chance)}:
        own = [t for t in clear.values() if not any(search.explains(o, t) for o in clear.values())]
        best = min(own or clear.values(), key=lambda t: (t.line_probability.max(), -t.prominence.min()))
        impacts = impact_order(best.order * best.scale, best.part, spectra, turning) if turning else None
        if impacts is not None:
            (part,) = (part for part, t in clear.items() if t is best)
            whose = _of_order(impacts[0], parts, scale, slip)
            others[part] = best, f"impacts at {impacts[0]:.4g} per revolution, of {whose}"
            if whose.startswith(UNKNOWN):
                search.remove(search.at(*impacts))
            trials = {p: search.family(p, span, slip) for p in tested if p not in found and p not in others}
            continue
        alike = {part: t for part, t in clear.items() if t is best or search.alike(best, t)}
        for part, t in alike.items():
            same = tuple(o.name for o in alike.values() if o is not t)
            found[part] = replace(t, named=True, same_lines=same)
            search.remove(t)
        span = (max(span[0], best.scale * (1.0 - 2.0 * slip)), min(span[1], best.scale * (1.0 + 2.0 * slip)))
        trials = {p: search.family(p, span, slip) for p in tested if p not in found and p not in others}
    rest = [replace(t, same_lines=(cause,)) for t, cause in others.values()]
    for part, t in trials.items():
        if part.name == "rolling element":
            # a damaged one modulates at the speed of its cage, and random slip may hide its own lines
            for cage in [p for p in found if (p.bearing, p.name) == (part.bearing, "cage")]:
                found[cage] = replace(found[cage], same_lines=(*found[cage].same_lines, t.name))
        seemed = first[part].is_clear(search.limits, chance)
        explained = [f.name for f in found.values() if seemed and search.explains(f, first[part])]
        rest.append(replace(t, same_lines=tuple(explained)))
    rest.sort(key=lambda t: t.probability)
    return FaultFamilies((*found.values(), *rest), scale, search.step, tuple(notes))


def _of_order(order: float, parts: TurningParts, scale: float, slip: float) -> str:
    """Given parts that have impacts of an order, in words; if none has, the next one that may slip so far."""
    apart = {
        f"{part} of {bearing.name}": order / (nominal * scale) - 1.0
        for bearing in parts.bearings
        for part, nominal in bearing.orders.items()
    }
    if whose := [name for name, share in apart.items() if abs(share) <= slip]:
        return " or ".join(whose)
    name, share = min(apart.items(), key=lambda one: abs(one[1]))
    return f"{UNKNOWN} ({name}: {100.0 * share:+.1f} %)" if abs(share) <= UNLOADED else UNKNOWN
