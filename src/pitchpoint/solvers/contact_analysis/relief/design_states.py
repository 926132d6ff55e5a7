# SPDX-License-Identifier: Apache-2.0
"""Static states of flexible teeth for one design of the modifications after another, in compiled code.

Positions of the contact nodes, their compliance and their local contact depend on the mesh phase alone.
They are stored once for every phase; a design changes the gaps of the nodes only.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.contact.local_approach import N_NODE
from pitchpoint.contact.unilateral_load import solve_load
from pitchpoint.contact.unilateral_work import CONTACT_STATE, FORCE, LISTED, N_VECTOR, forget
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.mesh.flank_modifications import modification_at, second_derivative_at
from pitchpoint.geometry.modification_terms import N_TERM
from pitchpoint.multibody.channels import F8, I8

#: Contact node of a mesh phase.
PLACED = np.dtype(
    [
        ("gap", "f8"),  # without modifications, at zero approach [m]
        ("t", "f8", 2),
        ("zeta", "f8", 2),  # relative height and width on both gears
        ("press", "f8"),  # pressure of the involutes over the root of the force [Pa/N^0.5], 0 on tip edges
        (
            "curved",
            "f8",
            (2, 2),
        ),  # added curvature over that of the involutes, by slope and second derivative
        ("edge", "f8"),  # 1 on tip edges, else 0
    ],
    align=True,
)

#: Mesh phase: number of nodes; addresses of the nodes [n], compliances [n, n] and local contacts [n, N_NODE].
PHASE = np.dtype([("n", "i8"), ("nodes", "i8"), ("C", "i8"), ("local", "i8")], align=True)

#: Result at a phase and a load.
FOUND = np.dtype(
    [
        ("load", "f8"),  # given: force along the base tangent [N]
        ("approach", "f8"),  # of the flanks along the base tangent [m]
        ("pressure", "f8"),  # maximum Hertzian pressure on the path of contact [Pa]
        ("edge", "f8"),  # share of the load on tip edges
        ("status", "i8"),
    ],
    align=True,
)

#: One design: addresses of its rows [2, N_TERM], of phases and results [phase, load], and of a workspace.
DESIGN = np.dtype(
    [
        ("rows", "i8"),
        ("phases", "i8"),
        ("n_phase", "i8"),
        ("found", "i8"),
        ("n_load", "i8"),
        ("gaps", "i8"),  # scratch [2, nodes]: gaps and weights
        ("most", "i8"),  # maximum number of nodes
        ("width", "i8"),  # of the arrays of the solver
        ("state", "i8"),
        ("on", "i8"),
        ("v", "i8"),
        ("U", "i8"),
    ],
    align=True,
)


@kernel
def set_gaps(rows, nodes, gaps):
    """Gaps of the nodes with the modifications of both gears, at zero approach [m]."""
    for i in range(nodes.size):
        gap = nodes[i]["gap"]
        for gear in range(2):
            gap += modification_at(rows[gear], nodes[i]["t"][gear], nodes[i]["zeta"][gear])[0]
        gaps[i] = gap


@kernel
def node_pressure(rows, node, force):
    """Hertzian pressure of a node with the curvature of the modifications [Pa].

    0 on tip edges, and where a hollow flank is not convex within its mate.
    """
    curvature = 1.0
    for gear in range(2):
        slope = modification_at(rows[gear], node["t"][gear], 0.0)[1]
        second = second_derivative_at(rows[gear], node["t"][gear])
        curvature += node["curved"][gear, 0] * slope + node["curved"][gear, 1] * second
    return node["press"] * math.sqrt(force * max(curvature, 0.0))


@kernel
def set_pressures(rows, nodes, forces, out):
    """Hertzian pressures of nodes [Pa], shape of `forces`."""
    for i in range(nodes.size):
        out[i] = node_pressure(rows, nodes[i], forces[i])


@kernel
def _summarise(rows, found, nodes, state, on, v):
    """Set maximum pressure and share of tip edges of a solution."""
    pressure = 0.0
    edge = 0.0
    for k in range(state["m"]):
        i = on[LISTED, k]
        force = v[FORCE, i]
        pressure = max(pressure, node_pressure(rows, nodes[i], force))
        edge += nodes[i]["edge"] * force
    found["approach"] = state["approach"]
    found["pressure"] = pressure
    found["edge"] = edge / found["load"]


@kernel
def solve_design(_, where, n):
    """Solve n designs; `where`: their address. Each phase starts anew, its loads from the ones before."""
    designs = view(where, n, DESIGN)
    worst = OK
    for k in range(n):
        d = designs[k]
        rows = view(d["rows"], (2, N_TERM), F8)
        phases = view(d["phases"], d["n_phase"], PHASE)
        found = view(d["found"], (d["n_phase"], d["n_load"]), FOUND)
        w = d["width"]
        state = view(d["state"], 1, CONTACT_STATE)[0]
        on = view(d["on"], (2, w), I8)
        v = view(d["v"], (N_VECTOR, w), F8)
        U = view(d["U"], (w, w), F8)
        for p in range(d["n_phase"]):
            m = phases[p]["n"]
            nodes = view(phases[p]["nodes"], m, PLACED)
            C = view(phases[p]["C"], (m, m), F8)
            local = view(phases[p]["local"], (m, N_NODE), F8)
            gaps = view(d["gaps"], m, F8)
            weights = view(d["gaps"] + 8 * d["most"], m, F8)
            set_gaps(rows, nodes, gaps)
            for i in range(m):
                weights[i] = 1.0
            forget(w, state, v)
            state["approach"] = 0.0
            for q in range(d["n_load"]):
                one = found[p, q]
                one["status"] = solve_load(C, local, gaps, weights, one["load"], state, on, v, U)
                worst = max(worst, one["status"])
                _summarise(rows, one, nodes, state, on, v)
    return worst
