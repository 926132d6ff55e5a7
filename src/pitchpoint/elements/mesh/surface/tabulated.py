# SPDX-License-Identifier: Apache-2.0
"""Pre-computed contact of tooth surfaces: forces as derivatives of a tabulated potential.

The table (`contact.potential_table`) holds the elastic potential of all tooth pairs of a flank over the mesh
phase in the middle of the common width, the approach there, the misalignment and the centre distance. An
axial offset of the gears moves that middle. Further quantities of the table, over the force: loads before and
beyond the pitch point with their places, then the forces of the tooth pairs.

Friction acts at two points, the centres of the loads before and beyond the pitch point, each with its own
sliding velocity: the load on either side slides in one direction but for motions of the gears across the line
of action. Damping acts on the whole flank, with the velocity in the middle of the common width.

Source: Adams Machinery, "Gear Pair (Advanced 3D Contact)", pre-computed contact.
"""

from __future__ import annotations

import math

from pitchpoint.contact.flank_law import flank_friction, node_damping
from pitchpoint.contact.potential_table import force_ratios, potential
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.mesh.line_of_action import pooled
from pitchpoint.elements.mesh.observations import add_pair_force
from pitchpoint.elements.mesh.record import N_OUT, RECORD
from pitchpoint.elements.mesh.surface.nodes import begin_surface
from pitchpoint.multibody.channels import F8

FRICTION_FORCE, PATH, WIDTH, FIRST_PAIR = 0, 1, 3, 5
"""Further quantities of a table: load beyond the pitch point less that before it; sums of load times path
position, before and beyond; of load times distance from the middle of the common width, before and beyond;
forces of the pairs in the order of their numbers."""

APART = -1e-9
"""Distance from contact of a flank without force [m]: the table does not contain the gap."""


@kernel
def _add_friction(b, f, middle, ratios):
    """Add the friction of the loads before and beyond the pitch point; the normal force has been added."""
    for side in range(2):
        share = 0.5 * (1.0 + (2 * side - 1) * ratios[0, FRICTION_FORCE])
        if share > 0.0:
            _add_point(b, f, share, middle, side, ratios)


@kernel
def _add_point(b, f, share, middle, side, ratios):
    """Add the friction of one of both loads, `share` of the normal force f, at its centre."""
    sums = b["sums"]
    rate = b["rate"]
    lever = b["lever"]
    lever[2] = 1.0
    lever[3] = middle + ratios[0, WIDTH + side] / share
    lever[4] = ratios[0, PATH + side] / share
    v = rate[2] + lever[3] * rate[3] + lever[4] * rate[4]
    friction, by_f, by_v = flank_friction(b["contact"], f * share, v)
    for p in range(2, 5):
        sums["force"][p] += friction * lever[p]
    sums["friction_power"] += friction * v
    if b["request"]["jac"] == 0:
        return
    tangent = sums["tangent"]
    for q in range(2):
        # by the normal force, and by the places of the loads: approach and misalignment
        by_x, by_k = (1.0, 0.0) if q == 0 else (middle, -1.0)
        ck = b["request"]["ck"]
        of_share = by_x * ratios[1, FRICTION_FORCE] + by_k * ratios[2, FRICTION_FORCE]
        load = ck * f * 0.5 * (2 * side - 1) * of_share
        z = ck * f * (by_x * ratios[1, WIDTH + side] + by_k * ratios[2, WIDTH + side])
        xi = ck * f * (by_x * ratios[1, PATH + side] + by_k * ratios[2, PATH + side])
        z += middle * load
        slide = (rate[3] * (z - lever[3] * load) + rate[4] * (xi - lever[4] * load)) / (f * share)
        c = share * tangent[0, q]
        tangent[2, q] += by_f * (c + load) + by_v * slide
        tangent[3, q] += by_f * (c * lever[3] + z) + by_v * slide * lever[3]
        tangent[4, q] += by_f * (c * lever[4] + xi) + by_v * slide * lever[4]
    by_v *= b["request"]["cd"]
    for p in range(2, 5):
        for q in range(2, 5):
            tangent[p, q] += by_v * lever[p] * lever[q]


