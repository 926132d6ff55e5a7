# SPDX-License-Identifier: Apache-2.0
"""Contact nodes of single tooth pairs: integration along the contact lines of all pairs of one flank.

A contact line is straight in path and width: p(z) = p_0 + lam z. Along it the stiffness of a pair is a
piecewise cubic, the penetration of tilted gears is linear, and the lever arms are linear, so three Gauss
points on every piece between kinks (start and end of contact, ends of the relief ramp, lift-off line, pitch
point with sliding reversal, points of a table) integrate force, moments and tangent exactly. Pairs with a
tooth with deviation grids (`mesh.flank_deviations`) have more pieces: between the stations of the grids, at
the edge of missing material, and at the lift-off of the flanks. With slices the sum has one node at the
centre of each slice; this is used for gears with modified flanks.

`deviating` is 1 for a pair with such a tooth, None for a nominal pair, whose kernels are compiled without it;
the former are called by address (`deviating_line`), compiled only for a mesh with such teeth.
"""

from __future__ import annotations

import math

from pitchpoint.contact.elastic import series_overlap
from pitchpoint.contact.flank_law import flank_energy
from pitchpoint.contact.lift_off import MAX_STEPS, narrowed, secant
from pitchpoint.contact.pair_shape import pair_shape, pair_shape_rate, pair_table, pair_table_rate
from pitchpoint.core.kernel import call, kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.mesh.flank_deviations import (
    find_rows,
    gap_at,
    has_level,
    level_at,
    next_station,
    pair_separation,
    runs_damped,
    softening_at,
)
from pitchpoint.elements.mesh.line_of_action import pooled
from pitchpoint.elements.mesh.nodes import GAUSS, drift, line_rate, nearer, set_levers
from pitchpoint.elements.mesh.observations import add_pair_force
from pitchpoint.elements.mesh.record import N_OUT, RECORD
from pitchpoint.elements.mesh.sums import add_node
from pitchpoint.multibody.channels import F8

MAX_SPLIT = 64
"""Maximum number of table points at which contact lines are split (three nodes per point on a line). The
table of `energy` has 129 smooth points; without splitting its stiffness error is below 3.4e-5 of the mean."""


@kernel
def pair_node(b, watch, p_0, x_q, z, weight, deviating):
    """Add one node of the pair with the contact line p_0 + lam z; `x_q`: its penetration at z = 0 [m]."""
    now = b["now"]
    p = p_0 + now["lam"] * z
    if b["n_table"] > 0:
        c = pair_table(p, now["eps"], b["n_table"], view(pooled(b, b["table"]), b["n_table"], F8), now["L"])
    else:
        c = pair_shape(p, now["eps"], b["S_R"], now["L"])
    x = x_q - now["tilt"] * z
    xi = now["xi_A"] + p * b["p_bt"]
    scale = b["c_prime"] * weight
    k_rate = 0.0
    x_rate = 0.0
    z_rate = 0.0
    xi_rate = 0.0
    if watch is not None or (deviating is not None and runs_damped(b)):
        z_rate = now["lo_rate"] + (z - now["z_lo"]) * now["growth"]  # as `width_rate`
        p_rate = now["phase_rate"][0 if now["flank"] > 0 else 1] + now["lam"] * z_rate
        xi_rate = now["xi_A_rate"] + p_rate * b["p_bt"]
    if watch is not None:
        k_rate = scale * _shape_rate(b, p, p_rate)
        x_rate = -now["kappa"] * (drift(b, z) + now["flank"] * b["tan_b"] * xi_rate)
    limit = b["load_limit"] * weight
    set_levers(b, z, xi)
    if deviating is None:
        return add_node(b, watch, x, c * scale, limit, (k_rate, x_rate, now["growth"]), None, 1.0)
    if weight <= 0.0:  # a piece between two coincident edges
        return 0.0
    gap, gap_rate, slope, level, level_rate, q, q_rate = pair_separation(b, z, xi, z_rate, xi_rate)
    # an edge that moves under the contact removes elastic energy, but has no damping
    x_rate -= level_rate
    own = (-gap_rate, -slope, q / weight, q_rate / weight)  # compliance of a crack in series, per face width
    return add_node(b, watch, x - gap - level, c * scale, limit, (k_rate, x_rate, now["growth"]), own, 1.0)


