# SPDX-License-Identifier: Apache-2.0
"""Static equilibrium of a system under its loads, with gears in contact or not.

Newton's method cannot start inside the backlash, where rotation is unconstrained. So each step solves
(K + M/tau^2) dq = -R: with a short pseudo-time tau the bodies move along their loads until flanks touch; with
a growing tau the step becomes a Newton step. Free spins (every rigid gear train has one) are held at their
angle; the holding torque is reported: it is zero if the loads balance.

A step is accepted by the size of the step that would follow it with the same matrix, in the mass norm.
Residuals do not measure progress: they may grow (a gear train multiplies a torque before the next mesh
carries it).

Sources: C. T. Kelley, D. E. Keyes, Convergence analysis of pseudo-transient continuation, SIAM
Journal on Numerical Analysis 35 (1998) 508-523; P. Deuflhard, Newton Methods for Nonlinear Problems, 2004
(natural monotonicity).
"""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.progress import report_step
from pitchpoint.core.status import DIVERGED, SINGULAR
from pitchpoint.solvers.element_batches import free_flying
from pitchpoint.solvers.equilibrium.approach import Contacts
from pitchpoint.solvers.equilibrium.balancing import LOAD, balancing_loads, balancing_spins
from pitchpoint.solvers.equilibrium.centring import centred
from pitchpoint.solvers.equilibrium.closed_loops import is_looped, rest_of_mechanism
from pitchpoint.solvers.equilibrium.failure import broken_tooth, reason
from pitchpoint.solvers.equilibrium.floating import balanced_drift, floating_force
from pitchpoint.solvers.equilibrium.force_jumps import (
    Rest,
    Surface,
    crossed,
    observe_mean,
    rest_between,
    rest_on_surfaces,
)
from pitchpoint.solvers.equilibrium.geometric_stiffness import Tangent, resists
from pitchpoint.solvers.equilibrium.secant import corrected
from pitchpoint.solvers.equilibrium.unknowns import (
    GROWTH,
    ROUNDING,
    SOFTENING,
    extents,
    inverse_of,
    rest_matrix,
    unsettled_states,
    without_rate_limits,
    wrapped,
)
from pitchpoint.solvers.gear_trains import complete, exchange, exchange_all, held_spins, is_independent
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import forget_contacts
from pitchpoint.system.residual import NEWTON
from pitchpoint.system.system import State, System

if TYPE_CHECKING:
    import xarray as xr

MAX_ITERATIONS = 400
TOLERANCE = 1e-9
"""Residual over the largest load, up to which a state counts as equilibrium."""
NEGLIGIBLE = 1e-12
"""Residual over the loads of the initial state, up to which any state is in equilibrium, however close to one
the iteration starts: a body that floats in the clearance of a bearing has no stiffness to oppose them."""
RESOLVED = 1e-13
"""Newton step over the size of a coordinate that is no more than its rounding error, in hundreds of terms."""
CLOSE = 8.0  # residual over the goal that is no more than rounding, too
FIRST = 1e4
"""Mass factor 1/tau^2 of the first step [1/s^2]."""
NEAR = 1.0  # from an equilibrium for similar loads
TINY = 1e-9  # step [m] over which a continuous force is practically constant
HEAVY = 1e8
"""Mass factor [1/s^2] beyond which exact tangents that are not positive definite are abandoned: those of
controllers need not be, as their forces do not derive from an energy."""
SLUGGISH = 10
"""Number of steps from which tangents are corrected by the last step, once it is nearly a Newton step."""
LONGEST = 0.3  # largest joint rotation per step with exact tangents [rad]
SLOW = 1.0  # time [s] after which the iteration reports its number of steps
NOW = np.zeros(1), np.ones(1)  # only the initial instant, with weight one
SHORT = 1e-6  # step [m] below which a rejected step is searched for a force jump


