# SPDX-License-Identifier: Apache-2.0
"""Linear bearing or coupling: a 6 x 6 spring and damper between two bodies (body 0 = ground).

Marker i lies on the spin axis of body i, marker j on that of body j; the springs act in an assembly frame W
that goes with the non-spinning frame of body j (world axes for ground). The displacement is
u = (W^T (p_i - p_j) - d0, -n_i.w_y, n_i.w_x, spin_i - spin_j) - u0: three translations, two tilts, the twist.
The wrench on body i is the conjugate one, that on body j its exact opposite; forces act at marker i. Damping
works with the twist between the bodies, so between two spinning bodies it rotates with them.

The twist is conjugate to first order in the tilt; everything else is exact for any tilt when j is ground.
Between two bodies, the exact tangent leaves out the turn of a preload. They must be coaxial as assembled, or
joined by torsion alone: u knows no spin but the twist, so a force between two axes would do work that no
spring gives. `model/support_check.py` refuses such a coupling.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.multibody.channels import frame_args, observations

TWO_PI = 6.283185307179586

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("K", "f8", (6, 6)),  # stiffness in W [N/m, N/rad, N m/m, N m/rad]
        ("D", "f8", (6, 6)),  # damping in W, likewise per second
        ("u0", "f8", 6),  # displacement without force [m, rad]: a preload K u0 on body i
        ("zi", "f8"),  # marker on the spin axis of body i, from its origin [m]
        ("zj", "f8"),  # marker on the spin axis of body j [m]
        ("d0", "f8", 3),  # vector from marker j to marker i as assembled, in W [m]
        ("B", "f8", (3, 3)),  # axes of W in the frame of body j, columns
        ("Pi", "f8", (6, 6)),  # scratch: du per displacement twist of body i
        ("Pj", "f8", (6, 6)),  # scratch: the same of body j
        ("C", "f8", (6, 6)),  # scratch
        ("f", "f8", 6),  # scratch: force on body i in W
        ("out", "i8"),
    ],
    align=True,
)

OUTPUTS = (
    ("bearing_force[{}.fx]", "N", "force on the body, x"),
    ("bearing_force[{}.fy]", "N", "force on the body, y"),
    ("bearing_force[{}.fz]", "N", "force on the body, axial"),
    ("bearing_force[{}.mx]", "N m", "moment on the body, x"),
    ("bearing_force[{}.my]", "N m", "moment on the body, y"),
    ("bearing_force[{}.mz]", "N m", "moment on the body about the axis"),
)


def outputs(record: np.void) -> tuple[tuple[str, str, str], ...]:
    """Names of the observations of one record: bearing on ground, or coupling between two bodies."""
    if record["j"] == 0:
        return OUTPUTS
    return tuple(
        (name.replace("bearing", "coupling"), unit, words.replace("the body", "the first body"))
        for name, unit, words in OUTPUTS
    )


@kernel
def _columns(P, sign, W, k, x, y, z, e0, e1, e2):
    """Row k of P for a force along W's axis k at the arm (x, y, z), and row 3 + k for the moment axis e."""
    a = W[0, k]
    b = W[1, k]
    c = W[2, k]
    P[k, 0] = sign * a
    P[k, 1] = sign * b
    P[k, 2] = sign * c
    P[k, 3] = sign * (y * c - z * b)
    P[k, 4] = sign * (z * a - x * c)
    P[k, 5] = sign * (x * b - y * a)
    P[3 + k, 0] = 0.0
    P[3 + k, 1] = 0.0
    P[3 + k, 2] = 0.0
    P[3 + k, 3] = sign * e0
    P[3 + k, 4] = sign * e1
    P[3 + k, 5] = sign * e2


