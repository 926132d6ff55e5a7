# SPDX-License-Identifier: Apache-2.0
"""Sums over the contact nodes of a flank, and their wrenches on both gears, for cylindrical and bevel meshes.

A node acts on the gears along the rows of a wrench basis with one lever per row: first the rows of the normal
force, then three of friction. Its force, tangent and observations follow from the flank law and are added to
the record `sums` of the mesh. Without observations `watch` is None, and energy, powers and event functions
are not compiled.

Every row of the wrench basis is the wrench of a unit force on both bodies. Sums over the rows give forces,
sums over pairs of rows tangents; the rate of a row is the power of its unit force, taken from the bodies.
Pure rotation without friction needs one value: the torque of a base-tangent force F is -r_b F about both
axes.
"""

from __future__ import annotations

import numpy as np

from pitchpoint.contact.damping import start_share
from pitchpoint.contact.flank_law import flank_energy, flank_force, flank_friction
from pitchpoint.core.kernel import kernel, view
from pitchpoint.multibody.channels import F8, FRAME

FRICTION_ROWS = 3
"""Number of friction rows, the last rows of a wrench basis."""

#: Evaluation request of a mesh: a copy of the fields that it needs of the control record.
REQUEST = np.dtype(
    [
        ("t", "f8"),
        ("ck", "f8"),
        ("cd", "f8"),  # factors of the tangents over positions and over velocities
        ("jac", "i8"),  # as in the control record
        ("out", "i8"),  # address of the observations of this mesh, 0: none
        ("ev", "i8"),  # address of its event functions, 0: none
        ("i", "i8"),
        ("j", "i8"),  # frames of gear 1 and gear 2
        ("ii", "i8"),
        ("ij", "i8"),
        ("ji", "i8"),
        ("jj", "i8"),  # pair tangents
        ("fr", "i8"),
        ("nb", "i8"),  # address and number of the frames
        ("kk", "i8"),
        ("np", "i8"),  # address and number of the pair tangents
    ],
    align=True,
)


def scratch_of_sums(rows: int) -> list[tuple]:
    """Record fields for the nodes and sums of a mesh whose wrench basis has `rows` rows."""
    sums = [
        ("force", "f8", rows),  # over the rows of the basis
        ("tangent", "f8", (rows, rows)),  # likewise, by positions and velocities
        ("roll", "f8", rows),  # tangent by the rate of the path position
        ("pushed", "f8"),  # base-tangent force of all nodes; this and the next fields only with observations
        ("stiffness", "f8"),
        ("friction_power", "f8"),
        ("damping_power", "f8"),
        ("parametric_power", "f8"),
        ("energy", "f8"),
        ("nearest", "f8"),  # maximum over the nodes of force over stiffness [m], negative if separated
    ]
    return [
        ("request", REQUEST),
        ("d_start", "f8"),
        ("t_end", "f8"),  # additional mesh damper for the start of a run, until this time [N s/m], [s]
        ("d_now", "f8"),  # mesh damper at the time of the request
        ("rate", "f8", rows),  # rates of both bodies along the rows
        ("lever", "f8", rows),  # of one node
        ("sums", np.dtype(sums, align=True)),
        ("basis_i", "f8", (rows, 6)),
        ("basis_j", "f8", (rows, 6)),  # wrench basis on both bodies
    ]


NOWHERE = -0.1
"""Distance from contact [m] of a flank without stiffness (no tooth pair in the path of contact)."""


@kernel
def begin_request(b, c):
    """Copy the evaluation request from the control record `c` to the mesh record."""
    request = b["request"]
    request["t"] = c["t"]
    request["ck"] = c["ck"]
    request["cd"] = c["cd"]
    request["jac"] = c["jac"]
    request["out"] = c["out"] + 8 * b["out"] if c["out"] != 0 else 0
    request["ev"] = c["ev"] + 8 * b["ev"] if c["ev"] != 0 else 0
    request["i"] = b["i"]
    request["j"] = b["j"]
    request["ii"] = b["ii"]
    request["ij"] = b["ij"]
    request["ji"] = b["ji"]
    request["jj"] = b["jj"]
    request["fr"] = c["fr"]
    request["nb"] = c["nb"]
    request["kk"] = c["kk"]
    request["np"] = c["np"]
    b["d_now"] = b["d_gap"]
    if b["d_start"] > 0.0 and c["jac"] != 2:  # not part of a linearisation
        b["d_now"] += b["d_start"] * start_share(c["t"], b["t_end"])


