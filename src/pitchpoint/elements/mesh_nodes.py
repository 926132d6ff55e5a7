# SPDX-License-Identifier: Apache-2.0
"""Forces of one flank as a sum over quadrature nodes on the contact lines of all tooth pairs.

A contact line is straight in path and width: p(z) = p_0 + lam z. Along it the stiffness of a pair is a
piecewise cubic, the penetration of tilted gears is linear, and the lever arms are linear, so three Gauss
points on every piece between kinks (start and end of contact, ends of the relief ramp, lift-off line, pitch
point where sliding turns, points of a table) integrate force, moments and tangent exactly. Slices are the
same sum with one node in the middle of each slice; separation grids of modified flanks need them.

Where nothing is observed, `watch` is None and energy, powers and what events ask for are left out when the
kernels are compiled.

Sums go to the scratch field `acc` (see gear_mesh_record). The normal force at (z, xi) has the moment y tau
about the pitch point, y = z + f tan(beta_b) xi: axial force times path and transverse force times width turn
the gears about the same axis tau = m x n_f. Penetration and its rate therefore change with y too.
"""

from __future__ import annotations

import math

from pitchpoint.contact.damping import linear_ramp, ramp
from pitchpoint.contact.elastic import low_load, power_force, stored_energy
from pitchpoint.contact.friction import static_dynamic
from pitchpoint.contact.pair_shape import pair_shape, pair_shape_rate, pair_table, pair_table_rate
from pitchpoint.core.kernel import kernel, view
from pitchpoint.elements.gear_mesh_record import NEAREST, ROLL
from pitchpoint.elements.mesh_line import pooled
from pitchpoint.elements.mesh_separation import pair_separation, runs_damped
from pitchpoint.multibody.channels import F8

_G = math.sqrt(0.6)

MOST_SPLIT = 64
"""Most points of a table that make pieces of their own: three nodes for every point on a contact line. The
table of `energy` has 129 smooth ones; without pieces its stiffness is off by 3.4e-5 of the mean at most."""


@kernel
def node(b, ctl, watch, x, x_rate, place, k, k_rate, limit, roll):
    """Add one node and return its normal force [N].

    `x` penetration [m] at the place (z, xi) [m], `k` stiffness [N/m^power], changing at `x_rate` [m/s] and
    `k_rate` per second where no force pushes: with the phase; `limit` force below which the pair softens [N].
    `roll`: rate of the penetration where the contact runs over separated flanks [m/s], which damps like that
    of the bodies, and its slope over xi; None on nominal flanks.
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
    if roll is not None:
        w += roll[0]
    f, kt = power_force(x, k, b["power"])
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
        f += d * w
        kt *= 1.0 + b["chi"] * w
    elif d > 0.0:
        share, slope = ramp(x, b["s_0"]) if b["smooth"] == 1 else linear_ramp(x, b["s_0"])
        full = d
        d *= share
        f += d * w
        kt += full * w * slope
    if watch is not None:
        acc[NEAREST] = max(acc[NEAREST], f / secant)
    # a flank that would have to pull lets go, and the work of its elastic force is lost
    f = max(f, 0.0)
    if watch is not None:
        energy, feed = stored_energy(x, k, b["power"], limit)
        acc[22] += (f - elastic) * w
        acc[23] += feed * k_rate + elastic * x_rate + energy * b["growth"]
        if roll is not None:
            acc[23] += f * roll[0]
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
    if roll is not None:
        c_roll = ctl["cd"] * d * roll[1]
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
def _pair_node(b, ctl, watch, p_0, x_q, z, weight, teeth):
    """One node of the pair whose contact line is p_0 + lam z; `x_q` is its penetration at z = 0 [m].

    `teeth`: the tooth of gear 1 and the space of gear 2 that make the pair, None on nominal flanks.
    """
    p = p_0 + b["lam"] * z
    if b["n_table"] > 0:
        c = pair_table(p, b["eps"], b["n_table"], view(pooled(b, b["table"]), b["n_table"], F8), b["L"])
    else:
        c = pair_shape(p, b["eps"], b["S_R"], b["L"])
    x = x_q - b["tilt"] * z
    xi = b["xi_A"] + p * b["p_bt"]
    scale = b["c_prime"] * weight
    k_rate = 0.0
    x_rate = 0.0
    z_rate = 0.0
    xi_rate = 0.0
    if watch is not None or (teeth is not None and runs_damped(b)):
        z_rate = b["lo_rate"] + (z - b["z_lo"]) * b["growth"]  # as `width_rate`
        p_rate = b["phase_rate"][0 if b["flank"] > 0 else 1] + b["lam"] * z_rate
        xi_rate = b["xi_A_rate"] + p_rate * b["p_bt"]
    if watch is not None:
        k_rate = scale * _shape_rate(b, p, p_rate)
        x_rate = -b["kappa"] * (_drift(b, z) + b["flank"] * b["tan_b"] * xi_rate)
    limit = b["load_limit"] * weight
    if teeth is None:
        return node(b, ctl, watch, x, x_rate, (z, xi), c * scale, k_rate, limit, None)
    gap, gap_rate, slope = pair_separation(b, teeth, z, xi, z_rate, xi_rate)
    return node(b, ctl, watch, x - gap, x_rate, (z, xi), c * scale, k_rate, limit, (-gap_rate, -slope))


@kernel
def _shape_rate(b, p, p_rate):
    """Rate of the ratio c/c' of a pair."""
    L_rate = b["T_R"] * b["eps_rate"]
    if b["n_table"] > 0:
        table = view(pooled(b, b["table"]), b["n_table"], F8)
        return pair_table_rate(p, p_rate, b["eps"], b["eps_rate"], b["n_table"], table, b["L"], L_rate)
    return pair_shape_rate(p, p_rate, b["eps"], b["eps_rate"], b["S_R"], b["L"], L_rate)


