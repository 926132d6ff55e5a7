# SPDX-License-Identifier: Apache-2.0
"""Matrices of Timoshenko beam elements: stiffness, consistent mass, gyroscopic matrix.

The beam axis is the third axis, like the spin axis of a body. Order of the twelve displacements: three
translations and three rotations of the first end, then those of the second end. The shape functions are the
exact static ones of a shear-flexible beam, with phi = 12 E I / (kappa A G L^2) in each plane.

Sources: Friswell, Penny, Garvey, Lees, Dynamics of Rotating Machines (2010), section 5.4 and 5.5;
Przemieniecki, Theory of Matrix Structural Analysis (1968), chapters 5, 11 and 15; shear factors: Cowper, J.
Appl. Mech. 33 (1966) 335-340.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.multibody.beam_coupling import Coupling, end_matrix

Matrix = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Section:
    """Cross-section of a straight beam; 1 and 2 are its principal axes.

    Parameters
    ----------
    A
        Area [m^2].
    I_1, I_2
        Second moments of area for bending in direction 1 and in direction 2: integrals of x_1^2 and of x_2^2
        over the area [m^4].
    J
        Torsion constant [m^4]; the polar second moment for round sections only.
    kappa_1, kappa_2
        Shear correction factors in direction 1 and 2; 0 for a beam without shear deformation.
    """

    A: float
    I_1: float
    I_2: float
    J: float
    kappa_1: float
    kappa_2: float

    @property
    def round(self) -> bool:
        """Whether bending stiffness and shear stiffness are the same in both directions."""
        return self.I_1 == self.I_2 and self.kappa_1 == self.kappa_2


def tube(diameter: float, bore: float = 0.0, nu: float = 0.3) -> Section:
    """Section of a solid or hollow round shaft.

    Parameters
    ----------
    diameter, bore
        Outer and inner diameter [m].
    nu
        Poisson's ratio [-], for the shear factor: kappa = 6 (1 + nu) (1 + m^2)^2 /
        ((7 + 6 nu) (1 + m^2)^2 + (20 + 12 nu) m^2) with m = bore/diameter (Cowper 1966).

    Examples
    --------
    >>> round(tube(0.05).I_1 * 1e9, 4)
    306.7962
    >>> round(tube(0.05).kappa_1, 4)
    0.8864
    """
    m = bore / diameter
    A = 0.25 * math.pi * (diameter**2 - bore**2)
    second = math.pi / 64.0 * (diameter**4 - bore**4)
    s = (1.0 + m * m) ** 2
    kappa = 6.0 * (1.0 + nu) * s / ((7.0 + 6.0 * nu) * s + (20.0 + 12.0 * nu) * m * m)
    return Section(A=A, I_1=second, I_2=second, J=2.0 * second, kappa_1=kappa, kappa_2=kappa)


def rectangle(width: float, height: float, nu: float = 0.3) -> Section:
    """Section of a rectangular bar, `width` along axis 1 and `height` along axis 2.

    Parameters
    ----------
    width, height
        Sides [m].
    nu
        Poisson's ratio [-], for the shear factor 10 (1 + nu) / (12 + 11 nu) (Cowper 1966).

    The torsion constant is the Saint-Venant series a b^3 (1/3 - 64/pi^5 (b/a) sum tanh(n pi a / 2 b) / n^5)
    over odd n, with a >= b.

    Examples
    --------
    >>> round(rectangle(1.0, 1.0).J, 5)
    0.14058
    """
    a, b = max(width, height), min(width, height)
    odd = np.arange(1, 60, 2)
    series = float(np.sum(np.tanh(0.5 * math.pi * odd * a / b) / odd**5.0))
    kappa = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu)
    return Section(
        A=width * height,
        I_1=height * width**3 / 12.0,
        I_2=width * height**3 / 12.0,
        J=a * b**3 * (1.0 / 3.0 - 64.0 / math.pi**5 * b / a * series),
        kappa_1=kappa,
        kappa_2=kappa,
    )


@dataclass(frozen=True, kw_only=True)
class Beam:
    """One beam element: straight, with constant section.

    Parameters
    ----------
    section
        Cross-section.
    length
        Length [m].
    E, G
        Young's modulus and shear modulus [Pa].
    rho
        Density [kg/m^3]; 0 for a massless beam.
    coupling
        Stiffness and damping of the deformations instead of E and G, for sections whose bending, torsion and
        extension are coupled; None: that of the section.
    shear
        Shear parameter of the shapes of the mass, for an element with mass only; None: that of the section.
    """

    section: Section
    length: float
    E: float
    G: float
    rho: float = 0.0
    coupling: Coupling | None = None
    shear: float | None = None

    @property
    def mass(self) -> float:
        """Mass [kg]."""
        return self.rho * self.section.A * self.length

    def phi(self, plane: int) -> float:
        """Shear parameter 12 E I / (kappa A G L^2) for bending in direction 1 or 2 [-]."""
        s = self.section
        if self.shear is not None:
            return self.shear
        if self.coupling is not None:
            return self.coupling.phi(plane)
        second, kappa = (s.I_1, s.kappa_1) if plane == 1 else (s.I_2, s.kappa_2)
        if kappa == 0.0:
            return 0.0
        return 12.0 * self.E * second / (kappa * s.A * self.G * self.length**2)

    def stiffness(self) -> Matrix:
        """Stiffness matrix (12, 12) [N/m, N/rad, N m/rad]."""
        s, h = self.section, self.length
        if self.coupling is not None:
            ends = np.hstack([-end_matrix(h) @ _carried(h), end_matrix(h)])
            return np.asarray(ends.T @ self.coupling.stiffness @ ends)
        K = np.zeros((12, 12))
        for plane, second in ((1, s.I_1), (2, s.I_2)):
            p = self.phi(plane)
            rows = [[12.0, 6 * h, -12, 6 * h], [0, (4 + p) * h**2, -6 * h, (2 - p) * h**2]]
            rows += [[0, 0, 12, -6 * h], [0, 0, 0, (4 + p) * h**2]]
            _spread(K, plane, self.E * second / ((1 + p) * h**3) * _full(rows))
        _pair(K, 2, self.E * s.A / h * np.array([[1.0, -1.0], [-1.0, 1.0]]))
        _pair(K, 5, self.G * s.J / h * np.array([[1.0, -1.0], [-1.0, 1.0]]))
        return K

    def consistent_mass(self) -> Matrix:
        """Consistent mass matrix (12, 12) with rotary inertia [kg, kg m, kg m^2]."""
        s, h = self.section, self.length
        M = np.zeros((12, 12))
        for plane, second in ((1, s.I_1), (2, s.I_2)):
            p = self.phi(plane)
            a, b, c = 312 + 588 * p + 280 * p**2, (44 + 77 * p + 35 * p**2) * h, 108 + 252 * p + 140 * p**2
            d, e = -(26 + 63 * p + 35 * p**2) * h, (8 + 14 * p + 7 * p**2) * h**2
            f = -(6 + 14 * p + 7 * p**2) * h**2
            rows = [[a, b, c, d], [0, e, -d, f], [0, 0, a, -b], [0, 0, 0, e]]
            _spread(M, plane, self.mass / (840 * (1 + p) ** 2) * _full(rows))
            _spread(M, plane, self.rho * second * self._rotary(p))
        third = np.array([[2.0, 1.0], [1.0, 2.0]]) / 6.0
        _pair(M, 2, self.mass * third)
        _pair(M, 5, self.rho * (s.I_1 + s.I_2) * h * third)
        return M

    def gyroscopic(self) -> Matrix:
        """Gyroscopic matrix D (12, 12) per spin speed; the force is -omega D x' [kg m^2].

        For round sections only. It couples bending in the two directions.
        """
        p = self.phi(1)
        polar = self.rho * (self.section.I_1 + self.section.I_2) * self._rotary(p)
        D = np.zeros((12, 12))
        # displacements of plane 1: x, ry; of plane 2: y, -rx
        one, two = _places(1), _places(2)
        for r in range(4):
            for c in range(4):
                D[one[r][0], two[c][0]] += one[r][1] * two[c][1] * polar[r, c]
                D[two[r][0], one[c][0]] -= two[r][1] * one[c][1] * polar[r, c]
        return D

    def _rotary(self, p: float) -> Matrix:
        """Rotary inertia of one plane per rho I (4, 4): integrals of products of the section rotations."""
        h = self.length
        a, b = 36.0, (3 - 15 * p) * h
        c, d = (4 + 5 * p + 10 * p**2) * h**2, (-1 - 5 * p + 5 * p**2) * h**2
        rows = [[a, b, -a, b], [0, c, -b, d], [0, 0, a, -b], [0, 0, 0, c]]
        return _full(rows) / (30.0 * h * (1 + p) ** 2)


def _carried(length: float) -> Matrix:
    """Displacement and rotation of the second end of a rigid element for those of the first, shape (6, 6)."""
    out = np.eye(6)
    out[0, 4], out[1, 3] = length, -length
    return out


def _full(rows: list[list[float]]) -> Matrix:
    upper = np.triu(np.array(rows, float))
    return upper + np.triu(upper, 1).T


def _places(plane: int) -> tuple[tuple[int, float], ...]:
    """Index and sign of deflection and slope of both ends in a plane; the slope is ry or -rx."""
    first, turn, sign = (0, 4, 1.0) if plane == 1 else (1, 3, -1.0)
    return ((first, 1.0), (turn, sign), (6 + first, 1.0), (6 + turn, sign))


def _spread(K: Matrix, plane: int, part: Matrix) -> None:
    for r, (i, a) in enumerate(_places(plane)):
        for c, (j, b) in enumerate(_places(plane)):
            K[i, j] += a * b * part[r, c]


def _pair(K: Matrix, first: int, part: Matrix) -> None:
    K[np.ix_([first, first + 6], [first, first + 6])] += part
