# SPDX-License-Identifier: Apache-2.0
"""Axis directions of gears: bodies in mesh have parallel z axes of any direction in the world.

Angles of a mesh refer to the x axis of the body of gear 1, angles of a tooth to that of its own body.
"""

from __future__ import annotations

import math
from collections import deque
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.model.frames import Array, Machine, body_frame
from pitchpoint.model.keys import Place
from pitchpoint.model.planet_places import axis_bodies
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.model.components.mesh import Mesh
    from pitchpoint.model.parts import Parts

PARALLEL = 1e-6
"""Angle [rad] up to which two axes are parallel: directions are given with about seven digits."""


def orient(parts: Parts) -> None:
    """Determine the axes of every body: as given, or those of the bodies that its gears mesh with, or those
    of a body that it is coupled with."""
    for name, body in parts.bodies.items():
        parts.bodies[name] = replace(body, orientation=body.axes)
    mates: dict[str, list[str]] = {}
    for mesh in parts.meshes.values():
        one, two = ends_of(parts, mesh)
        if one is not None and two is not None:
            mates.setdefault(one, []).append(two)
            mates.setdefault(two, []).append(one)
    for stage in parts.planetary_stages.values():
        for central in axis_bodies(parts, stage):
            for planet in stage.names:
                if {central, planet} <= parts.bodies.keys():
                    mates.setdefault(central, []).append(planet)
                    mates.setdefault(planet, []).append(central)
    queue = deque(n for n, b in parts.bodies.items() if b.axes is not None)
    while queue:
        here = queue.popleft()
        for there in mates.get(here, ()):
            if parts.bodies[there].orientation is None:
                parts.bodies[there] = replace(parts.bodies[there], orientation=parts.bodies[here].orientation)
                queue.append(there)
        if not queue:  # gears require parallel axes, couplings do not
            queue.extend(_orient_coupled(parts))


def _orient_coupled(parts: Parts) -> list[str]:
    """Give one body without axes those of the body that it is coupled with; list it, if there is one.

    Fixed bodies keep the axes of the world, to which their markers refer.
    """
    for coupling in parts.couplings.values():
        for here, there in (coupling.bodies, coupling.bodies[::-1]):
            if not {here, there} <= parts.bodies.keys() or parts.bodies[there].motion == "fixed":
                continue
            axes = parts.bodies[here].orientation
            if axes is not None and parts.bodies[there].orientation is None:
                parts.bodies[there] = replace(parts.bodies[there], orientation=axes)
                return [there]
    return []


def ends_of(parts: Parts, mesh: Mesh) -> tuple[str | None, str | None]:
    """Bodies of gear 1 and gear 2; None for a gear without body."""
    one, two = (parts.body_of(g) for g in mesh.gears)
    return one, two


def mesh_frame(machine: Machine, body: str | None) -> Array:
    """Reference frame of a mesh, columns: the axes of the body of gear 1, or of the world."""
    return np.eye(3) if body is None else body_frame(machine, body)[1]


def settle_twists(parts: Parts, report: Reader) -> None:
    """Check that the axes of meshing gears are parallel, and compute the angle between the x axes."""
    for name, mesh in parts.meshes.items():
        one, two = ends_of(parts, mesh)
        if one is None or two is None or one == two:
            parts.meshes[name] = replace(mesh, twist=0.0)
            continue
        frames = [mesh_frame(parts, body) for body in (one, two)]
        if any(("bodies", body, "axes") in report.tainted for body in (one, two)):
            continue
        z, other = (f[:, 2] for f in frames)
        angle = math.atan2(float(np.linalg.norm(np.cross(z, other))), float(z @ other))
        if angle > PARALLEL:
            _skew(name, mesh.gears, (one, two), angle, report)
            continue
        x = frames[0].T @ frames[1][:, 0]
        parts.meshes[name] = replace(mesh, twist=math.atan2(x[1], x[0]))


def _skew(name: str, gears: tuple[str, str], bodies: tuple[str, str], angle: float, report: Reader) -> None:
    at: Place = ("meshes", name, "gears")
    one, two = bodies
    if math.pi - angle <= PARALLEL:
        report.problem(
            at,
            f"have opposite z axes, those of {one} and {two}",
            value=" and ".join(gears),
            remedy=f"reverse the z axis of {one} or {two}: gears in mesh require the same direction",
        )
        return
    report.problem(
        at,
        f"have axes {math.degrees(angle):.6g} deg apart, the z axes of {one} and {two}",
        value=" and ".join(gears),
        limit=f"parallel to {PARALLEL:g} rad",
        remedy=f"give {one} and {two} parallel axes; use bevel gears, ratios or universal joints for others",
    )
