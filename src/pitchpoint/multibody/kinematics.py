# SPDX-License-Identifier: Apache-2.0
"""Kinematics of round bodies on ground: positions, twists, accelerations and joint columns.

All other bodies are computed in `tree`.

With w1 the first reference axis, w2 the second axis after the rotation alpha, n the spin axis:
omega = alpha' w1 + beta' w2 + phi' n, and its derivative has the bias alpha' beta' w1 x w2
+ phi' (alpha' w1 + beta' w2) x n. J contains the columns of each joint at the body origin (6 x n):
d(twist)/d(rate) = d(acceleration)/d(second rate) = displacement twist per coordinate.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel
from pitchpoint.multibody.bodies import GENERAL
from pitchpoint.multibody.joints import FREE, PLANAR, TORSION


@kernel
def rest_pose(body, fr, J):
    """Write all constant values: reference poses, columns of torsional and translational coordinates."""
    for b in range(body.size):
        o = body[b]
        f = fr[b]
        for i in range(3):
            f["r"][i] = o["pos"][i]
            for c in range(3):
                f["R"][i, c] = o["axes"][i, c]
                f["S"][i, c] = o["axes"][i, c]
        for i in range(6):
            f["tw"][i] = 0.0
            f["ac"][i] = 0.0
            f["F"][i] = 0.0
        f["phi"] = 0.0
        f["spin"] = 0.0
        f["base"] = 0.0
        f["base_turns"] = 0
        p = o["path"]
        if p >= 0 and o["joint"] != GENERAL:
            for i in range(6):
                for c in range(6):
                    J[p, i, c] = 0.0
            shift = 0
            if o["joint"] == PLANAR:
                shift = 2
            elif o["joint"] == FREE:
                shift = 3
            for i in range(3):
                for c in range(shift):
                    J[p, i, c] = o["axes"][i, c]
                J[p, 3 + i, o["joint"] - 1] = o["axes"][i, 2]
            if o["joint"] == FREE:
                for i in range(3):
                    J[p, 3 + i, 3] = o["axes"][i, 0]


@kernel
def free_body(o, f, J, q, v, a):
    """Frame and moving joint columns of a body with six coordinates."""
    d = o["dof"]
    p = o["path"]
    ca = math.cos(q[d + 3])
    sa = math.sin(q[d + 3])
    cb = math.cos(q[d + 4])
    sb = math.sin(q[d + 4])
    va = v[d + 3]
    vb = v[d + 4]
    vs = v[d + 5]
    E = o["axes"]
    for i in range(3):
        e1 = E[i, 0]
        e2 = ca * E[i, 1] + sa * E[i, 2]  # w2
        e3 = ca * E[i, 2] - sa * E[i, 1]  # w1 x w2
        n = cb * e3 + sb * e1
        f["R"][i, 0] = cb * e1 - sb * e3
        f["R"][i, 1] = e2
        f["R"][i, 2] = n
        J[p, 3 + i, 4] = e2
        J[p, 3 + i, 5] = n
        f["r"][i] = o["pos"][i] + E[i, 0] * q[d] + E[i, 1] * q[d + 1] + E[i, 2] * q[d + 2]
        f["tw"][i] = E[i, 0] * v[d] + E[i, 1] * v[d + 1] + E[i, 2] * v[d + 2]
        f["ac"][i] = E[i, 0] * a[d] + E[i, 1] * a[d + 1] + E[i, 2] * a[d + 2]
        f["tw"][3 + i] = va * e1 + vb * e2 + vs * n
        # w1 x n = -cb w2, w2 x n = first frame axis
        bias = va * vb * e3 - vs * va * cb * e2 + vs * vb * (cb * e1 - sb * e3)
        f["ac"][3 + i] = a[d + 3] * e1 + a[d + 4] * e2 + a[d + 5] * n + bias
    f["phi"] = q[d + 5]
    f["spin"] = vs


@kernel(inline=True)
def kinematics(body, fr, J, q, v, a):
    """Frames, twists, accelerations and moving joint columns of all round bodies at (q, v, a)."""
    for b in range(1, body.size):
        o = body[b]
        f = fr[b]
        d = o["dof"]
        if o["joint"] == TORSION:
            for i in range(3):
                n = o["axes"][i, 2]
                f["tw"][3 + i] = n * v[d]
                f["ac"][3 + i] = n * a[d]
            f["phi"] = q[d]
            f["spin"] = v[d]
        elif o["joint"] == FREE:
            free_body(o, f, J, q, v, a)
        elif o["joint"] == PLANAR:
            for i in range(3):
                e1 = o["axes"][i, 0]
                e2 = o["axes"][i, 1]
                n = o["axes"][i, 2]
                f["r"][i] = o["pos"][i] + e1 * q[d] + e2 * q[d + 1]
                f["tw"][i] = e1 * v[d] + e2 * v[d + 1]
                f["ac"][i] = e1 * a[d] + e2 * a[d + 1]
                f["tw"][3 + i] = n * v[d + 2]
                f["ac"][3 + i] = n * a[d + 2]
            f["phi"] = q[d + 2]
            f["spin"] = v[d + 2]