@kernel
def _shape_rate(b, p, p_rate):
    """Time derivative of the ratio c/c' of a pair."""
    now = b["now"]
    L_rate = b["T_R"] * now["eps_rate"]
    if b["n_table"] > 0:
        table = view(pooled(b, b["table"]), b["n_table"], F8)
        return pair_table_rate(p, p_rate, now["eps"], now["eps_rate"], b["n_table"], table, now["L"], L_rate)
    return pair_shape_rate(p, p_rate, now["eps"], now["eps_rate"], b["S_R"], now["L"], L_rate)


@kernel
def _gauss(b, watch, p_0, x_q, z_a, z_c, deviating):
    """Integrate the piece from z_a to z_c of a contact line with three Gauss points."""
    z = 0.5 * (z_a + z_c)
    half = 0.5 * (z_c - z_a)
    r = GAUSS * half
    f = pair_node(b, watch, p_0, x_q, z - r, half * (5.0 / 9.0), deviating)
    f += pair_node(b, watch, p_0, x_q, z, half * (8.0 / 9.0), deviating)
    return f + pair_node(b, watch, p_0, x_q, z + r, half * (5.0 / 9.0), deviating)


@kernel
def _over(b, what, p_0, x_q, z):
    """Level of the tooth of gear 1 or 2 (`what` 0 or 1) at a point of a contact line, or penetration (2) [m].

    Pieces are split at the sign changes of these functions.
    """
    now = b["now"]
    xi = now["xi_A"] + (p_0 + now["lam"] * z) * b["p_bt"]
    if what < 2:
        return level_at(b, what, z, xi)
    return x_q - now["tilt"] * z - gap_at(b, z, xi)


@kernel
def _edge(b, what, p_0, x_q, a, c, f_a, f_c):
    """Zero of `_over` between a and c, where its signs differ."""
    bracket = (a, c, f_a, f_c, 0)
    small = 1e-14 * (abs(f_a) + abs(f_c))
    z = c
    for _ in range(MAX_STEPS):
        z = secant(bracket)
        f = _over(b, what, p_0, x_q, z)
        if abs(f) <= small:
            break
        bracket = narrowed(bracket, z, f)
    return z


@kernel
def _split(b, gear, p_0, a, c):
    """Crossing of the edge of missing material with the piece from a to c; c if there is none."""
    if not has_level(b, gear):
        return c
    f_a = _over(b, gear, p_0, 0.0, a)
    f_c = _over(b, gear, p_0, 0.0, c)
    if (f_a > 0.0) == (f_c > 0.0):
        return c
    return _edge(b, gear, p_0, 0.0, a, c, f_a, f_c)


@kernel
def _touching_piece(b, watch, p_0, x_q, a, c, x_a, x_c):
    """Integrate the part of a smooth piece in contact; if separated at both ends and in the middle, none is.

    `x_a` and `x_c` are the penetrations at its ends.
    """
    if x_a <= 0.0 and x_c <= 0.0:
        m = 0.5 * (a + c)
        x_m = _over(b, 2, p_0, x_q, m)
        if x_m <= 0.0:
            if watch is not None:
                b["sums"]["nearest"] = max(b["sums"]["nearest"], max(x_a, x_m, x_c))
            return 0.0
        a = _edge(b, 2, p_0, x_q, a, m, x_a, x_m)
        c = _edge(b, 2, p_0, x_q, m, c, x_m, x_c)
    elif x_a <= 0.0:
        a = _edge(b, 2, p_0, x_q, a, c, x_a, x_c)
    elif x_c <= 0.0:
        c = _edge(b, 2, p_0, x_q, a, c, x_a, x_c)
    return _gauss(b, watch, p_0, x_q, a, c, 1)


