# SPDX-License-Identifier: Apache-2.0
"""Additional compliance of a tooth with a root crack, by the energy method of `tooth_compliance`."""

from __future__ import annotations

import math

import numpy as np
from numpy.polynomial.legendre import leggauss

from pitchpoint.contact.stiffness.description import Array
from pitchpoint.contact.stiffness.tooth_compliance import bending_terms, fillet_section, section
from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.tooth_form import ToothForm

_PANEL = leggauss(8)
_FILLET_PANELS = 24
_BELOW_PANELS = 8


def root_half_thickness(form: ToothForm) -> float:
    """Half thickness of a tooth where its fillet meets the root circle [m].

    Parameters
    ----------
    form
        Exact tooth form.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> round(1e3 * root_half_thickness(tooth_form(CylindricalGear(z=62, m_n=2e-3))), 3)
    2.89
    """
    return form.r_f * math.sin(form.root_half_angle)


def largest_crack(form: ToothForm, angle: float) -> float:
    """Depth of a crack that reaches the tooth centre line [m], the limit of validity of the formula.

    Parameters
    ----------
    form
        Exact tooth form.
    angle
        Angle between crack and centre line of the tooth [rad], in (0, π/2].

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> round(1e3 * largest_crack(tooth_form(CylindricalGear(z=62, m_n=2e-3)), math.radians(70)), 3)
    3.076
    """
    return root_half_thickness(form) / math.sin(angle)


def crack_compliance(
    form: ToothForm, rho: Array, depth: Array, *, angle: float, beta: float, E: float, nu: float
) -> Array:
    """Additional compliance of a root crack under opening load, per unit face width along the base tangent.

    Parameters
    ----------
    form
        Exact tooth form.
    rho
        Monotone radii of curvature of the contact points [m], shape (n,).
    depth
        Crack lengths in the transverse section [m], shape (m,), one per slice of the face width, measured
        from the intersection of fillet and root circle.
    angle
        Angle between crack and centre line of the tooth [rad], in (0, π/2].
    beta
        Helix angle [rad].
    E, nu
        Young's modulus [Pa], Poisson's ratio.

    Returns
    -------
    ndarray, shape (m, n)
        Added compliance [m^2/N].

    Raises
    ------
    GeometryError
        If a crack extends beyond the centre line or a depth is negative.

    Notes
    -----
    The crack tip is at the distance h_c = x_0 − depth sin(angle) from the centre line, with x_0 the half
    thickness at the root. Material farther out than h_c on the cracked side carries no load (limit line
    parallel to the centre line): sections of half thickness x > h_c have the thickness x + h_c instead of 2
    x, hence I = (x + h_c)³/12 and A = x + h_c in the bending and shear terms of `tooth_compliance`.
    Compression, contact and gear body are unchanged. X. Tian, M. J. Zuo and K. R. Fyfe, "Analysis of the
    vibration response of a gearbox with gear tooth faults", ASME IMECE (2004); Z. Chen and Y. Shao, Eng.
    Fail. Anal. 18 (2011) 2149. Slices along the face width are not coupled.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> form = tooth_form(CylindricalGear(z=62, m_n=2e-3))
    >>> steel = dict(angle=math.radians(70), beta=0.0, E=206e9, nu=0.3)
    >>> added = crack_compliance(form, np.array([0.02, 0.0265]), np.array([0.0, 1e-3]), **steel)
    >>> (1e12 * added).round(3).tolist()
    [[0.0, 0.0], [0.385, 1.795]]
    """
    depth = np.atleast_1d(np.asarray(depth, dtype=np.float64))
    half = root_half_thickness(form)
    h_c = half - depth * math.sin(angle)
    if h_c.min() < 0.0 or h_c.max() > half * (1.0 + 1e-12):
        raise GeometryError(
            "does not end between the root and the centre line of the tooth",
            where="depth",
            value=f"{1e3 * float(depth[np.argmax(abs(h_c - 0.5 * half))]):.6g} mm",
            limit=f"0 to {1e3 * largest_crack(form, angle):.6g} mm",
        )
    roll = np.asarray(rho, dtype=np.float64) / form.r_b
    flip = bool(form.sign * (roll[-1] - roll[0]) < 0.0)
    if flip:
        roll = roll[::-1]
    each, which = np.unique(h_c, return_inverse=True)
    J0, J1, J2, S0 = _integrals(form, roll, each)
    bending, c, _, _ = bending_terms(form, roll, beta, (J0, J1, J2))
    cb = math.cos(beta) ** 2
    added = bending / (E * cb * cb) + 1.2 * c * c * S0 * 2.0 * (1.0 + nu) / (E * cb)
    return np.asarray((added[:, ::-1] if flip else added)[which.ravel()])


