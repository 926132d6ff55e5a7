# SPDX-License-Identifier: Apache-2.0
"""Structural compliance of one gear as the contact of flanks reads it, independent of its source.

Derivation: docs/theory/flank_compliance.md, "What the contact needs".
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from types import MappingProxyType

import numpy as np
from numpy.polynomial.legendre import legvander
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import Message, ModelError

Array = NDArray[np.float64]

SYMMETRY = 1e-9
"""Permitted asymmetry of the compliance of a tooth, relative to its maximum."""


@dataclass(frozen=True, eq=False)
class FlankCompliance:
    """Compliance of the teeth and the body of one gear, without the local approach of the flanks.

    The common face width is divided into n planes of equal width Δ. A force f along the transverse base
    tangent, spread evenly over the width of plane j at the length of roll ρ_j, displaces plane i (mean over
    its width, along the base tangent) at the length of roll ρ_i by Σ P_m(t_i) C[i, j, m, n] P_n(t_j) f with
    the Legendre polynomials P_0 ... P_{M−1} of the height coordinate −1 ≤ t ≤ 1, which is linear in ρ. Left
    flank; on right flanks the block of the next tooth is transposed.

    Raises
    ------
    ModelError
        If shapes do not agree, a number is not finite, or the tooth is not symmetric.
    """

    roll: tuple[float, float]
    """Lengths of roll [m] at t = −1 (root side) and t = +1 (tip side)."""
    own: Array
    """Same tooth [m/N], shape (n, n, M, M); own[i, j, m, n] = own[j, i, n, m]."""
    beside: Array
    """Displacement of tooth k per force on tooth k + 1, the next one counter-clockwise [m/N], shape
    (n, n, M, M). By reciprocity tooth k + 1 moves by [j, i, n, m] per force on tooth k. Teeth farther apart
    share only `windup`."""
    windup: float
    """Displacement of every node of the gear per force on any node [m/N]: torsion of the blank, and its
    displacement that all teeth in contact share."""
    provenance: Mapping[str, str | float]
    """Options and intermediate results for the user."""

    def __post_init__(self) -> None:
        blocks = [f.name for f in fields(self)[1:3]]
        arrays = [np.array(getattr(self, name), dtype=np.float64, order="C") for name in blocks]
        own = arrays[0]
        problems = []
        for name, values in zip(blocks, arrays, strict=True):
            if values.ndim != 4 or values.shape != (own.shape[:1] * 2 + own.shape[-1:] * 2):
                problems.append(Message(f"compliance.{name}", "is not (n, n, M, M)", f"shape {values.shape}"))
            elif not np.isfinite(values).all():
                problems.append(Message(f"compliance.{name}", "contains numbers that are not finite"))
        if not problems and np.abs(own - own.transpose(1, 0, 3, 2)).max() > SYMMETRY * np.abs(own).max():
            problems.append(Message("compliance.own", "is not symmetric", limit=f"{SYMMETRY:g} relative"))
        if not all(math.isfinite(r) and r >= 0.0 for r in self.roll) or self.roll[0] == self.roll[1]:
            problems.append(Message("compliance.roll", "are not two lengths", f"{self.roll}", ">= 0 m"))
        if not (math.isfinite(self.windup) and self.windup >= 0.0):
            problems.append(Message("compliance.windup", "is not a compliance", f"{self.windup}", ">= 0 m/N"))
        if problems:
            raise ModelError(problems)
        for name, values in zip(blocks, arrays, strict=True):
            values.flags.writeable = False
            object.__setattr__(self, name, values)
        object.__setattr__(self, "provenance", MappingProxyType(dict(self.provenance)))

    @property
    def planes(self) -> int:
        """Number of planes n."""
        return int(self.own.shape[0])

    @property
    def order(self) -> int:
        """Number of Legendre polynomials M."""
        return int(self.own.shape[-1])

    def height(self, rho: ArrayLike) -> Array:
        """Height coordinate t of lengths of roll ρ [m], shape of ρ.

        Examples
        --------
        >>> zero = np.zeros((1, 1, 1, 1))
        >>> FlankCompliance((1e-3, 3e-3), zero, zero, 0.0, {}).height([1e-3, 2e-3]).tolist()
        [-1.0, 0.0]
        """
        low, high = self.roll
        return (2.0 * np.asarray(rho, dtype=np.float64) - low - high) / (high - low)

    def matrix(self, rho: ArrayLike, neighbours: int = 1) -> Array:
        """Compliance of the nodes of adjacent teeth including the wind-up [m/N].

        Parameters
        ----------
        rho
            Lengths of roll of the contact points [m], shape (neighbours, n): one per tooth, in
            counter-clockwise order, and plane.
        neighbours
            Number of teeth.

        Returns
        -------
        ndarray, shape (neighbours n, neighbours n)
            Symmetric; node k n + i is plane i of tooth k.
        """
        n = self.planes
        shape = legvander(self.height(np.reshape(rho, (neighbours, n))), self.order - 1)
        blocks = np.full((neighbours, n, neighbours, n), self.windup)
        for k in range(neighbours):
            blocks[k, :, k, :] += np.einsum("im,ijmn,jn->ij", shape[k], self.own, shape[k])
            if k + 1 < neighbours:
                side = np.einsum("im,ijmn,jn->ij", shape[k], self.beside, shape[k + 1])
                blocks[k, :, k + 1, :] += side
                blocks[k + 1, :, k, :] += side.T
        return np.asarray(blocks.reshape(neighbours * n, neighbours * n))

    def scaled(self, C_M: float) -> FlankCompliance:
        """Compliance of a gear with the correction factor C_M of the stiffness.

        Parameters
        ----------
        C_M
            Factor of the stiffness, > 0. ISO 6336-1 has C_M = 0.8 for the difference between measured and
            theoretical stiffness of solid discs. The local approach is not part of this description; to
            apply the factor to the whole single stiffness c', divide the approach by C_M too.

        Raises
        ------
        ModelError
            If the factor is not positive.
        """
        if isinstance(C_M, bool) or not (math.isfinite(C_M) and C_M > 0.0):
            raise ModelError([Message("compliance.C_M", "is not a factor", str(C_M), "> 0", "use 1 or 0.8")])
        before = float(self.provenance.get("C_M", 1.0))
        return replace(
            self,
            own=self.own / C_M,
            beside=self.beside / C_M,
            windup=self.windup / C_M,
            provenance={**self.provenance, "C_M": before * C_M},
        )
