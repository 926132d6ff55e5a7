# SPDX-License-Identifier: Apache-2.0
"""Tooth as a tapered cantilever plate on an elastic root, by the method of Ritz.

Plate with transverse shear (Mindlin 1951): deflection w, rotations over the height and along the face, and
the displacement v along the centre line of the tooth. Shapes over the height are the exact deflections of the
slice in plane strain under the Legendre loads, so that a uniform load gives the slice exactly; along the
face they are Legendre polynomials. Poisson's coupling of both bending moments is omitted for the same reason.

Derivation: docs/theory/flank_compliance.md, "Coupling along the face width".
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.polynomial.legendre import leggauss, legval, legvander
from numpy.typing import NDArray

from pitchpoint.contact.compliance.clamped_tooth import ClampedTooth
from pitchpoint.contact.compliance.foundation import Foundation
from pitchpoint.contact.compliance.heights import dual
from pitchpoint.geometry.materials import Material

Array = NDArray[np.float64]

_RULE = leggauss(8)
_LOADS = leggauss(40)
_PANELS = 8


@dataclass(frozen=True)
class HeightShapes:
    """Shapes over the height at the points of a quadrature, with their derivatives and their load terms.

    Parameters
    ----------
    values, slopes
        Functions and derivatives by the height at the points, shape (p, k); the first one or two are the
        motion of the root.
    load
        Generalised force of the M height loads on each function, shape (M, k).
    """

    values: Array
    slopes: Array
    load: Array


@dataclass(frozen=True)
class PlateTooth:
    """One tooth as a plate.

    Parameters
    ----------
    tooth
        The clamped tooth.
    material
        Material of the gear.
    order
        Number of Legendre polynomials over the height M.
    """

    tooth: ClampedTooth
    material: Material
    order: int

    @cached_property
    def points(self) -> tuple[Array, Array, Array]:
        """Heights above the clamp [m], weights [m], normal thickness [m] at the points, shape (p,) each."""
        tooth = self.tooth
        low, high = (float(v) for v in tooth.arms(np.array(tooth.roll))[0])
        form = float(tooth.outline(np.ones(1))[1][0] - tooth.outline(np.array([tooth.start]))[1][0])
        marks = sorted({0.0, tooth.top, *(y for y in (low, high, form) if 0.0 < y < tooth.top)})
        edges = [0.0]
        for below, above in zip(marks[:-1], marks[1:], strict=True):
            count = max(1, math.ceil(_PANELS * (above - below) / tooth.top))
            edges += list(np.linspace(below, above, count + 1)[1:])
        half = 0.5 * np.diff(edges)
        y = (np.array(edges[:-1]) + half)[:, None] + half[:, None] * _RULE[0]
        weights = half[:, None] * _RULE[1]
        return y.ravel(), weights.ravel(), tooth.outline(tooth.position(y.ravel()))[0]

    def resultants(self) -> tuple[Array, Array]:
        """Moment, shear and normal force of the Legendre loads at the points, and at the clamp.

        Returns
        -------
        along : ndarray, shape (3, p, M)
            At the points; the loads act at the heights of `ClampedTooth.arms`.
        root : ndarray, shape (3, M)
            At the clamp, loads below it included.
        """
        tooth, (y, _, _) = self.tooth, self.points
        psi, form = tooth.form.psi_b * tooth.form.sign, tooth.form
        # heights above y: angles of the line of action farther from (external) or nearer to 0 (internal)
        limit = np.arccos(np.clip(form.r_b / (tooth.distance + form.sign * y), -1.0, 1.0))
        low, high = sorted(a / form.r_b - psi for a in tooth.roll)
        lowest, highest = np.full(y.size, low), np.full(y.size, high)
        spans = [(limit, highest), (lowest, -limit)] if form.sign > 0 else [(-limit, limit)]
        along = np.zeros((3, y.size, self.order))
        for start, stop in spans:
            first, last = (np.clip(a, low, high) for a in (start, stop))
            half = 0.5 * np.maximum(last - first, 0.0)
            rho = form.r_b * (psi + (first + half)[:, None] + half[:, None] * _LOADS[0])
            along += self._integrate(rho, half[:, None] * _LOADS[1] * form.r_b, y[:, None])
        root_rho = form.r_b * (psi + 0.5 * (low + high) + 0.5 * (high - low) * _LOADS[0])[None]
        root = self._integrate(root_rho, 0.5 * (high - low) * _LOADS[1][None] * form.r_b, 0.0)
        return along, root[:, 0]

    def _integrate(self, rho: Array, weights: Array, base: Array | float) -> Array:
        """Integrals of the moments about `base` and of the forces, shape (3, p, M)."""
        low, high = self.tooth.roll
        t = (2.0 * rho - low - high) / (high - low)
        y, c, s = self.tooth.arms(rho)
        load = dual(t, self.order) * (weights * 2.0 / abs(high - low))[..., None]
        return np.stack([np.einsum("pq,pqm->pm", f, load) for f in (c * (y - base), c, s)])

    @cached_property
    def shapes(self) -> dict[str, HeightShapes]:
        """Shapes of w, both rotations and v over the height."""
        y, weights, s = self.points
        tooth_top = self.tooth.top
        E, nu, G = self.material.youngs_modulus, self.material.poisson_ratio, self.material.shear_modulus
        (M, Q, N), root = self.resultants()
        curvature = M * (12.0 * (1.0 - nu * nu) / E / s**3)[:, None]
        rotation = self._primitive(curvature)
        w_slope = rotation + Q * (1.2 / (G * s))[:, None]
        v_slope = N * ((1.0 - nu * nu) / E / s)[:, None]
        one, line, zero = np.ones((y.size, 1)), y[:, None] / tooth_top, np.zeros((y.size, 1))
        rise = one / tooth_top
        below = root[0] - weights @ Q  # moment of the loads under the clamp

        def family(motion: list[tuple[Array, Array]], slopes: Array) -> tuple[Array, Array]:
            """Root motions and independent combinations of elastic shapes, shapes (p, k)."""
            values = self._primitive(slopes)
            stacked = np.concatenate([values, slopes * tooth_top]) * np.sqrt(np.tile(weights, 2))[:, None]
            _, singular, right = np.linalg.svd(stacked, full_matrices=False)
            keep = singular > 1e-9 * singular[0]
            mix = right[keep].T / singular[keep]
            return (
                np.concatenate([*(m[0] for m in motion), values @ mix], axis=1),
                np.concatenate([*(m[1] for m in motion), slopes @ mix], axis=1),
            )

        w, dw = family([(one, zero), (line, rise)], w_slope)
        b, db = family([(one, zero)], curvature)
        v, dv = family([(one, zero)], v_slope)
        at_root = np.zeros(w.shape[1])
        at_root[0] = 1.0
        w_load = np.einsum("p,pm,pk->mk", weights, Q, dw) + np.outer(root[1], at_root)
        v_load = np.einsum("p,pm,pk->mk", weights, N, dv) + np.outer(root[2], np.eye(1, v.shape[1])[0])
        b_load = np.outer(below, np.eye(1, b.shape[1])[0])
        return {
            "w": HeightShapes(w, dw, w_load),
            "b": HeightShapes(b, db, b_load),
            "z": HeightShapes(w, dw, 0.0 * w_load),
            "v": HeightShapes(v, dv, v_load),
        }

    def uniform(self, ground: Foundation) -> tuple[Array, Array]:
        """Legendre coefficients of the slice in plane strain: same tooth, and next tooth.

        Parameters
        ----------
        ground
            Gear body; its first wave is uniform.

        Returns
        -------
        own, next : ndarray, shape (M, M)
            Per unit face width [m²/N].
        """
        _, weights, s = self.points
        E, nu = self.material.youngs_modulus, self.material.poisson_ratio
        along, root = self.resultants()
        factors = np.stack([12.0 / s**3, 2.4 / (1.0 - nu) / s, 1.0 / s]) * weights * (1.0 - nu * nu) / E
        inner = np.einsum("fp,fpm,fpn->mn", factors, along, along)
        cos_beta = self.tooth.cos_beta
        own = cos_beta * (inner + root.T @ ground.own[0] @ root)
        return own, np.asarray(cos_beta * root.T @ ground.next[0] @ root)

    def _primitive(self, slopes: Array) -> Array:
        """Integrals from the clamp to the points of functions at the points, shape (p, k)."""
        nodes = _RULE[0]
        width = self.points[1].reshape(-1, nodes.size).sum(axis=1)
        vander = legvander(nodes, nodes.size)
        # primitive of P_m from -1: (P_{m+1} - P_{m-1})/(2 m + 1)
        m = np.arange(1, nodes.size)
        primitive = np.concatenate(
            [(nodes + 1.0)[:, None], (vander[:, 2:] - vander[:, :-2]) / (2.0 * m + 1.0)], axis=1
        )
        inner = primitive @ (dual(nodes, nodes.size) * _RULE[1][:, None]).T
        parts = slopes.reshape(width.size, nodes.size, -1)
        local = 0.5 * width[:, None, None] * np.einsum("ab,pbk->pak", inner, parts)
        whole = 0.5 * width[:, None] * np.einsum("b,pbk->pk", _RULE[1], parts)
        start = np.concatenate([np.zeros((1, whole.shape[1])), np.cumsum(whole, axis=0)[:-1]])
        return np.asarray((start[:, None, :] + local).reshape(slopes.shape))

    def energy(self, waves: int, length: float) -> tuple[Array, dict[str, slice]]:
        """Stiffness matrix of the plate: shapes over the height times Legendre polynomials along the trace.

        Parameters
        ----------
        waves
            Number of Legendre polynomials along the trace.
        length
            Length of the trace over the face width of the gear [m].

        Returns
        -------
        matrix : ndarray, shape (k waves, k waves)
            Symmetric positive semidefinite.
        parts : dict
            Rows of each field; the index of the polynomial runs fastest.

        Notes
        -----
        Strain energy of the plate of R. D. Mindlin (1951), without Poisson's coupling of both curvatures:
        ½ ∫∫ D (β_y,y² + β_z,z²) + D (1 − ν)/2 (β_y,z + β_z,y)² + 5/6 G s [(w,y − β_y)² + (w,z − β_z)²] +
        E s/(1 − ν²) v,y² + G s v,z² with D = E s³/(12 (1 − ν²)).
        """
        _, weights, s = self.points
        E, nu, G = self.material.youngs_modulus, self.material.poisson_ratio, self.material.shear_modulus
        D = weights * E * s**3 / (12.0 * (1.0 - nu * nu))
        twist, shear = 0.5 * (1.0 - nu) * D, weights * G * s / 1.2
        stretch, slide = weights * E * s / (1.0 - nu * nu), weights * G * s
        x, gauss = leggauss(waves + 2)
        P = legvander(x, waves - 1)
        dP = np.stack([legval(x, np.polynomial.legendre.legder(row)) for row in np.eye(waves)], axis=1)
        Z = {"00": (P, P, 0.5 * length), "01": (P, dP, 1.0), "11": (dP, dP, 2.0 / length)}
        mass = {k: scale * a.T @ (gauss[:, None] * b) for k, (a, b, scale) in Z.items()}
        mass["10"] = mass["01"].T
        sizes = {name: shape.values.shape[1] * waves for name, shape in self.shapes.items()}
        stops = np.cumsum([0, *sizes.values()])
        parts = {name: slice(int(stops[i]), int(stops[i + 1])) for i, name in enumerate(sizes)}
        K = np.zeros((int(stops[-1]),) * 2)
        w, b, z, v = (self.shapes[name] for name in "wbzv")

        def add(row: str, column: str, weight: Array, first: Array, second: Array, along: str) -> None:
            """Add one term of the energy, and its transpose off the diagonal."""
            term = np.kron(first.T @ (weight[:, None] * second), mass[along])
            K[parts[row], parts[column]] += term
            if row != column:
                K[parts[column], parts[row]] += term.T

        add("b", "b", D, b.slopes, b.slopes, "00")
        add("z", "z", D, z.values, z.values, "11")
        add("b", "b", twist, b.values, b.values, "11")
        add("z", "z", twist, z.slopes, z.slopes, "00")
        add("b", "z", twist, b.values, z.slopes, "10")
        add("w", "w", shear, w.slopes, w.slopes, "00")
        add("b", "b", shear, b.values, b.values, "00")
        add("w", "b", -shear, w.slopes, b.values, "00")
        add("w", "w", shear, w.values, w.values, "11")
        add("z", "z", shear, z.values, z.values, "00")
        add("w", "z", -shear, w.values, z.values, "10")
        add("v", "v", stretch, v.slopes, v.slopes, "00")
        add("v", "v", slide, v.values, v.values, "11")
        return K, parts
