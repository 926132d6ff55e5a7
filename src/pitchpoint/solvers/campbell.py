# SPDX-License-Identifier: Apache-2.0
"""The linear system at other speeds, and modes followed over the speed.

A branch is a continuous curve: from speed to speed, each mode becomes the one with the most similar shape
(modal assurance criterion [1]_). Where two branches veer, they exchange their shapes. A branch keeps its
number and name, which come from its shape at rest with the direction in which it whirls at most speeds;
`character` states at every speed which name its shape fits best.

References
----------
.. [1] R. J. Allemang, D. L. Brown: A correlation coefficient for modal vector analysis, Proc. 1st
   International Modal Analysis Conference, 1982, 110-116.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.solvers.eigen import best_match, ratio_of, symmetric
from pitchpoint.solvers.gear_trains import mesh_orders
from pitchpoint.solvers.linear_system import Linearised, linearise, rates_of
from pitchpoint.solvers.modes.energies import (
    Energies,
    Motions,
    energies_of,
    gyroscopic_terms,
    motions_of,
    spins_of,
    whirl_index,
    whirl_words,
)
from pitchpoint.solvers.modes.names import base_names, full_names
from pitchpoint.solvers.over_speed import OverSpeed, over_speed
from pitchpoint.solvers.stiffness_parts import Array
from pitchpoint.solvers.whirl_basis import Complex, Found, WhirlModes, normalised
from pitchpoint.system.system import System

if TYPE_CHECKING:
    from pitchpoint.model.scenario import Scenario

RECENT, KEPT = 4, 600
"""Number of the last speeds at which the linear system is kept, and largest number of coordinates up to which
that of turning rotors is kept at all speeds."""
ALL, FEW = 24, 16
"""Largest number of modes of which all are followed by default, and the number followed of more."""
SIMILAR, DIVISIONS = 0.6, 4
"""Similarity of shapes below which a step of the speed is divided, and how often at most."""


@dataclass(frozen=True)
class Campbell:
    """Modes over the speed of one body.

    Parameters
    ----------
    body
        Reference body of the speed.
    speed
        Its speeds [rad/s], shape (n_speed,).
    eigenvalue, shape
        Eigenvalues [1/s], shape (n_speed, n_mode), and shapes with modal mass 1, (n_speed, n_mode, nd).
    frequency
        Damped natural frequencies [Hz], shape (n_speed, n_mode); 0 where a mode does not oscillate.
    damping_ratio
        Damping ratios, shape (n_speed, n_mode); 1 where a mode is overdamped.
    names
        Names of the branches, see the module.
    character
        Index of the branch whose shape at rest the mode is most similar to, shape (n_speed, n_mode).
    whirl, whirl_index
        Whirl at each speed in words and as number, see `mode_energies`, by speed and mode.
    energies
        Energies by speed.
    orders
        Mesh frequency over the rotational frequency of the body, by mesh.
    rates
        Rates of all coordinates with the body at 1 rad/s in the direction of the scenario.
    motions, modes
        For evaluations at further speeds.
    total
        Number of modes of the system.
    notes
        Notes for the user.
    omitted
        Speeds without an equilibrium [rad/s], which are omitted, with the reason.
    rotors
        Wind rotors whose modes are in multi-blade coordinates.
    """

    body: str
    speed: Array
    eigenvalue: NDArray[np.complex128]
    shape: NDArray[np.complex128]
    frequency: Array
    damping_ratio: Array
    names: tuple[str, ...]
    character: NDArray[np.int64]
    whirl: tuple[tuple[str, ...], ...]
    whirl_index: Array
    energies: tuple[Energies, ...]
    orders: dict[str, float]
    rates: Array
    motions: Motions
    modes: WhirlModes
    total: int
    notes: tuple[str, ...] = ()
    omitted: Mapping[float, str] = field(default_factory=dict)
    rotors: tuple[str, ...] = ()


def follow_modes(
    system: System,
    speeds: ArrayLike,
    body: str | None = None,
    scenario: Scenario | str | None = None,
    *,
    count: int | None = None,
    progress: Progress = silent,
    linear: Linearised | None = None,
    over: OverSpeed | None = None,
) -> Campbell:
    """Modes over speed; parameters as in `campbell_dataset.solve_campbell`, `linear` if already computed.

    `over`: the linear system as function of the speeds or, instead of them, of another parameter.
    """
    body = body or system.layout.bodies[1]
    if body not in system.layout.bodies[1:]:
        known = ", ".join(system.layout.bodies[1:] if system.model is None else system.model.bodies)
        raise SolverError(f"no body {body!r}; there are: {known}", INCONSISTENT)
    omega = np.atleast_1d(np.asarray(speeds, dtype=np.float64))
    linear = linear or linearise(system, scenario, turning=body)
    rates = rates_of(linear, body, scenario)
    total = linear.basis.shape[1]
    wanted = min(count if count is not None else total if total <= ALL else FEW, total)
    over = over or over_speed(linear, rates)
    over.prepare(omega)
    linear = over.reference
    few = not over.rotors or system.sizes["nd"] > KEPT
    at = lru_cache(RECENT if few else RECENT + omega.size)(over.at)
    own, parts = linear.system, linear.at_rest
    modes = WhirlModes(linear, at, omega, wanted if wanted < total else None)
    n = min(wanted, len(modes.modes.omega))
    at_rest = modes.modes.shapes[:n]
    omega, values, shapes, turning, omitted = _branches(modes, omega, at_rest, symmetric(parts.M), progress)
    motions = motions_of(own, linear.state, parts)
    spins = spins_of(motions, rates)
    energies = tuple(
        energies_of(
            motions,
            z,
            np.where(modes.modes.omega[:n] == 0.0, 0.0, v),
            terms,
            over.rate(float(s)) * spins,
        )
        for s, v, z, terms in zip(omega, values, shapes, turning, strict=True)
    )
    words = tuple(tuple(whirl_words(e)) for e in energies)
    rest = energies_of(
        motions, at_rest, (1j * modes.modes.omega[:n]).astype(np.complex128), 0.0 * at_rest, 0.0 * spins
    )
    named = base_names(own, motions, modes.modes.omega[:n], at_rest, rest)
    rotating = [row for s, row in zip(omega, words, strict=True) if s != 0.0]
    usual = _usual(rotating) if rotating else None
    blades = None
    if linear.axes is not None and rotating:
        turned = shapes[omega != 0.0]
        blades = _usual([linear.axes.ways(z, parts.M) for z in turned])
    return Campbell(
        body=body,
        speed=omega,
        eigenvalue=values,
        shape=shapes,
        frequency=values.imag / (2.0 * np.pi),
        damping_ratio=ratio_of(values),
        names=full_names(named, usual, blades),
        character=_character(shapes, at_rest, symmetric(parts.M), [(x.words, x.number) for x in named]),
        whirl=words,
        whirl_index=np.array([whirl_index(e) for e in energies]).reshape(omega.size, n),
        energies=energies,
        orders=mesh_orders(own, rates),
        rates=rates,
        motions=motions,
        modes=modes,
        total=total,
        notes=(*linear.notes, *modes.modes.notes),
        omitted=omitted,
        rotors=over.rotors,
    )


def _usual(words: Sequence[Sequence[str]]) -> list[str]:
    """Most frequent word of each mode over the speeds; of equally frequent ones that at the highest speed."""
    return [Counter(column).most_common(1)[0][0] for column in zip(*reversed(words), strict=True)]


def _branches(
    modes: WhirlModes, omega: Array, at_rest: Array, M: Array, progress: Progress
) -> tuple[Array, Complex, Complex, Array, dict[float, str]]:
    """Continuous curves that start as at rest, and the speeds without an equilibrium with the reason.

    Returns the other speeds (n_speed,), eigenvalues (n_speed, n), shapes (n_speed, n, nd) and their
    gyroscopic terms.
    """
    found: list[Complex] = []
    shapes: list[Complex] = []
    turning: list[Array] = []
    kept: list[float] = []
    omitted: dict[float, str] = {}
    last = normalised(at_rest.astype(complex), M)
    for s, speed in enumerate(map(float, omega)):
        before = kept[-1] if kept else None
        try:
            values, last = _step(modes, M, before, speed, last, DIVISIONS)
        except SolverError as error:
            omitted[speed] = str(error)
            if len(omitted) == len(omega):
                raise
        else:
            found.append(values)
            shapes.append(last)
            turning.append(gyroscopic_terms(last, modes.at(speed).D))
            kept.append(speed)
        progress(s + 1, omega.size, "speeds")
    n = len(at_rest)
    return (
        np.array(kept),
        np.array(found, complex).reshape(len(kept), n),
        np.array(shapes, complex).reshape(len(kept), *at_rest.shape),
        np.array(turning, float).reshape(len(kept), *at_rest.shape),
        omitted,
    )


def _step(
    modes: WhirlModes,
    M: Array,
    before: float | None,
    speed: float,
    last: NDArray[np.complex128],
    divisions: int,
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Follow the modes to a speed; a step over which a shape changes too much is divided."""
    values, z = modes.solve(speed)
    likeness = np.abs(last.conj() @ M @ z.T) ** 2
    order = best_match(likeness)
    least = likeness[np.arange(len(order)), order].min(initial=1.0)
    if before is not None and before != 0.0 and least < SIMILAR and divisions and modes.basis is not None:
        middle = 0.5 * (before + speed)
        _, last = _step(modes, M, before, middle, last, divisions - 1)
        return _step(modes, M, middle, speed, last, divisions - 1)
    return _with_rigid_modes(modes, (values[order], z[order]), last, likeness[np.arange(len(order)), order])


