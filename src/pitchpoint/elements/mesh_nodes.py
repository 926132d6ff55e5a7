# SPDX-License-Identifier: Apache-2.0
"""Forces of one flank as a sum over quadrature nodes: the law of one node, and a prescribed total stiffness.

The nodes of single tooth pairs are placed by `mesh_pairs`.

Where nothing is observed, `watch` is None and energy, powers and what events ask for are left out when the
kernels are compiled.

Sums go to the scratch field `acc` (see gear_mesh_record). The normal force at (z, xi) has the moment y tau
about the pitch point, y = z + f tan(beta_b) xi: axial force times path and transverse force times width turn
the gears about the same axis tau = m x n_f. Penetration and its rate therefore change with y too.
"""

from __future__ import annotations

import math

from pitchpoint.contact.damping import linear_ramp, ramp
from pitchpoint.contact.elastic import low_load, power_force, series_energy, series_overlap, stored_energy
from pitchpoint.contact.friction import static_dynamic
from pitchpoint.core.kernel import kernel
from pitchpoint.elements.gear_mesh_record import NEAREST, ROLL

GAUSS = math.sqrt(0.6)
"""Place of the outer ones of three Gauss points, from the middle to the ends of a piece."""


@kernel
def node(b, ctl, watch, x, x_rate, place, k, k_rate, limit, apart):
    """Add one node and return its normal force [N].

    `x` penetration [m] at the place (z, xi) [m], `k` stiffness [N/m^power], changing at `x_rate` [m/s] and
    `k_rate` per second where no force pushes: with the phase; `limit` force below which the pair softens [N].
    `apart`: None on nominal flanks; else the rate of the penetration where the contact runs over separated
    flanks [m/s], which damps like that of the bodies, its slope over xi, a compliance in series [m/N] and its
    rate. Contact damping acts on the overlap of the contact alone, u of x, and on its rate.
    """
    acc = b["acc"]
    if x <= 0.0 or k <= 0.0:
        if watch is not None and k > 0.0:
            acc[NEAREST] = max(acc[NEAREST], x)
        return 0.0
    z, xi = place
    rate = b["rate"]
    y = z + b["flank"] * b["tan_b"] * xi
    w = rate[0] + rate[1] * y
    u = x
    own = 1.0  # du/dx, which changes at `bent` over x
    bent = 0.0
    if apart is not None:
        w += apart[0]
        if apart[2] > 0.0:
            u = series_overlap(x, k, b["power"], apart[2])
    f, kt = power_force(u, k, b["power"])
    if apart is not None and apart[2] > 0.0:
        own = 1.0 / (1.0 + apart[2] * kt)
        bent = (1.0 - b["power"]) * kt / u * apart[2] * own * own * own
        kt *= own
    secant = f / x
    if limit > 0.0:
        force, tangent = low_load(f, limit)
        f *= force
        kt *= tangent
    elastic = f
    stiffness = kt
    d = (b["d_in"] if w > 0.0 else b["d_out"]) * k / b["k_ref"]
    if b["chi"] > 0.0:
        d = b["chi"] * f
        f += d * w * own
        kt *= 1.0 + b["chi"] * w * own
    elif d > 0.0:
        share, slope = ramp(u, b["s_0"]) if b["smooth"] == 1 else linear_ramp(u, b["s_0"])
        full = d
        d *= share
        f += d * w * own
        kt += full * w * slope * own * own
    if apart is not None:
        kt += d * w * bent
        d *= own
    if watch is not None:
        acc[NEAREST] = max(acc[NEAREST], f / secant)
    # a flank that would have to pull lets go, and the work of its elastic force is lost
    f = max(f, 0.0)
    if watch is not None:
        if apart is None:
            energy, feed = stored_energy(x, k, b["power"], limit)
            acc[23] += feed * k_rate + elastic * x_rate + energy * b["growth"]
        else:
            energy, feed, fall = series_energy(x, u, k, b["power"], apart[2], limit)
            acc[23] += feed * k_rate + fall * apart[3] + elastic * x_rate + energy * b["growth"]
            acc[23] += f * apart[0]
        acc[22] += (f - elastic) * w
        acc[24] += energy
        if f > 0.0:
            acc[20] += stiffness
    if f == 0.0:
        return 0.0
    acc[0] += f
    acc[1] += f * y
    c = ctl["ck"] * kt + ctl["cd"] * d
    if ctl["jac"] != 0:
        acc[5] += c
        acc[6] += c * y
        acc[7] += c * y * y
    c_roll = 0.0
    if apart is not None:
        c_roll = ctl["cd"] * d * apart[1]
        acc[ROLL] += c_roll
        acc[ROLL + 1] += c_roll * y
    if b["mu"] > 0.0:
        _friction(b, ctl, watch, f, c, c_roll, y, z, xi)
    return f


