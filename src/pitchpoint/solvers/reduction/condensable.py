# SPDX-License-Identifier: Apache-2.0
"""What of a system may be condensed: elements and bodies whose linearisation does not change over time.

A body goes if nothing acts on it, or on what hangs on it, but linear elements and weight, and if its place in
the equations of motion is the same at all times: its masses and these elements are evaluated at the operating
point and where the steady rotation has taken it a while later. Bodies at rest pass, round shafts pass as
their coordinates do not spin, an arm on a shaft that only spins passes, one on a shaft in bearings does not.
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
"""Eigenvalue of a stiffness with ones on its diagonal below which a motion is not held."""
LEAD = 1e-3
"""Share in such a motion from which a body takes part in it."""


@dataclass(frozen=True)
class Split:
    """What is condensed and what stays.

    Parameters
    ----------
    condensed
        Records by kind.
    kept
        Bodies that stay.
    parts
        Bodies of every condensed part, those that stay among them.
    notes
        What stays though it might have gone, in sentences.
    reasons
        Why each of the kept bodies stays.
    """

    condensed: Choice
    kept: list[int]
    parts: list[list[int]]
    notes: tuple[str, ...]
    reasons: tuple[str, ...]


def split_up(system: System, state: State, keep: Sequence[str]) -> Split:
    """Decide what goes; `keep` names bodies and elements ("KIND NAME") that stay."""
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
            notes.append(f"{kind.replace('_', ' ')} {which} is kept: it does not act alike at all times")
        moving = sorted(set(moving) - set(_kept(system, eligible, forced)))
        if moving:
            notes.append(f"kept as their inertia changes over time: {', '.join(names[b] for b in moving)}")
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
            notes.append(f"kept as no spring of their part holds them: {', '.join(names[b] for b in loose)}")
        forced |= dict.fromkeys(lone, "nothing to be condensed with")
        forced |= dict.fromkeys(alone, "first of a part that nothing else keeps")
        forced |= dict.fromkeys(loose, "no spring of its part holds it")


def names_to_keep(system: System) -> tuple[str, ...]:
    """What may be asked to stay: bodies, and elements as "KIND NAME"."""
    elements = [f"{kind} {name}" for kind in system.records for name in element_names(system, kind)]
    return (*system.layout.bodies[1:], *elements)


def _linear_records(system: System, keep: Sequence[str]) -> Choice:
    """Records of linear elements that need not be kept."""
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
    """Bodies that functions move, what hangs on them, and states of elements, with the reason."""
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
            found[b] = f"hangs on {elastic[0]}"
        elif body[b]["state"] == 1:
            found[b] = "state of an element"
        elif any(body[c]["guide"] >= 0 or body[c]["shares"] for c in path):
            found[b] = "moved by functions"
    for b in range(1, body.size):
        if body[b]["shares"]:
            found.setdefault(int(body[b]["shares"]), "moved by functions")
    return found


def _rotors(system: System) -> dict[int, str]:
    """Elastic bodies with a spin: number of the frame and name."""
    frames = {int(record["i"]): name for name, record, _ in elastic_records(system)}
    return {b: name for b, name in frames.items() if system.program["body"][b]["spin"] >= 0}


def _rotor_notes(system: System, eligible: Choice) -> list[str]:
    """Take out the elements on elastic rotors, whose coordinates turn with them, and note it."""
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
    which = f", so do what hangs on them and {', '.join(kept)}" if kept else ", so does what hangs on them"
    return [
        f"elastic rotors stay as they are, as their modes turn with them: {', '.join(rotors.values())}{which}"
    ]


def _ancestors(body: NDArray[np.void], b: int) -> list[int]:
    """Bodies on the way from a body to ground, without both."""
    found = []
    b = int(body[b]["parent"])
    while b:
        found.append(b)
        b = int(body[b]["parent"])
    return found


def _kept(system: System, eligible: Choice, forced: dict[int, str]) -> dict[int, str]:
    """Bodies that anything but a linear element acts on, those forced to stay, and what carries them: why."""
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
    """Linear elements that are condensed: on bodies that go, and between round ones, where it costs nothing.

    What ties two bodies of a mechanism that both stay keeps its own kernel, large motion included.
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
        # of all coordinates: it goes with the bodies that others join
        joined = {b for part in _parts(system, found, kept) for b in part}
        bank = system.records[kind]
        found[kind] = np.array(
            [k for k in eligible[kind] if {int(bank[k]["i"]), int(bank[k]["j"])} <= joined], np.int64
        )
    return found


def _movers(body: NDArray[np.void], b: int) -> list[int]:
    """Bodies whose coordinates move a body, its own first; shared ones are those of the owner."""
    return [int(body[c]["shares"]) or c for c in (b, *_ancestors(body, b))]


def _parts(system: System, condensed: Choice, kept: set[int]) -> list[list[int]]:
    """Bodies that condensed elements join, or joints with a body that goes; ground apart.

    What carries the end of an element, or gives it its coordinates, moves that end: it is one of the part.
    """
    body = system.program["body"]
    group = {b: {b} for b in range(1, system.sizes["nb"])}
    used: set[int] = set()

    def join(one: int, two: int) -> None:
        """Put two bodies and all that goes with them into one group."""
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
    """Bodies that could move while the kept ones of their part are at rest."""
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
    """Coordinates of bodies."""
    body = system.program["body"]
    return [int(body[b]["dof"]) + k for b in bodies for k in range(int(body[b]["n"]))]


def sum_over(system: System, condensed: Choice, request: Callable[[], Array]) -> Array:
    """What `request` gives with the condensed records alone, all bodies in place."""
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
