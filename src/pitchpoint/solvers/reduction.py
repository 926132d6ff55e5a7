# SPDX-License-Identifier: Apache-2.0
"""Reduced systems: linear parts condensed about an operating point, meshes and other laws kept as they are.

Bodies that only linear elements touch (bearings, bushings, couplings, beams) are condensed onto the bodies
that anything else acts on, by static shapes and by modes with those bodies fixed (Craig and Bampton). What is
kept runs with its own kernels, large rotation included; the condensed part is a linear element between the
bodies that remain and a few modal coordinates, gyroscopic terms taken at the operating speed.

References
----------
.. [1] R. R. Craig, M. C. C. Bampton: Coupling of substructures for dynamic analyses, AIAA Journal 6 (1968)
   1313-1319.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.elements import coupling, linear_part, registry
from pitchpoint.model.scenario import Scenario
from pitchpoint.multibody.bodies import GENERAL, TORSION, Body
from pitchpoint.solvers.controls import refuse_loads
from pitchpoint.solvers.eigen import symmetric, undamped
from pitchpoint.solvers.element_tangents import element_names, switched
from pitchpoint.solvers.operating_point import operating_point
from pitchpoint.solvers.reduction_error import ReductionError, compare
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System, assemble

Array = NDArray[np.float64]
Choice = dict[str, NDArray[np.int64]]

LINEAR = ("beam", "bearing", "bushing", "coupling", "damping", "gravity", "shaft_beam")
"""Kinds that are condensed if nothing else acts on one of their bodies."""
BEYOND = 4.0
"""Fixed-interface modes are kept up to this multiple of the highest frequency of interest: for geared shafts
natural frequencies below it then err by less than 0.1 % (by 0.2 % with a multiple of 2)."""
TURNS = 1e-7
"""Stiffness against a rotation of a whole shaft, over the largest, that counts as rounding."""


@dataclass(frozen=True)
class Reduced:
    """A reduced system.

    Parameters
    ----------
    system
        The system: bodies that were kept, modal coordinates as bodies `PART.mode1` ...
    state
        The operating point in its coordinates.
    full, full_state
        The system with everything in it and its operating point.
    error
        How far it is off, up to the highest frequency of interest.
    """

    system: System
    state: State
    full: System
    full_state: State
    error: ReductionError


@dataclass(frozen=True)
class Part:
    """A condensed part: its coordinates (the first `outer` stay), their shapes, and which body has which."""

    places: NDArray[np.int64]
    T: Array
    outer: int
    blocks: tuple[tuple[int, NDArray[np.int64]], ...]


def reduce_system(
    system: System,
    scenario: Scenario | str | None = None,
    *,
    limit: float,
    keep: Sequence[str] = (),
    start: State | None = None,
) -> Reduced:
    """Condense the linear parts of a system about an operating point.

    Parameters
    ----------
    system
        The compiled system.
    scenario, start
        Give the operating point, as in `modal.find_modes`.
    limit
        Highest frequency of interest [Hz].
    keep
        Names of bodies that stay, and of elements ("KIND NAME") that stay as they are.

    Returns
    -------
    Reduced

    Raises
    ------
    SolverError
        If a name is not known or there is no equilibrium.
    """
    refuse_loads(system, "a reduced system")
    point = operating_point(system, scenario, start)
    own, state = point.system, point.state
    condensed = _condensed(own, keep)
    kept = _kept_bodies(own, condensed, keep)
    condensed = _choose(own, condensed, kept)
    M, D, K, f = _matrices(own, state, condensed, kept)
    parts = _parts(own, condensed)
    number = {b: k for k, b in enumerate(kept, start=1)}
    number[0] = 0
    bodies = [replace(own.bodies[b - 1], parent=number[own.bodies[b - 1].parent]) for b in kept]
    bodies = [replace(b, name=own.layout.bodies[k]) for b, k in zip(bodies, kept, strict=True)]
    rows: dict[str, list[NDArray[np.void]]] = {"linear_part": [], "linear_modes": [], "coupling": []}
    blocks = []
    for p, part in enumerate(parts):
        inner = [b for b in part if b not in number]
        ends = [b for b in part if b in number]
        blocks.append(
            _condense(own, state, (M, D, K, f), (ends, inner), limit, f"part{p + 1}", number, bodies, rows)
        )
    _damp_across(D, state, blocks, rows["linear_modes"])
    found = _assembled(own, condensed, number, bodies, rows)
    begun = _state_of(own, state, found, kept)
    return Reduced(found, begun, own, state, compare(own, state, found, begun, limit))


def _condensed(system: System, keep: Sequence[str]) -> Choice:
    """Records of linear elements between round bodies on ground that nobody wants to keep."""
    body = system.program["body"]
    found: Choice = {}
    labels = [f"{kind} {name}" for kind in system.records for name in element_names(system, kind)]
    unknown = [name for name in keep if name not in labels and name not in system.layout.bodies]
    if unknown:
        raise SolverError(f"nothing to keep is called {', '.join(unknown)}", INCONSISTENT)
    joined: set[int] = set()
    for kind in sorted(LINEAR, key=lambda k: k == "damping"):  # last: of bodies that others join
        if kind not in system.records:
            continue
        if kind == "damping":
            joined = {b for part in _parts(system, found) for b in part}
        names = element_names(system, kind)
        chosen = []
        for k, record in enumerate(system.records[kind]):
            ends = [int(record[e]) for e in ("i", "j")]
            round_ = all(b == 0 or body[b]["joint"] != GENERAL for b in ends)
            turns = kind != "bearing" or 0 not in ends or record["K"][5, 5] == 0.0
            straight = kind != "coupling" or (record["gap"] == 0.0 and record["form"] == 0)
            if kind == "damping" and round_:
                round_ = all(b in joined for b in ends)
            if round_ and turns and straight and f"{kind} {names[k]}" not in keep:
                chosen.append(k)
        found[kind] = np.array(chosen, np.int64)
    return found


def _kept_bodies(system: System, condensed: Choice, keep: Sequence[str]) -> list[int]:
    """Bodies that anything but a condensed element acts on, or that carry others."""
    body = system.program["body"]
    kept = {system.layout.bodies.index(name) for name in keep if name in system.layout.bodies}
    kept |= {b for b in range(1, body.size) if body[b]["joint"] == GENERAL or body[b]["n"] == 0}
    kept |= {int(r["parent"]) for r in body[1:]}
    for kind, bank in system.records.items():
        if kind == "gravity":
            continue
        rest = np.setdiff1d(np.arange(bank.size), condensed.get(kind, np.zeros(0, np.int64)))
        for field in {f for pair in registry.find(kind).pairs for f in pair}:
            kept |= {int(b) for b in bank[field][rest]}
    parts = _parts(system, condensed)
    kept |= set(range(1, body.size)) - {b for part in parts for b in part}
    for part in parts:
        if not kept & set(part):
            kept.add(part[0])  # a part that nothing else touches stays as one body and its modes
    return sorted(kept - {0})


def _choose(system: System, condensed: Choice, kept: Sequence[int]) -> Choice:
    """Weights of bodies that are kept stay with them."""
    if "gravity" not in condensed:
        return condensed
    bank = system.records["gravity"]
    return {**condensed, "gravity": np.flatnonzero(~np.isin(bank["i"], kept))}


def _parts(system: System, condensed: Choice) -> list[list[int]]:
    """Bodies that condensed elements join, ground apart."""
    group = {b: {b} for b in range(1, system.sizes["nb"])}
    used: set[int] = set()
    for kind, chosen in condensed.items():
        for record in system.records[kind][chosen]:
            ends = [int(record[e]) for e in ("i", "j") if int(record[e])]
            used |= set(ends) if kind not in ("gravity", "damping") else set()
            if len(ends) == 2 and ends[0] != ends[1] and kind != "damping":
                whole = group[ends[0]] | group[ends[1]]
                for b in whole:
                    group[b] = whole
    found = {min(group[b]): sorted(group[b]) for b in used}
    return [found[b] for b in sorted(found)]


def _sum_over(system: System, condensed: Choice, ask: Callable[[], Array]) -> tuple[Array, Array]:
    """What all condensed records add to what `ask` gives, and what it gives without any element."""
    runs = {
        kind: [(int(r[0]), int(r[-1]) + 1) for r in np.split(k, np.flatnonzero(np.diff(k) > 1) + 1) if r.size]
        for kind, k in condensed.items()
    }
    with switched(system, {}):
        bare = ask()
    total = np.zeros_like(bare)
    for n in range(max((len(r) for r in runs.values()), default=0)):
        with switched(system, {kind: slice(*r[n]) for kind, r in runs.items() if n < len(r)}):
            total += ask() - bare
    return total, bare


def _matrices(
    system: System, state: State, condensed: Choice, kept: Sequence[int]
) -> tuple[Array, Array, Array, Array]:
    """M, D, K and residual of the condensed elements and of the bodies that go."""
    body = system.program["body"]
    gone = np.ones(system.sizes["nd"], bool)
    for b in kept:
        gone[body[b]["dof"] : body[b]["dof"] + body[b]["n"]] = False
    found = []
    for factors in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)):
        more, bare = _sum_over(
            system,
            condensed,
            lambda f=factors: evaluate.matrix(system, state, *f),  # type: ignore[misc]
        )
        found.append(more + np.where(np.outer(gone, gone), bare, 0.0))
    still = state.copy()
    still.a[:] = 0.0
    still.lam[:] = 0.0
    more, bare = _sum_over(system, condensed, lambda: evaluate.residual(system, still))
    return found[0], found[1], found[2], more + np.where(gone, bare, 0.0)


def _places(system: System, bodies: Sequence[int]) -> list[int]:
    """Coordinates of bodies."""
    body = system.program["body"]
    return [int(body[b]["dof"]) + k for b in bodies for k in range(int(body[b]["n"]))]


def _condense(
    system: System,
    state: State,
    matrices: tuple[Array, Array, Array, Array],
    sides: tuple[list[int], list[int]],
    limit: float,
    name: str,
    number: dict[int, int],
    bodies: list[Body],
    rows: dict[str, list[NDArray[np.void]]],
) -> Part:
    """Condense one part: append its modal bodies and its records."""
    ends, inner = sides
    M, D, K, f = matrices
    outer, hidden = _places(system, ends), _places(system, inner)
    body = system.program["body"]
    phi = np.zeros((len(hidden), 0))
    omega = np.zeros(0)
    static: Array = np.zeros((len(hidden), len(outer)))
    if hidden:
        k = symmetric(K[np.ix_(hidden, hidden)])
        static = np.asarray(-np.linalg.solve(k, symmetric(K)[np.ix_(hidden, outer)]))
        squares, shapes = undamped(
            M[np.ix_(hidden, hidden)], k, np.eye(len(hidden)), np.zeros((0, len(hidden)))
        )
        modes = int(np.sum(squares < BEYOND * 2.0 * np.pi * limit))
        omega, phi = squares[:modes], shapes[:modes].T
    n = len(outer)
    T = np.block([[np.eye(n), np.zeros((n, omega.size))], [static, phi]])
    places = [*outer, *hidden]
    m, d, stiff = (T.T @ A[np.ix_(places, places)] @ T for A in (M, D, K))
    force = T.T @ f[places]
    turning = np.array([float(c in set(body["spin"])) for c in outer] + [0.0] * omega.size)
    left = stiff @ turning
    if np.abs(left).max(initial=0.0) > TURNS * np.abs(stiff).max(initial=0.0):
        names = ", ".join(system.layout.bodies[b] for b in ends)
        why = "their axes are not parallel, or springs hold them"
        raise SolverError(f"{names}: do not turn together freely: {why}", INCONSISTENT)
    if turning.any():
        stiff -= np.outer(left, turning) / turning.sum()  # rounding: turning together costs nothing
    first = len(bodies) + 1
    for j, w in enumerate(omega):
        # inertia one, the spring as a coupling to ground: it is held like any torsional body
        bodies.append(Body(motion=TORSION, polar_inertia=1.0, name=f"{name}.mode{j + 1}"))
        row = np.zeros(1, coupling.RECORD)
        row["i"], row["k"] = first + j, w * w
        rows["coupling"].append(row)
        m[n + j, n + j] -= 1.0
        stiff[n + j, n + j] -= w * w
    blocks = [(number[b], np.array([outer.index(c) for c in _places(system, [b])], np.int64)) for b in ends]
    blocks += [(first + j, np.array([n + j])) for j in range(omega.size)]
    least = [1e-13 * np.abs(A).max(initial=0.0) for A in (m, d, stiff)]
    for one, (i, at) in enumerate(blocks):
        for two, (j, by) in enumerate(blocks):
            cut = [A[np.ix_(at, by)] for A in (m, d, stiff)]
            if one != two and all(np.abs(c).max(initial=0.0) <= s for c, s in zip(cut, least, strict=True)):
                continue
            row = np.zeros(1, linear_part.RECORD)
            r = row[0]
            r["i"], r["j"] = i, j
            for field, c in zip("MDK", cut, strict=True):
                r[field][: at.size, : by.size] = c
            if one == two:
                r["f0"][: at.size] = force[at]
            if two < len(ends):
                _refer(r, system, state, ends[two], ends[one] if one < len(ends) else 0)
            physical = one < len(ends) and two < len(ends)
            if one >= len(ends) and two < len(ends):
                r["K"][:] = 0.0  # static shapes do not stress the fixed modes
            rows["linear_part" if physical else "linear_modes"].append(row)
    return Part(np.array(places, np.int64), T, n, tuple(blocks))


def _damp_across(D: Array, state: State, parts: Sequence[Part], rows: list[NDArray[np.void]]) -> None:
    """Damping between parts, such as that of modal damping ratios."""
    for p in parts:
        for q in parts:
            whole = D[np.ix_(p.places, q.places)]
            if p is q or not whole.any():
                continue
            d = p.T.T @ whole @ q.T
            rates = np.concatenate([state.v[q.places[: q.outer]], np.zeros(q.T.shape[1] - q.outer)])
            for i, at in p.blocks:
                for j, by in q.blocks:
                    row = np.zeros(1, linear_part.RECORD)
                    row["i"], row["j"] = i, j
                    row["D"][0, : at.size, : by.size] = d[np.ix_(at, by)]
                    row["v0"][0, : by.size] = rates[by]
                    rows.append(row)


def _refer(record: np.void, system: System, state: State, j: int, i: int) -> None:
    """Write where body j is at the operating point, and the spin of body i against which it counts."""
    body = system.program["body"]
    dof, n = int(body[j]["dof"]), int(body[j]["n"])
    record["x0"][:n], record["v0"][:n] = state.q[dof : dof + n], state.v[dof : dof + n]
    spin = int(body[j]["spin"])
    if spin >= 0:
        record["x0"][spin - dof] += 2.0 * np.pi * state.turns[j]
    if i and spin >= 0 and body[i]["spin"] >= 0:
        record["relative"] = 1
        record["spin0"] = state.q[body[i]["spin"]] + 2.0 * np.pi * state.turns[i]


def _assembled(
    system: System,
    condensed: Choice,
    number: dict[int, int],
    bodies: list[Body],
    rows: dict[str, list[NDArray[np.void]]],
) -> System:
    """Put bodies, kept elements and condensed parts together."""
    banks: dict[str, NDArray[np.void]] = {}
    names: dict[str, list[str]] = {}
    laws = {}
    for kind, bank in system.records.items():
        rest = np.setdiff1d(np.arange(bank.size), condensed.get(kind, np.zeros(0, np.int64)))
        kept = bank[rest].copy()
        for field in {f for pair in registry.find(kind).pairs for f in pair}:
            kept[field] = [number[int(b)] for b in kept[field]]
        banks[kind] = kept
        names[kind] = [element_names(system, kind)[k] for k in rest]
        if kind in system.laws:
            laws[kind] = [system.laws[kind][k] for k in rest]
    for kind, more in rows.items():
        if more:
            names[kind] = [*names.get(kind, ()), *(f"condensed{k + 1}" for k in range(len(more)))]
            banks[kind] = np.concatenate([*([banks[kind]] if kind in banks else []), *more])
    constraints = {k: b for k, b in banks.items() if registry.find(k).channel == registry.CONSTRAINT}
    others = {k: b for k, b in banks.items() if k not in constraints and b.size}
    own = assemble(bodies, others, constraints, names=names, pools=system.pools, laws=laws, keep=system.keep)
    return replace(own, controllers=system.controllers)


def _state_of(system: System, state: State, found: System, kept: Sequence[int]) -> State:
    """The operating point in the coordinates that are left; modal coordinates are zero."""
    begun = found.initial_state()
    begun.t = state.t
    for new, old in enumerate(kept, start=1):
        a, b = found.program["body"][new], system.program["body"][old]
        n = int(a["n"])
        begun.q[a["dof"] : a["dof"] + n] = state.q[b["dof"] : b["dof"] + n]
        begun.v[a["dof"] : a["dof"] + n] = state.v[b["dof"] : b["dof"] + n]
        begun.turns[new] = state.turns[old]
    if begun.lam.size == state.lam.size:
        begun.lam[:] = state.lam
    return begun