@kernel
def width_rate(b, z):
    """Rate of a place on the shared width, seen from the pitch point: places keep their share of it."""
    share = (z - b["z_lo"]) / (b["z_hi"] - b["z_lo"])
    return b["lo_rate"] + share * (b["hi_rate"] - b["lo_rate"])


@kernel
def _drift(b, z):
    """Rate of that place over the one the normal force is conjugate to."""
    return width_rate(b, z) - b["w_z"] * b["dz_rate"]


@kernel
def line_rate(b, z):
    """Rate of the path position of the contact lines [base pitches/s] at a place on the shared width."""
    return b["phase_rate"][0 if b["flank"] > 0 else 1] + b["lam"] * width_rate(b, z)


@kernel
def _nearer(start, end, stop):
    """`stop` if it lies between, else `end`."""
    if stop > start and stop < end:
        return stop
    return end


@kernel
def _gauss(b, ctl, watch, p_0, x_q, z_a, z_c):
    """Three Gauss points on the piece from z_a to z_c of a contact line."""
    z = 0.5 * (z_a + z_c)
    half = 0.5 * (z_c - z_a)
    r = _G * half
    f = _pair_node(b, ctl, watch, p_0, x_q, z - r, half * (5.0 / 9.0), None)
    f += _pair_node(b, ctl, watch, p_0, x_q, z, half * (8.0 / 9.0), None)
    return f + _pair_node(b, ctl, watch, p_0, x_q, z + r, half * (5.0 / 9.0), None)


@kernel
def _next_point(b, p_0, a, end):
    """Where behind `a` a contact line crosses the next point of the table, at most `end`."""
    lam = b["lam"]
    step = b["eps"] / (b["n_table"] - 1)
    way = 1.0 if lam > 0.0 else -1.0
    i = way * (math.floor(way * (p_0 + lam * a) / step) + 1.0)
    stop = (i * step - p_0) / lam
    if stop <= a:  # the point where the last piece ended, a rounding before it
        stop = ((i + way) * step - p_0) / lam
    return min(stop, end)


@kernel
def exact_line(b, ctl, watch, p_0, x_q):
    """Sum over one contact line, split at its kinks."""
    lam = b["lam"]
    eps = b["eps"]
    L = min(b["L"], 0.5 * eps)  # the ramps of a path below one base pitch may meet
    a = b["z_lo"]
    end = b["z_hi"]
    z_1 = z_2 = z_3 = z_4 = end
    split = False
    if lam != 0.0:
        u = -p_0 / lam
        v = (eps - p_0) / lam
        if watch is not None and b["L"] == 0.0:
            _moving_ends(b, x_q, u, v)
        z_1 = (L - p_0) / lam
        z_2 = (eps - L - p_0) / lam
        if b["mu"] > 0.0:
            z_4 = (-b["xi_A"] / b["p_bt"] - p_0) / lam
        a = max(a, min(u, v))
        end = min(end, max(u, v))
        split = b["n_table"] > 2 and b["n_table"] <= MOST_SPLIT
    if b["tilt"] != 0.0:
        z_3 = x_q / b["tilt"]
    f = 0.0
    while a < end:
        c = _nearer(a, _nearer(a, _nearer(a, _nearer(a, end, z_1), z_2), z_3), z_4)
        if split:
            c = _next_point(b, p_0, a, c)
        f += _gauss(b, ctl, watch, p_0, x_q, a, c)
        a = c
    return f


