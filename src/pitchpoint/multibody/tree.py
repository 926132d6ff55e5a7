# SPDX-License-Identifier: Apache-2.0
"""Kinematics of bodies in a tree: frames, and the columns of all joints on the path from ground.

The joint frame E is fixed to the parent. The displacements d of the joint (see joints.py) translate the body
by E d[0:3] and rotate it about w1 = E'[:, 0], w2, n, where E' = E C includes the chart C, the reference
attitude of the rotations of a tumbling body. With o the angular velocity of the parent:

    r = r_p + rho,  v = v_p + o x rho + E d',  a = a_p + e_p x rho + o x (o x rho) + 2 o x E d' + E d''
    omega = o + alpha' w1 + beta' w2 + spin' n
    e = e_p + alpha'' w1 + beta'' w2 + spin'' n + o x (omega - o) + alpha' beta' w1 x w2
        + spin' (alpha' w1 + beta' w2) x n

The columns W of the six displacements at the origin of the body are (E, 0) and (0, w). The columns of a
joint are those of its displacements; for an outboard body they are transferred to its origin: (l + w x rho,
w).
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel
from pitchpoint.multibody.bodies import GENERAL
from pitchpoint.multibody.joints import Z

TWO_PI = 6.283185307179586
MAX_TILT = 0.8
"""Angle beta above which a tumbling body gets a new chart [rad]."""

#: Displacements of a body relative to its joint frame, their rates, and their columns in world axes.
MOTION = np.dtype(
    [
        ("d", "f8", 6),  # displacements [m, rad]
        ("rate", "f8", 6),
        ("second", "f8", 6),
        ("W", "f8", (6, 6)),  # column m: twist of the body per displacement m
    ],
    align=True,
)


@kernel
def body_axes(f):
    """Write S, the body-fixed frame: R rotated by the spin."""
    c = math.cos(f["phi"])
    s = math.sin(f["phi"])
    for i in range(3):
        x = f["R"][i, 0]
        y = f["R"][i, 1]
        f["S"][i, 0] = c * x + s * y
        f["S"][i, 1] = c * y - s * x
        f["S"][i, 2] = f["R"][i, 2]


@kernel
def _displace(o, f, mo, guides, q, v, a):
    """Displacements of a joint and their rates, from its coordinates or its guide."""
    d = o["dof"]
    for m in range(6):
        mo["d"][m] = 0.0
        mo["rate"][m] = 0.0
        mo["second"][m] = 0.0
    if o["guide"] >= 0:
        g = guides[o["guide"]]
        for m in range(6):
            x = g["rate"][m]
            y = g["second"][m]
            for k in range(o["n"]):
                by = g["by"][m, k]
                x += by * v[d + k]
                y += by * a[d + k] + g["by2"][m, k] * v[d + k] * v[d + k]
            mo["d"][m] = g["d"][m]
            mo["rate"][m] = x
            mo["second"][m] = y
        return
    for k in range(o["n"]):
        m = o["axis"][k]
        mo["d"][m] = q[d + k]
        mo["rate"][m] = v[d + k]
        mo["second"][m] = a[d + k]
    lead = o["lead"]
    if lead != 0.0:
        mo["d"][Z] = lead * (q[d] + TWO_PI * f["turns"])
        mo["rate"][Z] = lead * v[d]
        mo["second"][Z] = lead * a[d]


@kernel
def _joint_frame(o, p, f, charts, mo):
    """Write the joint axes E in world axes to W, and R as the frame before the rotations."""
    W = mo["W"]
    S = p["S"]
    A = o["axes"]
    for i in range(3):
        for c in range(3):
            W[i, c] = S[i, 0] * A[0, c] + S[i, 1] * A[1, c] + S[i, 2] * A[2, c]
    if o["chart"] >= 0:
        C = charts[o["chart"]]
        for i in range(3):
            for c in range(3):
                f["R"][i, c] = W[i, 0] * C[0, c] + W[i, 1] * C[1, c] + W[i, 2] * C[2, c]
    else:
        for i in range(3):
            for c in range(3):
                f["R"][i, c] = W[i, c]


@kernel
def _turn(f, mo):
    """Rotate R by alpha and beta; write the axes of the three rotations to W."""
    W = mo["W"]
    R = f["R"]
    d = mo["d"]
    if d[3] == 0.0 and d[4] == 0.0:
        for i in range(3):
            for c in range(3):
                W[3 + i, 3 + c] = R[i, c]
        return
    ca = math.cos(d[3])
    sa = math.sin(d[3])
    cb = math.cos(d[4])
    sb = math.sin(d[4])
    for i in range(3):
        e1 = R[i, 0]
        e2 = ca * R[i, 1] + sa * R[i, 2]
        e3 = ca * R[i, 2] - sa * R[i, 1]
        R[i, 0] = cb * e1 - sb * e3
        R[i, 1] = e2
        R[i, 2] = cb * e3 + sb * e1
        W[3 + i, 3] = e1
        W[3 + i, 4] = e2
        W[3 + i, 5] = R[i, 2]


@kernel
def _place(o, p, f, mo):
    """Origin, twist and acceleration of a body from those of its parent."""
    W = mo["W"]
    x = mo["rate"]
    y = mo["second"]
    S = p["S"]
    pos = o["pos"]
    d = mo["d"]
    o0 = p["tw"][3]
    o1 = p["tw"][4]
    o2 = p["tw"][5]
    e0 = p["ac"][3]
    e1 = p["ac"][4]
    e2 = p["ac"][5]
    r0 = S[0, 0] * pos[0] + S[0, 1] * pos[1] + S[0, 2] * pos[2]
    r1 = S[1, 0] * pos[0] + S[1, 1] * pos[1] + S[1, 2] * pos[2]
    r2 = S[2, 0] * pos[0] + S[2, 1] * pos[1] + S[2, 2] * pos[2]
    r0 += W[0, 0] * d[0] + W[0, 1] * d[1] + W[0, 2] * d[2]
    r1 += W[1, 0] * d[0] + W[1, 1] * d[1] + W[1, 2] * d[2]
    r2 += W[2, 0] * d[0] + W[2, 1] * d[1] + W[2, 2] * d[2]
    f["r"][0] = p["r"][0] + r0
    f["r"][1] = p["r"][1] + r1
    f["r"][2] = p["r"][2] + r2
    u0 = W[0, 0] * x[0] + W[0, 1] * x[1] + W[0, 2] * x[2]
    u1 = W[1, 0] * x[0] + W[1, 1] * x[1] + W[1, 2] * x[2]
    u2 = W[2, 0] * x[0] + W[2, 1] * x[1] + W[2, 2] * x[2]
    k0 = o1 * r2 - o2 * r1  # o x rho
    k1 = o2 * r0 - o0 * r2
    k2 = o0 * r1 - o1 * r0
    f["tw"][0] = p["tw"][0] + k0 + u0
    f["tw"][1] = p["tw"][1] + k1 + u1
    f["tw"][2] = p["tw"][2] + k2 + u2
    k0 += 2.0 * u0
    k1 += 2.0 * u1
    k2 += 2.0 * u2
    f["ac"][0] = p["ac"][0] + e1 * r2 - e2 * r1 + o1 * k2 - o2 * k1
    f["ac"][1] = p["ac"][1] + e2 * r0 - e0 * r2 + o2 * k0 - o0 * k2
    f["ac"][2] = p["ac"][2] + e0 * r1 - e1 * r0 + o0 * k1 - o1 * k0
    for i in range(3):
        f["ac"][i] += W[i, 0] * y[0] + W[i, 1] * y[1] + W[i, 2] * y[2]
    # rotations: omega = o + s with s = t + spin' n, t = alpha' w1 + beta' w2
    t0 = x[3] * W[3, 3] + x[4] * W[3, 4]
    t1 = x[3] * W[4, 3] + x[4] * W[4, 4]
    t2 = x[3] * W[5, 3] + x[4] * W[5, 4]
    n0 = x[5] * W[3, 5]
    n1 = x[5] * W[4, 5]
    n2 = x[5] * W[5, 5]
    s0 = t0 + n0
    s1 = t1 + n1
    s2 = t2 + n2
    f["tw"][3] = o0 + s0
    f["tw"][4] = o1 + s1
    f["tw"][5] = o2 + s2
    ab = x[3] * x[4]
    b0 = o1 * s2 - o2 * s1 + t1 * n2 - t2 * n1 + ab * (W[4, 3] * W[5, 4] - W[5, 3] * W[4, 4])
    b1 = o2 * s0 - o0 * s2 + t2 * n0 - t0 * n2 + ab * (W[5, 3] * W[3, 4] - W[3, 3] * W[5, 4])
    b2 = o0 * s1 - o1 * s0 + t0 * n1 - t1 * n0 + ab * (W[3, 3] * W[4, 4] - W[4, 3] * W[3, 4])
    f["ac"][3] = e0 + y[3] * W[3, 3] + y[4] * W[3, 4] + y[5] * W[3, 5] + b0
    f["ac"][4] = e1 + y[3] * W[4, 3] + y[4] * W[4, 4] + y[5] * W[4, 5] + b1
    f["ac"][5] = e2 + y[3] * W[5, 3] + y[4] * W[5, 4] + y[5] * W[5, 5] + b2
    f["phi"] = d[5]
    f["spin"] = x[5]
    f["base"] = o["sense"] * (p["phi"] + p["base"])
    f["base_turns"] = int(o["sense"]) * (p["turns"] + p["base_turns"])


@kernel
def _columns(body, b, path, fr, J, guides, mo):
    """Columns of the joint of a body, and those of all inboard joints transferred to its origin."""
    o = body[b]
    p = body[o["parent"]]
    f = fr[b]
    g = fr[o["parent"]]
    x = f["r"][0] - g["r"][0]
    y = f["r"][1] - g["r"][1]
    z = f["r"][2] - g["r"][2]
    for k in range(p["count"]):
        to = o["first"] + k
        by = p["first"] + k
        for c in range(path[to]["n"]):
            w0 = J[by, 3, c]
            w1 = J[by, 4, c]
            w2 = J[by, 5, c]
            J[to, 0, c] = J[by, 0, c] + w1 * z - w2 * y
            J[to, 1, c] = J[by, 1, c] + w2 * x - w0 * z
            J[to, 2, c] = J[by, 2, c] + w0 * y - w1 * x
            J[to, 3, c] = w0
            J[to, 4, c] = w1
            J[to, 5, c] = w2
    own = o["path"]
    W = mo["W"]
    for k in range(o["n"]):
        if o["guide"] >= 0:
            by_k = guides[o["guide"]]["by"]
            for i in range(6):
                s = 0.0
                for m in range(6):
                    s += W[i, m] * by_k[m, k]
                J[own, i, k] = s
        else:
            m = o["axis"][k]
            for i in range(6):
                J[own, i, k] = W[i, m] + o["lead"] * W[i, Z]


@kernel
def joint_motion(o, p, f, mo, guides, charts, q, v, a):
    """Displacements of a joint, its columns W, and R of its body; requires S of the parent."""
    _displace(o, f, mo, guides, q, v, a)
    _joint_frame(o, p, f, charts, mo)
    _turn(f, mo)


@kernel
def count_spin(o, body, fr, f, mo):
    """Split the attitude of a body attached to a spinner into frame R and spin; R is S on entry.

    The attitude relative to the parent frame of the spinner is expressed as alpha about x, beta about the
    rotated y, and spin, as for a joint with six coordinates; the whole turns are those of the spinner.
    """
    g = fr[o["spinner"]]
    p = fr[body[o["spinner"]]["parent"]]
    W = mo["W"]
    R = f["R"]
    U = o["upright"]
    S = p["S"]
    nx = 0.0
    ny = 0.0
    nz = 0.0
    for i in range(3):
        x = S[i, 0] * U[0, 0] + S[i, 1] * U[1, 0] + S[i, 2] * U[2, 0]
        y = S[i, 0] * U[0, 1] + S[i, 1] * U[1, 1] + S[i, 2] * U[2, 1]
        z = S[i, 0] * U[0, 2] + S[i, 1] * U[1, 2] + S[i, 2] * U[2, 2]
        W[3 + i, 3] = x
        W[3 + i, 4] = y
        W[3 + i, 5] = z
        nx += x * R[i, 2]
        ny += y * R[i, 2]
        nz += z * R[i, 2]
    cb = math.sqrt(ny * ny + nz * nz)
    sa = -ny / cb
    ca = nz / cb
    c = 0.0
    s = 0.0
    rate = 0.0
    along = 0.0
    for i in range(3):
        x = W[3 + i, 3]
        y = ca * W[3 + i, 4] + sa * W[3 + i, 5]
        z = ca * W[3 + i, 5] - sa * W[3 + i, 4]  # x cross y
        n = R[i, 2]
        c += R[i, 0] * (cb * x - nx * z)
        s += R[i, 0] * y
        rate += z * (f["tw"][3 + i] - p["tw"][3 + i])
        along += z * n
        W[3 + i, 4] = y
        W[3 + i, 5] = n
        R[i, 0] = cb * x - nx * z
        R[i, 1] = y
    phi = math.atan2(s, c)
    angle = f["base"] - g["base"]
    f["turns"] = f["base_turns"] - g["base_turns"] + int(math.floor((angle - phi) / TWO_PI + 0.5))
    f["phi"] = phi
    f["spin"] = rate / along
    f["base"] = g["base"]
    f["base_turns"] = g["base_turns"]


@kernel
def tree_kinematics(body, path, fr, J, motions, guides, charts, q, v, a):
    """Frames and columns of all bodies that are not round, and S where required; parents first."""
    for b in range(body.size):
        o = body[b]
        f = fr[b]
        if o["joint"] == GENERAL:
            mo = motions[b]
            p = fr[o["parent"]]
            joint_motion(o, p, f, mo, guides, charts, q, v, a)
            _place(o, p, f, mo)
            _columns(body, b, path, fr, J, guides, mo)
            if o["spinner"] != 0:
                count_spin(o, body, fr, f, mo)
        if o["fixed_axes"] != 0:
            body_axes(f)


@kernel
def start_charts_afresh(body, fr, charts, q, v, a, al, ap):
    """Set a new chart for tumbling bodies with a large beta; returns the number of changed bodies.

    The new chart is the present attitude Q; the new rates are the components of the angular velocity in the
    axes of Q. `al` and `ap`, the memory of one-step methods, are transformed like the second rates a.
    """
    changed = 0
    for b in range(body.size):
        o = body[b]
        if o["chart"] >= 0:
            d = o["dof"] + o["n"] - 3
            if abs(q[d + 1]) > MAX_TILT:
                _fresh_chart(charts[o["chart"]], d, q, v, a, al, ap)
                fr[b]["turns"] = 0
                changed += 1
    return changed


@kernel
def _fresh_chart(C, d, q, v, a, al, ap):
    """Merge the rotations at coordinates d to d + 2 into the chart C; transform rates and second rates."""
    ca = math.cos(q[d])
    sa = math.sin(q[d])
    cb = math.cos(q[d + 1])
    sb = math.sin(q[d + 1])
    cs = math.cos(q[d + 2])
    ss = math.sin(q[d + 2])
    va = v[d]
    vb = v[d + 1]
    vs = v[d + 2]
    # axes x, w2 and n in the old chart, and the bias of the angular acceleration
    n1 = -sa * cb
    n2 = ca * cb
    b0 = vs * vb * cb
    b1 = -va * vb * sa + vs * (vb * sa * sb - va * n2)
    b2 = va * vb * ca + vs * (va * n1 - vb * ca * sb)
    for i in range(3):
        x = C[i, 0]
        e2 = ca * C[i, 1] + sa * C[i, 2]
        e3 = ca * C[i, 2] - sa * C[i, 1]
        u = cb * x - sb * e3
        C[i, 0] = cs * u + ss * e2
        C[i, 1] = cs * e2 - ss * u
        C[i, 2] = cb * e3 + sb * x
    turn = (ca, sa, cb, sb, cs, ss)
    bias = (b0, b1, b2)
    rates = _seen(turn, va + vs * sb, vb * ca + vs * n1, vb * sa + vs * n2)
    _second(turn, a, d, bias, rates)
    _second(turn, al, d, bias, rates)
    _second(turn, ap, d, bias, rates)
    for i in range(3):
        v[d + i] = rates[i]
        q[d + i] = 0.0


@kernel
def _seen(turn, x, y, z):
    """Components of a vector in axes rotated by alpha, beta and spin; `turn` are their cosines and sines."""
    ca, sa, cb, sb, cs, ss = turn
    y2 = ca * y + sa * z
    z2 = ca * z - sa * y
    x3 = cb * x - sb * z2
    return cs * x3 + ss * y2, cs * y2 - ss * x3, cb * z2 + sb * x


@kernel
def _second(turn, a, d, bias, rates):
    """Transform second rates to the new chart: angular acceleration minus its velocity-dependent part."""
    ca, sa, cb, sb, _, _ = turn
    x = a[d] + a[d + 2] * sb + bias[0]
    y = a[d + 1] * ca - a[d + 2] * sa * cb + bias[1]
    z = a[d + 1] * sa + a[d + 2] * ca * cb + bias[2]
    x, y, z = _seen(turn, x, y, z)
    a[d] = x - rates[2] * rates[1]
    a[d + 1] = y + rates[2] * rates[0]
    a[d + 2] = z - rates[0] * rates[1]
