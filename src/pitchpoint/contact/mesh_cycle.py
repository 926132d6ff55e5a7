# SPDX-License-Identifier: Apache-2.0
"""Total stiffness of a mesh over one mesh cycle, with exact mean and extremes.

The sum over all pairs, averaged over the contact lines of a helical gear, is a piecewise polynomial of the
mesh phase, of degree four at most. Five points determine each piece exactly; the extremes follow from the
roots of its derivative and from the one-sided limits at its ends. Plain NumPy, independent of the kernels.

Derivation: docs/theory/stiffness.md, "The mesh".
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import Polynomial
from numpy.polynomial.legendre import leggauss
from numpy.typing import ArrayLike

from pitchpoint.contact.stiffness.description import Array, PairShape, PhaseStiffness, refuse

#: Overlap ratios below this are treated as zero.
SMALLEST_OVERLAP = 1e-14

#: Pieces up to this length (in base pitches) are round-off and skipped.
SHORTEST_PIECE = 1e-15

ROUND_OFF = 1e-12
"""Fraction of the maximum stiffness below which a value is the round-off of zero: no pair in contact."""

_GAUSS_X, _GAUSS_W = leggauss(3)
_NODES = 0.5 - 0.5 * np.cos(np.pi * (np.arange(5) + 0.5) / 5.0)
_TO_POLYNOMIAL = np.linalg.inv(np.vander(2.0 * _NODES - 1.0, increasing=True))


@dataclass(frozen=True)
class Piece:
    """One piece of the cycle: start and end phase, polynomial in 2 (psi - start)/(end - start) - 1."""

    start: float
    end: float
    polynomial: Polynomial

    def at(self, psi: ArrayLike) -> Array:
        """Stiffness at phases inside the piece, shape of psi; one-sided limits at its ends.

        >>> Piece(0.0, 0.5, Polynomial([1.0, 1.0])).at([0.0, 0.5]).tolist()
        [0.0, 2.0]
        """
        s = 2.0 * (np.asarray(psi, dtype=np.float64) - self.start) / (self.end - self.start) - 1.0
        return np.asarray(self.polynomial(s))

    def extremes(self) -> tuple[float, float]:
        """Minimum and maximum, one-sided limits at the ends included.

        >>> low, high = Piece(0.0, 1.0, Polynomial([1.0, 0.0, -1.0])).extremes()
        >>> abs(low) < 1e-12, abs(high - 1.0) < 1e-12
        (True, True)
        """
        scale = float(np.abs(self.polynomial.coef).max())
        slope = self.polynomial.deriv().trim(1e-14 * scale)
        roots = slope.roots() if slope.degree() > 0 else np.empty(0)
        inside = roots.real[(np.abs(roots.imag) < 1e-6) & (np.abs(roots.real) < 1.0)]
        values = self.polynomial(np.concatenate(([-1.0, 1.0], inside)))
        return float(values.min()), float(values.max())


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


@dataclass(frozen=True)
class _Line:
    """Stiffness of one pair along the path, with its kinks in ascending order from A to E."""

    kinks: Array
    shape: PairShape
    eps_alpha: float

    def law(self, p: Array) -> Array:
        """Stiffness of a pair over c' at path positions p in base pitches, shape of p [-]."""
        return self.shape.along(p, self.eps_alpha)

    def integral(self) -> float:
        """Integral over the whole path: the mean of the total stiffness."""
        middle = 0.5 * (self.kinks[1:] + self.kinks[:-1])[:, None]
        half = 0.5 * np.diff(self.kinks)[:, None]
        return float(np.sum(_GAUSS_W * half * self.law(middle + half * _GAUSS_X)))


def _line(shape: PairShape, eps_alpha: float) -> _Line:
    L = shape.ramp_length(eps_alpha)
    kinks = [0.0, eps_alpha]
    if L > 0.0:
        kinks += [L, eps_alpha - L] if eps_alpha > 2.0 * L else [0.5 * eps_alpha]
    if shape.table is not None:
        kinks += list(np.linspace(0.0, eps_alpha, shape.table.size)[1:-1])
    return _Line(np.unique(np.clip(kinks, 0.0, eps_alpha)), shape, eps_alpha)


