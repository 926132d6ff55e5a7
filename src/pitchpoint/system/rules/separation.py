# SPDX-License-Identifier: Apache-2.0
"""What the flanks of both gears of a mesh lack against the involute, as the grids that the element reads."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from pitchpoint.model.components.gear import Gear

#: Stations of a grid over the face width and over the length of roll.
N_WIDTH, N_ROLL = 33, 129


def separation_grids(row: Any, gears: Sequence[Gear], keep: Callable[[NDArray[np.float64]], int]) -> None:
    """Fill the separation fields of a mesh record; nothing to do for two perfect gears."""
    if not any(g.is_modified for g in gears):
        return
    row["n_sz"], row["n_sx"] = N_WIDTH, N_ROLL
    least = 0.0
    for k, gear in enumerate(gears, start=1):
        grid, span = flank_grid(gear, mate=k == 2)
        row[f"n_t{k}"], row[f"sep{k}"], row[f"roll{k}"] = grid.shape[1], keep(grid), span
        least += grid.min()
    row["sep_min"] = least


def flank_grid(gear: Gear, mate: bool) -> tuple[NDArray[np.float64], tuple[float, float]]:
    """Gaps [m] on the flanks of one gear, shape (2, teeth, width, roll), and the lengths of roll they span.

    The first index is 0 for the flanks that touch at the front (gear 1 pushing counter-clockwise), 1 for the
    back. Gears without deviations of single teeth need one tooth only. On an internal mate the front flanks
    are the right ones: the side towards which the teeth are counted is the other side of the mesh there.
    """
    from pitchpoint.geometry.deviations import separation
    from pitchpoint.geometry.modifications import flank_range

    geometry = gear.geometry
    span = flank_range(geometry)
    z = np.linspace(-0.5, 0.5, N_WIDTH) * geometry.b
    roll = np.linspace(*span, N_ROLL)
    order = ("right", "left") if mate and geometry.z < 0 else ("left", "right")
    deviations = None if gear.deviations is None else gear.deviations.of_geometry()
    sides = [None if gear.modifications is None else gear.modifications.side(flank) for flank in order]
    grids = [
        separation(
            geometry,
            flank,
            z,
            roll,
            modifications=None if side is None else side.of_geometry(),
            deviations=deviations,
        )
        for flank, side in zip(order, sides, strict=True)
    ]
    grid = np.stack(grids)
    return (grid if deviations is not None else grid[:, :1]), span
