# SPDX-License-Identifier: Apache-2.0
"""Gear trains: bodies that can only turn together, and the rotations that no element constrains.

Every element that carries torque is one linear relation between the rates of the spins: meshes and rigid
ratios by their teeth, couplings, beams and bearings stiff about their axis by equal rates. What satisfies all
of them is a free rotation: one per ordinary gear train, two per planet set whose three members are free. What
is stiff in other directions only, like the bearings of a shaft in a housing that moves, lets bodies turn.
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
    """Spin coordinates that have to be held so that nothing can turn freely, first bodies first."""
    return _independent(system, ())


def held_spins(system: System) -> tuple[int, ...]:
    """Spins of driven bodies, and those that must be held in addition."""
    return _independent(system, driven_coordinates(system))


def driven_coordinates(system: System) -> tuple[int, ...]:
    """Coordinates whose motion is prescribed, in the order of the drives."""
    return tuple(place_of(r, "i") for r in system.rows(DRIVE))


def exchange(system: System, held: Sequence[int], spin: int, state: State | None = None) -> tuple[int, ...]:
    """Hold one spin in place of the one among `held` that its train moves most; it comes last.

    Driven ones are let go last. With a state a train also continues through closed loops in their position
    there.
    """
    return exchange_all(system, held, (spin,), state)


def exchange_all(
    system: System, held: Sequence[int], spins: Sequence[int], state: State | None = None
) -> tuple[int, ...]:
    """Hold several spins in place of others, one after the other as by `exchange`."""
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
    """Spins held with one in place of another; those in the second list of `keep` stay longest."""
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
    """Rates of all coordinates as one spin turns at 1 rad/s through teeth and closed loops at a state.

    What they leave open besides moves as little as it can.

    Returns
    -------
    ndarray, shape (nd,)
        Zeros if the loops hold it fast.
    """
    free = _motions(system, state)
    row = free[spin]
    return np.zeros(len(free)) if np.linalg.norm(row) <= SAME else np.asarray(free @ row / (row @ row))


def tied_by_teeth(system: System, one: int, two: int) -> bool:
    """Whether teeth and other ratios that never change tie two spins, whatever loops do besides."""
    spins = spins_of(system)
    free = null_space([p.row for p in torque_paths(system)], spins)
    if free.group_of[one] != free.group_of[two]:
        return not (free.moves(one) and free.moves(two))
    return int(np.linalg.matrix_rank(np.array([free.row(one), free.row(two)]), tol=SAME)) < 2


def is_independent(system: System, state: State, held: Sequence[int], spin: int) -> bool:
    """Whether a spin can turn through teeth and closed loops while others are held."""
    rows = _motions(system, state)[[*held, spin]]
    return int(np.linalg.matrix_rank(rows, tol=SAME)) > int(np.linalg.matrix_rank(rows[:-1], tol=SAME))


def rates_through_loops(system: System, state: State, given: Collection[int]) -> Array:
    """Rates that fit teeth and closed loops at a state, those of some coordinates being given in it.

    What the given ones leave open changes as little as it can; where they contradict teeth and loops, all
    rates stay as they are.

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
    """What teeth and loops let move: orthonormal columns, shape (nd, k); rates of spins count by 1 rad.

    Shafts stay in their bearings, elastic bodies and states of elements as they are.
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
    """Spins to hold: the first ones, and those of the others that they leave free to turn."""
    return (*first, *_beside(_free(system), first, others))


def mesh_rates(system: System, speeds: Mapping[str, float]) -> list[float]:
    """Mesh periods per second times 2 pi of every mesh at the spins of bodies [rad/s]; see `mesh_orders`."""
    rates = np.zeros(system.sizes["nd"])
    for b, name in enumerate(system.layout.bodies):
        spin = int(system.program["body"][b]["spin"])
        if spin >= 0:
            rates[spin] = speeds.get(name, 0.0)
    return list(mesh_orders(system, rates).values())


def mesh_orders(system: System, rates: Array) -> dict[str, float]:
    """Mesh periods per second times 2 pi by mesh: teeth times the speed against the line of centres.

    Parameters
    ----------
    system
        The system.
    rates
        Rates of all coordinates [rad/s], shape (nd,); those of one body at 1 rad/s give the number of
        mesh periods in a revolution of it.
    """
    found = {}
    for name, record in zip(mesh_names(system), mesh_records(system), strict=True):
        terms = [factor * rates[spin] for spin, factor in against_the_base(system, record, "i").items()]
        turns = abs(sum(terms)) > SAME * sum(map(abs, terms))
        found[name] = abs(float(record["z1"] * sum(terms))) if turns else 0.0
    return found


def rotations(system: System, spins: Sequence[int]) -> Array:
    """Rates of all coordinates as each of some spins turns at 1 rad/s and other held ones are at rest.

    A train that something keeps from turning turns as its teeth want, whatever it is tied to.

    Returns
    -------
    ndarray, shape (nd, len(spins))
    """
    free = _free(system)
    rates = np.zeros((system.sizes["nd"], len(spins)))
    turning = {s: column for column, s in enumerate(spins) if free.moves(s)}
    for group, held in _by_train(free, [*turning, *_beside(free, [*turning], free.group_of)]).items():
        own, basis = free.groups[group]
        inverse = np.linalg.inv(np.array([free.row(h) for h in held]))
        for k, spin in enumerate(held):
            if spin in turning:
                rates[list(own), turning[spin]] = basis @ inverse[:, k]
    for column, spin in enumerate(spins):
        if spin not in turning:
            wanted = _as_the_teeth_want(system, spin)
            rates[list(wanted), column] = list(wanted.values())
    return rates


def _by_train(free: NullSpace, spins: Sequence[int]) -> dict[int, list[int]]:
    """Spins of every group that turns together."""
    found: dict[int, list[int]] = {}
    for spin in spins:
        found.setdefault(int(free.group_of[spin]), []).append(spin)
    return found


def rigid_rotations(system: System) -> Array:
    """Turns of the spins that nothing resists: one row per free train that nothing drives, shape (r, nd)."""
    return rotations(system, held_spins(system)[len(driven_coordinates(system)) :]).T


def driven_rotations(system: System) -> dict[int, Array]:
    """Rates of all coordinates (nd,) as one driven spin turns at 1 rad/s and the others are at rest, by spin.

    Of drives on one train the first counts.
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
    """Those of the other spins that are free while the first ones, and those before them, are held."""
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
    """Free rotations over the spins."""
    spins = spins_of(system)
    resisted: list[Row] = [{spin: 1.0} for spin in resisted_spins(system)]
    if len(resisted) == len(spins):  # nothing turns freely, as in machines of bodies on bushings
        return null_space(resisted, spins)
    return null_space([*resisted, *(p.row for p in torque_paths(system))], spins)


def _whole(basis: Array) -> NullSpace:
    """Orthonormal columns over all coordinates as one group."""
    places = range(len(basis))
    return NullSpace(((tuple(places), basis),), dict.fromkeys(places, 0), {k: k for k in places})


def _null_space(rows: Array) -> Array:
    """Orthonormal columns that rows of length one leave."""
    _, sizes, basis = np.linalg.svd(rows)
    return np.asarray(basis[int(np.sum(sizes > SAME * sizes.max(initial=0.0))) :].T)


def spins_of_train(system: System, spin: int) -> set[int]:
    """Spins that teeth, couplings and other paths of torque join with one, itself among them."""
    return _joined([p.row for p in torque_paths(system) if not p.to_ground], spin)


def _joined(rows: Sequence[Row], spin: int) -> set[int]:
    joined = {spin}
    while more := {s for row in rows if not joined.isdisjoint(row) for s in row} - joined:
        joined |= more
    return joined


def _as_the_teeth_want(system: System, spin: int) -> dict[int, float]:
    """Rates of the spins of a train that cannot turn as a whole, where its relations differ least."""
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
