# SPDX-License-Identifier: Apache-2.0
"""Modifications, deviations and faults of teeth for the mesh element.

Modifications are closed form, deviations and faults of individual teeth grids.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.mesh.record import N_ROW

if TYPE_CHECKING:
    from pitchpoint.model.components.gear import Gear

Array = NDArray[np.float64]

#: Stations of a grid over the face width and over the length of roll.
N_WIDTH, N_ROLL = 33, 129

#: Stations of gaps and compliances per segment of a contact line. Four segments over the face width with
#: three points each integrate wear and cracks to 2e-5 of the force; the interpolation error of 33 stations
#: is 2e-4.
STRIDE = 8

#: Gap due to wear [m] as a function of (front 0 or back 1, "left" or "right", z, roll), shape (n_z, n_roll).
Worn: TypeAlias = Callable[[int, str, Array, Array], Array] | None

GAP, SOFT, LEVEL = 0, 1, 2
"""Layers in the order of their columns in the table of a gear; GAP and SOFT share a stack of grids."""


def separation_grids(
    row: Any, gears: Sequence[Gear], keep: Callable[[Array], int], worn: Sequence[Worn] = (None, None)
) -> None:
    """Set the separation fields of a mesh record; unchanged for ideal gears.

    `worn` gives the wear of the flanks of both gears in this mesh.
    """
    if not any(g.is_modified or g.tooth_faults for g in gears):
        return
    row["n_sep"], row["stride"] = 1, STRIDE
    least = 0.0
    for k, gear in enumerate(gears):
        own = own_teeth(replace(gear, modifications=None), mate=k == 1, worn=worn[k])
        terms = flank_terms(gear, mate=k == 1)
        row["modified"][k] = bool(terms.any())
        row["terms"][k] = keep(terms)
        row["roll"][k] = own.span
        row["n_t"][k] = own.teeth
        row["teeth"][k] = keep(own.table(bool(row["tan_b"] != 0.0)))
        for stack, grids in enumerate((own.smooth, own.levels)):
            row["n_sz"][2 * stack + k], row["n_sx"][2 * stack + k] = own.stations[stack]
            row["sep"][2 * stack + k] = keep(np.array(grids)) if grids else 0
        least += own.least(terms)
    row["sep_min"] += least


def flank_terms(gear: Gear, mate: bool) -> Array:
    """Rows of `geometry.modification_terms` of front and back flanks, shape (2, N_TERM)."""
    from pitchpoint.geometry.modification_terms import N_TERM, modification_terms

    rows = np.zeros((2, N_TERM))
    for k, flank in enumerate(flank_sides(gear, mate)):
        side = None if gear.modifications is None else gear.modifications.side(flank)
        if side is not None:
            rows[k] = modification_terms(side.of_geometry(), gear.geometry)
    return rows


def flank_sides(gear: Gear, mate: bool) -> tuple[str, str]:
    """Sides of the front and the back flanks of gear 1, or gear 2 with `mate`.

    Front flanks are in contact if gear 1 drives counter-clockwise. On an internal mating gear they are the
    right ones, because its teeth are numbered towards the other side of the mesh.
    """
    return ("right", "left") if mate and gear.geometry.z < 0 else ("left", "right")


class OwnTeeth:
    """Grids of the deviations of the teeth of one gear from the involute.

    Parameters
    ----------
    teeth
        Number of distinguished teeth.
    span
        Range of roll length of the grids [m].
    """

    def __init__(self, teeth: int, span: tuple[float, float]) -> None:
        self.teeth = teeth
        self.span = span
        self.stations = [(N_WIDTH, N_ROLL), (N_WIDTH, N_ROLL)]
        self.smooth: list[Array] = []
        self.levels: list[Array] = []
        self.rows = np.full((2, teeth, 3), -1, dtype=np.int64)

    def add(self, layer: int, grid: Array) -> int:
        """Add a grid of shape (n_z, n_roll) to its stack; returns its row, -1 for a zero grid."""
        if not (np.any(grid > 0.0) if layer == LEVEL else np.any(grid)):
            return -1
        stack = self.levels if layer == LEVEL else self.smooth
        for k in range(len(stack) - 1, -1, -1):
            if stack[k] is grid:
                return k
        stack.append(grid)
        return len(stack) - 1

    def table(self, helical: bool) -> Array:
        """Table of grid rows and changing stations for each flank and tooth, shape (2, teeth, N_ROW)."""
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

    def least(self, terms: Array) -> float:
        """Minimum gap over all flanks, with the modifications of front and back flanks [m]."""
        from pitchpoint.geometry.modification_terms import cell_minima

        n_z, n_roll = self.stations[0]
        found = []
        for flank in range(2):
            across, along = np.linspace(-1.0, 1.0, n_z), np.linspace(0.0, 1.0, n_roll)
            profile, lead = cell_minima(terms[flank], along, across)
            modified = lead[:, None] + profile
            for k in np.unique(self.rows[flank, :, GAP]):
                grid = self.smooth[k] if k >= 0 else np.zeros((n_z, n_roll))
                cells = np.minimum(
                    np.minimum(grid[1:, 1:], grid[1:, :-1]), np.minimum(grid[:-1, 1:], grid[:-1, :-1])
                )
                found.append(float((cells + modified).min()))
        return min(found)


def changing(grid: Array, helical: bool, level: bool) -> tuple[int, int]:
    """First and last station over the face width between which a grid changes; (0, 0) if it is constant.

    Contact lines of helical gears cross the roll lengths, so that cells that change over the roll length are
    included. For a level only cells with positive values are included; edges along the whole face width need
    no stations.
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


