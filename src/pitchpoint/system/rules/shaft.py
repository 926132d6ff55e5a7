# SPDX-License-Identifier: Apache-2.0
"""Elastic shafts as stations, bodies with six coordinates, and the beams between them.

A station stands wherever something sits on the shaft, at every step of the diameter, at both ends, and in
between so that no piece is too long. The beams carry the mass of the shaft; what sits on it adds its own to
its station.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.elements.shaft_beam import RECORD, shaft_row
from pitchpoint.multibody.beam_section import Beam, tube
from pitchpoint.multibody.bodies import FREE, Body

if TYPE_CHECKING:
    from pitchpoint.model.components.shaft import Shaft

SAME = 1e-6
"""Places that differ by less than this share of the length are one."""
BARE = 1e-9
"""Mass and inertia of a station where nothing sits, per mass and inertia of the shaft: a body needs some."""


@dataclass(frozen=True, kw_only=True)
class Rider:
    """Something that sits on a shaft: a gear, a bearing, a load.

    Parameters
    ----------
    place
        From the start of the shaft [m].
    mass, polar, central, center
        Mass [kg], inertia about the spin axis and about a diameter through its centre of mass [kg m^2], and
        that centre from its place [m]; all zero for what only acts there.
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
        Stations in order along the shaft, called ``SHAFT.1`` and so on.
    beams
        Records of the kind shaft_beam, with the numbers of the bodies.
    names
        Names of the beams.
    stations
        Number of the body that each rider sits on, in the records.
    places
        Places of the stations from the start of the shaft [m].
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
    gravity: ArrayLike = (0.0, 0.0, 0.0),
    angle: float = 0.0,
) -> ShaftParts:
    """Cut a shaft into stations and beams.

    Parameters
    ----------
    name
        Name of the shaft.
    shaft
        Its sections.
    riders
        What sits on it, by name; things at one place share a station.
    first
        Number of its first body in the records.
    origin
        Start of the shaft in the world [m]; its axis is parallel to z.
    gravity
        On the mass of the shaft [m/s^2]; what sits on it is a matter of the bodies.
    angle
        Initial spin of all stations [rad].

    Raises
    ------
    CompileError
        If a rider does not sit on the shaft.
    """
    length = shaft.length
    off = [
        f"{r} at {x.place:g} m"
        for r, x in riders.items()
        if not -SAME * length <= x.place <= length * (1 + SAME)
    ]
    if off:
        raise CompileError(f"shaft {name}: is {length:g} m long; not on it: {', '.join(off)}")
    places = _places(shaft, [r.place for r in riders.values()])
    sat: dict[int, list[Rider]] = {}
    stations = {}
    for rider, x in riders.items():
        k = int(np.argmin(np.abs(places - x.place)))
        sat.setdefault(k, []).append(x)
        stations[rider] = first + k
    beams = [_beam(shaft, a, b) for a, b in zip(places[:-1], places[1:], strict=True)]
    mass = sum(b.mass for b in beams)
    polar = sum(b.rho * b.section.J * b.length for b in beams)
    start = np.asarray(origin, float)
    bodies = [
        _station(
            f"{name}.{k + 1}",
            np.add(start, (0.0, 0.0, place)),
            sat.get(k, []),
            BARE * mass,
            BARE * polar,
            angle,
        )
        for k, place in enumerate(places)
    ]
    rows = [
        shaft_row(b, bodies=(first + k, first + k + 1), eta=shaft.internal_damping, gravity=gravity)
        for k, b in enumerate(beams)
    ]
    names = tuple(f"{name}.{k + 1}" for k in range(len(beams)))
    return ShaftParts(tuple(bodies), np.concatenate(rows).astype(RECORD), names, stations, places)


def _places(shaft: Shaft, wanted: list[float]) -> NDArray[np.float64]:
    """Stations: what is wanted first, then steps and ends that are not there yet, then cuts of long
    pieces."""
    length = shaft.length
    found = sorted({min(max(p, 0.0), length) for p in wanted})
    kept: list[float] = []
    for p in found:
        if not kept or p - kept[-1] > SAME * length:
            kept.append(p)
    steps = np.concatenate([[0.0], np.cumsum([s.length for s in shaft.sections.values()])])
    for step in steps:
        if all(abs(step - p) > SAME * length for p in kept):
            kept.append(float(step))
    kept.sort()
    places = [kept[0]]
    for a, b in zip(kept[:-1], kept[1:], strict=True):
        section = _section_at(shaft, 0.5 * (a + b))
        pieces = math.ceil((b - a) / (shaft.largest_piece or 2.0 * section[0]) - 1e-9)
        places += [a + (b - a) * k / pieces for k in range(1, pieces + 1)] if pieces > 1 else [b]
    return np.array(places)


def _section_at(shaft: Shaft, place: float) -> tuple[float, float]:
    """Diameter and bore at a place [m]."""
    end = 0.0
    for section in shaft.sections.values():
        end += section.length
        if place <= end:
            break
    return section.diameter, section.bore


def _beam(shaft: Shaft, a: float, b: float) -> Beam:
    data = shaft.material_data
    diameter, bore = _section_at(shaft, 0.5 * (a + b))
    return Beam(
        section=tube(diameter, bore, data.poisson_ratio),
        length=b - a,
        E=data.youngs_modulus,
        G=data.shear_modulus,
        rho=data.density,
    )


def _station(
    name: str, position: NDArray[np.float64], sat: list[Rider], mass: float, inertia: float, angle: float
) -> Body:
    """Body with the mass of all that sits on it."""
    heavy = mass + sum(r.mass for r in sat)
    center = sum(r.mass * r.center for r in sat) / heavy
    central = inertia + sum(r.central + r.mass * (r.center - center) ** 2 for r in sat)
    return Body(
        motion=FREE,
        position=position,
        mass=heavy,
        polar_inertia=inertia + sum(r.polar for r in sat),
        transverse_inertia=central,
        center=center,
        angle=angle,
        name=name,
    )
