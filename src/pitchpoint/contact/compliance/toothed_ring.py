# SPDX-License-Identifier: Apache-2.0
"""Root strips of the teeth on an elastic ring: rotation and displacements of a root under loads on another.

Along the face width the tractions vary as a cosine; wave numbers κ > 0 are treated with the order
√(n² + κ² r_o²), which is exact for short waves (half space) and for a thin layer.

Derivation: docs/theory/flank_compliance.md, "The ring".
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.compliance.elastic_ring import ElasticRing

Array = NDArray[np.float64]

_REACH = 12.0
"""Largest order times half the angle of the strip with the full response of the ring."""
_TAIL = 200.0
"""The same for the tail, at uniform tractions along the face width."""
_PIECE = 100_000
"""Harmonics treated together, for the memory."""


@dataclass(frozen=True)
class ToothedRing:
    """Ring with z equal root strips.

    Parameters
    ----------
    ring
        The ring; its loaded circle passes through the ends of the strips.
    z
        Number of teeth.
    chord
        Width of a strip in the transverse section [m].
    distance
        Distance of the clamped section from the gear axis [m], about which moments are taken.
    """

    ring: ElasticRing
    z: int
    chord: float
    distance: float

    @property
    def half_angle(self) -> float:
        """Half the angle of a root strip [rad]."""
        return math.asin(0.5 * self.chord / self.ring.loaded)

    def tractions(self, n: Array) -> NDArray[np.complex128]:
        """Fourier integrals of the tractions of unit loads on a strip.

        Parameters
        ----------
        n
            Orders, shape (k,).

        Returns
        -------
        ndarray, shape (k, 2, 3)
            Tangential traction and traction into the ring for moment, shear and normal force.

        Notes
        -----
        Forces per chord length: −12 M s/S³ and N/S along the centre line of the tooth, Q/S across it in the
        direction of the force on a left flank; resolved on the circle. The moment counts about the clamped
        section, that of the tractions about the mean height of the arc.
        """
        a, r, S, sign = self.half_angle, self.ring.loaded, self.chord, self.ring.sign

        def even(m: int) -> Array:
            """Integral of cos(m φ) e^{−i n φ} over the strip, shape (k,)."""
            return a * (np.sinc((n - m) * a / math.pi) + np.sinc((n + m) * a / math.pi))

        def odd(m: int) -> Array:
            """Integral of sin(m φ) e^{−i n φ} over the strip divided by −i, shape (k,)."""
            return a * (np.sinc((n - m) * a / math.pi) - np.sinc((n + m) * a / math.pi))

        found = np.zeros((n.size, 2, 3), dtype=np.complex128)
        linear, uniform = -12.0 * r * r / S**3, r / S
        found[:, 0, 0] = sign * linear * 0.25 * (even(1) - even(3))
        found[:, 1, 0] = -1j * linear * 0.25 * (odd(1) + odd(3))
        found[:, 0, 1] = -uniform * 0.5 * (even(0) + even(2))
        found[:, 1, 1] = -1j * sign * uniform * 0.5 * odd(2)
        found[:, 0, 2] = -1j * sign * uniform * 0.5 * odd(2)
        found[:, 1, 2] = uniform * 0.5 * (even(0) + even(2))
        mean = r * uniform * (a + 0.5 * math.sin(2.0 * a))
        found[:, :, 1] += sign * (self.distance - mean) * found[:, :, 0]
        return found

    def response(self, wave_numbers: Array) -> Array:
        """Compliance between root strips without the torsion of the blank, per unit face width.

        Parameters
        ----------
        wave_numbers
            Wave numbers κ along the tooth trace [1/m], shape (k,); 0 is a uniform load.

        Returns
        -------
        ndarray, shape (3, k, 3, 3)
            [j]: rotation and displacements of a root per moment, shear and normal force on the j-th next
            root, counter-clockwise; j = 0, 1, 2.

        Notes
        -----
        For a wave that runs at the angle γ to the circumference, tan γ = κ r_o/n, the tangential traction
        has the share cos γ along the wave and the share sin γ across it, with the antiplane response.
        """
        half = self.half_angle
        n = np.arange(int(_REACH / half) + 1, dtype=np.float64)
        tail = np.arange(n.size, int(_TAIL / half), dtype=np.float64)
        rest = self._sum(tail, self.ring.plane(tail)[None])
        pieces = math.ceil(wave_numbers.size * n.size / _PIECE)
        parts = [self._sum(n, self._waves(n, k)) for k in np.array_split(wave_numbers, pieces)]
        return np.concatenate(parts, axis=1) + rest

    def _waves(self, n: Array, wave_numbers: Array) -> NDArray[np.complex128]:
        """Response of the loaded circle to orders n and wave numbers, shape (k, n, 2, 2)."""
        order = np.hypot(n, wave_numbers[:, None] * self.ring.loaded)
        plane = self.ring.plane(order)
        along = np.where(order > 0.0, n / np.where(order > 0.0, order, 1.0), 0.0)
        plane[..., 0, 0] *= along * along
        plane[..., 0, 1] *= along
        plane[..., 1, 0] *= along
        uniform = wave_numbers == 0.0
        plane[uniform, 0, 0, 0] = 0.0
        across = (1.0 - along * along) * self.ring.antiplane(order)
        plane[..., 0, 0] += np.where(uniform[:, None], 0.0, across)
        return plane

    def _sum(self, n: Array, plane: NDArray[np.complex128]) -> Array:
        """Sum of the Fourier series for the orders n, shape (3, k, 3, 3)."""
        T = self.tractions(n) * np.where(n == 0.0, math.sqrt(0.5), 1.0)[:, None, None]
        each = T.conj().transpose(0, 2, 1)[None] @ plane @ T[None]
        turn = np.exp(-2j * math.pi / self.z * np.outer(np.arange(3), n))
        found = np.einsum("jn,knab->jkab", turn, each)
        return np.asarray(found.real) / math.pi