@kernel
def _moving_ends(b, x_q, u, v):
    """Energy fed in where a contact line without relief ramp grows at A and shrinks at E.

    The stiffness per length jumps at both ends, u and v, which travel at 1/lam per base pitch.
    """
    first = b["S_R"]
    last = b["S_R"]
    if b["n_table"] > 0:
        table = view(pooled(b, b["table"]), b["n_table"], F8)
        first = table[0]
        last = table[b["n_table"] - 1]
    if u > b["z_lo"] and u < b["z_hi"]:
        b["acc"][23] += _line_energy(b, x_q - b["tilt"] * u, first) * line_rate(b, u) / abs(b["lam"])
    if v > b["z_lo"] and v < b["z_hi"]:
        leaves = line_rate(b, v) - b["eps_rate"]
        b["acc"][23] -= _line_energy(b, x_q - b["tilt"] * v, last) * leaves / abs(b["lam"])


@kernel
def _line_energy(b, x, c):
    """Energy per length of a contact line [J/m] with penetration `x` and ratio `c`."""
    return stored_energy(x, b["c_prime"] * c, b["power"], b["load_limit"])[0] if x > 0.0 and c > 0.0 else 0.0


@kernel
def _teeth(b, q):
    """Tooth of gear 1 and space of gear 2 that make the pair q; internal gears count the other way round."""
    flank = b["flank"]
    side = 1 if b["z2"] > 0 else -1
    pair = flank * (int(q) - b["tooth"])
    return b["t1_0"] + pair, b["t2_0"] - side * pair + (side if flank < 0 else 0)


@kernel
def sliced_line(b, ctl, watch, p_0, x_q, teeth):
    """Sum over one contact line with one node in the middle of each slice; `teeth` as in `_pair_node`."""
    n = b["slices"]
    step = (b["z_hi"] - b["z_lo"]) / n
    f = 0.0
    for s in range(n):
        f += _pair_node(b, ctl, watch, p_0, x_q, b["z_lo"] + (s + 0.5) * step, step, teeth)
    return f


@kernel
def profile_flank(b, ctl, watch, x_0):
    """All pairs of the current flank; `x_0` penetration at the pitch point."""
    fh = b["flank"] * b["tan_b"]
    middle = b["psi"] + 0.5 * b["lam"] * (b["z_lo"] + b["z_hi"])
    reach = 0.5 * abs(b["lam"]) * (b["z_hi"] - b["z_lo"])
    q = float(math.ceil(-middle - reach))
    last = math.floor(b["eps"] - middle + reach)
    while q <= last:
        p_0 = b["psi"] + q
        x_q = x_0 - b["kappa"] * fh * (b["xi_A"] + p_0 * b["p_bt"])
        if b["slices"] == 0:
            f = exact_line(b, ctl, watch, p_0, x_q)
        elif b["n_sz"] == 0:
            f = sliced_line(b, ctl, watch, p_0, x_q, None)
        else:
            f = sliced_line(b, ctl, watch, p_0, x_q, _teeth(b, q))
        if watch is not None and b["n_pair"] > 0:
            b["pair"][(b["tooth"] - int(q)) % b["n_pair"]] += b["flank"] * f
        q += 1.0


@kernel
def phase_flank(b, ctl, watch, x_0, ratio, slope):
    """A prescribed total stiffness, spread evenly over the shared face width, acting at the pitch point."""
    k = b["c_prime"] * ratio
    k_rate = b["c_prime"] * slope * b["phase_rate"][0 if b["flank"] > 0 else 1]
    lo = b["z_lo"]
    hi = b["z_hi"]
    if b["tilt"] == 0.0 and b["fixed"] == 1:
        node(b, ctl, watch, x_0, 0.0, (0.5 * (lo + hi), 0.0), k, k_rate, 0.0, None)
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
        stop = _nearer(lo, hi, x_0 / b["tilt"])
    a = lo
    while a < hi:
        c = stop if a < stop else hi
        z = 0.5 * (a + c)
        half = 0.5 * (c - a)
        for s in range(3):
            y = z + (s - 1) * _G * half
            part = half * ((8.0 / 9.0) if s == 1 else (5.0 / 9.0)) / (hi - lo)
            _phase_node(b, ctl, watch, x_0, y, k * part, k_rate * part)
        a = c


@kernel
def _phase_node(b, ctl, watch, x_0, z, k, k_rate):
    """One node of a prescribed stiffness, at the width z and at the pitch point."""
    x_rate = -b["kappa"] * _drift(b, z) if watch is not None else 0.0
    node(b, ctl, watch, x_0 - b["tilt"] * z, x_rate, (z, 0.0), k, k_rate, 0.0, None)
