# SPDX-License-Identifier: Apache-2.0
"""Exact tangents of a bevel mesh: derivative of the force directions by the plane of action.

As in `mesh.exact_tangent` for cylindrical gears: the basis rows are closed-form functions of the frames and
are differentiated by a fourth-order difference quotient. Mesh phase and contact lines are constant.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.mesh.bevel.plane_of_action import axes_of_action, normal_rows
from pitchpoint.elements.mesh.bevel.record import RECORD
from pitchpoint.elements.mesh.sums import requested_arrays
from pitchpoint.multibody.vectors import column, cross, triple, unit

STEP = 2e-4
"""Step of the difference quotient: rotation [rad], or translation over the mean cone distance."""


@kernel
def _sample(b, f, g, body, motion, h, flank):
    """Set the basis rows for one body displaced by h along a world axis, or rotated by h about one."""
    at = triple(body["r"], 0)
    axis = column(body["R"], 2)
    turned = cross(unit(motion - 3), axis)
    for k in range(3):
        body["r"][k] = at[k] + h * unit(motion)[k]
        body["R"][k, 2] = axis[k] + h * turned[k]
    axes_of_action(b, f, g)
    normal_rows(b, flank)
    for k in range(3):
        body["r"][k] = at[k]
        body["R"][k, 2] = axis[k]


@kernel
def _change(b, f, g, side, motion, flank):
    """Write the derivative of the rows by one motion of body `side` to the scratch `moved`."""
    now = b["now"]
    h = STEP * b["R_m"] if motion < 3 else STEP
    for row in range(3):
        for k in range(12):
            now["moved"][row, k] = 0.0
    for step in (-2, -1, 1, 2):
        weight = (2.0 / 3.0 if abs(step) == 1 else -1.0 / 6.0) / (step * h)
        _sample(b, f, g, f if side == 0 else g, motion, step * h, flank)
        for row in range(3):
            for k in range(6):
                now["moved"][row, k] += weight * b["basis_i"][row, k]
                now["moved"][row, 6 + k] += weight * b["basis_j"][row, k]


@kernel
def _turn_of_forces(b, f, g, kk, ck, flank):
    """Add the forces along the changed rows; write the change of the row rates to the scratch `slope`."""
    now = b["now"]
    rows = 1 if flank == 0 else 3
    for motion in range(12):
        side = motion // 6
        _change(b, f, g, side, motion % 6, flank)
        for row in range(rows):
            s = 0.0
            for k in range(6):
                one = now["moved"][row, k]
                two = now["moved"][row, 6 + k]
                kk[b["request"]["ii"] if side == 0 else b["request"]["ij"], k, motion % 6] -= (
                    ck * b["sums"]["force"][row] * one
                )
                kk[b["request"]["ji"] if side == 0 else b["request"]["jj"], k, motion % 6] -= (
                    ck * b["sums"]["force"][row] * two
                )
                s -= one * f["tw"][k] + two * g["tw"][k]
            now["slope"][row, motion] = s


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
    _turn_of_forces(b, f, g, kk, ck, flank)
    axes_of_action(b, f, g)
    normal_rows(b, flank)
    rows = 1 if flank == 0 else 3
    for motion in range(12):
        side = motion // 6
        for row in range(rows):
            s = 0.0
            for q in range(rows):
                s += b["sums"]["tangent"][row, q] * b["now"]["slope"][q, motion]
            for k in range(6):
                kk[b["request"]["ii"] if side == 0 else b["request"]["ij"], k, motion % 6] -= (
                    ck * s * b["basis_i"][row, k]
                )
                kk[b["request"]["ji"] if side == 0 else b["request"]["jj"], k, motion % 6] -= (
                    ck * s * b["basis_j"][row, k]
                )
    return OK
