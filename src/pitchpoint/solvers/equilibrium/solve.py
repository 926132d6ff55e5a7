# SPDX-License-Identifier: Apache-2.0
"""Static equilibrium: the state of rest of a system under its loads, gears in contact or not.

Newton's method cannot start inside the backlash, where nothing resists a turn. So each step solves
(K + M/tau^2) dq = -R: with a short pseudo-time tau the bodies drift apart along their loads until flanks
touch, with a growing one the step becomes Newton's. Spins that nothing holds (every rigid gear train has one)
are kept at their angle; the torque that this takes is reported: it is zero if the loads balance.

A step counts as progress by the step that would follow it with the same matrix, in the norm of the masses:
residuals themselves may grow on the way (a gear train multiplies a torque before the next mesh has taken it).

Sources of the ideas: C. T. Kelley, D. E. Keyes, Convergence analysis of pseudo-transient continuation, SIAM
Journal on Numerical Analysis 35 (1998) 508-523; P. Deuflhard, Newton Methods for Nonlinear Problems, 2004
(natural monotonicity).
"""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.progress import report_step
from pitchpoint.core.status import DIVERGED, SINGULAR
from pitchpoint.elements import torque
from pitchpoint.model.components.law import Balance
from pitchpoint.solvers.equilibrium.closed_loops import is_looped, rest_of_mechanism
from pitchpoint.solvers.equilibrium.failure import advice, broken_tooth, unconstrained
from pitchpoint.solvers.equilibrium.force_jumps import (
    Rest,
    Surface,
    crossed,
    observe_mean,
    rest_between,
    rest_on_surfaces,
)
from pitchpoint.solvers.equilibrium.geometric_stiffness import Tangent, resists
from pitchpoint.solvers.equilibrium.unknowns import (
    GROWTH,
    ROUNDING,
    inverse_of,
    rest_matrix,
    step_on,
    unsettled_states,
)
from pitchpoint.solvers.gear_trains import complete, exchange, exchange_all, free_spins, is_independent
from pitchpoint.system import evaluate
from pitchpoint.system.residual import NEWTON
from pitchpoint.system.source import coordinate_source
from pitchpoint.system.system import State, System

if TYPE_CHECKING:
    import xarray as xr

LOAD = torque.KIND.name
MOST_ITERATIONS = 400
TOLERANCE = 1e-9
"""Residual over the sum of what acts, at which a state counts as equilibrium."""
FIRST = 1e4
"""Factor of the masses in the first step [1/s^2]."""
TINY = 1e-9
"""Step [m] over which a force without a jump keeps its value."""
HEAVY = 1e8
"""Factor of the masses [1/s^2] beyond which exact tangents that no step resists are given up: those of
controllers need not, as they do not derive from an energy."""
LONGEST = 0.3
"""Largest turn of a joint in one step then [rad]."""
SLOW = 1.0
"""Time [s] from which on a search reports its number of steps."""
NOW = (np.zeros(1), np.ones(1))
"""The instant of the start alone, with its weight."""
SHORT = 1e-6
"""Step [m] below which one that makes no progress is searched for the jump of a force."""


@dataclass(frozen=True)
class Equilibrium:
    """A state at rest.

    Parameters
    ----------
    state
        The state; velocities are the given ones.
    held
        Coordinates that were kept.
    reaction
        Torque that keeps each of them [N m], shape (len(held),).
    iterations
        Newton steps taken.
    other_sides, share
        For every jump of a force the state rests on: the state on its other side, and the share in which
        what acts is that of the other side.
    """

    state: State
    held: tuple[int, ...]
    reaction: NDArray[np.float64]
    iterations: int
    other_sides: tuple[State, ...] = ()
    share: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0))

    def observe(self, system: System) -> NDArray[np.float64]:
        """All observations, in the order of ``system.layout.channels``; at a jump the mean that rests."""
        return observe_mean(system, self.state, self.other_sides, self.share)


