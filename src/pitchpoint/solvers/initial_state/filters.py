# SPDX-License-Identifier: Apache-2.0
"""Initial states of filters, integrators and transfer functions: steady state if there is one.

Filters and stable transfer functions start at the steady state of their inputs. An integrator with zero input
may have any value: it starts at the value that balances the loads of the machine, as in a drive that has been
running at its speed. An integrator with non-zero input has no steady state: it starts at its initial value.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.elements.signals.dry_friction import DEFLECTION
from pitchpoint.solvers.equilibrium.solve import Equilibrium, find_equilibrium
from pitchpoint.solvers.equilibrium.unknowns import STATE, signal_states, unsettled_states
from pitchpoint.system import evaluate
from pitchpoint.system.residual import EXACT
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

MAX_STEPS = 20
MAX_TURNS = 50
"""Maximum number of alternations between the machine and the states that depend on its loads."""
PARTS = (1.0, 0.5, 0.2, 0.05)
"""Parts of a step of states that are tried."""
AT_REST = 1e-9
"""Relative rate of a state, and relative residual torque, that count as zero."""
CREEPS = 1e-3
"""Rate of the deflection of a friction block [1/s] up to which it does not slip for the next 1000 s."""


def rest_of_controls(
    system: System, state: State, held: Sequence[int], known: Collection[int]
) -> tuple[Equilibrium, tuple[str, ...]]:
    """Equilibrium including the states of signals, and notes on them.

    Parameters
    ----------
    system, state
        The system and its initial guess.
    held
        Coordinates to hold.
    known
        Held coordinates that may have a reaction: driven ones, and bodies of balancing torques.
    """
    if not signal_states(system).size:
        return find_equilibrium(system, state, held), ()
    found = _rest(system, state, held)
    if found is None:
        found = _with_states_kept(system, state, held)  # raises its error if the machine has no equilibrium
        return found, (
            "no equilibrium of machine and controllers: states of signals start at their initial values",
        )
    found, notes = _balanced(system, found, held, known)
    # the tolerance of the equilibrium is set by the forces: refine the states
    return replace(found, state=states_of_inputs(system, found.state)), notes


def _rest(system: System, state: State, held: Sequence[int]) -> Equilibrium | None:
    """Equilibrium of machine and states, simultaneously or alternating (sensed loads have no tangents)."""
    try:
        return find_equilibrium(system, state, held)
    except SolverError:
        here = state
    states = signal_states(system)
    for _ in range(MAX_TURNS):
        try:
            found = _with_states_kept(system, here, held)
            settled = _settled(system, found.state)
        except SolverError:
            return None
        if settled is None:
            return None
        here = settled
        changed = np.abs(here.v[states] - found.state.v[states])
        if np.all(changed <= AT_REST * np.maximum(1.0, np.abs(here.v[states]))):
            return replace(found, state=here)
    return None


def _with_states_kept(system: System, state: State, held: Sequence[int]) -> Equilibrium:
    kept = (*held, *(int(k) for k in signal_states(system)))
    found = find_equilibrium(system, state, kept)
    return replace(found, held=tuple(held), reaction=found.reaction[: len(held)])


def _balanced(
    system: System, found: Equilibrium, held: Sequence[int], known: Collection[int]
) -> tuple[Equilibrium, tuple[str, ...]]:
    """Balance the residual torques of spins by integrators with arbitrary steady state."""
    free = np.setdiff1d(np.arange(system.sizes["nd"]), held)
    idle = unsettled_states(system, found.state, free)
    moving = _moving(system, found.state, idle)
    notes = tuple(
        f"{_name(system, k)} has no steady state: it starts at {found.state.v[k]:.6g}" for k in idle[moving]
    )
    idle = idle[~moving]
    open_ = [n for n, spin in enumerate(held) if spin not in known]
    size = _unit(found.state, idle)  # of a trial change
    for _ in range(MAX_STEPS):
        left = found.reaction[open_]
        if not idle.size or np.all(
            np.abs(left) <= AT_REST * acting_torques(system, found.state)[list(held)][open_]
        ):
            break
        answers = [_answer(system, found, held, k, change) for k, change in zip(idle, size, strict=True)]
        if any(answer is None for answer in answers):
            break
        slope = np.column_stack([answer[open_] - left for answer in answers if answer is not None])
        step = -np.linalg.pinv(slope, rcond=1e-9) @ left
        if not np.abs(step).max(initial=0.0) > 0.0:
            break
        better = _shorter(system, found, held, idle, step * size, open_)
        if better is None:
            break
        size = np.where(step == 0.0, size, np.minimum(np.abs(step), 1.0) * size)
        found = better
    return found, notes


def _shorter(
    system: System,
    found: Equilibrium,
    held: Sequence[int],
    idle: NDArray[np.int64],
    step: Array,
    open_: Sequence[int],
) -> Equilibrium | None:
    """Equilibrium after a step of states, or a part of it, that reduces the residual torques."""
    for part in PARTS:
        trial = found.state.copy()
        trial.v[idle] += part * step
        better = _rest(system, trial, held)
        if better is not None and np.linalg.norm(better.reaction[open_]) < np.linalg.norm(
            found.reaction[open_]
        ):
            return better
    return None


def acting_torques(system: System, state: State) -> Array:
    """Magnitude of the torques of signals on every coordinate, as reference for the residuals."""
    whole = np.abs(evaluate.matrix(system, state, 0.0, 1.0, 0.0, EXACT))
    return np.asarray(whole @ np.abs(state.v) + 1.0)


def _unit(state: State, at: NDArray[np.int64]) -> Array:
    return np.maximum(1.0, np.abs(state.v[at]))


def _answer(system: System, found: Equilibrium, held: Sequence[int], k: int, change: float) -> Array | None:
    """Reactions after a change of one state; None if there is no equilibrium."""
    trial = found.state.copy()
    trial.v[k] += change
    answer = _rest(system, trial, held)
    return None if answer is None else answer.reaction


def _moving(system: System, state: State, idle: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Flags of the states with a non-zero rate."""
    if not idle.size:
        return np.zeros(0, bool)
    rate = np.abs(evaluate.residual(system, state)[idle])
    terms = np.abs(evaluate.matrix(system, state, 0.0, 1.0, 0.0, EXACT)[idle]) @ np.abs(state.v)
    return np.asarray(rate > AT_REST * terms)


