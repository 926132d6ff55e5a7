# SPDX-License-Identifier: Apache-2.0
"""Broken tip edges in the transverse section: chamfer at 45° or rounding between flank and tip circle.

All lengths are positive, also for internal gears. The tooth is on the x axis, its left flank above it.

Derivation: docs/theory/geometry.md, "Tip edges".
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.bisection import bisect
from pitchpoint.geometry.tooth_thickness import tip_thickness

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

FloatArray = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]

SLOPE = complex(math.sqrt(0.5), -math.sqrt(0.5))
"""Direction of the chamfer of an external tooth from flank to tip: 45° to the centre line of the tooth."""
_ARC_SHARE = 16
"""Points of a flank per point of a rounding; at least four points."""
_NODES = np.polynomial.legendre.leggauss(20)
"""Abscissas and weights of the integrals along an edge, exact to round-off."""


@dataclass(frozen=True, kw_only=True)
class TipEdge:
    """Edge between flank and tip circle.

    Parameters
    ----------
    sign
        +1 for external, −1 for internal teeth.
    r_b, r_a
        Base and tip radius [m].
    psi_b
        Half tooth angle at the base circle [rad], as in `ToothForm`.
    chamfer
        Radial height of the chamfer h_K [m]; 0 for a rounding.
    rounding
        Radius of the rounding, tangent to the involute and to the tip circle [m]; 0 for a chamfer.

    Examples
    --------
    A chamfer of 0.3 mm and a rounding of 0.3 mm at the tip of a spur gear with 30 teeth of module 3 mm:

    >>> half = math.pi / 60.0 + math.tan(math.radians(20.0)) - math.radians(20.0)
    >>> size = {"sign": 1, "r_b": 45e-3 * math.cos(math.radians(20.0)), "r_a": 48e-3, "psi_b": half}
    >>> edges = TipEdge(**size, chamfer=0.3e-3), TipEdge(**size, rounding=0.3e-3)
    >>> [round(2e3 * edge.r_Fa, 4) for edge in edges], [round(math.degrees(edge.arc), 2) for edge in edges]
    ([95.4, 95.6791], [18.95, 62.44])
    """

    sign: int
    r_b: float
    r_a: float
    psi_b: float
    chamfer: float = 0.0
    rounding: float = 0.0

    @cached_property
    def _centre(self) -> float:
        """Roll angle of the centre of the rounding [rad]."""
        distance = (self.r_a - self.sign * self.rounding) / self.r_b
        if not distance > 1.0:
            raise _too_large("tip_rounding", self.rounding)
        return math.sqrt(distance * distance - 1.0)

    @cached_property
    def roll(self) -> float:
        """Roll angle at the tip form circle [rad].

        Raises
        ------
        GeometryError
            If it would be inside the base circle.
        """
        if self.rounding > 0.0:
            found = self._centre + self.sign * self.rounding / self.r_b
            if not found > 0.0:
                raise _too_large("tip_rounding", self.rounding)
            return found
        distance = (self.r_a - self.sign * self.chamfer) / self.r_b
        if not distance > 1.0:
            raise _too_large("tip_chamfer", self.chamfer)
        return math.sqrt(distance * distance - 1.0)

    @cached_property
    def r_Fa(self) -> float:
        """Tip form radius, where the involute ends [m]."""
        roll = self.roll
        if self.rounding > 0.0:
            return self.r_b * math.hypot(1.0, roll)
        return self.r_a - self.sign * self.chamfer

    @cached_property
    def _tangent(self) -> complex:
        """Direction from the axis to the base circle where the tangent to the tip form point leaves it."""
        angle = self.psi_b - self.sign * self.roll
        return complex(math.cos(angle), math.sin(angle))

    @cached_property
    def start(self) -> complex:
        """Point at the tip form circle x + iy [m]."""
        return self.r_b * self._tangent * complex(1.0, self.sign * self.roll)

    @cached_property
    def end(self) -> complex:
        """Point at the tip circle x + iy [m].

        Raises
        ------
        GeometryError
            If a chamfer does not reach the tip circle.
        """
        if self.rounding > 0.0:
            centre = self._tangent * complex(1.0, self.sign * self._centre)
            return self.r_a * centre / abs(centre)
        way = SLOPE if self.sign > 0 else -SLOPE.conjugate()
        along = (self.start * way.conjugate()).real
        rise = self.r_a * self.r_a - self.r_Fa * self.r_Fa
        square = along * along + rise
        if square < 0.0:
            raise _too_large("tip_chamfer", self.chamfer)
        return self.start + rise / (along + self.sign * math.sqrt(square)) * way

    @property
    def land_half_angle(self) -> float:
        """Half angle of the tip land that remains [rad]; not above 0 if there is none."""
        end = self.end
        return math.atan2(end.imag, end.real)

    @property
    def arc(self) -> float:
        """Angle by which the normal turns from the involute to the chamfer, or over the whole rounding [rad].

        In contact with a mate the edge at the tip form circle, or the rounding, touches as long as the common
        normal has turned by less (see `contact.tip_contact`).
        """
        if self.rounding > 0.0:
            return 0.5 * math.pi - math.atan(self._centre)
        return 0.25 * math.pi + self.sign * math.atan2(self._tangent.imag, self._tangent.real)

    def points(self, t: FloatArray) -> tuple[ComplexArray, ComplexArray]:
        """Points of the edge and their derivatives by t.

        Parameters
        ----------
        t
            Parameters, 0 at the tip form circle to 1 at the tip circle, shape (n,).

        Returns
        -------
        points, slopes : ndarray, shape (n,)
            x + iy [m].
        """
        if self.rounding == 0.0:
            along = self.end - self.start
            return np.asarray(self.start + along * t), np.asarray(along * np.ones_like(t))
        turn = -self.sign * self.arc
        spoke = 1j * self._tangent * self.rounding * np.exp(1j * turn * t)
        centre = self.r_b * self._tangent * complex(1.0, self.sign * self._centre)
        return np.asarray(centre + spoke), np.asarray(1j * turn * spoke)

    def drawn(self, n_flank: int) -> tuple[FloatArray, FloatArray]:
        """Radii and half tooth angles of points in drawings.

        Parameters
        ----------
        n_flank
            Points per flank.

        Returns
        -------
        r, half_angle : ndarray, shape (n,)
            From the first point beyond the flank to the tip circle [m, rad]: one of a chamfer.
        """
        count = 1 if self.rounding == 0.0 else max(4, n_flank // _ARC_SHARE)
        plane, _ = self.points(np.linspace(0.0, 1.0, count + 1)[1:])
        r = np.abs(plane)
        r[-1] = self.r_a
        return r, np.angle(plane)

    def integral(self, power: int) -> float:
        """Integral of r^power over the half tooth angle from the flank to the tip circle.

        Parameters
        ----------
        power
            2 or 4.

        Returns
        -------
        float
            [m²] or [m⁴], negative for a tooth that becomes thinner towards its tip.
        """
        nodes, weights = _NODES
        plane, slope = self.points(0.5 * (nodes + 1.0))
        turned = (plane.conj() * slope).imag
        return float(0.5 * np.sum(weights * np.abs(plane) ** (power - 2) * turned))


def tip_edge(gear: CylindricalGear) -> TipEdge | None:
    """Broken tip edge of a gear, None for a sharp one.

    Parameters
    ----------
    gear
        External or internal gear.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> edge = tip_edge(CylindricalGear(z=30, m_n=3e-3, tip_rounding=0.3e-3))
    >>> round(2e3 * edge.r_Fa, 4), tip_edge(CylindricalGear(z=30, m_n=3e-3))
    (95.6791, None)
    """
    if not gear.tip_chamfer and not gear.tip_rounding:
        return None
    return TipEdge(
        sign=gear.sign,
        r_b=abs(gear.r_b),
        r_a=0.5 * abs(gear.d_a),
        psi_b=gear.sign * gear.psi_b,
        chamfer=gear.tip_chamfer or 0.0,
        rounding=gear.tip_rounding or 0.0,
    )


def sharp(gear: CylindricalGear) -> CylindricalGear:
    """The gear with sharp tip edges.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = sharp(CylindricalGear(z=30, m_n=3e-3, tip_chamfer=0.3e-3))
    >>> gear.d_Fa == gear.d_a
    True
    """
    return gear if tip_edge(gear) is None else gear.replace(tip_chamfer=None, tip_rounding=None)


def large_edge(gear: CylindricalGear) -> tuple[str, str, str, str, str] | None:
    """Key, message, value, limit and remedy if chamfer or rounding leave no tip land or no involute.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> large_edge(CylindricalGear(z=30, m_n=3e-3, tip_rounding=2e-3))[1:4]
    ('is larger than the tip', '2.0000 mm', '1.7425 mm, at a tip thickness of 2.2122 mm')
    """
    if tip_edge(gear) is None:
        return None
    key = "tip_chamfer" if gear.tip_chamfer else "tip_rounding"
    amount = gear.tip_chamfer or gear.tip_rounding or 0.0

    def spare(size: float) -> float:
        """Half angle of the tip land for an edge of this size, negative without an involute."""
        try:
            edge = tip_edge(gear.replace(**{key: size}))
            if edge is None:
                return 1.0
            return edge.land_half_angle if gear.sign * edge.r_Fa > 0.5 * gear.d_Ff else -1.0
        except GeometryError:
            return -1.0

    if spare(amount) > 0.0:
        return None
    most = 1e3 * bisect(spare, 0.0, amount)
    limit = f"{most:.4f} mm, at a tip thickness of {1e3 * tip_thickness(sharp(gear)):.4f} mm"
    return key, "is larger than the tip", f"{1e3 * amount:.4f} mm", limit, "reduce it"


def _too_large(where: str, value: float) -> GeometryError:
    return GeometryError(
        "is larger than the tip",
        where=where,
        value=f"{1e3 * value:.4f} mm",
        limit="an involute that ends above the base circle",
        remedy="reduce it",
    )