@kernel
def _add_slopes(b, s_slope, force, by_distance, middle):
    """Add the energy slopes: by phase, by the approach and by the centre distance."""
    now = b["now"]
    per_xi = s_slope / b["p_bt"]
    place = now["place_slope"][0] + now["place_slope"][1] * middle
    now["by_travel"] += now["flank"] * per_xi
    now["by_tan"] += (now["xi_slope"] - b["r_b2"]) * per_xi
    now["by_tan"] += by_distance * abs(b["r_b1"] + b["r_b2"]) * now["sin_a"]
    now["by_dz"] += now["flank"] * b["tan_b"] * (b["w1"] - 0.5 + place) * per_xi
    now["by_dz"] -= force * now["kappa"] * (place - b["w_z"])


@kernel
def tabulated_flank(record, watch, _):
    """Sum the current flank. `watch` 1: with observations."""
    b = view(record, 1, RECORD)[0]
    b["n_nodes"] = 0
    if b["c_prime"] == 0.0:  # solvers remove the mesh spring in this way
        return OK
    now = b["now"]
    sums = b["sums"]
    begin_surface(b)
    side = 0 if now["flank"] > 0 else 1
    table = view(pooled(b, b["gcp"][side]), b["gcp_size"][side], F8)
    kappa = now["kappa"]
    middle = 0.5 * (now["z_lo"] + now["z_hi"])
    s = now["psi"] + now["lam"] * middle
    x = now["x_0"] - kappa * middle
    found = potential(table, s, x, kappa, abs(now["a"]))
    energy, by_s, force, by_kappa, by_distance, xx, xk, kk, beyond = found
    if watch == 1:
        sums["nearest"] = max(sums["nearest"], x if force > 0.0 else APART)
    if not energy > 0.0:
        return OK
    b["beyond"] |= beyond
    place = now["place_slope"][0] + now["place_slope"][1] * middle
    w = b["rate"][0] + middle * b["rate"][1] - kappa * (place - b["w_z"]) * now["dz_rate"]
    damping, factor, by_w = node_damping(b["contact"], force, xx, w)
    if force + damping <= 0.0:
        damping = -force
        factor = -1.0
        by_w = 0.0
    total = force + damping
    sums["force"][0] += total
    sums["force"][1] += middle * total - by_kappa
    ck = b["request"]["ck"]
    cd = b["request"]["cd"]
    if b["request"]["jac"] != 0:
        tangent = sums["tangent"]
        c = ck * (1.0 + factor) * xx + cd * by_w
        c_tilt = middle * c - ck * (1.0 + factor) * xk
        tangent[0, 0] += c
        tangent[0, 1] += c_tilt
        tangent[1, 0] += middle * c - ck * xk
        tangent[1, 1] += middle * c_tilt - ck * (middle * xk - kk)
    _add_slopes(b, by_s, total, by_distance, middle)
    sums["pushed"] += total
    ratios = b["gcp_ratios"]
    if watch == 1:
        force_ratios(table, s, x, kappa, abs(now["a"]), ratios)
    elif b["contact"]["mu"] > 0.0:
        force_ratios(table, s, x, kappa, abs(now["a"]), ratios[:, :FIRST_PAIR])
    if b["contact"]["mu"] > 0.0 and total > 0.0:
        _add_friction(b, total, middle, ratios)
    if watch == 1:
        sums["stiffness"] += xx
        sums["energy"] += energy
        sums["damping_power"] += damping * w
        if b["request"]["out"] != 0 and b["n_pair"] > 0:
            first = now["tooth"] + int(math.floor(s))
            for k in range(b["n_pair"]):
                share = now["flank"] * total * ratios[0, FIRST_PAIR + k]
                add_pair_force(b, N_OUT, (first + k) % b["n_pair"], share)
    return OK
