# SPDX-License-Identifier: Apache-2.0
"""Compliance of one tooth under a force on its flank: bending, shear, compression and gear body.

The tooth is a cantilever clamped at the root circle with the exact section of `geometry.tooth_form`. All
integrals over the height are cumulative from the root, so each point of the path of contact costs one step.

Source: Ma, Song, Pang, Wen, Eng. Fail. Anal. 44 (2014) 179; gear body Sainsot, Velex, Duverger, J. Mech. Des.
126 (2004) 748.
"""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass

import numpy as np
from numpy.polynomial.legendre import leggauss

from pitchpoint.contact.stiffness.description import Array
from pitchpoint.core.errors import ValidityWarning
from pitchpoint.geometry.tooth_form import ToothForm

#: Coefficients A..F of L*, M*, P*, Q* (Sainsot, Velex and Duverger 2004, table 1).
BODY = np.array(
    [
        [-5.574e-5, -1.9986e-3, -2.3015e-4, 4.7702e-3, 0.0271, 6.8045],
        [60.111e-5, 28.100e-3, -83.431e-4, -9.9256e-3, 0.1624, 0.9086],
        [-50.952e-5, 185.50e-3, 0.0538e-4, 53.300e-3, 0.2895, 0.9236],
        [-6.2042e-5, 9.0889e-3, -4.0964e-4, 7.8297e-3, -0.1472, 0.6904],
    ]
)

#: Ranges of the fit: half tooth angle at the root [rad], ratio of root to bore radius.
THETA_RANGE = (0.01, 0.12)
RATIO_RANGE = (1.4, 7.0)

#: Ratio for a gear without bore: the fit requires a clamped circle, assumed at half the root radius.
SOLID_RATIO = 2.0

_FILLET = leggauss(40)
_BELOW = leggauss(16)
_STEP = leggauss(3)


@dataclass(frozen=True)
class ToothCompliance:
    """Compliances of one tooth per unit face width along the base tangent, shape (n,) each [m^2/N].

    `depth` is the distance from the contact point to the centre line along the line of action [m].
    """

    bending: Array
    shear: Array
    axial: Array
    body: Array
    depth: Array

    @property
    def total(self) -> Array:
        """Sum of the four compliances [m^2/N], shape (n,)."""
        return self.bending + self.shear + self.axial + self.body


def section(form: ToothForm, roll: Array) -> tuple[Array, Array, Array]:
    """Half thickness, height above the tooth root [m], its derivative by the roll angle, shape (n,) each.

    Parameters
    ----------
    form
        Exact tooth form.
    roll
        Roll angles of flank points [rad], shape (n,).

    Examples
    --------
    On the reference circle half a tooth without profile shift spans the angle pi/(2 z):

    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> gear = CylindricalGear(z=30, m_n=1.0, b=1.0)
    >>> form = tooth_form(gear)
    >>> half, _, _ = section(form, np.array([np.tan(gear.alpha_t)]))
    >>> bool(abs(half[0] - 15.0 * math.sin(math.pi / 60.0)) < 1e-12)
    True
    """
    sign = form.sign
    r = form.r_b * np.hypot(1.0, roll)
    psi = form.psi_b - sign * (roll - np.arctan(roll))
    slope = form.r_b**2 * roll / r * np.cos(psi) + sign * r * np.sin(psi) * roll**2 / (1.0 + roll**2)
    return r * np.sin(psi), sign * (r * np.cos(psi) - _root_height(form)), sign * slope


def _root_height(form: ToothForm) -> float:
    r, angle = form.fillet_polar(form.fillet.theta_root)
    return float(r * np.cos(angle))


def _integrands(x: Array, eta: Array) -> Array:
    """1/I, eta/I, eta^2/I and 1/A per unit width, shape (4, ...)."""
    flexibility = 1.5 / x**3
    return np.stack([flexibility, eta * flexibility, eta * eta * flexibility, 0.5 / x])


def fillet_section(form: ToothForm, theta: Array) -> tuple[Array, Array, Array]:
    """Same as `section` for points of the fillet, with the derivative by the fillet parameter.

    Parameters
    ----------
    form
        Exact tooth form.
    theta
        Fillet parameters [rad], shape (n,).

    Examples
    --------
    The fillet begins at the root, where the height is zero:

    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> form = tooth_form(CylindricalGear(z=30, m_n=1.0, b=1.0))
    >>> _, height, _ = fillet_section(form, np.array([form.fillet.theta_root]))
    >>> round(float(height[0]), 12) + 0.0
    0.0
    """
    h = 0.5e-5 * abs(form.theta_form - form.fillet.theta_root)

    def point(t: Array) -> tuple[Array, Array]:
        """Half thickness and height above the root at fillet parameters t, shapes of t [m]."""
        r, angle = form.fillet_polar(t)
        return r * np.sin(angle), form.sign * (r * np.cos(angle) - _root_height(form))

    x, eta = point(theta)
    return x, eta, (point(theta + h)[1] - point(theta - h)[1]) / (2.0 * h)


