# SPDX-License-Identifier: Apache-2.0
"""Directions of the normal force: exact gradients of the penetration by the motion of both bodies.

The penetration x_0 - kappa y of a flank depends on the two frames only through invariants: centre distance a,
axial offset dz, the directions e and m of the line of centres and of the mean axis, the difference dn of the
axes, and the angles of the gears relative to e. A force along the gradient is conservative for any tilt, and
since a common rigid motion of both gears does not change the invariants, action equals reaction. A
misalignment of the housing (`skew`) adds to the tilt along e and t and follows both directions.

Held constant are the mesh phase, the position of the contact lines in the plane of action, and positions over
the width (on the narrower gear, or half-way between two of equal width). The energy supplied by their motion
is reported as parametric power.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel


@kernel
def gradient(b, f, g, p, q, q_a, q_z):
    """Set row `p` of both bases: wrenches of q_1 du_1 + q_2 du_2 + q_a da + q_z d(dz) + q_e de + q_m dm + q_n
    d(dn).

    u_1 = r_b1 (phi1 - gamma1) and u_2 = r_b2 (phi2 - gamma2) are the travels of the gears along the line of
    action without their axial part, q = (q_1, q_2). With the line between the mid-faces l = a e + dz m,

        d(dz) = m . dl + a e . dm
        da = e . dl - dz e . dm
        a de = dl - m d(dz) - dz dm - e da
        d(phi - gamma) = (w . (n - c e) - (n x e) . de) / (1 - c c),  c = n . e

    where an axis n rotates at w: dn = w x n; m is the unit vector of the weighted sum of both axes.
    """
    now = b["now"]
    Rf = f["R"]
    Rg = g["R"]
    m = now["m"]
    e = now["e"]
    q_e = now["q_e"]
    q_m = now["q_m"]
    q_n = now["q_n"]
    a = now["a"]
    dz = now["dz"]
    c1 = now["c1"]
    c2 = now["c2"]
    w1 = b["w1"] * now["inv_m"]
    w2 = (1.0 - b["w1"]) * now["inv_m"]
    h1 = q[0] * b["r_b1"] / (1.0 - c1 * c1)
    h2 = q[1] * b["r_b2"] / (1.0 - c2 * c2)
    Bi = b["basis_i"]
    Bj = b["basis_j"]
    # gradient by the line between the mid-faces and by the mean axis
    along = q_e[0] * e[0] + q_e[1] * e[1] + q_e[2] * e[2]
    shift = q_z
    turn = 0.0
    for k in range(3):
        k1 = (k + 1) % 3
        k2 = (k + 2) % 3
        s = q_e[k] - along * e[k]
        s -= h1 * (Rf[k1, 2] * e[k2] - Rf[k2, 2] * e[k1]) + h2 * (Rg[k1, 2] * e[k2] - Rg[k2, 2] * e[k1])
        s /= a
        shift -= s * m[k]
        turn += (q_m[k] - dz * s) * m[k]
        Bj[p, k] = s
    for k in range(3):
        s = Bj[p, k]
        axis = q_m[k] - dz * (s + q_a * e[k]) + shift * a * e[k] - turn * m[k]
        line = s + q_a * e[k] + shift * m[k]
        Bi[p, k] = -line
        Bj[p, k] = line
        Bi[p, 3 + k] = w1 * axis - q_n[k] - b["zc1"] * line
        Bj[p, 3 + k] = w2 * axis + q_n[k] + b["zc2"] * line
    _moments(Bi, p, Rf, e, h1, c1)
    _moments(Bj, p, Rg, e, h2, c2)


@kernel
def _moments(B, p, R, e, h, c):
    """Convert the gradient by the axis direction to a moment, and add the torque by the spin of the gear."""
    x = B[p, 3]
    y = B[p, 4]
    z = B[p, 5]
    B[p, 3] = R[1, 2] * z - R[2, 2] * y + h * (R[0, 2] - c * e[0])
    B[p, 4] = R[2, 2] * x - R[0, 2] * z + h * (R[1, 2] - c * e[1])
    B[p, 5] = R[0, 2] * y - R[1, 2] * x + h * (R[2, 2] - c * e[2])


@kernel
def _no_axes(b):
    now = b["now"]
    for k in range(3):
        now["q_e"][k] = 0.0
        now["q_m"][k] = 0.0
        now["q_n"][k] = 0.0


@kernel
def _parallel(b):
    """Whether the axes are exactly parallel, as for gears that only rotate and translate."""
    dn = b["now"]["dn"]
    skew = b["skew"]
    return dn[0] == 0.0 and dn[1] == 0.0 and dn[2] == 0.0 and skew[0] == 0.0 and skew[1] == 0.0


@kernel
def _lean(B, q, R, side):
    """Set row 1 of the basis of one body for parallel axes: `gradient` reduced to the term +-q . dn."""
    for k in range(3):
        k1 = (k + 1) % 3
        k2 = (k + 2) % 3
        B[1, k] = 0.0
        B[1, 3 + k] = side * (R[k1, 2] * q[k2] - R[k2, 2] * q[k1])


@kernel
def flank_tilt(b, flank):
    """Relative tilt of the axes along t and e; sets kappa, the loss of penetration per lever of a flank."""
    now = b["now"]
    dn = now["dn"]
    e = now["e"]
    t = now["t"]
    tilt_t = dn[0] * t[0] + dn[1] * t[1] + dn[2] * t[2] + b["skew"][0]
    tilt_e = dn[0] * e[0] + dn[1] * e[1] + dn[2] * e[2] + b["skew"][1]
    now["kappa"] = flank * now["cos_a"] * tilt_t + now["sin_a"] * tilt_e
    return tilt_t, tilt_e


@kernel
def normal_directions(b, f, g, flank):
    """Set rows 0 and 1 of the wrench basis, -dx_0 and d(kappa), and kappa."""
    now = b["now"]
    m = now["m"]
    e = now["e"]
    t = now["t"]
    dn = now["dn"]
    ca = flank * now["cos_a"]
    sa = now["sin_a"]
    tilt_t, tilt_e = flank_tilt(b, flank)
    _no_axes(b)
    gradient(b, f, g, 0, (-float(flank), -float(flank)), sa, now["kappa"] * b["w_z"] - flank * b["tan_b"])
    for k in range(3):
        now["q_n"][k] = ca * t[k] + sa * e[k]
    if _parallel(b):
        _lean(b["basis_i"], now["q_n"], f["R"], -1.0)
        _lean(b["basis_j"], now["q_n"], g["R"], 1.0)
        return
    for k in range(3):
        k1 = (k + 1) % 3
        k2 = (k + 2) % 3
        now["q_e"][k] = ca * (dn[k1] * m[k2] - dn[k2] * m[k1]) + sa * dn[k]
        now["q_m"][k] = ca * (e[k1] * dn[k2] - e[k2] * dn[k1])
    # d(alpha) = cos(alpha) / (a sin(alpha)) da
    q_a = (now["cos_a"] * tilt_e - flank * sa * tilt_t) * now["cos_a"] / (now["a"] * sa)
    gradient(b, f, g, 1, (0.0, 0.0), q_a, 0.0)


@kernel
def travel_direction(b, f, g):
    """Set row 0 of the wrench basis: -du, axial part included."""
    _no_axes(b)
    gradient(b, f, g, 0, (-1.0, -1.0), 0.0, -b["tan_b"])


@kernel
def offset_direction(b, f, g):
    """Set row 2 of the wrench basis: d(dz), the axial offset of the gears."""
    _no_axes(b)
    gradient(b, f, g, 2, (0.0, 0.0), 0.0, 1.0)


@kernel
def path_direction(b, f, g):
    """Set row 0 of the wrench basis: minus the change of energy with path, line of action and axial offset.

    The scratch holds its derivatives by the mean travel (u_1 - u_2)/2, by tan alpha and by the axial offset
    of the gears at constant penetration.
    """
    now = b["now"]
    _no_axes(b)
    half = 0.5 * now["by_travel"]
    q_a = -now["by_tan"] / (now["a"] * now["sin_a"] * now["cos_a"])
    gradient(b, f, g, 0, (-half, half), q_a, -now["by_dz"])


@kernel
def friction_directions(b, f, g, flank):
    """Set rows 2 to 4 of the wrench basis: friction along tau = m x n_f at the pitch point, per z and xi."""
    now = b["now"]
    m = now["m"]
    e = now["e"]
    t = now["t"]
    P = now["P"]
    ca = flank * now["cos_a"]
    sa = now["sin_a"]
    for side in range(2):
        B = b["basis_i"] if side == 0 else b["basis_j"]
        o = f["r"] if side == 0 else g["r"]
        sign = -1.0 if side == 0 else 1.0
        for k in range(3):
            k1 = (k + 1) % 3
            k2 = (k + 2) % 3
            n1 = ca * t[k1] + sa * e[k1]
            n2 = ca * t[k2] + sa * e[k2]
            B[2, k] = sign * (m[k1] * n2 - m[k2] * n1)
            B[3, k] = 0.0
            B[3, 3 + k] = -sign * (ca * t[k] + sa * e[k])
            B[4, k] = 0.0
            B[4, 3 + k] = sign * m[k]
        x = P[0] - o[0]
        y = P[1] - o[1]
        z = P[2] - o[2]
        B[2, 3] = y * B[2, 2] - z * B[2, 1]
        B[2, 4] = z * B[2, 0] - x * B[2, 2]
        B[2, 5] = x * B[2, 1] - y * B[2, 0]
