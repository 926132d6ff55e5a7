# SPDX-License-Identifier: Apache-2.0
"""Steady motion of a train under pulsating torques: mean torques over the period, ripple of the speed.

The train moves as a rigid body with the mean speeds of the scenario and a ripple of zero mean, by
`steady_motion`. Constant torques that balance the mean torques over this motion keep the mean speed exactly;
their work over the period balances, too. All loads share one time grid over their common period. Without a
common period they are averaged over many periods with a smooth window.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.formula.formula import Formula
from pitchpoint.core.formula.periods import phases_of
from pitchpoint.elements.signal import CONSTANT, FORMULA, LAW, OVER_ANGLE, TABLE, set_constant
from pitchpoint.elements.torque import KIND, slopes_of, values_of
from pitchpoint.elements.torsion import sense_of, turn_between
from pitchpoint.model.components.law import FormulaLaw
from pitchpoint.solvers.equilibrium.unknowns import rest_matrix
from pitchpoint.solvers.gear_trains import rotations
from pitchpoint.solvers.load_waves import SAME, TURNS, Wave, grid_of, waves_of
from pitchpoint.solvers.steady_motion import Motion, Torques, path_from, steady_motion, window
from pitchpoint.solvers.torque_paths import turning
from pitchpoint.system import evaluate
from pitchpoint.system.residual import NEWTON
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

LOAD = KIND.name
ROUND_OFF = 1e-14
"""Mean of a torque relative to its largest value that counts as zero."""
MAX_TURNS = 12
"""Revolutions within which a user law of the angle must repeat to count as periodic."""


@dataclass(frozen=True)
class LoadCycle:
    """Mean torques of pulsating loads over a steady motion.

    Parameters
    ----------
    means
        Mean torque over time by record of the torques [N m]; loads that do not repeat are omitted.
    period
        Common period of the loads [s]; 0 if there is none.
    averaged
        Time over which the torques were averaged [s].
    error
        Estimated error of the mean torques [N m].
    offset
        Deviation of the rates at the start from their means, shape (nd,); zero for trains at rest.
    lowest, highest
        Least and largest deviation of the rates from their means, shape (nd,).
    swing
        Peak-to-peak value of the ripple of the coordinates, shape (nd,).
    steady
        Whether the steady motion was found. If not, all loads were averaged at constant speed.
    stops
        Bodies that a rigid train would stop within the time of the mean, and when [s], if it started at
        constant speed; computed without steady motion only.
    waves
        Harmonics of the loads, as torques on the coordinates.
    body
        Of a slow roll the body whose angle [rad] takes the place of the time; else empty.
    """

    means: dict[int, float]
    period: float
    averaged: float
    error: float
    offset: Array
    lowest: Array
    highest: Array
    swing: Array
    steady: bool = True
    stops: dict[str, float] = field(default_factory=dict)
    waves: tuple[Wave, ...] = ()
    body: str = ""

    def applied(self, system: System) -> System:
        """Copy of the system with the mean torques."""
        records = system.records[LOAD].copy()
        for k, mean in self.means.items():
            set_constant(records[k], mean)
        return system.with_params({LOAD: records})

    def allowance(self, spin: int, window: float) -> float:
        """Largest deviation of the mean rate of a spin over a window [s] from that of the steady motion."""
        largest = max(-float(self.lowest[spin]), float(self.highest[spin]))
        return min(largest, float(self.swing[spin]) / window) if window > 0.0 else largest


@dataclass(frozen=True)
class PulsatingLoad:
    """A torque that repeats over a rigid motion.

    Parameters
    ----------
    number, record
        Its record and number.
    begin
        Time at the beginning [s].
    angle, speed
        Angle [rad] at the beginning and mean speed [rad/s] of its body, relative to that of the reaction.
    row
        Its speed per rate of the coordinates, shape (nd,).
    share
        Share of the free rotations in this angle.
    by_angle
        Periods of its arguments per revolution; empty if it does not depend on the angle.
    timed
        Whether an argument depends on time.
    rates
        Rates of the arguments [rad/s].
    """

    number: int
    record: np.void
    begin: float
    angle: float
    speed: float
    row: Array
    share: Array
    by_angle: tuple[float, ...]
    timed: bool
    rates: tuple[float, ...]

    def over(self, t: Array, speed: Array, angle: Array) -> tuple[Array, Array, Array]:
        """Torque and slopes over angle and speed, for times since the beginning and ripples (n, times)."""
        turned = self.angle + self.speed * t + self.share @ angle
        return slopes_of(self.record, self.begin + t, turned, self.speed + self.share @ speed)

    def at_angles(self, angles: Array, speed: float) -> Array:
        """Torque at the beginning over the angles of the body at a speed, shape of `angles`."""
        return values_of(self.record, self.begin, angles, speed)


def load_cycle(system: System, state: State, held: Sequence[int], driven: Sequence[int]) -> LoadCycle | None:
    """Mean torques of the pulsating loads, with all trains at their mean speed; None if no load pulsates.

    Parameters
    ----------
    system, state
        The system and the state at the beginning, with the mean rates.
    held
        Spins held at the start, one for every free rotation.
    driven
        Spins among them with prescribed motion, whose speed has no ripple.
    """
    records = system.records.get(LOAD)
    if records is None or not np.any(records["form"] != CONSTANT):
        return None
    evaluate.residual(system, state)
    free = [k for k, spin in enumerate(held) if spin not in set(driven)]
    motions = rotations(system, held)[:, free] if held else np.zeros((system.sizes["nd"], 0))
    loads = pulsating_loads(system, state, motions)
    rates = np.array(sorted({abs(rate) for load in loads for rate in load.rates}))
    if not rates.size:
        return None
    h, points, period = grid_of(rates)
    mass = motions.T @ rest_matrix(system, state, NEWTON, (1.0, 0.0, 0.0)) @ motions
    torques = _torques(loads, h, len(free))
    found = steady_motion(torques, mass, h, points, period > 0.0)
    motion = found or _constant_speed(torques, len(free), points, period > 0.0)
    t, weights = np.linspace(0.0, h * (motion.weights.size - 1), motion.weights.size), motion.weights
    values = {load.number: load.over(t, motion.speed, motion.angle)[0] for load in loads}
    means = {k: _without_round_off(float(weights @ over), over) for k, over in values.items()}
    # every second point of a period, or the second half without one
    whole = period > 0.0 and t.size == points
    part = slice(None, None, 2) if whole else slice(t.size // 2, None)
    fewer = weights[::2] / weights[::2].sum() if whole else window(t.size - t.size // 2)
    moving = (np.abs(motions.T) @ np.abs(state.v) > 0.0).astype(float)
    ranges = np.array([_range_of(row, motion) for row in motions]).reshape(-1, 3).T
    return LoadCycle(
        means=means,
        period=period,
        averaged=period if whole else float(t[-1]),
        error=max(abs(float(fewer @ values[k][part]) - means[k]) for k in means),
        offset=np.asarray(motions @ (moving * motion.speed[:, 0])),
        lowest=ranges[0],
        highest=ranges[1],
        swing=ranges[2],
        steady=found is not None,
        stops={}
        if found is not None
        else _stops(system, loads, path_from(torques, mass, h, motion.weights.size, motion.torque), h),
        waves=waves_of(loads, values if whole else {}, period) if found is not None else (),
    )


def _torques(loads: list[PulsatingLoad], h: float, n: int) -> Torques:
    """Sum of the loads on the free rotations at points of distance h [s]."""

    def over(part: slice, speed: Array, angle: Array) -> tuple[Array, Array, Array]:
        """Torques and slopes, see `Torques`."""
        t = h * np.arange(part.start, part.stop)
        total, by_angle, by_speed = np.zeros((n, t.size)), np.zeros((n, n, t.size)), np.zeros((n, n, t.size))
        for load in loads:
            value, over_angle, over_speed = load.over(t, speed, angle)
            shares = np.outer(load.share, load.share)[:, :, None]
            total += np.outer(load.share, value)
            by_angle += shares * over_angle
            by_speed += shares * over_speed
        return total, by_angle, by_speed

    return over


def _constant_speed(torques: Torques, n: int, points: int, periodic: bool) -> Motion:
    """Motion without ripple."""
    rest, weights = np.zeros((n, points)), np.full(points, 1.0 / points) if periodic else window(points)
    return Motion(rest, rest, weights, torques(slice(0, points), rest, rest)[0] @ weights)


def _range_of(row: Array, motion: Motion) -> tuple[float, float, float]:
    """Least and largest ripple of a rate, and peak-to-peak ripple of its coordinate."""
    if not row.any():
        return 0.0, 0.0, 0.0
    speed, angle = row @ motion.speed, row @ motion.angle
    return float(speed.min()), float(speed.max()), float(np.ptp(angle))


def _stops(system: System, loads: list[PulsatingLoad], path: Array | None, h: float) -> dict[str, float]:
    """Loaded bodies that reach standstill in a motion of the free rotations, and when [s]."""
    found: dict[str, float] = {}
    for load in loads:
        if path is None or load.speed == 0.0:
            continue
        still = np.flatnonzero(load.share @ path / load.speed <= -1.0)
        if still.size:
            found[system.layout.bodies[int(load.record["i"])]] = float(still[0]) * h
    return found


def pulsating_loads(system: System, state: State, motions: Array) -> list[PulsatingLoad]:
    """Loads whose torque repeats over the motion, with the rates of their arguments."""
    found = []
    given = [] if system.model is None else [load.torque for load in system.model.loads.values()]
    laws = [law for law in given if law is not None]
    for k, (record, law) in enumerate(zip(system.records[LOAD], laws, strict=False)):
        if int(record["form"]) == CONSTANT:
            continue
        angle, speed, row = relative_turn(system, state, record)
        phases = _phases(record, law, angle, speed)
        if phases is not None:
            rates = (by_time + by_angle * speed for by_time, by_angle in phases)
            found.append(
                PulsatingLoad(
                    number=k,
                    record=record,
                    begin=state.t,
                    angle=angle,
                    speed=speed,
                    row=row,
                    share=row @ motions,
                    by_angle=tuple(sorted({abs(by_angle) for _, by_angle in phases if by_angle != 0.0})),
                    timed=any(by_time != 0.0 for by_time, _ in phases),
                    rates=tuple(rate for rate in rates if rate != 0.0),
                )
            )
    return found


def relative_turn(system: System, state: State, record: np.void) -> tuple[float, float, Array]:
    """Angle [rad] and speed [rad/s] of the body of a load relative to its reaction; the speed per rate.

    The frames are those of the last evaluation.
    """
    system.workspace  # noqa: B018 - fills in the addresses of the records
    frames, i, j = system.workspace.fr, int(record["i"]), int(record["j"])
    sense = int(sense_of(frames[i], frames[j], j))
    rest, turns = turn_between(frames[i], frames[j], sense)
    row = np.zeros(len(state.v))
    for body, sign in ((i, 1.0), (j, -float(sense))):
        for spin, value in turning(system, body, sign).items():
            row[spin] += value
    return float(rest + TURNS * turns), float(row @ state.v), row


def _phases(record: np.void, law: object, angle: float, speed: float) -> list[tuple[float, float]] | None:
    """Arguments of a load, as coefficients of time and angle; None if it does not repeat."""
    form = int(record["form"])
    if float(record["ramp"]) > 0.0:
        return None
    if form == FORMULA and isinstance(law, FormulaLaw):
        found = phases_of(Formula.parse(law.text, law.variables), ("speed",))
        return None if found is None else [(by_time, by_angle) for by_time, by_angle, _ in found]
    if form == TABLE and int(record["over"]) == OVER_ANGLE:
        return [(0.0, TURNS / float(record["period"]))]
    if form == LAW:
        return _turns_of_law(record, angle, speed)
    return None


def _turns_of_law(record: np.void, angle: float, speed: float) -> list[tuple[float, float]] | None:
    """Argument of a user law that repeats after some revolutions; None if it does not, or depends on time."""
    over = angle + np.arange(720) * (TURNS / 720)
    first = values_of(record, 0.0, over, speed)
    size = float(np.abs(first).max())
    if not math.isfinite(size):
        return None
    faster = values_of(record, 0.0, over, 1.1 * speed + 1.0)
    if max(np.ptp(first), np.abs(faster - first).max()) <= SAME * size:  # is not called at other times
        return None
    for t in (0.0123, 0.77, 31.0):
        if not np.abs(values_of(record, t, over, speed) - first).max() <= SAME * size:  # also NaN of an error
            return None
    for turn in range(1, MAX_TURNS + 1):
        if np.abs(values_of(record, 0.0, over + TURNS * turn, speed) - first).max() <= SAME * size:
            return [(0.0, 1.0 / turn)]
    return None


def _without_round_off(mean: float, values: Array) -> float:
    """Mean of values, 0 if only their rounding errors are left: a sine has no mean."""
    return mean if abs(mean) > ROUND_OFF * float(np.abs(values).max(initial=0.0)) else 0.0
