# SPDX-License-Identifier: Apache-2.0
"""Compliance of the planes along the face width: coupled by the plate, by springs, or not at all.

Derivation: docs/theory/flank_compliance.md, "Coupling along the face width".
"""

from __future__ import annotations

import math

import numpy as np
from numpy.polynomial.legendre import leggauss, legvander
from numpy.typing import NDArray

from pitchpoint.contact.compliance.foundation import Foundation
from pitchpoint.contact.compliance.plate import PlateTooth

Array = NDArray[np.float64]

SPRING_RULE = 0.04
"""Factor of the coupling springs, see `springs`."""
MODES_PER_WAVE = 3
"""Cosine waves of the foundation per Legendre polynomial of the plate."""


def wave_numbers(waves: int, length: float) -> Array:
    """Wave numbers of the foundation along the tooth trace, n π/length [1/m].

    Parameters
    ----------
    waves
        Number of Legendre polynomials along the trace.
    length
        Length of the trace over the face width of the gear [m].

    Returns
    -------
    ndarray, shape (3 waves,)

    Notes
    -----
    Cosines that are level at the end faces: a uniform load remains in plane strain. Derivation:
    docs/theory/flank_compliance.md, "Coupling along the face width".

    Examples
    --------
    >>> wave_numbers(1, 0.01).round(1).tolist()
    [0.0, 314.2, 628.3]
    """
    return np.asarray(math.pi / length * np.arange(MODES_PER_WAVE * waves), dtype=np.float64)


def plane_means(edges: Array, waves: int) -> Array:
    """Mean values of Legendre polynomials over intervals.

    Parameters
    ----------
    edges
        Ends of the intervals in −1 ... 1, shape (n + 1,).
    waves
        Number of polynomials.

    Returns
    -------
    ndarray, shape (n, waves)

    Examples
    --------
    >>> plane_means(np.array([-1.0, 0.0, 1.0]), 2).tolist()
    [[1.0, -0.5], [1.0, 0.5]]
    """
    P = legvander(edges, waves)
    a = np.arange(1, waves)
    primitive = np.concatenate([P[:, 1:2], (P[:, 2:] - P[:, :-2]) / (2.0 * a + 1.0)], axis=1)
    return np.asarray(np.diff(primitive, axis=0) / np.diff(edges)[:, None])


