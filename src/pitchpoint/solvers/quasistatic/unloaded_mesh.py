# SPDX-License-Identifier: Apache-2.0
"""Single meshes: unloaded transmission error at first contact, and tangent stiffness."""

from __future__ import annotations

import math

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import DIVERGED
from pitchpoint.multibody.bodies import spin_of
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import mesh_names, mesh_record
from pitchpoint.system.residual import NEWTON
from pitchpoint.system.system import State, System

NEWTON_STEPS = 40
MAX_BISECTIONS = 100
DEPTH = 1e-13
"""Penetration that counts as first contact of an unloaded flank [m]."""


def tangent_stiffness(system: System, state: State, m: int) -> float:
    """Derivative of the force of mesh m with respect to the travel of one gear along the base tangent."""
    record = mesh_record(system, m)
    body, radius = (record["i"], record["r_b1"])
    if spin_of(system.program["body"], body) < 0:
        body, radius = record["j"], record["r_b2"]
    spin = spin_of(system.program["body"], body)
    whole = evaluate.matrix(system, state, 0.0, 0.0, 1.0, NEWTON)[spin, spin]
    kept = float(record["c_prime"])
    record["c_prime"] = 0.0
    try:
        rest = evaluate.matrix(system, state, 0.0, 0.0, 1.0, NEWTON)[spin, spin]
    finally:
        record["c_prime"] = kept
    return float((whole - rest) / radius**2)


def unloaded_error(system: System, clear: State, m: int, contact: float) -> float:
    """Transmission error of mesh m at first contact, with gear 1 at its angle in `clear`.

    If the same teeth stay in contact, the force is a power of the penetration: Newton's method on its root
    converges directly to first contact for any exponent. If the teeth in contact change, first contact is
    located by bisection between the last positions with and without force.
    """
    record = mesh_record(system, m)
    flank = -1.0 if contact < 0.0 else 1.0
    which, radius = ("j", float(record["r_b2"]))
    if spin_of(system.program["body"], record["j"]) < 0:
        which, radius = "i", float(record["r_b1"])
    spin = spin_of(system.program["body"], record[which])
    names = mesh_names(system)
    u, pushes = (system.layout.channel(f"{c}[{names[m]}]") for c in ("transmission_error", "mesh_force"))
    nowhere = SolverError(f"mesh {names[m]}: no position of first contact of the flanks", DIVERGED, clear)
    power = float(record["contact"]["power"])
    aim = DEPTH**power * float(record["contact"]["k_ref"])
    state = clear.copy()
    evaluate.residual(system, state)
    span = abs(float(record["now"]["gap"])) + 1e-6
    for _ in range(200):
        # close the gap until there is a force, then return to first contact
        values = evaluate.observe(system, state)
        force = flank * float(values[pushes])
        if force > 0.0:
            break
        state.q[spin] += flank * span / radius
        span *= 1.2
    else:
        raise nowhere
    reach = span
    inside, outside = state.q[spin], math.nan
    above, below = math.nan, math.nan
    for _ in range(NEWTON_STEPS):
        values = evaluate.observe(system, state)
        force = flank * float(values[pushes])
        if force > 0.0:
            inside = state.q[spin]
            depth = power * force / abs(tangent_stiffness(system, state, m))
            change = depth * (1.0 - (aim / force) ** (1.0 / power))
            if abs(change) < DEPTH or abs(above - below) * radius < DEPTH:
                return float(values[u])
            reach = 0.01 * abs(change)
            state.q[spin] -= flank * change / radius
            # concave flanks touch in one spot first, where the force of few nodes is not quite convex
            above, below = (inside, below) if force > aim else (above, inside)
            kept = min(above, below) < state.q[spin] < max(above, below)
            if not (kept or math.isnan(above - below)):
                state.q[spin] = 0.5 * (above + below)
        else:
            # first contact changes slightly with the phase: make a small step back into contact
            outside = state.q[spin]
            state.q[spin] += flank * reach / radius
            reach *= 4.0
    if math.isnan(outside):
        raise nowhere
    for _ in range(MAX_BISECTIONS):
        if abs(inside - outside) * radius <= DEPTH:
            break
        state.q[spin] = 0.5 * (inside + outside)
        if flank * float(evaluate.observe(system, state)[pushes]) > 0.0:
            inside = state.q[spin]
        else:
            outside = state.q[spin]
    return float(evaluate.observe(system, state)[u])
