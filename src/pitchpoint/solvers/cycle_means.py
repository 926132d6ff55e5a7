# SPDX-License-Identifier: Apache-2.0
"""Meshes over their cycle: mean damping and stiffness, and forces; unloaded meshes are set to first contact.

The mesh cycle is traversed by shifting the path of contact while all bodies are fixed: every mesh of a train
has its own mean, independent of the periods of the others. Independent meshes are evaluated simultaneously.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.mesh import record as mesh
from pitchpoint.elements.mesh.tooth_pairs import MAX_SPLIT
from pitchpoint.solvers.element_batches import Block, blocks_of, independent_batches, machines_of
from pitchpoint.solvers.element_tangents import forces_and_tangents
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.unloaded_flanks import shift_into_contact
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import (
    is_bevel,
    mesh_names,
    mesh_places,
    mesh_record,
    mesh_records,
    shared_width,
)
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]


GAUSS = 3
"""Quadrature phases between two kinks."""
_GAUSS_X, _GAUSS_W = np.polynomial.legendre.leggauss(GAUSS)
AHEAD = 1e-3
"""Rotation that shows in which direction the phases move [rad]."""
_MOVED = ("xi_0", "xi_b", "u0")
"""Fields of a mesh record that define its position in the cycle."""


def shift(record: np.void, share: float) -> None:
    """Advance a mesh by a fraction of its cycle without moving a body."""
    record["xi_0"] += share * record["p_bt"]
    record["xi_b"] -= share * record["p_bt"]


def cycle_nodes(record: np.void, flank: int, pool: Array, both: bool = False) -> tuple[Array, Array]:
    """Quadrature phases and weights of a flank for the mean over one mesh cycle.

    Exact for the closed forms and for pair tables with up to `MAX_SPLIT` points: three Gauss points between
    kinks (the total is a polynomial of degree four or less there), equal steps for a Fourier series, segment
    midpoints for a mesh table. Longer pair tables count as smooth on sixteen pieces. Slices and user-defined
    laws are sampled at 128 points. `both`: include the kinks of the other flank, which carries load, too.
    """
    if record["source"] == mesh.PHASE:
        n = int(record["n_k"])
        if record["form"] == 0:
            return _equal(max(8, 2 * n + 2))
        if record["form"] == 1:
            return _equal(n if n >= 32 else n * (32 // n + 1))
        if record["form"] == mesh.USER:
            return _equal(128)
    elif record["slices"] > 0:
        return _equal(128)
    kinks = _kinks(record, flank, pool)
    if both:
        # the phase of one flank falls as that of the other rises
        turned = float(record["now"]["start"].sum() + (record["xi_0"] + record["xi_b"]) / record["p_bt"])
        kinks = np.append(kinks, turned - _kinks(record, -flank, pool))
    kinks = np.unique(kinks % 1.0)
    lengths = np.diff(np.append(kinks, kinks[0] + 1.0))
    middle = kinks + 0.5 * lengths
    phases = middle[:, None] + 0.5 * lengths[:, None] * _GAUSS_X
    return phases.ravel(), (0.5 * lengths[:, None] * _GAUSS_W).ravel()


def _kinks(record: np.void, flank: int, pool: Array) -> Array:
    """Phases of a flank, modulo one base pitch, at which its total stiffness has a kink or a jump."""
    if record["source"] == mesh.PHASE:
        return np.array([0.0, pool[int(record["cosine"]) + 2]])
    lam = flank * record["tan_b"] / record["p_bt"]
    now, n = record["now"], int(record["n_table"])
    eps, L = float(now["eps"]), float(now["L"])
    places = [0.0, eps, L, eps - L, 0.5 * eps]
    if n > 2:
        places += list(np.linspace(0.0, eps, n if n <= MAX_SPLIT else 17)[1:-1])
    ends = lam * np.array(shared_width(record))
    if is_bevel(record):  # contact lines of bevel gears are spirals
        ends = lam * record["R_m"] * np.log1p(ends / (lam * record["R_m"])) if lam != 0.0 else ends
    return np.asarray(np.subtract.outer(places, ends).ravel())


def _equal(n: int) -> tuple[Array, Array]:
    return (np.arange(n) + 0.5) / n, np.full(n, 1.0 / n)


def observe_at(system: System, state: State, phases: Mapping[int, tuple[int, float]]) -> Array:
    """Observations at a state with meshes shifted to given phases, by mesh index the flank and its phase."""
    records = mesh_records(system)
    kept = {m: records[m].copy() for m in phases}
    for m, (_, now) in observed_phases(system, state, [*phases]):
        flank, wanted = phases[m]
        shift(records[m], flank * nearest(wanted - now[flank]))
    found = evaluate.observe(system, state)
    for m in phases:
        _put_back(records[m], kept[m])
    return found


@dataclass(frozen=True)
class _Cycle:
    """Cycle of a mesh: flank, initial phase, quadrature phases and weights, matrix blocks."""

    flank: int
    now: float
    phases: Array
    weights: Array
    blocks: Block


@dataclass(frozen=True)
class CycleMean:
    """A mesh over its cycle.

    Parameters
    ----------
    damping, stiffness
        Mean blocks, shape (number of blocks, 6, 6), in the order of `element_batches.blocks_of`.
    phases, weights
        Phases of the loaded flank and their weights in the mean, see `cycle_nodes`, shape (n,); none if the
        mesh is unloaded.
    places, forces
        Coordinates of the equilibrium at these phases, and generalised forces of this mesh and of others in
        other machines, shape (n, nd).
    """

    damping: Array
    stiffness: Array
    phases: Array
    weights: Array
    places: Array
    forces: Array


def cycle_means(
    system: System,
    state: State,
    held: tuple[int, ...],
    loose: Collection[str],
    rates: Array,
    settled: bool = True,
) -> dict[int, CycleMean]:
    """Every mesh over its cycle, by index of the mesh; the other meshes stay at their phase.

    Parameters
    ----------
    system, state
        The system, whose mesh records are changed and restored, and the operating point.
    held
        Spins that are held.
    loose
        Names of the unloaded meshes, which are set to first contact.
    rates
        Rates of the speed-dependent loads of the meshes.
    settled
        Find the equilibrium at every phase; without it all bodies stay, correct to first order in the
        variation of the stiffness.
    """
    names, places = mesh_names(system), mesh_places(system)
    free = [m for m in range(len(names)) if names[m] in loose]
    loaded = [m for m in range(len(names)) if names[m] not in loose]
    machine = machines_of(system)
    batches = independent_batches(free, [blocks_of(system, *places[m]).nodes for m in free])
    batches += independent_batches(
        loaded, [{int(machine[int(mesh_record(system, m)[e])]) for e in "ij"} - {0} for m in loaded]
    )
    found: dict[int, CycleMean] = {}
    for batch in batches:
        found |= _means_together(
            system, state, held, batch, names[batch[0]] in loose, rates if settled else None
        )
    return found


def _means_together(
    system: System,
    state: State,
    held: tuple[int, ...],
    batch: Sequence[int],
    loose: bool,
    rates: Array | None,
) -> dict[int, CycleMean]:
    """Cycles of independent meshes, evaluated simultaneously; without rates the bodies stay."""
    cycles = {m: _cycle(system, m, values) for m, values in observed_phases(system, state, batch)}
    records = mesh_records(system)
    kept = {m: records[m].copy() for m in batch}
    total = {m: np.zeros((2, len(c.blocks.places), 6, 6)) for m, c in cycles.items()}
    seen: dict[int, list[tuple[Array, Array]]] = {m: [] for m in batch}
    at = state
    try:
        for step in range(max(c.phases.size for c in cycles.values())):
            active = {m: c for m, c in cycles.items() if step < c.phases.size}
            for m, cycle in active.items():
                _put_back(records[m], kept[m])
                shift(records[m], cycle.flank * (float(cycle.phases[step]) - cycle.now))
            if loose:
                shift_into_contact(system, at, {m: c.flank for m, c in active.items()})
            for _ in range(2):  # the new deflection changes the phase slightly
                if loose or rates is None:
                    break
                at = _rest_at(system, at, held, state, rates)
                for m, (_, phase) in observed_phases(system, at, [*active]):
                    ahead = nearest(float(active[m].phases[step]) - phase[active[m].flank])
                    shift(records[m], active[m].flank * ahead)
            force, *both = forces_and_tangents(system, at, _records(system, active))
            for m, cycle in active.items():
                total[m] += cycle.weights[step] * np.array([x[cycle.blocks.places] for x in both])
                if not loose:
                    seen[m].append((at.q, force))
    finally:
        for m in batch:
            _put_back(records[m], kept[m])
        evaluate.residual(system, state)
    nd = system.sizes["nd"]
    return {
        m: CycleMean(
            total[m][0],
            total[m][1],
            cycles[m].phases[: len(rows)],
            cycles[m].weights[: len(rows)],
            np.array([q for q, _ in rows]).reshape(-1, nd),
            np.array([force for _, force in rows]).reshape(-1, nd),
        )
        for m, rows in seen.items()
    }


def _put_back(record: np.void, kept: np.void) -> None:
    """Restore the cycle position of a mesh from a copy of its record."""
    for name in _MOVED:
        record[name] = kept[name]


def _records(system: System, meshes: Collection[int]) -> dict[str, NDArray[np.int64]]:
    """Record indices of some meshes, by kind."""
    found: dict[str, list[int]] = {}
    places = mesh_places(system)
    for m in meshes:
        found.setdefault(places[m][0], []).append(places[m][1])
    return {kind: np.array(rows, np.int64) for kind, rows in found.items()}


def observed_phases(
    system: System, state: State, meshes: Sequence[int]
) -> Iterator[tuple[int, tuple[float, dict[int, float]]]]:
    """Contact state of some meshes, and the phases of both flanks.

    The phase of the back flank is read from the record, which the evaluation of that flank updates.
    """
    values, names, records = evaluate.observe(system, state), mesh_names(system), mesh_records(system)
    for m in meshes:
        contact, front = (
            float(values[system.layout.channel(f"{c}[{names[m]}]")]) for c in ("contact_state", "mesh_phase")
        )
        yield m, (contact, {1: front, -1: float(records[m]["now"]["psi"])})


def moving_phases(system: System, state: State, rates: Array) -> dict[str, tuple[float, bool]]:
    """Phase of the loaded flank of every mesh, and whether it grows along rates of the coordinates (nd,)."""
    names = mesh_names(system)
    moved = state.copy()
    moved.q += AHEAD * rates / max(float(np.abs(rates).max(initial=0.0)), 1e-300)
    seen = []
    for at in (state, moved):
        observed = observed_phases(system, at, range(len(names)))
        seen.append([phase[-1 if contact < 0.0 else 1] for _, (contact, phase) in observed])
    return {name: (a, nearest(b - a) > 0.0) for name, a, b in zip(names, *seen, strict=True)}


def _cycle(system: System, m: int, observed: tuple[float, dict[int, float]]) -> _Cycle:
    """Cycle of a mesh from its present phase."""
    record, (kind, n) = mesh_record(system, m), mesh_places(system)[m]
    contact, phase = observed
    flank = -1 if contact < 0.0 else 1
    both = bool(contact == 2.0 or record["now"]["gap"] < 0.0)
    phases, weights = cycle_nodes(record, flank, system.pools.get(kind, np.zeros(0)), both)
    return _Cycle(flank, phase[flank], phases, weights, blocks_of(system, kind, n))


def nearest(difference: float) -> float:
    """Difference of two phases in [-1/2, 1/2).

    Examples
    --------
    >>> nearest(0.75), nearest(-0.25)
    (-0.25, -0.25)
    """
    return (difference + 0.5) % 1.0 - 0.5


def _rest_at(system: System, near: State, held: tuple[int, ...], like: State, rates: Array) -> State:
    """Equilibrium under the loads at given rates; the result has the rates of `like`."""
    start = near.copy()
    start.v[:] = rates
    found = find_equilibrium(system, start, held, near=True).state
    found.v[:] = like.v
    return found
