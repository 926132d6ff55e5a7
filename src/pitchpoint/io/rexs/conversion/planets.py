# SPDX-License-Identifier: Apache-2.0
"""Planets of a planetary stage: circles of equal planets, their gears, their mates and their places."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from pitchpoint.io.rexs.conversion.frames import frame_of
from pitchpoint.io.rexs.conversion.gears import CYLINDRICAL
from pitchpoint.io.rexs.conversion.hubs import gears_on
from pitchpoint.io.rexs.conversion.meshes import gears_of_stage
from pitchpoint.io.rexs.conversion.state import Conversion, Seat
from pitchpoint.io.rexs.document import RexsComponent

EQUAL = 1e-6
"""Largest difference of distances that count as equal [m]."""
OF_TEETH = (
    *("number_of_teeth", "normal_module", "helix_angle_reference_diameter", "face_width"),
    *("tip_diameter", "root_diameter", "u_coordinate_on_shaft"),
)
"""Attributes in which planets must agree."""


@dataclass
class Planet:
    """One planet.

    Attributes
    ----------
    shaft, gears
        Its shaft, and its gears along u.
    angle, distance, z
        Its place about the axis of the stage [rad], [m], and that of its u = 0 along the axis [m].
    sign
        +1; -1 if u is opposite to the axis of the stage.
    """

    shaft: RexsComponent
    gears: list[RexsComponent]
    angle: float = 0.0
    distance: float = 0.0
    z: float = 0.0
    sign: float = 1.0

    def middle(self, wheel: int) -> float:
        """Mid-face of a gear along the axis of the stage [m]."""
        u = self.gears[wheel].get("u_coordinate_on_shaft")
        return self.z + self.sign * (float(u) if isinstance(u, int | float) else 0.0)


@dataclass
class Mate:
    """What a gear of the planets is in mesh with.

    Attributes
    ----------
    side
        sun, ring or planet.
    gear
        Sun or ring; of planets the gear of the first one.
    meshes
        Cylindrical stages with the gears of each, gear 1 first.
    """

    side: str
    gear: RexsComponent
    meshes: list[tuple[RexsComponent, list[RexsComponent]]]


@dataclass
class Circle:
    """Equal planets on one circle of pins.

    Attributes
    ----------
    planets
        The planets, by their angles.
    mates
        Mates of each gear of the planets.
    inner
        Circle of the inner planets; None without.
    name, planet_name
        Names in the model file.
    """

    planets: list[Planet]
    mates: list[list[Mate]] = field(default_factory=list)
    inner: Circle | None = None
    name: str = ""
    planet_name: str = ""

    @property
    def distance(self) -> float:
        """Distance of the pins from the axis [m]: the median."""
        return float(np.median([planet.distance for planet in self.planets]))

    @property
    def order(self) -> list[int]:
        """Gears of the planets, that which is `planet` in the model file first: it has a sun or a ring."""
        central = [k for k, mates in enumerate(self.mates) if any(m.side != "planet" for m in mates)]
        first = central[0] if central else 0
        return [first, *(k for k in range(len(self.mates)) if k != first)]


def planet_shafts(conversion: Conversion, stage: RexsComponent) -> list[RexsComponent]:
    """Shafts of the planets of a stage."""
    return [
        conversion.source.components[r.roles["shaft"]]
        for r in conversion.source.related("planet_shaft", planetary_stage=stage.id)
    ]


def circles_of(conversion: Conversion, stage: RexsComponent) -> list[Circle]:
    """Circles of planets of a stage, inner ones first; empty with a problem."""
    planets = []
    for shaft in planet_shafts(conversion, stage):
        gears = gears_on(conversion, shaft, *CYLINDRICAL)
        gears.sort(key=lambda gear: float(gear.get("u_coordinate_on_shaft") or 0.0))  # type: ignore[arg-type]
        if not gears:
            conversion.problem(shaft, "has no cylindrical gear", remedy="give every planet its gear")
            return []
        planets.append(Planet(shaft, gears))
    if not planets:
        conversion.problem(stage, "has no planets", remedy="give relations 'planet_shaft'")
        return []
    meshes = _meshes(conversion, planets)
    if meshes is None:
        return []
    return _grouped(conversion, stage, planets, meshes)


Pairs = list[tuple[RexsComponent, list[RexsComponent]]]


def _meshes(conversion: Conversion, planets: list[Planet]) -> Pairs | None:
    """Cylindrical stages of the planets with their gears; None with a problem."""
    own = {gear.id: planet for planet in planets for gear in planet.gears}
    found = []
    for mesh in conversion.source.of_type("cylindrical_stage"):
        gears = gears_of_stage(conversion, mesh)
        inside = [own[gear.id] for gear in gears if gear.id in own]
        if not inside:
            continue
        conversion.done.add(mesh.id)
        if len(inside) == 2 and inside[0] is inside[1]:
            conversion.problem(mesh, "is between two gears of one planet", remedy="correct gear_1 and gear_2")
            return None
        found.append((mesh, gears))
    return found


def _grouped(
    conversion: Conversion, stage: RexsComponent, planets: list[Planet], meshes: Pairs
) -> list[Circle]:
    """Planets with the same suns and rings are one circle."""
    own = {gear.id for planet in planets for gear in planet.gears}
    groups: dict[tuple[frozenset[int], ...], list[Planet]] = {}
    for planet in planets:
        signature = tuple(
            frozenset(
                g.id for _, pair in meshes if gear in pair for g in pair if g is not gear and g.id not in own
            )
            for gear in planet.gears
        )
        groups.setdefault(signature, []).append(planet)
    circles = [Circle(group) for group in groups.values()]
    for circle in circles:
        if not _find_mates(conversion, stage, circle, circles, meshes):
            return []
    if all(not mates for circle in circles for mates in circle.mates):
        what = "has no meshes of its planets"
        conversion.problem(stage, what, remedy="a stage has one sun, one ring, or both")
        return []
    return circles


def _find_mates(
    conversion: Conversion, stage: RexsComponent, circle: Circle, circles: list[Circle], meshes: Pairs
) -> bool:
    """Find suns, rings and planets in mesh with each gear of the planets; False with a problem."""
    owner = {gear.id: c for c in circles for planet in c.planets for gear in planet.gears}
    for wheel in range(len(circle.planets[0].gears)):
        found: dict[str, Mate] = {}
        gears = {planet.gears[wheel].id for planet in circle.planets}
        for mesh, pair in meshes:
            other = [g for g in pair if g.id not in gears]
            if len(other) != 1:
                continue
            mate = other[0]
            side = "planet" if mate.id in owner else "ring" if mate.type == "ring_gear" else "sun"
            one = found.setdefault(side, Mate(side, mate, []))
            if side != "planet" and one.gear.id != mate.id:
                what = "has a gear of the planets with several suns or rings"
                conversion.problem(stage, what, remedy="a gear of the planets has one sun, one ring, or both")
                return False
            if side == "planet" and owner[one.gear.id] is not owner[mate.id]:
                what = "has planets in mesh with two circles of planets"
                conversion.problem(stage, what, remedy="planets mesh with those of one other circle")
                return False
            one.meshes.append((mesh, pair))
        circle.mates.append(list(found.values()))
    return True


def settle_places(conversion: Conversion, circles: list[Circle], axis: Seat) -> bool:
    """Find the places of all planets about the axis of a stage, and order them; False with a problem."""
    base = axis.frame
    for planet in (p for circle in circles for p in circle.planets):
        frame = frame_of(conversion, planet.shaft)
        if frame is None:
            conversion.problem(
                planet.shaft, "has no position", "support_vector", remedy="give support_vector and axes"
            )
            return False
        x, y, planet.z = (float(v) for v in base.axes.T @ (frame.origin - base.origin))
        angle = math.atan2(y, x) % math.tau
        planet.angle = 0.0 if math.tau - angle < 1e-9 else angle  # 360 deg less rounding is 0
        planet.distance = math.hypot(x, y)
        planet.sign = 1.0 if float(frame.z @ base.z) > 0.0 else -1.0
        if abs(float(frame.z @ base.z)) < 1.0 - 1e-9:
            conversion.problem(planet.shaft, "is not parallel to the axis of its stage", "u_axis_vector")
            return False
    circles.sort(key=lambda circle: circle.distance)
    for circle in circles:
        circle.planets.sort(key=lambda planet: planet.angle)
    return all(_follow_inner(conversion, circle, circles) for circle in circles)


def _follow_inner(conversion: Conversion, circle: Circle, circles: list[Circle]) -> bool:
    """Order planets as the inner planets with which they are in mesh, which have a smaller distance."""
    owner = {gear.id: (c, p) for c in circles for p in c.planets for gear in p.gears}
    for mates in circle.mates:
        for mate in [m for m in mates if m.side == "planet"]:
            inner = owner[mate.gear.id][0]
            if circles.index(inner) > circles.index(circle):
                mates.remove(mate)  # given by the outer planets
                continue
            partner = {}
            for _, (one, two) in mate.meshes:
                mine, other = (one, two) if owner[one.id][0] is circle else (two, one)
                partner[id(owner[other.id][1])] = owner[mine.id][1]
            ordered = [partner.get(id(planet)) for planet in inner.planets]
            if None in ordered or len(ordered) != len(circle.planets) or circle.inner not in (None, inner):
                what = "is not in mesh with one planet of the other circle"
                conversion.problem(circle.planets[0].shaft, what, remedy="planets mesh in pairs")
                return False
            circle.planets = [planet for planet in ordered if planet is not None]
            circle.inner = inner
            mate.gear = circle.inner.planets[0].gears[_wheel_of(inner, mate.gear)]
    return True


def _wheel_of(circle: Circle, gear: RexsComponent) -> int:
    """Number of a gear along its planet."""
    return next(p.gears.index(gear) for p in circle.planets if gear in p.gears)


def check_equal(conversion: Conversion, planets: Sequence[Planet]) -> None:
    """Check that all planets have the teeth of the first one."""
    for planet in planets[1:]:
        if len(planet.gears) != len(planets[0].gears):
            conversion.problem(
                planet.shaft, "has another number of gears than the first planet", remedy="planets are equal"
            )
            continue
        for first, gear in zip(planets[0].gears, planet.gears, strict=True):
            conversion.done.add(gear.id)
            for key in OF_TEETH:
                one, two = first.get(key), gear.get(key)
                conversion.used.add((gear.id, key))
                if one != two and abs(float(one or 0.0) - float(two or 0.0)) > EQUAL:  # type: ignore[arg-type]
                    conversion.problem(
                        gear, f"differs from that of {first}", key, str(two), str(one), "planets are equal"
                    )


def places_on_turn(circle: Circle, fitted: bool) -> int:
    """Number of places on a turn of the carrier at which the teeth of planets fit; 0: at any angle.

    Parameters
    ----------
    circle
        The planets.
    fitted
        Whether the teeth of further gears of the planets are oriented at the assembly.
    """
    from pitchpoint.model.planet_spacing import spacing_teeth

    meshes = []
    for k, mates in enumerate(circle.mates):
        part = k if fitted and k != circle.order[0] else 0
        own = int(circle.planets[0].gears[k].get("number_of_teeth") or 0)  # type: ignore[arg-type]
        for mate in mates:
            if mate.side == "planet":
                return 0  # of the chain of planets: checked by the model
            teeth = int(mate.gear.get("number_of_teeth") or 0)  # type: ignore[arg-type]
            meshes.append(({part: own}, -teeth if mate.side == "ring" else teeth))
    return spacing_teeth(meshes) if meshes else 0  # type: ignore[arg-type]


def fitting_angles(circle: Circle, places: int) -> list[float] | None:
    """Angles of the planets at which their teeth fit [rad], from those of the file by pin errors at most.

    None if a planet is farther away from them than `LARGEST_ERROR` modules.
    """
    if places == 0:
        return [planet.angle for planet in circle.planets]
    module = float(circle.planets[0].gears[circle.order[0]].get("normal_module") or 0.0)  # type: ignore[arg-type]
    step = math.tau / places
    for first in (planet.angle for planet in circle.planets):  # most planets have no error
        found = [first + step * round((planet.angle - first) / step) for planet in circle.planets]
        errors = [
            abs(angle - planet.angle) * planet.distance
            for angle, planet in zip(found, circle.planets, strict=True)
        ]
        right = sum(error <= EQUAL for error in errors)
        if max(errors) <= LARGEST_ERROR * module and 2 * right > len(errors):
            return [
                planet.angle if error <= EQUAL else angle
                for angle, error, planet in zip(found, errors, circle.planets, strict=True)
            ]
    return None


LARGEST_ERROR = 0.25
"""Largest error of a pin, in modules: the bottom clearance of the teeth."""
