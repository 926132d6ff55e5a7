# SPDX-License-Identifier: Apache-2.0
"""Start of a run with short steps of the gear trains: their bodies, and whether the machine permits it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import NOT_FINITE
from pitchpoint.elements import registry
from pitchpoint.elements.kind import EVERYWHERE, GEARED, TOGETHER
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.solvers.implicit.interface import connect
from pitchpoint.solvers.implicit.step import factors
from pitchpoint.solvers.implicit.substeps import LONG_RHO, SubstepRun
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import mesh_records
from pitchpoint.system.part import Part
from pitchpoint.system.residual import NEWTON

if TYPE_CHECKING:
    from pitchpoint.system.system import State, System

SOFT = 0.1
"""Limit of H D/M of each slow coordinate in a long step H, with the damping of elements at the gear trains
and the inertia M that resists a sudden torque, and of the effect of control loops."""
SOFT_SPRING = 0.03
"""Limit of H^2 K/M with their stiffness. Undamped vibrations gain no energy if all natural frequencies of the
gear train against a rest that is held, and of the rest, have six long steps per period or more. Shorter ones
may gain up to 0.3 % of the critical damping where they coincide with others at the sampling rate 1/H (largest
of 12 000 random models), in proportion to H^2 K/M. Any damping there prevents it."""


def start(system: System, state: State, h: float, count: int) -> SubstepRun:
    """Start an integration with `count` short steps h of the gear trains in each step of all other bodies.

    Parameters
    ----------
    system, state
        The system and its initial state.
    h
        Short step [s], > 0.
    count
        Short steps per long step.

    Raises
    ------
    SolverError
        If the machine has constraint rows or nothing but gear trains, or if a gear train is connected too
        stiffly.
    """
    fast = fast_bodies(system)
    _check(system, fast)
    begun = generalized_alpha.start(system, state, h)
    body = system.program["body"]
    own = {int(body[b]["dof"]) + k for b in fast for k in range(int(body[b]["n"]))}
    parts = Part(system, own, fast), Part(system, set(range(system.sizes["nd"])) - own)
    _check_coupling(system, state, parts, count * h)
    _check_feedback(system, state, parts, count * h)
    connect(system, state, parts, factors(count * h, LONG_RHO)[:2])
    evaluate.load(system, state)
    late = _late_events(system, state, parts[0])
    run = SubstepRun(system, h, begun.rho_inf, begun.tolerance, state.t, count=count, parts=parts, late=late)
    evaluate.check(system, run.go_on(), state)
    return run


def fast_bodies(system: System) -> list[int]:
    """Numbers of the bodies of the gear trains.

    They are the rotating bodies with gears, the carriers of planets and all bodies that couplings, shafts and
    torsion springs turn with them, without those that carry further bodies, such as the hub of a wind
    turbine."""
    body = system.program["body"]
    found = {b for row in mesh_records(system) for b in (int(row["i"]), int(row["j"])) if _turns(body, b)}
    joined = [
        (int(row["i"]), int(row["j"]))
        for name, bank in system.records.items()
        for row in (bank if {"i", "j"} <= set(bank.dtype.names or ()) else ())
        if registry.find(name).spins_of(row) in (TOGETHER, GEARED)
        and not {int(row["i"]), int(row["j"])}
        & {int(body[row["i"]]["parent"]), int(body[row["j"]]["parent"])} - {0}
    ]
    size = -1
    while size != len(found):
        size = len(found)
        found |= {_owner(body, int(body[b]["parent"])) for b in found if body[b]["sense"] != 0.0}
        found |= {k for pair in joined if found & set(pair) for k in pair}
        found = {b for b in found if _turns(body, b)}
    carried = {b: int(body[b]["parent"]) for b in range(1, body.size)}
    size = -1
    while size != len(found):
        size = len(found)
        for b in range(1, body.size):
            if body[b]["n"] > 0 and b not in found:
                p = carried[b]
                while p:
                    found.discard(p)
                    p = carried[p]
    return sorted(found)


def _late_events(system: System, state: State, fast: Part) -> NDArray[np.int64]:
    """For each event function, 1 if short steps do not evaluate it, shape (ne,)."""
    values = np.full(system.sizes["ne"], np.nan)
    fast.run_events(state.t, values)
    return np.isnan(values).astype(np.int64)


def _owner(body: np.ndarray, b: int) -> int:
    """The body, or the one to which it is fixed and whose spin it takes over."""
    return b if body[b]["n"] > 0 else int(body[b]["spinner"])


def _turns(body: np.ndarray, b: int) -> bool:
    """Whether a body has a spin of its own about the axis of its joint."""
    return b > 0 and bool(body[b]["n"] > 0 and body[b]["spin"] >= 0 and not body[b]["state"])


def _check(system: System, fast: list[int]) -> None:
    """Refuse machines with nothing but gear trains, constraint rows or damping of all coordinates."""
    problem = ""
    if not {b for b in range(1, system.sizes["nb"]) if system.program["body"][b]["n"] > 0} - set(fast):
        problem = "has no bodies outside of its gear trains"
    elif system.sizes["nc"]:
        problem = "has closed loops, rigid ratios or drives"
    elif any(registry.find(name).scope == EVERYWHERE for name in system.records):
        problem = "has damping of all coordinates"
    elif len(system.workspace.tables["frictions"]):
        problem = "has friction that depends on joint loads"
    if problem:
        raise SolverError(f"long_step: the machine {problem}; remove long_step", NOT_FINITE)


def _check_coupling(system: System, state: State, parts: tuple[Part, Part], H: float) -> None:
    """Refuse gear trains that are connected to the rest too stiffly for a long step H [s]."""
    slow = parts[1].own
    easy = np.diag(np.linalg.inv(evaluate.matrix(system, state, 1.0, 0.0, 0.0, NEWTON)[np.ix_(slow, slow)]))
    evaluate.load(system, state)
    K, D = (np.diag(parts[0].matrix(state.t, *factors)) for factors in ((0.0, 0.0, 1.0), (0.0, 1.0, 0.0)))
    spring, damper = H**2 * np.abs(K[slow]) * easy / SOFT_SPRING, H * np.abs(D[slow]) * easy / SOFT
    size = np.maximum(spring, damper)
    worst = int(np.argmax(size))
    if size[worst] > 1.0:
        name = system.layout.coordinates[slow[worst]]
        longest = H / max(float(damper[worst]), float(spring[worst]) ** 0.5)
        raise SolverError(
            f"long_step: {H:.3g} s is too long for {name}, to which a gear train is connected stiffly: "
            f"vibrations could gain energy (limit {longest:.2g} s); shorten or remove long_step",
            NOT_FINITE,
        )


def _check_feedback(system: System, state: State, parts: tuple[Part, Part], H: float) -> None:
    """Refuse control loops from gear trains to themselves that are too fast for a long step H [s].

    Their signals are extrapolated during the short steps. Implicit Euler matrices of a step H give the
    torque by a motion through them, with the states of their filters eliminated, relative to the inertia.
    """
    fast, states = parts[0].own, np.intersect1d(system.states, parts[1].own)
    cm, cd = 1.0 / H**2, 1.0 / H
    whole = evaluate.matrix(system, state, cm, cd, 1.0, NEWTON)
    inertia = np.linalg.inv(evaluate.matrix(system, state, 1.0, 0.0, 0.0, NEWTON)[np.ix_(fast, fast)])
    links = evaluate.matrix(system, state, 0.0, cd, 1.0, NEWTON)[np.ix_(fast, fast)]
    evaluate.load(system, state)
    links -= parts[0].matrix(state.t, 0.0, cd, 1.0)[np.ix_(fast, fast)]
    if states.size:
        to_states = np.linalg.solve(whole[np.ix_(states, states)], whole[np.ix_(states, fast)])
        links -= whole[np.ix_(fast, states)] @ to_states
    root = np.sqrt(np.diag(inertia) / cm)
    loop = np.abs(links * np.outer(root, root))
    size, worst = float(np.linalg.norm(loop, 2)), int(np.argmax(loop.max(axis=1)))
    if size > SOFT:
        name = system.layout.coordinates[fast[worst]]
        raise SolverError(
            f"long_step: {H:.3g} s is too long for {name}: a control loop sets its torque by the motion of "
            f"its own gear train (limit {H * SOFT / size:.2g} s); shorten or remove long_step",
            NOT_FINITE,
        )
