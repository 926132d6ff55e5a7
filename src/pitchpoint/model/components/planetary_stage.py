# SPDX-License-Identifier: Apache-2.0
"""A planetary stage: planets between a sun, a ring, or both, on the pins of a carrier."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.components.flank_contact import FlankContact
from pitchpoint.model.components.gear import Gear
from pitchpoint.model.components.gear_faults import SeatFault
from pitchpoint.model.components.mesh import (
    Backlash,
    ContactDamping,
    Damper,
    Friction,
    Mesh,
    Misalignment,
    TransientDamping,
    TransmissionError,
)
from pitchpoint.model.components.modifications import Deviations, Modifications
from pitchpoint.model.components.six import Damping6, Stiffness6
from pitchpoint.model.components.stiffness import StiffnessLaw
from pitchpoint.model.components.tooth_faults import ToothFault
from pitchpoint.model.keys import (
    REQUIRED,
    choice,
    component,
    integer,
    key,
    keys_of,
    positive,
    quantities,
    quantity,
    same_key,
    text,
)

JOINTS = {"torsion": "revolute", "planar": "planar", "free": "shaft"}
"""Joint between carrier and planet for each motion of the planets."""


@dataclass(frozen=True, kw_only=True)
class StageMesh(Component):
    """Settings of all meshes of the planets with the sun, or with the ring."""

    backlash: Backlash | None = same_key(Mesh, "backlash")
    stiffness: StiffnessLaw = same_key(Mesh, "stiffness")
    contact: FlankContact | None = same_key(Mesh, "contact")
    width: str = same_key(Mesh, "width")
    slices: int = same_key(Mesh, "slices")
    damping: ContactDamping | None = same_key(Mesh, "damping")
    damper: Damper | None = same_key(Mesh, "damper")
    transient_damping: TransientDamping | None = same_key(Mesh, "transient_damping")
    friction: Friction | None = same_key(Mesh, "friction")
    transmission_error: TransmissionError | None = same_key(Mesh, "transmission_error")
    misalignment: Misalignment | None = same_key(Mesh, "misalignment")

    def between(self, gears: tuple[str, str], own: SingleMesh, **more: object) -> Mesh:
        """Mesh of two gears with these settings, and those of a single planet."""
        values = {name: getattr(self, name) for name in keys_of(StageMesh)} | own.given
        return Mesh(gears=gears, **values, **more)  # type: ignore[arg-type]


@dataclass(frozen=True, kw_only=True)
class SingleMesh(Component):
    """Settings of the mesh of one planet with the sun, or with the ring, that replace the common ones."""

    backlash: Backlash | None = same_key(Mesh, "backlash")
    damping: ContactDamping | None = same_key(Mesh, "damping")
    damper: Damper | None = same_key(Mesh, "damper")
    friction: Friction | None = same_key(Mesh, "friction")
    transmission_error: TransmissionError | None = same_key(Mesh, "transmission_error")
    misalignment: Misalignment | None = same_key(Mesh, "misalignment")

    @property
    def given(self) -> dict[str, object]:
        """Settings that are not those of the stage."""
        values = {name: getattr(self, name) for name in keys_of(SingleMesh)}
        return {name: value for name, value in values.items() if value is not None}


@dataclass(frozen=True, kw_only=True)
class PlanetBearing(Component):
    """Bearing of every planet on its pin, with the bending of the pin; for motion: planar or free."""

    stiffness: Stiffness6 = component(Stiffness6, "stiffness in six directions", Stiffness6())
    damping: Damping6 | None = component(Damping6, "damping in the same directions, or a damping ratio")
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
class SinglePlanet(Component):
    """Data of one planet that replace the common ones."""

    faults: Mapping[str, ToothFault | SeatFault] = same_key(Gear, "faults")
    modifications: Modifications | None = same_key(Gear, "modifications")
    deviations: Deviations | None = same_key(Gear, "deviations")
    tooth_thickness_allowance: float | None = quantity(
        "length", "normal tooth thickness allowance", None, display="that of planet"
    )
    sun_mesh: SingleMesh = component(SingleMesh, "mesh with the sun", SingleMesh(), later=True)
    ring_mesh: SingleMesh = component(SingleMesh, "mesh with the ring", SingleMesh(), later=True)


@dataclass(frozen=True, kw_only=True)
class PlanetaryStage(Component):
    """Equal planets on the pins of a carrier, in mesh with a sun, a ring, or both.

    The stage represents the gears, bodies, pins, bearings and meshes of its planets.
    """

    sun: str | None = text("name of the sun gear", None, display="no sun")
    ring: str | None = text("name of the internal gear", None, display="no ring")
    carrier: str = text("body that carries the pins; without position it is on the axis of sun and ring")
    planet: Gear = component(Gear, "gear data of every planet", REQUIRED)
    planets: int | None = integer(
        "number of planets, at equal angles", None, minimum=1, maximum=50, one_of="places"
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

    @property
    def places(self) -> tuple[float, ...]:
        """Angle of every planet [rad]."""
        if self.angles is not None:
            return self.angles
        count = self.planets or 0
        return tuple(math.tau * k / count for k in range(count))

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the planets: of their gears and of their bodies."""
        return tuple(f"{self.planet_name}_{k}" for k in range(1, len(self.places) + 1))

    def sun_meshes(self) -> tuple[str, ...]:
        """Names of the meshes with the sun, in the order of the planets."""
        return () if self.sun is None else tuple(f"{self.sun}-{name}" for name in self.names)

    def ring_meshes(self) -> tuple[str, ...]:
        """Names of the meshes with the ring, in the order of the planets."""
        return () if self.ring is None else tuple(f"{name}-{self.ring}" for name in self.names)
