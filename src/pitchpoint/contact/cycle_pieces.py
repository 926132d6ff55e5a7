# SPDX-License-Identifier: Apache-2.0
"""Total stiffness of a mesh over one mesh cycle as a piecewise polynomial, exact mean and extremes.

The sum over all pairs, averaged over the contact lines of a helical gear, is a piecewise polynomial of the
mesh phase, of degree four at most. Five points determine each piece exactly; the extremes follow from the
roots of its derivative and from the one-sided limits at its ends. Plain NumPy, independent of the kernels.

Derivation: docs/theory/stiffness.md, "The mesh".
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.typing import ArrayLike, NDArray

from pitchpoint.contact.stiffness.description import Array, PairShape, refuse

#: Overlap ratios below this are treated as zero.
SMALLEST_OVERLAP = 1e-14

#: Pieces up to this length (in base pitches) are round-off and skipped.
SHORTEST_PIECE = 1e-15

ROUND_OFF = 1e-12
"""Fraction of the maximum stiffness below which a value is the round-off of zero: no pair in contact."""

BISECTIONS = 30
"""Halvings of a stretch: a root to 2e-9, the extremum there, its square, to round-off."""

MOST_AT_ONCE = 1_000_000
"""Number of stretches of contact lines that are in memory at the same time."""

_GAUSS_X, _GAUSS_W = leggauss(3)
_NODES = 0.5 - 0.5 * np.cos(np.pi * (np.arange(5) + 0.5) / 5.0)
_TO_POLYNOMIAL = np.linalg.inv(np.vander(2.0 * _NODES - 1.0, increasing=True))


@dataclass(frozen=True)
class Pieces:
    """Pieces of one cycle in order of their start, or of several cycles one after the other.

    Parameters
    ----------
    start, width
        Phases at which the pieces start, in [0, 1), and their widths, shape (n,) [-]. The last piece of a
        cycle wraps around if it ends beyond 1.
    coefficients
        Coefficients of the powers 0 to 4 of s = 2 (psi - start)/width - 1, shape (n, 5).
    """

    start: Array
    width: Array
    coefficients: Array

    def at(self, psi: ArrayLike) -> Array:
        """Stiffness of a single cycle at any phases, shape of psi; at a jump the value after it.

        >>> Pieces(np.array([0.0]), np.array([1.0]), np.array([[1.0, 1.0, 0, 0, 0]])).at([0.0, 1.5]).tolist()
        [0.0, 1.0]
        """
        phase = np.asarray(psi, dtype=np.float64)
        phase = phase - np.floor(phase)
        index = np.searchsorted(self.start, phase, side="right") - 1
        phase = np.where(index < 0, phase + 1.0, phase)
        s = 2.0 * (phase - self.start[index]) / self.width[index] - 1.0
        return _values(np.moveaxis(self.coefficients[index], -1, 0), s)

    def mean(self) -> float:
        """Mean of a single cycle.

        >>> Pieces(np.zeros(1), np.ones(1), np.array([[1.0, 0.5, -0.3, 0.0, 0.0]])).mean()
        0.9
        """
        return float(self.width @ (self.coefficients[:, ::2] @ [1.0, 1.0 / 3.0, 1.0 / 5.0]))

    def extremes(self) -> tuple[Array, Array]:
        """Minimum and maximum of every piece, one-sided limits at its ends included, shape (n,) each.

        The roots of the second derivative bound stretches on which the first one is monotonic. Bisection
        finds its root there; where it has none, it ends at a point that is neither minimum nor maximum.

        >>> low, high = Pieces(np.zeros(1), np.ones(1), np.array([[1.0, 0.0, -1.0, 0.0, 0.0]])).extremes()
        >>> low.round(12).tolist(), high.round(12).tolist()
        ([0.0], [1.0])
        """
        c = self.coefficients.T[:, :, None]
        slope = np.arange(1, 5)[:, None, None] * c[1:]
        edges = np.sort(np.concatenate([-np.ones_like(c[0]), _turns(slope), np.ones_like(c[0])], axis=-1))
        low, high = edges[:, :-1], edges[:, 1:]
        rising = _values(slope, low) > 0.0
        for _ in range(BISECTIONS):
            middle = 0.5 * (low + high)
            before = (_values(slope, middle) > 0.0) == rising
            low, high = np.where(before, middle, low), np.where(before, high, middle)
        values = _values(c, np.concatenate([edges, low], axis=-1))
        return values.min(axis=-1), values.max(axis=-1)


def _values(coefficients: Array, s: Array) -> Array:
    """Polynomials with coefficients along the first axis at s."""
    total = coefficients[-1] * s + coefficients[-2]
    for c in coefficients[-3::-1]:
        total = total * s + c
    return np.asarray(total)


def _turns(slope: Array) -> Array:
    """Real roots in [-1, 1] of the derivatives of cubic polynomials (4, n, 1), shape (n, 2); else an end."""
    c, b, a = slope[1, :, 0], 2.0 * slope[2, :, 0], 3.0 * slope[3, :, 0]
    q = -0.5 * (b + np.copysign(np.sqrt(np.maximum(b * b - 4.0 * a * c, 0.0)), b))
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        roots = np.stack([q / a, c / q], axis=-1)
    return np.asarray(np.clip(np.nan_to_num(roots, nan=1.0), -1.0, 1.0))


@dataclass(frozen=True)
class _Line:
    """Stiffness of one pair along the path, with its kinks in ascending order from A to E."""

    kinks: Array
    shape: PairShape
    eps_alpha: float

    def law(self, p: Array) -> Array:
        """Stiffness of a pair over c' at path positions p in base pitches, shape of p [-]."""
        return self.shape.along(p, self.eps_alpha)


