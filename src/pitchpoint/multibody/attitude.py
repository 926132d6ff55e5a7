# SPDX-License-Identifier: Apache-2.0
"""Attitude of a tumbling body as a quaternion, independent of its chart."""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel


@kernel
def attitude(C, alpha, beta, spin, out, at):
    """Write the quaternion (x, y, z, w), w >= 0, of C Rx(alpha) Ry(beta) Rz(spin) to out[at : at + 4].

    C is the chart, a rotation matrix; the three rotations are intrinsic (about the rotated axes).
    """
    # the largest of the four components avoids cancellation
    trace = C[0, 0] + C[1, 1] + C[2, 2]
    if trace > 0.0:
        s = 2.0 * math.sqrt(1.0 + trace)
        w = 0.25 * s
        x = (C[2, 1] - C[1, 2]) / s
        y = (C[0, 2] - C[2, 0]) / s
        z = (C[1, 0] - C[0, 1]) / s
    elif C[0, 0] >= C[1, 1] and C[0, 0] >= C[2, 2]:
        s = 2.0 * math.sqrt(1.0 + C[0, 0] - C[1, 1] - C[2, 2])
        w = (C[2, 1] - C[1, 2]) / s
        x = 0.25 * s
        y = (C[0, 1] + C[1, 0]) / s
        z = (C[0, 2] + C[2, 0]) / s
    elif C[1, 1] >= C[2, 2]:
        s = 2.0 * math.sqrt(1.0 - C[0, 0] + C[1, 1] - C[2, 2])
        w = (C[0, 2] - C[2, 0]) / s
        x = (C[0, 1] + C[1, 0]) / s
        y = 0.25 * s
        z = (C[1, 2] + C[2, 1]) / s
    else:
        s = 2.0 * math.sqrt(1.0 - C[0, 0] - C[1, 1] + C[2, 2])
        w = (C[1, 0] - C[0, 1]) / s
        x = (C[0, 2] + C[2, 0]) / s
        y = (C[1, 2] + C[2, 1]) / s
        z = 0.25 * s
    c = math.cos(0.5 * alpha)
    s = math.sin(0.5 * alpha)
    x, y, z, w = x * c + w * s, y * c + z * s, z * c - y * s, w * c - x * s
    c = math.cos(0.5 * beta)
    s = math.sin(0.5 * beta)
    x, y, z, w = x * c - z * s, y * c + w * s, z * c + x * s, w * c - y * s
    c = math.cos(0.5 * spin)
    s = math.sin(0.5 * spin)
    x, y, z, w = x * c + y * s, y * c - x * s, z * c + w * s, w * c - z * s
    # q and -q are the same attitude
    sign = -1.0 if w < 0.0 else 1.0
    out[at] = sign * x
    out[at + 1] = sign * y
    out[at + 2] = sign * z
    out[at + 3] = sign * w
