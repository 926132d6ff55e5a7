# SPDX-License-Identifier: Apache-2.0
"""Checks of bearings and couplings: on the axis of their body, coaxial and at the same position."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.model.checks.beam_ends import is_beam
from pitchpoint.model.checks.forces import TURNING
from pitchpoint.model.components.bearing import Bearing
from pitchpoint.model.frames import GROUND, Array, bodies_of, body_frame, place_of, split
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.rings import following, ring_bodies, rings_of
from pitchpoint.model.shafts import SEATED

if TYPE_CHECKING:
    from pitchpoint.model.components.body import Body
    from pitchpoint.model.components.coupling import Coupling
    from pitchpoint.model.parts import Parts
    from pitchpoint.model.rings import Ringed

HOUSED = 1e-3
"""Maximum distance of a bearing from its housing marker [m]; a smaller distance is a rigid arm."""
TILTED = math.radians(5.0)
"""Maximum angle between the axes of two rings [rad]."""
INCLINED = math.radians(45.0)
"""Maximum angle between the axes of bodies on a torsional coupling [rad], as of constant-velocity joints."""
ON_PINS = ("revolute", "planar", "shaft")
"""Joints of planets on their pins."""
COAXIAL = 1e-6
"""Distance of two axes [m] up to which they coincide: round-off of positions computed from meshes."""


def check_positions(parts: Parts, report: Reader) -> None:
    """Check that bearings and couplings are on the axis of their body: they do not rotate with it."""
    for group in (*SEATED, "couplings"):
        for name, part in getattr(parts, group).items():
            x, y, z = part.position
            if x == 0.0 and y == 0.0:
                continue
            body = part.bodies[0] if group == "couplings" else part.body or "the bearing"
            shown = ", ".join(f"{v * 1e3:.6g}" for v in part.position)
            report.problem(
                (group, name, "position"),
                f"is off the axis of {body}",
                value=f"[{shown}] mm",
                limit="x = y = 0",
                remedy=f"write [0, 0, {z * 1e3:.6g} mm]; the axis is given by the position of {body}",
                taint=False,
            )


def check_housings(parts: Parts, report: Reader) -> None:
    """Check the position of bearings in housings, and that the spin is free."""
    for group in SEATED:
        for name, part in getattr(parts, group).items():
            at: Place = (group, name)
            if part.housing is None or part.housing == GROUND or at in report.tainted or part.body is None:
                continue
            _housing(parts, at, part, report)


def _housing(parts: Parts, at: Place, part: Bearing | Ringed, report: Reader) -> None:
    """Check one bearing in a housing."""
    body, marker = split(str(part.housing))
    if body == part.body:
        report.problem(
            (*at, "housing"),
            f"is the body that runs in the bearing {at[1]}, {body}",
            remedy="name another body, or remove housing for ground",
        )
        return
    if isinstance(part, Bearing) and part.stiffness.matrix6()[5][5] != 0.0:
        report.problem(
            (*at, "stiffness"),
            f"constrains the spin of {part.body} relative to the housing {body}",
            limit="torsion: 0",
            remedy="use a coupling instead, or remove torsion",
        )
    if part.body not in parts.bodies or not (body in parts.bodies or is_beam(parts, body)):
        return
    owner, there = parts.bodies[str(part.body)], place_of(parts, str(part.housing))
    if owner.origin is None or there is None:
        return
    center = np.array(owner.origin) + body_frame(parts, str(part.body))[1] @ [0.0, 0.0, part.position[2]]
    limit = HOUSED * max(1.0, float(np.abs(center).max()))
    if not marker:
        _off_the_pin(parts, at, part, center, limit, report)
        return
    if isinstance(part, Bearing) and part.stage is not None:
        return  # `check_pins` of the stage
    apart = float(np.linalg.norm(center - there))
    if apart > limit:
        report.problem(
            (*at, "housing"),
            f"is {apart * 1e3:.6g} mm away from the bearing",
            value=part.housing,
            limit=f"{limit * 1e3:.4g} mm",
            remedy=_closer(parts, str(part.body), str(part.housing), there - center, owner),
        )


def _closer(parts: Parts, body: str, end: str, way: Array, owner: Body) -> str:
    """What to correct if a bearing and the point at which it is mounted are apart."""
    axis = body_frame(parts, body)[1][:, 2]
    kind, link, _ = parts.placed.get(body, ("", "", ""))
    along = float(way @ axis)
    if kind == "mesh" and abs(along) < 0.5 * float(np.linalg.norm(way)):
        mesh = parts.meshes[link]
        if mesh.direction is None:
            return (
                f"give meshes.{link}.direction, the angle from the x axis to the line of centres; "
                f"omitted, it is 0 deg and places {body} off the axis of {split(end)[0]}"
            )
        return f"correct meshes.{link}.direction or center_distance, which place {body}, or the marker {end}"
    place = ", ".join(f"{1e3 * x:.6g} mm" for x in np.array(owner.origin) + way)
    return f"correct the marker {end}, the position of the bearing, or that of {body}: [{place}] would fit"


def _off_the_pin(
    parts: Parts, at: Place, part: Bearing | Ringed, center: Array, limit: float, report: Reader
) -> None:
    """Check that a bearing between two bodies is on the axis of the joint by which one carries the other."""
    one, two = str(part.body), split(str(part.housing))[0]
    held = _held_by_joint(parts, (one, two))
    if held is None:
        return
    origin, axes = body_frame(parts, held)
    apart = 0.0 if origin is None else float(np.linalg.norm(np.cross(axes[:, 2], center - origin)))
    if apart > limit:
        carrier = two if held == one else one
        report.problem(
            (*at, "body"),
            f"names {one}, whose axis is {apart * 1e3:.6g} mm away from that of {held} on its pin",
            limit=f"{limit * 1e3:.4g} mm",
            remedy=f"write body: {held}, housing: {carrier}"
            if isinstance(part, Bearing)
            else f"write ends: {_pinned(held, carrier, held == two)} instead of body and housing; the "
            "position is then along the pin",
        )


def _pinned(held: str, carrier: str, outer: bool) -> str:
    """Ends of a bearing of a body on its carrier, which contains the outer ring if `outer`."""
    return f"[{carrier}, {held}]" if outer else f"[{held}, {carrier}]"


def _held_by_joint(parts: Parts, bodies: tuple[str, str]) -> str | None:
    """Body with gears that the other one carries by a joint about its axis, a planet; None without one."""
    for held, carrier in (bodies, bodies[::-1]):
        seat = parts.mechanism.seats.get(held)
        joint = None if seat is None or seat.parent != carrier else seat.joint
        if joint is not None and parts.joints[joint].type in ON_PINS and parts.bodies[held].gears:
            return held
    return None


def check_couplings(parts: Parts, report: Reader) -> None:
    """Check the angle between the axes of coupled bodies, and that couplings with lateral stiffness are
    coaxial: otherwise their forces would not be conservative."""
    for name, coupling in parts.couplings.items():
        bodies = [parts.bodies.get(b) for b in coupling.bodies]
        if None in bodies or any(("bodies", b, "axes") in report.tainted for b in coupling.bodies):
            continue
        sideways = any(b.moves not in ("torsion", "fixed") for b in bodies if b is not None)
        if not (sideways and _holds_sideways(coupling)):
            _inclined(parts, name, coupling.bodies, report)
            continue
        if _tilted(parts, "couplings", name, coupling.bodies, report):
            continue
        places = [b.origin for b in bodies if b is not None and b.origin is not None]
        if len(places) < 2:
            continue
        z = body_frame(parts, coupling.bodies[0])[1][:, 2]
        apart = float(np.linalg.norm(np.cross(z, np.subtract(places[1], places[0]))))
        if apart > COAXIAL:
            first, second = coupling.bodies
            report.problem(
                ("couplings", name, "bodies"),
                f"have axes {apart * 1e3:.6g} mm apart, and the coupling constrains more than their rotation",
                value=f"{first} and {second}",
                limit=f"{COAXIAL * 1e3:g} mm",
                remedy=f"put {first} and {second} on one axis, or give the coupling torsion only",
            )


def _inclined(parts: Parts, name: str, bodies: tuple[str, str], report: Reader) -> None:
    """Report a torsional coupling of axes at an angle that no constant-velocity joint transmits."""
    frames = [body_frame(parts, b)[1] for b in bodies]
    z, other = (f[:, 2] for f in frames)
    angle = math.atan2(float(np.linalg.norm(np.cross(z, other))), float(z @ other))
    if angle <= INCLINED:
        return
    fixed = [b for b in bodies if parts.bodies[b].motion == "fixed"]
    one, two = bodies
    if fixed:
        moved = one if fixed[0] == two else two
        remedy = (
            f"give {fixed[0]} the z axis of {moved}, or use an element of torsion_springs with {moved} only"
        )
    elif math.pi - angle <= INCLINED:
        remedy = f"reverse the z axis of {one} or {two}: coupled bodies have z axes in the same direction"
    else:
        remedy = f"give {one} and {two} the same z axis, or connect them by bevel gears or a ratio"
    report.problem(
        ("couplings", name, "bodies"),
        f"have z axes {math.degrees(angle):.6g} deg apart",
        value=f"{one} and {two}",
        limit=f"{math.degrees(INCLINED):.3g} deg",
        remedy=remedy,
    )


def check_turning(parts: Parts, report: Reader) -> None:
    """Check that torsional elements connect parallel axes: otherwise the angle depends on the path."""
    for group in TURNING:
        for name, part in getattr(parts, group).items():
            bodies = bodies_of(part.bodies)
            if len(bodies) == 2 and all(b in parts.bodies for b in bodies):
                _tilted(parts, group, name, bodies, report)


def _tilted(parts: Parts, group: str, name: str, bodies: tuple[str, ...], report: Reader) -> bool:
    """Whether two bodies have different z axes initially; reports the problem."""
    z, other = (body_frame(parts, b)[1][:, 2] for b in bodies)
    cosine = float(z @ other)
    if cosine < 1.0 - COAXIAL**2:
        report.problem(
            (group, name, "bodies"),
            f"have axes {math.degrees(math.acos(max(-1.0, cosine))):.6g} deg apart",
            value=" and ".join(bodies),
            remedy="give both bodies the same z axis, or connect them by a universal joint",
        )
        return True
    return False


def check_rings(parts: Parts, report: Reader) -> None:
    """Check that the rings of rolling and plain bearings have the same position and axis."""
    for group in ("rolling_bearings", "plain_bearings"):
        for name, bearing in getattr(parts, group).items():
            named = {(group, name), *(("bodies", body) for body in ring_bodies(bearing))}
            if bearing.ends is None or named & report.tainted:
                continue
            if any(bearing.position) and following(parts, bearing) is None:
                report.problem(
                    (group, name, "position"),
                    f"does not apply to rings on {bearing.ends[0]} and {bearing.ends[1]}",
                    remedy="remove it, and give the positions of the rings by markers",
                )
                continue
            inner, outer = rings_of(parts, bearing)
            if inner.place is None or outer.place is None:
                continue
            if _apart(parts, (group, name, "ends"), bearing.ends, (inner.place, outer.place), report):
                continue
            z, other = inner.axes[:, 2], outer.axes[:, 2]
            angle = math.atan2(float(np.linalg.norm(np.cross(z, other))), abs(float(z @ other)))
            if angle > TILTED:
                report.problem(
                    (group, name, "ends"),
                    f"have z axes {math.degrees(angle):.6g} deg apart",
                    value=" and ".join(bearing.ends),
                    limit=f"{math.degrees(TILTED):.3g} deg",
                    remedy=f"give the marker {bearing.ends[1]} axes with z along that of {bearing.ends[0]}",
                )


def _apart(
    parts: Parts, at: Place, ends: tuple[str, str], places: tuple[Array, Array], report: Reader
) -> bool:
    """Whether the rings of a bearing have different initial positions; reports the problem."""
    distance = float(np.linalg.norm(places[0] - places[1]))
    limit = HOUSED * max(1.0, *(float(np.abs(p).max()) for p in places))
    if distance <= limit:
        return False
    report.problem(
        at,
        f"are {distance * 1e3:.6g} mm apart in the initial position",
        value=" and ".join(ends),
        limit=f"{limit * 1e3:.4g} mm",
        remedy=_placed(parts, ends, places, limit),
    )
    return True


def _placed(parts: Parts, ends: tuple[str, str], places: tuple[Array, Array], limit: float) -> str:
    """Remedy for rings that are apart: on a planet and its pin, or on a shaft in a housing without marker."""
    correct = "correct the positions of the bodies or markers"
    bodies = (split(ends[0])[0], split(ends[1])[0])
    held = _held_by_joint(parts, bodies)
    if held is not None:
        k = bodies.index(held)
        origin, axes = body_frame(parts, held)
        along = 0.0 if origin is None else float(axes[:, 2] @ (places[1 - k] - origin))
        return (
            f"{correct}, or write ends: {_pinned(held, bodies[1 - k], k == 1)}, "
            f"position: [0, 0, {along * 1e3:.6g} mm]: the position is on the pin, from {held}"
        )
    if split(ends[1])[1] or GROUND in ends:
        return correct
    origin, axes = body_frame(parts, bodies[0])
    if origin is None or float(np.linalg.norm(np.cross(axes[:, 2], places[0] - origin))) > limit:
        return correct
    z = float(axes[:, 2] @ (places[0] - origin))
    return (
        f"{correct}, or write body: {bodies[0]}, position: [0, 0, {z * 1e3:.6g} mm], housing: {ends[1]} "
        "instead of ends"
    )


def _holds_sideways(coupling: Coupling) -> bool:
    """Whether a coupling has stiffness or damping other than about its axis."""
    matrices = [coupling.stiffness.matrix6()]
    if coupling.damping is not None:
        matrices.append(coupling.damping.matrix6())  # a ratio damps the directions of the stiffness
    return any(m[i][j] != 0.0 for m in matrices for i in range(6) for j in range(6) if (i, j) != (5, 5))
