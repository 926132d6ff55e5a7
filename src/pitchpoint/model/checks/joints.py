# SPDX-License-Identifier: Apache-2.0
"""Checks of markers, joints, rods, ratios and shapes of mass one by one, before anything is placed."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from pitchpoint.model.components.joint import FUNCTIONS
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.model.components.joint import Joint
    from pitchpoint.model.parts import Parts

MOST_TILT = math.radians(85.0)
"""Largest beta of a start, well before alpha and spin turn about one axis [rad]."""


def check_joints(parts: Parts, report: Reader) -> None:
    """Every joint has the keys that its type needs."""
    for name, joint in parts.joints.items():
        at: Place = ("joints", name)
        if at in report.tainted:
            continue
        if joint.type == "screw" and not joint.lead:
            what = "is missing" if joint.lead is None else "is zero"
            report.problem(
                (*at, "lead"), f"{what}: a screw moves along its axis", remedy="add lead: 5 mm, per turn"
            )
        if joint.type in FUNCTIONS:
            _functions(joint, at, report)
        _friction(joint, at, report)
        if joint.type in ("spherical", "free", "shaft") and abs(joint.start.get("beta", 0.0)) > MOST_TILT:
            report.problem(
                (*at, "start", "beta"),
                "is a right angle or more, where alpha and spin cannot be distinguished",
                value=f"{math.degrees(joint.start['beta']):.6g} deg",
                limit=f"<= {math.degrees(MOST_TILT):.6g} deg",
                remedy="turn the joint and its bodies by their axes instead",
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
    """Friction of joints with one direction; a pin has a radius, a slide has none."""
    part = joint.friction
    if part is None:
        return
    if joint.type not in ("revolute", "prismatic"):
        report.problem(
            (*at, "friction"),
            f"is not for a joint of type {joint.type}",
            remedy="split it into revolute and prismatic joints, or leave friction out",
        )
    elif joint.type == "revolute" and part.radius is None and (*at, "friction") not in report.tainted:
        report.problem((*at, "friction", "radius"), "is missing: that of the pin", remedy="add radius: 10 mm")
    elif joint.type == "prismatic" and (part.radius is not None or part.shoulder_radius):
        key = "radius" if part.radius is not None else "shoulder_radius"
        report.problem((*at, "friction", key), "is that of a pin, and a slide has none", remedy="remove it")


def _functions(joint: Joint, at: Place, report: Reader) -> None:
    """A joint made of functions has some, and each of its coordinates moves something."""
    if not joint.motion and (*at, "motion") not in report.tainted:
        report.problem(
            (*at, "motion"), "is missing", remedy="add for example motion: {x: 2 mm * sin(t / 1 s)}"
        )
    if joint.type == "moved":
        if joint.coordinates:
            report.problem(
                (*at, "coordinates"),
                "belong to a joint of type user",
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
                "moves nothing: no function of motion uses it",
                remedy="use or remove it",
            )


def _variables(law: Any) -> tuple[str, ...]:
    return (law.over,) if hasattr(law, "over") else tuple(getattr(law, "variables", ()))