def crack_depth(z: Array, depth: float, length: float | None, face_width: float, at: str) -> Array:
    """Crack depth along the face width [m], shape (n,).

    Parameters
    ----------
    z
        Positions along the face width [m], −b/2 to b/2, shape (n,).
    depth
        Maximum depth [m].
    length
        Crack length along the face width [m]; None for constant depth over the whole face width.
    face_width
        Face width b [m].
    at
        End of the face width with the maximum depth: "start" (z = −b/2) or "end".

    Notes
    -----
    depth √(1 − ζ/length) with ζ measured from that end: a parabola as in Chen and Shao (2011).

    Examples
    --------
    >>> crack_depth(np.array([-0.01, -0.0025, 0.01]), 1e-3, 0.01, 0.02, "start").round(9).tolist()
    [0.001, 0.0005, 0.0]
    """
    if length is None:
        return np.full(z.size, depth)
    zeta = 0.5 * face_width + (z if at == "start" else -z)
    return np.asarray(depth * np.sqrt(np.clip(1.0 - zeta / length, 0.0, 1.0)))


def _added(x: Array, eta: Array, h_c: Array) -> Array:
    """Increase of 1/I, eta/I, eta^2/I and 1/A per unit width due to the crack, shape (4, m, ...)."""
    h = h_c[(..., *(None,) * x.ndim)]
    lost = x > h
    flexibility = np.where(lost, 12.0 / (x + h) ** 3 - 1.5 / x**3, 0.0)
    shear = np.where(lost, 1.0 / (x + h) - 0.5 / x, 0.0)
    return np.stack([flexibility, eta * flexibility, eta * eta * flexibility, shear])


def _integrals(form: ToothForm, roll: Array, h_c: Array) -> Array:
    """Integrals of `_added` from the root up to each roll angle, shape (4, m, n)."""
    edges = np.linspace(form.fillet.theta_root, form.theta_form, _FILLET_PANELS + 1)
    theta, weight = _panels(edges[:-1], edges[1:])
    x, eta, slope = fillet_section(form, theta)
    below = (_added(x, eta, h_c) * (slope * weight)).sum(axis=(2, 3))
    start = math.sqrt(max(0.0, (form.r_Ff / form.r_b) ** 2 - 1.0))
    edges = np.linspace(start, roll[0], _BELOW_PANELS + 1)
    below = below + _pieces(form, edges[:-1], edges[1:], h_c).sum(axis=2)
    steps = np.cumsum(_pieces(form, roll[:-1], roll[1:], h_c), axis=2)
    return np.concatenate([below[:, :, None], below[:, :, None] + steps], axis=2)


def _panels(lower: Array, upper: Array) -> tuple[Array, Array]:
    half = 0.5 * (upper - lower)
    return (0.5 * (upper + lower))[:, None] + half[:, None] * _PANEL[0], half[:, None] * _PANEL[1]


def _pieces(form: ToothForm, lower: Array, upper: Array, h_c: Array) -> Array:
    t, weight = _panels(lower, upper)
    x, eta, slope = section(form, t)
    return np.asarray((_added(x, eta, h_c) * (slope * weight)).sum(axis=3))
