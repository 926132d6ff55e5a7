# SPDX-License-Identifier: Apache-2.0
"""Observations of a mesh of cylindrical gears, written from the sums of its flanks."""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.gear_mesh_record import N_OUT
from pitchpoint.elements.mesh_friction import add_friction_torques


@kernel
def clear(b, out):
    """Set all observations of a mesh to zero."""
    for k in range(N_OUT + b["n_pair"] + 2 * b["rubs"]):
        out[b["out"] + k] = 0.0


@kernel
def write_mesh(b, out, psi, damper, rate):
    """Observations that do not depend on the flank; sums were added by `write_flank`."""
    k = b["out"]
    out[k + 2] += damper
    out[k] = b["u"]
    out[k + 1] = b["u"] - b["e_t"]
    out[k + 4] = psi
    out[k + 11] += damper * rate
    out[k + 12] -= damper * b["e_rate"]
    out[k + 14] = (abs(b["u"] - b["e_t"]) - 0.5 * b["gap"]) / math.sqrt(1.0 + b["tan_b"] * b["tan_b"])


@kernel
def write_flank(b, out, flank):
    """Add one flank to the observations; forces of pairs are there already."""
    k = b["out"]
    acc = b["acc"]
    F = acc[0]
    out[k + 2] += flank * F
    out[k + 3] += acc[20]
    if F > 0.0:
        out[k + 5] = 2.0 if out[k + 5] == 1.0 else float(flank)
    out[k + 6] += F * math.sqrt(1.0 + b["tan_b"] * b["tan_b"])
    out[k + 7] += flank * F * b["cos_a"]
    out[k + 8] += F * b["sin_a"]
    out[k + 9] -= flank * F * b["tan_b"]
    out[k + 10] += acc[21]
    out[k + 11] += acc[22]
    out[k + 12] += acc[23] - flank * F * b["e_rate"]
    out[k + 13] += acc[24]


@kernel
def write_friction_torques(b, out, f, g):
    """Add the friction of one flank, rows 2 to 4 of the basis, where the mesh shows it."""
    if b["rubs"] == 1 and b["mu"] > 0.0:
        add_friction_torques(b, out, b["out"] + N_OUT + b["n_pair"], f, g, 2)
