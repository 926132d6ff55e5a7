# SPDX-License-Identifier: Apache-2.0
"""One event per revolution of a shaft, in the wavelet level of the mesh of each of its gears.

A damaged tooth changes the force of its mesh while it is in contact, for about one tooth pitch. Such an
event has its lines at the lowest orders of the shaft, up to about twice the number of teeth. A ranking of all
orders up to half the sample rate (`ShaftView.comb`) misses them in a wide band: in the published record of a
shovel gearbox, 20 of 655 orders are raised. The approximation of a wavelet decomposition keeps the lowest
orders and the shape of the event.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.comb_chance import evidence_of_comb
from pitchpoint.analysis.combs import comb_lines, record_for_combs
from pitchpoint.analysis.periodicity import HIGHEST_SHARE
from pitchpoint.analysis.sampled import Array, as_signal
from pitchpoint.analysis.shaft_tests import SMALLEST_COMB, Measured, ShaftView
from pitchpoint.analysis.turning_parts import TurningParts
from pitchpoint.analysis.wavelets import approximation, most_levels

if TYPE_CHECKING:
    from pitchpoint.analysis.findings import Evidence

MESH_HARMONICS = 2
"""Mesh harmonics within the level, and highest shaft order tested over the number of teeth."""
KEPT = 8
"""Samples per period of the highest frequency of a level that are kept."""
SEEN_IN_SLOWER = 0.01
"""Probability of the period of a slower shaft below which it may explain that of a faster one."""


@dataclass(frozen=True)
class ToothLevel:
    """Wavelet level that contains the events of single teeth of a mesh.

    Attributes
    ----------
    values
        Shape (n,). Approximation, in the unit of the signal; the signal itself for level 0.
    samples_per_turn
        Samples per revolution of the reference shaft [-].
    level
        Number of the approximation [-]; 0 if twice the mesh order exceeds a quarter of the sample rate.
    """

    values: Array
    samples_per_turn: float
    level: int


def tooth_level(values: Array, samples_per_turn: float, mesh_order: float) -> ToothLevel:
    """Lowest wavelet approximation that contains two harmonics of a mesh.

    Parameters
    ----------
    values
        Signal over the angle of the reference shaft, shape (n,), any unit.
    samples_per_turn
        Samples per revolution of the reference shaft [-].
    mesh_order
        Tooth meshes per revolution of the reference shaft [-].

    Returns
    -------
    ToothLevel
        Approximation, with fewer samples.

    Notes
    -----
    Daubechies wavelet of order 5; approximation L is the band below 1/2^(L+1) of the sample rate [1]_. L is
    the largest with 2 f_mesh within the band, and at most that of the length of the record.

    References
    ----------
    .. [1] S. G. Mallat, A theory for multiresolution signal decomposition: the wavelet representation, IEEE
       Transactions on Pattern Analysis and Machine Intelligence 11(7), 1989, 674-693.

    Examples
    --------
    The published record of a shovel gearbox, 430.4 Hz and a mesh at 3.251 Hz: approximation 5, to 6.725 Hz.

    >>> tooth_level(np.arange(6456.0), 430.4, 3.251271).level
    5
    """
    octaves = np.log2(samples_per_turn / (2.0 * MESH_HARMONICS * mesh_order))
    level = int(np.clip(np.floor(octaves), 0, most_levels(values.size)))
    if level == 0:
        return ToothLevel(values, samples_per_turn, 0)
    step = max(2 ** (level + 1) // KEPT, 1)
    return ToothLevel(approximation(values, level)[::step], samples_per_turn / step, level)


def level_of(
    values: ArrayLike, samples_per_turn: float, parts: TurningParts, shaft: str, gear: str
) -> tuple[Array, float]:
    """Signal in the level of a gear, and its samples per revolution; the signal itself without a gear.

    Parameters
    ----------
    values
        Signal over the angle of the reference shaft, shape (n,), any unit.
    samples_per_turn
        Samples per revolution of the reference shaft [-].
    parts
        Rotating parts of the machine.
    shaft, gear
        A shaft, and a gear on it; empty for the signal itself.

    Examples
    --------
    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> level_of(np.zeros(6400), 34.9, train_parts([(11, 81)]), "shaft 1", "")[1]
    34.9
    """
    x = as_signal(values)
    if not gear:
        return x, samples_per_turn
    found = tooth_level(x, samples_per_turn, parts.mesh_order(parts.gears_of(shaft)[gear][0]))
    return found.values, found.samples_per_turn


def shaft_period(values: Array, samples_per_turn: float, view: ShaftView, teeth: int) -> Measured:
    """Test whether a signal has one event per revolution of a shaft, in the level of one of its meshes.

    Parameters
    ----------
    values
        Signal over the angle of the reference shaft, shape (n,), any unit.
    samples_per_turn
        Samples per revolution of the reference shaft [-].
    view
        Orders of the shaft.
    teeth
        Number of teeth z of the gear [-].

    Returns
    -------
    Measured
        Test with the normal score of its probability, at least zero; no lines if there are too few.

    Notes
    -----
    F test of the orders 1 to 2 z against the lines next to them, in which no line counts for more than 1 in
    100 [1]_; the evidence must remain without the multiples of every prime. Orders at mesh harmonics, and at
    their images beyond half the sample rate, are omitted. Valid for at least three revolutions.

    References
    ----------
    .. [1] B. G. Quinn, E. J. Hannan, The Estimation and Tracking of Frequency, Cambridge University Press,
       2001, chapter 4; the limit on one line is that of `comb_chance`.

    Examples
    --------
    Twenty revolutions of a gear with 11 teeth, one of them damaged:

    >>> from pitchpoint.analysis.line_tests import fine_spectrum
    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> parts = train_parts([(11, 36)])
    >>> turned = np.arange(8000) / 400.0
    >>> noise = 3.0 * np.random.default_rng(1).standard_normal(turned.size)
    >>> for dip in (0.0, 2.0):
    ...     x = np.cos(2 * np.pi * 11 * turned) - dip * (turned % 1 < 1 / 11) + noise
    ...     view = ShaftView(fine_spectrum(x, 400.0), parts, parts.shafts[0], float(x.std()), 400.0)
    ...     print(shaft_period(x, 400.0, view, 11).probability < 1e-4)
    False
    True
    """
    from scipy.stats import norm

    none = Measured(0.0, 1.0, view.order, 0.0, 0)
    level = tooth_level(values, samples_per_turn, teeth * view.order)
    most = MESH_HARMONICS * teeth
    top = min(most * view.order, HIGHEST_SHARE * level.samples_per_turn)
    meshes = [view.parts.mesh_order(mesh) for mesh in view.parts.meshes]
    record = record_for_combs(level.values, level.samples_per_turn, top, meshes)
    images = view.folded[view.folded < 0.5 * record.rate]
    record = replace(record, tones=np.union1d(record.tones, images))
    comb = comb_lines(record, 1.0 / view.order, most)
    if not comb.orders.size:
        return none
    chance, own, _ = evidence_of_comb(comb, most)
    probability = max(chance, own)
    above = np.maximum(comb.amplitude**2 - comb.noise**2, 0.0)
    amplitude = float(np.sqrt(above.sum()))
    small = amplitude < SMALLEST_COMB * view.rms
    return Measured(
        score=float(norm.isf(np.clip(probability, 1e-300, 0.5))),
        probability=1.0 if small else probability,
        order=view.order,
        amplitude=amplitude,
        lines=int(comb.orders.size),
        rule=f"below {100.0 * SMALLEST_COMB:g} % of the rms" if small else "",
    )


def shaft_periods(
    values: Array, samples_per_turn: float, views: Mapping[str, ShaftView], parts: TurningParts
) -> list[tuple[str, str, str, Measured]]:
    """Period tests of all shafts with gears: kind, shaft, gear and test.

    Parameters
    ----------
    values
        Signal over the angle of the reference shaft, shape (n,), any unit.
    samples_per_turn
        Samples per revolution of the reference shaft [-].
    views
        Orders by shaft.
    parts
        Rotating parts of the machine.

    Examples
    --------
    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> shaft_periods(np.zeros(64), 100.0, {}, train_parts([(21, 40)]))
    []
    """
    found = []
    for shaft, view in views.items():
        counts: set[int] = set()
        for gear, (_, teeth) in parts.gears_of(shaft).items():
            if view.testable and teeth not in counts:
                counts.add(teeth)
                found.append(("period", shaft, gear, shaft_period(values, samples_per_turn, view, teeth)))
    return found


def of_slower_shafts(evidence: Sequence[Evidence], parts: TurningParts) -> tuple[Evidence, ...]:
    """Mark periods of faster shafts that are those of a slower one.

    If the ratio of two shafts is a whole number, an event per revolution of the slower one has lines at all
    orders of the faster one. The lines of the slower one that are not orders of the faster one decide.

    Parameters
    ----------
    evidence
        All tests.
    parts
        Rotating parts of the machine.

    Examples
    --------
    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> of_slower_shafts((), train_parts([(32, 96)]))
    ()
    """
    from scipy.stats import norm

    limit = float(norm.isf(SEEN_IN_SLOWER))
    seen = {(e.channel, e.shaft) for e in evidence if e.kind in ("period", "comb") and e.value > limit}
    marked = []
    for e in evidence:
        if e.kind == "period" and e.found:
            fast = parts.shaft(e.shaft).order
            slow = [
                other.name
                for other in parts.shafts
                if other.order < fast
                and (fast / other.order).denominator == 1
                and (e.channel, other.name) in seen
            ]
            e = replace(e, found=False, explained=f"the period of {slow[0]}") if slow else e
        marked.append(e)
    return tuple(marked)
