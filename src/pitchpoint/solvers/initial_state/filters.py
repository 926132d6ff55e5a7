# SPDX-License-Identifier: Apache-2.0
"""Where filters, integrals and transfer functions begin: at rest with what they follow.

Filters and stable transfer functions begin at what their inputs give. An integral whose input is zero may
have any value: it begins where the loads of the machine balance, as in a drive that has been running at its
speed. One whose input is not zero cannot rest: it begins at its start value.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.solvers.equilibrium.solve import Equilibrium, find_equilibrium
from pitchpoint.solvers.equilibrium.unknowns import STATE, signal_states, unsettled_states
from pitchpoint.system import evaluate
from pitchpoint.system.residual import EXACT
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

MOST_STEPS = 20
MOST_TURNS = 50
"""Most turns between a machine and the states that follow its loads."""
AT_REST = 1e-9
"""Rate of a state over the terms it is made of, and torque left over, that count as none."""


def rest_of_controls(
    system: System, state: State, held: Sequence[int], known: Collection[int]
) -> tuple[Equilibrium, tuple[str, ...]]:
    """Equilibrium with the states of signals, and notes on them.

    Parameters
    ----------
    system, state
        Where to begin.
    held
        Coordinates to keep.
    known
        Those of them that may need a torque: driven ones, and bodies of balancing torques.
    """
    if not signal_states(system).size:
        return find_equilibrium(system, state, held), ()
    found = _rest(system, state, held)
    if found is None:
        found = _with_states_kept(system, state, held)  # its own error, if the machine has no rest either
        return found, ("no rest of machine and controllers: states of signals begin at their start values",)
    found, notes = _balanced(system, found, held, known)
    # states count little next to forces in what ends an equilibrium
    return replace(found, state=states_of_inputs(system, found.state)), notes


def _rest(system: System, state: State, held: Sequence[int]) -> Equilibrium | None:
    """Equilibrium of machine and states together, or in turns: tangents of sensed loads are not known."""
    try:
        return find_equilibrium(system, state, held)
    except SolverError:
        here = state
    states = signal_states(system)
    for _ in range(MOST_TURNS):
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
    """Let integrals that may have any value take the loads that are left over on spins."""
    free = np.setdiff1d(np.arange(system.sizes["nd"]), held)
    idle = unsettled_states(system, found.state, free)
    moving = _moving(system, found.state, idle)
    notes = tuple(
        f"{_name(system, k)} is not at rest: it begins at {found.state.v[k]:.6g}" for k in idle[moving]
    )
    idle = idle[~moving]
    open_ = [n for n, spin in enumerate(held) if spin not in known]
    for _ in range(MOST_STEPS):
        left = found.reaction[open_]
        if not idle.size or np.all(np.abs(left) <= AT_REST * _acting(system, found.state)[list(held)][open_]):
            break
        answers = [_answer(system, found, held, k) for k in idle]
        if any(answer is None for answer in answers):
            break
        slope = np.column_stack([answer[open_] - left for answer in answers if answer is not None])
        step = -np.linalg.pinv(slope, rcond=1e-9) @ left
        if not np.abs(step).max(initial=0.0) > 0.0:
            break
        trial = found.state.copy()
        trial.v[idle] += step * _unit(found.state, idle)
        better = _rest(system, trial, held)
        if better is None or not np.linalg.norm(better.reaction[open_]) < np.linalg.norm(left):
            break
        found = better
    return found, notes


def _acting(system: System, state: State) -> Array:
    """Size of the torques that signals put on every coordinate, for what is negligible next to it."""
    whole = np.abs(evaluate.matrix(system, state, 0.0, 1.0, 0.0, EXACT))
    return np.asarray(whole @ np.abs(state.v) + 1.0)


def _unit(state: State, at: NDArray[np.int64]) -> Array:
    return np.maximum(1.0, np.abs(state.v[at]))


def _answer(system: System, found: Equilibrium, held: Sequence[int], k: int) -> Array | None:
    """Reactions with one state changed by its unit."""
    trial = found.state.copy()
    trial.v[k] += float(_unit(trial, np.array([k]))[0])
    answer = _rest(system, trial, held)
    return None if answer is None else answer.reaction


def _moving(system: System, state: State, idle: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Which of some states have a rate."""
    if not idle.size:
        return np.zeros(0, bool)
    rate = np.abs(evaluate.residual(system, state)[idle])
    terms = np.abs(evaluate.matrix(system, state, 0.0, 1.0, 0.0, EXACT)[idle]) @ np.abs(state.v)
    return np.asarray(rate > AT_REST * terms)


def _name(system: System, k: int) -> str:
    """Signal that a coordinate holds the state of."""
    return f"signal[{system.layout.coordinates[k].removeprefix(STATE).rsplit('.', 1)[0]}]"


def states_of_inputs(system: System, state: State) -> State:
    """The same state of the machine, with filters and transfer functions at rest if they can be.

    Parameters
    ----------
    system, state
        Places and rates of the machine stay.
    """
    found = _settled(system, state)
    return state if found is None else found


def _settled(system: System, state: State) -> State | None:
    """The same; None if the states do not come to rest with their inputs as they are."""
    states = signal_states(system)
    free = np.setdiff1d(states, unsettled_states(system, state, states))
    found = state.copy()
    if not free.size:
        return found
    for _ in range(MOST_STEPS):
        rates = evaluate.residual(system, found)[free]
        slope = evaluate.matrix(system, found, 0.0, 1.0, 0.0, EXACT)[np.ix_(free, free)]
        step = -np.linalg.lstsq(slope, rates, rcond=1e-12)[0]
        found.v[free] += step
        if np.all(np.abs(step) <= 1e-13 * np.maximum(1.0, np.abs(found.v[free]))):
            break
    left = np.abs(evaluate.residual(system, found)[free])
    return found if np.all(left <= 1e-6 * (np.abs(slope) @ np.abs(found.v[free])) + 1e-12) else None
