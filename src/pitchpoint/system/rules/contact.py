# SPDX-License-Identifier: Apache-2.0
"""Contacts of a model as records."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact import curve as curves
from pitchpoint.contact import impact
from pitchpoint.contact.triangles import TriangleSurface
from pitchpoint.core.errors import CompileError, GeometryError
from pitchpoint.elements import (
    curve_curve,
    curve_on_curve,
    point_curve,
    point_on_curve,
    point_surface,
    surface_surface,
)
from pitchpoint.elements.contacts import record as element
from pitchpoint.elements.signal import Pool
from pitchpoint.geometry.triangle_file import placed_triangles, read_triangles
from pitchpoint.model.checks.contacts import ORDER
from pitchpoint.model.components.contact import (
    CamContact,
    ContactCurve,
    ContactFriction,
    ContactLaw,
    ContactSurface,
    CurveContact,
    SurfaceContact,
)
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.places import Places

Array = NDArray[np.float64]

#: Function of an end (ground, BODY or BODY.MARKER): body number, point and axes in the body-fixed frame.
End: TypeAlias = Callable[[str], tuple[int, Array, Array]]


def cam_banks(places: Places) -> tuple[Bank, Bank]:
    """Cams and followers: force contacts, and permanent contacts (constraints)."""
    pool, rows, names = Pool(), [], []
    held_pool, held, held_names = Pool(), [], []
    for name, part in places.model.cam_contacts.items():
        where = f"cam_contacts.{name}"
        curve = curve_of(part.curve, f"{where}.curve")
        if part.permanent:
            row = np.zeros(1, point_on_curve.RECORD)[0]
            row["i"], row["pi"], _ = places.end(part.ends[0])
            row["j"], row["pj"], row["Bj"] = places.end(part.ends[1])
            point_on_curve.set_point_on_curve(row, held_pool, curve, part.radius)
            held.append(row)
            held_names.append(name)
            continue
        row = _marked(part.ends, places.end)
        point_curve.set_cam(row, pool, curve, part.radius, part.depth)
        _forces(row, _law_of(part, where), part.friction, where)
        rows.append(row)
        names.append(name)
    return (
        pack("point_curve", element.RECORD, rows, names, pool=pool.array()),
        pack("point_on_curve", point_on_curve.RECORD, held, held_names, pool=held_pool.array()),
    )


def curve_banks(places: Places) -> tuple[Bank, Bank]:
    """Contacts of two curves: force contacts, and permanent contacts (constraints)."""
    pools, rows, names = (Pool(), Pool()), ([], []), ([], [])  # type: ignore[var-annotated]
    for name, part in places.model.curve_contacts.items():
        where = f"curve_contacts.{name}"
        row = _marked(part.ends, places.end)
        both = curve_of(part.first, f"{where}.first"), curve_of(part.second, f"{where}.second")
        which = 1 if part.permanent else 0
        if part.permanent:
            curve_on_curve.set_held_curves(row, pools[1], both)
        else:
            curve_curve.set_curves(row, pools[0], both, part.depth, part.margin)
            _forces(row, _law_of(part, where), part.friction, where)
        rows[which].append(row)
        names[which].append(name)
    return (
        pack("curve_curve", element.RECORD, rows[0], names[0], pool=pools[0].array()),
        pack("curve_on_curve", element.RECORD, rows[1], names[1], pool=pools[1].array()),
    )


def _law_of(part: CamContact | CurveContact | SurfaceContact, where: str) -> ContactLaw:
    if part.law is None:
        raise CompileError(f"{where}: a contact that may open requires a law; add `law` or `permanent: true`")
    return part.law


def surface_banks(places: Places) -> tuple[Bank, Bank, Bank]:
    """Contacts of two surfaces: with a sphere, all others, and spheres in permanent contact."""
    pools, rows, names = (Pool(), Pool()), ([], [], []), ([], [], [])  # type: ignore[var-annotated]
    for name, part in places.model.surface_contacts.items():
        where = f"surface_contacts.{name}"
        first, second, ends = part.first, part.second, part.ends
        if not _in_order(first, second, part.line):
            first, second, ends = second, first, (ends[1], ends[0])
        row = _marked(ends, places.end)
        which = 2 if part.permanent else 0 if _has_ball(first, second, part.line) else 1
        if which == 1:
            _pair(row, pools[1], first, second, part, where)
        else:
            _ball(row, pools[0], first, second, part, where)
        if not part.permanent:
            _forces(row, _law_of(part, where), part.friction, where)
        rows[which].append(row)
        names[which].append(name)
    return (
        pack("point_surface", element.RECORD, rows[0], names[0], pool=pools[0].array()),
        pack("surface_surface", element.RECORD, rows[1], names[1], pool=pools[1].array()),
        pack("ball_on_surface", element.RECORD, rows[2], names[2]),
    )


def curve_of(part: ContactCurve, where: str) -> curves.Curve:
    """Curve from its description in the model.

    Parameters
    ----------
    part
        Description of the curve.
    where
        Path in the model, for messages.

    Raises
    ------
    CompileError
        If a number of the shape is missing or impossible.
    """
    try:
        if part.shape == "circle":
            center = (float(_first(part.x)), float(_first(part.y)))
            return curves.circle(_required(part.radius, "radius", where), center, part.hollow)
        if part.shape == "involute":
            if len(part.roll) != 2:
                raise CompileError(f"{where}.roll: an involute requires two roll angles")
            hand = 1 if part.hand == "left" else -1
            r_b = _required(part.radius, "radius", where)
            return curves.chain([curves.involute_piece(r_b, part.phase, part.roll, hand)], False)
        if len(part.x) != len(part.y) or len(part.x) < (3 if part.closed else 2):
            raise CompileError(
                f"{where}: x and y need the same number of points, at least two, or three for a closed curve"
            )
        points = np.column_stack([part.x, part.y])
        if part.shape == "spline":
            return curves.spline(points, part.closed)
        return curves.polygon(points, part.radii or 0.0, part.closed)
    except ValueError as fault:
        raise CompileError(f"{where}: {fault}") from None


def _first(values: tuple[float, ...]) -> float:
    return values[0] if values else 0.0


def _required(value: float | None, name: str, where: str) -> float:
    if value is None:
        raise CompileError(f"{where}.{name}: is required for this shape")
    return value


def _is_ball(part: ContactSurface) -> bool:
    return part.shape == "sphere" and not part.hollow


def _has_ball(first: ContactSurface, second: ContactSurface, line: bool) -> bool:
    """Whether a sphere touches the other surface; a ring all around a sphere is a contact of the ring."""
    around = line and "torus" in (first.shape, second.shape)
    return (_is_ball(first) or _is_ball(second)) and not around


def _marked(ends: tuple[str, str], end: End) -> np.void:
    """New record with bodies and markers."""
    row: np.void = element.new_records(1)[0]
    for letter, name in zip("ij", ends, strict=True):
        row[letter], point, axes = end(name)
        element.set_marker(row, letter, point, axes)
    return row


def _forces(row: np.void, law: ContactLaw, friction: ContactFriction | None, where: str) -> None:
    """Set law and friction of a record."""
    k = law.force / law.depth**law.exponent
    if law.restitution is None:
        impact.set_impact(row, k, law.exponent, law.damping, law.full_damping)
    elif law.damping > 0.0:
        raise CompileError(f"{where}.law: damping and restitution describe the same property; give one")
    else:
        speed = law.reference_speed
        impact.set_restitution(row, k, law.restitution, speed, law.exponent, law.every_speed)
    if friction is not None:
        try:
            speeds = friction.static_speed, friction.slip_speed
            impact.set_friction(row, friction.static, friction.dynamic, *speeds)
        except ValueError as fault:
            raise CompileError(f"{where}.friction: {fault}") from None


def _triangles(part: ContactSurface, where: str) -> TriangleSurface:
    """Triangle surface from a file."""
    if part.file is None:
        raise CompileError(f"{where}.file: a triangle surface requires a file")
    try:
        found = placed_triangles(read_triangles(part.file), part.unit or 1.0, part.hollow)
        return TriangleSurface.from_triangles(found)
    except (GeometryError, ValueError) as fault:
        raise CompileError(f"{where}.file: {fault}") from None


def _sizes(part: ContactSurface, where: str) -> list[float]:
    """Dimensions of a simple shape; for a cylinder including its length, if given."""
    names = {"plane": (), "cone": ("half_angle",), "torus": ("radius", "tube")}.get(part.shape, ("radius",))
    sizes = [_required(getattr(part, name), name, where) for name in names]
    return [*sizes, part.length] if part.shape == "cylinder" and part.length is not None else sizes


def _ball(
    row: np.void, pool: Pool, ball: ContactSurface, other: ContactSurface, part: SurfaceContact, where: str
) -> None:
    """Set a contact of a sphere with a surface."""
    if not _is_ball(ball) or (part.permanent and other.shape == "triangles"):
        raise CompileError(f"{where}.permanent: requires a sphere on a smooth surface")
    radius = _required(ball.radius, "radius", where)
    if other.shape == "triangles":
        point_surface.set_mesh(row, pool, _triangles(other, where), radius, part.depth)
        return
    try:
        given = _sizes(other, where)[: 1 if other.shape == "cylinder" else 2]
        point_surface.set_surface(row, other.shape, given, radius, other.hollow, part.line)
    except ValueError as fault:
        raise CompileError(f"{where}: {fault}") from None


def _pair(
    row: np.void, pool: Pool, one: ContactSurface, two: ContactSurface, part: SurfaceContact, where: str
) -> None:
    """Set a contact of two surfaces without a sphere."""
    shapes = one.shape, two.shape
    if "triangles" in shapes:
        _on_triangles(row, pool, one, two, part, where)
    elif shapes == ("plane", "plane"):
        sides = one.size
        if sides is None or two.size is not None:
            raise CompileError(f"{where}.size: of two planes one requires a size")
        surface_surface.set_plate_on_plane(row, pool, sides, part.depth)
    elif shapes == ("cylinder", "plane"):
        radius, length = _required(one.radius, "radius", where), _required(one.length, "length", where)
        surface_surface.set_cylinder_on_plane(row, radius, length, part.stations)
    elif one.shape == "torus":
        ring = _required(one.radius, "radius", where), _required(one.tube, "tube", where)
        if two.shape == "plane":
            surface_surface.set_ring_on_plane(row, *ring)
        else:
            surface_surface.set_ring_on_surface(
                row, ring, two.shape, _sizes(two, where), two.hollow, part.line
            )
    elif one.shape == "cone":
        cone = _required(one.half_angle, "half_angle", where), _required(one.length, "length", where)
        if two.shape == "plane":
            surface_surface.set_cone_on_plane(row, *cone, part.stations)
        else:
            surface_surface.set_cone_on_surface(row, *cone, two.shape, _sizes(two, where))
    elif shapes == ("cylinder", "cylinder"):
        radii = [_required(s.radius, "radius", where) for s in (one, two)]
        lengths = [_required(s.length, "length", where) for s in (one, two)]
        if part.line or two.hollow:
            surface_surface.set_cylinders_in_line(row, radii, lengths, two.hollow, part.stations)
        else:
            surface_surface.set_crossed_cylinders(row, radii, lengths)
    else:
        raise CompileError(
            f"{where}: contact of {shapes[0]} and {shapes[1]} is not supported; describe both by triangles"
        )


def _on_triangles(
    row: np.void, pool: Pool, one: ContactSurface, two: ContactSurface, part: SurfaceContact, where: str
) -> None:
    """Set a contact of a triangle surface with triangles or a simple shape."""
    surface = _triangles(one, where)
    if two.shape == "triangles":
        surface_surface.set_meshes(row, pool, (surface, _triangles(two, where)), part.depth)
        return
    try:
        surface_surface.set_mesh_on_shape(
            row, pool, surface, two.shape, _sizes(two, where), two.hollow, part.depth
        )
    except ValueError as fault:
        raise CompileError(f"{where}: {fault}") from None


def _in_order(first: ContactSurface, second: ContactSurface, line: bool) -> bool:
    """Whether the surfaces are in the order that the element kinds require.

    Spheres first, triangles before simple shapes, these in the order of `ORDER`, a plate before the plane,
    the inner before the hollow one, the shorter of two cylinders or cones before the longer one.
    """
    if _has_ball(first, second, line):
        return _is_ball(first)
    if "triangles" in (first.shape, second.shape):
        return first.shape == "triangles"
    if first.shape != second.shape:
        return ORDER.index(first.shape) < ORDER.index(second.shape)
    if first.shape == "plane":
        return first.size is not None
    if first.hollow != second.hollow:
        return second.hollow
    return first.length is None or second.length is None or first.length <= second.length
