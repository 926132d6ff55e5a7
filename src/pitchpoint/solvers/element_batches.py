# SPDX-License-Identifier: Apache-2.0
"""Batches of elements without common coordinates, for simultaneous evaluation, and their matrix blocks."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import registry
from pitchpoint.elements.kind import EVERYWHERE, FORCE, SIGNAL, SINGLE, TORQUE
from pitchpoint.solvers.element_tangents import Share, tangents
from pitchpoint.solvers.null_space import connected
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Block:
    """Blocks of an element in a block matrix.

    Parameters
    ----------
    nodes
        Indices of its nodes.
    pairs, places
        Pairs of nodes with a block, and the indices of these blocks.
    """

    nodes: frozenset[int]
    pairs: tuple[tuple[int, int], ...]
    places: NDArray[np.int64]


def blocks_of(system: System, kind: str, k: int) -> Block:
    """Matrix blocks of one element: those of its bodies and of the bodies they are mounted on."""
    layout = system.layout
    # signals depend on bodies that are not fields of their records
    if registry.find(kind).role == SIGNAL or not _bodies(system, kind, k):
        nodes = frozenset(layout.node_of) - {-1}
        pairs = tuple(layout.blocks)
    else:
        bodies = {b for body in _bodies(system, kind, k) for b in _movers(system, body)}
        nodes = frozenset(layout.node_of[b] for b in bodies) - {-1}
        pairs = tuple((i, j) for i, j in product(sorted(nodes), sorted(nodes)) if (i, j) in layout.blocks)
    return Block(nodes, pairs, np.array([layout.blocks[pair] for pair in pairs], np.int64))


def independent_batches(elements: Sequence[int], touched: Sequence[Collection[int]]) -> list[list[int]]:
    """Divide elements into batches without common nodes: each joins the first batch without conflict.

    Examples
    --------
    >>> independent_batches([5, 6, 7], [{1, 2}, {2, 3}, {3, 4}])
    [[5, 7], [6]]
    """
    batches: list[list[int]] = []
    used: list[set[int]] = []
    for element, own in zip(elements, touched, strict=True):
        for batch, taken in zip(batches, used, strict=True):
            if taken.isdisjoint(own):
                batch.append(element)
                taken.update(own)
                break
        else:
            batches.append([element])
            used.append(set(own))
    return batches


def machines_of(system: System) -> NDArray[np.int64]:
    """Index of the machine of every body; different machines are not connected by any element.

    Ground is 0. Damping of the whole model is ignored: it acts on speeds only.
    """
    body = system.program["body"]
    rows = [{b: 1.0, int(body[b]["parent"]): 1.0} for b in range(1, len(body)) if body[b]["parent"]]
    rows += [{b: 1.0, int(body[b]["spinner"]): 1.0} for b in range(1, len(body)) if body[b]["spinner"]]
    for kind, records in system.records.items():
        described = registry.find(kind)
        if described.scope == EVERYWHERE:
            continue
        if described.role == SIGNAL:
            rows.append(dict.fromkeys(range(1, len(body)), 1.0))
        rows += [dict.fromkeys(own, 1.0) for k in range(len(records)) if (own := _bodies(system, kind, k))]
    found = np.zeros(len(body), np.int64)
    for number, members in enumerate(connected(rows, range(1, len(body))), start=1):
        found[members] = number
    return found


def free_flying(system: System, loaded: bool = False) -> NDArray[np.int64]:
    """Coordinates of bodies that are mounted on no other, carry none and are connected to none.

    Without `loaded`, only of those on which no gravity, force or torque acts either.
    """
    body = system.program["body"]
    mounted = (body["parent"] > 0) | (body["spinner"] > 0)
    touched = {0, *np.flatnonzero(mounted).tolist(), *body["parent"].tolist(), *body["spinner"].tolist()}
    for kind, records in system.records.items():
        described = registry.find(kind)
        load = described.scope == SINGLE or described.role in (FORCE, TORQUE)
        if described.scope != EVERYWHERE and not (load and loaded):
            touched.update(*(records[end].tolist() for end in described.ends))
    alone = [record for b, record in enumerate(body) if b not in touched]
    return np.array([d for r in alone for d in range(int(r["dof"]), int(r["dof"] + r["n"]))], np.int64)


def stiffness_by_element(
    system: System, state: State, elements: Sequence[tuple[str, int]]
) -> Iterator[tuple[Block, Array, Array]]:
    """Yield blocks, damping and stiffness of each element, given by kind and record index.

    Damping and stiffness have the shape (number of blocks, 6, 6).
    """
    blocks = [blocks_of(system, kind, k) for kind, k in elements]
    found: dict[int, tuple[Array, Array]] = {}
    for batch in independent_batches(range(len(elements)), [b.nodes for b in blocks]):
        rows: dict[str, list[int]] = {}
        for e in batch:
            rows.setdefault(elements[e][0], []).append(elements[e][1])
        D, K = tangents(system, state, {kind: np.array(own, np.int64) for kind, own in rows.items()})
        for e in batch:
            found[e] = D[blocks[e].places], K[blocks[e].places]
    for e, own in enumerate(blocks):
        yield (own, *found[e])


def share_of_blocks(system: System, block: Block, values: Array) -> Share:
    """Reduce the blocks of an element to the coordinates with non-zero entries."""
    layout = system.layout
    nodes = sorted(block.nodes)
    sizes = [layout.node_size[n] for n in nodes]
    at = dict(zip(nodes, np.cumsum([0, *sizes])[:-1].tolist(), strict=True))
    places = np.array([layout.node_dof[n] + k for n in nodes for k in range(layout.node_size[n])], np.int64)
    whole = np.zeros((places.size, places.size))
    for (i, j), value in zip(block.pairs, values, strict=True):
        n, m = layout.node_size[i], layout.node_size[j]
        whole[at[i] : at[i] + n, at[j] : at[j] + m] = value[:n, :m]
    used = np.flatnonzero(np.any(whole != 0.0, axis=0) | np.any(whole != 0.0, axis=1))
    return Share(places[used], whole[np.ix_(used, used)])


def _bodies(system: System, kind: str, k: int) -> set[int]:
    """Bodies of a record, without ground."""
    records = system.records[kind]
    return {int(records[k][field]) for field in registry.find(kind).ends} - {0}


def _movers(system: System, b: int) -> set[int]:
    """A body, the bodies it is mounted on, and the bodies whose spins these share."""
    body = system.program["body"]
    found: set[int] = set()
    waiting = [b]
    while waiting:
        b = waiting.pop()
        if b and b not in found:
            found.add(b)
            waiting += [int(body[b]["parent"]), int(body[b]["spinner"])]
    return found
