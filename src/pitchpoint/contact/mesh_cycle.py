# SPDX-License-Identifier: Apache-2.0
"""Total stiffness of a mesh over one mesh cycle: samples, exact mean and extremes.

Derivation: docs/theory/stiffness.md, "The mesh".
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pitchpoint.contact.cycle_pieces import ROUND_OFF, check_ratios, cycle_pieces
from pitchpoint.contact.stiffness.description import Array, PairShape, PhaseStiffness


@dataclass(frozen=True)
class MeshCycle:
    """Stiffness over one mesh cycle, in units of c' b (prescribed stiffness: in units of its mean).

    Parameters
    ----------
    phase, stiffness_ratio
        Phase in equal steps from 0 to 1, and the stiffness there; at a jump the value after it.
    mean, minimum, maximum, peak_to_peak
        Exact values over the cycle, one-sided limits at jumps included; not taken from the samples.
    breakpoints
        Phases in [0, 1] between which the stiffness is a single polynomial.
    jumps
        Phases at which the stiffness is discontinuous.
    """

    phase: Array
    stiffness_ratio: Array
    mean: float
    minimum: float
    maximum: float
    peak_to_peak: float
    breakpoints: Array
    jumps: tuple[float, ...]


def pair_cycle(shape: PairShape, eps_alpha: float, eps_beta: float = 0.0, n: int = 401) -> MeshCycle:
    """Mesh cycle of any single-pair stiffness, in units of c' b.

    Parameters
    ----------
    shape
        Stiffness of one pair.
    eps_alpha, eps_beta
        Transverse contact ratio (> 0) and overlap ratio (>= 0) [-].
    n
        Number of sampled phases, both ends included.

    Returns
    -------
    MeshCycle
        The phase is zero when a pair starts contact at mid-face.

    Raises
    ------
    ModelError
        If a contact ratio is out of range.

    Notes
    -----
    The total is the moving average of the spur gear stiffness over eps_beta base pitches (L. Mauer, SIMPACK
    User Meeting 2006: the parabola integrated along the face width).

    Examples
    --------
    >>> cycle = pair_cycle(PairShape(c_prime=14e9, S_R=1.0, T_R=0.75), 1.3)
    >>> round(cycle.mean, 9), round(cycle.minimum, 9), round(cycle.maximum, 9)
    (1.075, 1.0, 1.333333333)
    """
    check_ratios(eps_alpha, eps_beta)
    pieces = cycle_pieces(shape, eps_alpha, eps_beta)
    ends = pieces.extremes()
    low, high = float(ends[0].min()), float(ends[1].max())
    low = low if low > ROUND_OFF * high else 0.0
    phase = np.linspace(0.0, 1.0, n)
    ratio = pieces.at(phase)
    return MeshCycle(
        phase=phase,
        stiffness_ratio=np.where(ratio > ROUND_OFF * high, ratio, 0.0),
        mean=pieces.mean(),
        minimum=low,
        maximum=high,
        peak_to_peak=high - low,
        breakpoints=np.unique(pieces.start),
        jumps=shape.jumps(eps_alpha, eps_beta),
    )


def mesh_cycle(
    eps_alpha: float, eps_beta: float, S_R: float = 0.8, T_R: float = 0.0, n: int = 401
) -> MeshCycle:
    """Mesh cycle of the parabolic single-pair stiffness, in units of c' b.

    Parameters
    ----------
    eps_alpha, eps_beta
        Transverse contact ratio (> 0, also above 2 or below 1) and overlap ratio (>= 0) [-].
    S_R, T_R
        Stiffness ratio and tip-relief factor, both in [0, 1].
    n
        Number of sampled phases, both ends included.

    Returns
    -------
    MeshCycle
        Samples, exact mean and extremes, breakpoints, jumps.

    Notes
    -----
    Source: L. Mauer, SIMPACK User Meeting 2006. Without ramps the mean is eps_alpha (1 - (1 - S_R)/3).

    Examples
    --------
    >>> cycle = mesh_cycle(1.3, 0.85)
    >>> round(cycle.mean, 7), round(cycle.peak_to_peak, 7)
    (1.2133333, 0.1408632)
    """
    return pair_cycle(PairShape(c_prime=1.0, S_R=S_R, T_R=T_R), eps_alpha, eps_beta, n)


def phase_cycle(law: PhaseStiffness, n: int = 401) -> MeshCycle:
    """Mesh cycle of a prescribed stiffness, relative to its mean.

    The extremes are those of `PhaseStiffness.extremes`, not of the samples.

    Parameters
    ----------
    law
        Prescribed stiffness.
    n
        Number of sampled phases, both ends included.

    Examples
    --------
    >>> cycle = phase_cycle(PhaseStiffness(mean=1e8, cosine=[-0.2, -0.1, -0.05]))
    >>> round(cycle.mean, 12), round(cycle.minimum, 9)
    (1.0, 0.65)
    """
    count, first, _ = law.arrays()
    breakpoints = np.empty(0)
    mean = 1.0
    if law.form == 1:
        mean, breakpoints = float(first.mean()), np.arange(count) / count
    elif law.form == 2:
        mean = float(first[0] * first[2] + first[1] * (1.0 - first[2]))
        breakpoints = np.array([0.0, first[2]])
    phase = np.linspace(0.0, 1.0, n)
    low, high = law.extremes()
    return MeshCycle(phase, law.ratio(phase), mean, low, high, high - low, breakpoints, law.jumps())
