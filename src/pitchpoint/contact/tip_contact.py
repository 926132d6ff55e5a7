# SPDX-License-Identifier: Apache-2.0
"""Contact of a tip edge with the flank of the mate, before A and beyond E.

Under load a tooth enters contact before A and leaves it beyond E: there the tip edge of one gear touches the
flank of the other. In the transverse section of a pair on parallel axes, xi1 and xi2 are the positions of the
two flanks along the line of action, from the pitch point, and x = xi1 - xi2 is their penetration. Beyond E,
at eta = xi1 - xi_E > 0, the tip edge of gear 1 has left the line of action by a rotation theta = eta/r_b1.
The flank of gear 2 through it crosses the line of action at xi1 - G(eta), so that the penetration is
x - G(eta), exact and along the common normal, which is that of the flank of gear 2.

All lengths are signed as in ISO 21771 (internal gear: negative base radius and length of roll, negative
centre distance), and the same formulas give the tip edge of gear 2 before A, with eta = xi_A - xi2.
Contact states have the mean (xi1 + xi2)/2 of both flanks, see `tip_gap_from_mean`.

Derivation: docs/theory/geometry.md, "Contact of a tip edge".
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel

SERIES = 0.5
"""Angle up to which x - sin(x) is evaluated as a series, with a relative error below 1e-17 [rad]."""
MARGIN = 0.8
"""Factor by which the lower bound is below the smaller end value of G/eta^2; 0.9 is sufficient."""


@kernel
def arc_less_sine(x):
    """Difference x - sin(x), without cancellation.

    >>> round(float(arc_less_sine(1e-3)) * 1e9, 12)
    0.166666658333
    """
    if abs(x) > SERIES:
        return x - math.sin(x)
    q = x * x
    rest = 1.0 / 362880.0 - q * (1.0 / 39916800.0 - q * (1.0 / 6227020800.0 - q * (1.0 / 1307674368000.0)))
    return x * q * (1.0 / 6.0 - q * (1.0 / 120.0 - q * (1.0 / 5040.0 - q * rest)))


@kernel
def tip_gap(eta, r_1, r_2, L, tan_a):
    """Gap between a tip edge and the flank of the mate, beyond that of the flanks on the line of action.

    Parameters
    ----------
    eta
        Distance of the flank with the edge beyond the end of its path of contact, along the line of action:
        xi1 - xi_E for the tip of gear 1, xi_A - xi2 for that of gear 2 [m].
    r_1, r_2
        Base radii of the gear with the edge and of its mate [m]; negative if internal.
    L
        Length of roll of the edge, at the tip form circle d_Fa, or of the centre of its rounding [m]; signed
        like r_1.
    tan_a
        Tangent of the working pressure angle.

    Returns
    -------
    tuple
        G [m]; dG/d(eta); dG/d(tan alpha) at constant eta [m]; length of roll of the edge or centre on the
        mate, signed like r_2 [m]; its derivatives by eta and by tan alpha; d2G/d(eta)2 [1/m]; angle by which
        the common normal has turned on the gear with the edge [rad]. Up to the end of the path, eta <= 0, G
        is 0 and the roll that of the line of action. Infinite G and zeros if no involute of the mate passes
        through the edge.

    Notes
    -----
    With R = r_1 + r_2, phi the rotation of the mate between the edge and the line of action, and chi = theta
    + phi: G = L (1 - cos chi) + r_1 (chi - sin chi) - R tan(alpha) (1 - cos phi) - R (phi - sin phi);
    dG/d(eta) = (1 - cos chi) + L/r_1 sin chi; dG/d(tan alpha) = -R (1 - cos phi); dG/da = dG/d(tan alpha)/(R
    sin alpha).

    A rounding of radius rho, tangent to the involute, touches where its centre touches the parallel flank at
    the distance rho: L is then its length of roll at d_Fa less rho, and the contact is at the returned roll
    less rho. The edge of a chamfer is that at d_Fa.

    Examples
    --------
    FZG-C pair, the tip edge of the pinion 0.3 mm beyond E:

    >>> found = tip_gap(0.3e-3, 33.8289e-3, 50.7434e-3, 23.7232e-3, math.tan(0.3927))
    >>> round(float(found[0]) * 1e6, 4), round(float(found[3]) * 1e3, 4)
    (2.9158, 11.9467)
    """
    R = r_1 + r_2
    T = R * tan_a
    first = T - L
    if first * r_2 <= 0.0:
        return math.inf, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    if eta <= 0.0:
        return 0.0, 0.0, 0.0, first - eta, -1.0, R, 0.0, 0.0
    theta = eta / r_1
    half = math.sin(0.5 * theta)
    sine = 2.0 * half * math.cos(0.5 * theta)
    versine = 2.0 * half * half
    cosine = 1.0 - versine
    # change of the square of the length of roll on the mate, and its derivative by 2 theta
    A = T * L + R * r_1
    B = T * r_1 - R * L
    grown = 2.0 * (A * versine - B * sine)
    square = first * first + grown
    if square <= 0.0:
        return math.inf, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    roll = math.copysign(math.sqrt(square), r_2)
    dx = r_1 * sine - L * versine
    dy = -L * sine - r_1 * versine
    size = 1.0 / (r_2 * r_2 + square)
    sin_phi = (r_2 * (grown / (roll + first) + dx) - roll * dy) * size
    cos_phi = (roll * (first - dx) + r_2 * (r_2 - dy)) * size
    phi = math.asin(sin_phi) if cos_phi > 0.8 else math.atan2(sin_phi, cos_phi)
    sin_chi = sine * cos_phi + cosine * sin_phi
    cos_chi = cosine * cos_phi - sine * sin_phi
    chi = theta + phi
    less_chi = sin_chi * sin_chi / (1.0 + cos_chi)
    less_phi = sin_phi * sin_phi / (1.0 + cos_phi)
    inverse = 1.0 / r_1
    ratio = L * inverse
    along = ratio * cos_chi + sin_chi
    per_roll = 1.0 / roll
    return (
        L * less_chi + r_1 * arc_less_sine(chi) - T * less_phi - R * arc_less_sine(phi),
        less_chi + ratio * sin_chi,
        -R * less_phi,
        roll,
        (A * sine - B * cosine) * inverse * per_roll,
        R * (first - dx) * per_roll,
        along * (inverse + along * per_roll),
        chi,
    )


@kernel
def tip_gap_from_mean(eta, r_1, r_2, L, tan_a):
    """Gap of a tip edge as `tip_gap`, by the mean path position of both flanks.

    Parameters
    ----------
    eta
        Distance of the mean path position xi = (xi1 + xi2)/2 beyond the end of the path: xi - xi_E for the
        tip of gear 1, xi_A - xi for that of gear 2 [m].
    r_1, r_2, L, tan_a
        As in `tip_gap`.

    Returns
    -------
    tuple
        G [m]; dG/d(eta); dG/d(tan alpha) at constant eta [m]; length of roll on the mate, signed [m]; its
        derivatives by eta and by tan alpha; turn of the common normal [rad]. Infinite G and zeros as in
        `tip_gap`.

    Notes
    -----
    At first contact the flank with the edge is ahead of its mate by the gap, and half of it ahead of the
    mean: G = tip_gap(eta + G/2), by a second-order step and a Newton step from eta. Under load the teeth move
    back by their deflections u1 and u2 to this distance, exactly for u1 = u2.

    Examples
    --------
    FZG-C pair, the mean of both flanks 0.3 mm beyond E:

    >>> found = tip_gap_from_mean(0.3e-3, 33.8289e-3, 50.7434e-3, 23.7232e-3, math.tan(0.3927))
    >>> round(float(found[0]) * 1e6, 4), round(float(found[3]) * 1e3, 4)
    (2.9446, 11.9499)
    """
    gap, slope, _, _, _, _, bend, _ = tip_gap(eta, r_1, r_2, L, tan_a)
    if gap == math.inf:
        return math.inf, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    ahead = gap / (2.0 - slope)
    ahead = (gap + 0.5 * bend * ahead * ahead) / (2.0 - slope)
    gap, slope, by_tan, roll, roll_by_eta, roll_by_tan, bend, turned = tip_gap(
        eta + ahead, r_1, r_2, L, tan_a
    )
    if gap == math.inf:
        return math.inf, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    rest = (0.5 * gap - ahead) / (1.0 - 0.5 * slope)
    gap += slope * rest
    roll += roll_by_eta * rest
    slope += bend * rest
    share = 1.0 / (1.0 - 0.5 * slope)
    by_tan *= share
    return (
        gap,
        slope * share,
        by_tan,
        roll,
        roll_by_eta * share,
        roll_by_tan + 0.5 * roll_by_eta * by_tan,
        turned,
    )


@kernel
def tip_gap_curvature(r_1, r_2, L, tan_a):
    """Second derivative of `tip_gap` by eta at the end of the path, L T/(r_1^2 (T - L)) with T = R tan alpha.

    The arguments are those of `tip_gap`; infinite if no involute of the mate passes through the edge [1/m].

    >>> round(float(tip_gap_curvature(33.8289e-3, 50.7434e-3, 23.7232e-3, math.tan(0.3927))), 3)
    64.22
    """
    T = (r_1 + r_2) * tan_a
    if (T - L) * r_2 <= 0.0:
        return math.inf
    return L * T / (r_1 * r_1 * (T - L))


@kernel
def tip_gap_floor(eta, r_1, r_2, L, tan_a):
    """Factor q of the lower bound G >= q e^2 for all e from 0 to eta [1/m].

    The arguments are those of `tip_gap`, eta > 0. A node at e whose flanks penetrate by less than q e^2 does
    not touch. G/e^2 increases, decreases or is nearly constant up to a base pitch: the smaller of its values
    at both ends, less a margin, is below all others.

    >>> FZG_C = 33.8289e-3, 50.7434e-3, 23.7232e-3, math.tan(0.3927)
    >>> q = tip_gap_floor(1e-3, *FZG_C)
    >>> round(float(q), 3), bool(q * 0.3e-3**2 < tip_gap(0.3e-3, *FZG_C)[0])
    (25.688, True)
    """
    first = 0.5 * tip_gap_curvature(r_1, r_2, L, tan_a)
    return MARGIN * min(first, tip_gap(eta, r_1, r_2, L, tan_a)[0] / (eta * eta))
