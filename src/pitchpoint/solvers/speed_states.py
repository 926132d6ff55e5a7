# SPDX-License-Identifier: Apache-2.0
"""Relative equilibria of machines with bodies in trees at other speeds, and the linear system about them.

Each equilibrium is continued from the one at the nearest speed. Loads are those of the scenario at the new
speed, with two exceptions that keep the machine in its operation:

* the wind on a rotor changes in proportion to the speed: the flow along the blades keeps its angles, as in
  the operation of a turbine at its optimum tip-speed ratio. A constant wind would stall the blades at low
  speed. A box of turbulence does not change;
* controllers do not act: their states, and the joints that actuators position, such as the pitch of a blade,
  keep their values at the operating point. An integrator would change without limit at any other speed.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace

import numpy as np

from pitchpoint.core.errors import SolverError
from pitchpoint.elements import registry
from pitchpoint.elements.kind import MESH
from pitchpoint.solvers.constraints.free_directions import free_directions
from pitchpoint.solvers.element_tangents import inertial_stiffness, switched
from pitchpoint.solvers.equilibrium.geometric_stiffness import turning_joints
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.equilibrium.unknowns import signal_states, wrapped
from pitchpoint.solvers.initial_state.servos import without_positioned
from pitchpoint.solvers.linear_system import Linearised
from pitchpoint.solvers.stiffness_parts import Array
from pitchpoint.solvers.unloaded_flanks import close_backlash
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System
from pitchpoint.system.wind import has_wind, with_wind


class SpeedStates:
    """Relative equilibria over the speed, for systems with bodies in trees.

    Parameters
    ----------
    linear
        The system about its operating point.
    rates
        Rates of all coordinates with the reference body at 1 rad/s.
    """

    def __init__(self, linear: Linearised, rates: Array) -> None:
        self.linear, self.rates = linear, rates
        system = linear.system
        self.operating = float(linear.state.v @ rates) / max(float(rates @ rates), 1e-300)
        stopped = linear.state.copy()
        stopped.v[:] = 0.0
        self.held = tuple(dict.fromkeys([*linear.held, *(_controlled(linear) if has_wind(system) else ())]))
        self.failed: dict[float, SolverError] = {}
        self.known: list[tuple[float, State]] = [(self.operating, linear.state)]
        elastic = linear.at_rest.K.copy()
        for kind, share in zip(linear.at_rest.kinds, linear.at_rest.shares, strict=True):
            if kind == "rotation":  # centrifugal part at the speeds of the scenario
                elastic[np.ix_(share.places, share.places)] -= share.matrix
        self.mean_K = elastic - evaluate.matrix(system, stopped, 0.0, 0.0, 1.0)
        self.mean_D = linear.at_rest.D - evaluate.matrix(system, stopped, 0.0, 1.0, 0.0)
        meshed = any(registry.find(kind).role == MESH for kind in system.records)
        self.toothless: Mapping[str, slice] | None = (
            {k: slice(None) for k in system.records if registry.find(k).role != MESH} if meshed else None
        )

    def prepare(self, speeds: Array) -> None:
        """Find the equilibria at some speeds [rad/s], beginning at the operating speed."""
        for speed in sorted(map(float, speeds), key=lambda speed: abs(speed - self.operating)):
            with suppress(SolverError):
                self.state(speed)

    def at(self, speed: float) -> Linearised:
        """The linear system at a speed of the reference body [rad/s]."""
        return self.about(*self.state(speed))

    def state(self, speed: float) -> tuple[System, State]:
        """Relative equilibrium at a speed [rad/s].

        Raises
        ------
        SolverError
            If there is none.
        """
        if speed in self.failed:
            raise self.failed[speed]
        system = self._system(speed)
        for nearest in sorted(self.known, key=lambda known: abs(known[0] - speed))[:2]:
            start = nearest[1].copy()
            if nearest[0] == speed and nearest is not self.known[0]:
                return system, start
            start.v[self._moving] = (speed * self.rates)[self._moving]
            try:
                found = find_equilibrium(system, start, self.held, near=True).state
            except SolverError as error:
                self.failed[speed] = error
                continue
            self.failed.pop(speed, None)
            self.known.append((speed, found))
            return system, found
        raise self.failed[speed]

    def turned(self, state: State, speed: float, angle: float) -> tuple[System, State]:
        """Equilibrium at a speed [rad/s] with the reference body turned by an angle [rad] from a state."""
        system, start = self._system(speed), state.copy()
        start.q += angle * self.rates
        found = find_equilibrium(system, wrapped(system, start), self.held, near=True).state
        return system, found

    @property
    def _moving(self) -> Array:
        """Coordinates whose rates are not states."""
        return np.setdiff1d(np.arange(len(self.rates)), self.linear.system.states)

    def _system(self, speed: float) -> System:
        """Copy of the system with the wind of a speed."""
        if self.operating == 0.0:
            return self.linear.system.copy()
        return with_wind(self.linear.system, abs(speed / self.operating))

    def about(self, system: System, state: State, teeth: State | None = None) -> Linearised:
        """The linear system about a state; mesh stiffness is that at rest.

        Unloaded flanks are closed at every speed, as they are at rest. `teeth`: state with the mesh phases.
        """
        linear = self.linear
        close_backlash(system, state, linear.flanks)
        at_rest = state.copy()
        at_rest.v[self._moving] = 0.0
        D, K = self.mean_D.copy(), self.mean_K.copy()
        for target, factors in ((D, (0.0, 1.0, 0.0)), (K, (0.0, 0.0, 1.0))):
            target += self._matrix(system, state, factors, teeth)
        M = evaluate.matrix(system, state, 1.0, 0.0, 0.0)
        K_rest = self.mean_K + self._matrix(system, at_rest, (0.0, 0.0, 1.0), teeth)
        K_rest = K_rest + inertial_stiffness(system, state, at_rest, linear.rigid)
        parts = replace(linear.at_rest, M=M, K=K_rest)
        basis = free_directions(system, state, system.states.tolist())
        return replace(linear, system=system, state=state, at_rest=parts, D=D, K=K, basis=basis)

    def _matrix(
        self, system: System, state: State, factors: tuple[float, float, float], teeth: State | None
    ) -> Array:
        """Matrix of the system at a state, that of its meshes at another one."""
        if teeth is None or self.toothless is None:
            return evaluate.matrix(system, state, *factors)
        there = teeth.copy()
        there.v[:] = state.v
        own = evaluate.matrix(system, there, *factors)
        with switched(system, self.toothless):
            own -= evaluate.matrix(system, there, *factors)
            own += evaluate.matrix(system, state, *factors)
        return own


def _controlled(linear: Linearised) -> list[int]:
    """States of signals, and joints that actuators position."""
    system = linear.system
    joints = [int(k) for k in turning_joints(system)]
    loose = without_positioned(system, linear.state, joints, ())
    return [*(k for k in joints if k not in loose), *map(int, signal_states(system))]