def find_equilibrium(
    system: System,
    start: State | None = None,
    held: Sequence[int] | None = None,
    *,
    tolerance: float = TOLERANCE,
) -> Equilibrium:
    """Find the state at rest near a start.

    Parameters
    ----------
    system
        The system; rows of drives are not taken into account (they prescribe motion, not rest).
    start
        Where to begin; velocities are kept as they are and may carry friction. Default: the initial state.
    held
        Coordinates to keep. Default: `free_spins`.
    tolerance
        Largest residual, relative to the loads.

    Returns
    -------
    Equilibrium

    Raises
    ------
    SolverError
        If no equilibrium is found: something moves without resistance, or the law has none.
    """
    state = (system.initial_state() if start is None else start).copy()
    state.a[:] = 0.0
    kept = free_spins(system) if held is None else tuple(held)
    free = np.setdiff1d(np.arange(system.sizes["nd"]), kept)
    evaluate.prepare(system)
    idle = unsettled_states(system, state, free)
    free = np.setdiff1d(free, idle)
    if is_looped(system):
        mechanism = rest_of_mechanism(system, state, (*kept, *map(int, idle)), tolerance)
        if words := broken_tooth(system, mechanism.state):
            raise SolverError(words, DIVERGED, mechanism.state)
        reaction = mechanism.residual[list(kept)].copy()
        return Equilibrium(_wrapped(system, mechanism.state), kept, reaction, mechanism.steps)
    found, count, failure = _pseudo_time(system, state, free, tolerance)
    if words := broken_tooth(system, found.state):
        raise SolverError(words, DIVERGED, found.state)
    if failure:
        if names := unconstrained(system, state, free):
            where = coordinate_source(system, names[0]).removeprefix(names[0])
            raise SolverError(f"no equilibrium: {advice(names)}{where}", SINGULAR, found.state)
        left = np.abs(found.residual / system.weight)[free]
        worst = system.layout.coordinates[int(free[np.argmax(left)])]
        raise SolverError(
            f"no equilibrium found after {count} steps: {left.max():.3g} N are left over on "
            f"{coordinate_source(system, worst)}; check loads and stiffness",
            failure,
            found.state,
        )
    other_sides = tuple(_wrapped(system, other) for other in found.other_sides)
    reaction = found.residual[list(kept)].copy()
    return Equilibrium(_wrapped(system, found.state), kept, reaction, count, other_sides, found.share)


def _pseudo_time(
    system: System, state: State, free: NDArray[np.int64], tolerance: float
) -> tuple[Rest, int, int]:
    """Iterate the free coordinates to rest; gives where it ended, steps, and 0 or the status of a failure."""
    weight = 1.0 / system.weight  # residuals as forces
    R = evaluate.residual(system, state)
    mass, root, damping = None, np.zeros(0), np.zeros(R.size)
    if state.v.any():
        damping = abs(rest_matrix(system, state, NEWTON, (0.0, 1.0, 0.0))) @ np.abs(state.v)
    wanted = tolerance * float(np.abs(R * weight).max(initial=0.0))
    tangent, started = Tangent(system, state), time.monotonic()
    swings = np.isin(free, tangent.joints)
    passing: set[Surface] = set()  # surfaces that did not hold when they were tried last
    mu = FIRST
    for count in range(MOST_ITERATIONS):
        whole = tangent.at(state, count)
        # positions are rounded like 1 m and 1 rad: smaller residuals than the forces of that are out of reach
        rounded = ROUNDING * weight * (abs(whole) @ (np.abs(state.q) + 1.0) + damping)
        goal = np.maximum(rounded, wanted)[free]
        if (np.abs((R * weight)[free]) <= goal).all():
            return Rest(state, R), count, 0
        if mass is None:  # a state that rests already has no use for it
            mass = rest_matrix(system, state, NEWTON, (1.0, 0.0, 0.0))[free][:, free]
            root = np.sqrt(mass.diagonal())
        pulled = whole[free][:, free] + mu * mass
        if tangent.exact and not resists(pulled):  # Newton's step would go up, to an unstable equilibrium
            mu *= 8.0
            if mu > HEAVY:
                tangent.refuse()
                mu = FIRST
            continue
        inverse = inverse_of(pulled, root)
        step = -inverse(R[free])
        if time.monotonic() - started > SLOW:
            report_step(f"equilibrium, step {count + 1}")
        turn = float(np.abs(step[swings]).max(initial=0.0)) if tangent.exact else 0.0
        trial = step_on(system, state, free, step * min(1.0, LONGEST / turn if turn > 0.0 else 1.0))
        try:
            new = evaluate.residual(system, trial)
        except SolverError:
            mu *= 16.0
            continue
        left = float(np.linalg.norm(root * inverse(new[free])) / np.linalg.norm(root * step))
        beyond = float(new[free] @ step) > 0.0  # the forces push back: the step went past the goal
        # what swings down from above meets growing forces first
        if left < 0.9 or ((left <= GROWTH or tangent.exact) and not beyond):
            mu = max(mu * (0.1 if left < 0.5 else 0.5), 1e-3)
            state, R = trial, new
            continue
        length = float(np.abs(step * system.weight[free]).max(initial=0.0))
        if length < SHORT and (surfaces := crossed(system, state, trial)):
            rest = None if passing & {*surfaces} else rest_on_surfaces(system, state, surfaces, free, goal)
            if rest is not None and rest.holds:
                return rest, count, 0
            # a force across a jump does not measure the step that crosses it
            state = trial if rest is None else rest.state
            R = evaluate.residual(system, state)
            passing = set() if rest is None else {*surfaces}
            mu = mu if rest is None else FIRST
            continue
        if (
            length < SHORT
            and beyond
            and (found := rest_between(system, state, trial, free, goal)) is not None
        ):
            return found, count, 0
        if length < TINY and not beyond:  # still more is left over: a jump that must be crossed
            state, R = trial, new
            continue
        mu *= 8.0
        if mu > 1e30:
            break
    return Rest(state, R), count, SINGULAR if mu < 1.0 else DIVERGED