@kernel
def _deviating_piece(b, watch, p_0, x_q, a, c, x_a):
    """Integrate the piece from a to c of a deviating pair, split at the edges; returns force and x at c."""
    x_c = _over(b, 2, p_0, x_q, c)
    f = 0.0
    if has_level(b, 0) or has_level(b, 1):
        m_1 = _split(b, 0, p_0, a, c)
        m_2 = _split(b, 1, p_0, a, c)
        for m in (min(m_1, m_2), max(m_1, m_2)):
            if m > a and m < c:
                x_m = _over(b, 2, p_0, x_q, m)
                f += _touching_piece(b, watch, p_0, x_q, a, m, x_a, x_m)
                a = m
                x_a = x_m
    return f + _touching_piece(b, watch, p_0, x_q, a, c, x_a, x_c), x_c


@kernel
def _next_point(b, p_0, a, end):
    """Width after `a` at which a contact line crosses the next point of the table, at most `end`."""
    now = b["now"]
    lam = now["lam"]
    step = now["eps"] / (b["n_table"] - 1)
    way = 1.0 if lam > 0.0 else -1.0
    i = way * (math.floor(way * (p_0 + lam * a) / step) + 1.0)
    stop = (i * step - p_0) / lam
    if stop <= a:  # the end of the last piece, within round-off
        stop = ((i + way) * step - p_0) / lam
    return min(stop, end)


@kernel
def exact_line(b, watch, p_0, x_q, deviating):
    """Integrate over one contact line, split at its kinks."""
    now = b["now"]
    lam = now["lam"]
    eps = now["eps"]
    L = min(now["L"], 0.5 * eps)  # the ramps of a path below one base pitch may meet
    a = now["z_lo"]
    end = now["z_hi"]
    z_1 = z_2 = z_3 = z_4 = end
    split = False
    if lam != 0.0:
        u = -p_0 / lam
        v = (eps - p_0) / lam
        if watch is not None and now["L"] == 0.0:
            _moving_ends(b, x_q, u, v, deviating)
        z_1 = (L - p_0) / lam
        z_2 = (eps - L - p_0) / lam
        if b["contact"]["mu"] > 0.0 or deviating is not None:  # sliding reverses, wear has a kink
            z_4 = (-now["xi_A"] / b["p_bt"] - p_0) / lam
        a = max(a, min(u, v))
        end = min(end, max(u, v))
        split = b["n_table"] > 2 and b["n_table"] <= MAX_SPLIT
    elif p_0 < 0.0 or p_0 > eps:
        return 0.0
    if now["tilt"] != 0.0:
        z_3 = x_q / now["tilt"]
    f = 0.0
    x_a = _over(b, 2, p_0, x_q, a) if deviating is not None and a < end else 0.0
    while a < end:
        c = nearer(a, nearer(a, nearer(a, nearer(a, end, z_1), z_2), z_3), z_4)
        if split:
            c = _next_point(b, p_0, a, c)
        if deviating is None:
            f += _gauss(b, watch, p_0, x_q, a, c, None)
        else:
            c = next_station(b, a, c)
            part, x_a = _deviating_piece(b, watch, p_0, x_q, a, c, x_a)
            f += part
        a = c
    return f


@kernel
def _moving_ends(b, x_q, u, v, deviating):
    """Add the parametric power of a contact line without relief ramp that grows at A and shrinks at E.

    The stiffness per length jumps at both ends, u and v, which move by 1/lam per base pitch.
    """
    now = b["now"]
    first = b["S_R"]
    last = b["S_R"]
    if b["n_table"] > 0:
        table = view(pooled(b, b["table"]), b["n_table"], F8)
        first = table[0]
        last = table[b["n_table"] - 1]
    if u > now["z_lo"] and u < now["z_hi"]:
        energy = _line_energy(b, x_q, u, now["xi_A"], first, deviating)
        b["sums"]["parametric_power"] += energy * line_rate(b, u) / abs(now["lam"])
    if v > now["z_lo"] and v < now["z_hi"]:
        leaves = line_rate(b, v) - now["eps_rate"]
        energy = _line_energy(b, x_q, v, now["xi_A"] + now["eps"] * b["p_bt"], last, deviating)
        b["sums"]["parametric_power"] -= energy * leaves / abs(now["lam"])


