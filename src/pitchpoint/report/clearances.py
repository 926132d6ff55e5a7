# SPDX-License-Identifier: Apache-2.0
"""Clearances between the assembled gears of a model, compared with limits.

Meshing teeth are solids without modifications, except between front and between back flanks: their distances
include modifications, deviations and misaligned axes. Gears that do not mesh and adjacent shafts are
represented by tip cylinders and shaft sections at the positions of the model file.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.geometry.clearance import (
    ACCURACY,
    BACK,
    FRONT,
    TIP_1_ROOT_2,
    TIP_2_ROOT_1,
    TIP_ROOT,
    Clearance,
    clearances,
)
from pitchpoint.model.frames import body_frame

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    from pitchpoint.geometry.flank_clearance import MicroGeometry
    from pitchpoint.geometry.gear_pair import GearPair
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.model import Model

FACE = "face"
_PARALLEL = 1e-6


@dataclass(frozen=True)
class Room:
    """Distance and its limit.

    Attributes
    ----------
    words
        The two parts, in words.
    distance, limit
        Distance and its minimum [m].
    slack
        Numerical tolerance of the distance below the limit [m].
    where
        Mesh position and location of the minimum, for teeth in mesh.
    """

    words: str
    distance: float
    limit: float = 0.0
    slack: float = 0.0
    where: Clearance | None = None

    @property
    def fine(self) -> bool:
        """Whether the distance is within its limit."""
        return self.distance >= self.limit - self.slack


@dataclass(frozen=True)
class Stage:
    """The clearances of one mesh.

    Attributes
    ----------
    pair
        Gears with tooth thicknesses that give the backlash of the mesh.
    gears
        Names of the gears.
    rooms
        Distances by kind, see `pitchpoint.geometry.clearance.KINDS`, and `FACE`: the common face width, whose
        limit is the narrower face width.
    notes
        Remarks.
    """

    pair: GearPair
    gears: tuple[str, str]
    rooms: dict[str, Room]
    notes: tuple[str, ...] = ()


def stage_of(model: Model, mesh: str) -> Stage:
    """Clearances of an assembled mesh.

    Parameters
    ----------
    model
        The model.
    mesh
        Name of the mesh.

    Raises
    ------
    GeometryError
        If a gear has no valid tooth.
    """
    pair, notes = _pair_as_built(model, mesh)
    first, second = names = model.meshes[mesh].gears
    words = {
        FRONT: "front flanks",
        BACK: "back flanks",
        TIP_1_ROOT_2: f"tip of {first} to root of {second}",
        TIP_2_ROOT_1: f"tip of {second} to root of {first}",
        "tip_1_fillet_2": f"tip of {first} to fillet of {second}",
        "tip_2_fillet_1": f"tip of {second} to fillet of {first}",
        "tips": f"tip of {first} to tip of {second}",
    }
    m_n = pair.gear1.m_n
    found = clearances(pair) | _modified_flanks(model, mesh, pair)
    limits = dict.fromkeys((TIP_1_ROOT_2, TIP_2_ROOT_1), TIP_ROOT * m_n)
    rooms = {
        kind: Room(words[kind], found[kind].distance, limits.get(kind, 0.0), ACCURACY * m_n, found[kind])
        for kind in words
        if kind in found
    }
    narrower = min(model.gears[name].face_width for name in names)
    width = model.meshes[mesh].b_w
    rooms[FACE] = Room("common face width", pair.b_w if width is None else width, narrower, 1e-9 * narrower)
    return Stage(pair, names, rooms, notes + _fillets(pair, names))


def _modified_flanks(model: Model, mesh: str, pair: GearPair) -> dict[str, Clearance]:
    """Clearances of flanks with micro-geometry or misaligned axes; empty for ideal ones."""
    from dataclasses import replace

    from pitchpoint.geometry.flank_clearance import flank_clearances
    from pitchpoint.geometry.flank_distance import Mounting

    part = model.meshes[mesh]
    gears = [model.gears[name] for name in part.gears]
    out_of_plane, in_plane = (0.0, 0.0) if part.misalignment is None else part.misalignment.skew
    straight = in_plane == 0.0 and out_of_plane == 0.0
    if straight and all(gear.modifications is None and gear.deviations is None for gear in gears):
        return {}
    wide = replace(
        pair,
        gear1=replace(pair.gear1, b=gears[0].face_width),
        gear2=replace(pair.gear2, b=gears[1].face_width),
    )
    # axis 2 tilts about the pitch point, which has no axial motion then
    offset = part.offset1 - part.offset2 - 0.5 * pair.d_w2 * in_plane
    mounting = Mounting(pair=wide, offset=offset, in_plane=in_plane, out_of_plane=out_of_plane)
    return flank_clearances(mounting, (_micro(gears[0]), _micro(gears[1])))


def _micro(gear: Gear) -> MicroGeometry:
    """Modifications and deviations of a gear."""
    from pitchpoint.geometry.flank_clearance import MicroGeometry

    sides = {}
    if gear.modifications is not None:
        for side in ("left", "right"):
            own = gear.modifications.side(side)
            sides[side] = None if own is None else own.of_geometry()
    return MicroGeometry(
        **sides, deviations=None if gear.deviations is None else gear.deviations.of_geometry()
    )


def _fillets(pair: GearPair, names: tuple[str, str]) -> tuple[str, ...]:
    """Notes on tips that meet a fillet instead of an involute."""
    from pitchpoint.geometry.flank_clearance import below_form

    return tuple(
        f"interference of the tip of {tip} with the fillet of {root}: contact would lie below the root form "
        f"circle of {root}"
        for root, tip, below in zip(names, names[::-1], below_form(pair), strict=True)
        if below
    )


def _pair_as_built(model: Model, mesh: str) -> tuple[GearPair, tuple[str, ...]]:
    """Pair with teeth thinned equally to the backlash of the mesh; roots unchanged."""
    from dataclasses import replace

    pair = model.pairs[mesh]
    more = model.backlash(mesh) - pair.j_bt
    if abs(more) < 1e-12:
        return pair, ()
    if pair.gear1.outline is not None or pair.gear2.outline is not None:
        return pair, ("computed from the actual teeth, not from the backlash given in the file",)
    thinner = 0.5 * more * math.cos(pair.gear1.beta) / math.cos(pair.gear1.alpha_t)

    def thinned(gear: CylindricalGear) -> CylindricalGear:
        """Gear with thinner teeth and unchanged root and tip circles."""
        allowance = gear.thickness_allowance - thinner
        return replace(gear, thickness_allowance=allowance, root_diameter=gear.d_fE, tip_diameter=gear.d_a)

    return replace(pair, gear1=thinned(pair.gear1), gear2=thinned(pair.gear2)), ()


def neighbours(model: Model) -> list[Room]:
    """Clearances between gears that do not mesh and between gears and shafts, smallest first.

    Parameters
    ----------
    model
        Model with bodies. Evaluated are parts on parallel axes that overlap axially and whose distance is
        less than half of the smaller tip diameter, at the positions of the model file.
    """
    rounds = _gears(model) + _sections(model)
    mates = {frozenset(mesh.gears) for mesh in model.meshes.values()}
    found: dict[tuple[str, str], Room] = {}
    for one, two in combinations(rounds, 2):
        if one.body == two.body or frozenset((one.name, two.name)) in mates:
            continue
        if not (one.is_gear or two.is_gear) or np.linalg.norm(np.cross(one.axis, two.axis)) > _PARALLEL:
            continue
        apart = two.middle - one.middle
        along = float(apart @ one.axis)
        if abs(along) >= 0.5 * (one.width + two.width):
            continue
        distance = float(np.linalg.norm(apart - along * one.axis)) - one.radius - two.radius
        sizes = [part.radius for part in (one, two) if part.is_gear]
        key = (one.name, two.name)
        if distance < min(sizes) and (key not in found or distance < found[key].distance):
            words = " to ".join(f"{'tip of ' if p.is_gear else 'shaft '}{p.name}" for p in (one, two))
            found[key] = Room(words, distance)
    return sorted(found.values(), key=lambda room: room.distance)


@dataclass(frozen=True)
class _Round:
    """Tip cylinder or section of a shaft."""

    name: str
    body: str
    is_gear: bool
    middle: NDArray[np.float64]
    axis: NDArray[np.float64]
    radius: float
    width: float


def _gears(model: Model) -> list[_Round]:
    """Tip cylinders of the external gears on bodies with a position."""
    found = []
    for name, gear in model.gears.items():
        body = model.body_of(name)
        if body is None or gear.type == "internal":
            continue
        origin, axes = body_frame(model, body)
        if origin is not None:
            middle = origin + model.bodies[body].gears[name] * axes[:, 2]
            radius = 0.5 * gear.geometry.d_a
            found.append(_Round(name, body, True, middle, axes[:, 2], radius, gear.face_width))
    return found


def _sections(model: Model) -> list[_Round]:
    """Sections of the elastic shafts."""
    found = []
    for name, shaft in model.shafts.items():
        origin, axes = body_frame(model, name)
        if origin is None:
            continue
        start = 0.0
        for section in shaft.sections:
            middle = origin + (start + 0.5 * section.length) * axes[:, 2]
            radius = 0.5 * section.diameter
            found.append(_Round(name, name, False, middle, axes[:, 2], radius, section.length))
            start += section.length
    return found


def clearance_numbers(stages: dict[str, Stage], others: list[Room]) -> dict[str, Any]:
    """Output of `clearance --json`.

    Parameters
    ----------
    stages
        Clearances by mesh.
    others
        Clearances between parts that do not mesh.
    """
    meshes = {}
    for name, stage in stages.items():
        rows = {kind: _numbers(room) for kind, room in stage.rooms.items()}
        for kind in (FRONT, BACK):
            if kind in rows:
                rows[kind]["normal"] = stage.rooms[kind].distance * math.cos(stage.pair.gear1.beta_b)
        meshes[name] = {"gears": list(stage.gears), "clearances": rows, "notes": list(stage.notes)}
    rooms = [room for stage in stages.values() for room in stage.rooms.values()] + others
    return {
        "meshes": meshes,
        "neighbours": [_numbers(room) for room in others],
        "fine": all(room.fine for room in rooms),
    }


def _numbers(room: Room) -> dict[str, Any]:
    found: dict[str, Any] = {
        "between": room.words,
        "distance": room.distance,
        "limit": room.limit,
        "fine": room.fine,
    }
    if room.where is not None:
        found["places"] = [list(room.where.place1), list(room.where.place2)]
        found["rotations"] = [room.where.phi1, room.where.phi2]
    return found
