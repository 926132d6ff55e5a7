# SPDX-License-Identifier: Apache-2.0
"""Derivatives of twists and accelerations by joint displacements and rates, for exact linearisation.

Consider one displacement c of a joint, its axis w through the origin r_k of the body it moves, and an
outboard body b. With o and e the angular velocity of the frame after c and its derivative, rho = r_b - r_k
and

    v_b = v_k + o x rho + v_r,   a_b = a_k + e x rho + o x (o x rho) + 2 o x v_r + a_r,
    omega_b = o + o_r,           e_b = e + e_r + o x o_r,

a rotation about w rotates rho, v_r, a_r, o_r and e_r like vectors of one rigid body, and a rate about w adds
w to o and o x w to e. A translation along w moves all outboard bodies by w in the frame of the parent.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.multibody.joints import Z
from pitchpoint.multibody.tree import body_axes, count_spin, joint_motion
from pitchpoint.multibody.vectors import add, cross, dot, less, times, triple


@kernel
def joint_motions(body, fr, motions, guides, charts, q, v, a):
    """Displacements and columns of all joints, including round bodies, at the frames in the workspace.

    Also writes `axle` of every body: its scalar product with a small rotation is the change of the spin. It
    is the spin axis unless beta tilts the body: w1 then has a component along the spin axis, and axle is w1
    x w2 / cos(beta), perpendicular to both tilt axes.
    """
    for b in range(body.size):
        body_axes(fr[b])
    for b in range(1, body.size):
        o = body[b]
        f = fr[b]
        joint_motion(o, fr[o["parent"]], f, motions[b], guides, charts, q, v, a)
        if o["spinner"] != 0:
            f["base"] = o["sense"] * (fr[o["parent"]]["phi"] + fr[o["parent"]]["base"])
            f["base_turns"] = int(o["sense"]) * (fr[o["parent"]]["turns"] + fr[o["parent"]]["base_turns"])
            count_spin(o, body, fr, f, motions[b])
        W = motions[b]["W"]
        x, y, z = cross(_axis(W, 3), _axis(W, 4))
        s = x * W[3, 5] + y * W[4, 5] + z * W[5, 5]
        f["axle"][0] = x / s
        f["axle"][1] = y / s
        f["axle"][2] = z / s


@kernel
def _axis(W, m):
    """Direction of displacement m: rows 0..2 for a translation, 3..5 for a rotation."""
    first = 0 if m < 3 else 3
    return W[first, m], W[first + 1, m], W[first + 2, m]


@kernel
def _after(p, mo, m):
    """Angular velocity of the frame after the rotations up to m, and its time derivative."""
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
def _by_rate(p, k, f, mo, m, t, c, factor, out):
    """Add factor times the derivative of the acceleration of body f by the rate of displacement m."""
    w = _axis(mo["W"], m)
    nothing = (0.0, 0.0, 0.0)
    if m < 3:
        _put(out, t, c, 2.0 * factor, cross(triple(p["tw"], 3), w), nothing)
        return
    o, _ = _after(p, mo, m)
    rho = less(triple(f["r"], 0), triple(k["r"], 0))
    v_r = less(less(triple(f["tw"], 0), triple(k["tw"], 0)), cross(o, rho))
    tilt = cross(o, w)
    linear = add(cross(tilt, rho), add(cross(w, cross(o, rho)), cross(o, cross(w, rho))))
    angular = add(tilt, cross(w, less(triple(f["tw"], 3), o)))
    _put(out, t, c, factor, add(linear, times(2.0, cross(w, v_r))), angular)


@kernel
def _displacement(p, k, f, mo, m, t, c, factor, rates):
    """Add factor times the derivatives of body f by displacement m of the joint of k to column c."""
    Tq, Av, Aq = rates
    _by_rate(p, k, f, mo, m, t, c, factor, Av)
    w = _axis(mo["W"], m)
    nothing = (0.0, 0.0, 0.0)
    if m < 3:
        o = triple(p["tw"], 3)
        s = cross(o, w)
        _put(Tq, t, c, factor, s, nothing)
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
    _put(Tq, t, c, factor, add(cross(o, turned), dv), do)
    by_place = add(cross(e, turned), cross(o, cross(o, turned)))
    by_place = add(by_place, add(times(2.0, cross(o, dv)), cross(w, a_r)))
    _put(Aq, t, c, factor, by_place, add(cross(w, e_r), cross(o, do)))


@kernel
def _transferred_column(k, f, W, m):
    """Column of displacement m of the body with frame k, transferred to the origin of frame f."""
    w = _axis(W, m)
    nothing = (0.0, 0.0, 0.0)
    if m < 3:
        return w, nothing
    return cross(w, less(triple(f["r"], 0), triple(k["r"], 0))), w


@kernel
def _guided(p, k, f, mo, g, t, c, v, a, rates):
    """Add the derivatives by coordinate c of a guided joint: chain rule over its displacements.

    A displacement d(q) has the derivatives d' = d_q q' and d'' = d_q q'' + d_qq q'^2.
    """
    Tq, Av, Aq = rates
    for m in range(6):
        by = g["by"][m, c]
        bend = g["by2"][m, c]
        if by != 0.0:
            _displacement(p, k, f, mo, m, t, c, by, rates)
        if bend != 0.0 or g["by3"][m, c] != 0.0:
            linear, angular = _transferred_column(k, f, mo["W"], m)
            _put(Tq, t, c, bend * v, linear, angular)
            _put(Av, t, c, 2.0 * bend * v, linear, angular)
            _put(Aq, t, c, bend * a + g["by3"][m, c] * v * v, linear, angular)
            _by_rate(p, k, f, mo, m, t, c, bend * v, Aq)


@kernel
def guided_geometry(proj, path, body, fr, motions, guides, A, ck):
    """Correct `project_geometry` for pairs of coordinates of the same guided joint.

    `project_geometry` assumes that each joint coordinate is a single displacement, in order. The coordinates
    of a guided joint act on all six displacements: dQ_a/dq_c = sum over m, n of d_m,a d_n,c (dW_m/dd_n) . F
    + sum over m of d_m,aa W_m . F.
    """
    for row in range(proj.size):
        w = proj[row]
        b = path[w["pi"]]["body"]
        owner = path[w["pi"]]["owner"]
        if w["pi"] != w["pj"] or body[owner]["guide"] < 0:
            continue
        g = guides[body[owner]["guide"]]
        W = motions[owner]["W"]
        k = fr[owner]
        f = fr[b]
        force = triple(f["F"], 0)
        moment = triple(f["F"], 3)
        for a in range(w["ni"]):
            for c in range(w["nj"]):
                wrong = 0.0
                right = 0.0
                for m in range(6):
                    l_m, w_m = _transferred_column(k, f, W, m)
                    if a == c:
                        right += g["by2"][m, a] * (dot(l_m, force) + dot(w_m, moment))
                    for n in range(6):
                        share = g["by"][m, a] * g["by"][n, c]
                        l_n, w_n = _transferred_column(k, f, W, n)
                        inboard = dot(cross(w_n, l_m), force) + dot(cross(w_n, w_m), moment)
                        outboard = dot(cross(w_m, l_n), force)
                        right += share * (inboard if n < m else outboard)
                        wrong += share * (inboard if c < a else outboard)
                A[w["blk"], w["oi"] + a, w["oj"] + c] -= ck * (right - wrong)


@kernel
def joint_rates(body, path, fr, motions, guides, rates, v, a):
    """Derivatives of twists and accelerations for exact linearisation; call after `joint_motions`.

    `rates` are Tq = d(twist)/dq, Av = d(acceleration)/dv, Aq = d(acceleration)/dq with one column per
    coordinate for every path entry; the joint columns J themselves are not included.
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
            if o["guide"] >= 0:
                d = o["dof"] + c
                g = guides[o["guide"]]
                _guided(p, fr[k], f, motions[k], g, t, c, v[d], a[d], rates)
                continue
            _displacement(p, fr[k], f, motions[k], o["axis"][c], t, c, 1.0, rates)
            if o["lead"] != 0.0:
                _displacement(p, fr[k], f, motions[k], Z, t, c, o["lead"], rates)
