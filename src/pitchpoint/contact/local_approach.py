# SPDX-License-Identifier: Apache-2.0
"""Local approach of two flanks at a contact node: Hertzian line contact down to a depth, and its energy.

A node carries the normal force f over the length l of the contact line, q = f/l. The approach is

    h = d f + sum over both bodies of 2 c/pi q [asinh(t/b) - nu/(1 - nu) t/(sqrt(t^2 + b^2) + t)],

with b = sqrt(4 q R (c_1 + c_2)/pi), c = (1 - nu^2)/E, the depth t of the reference point of each body and an
additional linear compliance d. h increases and is concave; its slope is infinite, as a logarithm, at f = 0.
The bracket is the integral of the strain below a strip of elliptical pressure on a half-plane, without an
assumption on b/t; for b << t it is that of Weber and Banaschek in `hertz.line_approach`.

Source: Weber and Banaschek, Formaenderung und Profilruecknahme (1953); Johnson, Contact Mechanics (1985),
4.2. Derivation of slope and energy: docs/decisions/0032-unilateral-contact.md.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel

#: Elastic constants of both bodies: (1 - nu^2)/E [1/Pa] and nu/(1 - nu).
PAIR_MATERIAL = np.dtype([("c", "f8", 2), ("kappa", "f8", 2)], align=True)

#: Columns of a node: d [m/N]; 2 c/(pi l) [m/N] and t [m] of both bodies; b^2/f [m^2/N]; nu/(1 - nu).
D, A1, A2, T1, T2, B, K1, K2 = range(8)
N_NODE = 8
"""Columns of a node. A node of zeros apart from d is linear."""

_SMALLEST = 1e-280
"""Lower limit of b^2 [m^2]: keeps t^2/b^2 and the slope finite down to f = 0."""
_STEPS = 40
"""Maximum number of steps of `local_force`; three to five are needed."""


@kernel
def set_node(node, i, length, radius, depths, material, compliance):
    """Set the columns of a node.

    Parameters
    ----------
    node
        Nodes, shape (n, N_NODE).
    i
        Index of the node.
    length
        Length of the contact line over which the force of the node acts, l [m].
    radius
        Reduced radius of curvature in the normal section, R [m].
    depths
        Depths of both reference points below the contact, t_1 and t_2 [m], as a pair.
    material
        Record of `PAIR_MATERIAL`.
    compliance
        Additional linear compliance of the node, d >= 0 [m/N].

    Examples
    --------
    >>> steel = np.zeros(1, PAIR_MATERIAL)[0]
    >>> steel["c"], steel["kappa"] = 0.91 / 206e9, 0.3 / 0.7
    >>> node = np.zeros((1, N_NODE))
    >>> R = 8.5e-3 * 21.5e-3 / 30e-3 * math.sin(math.radians(20.0))  # 17/43 teeth, 1 mm, at the pitch point
    >>> set_node(node, 0, 0.01, R, (0.8e-3, 0.8e-3), steel, 0.0)
    >>> h, slope = local_approach(node, 0, 3000.0)  # 300 N/mm
    >>> round(float(h) / 300.0 * 1e9, 5)  # 1e-3 um per N/mm, two equal bodies of 7.69923
    15.39846
    """
    c = material["c"]
    share = 2.0 / (math.pi * length)
    node[i, D] = compliance
    node[i, A1] = share * c[0]
    node[i, A2] = share * c[1]
    node[i, T1] = depths[0]
    node[i, T2] = depths[1]
    node[i, B] = 2.0 * share * radius * (c[0] + c[1])
    node[i, K1] = material["kappa"][0]
    node[i, K2] = material["kappa"][1]


@kernel
def _arc(t, s, bb):
    """asinh(t/b) of a depth t, with s = sqrt(t^2 + b^2) and bb = b^2."""
    if bb < t * t:
        return 0.5 * math.log((t + s) * (t + s) / bb)
    b = math.sqrt(bb)  # a contact wider than deep: without cancellation down to t << b
    return math.log1p((t + t * t / (s + b)) / b)


@kernel
def _body(a, t, kappa, bb):
    """Compliance h/f of one body and its slope dh/df, with a = 2 c/(pi l) and bb = b^2."""
    s = math.sqrt(t * t + bb)
    arc = _arc(t, s, bb)
    share = t / (s * (s + t))
    return a * (arc - kappa * s * share), a * (arc - 0.5 * (1.0 + kappa) * (s + t) * share)


@kernel(inline=True)
def local_approach(node, i, f):
    """Local approach h of node i under a force f, odd in f [m], and its slope dh/df [m/N].

    Examples
    --------
    >>> node = np.array([[1e-10, 2e-10, 1e-10, 3e-3, 2e-3, 1e-11, 0.4, 0.4]])
    >>> h, slope = local_approach(node, 0, 1e3)
    >>> round(float(h) * 1e6, 9), round(float(slope) * 1e10, 8)
    (1.227898421, 10.78039881)
    >>> bool(local_approach(node, 0, -1e3)[0] == -h)
    True
    """
    if node[i, B] == 0.0:
        return node[i, D] * f, node[i, D]
    bb = max(node[i, B] * abs(f), _SMALLEST)
    h_1, slope_1 = _body(node[i, A1], node[i, T1], node[i, K1], bb)
    h_2, slope_2 = _body(node[i, A2], node[i, T2], node[i, K2], bb)
    return f * (node[i, D] + h_1 + h_2), node[i, D] + slope_1 + slope_2


@kernel
def local_force(node, i, overlap, compliance):
    """Force at which the approach of node i plus a linear compliance equals an overlap >= 0 [N].

    Root of h(f) + compliance f = overlap. As h is concave, scaling a force by overlap over approach leads to
    a force above the root, and Newton's method from there to one below, from which it increases
    monotonically.

    Parameters
    ----------
    node, i
        Nodes and index of the node.
    overlap
        Sum of both deflections [m].
    compliance
        Linear compliance in series with the node [m/N].

    Examples
    --------
    >>> node = np.array([[1e-10, 2e-10, 1e-10, 3e-3, 2e-3, 1e-11, 0.4, 0.4]])
    >>> round(float(local_force(node, 0, 1.227898421e-6 + 2e-6, 2e-9)), 5)
    1000.0
    """
    if not overlap > 0.0:
        return 0.0
    f = overlap / (local_approach(node, i, 1.0)[0] + compliance)
    for _ in range(_STEPS):
        h, slope = local_approach(node, i, f)
        h += compliance * f
        scaled = f * overlap / h
        f += (overlap - h) / (slope + compliance)
        if not abs(h - overlap) > 1e-6 * overlap:
            break
        if f <= 0.0:
            f = scaled
    return f


@kernel
def _store(t, kappa, s, bb):
    """Energy bracket of one body, and its derivative by ln t, which is minus that by ln b."""
    share = t / ((s + t) * (s + t))
    store = 0.5 * _arc(t, s, bb) + share * (s + 2.0 * t - 2.0 * kappa * (2.0 * s + t)) / 6.0
    return store, 2.0 / 3.0 * share * (s + 2.0 * t - kappa * (s - t))


@kernel
def local_energy(node, i, f):
    """Complementary energy of node i, the integral of h over the force up to f >= 0 [J].

    Psi = d f^2/2 + l q^2 times the sum of 2 c/pi {asinh(t/b)/2 + t [s + 2 t - 2 nu/(1 - nu) (2 s + t)]/
    (6 (s + t)^2)}, s = sqrt(t^2 + b^2). The energy stored in the node is h f - Psi.

    Examples
    --------
    >>> node = np.array([[1e-10, 2e-10, 1e-10, 3e-3, 2e-3, 1e-11, 0.4, 0.4]])
    >>> round(float(local_energy(node, 0, 1e3)) * 1e3, 9)
    0.651425625
    """
    psi = 0.5 * node[i, D]
    if node[i, B] > 0.0:
        bb = max(node[i, B] * f, _SMALLEST)
        t = node[i, T1]
        psi += node[i, A1] * _store(t, node[i, K1], math.sqrt(t * t + bb), bb)[0]
        t = node[i, T2]
        psi += node[i, A2] * _store(t, node[i, K2], math.sqrt(t * t + bb), bb)[0]
    return psi * f * f


@kernel(inline=True)
def energy_slopes(node, i, f):
    """Derivatives of `local_energy` at constant force by ln R, t_1 [J/m], t_2 [J/m] and ln l.

    A conservative force needs them if the radius, the depths or the length of the node change with the
    position: divide the first by R and the last by l.

    Examples
    --------
    >>> node = np.array([[1e-10, 2e-10, 1e-10, 3e-3, 2e-3, 1e-11, 0.4, 0.4]])
    >>> [round(float(value) * 1e3, 9) for value in energy_slopes(node, 0, 1e3)]
    [-0.074952829, 33.318528285, 24.975037046, -0.526472796]
    """
    if node[i, B] == 0.0:
        return 0.0, 0.0, 0.0, 0.0
    bb = max(node[i, B] * f, _SMALLEST)
    square = f * f
    t_1 = node[i, T1]
    t_2 = node[i, T2]
    psi_1, slope_1 = _store(t_1, node[i, K1], math.sqrt(t_1 * t_1 + bb), bb)
    psi_2, slope_2 = _store(t_2, node[i, K2], math.sqrt(t_2 * t_2 + bb), bb)
    slope_1 *= node[i, A1] * square
    slope_2 *= node[i, A2] * square
    # d is given per node, not per length: only the Hertzian part depends on l
    psi = (node[i, A1] * psi_1 + node[i, A2] * psi_2) * square
    h = local_approach(node, i, f)[0] - node[i, D] * f
    by_radius = -0.5 * (slope_1 + slope_2)
    return by_radius, slope_1 / t_1, slope_2 / t_2, psi - f * h
