# SPDX-License-Identifier: Apache-2.0
"""Rotor and tower of a windIO file, for blade-element momentum theory."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass

from pitchpoint.core.errors import ModelError
from pitchpoint.geometry.rotor.blade import Rotor
from pitchpoint.geometry.rotor.tower import Tower
from pitchpoint.model.windio.blade import read_blade, reference_axis
from pitchpoint.model.windio.ontology import Ontology, read_ontology, smooth


@dataclass(frozen=True)
class WindIORotor:
    """Contents of a windIO file for the loads of the air.

    Attributes
    ----------
    rotor
        Blades with their polars, hub radius, precone, tilt, hub height, overhang.
    tower
        Elevations and diameters; None if the file has no tower.
    notes
        Airfoils and polars of the file that are not used.
    """

    rotor: Rotor
    tower: Tower | None
    notes: tuple[str, ...] = ()


def read_windio_rotor(path: str | os.PathLike[str]) -> WindIORotor:
    """Rotor of a turbine in the ontology windIO, version 1 or 2.

    Chord, twist, reference axis and relative thickness are monotone cubic polynomials (PCHIP) between their
    points; the coefficients of a section are those of its relative thickness between the airfoils. Polars of
    several Reynolds numbers are taken at the rated rotor speed of the file. The stations are where the file
    has chords, each at the aerodynamic centre of the file, to which windIO refers the polars; moments are
    about it.

    Parameters
    ----------
    path
        The file.

    Raises
    ------
    ModelError
        With every problem, its file and line.
    """
    return _read(path, placed=True)


def read_windio_blades(path: str | os.PathLike[str]) -> WindIORotor:
    """Blades, hub radius, precone and tower of a windIO file, without hub height, tilt and overhang.

    These are not read and have the defaults of `Rotor`: in a model the bodies have them. Otherwise as
    `read_windio_rotor`.
    """
    return _read(path, placed=False)


def _read(path: str | os.PathLike[str], placed: bool) -> WindIORotor:
    file = read_ontology(path)
    downwind = str(file.get("assembly", "rotor_orientation") or "Upwind").lower() == "downwind"
    hub_radius = 0.5 * file.number("components", "hub", "diameter", positive=True)
    coned = file.number("components", "hub", "cone_angle", default=0.0)
    file.check_angle(coned, "components", "hub", "cone_angle", most=0.5)
    cone = float(file.angle(coned))
    blades = file.number("assembly", "number_of_blades", default=3.0)
    place = _place(file, downwind) if placed else {}
    if not file.problems and blades != round(blades):
        file.problem(("assembly", "number_of_blades"), "is not a whole number", f"{blades:g}")
    file.stop()
    blade = read_blade(file, hub_radius)
    if hub_radius > blade.length:
        limit, remedy = f"<= {2.0 * blade.length:.6g} m, twice the blade", "lengths are in metres"
        file.problem(
            ("components", "hub", "diameter"), "is out of range", f"{2.0 * hub_radius:.6g} m", limit, remedy
        )
    tower = _tower(file)
    file.stop()
    try:
        rotor = Rotor(
            blade=blade,
            blades=round(blades),
            hub_radius=hub_radius,
            precone=-cone if downwind else cone,
            **place,
        )
    except ModelError as error:
        raise ModelError([p.changed(file=file.path.name) for p in error.problems], str(path)) from None
    return WindIORotor(rotor, tower, tuple(file.notes))


def _place(file: Ontology, downwind: bool) -> dict[str, float]:
    """Tilt, hub height and overhang."""
    at = ("components", "drivetrain", "outer_shape")
    if file.version == 1:
        at = ("components", "nacelle", "drivetrain")
    tilted = file.number(*at, "uptilt", default=0.0)
    file.check_angle(tilted, *at, "uptilt", most=0.5)
    tilt = float(file.angle(tilted))
    overhang = file.number(*at, "overhang", default=0.0)
    hub_height = file.number("assembly", "hub_height", positive=True)
    return {
        "tilt": tilt,
        "hub_height": hub_height,
        "overhang": (-overhang if downwind else overhang) / math.cos(tilt),
    }


def _tower(file: Ontology) -> Tower | None:
    """Outer shape of the tower."""
    at = ("components", "tower")
    if not file.has(*at):
        return None
    outer = (*at, "outer_shape" if file.version == 2 else "outer_shape_bem")
    grid, diameter = file.curve(*outer, "outer_diameter")
    axis = reference_axis(file, at if file.version == 2 else outer, grid)
    file.stop()
    try:
        return Tower(elevation=axis[2], diameter=smooth((grid, diameter), grid))
    except ModelError as error:
        raise ModelError([p.changed(file=file.path.name) for p in error.problems], str(file.path)) from None
