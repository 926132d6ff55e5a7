# SPDX-License-Identifier: Apache-2.0
"""Preparation of element records for the compiled core: checks, indices, numbering of outputs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.elements import registry
from pitchpoint.elements.kind import CONSTRAINT, Kind
from pitchpoint.multibody.bodies import base_of
from pitchpoint.system.layout import Channel


def checked(kind: Kind, bank: NDArray[np.void], nb: int) -> NDArray[np.void]:
    """Contiguous copy of a bank, checked for dtype and body indices."""
    record = kind.record
    if bank.dtype != record:
        raise CompileError(f"records of kind {kind.name!r} do not have the dtype that the kind declares")
    bank = np.array(bank, dtype=record, order="C").reshape(-1)
    for pair in kind.pairs:
        for name in pair:
            if bank.size and not (0 <= bank[name].min() and bank[name].max() < nb):
                raise CompileError(
                    f"a record of kind {kind.name!r} refers to a body that does not exist ({name})"
                )
    return bank


def _outputs(rows: Sequence[tuple[str, ...]], label: str) -> list[Channel]:
    found = []
    for row in rows:
        name, unit, text = row if len(row) == 3 else (row[0], "1", row[1])
        full = name.format(label) if "{}" in name else f"{name}[{label}]"
        found.append(Channel(full, unit, text))
    return found


def _movers(records: NDArray[np.void], b: int) -> set[int]:
    """Bodies whose joints move body b."""
    found = set()
    while b:
        if records[b]["n"] > 0:
            found.add(b)
        b = int(records[b]["parent"])
    return found


def _carried(records: NDArray[np.void], i: int, j: int) -> int:
    """Gear (1 or 2) whose base rotates the line of centres: that with more joints; 0 for none."""
    one, two = (_movers(records, base_of(records, b)) for b in (i, j))
    return 0 if one == two else 1 if len(one) > len(two) else 2


_WORDS = ("dof_", "n_", "guide_", "o_", "spin_")
"""Beginnings of the fields with indices of one body."""


def _index_fields(a: str, b: str) -> set[str]:
    """Names of the fields with indices of two bodies."""
    return {a + a, a + b, b + a, b + b, *(f"{word}{end}" for word in _WORDS for end in (a, b))}


def fill(
    kind: Kind,
    bank: NDArray[np.void],
    records: NDArray[np.void],
    pair_index: Mapping[tuple[int, int], int],
    parts: Mapping[str, Any],
) -> None:
    """Set the index fields of a bank: pair blocks, coordinate blocks, spin coordinates."""
    fields = frozenset(bank.dtype.names or ())
    indices = [pair for pair in kind.pairs if "blk" in fields or not fields.isdisjoint(_index_fields(*pair))]
    for record in bank:
        if kind.paired:
            own = [int(record[a]) for a in kind.paired]
            record["pairs"] = [[pair_index.get((a, b), 0) for b in own] for a in own]
        if "carried" in fields:
            record["carried"] = _carried(records, int(record["i"]), int(record["j"]))
        for a, b in indices:
            i, j = int(record[a]), int(record[b])
            for name, key in ((a + a, (i, i)), (a + b, (i, j)), (b + a, (j, i)), (b + b, (j, j))):
                if name in fields:
                    record[name] = pair_index.get(key, 0)
            if "blk" in fields:
                ni, nj = parts["node_of"][i], parts["node_of"][j]
                record["blk"] = parts["blocks"].get((ni, nj), 0) if ni >= 0 and nj >= 0 else 0
            for body, end in ((i, a), (j, b)):
                values = {
                    f"dof_{end}": records[body]["dof"],
                    f"n_{end}": records[body]["n"],
                    f"guide_{end}": records[body]["guide"],
                    f"o_{end}": max(parts["offset_of"][body], 0),
                    f"spin_{end}": records[body]["spin"],
                }
                for name, value in values.items():
                    if name in fields:
                        record[name] = value


def pairs(banks: Mapping[str, NDArray[np.void]], channel: str) -> set[tuple[int, int]]:
    """Pairs of bodies coupled by the records of a channel; constraints only on body-fixed frames."""
    return {
        (int(record[a]), int(record[b]))
        for name, bank in banks.items()
        if registry.find(name).channel == channel
        if channel != CONSTRAINT or registry.find(name).body_fixed
        for a, b in registry.find(name).pairs
        for record in bank
    }


def number(
    banks: Mapping[str, NDArray[np.void]], names: Mapping[str, Sequence[str]]
) -> tuple[list[Channel], list[Channel], list[str], list[tuple[int, int]]]:
    """Number the observations, event functions and constraint rows of all records."""
    channels: list[Channel] = []
    events: list[Channel] = []
    rows: list[str] = []
    row_bodies: list[tuple[int, int]] = []
    for name, bank in banks.items():
        kind = registry.find(name)
        fields = bank.dtype.names or ()
        for k, record in enumerate(bank):
            label = names[name][k] if name in names else f"{name}{k}"
            if "out" in fields:
                record["out"] = len(channels)
            channels += _outputs(kind.outputs_of(record), label)
            if "ev" in fields:
                record["ev"] = len(events)
            events += _outputs(kind.events, label)
            if "row" in fields:
                record["row"] = len(rows)
                for _ in range(kind.rows):
                    rows.append(f"{name} {label}")
                    row_bodies.append((int(record["i"]), int(record["j"])))
    return channels, events, rows, row_bodies
