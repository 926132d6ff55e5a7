# SPDX-License-Identifier: Apache-2.0
"""One tooth as a cantilever in plane strain: displacement at one height of load due to a force at another.

The section is that of the generated tooth including its fillet, clamped where the tangent of the fillet is
inclined to the centre line of the tooth by a given angle. A force acts on the centre line where the line of
action crosses it, as in the method of Weber and Banaschek.

Source: C. Weber and K. Banaschek, Formänderung und Profilrücknahme bei gerad- und schrägverzahnten Rädern
(1953/55). Derivation: docs/theory/flank_compliance.md, "The tooth".
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.typing import ArrayLike, NDArray

from pitchpoint.contact.stiffness.tooth_compliance import fillet_section, section
from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.bisection import bisect
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.tooth_form import ToothForm, tooth_form

Array = NDArray[np.float64]

CLAMP = math.radians(30.0)
"""Default inclination of the tangent at the clamp of an external gear: section of ISO 6336-3."""
CLAMP_INTERNAL = math.radians(60.0)
"""Default inclination of an internal gear, as in ISO 6336-3."""

_FILLET_PANELS, _FLANK_PANELS = 12, 16
_RULE = leggauss(8)
_SCAN = 257


@dataclass(frozen=True)
class ClampedTooth:
    """One tooth clamped at a chord of its root.

    Parameters
    ----------
    form
        Exact tooth form.
    beta
        Helix angle [rad].
    clamp
        Inclination of the tangent of the fillet to the centre line of the tooth at the clamp [rad].
    start
        Position of the clamp on the fillet, 0 at the root circle, 1 at the form circle.

    Notes
    -----
    A helical tooth bends perpendicular to its trace. With the thickness of the transverse section times cos
    β, the tangential force divided by cos β and the length of the trace dz/cos β, all of them exact for an
    oblique prism, the compliance of a slice follows from that of a spur tooth. The real fillet of any
    generating tool, internal gears and profile shift need no virtual number of teeth then.
    """

    form: ToothForm
    beta: float
    clamp: float
    start: float

    # --- section --------------------------------------------------------------------------------------
    @property
    def cos_beta(self) -> float:
        """Cosine of the helix angle."""
        return math.cos(self.beta)

    @cached_property
    def _roll_angles(self) -> tuple[float, float]:
        """Roll angles at the form circle and at the tip end of the involute [rad]."""
        form = self.form
        low, high = (math.sqrt(max(0.0, (r / form.r_b) ** 2 - 1.0)) for r in (form.r_Ff, form.r_Fa))
        return low, high

    def outline(self, u: Array) -> tuple[Array, Array, Array]:
        """Points of the normal section along the flank.

        Parameters
        ----------
        u
            Positions: 0 at the root circle, 1 at the form circle, 2 at the tip, shape (n,).

        Returns
        -------
        thickness, height, slope : ndarray, shape (n,)
            Normal thickness [m], height above the root circle along the centre line [m], its derivative by u.
        """
        form, (low, high) = self.form, self._roll_angles
        span = self.form.theta_form - form.fillet.theta_root
        below = fillet_section(form, form.fillet.theta_root + span * np.minimum(u, 1.0))
        above = section(form, low + (high - low) * (np.maximum(u, 1.0) - 1.0))
        x, eta = (np.where(u < 1.0, a, b) for a, b in zip(below[:2], above[:2], strict=True))
        slope = np.where(u < 1.0, below[2] * span, above[2] * (high - low))
        return 2.0 * self.cos_beta * x, eta, slope

    @cached_property
    def _clamp_point(self) -> tuple[float, float]:
        thickness, eta, _ = self.outline(np.array([self.start]))
        return float(thickness[0]), float(eta[0])

    @property
    def chord(self) -> float:
        """Normal thickness of the tooth at the clamp s_f [m]."""
        return self._clamp_point[0]

    @cached_property
    def fillet_radius(self) -> float:
        """Radius of curvature of the fillet at the clamp, normal section [m]."""
        step = min(1e-3, 0.5 * self.start, 0.5 * (1.0 - self.start))
        thickness, eta, _ = self.outline(self.start + step * np.array([-1.0, 0.0, 1.0]))
        x = 0.5 * thickness
        (x_u, y_u), (x_uu, y_uu) = (
            (float(q @ x), float(q @ eta)) for q in (np.array([-0.5, 0.0, 0.5]), np.array([1.0, -2.0, 1.0]))
        )
        return math.hypot(x_u, y_u) ** 3 / abs(x_u * y_uu - x_uu * y_u)

    @cached_property
    def distance(self) -> float:
        """Distance of the clamped section from the gear axis [m]."""
        form = self.form
        r, angle = form.fillet_polar(form.fillet.theta_root)
        return float(r * np.cos(angle)) + form.sign * self._clamp_point[1]

    @cached_property
    def top(self) -> float:
        """Height of the tip end of the involute above the clamp [m]."""
        return float(self.outline(np.array([2.0]))[1][0]) - self._clamp_point[1]

    @cached_property
    def roll(self) -> tuple[float, float]:
        """Lengths of roll [m] at the form circle and at the tip end of the involute."""
        low, high = self._roll_angles
        return low * self.form.r_b, high * self.form.r_b

    # --- loads ----------------------------------------------------------------------------------------
    def load_angle(self, rho: ArrayLike) -> Array:
        """Angle of the line of action to the perpendicular of the tooth centre line [rad], shape of rho.

        Parameters
        ----------
        rho
            Lengths of roll [m].
        """
        roll = np.asarray(rho, dtype=np.float64) / self.form.r_b
        return roll - self.form.psi_b if self.form.sign > 0 else roll + self.form.psi_b

    def arms(self, rho: ArrayLike) -> tuple[Array, Array, Array]:
        """Effect of a unit force along the base tangent on the section.

        Parameters
        ----------
        rho
            Lengths of roll [m], any shape.

        Returns
        -------
        y, c, s : ndarray, shape of rho
            Height above the clamp at which the line of action crosses the centre line [m], force
            perpendicular to the centre line and along it (normal section).
        """
        alpha = self.load_angle(rho)
        y = self.form.sign * (self.form.r_b / np.cos(alpha) - self.distance)
        return y, np.cos(alpha) / self.cos_beta, np.sin(alpha)

    def root_loads(self, rho: ArrayLike) -> Array:
        """Moment, shear and normal force on the clamped section per unit force along the base tangent.

        Parameters
        ----------
        rho
            Lengths of roll [m], shape (n,).

        Returns
        -------
        ndarray, shape (n, 3)
            (y c, c, s) of `arms` [m, -, -].
        """
        y, c, s = self.arms(rho)
        return np.stack([y * c, c, s], axis=-1)

    # --- integrals ------------------------------------------------------------------------------------
    @cached_property
    def _edges(self) -> tuple[Array, Array, Array]:
        """Panel edges: positions u, heights above the clamp, integrals up to them (4 by panel edge)."""
        fillet = np.linspace(self.start, 1.0, _FILLET_PANELS + 1)[:-1] if self.start < 1.0 else np.empty(0)
        u = np.concatenate([fillet, np.linspace(1.0, 2.0, _FLANK_PANELS + 1)])
        pieces = self._pieces(u[:-1], u[1:])
        sums = np.concatenate([np.zeros((4, 1)), np.cumsum(pieces, axis=1)], axis=1)
        return u, self.outline(u)[1] - self._clamp_point[1], sums

    def _pieces(self, lower: Array, upper: Array) -> Array:
        """Integrals of (1, y, y²)/s³ and 1/s over the height between positions, shape (4, n)."""
        half = 0.5 * (upper - lower)
        u = (0.5 * (upper + lower))[:, None] + half[:, None] * _RULE[0]
        s, eta, slope = self.outline(u)
        y = eta - self._clamp_point[1]
        values = np.stack([1.0 / s**3, y / s**3, y * y / s**3, 1.0 / s])
        return np.asarray((values * slope) @ _RULE[1] * half)

    def position(self, y: Array) -> Array:
        """Positions u of heights above the clamp [m], shape of y; heights must not exceed `top`.

        Parameters
        ----------
        y
            Heights above the clamp, >= 0 [m].
        """
        edges, heights, _ = self._edges
        panel = np.clip(np.searchsorted(heights, y, side="right") - 1, 0, edges.size - 2)
        low, high = edges[panel], edges[panel + 1]
        for _ in range(52):
            middle = 0.5 * (low + high)
            above = self.outline(middle)[1] - self._clamp_point[1] > y
            low, high = np.where(above, low, middle), np.where(above, middle, high)
        return np.asarray(0.5 * (low + high))

    def integrals(self, y: Array) -> Array:
        """Integrals of (1, η, η²)/s³ and 1/s from the clamp to heights y, shape (4, *y.shape).

        Parameters
        ----------
        y
            Heights above the clamp [m], any shape; negative ones give zero.

        Notes
        -----
        s(η) is the normal thickness: 12/s³ and 1/s are the reciprocal moment of inertia and area per unit
        length of the trace, used by Weber and Banaschek (1953).
        """
        edges, _, sums = self._edges
        u = self.position(np.maximum(y, 0.0).ravel())
        panel = np.clip(np.searchsorted(edges, u, side="right") - 1, 0, edges.size - 2)
        found = sums[:, panel] + self._pieces(edges[panel], u)
        return np.where(y > 0.0, found.reshape(4, *y.shape), 0.0)

    def influence(self, rho: ArrayLike, rho_load: ArrayLike, E: float, nu: float) -> Array:
        """Displacement of the clamped tooth along the base tangent per force, plane strain, unit face width.

        Parameters
        ----------
        rho
            Lengths of roll of the observed points [m].
        rho_load
            Lengths of roll of the forces [m], broadcast against rho.
        E, nu
            Young's modulus [Pa], Poisson's ratio.

        Returns
        -------
        ndarray, shape of the arguments broadcast
            Compliance per unit face width [m²/N]; symmetric in the first two arguments.

        Notes
        -----
        With y, c, s of `arms` at both heights and integrals up to the lower one, for unit length of trace

            (1 − ν²)/E {12 c c' ∫(y − η)(y' − η)/s³ dη + [2.4/(1 − ν) c c' + s s'] ∫dη/s}

        which is the formula of Weber and Banaschek (1953) for y = y'.
        """
        (y, c, s), (y_2, c_2, s_2) = self.arms(rho), self.arms(rho_load)
        lower = y <= y_2
        below = self.integrals(y)
        J0, J1, J2, S = below if rho is rho_load else np.where(lower, below, self.integrals(y_2))
        bending = 12.0 * c * c_2 * (y * y_2 * J0 - (y + y_2) * J1 + J2)
        straight = (2.4 / (1.0 - nu) * c * c_2 + s * s_2) * S
        return np.asarray((1.0 - nu * nu) / E * self.cos_beta * (bending + straight))


@lru_cache(maxsize=64)
def clamped_tooth(gear: CylindricalGear, clamp: float | None = None) -> ClampedTooth:
    """Tooth of a gear clamped at a tangent of its fillet.

    Parameters
    ----------
    gear
        External or internal gear.
    clamp
        Inclination of the tangent to the centre line of the tooth at the clamp [rad], normal section; None:
        30°, for internal gears 60°.

    Raises
    ------
    GeometryError
        If the fillet does not have a tangent with this inclination.

    Examples
    --------
    >>> tooth = clamped_tooth(CylindricalGear(z=17, m_n=1e-3))
    >>> round(1e3 * tooth.chord, 4)
    1.884
    """
    return clamped_form(tooth_form(gear), gear.beta, clamp)


def clamped_form(form: ToothForm, beta: float, clamp: float | None = None) -> ClampedTooth:
    """Tooth form clamped at a tangent of its fillet.

    Parameters
    ----------
    form
        Exact tooth form.
    beta
        Helix angle of the section [rad].
    clamp
        As for `clamped_tooth`.

    Raises
    ------
    GeometryError
        If the fillet does not have a tangent with this inclination.

    Examples
    --------
    >>> tooth = clamped_form(tooth_form(CylindricalGear(z=17, m_n=1e-3)), 0.0)
    >>> round(1e3 * tooth.chord, 4), round(1e3 * tooth.fillet_radius, 4)
    (1.884, 0.5811)
    """
    angle = clamp if clamp is not None else (CLAMP if form.sign > 0 else CLAMP_INTERNAL)
    span = form.theta_form - form.fillet.theta_root
    step = 1e-5

    def inclination(t: float) -> float:
        """Inclination of the tangent at a position between root and form circle [rad]."""
        ends = form.fillet.theta_root + span * np.array([t - step, t + step])
        x, eta, _ = fillet_section(form, ends)
        return math.atan2(float(x[0] - x[1]) * math.cos(beta), float(eta[1] - eta[0]))

    grid = np.linspace(step, 1.0 - step, _SCAN)
    values = np.array([inclination(float(t)) for t in grid])
    below = np.nonzero(values < angle)[0]
    if isinstance(clamp, bool) or not math.isfinite(angle) or below.size == 0 or below[0] == 0:
        raise GeometryError(
            "is not the inclination of a tangent of the fillet",
            where="clamp",
            value=f"{math.degrees(angle):.4g} deg",
            limit=f"{math.degrees(values.min()):.4g} to {math.degrees(values[0]):.4g} deg",
            remedy="set clamp within the limits",
        )
    first = int(below[0])
    start = bisect(lambda t: inclination(t) - angle, float(grid[first - 1]), float(grid[first]))
    return ClampedTooth(form, beta, angle, start)
