# SPDX-License-Identifier: Apache-2.0
"""Torques of all meshes, couplings and ratios at constant speed and without losses, from balance alone.

A link relates the speeds of its bodies, sum_s a_s w_s = 0 over the spins s; by virtual work its torque T acts
on every spin with a_s T (`carried_trains.relation`). At constant speed the torques on every spin add up to
zero:

    sum over the links of a_s T + sum over the external torques of e_s M = 0.

Power in equals power out, since w satisfies all relations. Where several paths carry the torque in parallel,
balance leaves a freedom, which elastic deflection decides. Meshes then count as equally stiff along their
lines of action, all other links as rigid: of all balanced torques those with the smallest sum of squares of
the tooth forces. Equal paths carry equal shares.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.model.carried_trains import relation, spin_row
from pitchpoint.model.frames import GROUND
from pitchpoint.model.keys import Place
from pitchpoint.model.mechanism import coordinate
from pitchpoint.model.speed_ratios import Link, links_of

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts

Array = NDArray[np.float64]

SAME = 1e-9
"""Relative singular value, torque and share of a vector that count as zero."""
ROUND_OFF = 1e-13
"""Force relative to the largest of a train that is rounding error."""


@dataclass(frozen=True)
class External:
    """Torque on a body from outside of the train.

    Attributes
    ----------
    name
        Key in the file, such as ("loads", "motor").
    body
        Body on which it acts, about its axis.
    torque
        Torque [N m]; None if the balance determines it.
    reaction
        Body that takes the reaction.
    """

    name: Place
    body: str
    torque: float | None = None
    reaction: str = GROUND


@dataclass(frozen=True)
class TorqueLink:
    """A mesh, coupling or ratio with its bodies and the torques on them about their own axes [N m].

    The torques are nan if balance does not determine them.
    """

    place: Place
    bodies: tuple[str, ...]
    torques: tuple[float, ...]


@dataclass(frozen=True, kw_only=True)
class TorqueBalance:
    """Torques at constant speed without losses.

    Attributes
    ----------
    links
        Torques of all links, by their keys in the file.
    external
        External torques [N m] by their keys; nan if balance does not determine them.
    unbalanced
        Trains with given torques that do not balance: their bodies, one of them, and the torque on it [N m]
        that would balance them; None with several free motions.
    undetermined
        Groups of external torques of which balance determines only the sum, or nothing.
    shared
        Meshes and couplings whose shares follow from equal stiffness, by train.
    """

    links: Mapping[Place, TorqueLink]
    external: Mapping[Place, float]
    unbalanced: Sequence[tuple[tuple[str, ...], str, float | None]] = ()
    undetermined: Sequence[tuple[Place, ...]] = ()
    shared: Sequence[tuple[str, ...]] = ()


@dataclass
class _Path:
    """One link as a column of the balance: ends with the factors of its torque, and the lever of its
    force."""

    place: Place
    ends: list[tuple[str, float]]
    row: Array
    lever: float


@dataclass
class _Train:
    """Columns of the balance that act on one set of spins."""

    spins: list[int]
    paths: list[_Path] = field(default_factory=list)
    outer: list[tuple[External, Array]] = field(default_factory=list)


def torque_balance(parts: Parts, external: Sequence[External], more: Sequence[Link] = ()) -> TorqueBalance:
    """Torques of all links for given external torques.

    Parameters
    ----------
    parts
        A model or the parts of one.
    external
        All external torques: loads, drives, supports.
    more
        Further links, such as closed clutches.
    """
    turning = [name for name, seat in parts.mechanism.seats.items() if "spin" in seat.coordinates]
    place = {name: k for k, name in enumerate(turning)}
    known = {one.name for one in external}  # such as a spring of known torque
    paths = [path for path in _paths(parts, place, more) if path.place not in known]
    outer = []
    for one in external:
        row = spin_row(parts, place, one.body)
        if one.reaction != GROUND:
            row = row - spin_row(parts, place, one.reaction, about=one.body)
        outer.append((one, row))
    links: dict[Place, TorqueLink] = {
        p.place: TorqueLink(p.place, tuple(b for b, _ in p.ends), (0.0,) * len(p.ends)) for p in paths
    }
    torques = {one.name: one.torque or 0.0 for one in external}
    unbalanced, undetermined, shared = [], [], []
    for train in _trains(len(turning), paths, outer):
        found = _solve(train)
        if found is None:
            continue
        links |= {p.place: _link(p, value) for p, value in zip(train.paths, found.paths, strict=True)}
        torques |= found.outer
        names = tuple(turning[s] for s in train.spins)
        if found.left is not None:
            spin, missing = found.left
            unbalanced.append((names, turning[train.spins[spin]], missing))
        undetermined += [found.undetermined] if found.undetermined else []
        shared += [found.shared] if found.shared else []
    return TorqueBalance(
        links=links, external=torques, unbalanced=unbalanced, undetermined=undetermined, shared=shared
    )


def _paths(parts: Parts, place: Mapping[str, int], more: Sequence[Link]) -> list[_Path]:
    """Links as columns of the balance; ratios of three spins included."""
    found = []
    for link in (*links_of(parts), *more):
        where, one, two, ratio = link
        row = relation(parts, place, link)
        if row.any():
            found.append(_Path(where, [(one, -ratio), (two, 1.0)], row, _lever(parts, where)))
    for name, part in parts.ratios.items():
        ends = [coordinate(parts.mechanism, parts, term) for term in part.terms]
        bodies = [end[0] for end in ends if not isinstance(end, str) and end[0] in place]
        if len(bodies) == len(ends) > 2 and all(_is_spin(parts, end) for end in ends):
            factors = list(part.terms.values())
            row = np.zeros(len(place))
            for body, factor in zip(bodies, factors, strict=True):
                row[place[body]] += factor
            found.append(_Path(("ratios", name), list(zip(bodies, factors, strict=True)), row, 0.0))
    return found


def _is_spin(parts: Parts, end: tuple[str, int, str] | str) -> bool:
    return not isinstance(end, str) and parts.mechanism.seats[end[0]].coordinates[end[1]] == "spin"


def _lever(parts: Parts, where: Place) -> float:
    """Lever of the tooth force on gear 2 [m], its base radius; 0 for links without teeth."""
    if where[0] == "meshes":
        return abs(parts.pairs[str(where[1])].gear2.r_b)
    if where[0] == "bevel_meshes":
        gear = parts.bevel_gears[parts.bevel_meshes[str(where[1])].gears[1]].geometry
        return 0.5 * gear.d_m * math.cos(gear.alpha_t)
    return 0.0


def _link(path: _Path, value: float) -> TorqueLink:
    bodies = tuple(body for body, _ in path.ends)
    return TorqueLink(path.place, bodies, tuple(factor * value for _, factor in path.ends))


def _trains(count: int, paths: list[_Path], outer: list[tuple[External, Array]]) -> list[_Train]:
    """Sets of spins that links or unknown external torques connect; given torques act on each of them."""
    groups: list[set[int]] = [{s} for s in range(count)]
    for row in [*(p.row for p in paths), *(row for one, row in outer if one.torque is None)]:
        touched = set(np.flatnonzero(row).tolist())
        if touched:
            joined = [g for g in groups if g & touched]
            groups = [g for g in groups if not g & touched] + [set().union(*joined)]
    found = [_Train(sorted(group)) for group in sorted(groups, key=min)]
    of = {s: train for train in found for s in train.spins}
    for path in paths:
        of[int(np.flatnonzero(path.row)[0])].paths.append(path)
    for one, row in outer:
        for train in {id(t): t for t in (of[int(s)] for s in np.flatnonzero(row))}.values():
            train.outer.append((one, row))
    return found


@dataclass
class _Found:
    """Torques of one train."""

    paths: list[float]
    outer: dict[Place, float]
    left: tuple[int, float | None] | None = None
    undetermined: tuple[Place, ...] = ()
    shared: tuple[str, ...] = ()


def _solve(train: _Train) -> _Found | None:
    """Torques of one train; None without external torques, given or unknown."""
    unknown = [(one, row) for one, row in train.outer if one.torque is None]
    given = [(one, row) for one, row in train.outer if one.torque]
    if not train.outer:
        return None
    # columns are torques over their lever, in N, with rows of unit length
    levers = np.array([p.lever for p in train.paths])
    typical = float(np.median(levers[levers > 0.0])) if np.any(levers > 0.0) else 1.0
    scale = np.array([*np.where(levers > 0.0, levers, typical), *[typical] * len(unknown)])
    rows = [*(p.row for p in train.paths), *(row for _, row in unknown)]
    load = np.zeros(len(train.spins))
    for one, row in given:
        load += float(one.torque or 0.0) * row[train.spins]
    if not rows:
        return _Found([], {}, left=_left(train, load, load) if load.any() else None)
    A = np.array(rows)[:, train.spins].T * scale
    x, free = _least(A, -load, levers)
    rest = A @ x + load
    size = float(np.abs(A * x).max(initial=0.0)) + float(np.abs(load).max())
    nothing = [math.nan] * len(train.paths)
    if float(np.abs(rest).max()) > SAME * size:
        return _Found(nothing, {one.name: math.nan for one, _ in unknown}, left=_left(train, rest, load))
    n = len(train.paths)
    loose = [
        one.name
        for (one, _), row in zip(unknown, free[n:], strict=True)
        if np.abs(row).max(initial=0.0) > SAME
    ]
    values = x * scale
    outer = {one.name: float(value) for (one, _), value in zip(unknown, values[n:], strict=True)}
    if loose:
        outer |= dict.fromkeys(loose, math.nan)
        touched = _moved(free)
        inner = [math.nan if touched[k] else float(values[k]) for k in range(n)]
        return _Found(inner, outer, undetermined=tuple(loose))
    shared = tuple(
        str(p.place[1])
        for p, row in zip(train.paths, free, strict=False)
        if np.abs(row).max(initial=0.0) > SAME
    )
    return _Found([float(v) for v in values[:n]], outer, shared=shared)


def _moved(free: Array) -> NDArray[np.bool_]:
    return np.asarray(np.abs(free).max(axis=1, initial=0.0) > SAME)


def _least(A: Array, b: Array, levers: Array) -> tuple[Array, Array]:
    """Solution of A x = b with the smallest tooth forces, of these the smallest one, and the null space of
    A."""
    U, sizes, V = np.linalg.svd(A)
    rank = int(np.sum(sizes > SAME * sizes.max()))
    x = V[:rank].T @ ((U[:, :rank].T @ b) / sizes[:rank])
    free = V[rank:].T
    if free.shape[1]:
        toothed = np.flatnonzero(levers > 0.0)
        # rounding errors of a null space without tooth forces count as none
        held = np.where(np.abs(free[toothed]) > SAME, free[toothed], 0.0)
        x = x - free @ (np.linalg.pinv(held, rcond=SAME) @ x[toothed])
    x[np.abs(x) < ROUND_OFF * np.abs(x).max(initial=0.0)] = 0.0
    return x, free


def _left(train: _Train, rest: Array, load: Array) -> tuple[int, float | None]:
    """Number of the most loaded spin, and the torque on it that would balance the train [N m].

    With one free motion, the torques `rest` left over are proportional to its speeds w, and the missing
    torque M has the power M w_k = -rest w. With several free motions no single torque balances the train.
    """
    k = int(np.argmax(np.abs(load) * (np.abs(rest) > SAME * np.abs(rest).max())))
    rows = [p.row[train.spins] for p in train.paths]
    rank = int(np.linalg.matrix_rank(np.array(rows), tol=SAME)) if rows else 0
    return k, -float(rest @ rest) / float(rest[k]) if len(train.spins) - rank == 1 else None