@kernel
def _friction(b, ctl, watch, f, c, c_roll, y, z, xi):
    """Friction of a node with normal force `f`, against its local sliding.

    `c` normal tangent, `c_roll` that over the rate of the path position.
    """
    acc = b["acc"]
    rate = b["rate"]
    v = rate[2] + rate[3] * z + rate[4] * xi
    s, ds = static_dynamic(v, b["mu_s"], b["mu"], b["v_s"], b["v_eps"])
    mu = math.sqrt(1.0 + b["tan_b"] * b["tan_b"])  # per force normal to the flanks
    q = mu * f * s
    acc[2] += q
    acc[3] += q * z
    acc[4] += q * xi
    if watch is not None:
        acc[21] += q * v
    if ctl["jac"] != 0:
        p = mu * s * c
        acc[8] += p
        acc[9] += p * y
        acc[10] += p * z
        acc[11] += p * z * y
        acc[12] += p * xi
        acc[13] += p * xi * y
        p = mu * s * c_roll
        acc[ROLL + 2] += p
        acc[ROLL + 3] += p * z
        acc[ROLL + 4] += p * xi
        p = mu * f * ds * ctl["cd"]
        acc[14] += p
        acc[15] += p * z
        acc[16] += p * xi
        acc[17] += p * z * z
        acc[18] += p * z * xi
        acc[19] += p * xi * xi


@kernel
def width_rate(b, z):
    """Rate of a place on the shared width, seen from the pitch point: places keep their share of it."""
    share = (z - b["z_lo"]) / (b["z_hi"] - b["z_lo"])
    return b["lo_rate"] + share * (b["hi_rate"] - b["lo_rate"])


@kernel
def drift(b, z):
    """Rate of that place over the one the normal force is conjugate to."""
    return width_rate(b, z) - b["w_z"] * b["dz_rate"]


@kernel
def line_rate(b, z):
    """Rate of the path position of the contact lines [base pitches/s] at a place on the shared width."""
    return b["phase_rate"][0 if b["flank"] > 0 else 1] + b["lam"] * width_rate(b, z)


@kernel
def nearer(start, end, stop):
    """`stop` if it lies between, else `end`."""
    if stop > start and stop < end:
        return stop
    return end


@kernel
def phase_flank(b, ctl, watch, x_0, ratio, rate):
    """A prescribed total stiffness, spread evenly over the shared face width, acting at the pitch point.

    `ratio` of the stiffness to its mean and the rate of that ratio [1/s].
    """
    k = b["c_prime"] * ratio
    k_rate = b["c_prime"] * rate
    lo = b["z_lo"]
    hi = b["z_hi"]
    if b["tilt"] == 0.0 and b["fixed"] == 1:
        node(b, ctl, watch, x_0, 0.0, (0.5 * (lo + hi), 0.0), k, k_rate, 0.0, None)
        return
    if b["slices"] == 0 and b["tilt"] == 0.0 and b["rate"][1] == 0.0 and b["mu"] == 0.0:
        # parallel axes: the same force all over the width, whose second moment is that of its length
        node(b, ctl, watch, x_0, 0.0, (0.5 * (lo + hi), 0.0), k, k_rate, 0.0, None)
        b["acc"][7] += b["acc"][5] * (hi - lo) * (hi - lo) / 12.0
        return
    if b["slices"] > 0:
        step = (hi - lo) / b["slices"]
        part = 1.0 / b["slices"]
        for s in range(b["slices"]):
            z = lo + (s + 0.5) * step
            _phase_node(b, ctl, watch, x_0, z, k * part, k_rate * part)
        return
    stop = hi
    if b["tilt"] != 0.0:
        stop = nearer(lo, hi, x_0 / b["tilt"])
    a = lo
    while a < hi:
        c = stop if a < stop else hi
        z = 0.5 * (a + c)
        half = 0.5 * (c - a)
        for s in range(3):
            y = z + (s - 1) * GAUSS * half
            part = half * ((8.0 / 9.0) if s == 1 else (5.0 / 9.0)) / (hi - lo)
            _phase_node(b, ctl, watch, x_0, y, k * part, k_rate * part)
        a = c


@kernel
def _phase_node(b, ctl, watch, x_0, z, k, k_rate):
    """One node of a prescribed stiffness, at the width z and at the pitch point."""
    x_rate = -b["kappa"] * drift(b, z) if watch is not None else 0.0
    node(b, ctl, watch, x_0 - b["tilt"] * z, x_rate, (z, 0.0), k, k_rate, 0.0, None)
