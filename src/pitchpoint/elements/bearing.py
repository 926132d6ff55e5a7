# SPDX-License-Identifier: Apache-2.0
"""Linear bearing or coupling: a 6 x 6 spring and damper between two bodies (body 0 = ground).

Marker i is on the spin axis of body i, marker j on that of body j; the springs act in an assembly frame W
that is fixed to the non-spinning frame of body j (world axes for ground). The displacement is u = (W^T (p_i -
p_j) - d0, -n_i.w_y, n_i.w_x, spin_i - spin_j) - u0: three translations, two tilts, the twist. The wrench on
body i is conjugate to u, that on body j is its exact reaction; forces act at marker i. Damping acts on the
relative velocity of the bodies, so between two spinning bodies it rotates with them.

The twist is conjugate for any angle between the spin axes, and to first order in the tilt of the bodies; all
other components are exact for any tilt if j is ground. For a bearing in a housing, body j is fixed to the
housing at the bearing, along its axis, and its frame rotates with the housing; the spin is free.

Two bodies must be coaxial as assembled, or coupled in torsion only: u contains the spin only in the twist, so
a force between offset axes would not be conservative. `model/checks/supports.py` refuses such a coupling.

Integrators use P^T (K, D) P. The exact tangent is the full derivative of the wrenches: the axes of W, the
markers and the axes of the moments move with the bodies, under spring forces and under the forces of spinning
dampers.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.kind import ACROSS, FRAME, HOLDS, NOTHING, TOGETHER, Kind, Power
from pitchpoint.elements.ring import RESULTANT_OUTPUTS, put_resultants
from pitchpoint.elements.twist import turned_twist_axis, twist_axis
from pitchpoint.elements.wrench import angular_velocity, origin, spin_axis, velocity
from pitchpoint.multibody.channels import frame_args, observations
from pitchpoint.multibody.vectors import add, cross, dot, times, unit

TWO_PI = 6.283185307179586

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("K", "f8", (6, 6)),  # stiffness in W [N/m, N/rad, N m/m, N m/rad]
        ("D", "f8", (6, 6)),  # damping in W, likewise per second
        ("u0", "f8", 6),  # displacement at zero force [m, rad]: a preload K u0 on body i
        ("zi", "f8"),  # marker on the spin axis of body i, from its origin [m]
        ("zj", "f8"),  # marker on the spin axis of body j [m]
        ("d0", "f8", 3),  # vector from marker j to marker i as assembled, in W [m]
        ("B", "f8", (3, 3)),  # axes of W in the frame of body j, columns
        ("Pi", "f8", (6, 6)),  # scratch: gradient of u for motions of body i
        ("Pj", "f8", (6, 6)),  # scratch: the same for body j
        ("C", "f8", (6, 6)),  # scratch
        ("f", "f8", 6),  # scratch: force on body i in W
        ("housed", "i8"),  # 1: body j is the seat of a bearing in a housing; W follows its full rotation
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
    """Observations of one record, named as bearing (on ground, in a housing) or as coupling."""
    if record["j"] == 0 or record["housed"]:
        return OUTPUTS + RESULTANT_OUTPUTS
    first = ("the body", "the first body")
    return tuple((n.replace("bearing", "coupling"), u, words.replace(*first)) for n, u, words in OUTPUTS)


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
def _far_axis(b, f, g):
    """Spin axis of body j of a coupling; that of body i for bearings."""
    return spin_axis(f) if b["j"] == 0 or b["housed"] == 1 else spin_axis(g)


@kernel
def _kinematics(b, f, g):
    """Write the displacement u to b["f"] and its gradients to Pi and Pj; the scratch C holds W."""
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
        if k == 0:  # axis of a rotation that increases -n.w_y
            e0 = W[1, 1] * n2 - W[2, 1] * n1
            e1 = W[2, 1] * n0 - W[0, 1] * n2
            e2 = W[0, 1] * n1 - W[1, 1] * n0
        elif k == 1:
            e0 = n1 * W[2, 0] - n2 * W[1, 0]
            e1 = n2 * W[0, 0] - n0 * W[2, 0]
            e2 = n0 * W[1, 0] - n1 * W[0, 0]
        else:
            e0, e1, e2 = twist_axis((n0, n1, n2), _far_axis(b, f, g))
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
def _along(b, k):
    """Axis k of W, from the gradient Pi."""
    return b["Pi"][k, 0], b["Pi"][k, 1], b["Pi"][k, 2]


@kernel
def _spun(f, turn):
    """Change of the spin angle for a rotation of the body."""
    return f["axle"][0] * turn[0] + f["axle"][1] * turn[1] + f["axle"][2] * turn[2]


@kernel
def _arms(b, f, g):
    """Position of marker i relative to the origin of body i, to that of body j, and to marker j."""
    own = times(b["zi"], spin_axis(f))
    arm = add(add(origin(f), own), times(-1.0, origin(g)))
    return own, arm, add(arm, times(-b["zj"], spin_axis(g)))


@kernel
def _moves(b, f, g, side, c):
    """Change of the twist, rotation of W, changes of axis i and of the three arms for one motion of one body.

    Motion c of body i (`side` 0) or j (1) is a translation (c < 3) or a rotation. W rotates with the frame of
    body j, which does not spin, or with the body itself if that is a housing.
    """
    shift = unit(c)
    turn = unit(c - 3)
    if side == 0:
        dn = cross(turn, spin_axis(f))
        d_own = times(b["zi"], dn)
        d_arm = add(shift, d_own)
        return _spun(f, turn), unit(3), dn, d_own, d_arm, d_arm
    twist = -_spun(g, turn)
    if b["housed"] == 1:
        twist = 0.0
    frame = add(turn, times(twist, spin_axis(g)))
    d_arm = times(-1.0, shift)
    d_gap = add(d_arm, times(-b["zj"], cross(turn, spin_axis(g))))
    return twist, frame, unit(3), unit(3), d_arm, d_gap


@kernel
def _turned_axis(b, n, frame, dn, k):
    """Change of the axis of tilting moment k: w_y x n or n x w_x."""
    w = _along(b, 1 - k)
    de = add(cross(cross(frame, w), n), cross(w, dn))
    return de if k == 0 else times(-1.0, de)


@kernel
def _change(b, f, g, side, c):
    """Derivatives for motion c of one body at constant body velocities, in the columns of the scratch C.

    Column 0: displacement u; 1: its rate P_i tw_i + P_j tw_j; 2: wrench on body i at constant forces f in W;
    3: wrench on body j, likewise.
    """
    n = spin_axis(f)
    far = _far_axis(b, f, g)
    own, arm, gap = _arms(b, f, g)
    twist, frame, dn, d_own, d_arm, d_gap = _moves(b, f, g, side, c)
    d_far = dn if b["j"] == 0 or b["housed"] == 1 else cross(unit(c - 3), far) if side == 1 else unit(3)
    oi = angular_velocity(f)
    oj = angular_velocity(g)
    across = add(oi, times(-1.0, oj))
    force = unit(3)
    couple = unit(3)
    T = b["C"]
    for k in range(3):
        w = _along(b, k)
        dw = cross(frame, w)
        T[k, 0] = dot(dw, gap) + dot(w, d_gap)
        T[k, 1] = dot(dw, velocity(f)) + dot(add(cross(d_own, w), cross(own, dw)), oi)
        T[k, 1] -= dot(dw, velocity(g)) + dot(add(cross(d_arm, w), cross(arm, dw)), oj)
        de = _turned_axis(b, n, frame, dn, k) if k < 2 else turned_twist_axis(n, far, dn, d_far)
        T[3 + k, 1] = dot(de, across)
        force = add(force, times(b["f"][k], w))
        couple = add(couple, times(b["f"][3 + k], de))
        if k < 2:  # u_3 = -n . w_y, u_4 = n . w_x
            s = dot(dn, w) + dot(n, dw)
            T[4 - k, 0] = s if k == 0 else -s
    T[5, 0] = twist
    df = cross(frame, force)
    mi = add(couple, add(cross(d_own, force), cross(own, df)))
    mj = add(couple, add(cross(d_arm, force), cross(arm, df)))
    for r in range(3):
        T[r, 2] = df[r]
        T[3 + r, 2] = mi[r]
        T[r, 3] = -df[r]
        T[3 + r, 3] = -mj[r]


@kernel
def _exact(b, f, g, kk, ck):
    """Add ck times the full derivative of both wrenches by the body poses, at constant velocities."""
    T = b["C"]
    for side in range(2):
        if side == 1 and b["j"] == 0:
            break
        ki = kk[b["ii"]] if side == 0 else kk[b["ij"]]
        kj = kk[b["ji"]] if side == 0 else kk[b["jj"]]
        for c in range(6):
            _change(b, f, g, side, c)
            for r in range(6):
                s = 0.0
                for h in range(6):
                    s += b["K"][r, h] * T[h, 0] + b["D"][r, h] * T[h, 1]
                T[r, 4] = s
            for r in range(6):
                s = -T[r, 2]
                e = -T[r, 3]
                for h in range(6):
                    s += b["Pi"][h, r] * T[h, 4]
                    e += b["Pj"][h, r] * T[h, 4]
                ki[r, c] += ck * s
                if b["j"] != 0:
                    kj[r, c] += ck * e


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
        for r in range(6):  # rates, in the first column of the scratch
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
        if c["jac"] == 2:
            _tangent(b, kk, 0.0, c["cd"])
            if c["ck"] != 0.0:
                _exact(b, f, g, kk, c["ck"])
        elif c["jac"] != 0:
            _tangent(b, kk, c["ck"], c["cd"])
        if c["out"] != 0:
            out = observations(ctl)
            for r in range(6):
                out[b["out"] + r] = u[r]
            if b["j"] == 0 or b["housed"] == 1:
                put_resultants(out, b["out"])
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return bearing(view(rec, n, RECORD), c, fr, kk)


def defaults(record: np.void) -> None:
    """Set the axes of the assembly frame of a fresh record to those of body j."""
    record["B"] = np.eye(3)


def _spins(record: np.void) -> str:
    """Both bodies rotate together if the torsional stiffness is not zero."""
    return HOLDS if record["K"][5, 5] == 0.0 else TOGETHER


def _resists(record: np.void) -> str:
    """A bearing constrains its housing about all axes except its own."""
    return NOTHING if record["housed"] == 0 else ACROSS


def _linear(record: np.void, spinning: bool) -> bool:
    """Linear unless it constrains a spin against ground."""
    return not (spinning and 0 in (record["i"], record["j"]) and record["K"][5, 5] != 0.0)


def _label(record: np.void) -> str:
    """Label: bearing on ground or in a housing, else coupling."""
    return "coupling" if record["j"] != 0 and not record["housed"] else "bearing"


def _arrow(record: np.void) -> str:
    """Forces of couplings are not drawn."""
    return "bearing" if record["j"] == 0 or record["housed"] else ""


KIND = Kind(
    name="bearing",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=outputs,
    massless=True,
    spins=_spins,
    resists=_resists,
    linear=_linear,
    excites=False,
    sections={"bearings": "", "couplings": "flanges"},
    label=_label,
    plural="bearings",
    main=True,
    arrow=_arrow,
    power=Power("coupling_force[{}.mz]", where=lambda record: not record["housed"]),
)
