# SPDX-License-Identifier: Apache-2.0
"""Checks of contacts of surfaces: which pairs can touch, sizes, axes, files of triangles."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from pitchpoint.core.errors import GeometryError
from pitchpoint.model.keys import Place
from pitchpoint.model.read import Reader

if TYPE_CHECKING:
    from pitchpoint.model.components.contact import ContactSurface, SurfaceContact
    from pitchpoint.model.parts import Parts

#: Sizes that a surface needs against a sphere or triangles.
SIZES: dict[str, tuple[str, ...]] = {
    "plane": (),
    "sphere": ("radius",),
    "cylinder": ("radius",),
    "cone": ("half_angle",),
    "torus": ("radius", "tube"),
    "triangles": ("file",),
}
#: Sizes that both surfaces of other pairs need; the order of a pair with a plane does not matter.
PAIRS: dict[tuple[str, str], tuple[tuple[str, ...], tuple[str, ...]]] = {
    ("cylinder", "plane"): (("radius", "length"), ()),
    ("torus", "plane"): (("radius", "tube"), ()),
    ("cylinder", "cylinder"): (("radius", "length"), ("radius", "length")),
}
PARALLEL = 0.02
"""Sine between two axes below which cylinders do not cross."""


def check_surfaces(parts: Parts, name: str, contact: SurfaceContact, report: Reader) -> None:
    """A contact of two surfaces.

    Parameters
    ----------
    parts
        Sections of the model.
    name, contact
        Its name and the contact.
    report
        Takes the problems.
    """
    at: Place = ("surface_contacts", name)
    one, two = (contact.first, "first"), (contact.second, "second")
    shapes = {contact.first.shape, contact.second.shape}
    for part, key in (one, two):
        check_file(part, (*at, key), report)
    if contact.line and shapes != {"cylinder"}:
        report.problem((*at, "line"), "has no effect: only two cylinders have a choice", remedy="remove it")
    if contact.permanent:
        _held(contact, at, report)
    if "triangles" in shapes or any(p.shape == "sphere" and not p.hollow for p, _ in (one, two)):
        for part, key in (one, two):
            _sizes(part, SIZES[part.shape], (*at, key), report)
        return
    if one[0].shape == "plane":
        one, two = two, one
    pair = (one[0].shape, two[0].shape)
    bore = pair == ("cylinder", "cylinder") and one[0].hollow != two[0].hollow
    if pair not in PAIRS or (not bore and (one[0].hollow or two[0].hollow)):
        hollow = "hollow " * (one[0].hollow or two[0].hollow)
        report.problem(
            at,
            f"is of a {hollow}{pair[0]} and a {pair[1]}, which is not known",
            remedy="spheres and triangles touch everything, cylinder and torus a plane, cylinders each "
            "other; use triangles for others",
        )
        return
    for (part, key), needed in zip((one, two), PAIRS[pair], strict=True):
        _sizes(part, needed, (*at, key), report)
    if bore:
        _bore(contact, at, report)
    elif pair == ("cylinder", "cylinder") and not contact.line:
        _crossed(parts, contact, at, report)


def _held(contact: SurfaceContact, at: Place, report: Reader) -> None:
    """Only a sphere on a smooth surface can be kept in contact."""
    shapes = [contact.first.shape, contact.second.shape]
    balls = [p.shape == "sphere" and not p.hollow for p in (contact.first, contact.second)]
    if not any(balls) or "triangles" in shapes:
        report.problem(
            (*at, "permanent"),
            f"is of a {shapes[0]} and a {shapes[1]}; what stays is a sphere on any surface but triangles",
            remedy="give a law instead",
        )


def check_file(part: ContactSurface, at: Place, report: Reader) -> None:
    """The triangles of a surface, and keys that only they have.

    Parameters
    ----------
    part
        The surface.
    at
        Its place in the model.
    report
        Takes the problems.
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
    """What goes into a bore is thinner than it."""
    pin, bore = contact.first, contact.second
    if pin.hollow:
        pin, bore = bore, pin
    if pin.radius is not None and bore.radius is not None and pin.radius >= bore.radius:
        key = "first" if pin is contact.first else "second"
        report.problem(
            (*at, key, "radius"),
            "does not go into the bore",
            value=f"{pin.radius:g} m",
            limit=f"< {bore.radius:g} m",
            remedy="give the play between them",
        )


def _crossed(parts: Parts, contact: SurfaceContact, at: Place, report: Reader) -> None:
    """Cylinders that touch at one place have axes that cross."""
    from pitchpoint.model.frames import GROUND, axes_of, split

    if (*at, "ends") in report.tainted or any(
        split(end)[0] not in (*parts.bodies, GROUND) for end in contact.ends
    ):
        return
    a, b = (axes_of(parts, end)[:, 2] for end in contact.ends)
    sine = math.sqrt(max(0.0, 1.0 - float(a @ b) ** 2))
    if sine < PARALLEL:
        report.problem(
            at,
            "is of two cylinders side by side, which touch at no single place",
            value=f"{math.degrees(math.asin(sine)):.3g} deg between their axes",
            remedy="write line: true, and the law for the whole line",
        )


def _sizes(part: ContactSurface, needed: tuple[str, ...], at: Place, report: Reader) -> None:
    for key in needed:
        if getattr(part, key) is None and (*at, key) not in report.tainted:
            report.problem((*at, key), f"is missing: the {part.shape} needs it", remedy=f"add {key}")
    if part.half_angle is not None and part.half_angle >= 0.5 * math.pi:
        report.problem(
            (*at, "half_angle"), "is not a cone", limit="< 90 deg", remedy="give the half of its angle"
        )
