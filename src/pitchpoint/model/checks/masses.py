# SPDX-License-Identifier: Apache-2.0
"""Checks of masses and inertias: unique, physically possible, and sufficient for the motion of the body."""

from __future__ import annotations

import numpy as np

from pitchpoint.core.errors import GeometryError
from pitchpoint.model.components.body import Body
from pitchpoint.model.frames import GROUND
from pitchpoint.model.inertia import (
    BodyInertia,
    asks_gears,
    bevel_gear_inertia,
    body_inertia,
    gear_inertia,
    matrix,
)
from pitchpoint.model.keys import Place
from pitchpoint.model.parts import Parts
from pitchpoint.model.reading.reader import Reader

INERTIAS = {
    "torsion": ("inertia",),
    "planar": ("inertia", "mass"),
    "free": ("inertia", "mass", "transverse_inertia"),
    "fixed": (),
}
_SUM = {"inertia": "polar", "mass": "mass", "transverse_inertia": "transverse"}


def check_masses(parts: Parts, report: Reader) -> None:
    """Check that the mass properties of every body are unique and physically possible."""
    for name, body in parts.bodies.items():
        at: Place = ("bodies", name)
        if at in report.tainted:
            continue
        others = [k for k in ("inertia", "transverse_inertia") if getattr(body, k) is not None]
        if body.inertia_tensor is not None:
            if others:
                report.problem(
                    (*at, "inertia_tensor"),
                    f"cannot be combined with {' and '.join(others)}",
                    remedy="give the tensor alone",
                )
            _tensor(body, (*at, "inertia_tensor"), report)
        elif body.solid is not None and not body.is_round and others:
            report.problem(
                (*at, others[0]),
                "cannot be combined with a solid that is not axisymmetric about the z axis of the body",
                remedy=f"remove {' and '.join(others)}, or align the solid by its axes and origin",
            )
        elif not body.is_round and others:
            report.problem(
                (*at, "center_of_mass"),
                f"is off the axis, and {' and '.join(others)} do not define the inertia about it",
                remedy="give inertia_tensor about the centre of mass instead",
            )


def _tensor(body: Body, at: Place, report: Reader) -> None:
    if body.inertia_tensor is None or at in report.tainted:
        return
    least, middle, most = (float(v) for v in np.linalg.eigvalsh(matrix(body.inertia_tensor)))
    # tolerance for moments rounded to a few digits
    if least < -1e-6 * most or least + middle < most * (1.0 - 1e-4):
        report.problem(
            at,
            "are not physically possible",
            value=f"principal moments {least:.6g}, {middle:.6g}, {most:.6g} kg m^2",
            limit="none negative, none above the sum of the other two",
            remedy="check the order Ixx, Iyy, Izz, Ixy, Iyz, Izx, the units and the signs of the products",
        )


def check_motions(parts: Parts, report: Reader) -> None:
    """Check that moving bodies have inertia, and that loads and bearings are not on fixed bodies."""
    for name in parts.bodies:
        _inertia(parts, name, report)
    fixed = {n for n, b in parts.bodies.items() if b.moves == "fixed"}
    for group in ("loads", "bearings"):
        for name, part in getattr(parts, group).items():
            if part.body in fixed and getattr(part, "housing", None) in (None, GROUND):
                report.problem(
                    (group, name, "body"),
                    f"names {part.body}, which is fixed: it has no effect",
                    remedy="remove it, or give the body a motion",
                )


def _inertia(parts: Parts, name: str, report: Reader) -> None:
    """Check the mass and inertia of one body that its motion requires."""
    body = parts.bodies[name]
    if body.moves == "joint" and asks_gears(body) and _readable(parts, body, report):
        for gear in (*body.gears, *body.bevel_gears):
            _has_inertia(parts, gear, report)
    if body.moves == "joint" or not body.is_round or body.elastic is not None:
        return  # checked with the mechanism; elastic bodies have the mass of their file
    needed = [k for k in INERTIAS[body.moves] if ("bodies", name, k) not in report.tainted]
    given = {k: getattr(body, k) for k in needed if getattr(body, k) is not None}
    total = None
    if _readable(parts, body, report):
        # the inertia of the body requires all data of its gears
        carried = (*body.gears, *body.bevel_gears)
        if asks_gears(body) and not all(_has_inertia(parts, g, report) for g in carried):
            return
        total = body_inertia(body, parts.gears, parts.bevel_gears)
        given = {k: getattr(total, _SUM[k]) for k in needed}
    zero = [key for key, amount in given.items() if not amount > 0.0]
    if not body.gears and ("bodies", name, "gears") in report.tainted:
        zero = []  # the gears are unreadable
    for key in zero:
        report.problem(
            ("bodies", name, key),
            f"is zero, but the body moves ({body.moves})",
            limit="> 0",
            remedy=f"give {key}" + ("" if body.gears or body.bevel_gears else " (the body carries no gears)"),
        )
    whole = not any(("bodies", name, k) in report.tainted for k in ("gears", "mass", "center_of_mass"))
    if total is not None and whole and "transverse_inertia" in given and not zero and not total.central > 0.0:
        _transverse(name, body, total, report)


def _readable(parts: Parts, body: Body, report: Reader) -> bool:
    """Whether all gears of a body could be read and have valid geometry."""
    return all(
        g in getattr(parts, group) and (group, g) not in report.tainted and g not in parts.misshapen
        for group in ("gears", "bevel_gears")
        for g in getattr(body, group)
    )


def _transverse(name: str, body: Body, total: BodyInertia, report: Reader) -> None:
    """Report a tilting body without transverse inertia about its centre of mass."""
    least = total.mass * total.center * total.center
    place = f"the centre of mass at {total.center * 1e3:.6g} mm from the origin"
    if body.transverse_inertia is None:
        report.problem(
            ("bodies", name, "transverse_inertia"),
            f"of the gears is zero about {place}, but the body tilts (motion: free)",
            limit=f"> {least:.6g} kg m^2 about the origin",
            remedy="give transverse_inertia about the origin",
        )
        return
    report.problem(
        ("bodies", name, "transverse_inertia"),
        f"refers to the origin and leaves no inertia about {place}",
        value=f"{body.transverse_inertia:.6g} kg m^2",
        limit=f"> {least:.6g} kg m^2, mass * center_of_mass^2",
        remedy=f"add {least:.6g} kg m^2 if it was meant about the centre of mass, or "
        f"{'give' if body.center_of_mass is None else 'correct'} center_of_mass",
    )


def _has_inertia(parts: Parts, gear: str, report: Reader) -> bool:
    """Whether mass and inertia of a gear can be computed; reports the problem if not."""
    group = "gears" if gear in parts.gears else "bevel_gears"
    try:
        if group == "gears":
            gear_inertia(parts.gears[gear])
        else:
            bevel_gear_inertia(parts.bevel_gears[gear])
    except GeometryError as error:
        report.hand_on((group, gear), error.problem)
        return False
    return True
