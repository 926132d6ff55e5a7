# SPDX-License-Identifier: Apache-2.0
"""Checks of contacts: supported pairs of shapes, sizes, axes, triangle files, contact laws."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from pitchpoint.core.errors import GeometryError
from pitchpoint.model.checks.seats import seat_of
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.model.components.contact import (
        CamContact,
        ContactCurve,
        ContactFriction,
        ContactLaw,
        ContactSurface,
        CurveContact,
        SurfaceContact,
    )
    from pitchpoint.model.parts import Parts


#: Sizes required of a surface in contact with a sphere or triangles.
SIZES: dict[str, tuple[str, ...]] = {
    "plane": (),
    "sphere": ("radius",),
    "cylinder": ("radius",),
    "cone": ("half_angle",),
    "torus": ("radius", "tube"),
    "triangles": ("file",),
}
#: Sizes required of both surfaces of other pairs, in the order of `ORDER`.
PAIRS: dict[tuple[str, str], tuple[tuple[str, ...], tuple[str, ...]]] = {
    ("plane", "plane"): ((), ()),
    ("cylinder", "plane"): (("radius", "length"), ()),
    ("cone", "plane"): (("half_angle", "length"), ()),
    ("torus", "plane"): (("radius", "tube"), ()),
    ("cylinder", "cylinder"): (("radius", "length"), ("radius", "length")),
    ("cone", "cylinder"): (("half_angle", "length"), ("radius",)),
    ("cone", "cone"): (("half_angle", "length"), ("half_angle", "length")),
    ("torus", "cylinder"): (("radius", "tube"), ("radius",)),
    ("torus", "cone"): (("radius", "tube"), ("half_angle",)),
    ("torus", "torus"): (("radius", "tube"), ("radius", "tube")),
}
ORDER = ("torus", "cone", "cylinder", "plane", "sphere")
"""Order of the shapes in a pair; a sphere here is hollow."""
PARALLEL = 0.02
"""Sine of the angle between two axes below which cylinders are parallel."""


def check_surfaces(parts: Parts, name: str, contact: SurfaceContact, report: Reader) -> None:
    """Check a contact of two surfaces.

    Parameters
    ----------
    parts
        Sections of the model.
    name, contact
        Its name and the contact.
    report
        Collects the problems.
    """
    at: Place = ("surface_contacts", name)
    one, two = (contact.first, "first"), (contact.second, "second")
    shapes = {contact.first.shape, contact.second.shape}
    for part, key in (one, two):
        check_file(part, (*at, key), report)
    around = "torus" in shapes and shapes <= set(ORDER[:3]) or seat_of(contact) is not None
    if contact.line and shapes != {"cylinder"} and not (around and not contact.permanent):
        report.problem(
            (*at, "line"),
            "has no effect: it is for two cylinders, a torus on a cylinder, cone or torus, or a sphere in a "
            "hollow cone or in the hole of a torus",
            remedy="remove it",
        )
    if contact.permanent:
        _held(contact, at, report)
    _plates(parts, contact, at, report)
    if "triangles" in shapes or any(p.shape == "sphere" and not p.hollow for p, _ in (one, two)):
        for part, key in (one, two):
            _sizes(part, SIZES[part.shape], (*at, key), report)
        if shapes == {"sphere", "cylinder"} and contact.first.hollow != contact.second.hollow:
            _bore(contact, at, report)
        return
    one, two = sorted((one, two), key=lambda part: (ORDER.index(part[0].shape), part[0].hollow))
    pair = (one[0].shape, two[0].shape)
    if pair not in PAIRS:
        report.problem(
            at,
            f"is between {_named(one[0])} and {_named(two[0])}, which is not supported",
            remedy="describe corners of one of them by spheres, edges by cylinders, or it by triangles",
        )
        return
    may_be_hollow = pair[0] == "torus" and pair[1] != "plane" or pair == ("cylinder", "cylinder")
    if one[0].hollow or (two[0].hollow and not may_be_hollow):
        report.problem(
            at,
            f"is between {_named(one[0])} and {_named(two[0])}, which touch at an edge",
            remedy="describe the edge by a torus with a small tube, or one of them by triangles",
        )
        return
    bore = pair == ("cylinder", "cylinder") and two[0].hollow
    for (part, key), needed in zip((one, two), PAIRS[pair], strict=True):
        _sizes(part, needed, (*at, key), report)
    if bore:
        _bore(contact, at, report)
    elif pair == ("cylinder", "cylinder") and not contact.line:
        _crossed(parts, contact, at, report)


def _plates(parts: Parts, contact: SurfaceContact, at: Place, report: Reader) -> None:
    """Check the size of a plate on a plane, and that both planes have their material on opposite sides."""
    both = (("first", contact.first), ("second", contact.second))
    sized = [key for key, part in both if part.size is not None]
    if [part.shape for _, part in both] != ["plane", "plane"]:
        for key in sized:
            report.problem((*at, key, "size"), "has no effect: it is for two planes", remedy="remove it")
        return
    if any((*at, key, "size") in report.tainted for key, _ in both):
        return
    if len(sized) != 1:
        report.problem(
            at,
            "is between two planes of limited size" if sized else "is between two planes without limits",
            remedy="give the size of the smaller one only: it is a plate on an infinite plane"
            if sized
            else "give the plate that touches the plane its sides, such as size: [80 mm, 40 mm]",
        )
        return
    cosine = _cosine(parts, contact, at, report)
    if cosine is not None and cosine > 0.0:
        report.problem(
            (*at, "ends"),
            "have planes that face the same way, with "
            f"{math.degrees(math.acos(min(1.0, cosine))):.3g} deg between their z axes",
            limit="> 90 deg",
            remedy="rotate the axes of a marker: z points out of the material of its plane",
        )


def _cosine(parts: Parts, contact: SurfaceContact, at: Place, report: Reader) -> float | None:
    """Cosine of the angle between the z axes of both ends; None if an end is unknown."""
    from pitchpoint.model.frames import GROUND, axes_of, split

    known = (*parts.bodies, *parts.beams, GROUND)
    if (*at, "ends") in report.tainted or any(split(end)[0] not in known for end in contact.ends):
        return None
    a, b = (axes_of(parts, end)[:, 2] for end in contact.ends)
    return float(a @ b)


def _named(part: ContactSurface) -> str:
    """Shape of a surface with its article."""
    return f"a {'hollow ' * part.hollow}{part.shape}"


def _held(contact: SurfaceContact, at: Place, report: Reader) -> None:
    """Check that a permanent contact is that of a sphere on a smooth surface."""
    shapes = [contact.first.shape, contact.second.shape]
    balls = [p.shape == "sphere" and not p.hollow for p in (contact.first, contact.second)]
    if not any(balls) or "triangles" in shapes:
        report.problem(
            (*at, "permanent"),
            f"is between a {shapes[0]} and a {shapes[1]}; only a sphere on a surface "
            "other than triangles can be permanent",
            remedy="give a law instead",
        )


def check_file(part: ContactSurface, at: Place, report: Reader) -> None:
    """Check the triangles of a surface, and keys that are for triangles only.

    Parameters
    ----------
    part
        The surface.
    at
        Its path in the model.
    report
        Collects the problems.
    """
    if part.shape != "triangles":
        for key in ("file", "unit", "open"):
            if getattr(part, key) not in (None, False):
                report.problem((*at, key), f"has no effect: a {part.shape} has no file", remedy="remove it")
        return
    if part.file is None or (*at, "file") in report.tainted:
        return
    if part.file.lower().endswith(".stl") and part.unit is None:
        if (*at, "unit") not in report.tainted:
            report.problem(
                (*at, "unit"),
                "is missing: an STL file does not contain its unit",
                remedy="add unit: 1 mm, for example",
            )
        return
    from pitchpoint.geometry.triangle_file import read_triangles, triangle_faults

    try:
        found = read_triangles(part.file)
    except GeometryError as error:
        report.hand_on((*at, "file"), error.problem.changed(where=""))
        return
    for wrong in triangle_faults(found, part.unit or 1.0, part.open, part.hollow):
        report.hand_on((*at, "file"), wrong)


def _bore(contact: SurfaceContact, at: Place, report: Reader) -> None:
    """Check that the cylinder or sphere in a bore is smaller than the bore."""
    pin, bore = contact.first, contact.second
    if pin.hollow:
        pin, bore = bore, pin
    if pin.radius is not None and bore.radius is not None and pin.radius >= bore.radius:
        key = "first" if pin is contact.first else "second"
        report.problem(
            (*at, key, "radius"),
            "does not fit into the bore",
            value=f"{pin.radius:g} m",
            limit=f"< {bore.radius:g} m",
            remedy="leave a clearance between them",
        )


def _crossed(parts: Parts, contact: SurfaceContact, at: Place, report: Reader) -> None:
    """Check that cylinders with point contact are not parallel."""
    cosine = _cosine(parts, contact, at, report)
    if cosine is None:
        return
    sine = math.sqrt(max(0.0, 1.0 - cosine**2))
    if sine < PARALLEL:
        report.problem(
            at,
            "is between parallel cylinders, which have no single contact point",
            value=f"{math.degrees(math.asin(sine)):.3g} deg between their axes",
            remedy="write line: true, and the law for the whole line",
        )


def _sizes(part: ContactSurface, needed: tuple[str, ...], at: Place, report: Reader) -> None:
    for key in needed:
        if getattr(part, key) is None and (*at, key) not in report.tainted:
            report.problem((*at, key), f"is missing: required for shape {part.shape}", remedy=f"add {key}")
    if part.half_angle is not None and part.half_angle >= 0.5 * math.pi:
        report.problem(
            (*at, "half_angle"), "is not a cone", limit="< 90 deg", remedy="give half of the cone angle"
        )


def check_contacts(parts: Parts, report: Reader) -> None:
    """Check all contacts for missing and contradicting keys."""
    for name, cam in parts.cam_contacts.items():
        _cam(cam, ("cam_contacts", name), report)
    for name, pair in parts.curve_contacts.items():
        at: Place = ("curve_contacts", name)
        _curve(pair.first, (*at, "first"), report)
        _curve(pair.second, (*at, "second"), report)
        _permanent(pair, at, ("law", "friction", "depth", "margin"), report)
        _forces(pair, at, report)
    for name, contact in parts.surface_contacts.items():
        check_surfaces(parts, name, contact, report)
        held = ("law", "friction", "depth")
        _permanent(contact, ("surface_contacts", name), held, report)
        _forces(contact, ("surface_contacts", name), report)


def _cam(cam: CamContact, at: Place, report: Reader) -> None:
    _curve(cam.curve, (*at, "curve"), report)
    _permanent(cam, at, ("law", "friction", "depth"), report)
    _forces(cam, at, report)


def _permanent(
    part: CamContact | CurveContact | SurfaceContact, at: Place, forces: tuple[str, ...], report: Reader
) -> None:
    """Check that a contact has a law unless it is permanent."""
    if part.permanent:
        for key in forces:
            if getattr(part, key) is not None:
                report.problem((*at, key), "has no effect on a permanent contact", remedy="remove it")
    elif part.law is None and (*at, "law") not in report.tainted:
        report.problem(
            (*at, "law"),
            "is missing: required unless the contact is permanent",
            remedy="add law: {force: 1 kN, depth: 0.1 mm}, or permanent: true",
        )


def _forces(part: CamContact | CurveContact | SurfaceContact, at: Place, report: Reader) -> None:
    if part.law is not None:
        _law(part.law, (*at, "law"), report)
    if part.friction is not None:
        _friction(part.friction, (*at, "friction"), report)


def _law(law: ContactLaw, at: Place, report: Reader) -> None:
    if law.restitution is not None and law.damping > 0.0:
        report.problem((*at, "damping"), "cannot be combined with restitution", remedy="give one of the two")


def _friction(friction: ContactFriction, at: Place, report: Reader) -> None:
    if max(friction.static, friction.dynamic) > 0.0 and not friction.static_speed < friction.slip_speed:
        report.problem(
            (*at, "static_speed"),
            "is not below slip_speed",
            value=f"{friction.static_speed:g} m/s",
            limit=f"< {friction.slip_speed:g} m/s",
            remedy="exchange them",
        )


def _curve(curve: ContactCurve, at: Place, report: Reader) -> None:
    if curve.shape in ("circle", "involute") and curve.radius is None:
        report.problem(
            (*at, "radius"), f"is missing: required for shape {curve.shape}", remedy="add radius: 20 mm"
        )
    if curve.shape == "involute":
        roll = curve.roll
        if len(roll) != 2 or not min(roll, default=0.0) > 0.0 or roll[0] == roll[1]:
            report.problem(
                (*at, "roll"),
                "are not two different positive angles",
                remedy="write for example [10 deg, 40 deg]",
            )
        return
    if curve.shape == "circle":
        return
    least = 3 if curve.closed else 2
    if len(curve.x) != len(curve.y) or len(curve.x) < least:
        report.problem(
            (*at, "x"),
            f"has {len(curve.x)} points, and y has {len(curve.y)}",
            limit=f"the same number, at least {least}",
            remedy="give both for every point",
        )
    elif curve.shape == "polygon" and curve.radii and len(curve.radii) != len(curve.x):
        report.problem(
            (*at, "radii"),
            f"has {len(curve.radii)} entries for {len(curve.x)} corners",
            remedy="give one radius per corner",
        )