def plate_coupled(
    plate: PlateTooth, ground: Foundation, edges: Array, length: float, waves: int
) -> tuple[Array, Array]:
    """Compliance of planes coupled by the tooth as a plate and by the gear body.

    Parameters
    ----------
    plate
        The tooth.
    ground
        Gear body for the wave numbers of `wave_numbers`.
    edges
        Edges of the planes from the middle of the face over half the face width, shape (n + 1,).
    length
        Length of the trace over the face width of the gear [m].
    waves
        Number of Legendre polynomials along the trace.

    Returns
    -------
    own, next : ndarray, shape (n, n, M, M)
        Displacement per force [m/N] of the Legendre loads over the height, same tooth and next tooth.

    Notes
    -----
    With the stiffness K of plate and root and the load vectors F, own = Fᵀ K⁻¹ F. The root reactions r of
    the loads displace the roots of the next tooth, which follows as a rigid base: by reciprocity
    next = rᵀ C_next r. A chain of teeth is then as positive as the roots. Derivation:
    docs/theory/flank_compliance.md, "Coupling along the face width".

    Examples
    --------
    Uniform load on two planes of a 20-tooth gear, relative to plane strain:

    >>> from pitchpoint.contact.compliance.blank import Blank, blank_radii
    >>> from pitchpoint.contact.compliance.clamped_tooth import clamped_tooth
    >>> from pitchpoint.contact.compliance.foundation import foundation
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.materials import material
    >>> gear, steel = CylindricalGear(z=20, m_n=1e-3, b=5e-3), material("steel")
    >>> tooth, blank = clamped_tooth(gear), blank_radii(gear, Blank())
    >>> ground = foundation(tooth, blank, steel, "weber_banaschek", wave_numbers(4, 5e-3))
    >>> edges = np.array([-1.0, 0.0, 1.0])
    >>> plate = PlateTooth(tooth, steel, 1)
    >>> own, _ = plate_coupled(plate, ground, edges, 5e-3, 4)
    >>> (own[:, :, 0, 0].sum(axis=1) * 2.5e-3 / plate.uniform(ground)[0]).round(3).tolist()
    [[1.0, 1.0]]
    """
    K, parts = plate.energy(waves, length)
    means = plane_means(edges, waves)
    loads = np.zeros((K.shape[0], means.shape[0], plate.order))
    for name, rows in parts.items():
        load = plate.shapes[name].load
        loads[rows] = np.einsum("mk,ja->kajm", load, means).reshape(-1, *loads.shape[1:])
    roots = np.concatenate([np.arange(parts[name].start, parts[name].start + waves) for name in "bwv"])
    F = loads.reshape(K.shape[0], -1)
    rigid = not ground.own.any()
    if rigid:
        free = np.setdiff1d(np.arange(K.shape[0]), roots)
        own = F[free].T @ np.linalg.solve(K[np.ix_(free, free)], F[free])
        following = np.zeros_like(own)
    else:
        modes = _cosines(ground.own.shape[0], waves, length)
        stiff = np.linalg.inv(ground.own)
        spring = np.einsum("na,nij,nb->iajb", modes, stiff, modes).reshape(3 * waves, 3 * waves)
        K[np.ix_(roots, roots)] += spring
        u = np.linalg.solve(K, F)
        own = F.T @ u
        q = np.einsum("na,iac->nic", modes, u[roots].reshape(3, waves, -1))
        r = stiff @ q
        following = np.einsum("nic,nid->cd", r, ground.next @ r)
    shape = (*loads.shape[1:], *loads.shape[1:])
    own = (0.5 * (own + own.T)).reshape(shape).transpose(0, 2, 1, 3)
    return np.asarray(own), np.asarray(following.reshape(shape).transpose(0, 2, 1, 3))


def _cosines(count: int, waves: int, length: float) -> Array:
    """Integrals of orthonormal cosines and Legendre polynomials along the trace, shape (count, waves)."""
    nodes, weights = leggauss(12)
    pieces = count // 4 + waves // 4 + 1
    x = ((np.arange(pieces)[:, None] + 0.5 * (nodes + 1.0)) * (2.0 / pieces) - 1.0).ravel()
    w = np.tile(weights, pieces) / pieces
    cosine = np.cos(0.5 * math.pi * np.arange(count)[:, None] * (x + 1.0)) * math.sqrt(2.0 / length)
    cosine[0] = math.sqrt(1.0 / length)
    return np.asarray((cosine * w) @ legvander(x, waves - 1) * (0.5 * length))


def springs(planes: int) -> Array:
    """Coupling of slices by springs, a rule of the KISSsoft user manual.

    Parameters
    ----------
    planes
        Number of slices N.

    Returns
    -------
    ndarray, shape (planes, planes)
        Displacement of a slice per force on another, relative to the compliance of a slice; rows sum to 1.

    Notes
    -----
    Springs C_c = 0.04 N² (C_i + C_{i+1})/2 between adjacent slices of stiffness C_i; here all slices have
    the same one, and the teeth end with the common face. Derivation: docs/theory/flank_compliance.md,
    "Coupling along the face width".

    Examples
    --------
    >>> springs(2).round(4).tolist()
    [[0.8788, 0.1212], [0.1212, 0.8788]]
    """
    chain = 2.0 * np.eye(planes) - np.eye(planes, k=1) - np.eye(planes, k=-1)
    chain[0, 0] -= 1.0
    chain[-1, -1] -= 1.0
    return np.asarray(np.linalg.inv(np.eye(planes) + SPRING_RULE * planes**2 * chain))