@dataclass(frozen=True)
class Equilibrium:
    """A state at rest.

    Parameters
    ----------
    state
        The state; velocities are the given ones.
    held
        Coordinates that were held.
    reaction
        Holding torque of each of them [N m], shape (len(held),).
    iterations
        Number of Newton steps.
    other_sides, share
        For every force jump at the equilibrium: the state on its other side, and the weight of the forces on
        that side.
    """

    state: State
    held: tuple[int, ...]
    reaction: NDArray[np.float64]
    iterations: int
    other_sides: tuple[State, ...] = ()
    share: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0))

    def __repr__(self) -> str:
        return f"Equilibrium({self.state!r}, {len(self.held)} held, {self.iterations} iterations)"

    def observe(self, system: System) -> NDArray[np.float64]:
        """All channels, in the order of ``system.layout.channels``; at a jump the equilibrium mean."""
        return observe_mean(system, self.state, self.other_sides, self.share)


def find_equilibrium(
    system: System,
    start: State | None = None,
    held: Sequence[int] | None = None,
    *,
    tolerance: float = TOLERANCE,
    near: bool = False,
) -> Equilibrium:
    """Find the equilibrium near an initial state.

    Parameters
    ----------
    system
        The system; constraint rows of drives are ignored (they prescribe motion, not rest).
    start
        Initial state; its velocities are retained and define the friction. Default: the initial state.
    held
        Coordinates to hold. Default: `held_spins`.
    tolerance
        Largest residual, relative to the loads.
    near
        Whether the initial state is an equilibrium for similar loads: the first steps are then longer.

    Returns
    -------
    Equilibrium

    Raises
    ------
    SolverError
        If no equilibrium is found: a loaded direction is unconstrained, or a force law has no equilibrium.
    """
    kept = held_spins(system) if held is None else tuple(held)
    system = without_rate_limits(system)
    state = (centred(system, system.initial_state(), kept) if start is None else start).copy()
    state.a[:] = 0.0
    free = np.setdiff1d(np.arange(system.sizes["nd"]), kept)
    evaluate.prepare(system)
    idle = unsettled_states(system, state, free)
    free = np.setdiff1d(free, idle) if idle.size else free
    if state.v.any():  # the inertia forces of a body that tumbles freely displace nothing
        free = np.setdiff1d(free, free_flying(system))
    if is_looped(system):
        mechanism = rest_of_mechanism(system, state, (*kept, *map(int, idle)), tolerance)
        if words := broken_tooth(system, mechanism.state):
            raise SolverError(words, DIVERGED, mechanism.state)
        reaction = mechanism.residual[list(kept)].copy()
        return Equilibrium(wrapped(system, mechanism.state), kept, reaction, mechanism.steps)
    found, count, failure, worst = _pseudo_time(system, state, free, tolerance, NEAR if near else FIRST)
    if words := broken_tooth(system, found.state):
        raise SolverError(words, DIVERGED, found.state)
    if failure:
        words, singular = reason(system, state, free, found, count, worst)
        raise SolverError(words, SINGULAR if singular else failure, found.state)
    other_sides = tuple(wrapped(system, other) for other in found.other_sides)
    reaction = found.residual[list(kept)].copy()
    return Equilibrium(wrapped(system, found.state), kept, reaction, count, other_sides, found.share)


