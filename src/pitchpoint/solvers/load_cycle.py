# SPDX-License-Identifier: Apache-2.0
"""Steady motion of a train under pulsating torques: mean torques over the period, ripple of the speed.

The train moves as a rigid body with the speed eta + d_eta(t), where d_eta has zero mean. Its momentum balance

    M d_eta' = Q(t, angle, speed) - mean of Q

is iterated: loads over the motion, their mean, the ripple of speed and angle that the rest causes, loads over
the new motion. In the converged motion constant torques that balance the mean torques keep the mean speed
exactly; their work over the period balances, too. All loads share one time grid over their common period.
Without a common period they are averaged over many periods with a smooth window.

Source of the window: S. Das, Y. Saiki, E. Sander, J. A. Yorke, Quantitative quasiperiodicity, Nonlinearity 30
(2017) 4111-4140: the weighted mean converges faster than any power of the number of periods.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.formula.formula import Formula
from pitchpoint.core.formula.periods import phases_of
from pitchpoint.elements.signal import CONSTANT, FORMULA, LAW, OVER_ANGLE, TABLE, set_constant
from pitchpoint.elements.torque import KIND, values_of
from pitchpoint.elements.torsion import sense_of, turn_between
from pitchpoint.model.components.law import FormulaLaw
from pitchpoint.solvers.equilibrium.unknowns import rest_matrix
from pitchpoint.solvers.gear_trains import rotations
from pitchpoint.solvers.torque_paths import turning
from pitchpoint.system import evaluate
from pitchpoint.system.residual import NEWTON
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

LOAD = KIND.name
TURNS = 2.0 * math.pi
SAME = 1e-9
"""Relative difference up to which rates, torques or speeds count as equal."""
ROUND_OFF = 1e-14
"""Mean of a torque relative to its largest value that counts as zero."""
POINTS = 64
"""Points per period of the fastest argument: the mean is exact for harmonics of lower order."""
LEAST = 4096
"""Least number of points in a common period, for tables and formulas with kinks."""
MAX_CYCLES = 2048
"""Periods of the fastest argument: the longest common period, and the time of the mean without one."""
MAX_TURNS = 12
"""Revolutions within which a user law of the angle must repeat to count as periodic."""
PASSES = 100
"""Largest number of iterations of the steady motion."""


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
    slowest
        Period of the slowest argument of a load [s].
    offset
        Deviation of the rates at the start from their means, shape (nd,); zero for trains at rest.
    ripple
        Upper bound of the deviation of the rates from their means, shape (nd,).
    stalls
        Bodies that the loads would stop or reverse, or whose steady motion was not found; all loads were then
        averaged at constant speed.
    """

    means: dict[int, float]
    period: float
    averaged: float
    error: float
    slowest: float
    offset: Array
    ripple: Array
    stalls: tuple[str, ...] = ()

    def applied(self, system: System) -> System:
        """Copy of the system with the mean torques."""
        records = system.records[LOAD].copy()
        for k, mean in self.means.items():
            set_constant(records[k], mean)
        return system.with_params({LOAD: records})


@dataclass(frozen=True)
class _Load:
    """A torque over a rigid motion: record, angle and mean speed of its body, share of every free rotation.

    `turns`: it depends on the angle; `rates`: those of its arguments [rad/s].
    """

    number: int
    record: np.void
    angle: float
    speed: float
    share: Array
    turns: bool
    rates: tuple[float, ...]

    def over(self, t: Array, speed: Array, angle: Array) -> Array:
        """Torque at times, for ripples of the free speeds and angles, shape (free, n)."""
        turned = self.angle + self.speed * t + self.share @ angle
        return values_of(self.record, t, turned, self.speed + self.share @ speed)


