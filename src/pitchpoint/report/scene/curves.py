# SPDX-License-Identifier: Apache-2.0
"""Curves of a scene: all samples of a channel, or minimum, mean and maximum of equal pieces of the record."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.viz.quantities import Channel, channel_scale
from pitchpoint.viz.scene.content import SceneChannel

if TYPE_CHECKING:
    import xarray as xr

Array = NDArray[np.float64]

SAMPLES = 20_000
"""Maximum number of numbers of a main channel."""
MAIN, OTHERS = 6e5, 5e6
"""Maximum count of numbers of all main channels, and of all others."""
COLUMNS = (200, 1000)
"""Minimum and maximum number of pieces of the other channels: columns of pixels of a page."""
PER_PIECE = 3
"""Numbers per piece: minimum, mean, maximum."""
FIRST = ("hub_wind_speed", "aerodynamic_power", "normal_force", "transmission_error")
"""Quantities with curves shown by default."""
SECOND = ("contact_force", "tension", "reaction_force", "torque", "speed", "displacement")
"""Fallback quantities: the first varying channel is shown if none of these exists."""


def scene_curves(result: xr.Dataset, main: Collection[str]) -> list[SceneChannel]:
    """All finite channels of a result over time.

    Parameters
    ----------
    result
        Result of a time run.
    main
        Names of the main channels, which have more pieces.
    """
    names = [str(name) for name, values in result.data_vars.items() if values.dims == ("time",)]
    main = set(main).intersection(names)
    low, high = (PER_PIECE * count for count in COLUMNS)
    fine = int(min(SAMPLES, max(high, MAIN / max(1, len(main)))))
    coarse = int(min(high, max(low, OTHERS / max(1, len(names) - len(main)))))
    time = np.asarray(result["time"].values, dtype=np.float64)
    # a record that is little longer is stored whole: it compresses better than pieces
    starts = {limit: _starts(time.size, limit) for limit in (fine, coarse)}
    found = []
    for name in names:
        x = np.asarray(result[name].values, dtype=np.float64)
        if not np.isfinite(x).all():
            continue
        found.append(_curve(name, result[name].attrs, time, x, starts[fine if name in main else coarse]))
    if found and not any(channel.first for channel in found):
        best = min(range(len(found)), key=lambda k: _rank(found[k]))
        found[best] = replace(found[best], first=True)
    return found


def _starts(n: int, numbers: int) -> NDArray[np.int64] | None:
    """First samples of the pieces of a record with n samples; None if all samples are stored."""
    if n <= 1.5 * numbers:
        return None
    edges = np.linspace(0, n, numbers // PER_PIECE + 1).round().astype(np.int64)
    return np.unique(edges)[:-1]


def _curve(
    name: str, about: dict[str, object], time: Array, x: Array, starts: NDArray[np.int64] | None
) -> SceneChannel:
    unit = str(about.get("units", "1"))
    shown = channel_scale(name, unit, x)
    least = most = mean = x
    if starts is not None:
        least, most = np.minimum.reduceat(x, starts), np.maximum.reduceat(x, starts)
        mean = np.add.reduceat(x, starts) / np.diff(np.append(starts, x.size))
        time = time[starts]
    return SceneChannel(
        name=name,
        label=Channel(name, x).label,
        unit=unit,
        shown_unit=shown.unit,
        scale=shown.factor,
        times=time,
        least=least,
        most=most,
        mean=mean,
        first=name.split("[")[0] in FIRST,
    )


def _rank(channel: SceneChannel) -> tuple[bool, int]:
    """Sort key: varying channels before constant ones, main quantities first."""
    order = {quantity: k for k, quantity in enumerate(SECOND)}
    least, most = float(channel.least.min()), float(channel.most.max())
    level = most - least <= 1e-9 * max(abs(least), abs(most))
    return level, order.get(channel.name.split("[")[0], len(order))