def _spur(line: _Line, start: float, tau: Array) -> Array:
    """Sum over all pairs at the phases start + tau, inside one piece of a spur mesh."""
    middle = start + 0.5 * (tau[0] + tau[-1])
    total = np.zeros(tau.size)
    for j in range(math.ceil(-middle), math.floor(line.eps_alpha - middle) + 1):
        total += line.law(np.clip(start + tau + j, 0.0, line.eps_alpha))
    return total


def _helical(line: _Line, eps_beta: float, anchor: tuple[float, float, int], tau: Array) -> Array:
    """Sum over all pairs of the mean along the contact line, at the phase of the anchor plus tau.

    The anchor (kink, side, n) is the phase kink + side eps_beta/2 + n. The distances of kinks from the
    middle of the line are computed from differences of kinks, so that a tiny overlap ratio loses no digits.
    """
    kink, side, n = anchor
    half = 0.5 * eps_beta
    start = kink + side * half + n
    reach = half + float(tau[-1])
    pairs = np.arange(math.ceil(-start - reach), math.floor(line.eps_alpha - start + half) + 1)
    offset = (line.kinks - kink)[None, None, :] - (pairs + n)[None, :, None]
    y = np.clip(offset - side * half - tau[:, None, None], -half, half)
    length = np.diff(y, axis=-1)
    at, pair, piece = np.nonzero(length)
    w = length[at, pair, piece]
    middle = 0.5 * (y[at, pair, piece] + y[at, pair, piece + 1])
    p = (start + tau[at] + pairs[pair] + middle)[:, None] + 0.5 * w[:, None] * _GAUSS_X
    c = line.law(np.clip(p, line.kinks[piece][:, None], line.kinks[piece + 1][:, None]))
    share = 0.5 * w / eps_beta * (c @ _GAUSS_W)
    return np.asarray(np.bincount(at, weights=share, minlength=tau.size), dtype=np.float64)


def _pieces(line: _Line, eps_beta: float) -> list[Piece]:
    """All pieces of one cycle in order; the last one wraps around if it ends beyond psi = 1."""
    sides = (0.0,) if eps_beta < SMALLEST_OVERLAP else (-1.0, 1.0)
    half = 0.5 * eps_beta
    anchors = [(k, s, -math.floor(k + s * half)) for k in line.kinks.tolist() for s in sides]
    anchors.sort(key=lambda a: a[0] + a[1] * half + a[2])
    pieces = []
    for i, first in enumerate(anchors):
        last = anchors[(i + 1) % len(anchors)]
        turn = 1 if i + 1 == len(anchors) else 0
        width = (last[0] - first[0]) + (last[2] + turn - first[2]) + (last[1] - first[1]) * half
        if width <= SHORTEST_PIECE:
            continue
        start = first[0] + first[1] * half + first[2]
        tau = width * _NODES
        total = _spur(line, start, tau) if len(sides) == 1 else _helical(line, eps_beta, first, tau)
        pieces.append(Piece(start, start + width, Polynomial(_TO_POLYNOMIAL @ total)))
    return pieces


def _sample(pieces: list[Piece], phase: Array) -> Array:
    starts = np.array([piece.start for piece in pieces])
    psi = phase - np.floor(phase)
    index = np.searchsorted(starts, psi, side="right") - 1
    psi = np.where(index < 0, psi + 1.0, psi)
    out = np.empty(phase.size)
    for i, piece in enumerate(pieces):
        mine = (index % len(pieces)) == i
        out[mine] = piece.at(psi[mine])
    return out


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
    if not (math.isfinite(eps_alpha) and eps_alpha > 0.0):
        raise refuse("eps_alpha", "is not a contact ratio", eps_alpha, "> 0", "give a positive number")
    if not (math.isfinite(eps_beta) and eps_beta >= 0.0):
        raise refuse("eps_beta", "is not an overlap ratio", eps_beta, ">= 0", "give 0 or a positive number")
    line = _line(shape, eps_alpha)
    pieces = _pieces(line, eps_beta)
    extremes = [piece.extremes() for piece in pieces]
    low, high = min(e[0] for e in extremes), max(e[1] for e in extremes)
    low = low if low > ROUND_OFF * high else 0.0
    phase = np.linspace(0.0, 1.0, n)
    ratio = _sample(pieces, phase)
    return MeshCycle(
        phase=phase,
        stiffness_ratio=np.where(ratio > ROUND_OFF * high, ratio, 0.0),
        mean=line.integral(),
        minimum=low,
        maximum=high,
        peak_to_peak=high - low,
        breakpoints=np.unique(np.array([piece.start for piece in pieces])),
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
