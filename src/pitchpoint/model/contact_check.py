# SPDX-License-Identifier: Apache-2.0
"""Checks of contacts: shapes have their sizes, pairs of surfaces can touch, laws are consistent."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.model.keys import Place
from pitchpoint.model.read import Reader
from pitchpoint.model.surface_check import check_surfaces

if TYPE_CHECKING:
    from pitchpoint.model.components.contact import (
        CamContact,
        ContactCurve,
        ContactFriction,
        ContactLaw,
        CurveContact,
        SurfaceContact,
    )
    from pitchpoint.model.parts import Parts


def check_contacts(parts: Parts, report: Reader) -> None:
    """Everything about a contact that more than one key decides."""
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
    """What never parts has no law, and all else has one."""
    if part.permanent:
        for key in forces:
            if getattr(part, key) is not None:
                report.problem((*at, key), "has no effect: what never parts has no law", remedy="remove it")
    elif part.law is None and (*at, "law") not in report.tainted:
        report.problem(
            (*at, "law"),
            "is missing: bodies that may part",
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
        report.problem((*at, "radius"), f"is missing: the {curve.shape} has one", remedy="add radius: 20 mm")
    if curve.shape == "involute":
        roll = curve.roll
        if len(roll) != 2 or not min(roll, default=0.0) > 0.0 or roll[0] == roll[1]:
            report.problem(
                (*at, "roll"),
                "is not two different angles above zero",
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
