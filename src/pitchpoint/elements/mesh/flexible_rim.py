# SPDX-License-Identifier: Apache-2.0
"""Gear 2 with a flexible rim: the frame of its teeth at the place of the mesh replaces that of its body.

The modal coordinates eta of the rim are those of an element `flexible_body`, displacements of hidden bodies.
At the angle theta of the centre of gear 1 in the axes S of body j, the teeth of gear 2 are displaced like a
rigid gear by a and rotated by the small rotation c, both sums of Fourier series times coordinates,

    a = sum eta_k a_k(theta),  c = sum eta_k c_k(theta),  theta' = g_i . x_i' + g_j . x_j'

with components along radius, tangent and axis at theta. The frame of the teeth then has

    r = r_j + S a,        v = v_j + omega_j x S a + S (sum eta_k' a_k + a' theta'),
    R = exp(S c) R_j,     omega = omega_j + S (sum eta_k' c_k + c' theta')

The matrix of this relation brings wrench and tangents back, so that the power of mesh, bodies and rim is the
same: a force that moves along the deflected rim has the torque (S a') . f + (S c') . m about theta. Rotations
in the plane of the rim are exact; those out of it are correct to first order. Exact tangents include the
second derivatives, and the change of the velocities at constant velocities of bodies and coordinates, which
needs the damping part of the tangent alone.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.kind import RIM
from pitchpoint.elements.mesh.eccentricity import arms_of, damping_blocks, swing_rate, tangent_blocks
from pitchpoint.elements.mesh.line_of_action import pooled
from pitchpoint.elements.mesh.record import RECORD
from pitchpoint.elements.wrench import angular_velocity
from pitchpoint.multibody.channels import CTL, F8, FRAME
from pitchpoint.multibody.vectors import add, column, cross, dot, plus, times, triple, unit

GROUP = 3
"""Modal coordinates per hidden body."""
MAX_MODES = GROUP * (len(RIM) - 2)
"""Maximum number of modal coordinates."""
MAX_WAVES = 32
"""Maximum number of waves of a shape around the circumference."""
WAY = 12 + MAX_MODES
"""Motions of both bodies and coordinates."""

#: Scratch of the rim of one mesh; the rows of its shapes follow in the pool.
ROOM = np.dtype(
    [
        ("rows", "i8"),  # of the shapes: coordinate, waves, component, factors of cosine and sine
        ("waves", "i8"),  # their largest number
        ("cosine", "f8", MAX_WAVES + 1),
        ("sine", "f8", MAX_WAVES + 1),
        ("eta", "f8", (2, MAX_MODES)),  # coordinates and their rates
        ("shape", "f8", (3, MAX_MODES, 6)),  # a_k, c_k and their derivatives by theta, world axes
        ("sum", "f8", (3, 6)),  # the same times eta
        ("flow", "f8", (2, 6)),  # the same times the rates
        ("turn", "f8", 12),  # g_i, g_j
        ("d_turn", "f8", 12),
        ("theta_rate", "f8"),
        ("tw", "f8", 6),  # twist of body j
        ("out", "f8", 3),
        ("along", "f8", 3),  # radius and tangent at theta, world axes
        ("reach", "f8"),  # distance of the centres in the plane of the rim
        ("arm", "f8", 3),  # mid-face of gear 1 from its origin
        ("line", "f8", 3),  # mid-face of gear 1 from the origin of body j
        ("way", "f8", (6, WAY)),  # motion of the frame of the teeth by those of bodies and coordinates
        ("half", "f8", (12, WAY)),
        ("whole", "f8", (WAY, WAY)),
    ],
    align=True,
)

ROOM_BYTES = ROOM.itemsize


def rim_room(terms: np.ndarray) -> np.ndarray:
    """Pool entry of a flexible rim with these shapes, rows as in `multibody.ring_modes.ring_terms`."""
    head = np.zeros(1, ROOM)
    head["rows"], head["waves"] = len(terms), int(terms[:, 1].max())
    return np.concatenate([head.view("f8"), np.ravel(terms)])


@kernel
def hidden(b, g):
    """Hidden body of the modal coordinates of group g."""
    if g == 0:
        return b["h1"]
    if g == 1:
        return b["h2"]
    if g == 2:
        return b["h3"]
    if g == 3:
        return b["h4"]
    if g == 4:
        return b["h5"]
    if g == 5:
        return b["h6"]
    if g == 6:
        return b["h7"]
    if g == 7:
        return b["h8"]
    return b["h9"] if g == 8 else b["h10"]


@kernel
def _put(x, first, a):
    x[first] = a[0]
    x[first + 1] = a[1]
    x[first + 2] = a[2]


@kernel
def _body_axes(f):
    """Axes x, y, z of a body that rotate with its spin."""
    R = f["R"]
    c = math.cos(f["phi"])
    s = math.sin(f["phi"])
    x = column(R, 0)
    y = column(R, 1)
    return add(times(c, x), times(s, y)), add(times(-s, x), times(c, y)), column(R, 2)


@kernel
def _place(b, w, f, g):
    """Angle of gear 1 on the rim, its gradient, and the polar axes there; returns cosine and sine."""
    x, y, z = _body_axes(g)
    arm = times(b["zc1"], column(f["R"], 2))
    line = (
        f["r"][0] + arm[0] - g["r"][0],
        f["r"][1] + arm[1] - g["r"][1],
        f["r"][2] + arm[2] - g["r"][2],
    )
    p = dot(x, line)
    q = dot(y, line)
    reach = math.sqrt(p * p + q * q)
    c = p / reach
    s = q / reach
    out = add(times(c, x), times(s, y))
    along = add(times(-s, x), times(c, y))
    _put(w["arm"], 0, arm)
    _put(w["line"], 0, line)
    _put(w["out"], 0, out)
    _put(w["along"], 0, along)
    w["reach"] = reach
    per = times(1.0 / reach, along)
    _put(w["turn"], 0, per)
    _put(w["turn"], 3, cross(arm, per))
    _put(w["turn"], 6, times(-1.0, per))
    _put(w["turn"], 9, times(-1.0, cross(line, per)))
    rate = 0.0
    for r in range(6):
        rate += w["turn"][r] * f["tw"][r] + w["turn"][6 + r] * g["tw"][r]
    w["theta_rate"] = rate
    return c, s


@kernel
def _shapes(b, w, terms, c, s):
    """Shapes and their derivatives by theta, in polar axes."""
    w["cosine"][0] = 1.0
    w["sine"][0] = 0.0
    for n in range(1, w["waves"] + 1):
        w["cosine"][n] = c * w["cosine"][n - 1] - s * w["sine"][n - 1]
        w["sine"][n] = s * w["cosine"][n - 1] + c * w["sine"][n - 1]
    shape = w["shape"]
    for d in range(3):
        for k in range(b["n_rim"]):
            for r in range(6):
                shape[d, k, r] = 0.0
    for row in range(w["rows"]):
        k = int(terms[row, 0])
        n = int(terms[row, 1])
        r = int(terms[row, 2])
        value = terms[row, 3] * w["cosine"][n] + terms[row, 4] * w["sine"][n]
        shape[0, k, r] += value
        shape[1, k, r] += n * (terms[row, 4] * w["cosine"][n] - terms[row, 3] * w["sine"][n])
        shape[2, k, r] -= n * n * value


@kernel
def _into_world(b, w, axis):
    """Turn the shapes into world axes; the polar axes rotate with theta."""
    shape = w["shape"]
    out = triple(w["out"], 0)
    along = triple(w["along"], 0)
    for k in range(b["n_rim"]):
        for first in (0, 3):
            a = triple(shape[0, k], first)
            d = triple(shape[1, k], first)
            e = triple(shape[2, k], first)
            d1 = (d[0] - a[1], d[1] + a[0], d[2])
            d2 = (e[0] - 2.0 * d[1] - a[0], e[1] + 2.0 * d[0] - a[1], e[2])
            _put(shape[0, k], first, add(add(times(a[0], out), times(a[1], along)), times(a[2], axis)))
            _put(shape[1, k], first, add(add(times(d1[0], out), times(d1[1], along)), times(d1[2], axis)))
            _put(shape[2, k], first, add(add(times(d2[0], out), times(d2[1], along)), times(d2[2], axis)))


@kernel
def _sums(b, w, fr):
    """Read the coordinates and sum the shapes."""
    for k in range(b["n_rim"]):
        h = fr[hidden(b, k // GROUP)]
        w["eta"][0, k] = h["r"][k % GROUP]
        w["eta"][1, k] = h["tw"][k % GROUP]
    for r in range(6):
        for d in range(3):
            s = 0.0
            v = 0.0
            for k in range(b["n_rim"]):
                s += w["shape"][d, k, r] * w["eta"][0, k]
                v += w["shape"][d, k, r] * w["eta"][1, k]
            w["sum"][d, r] = s
            if d < 2:
                w["flow"][d, r] = v


@kernel
def _tooth_frame(w, g):
    """Move the frame of gear 2 to that of its teeth."""
    a = triple(w["sum"][0], 0)
    c = triple(w["sum"][0], 3)
    rate = w["theta_rate"]
    v = add(cross(angular_velocity(g), a), plus(triple(w["flow"][0], 0), rate, triple(w["sum"][1], 0)))
    o = plus(triple(w["flow"][0], 3), rate, triple(w["sum"][1], 3))
    t = math.sqrt(dot(c, c))
    sine = math.sin(t) / t if t > 1e-9 else 1.0
    cosine = 2.0 * (math.sin(0.5 * t) / t) ** 2 if t > 1e-9 else 0.5
    for k in range(3):
        x = column(g["R"], k)
        one = cross(c, x)
        x = add(x, add(times(sine, one), times(cosine, cross(c, one))))
        for r in range(3):
            g["R"][r, k] = x[r]
    for r in range(6):
        w["tw"][r] = g["tw"][r]
    for r in range(3):
        g["r"][r] += a[r]
        g["tw"][r] += v[r]
        g["tw"][3 + r] += o[r]


@kernel
def bend_rim(here, at, _):
    """Move the frame of gear 2 of a mesh to that of its teeth."""
    b = view(here, 1, RECORD)[0]
    ctl = view(at, 1, CTL)[0]
    where = pooled(b, b["rim"])
    w = view(where, 1, ROOM)[0]
    own = view(b["request"]["fr"], 2, FRAME)
    terms = view(where + ROOM_BYTES, (w["rows"], 5), F8)
    c, s = _place(b, w, own[0], own[1])
    _shapes(b, w, terms, c, s)
    _into_world(b, w, column(own[1]["R"], 2))
    _sums(b, w, view(ctl["fr"], ctl["nb"], FRAME))
    _way(b, w)
    _tooth_frame(w, own[1])
    return OK


@kernel
def _way(b, w):
    """Set the motion of the frame of the teeth by those of both bodies and by the coordinates."""
    way = w["way"]
    for r in range(6):
        slope = w["sum"][1, r]
        for c in range(12):
            way[r, c] = slope * w["turn"][c]
        way[r, 6 + r] += 1.0
        for k in range(b["n_rim"]):
            way[r, 12 + k] = w["shape"][0, k, r]
    a = triple(w["sum"][0], 0)
    for c in range(3):  # rotation of body j about axis c moves the frame by unit(c) x a
        i = (c + 1) % 3
        k = (c + 2) % 3
        way[i, 9 + c] -= a[k]
        way[k, 9 + c] += a[i]


@kernel
def _right(w, kk, ways):
    """Set `half` from tangents `kk` of both frames: their forces by the motions of bodies and coordinates."""
    way = w["way"]
    for side in range(2):
        for r in range(6):
            for c in range(ways):
                s = kk[2 * side, r, c] if c < 6 else 0.0
                for h in range(6):
                    s += kk[2 * side + 1, r, h] * way[h, c]
                w["half"][6 * side + r, c] = s


@kernel
def _left(w, ways):
    """Set `whole` from `half`: forces on bodies and coordinates."""
    way = w["way"]
    half = w["half"]
    for r in range(ways):
        for c in range(ways):
            s = half[r, c] if r < 6 else 0.0
            for h in range(6):
                s += way[h, r] * half[6 + h, c]
            w["whole"][r, c] = s


@kernel
def _change(w, c, order, first):
    """Change of a sum (a or c and derivatives, world axes) by motion c of bodies or coordinates."""
    if c >= 12:
        return triple(w["shape"][order, c - 12], first)
    x = times(w["turn"][c], triple(w["sum"][order + 1], first))
    if c >= 9:
        x = add(x, cross(unit(c - 9), triple(w["sum"][order], first)))
    return x


@kernel
def _change_of_shape(w, c, k, first):
    """Change of the shape of coordinate k, likewise."""
    x = times(w["turn"][c], triple(w["shape"][1, k], first))
    if c >= 9:
        x = add(x, cross(unit(c - 9), triple(w["shape"][0, k], first)))
    return x


@kernel
def _change_of_flow(w, c, first):
    """Change of the motion of the teeth by the rates of the coordinates and of theta, at constant rates."""
    rate = w["theta_rate"]
    x = times(rate, _change(w, c, 1, first))
    if c < 12:
        x = add(x, times(w["turn"][c], triple(w["flow"][1], first)))
    if c >= 9 and c < 12:
        x = add(x, cross(unit(c - 9), triple(w["flow"][0], first)))
    return x


@kernel
def _turn_gradient(w, c):
    """Set the change of the gradient of theta by motion c of the bodies."""
    for r in range(12):
        w["d_turn"][r] = 0.0
    if c >= 12:
        return
    arm = triple(w["arm"], 0)
    line = triple(w["line"], 0)
    out = triple(w["out"], 0)
    along = triple(w["along"], 0)
    d_arm = cross(unit(c - 3), arm) if c < 6 else (0.0, 0.0, 0.0)
    d_line = add(unit(c), d_arm) if c < 6 else times(-1.0, unit(c - 6))
    spin = unit(c - 9) if c >= 9 else (0.0, 0.0, 0.0)
    d_along = add(times(-w["turn"][c], out), cross(spin, along))
    d_reach = dot(out, d_line) + dot(cross(spin, out), line)
    per = 1.0 / w["reach"]
    d_per = times(per, plus(d_along, -d_reach * per, along))
    _put(w["d_turn"], 0, d_per)
    _put(w["d_turn"], 3, add(cross(d_arm, times(per, along)), cross(arm, d_per)))
    _put(w["d_turn"], 6, times(-1.0, d_per))
    _put(w["d_turn"], 9, times(-1.0, add(cross(d_line, times(per, along)), cross(line, d_per))))


@kernel
def _follow(b, w, f, dk, ck, ways):
    """Add to `half` the forces by the change of velocities at constant rates of bodies and coordinates."""
    spin = triple(w["tw"], 3)
    for c in range(ways):
        _turn_gradient(w, c)
        rate = 0.0
        for r in range(6):
            rate += w["d_turn"][r] * f["tw"][r] + w["d_turn"][6 + r] * w["tw"][r]
        v = add(cross(spin, _change(w, c, 0, 0)), _change_of_flow(w, c, 0))
        v = plus(v, rate, triple(w["sum"][1], 0))
        o = plus(_change_of_flow(w, c, 3), rate, triple(w["sum"][1], 3))
        for side in range(2):
            for r in range(6):
                s = 0.0
                for h in range(3):
                    s += dk[2 * side + 1, r, h] * v[h] + dk[2 * side + 1, r, 3 + h] * o[h]
                w["half"][6 * side + r, c] += ck * s


@kernel
def _follow_forces(b, w, F, ck, ways):
    """Add to `whole` the change of the directions of the wrench F on the teeth."""
    force = triple(F, 0)
    moment = triple(F, 3)
    whole = w["whole"]
    torque = dot(triple(w["sum"][1], 0), force) + dot(triple(w["sum"][1], 3), moment)
    for c in range(ways):
        _turn_gradient(w, c)
        change = dot(_change(w, c, 1, 0), force) + dot(_change(w, c, 1, 3), moment)
        for r in range(12):
            whole[r, c] -= ck * (w["d_turn"][r] * torque + w["turn"][r] * change)
        lift = cross(_change(w, c, 0, 0), force)
        for r in range(3):
            whole[9 + r, c] -= ck * lift[r]
        if c < 12:
            for k in range(b["n_rim"]):
                by = dot(_change_of_shape(w, c, k, 0), force) + dot(_change_of_shape(w, c, k, 3), moment)
                whole[12 + k, c] -= ck * by


@kernel
def _back(w, kk):
    """Replace the tangents of both frames by those of the bodies."""
    for side in range(2):
        for other in range(2):
            for r in range(6):
                for c in range(6):
                    kk[2 * side + other, r, c] = w["whole"][6 * side + r, 6 * other + c]


@kernel
def _spread(b, w, kk, arms):
    """Add the tangents of the coordinates; `arms`: from the bodies to the gears, if eccentric."""
    whole = w["whole"]
    n = b["n_rim"]
    pairs = b["pairs"]
    for k in range(n):
        x = 2 + k // GROUP
        r = k % GROUP
        for h in range(n):
            kk[pairs[x, 2 + h // GROUP], r, h % GROUP] += whole[12 + k, 12 + h]
        for side in range(2):
            arm = triple(arms[side], 0)
            rows = kk[pairs[side, x]]
            columns = kk[pairs[x, side]]
            first = 6 * side
            up = (whole[first, 12 + k], whole[first + 1, 12 + k], whole[first + 2, 12 + k])
            across = (whole[12 + k, first], whole[12 + k, first + 1], whole[12 + k, first + 2])
            up_turn = cross(arm, up)
            across_turn = cross(arm, across)
            for c in range(3):
                rows[c, r] += up[c]
                rows[3 + c, r] += whole[first + 3 + c, 12 + k] + up_turn[c]
                columns[r, c] += across[c]
                columns[r, 3 + c] += whole[12 + k, first + 3 + c] + across_turn[c]


@kernel
def _swing(b, w, own, arms, kk, ck):
    """Add the change of the velocities of eccentric gears to the tangents of the coordinates."""
    for k in range(b["n_rim"]):
        for side in range(2):
            block = kk[b["pairs"][2 + k // GROUP, side]]
            for c in range(3):
                moved = swing_rate(own, arms, side, c)
                s = 0.0
                for h in range(3):
                    s += w["whole"][12 + k, 6 * side + h] * moved[h]
                block[k % GROUP, 3 + c] += ck * s


@kernel
def release_rim(here, at, _):
    """Bring wrenches and tangents of the teeth to the frames of both gears and to the coordinates."""
    b = view(here, 1, RECORD)[0]
    ctl = view(at, 1, CTL)[0]
    w = view(pooled(b, b["rim"]), 1, ROOM)[0]
    own = view(b["request"]["fr"], 2, FRAME)
    fr = view(ctl["fr"], ctl["nb"], FRAME)
    ways = 12 + b["n_rim"]
    F = own[1]["F"]
    for r in range(6):
        own[1]["tw"][r] = w["tw"][r]
    if ctl["jac"] != 0:
        kk = tangent_blocks(b)
        exact = ctl["jac"] == 2 and ctl["ck"] != 0.0
        _right(w, kk, ways)
        if exact:
            dk = damping_blocks(b)
            _follow(b, w, own[0], dk, ctl["ck"], ways)
        _left(w, ways)
        if exact:
            _follow_forces(b, w, F, ctl["ck"], ways)
        arms = arms_of(b)
        blocks = view(ctl["kk"], (ctl["np"], 6, 6), F8)
        _spread(b, w, blocks, arms)
        _back(w, kk)
        if exact:
            _right(w, dk, ways)
            _left(w, ways)
            _swing(b, w, own, arms, blocks, ctl["ck"])
            _back(w, dk)
    for c in range(ways):
        s = 0.0
        for h in range(6):
            s += w["way"][h, c] * F[h]
        if c < 6:
            own[0]["F"][c] += s
        elif c >= 12:
            fr[hidden(b, (c - 12) // GROUP)]["F"][(c - 12) % GROUP] += s
        w["half"][0, c] = s
    for r in range(6):
        F[r] = w["half"][0, 6 + r]
    return OK
