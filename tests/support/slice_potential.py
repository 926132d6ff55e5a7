# SPDX-License-Identifier: Apache-2.0
"""Naive elastic potentials of a gear pair: slices of tooth pairs over the face width, coupled or not.

U = sum of k w <x - g>^2/2 over pairs and slices; the gap g has tip and root relief, crowning, misalignment
and rapid growth beyond the ends of the path of contact. The number of pairs in contact changes over the
phase. The coupled potential is the maximum of f (x - g) - f C f/2 over f >= 0 for a compliance matrix C.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
UM = 1e-6


@dataclass(frozen=True)
class SlicePair:
    """A pair of gears about the working position; positions p along the path in base pitches.

    c_prime [N/m^2], crown and relief [m]; `shortening` [1/m]: change of the contact ratio by the centre
    distance; `beyond` [m]: growth of the gap with the square of the distance beyond the path; C_R the share
    of stiffness that is the same everywhere; `soft`: share of the compliance that couples slices and pairs.
    """

    eps_alpha: float = 1.6
    eps_beta: float = 0.0
    b: float = 0.02
    p_bt: float = 11.8e-3
    c_prime: float = 14e9
    relief: float = 18.0 * UM
    relief_length: float = 0.3
    crown: float = 6.0 * UM
    beyond: float = 4.2e-3
    shortening: float = 250.0
    slices: int = 21
    soft: float = 0.0

    def _points(self, states: Array) -> tuple[Array, Array, Array, Array]:
        """Gap, its derivatives by s and a, and place z of all pairs and slices, shape (n, points)."""
        s, _, kappa, a = states.T[:, :, None, None]
        t, _ = np.polynomial.legendre.leggauss(self.slices)
        z = 0.5 * self.b * t
        p = s - np.floor(s) + np.arange(-2, 4)[:, None] + 0.5 * self.eps_beta * t
        short = 0.5 * self.shortening * a
        gap = self.crown * t**2 + kappa * z + 0.0 * p
        by_s, by_a = np.zeros_like(gap), np.zeros_like(gap)
        for inside, sign in ((short - p, -1.0), (p - self.eps_alpha + short, 1.0)):
            d = np.maximum(inside + self.relief_length, 0.0) / self.relief_length
            o = np.maximum(inside, 0.0)
            gap += self.relief * d**2 + self.beyond * o**2
            slope = 2.0 * self.relief * d / self.relief_length + 2.0 * self.beyond * o
            by_s += sign * slope
            by_a += 0.5 * self.shortening * slope
        shape = (len(states), -1)
        every = np.broadcast_to(z, gap.shape)
        return gap.reshape(shape), by_s.reshape(shape), by_a.reshape(shape), every.reshape(shape)

    def _place(self, states: Array) -> Array:
        """Distance of pairs and slices from the pitch point [m], shape (n, points)."""
        s = states[:, 0, None, None]
        t, _ = np.polynomial.legendre.leggauss(self.slices)
        p = s - np.floor(s) + np.arange(-2, 4)[:, None] + 0.5 * self.eps_beta * t
        return self.p_bt * (p - 0.45 * self.eps_alpha).reshape(len(states), -1)

    def __call__(self, states: Array) -> Array:
        """Potential, its four derivatives, loss and friction moment per unit coefficient, shape (n, 7)."""
        gap, by_s, by_a, z = self._points(states)
        _, w = np.polynomial.legendre.leggauss(self.slices)
        k = self.c_prime * 0.5 * self.b * np.tile(w, 6)
        depth = states[:, 1, None] - gap
        if self.soft == 0.0:
            f = k * np.maximum(depth, 0.0)
        else:
            f = coupled_forces(self.compliance(k, w), depth)
        place = self._place(states)
        energy = 0.5 * np.sum(f * depth, axis=1)
        columns = [energy, -np.sum(f * by_s, 1), np.sum(f, 1), -np.sum(f * z, 1), -np.sum(f * by_a, 1)]
        columns += [np.sum(f * np.abs(place), 1), np.sum(f * np.sign(place) * (0.02 + place), 1)]
        return np.column_stack(columns)

    def compliance(self, k: Array, w: Array) -> Array:
        """Compliance matrix: slices of a pair bend together, neighbouring pairs turn a common body."""
        n = self.slices
        t, _ = np.polynomial.legendre.leggauss(n)
        near = np.exp(-np.abs(t[:, None] - t[None, :]) / 0.3)
        pair = np.exp(-np.abs(np.arange(6)[:, None] - np.arange(6)[None, :]) / 0.6)
        own = np.diag((1.0 - self.soft) / k)
        return own + self.soft / (self.c_prime * self.b) * 2.0 * np.kron(pair, near)


def coupled_forces(C: Array, depth: Array) -> Array:
    """Forces f >= 0 with C f >= depth and equality in contact, by principal pivoting, shape (n, points)."""
    f = np.zeros_like(depth)
    active = depth > 0.0
    near = np.flatnonzero(active.any(axis=0))
    C, depth = C[np.ix_(near, near)], depth[:, near]
    found = np.zeros_like(depth)
    for row, (d, on) in enumerate(zip(depth, depth > 0.0, strict=True)):
        for _ in range(50):  # block principal pivoting; the matrices at hand never cycle
            g = np.zeros(len(near))
            g[on] = np.linalg.solve(C[np.ix_(on, on)], d[on]) if on.any() else 0.0
            gap = C @ g - d
            flip = (on & (g < 0.0)) | (~on & (gap < -1e-15))
            if not flip.any():
                break
            on = on ^ flip
        found[row] = g
    f[:, near] = found
    return f