def _with_rigid_modes(modes: WhirlModes, found: Found, last: Complex, likeness: Array) -> Found:
    """Rigid rotations that forces damp need not be among the computed modes: they then have no frequency."""
    values, z = found
    lost = (modes.modes.omega[: len(values)] == 0.0) & (likeness < SIMILAR)
    if not lost.any():
        return found
    return np.where(lost, 0.0, values), np.where(lost[:, None], last, z)


def _character(
    shapes: NDArray[np.complex128], at_rest: Array, M: Array, kinds: list[tuple[str, int]]
) -> NDArray[np.int64]:
    """Branch whose shape at rest is most similar, shape (n_speed, n); modes of one pair count together."""
    found = np.tile(np.arange(len(at_rest)), (len(shapes), 1))
    if not kinds:
        return found
    listed = list(dict.fromkeys(kinds))
    first = np.array([kinds.index(kind) for kind in listed], np.int64)
    member = np.array([[kind == own for own in kinds] for kind in listed], float)
    for s, z in enumerate(shapes):
        share = member @ (np.abs(at_rest @ M @ z.T) ** 2)
        best = share.argmax(axis=0)
        own = np.array([listed.index(kind) for kind in kinds])
        other = share[best, np.arange(len(own))] > share[own, np.arange(len(own))] + 1e-9
        found[s] = np.where(other, first[best], found[s])
    return found
