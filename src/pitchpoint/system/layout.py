# SPDX-License-Identifier: Apache-2.0
"""Layout of a system: names and indices of coordinates, blocks, observations and constraint rows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.multibody.block_lu import plan
from pitchpoint.multibody.bodies import GENERAL, PATH, Body
from pitchpoint.multibody.joints import FREE, SPIN, TORSION, TUMBLING
from pitchpoint.multibody.projection import ANY, PROJ, SHAFTS, SPINS

NODE = 6  # maximum number of coordinates of a node


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
        Node of each body and offset of its first coordinate in the node (-1 for bodies without coordinates).
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
        try:
            return self.channel_numbers[name]
        except KeyError:
            raise ValueError(f"{name!r} is not a channel") from None

    def coordinate(self, name: str) -> int:
        """Index of a coordinate, ``BODY.x`` and the like."""
        return self.coordinates.index(name)

    @cached_property
    def channel_numbers(self) -> dict[str, int]:
        """Index of every observation by name."""
        return {c.name: k for k, c in enumerate(self.channels)}

    @cached_property
    def entries(self) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
        """Row, column and flat index in the blocks of all matrix entries, sorted by column."""
        found = []
        for (i, j), block in self.blocks.items():
            r, c = np.mgrid[: self.node_size[i], : self.node_size[j]]
            place = NODE * NODE * block + NODE * r + c
            found.append([(self.node_dof[i] + r).ravel(), (self.node_dof[j] + c).ravel(), place.ravel()])
        whole = np.hstack(found) if found else np.zeros((3, 0), np.int64)
        rows, columns, places = whole[:, np.lexsort((whole[0], whole[1]))]
        return rows, columns, places


def group(sizes: Sequence[int], edges: set[tuple[int, int]]) -> list[list[int]]:
    """Group coupled bodies to nodes of at most six coordinates.

    Parameters
    ----------
    sizes
        Number of coordinates of each body, ground included.
    edges
        Pairs of bodies coupled by a tangent.
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
    """Number the coordinates by nodes; returns node and offset of the bodies, start and size of the nodes."""
    nb = records.size
    node_of, offset_of = [-1] * nb, [-1] * nb
    starts, sizes = [], []
    dof = 0
    for k, node in enumerate(nodes):
        starts.append(dof)
        for b in node:
            node_of[b], offset_of[b] = k, dof - starts[k]
            records[b]["dof"] = dof
            n = int(records[b]["n"])
            dof += n
            if n and records[b]["guide"] < 0 and records[b]["axis"][n - 1] == SPIN:
                records[b]["spin"] = dof - 1
        sizes.append(dof - starts[k])
    return node_of, offset_of, starts, sizes


def structure(
    records: NDArray[np.void], pairs: set[tuple[int, int]], blocks_only: set[tuple[int, int]]
) -> tuple[dict[str, NDArray[Any]], dict[tuple[int, int], int], dict[str, Any]]:
    """Create all integer programmes of a tree of bodies.

    Parameters
    ----------
    records
        Body records; the fields dof, spin, path, first, count and ii are set.
    pairs
        Pairs of bodies coupled by frame kinds.
    blocks_only
        Further pairs of bodies that require only a matrix block (coordinate kinds).

    Returns
    -------
    program, pair_index, layout parts
    """
    nb = records.size
    owners = _owners(records)
    moving = [b for b in range(nb) if owners[b]]
    joined = {(i, j) for i, j in pairs | blocks_only if i != j and owners[i] and owners[j]}
    of = [int(r["shares"]) or b for b, r in enumerate(records)]  # body that owns the coordinates
    live = {(of[a], of[c]) for i, j in joined for a in owners[i] for c in owners[j] if of[a] != of[c]}
    # forces on a body couple all joints on its path; inboard joints are covered by the paths of their bodies
    ways = {(of[a], of[owners[b][-1]]) for b in moving for a in owners[b]}
    live |= {pair for a, c in ways if a != c for pair in ((a, c), (c, a))}
    nodes = group([int(r["n"]) if of[b] == b else 0 for b, r in enumerate(records)], live)
    node_of, offset_of, starts, sizes = place_coordinates(records, nodes)
    for b, master in enumerate(of):
        records[b]["dof"] = records[master]["dof"]
        node_of[b], offset_of[b] = node_of[master], offset_of[master]
    index: dict[tuple[int, int], int] = {}
    for b in moving:
        index[b, b] = len(index) + 1
        records[b]["ii"] = index[b, b]
    for i, j in sorted(pairs):
        if i != j and owners[i] and owners[j]:
            for key in ((i, j), (j, i)):
                index.setdefault(key, len(index) + 1)
    blocks, factor, solve = plan(sizes, {(node_of[a], node_of[c]) for a, c in live}, starts)
    path = _paths(records, owners)
    spins = [(records[b]["spin"], b) for b in range(nb) if records[b]["spin"] >= 0]
    program = {
        "body": records,
        "path": path,
        "proj": _projection(records, path, index, blocks, (node_of, offset_of)),
        "factor": factor,
        "solve": solve,
        "spins": np.array(spins, np.int64).reshape(-1, 2),
    }
    parts = {
        "node_of": tuple(node_of),
        "offset_of": tuple(offset_of),
        "blocks": blocks,
        "node_dof": tuple(starts),
        "node_size": tuple(sizes),
    }
    return program, index, parts


