# SPDX-License-Identifier: Apache-2.0
"""Curves of a scene as columns of a few tables, see `docs/scene_format.md`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from pitchpoint.viz.scene import SceneChannel
from pitchpoint.viz.scene_numbers import Block

FINE, COARSE = 65535, 2047
"""Steps between the least and the largest value of a curve: shown without asking, and others."""


def channel_entries(channels: Sequence[SceneChannel], block: Block) -> dict[str, Any]:
    """The parts `curves` and `channels` of a header; their numbers go into the block.

    Parameters
    ----------
    channels
        The curves; those that have the same instants share a table, those that look the same a column.
    block
        Numbers of the scene.

    Raises
    ------
    ValueError
        If a number is not finite.
    """
    tables: dict[tuple[int, bytes], _Table] = {}
    entries = []
    for channel in channels:
        if not (np.isfinite(channel.least).all() and np.isfinite(channel.most).all()):
            raise ValueError(f"{channel.name}: holds numbers that are not finite")
        steps = FINE if channel.first else COARSE
        table = tables.setdefault((steps, channel.times.tobytes()), _Table(len(tables), channel))
        low, high = float(channel.least.min()), float(channel.most.max())
        # an offset with all its digits: a torque of 1e5 N m may ripple by 1 N m
        step, low = float(f"{(high - low) / steps * (1.0 + 1e-5):.10g}"), float(f"{low:.12g}")
        parts = [np.rint((x - low) / (step or 1.0)).astype(np.int64) for x in (channel.least, channel.most)]
        entry: dict[str, Any] = {
            "name": channel.name,
            "label": channel.label,
            "unit": channel.unit,
            "shown_unit": channel.shown_unit,
            "scale": channel.scale,
            "curve": [table.number, table.column(*parts)],
            "from": [low, step],
        }
        entries.append({**entry, "first": True} if channel.first else entry)
    return {"curves": [table.entry(block) for table in tables.values()], "channels": entries}


class _Table:
    """Curves over the same instants, each look once."""

    def __init__(self, number: int, first: SceneChannel) -> None:
        self.number, self.times = number, first.times
        self.columns: dict[bytes, tuple[int, np.ndarray, np.ndarray]] = {}

    def column(self, least: np.ndarray, most: np.ndarray) -> int:
        """Number of the column that holds these steps."""
        key = least.tobytes() + most.tobytes()
        return self.columns.setdefault(key, (len(self.columns), least, most))[0]

    def entry(self, block: Block) -> dict[str, Any]:
        """Part of the header; numbers go into the block."""
        least = np.stack([column[1] for column in self.columns.values()], axis=1)
        most = np.stack([column[2] for column in self.columns.values()], axis=1)
        found = {"times": block.put(self.times, "f8"), "least": block.put_whole(least)}
        return {**found, "span": block.put_whole(most - least)} if np.any(most != least) else found
