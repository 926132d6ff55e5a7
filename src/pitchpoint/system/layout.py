# SPDX-License-Identifier: Apache-2.0
"""Names and indices: which coordinate, block, observation and row belongs to what. Made once per topology."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.multibody.block_lu import plan
from pitchpoint.multibody.bodies import PATH, Body
from pitchpoint.multibody.joints import FREE, JOINTS, TORSION
from pitchpoint.multibody.projection import GENERAL, PROJ, SHAFTS, SPINS

NODE = 6  # most coordinates of one node


@dataclass(frozen=True)
class Channel:
    """One observation or event function: its name as ``quantity[THING]``, unit and meaning."""

    name: str
    unit: str
    long_name: str


@dataclass(frozen=True)
class Layout:
    """Indices of a compiled system.

    Parameters
    ----------
    bodies
        Names of the bodies, ground first.
    coordinates
        Names of the coordinates, ``BODY.joint_coordinate``.
    channels, events
        Observations and event functions in the order of their rows.
    node_of, offset_of
        Node of every body and offset of its first coordinate inside it (-1 for bodies without coordinates).
    blocks
        Block index of every ordered pair of nodes.
    node_dof, node_size
        First coordinate and number of coordinates of every node.
    rows
        Names of the constraint rows.
    """

    bodies: tuple[str, ...]
    coordinates: tuple[str, ...]
    channels: tuple[Channel, ...]
    events: tuple[Channel, ...]
    node_of: tuple[int, ...]
    offset_of: tuple[int, ...]
    blocks: Mapping[tuple[int, int], int]
    node_dof: tuple[int, ...]
    node_size: tuple[int, ...]
    rows: tuple[str, ...]

    def channel(self, name: str) -> int:
        """Index of an observation."""
        return [c.name for c in self.channels].index(name)

    def coordinate(self, name: str) -> int:
        """Index of a coordinate, ``BODY.x`` and the like."""
        return self.coordinates.index(name)


def group(sizes: Sequence[int], edges: set[tuple[int, int]]) -> list[list[int]]:
    """Gather neighbouring bodies into nodes of at most six coordinates.

    Parameters
    ----------
    sizes
        Number of coordinates of each body, ground included.
    edges
        Pairs of bodies that share a tangent.
    """
    near: dict[int, set[int]] = {b: set() for b in range(len(sizes))}
    for i, j in edges:
        near[i].add(j)
        near[j].add(i)
    nodes, placed = [], set()
    for b, size in enumerate(sizes):
        if b in placed or size == 0:
            continue
        node, total = [b], size
        placed.add(b)
        grown = True
        while grown and total < NODE:
            grown = False
            for c in sorted({c for m in node for c in near[m]} - placed):
                if 0 < sizes[c] and total + sizes[c] <= NODE:
                    node.append(c)
                    placed.add(c)
                    total += sizes[c]
                    grown = True
        nodes.append(sorted(node))
    return nodes


def place_coordinates(
    records: NDArray[np.void], nodes: list[list[int]]
) -> tuple[list[int], list[int], list[int], list[int]]:
    """Number the coordinates node by node; returns node and offset of bodies, start and size of nodes."""
    nb = records.size
    node_of, offset_of = [-1] * nb, [-1] * nb
    starts, sizes = [], []
    dof = 0
    for k, node in enumerate(nodes):
        starts.append(dof)
        for b in node:
            node_of[b], offset_of[b] = k, dof - starts[k]
            records[b]["dof"] = dof
            dof += int(records[b]["joint"])
            records[b]["spin"] = dof - 1
        sizes.append(dof - starts[k])
    return node_of, offset_of, starts, sizes


def structure(
    records: NDArray[np.void], pairs: set[tuple[int, int]], blocks_only: set[tuple[int, int]]
) -> tuple[dict[str, NDArray[Any]], dict[tuple[int, int], int], dict[str, Any]]:
    """Write every integer programme of a set of bodies on ground.

    Parameters
    ----------
    records
        Body records; their dof, spin, path and ii fields are filled in.
    pairs
        Pairs of bodies joined by frame kinds.
    blocks_only
        Further pairs of bodies that only need a block (coordinate kinds).

    Returns
    -------
    program, pair_index, layout parts
    """
    moving = [b for b in range(records.size) if records[b]["joint"] > 0]
    live = {(i, j) for i, j in pairs | blocks_only if i != j and i in moving and j in moving}
    nodes = group([int(n) for n in records["joint"]], live)
    node_of, offset_of, starts, sizes = place_coordinates(records, nodes)
    index: dict[tuple[int, int], int] = {}
    for b in moving:
        index[b, b] = len(index) + 1
        records[b]["ii"] = index[b, b]
    for i, j in sorted(pairs):
        if i != j and i in moving and j in moving:
            for key in ((i, j), (j, i)):
                index.setdefault(key, len(index) + 1)
    blocks, factor, solve = plan(sizes, {(node_of[i], node_of[j]) for i, j in live}, starts)
    path = np.zeros(len(moving), PATH)
    path_of = np.full(records.size, -1, np.int64)
    for p, b in enumerate(moving):
        records[b]["path"] = path_of[b] = p
        n = int(records[b]["joint"])
        path[p] = (b, n, records[b]["dof"], n)
    proj = np.zeros(len(index), PROJ)
    for k, ((i, j), pair) in enumerate(index.items()):
        ni, nj = int(records[i]["joint"]), int(records[j]["joint"])
        short = SPINS if ni == nj == TORSION else SHAFTS if ni == nj == FREE else GENERAL
        block = blocks[node_of[i], node_of[j]]
        proj[k] = (pair, path_of[i], path_of[j], block, ni, nj, offset_of[i], offset_of[j], short)
    spins = np.array([(records[b]["spin"], b) for b in moving], np.int64).reshape(-1, 2)
    program = {
        "body": records,
        "path": path,
        "path_of": path_of,
        "proj": proj,
        "factor": factor,
        "solve": solve,
        "spins": spins,
    }
    parts = {
        "node_of": tuple(node_of),
        "offset_of": tuple(offset_of),
        "blocks": blocks,
        "node_dof": tuple(starts),
        "node_size": tuple(sizes),
    }
    return program, index, parts


def body_channels(
    bodies: Sequence[Body], names: Sequence[str], records: NDArray[np.void], first: int
) -> tuple[list[Channel], NDArray[np.int64]]:
    """Observations of the bodies themselves: unwrapped angle, speed, displacements.

    Returns the channels and rows (0 coordinate | 1 unwrapped spin | 2 rate, body, coordinate, observation).
    """
    channels: list[Channel] = []
    table: list[tuple[int, int, int, int]] = []
    words = {"alpha": "rx", "beta": "ry"}
    for b, (body, name) in enumerate(zip(bodies, names, strict=True), start=1):
        for k, (coordinate, unit) in enumerate(JOINTS[body.motion]):
            dof = int(records[b]["dof"]) + k
            at = first + len(channels)
            if coordinate == "spin":
                channels.append(Channel(f"angle[{name}]", "rad", f"angle of {name}"))
                channels.append(Channel(f"speed[{name}]", "rad/s", f"speed of {name}"))
                table += [(1, b, dof, at), (2, b, dof, at + 1)]
            else:
                word = words.get(coordinate, coordinate)
                text = f"displacement of {name}, {word}"
                channels.append(Channel(f"displacement[{name}.{word}]", unit, text))
                table.append((0, b, dof, at))
    return channels, np.array(table, np.int64).reshape(-1, 4)
