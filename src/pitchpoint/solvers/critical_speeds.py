# SPDX-License-Identifier: Apache-2.0
"""Critical speeds: crossings of branches and excitation orders, with what drives them, ranked.

Crossings of the computed points are solved again at the speed of the crossing. The response follows from that
of a lightly damped mode z to a force f, with the amplitude z (z^H f)/((2 i omega z^H M z + z^H D z)(i Omega -
lambda)), whose first factor is 4 i (T + V)/omega with the kinetic energy T and strain energy V of the mode.
With its damping ratio zeta and the energy X of the mode where the order acts, there is at resonance

* the amplification, the response where the order acts: X/((T + V) zeta);
* the response of the machine: the root of the energy W of its vibration over that of the source, sqrt(X W)/
  ((T + V) zeta), with W = V where X is strain energy, else W = T. With the participation p = X/W it is
  1/sqrt(p) times the amplification: a part with little energy can drive a mode that is large elsewhere.

The sources are

* transmission error e of a mesh with the law of `mesh_law`, of the stiffness k = s^T K s: f = K s e; the
  amplification is u/e with the mean deflection of the teeth u = s^T K z/k, and X = k |u|^2/4. Flanks that
  tilt against each other take no energy from e. Here the conjugate of z is replaced by the left vector of the
  mode (`tooth_response`), which differs with torques that follow a tilting axis. A component with the share q
  of V, such as a bearing, responds with sqrt(q) times the response of the machine, which is the geometric
  mean of its deflection over e and of its force over k e;
* shuttling force of a mesh under load (`tooth_wave`): its centre of force moves across the face width and
  tilts the gears. Mesh orders act with the transmission errors and shuttling forces of their harmonic, in
  their sizes and phases at this load: f = p, with the energy E = (sum k |e|^2 + that of the static
  deflection by shuttling)/4, and X = |p^H z|^2/(16 E);
* eccentricity e of the mass of a shaft: f = m e Omega^2; its forward whirl is u = e T_f/((T + V) zeta) with
  the kinetic energy T_f of the forward whirl. The distribution of the unbalance along the shaft is the most
  unfavourable one, as are the phases of several meshes in sidebands and run-out, whose energies X add up;
* torque M on a body of the moment of inertia J: its acceleration is J |phi''| = M T_r/((T + V) zeta) with the
  kinetic energy T_r of its rotation. Several torques of one order act with their sizes and phases at the
  speed of the crossing (`load_orders.alignment`);
* ripple of a driven body: that of the elements between it and the machine, as for a transmission error.

Without gyroscopic effects T = V, and the amplification is p/(2 zeta), the response sqrt(p)/(2 zeta).

Crossings are ranked by the response with a damping ratio of at least that of welded steel stacks [1]_: modes
that are hardly damped or unstable (see `unstable_modes`) rank by what excites them.

References
----------
.. [1] EN 1991-1-4:2005, table F.2: logarithmic decrement of structural damping 0.012.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.progress import report_step
from pitchpoint.solvers.campbell import Campbell
from pitchpoint.solvers.cycle_means import moving_phases
from pitchpoint.solvers.eigen import ratio_of
from pitchpoint.solvers.excitation_orders import BLADES, LOAD, MESH, RIPPLE, SHAFT, SIDEBAND, Order
from pitchpoint.solvers.linear_system import Linearised
from pitchpoint.solvers.load_orders import alignment
from pitchpoint.solvers.modes.energies import (
    WAYS,
    Energies,
    Motions,
    energies_of,
    gyroscopic_terms,
    spins_of,
    whirl_words,
)
from pitchpoint.solvers.modes.unstable import UNDAMPED
from pitchpoint.solvers.speed_sensitivity import Sensitivity, sensitivities
from pitchpoint.solvers.stiffness_parts import Array
from pitchpoint.solvers.tooth_response import Phases, Source, errors_of, teeth_of, tooth_response
from pitchpoint.solvers.whirl_basis import Complex

ERROR, RUN_OUT, FAULT, GIVEN = "transmission error", "run-out", "bearing fault", "given order"
SHUTTLING = "shuttling force"
UNBALANCE, MISALIGNMENT = "unbalance", "misalignment"
TORQUE, DRIVEN = "pulsating torque", "ripple of the drive"
PASSING = "blade passing"
BY_STRAIN = (ERROR, SHUTTLING, RUN_OUT, FAULT, GIVEN, DRIVEN)
"""Sources that act on the strain energy of a mode; the others act on its kinetic energy."""
ROTATION = WAYS.index("rotation")
ROUNDING = 1e-12
"""Share of the energy up to which nothing is excited."""
ROUNDS, EXACT, CHANGE = 6, 1e-9, 1e-5
"""Most corrections of a crossing, its relative accuracy, and the least change of a gap that gives a slope."""

DAMPED = 0.012 / (2.0 * np.pi)
"""Least damping ratio in the ranks, see the module."""
RANKING = (
    "ranked by the response of the machine at resonance: root of the energy of its vibration over that of "
    f"the excitation, for a damping ratio of at least {100.0 * DAMPED:.2f} %; amplification: the response "
    "where the order acts, such as tooth deflection over transmission error; mesh orders act with the "
    "transmission errors and shuttling forces of all their meshes under the load of the scenario, in phase; "
    "torques of one order act with their sizes and phases; an unbalance acts on the forward whirl of a mode "
    "only, and sidebands have their most unfavourable phases"
)
"""How crossings are ranked, for outputs."""


@dataclass(frozen=True)
class ByTeeth:
    """A mode excited by teeth.

    Parameters
    ----------
    energy
        Twice the strain energy where the excitation acts, as z^H K z.
    gain
        Amplification times damping ratio.
    shuttles
        Whether shuttling forces drive it more than transmission errors.
    """

    energy: float
    gain: float
    shuttles: bool


@dataclass(frozen=True)
class CriticalSpeed:
    """Crossing of a branch and an excitation order.

    Parameters
    ----------
    speed
        Speed of the reference body [rad/s].
    frequency
        Damped natural frequency [Hz].
    damping_ratio
        Damping ratio at this speed.
    mode
        Index of the branch.
    order
        The excitation order.
    whirl
        Whirl of the mode at this speed.
    source
        What drives the mode: unbalance, misalignment, run-out, transmission error, shuttling force, pulsating
        torque, ripple of the drive, blade passing, bearing fault, given order.
    participation
        Share of the kinetic energy (unbalance, misalignment) or strain energy (transmission error, shuttling
        force, run-out, bearing fault) of the mode where the order acts, 0 to 1; of transmission errors that
        of the mean tooth deflection.
    amplification
        Amplification at resonance, see the module; infinite without damping or if the mode is unstable.
    response
        Response of the machine at resonance with at least the damping ratio `DAMPED`: the rank.
    moved_by
        Change of the critical speed with stiffness and inertia.
    """

    speed: float
    frequency: float
    damping_ratio: float
    mode: int
    order: Order
    whirl: str
    source: str
    participation: float
    amplification: float
    response: float
    moved_by: Sensitivity


def critical_speeds(found: Campbell, orders: Sequence[Order]) -> tuple[CriticalSpeed, ...]:
    """Crossings of all branches and orders in the range of the speeds, in order of their rank."""
    forward = np.argsort(found.speed, kind="stable")
    phases: Phases | None = None
    solved, turning = [], []
    by_teeth: list[ByTeeth | None] = []
    for order in orders:
        crossings = [
            (k, at) for k in range(len(found.names)) for at in _brackets(found, forward, order.value, k)
        ]
        if not crossings:
            continue
        phases = phases or moving_phases(found.motions.system, found.motions.state, found.rates)
        source = _source(found, order, phases)
        for mode, ends in crossings:
            report_step(f"critical speeds of order {order.name}, mode {mode + 1}")
            exact = not found.rotors
            try:
                crossing = (_solve if exact else _interpolate)(found, order.value, mode, ends)
            except SolverError:  # no equilibrium at a speed between the computed ones
                exact, crossing = False, _interpolate(found, order.value, mode, ends)
            speed, value, shape, slope = crossing
            near = _nearest(found, speed)
            at = found.modes.at(speed if exact else float(found.speed[near]))
            solved.append((order, mode, speed, value, shape, slope))
            turning.append(gyroscopic_terms(shape[None], at.D)[0])
            by_teeth.append(_by_teeth(at, source, (speed, value, shape), found.shape[near]))
    if not solved:
        return ()
    _, _, speeds, values, shapes, slopes = zip(*solved, strict=True)
    z, spins = np.array(shapes), spins_of(found.motions, found.rates)
    energies = energies_of(
        found.motions, z, np.array(values), np.array(turning), np.array(speeds)[:, None] * spins
    )
    words = whirl_words(energies)
    moved = sensitivities(found.motions, energies, np.array(slopes))
    listed = [
        _critical(found, each[:5], (energies, k, words[k], by_teeth[k], moved[k]))
        for k, each in enumerate(solved)
    ]
    # harmonics of one mode have one response, except for rounding: the lowest is first
    return tuple(
        sorted(listed, key=lambda c: (-float(f"{c.response:.8g}"), -round(c.participation, 8), c.order.value))
    )


def _by_teeth(
    at: Linearised, source: Source | None, mode: tuple[float, complex, Complex], near: Complex
) -> ByTeeth | None:
    """Share and amplification of a mode driven by the meshes; `mode`: speed, eigenvalue and shape."""
    if source is None:
        return None
    speed, value, shape = mode
    source = source.reversed() if speed < 0.0 else source
    gain = tooth_response(at, source, value, shape, near)
    return ByTeeth(source.energy(shape), gain, source.shuttles(shape))


def _source(found: Campbell, order: Order, phases: Phases) -> Source | None:
    """Excitation by the meshes of an order.

    Mesh orders have the phases of the meshes to each other; sidebands, whose phases depend on what modulates
    them, and run-out have the most unfavourable ones.
    """
    own = {name: found.motions.laws[name] for name in order.meshes}
    known = found.modes.modes
    if order.kind not in (MESH, SIDEBAND):
        return errors_of(own.values())
    at_rest = known.whole or (known.omega, known.shapes)
    return teeth_of(own, order.harmonic, at_rest, phases if order.kind == MESH else None)


def _brackets(found: Campbell, forward: NDArray[np.intp], order: float, mode: int) -> list[tuple[int, int]]:
    """Pairs of neighbouring points between which the branch crosses the order."""
    f, speed = found.frequency[forward, mode], found.speed[forward]
    away = f - order * np.abs(speed) / (2.0 * np.pi)
    pairs = []
    for k in range(len(f) - 1):
        vibrates = f[k] > 0.0 and f[k + 1] > 0.0 and speed[k] * speed[k + 1] >= 0.0
        if vibrates and (away[k] * away[k + 1] < 0.0 or (away[k] == 0.0 and speed[k] != 0.0)):
            pairs.append((int(forward[k]), int(forward[k + 1])))
    if len(f) > 1 and away[-1] == 0.0 and f[-1] > 0.0:
        pairs.append((int(forward[-2]), int(forward[-1])))
    return pairs


def _solve(
    found: Campbell, order: float, mode: int, at: tuple[int, int]
) -> tuple[float, complex, NDArray[np.complex128], float]:
    """Speed, eigenvalue and shape at a crossing: secant steps on the mode followed from the closer point.

    The fourth value is the slope of the branch over that of the order.
    """
    ends = [float(found.speed[k]) for k in at]
    away = [
        float(found.frequency[k, mode]) - order * abs(s) / (2.0 * np.pi)
        for k, s in zip(at, ends, strict=True)
    ]
    near = 0 if abs(away[0]) < abs(away[1]) else 1
    value, shape = complex(found.eigenvalue[at[near], mode]), found.shape[at[near], mode]
    slope = (away[1] - away[0]) / (ends[1] - ends[0])
    last, gap = ends[near], away[near]
    for _ in range(ROUNDS):
        speed = float(np.clip(last - gap / slope, min(ends), max(ends)))
        value, shape = found.modes.near(speed, value, shape)
        new = value.imag / (2.0 * np.pi) - order * abs(speed) / (2.0 * np.pi)
        if speed != last and abs(new - gap) > CHANGE * abs(value.imag) / (2.0 * np.pi):
            slope = (new - gap) / (speed - last)
        done = abs(new) <= EXACT * abs(value.imag) / (2.0 * np.pi) or speed == last
        last, gap = speed, new
        if done:
            break
    return last, value, shape, 1.0 + slope * 2.0 * math.pi / (order * math.copysign(1.0, last))


def _interpolate(
    found: Campbell, order: float, mode: int, at: tuple[int, int]
) -> tuple[float, complex, NDArray[np.complex128], float]:
    """As `_solve`, interpolated: matrices of turning rotors require several equilibria each."""
    from scipy.interpolate import PchipInterpolator
    from scipy.optimize import brentq

    forward = np.argsort(found.speed, kind="stable")
    curve = PchipInterpolator(
        found.speed[forward], found.eigenvalue[forward, mode].view(float).reshape(-1, 2)
    )
    sense = math.copysign(1.0, float(found.speed[list(at)].sum()))

    def gap(speed: float) -> float:
        """Circular natural frequency less that of the order [rad/s]."""
        return float(curve(speed)[1]) - order * sense * speed

    ends = [float(found.speed[k]) for k in at]
    last = next((end for end in ends if gap(end) == 0.0), None)
    speed = float(brentq(gap, ends[0], ends[1])) if last is None else last
    slope = float(curve(speed, 1)[1]) * sense / order
    return speed, complex(*curve(speed)), found.shape[_nearest(found, speed), mode], slope


def _nearest(found: Campbell, speed: float) -> int:
    """Index of the computed speed that is closest to a speed."""
    return int(np.argmin(np.abs(found.speed - speed)))


def _critical(
    found: Campbell,
    crossing: tuple[Order, int, float, complex, Complex],
    about: tuple[Energies, int, str, ByTeeth | None, Sensitivity],
) -> CriticalSpeed:
    """Crossing with what drives it.

    `crossing`: order, mode, speed, eigenvalue and shape; `about`: energies, index of the mode in them, whirl,
    teeth, changes.
    """
    order, mode, speed, value, shape = crossing
    energies, k, whirl, teeth, moved = about
    ratio = float(ratio_of(np.array([value]))[0])
    ratio = ratio if abs(ratio) > UNDAMPED else 0.0
    source, share = driven_by(found.motions, energies, k, order)
    if len(order.torques) > 1:
        share *= alignment(order.torques, shape, speed)
    strain = float(energies.strain_ratio[k])  # V/T
    size = share * (strain if source in BY_STRAIN else 1.0) / (1.0 + strain)  # X/(T + V)
    if source in (ERROR, RUN_OUT):
        whole = float(energies.whole_strain[k])
        share = teeth.energy / whole if teeth is not None and whole > 0.0 else 0.0
        size = teeth.gain if teeth is not None else 0.0
        source = SHUTTLING if teeth is not None and teeth.shuttles else source
    share = min(share, 1.0) if share > ROUNDING else 0.0
    size = size if share > 0.0 else 0.0
    gain = size / ratio if ratio > 0.0 else np.inf if size > 0.0 else 0.0
    return CriticalSpeed(
        speed=speed,
        frequency=value.imag / (2.0 * np.pi),
        damping_ratio=ratio,
        mode=mode,
        order=order,
        whirl=whirl,
        source=source,
        participation=share,
        amplification=gain,
        response=size / math.sqrt(share) / max(ratio, DAMPED) if share > 0.0 else 0.0,
        moved_by=moved,
    )


def driven_by(motions: Motions, energies: Energies, k: int, order: Order) -> tuple[str, float]:
    """Source through which an order drives mode k, and its share of the energy of the mode.

    * mesh orders and sidebands: transmission error, strain energy of the mean tooth deflection of the meshes;
    * first order of a shaft: unbalance, kinetic energy of its forward whirl; or run-out of its gears, strain
      energy of the mean tooth deflection of their meshes;
    * higher orders of a shaft: misalignment, kinetic energy of its lateral motion; or run-out;
    * torques: kinetic energy of the rotation of the bodies on which they act;
    * passing of blades, by wind shear and tower: kinetic energy of hub and blades;
    * ripple of a drive: strain energy of the components on the driven body;
    * other orders: strain energy of the bearing named by the order, such as `BPFO front`; otherwise 1.
    """
    groups = motions.groups
    strain: Array = energies.strain[k]
    teeth = float(sum(energies.teeth[k, m] for m, name in enumerate(motions.laws) if name in order.meshes))
    if order.kind in (MESH, SIDEBAND):
        return ERROR, teeth
    if order.kind == SHAFT:
        own = [p for p in range(len(groups.parts)) if groups.moves[p] in order.parts]
        lateral = float(energies.forward[k, own].sum())
        if order.harmonic > 1:
            lateral += float(energies.backward[k, own].sum())
        word = UNBALANCE if order.harmonic == 1 else MISALIGNMENT
        return (word, lateral) if lateral >= teeth else (RUN_OUT, teeth)
    if order.kind == LOAD:
        moved = [p for p in range(len(groups.parts)) if groups.moves[p] in order.parts]
        return TORQUE, float(energies.kinetic[k, moved, ROTATION].sum())
    if order.kind == BLADES:
        return PASSING, float(energies.kinetic[k, list(order.parts)].sum())
    if order.kind == RIPPLE:
        joined = [e for e, ends in enumerate(groups.ends) if set(ends) & set(order.parts)]
        return DRIVEN, float(strain[joined].sum())
    bearing = f" bearing {order.name.partition(' ')[2]}"
    named = [e for e, name in enumerate(groups.components) if f" {name}".endswith(bearing)]
    return (FAULT, float(strain[named].sum())) if named else (GIVEN, 1.0)


def separation(speed: Array, operating: tuple[float, float]) -> Array:
    """Distance of speeds from an operating range over its nearest end: 0 inside, negative below.

    Examples
    --------
    >>> separation(np.array([80.0, 110.0, 150.0]), (100.0, 120.0)).round(6).tolist()
    [-0.2, 0.0, 0.25]
    """
    low, high = sorted(map(abs, operating))
    x = np.abs(speed)
    return np.where(x > high, x / max(high, 1e-300) - 1.0, np.where(x < low, x / max(low, 1e-300) - 1.0, 0.0))
