# SPDX-License-Identifier: Apache-2.0
"""Elastic ring under tractions on its toothed circle, in Fourier series: response to one harmonic.

Plane strain for the rim; a web inside it is a disc in plane stress whose stiffness is reduced by its
thickness. The ring is clamped at the bore (external gear) or at the outer diameter (internal gear).

Source: solution of J. H. Michell (1899) for rings, S. P. Timoshenko and J. N. Goodier, Theory of Elasticity,
3rd ed. (1970), art. 43. Derivation: docs/theory/flank_compliance.md, "The ring".
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.compliance.blank import BlankRadii

Array = NDArray[np.float64]

DEEP = 20.0
"""Decay exponent n ln(r/r') beyond which a harmonic does not reach the other side of a ring."""
_NEAR_ONE = 1e-6
"""Distance from the order 1, whose solutions coincide, that keeps the equations regular."""
_LEAST = 1e-4
"""Order that replaces 0."""


@dataclass(frozen=True)
class RingMaterial:
    """Elastic constants of one layer: Lamé's first constant and shear modulus [Pa], of plane strain."""

    lame: float
    shear: float


def rim_material(E: float, nu: float) -> RingMaterial:
    """Constants of the rim, in plane strain.

    Parameters
    ----------
    E, nu
        Young's modulus [Pa], Poisson's ratio.

    Examples
    --------
    >>> rim_material(206e9, 0.25)
    RingMaterial(lame=82400000000.0, shear=82400000000.0)
    """
    return RingMaterial(E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), 0.5 * E / (1.0 + nu))


def web_material(E: float, nu: float, share: float) -> RingMaterial:
    """Constants of a web per unit face width, in plane stress.

    Parameters
    ----------
    E, nu
        Young's modulus [Pa], Poisson's ratio.
    share
        Web thickness over face width.

    Notes
    -----
    Plane stress has the equations of plane strain with λ' = E ν/(1 − ν²), and the same shear modulus
    (Timoshenko and Goodier, 1970).

    Examples
    --------
    >>> web_material(206e9, 0.25, 0.5).shear
    41200000000.0
    """
    return RingMaterial(share * E * nu / (1.0 - nu * nu), share * 0.5 * E / (1.0 + nu))


