# SPDX-License-Identifier: Apache-2.0
"""How twists and accelerations change with moving joint axes; only exact linearisation asks.

Take one displacement c of a joint, its axis w through the origin r_k of the body it moves, and a body b
further out. With o and e the angular velocity of the frame after c and its derivative, rho = r_b - r_k and

    v_b = v_k + o x rho + v_r,   a_b = a_k + e x rho + o x (o x rho) + 2 o x v_r + a_r,
    omega_b = o + o_r,           e_b = e + e_r + o x o_r,

a turn about w turns rho, v_r, a_r, o_r and e_r like vectors of one rigid thing, and a rate about w adds w to
o and o x w to e. A translation along w moves what is further out by w in the frame of the parent.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.multibody.joints import Z
from pitchpoint.multibody.tree import body_axes, joint_motion
from pitchpoint.multibody.vectors import add, cross, less, times, triple


@kernel
def joint_motions(body, fr, motions, guides, charts, q, v, a):
    """Displacements and columns of all joints, round bodies too, at the frames in the workspace.

    Also written is the vector of every body whose product with a small turn is the change of its spin. It is
    the spin axis, unless beta tilts the body: w1 then has a share along the spin axis, and
    w1 x w2 / cos(beta) is the vector that stands on both tilt axes.
    """
    for b in range(body.size):
        body_axes(fr[b])
    for b in range(1, body.size):
        o = body[b]
        f = fr[b]
        joint_motion(o, fr[o["parent"]], f, motions[b], guides, charts, q, v, a)
        W = motions[b]["W"]
        x, y, z = cross(_axis(W, 3), _axis(W, 4))
        s = x * W[3, 5] + y * W[4, 5] + z * W[5, 5]
        f["axle"][0] = x / s
        f["axle"][1] = y / s
        f["axle"][2] = z / s


@kernel
def _axis(W, m):
    """Direction of displacement m: rows 0..2 of a translation, 3..5 of a turn."""
    first = 0 if m < 3 else 3
    return W[first, m], W[first + 1, m], W[first + 2, m]


@kernel
def _after(p, mo, m):
    """Angular velocity and its derivative of the frame after the turns up to m."""
    o = triple(p["tw"], 3)
    e = triple(p["ac"], 3)
    for k in range(3, m + 1):
        w = _axis(mo["W"], k)
        s = times(mo["rate"][k], w)
        e = add(e, add(times(mo["second"][k], w), cross(o, s)))
        o = add(o, s)
    return o, e


@kernel
def _put(out, t, c, factor, linear, angular):
    for i in range(3):
        out[t, i, c] += factor * linear[i]
        out[t, 3 + i, c] += factor * angular[i]


@kernel
def _displacement(p, k, f, mo, m, t, c, factor, rates):
    """Add factor times the rates by displacement m of the joint of k, as felt by body f, to column c."""
    Tq, Av, Aq = rates
    w = _axis(mo["W"], m)
    nothing = (0.0, 0.0, 0.0)
    if m < 3:
        o = triple(p["tw"], 3)
        s = cross(o, w)
        _put(Tq, t, c, factor, s, nothing)
        _put(Av, t, c, 2.0 * factor, s, nothing)
        _put(Aq, t, c, factor, add(cross(triple(p["ac"], 3), w), cross(o, s)), nothing)
        return
    o, e = _after(p, mo, m)
    rho = less(triple(f["r"], 0), triple(k["r"], 0))
    o_r = less(triple(f["tw"], 3), o)
    e_r = less(less(triple(f["ac"], 3), e), cross(o, o_r))
    turned = cross(w, rho)
    swept = cross(o, rho)
    v_r = less(less(triple(f["tw"], 0), triple(k["tw"], 0)), swept)
    a_r = less(less(triple(f["ac"], 0), triple(k["ac"], 0)), cross(e, rho))
    a_r = less(less(a_r, cross(o, swept)), times(2.0, cross(o, v_r)))
    dv = cross(w, v_r)
    do = cross(w, o_r)
    tilt = cross(o, w)
    _put(Tq, t, c, factor, add(cross(o, turned), dv), do)
    by_rate = add(cross(tilt, rho), add(cross(w, swept), cross(o, turned)))
    _put(Av, t, c, factor, add(by_rate, times(2.0, dv)), add(tilt, do))
    by_place = add(cross(e, turned), cross(o, cross(o, turned)))
    by_place = add(by_place, add(times(2.0, cross(o, dv)), cross(w, a_r)))
    _put(Aq, t, c, factor, by_place, add(cross(w, e_r), cross(o, do)))


@kernel
def joint_rates(body, path, fr, motions, rates):
    """Derivatives of twists and accelerations that only an exact linearisation needs, after `joint_motions`.

    `rates` are Tq = d(twist)/dq, Av = d(acceleration)/dv, Aq = d(acceleration)/dq, one column per coordinate
    of every entry of a path, the columns of the joint itself apart.
    """
    Tq, Av, Aq = rates
    for t in range(path.size):
        for i in range(6):
            for c in range(6):
                Tq[t, i, c] = 0.0
                Av[t, i, c] = 0.0
                Aq[t, i, c] = 0.0
        k = path[t]["owner"]
        o = body[k]
        p = fr[o["parent"]]
        f = fr[path[t]["body"]]
        for c in range(o["n"]):
            _displacement(p, fr[k], f, motions[k], o["axis"][c], t, c, 1.0, rates)
            if o["lead"] != 0.0:
                _displacement(p, fr[k], f, motions[k], Z, t, c, o["lead"], rates)