def _pseudo_time(
    system: System, state: State, free: NDArray[np.int64], tolerance: float, first: float = FIRST
) -> tuple[Rest, int, int, int]:
    """Iterate the free coordinates to equilibrium.

    Returns the result, the step count, the status (0: success) and the coordinate farthest from its goal.
    """
    weight = 1.0 / system.weight  # residuals as forces
    R = evaluate.residual(system, state)
    mass, root, damping = None, np.zeros(0), np.zeros(R.size)
    if state.v.any():
        damping = abs(rest_matrix(system, state, NEWTON, (0.0, 1.0, 0.0))) @ np.abs(state.v)
    begin = replace(system.initial_state(), v=state.v.copy())  # constant power is infinite at rest
    unloaded = evaluate.residual(system, begin)
    loads = float(np.abs(unloaded * weight).max(initial=0.0))
    wanted = max(tolerance * float(np.abs(R * weight).max(initial=0.0)), NEGLIGIBLE * loads)
    tangent, contacts, started = Tangent(system, state), Contacts.of(system), time.monotonic()
    swings = np.isin(free, tangent.joints)
    passing: set[Surface] = set()  # surfaces without an equilibrium at the last trial
    mu, floats, size = first, False, extents(system)
    learned: tuple[NDArray[np.float64], NDArray[np.float64]] | None = None  # last step, residual missed
    for count in range(MAX_ITERATIONS):
        whole = tangent.at(state, count)
        # the force error of rounded positions limits the residual
        rounded = ROUNDING * weight * (abs(whole) @ (np.abs(state.q) + size) + damping)
        goal = np.maximum(rounded, wanted)[free]
        left = np.abs((R * weight)[free])
        if (left <= goal).all():
            return Rest(state, R), count, 0, -1
        if mass is None:  # not needed if the initial state is in equilibrium
            mass = rest_matrix(system, state, NEWTON, (1.0, 0.0, 0.0))[free][:, free]
            root = np.sqrt(mass.diagonal())
        pulled = whole[free][:, free] + mu * mass
        if tangent.exact and not resists(pulled):  # the step would lead to an unstable equilibrium
            mu *= 8.0
            if mu > HEAVY:
                tangent.refuse()
                mu = FIRST
            continue
        inverse = inverse_of(pulled, root)
        if count >= SLUGGISH and mu <= FIRST and learned is not None:
            inverse = corrected(inverse, *learned, mass)
        allowed = goal / weight[free]
        drift = balanced_drift(R[free], mass, mu, inverse, allowed) if floats else None
        step = -inverse(R[free] if drift is None else R[free] - drift)
        if time.monotonic() - started > SLOW:
            report_step(f"equilibrium, step {count + 1}")
        turn = float(np.abs(step[swings]).max(initial=0.0)) if tangent.exact else 0.0
        try:
            trial = contacts.step_on(system, state, free, step * (LONGEST / turn if turn > LONGEST else 1.0))
            new = evaluate.residual(system, trial)
        except SolverError:
            mu *= 16.0
            continue
        moved = (trial.q - state.q)[free]
        known = drift is None and not system.states.size and moved.any()  # states are stored as rates
        learned = (moved, (new - R - whole[:, free] @ moved)[free]) if known else None
        after = new[free] if drift is None else new[free] - floating_force(new[free], mass, mu, inverse)
        ratio = float(np.linalg.norm(root * inverse(after)) / np.linalg.norm(root * step))
        beyond = float(new[free] @ step) > 0.0  # the forces oppose the step: it went too far
        if drift is None and ratio >= 0.9 and not beyond:
            floats = balanced_drift(R[free], mass, mu, inverse, allowed) is not None
            if floats:
                continue
        # a roller bearing turns to its next stable position, by forces that grow along the way
        softens = float(np.abs(new * weight)[free].max(initial=0.0)) <= loads
        growth = SOFTENING if softens else GROWTH
        # forces grow first on bodies that swing down from an unstable position
        if ratio < 0.9 or ((ratio <= growth or tangent.exact) and not beyond):
            mu = max(mu * (0.1 if ratio < 0.5 else 0.5), 1e-3)
            state, R = trial, new
            continue
        if drift is None and (left <= tolerance * loads).all():  # rounding of many terms may exceed the goal
            whole_step = inverse_of(whole[free][:, free] + 1e-3 * mass, root)(R[free])
            small = np.abs(whole_step) <= RESOLVED * (np.abs(state.q) + size)[free]
            if (small | (left <= CLOSE * goal)).all():
                return Rest(state, R), count, 0, -1
        length = float(np.abs(step * system.weight[free]).max(initial=0.0))
        if length < SHORT and (surfaces := crossed(system, state, trial)):
            rest = None if passing & {*surfaces} else rest_on_surfaces(system, state, surfaces, free, goal)
            if rest is not None and rest.holds:
                return rest, count, 0, -1
            # the residual beyond a jump does not measure the step across it
            state = trial if rest is None else rest.state
            R = evaluate.residual(system, state)
            passing, mu = (set(), mu) if rest is None else ({*surfaces}, FIRST)
            continue
        if (
            length < SHORT
            and beyond
            and (found := rest_between(system, state, trial, free, goal)) is not None
        ):
            return found, count, 0, -1
        if length < TINY and not beyond:  # the residual still acts along the step: cross the jump
            state, R = trial, new
            continue
        mu *= 8.0
        if mu > 1e30:
            break
    worst = int(free[np.argmax(left / np.maximum(goal, np.finfo(float).tiny))])
    return Rest(state, R), count, SINGULAR if mu < 1.0 else DIVERGED, worst


