# SPDX-License-Identifier: Apache-2.0
"""Exact tangents of a mesh: derivative of the force directions by the line of action.

The tangent of `mesh.sums` holds the line of action constant. Motion of the bodies also rotates the force
directions (terms of the order force over centre distance) and, at speed, the directions of the damper rates
(damping times speed): without them dampers would appear to destabilise a gear. Mesh phase, contact lines and
shared width are constant (docs/decisions/0006-frozen-phase-tangents.md).

The directions are closed-form functions of the frames; a fourth-order difference quotient gives their
derivative with a relative error of 1e-11.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.mesh.force_directions import normal_directions, offset_direction, travel_direction
from pitchpoint.elements.mesh.line_of_action import line_of_action
from pitchpoint.elements.mesh.record import RECORD
from pitchpoint.elements.mesh.sums import requested_arrays

STEP = 2e-4
"""Step of the difference quotient: rotation [rad], or translation over centre distance."""


@kernel
def _directions(b, f, g, flank):
    """Set rows 0 and 1 of the wrench basis of a flank, or row 0 for the damper (`flank` 0)."""
    line_of_action(b, f, g)
    if flank == 0:
        travel_direction(b, f, g)
    else:
        normal_directions(b, f, g, flank)


@kernel
def _nudged(b, f, g, body, c, h, flank):
    """Set the directions for one body displaced by h along axis c, or rotated by h about axis c - 3."""
    r = body["r"]
    R = body["R"]
    if c < 3:
        kept = r[c]
        r[c] += h
        _directions(b, f, g, flank)
        r[c] = kept
        return
    i = (c - 2) % 3
    k = (c - 1) % 3
    y = R[i, 2]
    z = R[k, 2]
    R[i, 2] = y - h * z
    R[k, 2] = z + h * y
    _directions(b, f, g, flank)
    R[i, 2] = y
    R[k, 2] = z


@kernel
def _change(b, f, g, body, c, flank):
    """Write the derivative of the directions by the motion c of one body to the scratch `moved`."""
    now = b["now"]
    h = STEP * abs(now["a"]) if c < 3 else STEP
    moved = now["moved"]
    for p in range(2):
        for k in range(12):
            moved[p, k] = 0.0
    for step in (-2, -1, 1, 2):
        weight = (2.0 / 3.0 if abs(step) == 1 else -1.0 / 6.0) / (step * h)
        _nudged(b, f, g, body, c, step * h, flank)
        for p in range(2):
            for k in range(6):
                moved[p, k] += weight * b["basis_i"][p, k]
                moved[p, 6 + k] += weight * b["basis_j"][p, k]


@kernel
def _turn(b, f, g, body, side, ki, kj, ck, flank):
    """Add the rotation of the forces with the motions of one body; write the rate changes to `slope`."""
    now = b["now"]
    force = b["sums"]["force"]
    rows = 1 if flank == 0 else 2
    for c in range(6):
        _change(b, f, g, body, c, flank)
        for p in range(rows):
            s = 0.0
            for k in range(6):
                di = now["moved"][p, k]
                dj = now["moved"][p, 6 + k]
                ki[k, c] -= ck * force[p] * di
                kj[k, c] -= ck * force[p] * dj
                s -= di * f["tw"][k] + dj * g["tw"][k]
            now["slope"][p, 6 * side + c] = s


@kernel
def _brake(b, B, side, ki, kj, ck, flank):
    """Add damping forces for the rate changes, and the moment of the force shift along the face width."""
    now = b["now"]
    force = b["sums"]["force"]
    damping = b["sums"]["tangent"]
    Bi = b["basis_i"]
    Bj = b["basis_j"]
    for c in range(6):
        across = 0.0 if flank == 0 else b["w_z"] * B[2, c]
        at_point = now["slope"][0, 6 * side + c] + b["rate"][1] * across
        s = damping[0, 0] * at_point
        e = 0.0
        if flank != 0:
            per_lever = now["slope"][1, 6 * side + c]
            s += damping[0, 1] * per_lever
            e = damping[0, 1] * at_point + damping[1, 1] * per_lever + force[0] * across
        for k in range(6):
            ki[k, c] -= ck * (s * Bi[0, k] + e * Bi[1, k])
            kj[k, c] -= ck * (s * Bj[0, k] + e * Bj[1, k])


@kernel
def turning(record, flank, _):
    """Add ck times the derivative of the wrenches of one mesh by their directions.

    The sums hold the forces of the flank and, as tangents, its damping coefficients only [N s/m]. `flank` 0:
    mesh damper. Compiled only if exact tangents are requested.
    """
    b = view(record, 1, RECORD)[0]
    fr, kk = requested_arrays(b)
    ck = b["request"]["ck"]
    f = fr[b["request"]["i"]]
    g = fr[b["request"]["j"]]
    _turn(b, f, g, f, 0, kk[b["request"]["ii"]], kk[b["request"]["ji"]], ck, flank)
    _turn(b, f, g, g, 1, kk[b["request"]["ij"]], kk[b["request"]["jj"]], ck, flank)
    _directions(b, f, g, flank)
    if flank != 0:
        offset_direction(b, f, g)
    _brake(b, b["basis_i"], 0, kk[b["request"]["ii"]], kk[b["request"]["ji"]], ck, flank)
    _brake(b, b["basis_j"], 1, kk[b["request"]["ij"]], kk[b["request"]["jj"]], ck, flank)
    return OK