@kernel
def _line_energy(b, x_q, z, xi, c, deviating):
    """Energy per length of a contact line [J/m] at its end (z, xi), with the stiffness ratio `c`."""
    x = x_q - b["now"]["tilt"] * z
    k = b["c_prime"] * c
    if deviating is None:
        if x <= 0.0 or c <= 0.0:
            return 0.0
        return flank_energy(b["contact"], x, x, k, b["load_limit"], None)[0]
    x -= gap_at(b, z, xi)
    if x <= 0.0 or c <= 0.0:
        return 0.0
    q = softening_at(b, z, xi)
    u = series_overlap(x, k, b["contact"]["power"], q)
    return flank_energy(b["contact"], x, u, k, b["load_limit"], q)[0]


@kernel
def pair_teeth(b, q):
    """Tooth of gear 1 and space of gear 2 of the pair q; internal gears count in the opposite direction."""
    now = b["now"]
    flank = now["flank"]
    side = 1 if b["z2"] > 0 else -1
    pair = flank * (int(q) - now["tooth"])
    return b["t1_0"] + pair, b["t2_0"] - side * pair + (side if flank < 0 else 0)


@kernel
def sliced_line(b, watch, p_0, x_q, deviating):
    """Sum over one contact line with one node at the centre of each slice."""
    now = b["now"]
    n = b["slices"]
    step = (now["z_hi"] - now["z_lo"]) / n
    f = 0.0
    for s in range(n):
        f += pair_node(b, watch, p_0, x_q, now["z_lo"] + (s + 0.5) * step, step, deviating)
    return f


@kernel
def pair_line(b, watch, p_0, x_q, deviating):
    """Sum over one contact line."""
    if b["slices"] == 0:
        return exact_line(b, watch, p_0, x_q, deviating)
    return sliced_line(b, watch, p_0, x_q, deviating)


@kernel
def deviating_line(record, watch, _):
    """Sum over the contact line with p_0 = line[0] and the penetration line[1]; its force to line[2].

    For pairs with flank deviations, called by address: most meshes have none, and without this code their
    kernel compiles in three quarters of the time. `watch` 1: with observations.
    """
    b = view(record, 1, RECORD)[0]
    line = b["now"]["line"]
    if watch == 1:
        line[2] = pair_line(b, 1, line[0], line[1], 1)
    else:
        line[2] = pair_line(b, None, line[0], line[1], 1)
    return OK


@kernel
def profile_flank(b, watch, x_0):
    """Sum over all pairs of the current flank; `x_0`: penetration at the pitch point [m]."""
    now = b["now"]
    fh = now["flank"] * b["tan_b"]
    middle = now["psi"] + 0.5 * now["lam"] * (now["z_lo"] + now["z_hi"])
    reach = 0.5 * abs(now["lam"]) * (now["z_hi"] - now["z_lo"])
    q = float(math.ceil(-middle - reach))
    last = math.floor(now["eps"] - middle + reach)
    while q <= last:
        p_0 = now["psi"] + q
        x_q = x_0 - now["kappa"] * fh * (now["xi_A"] + p_0 * b["p_bt"])
        if b["n_sep"] > 0 and find_rows(b, pair_teeth(b, q)):
            now["line"][0] = p_0
            now["line"][1] = x_q
            call(b["deviating"], b["here"], 1 if watch is not None else 0, 0)
            f = now["line"][2]
        else:
            f = pair_line(b, watch, p_0, x_q, None)
        if watch is not None and b["request"]["out"] != 0 and b["n_pair"] > 0:
            add_pair_force(b, N_OUT, (now["tooth"] - int(q)) % b["n_pair"], now["flank"] * f)
        q += 1.0
