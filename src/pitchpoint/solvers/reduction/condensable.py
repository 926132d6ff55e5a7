# SPDX-License-Identifier: Apache-2.0
"""Selection of the elements and bodies that can be condensed: those with a time-invariant linearisation.

A body is condensed if only linear elements and weight act on it and on the bodies mounted on it, and if its
equations of motion are time-invariant: its masses and these elements are compared at the operating point and
after some steady rotation. This holds for bodies at rest, for round shafts, whose coordinates do not rotate,
and for an arm on a shaft that only rotates, but not for an arm on a shaft in bearings.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.elements import registry
from pitchpoint.elements.kind import BETWEEN, EVERYWHERE, SINGLE
from pitchpoint.multibody.bodies import GENERAL
from pitchpoint.solvers.eigen import symmetric
from pitchpoint.solvers.element_tangents import element_names, switched
from pitchpoint.solvers.position_dependence import changing, ways_to_turn
from pitchpoint.system import evaluate
from pitchpoint.system.elastic import elastic_records
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]
Choice = dict[str, NDArray[np.int64]]

LOOSE = 1e-9
"""Eigenvalue of a stiffness scaled to a unit diagonal below which a motion is unconstrained."""
LEAD = 1e-3
"""Amplitude from which a body counts as moving in such a motion."""


@dataclass(frozen=True)
class Split:
    """Partition into condensed and retained bodies and elements.

    Parameters
    ----------
    condensed
        Condensed records by kind.
    kept
        Retained bodies.
    parts
        Bodies of every condensed part, including the retained ones.
    notes
        Notes on bodies and elements that are retained unexpectedly.
    reasons
        Why each of the retained bodies is retained.
    """

    condensed: Choice
    kept: list[int]
    parts: list[list[int]]
    notes: tuple[str, ...]
    reasons: tuple[str, ...]


def split_up(system: System, state: State, keep: Sequence[str]) -> Split:
    """Select what is condensed; `keep`: names of bodies and elements ("KIND NAME") to retain."""
    names = system.layout.bodies
    known = names_to_keep(system)
    unknown = [name for name in keep if name not in known]
    if unknown:
        raise SolverError(f"nothing to keep is called {', '.join(unknown)}", INCONSISTENT)
    eligible = _linear_records(system, keep)
    notes = _rotor_notes(system, eligible)
    forced = {names.index(n): "requested" for n in keep if n in names} | _never(system)
    stays = _kept(system, eligible, forced)
    rates = ways_to_turn(system, state, stays)
    if rates.any():
        elements, moving = changing(system, state, eligible, rates)
        for kind, rows in elements.items():
            eligible[kind] = np.setdiff1d(eligible[kind], rows)
            which = ", ".join(element_names(system, kind)[k] for k in rows)
            notes.append(f"{kind.replace('_', ' ')} {which} is kept: its linearisation changes over time")
        moving = sorted(set(moving) - set(_kept(system, eligible, forced)))
        if moving:
            notes.append(f"kept because their inertia changes: {', '.join(names[b] for b in moving)}")
        forced |= dict.fromkeys(moving, "inertia that changes over time")
    while True:
        why = _kept(system, eligible, forced)
        kept = set(why)
        condensed = _used(system, eligible, kept)
        parts = _parts(system, condensed, kept)
        lone = [b for b in range(1, len(names)) if b not in kept and not any(b in part for part in parts)]
        alone = [part[0] for part in parts if not kept & set(part)]
        loose = [] if lone or alone else _loose(system, state, condensed, parts, kept)
        if not (lone or alone or loose):
            order = sorted(kept)
            return Split(condensed, order, parts, tuple(notes), tuple(why[b] for b in order))
        if loose:
            which = ", ".join(names[b] for b in loose)
            notes.append(f"kept because no spring of their part constrains them: {which}")
        forced |= dict.fromkeys(lone, "not connected to a condensed part")
        forced |= dict.fromkeys(alone, "reference of a part without other kept bodies")
        forced |= dict.fromkeys(loose, "no spring of its part constrains it")


def names_to_keep(system: System) -> tuple[str, ...]:
    """Valid names to retain: bodies, and elements as "KIND NAME"."""
    elements = [f"{kind} {name}" for kind in system.records for name in element_names(system, kind)]
    return (*system.layout.bodies[1:], *elements)


def _linear_records(system: System, keep: Sequence[str]) -> Choice:
    """Records of linear elements that need not be retained."""
    body = system.program["body"]
    found: Choice = {}
    for kind, records in system.records.items():
        described = registry.find(kind)
        if not described.linear:
            continue
        names = element_names(system, kind)
        chosen = []
        for k, record in enumerate(records):
            spinning = any(b and body[b]["joint"] != GENERAL for b in (int(record[e]) for e in ("i", "j")))
            if described.is_linear(record, spinning) and f"{kind} {names[k]}" not in keep:
                chosen.append(k)
        found[kind] = np.array(chosen, np.int64)
    return found


def _never(system: System) -> dict[int, str]:
    """Bodies that are never condensed, with the reason: elastic, moved by functions, or element states."""
    body = system.program["body"]
    found: dict[int, str] = {}
    for name, record, fields in elastic_records(system):
        modes = {int(record[field]) for field in ("i", *fields)} - {0}
        for b in range(1, body.size):
            if {b, int(body[b]["shares"])} & modes:
                found[b] = f"elastic body {name}"
    for b in range(1, body.size):
        path = [b, *_ancestors(body, b)]
        elastic = [found[c] for c in path if found.get(c, "").startswith("elastic body")]
        if b in found:
            continue
        if elastic:
            found[b] = f"mounted on {elastic[0]}"
        elif body[b]["state"] == 1:
            found[b] = "state of an element"
        elif any(body[c]["guide"] >= 0 or body[c]["shares"] for c in path):
            found[b] = "moved by functions"
    for b in range(1, body.size):
        if body[b]["shares"]:
            found.setdefault(int(body[b]["shares"]), "moved by functions")
    return found


def _rotors(system: System) -> dict[int, str]:
    """Elastic bodies with a spin: body index of the frame, and name."""
    frames = {int(record["i"]): name for name, record, _ in elastic_records(system)}
    return {b: name for b, name in frames.items() if system.program["body"][b]["spin"] >= 0}


def _rotor_notes(system: System, eligible: Choice) -> list[str]:
    """Exclude the elements on elastic rotors, whose coordinates rotate with them; returns the notes."""
    body, rotors = system.program["body"], _rotors(system)
    if not rotors:
        return []
    kept = []
    for kind, rows in eligible.items():
        if registry.find(kind).scope != BETWEEN:
            continue
        on = [
            int(k)
            for k in rows
            if any(
                rotors.keys() & {b, *_ancestors(body, b)}
                for b in (int(system.records[kind][k][end]) for end in ("i", "j"))
            )
        ]
        eligible[kind] = np.setdiff1d(rows, on)
        kept += [f"{kind.replace('_', ' ')} {element_names(system, kind)[k]}" for k in on]
    which = f" and {', '.join(kept)}" if kept else ""
    return [
        f"elastic rotors are kept because their modes rotate with them: {', '.join(rotors.values())}, "
        f"and the bodies mounted on them{which}"
    ]


def _ancestors(body: NDArray[np.void], b: int) -> list[int]:
    """Bodies on the path from a body to ground, without both."""
    found = []
    b = int(body[b]["parent"])
    while b:
        found.append(b)
        b = int(body[b]["parent"])
    return found


def _kept(system: System, eligible: Choice, forced: dict[int, str]) -> dict[int, str]:
    """Retained bodies and the reason: nonlinear elements act on them, forced, or they carry such a body."""
    body, kept = system.program["body"], dict(forced)
    for kind, bank in system.records.items():
        described = registry.find(kind)
        if described.scope == SINGLE:
            continue
        rest = np.setdiff1d(np.arange(bank.size), eligible.get(kind, np.zeros(0, np.int64)))
        names = element_names(system, kind)
        for field in described.ends:
            for k in rest:
                kept.setdefault(int(bank[field][k]), f"{kind.replace('_', ' ')} {names[k]} acts on it")
    kept.pop(0, None)
    for b in sorted(kept):
        for c in _ancestors(body, b):
            kept.setdefault(c, f"carries {system.layout.bodies[b]}")
    return kept


def _used(system: System, eligible: Choice, kept: set[int]) -> Choice:
    """Linear elements that are condensed: those on condensed bodies, and those between round bodies.

    Elements between two retained bodies of a mechanism are evaluated by their own kernels, with large motion.
    """
    body = system.program["body"]
    found: Choice = {}
    for kind, rows in eligible.items():
        chosen = []
        described = registry.find(kind)
        for k in rows:
            ends = [int(system.records[kind][k][e]) for e in ("i", "j")]
            if described.scope == SINGLE:
                ends = ends[:1]
            goes = any(b and b not in kept for b in ends)
            joins = described.scope == BETWEEN and not described.large
            round_ = joins and all(b == 0 or body[b]["joint"] != GENERAL for b in ends)
            if goes or round_:
                chosen.append(int(k))
        found[kind] = np.array(chosen, np.int64)
    for kind in [kind for kind in found if registry.find(kind).scope == EVERYWHERE]:
        # elements on all coordinates: condensed with the bodies of the parts
        joined = {b for part in _parts(system, found, kept) for b in part}
        bank = system.records[kind]
        found[kind] = np.array(
            [k for k in eligible[kind] if {int(bank[k]["i"]), int(bank[k]["j"])} <= joined], np.int64
        )
    return found


def _movers(body: NDArray[np.void], b: int) -> list[int]:
    """Bodies whose coordinates move a body, itself first; for shared coordinates their owner."""
    return [int(body[c]["shares"]) or c for c in (b, *_ancestors(body, b))]


def _parts(system: System, condensed: Choice, kept: set[int]) -> list[list[int]]:
    """Groups of bodies connected by condensed elements, or by joints with a condensed body; without ground.

    Bodies that carry the end of an element, or own its coordinates, belong to the part.
    """
    body = system.program["body"]
    group = {b: {b} for b in range(1, system.sizes["nb"])}
    used: set[int] = set()

    def join(one: int, two: int) -> None:
        """Merge the groups of two bodies."""
        whole = group[one] | group[two]
        for b in whole:
            group[b] = whole

    for b in range(1, body.size):
        carriers = _ancestors(body, b)
        if b not in kept and carriers:
            used |= {b, *carriers}
            for c in carriers:
                join(b, c)
    for kind, chosen in condensed.items():
        if registry.find(kind).scope != BETWEEN:
            continue
        for record in system.records[kind][chosen]:
            ends = [c for e in ("i", "j") if int(record[e]) for c in _movers(body, int(record[e]))]
            used |= set(ends)
            for end in ends[1:]:
                join(ends[0], end)
    found = {min(group[b]): sorted(group[b]) for b in used}
    return [found[b] for b in sorted(found)]


def _loose(
    system: System, state: State, condensed: Choice, parts: Sequence[list[int]], kept: set[int]
) -> list[int]:
    """Bodies with an unconstrained motion while the retained bodies of their part are fixed."""
    K = symmetric(sum_over(system, condensed, lambda: evaluate.matrix(system, state, 0.0, 0.0, 1.0)))
    found: set[int] = set()
    for part in parts:
        hidden = [b for b in part if b not in kept]
        places = coordinates_of(system, hidden)
        if not places:
            continue
        k = K[np.ix_(places, places)]
        size = np.sqrt(np.maximum(np.diag(k), 1e-300))
        values, vectors = np.linalg.eigh(k / np.outer(size, size))
        motions = np.abs(vectors[:, values < LOOSE]).max(axis=1, initial=0.0)
        owner = [b for b in hidden for _ in coordinates_of(system, [b])]
        found |= {b for b, share in zip(owner, motions, strict=True) if share > LEAD}
    return sorted(found)


def coordinates_of(system: System, bodies: Sequence[int]) -> list[int]:
    """Indices of the coordinates of bodies."""
    body = system.program["body"]
    return [int(body[b]["dof"]) + k for b in bodies for k in range(int(body[b]["n"]))]


def sum_over(system: System, condensed: Choice, request: Callable[[], Array]) -> Array:
    """Result of `request` with all bodies, but with the condensed records only."""
    runs = {
        kind: [(int(r[0]), int(r[-1]) + 1) for r in np.split(k, np.flatnonzero(np.diff(k) > 1) + 1) if r.size]
        for kind, k in condensed.items()
    }
    with switched(system, {}):
        bare = request()
    total = bare.copy()
    for n in range(max((len(r) for r in runs.values()), default=0)):
        with switched(system, {kind: slice(*r[n]) for kind, r in runs.items() if n < len(r)}):
            total += request() - bare
    return np.asarray(total)
