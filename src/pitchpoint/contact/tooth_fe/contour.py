# SPDX-License-Identifier: Apache-2.0
"""Left half of the outline of one pitch: involute, fillet and root circle in closed form.

Frame as in `pitchpoint.geometry.tooth_form`: tooth on the +x axis, points x + iy. Positions on the involute
are lengths of roll ρ, positions on the fillet are angles between its tangent and the tooth centre line.

Derivation: docs/theory/tooth_fe.md, "Mesh".
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.tooth_generation import ToothForm

FloatArray = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]

_SAMPLES = 2001
_SHARPEST = 0.01
"""Minimum length of the fillet relative to half a pitch; below it the root is a sharp corner."""


@dataclass(frozen=True)
class Contour:
    """Left flank, fillet and root of one tooth.

    Parameters
    ----------
    form
        Exact tooth of the gear.
    """

    form: ToothForm

    def involute(self, rho: FloatArray) -> ComplexArray:
        """Points of the involute [m] at lengths of roll [m], shape (n,)."""
        return np.asarray(np.hypot(rho, self.form.r_b) * np.exp(1j * self._half_angle(rho)))

    def inward_normal(self, rho: FloatArray) -> ComplexArray:
        """Unit normals of the involute into the tooth, along the base tangent, shape (n,)."""
        turn = self._half_angle(rho) - self.form.sign * np.arctan(rho / self.form.r_b)
        return np.asarray(-1j * np.exp(1j * turn))

    def _half_angle(self, rho: FloatArray) -> FloatArray:
        roll = rho / self.form.r_b
        return np.asarray(self.form.psi_b - self.form.sign * (roll - np.arctan(roll)))

    @property
    def roll(self) -> tuple[float, float]:
        """Lengths of roll of the ends of the involute at root and tip [m]."""
        form = self.form
        low, high = (math.sqrt(max(0.0, r * r - form.r_b**2)) for r in (form.r_Ff, form.r_Fa))
        return low, high

    @cached_property
    def _fillet(self) -> tuple[FloatArray, ComplexArray, FloatArray, FloatArray]:
        """Parameter, points, arc length and tangent angle from the root circle to the involute."""
        form = self.form
        theta = np.linspace(form.fillet.theta_root, form.theta_form, _SAMPLES)
        points = self._at(theta)
        length = np.append(0.0, np.cumsum(np.abs(np.diff(points))))
        if length[-1] < _SHARPEST * math.pi * form.r_f / form.z:
            raise GeometryError(
                "has a sharp corner between flank and root, where stress is not finite",
                where="root_fillet_radius",
                value=f"arc of {1e3 * length[-1]:.4f} mm",
                limit=f"{1e3 * _SHARPEST * math.pi * form.r_f / form.z:.4f} mm",
                remedy="set the tip radius of the tool",
            )
        step = np.gradient(points)
        return theta, points, length, np.arctan2(-step.imag, form.sign * step.real)

    def _at(self, theta: FloatArray) -> ComplexArray:
        r, angle = self.form.fillet_polar(theta)
        return np.asarray(r * np.exp(1j * angle))

    @property
    def tangent_range(self) -> tuple[float, float]:
        """Tangent angles of the fillet at the involute and at the root circle [rad]."""
        tangent = self._fillet[3]
        return float(tangent[-1]), float(tangent[0])

    def fillet_length_at(self, tangent: FloatArray) -> FloatArray:
        """Arc lengths from the root circle [m] of points with tangent angles [rad], shape (n,)."""
        _, _, length, angle = self._fillet
        order = np.argsort(angle)
        return np.interp(tangent, angle[order], length[order])

    @property
    def fillet_length(self) -> float:
        """Arc length of the fillet [m]."""
        return float(self._fillet[2][-1])

    @property
    def land_length(self) -> float:
        """Arc length of the root circle from the middle of the root to the fillet [m]."""
        form = self.form
        return max(0.0, form.r_f * (form.half_pitch_angle - form.root_half_angle))

    def root(self, length: FloatArray) -> ComplexArray:
        """Points [m] at arc lengths [m] from the end of the fillet at the root circle, shape (n,).

        Positive lengths are on the fillet, negative ones on the root circle.
        """
        theta, _, along, _ = self._fillet
        fillet = self._at(np.interp(length, along, theta))
        angle = self.form.root_half_angle - np.minimum(length, 0.0) / self.form.r_f
        return np.where(length > 0.0, fillet, self.form.r_f * np.exp(1j * angle))
