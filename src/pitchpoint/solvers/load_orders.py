# SPDX-License-Identifier: Apache-2.0
"""Torques that pulsate with the angle of a rotating body in linear analyses: mean over the angle, and orders.

Along a rotation, the torque T(phi) on a body with the angle phi = Omega t + delta is T(Omega t) +
T'(Omega t) delta. The first term is the mean torque and an excitation by the orders of its Fourier series.
The slope T' has the mean [T(period) - T(0)]/period = 0: a torque that repeats has no stiffness. The slope at
one angle would make the rotation grow or oscillate. A body at rest stays at one angle: there it is a spring.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.kind import DRIVE
from pitchpoint.elements.signal import OVER_SPEED, Pool, set_constant, set_table
from pitchpoint.solvers.gear_trains import driven_coordinates
from pitchpoint.solvers.load_cycle import LOAD, PulsatingLoad, pulsating_loads
from pitchpoint.solvers.load_waves import common_rate
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

POINTS = 64
"""Points per period of the fastest argument."""
LEAST, MOST_POINTS = 4096, 1 << 16
"""Least and largest number of points in the period of a load."""
ROUND_OFF = 1e-9
"""Amplitude over the largest value of a torque up to which a harmonic is rounding."""
FAST = 100.0
"""High speed at which vector sums are compared with those at 1 rad/s [rad/s]."""
WEAK = 0.05
"""Amplitude over that of the strongest harmonic of a load up to which one is omitted: a table with kinks has
hundreds."""
SPEEDS, REACH = 1025, 20.0
"""Points of a mean torque over the speed, denser about zero, and the largest speed over the mean speed: a
diagram over the speed has its state at the lowest speed."""


@dataclass(frozen=True)
class LoadOrder:
    """Harmonic of a torque or of the ripple of a drive.

    Parameters
    ----------
    name
        Name of the load, or of the driven coordinate.
    bodies
        Bodies on which it acts.
    order
        Periods per revolution of the body, relative to that of the reaction.
    speed
        Speed of this rotation with the reference body at 1 rad/s.
    amplitude
        Amplitude at this speed [N m]; of a ripple [rad].
    ripple
        Whether it is the ripple of a drive.
    load, harmonic
        The torque and the number of its harmonic, for its phase.
    """

    name: str
    bodies: tuple[int, ...]
    order: float
    speed: float
    amplitude: float
    ripple: bool = False
    load: PulsatingLoad | None = None
    harmonic: int = 0

    def phasor(self, speed: float) -> complex:
        """Complex amplitude M of a torque Re(M e^(i Omega t)) at a speed of the reference body [rad/s].

        The angles at t = 0 are those of the state.
        """
        if self.load is None:
            return complex(self.amplitude)
        over, base = angles_of(self.load)
        values = self.load.at_angles(over, self.load.speed * speed)
        angle = self.harmonic * base * (over - self.load.angle)
        found = 2.0 * complex(np.mean(values * np.exp(-1j * angle)))
        return found if self.load.speed * speed > 0.0 else found.conjugate()


def rigid_sum(orders: Sequence[LoadOrder]) -> float:
    """Largest vector sum of torques on one body over their sum of amplitudes, at low and at high speed."""
    shares = []
    for speed in (1.0, FAST):
        found = [order.phasor(speed) for order in orders]
        shares.append(abs(sum(found)) / max(sum(map(abs, found)), 1e-300))
    return max(shares)


def alignment(orders: Sequence[LoadOrder], shape: Complex, speed: float) -> float:
    """Share of a mode that torques of one order excite with their phases to each other, 0 to 1.

    With the torques M and the rotations phi of their bodies it is |sum phi* M|^2/(sum |M| sum |M| |phi|^2),
    1 for a single torque. On a rigid shaft that is the square of the vector sum over the sum of the
    amplitudes: 0 for equal cylinders at equal firing intervals, except at multiples of the firing order.

    Parameters
    ----------
    orders
        Torques of one order.
    shape
        Mode shape, shape (nd,).
    speed
        Speed of the reference body [rad/s].
    """
    known = [order for order in orders if order.load is not None]
    torques = np.array([order.phasor(speed) for order in known])
    turned = np.array([order.load.row @ shape for order in known if order.load is not None])
    largest = float(np.abs(torques).sum() * (np.abs(torques) @ np.abs(turned) ** 2)) if known else 0.0
    return float(abs(np.vdot(turned, torques)) ** 2 / largest) if largest > 0.0 else 1.0


def _by_angle(system: System, state: State, rates: Array) -> list[PulsatingLoad]:
    """Loads that repeat with the angle of their body."""
    if LOAD not in system.records:
        return []
    at = state.copy()
    at.v[:] = rates
    nothing = np.zeros((rates.size, 0))
    return [load for load in pulsating_loads(system, at, nothing) if load.by_angle]


def of_one_angle(system: System, state: State) -> tuple[str, ...]:
    """Names of the torques that repeat with the angle of a body at rest."""
    found = _by_angle(system, state, state.v)
    return tuple(system.names[LOAD][load.number] for load in found if load.speed == 0.0)


def angles_of(load: PulsatingLoad) -> tuple[Array, float]:
    """Equally spaced angles over the period of a load [rad], and the orders of its first harmonic."""
    base = common_rate(np.array(load.by_angle)) or min(load.by_angle)
    n = int(min(max(LEAST, POINTS * math.ceil(load.by_angle[-1] / base)), MOST_POINTS))
    return np.asarray(np.arange(n) * (2.0 * math.pi / base / n)), base


def mean_loads(system: System, state: State, rates: Array) -> tuple[System, tuple[str, ...]]:
    """Replace torques that repeat with the angle of a rotating body by their mean over the angle.

    Parameters
    ----------
    system, state
        The system and its position.
    rates
        Rates of all coordinates [rad/s], shape (nd,).

    Returns
    -------
    tuple
        The system, a copy if a torque was replaced, and the names of these loads. A mean that depends on the
        speed is a table over the speed.
    """
    found = [load for load in _by_angle(system, state, rates) if load.speed != 0.0]
    if not found:
        return system, ()
    records = system.records[LOAD].copy()
    kept = system.pools.get(LOAD, np.zeros(0))
    pool = Pool()
    pool.add(kept)
    for load in found:
        over, _ = angles_of(load)
        top = REACH * abs(load.speed)
        spread = np.linspace(-1.0, 1.0, SPEEDS)
        speeds = top * spread * np.abs(spread)
        few = over[:: max(1, over.size // 512)]
        means = np.array([float(load.at_angles(few, speed).mean()) for speed in speeds])
        own = float(load.at_angles(over, load.speed).mean())
        size = float(np.abs(load.at_angles(over, load.speed)).max())
        if np.ptp(means) <= ROUND_OFF * max(size, float(np.abs(means).max())):
            set_constant(records[load.number], own if abs(own) > 1e-14 * size else 0.0)
        else:
            set_table(records[load.number], pool, speeds, means, OVER_SPEED)
    names = tuple(system.names[LOAD][load.number] for load in found)
    return with_pool(system, records, pool), names


def with_pool(system: System, records: np.ndarray, pool: Pool) -> System:
    """Copy of the system with other torques and the pool of their tables."""
    changed = system.with_params({LOAD: records})
    return replace(changed, pools={**changed.pools, LOAD: pool.array()})


def load_orders(system: System, state: State, rates: Array) -> tuple[LoadOrder, ...]:
    """Orders of the torques and of the ripples of drives; arguments as of `mean_loads`.

    Harmonics of rounding, and those that are `WEAK` against the strongest of their load, are omitted. A
    torque that also depends on time has no orders.
    """
    found = []
    for load in _by_angle(system, state, rates):
        if load.timed or load.speed == 0.0:
            continue
        over, base = angles_of(load)
        values = load.at_angles(over, load.speed)
        size = 2.0 * np.abs(np.fft.rfft(values)) / over.size
        size[[0, -1]] = 0.0
        least = max(ROUND_OFF * float(np.abs(values).max()), WEAK * float(size.max()))
        ends = tuple(b for b in (int(load.record["i"]), int(load.record["j"])) if b)
        name = system.names[LOAD][load.number]
        found += [
            LoadOrder(name, ends, k * base, abs(load.speed), float(size[k]), load=load, harmonic=k)
            for k in np.flatnonzero(size > least).tolist()
        ]
    return (*found, *_ripples(system, rates))


def _ripples(system: System, rates: Array) -> list[LoadOrder]:
    """Orders of the ripples of drives."""
    found = []
    drives = [(kind, record) for kind in system.kinds(DRIVE) for record in system.records[kind]]
    for (kind, record), place in zip(drives, driven_coordinates(system), strict=True):
        body, count = int(record["i"]), int(record["waves"])
        if place != int(system.program["body"][body]["spin"]) or not count or rates[place] == 0.0:
            continue
        begin, speed = int(record["ripple"]), abs(float(rates[place]))
        for order, size, _ in system.pools[kind][begin : begin + 3 * count].reshape(count, 3):
            name = system.layout.bodies[body]
            found.append(LoadOrder(name, (body,), float(order), speed, float(size), True))
    return found
