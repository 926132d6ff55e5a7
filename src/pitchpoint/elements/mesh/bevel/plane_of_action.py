# SPDX-License-Identifier: Apache-2.0
"""Plane of action of a bevel pair: contact geometry, travel, phase and force directions from two frames.

The pitch ray p, q normal to it towards gear 2 and t = p x q follow from the two axes a1, a2 that point from
the apexes into the gears: t is normal to both, and p divides the angle between them in proportion to the
sines of the base cone angles. The plane of action of the flank f (+1 front, -1 back) contains the apex, is
tangent to both base cones and has the normal N = sin(alpha) t - f cos(alpha) q; its ray at the angle sigma
from p is r = cos(sigma) p + sin(sigma) e0 with e0 = N x p, and the line of action crosses the ray in the
direction e = N x r. Gears with coincident apexes roll exactly for any shaft angle: the base cones are fixed,
working pitch cones and backlash follow, as with the centre distance of cylindrical gears.

An offset d of the apexes separates the flanks by the component of d along their normal, so that the
penetration along the base tangent at the cone distance R is

    x = R (f u - gap/2)/R_m + (e - f tan(beta_b) r) . d

with u and gap at R_m. The contribution of d at the pitch point with opposite signs on both flanks is included
in the travel, that with equal signs in the gap, as for an offset or a change of centre distance of
cylindrical gears. The gradient of x at constant R and sigma is the wrench of a unit force: e - f tan(beta_b)
r at the apexes, a couple R N, and a couple for the rotation of e with the axes. Hence the forces are
conservative, and since x is invariant, action equals reaction.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel
from pitchpoint.core.status import BAD_CENTRE, OK
from pitchpoint.multibody.vectors import add, column, cross, dot, less, plus, times, triple


@kernel
def put_row(A, k, a):
    """Write a vector into row k of an array."""
    for r in range(3):
        A[k, r] = a[r]


@kernel
def axes_of_action(b, f, g):
    """Set directions, cone angles and positions of mesh `b` from the frames `f` and `g` of its bodies."""
    now = b["now"]
    n1 = column(f["R"], 2)
    n2 = column(g["R"], 2)
    one = times(b["side"][0], n1)
    two = times(b["side"][1], n2)
    t = cross(one, two)
    s = math.sqrt(dot(t, t))
    s1 = b["base"][0]
    s2 = b["base"][1]
    rest = s1 * s1 + s2 * s2 + 2.0 * dot(one, two) * s1 * s2
    # parallel axes, or overlapping base cones
    if not s * s > rest:
        return BAD_CENTRE
    t = times(1.0 / s, t)
    cos_a = math.sqrt(rest) / s
    s1 /= cos_a
    s2 /= cos_a
    # the pitch cones fill the shaft angle; one of them may exceed 90 deg
    c1 = (s2 + s1 * dot(one, two)) / s
    c2 = (s1 + s2 * dot(one, two)) / s
    across = cross(t, one)
    p = plus(times(c1, one), s1, across)
    q = cross(t, p)
    A1 = plus(triple(f["r"], 0), b["apex"][0], n1)
    A2 = plus(triple(g["r"], 0), b["apex"][1], n2)
    d = less(A1, A2)
    put_row(now["axis"], 0, one)
    put_row(now["axis"], 1, two)
    put_row(now["away"], 0, across)
    put_row(now["away"], 1, cross(t, two))
    now["cos_a"] = cos_a
    now["sin_a"] = math.sqrt(1.0 - cos_a * cos_a)
    now["sin_S"] = s
    now["cone"][0] = c1
    now["cone"][1] = c2
    now["open"][0] = s1 * c2 / s
    now["open"][1] = c1 * s2 / s
    for k in range(3):
        now["d"][k] = d[k]
        now["m"][k] = p[k]
        now["e"][k] = q[k]
        now["t"][k] = t[k]
        now["P"][k] = 0.5 * (A1[k] + A2[k]) + b["R_m"] * p[k]
    return OK


@kernel
def _roll(b, gear):
    """Roll angle at the pitch ray of a gear and involute function, as arcs in the plane of action [rad]."""
    now = b["now"]
    s = b["base"][gear]
    across = s / now["cos_a"] * now["sin_a"]
    sigma = math.atan2(across, now["cone"][gear])
    return sigma, sigma - s * math.atan2(across, s * now["cone"][gear])


@kernel
def _turned(b, f, gear):
    """Rotation of the pitch ray about the z axis of a body since assembly, in the frame of the body [rad]."""
    sense = 1.0 if gear == 0 else -1.0
    to = triple(b["now"]["away"][gear], 0)
    x = sense * dot(to, column(f["R"], 0))
    y = sense * dot(to, column(f["R"], 1))
    c = b["towards"][gear, 0]
    s = b["towards"][gear, 1]
    return math.atan2(c * y - s * x, c * x + s * y)


@kernel
def place_flanks(b, f, g):
    """Set backlash, path of contact, travel and phases of mesh `b`; call `axes_of_action` first."""
    now = b["now"]
    p_bt = b["p_bt"]
    R = b["R_m"]
    roll1, inv1 = _roll(b, 0)
    roll2, inv2 = _roll(b, 1)
    now["gap"] = b["gap_0"] + 2.0 * R * (inv1 + inv2)
    now["xi_A"] = R * (roll2 - b["tip"][1])
    now["eps"] = (R * (b["tip"][0] - roll1) - now["xi_A"]) / p_bt
    now["L"] = b["T_R"] * (now["eps"] - math.floor(now["eps"]))
    middle = (-0.5 * R * (inv1 - inv2) - now["xi_A"]) / p_bt
    now["start"][0] = middle
    now["start"][1] = middle
    first = b["r_b1"] * (f["phi"] - _turned(b, f, 0))
    second = b["r_b2"] * (g["phi"] - _turned(b, g, 1))
    u = first + second + b["u0"]
    n1 = b["z1"] * f["turns"]
    n2 = b["z2"] * g["turns"]
    fewer = min(abs(b["z1"]), abs(b["z2"]))
    if b["carried"] == 0 and abs(u + p_bt * (n1 + n2)) <= 0.5 * p_bt * fewer:
        n = n1 - n2
        u += p_bt * (n1 + n2)
    else:
        # a turn of the plane of the axes shifts the mesh by whole teeth: the nearest teeth are in mesh
        k = int(math.floor(u / p_bt + 0.5))
        u -= p_bt * k
        n = 2 * n1 + k
    half = n % 2
    d = triple(now["d"], 0)
    now["aside"][0] = now["cos_a"] * dot(triple(now["t"], 0), d) - b["tan_b"] * dot(triple(now["m"], 0), d)
    now["aside"][1] = -2.0 * now["sin_a"] * dot(triple(now["e"], 0), d)
    now["u"] = u + now["aside"][0]
    now["gap"] += now["aside"][1]
    now["turn"] = (n - half) // 2
    now["travel"] = 0.5 * (first - second + p_bt * half)


@kernel
def turn_of_plane(b, side, w, bends):
    """Rotation of the plane of action for a rotation w of the gear `side` (0 or 1) [rad].

    `bends` is the derivative of the pressure angle by the shaft angle, signed by the flank, or 0 for the
    plane of the axes. For a common rotation of both gears the contributions add up to that rotation.
    """
    now = b["now"]
    t = triple(now["t"], 0)
    along = dot(t, w)
    other = triple(now["axis"][1 - side], 0)
    sign = 1.0 if side == 0 else -1.0
    by = sign * dot(triple(now["away"][side], 0), w) / now["sin_S"]
    share = now["open"][1 - side]
    p = triple(now["m"], 0)
    return add(plus(times(by, other), share * along, t), times(sign * bends * along, p))


@kernel
def _couple(b, side, v, bends):
    """Couple on the gear `side` for a couple v on the plane of action: transpose of `turn_of_plane`."""
    now = b["now"]
    t = triple(now["t"], 0)
    sign = 1.0 if side == 0 else -1.0
    by = sign * dot(triple(now["axis"][1 - side], 0), v) / now["sin_S"]
    share = now["open"][1 - side]
    along = share * dot(t, v) + sign * bends * dot(triple(now["m"], 0), v)
    return plus(times(by, triple(now["away"][side], 0)), along, t)


@kernel
def _pressure_change(b):
    """Derivative of the pressure angle by the shaft angle, cot(alpha) cos(delta1) cos(delta2)/sin(Sigma)."""
    now = b["now"]
    return now["cos_a"] * now["cone"][0] * now["cone"][1] / (now["sin_a"] * now["sin_S"])


@kernel
def _normal_row(b, row, G, bends):
    """Set a basis row for a force along G at the apexes, with the couple for the rotation of G."""
    now = b["now"]
    d = triple(now["d"], 0)
    v = cross(G, d)
    for side in range(2):
        B = b["basis_i"] if side == 0 else b["basis_j"]
        sign = -1.0 if side == 0 else 1.0
        arm = times(sign * b["side"][side] * b["apex"][side], triple(now["axis"][side], 0))
        M = less(cross(arm, G), _couple(b, side, v, bends))
        for k in range(3):
            B[row, k] = sign * G[k]
            B[row, 3 + k] = M[k]


@kernel
def _couple_row(b, row, M):
    for k in range(3):
        b["basis_i"][row, k] = 0.0
        b["basis_j"][row, k] = 0.0
        b["basis_i"][row, 3 + k] = -M[k]
        b["basis_j"][row, 3 + k] = M[k]


@kernel
def normal_rows(b, flank):
    """Set rows 0 to 2 of the basis of a flank; for the mesh damper (flank 0) row 0, at the pitch ray."""
    now = b["now"]
    t = triple(now["t"], 0)
    p = triple(now["m"], 0)
    q = triple(now["e"], 0)
    c = now["cos_a"] if flank >= 0 else -now["cos_a"]
    s = now["sin_a"] if flank != 0 else 0.0
    tan = b["tan_b"] if flank >= 0 else -b["tan_b"]
    N = plus(times(s, t), -c, q)
    e0 = plus(times(c, t), s, q)
    bends = 0.0 if flank == 0 else flank * _pressure_change(b)
    _normal_row(b, 0, plus(e0, -tan, p), bends)
    if flank == 0:
        for k in range(3):
            b["basis_i"][0, 3 + k] -= b["R_m"] * N[k]
            b["basis_j"][0, 3 + k] += b["R_m"] * N[k]
        return
    for k in range(3):
        now["N"][k] = N[k]
    _normal_row(b, 1, times(-1.0, plus(p, tan, e0)), bends)
    _couple_row(b, 2, N)


@kernel
def friction_rows(b, f, g):
    """Set rows 3 to 5: friction along N at the apex, and its moments per R cos(sigma) and R sin(sigma)."""
    now = b["now"]
    N = triple(now["N"], 0)
    p = triple(now["m"], 0)
    at = plus(triple(now["P"], 0), -b["R_m"], p)
    one = cross(less(at, triple(f["r"], 0)), N)
    two = cross(less(at, triple(g["r"], 0)), N)
    for k in range(3):
        b["basis_i"][3, k] = -N[k]
        b["basis_j"][3, k] = N[k]
        b["basis_i"][3, 3 + k] = -one[k]
        b["basis_j"][3, 3 + k] = two[k]
    _couple_row(b, 4, cross(p, N))
    _couple_row(b, 5, p)


@kernel
def rates_of_place(b, f, g):
    """Set the time derivatives of travel, phases and path of contact."""
    now = b["now"]
    w1 = triple(f["tw"], 3)
    w2 = triple(g["tw"], 3)
    plane = add(turn_of_plane(b, 0, w1, 0.0), turn_of_plane(b, 1, w2, 0.0))
    one = b["R_m"] * b["base"][0] * dot(triple(now["axis"][0], 0), less(w1, plane))
    two = b["R_m"] * b["base"][1] * dot(triple(now["axis"][1], 0), less(w2, plane))
    wider = dot(triple(now["t"], 0), less(w2, w1))  # rate of the shaft angle
    p_bt = b["p_bt"]
    by = b["R_m"] * wider / now["sin_a"]
    xi_A_rate = by * now["open"][1]
    now["xi_A_rate"] = xi_A_rate
    now["eps_rate"] = -by / p_bt
    now["travel_rate"] = 0.5 * (one - two)
    spread = by * now["sin_a"] * now["sin_a"] * (now["open"][0] - now["open"][1])
    middle = -0.5 * spread - xi_A_rate
    now["phase_rate"][0] = (middle + now["travel_rate"]) / p_bt
    now["phase_rate"][1] = (middle - now["travel_rate"]) / p_bt
