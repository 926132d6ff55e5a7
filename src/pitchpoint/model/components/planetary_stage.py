# SPDX-License-Identifier: Apache-2.0
"""A planetary stage: planets between a sun, a ring, or both, on the pins of a carrier."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.components.gear import Gear
from pitchpoint.model.components.gear_faults import SeatFault
from pitchpoint.model.components.modifications import Deviations, Modifications
from pitchpoint.model.components.six import Damping6, Stiffness6
from pitchpoint.model.components.stage_mesh import SingleMesh, StageMesh
from pitchpoint.model.components.tooth_faults import ToothFault
from pitchpoint.model.keys import (
    REQUIRED,
    boolean,
    choice,
    component,
    derived,
    integer,
    key,
    positive,
    quantities,
    quantity,
    same_key,
    text,
)

JOINTS = {"torsion": "revolute", "planar": "planar", "free": "shaft"}
"""Joint between carrier and planet for each motion of the planets."""
SIDES = ("sun", "ring", "planet")
"""Mates of planets; planet: inner planets."""


@dataclass(frozen=True, kw_only=True)
class PlanetBearing(Component):
    """Bearing of every planet on its pin, with the bending of the pin; for motion: planar or free."""

    stiffness: Stiffness6 = component(Stiffness6, "stiffness in six directions", Stiffness6())
    damping: Damping6 | None = component(Damping6, "damping in the same directions, or a damping ratio")
    position: float = quantity(
        "length", "axial position of the bearing from the mid-face of planet", 0.0, later=True
    )
    pin_stiffness: float | None = positive(
        "stiffness",
        "bending stiffness of the pin at the planet, in series with the bearing along x and y",
        None,
        display="rigid pin",
    )

    def on_pin(self) -> Stiffness6:
        """Stiffness of bearing and pin in series."""
        if self.pin_stiffness is None:
            return self.stiffness
        rows = [list(row) for row in self.stiffness.matrix6()]
        for k in (0, 1):
            rows[k][k] = 1.0 / (1.0 / rows[k][k] + 1.0 / self.pin_stiffness) if rows[k][k] > 0.0 else 0.0
        return Stiffness6(matrix=tuple(tuple(row) for row in rows))


@dataclass(frozen=True, kw_only=True)
class PinError(Component):
    """Error of the position of one pin on the carrier."""

    tangential: float = quantity(
        "length", "along the circle of the pins, positive counter-clockwise about the z axis", 0.0
    )
    radial: float = quantity("length", "positive away from the axis of the carrier", 0.0)


@dataclass(frozen=True, kw_only=True)
class SingleStep(Component):
    """Data of one step of a single planet that replace the common ones."""

    faults: Mapping[str, ToothFault | SeatFault] = same_key(Gear, "faults")
    modifications: Modifications | None = same_key(Gear, "modifications")
    deviations: Deviations | None = same_key(Gear, "deviations")
    tooth_thickness_allowance: float | None = quantity(
        "length", "normal tooth thickness allowance", None, display="that of planet"
    )
    sun_mesh: SingleMesh = component(SingleMesh, "mesh with the sun", SingleMesh(), later=True)
    ring_mesh: SingleMesh = component(SingleMesh, "mesh with the ring", SingleMesh(), later=True)
    planet_mesh: SingleMesh = component(SingleMesh, "mesh with the inner planet", SingleMesh(), later=True)


@dataclass(frozen=True, kw_only=True)
class SinglePlanet(SingleStep):
    """Data of one planet that replace the common ones."""

    steps: Mapping[str, SingleStep] = key(
        "components", "data of its steps, by name", {}, of=SingleStep, later=True
    )


@dataclass(frozen=True, kw_only=True)
class PlanetStep(Component):
    """A further gear of every planet, and its mates."""

    gear: Gear = component(Gear, "gear data of the step on every planet", REQUIRED)
    position: float = quantity(
        "length", "axial position of its mid-face from that of the gear given as planet", REQUIRED
    )
    sun: str | None = text("name of a sun gear in mesh with the step", None, display="no sun")
    ring: str | None = text("name of an internal gear in mesh with the step", None, display="no ring")
    inner_planets: str | None = text(
        "planet_name of another stage, whose planets are in mesh with the step", None, display="none"
    )
    orientation: float | None = quantity(
        "angle",
        "angle from the centre of a tooth of planet to that of a tooth of the step, at their mid-faces",
        None,
        display="that of the teeth in mesh, as rings and suns are assembled",
    )
    fitted: bool = boolean(
        "the teeth of each planet are oriented at its assembly, so that planets need not be equal", False
    )
    sun_mesh: StageMesh | None = component(
        StageMesh, "meshes with the sun", None, display="sun_mesh of the stage"
    )
    ring_mesh: StageMesh | None = component(
        StageMesh, "meshes with the ring", None, display="ring_mesh of the stage"
    )
    planet_mesh: StageMesh | None = component(
        StageMesh, "meshes with the inner planets", None, display="planet_mesh of the stage"
    )


@dataclass(frozen=True)
class Wheel:
    """One gear of every planet, and its mates.

    Parameters
    ----------
    step
        Name of the step; "" for the gear given as `planet`.
    gear, position
        Its data and the axial position of its mid-face on the planet [m].
    mates
        Names of sun and ring, and the planet_name of inner planets, by side: sun, ring, planet.
    settings
        Settings of the meshes by side.
    key
        Keys of the stage that lead to it.
    """

    step: str
    gear: Gear
    position: float
    mates: Mapping[str, str]
    settings: Mapping[str, StageMesh]
    key: tuple[str, ...]

    def of(self, planet: str) -> str:
        """Name of the gear on a planet."""
        return f"{planet}-{self.step}" if self.step else planet


@dataclass(frozen=True)
class MeshGroup:
    """Parallel meshes of all planets of a stage with one mate.

    Parameters
    ----------
    side, mate
        sun, ring or planet, and the name of the gear or of the inner planets.
    wheel
        Gear of the planets.
    gears
        Gear 1 and gear 2 of every mesh, in the order of the planets.
    """

    side: str
    mate: str
    wheel: Wheel
    gears: tuple[tuple[str, str], ...]

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the meshes."""
        return tuple(f"{one}-{two}" for one, two in self.gears)

    @property
    def key(self) -> tuple[str, ...]:
        """Keys of the stage with the settings of the meshes."""
        return (*self.wheel.key, f"{self.side}_mesh")


