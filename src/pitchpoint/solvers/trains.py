# SPDX-License-Identifier: Apache-2.0
"""Trains: bodies that can only turn together, and the rotations that nothing hinders.

Every element that carries torque is one linear relation between the rates of the spins: meshes and rigid
ratios by their teeth, couplings, beams and bearings stiff about their axis by equal rates. What satisfies all
of them is a free rotation: one per ordinary gear train, two per planet set whose three members are free. What
is stiff in other directions only, like the bearings of a shaft in a housing that moves, lets bodies turn.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.elements import registry
from pitchpoint.elements.ratio import place_of
from pitchpoint.elements.registry import MODAL
from pitchpoint.model.scenario import Scenario
from pitchpoint.multibody.bodies import GENERAL, base_of
from pitchpoint.solvers.assembly import loop_rows
from pitchpoint.solvers.resistance import SAME, resisted_spins
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import KINDS, is_bevel, mesh_names, mesh_records
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

MOST_SPINS = 3000
"""Spins up to which trains are looked for: the time grows with their cube, to a minute for these."""


def free_spins(system: System) -> tuple[int, ...]:
    """Spin coordinates that have to be held so that nothing can turn freely, first bodies first."""
    return _independent(system, ())


def held_spins(system: System) -> tuple[int, ...]:
    """Spins of driven bodies, and those that must be held beside them."""
    return _independent(system, driven_coordinates(system))


def driven_coordinates(system: System) -> tuple[int, ...]:
    """Coordinates whose motion is prescribed, in the order of the drives."""
    return tuple(place_of(r, "i") for r in system.records.get("drive", ()))


def exchange(system: System, held: Sequence[int], spin: int, state: State | None = None) -> tuple[int, ...]:
    """Hold one spin in place of the one among `held` that its train moves most; it comes last.

    With a state a train also goes on through closed loops, as they stand there.
    """
    if spin in held:
        return (*(h for h in held if h != spin), spin)
    free, index = _free(system)
    if state is not None and loop_rows(system):
        free, index = _motions(system, state), {k: k for k in range(system.sizes["nd"])}
    turning = [h for h in held if h in index and np.linalg.norm(free[index[h]]) > SAME]
    if not turning or np.linalg.norm(free[index[spin]]) <= SAME:
        return (*held, spin)
    shares = np.linalg.lstsq(free[[index[h] for h in turning]].T, free[index[spin]], rcond=None)[0]
    given_up = turning[int(np.argmax(np.abs(shares)))]
    return (*(h for h in held if h != given_up), spin)


def turning_rates(system: System, state: State, spin: int) -> Array:
    """Rates of all coordinates as one spin turns at 1 rad/s through teeth and closed loops, as they stand.

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
    _, index = _free(system)
    rows = [row / np.linalg.norm(row) for row in _relations(system, index, True)]
    free = _null_space(np.array(rows).reshape(-1, len(index)))[[index[one], index[two]]]
    return int(np.linalg.matrix_rank(free, tol=SAME)) < 2


def is_independent(system: System, state: State, held: Sequence[int], spin: int) -> bool:
    """Whether a spin can turn through teeth and closed loops while others are held."""
    rows = _motions(system, state)[[*held, spin]]
    return int(np.linalg.matrix_rank(rows, tol=SAME)) > int(np.linalg.matrix_rank(rows[:-1], tol=SAME))


