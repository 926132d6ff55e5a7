# SPDX-License-Identifier: Apache-2.0
"""Remarks on bodies and torques at unintended positions, because the model does not give them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import Message, remark
from pitchpoint.core.units import format_quantity
from pitchpoint.model.checks.carried_meshes import off_axis
from pitchpoint.model.frames import GROUND, Array, bodies_of, body_frame, place_of, split
from pitchpoint.model.shafts import SEATED
from pitchpoint.model.stand_ins import own_parts

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

Span = tuple[str, str, Array, Array, float, float]
"""Body, gear, position and axis of the body, axial start and end of the gear [m]."""
TURNING = ("torsion_springs", "torsion_maxwells", "clutches")
"""Sections whose torques act at the origin of a body, which is the start of a shaft."""
ALIGNED = 0.01
"""Distance of two axes that a coupling, such as an Oldham coupling, may bridge as misalignment [m]."""
SAME = 1e-6
"""Distance of two axes, relative to the tip diameter, up to which they coincide."""


def places_left_open(model: Model) -> tuple[Message, ...]:
    """A remark for every axis that is located by a joint, overlapping gears, the far end of a
    shaft, connections of distant axes, and carriers off the axis of their central gears."""
    beside = (remark(f"bodies.{o.carrier}.position", o.words, o.remedy) for o in off_axis(model))
    apart = (*_far_ends(model), *_distant_axes(model), *_distant_housings(model))
    return (*_axes_by_joints(model), *_gears_in_gears(model), *apart, *beside)


def _axes_by_joints(model: Model) -> Iterator[Message]:
    """Bodies without position that rotate about their own axis through a joint.

    A planet carrier without position would rotate about the pin of its first planet.
    """
    joined: dict[str, list[str]] = {}
    for joint, part in own_parts(model.joints).items():  # a stage locates its carrier
        for body_name in dict.fromkeys(split(end)[0] for end in part.bodies):
            joined.setdefault(body_name, []).append(joint)
    coupled = {name for coupling in model.couplings.values() for name in coupling.bodies}
    for name, body in model.bodies.items():
        seat = model.mechanism.seats.get(name)
        if body.position is not None or body.gears or body.bevel_gears:
            continue
        if seat is None or seat.joint is not None:
            continue
        if seat.kind not in ("revolute", "planar"):
            continue
        origin, _ = body_frame(model, name)
        joints = joined.get(name)
        if not joints or name in coupled or origin is None:
            continue
        where = ", ".join(format_quantity(round(float(x), 9) + 0.0, "length", 4) for x in origin)
        yield remark(
            f"bodies.{name}",
            f"has no position and takes that of joints.{joints[0]}, [{where}], so that it "
            "rotates about an axis there",
            "for another axis, give position: [x, y, z]",
        )


def _gears_in_gears(model: Model) -> Iterator[Message]:
    """External gears of two bodies that overlap on one axis, such as planets without `direction`."""
    spans = [
        (name, gear, *span)
        for name, body in model.bodies.items()
        for gear, offset in body.gears.items()
        if gear in model.gears and (span := _span(model, name, gear, offset)) is not None
    ]
    for first, second in _on_one_axis(spans, [model.gears[span[1]].geometry.d_a for span in spans]):
        (one, a, at, along, low, high), (two, b, other, way, least, most) = first, second
        apart = other - at
        off_axis = float(np.linalg.norm(apart - (apart @ along) * along))
        reach = SAME * model.gears[a].geometry.d_a
        if one == two or abs(along @ way) < 1.0 - SAME or off_axis > reach:
            continue
        ends = sorted(float(other @ along + x * (way @ along)) for x in (least, most))
        here = float(at @ along)
        if min(ends[1], here + high) - max(ends[0], here + low) > reach:
            yield remark(
                f"bodies.{two}",
                f"{b} overlaps with {a} of {one}, on the same axis",
                "give direction in the meshes that locate them, or position: [x, y, z] of the bodies",
            )


def _far_ends(model: Model) -> Iterator[Message]:
    """Torques at the start of an elastic shaft, from a body that is nearer to its end."""
    for group in TURNING:
        for name, part in getattr(model, group).items():
            pairs = (part.bodies, part.bodies[::-1]) if len(part.bodies) == 2 else ()
            for shaft, end in pairs:
                other, marker = split(end)
                if shaft not in model.shafts or other not in model.bodies:
                    continue  # the place is that of a marker
                origin, axes = body_frame(model, shaft)
                place = place_of(model, end) if marker else body_frame(model, other)[0]
                if origin is None or place is None:
                    continue
                if (place - origin) @ axes[:, 2] > 0.5 * model.shafts[shaft].length:
                    yield remark(
                        f"{group}.{name}",
                        f"acts at the start of the shaft {shaft}, but {other} is nearer to its end: the "
                        "torque does not twist the shaft between them",
                        f"add a marker at the end to {shaft} and name {shaft}.MARKER instead",
                    )


def _distant_axes(model: Model) -> Iterator[Message]:
    """Couplings and torsional elements between rotating bodies on parallel axes that are apart."""
    for group in ("couplings", *TURNING):
        for name, part in getattr(model, group).items():
            bodies = bodies_of(part.bodies)
            if len(bodies) < 2 or not getattr(part, "carries_torque", True):
                continue
            if any(b in model.bodies and model.bodies[b].moves == "fixed" for b in bodies):
                continue  # the origin of a frame is not its axis
            (at, axes), (other, way) = (body_frame(model, body) for body in bodies)
            if at is None or other is None or abs(axes[:, 2] @ way[:, 2]) < 1.0 - SAME:
                continue
            apart = float(np.linalg.norm(np.cross(axes[:, 2], other - at)))
            if apart > ALIGNED:
                yield remark(
                    f"{group}.{name}.bodies",
                    f"{' and '.join(bodies)} have parallel axes {format_quantity(apart, 'length', 4)} "
                    "apart, and the torque between them acts without a force",
                    "correct the positions, or connect them by a mesh or a ratio",
                )


def _distant_housings(model: Model) -> Iterator[Message]:
    """Bearings outside the shaft or gear that is named as their housing, unless that is a planet carrier."""
    found: dict[str, dict[tuple[str, str], tuple[str, float, float]]] = {}
    carriers = {seat.parent for seat in model.mechanism.seats.values() if seat.joint is not None}
    for group in SEATED:
        for name, part in getattr(model, group).items():
            house, marker = split(part.housing or GROUND)
            if marker or house not in model.bodies or house in carriers:
                continue
            (origin, axes), (at, own) = body_frame(model, house), body_frame(model, part.body)
            sizes = [abs(model.gears[gear].geometry.d_a) for gear in model.bodies[house].gears]
            if house in model.shafts:
                sizes += [section.diameter for section in model.shafts[house].sections]
            if origin is None or at is None or not sizes:
                continue
            away = np.cross(axes[:, 2], at + own[:, 2] * part.position[2] - origin)
            apart = float(np.linalg.norm(away))
            if apart > 0.5 * max(sizes):
                found.setdefault(house, {})[group, name] = part.body, apart, max(sizes)
    for house, bearings in found.items():
        if len({body for body, *_ in bearings.values()}) > 1:
            continue  # planets on bearings only
        for (group, name), (_, apart, size) in bearings.items():
            far, wide = (format_quantity(length, "length", 4) for length in (apart, size))
            yield remark(
                f"{group}.{name}.housing",
                f"the axis of {house} is {far} away from the bearing, outside its diameter of {wide}",
                "name the housing, or remove housing for ground",
            )


def _on_one_axis(spans: list[Span], sizes: list[float]) -> Iterator[tuple[Span, Span]]:
    """Pairs of gears on nearly the same axis, preselected by array operations for models with many gears."""
    places = np.array([span[2] for span in spans]).reshape(-1, 3)
    ways = np.array([span[3] for span in spans]).reshape(-1, 3)
    for k, (span, size) in enumerate(zip(spans, sizes, strict=True)):
        apart = places[k + 1 :] - span[2]
        off_axis = np.linalg.norm(apart - np.outer(apart @ span[3], span[3]), axis=1)
        near = (off_axis <= 2.0 * SAME * size) & (np.abs(ways[k + 1 :] @ span[3]) >= 1.0 - 2.0 * SAME)
        for other in np.flatnonzero(near):
            yield span, spans[k + 1 + int(other)]


def _span(model: Model, body: str, gear: str, offset: float) -> tuple[Array, Array, float, float] | None:
    """Position and axis of the body of an external gear, axial start and end of the gear [m]."""
    origin, axes = body_frame(model, body)
    if origin is None or model.gears[gear].geometry.is_internal:
        return None
    half = 0.5 * model.gears[gear].face_width
    return origin, axes[:, 2], offset - half, offset + half