@dataclass(frozen=True, kw_only=True)
class PlanetaryStage(Component):
    """Equal planets on the pins of a carrier, in mesh with suns, rings, or the planets of another stage.

    The stage represents the gears, bodies, pins, bearings and meshes of its planets.
    """

    sun: str | None = text("name of the sun gear", None, display="no sun")
    ring: str | None = text("name of the internal gear", None, display="no ring")
    inner_planets: str | None = text(
        "planet_name of another stage on the same carrier; each planet is in mesh with the inner planet of "
        "the same number",
        None,
        display="none",
        later=True,
    )
    carrier: str = text("body that carries the pins; without position it is on the axis of sun and ring")
    pins: tuple[str, ...] | None = key(
        "names",
        "nodes of an elastic carrier, or markers of another body, that carry the planets, in their order",
        None,
        display="the carrier itself",
        later=True,
    )
    planet: Gear = component(Gear, "gear data of every planet", REQUIRED)
    planets: int | None = integer(
        "number of planets, at equal angles; with inner_planets each at the same angle from its inner planet",
        None,
        minimum=1,
        maximum=50,
        one_of="places",
        sample="3",
        also=("number_of_planets",),
    )
    angles: tuple[float, ...] | None = quantities(
        "angle",
        "angles of the planets from the x axis of sun and ring, counter-clockwise about the z axis",
        None,
        length=(1, 50),
        one_of="places",
        sample="[0 deg, 90 deg, 180 deg, 270 deg]",
    )
    planet_name: str = text("names of the planets: planet_1, planet_2, ...", "planet")
    center_distance: float | None = positive(
        "length",
        "distance of the pins from the axis, without pin errors",
        None,
        maximum=50.0,
        display="zero backlash from the profile shifts",
    )
    position: float = quantity(
        "length",
        "axial position of the mid-face of planet from that of sun or ring in mesh with it",
        0.0,
        later=True,
    )
    planet_center_distance: float | None = positive(
        "length",
        "centre distance of planets and inner planets, which determines the angle between them",
        None,
        maximum=50.0,
        display="zero backlash from the profile shifts",
        later=True,
    )
    planet_side: str = choice(
        ("counter_clockwise", "clockwise"),
        "side of each inner planet on which the planet in mesh with it is",
        "counter_clockwise",
        later=True,
    )
    steps: Mapping[str, PlanetStep] = key(
        "components", "further gears of stepped planets, by name", {}, of=PlanetStep, later=True
    )
    motion: str = choice(
        tuple(JOINTS),
        "degrees of freedom of the planets on their pins; torsion: spin; planar: x, y, spin; free: all six",
        "torsion",
    )
    planet_mass: float | None = quantity(
        "mass", "mass of one planet with its bearings", None, minimum=0.0, display="of the gear"
    )
    planet_inertia: float | None = quantity(
        "inertia", "polar moment of inertia of one planet", None, minimum=0.0, display="of the gear"
    )
    planet_transverse_inertia: float | None = quantity(
        "inertia",
        "moment of inertia of one planet about a diameter",
        None,
        minimum=0.0,
        display="of the gear",
    )
    bearing: PlanetBearing | None = component(PlanetBearing, "bearing of every planet on its pin")
    pin_errors: Mapping[str, PinError] = key(
        "components", "position errors of single pins, by the name of the planet", {}, of=PinError
    )
    single_planets: Mapping[str, SinglePlanet] = key(
        "components", "data of single planets, such as faults, by name", {}, of=SinglePlanet
    )
    sun_mesh: StageMesh = component(StageMesh, "meshes with the sun", StageMesh())
    ring_mesh: StageMesh = component(StageMesh, "meshes with the ring", StageMesh())
    planet_mesh: StageMesh = component(StageMesh, "meshes with the inner planets", StageMesh(), later=True)

    inner_angles: tuple[float, ...] = derived(())
    """Angles of the inner planets [rad]; empty until they are known."""
    lead: float = derived(0.0)
    """Angle from each inner planet to its planet [rad]."""

    @property
    def places(self) -> tuple[float, ...]:
        """Angle of every planet [rad]."""
        if self.angles is not None:
            return self.angles
        count = self.planets or 0
        if len(self.inner_angles) == count:
            return tuple(angle + self.lead for angle in self.inner_angles)
        return tuple(math.tau * k / count for k in range(count))

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the planets: of their gears and of their bodies."""
        return names_of(self.planet_name, len(self.angles or ()) or self.planets or 0)

    @property
    def seats(self) -> tuple[str, ...]:
        """What carries each planet: BODY.PIN, or the carrier itself without `pins`."""
        named = [f"{self.carrier}.{pin}" for pin in self.pins or ()]
        count = len(self.names)
        return tuple((named + [self.carrier] * count)[:count])

    @property
    def wheels(self) -> tuple[Wheel, ...]:
        """Gears of every planet: that given as `planet`, then the steps."""
        own: dict[str, StageMesh] = {}
        found = []
        parts: dict[str, PlanetaryStage | PlanetStep] = {"": self, **self.steps}
        for step, part in parts.items():
            settings = {side: getattr(part, f"{side}_mesh") or own[side] for side in SIDES}
            own = own or settings
            named = {"sun": part.sun, "ring": part.ring, "planet": part.inner_planets}
            mates = {side: mate for side, mate in named.items() if mate is not None}
            gear = part.gear if isinstance(part, PlanetStep) else part.planet
            position = part.position if isinstance(part, PlanetStep) else 0.0
            found.append(Wheel(step, gear, position, mates, settings, ("steps", step) if step else ()))
        return tuple(found)

    @property
    def groups(self) -> tuple[MeshGroup, ...]:
        """Groups of parallel meshes: of every gear of the planets with sun, ring and inner planets."""
        found = []
        for wheel in self.wheels:
            own = tuple(map(wheel.of, self.names))
            for side, mate in wheel.mates.items():
                others = names_of(mate, len(own)) if side == "planet" else (mate,) * len(own)
                pairs = zip(own, others, strict=True) if side == "ring" else zip(others, own, strict=True)
                found.append(MeshGroup(side, mate, wheel, tuple(pairs)))
        return tuple(found)

    @property
    def meshes(self) -> tuple[str, ...]:
        """Names of all meshes."""
        return tuple(name for group in self.groups for name in group.names)


def names_of(planet_name: str, count: int) -> tuple[str, ...]:
    """Names of planets.

    Examples
    --------
    >>> names_of("planet", 2)
    ('planet_1', 'planet_2')
    """
    return tuple(f"{planet_name}_{k}" for k in range(1, count + 1))
