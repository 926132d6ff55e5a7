# SPDX-License-Identifier: Apache-2.0
"""Contact of the tip edge of a gear with the flank of its mate, before A and beyond E.

On the path of contact A-E the flanks touch on the line of action. A deflected pair touches earlier and later
than that: the tip edge of one gear slides on the flank of the other. The distance of the edge from the flank
is closed form, because the distance of a point from an involute is measured along the base tangent through
the point.

Derivation: docs/theory/flank_contact.md, "Tip edges".
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel


@kernel
def tip_gap(eta, r_1, r_2, L, tan_a):
    """Gap between the tip edge of a gear and the flank of its mate beyond the end of the path of contact.

    Parameters
    ----------
    eta
        Distance of the flank beyond the end of its path along the line of action, ≥ 0 [m].
    r_1, r_2
        Base radii of the gear with the edge and of its mate [m]; negative for an internal gear.
    L
        Length of roll of the edge, or of the centre of its rounding [m]; negative for an internal gear.
    tan_a
        Tangent of the working pressure angle.

    Returns
    -------
    tuple
        Gap G along the base tangent of the mate through the edge [m], added to the gap on the line of
        action; its derivatives by eta and by tan_a; length of roll of the contact point on the mate [m] and
        its derivatives by eta and by tan_a.

    Notes
    -----
    In axes along the line of action (from the pitch point) and normal to it the gears are at (-r_1 tan α,
    r_1) and (r_2 tan α, -r_2). The edge has turned by θ = η/r_1 beyond the end and is at V from the axis of
    the mate. Turning the mate by ψ takes it to the line of action, at the length of roll ρ = √(V² - r_2²).
    Then G = L - (r_1 + r_2) tan α + η + ρ - r_2 ψ, dG/dη = 1 - cos(θ + ψ) + L/r_1 sin(θ + ψ), and dG/dtan α =
    -(r_1 + r_2)(1 - cos ψ).

    Examples
    --------
    FZG-C pair, the pinion 0.3 mm beyond E: the gap is 2.9 µm.

    >>> gap = tip_gap(0.3e-3, 33.8289e-3, 50.7434e-3, 23.7232e-3, math.tan(0.3927))
    >>> round(1e6 * float(gap[0]), 2)
    2.92
    """
    R = r_1 + r_2
    turn = eta / r_1
    c = math.cos(turn)
    s = math.sin(turn)
    # edge from the axis of gear 1, then from that of its mate
    px = L * c + r_1 * s
    py = L * s - r_1 * c
    x = px - R * tan_a
    y = py + R
    rho = math.copysign(math.sqrt(max(x * x + y * y - r_2 * r_2, 0.0)), r_2)
    psi = math.atan2(x * r_2 + y * rho, y * r_2 - x * rho)
    half = 0.5 * (turn + psi)
    by_eta = 2.0 * math.sin(half) * (math.sin(half) + L / r_1 * math.cos(half))
    half = math.sin(0.5 * psi)
    gap = (L - R * tan_a + rho) + (eta - r_2 * psi)
    roll_by_eta = 0.0
    roll_by_tan = 0.0
    if rho != 0.0:
        roll_by_eta = (y * px - x * py) / (r_1 * rho)
        roll_by_tan = -R * x / rho
    return gap, by_eta, -2.0 * R * half * half, rho, roll_by_eta, roll_by_tan


@kernel
def tip_gap_curvature(r_1, r_2, L, tan_a):
    """Second derivative of `tip_gap` by eta at the end of the path, L/r_1^2 (r_1 + r_2) tan α/ρ_2 [1/m].

    Parameters
    ----------
    r_1, r_2, L, tan_a
        As in `tip_gap`.

    Examples
    --------
    >>> c = tip_gap_curvature(33.8289e-3, 50.7434e-3, 23.7232e-3, math.tan(0.3927))
    >>> round(0.5 * float(c) * 0.3e-3**2 * 1e6, 2)
    2.89
    """
    R = r_1 + r_2
    rho = R * tan_a - L
    if rho * r_2 <= 0.0:
        return 0.0
    return L / (r_1 * r_1) * R * tan_a / rho
