# SPDX-License-Identifier: Apache-2.0
"""Checks of bearings and couplings: on the axis of their body, coaxial and at the same position."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.model.checks.beam_ends import is_beam
from pitchpoint.model.checks.forces import TURNING
from pitchpoint.model.components.bearing import Bearing
from pitchpoint.model.frames import GROUND, Array, body_frame, place_of, split
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.rings import ring_bodies, rings_of
from pitchpoint.model.shafts import SEATED

if TYPE_CHECKING:
    from pitchpoint.model.components.coupling import Coupling
    from pitchpoint.model.parts import Parts
    from pitchpoint.model.rings import Ringed

HOUSED = 1e-3
"""Maximum distance of a bearing from its housing marker [m]; a smaller distance is a rigid arm."""
TILTED = math.radians(5.0)
"""Maximum angle between the axes of two rings [rad]."""
COAXIAL = 1e-6
"""Distance of two axes [m] up to which they coincide: round-off of positions computed from meshes."""


def check_positions(parts: Parts, report: Reader) -> None:
    """Check that bearings and couplings are on the axis of their body: they do not rotate with it."""
    for group in (*SEATED, "couplings"):
        for name, part in getattr(parts, group).items():
            x, y, z = part.position
            if x == 0.0 and y == 0.0:
                continue
            body = part.bodies[0] if group == "couplings" else part.body
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
            f"is the body that runs in the bearing, {body}",
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
    if owner.origin is None or there is None or not marker:
        return
    center = np.array(owner.origin) + body_frame(parts, str(part.body))[1] @ [0.0, 0.0, part.position[2]]
    apart = float(np.linalg.norm(center - there))
    limit = HOUSED * max(1.0, float(np.abs(center).max()))
    if apart > limit:
        report.problem(
            (*at, "housing"),
            f"is {apart * 1e3:.6g} mm away from the bearing",
            value=part.housing,
            limit=f"{limit * 1e3:.4g} mm",
            remedy=f"correct the position of {marker}, of the bearing or of {part.body}",
        )


def check_couplings(parts: Parts, report: Reader) -> None:
    """Check that couplings with lateral stiffness are coaxial: otherwise their forces would not be
    conservative."""
    for name, coupling in parts.couplings.items():
        bodies = [parts.bodies.get(b) for b in coupling.bodies]
        if None in bodies or all(b.moves in ("torsion", "fixed") for b in bodies if b is not None):
            continue
        places = [b.origin for b in bodies if b is not None and b.origin is not None]
        if len(places) < 2 or not _holds_sideways(coupling):
            continue
        if _tilted(parts, "couplings", name, coupling.bodies, report):
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


def check_turning(parts: Parts, report: Reader) -> None:
    """Check that torsional elements connect parallel axes: otherwise the angle depends on the path."""
    for group in TURNING:
        for name, part in getattr(parts, group).items():
            if len(part.bodies) == 2 and all(b in parts.bodies for b in part.bodies):
                _tilted(parts, group, name, part.bodies, report)


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
            inner, outer = rings_of(parts, bearing)
            if inner.place is None or outer.place is None:
                continue
            if _apart((group, name, "ends"), bearing.ends, (inner.place, outer.place), report):
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


def _apart(at: Place, ends: tuple[str, str], places: tuple[Array, Array], report: Reader) -> bool:
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
        remedy="correct the positions of the bodies or markers" + _placed(ends),
    )
    return True


def _placed(ends: tuple[str, str]) -> str:
    """Remedy for rings on origins of bodies, which need not be on the axis of the bearing."""
    if split(ends[1])[1] or GROUND in ends:
        return ""
    body = split(ends[0])[0]
    return f", or write body: {body}, position: [0, 0, z], housing: {ends[1]} instead of ends"


def _holds_sideways(coupling: Coupling) -> bool:
    """Whether a coupling has stiffness or damping other than about its axis."""
    matrices = [coupling.stiffness.matrix6()]
    if coupling.damping is not None:
        matrices.append(coupling.damping.matrix6())  # a ratio damps the directions of the stiffness
    return any(m[i][j] != 0.0 for m in matrices for i in range(6) for j in range(6) if (i, j) != (5, 5))
