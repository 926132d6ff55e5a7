# SPDX-License-Identifier: Apache-2.0
"""Shafts, rigid bodies and planet carriers as components of REXS."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from pitchpoint.geometry.materials import Material
from pitchpoint.io.rexs.exporting.draft import Draft, placed

if TYPE_CHECKING:
    from pitchpoint.model.components.body import Body

STEEL: dict[str, Any] = {"youngs_modulus": 2.06e11, "poisson_ratio": 0.3}
"""Elastic properties of rigid bodies in the file."""


def add_shafts(draft: Draft) -> None:
    """Add all bodies: elastic shafts with sections, carriers, and rigid bodies as shafts without sections."""
    carriers = {stage.carrier for stage in draft.model.planetary_stages.values()}
    for name, body in draft.model.bodies.items():
        if body.of_housing:
            continue
        if body.elastic is not None and name not in carriers:
            draft.omit(f"elastic_bodies.{name}", "reduced elastic bodies are not written")
        elif body.shaft is not None:
            _add_shaft(draft, name, body)
        elif name in carriers:
            _add_carrier(draft, name, body)
        else:
            _add_rigid(draft, name, body)


def _add_shaft(draft: Draft, name: str, body: Body) -> None:
    shaft = body.shaft
    assert shaft is not None
    id = draft.part("shaft", name, draft.unit, **draft.place(name))
    draft.shafts[name] = id
    draft.relate("reference", origin=id, referenced=draft.material(shaft.material_data))
    begin = 0.0
    for section in shaft.sections:
        bore = {f"inner_diameter_{end}": section.bore for end in ("begin", "end") if section.bore}
        draft.part(
            "shaft_section",
            "",
            id,
            u_coordinate_on_shaft=begin,
            length=section.length,
            outer_diameter_begin=section.diameter,
            outer_diameter_end=section.diameter,
            **bore,
        )
        begin += section.length


def _add_rigid(draft: Draft, name: str, body: Body) -> None:
    """Add a rigid body: a shaft without sections, with its mass as an additional one."""
    origin, axes = draft.frame(name)
    id = draft.part("shaft", name, draft.unit, **placed(origin, axes, draft.unit))
    draft.shafts[name] = id
    if body.motion == "fixed":
        hold = draft.add("coupling", f"{name} fixed")
        draft.relate("side", assembly=hold, inner_part=id, outer_part=draft.casing)
        return
    if body.stage is not None:
        return  # a planet: mass of its gear
    own = [body.mass, body.inertia, body.transverse_inertia, body.inertia_tensor, body.solid]
    if all(value is None for value in own):
        return
    if body.gears or body.bevel_gears:
        draft.omit(f"bodies.{name}", "has the mass and the inertia of its gears in the file")
        return
    _add_mass(draft, name, id)


def _add_mass(draft: Draft, name: str, id: int) -> None:
    """Add mass and moments of inertia of a rigid body about its centre of mass."""
    found = draft.model.body_inertia(name)
    tensor = found.about_center()
    if max(map(abs, found.off_axis)) > 0.0:
        draft.omit(f"bodies.{name}.center_of_mass", "the centre of mass is on the axis in the file")
    if abs(tensor[0, 1]) + abs(tensor[0, 2]) + abs(tensor[1, 2]) > 0.0:
        draft.omit(f"bodies.{name}.inertia_tensor", "products of inertia are not written")
    draft.part(
        "additional_mass",
        f"{name} mass",
        id,
        u_coordinate_on_shaft=found.center,
        mass_of_component=found.mass or None,
        moment_of_inertia_u_axis=float(tensor[2, 2]),
        moment_of_inertia_v_axis=float(tensor[1, 1]) or None,
        moment_of_inertia_w_axis=float(tensor[0, 0]) or None,
    )


def _add_carrier(draft: Draft, name: str, body: Body) -> None:
    """Add the shaft of a carrier, with its mass."""
    id = draft.part("shaft", f"{name} shaft", draft.unit, **draft.place(name))
    draft.shafts[name] = id
    if body.elastic is not None:
        draft.omit(f"elastic_bodies.{name}", "a carrier without mass and compliance in the file")
        return
    _add_cylinder(draft, name, id)
    if body.motion not in ("free", None):
        draft.omit(f"bodies.{name}.motion", f"motion: {body.moves} becomes free")


def _add_cylinder(draft: Draft, name: str, id: int) -> None:
    """Add the solid cylinder with the mass and the moments of inertia of a rigid body.

    Polar moment m D^2/8 and central one m D^2/16 + m L^2/12 determine D and L; the density follows from m.
    """
    found = draft.model.body_inertia(name)
    across = found.central - 0.5 * found.polar
    if found.central == 0.0 and found.mass > 0.0:
        across = 2.0 / 3.0 * found.polar  # L = D
        reason = "its transverse moment of inertia is not known: the cylinder is as long as its diameter"
        draft.omit(f"bodies.{name}.transverse_inertia", reason)
    if max(map(abs, found.off_axis)) > 0.0:
        draft.omit(f"bodies.{name}.center_of_mass", "the centre of mass is on the axis in the file")
    if not (found.mass > 0.0 and found.polar > 0.0 and across > 0.0):
        draft.omit(
            f"bodies.{name}", "has no mass in the file: no cylinder has its mass and moments of inertia"
        )
        return
    length, diameter = math.sqrt(12.0 * across / found.mass), math.sqrt(8.0 * found.polar / found.mass)
    draft.part(
        "shaft_section",
        "",
        id,
        u_coordinate_on_shaft=found.center - 0.5 * length,
        length=length,
        outer_diameter_begin=diameter,
        outer_diameter_end=diameter,
    )
    density = found.mass / (math.pi / 4.0 * diameter**2 * length)
    draft.relate(
        "reference", origin=id, referenced=draft.material(Material(name=name, density=density, **STEEL))
    )
    draft.omit(f"bodies.{name}", "a steel cylinder of the same mass and moments of inertia")


def add_planetary_stages(draft: Draft) -> None:
    """Add planetary stages with their carriers; shafts, gears and meshes are there already.

    Stages whose planets are in mesh are one planetary stage of the file.
    """
    for name, stage in draft.model.planetary_stages.items():
        root = _innermost(draft, name)
        if root in draft.stages:
            id = draft.stages[name] = draft.stages[root]
        else:
            id = draft.stages[name] = draft.stages[root] = _add_stage(draft, root, stage.carrier)
        if root != name:
            draft.omit(f"planetary_stages.{name}", f"is a part of the planetary stage {root} of the file")
        for body, found in draft.model.bodies.items():
            if found.stage == name:
                draft.relate("planet_shaft", planetary_stage=id, shaft=draft.shafts[body])
        for gear in dict.fromkeys(m.mate for m in stage.groups if m.side != "planet"):
            owner = draft.model.body_of(gear)
            if owner in draft.shafts:
                draft.relate("central_shaft", planetary_stage=id, shaft=draft.shafts[str(owner)])


def _innermost(draft: Draft, name: str) -> str:
    """Stage of the innermost planets with which those of a stage are in mesh."""
    stages = draft.model.planetary_stages
    for _ in stages:
        mates = [group.mate for group in stages[name].groups if group.side == "planet"]
        inner = next((n for n, s in stages.items() if mates and s.planet_name == mates[0]), None)
        if inner is None:
            break
        name = inner
    return name


def _add_stage(draft: Draft, name: str, of: str) -> int:
    id = draft.part("planetary_stage", name, draft.unit)
    carrier = draft.part("planet_carrier", of, id)
    draft.relate("assembly", assembly=carrier, part=draft.shafts[of])
    draft.relate("planet_carrier_shaft", planetary_stage=id, shaft=draft.shafts[of])
    return id