@kernel
def requested_arrays(b):
    """Frames [nb] and pair tangents [np, 6, 6] of an evaluation."""
    request = b["request"]
    return view(request["fr"], request["nb"], FRAME), view(request["kk"], (request["np"], 6, 6), F8)


@kernel
def begin_damping(b):
    """Request sums of the damping coefficients alone, without observations; returns the replaced request."""
    request = b["request"]
    kept = (request["ck"], request["cd"], request["out"], request["ev"])
    request["ck"] = 0.0
    request["cd"] = 1.0
    request["out"] = 0
    request["ev"] = 0
    return kept


@kernel
def end_damping(b, kept):
    """Restore the request that `begin_damping` returned."""
    request = b["request"]
    request["ck"], request["cd"], request["out"], request["ev"] = kept


@kernel
def begin_sums(b):
    """Reset the sums."""
    sums = b["sums"]
    rows = b["lever"].size
    for p in range(rows):
        sums["force"][p] = 0.0
        sums["roll"][p] = 0.0
        for q in range(rows):
            sums["tangent"][p, q] = 0.0
    sums["pushed"] = 0.0
    sums["stiffness"] = 0.0
    sums["friction_power"] = 0.0
    sums["damping_power"] = 0.0
    sums["parametric_power"] = 0.0
    sums["energy"] = 0.0
    sums["nearest"] = NOWHERE


@kernel
def across(b, values):
    """Value at the current node of a quantity given along the rows of the normal force."""
    lever = b["lever"]
    s = 0.0
    for p in range(lever.size - FRICTION_ROWS):
        s += lever[p] * values[p]
    return s


@kernel(inline=True)
def add_node(b, watch, x, k, limit, feed, own, size):
    """Add the node with the current levers and return its force along the base tangent [N].

    `x`: penetration [m]; `k`: stiffness [N/m^power]; `limit`: force below which the node softens [N]. `feed`:
    rates of stiffness and penetration with the mesh phase, which supply parametric power, and relative rate
    of the width. `size`: squared ratio of the displacement of the node to that of the gears along the base
    tangent. `own`: None for nominal flanks; for deviating flanks the penetration rate by the motion of the
    contact over the flanks [m/s], which is damped like that of the bodies, its slope over the path rate, a
    compliance in series [m/N] and its rate.
    """
    sums = b["sums"]
    if x <= 0.0 or k <= 0.0:
        if watch is not None and k > 0.0:
            sums["nearest"] = max(sums["nearest"], x)
        return 0.0
    law = b["contact"]
    w = across(b, b["rate"])
    if own is None:
        f, by_x, by_w, elastic, stiffness, u, reach = flank_force(law, x, k, limit, w, None)
    else:
        w += own[0]
        f, by_x, by_w, elastic, stiffness, u, reach = flank_force(law, x, k, limit, w, own[2])
    if watch is not None:
        sums["nearest"] = max(sums["nearest"], reach)
        if own is None:
            energy, by_k, by_soft = flank_energy(law, x, u, k, limit, None)
        else:
            energy, by_k, by_soft = flank_energy(law, x, u, k, limit, own[2])
            sums["parametric_power"] += by_soft * own[3] + f * own[0]
        sums["parametric_power"] += by_k * feed[0] + elastic * feed[1] + energy * feed[2]
        sums["damping_power"] += (f - elastic) * w
        sums["energy"] += energy
        sums["pushed"] += f
        if f > 0.0:
            sums["stiffness"] += stiffness * size
    if f == 0.0:
        return 0.0
    c = b["request"]["ck"] * by_x + b["request"]["cd"] * by_w
    add_normal(b, f, c)
    by_f = add_friction(b, watch, f, c) if law["mu"] > 0.0 else 0.0
    if own is not None:
        _add_roll(b, by_f, b["request"]["cd"] * by_w * own[1])
    return f


@kernel(inline=True)
def add_normal(b, f, c):
    """Add the normal force of a node and its tangent."""
    sums = b["sums"]
    lever = b["lever"]
    normal = lever.size - FRICTION_ROWS
    for p in range(normal):
        sums["force"][p] += f * lever[p]
    if b["request"]["jac"] != 0:
        for p in range(normal):
            for q in range(normal):
                sums["tangent"][p, q] += c * lever[p] * lever[q]


