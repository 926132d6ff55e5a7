# SPDX-License-Identifier: Apache-2.0
"""Comparison of mass and inertia of gears, shafts and bodies from all available sources."""

from __future__ import annotations

import contextlib
import dataclasses
import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import GeometryError
from pitchpoint.model.housing import node_bodies
from pitchpoint.model.inertia import (
    bevel_gear_inertia,
    body_inertia,
    gear_by_geometry,
    gear_inertia,
    gears_of_body,
)
from pitchpoint.model.solids import solid_mass, solid_of_gear

if TYPE_CHECKING:
    from pitchpoint.model.components.bevel_gear import BevelGear
    from pitchpoint.model.components.body import Body
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.components.shaft import Shaft
    from pitchpoint.model.components.solid import SolidReference
    from pitchpoint.model.model import Model

SOURCES = ("geometry", "outside shaft", "gears", "solid", "given", "effective")
"""Sources of a mass: "outside shaft" is the part of a gear outside the sections of its shaft, "gears" the sum
over the gears of a body."""
_BARE: dict[str, Any] = {"mass": None, "polar_inertia": None, "transverse_inertia": None}
VALUES = ("mass", "polar_inertia", "transverse_inertia")


def masses(model: Model) -> list[dict[str, Any]]:
    """Mass data of every gear, shaft and body from all sources.

    Parameters
    ----------
    model
        The model.

    Returns
    -------
    list
        For each of them `part` ("gear", "shaft" or "body"), `name`, `sources`: for each available source
        mass [kg], polar inertia about the axis and transverse inertia about the centre of mass [kg m²]
        (None if not known), and for shafts and bodies the centre of mass from the origin [m];
        `differences`: relative difference of each source from the effective value; for solids `file`,
        `unit`, `density` [kg/m³].
    """
    found = [
        _entry("gear", name, _of_gear(model, name, gear), gear.solid, gear.material)
        for name, gear in model.gears.items()
    ]
    found += [
        _entry("gear", name, _of_bevel_gear(model, name, gear), None, gear.material)
        for name, gear in model.bevel_gears.items()
    ]
    found += [
        _entry("shaft", name, _of_shaft(shaft), shaft.solid, shaft.material)
        for name, shaft in model.shafts.items()
    ]
    hidden = node_bodies(model)
    for name, body in model.bodies.items():
        if body.shaft is None and body.elastic is None and name not in hidden:
            found.append(_entry("body", name, _of_body(model, body), body.solid, "steel"))
    return found


