# SPDX-License-Identifier: Apache-2.0
"""States of one flank at given positions of the gears: static contact analysis of tooth surfaces.

A state is given by the mesh phase, the centre distance, the misalignment and either the penetration at the
pitch point or the force along the base tangent. The mesh has been evaluated before, so its record contains
the line of action; the kernels are those of the mesh element, with all velocities zero.
"""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.kernel import call, kernel, view
from pitchpoint.core.status import BAD_CENTRE, DIVERGED, NOT_FINITE, OK
from pitchpoint.elements.mesh.line_of_action import place_gears
from pitchpoint.elements.mesh.record import RECORD, ROWS
from pitchpoint.elements.mesh.sums import begin_sums
from pitchpoint.elements.mesh.surface.nodes import (
    NODE,
    begin_pair,
    begin_surface,
    first_pair,
    node_array,
    plane_point,
    planes_of,
    set_node,
)

#: One state of a flank.
STATE = np.dtype(
    [
        ("record", "i8"),  # address of the record of the mesh
        ("flank", "i8"),  # 1 front, -1 back
        ("pairs", "i8"),
        ("psi", "f8"),  # mesh phase: whole base pitches and fraction
        ("distance", "f8"),  # signed centre distance [m]
        ("dz", "f8"),  # axial offset of the gears [m]
        ("kappa", "f8"),  # loss of penetration over the width [rad]
        ("by_force", "i8"),  # 1: `force` is given, 0: `x_0`
        ("x_0", "f8"),  # penetration at the pitch point [m]
        ("force", "f8"),  # along the base tangent [N]
        ("first", "f8"),  # results: penetration at first contact [m]
        ("stiffness", "f8"),  # derivative of the force by x_0 [N/m]
        ("energy", "f8"),  # [J]
        ("moment", "f8"),  # of the force about the pitch point, in the plane of action [N m]
        ("by_travel", "f8"),
        ("by_tan", "f8"),  # as in the scratch of the record
        ("evaluations", "i8"),
        ("status", "i8"),
        ("n_nodes", "i8"),
        ("nodes", "i8"),  # address of the nodes [max_nodes], 0: not required
    ],
    align=True,
)

_CLEAR = 1e-2
"""Penetration at which all nodes within reach are placed, in base pitches."""
_STEPS = 60
"""Maximum number of Newton steps; three to five are needed."""
_CONVERGED = 1e-11
"""Error of the force, relative."""


@kernel
def _begin(b, state):
    """Set the scratch of a flank at the place of a state; returns a status."""
    now = b["now"]
    a = state["distance"]
    r_b = b["r_b1"] + b["r_b2"]
    if not a * a > r_b * r_b:
        return BAD_CENTRE
    now["a"] = a
    now["dz"] = state["dz"]
    place_gears(b, r_b / a)
    now["flank"] = state["flank"]
    now["psi"] = state["psi"]
    now["tooth"] = state["pairs"]
    now["lam"] = state["flank"] * b["tan_b"] / b["p_bt"]
    now["kappa"] = state["kappa"]
    now["tilt"] = 0.0
    now["travel_rate"] = 0.0
    now["xi_A_rate"] = 0.0
    now["dz_rate"] = 0.0
    now["lo_rate"] = 0.0
    now["hi_rate"] = 0.0
    for k in range(ROWS):
        b["rate"][k] = 0.0
    b["request"]["jac"] = 1
    b["request"]["ck"] = 1.0
    b["request"]["cd"] = 0.0
    b["request"]["out"] = 0
    b["request"]["ev"] = 0
    return OK


@kernel
def first_contact(b):
    """Penetration at the pitch point at which the first node of the current flank comes into contact [m]."""
    now = b["now"]
    begin_surface(b)
    clear = _CLEAR * b["p_bt"]
    now["x_0"] = clear
    node = node_array(b)[0]
    nearest = -math.inf
    planes = planes_of(b)
    q, count = first_pair(b)
    for _ in range(count):
        own = begin_pair(b, q)
        for s in range(b["slices"]):
            z, xi, place, eta, _ = plane_point(planes, q, s)
            if eta <= b["reach"]:
                set_node(b, node, xi, z, place, eta, own)
                nearest = max(nearest, node["x"])
        q += 1
    return clear - nearest


@kernel
def flank_at(b, x_0):
    """Sum the current flank at a penetration; returns a status."""
    b["now"]["x_0"] = x_0
    begin_sums(b)
    return call(b["flexible"] if b["is_flexible"] == 1 else b["rigid"], b["here"], 1, 0)


@kernel
def _find(b, state):
    """Penetration at which the flank carries the given force, by Newton's method within a bracket."""
    sums = b["sums"]
    aim = state["force"]
    low = state["first"]
    high = math.inf
    x = state["x_0"] if state["x_0"] > low else low + aim / b["k_step"]
    for k in range(_STEPS):
        status = flank_at(b, x)
        state["evaluations"] = k + 1
        if status != OK:
            return status
        force = sums["force"][0]
        if not math.isfinite(force):
            return NOT_FINITE
        if abs(force - aim) <= _CONVERGED * aim:
            state["x_0"] = x
            return OK
        if force > aim:
            high = x
        else:
            low = x
        slope = sums["tangent"][0, 0]
        step = (aim - force) / slope if slope > 0.0 else math.inf
        x += step
        if not (x > low and x < high):
            x = 0.5 * (low + high) if math.isfinite(high) else 2.0 * low - state["first"] + aim / b["k_step"]
        if high - low <= 1e-15:
            state["x_0"] = x
            return OK
    return DIVERGED


@kernel
def _solve(b, state):
    """Solve one state."""
    state["n_nodes"] = 0
    state["evaluations"] = 0
    status = _begin(b, state)
    if status != OK:
        return status
    state["first"] = first_contact(b)
    if not math.isfinite(state["first"]):
        return NOT_FINITE
    if state["by_force"] == 0:
        status = flank_at(b, state["x_0"])
        state["force"] = b["sums"]["force"][0]
    else:
        status = _find(b, state)
    sums = b["sums"]
    state["stiffness"] = sums["tangent"][0, 0]
    state["energy"] = sums["energy"]
    state["moment"] = sums["force"][1]
    state["by_travel"] = b["now"]["by_travel"]
    state["by_tan"] = b["now"]["by_tan"]
    state["n_nodes"] = b["n_nodes"]
    if state["nodes"] != 0:
        nodes = node_array(b)
        kept = view(state["nodes"], b["max_nodes"], NODE)
        for k in range(b["n_nodes"]):
            kept[k] = nodes[k]
    return status


@kernel
def solve_states(_, where, n):
    """Solve n states in order, each starting from the solution of the one before; `where`: their address."""
    states = view(where, n, STATE)
    worst = OK
    for k in range(n):
        state = states[k]
        b = view(state["record"], 1, RECORD)[0]
        b["here"] = state["record"]
        state["status"] = _solve(b, state)
        worst = max(worst, state["status"])
    return worst
