# SPDX-License-Identifier: Apache-2.0
"""Shafts with their sections."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from pitchpoint.io.rexs.conversion.frames import Frame, frame_of
from pitchpoint.io.rexs.conversion.materials import material_of
from pitchpoint.io.rexs.conversion.state import Conversion, Seat, q, vector
from pitchpoint.io.rexs.document import RexsComponent

GAP, SMALL = 1e-6, 2e-4
"""Largest gap or overlap of two sections that is rounding, and that is closed [m]."""
STEP = 0.05
"""Largest relative change of diameter between the cylinders that replace a cone."""
MOST_STEPS = 20

Section = tuple[float, float, float, float]
"""Start and end along u, outer and inner diameter [m]."""


def convert_shaft(conversion: Conversion, shaft: RexsComponent) -> None:
    """Add an elastic shaft; a shaft without sections becomes a rigid body with the mass of its gears."""
    frame = frame_of(conversion, shaft)
    if frame is None:
        if not any(p.where.startswith(shaft.where) for p in conversion.problems):
            conversion.problem(
                shaft, "has no position", "support_vector", remedy="give support_vector and axes"
            )
        return
    sections = sections_of(conversion, shaft)
    name = conversion.name(shaft)
    frame, sign = conversion.aligned(frame)
    if not sections:
        conversion.done.add(shaft.id)
        if not conversion.parts(shaft, "shaft_section"):
            values: dict[str, Any] = {"motion": "free", "position": vector(frame.origin), **axes_of(frame)}
            conversion.put("bodies", shaft, values)
            conversion.default(
                shaft,
                "shaft_section",
                "rigid, with the mass of its gears",
                f"bodies.{name}",
                "it has no sections",
            )
            conversion.seats[shaft.id] = Seat(name, 0.0, frame, sign=sign)
        return
    first = sections[0][0] if sign > 0.0 else sections[-1][1]
    origin = frame.at(sign * first)
    entries = [
        {
            "length": q(b - a, "length"),
            "diameter": q(outer, "length"),
            **({"bore": q(inner, "length")} if inner else {}),
        }
        for a, b, outer, inner in (sections if sign > 0.0 else reversed(sections))
    ]
    material = material_of(conversion, shaft, f"shafts.{name}.material")
    values = {"sections": entries, "position": vector(origin), **axes_of(frame)}
    if material != "steel":
        values["material"] = material
    conversion.put("shafts", shaft, values)
    conversion.seats[shaft.id] = Seat(name, -sign * first, frame, sections, sign)


def axes_of(frame: Frame) -> dict[str, Any]:
    """Axes of a shaft that is not along the z axis of the world."""
    if np.allclose(frame.z, (0.0, 0.0, 1.0), atol=1e-12):
        return {}
    return {"axes": {"z": vector(frame.z, "dimensionless"), "x": vector(frame.axes[:, 0], "dimensionless")}}


def sections_of(conversion: Conversion, shaft: RexsComponent) -> list[Section]:
    """Cylindrical sections of a shaft in their order; cones become several cylinders.

    Sections without a coordinate follow the one before. Gaps and overlaps are problems.
    """
    found: list[tuple[float, RexsComponent, Section, float, float]] = []
    end = 0.0
    for part in conversion.parts(shaft, "shaft_section"):
        conversion.done.add(part.id)
        begin = conversion.number(part, "u_coordinate_on_shaft")
        if begin is None:
            begin = end
            conversion.default(
                part, "u_coordinate_on_shaft", str(q(end, "length")), "", "after the one before"
            )
        length = conversion.need(part, "length", "mm")
        outer = [conversion.number(part, f"outer_diameter_{e}") for e in ("begin", "end")]
        inner = [conversion.number(part, f"inner_diameter_{e}") for e in ("begin", "end")]
        if outer == [None, None]:
            conversion.problem(
                part, "is missing", "outer_diameter_begin", remedy="give outer_diameter_begin (mm)"
            )
        if length is None or outer == [None, None]:
            return []
        d, e = (outer[0] if x is None else x for x in (outer[0] or outer[1], outer[1]))
        a, b = (inner[0] or 0.0 if x is None else x for x in (inner[0] or 0.0, inner[1]))
        assert d is not None and e is not None
        if length <= 0.0 or d <= 0.0 or e <= 0.0:
            conversion.problem(
                part, "is not above zero", "length" if length <= 0.0 else "outer_diameter_begin"
            )
            return []
        for at, bore, diameter in (("begin", a, d), ("end", b, e)):
            if not 0.0 <= bore < diameter:
                conversion.problem(
                    part,
                    "is not smaller than the outer diameter",
                    f"inner_diameter_{at}",
                    str(q(bore, "length")),
                    f"from 0, below {q(diameter, 'length')}",
                    "give diameters, not radii",
                )
                return []
        end = begin + length
        found.append((begin, part, (begin, end, d, a), e, b))
    found.sort(key=lambda one: one[0])
    result: list[Section] = []
    for begin, part, (_, stop, d, a), e, b in found:
        apart = abs(begin - result[-1][1]) if result else 0.0
        if GAP < apart <= SMALL:
            target = f"shafts.{conversion.name(shaft)}.sections"
            text = f"it is {q(apart, 'length')} from the end of the section before"
            conversion.changed(part, "u_coordinate_on_shaft", "at its end", target, text)
        elif result and apart > GAP:
            what = "leaves a gap after" if begin > result[-1][1] else "overlaps"
            conversion.problem(
                part,
                f"{what} the section before, which ends at {q(result[-1][1], 'length')}",
                "u_coordinate_on_shaft",
                str(q(begin, "length")),
                remedy="sections follow each other without gaps",
            )
            return []
        start = result[-1][1] if result else begin
        result += _cylinders(conversion, part, start, stop, (d, e), (a, b))
    return result


def _cylinders(
    conversion: Conversion,
    part: RexsComponent,
    start: float,
    stop: float,
    outer: tuple[float, float],
    inner: tuple[float, float],
) -> list[Section]:
    """Cylinders of equal length with the volume of a section, which may be conical."""
    change = max(abs(one - two) / max(one, two, 1e-12) for one, two in (outer, inner))
    if change == 0.0:
        return [(start, stop, outer[0], inner[0])]
    steps = min(MOST_STEPS, max(1, math.ceil(change / STEP)))
    text = f"{steps} cylinder{'s' if steps > 1 else ''} of the same volume"
    conversion.changed(part, "outer_diameter_end", text, "", "sections of a model are cylinders")
    length = (stop - start) / steps
    rows = []
    for k in range(steps):
        d, b = (
            math.sqrt((p * p + p * r + r * r) / 3.0)
            for p, r in (_between(pair, k / steps, (k + 1) / steps) for pair in (outer, inner))
        )
        rows.append((start + k * length, start + (k + 1) * length, d, b))
    return rows


def _between(pair: tuple[float, float], a: float, b: float) -> tuple[float, float]:
    return pair[0] + a * (pair[1] - pair[0]), pair[0] + b * (pair[1] - pair[0])