def products(records: NDArray[np.void], pairs: set[tuple[int, int]]) -> int:
    """Number of joint pairs that contribute to the matrix: rows of the projection programme.

    Each pair of bodies involves all joints on the paths to both, so that a chain of n bodies requires n^3 /
    3 rows.
    """
    count = [0] * records.size
    for b in range(1, records.size):
        count[b] = count[int(records[b]["parent"])] + (1 if records[b]["n"] > 0 else 0)
    both = {(min(i, j), max(i, j)) for i, j in pairs if i != j}
    return sum(n * n for n in count) + 2 * sum(count[i] * count[j] for i, j in both)


def _owners(records: NDArray[np.void]) -> list[list[int]]:
    """For each body the bodies whose joints move it, from ground outwards; parents come before children."""
    owners: list[list[int]] = [[]]
    for b in range(1, records.size):
        own = [b] if records[b]["n"] > 0 else []
        owners.append(owners[int(records[b]["parent"])] + own)
    return owners


def _paths(records: NDArray[np.void], owners: list[list[int]]) -> NDArray[np.void]:
    """Table of the joints on the path to each body; sets first, count and path of the bodies."""
    rows: list[tuple[int, ...]] = []
    for b, mine in enumerate(owners):
        records[b]["first"], records[b]["count"] = len(rows), len(mine)
        for k in mine:
            short = records[k]["joint"] if k == b else GENERAL
            rows.append((b, short, records[k]["dof"], records[k]["n"], k))
        records[b]["path"] = len(rows) - 1 if mine and mine[-1] == b else -1
    return np.array(rows, PATH)


def _projection(
    records: NDArray[np.void],
    path: NDArray[np.void],
    index: Mapping[tuple[int, int], int],
    blocks: Mapping[tuple[int, int], int],
    places: tuple[Sequence[int], Sequence[int]],
) -> NDArray[np.void]:
    """Projection programme: one row per pair of bodies and pair of joints on their paths.

    Rows with the same joint of the second body follow each other: `project_tangent` keeps a product for them.

    Parameters
    ----------
    records, path
        Bodies, and the joints on the path to each.
    index
        Numbers of the pairs of bodies.
    blocks
        Block of each pair of nodes.
    places
        Node of each body, and offset of its first coordinate in the node.
    """
    one, two = np.array(list(index), np.int64).reshape(-1, 2).T
    along = records["count"][one]
    total = along * records["count"][two]
    row = np.repeat(np.arange(total.size), total)  # index of the body pair; `within`: row within the pair
    within = np.arange(row.size) - np.repeat(np.cumsum(total) - total, total)
    found = np.zeros(row.size, PROJ)
    found["pair"] = np.array(list(index.values()), np.int64)[row]
    found["pi"] = records["first"][one][row] + within % along[row]
    found["pj"] = records["first"][two][row] + within // along[row]
    a, c = path["owner"][found["pi"]], path["owner"][found["pj"]]
    node, offset = (np.array(x, np.int64) for x in places)
    keys, where = np.unique(node[a] * records.size + node[c], return_inverse=True)
    found["blk"] = np.array([blocks[divmod(int(k), records.size)] for k in keys], np.int64)[where]
    for size, start, body in (("ni", "oi", a), ("nj", "oj", c)):
        found[size], found[start] = records["n"][body], offset[body]
    joints = path["joint"][found["pi"]], path["joint"][found["pj"]]
    found["short"] = ANY
    for joint, short in ((TORSION, SPINS), (FREE, SHAFTS)):
        found["short"][(joints[0] == joint) & (joints[1] == joint)] = short
    return found


def body_channels(
    bodies: Sequence[Body], names: Sequence[str], records: NDArray[np.void], first: int
) -> tuple[list[Channel], NDArray[np.int64]]:
    """Observations of the bodies: unwrapped angle, speed, displacements, attitudes.

    Returns the channels and a table with rows (0 coordinate | 1 unwrapped spin | 2 rate, body, coordinate,
    observation), for tumbling bodies (3, chart, first rotation, first of four observations).
    """
    channels: list[Channel] = []
    table: list[tuple[int, int, int, int]] = []
    words = {"alpha": "rx", "beta": "ry"}
    for b, (body, name) in enumerate(zip(bodies, names, strict=True), start=1):
        for k, (coordinate, unit) in enumerate(() if body.state else body.coordinates):
            dof = int(records[b]["dof"]) + k
            at = first + len(channels)
            if body.motion in TUMBLING and unit == "rad":
                if coordinate == "alpha":  # the angles jump when the chart changes, the attitude does not
                    table.append((3, int(records[b]["chart"]), dof, at))
                    text = f"attitude of {name} against its start, quaternion"
                    channels += [Channel(f"attitude[{name}.{c}]", "1", f"{text}, {c}") for c in "xyzw"]
                continue
            if coordinate == "spin":
                against = f" against {names[body.parent - 1]}" if body.parent else ""
                channels.append(Channel(f"angle[{name}]", "rad", f"angle of {name}{against}"))
                channels.append(Channel(f"speed[{name}]", "rad/s", f"speed of {name}{against}"))
                table += [(1, b, dof, at), (2, b, dof, at + 1)]
            else:
                word = words.get(coordinate, coordinate)
                text = f"displacement of {name}, {word}"
                channels.append(Channel(f"displacement[{name}.{word}]", unit, text))
                table.append((0, b, dof, at))
    return channels, np.array(table, np.int64).reshape(-1, 4)
