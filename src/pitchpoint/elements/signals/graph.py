# SPDX-License-Identifier: Apache-2.0
"""Dependency graph of signals: evaluation order, algebraic loops, records and tangent links."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.core.nearest import hint
from pitchpoint.elements.signal import Pool
from pitchpoint.elements.signals.record import (
    CHANNEL,
    LINEAR,
    LINK,
    NOTHING,
    RATE,
    REACTION_FORCE,
    REACTION_MOMENT,
    RECORD,
    ROW,
    TIME,
    TORQUE,
    UNITS,
)

LOADS = (REACTION_FORCE, REACTION_MOMENT, CHANNEL)
REACTIONS = (REACTION_FORCE, REACTION_MOMENT)


@dataclass
class Node:
    """One signal before it is compiled.

    Parameters
    ----------
    name
        Name of the signal.
    op
        Operation, see `signals.record`.
    inputs
        Names of the input signals; "t" is the time, as input of a formula.
    fields
        Fields of its record.
    numbers
        Values in the pool, without the input slots of a linear combination.
    state
        Number of the state, for states and their rates.
    law
        User law, if any.
    """

    name: str
    op: int
    inputs: tuple[str, ...] = ()
    fields: dict[str, Any] = field(default_factory=dict)
    numbers: Any = ()
    state: int = -1
    law: Any = None


def evaluation_order(nodes: dict[str, Node]) -> list[Node]:
    """Nodes in evaluation order: inputs first, reactions after all actuators.

    Raises
    ------
    CompileError
        If an input does not exist, or signals form an algebraic loop.
    """
    acting = tuple(n.name for n in nodes.values() if n.op >= TORQUE and n.op != RATE)
    found: list[Node] = []
    done: set[str] = set()
    for first in nodes:
        trail: list[tuple[str, int]] = [(first, 0)]
        while trail:
            name, k = trail.pop()
            node = nodes[name]
            needs = [x for x in node.inputs if x != "t"]
            if node.op in REACTIONS:
                needs += acting
            if name in done:
                continue
            if k == len(needs):
                done.add(name)
                found.append(node)
                continue
            trail.append((name, k + 1))
            wanted = needs[k]
            if wanted not in nodes:
                raise CompileError(f"signal {name!r}: {wanted!r} is not a signal; {hint(wanted, nodes)}")
            on_trail = [n for n, _ in trail]
            if wanted in on_trail:
                loop = [*on_trail[on_trail.index(wanted) :], wanted]
                raise CompileError(
                    f"the signals {' <- '.join(loop)} form an algebraic loop; put a state between them, "
                    "such as a filter"
                )
            if wanted not in done:
                trail.append((wanted, 0))
    return found


def _sources(ordered: Sequence[Node]) -> dict[str, list[str]]:
    """Sources (sensors, states) on which each signal depends directly."""
    found: dict[str, list[str]] = {}
    for node in ordered:
        if node.op < LINEAR:
            found[node.name] = [node.name]
        else:
            both = [s for x in node.inputs if x != "t" for s in found[x]]
            found[node.name] = list(dict.fromkeys(both))
    return found


def _input_slots(node: Node, slot: dict[str, int]) -> list[int]:
    return [TIME if x == "t" else slot[x] for x in node.inputs]


def make_records(
    nodes: dict[str, Node], first_state: int
) -> tuple[NDArray[np.void], list[str], NDArray[np.float64], list[Any]]:
    """Records in evaluation order, their names, the pool, and the laws.

    Parameters
    ----------
    nodes
        All signals by name.
    first_state
        Number of the hidden body of state 0.
    """
    ordered = evaluation_order(nodes)
    slot = {node.name: k for k, node in enumerate(ordered)}
    column = {node.name: k for k, node in enumerate(n for n in ordered if n.op < LINEAR)}
    size, sources = len(ordered), max(len(column), 1)
    pool = Pool()
    pool.add(np.zeros(size * (1 + sources) + sources * 2 * ROW))
    records = np.zeros(size, RECORD)
    for record, node in zip(records, ordered, strict=True):
        record["op"], record["slot"], record["source"] = node.op, slot[node.name], column.get(node.name, 0)
        places = _input_slots(node, slot)
        record["a"], record["b"], record["c"] = (*places[:3], *[NOTHING] * 3)[:3]
        for key, value in node.fields.items():
            record[key] = value
        if node.state >= 0:
            record["i"] = first_state + node.state
        numbers = np.asarray(node.numbers, float)
        if node.op == LINEAR:
            numbers, record["n"] = np.column_stack([places, numbers]).ravel(), len(places)
        if node.op >= TORQUE:
            numbers = np.zeros(12)
        record["start"] = pool.add(numbers)
    links, moved = _links(ordered, records, slot, column, size, sources)
    records = np.concatenate([records, links])
    records["nodes"], records["sources"] = size, sources
    names = [node.name for node in ordered] + [f"{name}.link{k}" for k, name in enumerate(moved)]
    laws = [node.law for node in ordered] + [None] * links.size
    return records, names, pool.array(), laws


def _links(
    ordered: Sequence[Node],
    records: NDArray[np.void],
    slot: dict[str, int],
    column: dict[str, int],
    size: int,
    sources: int,
) -> tuple[NDArray[np.void], list[str]]:
    """Link records: tangent of each end of each actuator by each body of each source that it depends on.

    Also the name of the actuator of each.
    """
    follows = _sources(ordered)
    by_name = {node.name: record for node, record in zip(ordered, records, strict=True)}
    rows, names = [], []
    for node in ordered:
        if node.op < TORQUE:
            continue
        actuator = by_name[node.name]
        for end, moved in enumerate(("i", "j")):
            for source in follows[node.inputs[0]]:
                sensor = by_name[source]
                if int(sensor["op"]) in LOADS:
                    continue
                for side, body in enumerate(("i", "j")):
                    if actuator[moved] == 0 or sensor[body] == 0:
                        continue
                    link = np.zeros((), RECORD)
                    link["op"], link["slot"] = LINK, -1
                    link["i"], link["j"] = actuator[moved], sensor[body]
                    link["a"] = actuator["start"] + 6 * end
                    link["b"] = size * (1 + sources) + ROW * (2 * column[source] + side)
                    link["c"] = size + slot[node.inputs[0]] * sources + column[source]
                    rows.append(link)
                    names.append(node.name)
    return np.array(rows, RECORD).reshape(-1), names


def unit_code(unit: str) -> int:
    """Code of a signal unit."""
    if unit not in UNITS:
        raise CompileError(f"unit {unit!r} of a signal is unknown; use one of {', '.join(UNITS[1:])}")
    return UNITS.index(unit) or 1
