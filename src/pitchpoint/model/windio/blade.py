# SPDX-License-Identifier: Apache-2.0
"""Aerodynamic blade of a windIO file: stations, and polars blended along the span."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import ModelError
from pitchpoint.geometry.rotor.blade import Blade
from pitchpoint.geometry.rotor.blending import blend_polars
from pitchpoint.geometry.rotor.polar import Polar
from pitchpoint.model.keys import Place
from pitchpoint.model.windio.airfoils import Airfoil, read_airfoils
from pitchpoint.model.windio.ontology import LARGEST, Ontology, smooth

FloatArray = NDArray[np.float64]
VISCOSITY = 1.46e-5
"""Kinematic viscosity of air at 15 °C for the Reynolds number of the sections [m²/s]."""
BLADE = ("components", "blade")
SOUND = 340.0
"""Speed of sound in air [m/s]."""
_SAME = 1e-6


@dataclass(frozen=True)
class Shape:
    """Outer shape at the stations of the chord: share of the length, chord [m], twist [rad], points of the
    reference axis [m], its distance behind the leading edge [m]."""

    grid: FloatArray
    chord: FloatArray
    twist: FloatArray
    axis: FloatArray
    behind: FloatArray


def read_blade(file: Ontology, hub_radius: float) -> Blade:
    """Blade with one polar for each distinct section, at the places where the file has chords.

    Parameters
    ----------
    file
        The file.
    hub_radius
        Distance of the root from the axis of the rotor [m], for Reynolds numbers.

    Raises
    ------
    ModelError
        With every problem and its line.
    """
    shape = _shape(file)
    names, places = _airfoil_places(file)
    airfoils = read_airfoils(file, names, _configurations(file, names))
    file.stop()
    own = np.array([airfoils[name].thickness for name in names])
    thickness = smooth(_thickness(file, places, own), shape.grid)
    file.stop()
    used = _by_thickness(airfoils, file)
    several = any(len(airfoil.polars) > 1 for airfoil in used)
    reynolds = _reynolds(file, shape, hub_radius) if several else np.full(shape.grid.size, 1e6)
    file.stop()
    centers = np.interp(thickness, [a.thickness for a in used], [a.center for a in used])
    behind = centers * shape.chord - shape.behind
    x, y, z = shape.axis
    polars, index = _polars(used, thickness, reynolds)
    try:
        return Blade(
            span=z - z[0],
            prebend=x + behind * np.sin(shape.twist),
            sweep=y + behind * np.cos(shape.twist),
            curve_angle=np.arctan(np.gradient(x, z)),
            twist=shape.twist,
            chord=shape.chord,
            polars=polars,
            polar_index=index,
        )
    except ModelError as error:
        raise ModelError([p.changed(file=file.path.name) for p in error.problems], str(file.path)) from None


def reference_axis(file: Ontology, at: tuple[Any, ...], grid: FloatArray | None = None) -> FloatArray:
    """Points of a reference axis, shape (3, n) [m]; at given shares of its length or all of its own."""
    curves = [file.curve(*at, "reference_axis", c) for c in "xyz"]
    where = np.unique(np.concatenate([curve[0] for curve in curves])) if grid is None else grid
    points = np.array([smooth(curve, where) for curve in curves])
    if not file.problems and not (np.diff(points[2]) > 0.0).all():
        file.problem((*at, "reference_axis", "z", "values"), "do not increase from the root to the tip")
    return points


def check_length(file: Ontology, at: tuple[Any, ...], length: float) -> None:
    """Add a problem for a blade or tower that is longer than any.

    Parameters
    ----------
    file, at
        File, and place of the reference axis in it.
    length
        Length [m].
    """
    if length > LARGEST:
        limit = f"<= {LARGEST:g} m"
        file.problem(
            (*at, "reference_axis", "z", "values"),
            "is the length",
            f"{length:.6g} m",
            limit,
            "lengths are in metres",
        )


def _shape(file: Ontology) -> Shape:
    """Outer shape in either layout."""
    new = file.version == 2
    at = (*BLADE, "outer_shape" if new else "outer_shape_bem")
    grid, chord = file.curve(*at, "chord")
    angles = file.curve(*at, "twist")
    twist = file.angle(smooth(angles, grid))
    axis = reference_axis(file, BLADE if new else at, grid)
    if new:
        behind = smooth(file.curve(*at, "section_offset_y"), grid)
    else:
        shares = file.curve(*at, "pitch_axis")
        behind = chord * smooth(shares, grid)
    file.stop()
    if not new:
        remedy = "give shares of the chord"
        file.check_range((*at, "pitch_axis", "values"), shares[1], -0.5, 1.5, "", remedy)
    file.check_angle(angles[1], *at, "twist", "values")
    check_length(file, BLADE if new else at, float(axis[2][-1] - axis[2][0]))
    for k in np.flatnonzero(chord <= 0.0)[:1]:
        file.problem(
            (*at, "chord", "values", int(k)), "is out of range", f"{chord[k]:g}", "> 0", "correct it"
        )
    if not file.problems:
        length, remedy = (
            float(axis[2][-1] - axis[2][0]),
            "a chord is shorter than the blade; lengths are in metres",
        )
        file.check_range((*at, "chord", "values"), chord, 0.0, length, "m", remedy)
    file.stop()
    return Shape(grid, chord, np.asarray(twist), axis, behind)


def _airfoil_places(file: Ontology) -> tuple[list[str], FloatArray]:
    """Names of the airfoils along the span, and their places from 0 to 1."""
    if file.version == 1:
        at = (*BLADE, "outer_shape_bem", "airfoil_position")
        names, places = [str(name) for name in file.entries(*at, "labels")], file.numbers(*at, "grid")
    else:
        at = (*BLADE, "outer_shape", "airfoils")
        count = len(file.entries(*at))
        names = [str(file.get(*at, k, "name")) for k in range(count)]
        places = np.array([file.number(*at, k, "spanwise_position") for k in range(count)])
    if not file.problems:
        if not names or len(names) != places.size:
            file.problem(at, "is the number of places", str(places.size), f"{len(names)} as of names, >= 1")
        for k in np.flatnonzero(np.diff(places) <= 0.0)[:1]:
            file.problem(at, "does not increase", f"{places[k + 1]:g}", f"> {places[k]:g}")
    return names, places


def _configurations(file: Ontology, names: list[str]) -> dict[str, str]:
    """Configuration of the polars by airfoil, which version 2 has at the places along the span."""
    if file.version == 1:
        return {}
    at = (*BLADE, "outer_shape", "airfoils")
    found: dict[str, str] = {}
    for k, name in enumerate(names):
        given = file.entries(*at, k, "configuration") if file.has(*at, k, "configuration") else []
        if len(given) > 1:
            file.problem((*at, k, "configuration"), "has several configurations, which are not read")
        elif given and found.setdefault(name, str(given[0])) != str(given[0]):
            text = f"is another configuration of {name} than at a place before"
            file.problem((*at, k, "configuration"), text, str(given[0]), found[name])
    return found


def _thickness(file: Ontology, places: FloatArray, own: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Relative thickness along the span: of the file, or of the airfoils at their places."""
    at = (*BLADE, "outer_shape" if file.version == 2 else "outer_shape_bem", "rthick")
    if file.has(*at):
        return file.curve(*at)
    return (places, own) if places.size > 1 else (np.array([0.0, 1.0]), np.repeat(own, 2))