@dataclass(frozen=True)
class ElasticRing:
    """A ring loaded at one radius and clamped at another, with an optional web as second layer.

    Parameters
    ----------
    loaded
        Radius of the circle with the tractions r_o [m].
    radii
        Radii of rim and clamp.
    sign
        +1 external gear, −1 internal gear.
    E, nu
        Young's modulus [Pa], Poisson's ratio.
    """

    loaded: float
    radii: BlankRadii
    sign: int
    E: float
    nu: float

    @property
    def _layers(self) -> list[tuple[RingMaterial, float, float]]:
        """Material, logarithms of the radii at the loaded side and at the clamped side over r_o."""
        rim = math.log(self.radii.rim / self.loaded)
        end = math.log(self.radii.clamp / self.loaded)
        layers = [(rim_material(self.E, self.nu), 0.0, rim)]
        if rim != end:
            layers.append((web_material(self.E, self.nu, self.radii.web_share), rim, end))
        return layers

    def plane(self, order: Array) -> NDArray[np.complex128]:
        """Displacement amplitudes per traction amplitude in the transverse plane, for unit radius.

        Parameters
        ----------
        order
            Orders n >= 0 of e^{i n θ}, real numbers, any shape.

        Returns
        -------
        ndarray, shape (*order.shape, 2, 2)
            Rows: displacement in the direction of increasing θ and into the ring; columns: tractions in the
            same directions [1/Pa]; Hermitian. Multiply by r_o for displacements.

        Notes
        -----
        In each layer u_r = Σ A r^s, u_θ = i Σ B r^s with s = ±(n ± 1) (Michell, 1899). Orders within 1e-6 of
        1 and below 1e-4 are shifted by as much, because two of the four solutions coincide there.
        """
        n = np.maximum(np.asarray(order, dtype=np.float64), _LEAST)
        n = np.where(np.abs(n - 1.0) < _NEAR_ONE, 1.0 + _NEAR_ONE, n)
        found = np.empty((*n.shape, 2, 2), dtype=np.complex128)
        depth = [abs(end) for _, _, end in self._layers]
        for count in range(len(depth) + 1):  # layers that the harmonic reaches the end of
            reached = n * (depth[count] if count < len(depth) else 0.0) < DEEP
            before = n * (depth[count - 1] if count > 0 else np.inf) < DEEP
            if count == 0:
                group = ~reached
                parts = self._layers[:1]
            else:
                group = before & ~reached if count < len(depth) else before
                parts = self._layers[: count + 1]
            if group.any():
                found[group] = self._solve(n[group], parts, closed=count == len(depth))
        return found

    def _solve(
        self, n: Array, layers: list[tuple[RingMaterial, float, float]], closed: bool
    ) -> NDArray[np.complex128]:
        """Response of the layers; the last one extends without end unless `closed` (clamped)."""
        blocks = [_layer(n, *layer) for layer in layers]
        size = 4 * len(layers)
        keep = np.ones(size, dtype=bool)
        if not closed:
            grows = _exponents(n[:1])[0] * self.sign > 0.0  # decays into the ring
            keep[-4:] = grows
        M = np.zeros((n.size, size, size), dtype=np.complex128)
        M[:, 0:2, 0:4] = blocks[0]["near"][:, 2:4]
        for k in range(len(layers) - 1):
            rows = slice(4 * k + 2, 4 * k + 6)
            M[:, rows, 4 * k : 4 * k + 4] = blocks[k]["far"]
            M[:, rows, 4 * k + 4 : 4 * k + 8] = -blocks[k + 1]["near"]
        M[:, size - 2 :, size - 4 :] = blocks[-1]["far"][:, 0:2]
        used = int(keep.sum())
        M = M[:, :used, keep]
        loads = np.zeros((n.size, used, 2), dtype=np.complex128)
        loads[:, 0, 1], loads[:, 1, 0] = -1.0, self.sign
        scale = np.abs(M).max(axis=2, keepdims=True)
        x = np.linalg.solve(M / scale, loads / scale)
        u = blocks[0]["near"][:, 0:2][:, :, keep[:4]] @ x[:, : int(keep[:4].sum())]
        return np.stack([u[:, 1], -self.sign * u[:, 0]], axis=1)

    def antiplane(self, order: Array) -> Array:
        """Axial displacement amplitude per axial traction amplitude, for unit radius [1/Pa].

        Parameters
        ----------
        order
            Orders n >= 0, real numbers, any shape.

        Returns
        -------
        ndarray, shape of order

        Notes
        -----
        u_z'' = n² u_z over ln r: a layer with the reciprocal k at its far side has at its near side
        μ n (k + μ n tanh)/(μ n + k tanh), tanh of n ln(r/r').
        """
        n = np.maximum(np.asarray(order, dtype=np.float64), _LEAST)
        stiffness: Any = np.inf
        for material, near, end in reversed(self._layers):
            tanh, own = np.tanh(n * abs(end - near)), material.shear * n
            with np.errstate(invalid="ignore"):
                layered = own * (stiffness + own * tanh) / (own + stiffness * tanh)
            stiffness = np.where(np.isinf(stiffness), own / tanh, layered)
        return np.asarray(1.0 / stiffness)


def _exponents(n: Array) -> Array:
    """Exponents s of the four solutions, shape (n, 4)."""
    return np.stack([n + 1.0, n - 1.0, 1.0 - n, -n - 1.0], axis=-1)


def _layer(n: Array, material: RingMaterial, near: float, far: float) -> dict[str, NDArray[np.complex128]]:
    """u_r, u_θ, σ_r r, τ r of the four solutions at both sides of a layer, shape (n, 4, 4) each.

    Each solution is scaled to 1 at the side where it is largest.
    """
    lame, mu = material.lame, material.shear
    stiff = lame + 2.0 * mu
    s, order = _exponents(n), n[:, None]
    a = s * (stiff * s + lame) - (stiff + lame * s) - order * order * mu
    b = order * (stiff - lame * s - mu * (s - 1.0))
    size = np.hypot(a, b)
    A, B = b / size, -a / size
    radial = stiff * s * A + lame * (A - order * B)
    shear = 1j * mu * (order * A + (s - 1.0) * B)
    rows = np.stack([A + 0j, 1j * B, radial + 0j, shear], axis=1)
    top = np.maximum(s * near, s * far)
    return {
        "near": rows * np.exp(s * near - top)[:, None, :],
        "far": rows * np.exp(s * far - top)[:, None, :],
    }
