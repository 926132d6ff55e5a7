# SPDX-License-Identifier: Apache-2.0
"""Planet carriers: shafts, side plates and pins as one rigid body."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from pitchpoint.io.rexs.conversion.bearings import RIGID_TILT, sides_of
from pitchpoint.io.rexs.conversion.couplings import COUPLINGS, engaged
from pitchpoint.io.rexs.conversion.frames import Frame, frame_of
from pitchpoint.io.rexs.conversion.hubs import gears_on
from pitchpoint.io.rexs.conversion.materials import density_of
from pitchpoint.io.rexs.conversion.shafts import axes_of, sections_of
from pitchpoint.io.rexs.conversion.state import Conversion, Seat, counted, q, vector
from pitchpoint.io.rexs.document import RexsComponent


@dataclass
class _Mass:
    """Mass [kg], first moment [kg m] and inertia about the origin [kg m^2] of several cylinders."""

    mass: float = 0.0
    moment: float = 0.0
    polar: float = 0.0
    transverse: float = 0.0

    def add(self, cylinder: tuple[float, float, float, float], density: float, radius: float) -> None:
        """Add a hollow cylinder from z1 to z2 whose axis is at a distance from that of the carrier."""
        a, b, outer, inner = cylinder
        mass = density * math.pi / 4.0 * (outer**2 - inner**2) * (b - a)
        own = mass / 8.0 * (outer**2 + inner**2)
        middle = 0.5 * (a + b)
        self.mass += mass
        self.moment += mass * middle
        self.polar += own + mass * radius**2
        # of the pins together: their circle has half the polar moment about each diameter
        self.transverse += 0.5 * own + mass * ((b - a) ** 2 / 12.0 + middle**2 + 0.5 * radius**2)


def carrier_parts(conversion: Conversion, stage: RexsComponent) -> dict[int, RexsComponent]:
    """Shafts, side plates and pins of the carrier of a planetary stage, and what is coupled to them only."""
    found: dict[int, RexsComponent] = {}
    for kind in ("planet_carrier_shaft", "planet_pin"):
        for relation in conversion.source.related(kind, planetary_stage=stage.id):
            one = conversion.source.components[relation.roles["shaft"]]
            found[one.id] = one
    for carrier in conversion.parts(stage, "planet_carrier"):
        conversion.done.add(carrier.id)
        found.update({one.id: one for one in conversion.parts(carrier, "shaft", "side_plate")})
    for shaft in conversion.source.of_type("shaft"):
        if shaft.id in found or gears_on(conversion, shaft) or conversion.parts(shaft, "external_load"):
            continue
        mates = [
            other.id
            for part in conversion.source.components.values()
            for sides in [sides_of(conversion, part)]
            if shaft.id in [s.id for s in sides.values()]
            for other in sides.values()
            if other.id != shaft.id
        ]
        if mates and all(mate in found for mate in mates):
            found[shaft.id] = shaft
    return found


def convert_carrier(conversion: Conversion, stage: RexsComponent) -> str | None:
    """Add the carrier of a planetary stage as a rigid body; its name, None with a problem."""
    parts = carrier_parts(conversion, stage)
    shafts = [
        conversion.source.components[r.roles["shaft"]]
        for r in conversion.source.related("planet_carrier_shaft", planetary_stage=stage.id)
    ] or [p for p in parts.values() if p.type == "shaft"]
    if not shafts:
        conversion.problem(stage, "has no carrier", remedy="give relations 'planet_carrier_shaft'")
        return None
    frame = frame_of(conversion, shafts[0])
    if frame is None:
        conversion.problem(shafts[0], "has no position", "support_vector")
        return None
    carriers = conversion.parts(stage, "planet_carrier")
    main = carriers[0] if carriers else shafts[0]
    name = conversion.name(main)
    frame, _ = conversion.aligned(frame)
    mass = _Mass()
    for part in parts.values():
        _add_part(conversion, part, name, frame, mass)
    values: dict[str, Any] = {
        "motion": "free",
        "position": vector(frame.origin),
        **axes_of(frame),
        "mass": q(mass.mass, "mass"),
        "inertia": q(mass.polar, "inertia"),
        "transverse_inertia": q(mass.transverse, "inertia"),
        "center_of_mass": q(mass.moment / mass.mass if mass.mass else 0.0, "length"),
    }
    given = conversion.number(main, "mass_of_component", f"bodies.{name}.mass")
    if given:
        values["mass"] = q(given, "mass")
    conversion.put("bodies", main, values, name)
    conversion.changed(
        main,
        counted([p.type for p in parts.values()]),
        "one rigid body",
        f"bodies.{name}",
        "the planets of a stage are on the pins of one body",
    )
    _drop_inner(conversion, parts, name)
    return name


def _add_part(conversion: Conversion, part: RexsComponent, name: str, base: Frame, mass: _Mass) -> None:
    """Add the mass of a part, and its seat on the carrier."""
    conversion.done.add(part.id)
    frame = frame_of(conversion, part)
    if frame is None:
        conversion.ignored(part, "mass", "it has no position")
        return
    offset = frame.origin - base.origin
    start = float(offset @ base.z)
    radius = float(np.linalg.norm(offset - start * base.z))
    if part.type == "shaft":
        sections = sections_of(conversion, part)
    else:
        length = conversion.number(part, "length") or 0.0
        outer = conversion.number(part, "outer_diameter") or 0.0
        sections = [(0.0, length, outer, conversion.number(part, "inner_diameter") or 0.0)]
    density = 0.0
    if sections:
        stiff = [m for m in conversion.referenced(part, "material") if "density" not in m.attributes]
        if stiff:
            conversion.done.update(m.id for m in stiff)
            conversion.default(
                part, "density", "no mass", f"bodies.{name}.mass", "its material has no density"
            )
        else:
            density = density_of(conversion, part, f"bodies.{name}.mass")
    sign = 1.0 if float(frame.z @ base.z) > 0.0 else -1.0
    for a, b, d, bore in sections:
        ends = sorted((start + sign * a, start + sign * b))
        mass.add((ends[0], ends[1], d, bore), density, radius)
    conversion.seats[part.id] = Seat(name, start, frame.along(base.z), sections, sign)


def _drop_inner(conversion: Conversion, parts: dict[int, RexsComponent], name: str) -> None:
    """List couplings within the carrier: as rigid, or as soft ones that the model does not have."""
    for coupling in conversion.source.of_type(*COUPLINGS):
        sides = sides_of(conversion, coupling).values()
        if len(sides) < 2 or not all(s.id in parts for s in sides):
            continue
        if not engaged(conversion, coupling):
            continue
        values = [conversion.number(coupling, k) for k in ("rotational_stiffness", "bending_stiffness")]
        soft = any(v is not None and v < RIGID_TILT for v in values)
        conversion.done.add(coupling.id)
        if soft:
            conversion.changed(coupling, "stiffness", "rigid", f"bodies.{name}", "within the carrier")
        else:
            conversion.ignored(coupling, "all", f"rigid, within {name}")