def _line(shape: PairShape, eps_alpha: float) -> _Line:
    L = shape.ramp_length(eps_alpha)
    kinks = [0.0, eps_alpha]
    if L > 0.0:
        kinks += [L, eps_alpha - L] if eps_alpha > 2.0 * L else [0.5 * eps_alpha]
    if shape.table is not None:
        kinks += list(np.linspace(0.0, eps_alpha, shape.table.size)[1:-1])
    return _Line(np.unique(np.clip(kinks, 0.0, eps_alpha)), shape, eps_alpha)


@dataclass(frozen=True)
class _Anchors:
    """Phases kink + side + n at which pieces start, half the length of the contact line there, shape (r,)."""

    kink: Array
    side: Array
    n: Array
    half: Array

    @property
    def start(self) -> Array:
        """Phases, shape (r,)."""
        return self.kink + self.side + self.n

    def of(self, which: NDArray[np.bool_] | slice) -> _Anchors:
        """Some of them."""
        return _Anchors(self.kink[which], self.side[which], self.n[which], self.half[which])


def _spur(line: _Line, at: _Anchors, tau: Array) -> Array:
    """Sum over all pairs at the phases start + tau (r, 5), inside pieces of a spur mesh."""
    start = at.start[:, None]
    middle = start + 0.5 * (tau[:, :1] + tau[:, -1:])
    total = np.zeros_like(tau)
    for j in range(-1, math.floor(line.eps_alpha) + 1):
        touches = (middle + j >= 0.0) & (middle + j <= line.eps_alpha)
        total += np.where(touches, line.law(np.clip(start + tau + j, 0.0, line.eps_alpha)), 0.0)
    return total


