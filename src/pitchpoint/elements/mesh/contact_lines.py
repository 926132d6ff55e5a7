# SPDX-License-Identifier: Apache-2.0
"""Contact lines of one flank of a mesh, positions and loads, for graphics.

Not used by solvers. The mesh has been evaluated before, so its record contains the line of action; the loads
are those of the nodes of `mesh.tooth_pairs`. With the bodies at rest they are the elastic part.

A tooth pair has a constant number N while in mesh: its contact line is p(z) = phase - N + lam z from the
start A of the path of contact, in base pitches. Slot N mod n_pair is that of its channel `pair_force`.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.mesh.flank_deviations import begin_separation, find_rows
from pitchpoint.elements.mesh.force_directions import flank_tilt
from pitchpoint.elements.mesh.line_of_action import begin_flank, countable
from pitchpoint.elements.mesh.record import PHASE, RECORD, ROWS, SURFACE
from pitchpoint.elements.mesh.sums import begin_sums
from pitchpoint.elements.mesh.surface.nodes import node_array
from pitchpoint.elements.mesh.surface.states import flank_at
from pitchpoint.elements.mesh.tooth_pairs import pair_line, pair_node, pair_teeth
from pitchpoint.multibody.channels import F8

#: Request for one flank, with its result.
LINES = np.dtype(
    [
        ("record", "i8"),  # address of the record of the mesh
        ("flank", "i8"),  # 1 front, -1 back
        ("deflection", "f8"),  # travel of the gears along the base tangent less the excitation [m]
        ("stations", "i8"),  # stations along each line, at least 2
        ("pairs", "i8"),  # result: whole base pitches, and
        ("psi", "f8"),  # fraction: pairs + psi is the phase of the flank
        ("forces", "i8"),  # address of the forces of the slots [n_pair], base tangent, front positive [N]
        ("loads", "i8"),  # address of their loads [n_pair, stations], per width [N/m]
    ],
    align=True,
)

INSIDE = 1e-9
"""Distance of the first and last station from the ends of a line, where loads may jump, over its length."""


@kernel
def _begin(b, flank, deflection):
    """Set the scratch for the nodes of a flank with bodies at rest; returns the penetration of the flank."""
    now = b["now"]
    begin_flank(b, flank, 1.0)
    now["kappa"] = 0.0
    if b["fixed"] == 0:
        flank_tilt(b, flank)
    now["tilt"] = now["kappa"] * (1.0 + b["tan_b"] * b["tan_b"])
    now["growth"] = 0.0
    for k in range(ROWS):
        b["rate"][k] = 0.0
    b["request"]["jac"] = 0
    b["request"]["out"] = 0
    b["request"]["ev"] = 0
    begin_sums(b)
    if b["n_sep"] > 0:
        begin_separation(b)
    return flank * deflection - 0.5 * now["gap"]


@kernel
def _loads(b, p_0, x_q, deviating, loads):
    """Loads per face width at equidistant stations on the part of a contact line within the flanks."""
    a, end = _line_ends(b, p_0)
    n = loads.size
    for s in range(n):
        share = INSIDE + (1.0 - 2.0 * INSIDE) * s / (n - 1)
        loads[s] = pair_node(b, None, p_0, x_q, a + share * (end - a), 1.0, deviating)


@kernel
def _line_ends(b, p_0):
    """Ends of the part of a contact line within the flanks [m from the pitch point]."""
    now = b["now"]
    lam = now["lam"]
    if lam == 0.0:
        return now["z_lo"], now["z_hi"]
    u = -p_0 / lam
    v = (now["eps"] - p_0) / lam
    return max(now["z_lo"], min(u, v)), min(now["z_hi"], max(u, v))


@kernel
def _surface_loads(b, x_0, forces, loads):
    """Forces and loads of all pairs of tooth surfaces; loads are linear between the contact planes."""
    now = b["now"]
    if flank_at(b, x_0) != OK:
        return
    nodes = node_array(b)
    planes = b["slices"]
    width = (now["z_hi"] - now["z_lo"]) / planes
    stations = loads.shape[1]
    for k in range(b["n_nodes"]):
        node = nodes[k]
        slot = node["pair"] % b["n_pair"]
        forces[slot] += now["flank"] * node["elastic"]
        a, end = _line_ends(b, now["psi"] + now["tooth"] - node["pair"])
        for s in range(stations):
            z = a + s / (stations - 1) * (end - a)
            plane = min(max((z - now["z_lo"]) / width - 0.5, 0.0), planes - 1.0)
            loads[slot, s] += node["elastic"] / width * max(0.0, 1.0 - abs(plane - node["plane"]))


@kernel
def contact_lines(b, question):
    """Forces and loads of all tooth pairs of one flank."""
    now = b["now"]
    n = b["n_pair"]
    stations = question["stations"]
    forces = view(question["forces"], n, F8)
    loads = view(question["loads"], (n, stations), F8)
    flank = question["flank"]
    deflection = question["deflection"]
    x_0 = _begin(b, flank, deflection)
    question["pairs"] = now["tooth"]
    question["psi"] = now["psi"]
    for k in range(n):
        forces[k] = 0.0
        for s in range(stations):
            loads[k, s] = 0.0
    if b["source"] == PHASE or n == 0 or now["eps"] <= 0.0 or now["z_hi"] <= now["z_lo"]:
        return
    if countable(deflection, now["travel"], b["p_bt"], now["eps"]) != OK:
        return
    if b["source"] == SURFACE:
        _surface_loads(b, x_0, forces, loads)
        return
    middle = now["psi"] + 0.5 * now["lam"] * (now["z_lo"] + now["z_hi"])
    reach = 0.5 * abs(now["lam"]) * (now["z_hi"] - now["z_lo"])
    q = float(math.ceil(-middle - reach))
    last = math.floor(now["eps"] - middle + reach)
    while q <= last:
        p_0 = now["psi"] + q
        x_q = x_0 - now["kappa"] * flank * b["tan_b"] * (now["xi_A"] + p_0 * b["p_bt"])
        slot = (now["tooth"] - int(q)) % n
        if b["n_sep"] > 0 and find_rows(b, pair_teeth(b, q)):
            forces[slot] += flank * pair_line(b, None, p_0, x_q, 1)
            _loads(b, p_0, x_q, 1, loads[slot])
        else:
            forces[slot] += flank * pair_line(b, None, p_0, x_q, None)
            _loads(b, p_0, x_q, None, loads[slot])
        q += 1.0


@kernel
def answer(_, where, n):
    """Evaluate n flank requests; `where` is the address of the first."""
    questions = view(where, n, LINES)
    for k in range(n):
        contact_lines(view(questions[k]["record"], 1, RECORD)[0], questions[k])
    return OK
