# SPDX-License-Identifier: Apache-2.0
"""Checks of single joints, before positions are computed."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from pitchpoint.model.components.joint import FUNCTIONS
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.model.components.joint import Joint
    from pitchpoint.model.parts import Parts

MAX_TILT = math.radians(85.0)
"""Maximum initial beta, well below the singularity of alpha and spin [rad]."""


def check_joints(parts: Parts, report: Reader) -> None:
    """Check that every joint has the keys required by its type."""
    for name, joint in parts.joints.items():
        at: Place = ("joints", name)
        if at in report.tainted:
            continue
        if joint.type == "screw" and not joint.lead:
            what = "is missing" if joint.lead is None else "is zero"
            report.problem(
                (*at, "lead"), f"{what}: a screw joint requires a lead", remedy="add for example lead: 5 mm"
            )
        if joint.type in FUNCTIONS:
            _functions(joint, at, report)
        _friction(joint, at, report)
        if joint.type in ("spherical", "free", "shaft") and abs(joint.start.get("beta", 0.0)) > MAX_TILT:
            report.problem(
                (*at, "start", "beta"),
                "is close to a right angle or above, where alpha and spin cannot be distinguished",
                value=f"{math.degrees(joint.start['beta']):.6g} deg",
                limit=f"<= {math.degrees(MAX_TILT):.6g} deg",
                remedy="rotate the joint and its bodies by `axes` instead",
            )
        for key in ("start", "speed"):
            for word in getattr(joint, key):
                if word not in joint.names:
                    listed = ", ".join(joint.names) or "none"
                    report.problem(
                        (*at, key, word),
                        f"is not a coordinate of a joint of type {joint.type}",
                        remedy=f"its coordinates are {listed}",
                    )


def _friction(joint: Joint, at: Place, report: Reader) -> None:
    """Check that the friction of a joint has the keys of its type."""
    part = joint.friction
    if part is None or (*at, "friction") in report.tainted:
        return
    if joint.type not in RUBBING:
        report.problem(
            (*at, "friction"),
            f"has no meaning for a joint of type {joint.type}, which has no sliding surfaces",
            remedy=f"remove it; joints with friction are {', '.join(RUBBING)}",
        )
        return
    needs, allows, surface = RUBBING[joint.type]
    if "radius" in needs and part.radius is None:
        report.problem(
            (*at, "friction", "radius"), f"is missing: the radius of {surface}", remedy="add radius: 10 mm"
        )
    for key, given in (
        ("radius", part.radius is not None),
        ("shoulder_radius", part.shoulder_radius > 0.0),
        ("length", part.length is not None),
    ):
        if given and key not in (*needs, *allows):
            report.problem(
                (*at, "friction", key), f"has no effect on a joint of type {joint.type}", remedy="remove it"
            )


RUBBING: dict[str, tuple[tuple[str, ...], tuple[str, ...], str]] = {
    "revolute": (("radius",), ("shoulder_radius", "length"), "the pin"),
    "prismatic": ((), ("length",), ""),
    "cylindrical": (("radius",), ("length",), "the pin"),
    "screw": (("radius",), ("length",), "the thread"),
    "universal": (("radius",), ("shoulder_radius", "length"), "the pins of the cross"),
    "spherical": (("radius",), (), "the ball"),
    "planar": ((), ("radius", "length"), ""),
}
"""Joints with friction: required keys, further keys, name of the surface with the radius."""


def _functions(joint: Joint, at: Place, report: Reader) -> None:
    """Check the functions and coordinates of joints of type `moved` and `user`."""
    if not joint.motion and (*at, "motion") not in report.tainted:
        report.problem(
            (*at, "motion"), "is missing", remedy="add for example motion: {x: 2 mm * sin(t / 1 s)}"
        )
    if joint.type == "moved":
        if joint.coordinates:
            report.problem(
                (*at, "coordinates"),
                "are for joints of type user only",
                remedy="write type: user, or remove them",
            )
        return
    if not joint.coordinates and (*at, "coordinates") not in report.tainted:
        report.problem((*at, "coordinates"), "is missing", remedy="add for example coordinates: {s: length}")
    used = {v for laws in joint.motion.values() for law in laws for v in _variables(law)}
    for word in joint.coordinates:
        if word not in used and ("joints",) not in report.tainted:
            report.problem(
                (*at, "coordinates", word),
                "has no effect: no function of motion uses it",
                remedy="use or remove it",
            )


def _variables(law: Any) -> tuple[str, ...]:
    return (law.over,) if hasattr(law, "over") else tuple(getattr(law, "variables", ()))
