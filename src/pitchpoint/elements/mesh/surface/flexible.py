# SPDX-License-Identifier: Apache-2.0
"""Flexible teeth: forces of all contact nodes of a flank from the unilateral contact problem.

The nodes of all planes and pairs are coupled by the compliance of teeth and bodies (`surface.compliance`) and
have a local Hertzian approach. The forces follow from the penetrations in each evaluation (`contact.
unilateral`), starting from the last solution. The stored energy is

    U = max over f >= 0 of f x - f C f/2 - sum Psi(f)

and all forces on the gears are its slopes: those of the penetrations, and those of the compliances, which
change as the contact moves over the teeth.
"""

from __future__ import annotations

from pitchpoint.contact.flank_law import flank_friction, node_damping
from pitchpoint.contact.local_approach import energy_slopes
from pitchpoint.contact.unilateral import contact_energy, solve_contact, solve_tangent, tangent_block
from pitchpoint.contact.unilateral_work import FORCE, LISTED
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK, UNBOUNDED
from pitchpoint.elements.mesh.observations import add_pair_force
from pitchpoint.elements.mesh.record import N_OUT, RECORD
from pitchpoint.elements.mesh.sums import FRICTION_ROWS
from pitchpoint.elements.mesh.surface.compliance import assemble, local_slopes
from pitchpoint.elements.mesh.surface.losses import farthest_gap, with_losses
from pitchpoint.elements.mesh.surface.nodes import (
    add_slopes,
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
from pitchpoint.elements.mesh.surface.scratch import flexible_arrays, slope_arrays, solver_arrays


@kernel
def place_nodes(b, watch):
    """Place all nodes of the current flank that may have forces; returns their number, or -1 if gears far
    from their places have more than the pool holds."""
    now = b["now"]
    begin_surface(b)
    planes, bounds = planes_of(b), tip_bounds(b)
    nodes = node_array(b)
    far = farthest_gap(b)
    found = 0
    first = 0
    q, count = first_pair(b)
    for _ in range(count):
        if is_far(planes, bounds, q, b["slices"] - 1):
            q += 1
            continue
        own = begin_pair(b, q)
        for s in range(b["slices"]):
            z, xi, place, eta, x = plane_point(planes, q, s)
            if not reaches(bounds, place, eta, x):
                if watch == 1 and place == 0:
                    b["sums"]["nearest"] = max(b["sums"]["nearest"], x)
                continue
            if found == nodes.size:
                return -1
            node = nodes[found]
            if found == 0:
                first = q
            node["pair"] = now["tooth"] - q
            node["slot"] = q - first
            node["plane"] = s
            set_node(b, node, xi, z, place, eta, own)
            if node["x"] > -far:
                found += 1
            elif watch == 1:
                b["sums"]["nearest"] = max(b["sums"]["nearest"], node["x"])
        q += 1
    b["n_nodes"] = found
    return found


@kernel
def _recall(b, nodes, n, slots, kept, state, on, v):
    """Forces of the last solution as the start of this one; its factor too if the nodes are the same.

    Forces are kept by tooth pair and plane, in whose order `slots` has the nodes of the last solution.
    """
    planes = b["slices"]
    if b["n_slots"] < 0:
        for k in range(kept.size):
            kept[k] = 0.0
    same = b["n_slots"] == n
    for i in range(n):
        slot = (nodes[i]["pair"] % b["n_slot_pairs"]) * planes + nodes[i]["plane"]
        same = same and slots[i] == slot
        slots[i] = slot
    b["n_slots"] = n
    if same:
        return
    m = 0
    for i in range(n):
        f = kept[slots[i]]
        v[FORCE, i] = f
        if f > 0.0:
            on[LISTED, m] = i
            m += 1
    state["m"] = m
    state["factored"] = 0
    state["exact"] = 0


@kernel
def _remember(b, n, slots, kept, v):
    """Keep the forces for the next solution."""
    for k in range(b["n_slot_pairs"] * b["slices"]):
        kept[k] = 0.0
    for i in range(n):
        kept[slots[i]] = v[FORCE, i]


@kernel
def solve_nodes(b, n):
    """Solve the contact problem of the placed nodes, whose compliances are set; returns a status."""
    nodes = node_array(b)
    x, local, C, slots, kept = flexible_arrays(b, n)
    states, on, v, U = solver_arrays(b)
    state = states[0]
    for i in range(n):
        x[i] = nodes[i]["x"]
    _recall(b, nodes, n, slots, kept, state, on, v)
    status = solve_contact(C, local, x, state, on, v, U)
    if status != OK:
        b["n_slots"] = -1
        return status
    _remember(b, n, slots, kept, v)
    for i in range(n):
        nodes[i]["elastic"] = v[FORCE, i]
    return OK


@kernel
def _damped(b, node, elastic, k):
    """Total force of a node; factor of the change of the elastic force in it, derivatives by x at constant
    elastic force, and by rate.

    `k`: typical stiffness of the node, to which its damping coefficient is proportional.
    """
    damping = factor = by_w = 0.0
    if elastic > 0.0:
        damping, factor, by_w = node_damping(b["contact"], elastic, k, node["rate"])
        factor += 1.0
    found = (elastic + damping, factor, by_w)
    return with_losses(b, node["x"], node["rate"], (elastic, 1.0), found)


@kernel
def _add_tangent(b, state, on, v, U, side, factors):
    """Add the tangent of the elastic forces by the motions along the rows of the normal force."""
    nodes = node_array(b)
    lever = b["lever"]
    tangent = b["sums"]["tangent"]
    rows = lever.size
    normal = 2
    ck = b["request"]["ck"]
    listed = on[LISTED]
    m = state["m"]
    for q in range(normal):
        for k in range(m):
            node = nodes[listed[k]]
            levers_of(b, node)
            side[k] = lever[q]
        for k in range(m, side.size):
            side[k] = 0.0
        solve_tangent(state, v, U, side)
        for k in range(m):
            i = listed[k]
            levers_of(b, nodes[i])
            c = ck * factors[i] * side[k]
            for p in range(normal):
                tangent[p, q] += c * lever[p]
            if b["contact"]["mu"] > 0.0:
                slip = 0.0
                for p in range(rows - FRICTION_ROWS, rows):
                    slip += lever[p] * b["rate"][p]
                by_f = flank_friction(b["contact"], 1.0, slip)[1]
                for p in range(rows - FRICTION_ROWS, rows):
                    tangent[p, q] += by_f * c * lever[p]


@kernel
def _add_node_tangent(b, c, by_f, by_v):
    """Add the tangents of a node alone: `c` of the normal force by film and velocities, `by_v` of friction by
    sliding."""
    lever = b["lever"]
    tangent = b["sums"]["tangent"]
    rows = lever.size
    normal = rows - FRICTION_ROWS
    for p in range(rows):
        for q in range(rows):
            if q < normal:
                s = c * lever[q] * (1.0 if p < normal else by_f)
                tangent[p, q] += s * lever[p]
            elif p >= normal:
                tangent[p, q] += by_v * lever[p] * lever[q]


@kernel
def _add_node(b, watch, i, node, k, factors):
    """Add the forces of a node to the sums, without the tangent of its elastic force; returns its force."""
    sums = b["sums"]
    lever = b["lever"]
    rows = lever.size
    normal = rows - FRICTION_ROWS
    levers_of(b, node)
    node["rate"] = node_rate(b, node)
    elastic = node["elastic"]
    f, factors[i], film_by_x, by_w = _damped(b, node, elastic, k)
    node["force"] = f
    sums["damping_power"] += (f - elastic) * node["rate"]
    if f == 0.0:
        return 0.0
    for p in range(normal):
        sums["force"][p] += f * lever[p]
    sums["pushed"] += f
    by_f = 0.0
    by_v = 0.0
    if b["contact"]["mu"] > 0.0:
        slip = 0.0
        for p in range(normal, rows):
            slip += lever[p] * b["rate"][p]
        friction, by_f, by_v = flank_friction(b["contact"], f, slip)
        for p in range(normal, rows):
            sums["force"][p] += friction * lever[p]
        sums["friction_power"] += friction * slip
    if b["request"]["jac"] != 0:
        cd = b["request"]["cd"]
        c = b["request"]["ck"] * film_by_x + cd * by_w
        if c != 0.0 or cd * by_v != 0.0:
            _add_node_tangent(b, c, by_f, cd * by_v)
    return f


@kernel
def _add_energy_slopes(b, i, node, forces, slopes, local):
    """Add the slopes of the energy by the motion of the node over the flanks."""
    elastic = node["elastic"]
    by_xi = 0.0
    by_tan = 0.0
    of_soft = 0.0
    if elastic > 0.0:
        by_1 = 0.0
        by_2 = 0.0
        for j in range(slopes.shape[1]):
            by_1 += slopes[0, j] * forces[j]
            by_2 += slopes[1, j] * forces[j]
        by_radius, by_t1, by_t2, _ = energy_slopes(local, i, elastic)
        local_1, local_2 = local_slopes(b, node, by_radius, (by_t1, by_t2))
        of_soft = 0.5 * elastic * elastic / b["plane_width"]
        by_1 = by_1 * elastic + local_1 + of_soft * node["soft_by_roll"][0]
        by_2 = by_2 * elastic + local_2 + of_soft * node["soft_by_roll"][1]
        by_xi = -(by_1 * node["roll_by_xi"][0] + by_2 * node["roll_by_xi"][1])
        by_tan = -(by_1 * node["roll_by_tan"][0] + by_2 * node["roll_by_tan"][1])
    by_z = (-of_soft * node["soft_by_z"][0], -of_soft * node["soft_by_z"][1])
    add_slopes(b, node, node["force"], by_xi, by_tan, by_z)


@kernel
def flexible_flank(record, watch, _):
    """Sum the current flank; its nodes remain in the pool. `watch` 1: with observations."""
    b = view(record, 1, RECORD)[0]
    b["n_nodes"] = 0
    if b["c_prime"] == 0.0:  # solvers remove the mesh spring in this way
        return OK
    now = b["now"]
    n = place_nodes(b, watch)
    if n <= 0:
        return OK if n == 0 else UNBOUNDED
    nodes = node_array(b)
    sums = b["sums"]
    x, local, C, slots, kept = flexible_arrays(b, n)
    legs, slopes = slope_arrays(b, n)
    assemble(b, nodes, n, legs, local, C, slopes)
    status = solve_nodes(b, n)
    if status != OK:
        return status
    factors = x  # penetrations are no longer used
    states, on, v, U = solver_arrays(b)
    state = states[0]
    m = state["m"]
    k = b["c_prime"] * b["plane_width"]
    for i in range(n):
        node = nodes[i]
        if watch == 1:
            sums["nearest"] = max(sums["nearest"], node["x"])
        f = _add_node(b, watch, i, node, k, factors)
        if f > 0.0 or node["elastic"] > 0.0:
            _add_energy_slopes(b, i, node, v[FORCE], slopes[i], local)
            if watch == 1 and b["request"]["out"] != 0 and b["n_pair"] > 0:
                add_pair_force(b, N_OUT, node["pair"] % b["n_pair"], now["flank"] * f)
    sums["energy"] += contact_energy(local, state, on, v) if watch == 1 else 0.0
    if m == 0 or (b["request"]["jac"] == 0 and watch == 0):
        return OK
    status = tangent_block(C, state, on, v, U)
    if status != OK:
        return status
    if b["request"]["jac"] != 0:
        _add_tangent(b, state, on, v, U, v[_SIDE], factors)
    if watch == 1:
        sums["stiffness"] += _stiffness(state, v, U)
    return OK


_SIDE = 8
"""Row of the vectors of the solver that is free after a solution."""


@kernel
def _stiffness(state, v, U):
    """Derivative of the total force by the penetration of all nodes [N/m]."""
    side = v[_SIDE]
    m = state["m"]
    for k in range(side.size):
        side[k] = 1.0 if k < m else 0.0
    solve_tangent(state, v, U, side)
    total = 0.0
    for k in range(m):
        total += side[k]
    return total