def _by_thickness(airfoils: dict[str, Airfoil], file: Ontology) -> list[Airfoil]:
    """Airfoils by increasing thickness; of several with the same thickness the first one, with a note."""
    found: list[Airfoil] = []
    last = ""
    for name, airfoil in sorted(airfoils.items(), key=lambda item: item[1].thickness):
        if not found or airfoil.thickness > found[-1].thickness + _SAME:
            found.append(airfoil)
            last = name
        else:
            file.notes.append(f"airfoil {name}: not used, as {last} has the same relative thickness")
    return found


def _reynolds(file: Ontology, shape: Shape, hub_radius: float) -> FloatArray:
    """Reynolds numbers of the stations at the rated speed of the rotor without wind."""
    if file.has("control", "rated_rotor_speed"):
        speed = file.number("control", "rated_rotor_speed", positive=True) * math.pi / 30.0
    elif file.has("control", "torque", "VS_maxspd"):
        speed = file.number("control", "torque", "VS_maxspd", positive=True)
    else:
        remedy = "add it: it selects the polars of several Reynolds numbers"
        file.problem(("control", "rated_rotor_speed"), "is missing", remedy=remedy)
        return np.ones(shape.grid.size)
    tip = speed * (hub_radius + float(shape.axis[2][-1]))
    if tip > SOUND:
        of_file = file.has("control", "rated_rotor_speed")
        place: Place = ("control", "rated_rotor_speed") if of_file else ("control", "torque", "VS_maxspd")
        remedy = "correct the speed: rpm for rated_rotor_speed, rad/s for VS_maxspd"
        file.problem(place, "is the speed of the blade tip", f"{tip:.4g} m/s", f"<= {SOUND:g} m/s", remedy)
    return np.asarray(speed * (hub_radius + shape.axis[2]) * shape.chord / VISCOSITY)


def _polars(
    used: list[Airfoil], thickness: FloatArray, reynolds: FloatArray
) -> tuple[list[Polar], NDArray[np.int64]]:
    """Polar of each station, those of the same section once."""
    if len(used) == 1:
        each = [used[0].at(number) for number in reynolds]
    elif all(len(airfoil.polars) == 1 for airfoil in used):
        each = blend_polars([a.polars[0] for a in used], [a.thickness for a in used], thickness)
    else:
        own = [a.thickness for a in used]
        each = [
            blend_polars([a.at(number) for a in used], own, [t])[0]
            for t, number in zip(thickness, reynolds, strict=True)
        ]
    polars: list[Polar] = []
    index = []
    for polar in each:
        if not any(polar is known for known in polars):
            polars.append(polar)
        index.append(next(k for k, known in enumerate(polars) if known is polar))
    return polars, np.array(index, dtype=np.int64)