def _name(system: System, k: int) -> str:
    """Name of the signal to which a state coordinate belongs."""
    return f"signal[{system.layout.coordinates[k].removeprefix(STATE).rsplit('.', 1)[0]}]"


def states_of_inputs(system: System, state: State) -> State:
    """Copy of a state with filters and transfer functions in steady state, if there is one.

    Parameters
    ----------
    system, state
        The system and its state; positions and rates of the machine are unchanged.
    """
    found = _settled(system, state)
    return state if found is None else found


def slipping_frictions(system: System, state: State) -> State:
    """Copy of a state in which friction blocks that slip have their full deflection, 1 or -1.

    Without deflection, as assembled, the damping before slip would act with the whole slip speed. At equal
    speeds except for rounding, they stick without deflection.
    """
    found = state.copy()
    for k in signal_states(system):
        if not system.layout.coordinates[k].endswith(f"{DEFLECTION}.spin") or state.v[k] != 0.0:
            continue
        rate = -float(evaluate.residual(system, replace(state, a=np.zeros_like(state.a)))[k])
        found.v[k] = np.sign(rate) if abs(rate) > CREEPS else 0.0
    return found


def _settled(system: System, state: State) -> State | None:
    """As `states_of_inputs`; None if the states have no steady state for their present inputs."""
    states = signal_states(system)
    free = np.setdiff1d(states, unsettled_states(system, state, states))
    found = state.copy()
    if not free.size:
        return found
    for _ in range(MAX_STEPS):
        rates = evaluate.residual(system, found)[free]
        slope = evaluate.matrix(system, found, 0.0, 1.0, 0.0, EXACT)[np.ix_(free, free)]
        step = -np.linalg.lstsq(slope, rates, rcond=1e-12)[0]
        found.v[free] += step
        if np.all(np.abs(step) <= 1e-13 * np.maximum(1.0, np.abs(found.v[free]))):
            break
    left = np.abs(evaluate.residual(system, found)[free])
    return found if np.all(left <= 1e-6 * (np.abs(slope) @ np.abs(found.v[free])) + 1e-12) else None
