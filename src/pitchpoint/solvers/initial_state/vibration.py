# SPDX-License-Identifier: Apache-2.0
"""Steady vibration under pulsating torques, with which a run starts: no natural mode is excited.

The deflection under the torque at t = 0 is that of a slow torque, the one under its mean that of a fast one.
The steady vibration of the system linearised about its mean loads is right for both, and between them:

    (K + i omega D - omega^2 M) q = T - M r (r' M r)^-1 r' T

for every harmonic T of the loads. The second term is the part that accelerates the free rotations r: their
ripple is that of the rigid train, which may be large (`load_cycle`).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.solvers.constraints.free_directions import free_directions
from pitchpoint.solvers.equilibrium.closed_loops import is_looped
from pitchpoint.solvers.equilibrium.unknowns import rest_matrix, signal_states
from pitchpoint.solvers.gear_trains import rotations
from pitchpoint.solvers.harmonic_response import harmonic_response
from pitchpoint.solvers.load_cycle import LoadCycle
from pitchpoint.solvers.load_waves import GOLDEN, TURNS
from pitchpoint.system import evaluate
from pitchpoint.system.residual import EXACT
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

INSTANTS = 64
"""Instants at which the forces of the vibration are compared with the linear ones."""
LINEAR = 0.1
"""Difference of these forces over the largest linear one up to which the vibration counts as linear."""


def with_vibration(
    system: System, state: State, cycle: LoadCycle, held: Sequence[int], driven: Sequence[int]
) -> State:
    """State at the start of the steady vibration about a mean state.

    The mean state is returned if there is no such vibration: where flanks separate in it or another force is
    far from linear, at a resonance without damping, and in machines with closed loops.

    Parameters
    ----------
    system, state
        The system with its damping, in equilibrium under the mean torques.
    cycle
        Its pulsating loads.
    held, driven
        Spins held at the start, one for every free rotation, and those with prescribed motion.
    """
    if not cycle.waves or is_looped(system):
        return state
    own = cycle.applied(system)
    free = [k for k, spin in enumerate(held) if spin not in set(driven)]
    M = rest_matrix(own, state, EXACT, (1.0, 0.0, 0.0))
    D = rest_matrix(own, state, EXACT, (0.0, 1.0, 0.0))
    K = rest_matrix(own, state, EXACT, (0.0, 0.0, 1.0))
    motions = rotations(own, held)[:, free] if free else np.zeros((own.sizes["nd"], 0))
    carried = M @ motions
    accelerated = carried @ np.linalg.solve(motions.T @ carried, motions.T)
    states = np.setdiff1d(own.states, signal_states(own)).tolist()
    basis = free_directions(own, state, own.states.tolist())
    place, rate = (np.zeros((own.sizes["nd"], len(cycle.waves)), complex) for _ in range(2))
    for k, wave in enumerate(cycle.waves):
        torque = (wave.torque - accelerated @ wave.torque)[:, None]
        found = harmonic_response((M, D, K), basis, states, wave.rate, torque)
        place[:, k], rate[:, k] = found.place[:, 0], found.rate[:, 0]
    rates = np.array([wave.rate for wave in cycle.waves])
    if not (np.all(np.isfinite(place)) and _is_linear(own, state, (D, K), (place, rate, rates))):
        return state
    return _moved(state, place.sum(axis=1), rate.sum(axis=1))


def _moved(state: State, place: Complex, rate: Complex) -> State:
    """Copy of a state with the real parts of a deviation added."""
    moved = state.copy()
    moved.q += place.real
    moved.v += rate.real
    return moved


def _is_linear(
    system: System, state: State, matrices: tuple[Any, Any], vibration: tuple[Complex, Complex, Array]
) -> bool:
    """Whether the forces of the elements in a vibration are those of the linear system."""
    place, rate, rates = vibration
    D, K = matrices
    rest = evaluate.residual(system, state)
    rows = np.setdiff1d(np.arange(rest.size), system.states)
    largest = different = 0.0
    for k in range(INSTANTS):
        turned = np.exp(1j * rates * (k * GOLDEN % 1.0) * TURNS / rates.min())
        moved = _moved(state, place @ turned, rate @ turned)
        linear = K @ (moved.q - state.q) + D @ (moved.v - state.v)
        try:
            forces = evaluate.residual(system, moved) - rest
        except SolverError:
            return False
        sizes = [np.abs((x / system.weight)[rows]).max(initial=0.0) for x in (linear, forces - linear)]
        largest, different = max(largest, sizes[0]), max(different, sizes[1])
    return bool(different <= LINEAR * largest)
