# SPDX-License-Identifier: Apache-2.0
"""Straight pieces of beams of constant section: areas, second moments, shear.

The axis of the beam is its third axis, as the spin axis of a body. A shear-flexible beam bends with
phi = 12 E I / (kappa A G L^2) in each plane.

Shear factors: Cowper, J. Appl. Mech. 33 (1966) 335-340.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, kw_only=True)
class Section:
    """Cross-section of a straight beam; 1 and 2 are its principal axes.

    Parameters
    ----------
    A
        Area [m^2].
    I_1, I_2
        Second moments of area that resist bending towards axis 1 and towards axis 2: the integrals of x_1^2
        and of x_2^2 over the area [m^4].
    J
        Torsion constant [m^4]; the polar second moment for round sections only.
    kappa_1, kappa_2
        Shear factors for shear along axis 1 and 2; 0 for a beam without shear deflection.
    """

    A: float
    I_1: float
    I_2: float
    J: float
    kappa_1: float
    kappa_2: float

    @property
    def round(self) -> bool:
        """Whether no direction across the axis differs from another."""
        return self.I_1 == self.I_2 and self.kappa_1 == self.kappa_2


def tube(diameter: float, bore: float = 0.0, nu: float = 0.3) -> Section:
    """Section of a round shaft.

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

    The torsion constant is Saint-Venant's series, a b^3 (1/3 - 64/pi^5 (b/a) sum tanh(n pi a / 2 b) / n^5)
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
    """One element: a straight piece of constant section.

    Parameters
    ----------
    section
        Its section.
    length
        Length [m].
    E, G
        Elastic and shear modulus [Pa].
    rho
        Density [kg/m^3]; 0 for a beam without mass.
    """

    section: Section
    length: float
    E: float
    G: float
    rho: float = 0.0

    @property
    def mass(self) -> float:
        """Mass [kg]."""
        return self.rho * self.section.A * self.length

    def phi(self, plane: int) -> float:
        """Shear number 12 E I / (kappa A G L^2) of bending towards axis 1 or 2 [-]."""
        s = self.section
        second, kappa = (s.I_1, s.kappa_1) if plane == 1 else (s.I_2, s.kappa_2)
        if kappa == 0.0:
            return 0.0
        return 12.0 * self.E * second / (kappa * s.A * self.G * self.length**2)
