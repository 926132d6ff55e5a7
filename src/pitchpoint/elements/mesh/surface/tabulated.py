# SPDX-License-Identifier: Apache-2.0
"""Pre-computed contact of tooth surfaces: forces as derivatives of a tabulated potential.

The table (`contact.potential_table`) holds the elastic potential of all tooth pairs of a flank over the mesh
phase in the middle of the common width, the approach there, the misalignment and the centre distance. An
axial offset of the gears moves that middle. Further quantities of the table, over the force: friction force
and friction moment about the pitch point for a coefficient of 1 with the sliding in the direction of recess;
then the forces of the tooth pairs.

Damping and friction act on the whole flank, with the velocities in the middle of the common width.

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

FRICTION_FORCE, FRICTION_MOMENT, FIRST_PAIR = 0, 1, 2
"""Further quantities of a table; the forces of the pairs are in the order of their numbers."""

APART = -1e-9
"""Distance from contact of a flank without force [m]: the table does not contain the gap."""


@kernel
def _add_friction(b, f, middle, ratios):
    """Add the friction of the flank, with the sliding velocity of its mean distance from the pitch point."""
    sums = b["sums"]
    rate = b["rate"][4]
    friction, by_f, _ = flank_friction(b["contact"], f, rate * ratios[FRICTION_MOMENT])
    along = friction * ratios[FRICTION_FORCE]
    about = friction * ratios[FRICTION_MOMENT]
    sums["force"][2] += along
    sums["force"][3] += along * middle
    sums["force"][4] += about
    sums["friction_power"] += along * (b["rate"][2] + middle * b["rate"][3]) + about * rate
    if b["request"]["jac"] != 0:
        c = b["sums"]["tangent"][0, 0]
        sums["tangent"][2, 0] += by_f * ratios[FRICTION_FORCE] * c
        sums["tangent"][4, 0] += by_f * ratios[FRICTION_MOMENT] * c


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
        tangent[0, 0] += c
        tangent[0, 1] += middle * c - ck * xk
        tangent[1, 0] += middle * c - ck * xk
        tangent[1, 1] += middle * middle * c - ck * (2.0 * middle * xk - kk)
    _add_slopes(b, by_s, total, by_distance, middle)
    sums["pushed"] += total
    ratios = b["gcp_ratios"]
    if b["contact"]["mu"] > 0.0 or watch == 1:
        force_ratios(table, s, x, kappa, abs(now["a"]), ratios)
    if b["contact"]["mu"] > 0.0:
        _add_friction(b, total, middle, ratios)
    if watch == 1:
        sums["stiffness"] += xx
        sums["energy"] += energy
        sums["damping_power"] += damping * w
        if b["request"]["out"] != 0 and b["n_pair"] > 0:
            first = now["tooth"] + int(math.floor(s))
            for k in range(b["n_pair"]):
                share = now["flank"] * total * ratios[FIRST_PAIR + k]
                add_pair_force(b, N_OUT, (first + k) % b["n_pair"], share)
    return OK