def several_sources(found: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Entries of `masses` with more than one of geometry, gears, solid and given values."""
    return [entry for entry in found if len(entry["differences"].keys() - {"outside shaft"}) > 1]


def masses_of_shafts(model: Model) -> dict[str, dict[str, dict[str, Any]]]:
    """Mass data of what the sections and the gears of every shaft with gears contribute.

    Parameters
    ----------
    model
        The model.

    Returns
    -------
    dict
        By shaft and by "sections" or gear: `mass` [kg], `polar_inertia` and `transverse_inertia` about the
        centre of mass of the part [kg m²], and `alone`: mass of the gear without shaft [kg], None for the
        sections.
    """
    found = {}
    for name, shaft in model.shafts.items():
        body = model.bodies[name]
        parts = gears_of_body(body, model.gears, model.bevel_gears)
        if not parts:
            continue
        sections = _numbers(*(_of_shaft(shaft)["effective"][key] for key in VALUES), alone=None)
        found[name] = {"sections": sections}
        for gear, values in parts.items():
            if gear in model.gears:
                alone = gear_inertia(model.gears[gear])[0]
            else:
                alone = bevel_gear_inertia(model.bevel_gears[gear])[0]
            found[name][gear] = _numbers(*values[:3], alone=alone)
    return found


def _entry(
    part: str, name: str, sources: Mapping[str, Any], solid: SolidReference | None, own: Any
) -> dict[str, Any]:
    force = sources["effective"]
    entry: dict[str, Any] = {"part": part, "name": name, "sources": sources}
    entry["differences"] = {
        source: {key: _difference(numbers[key], force[key]) for key in VALUES}
        for source, numbers in sources.items()
        if source != "effective"
    }
    if solid is not None:
        entry |= {"file": solid.file, "density": solid.density_for(own), "unit": _unit(solid)}
    return entry


def _unit(solid: SolidReference) -> str:
    from pitchpoint.geometry.solid_file import read_solids

    return read_solids(solid.file, solid.unit).unit


def _difference(value: float | None, force: float | None) -> float | None:
    if value is None or force is None or not force > 0.0:
        return None
    return value / force - 1.0


def _numbers(
    mass: float | None, polar: float | None, transverse: float | None, **more: Any
) -> dict[str, Any]:
    return {"mass": mass, "polar_inertia": polar, "transverse_inertia": transverse, **more}


def _seated(model: Model, name: str, gear: Gear | BevelGear) -> dict[str, Any] | None:
    """Mass data of what a gear adds to its shaft; None if it is not on a shaft."""
    body = model.body_of(name)
    if body is None or body not in model.shafts:
        return None
    gears = {**model.gears, **model.bevel_gears, name: gear}
    return _numbers(*gears_of_body(model.bodies[body], gears, gears)[name][:3])  # type: ignore[arg-type]


def _of_gear(model: Model, name: str, gear: Gear) -> dict[str, Any]:
    sources = {}
    # the blank may be inconsistent with the teeth if all values are given elsewhere
    with contextlib.suppress(GeometryError):
        sources["geometry"] = _numbers(*gear_by_geometry(gear))
        outside = _seated(model, name, dataclasses.replace(gear, solid=None, **_BARE))
        if outside is not None:
            sources["outside shaft"] = outside
    if gear.solid is not None:
        sources["solid"] = _numbers(*solid_of_gear(gear))
    given = (gear.mass, gear.polar_inertia, gear.transverse_inertia)
    if any(v is not None for v in given):
        sources["given"] = _numbers(*given)
    return {**sources, "effective": _seated(model, name, gear) or _numbers(*gear_inertia(gear))}


def _of_bevel_gear(model: Model, name: str, gear: BevelGear) -> dict[str, Any]:
    sources = {}
    bare = dataclasses.replace(gear, **_BARE)
    with contextlib.suppress(GeometryError):
        sources["geometry"] = _numbers(*bevel_gear_inertia(bare)[:3])
        outside = _seated(model, name, bare)
        if outside is not None:
            sources["outside shaft"] = outside
    given = (gear.mass, gear.polar_inertia, gear.transverse_inertia)
    if any(v is not None for v in given):
        sources["given"] = _numbers(*given)
    return {**sources, "effective": _seated(model, name, gear) or _numbers(*bevel_gear_inertia(gear)[:3])}


def _of_shaft(shaft: Shaft) -> dict[str, Any]:
    from pitchpoint.geometry.shaft_solid import shaft_mass_properties

    def by_sections(density: float) -> dict[str, Any]:
        """Mass, inertia and centre of mass of the shaft sections for a density [kg/m^3]."""
        total = shaft_mass_properties(shaft.dimensions, density)
        inertia = (total.polar_inertia, total.transverse_inertia)
        return _numbers(total.mass, *inertia, center=(0.0, 0.0, total.center))

    sources = {"geometry": by_sections(shaft.material_data.density)}
    if shaft.solid is not None:
        density = shaft.solid.density_for(shaft.material)
        found = shaft.solid.about_axis()
        volume = shaft.solid.solid().volume
        sources["solid"] = _numbers(
            density * volume, density * found.polar, density * found.transverse, center=None
        )
    return {**sources, "effective": by_sections(shaft.density)}


def _of_body(model: Model, body: Body) -> dict[str, Any]:
    sources = {}
    nothing = {"mass": None, "inertia": None, "transverse_inertia": None, "inertia_tensor": None}
    if body.gears or body.bevel_gears:
        bare = dataclasses.replace(body, solid=None, center_of_mass=None, **nothing)  # type: ignore[arg-type]
        sources["gears"] = _of(body_inertia(bare, model.gears, model.bevel_gears))
    if body.solid is not None:
        found = solid_mass(body.solid)
        sources["solid"] = _numbers(found.mass, found.polar, found.central, center=found.center)
    force = body_inertia(body, model.gears, model.bevel_gears)
    tensor = body.inertia_tensor is not None
    given = _numbers(
        body.mass,
        _polar(force) if tensor or body.inertia is not None else None,
        force.central if tensor or body.transverse_inertia is not None else None,
        center=body.center,
    )
    if any(v is not None for v in given.values()):
        sources["given"] = given
    return {**sources, "effective": _of(force)}


def _of(inertia: Any) -> dict[str, Any]:
    center = inertia.place if inertia.mass > 0.0 else None
    return _numbers(inertia.mass, _polar(inertia), inertia.central, center=center)


def _polar(inertia: Any) -> float:
    """Moment of inertia about an axis along z through the centre of mass [kg m^2]."""
    off_axis = math.hypot(*inertia.off_axis)
    return float(inertia.polar - inertia.mass * off_axis * off_axis)