def load_cycle(system: System, state: State, held: Sequence[int], driven: Sequence[int]) -> LoadCycle | None:
    """Mean torques of the pulsating loads, with all trains at their mean speed; None if no load pulsates.

    Parameters
    ----------
    system, state
        The system and the state at t = 0 with the mean rates.
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
    loads = _repeating(system, state, motions)
    rates = np.array(sorted({abs(rate) for load in loads for rate in load.rates}))
    if not rates.size:
        return None
    t, weights, period = _grid(rates)
    mass = motions.T @ rest_matrix(system, state, NEWTON, (1.0, 0.0, 0.0)) @ motions
    found = _steady(loads, mass, t, weights)
    stalls = [
        load
        for load in loads
        if found is None
        or (load.turns and 0.0 < abs(load.speed) <= np.abs(load.share @ found[0]).max(initial=0.0))
    ]
    steady = np.zeros((2, len(free), t.size)) if found is None or stalls else found
    torques = {load.number: load.over(t, *steady) for load in loads}
    means = {k: _without_round_off(float(weights @ values), values) for k, values in torques.items()}
    # every second point of a period, or the second half without one
    part = slice(None, None, 2) if period > 0.0 else slice(t.size // 2, None)
    fewer = weights[::2] / weights[::2].sum() if period > 0.0 else _window(t.size - t.size // 2)
    moving = (np.abs(motions.T) @ np.abs(state.v) > 0.0).astype(float)
    return LoadCycle(
        means=means,
        period=period,
        averaged=period or float(t[-1]),
        error=max(abs(float(fewer @ torques[k][part]) - means[k]) for k in means),
        slowest=TURNS / float(rates[0]),
        offset=np.asarray(motions @ (moving * steady[0][:, 0])),
        ripple=np.asarray(np.abs(motions) @ np.abs(steady[0]).max(axis=1, initial=0.0)),
        stalls=tuple(dict.fromkeys(system.layout.bodies[int(load.record["i"])] for load in stalls)),
    )


def _repeating(system: System, state: State, motions: Array) -> list[_Load]:
    """Loads whose torque repeats over the motion, with the rates of their arguments."""
    system.workspace  # noqa: B018 - fills in the addresses of the records
    frames, found = system.workspace.fr, []
    given = [] if system.model is None else [load.torque for load in system.model.loads.values()]
    laws = [law for law in given if law is not None]
    for k, (record, law) in enumerate(zip(system.records[LOAD], laws, strict=False)):
        if int(record["form"]) == CONSTANT:
            continue
        i, j = int(record["i"]), int(record["j"])
        sense = int(sense_of(frames[i], frames[j], j))
        rest, turns = turn_between(frames[i], frames[j], sense)
        row = np.zeros(len(state.v))
        for body, sign in ((i, 1.0), (j, -float(sense))):
            for spin, value in turning(system, body, sign).items():
                row[spin] += value
        speed = float(row @ state.v)
        phases = _phases(record, law, float(rest + TURNS * turns), speed)
        if phases is not None:
            rates = (by_time + by_angle * speed for by_time, by_angle in phases)
            found.append(
                _Load(
                    number=k,
                    record=record,
                    angle=float(rest + TURNS * turns),
                    speed=speed,
                    share=row @ motions,
                    turns=any(by_angle != 0.0 for _, by_angle in phases),
                    rates=tuple(rate for rate in rates if rate != 0.0),
                )
            )
    return found


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
    for t in (0.0123, 0.77, 31.0):
        if np.abs(values_of(record, t, over, speed) - first).max() > SAME * size:
            return None
    for turn in range(1, MAX_TURNS + 1):
        if np.abs(values_of(record, 0.0, over + TURNS * turn, speed) - first).max() <= SAME * size:
            return [(0.0, 1.0 / turn)]
    return None


def _grid(rates: Array) -> tuple[Array, Array, float]:
    """Times and weights of the mean for rates [rad/s] of the arguments, and their common period [s] or 0."""
    base = common_rate(rates)
    if base > 0.0 and rates[-1] / base <= MAX_CYCLES:
        n = 2 * math.ceil(max(LEAST, POINTS * rates[-1] / base) / 2)
        period = TURNS / base
        return np.arange(n) * (period / n), np.full(n, 1.0 / n), period
    n = POINTS // 2 * MAX_CYCLES
    return np.arange(n) * (TURNS / rates[-1] / (POINTS // 2)), _window(n), 0.0


def common_rate(rates: Array) -> float:
    """Rate of the common period of positive rates in increasing order; 0 if their ratios are not rational.

    Examples
    --------
    >>> round(common_rate(np.array([2.0, 5.0])), 12), common_rate(np.array([1.0, 2.0**0.5]))
    (1.0, 0.0)
    """
    multiples = []
    for rate in rates / rates[0]:
        near = Fraction(float(rate)).limit_denominator(MAX_CYCLES)
        if abs(float(near) - rate) > SAME * rate:
            return 0.0
        multiples.append(near.denominator)
    return float(rates[0]) / math.lcm(*multiples)


def _window(n: int) -> Array:
    """Weights exp(-1/(x (1 - x))) over n points; they sum to one."""
    x = (np.arange(n) + 0.5) / n
    weights = np.exp(-1.0 / (x * (1.0 - x)))
    return np.asarray(weights / weights.sum())


def _steady(loads: list[_Load], mass: Array, t: Array, weights: Array) -> Array | None:
    """Ripples of the free speeds and angles, shape (2, free, n); None if the iteration does not converge."""
    n = len(mass)
    speed, angle = np.zeros((n, t.size)), np.zeros((n, t.size))
    if n == 0:
        return np.stack([speed, angle])
    inverse, h = np.linalg.inv(mass), float(t[1])
    relax, last = 1.0, math.inf
    for _ in range(PASSES):
        torque = np.zeros((n, t.size))
        for load in loads:
            torque += np.outer(load.share, load.over(t, speed, angle))
        if not np.all(np.isfinite(torque)):
            return None
        torque -= (torque @ weights)[:, None]
        new = _integrated(inverse @ torque, h)
        new -= (new @ weights)[:, None]
        change, size = float(np.abs(new - speed).max()), float(np.abs(new).max())
        if change <= SAME * size:
            return np.stack([speed, angle])
        relax = 0.5 * relax if change > 0.9 * last else relax
        last = change
        speed = speed + relax * (new - speed)
        angle = _integrated(speed, h)
    return None


def _integrated(rate: Array, h: float) -> Array:
    """Integral from the first point by the trapezoidal rule, shape of `rate`."""
    steps = 0.5 * h * (rate[:, 1:] + rate[:, :-1])
    return np.concatenate([np.zeros((len(rate), 1)), np.cumsum(steps, axis=1)], axis=1)


def _without_round_off(mean: float, values: Array) -> float:
    """Mean of values, 0 if only their rounding errors are left: a sine has no mean."""
    return mean if abs(mean) > ROUND_OFF * float(np.abs(values).max(initial=0.0)) else 0.0
