# SPDX-License-Identifier: Apache-2.0
"""Elastic shafts as stations (bodies with six coordinates) and the beam elements between them.

Stations are at every mounted part, every diameter step, both ends, and in between to limit the element
length. The beam elements include the mass of the shaft; mounted parts add their mass to their station.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.elements.shaft_beam import RECORD, shaft_row
from pitchpoint.model.frames import Array, body_frame
from pitchpoint.model.inertia import gears_of_body
from pitchpoint.model.shafts import cut, middle_of, on_shaft, section_at, station_names
from pitchpoint.multibody.beam_section import Beam, tube
from pitchpoint.multibody.bodies import FREE, Body
from pitchpoint.system.rules.bank import Bank
from pitchpoint.system.rules.places import Places

if TYPE_CHECKING:
    from pitchpoint.model.components.shaft import Shaft
    from pitchpoint.model.model import Model

BARE = 1e-9
"""Mass and inertia of a station without parts relative to those of the shaft; a body must not be massless."""


@dataclass(frozen=True, kw_only=True)
class Rider:
    """Part mounted on a shaft: gear, bearing or load.

    Parameters
    ----------
    place
        Position from the start of the shaft [m].
    mass, polar, central, center
        Mass [kg], inertia about the spin axis and about a diameter through the centre of mass [kg m^2], and
        position of the centre of mass relative to `place` [m]; all zero for massless parts.
    """

    place: float
    mass: float = 0.0
    polar: float = 0.0
    central: float = 0.0
    center: float = 0.0


@dataclass(frozen=True)
class ShaftParts:
    """Bodies and beams of one shaft.

    Parameters
    ----------
    bodies
        Stations in order along the shaft, called ``SHAFT``, ``SHAFT.2`` and so on.
    beams
        Records of the kind shaft_beam, with the numbers of the bodies.
    names
        Names of the beams.
    stations
        Body number of the station of each rider in the records.
    places
        Positions of the stations from the start of the shaft [m].
    """

    bodies: tuple[Body, ...]
    beams: NDArray[np.void]
    names: tuple[str, ...]
    stations: Mapping[str, int]
    places: NDArray[np.float64]


def shaft_parts(
    name: str,
    shaft: Shaft,
    riders: Mapping[str, Rider],
    *,
    first: int,
    origin: ArrayLike = (0.0, 0.0, 0.0),
    axes: ArrayLike | None = None,
    gravity: ArrayLike = (0.0, 0.0, 0.0),
    angle: float = 0.0,
    stations: Sequence[float] | None = None,
) -> ShaftParts:
    """Divide a shaft into stations and beam elements.

    Parameters
    ----------
    name
        Name of the shaft.
    shaft
        Sections of the shaft.
    riders
        Mounted parts by name; parts at the same position share a station.
    first
        Number of its first body in the records.
    origin
        Start of the shaft in the world [m].
    axes
        Frame of the shaft, columns, shape (3, 3), the third along the shaft; None: world frame.
    gravity
        Gravity acting on the beam elements [m/s^2]; mounted parts are included in the bodies.
    angle
        Initial spin angle of all stations [rad].
    stations
        Positions of the stations from the start of the shaft [m]; None: determined from the riders.

    Raises
    ------
    CompileError
        If a rider is not on the shaft.
    """
    off = [f"{r} at {x.place:g} m" for r, x in riders.items() if not on_shaft(shaft, x.place)]
    if off:
        raise CompileError(f"shaft {name}: is {shaft.length:g} m long; not on it: {', '.join(off)}")
    places = np.array(stations or cut(shaft, [r.place for r in riders.values()]))
    sat: dict[int, list[Rider]] = {}
    numbers = {}
    for rider, x in riders.items():
        k = int(np.argmin(np.abs(places - x.place)))
        sat.setdefault(k, []).append(x)
        numbers[rider] = first + k
    beams = [_beam(shaft, a, b) for a, b in zip(places[:-1], places[1:], strict=True)]
    mass = sum(b.mass for b in beams)
    polar = sum(b.rho * b.section.J * b.length for b in beams)
    start, frame = np.asarray(origin, float), np.eye(3) if axes is None else np.asarray(axes, float)
    bodies = [
        _station(
            label,
            (start + frame[:, 2] * place, frame),
            sat.get(k, []),
            BARE * mass,
            BARE * polar,
            angle,
        )
        for k, (label, place) in enumerate(zip(station_names(name, places.size), places, strict=True))
    ]
    rows = [
        shaft_row(b, bodies=(first + k, first + k + 1), eta=shaft.internal_damping, gravity=gravity)
        for k, b in enumerate(beams)
    ]
    names = tuple(f"{name}.{k + 1}" for k in range(len(beams)))
    return ShaftParts(tuple(bodies), np.concatenate(rows).astype(RECORD), names, numbers, places)


def shaft_of(model: Model, name: str, first: int) -> ShaftParts:
    """Bodies and beams of a shaft in a model, with its gears; `first` is the number of its first station."""
    shaft, body = model.shafts[name], model.bodies[name]
    seats = body.gears | {
        gear: middle_of(model.bevel_gears[gear], apex) for gear, apex in body.bevel_gears.items()
    }
    riders = {
        gear: Rider(place=seats[gear], mass=mass, polar=polar, central=central, center=at - seats[gear])
        for gear, (mass, polar, central, at) in gears_of_body(body, model.gears, model.bevel_gears).items()
    }
    return shaft_parts(
        name,
        shaft,
        riders,
        first=first,
        origin=body.origin or (0.0, 0.0, 0.0),
        axes=body_frame(model, name)[1],
        gravity=model.gravity or (0.0, 0.0, 0.0),
        stations=model.stations[name],
    )


def shaft_bank(places: Places) -> Bank:
    """Beam elements of all shafts."""
    model, numbers = places.model, places.numbers
    parts = [shaft_of(model, name, numbers[name]) for name in model.shafts]
    records = [np.zeros(0, RECORD), *(p.beams for p in parts)]
    return Bank("shaft_beam", np.concatenate(records), tuple(n for p in parts for n in p.names))


def _beam(shaft: Shaft, a: float, b: float) -> Beam:
    data = shaft.material_data
    diameter, bore = section_at(shaft, 0.5 * (a + b))
    return Beam(
        section=tube(diameter, bore, data.poisson_ratio),
        length=b - a,
        E=data.youngs_modulus,
        G=data.shear_modulus,
        rho=shaft.density,
    )


def _station(
    name: str, pose: tuple[Array, Array], sat: list[Rider], mass: float, inertia: float, angle: float
) -> Body:
    """Station with position, frame, and the mass of the parts mounted on it."""
    heavy = mass + sum(r.mass for r in sat)
    center = sum(r.mass * r.center for r in sat) / heavy
    central = inertia + sum(r.central + r.mass * (r.center - center) ** 2 for r in sat)
    return Body(
        motion=FREE,
        position=pose[0],
        axes=pose[1],
        mass=heavy,
        polar_inertia=inertia + sum(r.polar for r in sat),
        transverse_inertia=central,
        center=center,
        angle=angle,
        name=name,
    )