@kernel
def _kinematics(b, f, g):
    """Displacement u into b["f"], its gradients into Pi and Pj; W goes through the scratch C."""
    W = b["C"]
    for k in range(3):
        for c in range(3):
            W[k, c] = g["R"][k, 0] * b["B"][0, c] + g["R"][k, 1] * b["B"][1, c] + g["R"][k, 2] * b["B"][2, c]
    n0 = f["R"][0, 2]
    n1 = f["R"][1, 2]
    n2 = f["R"][2, 2]
    s = b["zi"]
    x = f["r"][0] + s * n0 - g["r"][0]  # arm of marker i about the origin of body j
    y = f["r"][1] + s * n1 - g["r"][1]
    z = f["r"][2] + s * n2 - g["r"][2]
    h = b["zj"]
    u = b["f"]
    for k in range(3):
        u[k] = (
            W[0, k] * (x - h * g["R"][0, 2])
            + W[1, k] * (y - h * g["R"][1, 2])
            + W[2, k] * (z - h * g["R"][2, 2])
        ) - (b["d0"][k] + b["u0"][k])
        if k == 0:  # axis of a turn that raises -n.w_y
            e0 = W[1, 1] * n2 - W[2, 1] * n1
            e1 = W[2, 1] * n0 - W[0, 1] * n2
            e2 = W[0, 1] * n1 - W[1, 1] * n0
        elif k == 1:
            e0 = n1 * W[2, 0] - n2 * W[1, 0]
            e1 = n2 * W[0, 0] - n0 * W[2, 0]
            e2 = n0 * W[1, 0] - n1 * W[0, 0]
        else:
            e0 = n0
            e1 = n1
            e2 = n2
        _columns(b["Pi"], 1.0, W, k, s * n0, s * n1, s * n2, e0, e1, e2)
        _columns(b["Pj"], -1.0, W, k, x, y, z, e0, e1, e2)
    u[3] = -(n0 * W[0, 1] + n1 * W[1, 1] + n2 * W[2, 1]) - b["u0"][3]
    u[4] = n0 * W[0, 0] + n1 * W[1, 0] + n2 * W[2, 0] - b["u0"][4]
    u[5] = f["phi"] - g["phi"] + TWO_PI * (f["turns"] - g["turns"]) - b["u0"][5]


@kernel
def _tangent(b, kk, ck, cd):
    """Add P^T (ck K + cd D) P to the four pair blocks."""
    K = b["K"]
    D = b["D"]
    T = b["C"]
    for side in range(2):
        if side == 1 and b["j"] == 0:
            break
        P = b["Pi"] if side == 0 else b["Pj"]
        for r in range(6):
            for c in range(6):
                s = 0.0
                for h in range(6):
                    s += (ck * K[r, h] + cd * D[r, h]) * P[h, c]
                T[r, c] = s
        ki = kk[b["ii"]] if side == 0 else kk[b["ij"]]
        kj = kk[b["ji"]] if side == 0 else kk[b["jj"]]
        for r in range(6):
            for c in range(6):
                s = 0.0
                e = 0.0
                for h in range(6):
                    s += b["Pi"][h, r] * T[h, c]
                    e += b["Pj"][h, r] * T[h, c]
                ki[r, c] += s
                if b["j"] != 0:
                    kj[r, c] += e


@kernel
def _geometric(b, f, k, ck):
    """Change of the wrench of body i with the direction of its own axis, at constant forces (j ground)."""
    n0 = f["R"][0, 2]
    n1 = f["R"][1, 2]
    n2 = f["R"][2, 2]
    p = b["f"]
    P = b["Pj"]  # rows 0..2 hold minus the axes of W
    s = b["zi"]
    # M = s n x F + f3 w_y x n - f4 w_x x n + f5 n = n x m0 + f5 n
    m0 = 0.0
    m1 = 0.0
    m2 = 0.0
    for h in range(3):
        m0 -= s * p[h] * P[h, 0]
        m1 -= s * p[h] * P[h, 1]
        m2 -= s * p[h] * P[h, 2]
    m0 += p[3] * P[1, 0] - p[4] * P[0, 0]
    m1 += p[3] * P[1, 1] - p[4] * P[0, 1]
    m2 += p[3] * P[1, 2] - p[4] * P[0, 2]
    for c in range(3):
        x = 1.0 if c == 0 else 0.0
        y = 1.0 if c == 1 else 0.0
        z = 1.0 if c == 2 else 0.0
        h0 = y * n2 - z * n1  # change of n
        h1 = z * n0 - x * n2
        h2 = x * n1 - y * n0
        k[3, 3 + c] -= ck * (h1 * m2 - h2 * m1 + p[5] * h0)
        k[4, 3 + c] -= ck * (h2 * m0 - h0 * m2 + p[5] * h1)
        k[5, 3 + c] -= ck * (h0 * m1 - h1 * m0 + p[5] * h2)


