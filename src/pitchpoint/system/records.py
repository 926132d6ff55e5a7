# SPDX-License-Identifier: Apache-2.0
"""Records of elements as the compiled core wants them: checked, every index filled in, outputs counted."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.elements import registry
from pitchpoint.multibody.bodies import base_of
from pitchpoint.system.layout import Channel


def checked(kind: registry.Kind, bank: NDArray[np.void], nb: int) -> NDArray[np.void]:
    """Own, contiguous copy of a bank with the exact dtype and valid body indices."""
    record = kind.load().RECORD
    if bank.dtype != record:
        raise CompileError(f"records of kind {kind.name!r} have another layout than the kind declares")
    bank = np.array(bank, dtype=record, order="C").reshape(-1)
    for pair in kind.pairs:
        for name in pair:
            if bank.size and not (0 <= bank[name].min() and bank[name].max() < nb):
                raise CompileError(
                    f"a record of kind {kind.name!r} names a body that does not exist ({name})"
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
    """Bodies whose joints move a body."""
    found = set()
    while b:
        if records[b]["n"] > 0:
            found.add(b)
        b = int(records[b]["parent"])
    return found


def _carried(records: NDArray[np.void], i: int, j: int) -> int:
    """Which of two gears carries the line between them round: the one whose base moves with more joints."""
    one, two = (_movers(records, base_of(records, b)) for b in (i, j))
    return 0 if one == two else 1 if len(one) > len(two) else 2


def fill(
    kind: registry.Kind,
    bank: NDArray[np.void],
    records: NDArray[np.void],
    pair_index: Mapping[tuple[int, int], int],
    parts: Mapping[str, Any],
) -> None:
    """Write the index fields of a bank: pair blocks, coordinate blocks, spin coordinates."""
    fields = bank.dtype.names or ()
    paired = getattr(kind.load(), "PAIRED", ())
    for record in bank:
        for x, a in enumerate(paired):
            for y, b in enumerate(paired):
                record["pairs"][x, y] = pair_index.get((int(record[a]), int(record[b])), 0)
        for a, b in kind.pairs:
            i, j = int(record[a]), int(record[b])
            for name, key in ((a + a, (i, i)), (a + b, (i, j)), (b + a, (j, i)), (b + b, (j, j))):
                if name in fields:
                    record[name] = pair_index.get(key, 0)
            if "carried" in fields:
                record["carried"] = _carried(records, i, j)
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
    """Pairs of bodies that the records of a channel join; of constraints only those on turning frames."""
    return {
        (int(record[a]), int(record[b]))
        for name, bank in banks.items()
        if registry.find(name).channel == channel
        if channel != registry.CONSTRAINT or hasattr(registry.find(name).load(), "BODY_FIXED")
        for a, b in registry.find(name).pairs
        for record in bank
    }


def number(
    banks: Mapping[str, NDArray[np.void]], names: Mapping[str, Sequence[str]]
) -> tuple[list[Channel], list[Channel], list[str], list[tuple[int, int]]]:
    """Give every record its observations, event functions and constraint rows."""
    channels: list[Channel] = []
    events: list[Channel] = []
    rows: list[str] = []
    row_bodies: list[tuple[int, int]] = []
    for name, bank in banks.items():
        module = registry.find(name).load()
        fields = bank.dtype.names or ()
        outputs = getattr(module, "outputs", None)
        for k, record in enumerate(bank):
            label = names[name][k] if name in names else f"{name}{k}"
            if "out" in fields:
                record["out"] = len(channels)
            channels += _outputs(outputs(record) if outputs else getattr(module, "OUTPUTS", ()), label)
            if "ev" in fields:
                record["ev"] = len(events)
            events += _outputs(getattr(module, "EVENTS", ()), label)
            if "row" in fields:
                record["row"] = len(rows)
                for _ in range(getattr(module, "ROWS", 0)):
                    rows.append(f"{name} {label}")
                    row_bodies.append((int(record["i"]), int(record["j"])))
    return channels, events, rows, row_bodies
