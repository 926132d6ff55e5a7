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
from pitchpoint.elements.mesh.observations import add_pair_force
from pitchpoint.elements.mesh.record import N_OUT, RECORD
from pitchpoint.elements.mesh.surface.losses import farthest_gap, with_losses
from pitchpoint.elements.mesh.surface.nodes import (
    add_slopes,
    add_to_sums,
    begin_pair,
    begin_surface,
    first_pair,
    is_far,
    levers_of,
    node_array,
    node_rate,
    plane_point,
    planes_of,
    reaches,
    set_node,
    tip_bounds,
)


@kernel
def _store(b, node, k, u, soft):
    """Add the energy of the node, and its slopes by the common width and by the compliance of cracks."""
    now = b["now"]
    energy, _, by_soft = flank_energy(b["contact"], node["x"], u, k, 0.0, soft)
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
def _add(b, watch, node, k):
    """Add the node to the sums; returns its force."""
    sums = b["sums"]
    x = node["x"]
    levers_of(b, node)
    w = node_rate(b, node)
    elastic = 0.0
    stiffness = 0.0
    f = by_x = by_w = 0.0
    if x > 0.0:
        soft = node["soft"]
        if soft > 0.0:
            soft /= b["now"]["plane_step"]
        f, by_x, by_w, elastic, stiffness, u, _ = flank_force(b["contact"], x, k, 0.0, w, soft)
        if watch == 1 or b["now"]["growth"] != 0.0 or soft > 0.0:
            _store(b, node, k, u, soft)
    f, by_x, film_by_x, by_w = with_losses(b, x, w, (elastic, stiffness), (f, by_x, by_w))
    node["rate"] = w
    node["elastic"] = elastic
    node["force"] = f
    if watch == 1:
        sums["pushed"] += f
        sums["stiffness"] += stiffness
        sums["damping_power"] += (f - elastic) * w
    if f == 0.0:
        return 0.0
    sums["nearest"] = max(sums["nearest"], abs(x))
    add_slopes(b, node, f, 0.0, 0.0, (0.0, 0.0))
    c = b["request"]["ck"] * (by_x + film_by_x) + b["request"]["cd"] * by_w
    add_to_sums(b, f, c)
    return f


@kernel
def rigid_flank(record, watch, _):
    """Sum the current flank; its nodes with forces remain in the pool. `watch` 1: with observations."""
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
            node["pair"] = now["tooth"] - q
            node["plane"] = s
            set_node(b, node, xi, z, place, eta, own)
            if node["x"] <= -far:
                b["sums"]["nearest"] = max(b["sums"]["nearest"], node["x"])
                continue
            force += _add(b, watch, node, k)
            found += 1
        if watch == 1 and b["request"]["out"] != 0 and b["n_pair"] > 0:
            add_pair_force(b, N_OUT, (now["tooth"] - q) % b["n_pair"], now["flank"] * force)
        q += 1
    b["n_nodes"] = found
    return OK