def _fillet_integrals(form: ToothForm) -> Array:
    """Integrals of `_integrands` over the fillet, from the root circle to the form circle, shape (4,)."""
    start, stop = form.fillet.theta_root, form.theta_form
    half = 0.5 * (stop - start)
    theta = 0.5 * (start + stop) + half * _FILLET[0]
    x, eta, slope = fillet_section(form, theta)
    return np.asarray(_integrands(x, eta) @ (half * _FILLET[1] * slope))


def _cumulative_integrals(form: ToothForm, roll: Array) -> Array:
    """Integrals from the root up to each roll angle (ordered from root to tip), shape (4, n)."""

    def pieces(lower: Array, upper: Array, rule: tuple[Array, Array]) -> Array:
        """Integrals over the intervals from `lower` to `upper`, shapes (n,), by a Gauss rule."""
        half = 0.5 * (upper - lower)
        t = (0.5 * (upper + lower))[:, None] + half[:, None] * rule[0]
        x, eta, slope = section(form, t)
        return np.asarray((_integrands(x, eta) * slope) @ rule[1] * half)

    form_roll = np.array([math.sqrt(max(0.0, (form.r_Ff / form.r_b) ** 2 - 1.0))])
    below = _fillet_integrals(form)[:, None] + pieces(form_roll, roll[:1], _BELOW)
    steps = np.cumsum(pieces(roll[:-1], roll[1:], _STEP), axis=1)
    return np.concatenate([below, below + steps], axis=1)


def body_coefficients(theta_f: float, radius_ratio: float) -> tuple[float, float, float, float]:
    """Coefficients L*, M*, P*, Q* of the tooth deflection due to the gear body.

    Parameters
    ----------
    theta_f
        Half tooth angle at the root circle [rad]; fitted for 0.01 to 0.12.
    radius_ratio
        Root radius over bore radius, h = r_f/r_int; fitted for 1.4 to 7. The disc is clamped at the bore: a
        smaller bore gives a more compliant body.

    Notes
    -----
    X* = A/theta_f^2 + B h^2 + C h/theta_f + D/theta_f + E h + F. P. Sainsot, P. Velex and O. Duverger,
    "Contribution of gear body to tooth deflections", J. Mech. Des. 126 (2004) 748. A ValidityWarning reports
    arguments outside the range of the fit.

    Examples
    --------
    >>> [round(c, 4) for c in body_coefficients(0.05, 3.0)]
    [6.9271, 1.19, 4.3241, 0.4378]
    """
    h = radius_ratio
    for name, value, (low, high) in (
        ("half tooth angle at the root circle theta_f [rad]", theta_f, THETA_RANGE),
        ("root radius over bore radius h", h, RATIO_RANGE),
    ):
        if not low <= value <= high:
            warnings.warn(
                f"{name} = {value:.3g} lies outside the range {low} to {high} of the gear body formula"
                " (Sainsot, Velex and Duverger 2004)",
                ValidityWarning,
                stacklevel=2,
            )
    terms = np.array([1.0 / theta_f**2, h * h, h / theta_f, 1.0 / theta_f, h, 1.0])
    L, M, P, Q = (float(c) for c in BODY @ terms)
    return L, M, P, Q


def _body_compliance(form: ToothForm, c: Array, height: Array, bore: float | None) -> Array:
    """Compliance of the gear body times E; c is the cosine of the load angle a1.

    cos^2 a1 [L* (u/s_f)^2 + M* u/s_f + P* (1 + Q* tan^2 a1)], s_f = 2 r_f theta_f, u = height - r_f.
    Sainsot, Velex and Duverger measure u to the intersection of the line of action with the tooth centre
    line, at r_b/cos a1 ("load_line"). Some programs use the height of the contact point instead
    ("contact_point"), which makes the body more compliant.
    """
    theta_f = form.root_half_angle
    L, M, P, Q = body_coefficients(theta_f, 2.0 * form.r_f / bore if bore else SOLID_RATIO)
    u = (height - form.r_f) / (2.0 * form.r_f * theta_f)
    return np.asarray(c * c * (L * u * u + M * u + P * (1.0 + Q * (1.0 / (c * c) - 1.0))))