def _wrapped(system: System, state: State) -> State:
    """The same state with every spin as a remainder and whole turns."""
    for b in range(1, len(system.layout.bodies)):
        spin = int(system.program["body"][b]["spin"])
        if spin >= 0:
            turns = int(np.floor(state.q[spin] / (2.0 * np.pi) + 0.5))
            if turns:
                state.q[spin] -= 2.0 * np.pi * turns
                state.turns[b] += turns
    return state


def balancing_loads(system: System) -> list[int]:
    """Records of the torques that the model leaves to balance all others."""
    loads = {} if system.model is None else system.model.loads
    torques = [load.torque for load in loads.values() if load.torque is not None]
    return [k for k, torque in enumerate(torques) if isinstance(torque, Balance)]


def balance_torques(
    system: System,
    state: State,
    held: Sequence[int],
    driven: Sequence[int] = (),
    instants: tuple[NDArray[np.float64], NDArray[np.float64]] = NOW,
) -> tuple[System, tuple[int, ...], list[int]]:
    """Fill in the torques that the model leaves to balance all others.

    Each is what holds its body at its angle in equilibrium, with the drives of its gear train let go.

    Parameters
    ----------
    system, state
        The system and where to look for the equilibrium.
    held
        Spins kept, one for every group of bodies that can turn freely.
    driven
        Those of them whose motion is prescribed.
    instants
        Instants [s] to which all spins turn at their speeds, and the weights of the torques found there.

    Returns
    -------
    tuple
        The system with its torques, the spins of the balancing bodies, and the spins to keep from now on:
        drives stay, other groups keep their balancing body.

    Raises
    ------
    SolverError
        If there is no equilibrium.
    """
    wanted = balancing_loads(system)
    if not wanted:
        return system, (), list(held)
    acting = system.records[LOAD]["i"]  # on a shaft it is the station where the torque acts
    spins = [system.spin(system.layout.bodies[int(acting[k])]) for k in wanted]
    let_go = exchange_all(system, held, spins, state)
    found = find_equilibrium(system, state, let_go)
    reaction = _mean_reaction(system, found, *instants)
    records = system.records[LOAD].copy()
    for k, spin in zip(wanted, spins, strict=True):
        records["value"][k] = reaction[found.held.index(spin)]
    kept = list(complete(system, driven, let_go))
    if is_looped(system):  # a train that continues through loops stays where its torques balance
        kept += [s for s in spins if s not in kept and is_independent(system, state, kept, s)]
    return system.with_params({LOAD: records}), tuple(spins), kept


def _mean_reaction(
    system: System, found: Equilibrium, times: NDArray[np.float64], weights: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Weighted mean of the reactions of an equilibrium whose spins turn on at their speeds.

    Instants without an equilibrium, such as those at a missing tooth, do not count.
    """
    if not times.any():
        return found.reaction
    spins = np.setdiff1d([s for s in system.program["body"]["spin"] if s >= 0], system.states)
    total, counted = np.zeros(len(found.held)), 0.0
    for instant, weight in zip(times[weights > 0.0], weights[weights > 0.0], strict=True):
        state = found.state.copy()
        state.q[spins] += instant * state.v[spins]
        with suppress(SolverError):
            total += weight * find_equilibrium(system, _wrapped(system, state), found.held).reaction
            counted += weight
    return total / counted if counted > 0.0 else found.reaction


def solve_equilibrium(
    system: System, angles: Mapping[str, float] | None = None, speeds: Mapping[str, float] | None = None
) -> xr.Dataset:
    """Static equilibrium of a system under its loads.

    Parameters
    ----------
    system
        The compiled model.
    angles
        Spin angle at which bodies are held, by name [rad]; every group of bodies that could turn freely
        needs one held body and takes its first otherwise.
    speeds
        Speeds by body [rad/s] that friction and dampers see; default at rest.

    Returns
    -------
    xarray.Dataset
        All channels of the system (no dimension), the coordinates over `coordinate`, and the torque that
        holds each kept spin over `held`.

    Raises
    ------
    SolverError
        If there is no equilibrium.
    """
    from pitchpoint.solvers.dataset import point_dataset

    start = system.initial_state()
    held = free_spins(system)
    for name, angle in (angles or {}).items():
        spin = system.spin(name)
        start.q[spin] = angle
        if spin not in held:
            held = exchange(system, held, spin)
    for name, speed in (speeds or {}).items():
        start.v[system.spin(name)] = speed
    settled, balanced, kept = balance_torques(system, _wrapped(system, start), held)
    held = tuple(kept) if balanced and is_looped(settled) else held
    return point_dataset(settled, find_equilibrium(settled, _wrapped(settled, start), held))