@kernel
def _damping_geometric(b, f, k, ck):
    """Change of the damping force with the axis at constant twist: P^T D (dP/dn) twist (j ground)."""
    n0 = f["R"][0, 2]
    n1 = f["R"][1, 2]
    n2 = f["R"][2, 2]
    w0 = f["tw"][3]
    w1 = f["tw"][4]
    w2 = f["tw"][5]
    P = b["Pj"]
    D = b["D"]
    s = b["zi"]
    for c in range(3):
        x = 1.0 if c == 0 else 0.0
        y = 1.0 if c == 1 else 0.0
        z = 1.0 if c == 2 else 0.0
        h0 = y * n2 - z * n1
        h1 = z * n0 - x * n2
        h2 = x * n1 - y * n0
        g0 = w1 * h2 - w2 * h1  # omega x change of n
        g1 = w2 * h0 - w0 * h2
        g2 = w0 * h1 - w1 * h0
        for r in range(6):
            q = 0.0
            for a in range(6):
                if a < 3:
                    d = -s * (P[a, 0] * g0 + P[a, 1] * g1 + P[a, 2] * g2)
                elif a == 3:
                    d = P[1, 0] * g0 + P[1, 1] * g1 + P[1, 2] * g2
                elif a == 4:
                    d = -(P[0, 0] * g0 + P[0, 1] * g1 + P[0, 2] * g2)
                else:
                    d = w0 * h0 + w1 * h1 + w2 * h2
                for e in range(6):
                    q += b["Pi"][e, r] * D[e, a] * d
            k[r, 3 + c] += ck * q


@kernel
def _rotating_damping(b, f, g, kk, ck):
    """Damper that turns with a spinning body j: its rate w_a.(omega_j x arm) makes circulatory stiffness."""
    o = g["tw"]
    P = b["Pi"]
    D = b["D"]
    s = b["zi"]
    for a in range(3):
        g0 = o[4] * P[a, 2] - o[5] * P[a, 1]  # omega_j x w_a
        g1 = o[5] * P[a, 0] - o[3] * P[a, 2]
        g2 = o[3] * P[a, 1] - o[4] * P[a, 0]
        h0 = s * (f["R"][1, 2] * g2 - f["R"][2, 2] * g1)  # arm of marker i x that
        h1 = s * (f["R"][2, 2] * g0 - f["R"][0, 2] * g2)
        h2 = s * (f["R"][0, 2] * g1 - f["R"][1, 2] * g0)
        for r in range(6):
            x = 0.0
            y = 0.0
            for e in range(6):
                x += ck * P[e, r] * D[e, a]
                y += ck * b["Pj"][e, r] * D[e, a]
            for side in range(2):
                w = x if side == 0 else y
                left = kk[b["ii"]] if side == 0 else kk[b["ji"]]
                right = kk[b["ij"]] if side == 0 else kk[b["jj"]]
                left[r, 0] += w * g0
                left[r, 1] += w * g1
                left[r, 2] += w * g2
                left[r, 3] += w * h0
                left[r, 4] += w * h1
                left[r, 5] += w * h2
                right[r, 0] -= w * g0
                right[r, 1] -= w * g1
                right[r, 2] -= w * g2


@kernel
def bearing(rec, ctl, fr, kk):
    """Forces, tangents and observations of all bearings."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        g = fr[b["j"]]
        _kinematics(b, f, g)
        u = b["f"]
        T = b["C"]
        for r in range(6):  # rates, kept in the first column of the scratch
            s = 0.0
            for h in range(6):
                s += b["Pi"][r, h] * f["tw"][h] + b["Pj"][r, h] * g["tw"][h]
            T[r, 0] = s
        for r in range(6):
            s = 0.0
            for h in range(6):
                s -= b["K"][r, h] * u[h] + b["D"][r, h] * T[h, 0]
            T[r, 1] = s
        for r in range(6):
            u[r] = T[r, 1]
        for r in range(6):
            s = 0.0
            d = 0.0
            for h in range(6):
                s += b["Pi"][h, r] * u[h]
                d += b["Pj"][h, r] * u[h]
            f["F"][r] += s
            g["F"][r] += d
        if c["jac"] != 0:
            _tangent(b, kk, c["ck"], c["cd"])
            if c["jac"] == 2 and b["j"] == 0 and c["ck"] != 0.0:
                _geometric(b, f, kk[b["ii"]], c["ck"])
                _damping_geometric(b, f, kk[b["ii"]], c["ck"])
            elif c["jac"] == 2 and c["ck"] != 0.0:
                _rotating_damping(b, f, g, kk, c["ck"])
        if c["out"] != 0:
            out = observations(ctl)
            for r in range(6):
                out[b["out"] + r] = u[r]
    return OK


@kernel
def entry(ctl, rec, n):
    """Uniform entry of the kind."""
    c, fr, kk = frame_args(ctl)
    return bearing(view(rec, n, RECORD), c, fr, kk)


def defaults(record: np.void) -> None:
    """Set the axes of the assembly frame of a fresh record to those of body j."""
    record["B"] = np.eye(3)