def rates_through_loops(system: System, state: State, given: Collection[int]) -> Array:
    """Rates that fit teeth and closed loops at a state, those of some coordinates as they stand in it.

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
    _, index = _free(system)
    rows = list(evaluate.constraint_jacobian(system, state)[loop_rows(system)])
    for relation in _relations(system, index, True):
        row = np.zeros(nd)
        row[list(index)] = relation
        rows.append(row)
    still = {int(s) for s in system.states}
    hidden = {int(r[n]) for r in system.records.get("flexible_body", ()) for n in MODAL[1:]} - {0}
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
    return (*first, *_beside(system, first, others))


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
    index = _index(system)
    spins = rates[list(index)]
    found = {}
    for name, record in zip(mesh_names(system), mesh_records(system), strict=True):
        relative = _turning(system, index, int(record["i"])) - _base(system, index, record, "i")
        speed = float(relative @ spins)
        turns = abs(speed) > SAME * float(np.abs(relative) @ np.abs(spins))
        found[name] = abs(float(record["z1"]) * speed) if turns else 0.0
    return found


def body_rates(system: System, body: str) -> Array:
    """Rates of all coordinates, shape (nd,), as one body turns at 1 rad/s and its train with it."""
    if system.model is None:
        return np.asarray(rotations(system, (system.spin(body),))[:, 0])
    rates = np.zeros(system.sizes["nd"])
    for name, ratio in system.model.start_speeds(Scenario(speed={body: 1.0})).items():
        if ratio != 0.0:
            rates[system.spin(name)] = ratio
    return rates


def rotations(system: System, spins: Sequence[int]) -> Array:
    """Rates of all coordinates as each of some spins turns at 1 rad/s and other held ones stand still.

    A train that something keeps from turning turns as its teeth want, whatever it is tied to.

    Returns
    -------
    ndarray, shape (nd, len(spins))
    """
    free, index = _free(system)
    rates = np.zeros((system.sizes["nd"], len(spins)))
    turning = [s for s in spins if np.linalg.norm(free[index[s]]) > SAME]
    held = [*turning, *_beside(system, turning, index)]
    inverse = np.linalg.inv(free[[index[h] for h in held]]) if held else np.zeros((0, 0))
    places = list(index)
    for column, spin in enumerate(spins):
        if spin in turning:
            rates[places, column] = free @ inverse[:, held.index(spin)]
        else:
            rates[places, column] = _as_the_teeth_want(system, index, spin)
    return rates


def rigid_rotations(system: System) -> Array:
    """Turns of the spins that nothing resists: one row per free train that nothing drives, shape (r, nd)."""
    return rotations(system, held_spins(system)[len(driven_coordinates(system)) :]).T


def driven_rotations(system: System) -> dict[int, Array]:
    """Rates of all coordinates (nd,) as one driven spin turns at 1 rad/s and the others stand still, by spin.

    Of drives on one train the first counts.
    """
    free, index = _free(system)
    turning: list[int] = []
    driven: list[int] = []
    for spin in (s for s in driven_coordinates(system) if s in index):
        resisted = np.linalg.norm(free[index[spin]]) <= SAME
        if resisted or _beside(system, turning, [spin]):
            driven.append(spin)
            turning += [] if resisted else [spin]
    return dict(zip(driven, rotations(system, driven).T, strict=True))


def _independent(system: System, first: Sequence[int]) -> tuple[int, ...]:
    _, index = _free(system)
    return complete(system, first, index)


def _beside(system: System, first: Sequence[int], others: Iterable[int]) -> list[int]:
    """Those of the other spins that are free while the first ones, and those before them, are held."""
    free, index = _free(system)
    rest = free.copy()
    found = []
    for spin in [*(s for s in first if s in index), *others]:
        row = rest[index[spin]]
        size = float(row @ row)
        if size > SAME:
            if spin not in first:
                found.append(spin)
            rest = rest - np.outer(rest @ row, row) / size
    return found


def _index(system: System) -> dict[int, int]:
    """Place of every spin among all spins."""
    return {int(s): k for k, s in enumerate(s for s in system.program["body"]["spin"] if s >= 0)}


def _free(system: System) -> tuple[Array, dict[int, int]]:
    """Orthonormal basis of the free rotations over the spins, shape (n, k), and the place of every spin."""
    index = _index(system)
    resisted = resisted_spins(system, index)
    if len(resisted) == len(index) > 0:  # nothing turns freely, as in machines of bodies on bushings
        return np.zeros((len(index), 0)), index
    if len(index) > MOST_SPINS:
        raise CompileError(
            f"{len(index)} bodies and stations of shafts spin, and which of them turn together is found for "
            f"{MOST_SPINS} at most; compute parts of the machine apart, or give shafts fewer pieces "
            "(largest_piece)"
        )
    rows = [*_relations(system, index, True), *resisted]
    if not rows:
        return np.eye(len(index)), index
    L = np.array(rows)
    return _null_space(L / np.linalg.norm(L, axis=1, keepdims=True)), index


def _null_space(rows: Array) -> Array:
    """Orthonormal columns that rows of length one leave."""
    _, sizes, basis = np.linalg.svd(rows)
    return np.asarray(basis[int(np.sum(sizes > SAME * sizes.max(initial=0.0))) :].T)


def _as_the_teeth_want(system: System, index: dict[int, int], spin: int) -> Array:
    """Rates of the spins of a train that cannot turn as a whole, where its relations differ least."""
    one = np.zeros(len(index))
    one[index[spin]] = 1.0
    rows = [row / np.linalg.norm(row) for row in _relations(system, index, False)]
    A = np.array([*rows, 1e3 * one])
    return np.asarray(np.linalg.lstsq(A, np.array([*np.zeros(len(rows)), 1e3]), rcond=None)[0])


def _turning(system: System, index: dict[int, int], b: int, sense: float = 1.0) -> Array:
    """How a body turns in space per rate of every spin: about its own axis, or against it (`sense` -1)."""
    body = system.program["body"]
    found = np.zeros(len(index))
    while b and sense != 0.0:
        if body[b]["spin"] >= 0:
            found[index[int(body[b]["spin"])]] += sense
        sense *= float(body[b]["sense"])
        b = int(body[b]["parent"])
    return found


def _relations(system: System, index: dict[int, int], to_ground: bool) -> list[Array]:
    """Rows over the rates of the spins that torque-carrying elements hold at zero."""
    found = []
    for kind, records in system.records.items():
        together = getattr(registry.find(kind).load(), "SPINS", "") == "together"
        for record in records:
            if kind == "ratio":
                row = _ratio(record, index)
            elif kind in (*KINDS, "bearing") or together:
                i, j = int(record["i"]), int(record["j"])
                one, two = (_turning(system, index, b) for b in (i, j))
                if kind in KINDS:
                    base1, base2 = (_base(system, index, record, end) for end in "ij")
                    row = float(record["z1"]) * (one - base1) + float(record["z2"]) * (two - base2)
                elif kind == "bearing" and record["K"][5, 5] == 0.0:
                    continue
                else:
                    row = one - two
                if not to_ground and not (one.any() and two.any()):
                    continue
            else:
                continue
            if row.any():
                found.append(row)
    return found


def _base(system: System, index: dict[int, int], record: np.void, end: str) -> Array:
    """How what carries the line of centres of a mesh turns about the axis of a gear, per rate of any spin.

    Axes of cylindrical gears are the same, bevel gears have their own. A housing that turns about another
    axis takes the gears along and turns none against the other.
    """
    body = system.program["body"]
    carried = "i" if record["carried"] == 1 else "j"
    if is_bevel(record) and carried != end:
        return _bevel_base(system, index, (int(record[carried]), int(record[end])))
    gear = int(record[carried])
    own = int(body[gear]["spinner"]) or gear
    return _turning(system, index, base_of(body, gear), float(body[own]["sense"]))


def _bevel_base(system: System, index: dict[int, int], gears: tuple[int, int]) -> Array:
    """How the base of the first of two bevel gears turns about the axis of the second, if it is parallel."""
    base = base_of(system.program["body"], gears[0])
    if base == 0:
        return np.zeros(len(index))
    one, two = (np.asarray(system.bodies[b - 1].axes, float)[:, 2] for b in (base, gears[1]))
    along = float(one @ two)
    return _turning(system, index, base, float(np.sign(along)) if abs(abs(along) - 1.0) < SAME else 0.0)


def _ratio(record: np.void, index: dict[int, int]) -> Array:
    """Row of a rigid ratio; one that ties a coordinate that is no spin holds no spin by itself."""
    row = np.zeros(len(index))
    for end in "ijk":
        if record[f"c_{end}"] != 0.0:
            place = place_of(record, end)
            if place not in index:
                return np.zeros(len(index))
            row[index[place]] += float(record[f"c_{end}"])
    return row
