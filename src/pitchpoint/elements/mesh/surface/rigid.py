# SPDX-License-Identifier: Apache-2.0
"""Rigid tooth surfaces: force of each contact plane from its penetration, k x^power.

The planes and tooth pairs are independent of each other. Stiffness and exponent apply to the whole face width
of one pair; a plane has its share of the width.

Source: Adams Machinery, "Gear Pair (Advanced 3D Contact)", contact of rigid gears.
"""

from __future__ import annotations

from pitchpoint.contact.flank_law import flank_energy, flank_force
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK, UNBOUNDED
from pitchpoint.elements.mesh.nodes import set_levers
from pitchpoint.elements.mesh.observations import add_pair_force
from pitchpoint.elements.mesh.record import N_OUT, RECORD
from pitchpoint.elements.mesh.surface.losses import farthest_gap, with_losses
from pitchpoint.elements.mesh.surface.nodes import (
    ON_PATH,
    add_plain_slopes,
    add_slopes,
    add_to_sums,
    begin_pair,
    begin_surface,
    first_pair,
    is_far,
    node_array,
    node_rate,
    plain_rate,
    plane_point,
    planes_of,
    reaches,
    set_node,
    tip_bounds,
)


@kernel
def _store(b, node, x, u, k, soft):
    """Add the energy of the node, and its slopes by the common width and by the compliance of cracks."""
    now = b["now"]
    energy, _, by_soft = flank_energy(b["contact"], x, u, k, 0.0, soft)
    b["sums"]["energy"] += energy
    now["by_dz"] += energy * now["growth"]
    if soft == 0.0:
        return
    slope = by_soft / now["plane_step"]
    of_roll = node["soft_by_roll"]
    of_z = node["soft_by_z"]
    by_xi = of_roll[0] * node["roll_by_xi"][0] + of_roll[1] * node["roll_by_xi"][1]
    by_tan = of_roll[0] * node["roll_by_tan"][0] + of_roll[1] * node["roll_by_tan"][1]
    add_slopes(b, node, 0.0, slope * by_xi, slope * by_tan, (slope * of_z[0], slope * of_z[1]))


@kernel
def _add(b, watch, node, x, w, soft, k):
    """Add a node with the current levers to the sums, without slopes; returns its force.

    `x`: penetration [m]; `w`: its rate [m/s]; `soft`: compliance in series [m/N]. `node` is used only with
    observations, or with a compliance.
    """
    sums = b["sums"]
    elastic = 0.0
    stiffness = 0.0
    f = by_x = by_w = 0.0
    if x > 0.0:
        f, by_x, by_w, elastic, stiffness, u, _ = flank_force(b["contact"], x, k, 0.0, w, soft)
        if watch == 1 or b["now"]["growth"] != 0.0 or soft > 0.0:
            _store(b, node, x, u, k, soft)
    f, by_x, film_by_x, by_w = with_losses(b, x, w, (elastic, stiffness), (f, by_x, by_w))
    if watch == 1:
        node["rate"] = w
        node["elastic"] = elastic
        node["force"] = f
        sums["pushed"] += f
        sums["stiffness"] += stiffness
        sums["damping_power"] += (f - elastic) * w
        if f > 0.0:
            sums["nearest"] = max(sums["nearest"], abs(x))
    if f > 0.0:
        add_to_sums(b, f, b["request"]["ck"] * (by_x + film_by_x) + b["request"]["cd"] * by_w)
    return f


@kernel
def rigid_flank(record, watch, _):
    """Sum the current flank. `watch` 1: with observations; its nodes with forces then remain in the pool."""
    b = view(record, 1, RECORD)[0]
    b["n_nodes"] = 0
    if b["c_prime"] == 0.0:  # solvers remove the mesh spring in this way
        return OK
    now = b["now"]
    begin_surface(b)
    k = b["c_prime"] * now["plane_step"]
    planes, bounds = planes_of(b), tip_bounds(b)
    nodes = node_array(b)
    found = 0
    # slopes of plain nodes are linear over the width: those of their resultant
    resultant = 0.0
    moment = 0.0
    far = farthest_gap(b)
    q, count = first_pair(b)
    for _ in range(count):
        if is_far(planes, bounds, q, b["slices"] - 1):
            q += 1
            continue
        own = begin_pair(b, q)
        force = 0.0
        for s in range(b["slices"]):
            z, xi, place, eta, x = plane_point(planes, q, s)
            if not reaches(bounds, place, eta, x):
                if watch == 1 and place == 0:
                    b["sums"]["nearest"] = max(b["sums"]["nearest"], x)
                continue
            if found == nodes.size:  # gears far from their places
                return UNBOUNDED
            node = nodes[found]
            soft = 0.0
            plain = not own and place == ON_PATH
            if watch == 1 or not plain:
                node["pair"] = now["tooth"] - q
                node["plane"] = s
                set_node(b, node, xi, z, place, eta, own)
                x = node["x"]
                soft = node["soft"] / now["plane_step"]
            if x <= -far:
                b["sums"]["nearest"] = max(b["sums"]["nearest"], x)
                continue
            set_levers(b, z, xi)
            w = plain_rate(b, z) if plain else node_rate(b, node)
            f = _add(b, watch, node, x, w, soft, k)
            if plain:
                resultant += f
                moment += f * z
            elif f > 0.0:
                add_slopes(b, node, f, 0.0, 0.0, (0.0, 0.0))
            force += f
            found += 1
        if watch == 1 and b["request"]["out"] != 0 and b["n_pair"] > 0:
            add_pair_force(b, N_OUT, (now["tooth"] - q) % b["n_pair"], now["flank"] * force)
        q += 1
    if watch == 1:
        b["n_nodes"] = found
    if resultant > 0.0:
        add_plain_slopes(b, resultant, moment / resultant)
    return OK
