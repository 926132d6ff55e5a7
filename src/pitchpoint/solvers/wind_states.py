# SPDX-License-Identifier: Apache-2.0
"""Steady operation of a turbine over the wind speed, and the linear system about it.

At every wind speed the speed of the rotor balances the torques of air and generator, and controllers are in
equilibrium. Two cases follow from the integrators of the controllers:

* they rest at their initial value, as a pitch control below the rated speed, whose output is limited: only
  the speed of the rotor is unknown;
* their input is zero, as above the rated speed: their values, such as the pitch, are unknown too.

The second case applies if an integrator would move in the first one and has an effect on the torque. Each
solution begins at that of the nearest wind speed.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pitchpoint.core.errors import SolverError
from pitchpoint.core.progress import report_step
from pitchpoint.core.status import DIVERGED, INCONSISTENT
from pitchpoint.core.units import format_quantity
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.equilibrium.unknowns import integrators, wrapped
from pitchpoint.solvers.gear_trains import driven_coordinates
from pitchpoint.solvers.initial_state.filters import slipping_frictions, states_of_inputs
from pitchpoint.solvers.initial_state.servos import without_positioned
from pitchpoint.solvers.linear_system import Linearised
from pitchpoint.solvers.speed_states import SpeedStates
from pitchpoint.solvers.stiffness_parts import Array
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System
from pitchpoint.system.wind import with_wind

STEP = 2.0
"""Largest step of the wind speed between two equilibria [m/s]."""
ROUNDS = 25
"""Maximum number of corrections of speed and integrators."""
ACCURATE = 1e-7
"""Relative change of the speed, and change of an integrator, at which they are found."""
TRIAL = 1e-3
"""Change of the speed (relative) and of integrators (absolute, relative above 1) for differences."""
LARGEST = 0.1
"""Largest relative change of the speed in one correction."""
WEAK = 1e-7
"""Effect of a unit of an integrator over that of a unit of the speed, below which it has none."""
MOMENT, RESTS = 0.01, 1e-4
"""Time [s] over which an integrator moves at its rate, and the effect per second on the torque, over that of
a relative change of the speed, below which it rests."""


@dataclass(frozen=True)
class Operation:
    """Steady operation at one wind speed: speed of the body of reference [rad/s], the system, its state."""

    speed: float
    system: System
    state: State


class WindStates(SpeedStates):
    """Equilibria over the wind speed [m/s].

    Parameters
    ----------
    linear
        The system about the operating point of a scenario.
    rates
        Rates of all coordinates with the reference body at 1 rad/s.

    Raises
    ------
    SolverError
        If the machine has no rotor in a steady wind, a free rotor without speed, or several groups of bodies
        that rotate freely.
    """

    def __init__(self, linear: Linearised, rates: Array) -> None:
        super().__init__(linear, rates)
        system = linear.system
        self.wind = wind_speed_of(system)
        driven = [int(k) for k in driven_coordinates(system)]
        spins = without_positioned(system, linear.state, linear.held, driven)
        self.idle = [int(k) for k in integrators(system, linear.state)]
        self.held = (*spins, *self.idle)
        self.open = [n for n, k in enumerate(spins) if k not in driven and rates[k] != 0.0]
        if len(self.open) > 1:
            raise SolverError(
                "several groups of bodies rotate freely, and the speed of the rotor does not give those of "
                "the others; drive or connect them",
                INCONSISTENT,
            )
        if self.open and self.operating == 0.0:
            raise SolverError(
                "the rotor is free and has no speed at the start, with which the operating points begin; "
                "give the scenario a speed of the rotor",
                INCONSISTENT,
            )
        self.limits = system.initial_state().v[self.idle]
        """Values of the integrators at which the limits of controllers hold."""
        self.regulated = False
        self.found: dict[float, Operation] = {}
        self.now = system

    def prepare(self, speeds: Array) -> None:
        """Find the operation at some wind speeds [m/s], beginning at the wind of the scenario."""
        for part in (speeds[speeds >= self.wind], speeds[speeds < self.wind][::-1]):
            self.regulated = bool(np.any(self.linear.state.v[self.idle] != self.limits))
            last = Operation(self.operating, self.linear.system, self.linear.state)
            last, at = self._solved(self.wind, last), self.wind
            for wind in map(float, part):
                report_step(f"operating point at {format_quantity(wind, 'speed', 4)}")
                try:
                    for between in np.linspace(at, wind, int(np.ceil(abs(wind - at) / STEP)) + 1)[1:-1]:
                        last = self._solved(float(between), last)
                    last, at = self._solved(wind, last), wind
                    self.found[wind] = last
                except SolverError as error:
                    self.failed[wind] = error

    def operation(self, wind: float) -> Operation:
        """Steady operation at a wind speed of `prepare` [m/s]; SolverError if there is none."""
        if wind in self.failed:
            raise self.failed[wind]
        return self.found[wind]

    def at(self, wind: float) -> Linearised:
        """The linear system at a wind speed of `prepare` [m/s]."""
        found = self.operation(wind)
        self.now = found.system
        return self.about(found.system.copy(), found.state)

    def turned(self, state: State, speed: float, angle: float) -> tuple[System, State]:
        """Equilibrium with the reference body turned by an angle [rad] from the last state of `at`."""
        system, start = self.now.copy(), state.copy()
        start.q += angle * self.rates
        return system, find_equilibrium(system, wrapped(system, start), self.held, near=True).state

    def _solved(self, wind: float, last: Operation) -> Operation:
        """Operation at a wind speed, beginning at another one."""
        system = with_wind(self.linear.system, wind / self.wind)
        trial = _Trial(self, system, last)
        if not self.open:
            return trial.operation(last.speed, self.limits)
        if self.regulated:
            found = trial.regulated()
            if found is not None and not trial.moves(found):
                return found
        limited = trial.limited()
        if not trial.moves(limited):
            self.regulated = False
            return limited
        found = _Trial(self, system, limited).regulated()
        if found is None or trial.moves(found):
            words = format_quantity(wind, "speed", 4)
            raise SolverError(f"controllers have no steady state at {words}", DIVERGED)
        self.regulated = True
        return found


class _Trial:
    """Solutions at one wind speed; parameters as in `WindStates._solved`."""

    def __init__(self, states: WindStates, system: System, last: Operation) -> None:
        self.of, self.system, self.last = states, system, last
        self.state = last.state

    def operation(self, speed: float, integrators: Array) -> Operation:
        """Equilibrium at a speed and with values of the integrators."""
        return Operation(speed, self.system, self._at(speed, integrators)[1])

    def _at(self, speed: float, integrators: Array) -> tuple[Array, State]:
        """Net torque and rates of the integrators, and the state."""
        of, start = self.of, self.state.copy()
        start.v[of._moving] = (speed * of.rates)[of._moving]
        start.v[of.idle] = integrators
        # small changes of states are within the tolerance of the forces: settle them first
        start = states_of_inputs(self.system, slipping_frictions(self.system, start))
        found = find_equilibrium(self.system, start, of.held, near=True)
        self.state = found.state
        rates = -evaluate.residual(self.system, found.state)[of.idle]
        return np.array([*(-found.reaction[of.open]), *rates]), found.state

    def limited(self) -> Operation:
        """Balance of torques with integrators at their limits."""
        speed, fixed = self.last.speed, self.of.limits
        left = self._at(speed, fixed)[0][0]
        slope = (self._at(speed * (1.0 + TRIAL), fixed)[0][0] - left) / (speed * TRIAL)
        for _ in range(ROUNDS):
            step = float(np.clip(-left / slope, -LARGEST * abs(speed), LARGEST * abs(speed)))
            now, state = self._at(speed + step, fixed)
            if abs(step) <= ACCURATE * abs(speed):
                return Operation(speed + step, self.system, state)
            if now[0] != left:
                slope = (now[0] - left) / step
            speed, left = speed + step, now[0]
        raise SolverError("no speed of the rotor balances the torques", DIVERGED)

    def moves(self, found: Operation) -> bool:
        """Whether an integrator moves there that acts on the torque."""
        values = found.state.v[self.of.idle]
        here, _ = self._at(found.speed, values)
        for n in np.flatnonzero(here[1:]):
            other = values.copy()
            other[n] += MOMENT * here[1 + n]
            if abs(self._at(found.speed, other)[0][0] - here[0]) > RESTS * MOMENT * self._torque(found):
                return True
        return False

    def _torque(self, found: Operation) -> float:
        """Change of the net torque over the relative change of the speed, for comparison."""
        low, high = (
            self._at(found.speed * (1.0 + d), found.state.v[self.of.idle])[0][0] for d in (0.0, TRIAL)
        )
        return float(abs(high - low)) / TRIAL

    def regulated(self) -> Operation | None:
        """Balance of torques with integrators whose input is zero; None if they do not act there."""
        x = np.array([self.last.speed, *self.last.state.v[self.of.idle]])
        try:
            left, _ = self._at(x[0], x[1:])
            sizes = np.maximum(1.0, np.abs(x)) * TRIAL
            slopes = np.column_stack([(self._at(*_split(x + d))[0] - left) / d.sum() for d in np.diag(sizes)])
            acting = np.flatnonzero(np.abs(slopes[0]) > WEAK * abs(slopes[0, 0]))
            if acting.size < 2:
                return None
            for _ in range(ROUNDS):
                own = np.ix_(acting, acting)
                step = np.zeros(x.size)
                step[acting] = -np.linalg.solve(slopes[own], left[acting])
                step *= min(1.0, LARGEST * abs(x[0]) / max(float(np.abs(step).max()), 1e-300))
                now, state = self._at(*_split(x + step))
                x = x + step
                if np.all(np.abs(step) <= ACCURATE * np.maximum(1.0, np.abs(x))):
                    return Operation(float(x[0]), self.system, state)
                change = now - left
                slopes += np.outer(change - slopes @ step, step) / float(step @ step)
                left = now
        except (SolverError, np.linalg.LinAlgError):
            return None
        return None


def _split(x: Array) -> tuple[float, Array]:
    """Speed and integrators."""
    return float(x[0]), x[1:]


def wind_speed_of(system: System) -> float:
    """Mean wind speed at the hub of the first rotor [m/s].

    Raises
    ------
    SolverError
        If there is no rotor in the wind, or its wind is a box of turbulence with its own mean.
    """
    for bank in system.records.values():
        if "wind" in (bank.dtype.names or ()) and len(bank):
            speed = float(bank["wind"]["speed"][0])
            if speed > 0.0:
                return speed
    raise SolverError(
        "no rotor is in a steady wind, so there are no modes over the wind speed; give wind_rotors with "
        "winds that have a speed",
        INCONSISTENT,
    )
