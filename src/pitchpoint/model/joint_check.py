# SPDX-License-Identifier: Apache-2.0
"""Checks of markers, joints, rods, ratios and shapes of mass one by one, before anything is placed."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from pitchpoint.model.components.joint import FUNCTIONS
from pitchpoint.model.frames import GROUND, split
from pitchpoint.model.keys import Place, keys_of
from pitchpoint.model.read import Reader

if TYPE_CHECKING:
    from pitchpoint.model.components.body import Body
    from pitchpoint.model.components.joint import Joint
    from pitchpoint.model.components.marker import Axes
    from pitchpoint.model.parts import Parts

MOST_TILT = math.radians(85.0)
"""Largest beta of a start, well before alpha and spin turn about one axis [rad]."""
SQUARE = 1e-6
"""Cosine of the angle up to which two directions count as perpendicular."""


def check_places(parts: Parts, report: Reader) -> None:
    """Whatever names a place on a body names a body and a marker that exist."""
    if GROUND in parts.known("bodies"):
        report.problem(
            ("bodies", GROUND), "is the name of what does not move", remedy="call the body something else"
        )
    for group, name, key, given in ends_of(parts):
        many = not isinstance(given, str)
        for i, end in enumerate(given if many else (given,)):
            at: Place = (group, name, key, i) if many else (group, name, key)
            _known_end(parts, end, at, report)
        if many and len(given) == 2 and len({split(e)[0] for e in given}) == 1:
            body = parts.bodies.get(split(given[0])[0])
            if group == "sensors" and body is not None and (body.shaft or body.elastic):
                continue  # how it bends and twists
            report.problem(
                (group, name, key),
                f"lie on one body, {split(given[0])[0]}",
                value=" and ".join(given),
                remedy="name places on two bodies",
            )


def ends_of(parts: Any) -> Iterator[tuple[str, str, str, Any]]:
    """Every place on a body that a component names: section, name, key and value."""
    from pitchpoint.model.model import GROUPS

    for group in GROUPS:
        for name, part in getattr(parts, group).items():
            for key, description in keys_of(type(part)).items():
                given = getattr(part, key)
                if description.kind in ("end", "ends") and given is not None:
                    yield group, name, key, given


def _known_end(parts: Parts, end: str, at: Place, report: Reader) -> None:
    from pitchpoint.model.validate import known, nearest

    body, marker = split(end)
    if body == GROUND:
        if marker:
            report.problem(
                at,
                f"names a marker of ground, {end}",
                remedy="give the place as position, or put the marker on a body with motion: fixed",
            )
        return
    if not known(parts, "bodies", body, at, report) or not marker or body not in parts.bodies:
        return
    markers = parts.bodies[body].markers
    if marker not in markers and ("bodies", body, "markers") not in report.tainted:
        have = f"there are {', '.join(markers)}" if markers else f"{body} has no markers"
        report.problem(
            at,
            f"names the marker {marker[:40]!r}, which {body} does not have",
            remedy=nearest(marker, markers) + have,
        )


def check_directions(parts: Parts, report: Reader) -> None:
    """Axes are directions, and x stands at right angles to z."""
    for name, body in parts.bodies.items():
        check_axes(body.axes, ("bodies", name, "axes"), report)
        for word, marker in body.markers.items():
            check_axes(marker.axes, ("bodies", name, "markers", word, "axes"), report)
    for name, joint in parts.joints.items():
        check_axes(joint.axes, ("joints", name, "axes"), report)


def check_axes(axes: Axes | None, at: Place, report: Reader) -> None:
    """Directions that are some, and stand at right angles to each other."""
    if axes is None:
        return
    for key in ("z", "x"):
        given = getattr(axes, key)
        if given is not None and not any(given):
            report.problem(
                (*at, key), "is no direction: all its numbers are zero", remedy="write [1, 0, 0], say"
            )
            return
    if axes.x is None:
        return
    cosine = math.fsum(a * b for a, b in zip(axes.z, axes.x, strict=True))
    cosine /= math.hypot(*axes.z) * math.hypot(*axes.x)
    if abs(cosine) > SQUARE:
        report.problem(
            (*at, "x"),
            "is not at right angles to z",
            value=f"{math.degrees(math.acos(max(-1.0, min(1.0, cosine)))):.6g} deg",
            limit="90 deg",
            remedy="correct one of them, or leave x out",
        )


def check_masses(parts: Parts, report: Reader) -> None:
    """One way to say where the mass lies, and one that some mass can have."""
    for name, body in parts.bodies.items():
        at: Place = ("bodies", name)
        if at in report.tainted:
            continue
        others = [k for k in ("inertia", "transverse_inertia") if getattr(body, k) is not None]
        if body.inertia_tensor is not None:
            if others:
                report.problem(
                    (*at, "inertia_tensor"),
                    f"stands beside {' and '.join(others)}",
                    remedy="give the tensor alone",
                )
            _tensor(body, (*at, "inertia_tensor"), report)
        elif body.solid is not None and not body.is_round and others:
            report.problem(
                (*at, others[0]),
                "stands beside a solid that is not round about the z axis of the body",
                remedy=f"remove {' and '.join(others)}, or turn the solid by its axes and origin",
            )
        elif not body.is_round and others:
            report.problem(
                (*at, "center_of_mass"),
                f"lies off the axis, and {' and '.join(others)} would not say how the mass lies about it",
                remedy="give inertia_tensor about the centre of mass instead",
            )


def _tensor(body: Body, at: Place, report: Reader) -> None:
    import numpy as np

    from pitchpoint.model.inertia import matrix

    if body.inertia_tensor is None or at in report.tainted:
        return
    least, middle, most = (float(v) for v in np.linalg.eigvalsh(matrix(body.inertia_tensor)))
    # moments from drawings are rounded to a few digits
    if least < -1e-6 * most or least + middle < most * (1.0 - 1e-4):
        report.problem(
            at,
            "is that of no mass",
            value=f"principal moments {least:.6g}, {middle:.6g}, {most:.6g} kg m^2",
            limit="none negative, none above the sum of the other two",
            remedy="check the order Ixx, Iyy, Izz, Ixy, Iyz, Izx, the units and the signs of the products",
        )


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
                "is a right angle or more, where alpha and spin cannot be told apart",
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
                        f"is no coordinate of a joint of type {joint.type}",
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
        report.problem((*at, "motion"), "is missing", remedy="add motion: {x: 2 mm * sin(t / 1 s)}, say")
    if joint.type == "moved":
        if joint.coordinates:
            report.problem(
                (*at, "coordinates"),
                "belong to a joint of type user",
                remedy="write type: user, or remove them",
            )
        return
    if not joint.coordinates and (*at, "coordinates") not in report.tainted:
        report.problem((*at, "coordinates"), "is missing", remedy="add coordinates: {s: length}, say")
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