def _helical(line: _Line, at: _Anchors, tau: Array) -> Array:
    """Sum over all pairs of the mean along the contact line, at the phases start + tau (r, 5).

    The distances of kinks from the middle of the line are computed from differences of kinks, so that a tiny
    overlap ratio loses no digits.
    """
    pairs = np.arange(-2, math.floor(line.eps_alpha) + 2)
    rows = max(1, MOST_AT_ONCE // (5 * pairs.size * line.kinks.size))
    if at.kink.size > rows:
        cuts = [slice(i, i + rows) for i in range(0, at.kink.size, rows)]
        return np.concatenate([_helical(line, at.of(cut), tau[cut]) for cut in cuts])
    half = at.half[:, None, None, None]
    offset = (line.kinks - at.kink[:, None])[:, None, :] - (pairs + at.n[:, None])[:, :, None]
    offset = (offset - at.side[:, None, None])[:, None] - tau[:, :, None, None]
    y = np.clip(offset, -half, half)
    length = np.diff(y, axis=-1)
    row, node, pair, piece = np.nonzero(length)
    w = length[row, node, pair, piece]
    middle = 0.5 * (y[row, node, pair, piece] + y[row, node, pair, piece + 1])
    p = (at.start[row] + tau[row, node] + pairs[pair] + middle)[:, None] + 0.5 * w[:, None] * _GAUSS_X
    c = line.law(np.clip(p, line.kinks[piece][:, None], line.kinks[piece + 1][:, None]))
    share = 0.25 * w / at.half[row] * (c @ _GAUSS_W)
    total = np.bincount(row * tau.shape[1] + node, weights=share, minlength=tau.size)
    return np.asarray(total, dtype=np.float64).reshape(tau.shape)


def _pieces(line: _Line, part: Array) -> tuple[Pieces, NDArray[np.intp]]:
    """Pieces of the cycles with overlap ratios below 1, shape (m,); index of the first piece of each."""
    half = 0.5 * np.where(part < SMALLEST_OVERLAP, 0.0, part)[:, None]
    kink = np.repeat(line.kinks, 2)[None, :] + 0.0 * half
    side = half * np.tile([-1.0, 1.0], line.kinks.size)
    n = -np.floor(kink + side)
    order = np.argsort(kink + side + n, axis=1, kind="stable")
    kink, side, n = (np.take_along_axis(values, order, axis=1) for values in (kink, side, n))
    turn = np.append(np.zeros(kink.shape[1] - 1), 1.0)
    width = _to_next(kink) + (_to_next(n) + turn) + _to_next(side)
    is_piece = width > SHORTEST_PIECE
    width, at = width[is_piece], _Anchors(kink, side, n, half + 0.0 * kink).of(is_piece)
    tau = width[:, None] * _NODES
    total = np.empty_like(tau)
    for law, rows in ((_spur, at.half == 0.0), (_helical, at.half > 0.0)):
        total[rows] = law(line, at.of(rows), tau[rows])
    count = is_piece.sum(axis=1)
    first = np.cumsum(count) - count
    return Pieces(at.start, width, total @ _TO_POLYNOMIAL.T), first


def _to_next(values: Array) -> Array:
    """Differences to the next value of each row, of the last one to the first, shape (m, a)."""
    return np.asarray(np.roll(values, -1, axis=1) - values)


def cycle_pieces(shape: PairShape, eps_alpha: float, eps_beta: float = 0.0) -> Pieces:
    """Pieces of the mesh cycle of a single-pair stiffness, in units of c' b.

    Parameters
    ----------
    shape
        Stiffness of one pair.
    eps_alpha, eps_beta
        Transverse contact ratio (> 0) and overlap ratio (>= 0) [-].

    Notes
    -----
    The average over N whole periods is the mean c: with f = eps_beta - N, the stiffness at psi is
    (N c + f k_f(psi - N/2))/eps_beta, where k_f is that of the overlap ratio f.

    Examples
    --------
    >>> pieces = cycle_pieces(PairShape(c_prime=14e9, S_R=1.0), 1.5, 1.5)
    >>> pieces.at([0.25, 0.75]).round(9).tolist()
    [1.333333333, 1.666666667]
    """
    whole = math.floor(eps_beta)
    pieces, _ = _pieces(_line(shape, eps_alpha), np.array([eps_beta - whole]))
    if whole == 0:
        return pieces
    coefficients = pieces.coefficients * ((eps_beta - whole) / eps_beta)
    coefficients[:, 0] += whole * pieces.mean() / eps_beta
    start = pieces.start + 0.5 * (whole % 2)
    start -= np.floor(start)
    order = np.argsort(start, kind="stable")
    return Pieces(start[order], pieces.width[order], coefficients[order])


def variations(shape: PairShape, eps_alpha: float, eps_beta: Array) -> Array:
    """Maximum less minimum of the mesh cycles of several overlap ratios, in units of c' b.

    Parameters
    ----------
    shape
        Stiffness of one pair.
    eps_alpha, eps_beta
        Transverse contact ratio (> 0) and overlap ratios (>= 0), shape (m,) [-].

    Examples
    --------
    >>> variations(PairShape(c_prime=14e9, S_R=1.0), 1.3, np.array([0.3, 0.7, 2.0])).round(7).tolist()
    [1.0, 0.4285714, 0.0]
    """
    check_ratios(eps_alpha, eps_beta)
    part = eps_beta - np.floor(eps_beta)
    pieces, first = _pieces(_line(shape, eps_alpha), part)
    low, high = pieces.extremes()
    least, greatest = np.minimum.reduceat(low, first), np.maximum.reduceat(high, first)
    least = np.where(least > ROUND_OFF * greatest, least, 0.0)
    return np.asarray(
        (greatest - least) * np.divide(part, eps_beta, out=np.ones_like(part), where=eps_beta >= 1.0)
    )


def check_ratios(eps_alpha: float, eps_beta: ArrayLike) -> None:
    """Refuse contact ratios that are out of range.

    Parameters
    ----------
    eps_alpha, eps_beta
        Transverse contact ratio and overlap ratios, any shape [-].

    Raises
    ------
    ModelError
        If one is not finite, the first one not positive, or the second one negative.

    Examples
    --------
    >>> check_ratios(1.3, 0.0)
    """
    if not (math.isfinite(eps_alpha) and eps_alpha > 0.0):
        raise refuse("eps_alpha", "is not a contact ratio", eps_alpha, "> 0", "give a positive number")
    for value in np.atleast_1d(np.asarray(eps_beta, dtype=np.float64)).tolist():
        if not (math.isfinite(value) and value >= 0.0):
            raise refuse("eps_beta", "is not an overlap ratio", value, ">= 0", "give 0 or a positive number")
