# SPDX-License-Identifier: Apache-2.0
"""Gears of a scene: one tooth per shape, and the angles of its copies.

Micro-geometry, deviations of single teeth and missing material of damaged teeth are drawn as in the contact
model. Every tooth has several levels of detail, graded by the deviation of its chords from the exact tooth.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.gear_sector import (
    Gap,
    Outline,
    Sector,
    gear_sector,
    pitch_outline,
    slices_for,
)
from pitchpoint.geometry.tooth_faults import tooth_height
from pitchpoint.geometry.tooth_form import root_radius
from pitchpoint.model.components.gear_faults import Eccentricity, Wobble
from pitchpoint.model.components.tooth_faults import BrokenTooth, Pitting, RootCrack, Wear
from pitchpoint.system.rules.separation import GAP, LEVEL, own_teeth
from pitchpoint.viz.scene.content import SceneLevel, ScenePiece, SceneSolid

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.model import Model
    from pitchpoint.system.rules.separation import OwnTeeth

Array = NDArray[np.float64]

ERRORS = (0.2, 0.04, 4e-3)
"""Chord errors of the coarser levels, in modules."""
FINEST = (1e-6, 1e-4)
"""Chord error of the finest level on the flanks: maximum of a length [m] and a fraction of the module."""
OWN_SLICES = 16
"""Slices of the finest level for flanks that vary along the face."""
DAMAGED = (24, 48)
"""Maximum points of a damaged flank and slices of a damaged tooth, coarse and fine."""
NOTHING = 1e-9
"""Gaps below this are not drawn [m]."""
MAX_POINTS = 400
"""Maximum number of points of a flank per slice."""


def gear_part(
    model: Model, name: str, seat: tuple[int, Array, Array], thinner: float, room: float = 0.0
) -> tuple[SceneSolid, list[str]]:
    """Gear, and remarks on its invisible faults.

    Parameters
    ----------
    model
        The model.
    name
        Name of the gear.
    seat
        Index of its body in the scene, its middle [m] and the axes of its body in that frame.
    thinner
        Reduction of the normal tooth thickness for the backlash of its meshes [m].
    room
        Outside diameter of a bearing in the gear, which is its bore if none is given [m].

    Raises
    ------
    GeometryError
        If teeth or blank are impossible.
    """
    gear = model.gears[name]
    if gear.type == "external" and gear.bore_diameter == 0.0 and room < gear.geometry.d_f:
        gear = replace(gear, bore_diameter=room)
    teeth = _Teeth.of(gear, thinner)
    shift, lean = _seat(gear)
    number, place, frame = seat
    turn = model.phasing.tooth_angle[name]
    c, s = math.cos(turn), math.sin(turn)
    axes = frame @ np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    solid = SceneSolid(
        name=name,
        kind="gear",
        body=number,
        teeth=gear.number_of_teeth,
        place=place + axes @ np.array([shift.real, shift.imag, 0.0]),
        axes=axes @ _leaning(lean),
        pieces=teeth.pieces(),
    )
    return solid, _unseen(name, gear)


def _unseen(name: str, gear: Gear) -> list[str]:
    """Remarks on faults that are not drawn."""
    found = []
    for label, fault in gear.faults.items():
        if isinstance(fault, Wear) and fault.severity > 0.0:
            size = "" if fault.depth is None else f", {1e6 * fault.severity * fault.depth:.3g} µm at most"
            found.append(f"wear of {name} ({label}{size}) is included in the forces, but not drawn")
        if isinstance(fault, RootCrack) and fault.severity > 0.0:
            deep = f"{1e3 * fault.severity * fault.depth:.3g} mm"
            found.append(f"root crack of {name}, tooth {fault.tooth} ({label}, {deep}) is marked, not drawn")
    return found


def _seat(gear: Gear) -> tuple[complex, complex]:
    """Displacement of the teeth [m] and tilt of their axis [rad], from the centre of tooth 0."""
    shift, lean = 0j, 0j
    for fault in gear.faults.values():
        if isinstance(fault, Eccentricity | Wobble):
            towards = fault.severity * fault.amount * complex(math.cos(fault.phase), math.sin(fault.phase))
            shift, lean = (
                (shift + towards, lean) if isinstance(fault, Eccentricity) else (shift, lean + towards)
            )
    return shift, lean


def _leaning(lean: complex) -> Array:
    """Axes with the third tilted towards a direction in the plane of the first two."""
    from scipy.spatial.transform import Rotation

    return np.asarray(Rotation.from_rotvec([-lean.imag, lean.real, 0.0]).as_matrix())


@dataclass(frozen=True)
class _Teeth:
    """Gear with drawn teeth.

    Attributes
    ----------
    gear, shape
        Gear, and its geometry with the backlash of its meshes.
    own
        Deviations of its teeth; None if all are equal and exact.
    """

    gear: Gear
    shape: CylindricalGear
    own: OwnTeeth | None

    @classmethod
    def of(cls, gear: Gear, thinner: float) -> _Teeth:
        """Teeth of a gear, thinned by a normal thickness [m]."""
        shape = gear.geometry
        shape = replace(shape, thickness_allowance=shape.thickness_allowance - thinner)
        plain = not gear.is_modified and not gear.tooth_faults
        return cls(gear, shape, None if plain else own_teeth(gear, mate=False))

    def pieces(self) -> list[ScenePiece]:
        """One piece for all intact teeth, and one for every damaged tooth."""
        z = self.gear.number_of_teeth
        damaged: dict[int, list[tuple[str, BrokenTooth | Pitting | RootCrack]]] = {}
        for label, fault in self.gear.faults.items():
            if isinstance(fault, BrokenTooth | Pitting | RootCrack) and fault.severity > 0.0:
                damaged.setdefault(fault.tooth, []).append((label, fault))
        sound = np.array([t for t in range(z) if t not in damaged], np.int64)
        pitch = 2.0 * math.pi / z
        found = []
        if sound.size:
            gap, shifts = self._common(sound)
            found.append(ScenePiece(pitch * sound + shifts, self._levels(gap)))
        for tooth, faults in damaged.items():
            labels = [f"tooth {tooth}: {label} ({fault.form.replace('_', ' ')})" for label, fault in faults]
            sectors = self._damaged(tooth, [fault for _, fault in faults])
            turn = np.array([pitch * tooth])
            # the blank below a damaged tooth is intact
            damage = [SceneLevel(error, *s.part(0, s.blank)) for error, s in sectors]
            blank = [SceneLevel(error, *s.part(s.blank, len(s.triangles))) for error, s in sectors]
            found += [ScenePiece(turn, damage, "; ".join(labels)), ScenePiece(turn, blank)]
        return found

    @property
    def _resolution(self) -> int | None:
        """Points of a flank requested by the model, limited by the page size."""
        asked = self.gear.drawing_resolution
        return None if asked is None else min(asked, MAX_POINTS)

    def _grid(self, layer: int, flank: int, tooth: int) -> Array | None:
        """Grid of a flank in a layer."""
        assert self.own is not None
        row = int(self.own.rows[flank, tooth % self.own.teeth, layer])
        return None if row < 0 else (self.own.levels if layer == LEVEL else self.own.smooth)[row]

    def _common(self, sound: NDArray[np.int64]) -> tuple[Gap | None, Array]:
        """Mean deviation of all intact teeth, and the angular pitch deviation of each [rad]."""
        shifts = np.zeros(sound.size)
        if self.own is None:
            return None, shifts
        means, sums = [], np.zeros((2, sound.size))
        for flank in range(2):
            grids = [self._grid(GAP, flank, int(t)) for t in sound]
            zero = np.zeros(self.own.stations[0])
            means.append(np.mean([zero if g is None else g for g in grids], axis=0))
            sums[flank] = [0.0 if g is None else float(g.mean()) for g in grids]
        # a tooth displaced counter-clockwise lacks less material on its left flank than on its right one
        r_b = 0.5 * abs(self.shape.d_b)
        shifts = 0.5 * (sums[1] - sums[0]) / r_b
        shifts -= np.median(shifts)
        means = [means[0] + r_b * shifts.mean(), means[1] - r_b * shifts.mean()]
        if max(float(np.abs(mean).max()) for mean in means) < NOTHING:
            return None, shifts
        return self._read([[mean] for mean in means]), shifts

    def _read(self, grids: list[list[Array]], levels: list[Array | None] | None = None) -> Gap:
        """Reader of grids of both flanks, left first: the sum of smooth ones, and levels above 0."""
        from scipy.interpolate import RegularGridInterpolator

        assert self.own is not None
        sides = []
        for flank in range(2):
            stacks = [(grid, 0) for grid in grids[flank]]
            if levels is not None and (level := levels[flank]) is not None:
                stacks.append((level, 1))
            readers = []
            for grid, stack in stacks:
                n_z, n_x = self.own.stations[stack]
                roll = np.linspace(*self.own.span, n_x)
                z = np.linspace(-0.5, 0.5, n_z) * self.gear.face_width
                step = 1 if roll[-1] > roll[0] else -1
                readers.append((RegularGridInterpolator((z, roll[::step]), grid[:, ::step]), stack))
            sides.append(readers)
        low, high = sorted(self.own.span)

        def gap(flank: str, z: float, roll: Array) -> Array:
            """Missing material of a flank along the base tangent [m]."""
            at = np.column_stack([np.full(roll.size, z), np.clip(roll, low, high)])
            lacks = np.zeros(roll.size)
            for reader, stack in sides[0 if flank == "left" else 1]:
                value = reader(at)
                lacks += np.maximum(value, 0.0) if stack else value
            return lacks

        return gap

    def _sector(
        self, outline: Outline, sections: list[tuple[float, float | None]], gap: Gap | None
    ) -> Sector:
        """One pitch with the blank of the gear."""
        return gear_sector(
            self.shape,
            outline,
            sections,
            gap=gap,
            bore_diameter=self.gear.bore_diameter,
            rim_thickness=self.gear.rim_thickness,
            web_thickness=self.gear.web_thickness,
        )

    def _levels(self, gap: Gap | None) -> list[SceneLevel]:
        """Intact tooth from coarse to fine."""
        found = []
        coarse = [e * self.shape.m_n for e in ERRORS]
        for error in (*coarse, max(FINEST[0], FINEST[1] * self.shape.m_n)):
            finest = error < coarse[-1]
            resolution = self._resolution if finest else None
            outline = pitch_outline(
                self.shape, error, resolution, min(10.0 * error, coarse[-1]) if finest else error
            )
            heights = slices_for(self.shape, 10.0 * error if finest else error)
            if finest and gap is not None and heights.size <= OWN_SLICES:
                heights = np.linspace(-0.5, 0.5, OWN_SLICES + 1) * self.shape.b
            sector = self._sector(outline, [(float(z), None) for z in heights], gap if finest else None)
            found.append(SceneLevel(error, sector.points, sector.triangles))
        return found

    def _damaged(
        self, tooth: int, faults: list[BrokenTooth | Pitting | RootCrack]
    ) -> list[tuple[float, Sector]]:
        """Pitch of a damaged tooth from coarse to fine."""
        assert self.own is not None
        smooth: list[list[Array]] = []
        for flank in range(2):
            grid = self._grid(GAP, flank, tooth)
            smooth.append([] if grid is None else [grid])
        gap = self._read(smooth, [self._grid(LEVEL, flank, tooth) for flank in range(2)])
        breaks = [f for f in faults if isinstance(f, BrokenTooth)]
        pits = [p for f in faults if isinstance(f, Pitting) for p in f.on(self.gear.geometry)]
        found = []
        for most, error in zip(DAMAGED, ERRORS[1:], strict=True):
            slices = most if pits else 12
            heights = set(slices_for(self.shape, error * self.shape.m_n)) | set(
                np.linspace(-0.5, 0.5, slices + 1) * self.shape.b
            )
            sections = _sections(self.gear, self.shape, breaks, sorted(float(h) for h in heights))
            # without pits the outline of an intact tooth is fine enough
            resolution = max(most, self._resolution or 5) if pits else None
            outline = pitch_outline(self.shape, error * self.shape.m_n, resolution)
            found.append((error * self.shape.m_n, self._sector(outline, sections, gap)))
        return found


def _sections(
    gear: Gear, shape: CylindricalGear, breaks: list[BrokenTooth], heights: list[float]
) -> list[tuple[float, float | None]]:
    """Positions along the face and radius at which a broken tooth ends; a transverse edge is a step."""
    if not breaks:
        return [(z, None) for z in heights]
    sizes = [(*fault.sizes(shape.b, tooth_height(shape)), fault) for fault in breaks]
    steps = []
    for width, _, fault in sizes:
        if width < shape.b * (1.0 - 1e-9):
            steps.append((1.0 if fault.at == "start" else -1.0) * (width - 0.5 * shape.b))
    tip, inwards = 0.5 * abs(shape.d_a), -1.0 if gear.type != "internal" else 1.0
    deepest = abs(tip - root_radius(shape))

    def limit(z: float) -> float | None:
        """Radius of the end of the tooth [m]."""
        missing = 0.0
        for width, height, fault in sizes:
            zeta = 0.5 * shape.b + (z if fault.at == "start" else -z)
            if fault.shape == "corner":
                missing = max(missing, height * (1.0 - zeta / width))
            elif zeta < width or width >= shape.b * (1.0 - 1e-9):
                missing = max(missing, height)
        return tip + inwards * min(missing, deepest) if missing > 0.0 else None

    near = 1e-6 * shape.b
    found = [(z, limit(z)) for z in heights if all(abs(z - s) > near for s in steps)]
    for s in steps:
        found += [(s - near, limit(s - near)), (s + near, limit(s + near))]
    return sorted(found, key=lambda section: section[0])
