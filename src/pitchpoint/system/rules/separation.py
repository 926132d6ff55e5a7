# SPDX-License-Identifier: Apache-2.0
"""What the teeth of both gears of a mesh have of their own, as the grids that the element reads."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.gear_mesh_record import N_ROW

if TYPE_CHECKING:
    from pitchpoint.model.components.gear import Gear

Array = NDArray[np.float64]

#: Stations of a grid over the face width and over the length of roll.
N_WIDTH, N_ROLL = 33, 129

GAP, SOFT, LEVEL = 0, 1, 2
"""Layers, in the order of their columns in the table of a gear; gap and soft share a stack of grids."""


def separation_grids(row: Any, gears: Sequence[Gear], keep: Callable[[Array], int]) -> None:
    """Fill the separation fields of a mesh record; nothing to do for two perfect gears."""
    if not any(g.is_modified or g.tooth_faults for g in gears):
        return
    row["n_sep"] = 1
    least = 0.0
    for k, gear in enumerate(gears):
        own = own_teeth(gear, mate=k == 1)
        row["roll"][k] = own.span
        row["n_t"][k] = own.teeth
        row["teeth"][k] = keep(own.table(bool(row["tan_b"] != 0.0)))
        for stack, grids in enumerate((own.smooth, own.levels)):
            row["n_sz"][2 * stack + k], row["n_sx"][2 * stack + k] = own.stations[stack]
            row["sep"][2 * stack + k] = keep(np.array(grids)) if grids else 0
        least += own.least()
    row["sep_min"] = least


class OwnTeeth:
    """Grids of the teeth of one gear that differ from the involute.

    Parameters
    ----------
    teeth
        Number of teeth that are told apart.
    span
        Lengths of roll that the grids span [m].
    """

    def __init__(self, teeth: int, span: tuple[float, float]) -> None:
        self.teeth = teeth
        self.span = span
        self.stations = [(N_WIDTH, N_ROLL), (N_WIDTH, N_ROLL)]
        self.smooth: list[Array] = []
        self.levels: list[Array] = []
        self.rows = np.full((2, teeth, 3), -1, dtype=np.int64)

    def add(self, layer: int, grid: Array) -> int:
        """Keep a grid of shape (n_z, n_roll); returns its row, -1 where it says nothing."""
        if not (np.any(grid > 0.0) if layer == LEVEL else np.any(grid)):
            return -1
        stack = self.levels if layer == LEVEL else self.smooth
        stack.append(np.ascontiguousarray(grid, dtype=np.float64))
        return len(stack) - 1

    def table(self, helical: bool) -> Array:
        """What the element knows of every flank and tooth, shape (2, teeth, N_ROW)."""
        out = np.full((2, self.teeth, N_ROW), -1.0)
        out[:, :, :3] = self.rows
        found: dict[tuple[int, int], tuple[int, int]] = {}
        for flank, tooth in np.ndindex(2, self.teeth):
            for layer, first in ((GAP, 3), (SOFT, 3), (LEVEL, 5)):
                row = int(self.rows[flank, tooth, layer])
                if row < 0:
                    continue
                key = (min(layer, 1) if layer != LEVEL else LEVEL, row)
                if key not in found:
                    stack = self.levels if layer == LEVEL else self.smooth
                    found[key] = changing(stack[row], helical and layer != LEVEL, layer == LEVEL)
                low, high = found[key]
                if high > low:
                    was = out[flank, tooth, first]
                    out[flank, tooth, first] = low if was < 0 else min(was, low)
                    out[flank, tooth, first + 1] = max(out[flank, tooth, first + 1], high)
        return out

    def least(self) -> float:
        """Smallest gap of all flanks [m]."""
        gaps = [self.smooth[k].min() if k >= 0 else 0.0 for k in np.unique(self.rows[:, :, GAP])]
        return float(min(gaps))


def changing(grid: Array, helical: bool, level: bool) -> tuple[int, int]:
    """First and last station over the width between which a grid changes; (0, 0) if it does not.

    Contact lines of helical gears cross the lengths of roll: there every cell that is not even counts. Of a
    level only cells count that it reaches into; edges along the whole width are found without stations.
    """
    across = np.asarray(np.abs(np.diff(grid, axis=0)).max(axis=1) > 0.0)
    if helical:
        along = np.asarray(grid.max(axis=1) > grid.min(axis=1))
        across |= along[1:] | along[:-1]
    if level:
        some = np.asarray(grid.max(axis=1) > 0.0)
        across &= some[1:] | some[:-1]
    cells = np.flatnonzero(across)
    return (int(cells[0]), int(cells[-1]) + 1) if cells.size else (0, 0)


def own_teeth(gear: Gear, mate: bool) -> OwnTeeth:
    """Grids of one gear.

    The first index of its rows is 0 for the flanks that touch at the front (gear 1 pushing counter-
    clockwise), 1 for the back. On an internal mate the front flanks are the right ones: the side towards
    which the teeth are counted is the other side of the mesh there.
    """
    from pitchpoint.geometry.modifications import flank_range

    single = gear.deviations is not None or bool(gear.tooth_faults)
    own = OwnTeeth(gear.number_of_teeth if single else 1, flank_range(gear.geometry))
    order = ("right", "left") if mate and gear.geometry.z < 0 else ("left", "right")
    z = np.linspace(-0.5, 0.5, N_WIDTH) * gear.face_width
    roll = np.linspace(*own.span, N_ROLL)
    for k, flank in enumerate(order):
        gaps = _gaps(gear, flank, z, roll)
        for tooth, grid in gaps.items():
            own.rows[k, tooth, GAP] = own.add(GAP, grid)
        for tooth, grid in _levels(gear, z, roll).items():
            own.rows[k, tooth, LEVEL] = own.add(LEVEL, grid)
    return own


def _gaps(gear: Gear, flank: str, z: Array, roll: Array) -> dict[int, Array]:
    """Gaps [m] of the teeth that are out of their nominal shape or place, shape (n_z, n_roll) each."""
    from pitchpoint.geometry.deviations import separation
    from pitchpoint.geometry.tooth_faults import displaced_gap
    from pitchpoint.model.components.tooth_faults import PitchError

    found: dict[int, Array] = {}
    if gear.is_modified:
        deviations = None if gear.deviations is None else gear.deviations.of_geometry()
        side = None if gear.modifications is None else gear.modifications.side(flank)
        grid = separation(
            gear.geometry,
            flank,
            z,
            roll,
            modifications=None if side is None else side.of_geometry(),
            deviations=deviations,
        )
        single = deviations is not None or gear.tooth_faults
        found = dict(enumerate(grid if single else grid[:1]))
    for fault in gear.faults.values():
        if isinstance(fault, PitchError):
            moved = displaced_gap(gear.geometry, flank, fault.severity * fault.amount)
            found[fault.tooth] = found.get(fault.tooth, np.zeros((z.size, roll.size))) + moved
    return found


def _levels(gear: Gear, z: Array, roll: Array) -> dict[int, Array]:
    """Levels [m] of the teeth that miss something, shape (n_z, n_roll) each."""
    from pitchpoint.geometry.tooth_faults import break_level, tooth_height
    from pitchpoint.model.components.tooth_faults import BrokenTooth

    found: dict[int, Array] = {}
    shape = gear.geometry
    for fault in gear.faults.values():
        if isinstance(fault, BrokenTooth):
            width, height = fault.sizes(gear.face_width, tooth_height(shape))
            corner = fault.shape == "corner"
            level = break_level(shape, z, roll, width=width, height=height, at=fault.at, corner=corner)
            found[fault.tooth] = np.maximum(found.get(fault.tooth, level), level)
    return found