def own_teeth(gear: Gear, mate: bool, worn: Worn = None) -> OwnTeeth:
    """Grids of one gear, with its modifications.

    The first index of its rows is 0 for front flanks, 1 for back flanks.
    """
    from pitchpoint.geometry.modifications import flank_range

    single = gear.deviations is not None or bool(gear.tooth_faults)
    own = OwnTeeth(gear.number_of_teeth if single else 1, flank_range(gear.geometry))
    own.stations = [(N_WIDTH, N_ROLL), _level_stations(gear)]
    (z, roll), (z_fine, roll_fine) = (
        (np.linspace(-0.5, 0.5, n) * gear.face_width, np.linspace(*own.span, m)) for n, m in own.stations
    )
    for k, flank in enumerate(flank_sides(gear, mate)):
        gaps = _gaps(gear, flank, z, roll, None if worn is None else worn(k, flank, z, roll))
        for tooth, grid in gaps.items():
            own.rows[k, tooth, GAP] = own.add(GAP, grid)
        for tooth, grid in _softenings(gear, flank, z, roll).items():
            own.rows[k, tooth, SOFT] = own.add(SOFT, grid)
        for tooth, grid in _levels(gear, flank, z_fine, roll_fine).items():
            own.rows[k, tooth, LEVEL] = own.add(LEVEL, grid)
    return own


def _gaps(gear: Gear, flank: str, z: Array, roll: Array, wear: Array | None) -> dict[int, Array]:
    """Gaps [m] of the teeth with modified or displaced flanks, shape (n_z, n_roll) each.

    Teeth with wear only share the same array.
    """
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
    if wear is not None:
        teeth = range(gear.number_of_teeth)
        found = {t: wear + found[t] if t in found else wear for t in teeth}
    for fault in gear.faults.values():
        if isinstance(fault, PitchError):
            moved = displaced_gap(gear.geometry, flank, fault.severity * fault.amount)
            found[fault.tooth] = found.get(fault.tooth, np.zeros((z.size, roll.size))) + moved
    return found


def _softenings(gear: Gear, flank: str, z: Array, roll: Array) -> dict[int, Array]:
    """Additional compliance of cracked teeth [m^2/N], shape (n_z, n_roll) each."""
    from pitchpoint.contact.stiffness.root_crack import crack_compliance, crack_depth
    from pitchpoint.geometry.tooth_form import tooth_form
    from pitchpoint.model.components.tooth_faults import RootCrack

    found: dict[int, Array] = {}
    for fault in gear.faults.values():
        if not isinstance(fault, RootCrack) or fault.flank not in (flank, "both"):
            continue
        depth = crack_depth(z, fault.severity * fault.depth, fault.length, gear.face_width, fault.at)
        steel = gear.material_data
        added = crack_compliance(
            tooth_form(gear.geometry),
            roll,
            depth,
            angle=fault.angle,
            beta=gear.geometry.beta,
            E=steel.youngs_modulus,
            nu=steel.poisson_ratio,
        )
        found[fault.tooth] = found.get(fault.tooth, 0.0) + added
    return found


def _level_stations(gear: Gear) -> tuple[int, int]:
    """Stations over face width and roll length that resolve the smallest pit; the default without pits."""
    from pitchpoint.geometry.pits import stations
    from pitchpoint.model.components.tooth_faults import Pitting

    patches = [p for f in gear.faults.values() if isinstance(f, Pitting) for p in f.on(gear.geometry)]
    return stations(patches, gear.geometry, (N_WIDTH, N_ROLL))


def _levels(gear: Gear, flank: str, z: Array, roll: Array) -> dict[int, Array]:
    """Levels [m] of the teeth with missing material, shape (n_z, n_roll) each."""
    from pitchpoint.geometry.pits import pit_level
    from pitchpoint.geometry.tooth_faults import break_level, tooth_height
    from pitchpoint.model.components.tooth_faults import BrokenTooth, Pitting

    found: dict[int, Array] = {}
    shape = gear.geometry
    for fault in gear.faults.values():
        if isinstance(fault, BrokenTooth):
            width, height = fault.sizes(gear.face_width, tooth_height(shape))
            corner = fault.shape == "corner"
            level = break_level(shape, z, roll, width=width, height=height, at=fault.at, corner=corner)
        elif isinstance(fault, Pitting) and fault.flank in (flank, "both"):
            level = pit_level(shape, z, roll, fault.on(shape), fault.severity)
        else:
            continue
        found[fault.tooth] = np.maximum(found.get(fault.tooth, level), level)
    return found
