# SPDX-License-Identifier: Apache-2.0
"""Elastic shafts: representation as bodies, checks, and division into beam elements.

A shaft is represented by a body with six degrees of freedom and its origin at the start of the shaft. Only
the rules of the system divide it into stations.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import PitchpointError
from pitchpoint.model.components.body import Body
from pitchpoint.model.frames import Array, body_frame, joint_place, place_of, split
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.model.components.bevel_gear import BevelGear
    from pitchpoint.model.components.shaft import Shaft
    from pitchpoint.model.parts import Parts

SAME = 1e-6
"""Positions that differ by less than this fraction of the length coincide."""
SEATED = ("bearings", "rolling_bearings", "plain_bearings")
"""Sections with `body`, `position` and `housing`."""
MAX_PIECES = 2000
"""Maximum number of beam elements of one shaft; typical shafts have ten to a hundred."""


# --- representation as bodies -------------------------------------------------------------------------------
def stand_in(shaft: Shaft) -> Body:
    """Body that represents a shaft, with its gears, position, markers and mass."""
    return Body(
        gears=dict(shaft.gears),
        bevel_gears=dict(shaft.bevel_gears),
        motion="free",
        position=shaft.position,
        axes=shaft.axes,
        markers=shaft.markers,
        shaft=shaft,
    )


def add_shafts(parts: Parts, report: Reader) -> None:
    """Check the shafts and add a body for each of them.

    Later problems of these bodies are reported for the shafts.
    """
    for path in [p for p in report.tainted if p[0] == "shafts"]:
        report.tainted.add(("bodies", *path[1:]))
    parts.names["bodies"] = parts.known("bodies") | parts.known("shafts")
    for name, shaft in parts.shafts.items():
        if name in parts.bodies:
            report.problem(
                ("shafts", name), "has the name of a body", remedy="choose a unique name for the shaft"
            )
            report.tainted.add(("bodies",))
            continue
        _check(name, shaft, report)
        report.aliases["bodies", name] = ("shafts", name)
        parts.bodies[name] = stand_in(shaft)


def _check(name: str, shaft: Shaft, report: Reader) -> None:
    at: Place = ("shafts", name)
    if not shaft.sections:
        report.problem((*at, "sections"), "is empty", remedy="give at least one section")
    for k, section in enumerate(shaft.sections):
        if section.bore >= section.diameter:
            report.problem(
                (*at, "sections", k, "bore"),
                "is not smaller than the diameter",
                value=in_mm(section.bore),
                limit=f"below the diameter {in_mm(section.diameter)}",
                remedy="give diameters, not radii",
            )
    solid = all(section.bore < section.diameter for section in shaft.sections)
    for k, (one, two) in enumerate(pairwise(shaft.sections), 1):
        if solid and max(one.bore, two.bore) >= min(one.diameter, two.diameter):
            report.problem(
                (*at, "sections", k),
                "does not touch the section before",
                value=f"diameter {in_mm(two.diameter)} and bore {in_mm(two.bore)} after diameter "
                f"{in_mm(one.diameter)} and bore {in_mm(one.bore)}",
                remedy="make each bore smaller than the other diameter, or add a section between them",
            )
    pieces = sum(s.length / (shaft.largest_piece or 2.0 * s.diameter) for s in shaft.sections)
    if pieces > MAX_PIECES:
        key = "sections" if shaft.largest_piece is None else "largest_piece"
        report.problem(
            (*at, key),
            f"would divide the shaft of {in_mm(shaft.length)} into {pieces:.0f} beam elements",
            value=None if shaft.largest_piece is None else in_mm(shaft.largest_piece),
            limit=f"{MAX_PIECES} beam elements",
            remedy="check the units of lengths and diameters, or give "
            f"largest_piece: {in_mm(1.01 * shaft.length / MAX_PIECES)} or more",
        )


def check_shaft_places(parts: Parts, report: Reader) -> None:
    """Check that everything on a shaft is located between its ends."""
    sits = seats_on_shafts(parts)
    for name, shaft in parts.shafts.items():
        if ("shafts", name, "sections") in report.tainted or name not in parts.bodies:
            continue
        for at, place in sits[name]:
            if on_shaft(shaft, place) or at in report.tainted:
                continue
            report.problem(
                at,
                f"is not a position on the shaft {name}",
                value=in_mm(place),
                limit=f"0 to {in_mm(shaft.length)} from its start",
                remedy="positions are measured from the start of the first section",
            )


def on_shaft(shaft: Shaft, place: float) -> bool:
    """Whether a position from the start of a shaft [m] is between its ends."""
    slack = SAME * shaft.length
    return -slack <= place <= shaft.length + slack


def in_mm(length: float) -> str:
    """Length in millimetres, without round-off below a picometre.

    Examples
    --------
    >>> in_mm(0.1 + 0.2)
    '300 mm'
    """
    return f"{round(length * 1e3, 9) + 0.0:.6g} mm"


# --- positions on shafts ------------------------------------------------------------------------------------
def seats_on_shafts(machine: Any) -> dict[str, list[tuple[Place, float]]]:
    """All elements on the shafts: their keys in the file, and their positions from the start [m].

    Parameters
    ----------
    machine
        A model or its parts, with the positions of its bodies.

    Returns
    -------
    dict
        Keys and positions by shaft, for shafts that are represented by a body.
    """
    frames = {name: body_frame(machine, name) for name in machine.shafts if name in machine.bodies}
    found: dict[str, list[tuple[Place, float]]] = {name: [] for name in frames}

    def along(shaft: str, place: Array) -> float:
        """Position along the axis of the shaft [m]."""
        origin, axes = frames[shaft]
        return float(axes[:, 2] @ place) - (0.0 if origin is None else float(axes[:, 2] @ origin))

    for shaft, seats in found.items():
        body = machine.bodies[shaft]
        seats += [(("shafts", shaft, "gears", gear), place) for gear, place in body.gears.items()]
        seats += bevel_seats(machine, shaft)
        for name, marker in body.markers.items():
            seats.append((("shafts", shaft, "markers", name, "position"), marker.position[2]))
    for group in (*SEATED, "unbalances"):
        for name, part in getattr(machine, group).items():
            if part.body in found:
                found[part.body].append(((group, name, "position"), part.position[2]))
            for end in getattr(part, "ends", None) or ():
                shaft, marker = split(end)
                if shaft in found and part.position[2] != 0.0 and not marker:
                    found[shaft].append(((group, name, "position"), part.position[2]))
    for group in SEATED:
        for name, part in getattr(machine, group).items():
            shaft = "" if part.housing is None else split(part.housing)[0]
            if shaft in found and part.body in machine.bodies:
                place = along(shaft, _place_on_axis(machine, part.body, part))
                found[shaft].append(((group, name, "housing"), place))
    for name, coupling in machine.couplings.items():
        for shaft in {*coupling.bodies} & found.keys():
            place = along(shaft, _place_on_axis(machine, coupling.bodies[0], coupling))
            found[shaft].append((("couplings", name, "position"), place))
    for name, load in machine.loads.items():
        for key, shaft in (("position", load.body), ("reaction", load.reaction)):
            if shaft in found and (key == "position" or shaft != load.body):
                found[shaft].append((("loads", name, key), along(shaft, place_of_load(machine, load))))
    for name, joint in machine.joints.items():
        ends = {split(e)[0] for e in joint.bodies} & found.keys()
        at = joint_place(machine, joint) if ends else None
        if at is None:
            continue
        for shaft in ends:
            found[shaft].append((("joints", name, "position"), along(shaft, at)))
    return found


def bevel_seats(machine: Any, shaft: str) -> list[tuple[Place, float]]:
    """Keys and positions of the bevel gears of a shaft: the middles of their faces."""
    found: list[tuple[Place, float]] = []
    for gear, apex in machine.bodies[shaft].bevel_gears.items():
        try:
            found.append((("shafts", shaft, "bevel_gears", gear), middle_of(machine.bevel_gears[gear], apex)))
        except (KeyError, PitchpointError):
            continue  # problems of the gear have been reported already
    return found


def middle_of(gear: BevelGear, apex: float) -> float:
    """Axial position of the middle of the face of a bevel gear with its apex at `apex` [m]."""
    return apex + gear.direction * gear.geometry.R_m * math.cos(gear.delta)


def _place_on_axis(machine: Any, body: str, part: Any) -> Array:
    """World position of an element with a `position` on the axis of a body [m]."""
    if body not in machine.bodies:
        return np.zeros(3)
    origin, axes = body_frame(machine, body)
    return (np.zeros(3) if origin is None else origin) + axes[:, 2] * part.position[2]


def place_of_load(machine: Any, load: Any) -> Array:
    """World position of a load on the axis of its body, or at its marker [m]."""
    if load.marker is None:
        return _place_on_axis(machine, load.body, load)
    place = place_of(machine, f"{load.body}.{load.marker}")
    return np.zeros(3) if place is None else place


# --- stations -----------------------------------------------------------------------------------------------
def stations_of(machine: Any) -> dict[str, tuple[float, ...]]:
    """Positions of the stations of all shafts, from their starts [m]."""
    sits = seats_on_shafts(machine)
    return {name: cut(shaft, [place for _, place in sits[name]]) for name, shaft in machine.shafts.items()}


def station_names(name: str, count: int) -> tuple[str, ...]:
    """Names of the stations of a shaft; the first station has the name of the shaft.

    Examples
    --------
    >>> station_names("input", 3)
    ('input', 'input.2', 'input.3')
    """
    return (name, *(f"{name}.{k}" for k in range(2, count + 1)))


def cut(shaft: Shaft, wanted: Sequence[float]) -> tuple[float, ...]:
    """Divide a shaft into beam elements and return the positions of the stations [m].

    Stations are placed at `wanted`, then at steps of the diameter and at the ends, then within elements that
    are too long.

    Parameters
    ----------
    shaft
        The shaft.
    wanted
        Positions of the elements on the shaft [m].
    """
    length = shaft.length
    kept: list[float] = []
    for p in sorted({min(max(p, 0.0), length) for p in wanted}):
        if not kept or p - kept[-1] > SAME * length:
            kept.append(p)
    step = 0.0
    for end in (0.0, *(s.length for s in shaft.sections)):
        step += end
        if all(abs(step - p) > SAME * length for p in kept):
            kept.append(step)
    kept.sort()
    places = [kept[0]]
    for a, b in zip(kept[:-1], kept[1:], strict=True):
        section = section_at(shaft, 0.5 * (a + b))
        pieces = math.ceil((b - a) / (shaft.largest_piece or 2.0 * section[0]) - 1e-9)
        places += [a + (b - a) * k / pieces for k in range(1, pieces + 1)] if pieces > 1 else [b]
    return tuple(places)


def section_at(shaft: Shaft, place: float) -> tuple[float, float]:
    """Diameter and bore at a position [m]."""
    end = 0.0
    for section in shaft.sections:
        end += section.length
        if place <= end:
            break
    return section.diameter, section.bore


def diameters_between(shaft: Shaft, low: float, high: float) -> set[float]:
    """Diameters of all sections between two positions, including those that only touch them [m]."""
    slack = SAME * shaft.length
    found, end = set(), 0.0
    for section in shaft.sections:
        start, end = end, end + section.length
        if start <= high + slack and end >= low - slack:
            found.add(section.diameter)
    return found


def nearest_station(places: Sequence[float], place: float) -> int:
    """Index of the station nearest to a position."""
    return min(range(len(places)), key=lambda k: abs(places[k] - place))
