# SPDX-License-Identifier: Apache-2.0
"""Gear trains: bodies with coupled rotations, and the free rotations of the system.

Every element that transmits torque is one linear relation between the spin rates: meshes and rigid ratios by
their tooth numbers; couplings, beams and torsionally stiff bearings by equal rates. The solutions of all
relations are the free rotations: one per ordinary gear train, two per planetary gear set with three free
members. Elements without torsional stiffness, such as the bearings of a shaft in a movable housing, do not
couple rotations.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.kind import DRIVE
from pitchpoint.elements.ratio import place_of
from pitchpoint.multibody.bodies import GENERAL
from pitchpoint.solvers.constraints.assembly import loop_rows
from pitchpoint.solvers.null_space import NullSpace, null_space
from pitchpoint.solvers.resistance import SAME, resisted_spins
from pitchpoint.solvers.torque_paths import Row, against_the_base, spins_of, torque_paths
from pitchpoint.system import evaluate
from pitchpoint.system.elastic import modal_bodies
from pitchpoint.system.meshes import mesh_names, mesh_records
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]


def free_spins(system: System) -> tuple[int, ...]:
    """Minimum set of spins to hold so that no body can rotate freely, in the order of the bodies."""
    return _independent(system, ())


def turning_spins(system: System) -> set[int]:
    """Spins that teeth, springs and bearings leave free to rotate."""
    free = _free(system)
    return {spin for spin in free.group_of if free.moves(spin)}


def held_spins(system: System) -> tuple[int, ...]:
    """Spins of driven bodies, and those to hold in addition so that no body can rotate freely."""
    return _independent(system, driven_coordinates(system))


def driven_coordinates(system: System) -> tuple[int, ...]:
    """Coordinates whose motion is prescribed, in the order of the drives."""
    return tuple(place_of(r, "i") for r in system.rows(DRIVE))


def exchange(system: System, held: Sequence[int], spin: int, state: State | None = None) -> tuple[int, ...]:
    """Hold one spin instead of the one among `held` that it drives with the largest ratio; appended last.

    Driven spins are released only if there is no other. With a state, trains continue through closed loops in
    their position there.
    """
    return exchange_all(system, held, (spin,), state)


def exchange_all(
    system: System, held: Sequence[int], spins: Sequence[int], state: State | None = None
) -> tuple[int, ...]:
    """Hold several spins instead of others, in sequence as by `exchange`."""
    kept, driven = tuple(held), driven_coordinates(system)
    if all(spin in kept for spin in spins):
        return (*(h for h in kept if h not in spins), *spins)
    free = _free(system)
    if state is not None and loop_rows(system):
        free = _whole(_motions(system, state))
    for spin in spins:
        kept = _exchanged(free, kept, spin, (driven, spins))
    return kept


def _exchanged(
    free: NullSpace, held: tuple[int, ...], spin: int, keep: tuple[Sequence[int], Sequence[int]]
) -> tuple[int, ...]:
    """Held spins with one exchanged; spins of the second list of `keep` are released last."""
    if spin in held or not free.moves(spin):
        return (*(h for h in held if h != spin), spin)
    train = free.group_of[spin]
    turning = [h for h in held if h in free.group_of and free.group_of[h] == train and free.moves(h)]
    if not turning:
        return (*held, spin)
    rows = np.array([free.row(h) for h in turning])
    shares = np.linalg.lstsq(rows.T, free.row(spin), rcond=None)[0]
    sizes = np.abs(shares)
    able = [k for k in range(len(turning)) if sizes[k] > SAME * sizes.max()]
    least = min(able, key=lambda k: (turning[k] in keep[1], turning[k] in keep[0], -sizes[k]))
    given_up = turning[least]
    return (*(h for h in held if h != given_up), spin)


def turning_rates(system: System, state: State, spin: int) -> Array:
    """Rates of all coordinates for one spin at 1 rad/s, through gear trains and closed loops at a state.

    Rates that these do not determine have minimum norm.

    Returns
    -------
    ndarray, shape (nd,)
        Zeros if the loops fix the spin.
    """
    free = _motions(system, state)
    row = free[spin]
    return np.zeros(len(free)) if np.linalg.norm(row) <= SAME else np.asarray(free @ row / (row @ row))


def tied_by_teeth(system: System, one: int, two: int) -> bool:
    """Whether teeth or other constant ratios couple two spins; closed loops are ignored."""
    spins = spins_of(system)
    free = null_space([p.row for p in torque_paths(system)], spins)
    if free.group_of[one] != free.group_of[two]:
        return not (free.moves(one) and free.moves(two))
    return int(np.linalg.matrix_rank(np.array([free.row(one), free.row(two)]), tol=SAME)) < 2


def is_independent(system: System, state: State, held: Sequence[int], spin: int) -> bool:
    """Whether a spin is free to rotate, given teeth and closed loops, while others are held."""
    rows = _motions(system, state)[[*held, spin]]
    return int(np.linalg.matrix_rank(rows, tol=SAME)) > int(np.linalg.matrix_rank(rows[:-1], tol=SAME))


def rates_through_loops(system: System, state: State, given: Collection[int]) -> Array:
    """Rates consistent with teeth and closed loops at a state, for given rates of some of its coordinates.

    Rates that these do not determine change as little as possible. If the given rates contradict teeth or
    loops, all rates are unchanged.

    Returns
    -------
    ndarray, shape (nd,)
    """
    free, known = _motions(system, state), sorted(given)
    wanted = state.v[known]
    share = free.T @ state.v
    share = share + np.linalg.lstsq(free[known], wanted - free[known] @ share, rcond=SAME)[0]
    off = np.abs(free[known] @ share - wanted).max(initial=0.0)
    if off > SAME * np.abs(wanted).max(initial=0.0):
        return state.v.copy()
    return np.where(np.linalg.norm(free, axis=1) > SAME, free @ share, state.v)


def _motions(system: System, state: State) -> Array:
    """Motions allowed by teeth and loops: orthonormal columns, shape (nd, k).

    Displacements of shafts in their bearings, elastic deformations and element states are excluded.
    """
    body, nd = system.program["body"], system.sizes["nd"]
    rows = list(evaluate.constraint_jacobian(system, state)[loop_rows(system)])
    for path in torque_paths(system):
        row = np.zeros(nd)
        row[list(path.row)] = list(path.row.values())
        rows.append(row)
    still = {int(s) for s in system.states}
    hidden = modal_bodies(system)
    for k, b in enumerate(body):
        if k and (b["joint"] != GENERAL or k in hidden):
            own = range(int(b["dof"]), int(b["dof"]) + int(b["n"]))
            still |= {c for c in own if c != int(b["spin"]) or k in hidden}
    rows += list(np.eye(nd)[sorted(still)])
    L = np.array(rows).reshape(-1, nd)
    sizes = np.linalg.norm(L, axis=1, keepdims=True)
    return _null_space(L / np.where(sizes > 0.0, sizes, 1.0))


def complete(system: System, first: Sequence[int], others: Iterable[int]) -> tuple[int, ...]:
    """Spins to hold: the first ones, and those of the others that are then still free to rotate."""
    return (*first, *_beside(_free(system), first, others))


def mesh_rates(system: System, speeds: Mapping[str, float]) -> list[float]:
    """Circular mesh frequency of every mesh [rad/s] for the speeds of bodies [rad/s]; see `mesh_orders`."""
    rates = np.zeros(system.sizes["nd"])
    for b, name in enumerate(system.layout.bodies):
        spin = int(system.program["body"][b]["spin"])
        if spin >= 0:
            rates[spin] = speeds.get(name, 0.0)
    return list(mesh_orders(system, rates).values())


def mesh_orders(system: System, rates: Array) -> dict[str, float]:
    """Circular mesh frequency by mesh: number of teeth times the speed relative to the line of centres.

    Parameters
    ----------
    system
        The system.
    rates
        Rates of all coordinates [rad/s], shape (nd,). With one body at 1 rad/s the result is the mesh order:
        mesh periods per revolution of that body.
    """
    found = {}
    for name, record in zip(mesh_names(system), mesh_records(system), strict=True):
        terms = [factor * rates[spin] for spin, factor in against_the_base(system, record, "i").items()]
        turns = abs(sum(terms)) > SAME * sum(map(abs, terms))
        found[name] = abs(float(record["z1"] * sum(terms))) if turns else 0.0
    return found


def rotations(system: System, spins: Sequence[int]) -> Array:
    """Rates of all coordinates with each of some spins at 1 rad/s while the other held spins are at rest.

    The rates of a train that cannot rotate follow from its tooth ratios only.

    Returns
    -------
    ndarray, shape (nd, len(spins))
    """
    free = _free(system)
    rates = np.zeros((system.sizes["nd"], len(spins)))
    turning = {s: column for column, s in enumerate(spins) if free.moves(s)}
    for group, held in _by_train(free, [*turning, *_beside(free, [*turning], free.group_of)]).items():
        own, basis = free.groups[group]
        rows = np.array([free.row(h) for h in held])
        # kinds of other packages may link held spins, which then determine each other
        inverse = np.linalg.inv(rows) if rows.shape[0] == rows.shape[1] else np.linalg.pinv(rows)
        for k, spin in enumerate(held):
            if spin in turning:
                rates[list(own), turning[spin]] = basis @ inverse[:, k]
    for column, spin in enumerate(spins):
        if spin not in turning:
            wanted = _by_tooth_ratios(system, spin)
            rates[list(wanted), column] = list(wanted.values())
    return rates


def _by_train(free: NullSpace, spins: Sequence[int]) -> dict[int, list[int]]:
    """Spins by group of coupled rotations."""
    found: dict[int, list[int]] = {}
    for spin in spins:
        found.setdefault(int(free.group_of[spin]), []).append(spin)
    return found


def rigid_rotations(system: System) -> Array:
    """Free rigid rotations: one row per train without drive and resistance, shape (r, nd)."""
    return rotations(system, held_spins(system)[len(driven_coordinates(system)) :]).T


def free_motions(system: System) -> Array:
    """Rigid rotations that no drive prescribes, one per column, shape (nd, n)."""
    held, driven = held_spins(system), set(driven_coordinates(system))
    return rotations(system, held)[:, [k for k, spin in enumerate(held) if spin not in driven]]


def driven_rotations(system: System) -> dict[int, Array]:
    """Rates of all coordinates (nd,) with one driven spin at 1 rad/s and the others at rest, by driven spin.

    If a train has several drives, only the first counts.
    """
    free = _free(system)
    turning: list[int] = []
    driven: list[int] = []
    for spin in (s for s in driven_coordinates(system) if s in free.group_of):
        resisted = not free.moves(spin)
        if resisted or _beside(free, turning, [spin]):
            driven.append(spin)
            turning += [] if resisted else [spin]
    return dict(zip(driven, rotations(system, driven).T, strict=True))


def _independent(system: System, first: Sequence[int]) -> tuple[int, ...]:
    return complete(system, first, spins_of(system))


def _beside(free: NullSpace, first: Sequence[int], others: Iterable[int]) -> list[int]:
    """Spins among the others that are free while the first ones, and those found before, are held."""
    order = [*(s for s in first if s in free.group_of), *others]
    found = set()
    for group, spins in _by_train(free, order).items():
        rest = free.groups[group][1].copy()
        for spin in spins:
            if not rest.any():
                break
            row = rest[free.place_of[spin]].copy()
            size = float(row @ row)
            if size > SAME:
                found.add(spin)
                rest -= np.outer(rest @ row, row) / size
    return [s for s in dict.fromkeys(order) if s in found and s not in first]


def _free(system: System) -> NullSpace:
    """Free rotations, as null space over the spins."""
    spins = spins_of(system)
    resisted: list[Row] = [{spin: 1.0} for spin in resisted_spins(system)]
    if len(resisted) == len(spins):  # no free rotation, as for bodies on bushings
        return null_space(resisted, spins)
    return null_space([*resisted, *(p.row for p in torque_paths(system))], spins)


def _whole(basis: Array) -> NullSpace:
    """Null space with one group over all coordinates, from orthonormal columns."""
    places = range(len(basis))
    return NullSpace(((tuple(places), basis),), dict.fromkeys(places, 0), {k: k for k in places})


def _null_space(rows: Array) -> Array:
    """Orthonormal basis of the null space of rows of unit length."""
    _, sizes, basis = np.linalg.svd(rows)
    return np.asarray(basis[int(np.sum(sizes > SAME * sizes.max(initial=0.0))) :].T)


def spins_of_train(system: System, spin: int) -> set[int]:
    """Spins connected with one by teeth, couplings and other torque paths, including itself."""
    return _joined([p.row for p in torque_paths(system) if not p.to_ground], spin)


def _joined(rows: Sequence[Row], spin: int) -> set[int]:
    joined = {spin}
    while more := {s for row in rows if not joined.isdisjoint(row) for s in row} - joined:
        joined |= more
    return joined


def _by_tooth_ratios(system: System, spin: int) -> dict[int, float]:
    """Spin rates of a train that cannot rotate as a whole: least-squares solution of its relations."""
    rows = [p.row for p in torque_paths(system) if not p.to_ground]
    joined = _joined(rows, spin)
    place = {s: k for k, s in enumerate(sorted(joined))}
    rows = [row for row in rows if spin in joined and not joined.isdisjoint(row)]
    A = np.zeros((len(rows) + 1, len(place)))
    for line, row in zip(A, rows, strict=False):
        line[[place[s] for s in row]] = np.array(list(row.values())) / np.linalg.norm(list(row.values()))
    A[-1, place[spin]] = 1e3
    found = np.linalg.lstsq(A, np.array([*np.zeros(len(rows)), 1e3]), rcond=None)[0]
    return dict(zip(place, found.tolist(), strict=True))
