# SPDX-License-Identifier: Apache-2.0
"""Tooth numbers from the spacing of the sidebands of a mesh.

An angle that follows a mesh line contains the given number of teeth: mesh lines agree with any number. Their
sidebands do not; they are spaced by the mesh order over the true number.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.line_tests import FineSpectrum, fine_spectrum
from pitchpoint.analysis.mesh_angle import HARMONICS
from pitchpoint.analysis.sampled import Array, as_signal, positive
from pitchpoint.analysis.turning_parts import TurningParts

NEAR = 0.2
"""Largest relative difference from the given number of teeth."""
CHANCE = 1e-4
"""Probability of noise alone below which a sideband is there."""
SHARE = 0.5
"""Smallest share of mesh lines with both sidebands by whose spacing the number of teeth is known."""
FEWEST = 2
"""Smallest number of such mesh lines: modulation by a bearing may agree with one."""
AROUND = 40.0
"""Half width of the surroundings of a sideband [lines of the record]."""
APART = 2.0
"""Smallest distance of a sideband from lines of other parts [lines of the record]."""


@dataclass(frozen=True)
class SidebandTeeth:
    """Number of teeth by the sidebands of a mesh.

    Attributes
    ----------
    gear
        Name of the gear.
    given
        Its number of teeth [-].
    found
        Number of teeth by the sidebands [-]; 0 if they give none.
    """

    gear: str
    given: int
    found: int


def sideband_teeth(
    signals: Mapping[str, ArrayLike], samples_per_turn: float, parts: TurningParts
) -> tuple[SidebandTeeth, ...]:
    """Numbers of teeth of all gears by the sidebands of their meshes.

    Parameters
    ----------
    signals
        Channels at equal steps of an angle that follows the mesh lines, shape (n,) each, any unit.
    samples_per_turn
        Samples per revolution of the reference shaft [-].
    parts
        Rotating parts; orders refer to the reference shaft.

    Returns
    -------
    tuple of SidebandTeeth
        One per gear.

    Notes
    -----
    Sidebands of the mesh order M at k M ± M/z for all z within 20 % of the given number [1]_. The given
    number is confirmed by one harmonic of one channel with both sidebands; another one requires them at half
    of the harmonics of all channels, and the given one without them. Sidebands at lines of other shafts are
    omitted. Valid for more revolutions than teeth, since neighbouring numbers are not resolved otherwise.

    References
    ----------
    .. [1] R. B. Randall, A new method of modeling gear faults, Journal of Mechanical Design 104(2), 1982,
       259-267.

    Examples
    --------
    A gear of 20 teeth, given as one of 21:

    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> turned = 2 * np.pi * np.arange(60_000) / 300.0
    >>> noise = np.random.default_rng(1).standard_normal(turned.size)
    >>> x = (np.cos(21 * turned) + np.cos(42 * turned)) * (1 + 0.3 * np.cos(21 / 20 * turned)) + noise
    >>> [(one.gear, one.found) for one in sideband_teeth({"acc": x}, 300.0, train_parts([(21, 43)]))]
    [('Z1', 20), ('Z2', 0)]
    """
    rate = positive(samples_per_turn, "samples_per_turn")
    spectra = [fine_spectrum(as_signal(x, name, 64), rate) for name, x in signals.items()]
    shafts = {shaft.name: float(shaft.order) for shaft in parts.shafts}
    found = []
    for name in shafts:
        others = [order for shaft, order in shafts.items() if shaft != name]
        for gear, (mesh, teeth) in parts.gears_of(name).items():
            order = parts.mesh_order(mesh)
            pairs, tested = _pairs(spectra, order, order / teeth, others)
            if pairs or not tested:
                found.append(SidebandTeeth(gear, teeth, teeth if pairs else 0))
                continue
            numbers = range(max(int((1.0 - NEAR) * teeth), 4), int((1.0 + NEAR) * teeth) + 1)
            counts = [_pairs(spectra, order, order / number, others)[0] for number in numbers]
            best = max(range(len(counts)), key=lambda k: counts[k])
            enough = counts[best] >= max(FEWEST, SHARE * tested)
            found.append(SidebandTeeth(gear, teeth, numbers[best] if enough else 0))
    return tuple(found)


def _pairs(spectra: list[FineSpectrum], order: float, spacing: float, others: list[float]) -> tuple[int, int]:
    """Number of mesh lines with both sidebands, and of those of which both could be seen."""
    least, pairs, tested = -float(np.log(CHANCE)), 0, 0
    for one in spectra:
        edge = AROUND * one.resolution
        apart = [abs(spacing - round(spacing / other) * other) for other in others]
        if any(distance < APART * one.resolution for distance in apart):
            continue
        for k in range(1, HARMONICS + 1):
            at = k * order + np.array([-spacing, spacing])
            if at[0] < edge or at[1] > 0.95 * one.highest - edge:
                continue
            tested += 1
            pairs += all(float(one.power(place)) > least * _noise(one, place) for place in at)
    return pairs, tested


def _noise(spectrum: FineSpectrum, order: float) -> float:
    """Mean power of the noise about an order: median of the surroundings over ln 2."""
    around: Array = order + spectrum.resolution * np.arange(-AROUND, AROUND + 1.0)
    return max(float(np.median(spectrum.power(around))) / np.log(2.0), 1e-300)