def bending_terms(
    form: ToothForm, roll: Array, beta: float, moments: tuple[Array, Array, Array]
) -> tuple[Array, Array, Array, Array]:
    """Bending of a tooth by forces at contact points; symbols as in `tooth_compliance`.

    Parameters
    ----------
    form
        Exact tooth.
    roll
        Roll angles of the contact points [rad], shape (n,).
    beta
        Helix angle [rad].
    moments
        Integrals of eta^k/I from the root per unit face width, k = 0, 1, 2, shape (n,) each.

    Returns
    -------
    tuple of ndarray
        Compliance times E cos^4(beta), cos a1, sin a1 and half thickness x [m], shape (n,) each.

    Examples
    --------
    With the compliance at the root alone, its root is the lever of the force about the root:

    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> form = tooth_form(CylindricalGear(z=62, m_n=2e-3))
    >>> one, none = np.ones(1), np.zeros(1)
    >>> bending, c, s, x = bending_terms(form, np.array([0.4]), 0.0, (one, none, none))
    >>> height = section(form, np.array([0.4]))[1]
    >>> bool(abs(np.sqrt(bending) - (c * height - s * x))[0] < 1e-12)
    True
    """
    J0, J1, J2 = moments
    x, eta, _ = section(form, roll)
    psi = form.psi_b - form.sign * (roll - np.arctan(roll))
    angle = np.arctan(roll) - form.sign * psi
    c, s = np.cos(angle), np.sin(angle)
    lever = s * x * math.cos(beta) ** 2
    bending = (
        c * c * (eta * eta * J0 - 2.0 * eta * J1 + J2)
        - 2.0 * c * lever * (eta * J0 - J1)
        + lever * lever * J0
    )
    return bending, c, s, x


def tooth_compliance(
    form: ToothForm, rho: Array, *, beta: float, E: float, nu: float, bore: float | None, body: str
) -> ToothCompliance:
    """Compliances of one tooth for forces at points of its flank.

    Parameters
    ----------
    form
        Exact tooth form.
    rho
        Transverse radii of curvature at the contact points (distances from the tangent point on the base
        circle), positive and monotone [m], shape (n,).
    beta
        Helix angle [rad]; the sign does not matter.
    E, nu
        Young's modulus [Pa], Poisson's ratio.
    bore
        Bore diameter [m]; None for a solid gear, assumed clamped at half its root radius.
    body
        "load_line" or "contact_point": definition of u, see `_body_compliance`; "rigid": no body compliance.
        An internal gear is always rigid because the fit applies to discs.

    Notes
    -----
    Per unit face width, with F along the base tangent, a1 its angle to the perpendicular to the tooth centre
    line, x the half thickness and eta the height above the root circle:

    * bending: int [cos a1 (eta_c - eta) - x_c sin a1]^2/(E I) d eta, I = 2 x^3/3
    * shear: 1.2 cos^2 a1 int 1/(G A) d eta, A = 2 x; axial: sin^2 a1 int 1/(E A) d eta
    * body: see `_body_compliance`

    H. Ma, R. Song, X. Pang and B. Wen, Eng. Fail. Anal. 44 (2014) 179. A helical tooth bends perpendicular
    to its trace: in the normal section the thickness is x cos(beta), while the tangential force and the
    length of the trace increase with 1/cos(beta). This multiplies bending by 1/cos^4(beta) (the moment of
    the radial force by a further cos^2(beta)) and shear by 1/cos^2(beta).

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> form = tooth_form(CylindricalGear(z=62, m_n=2e-3))
    >>> steel = dict(E=206e9, nu=0.3, bore=0.035, body="load_line")
    >>> tooth = tooth_compliance(form, np.array([0.02, 0.0265]), beta=0.0, **steel)
    >>> (1e-9 / tooth.bending).round(1).tolist(), (1e-9 / tooth.body).round(1).tolist()
    ([1165.9, 48.3], [38.0, 25.1])
    """
    roll = np.asarray(rho, dtype=np.float64) / form.r_b
    flip = bool(form.sign * (roll[-1] - roll[0]) < 0.0)
    if flip:
        roll = roll[::-1]
    J0, J1, J2, S0 = _cumulative_integrals(form, roll)
    bending, c, s, x = bending_terms(form, roll, beta, (J0, J1, J2))
    psi = form.psi_b - form.sign * (roll - np.arctan(roll))
    cb = math.cos(beta) ** 2
    G = 0.5 * E / (1.0 + nu)
    rigid = body == "rigid" or form.is_internal
    height = form.r_b / c if body == "load_line" else form.r_b * np.hypot(1.0, roll) * np.cos(psi)
    foundation = np.zeros_like(roll) if rigid else _body_compliance(form, c, height, bore) / E
    parts = (bending / (E * cb * cb), 1.2 * c * c * S0 / (G * cb), s * s * S0 / E, foundation, x / c)
    return ToothCompliance(*(part[::-1] if flip else part for part in parts))