def balance_torques(
    system: System,
    state: State,
    held: Sequence[int],
    driven: Sequence[int] = (),
    instants: tuple[NDArray[np.float64], NDArray[np.float64]] = NOW,
) -> tuple[System, tuple[int, ...], list[int], int]:
    """Compute the balancing torques of the model.

    Each is the holding torque of its body in equilibrium, with the drives of its gear train released.

    Parameters
    ----------
    system, state
        The system and the initial state of the iteration.
    held
        Spins held, one for every group of bodies that can rotate freely.
    driven
        Spins among them whose motion is prescribed.
    instants
        Instants [s] to which all spins are advanced at their speeds, and the weights of the torques there.

    Returns
    -------
    tuple
        The system with its torques; the spins of the balancing bodies; the spins to hold afterwards: drives,
        and the balancing body in the other groups; the number of instants without an equilibrium.

    Raises
    ------
    SolverError
        If there is no equilibrium.
    """
    wanted = balancing_loads(system)
    if not wanted:
        return system, (), list(held), 0
    spins = balancing_spins(system)
    let_go = exchange_all(system, held, spins, state)
    found = find_equilibrium(system, centred(system, state, let_go), let_go)
    reaction, skipped = _mean_reaction(system, found, *instants)
    records = system.records[LOAD].copy()
    for k, spin in zip(wanted, spins, strict=True):
        records["value"][k] = reaction[found.held.index(spin)]
    kept = list(complete(system, driven, let_go))
    if is_looped(system):  # trains joined through loops are held at their balancing bodies
        kept += [s for s in spins if s not in kept and is_independent(system, state, kept, s)]
    return system.with_params({LOAD: records}), tuple(spins), kept, skipped


def _mean_reaction(
    system: System, found: Equilibrium, times: NDArray[np.float64], weights: NDArray[np.float64]
) -> tuple[NDArray[np.float64], int]:
    """Weighted mean of the reactions over instants to which the spins are advanced at their speeds.

    Instants without an equilibrium, such as those at a missing tooth, are skipped and counted.
    """
    if not times.any():
        return found.reaction, 0
    spins = np.setdiff1d([s for s in system.program["body"]["spin"] if s >= 0], system.states)
    total, counted, skipped = np.zeros(len(found.held)), 0.0, 0
    for instant, weight in zip(times[weights > 0.0], weights[weights > 0.0], strict=True):
        state = found.state.copy()
        state.q[spins] += instant * state.v[spins]
        try:
            total += weight * find_equilibrium(system, wrapped(system, state), found.held).reaction
            counted += weight
        except SolverError:
            skipped += 1
    return total / counted if counted > 0.0 else found.reaction, skipped


def solve_equilibrium(
    system: System, angles: Mapping[str, float] | None = None, speeds: Mapping[str, float] | None = None
) -> xr.Dataset:
    """Static equilibrium of a system under its loads.

    Parameters
    ----------
    system
        The compiled model.
    angles
        Spin angle at which bodies are held, by name [rad]; every group of bodies that can rotate freely needs
        one held body: by default those that the scenario drives or holds, else the first.
    speeds
        Speeds by body [rad/s] for friction and dampers; default zero.

    Returns
    -------
    xarray.Dataset
        All channels of the system (no dimension), the coordinates over `coordinate`, and the holding torque
        of each held spin over `held`.

    Raises
    ------
    SolverError
        If there is no equilibrium.
    """
    from pitchpoint.solvers.dataset import point_dataset

    forget_contacts(system)
    start = system.initial_state()
    held = held_spins(system)
    for name, angle in (angles or {}).items():
        spin = system.spin(name)
        start.q[spin] = angle
        if spin not in held:
            held = exchange(system, held, spin)
    for name, speed in (speeds or {}).items():
        start.v[system.spin(name)] = speed
    settled, balanced, kept, _ = balance_torques(system, wrapped(system, start), held)
    held = tuple(kept) if balanced and is_looped(settled) else held
    start = centred(settled, wrapped(settled, start), held)
    return point_dataset(settled, find_equilibrium(settled, start, held))
