# SPDX-License-Identifier: Apache-2.0
"""Orders of impacts of parts that are not given, whose sidebands may be the lines of given parts.

Derivation: docs/theory/signals.md, "Statistical tests".
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from pitchpoint.analysis.family_lines import FamilyLines
from pitchpoint.analysis.family_search import HARMONICS, SEPARATE, SIDEBANDS
from pitchpoint.analysis.line_prominence import OMITTED
from pitchpoint.analysis.sampled import Array

ELEMENTS = 5, 40
"""Numbers of rolling elements whose passage a cage may modulate, from and up to."""


def impact_order(
    own: float, part: str, spectra: Sequence[FamilyLines], shafts: Sequence[float]
) -> tuple[float, float] | None:
    """Order of the impacts whose sidebands the lines of a part are, and that of their distance, if any.

    Parameters
    ----------
    own
        Order of the lines of the part [-].
    part
        Name of the part: outer ring, inner ring, rolling element or cage.
    spectra
        Lines of squared envelopes of the same signal, of different bands or weights.
    shafts
        Orders of the shafts [-].

    Returns
    -------
    tuple of float or None
        Order of the impacts and of the shaft or cage that modulates them [-]; None if the lines of the part
        are the clearer ones.

    Notes
    -----
    Impacts of order f whose height repeats with a shaft of order n have lines k f + j n in the squared
    envelope. Lines of a part at multiples of g = a f + b n are among them. The height is never negative, so
    that none of its Fourier coefficients exceeds its mean, and no line k f + j n the line k f [1]_.
    Therefore that of the orders g and f = (g - b n)/a is the one of the impacts whose first three lines have
    the higher mean level; in the mean of all spectra, because the spectrum of impacts has zeros. Tried are
    a = 1 ... 3 and b in steps of one half, for shafts that vibrate at half their speed, up to the third
    sideband. Half of the order of a rolling element is its own line. The lines of a cage are those of the
    passage of 5 to 39 unequal rolling elements if these are clearer. Valid for orders resolved from those of
    the shafts, and whose first three lines are in the spectra.

    References
    ----------
    .. [1] P. D. McFadden, J. D. Smith, Model for the vibration produced by a single point defect in a rolling
       element bearing, Journal of Sound and Vibration 96(1), 1984, 69-82.

    Examples
    --------
    Lines at multiples of 5.42 and, lower by 10 dB, of 4.42:

    >>> from pitchpoint.analysis.family_lines import LineLevels
    >>> level = np.zeros(3000)
    >>> for k in (1, 2, 3):
    ...     level[[round(k * order / 0.01) - OMITTED for order in (5.42, 4.42)]] = 30.0, 20.0
    >>> spectrum = FamilyLines({1: LineLevels(level, np.ones(3000))}, 0.01)
    >>> impact_order(4.42, "inner ring", [spectrum], [1.0])
    (5.42, 1.0)
    >>> impact_order(5.42, "inner ring", [spectrum], [1.0]) is None
    True
    """
    level, near = _mean_level(own, spectra), SEPARATE * spectra[0].step
    clearer = {}
    for order, shaft in _candidates(own, part, shafts):
        other = _mean_level(order, spectra) if order > min(shafts) else np.nan
        # a line of a shaft is widened by the window, and highest in its middle
        multiples = [one for n in shafts if abs(order - (one := round(order / n) * n)) < near]
        if other > level and all(other > _mean_level(one, spectra) for one in multiples):
            clearer[order, shaft] = other
    return max(clearer, key=lambda pair: clearer[pair], default=None)


def _candidates(order: float, part: str, shafts: Sequence[float]) -> Iterator[tuple[float, float]]:
    """Orders of impacts with sidebands at the lines of a part, and those of the shafts or the cage."""
    ball = part == "rolling element"
    if part == "cage":
        yield from ((elements * order, order) for elements in range(*ELEMENTS))
        return
    for shaft in shafts:
        for times in range(1, HARMONICS + 1):
            for halves in range(-2 * SIDEBANDS, 2 * SIDEBANDS + 1):
                itself = halves == 0 and (times == 1 or (ball and times == 2))
                if not itself:
                    yield (order - 0.5 * halves * shaft) / times, shaft


def _mean_level(order: float, spectra: Sequence[FamilyLines]) -> float:
    """Mean level of the first three harmonics of an order in all spectra [dB]; NaN outside of them."""
    return float(np.mean([_levels(order, lines) for lines in spectra]))


def _levels(order: float, lines: FamilyLines) -> Array:
    """Levels of the first three harmonics of an order, each the highest within one line [dB], shape (3,)."""
    level = lines.levels[1].prominence
    at = np.rint(order * np.arange(1, HARMONICS + 1) / lines.step).astype(np.int64) - OMITTED
    if at[-1] + 1 >= level.size:
        return np.full(HARMONICS, np.nan)
    near = np.maximum(at[:, None] + np.arange(-1, 2), 0)
    return np.asarray(level[near].max(axis=1), dtype=np.float64)
