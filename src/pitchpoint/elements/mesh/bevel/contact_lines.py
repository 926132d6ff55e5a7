# SPDX-License-Identifier: Apache-2.0
"""Contact lines of one flank of a bevel mesh, positions and loads, for the scene.

Counterpart of `mesh.contact_lines` with the same requests. The loads are those of the nodes in
`flank_forces`. Contact lines are straight in the coordinate zeta = R_m ln(R/R_m) along the face; stations are
equidistant in it.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.bevel_mesh import begin_side
from pitchpoint.elements.mesh.bevel.flank_forces import first_and_last, pair_node, sum_pair
from pitchpoint.elements.mesh.bevel.record import PROFILE, RECORD, ROWS
from pitchpoint.elements.mesh.contact_lines import INSIDE, LINES
from pitchpoint.elements.mesh.line_of_action import countable
from pitchpoint.elements.mesh.sums import begin_sums
from pitchpoint.multibody.channels import F8


@kernel
def _loads(b, p_0, loads):
    """Loads per face width at equidistant stations on the part of a contact line within the flanks."""
    now = b["now"]
    R_m = b["R_m"]
    lam = now["lam"]
    a = math.log1p(b["z_lo"] / R_m)
    end = math.log1p(b["z_hi"] / R_m)
    if lam != 0.0:
        u = -p_0 / lam
        v = (now["eps"] - p_0) / lam
        a = max(a, min(u, v))
        end = min(end, max(u, v))
    n = loads.size
    for s in range(n):
        share = INSIDE + (1.0 - 2.0 * INSIDE) * s / (n - 1)
        R = R_m * math.exp(a + share * (end - a))
        if R >= R_m + now["lo"] and R <= R_m + now["hi"]:
            loads[s] = pair_node(b, None, p_0, R, 1.0)


@kernel
def contact_lines(b, question):
    """Forces and loads of all tooth pairs of one flank, for bodies at rest."""
    now = b["now"]
    n = b["n_pair"]
    stations = question["stations"]
    forces = view(question["forces"], n, F8)
    loads = view(question["loads"], (n, stations), F8)
    flank = question["flank"]
    deflection = question["deflection"]
    begin_side(b, flank, deflection)
    for row in range(ROWS):
        b["rate"][row] = 0.0
    b["request"]["jac"] = 0
    begin_sums(b)
    question["pairs"] = now["tooth"]
    question["psi"] = now["psi"]
    for k in range(n):
        forces[k] = 0.0
        for s in range(stations):
            loads[k, s] = 0.0
    if b["source"] != PROFILE or n == 0 or now["eps"] <= 0.0:
        return
    if countable(deflection, now["travel"], b["p_bt"], now["eps"]) != OK:
        return
    q, last = first_and_last(b)
    while q <= last:
        slot = (now["tooth"] - int(q)) % n
        forces[slot] += flank * sum_pair(b, None, q)
        _loads(b, now["psi"] + q, loads[slot])
        q += 1.0


@kernel
def answer(_, where, n):
    """Evaluate n flank requests; `where` is the address of the first."""
    questions = view(where, n, LINES)
    for k in range(n):
        contact_lines(view(questions[k]["record"], 1, RECORD)[0], questions[k])
    return OK
