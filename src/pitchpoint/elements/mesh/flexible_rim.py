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

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.mesh.eccentricity import arms_of, damping_blocks, tangent_blocks
from pitchpoint.elements.mesh.line_of_action import pooled
from pitchpoint.elements.mesh.record import RECORD
from pitchpoint.elements.mesh.rim_tangents import (
    follow_forces,
    follow_rates,
    left_tangents,
    right_tangents,
    swing_coordinates,
    to_bodies,
    to_coordinates,
)
from pitchpoint.elements.mesh.rim_workspace import GROUP, WORKSPACE, WORKSPACE_BYTES, hidden, put3
from pitchpoint.elements.wrench import angular_velocity
from pitchpoint.multibody.channels import CTL, F8, FRAME
from pitchpoint.multibody.vectors import add, column, cross, dot, plus, times, triple


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
    put3(w["arm"], 0, arm)
    put3(w["line"], 0, line)
    put3(w["out"], 0, out)
    put3(w["along"], 0, along)
    w["reach"] = reach
    per = times(1.0 / reach, along)
    put3(w["turn"], 0, per)
    put3(w["turn"], 3, cross(arm, per))
    put3(w["turn"], 6, times(-1.0, per))
    put3(w["turn"], 9, times(-1.0, cross(line, per)))
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
            put3(shape[0, k], first, add(add(times(a[0], out), times(a[1], along)), times(a[2], axis)))
            put3(shape[1, k], first, add(add(times(d1[0], out), times(d1[1], along)), times(d1[2], axis)))
            put3(shape[2, k], first, add(add(times(d2[0], out), times(d2[1], along)), times(d2[2], axis)))


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
    w = view(where, 1, WORKSPACE)[0]
    own = view(b["request"]["fr"], 2, FRAME)
    terms = view(where + WORKSPACE_BYTES, (w["rows"], 5), F8)
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
def release_rim(here, at, _):
    """Bring wrenches and tangents of the teeth to the frames of both gears and to the coordinates."""
    b = view(here, 1, RECORD)[0]
    ctl = view(at, 1, CTL)[0]
    w = view(pooled(b, b["rim"]), 1, WORKSPACE)[0]
    own = view(b["request"]["fr"], 2, FRAME)
    fr = view(ctl["fr"], ctl["nb"], FRAME)
    ways = 12 + b["n_rim"]
    F = own[1]["F"]
    for r in range(6):
        own[1]["tw"][r] = w["tw"][r]
    if ctl["jac"] != 0:
        kk = tangent_blocks(b)
        exact = ctl["jac"] == 2 and ctl["ck"] != 0.0
        right_tangents(w, kk, ways)
        if exact:
            dk = damping_blocks(b)
            follow_rates(b, w, own[0], dk, ctl["ck"], ways)
        left_tangents(w, ways)
        if exact:
            follow_forces(b, w, F, ctl["ck"], ways)
        arms = arms_of(b)
        blocks = view(ctl["kk"], (ctl["np"], 6, 6), F8)
        to_coordinates(b, w, blocks, arms)
        to_bodies(w, kk)
        if exact:
            right_tangents(w, dk, ways)
            left_tangents(w, ways)
            swing_coordinates(b, w, own, arms, blocks, ctl["ck"])
            to_bodies(w, dk)
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