@kernel
def add_friction(b, watch, f, c):
    """Add the friction of a node against its local sliding; returns its derivative by the normal force."""
    sums = b["sums"]
    lever = b["lever"]
    rows = lever.size
    normal = rows - FRICTION_ROWS
    v = 0.0
    for p in range(normal, rows):
        v += lever[p] * b["rate"][p]
    force, by_f, by_v = flank_friction(b["contact"], f, v)
    for p in range(normal, rows):
        sums["force"][p] += force * lever[p]
    if watch is not None:
        sums["friction_power"] += force * v
    if b["request"]["jac"] != 0:
        by_v *= b["request"]["cd"]
        for p in range(normal, rows):
            for q in range(normal):
                sums["tangent"][p, q] += by_f * c * lever[p] * lever[q]
            for q in range(normal, rows):
                sums["tangent"][p, q] += by_v * lever[p] * lever[q]
    return by_f


@kernel
def _add_roll(b, by_f, c):
    """Add the tangent by the rate of the path position: `c` of the normal force, `by_f` c of friction."""
    roll = b["sums"]["roll"]
    lever = b["lever"]
    normal = lever.size - FRICTION_ROWS
    for p in range(normal):
        roll[p] += c * lever[p]
    for p in range(normal, lever.size):
        roll[p] += by_f * c * lever[p]


@kernel
def rate_of_row(b, f, g, p):
    """Rate of both bodies against row `p` of the wrench basis: power of its unit force."""
    s = 0.0
    for k in range(6):
        s -= b["basis_i"][p, k] * f["tw"][k] + b["basis_j"][p, k] * g["tw"][k]
    return s


@kernel
def push(b, f, g, kk, rows):
    """Add the summed forces of the first rows to both bodies, and their tangents to the four pair blocks."""
    sums = b["sums"]
    for p in range(rows):
        s = sums["force"][p]
        for k in range(6):
            f["F"][k] += s * b["basis_i"][p, k]
            g["F"][k] += s * b["basis_j"][p, k]
    if b["request"]["jac"] == 0:
        return
    for p in range(rows):
        for q in range(rows):
            c = sums["tangent"][p, q]
            if c == 0.0:
                continue
            for k in range(6):
                one = c * b["basis_i"][p, k]
                two = c * b["basis_j"][p, k]
                for n in range(6):
                    kk[b["request"]["ii"], k, n] += one * b["basis_i"][q, n]
                    kk[b["request"]["ij"], k, n] += one * b["basis_j"][q, n]
                    kk[b["request"]["ji"], k, n] += two * b["basis_i"][q, n]
                    kk[b["request"]["jj"], k, n] += two * b["basis_j"][q, n]


@kernel
def mesh_damper(b, f, g, kk, e_rate):
    """Add the mesh damper along the travel, row 0 of the basis; returns its force and rate.

    It also acts within the backlash. `e_rate`: rate of the static transmission error, excluded from the rate
    of the damper [m/s].
    """
    rate = rate_of_row(b, f, g, 0) - e_rate
    force = b["d_now"] * rate
    begin_sums(b)
    b["sums"]["force"][0] = force
    b["sums"]["tangent"][0, 0] = b["request"]["cd"] * b["d_now"]
    push(b, f, g, kk, 1)
    b["sums"]["tangent"][0, 0] = b["d_now"]
    return force, rate


@kernel
def add_spin_torque(b, f, g, force):
    """Add the torques of the base-tangent force `force` [N], front flank positive."""
    s1 = force * b["r_b1"]
    s2 = force * b["r_b2"]
    m = b["now"]["m"]
    for k in range(3):
        f["F"][3 + k] -= s1 * m[k]
        g["F"][3 + k] -= s2 * m[k]


@kernel
def push_path(b, f, g):
    """Add row 0 of the wrench basis to both bodies."""
    for k in range(6):
        f["F"][k] += b["basis_i"][0, k]
        g["F"][k] += b["basis_j"][0, k]


@kernel
def add_travel_torque(b, f, g):
    """Add the torques of gears that only rotate, by the change of energy with their mean travel."""
    half = 0.5 * b["now"]["by_travel"]
    s1 = half * b["r_b1"]
    s2 = half * b["r_b2"]
    m = b["now"]["m"]
    for k in range(3):
        f["F"][3 + k] -= s1 * m[k]
        g["F"][3 + k] += s2 * m[k]


@kernel
def add_spin_tangent(b, kk, c):
    """Add the tangent `c` of the base-tangent force by the travel."""
    m = b["now"]["m"]
    r1 = b["r_b1"]
    r2 = b["r_b2"]
    for k in range(3):
        for n in range(3):
            s = c * m[k] * m[n]
            kk[b["request"]["ii"], 3 + k, 3 + n] += r1 * r1 * s
            kk[b["request"]["ij"], 3 + k, 3 + n] += r1 * r2 * s
            kk[b["request"]["ji"], 3 + k, 3 + n] += r1 * r2 * s
            kk[b["request"]["jj"], 3 + k, 3 + n] += r2 * r2 * s
