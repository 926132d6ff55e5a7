# SPDX-License-Identifier: Apache-2.0
"""Contact nodes of one flank of a cylindrical mesh: levers and rates; flank with prescribed total stiffness.

`mesh.tooth_pairs` defines the nodes of single tooth pairs; `mesh.sums.add_node` applies the flank law to a
node. The normal force at (z, xi) has the moment y tau about the pitch point, y = z + f tan(beta_b) xi: axial
force times path and transverse force times width act about the same axis tau = m x n_f. Penetration and its
rate therefore depend on y as well.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.mesh.sums import add_node

GAUSS = math.sqrt(0.6)
"""Abscissa of the outer points of the three-point Gauss rule on [-1, 1]."""


@kernel
def set_levers(b, z, xi):
    """Set the levers of a node at the width z and the path position xi, from the pitch point [m]."""
    lever = b["lever"]
    lever[0] = 1.0
    lever[1] = z + b["now"]["flank"] * b["tan_b"] * xi
    lever[2] = 1.0
    lever[3] = z
    lever[4] = xi


@kernel
def width_rate(b, z):
    """Rate of a point at a constant fraction of the common width, relative to the pitch point."""
    now = b["now"]
    return now["lo_rate"] + (z - now["z_lo"]) * (now["hi_rate"] - now["lo_rate"]) / (
        now["z_hi"] - now["z_lo"]
    )


@kernel
def drift(b, z):
    """Rate of that point relative to the motion to which the normal force is conjugate."""
    return width_rate(b, z) - b["w_z"] * b["now"]["dz_rate"]


@kernel
def line_rate(b, z):
    """Rate of the path position of the contact lines [base pitches/s] at a point of the common width."""
    now = b["now"]
    return now["phase_rate"][0 if now["flank"] > 0 else 1] + now["lam"] * width_rate(b, z)


@kernel
def nearer(start, end, stop):
    """`stop` if it is between `start` and `end`, else `end`."""
    if stop > start and stop < end:
        return stop
    return end


@kernel
def phase_flank(b, watch, x_0, ratio, rate):
    """Sum a prescribed total stiffness, uniform over the common face width, acting at the pitch point.

    `ratio`: stiffness over its mean; `rate`: time derivative of that ratio [1/s].
    """
    now = b["now"]
    k = b["c_prime"] * ratio
    k_rate = b["c_prime"] * rate
    lo = now["z_lo"]
    hi = now["z_hi"]
    if now["tilt"] == 0.0 and b["fixed"] == 1:
        _middle_node(b, watch, x_0, k, k_rate)
        return
    if b["slices"] == 0 and now["tilt"] == 0.0 and b["rate"][1] == 0.0 and b["contact"]["mu"] == 0.0:
        # parallel axes: uniform force over the width, with the second moment of its length
        _middle_node(b, watch, x_0, k, k_rate)
        tangent = b["sums"]["tangent"]
        tangent[1, 1] += tangent[0, 0] * (hi - lo) * (hi - lo) / 12.0
        return
    if b["slices"] > 0:
        step = (hi - lo) / b["slices"]
        part = 1.0 / b["slices"]
        for s in range(b["slices"]):
            z = lo + (s + 0.5) * step
            _phase_node(b, watch, x_0, z, k * part, k_rate * part)
        return
    stop = hi
    if now["tilt"] != 0.0:
        stop = nearer(lo, hi, x_0 / now["tilt"])
    a = lo
    while a < hi:
        c = stop if a < stop else hi
        z = 0.5 * (a + c)
        half = 0.5 * (c - a)
        for s in range(3):
            y = z + (s - 1) * GAUSS * half
            part = half * ((8.0 / 9.0) if s == 1 else (5.0 / 9.0)) / (hi - lo)
            _phase_node(b, watch, x_0, y, k * part, k_rate * part)
        a = c


@kernel
def _middle_node(b, watch, x, k, k_rate):
    """Add one node of a prescribed stiffness for the whole width."""
    now = b["now"]
    set_levers(b, 0.5 * (now["z_lo"] + now["z_hi"]), 0.0)
    add_node(b, watch, x, k, 0.0, (k_rate, 0.0, now["growth"]), None, 1.0)


@kernel
def _phase_node(b, watch, x_0, z, k, k_rate):
    """Add one node of a prescribed stiffness, at the width z and at the pitch point."""
    now = b["now"]
    x_rate = -now["kappa"] * drift(b, z) if watch is not None else 0.0
    set_levers(b, z, 0.0)
    add_node(b, watch, x_0 - now["tilt"] * z, k, 0.0, (k_rate, x_rate, now["growth"]), None, 1.0)
