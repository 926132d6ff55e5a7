# SPDX-License-Identifier: Apache-2.0
"""Derived geometry of a model: pairs of gears, positions of bodies.

Works on the parts of a model that could be read; missing or broken parts are skipped, because their problems
have been reported already.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from pitchpoint.model.checks.gear_pairs import check_gear, check_pair
from pitchpoint.model.frames import Array, body_frame
from pitchpoint.model.gear_axes import ends_of, mesh_frame, orient, settle_twists
from pitchpoint.model.housing import place_nodes
from pitchpoint.model.lines_of_centres import by_couplings, line_up
from pitchpoint.model.mechanism import hang, place_joined
from pitchpoint.model.parts import Parts
from pitchpoint.model.planet_places import orient_pins, place_planets, settle_angles
from pitchpoint.model.profile_shifts import determine_shifts, usable
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.scissor_gears import place_free_halves


def resolve(parts: Parts, report: Reader) -> None:
    """Compute the derived fields of all parts in place; problems are added to `report`."""
    _check_hands(parts, report)
    determine_shifts(parts, report)
    _pairs(parts, report)
    settle_angles(parts, report)
    orient(parts)
    orient_pins(parts)
    settle_twists(parts, report)
    _places(parts, report)
    _widths(parts, report)


def _check_hands(parts: Parts, report: Reader) -> None:
    for name, gear in parts.gears.items():
        if gear.helix_angle > 0.0 and gear.hand is None:
            report.problem(
                ("gears", name, "hand"),
                "is missing: a helical gear is left or right handed",
                remedy="add hand: left or hand: right",
            )


# --- pairs -------------------------------------------------------------------------------------------------
def _pairs(parts: Parts, report: Reader) -> None:
    for name in parts.gears:
        known = parts.gears[name].x is not None and name not in parts.misshapen
        if known and ("gears", name) not in report.tainted:
            check_gear(parts, name, report)
    for name, mesh in list(parts.meshes.items()):
        if usable(parts, mesh, report):
            check_pair(parts, name, mesh, report)


LINKS = ("meshes", "couplings", "bodies", "gears", "joints")
"""Sections of components that locate bodies."""


# --- positions of bodies ------------------------------------------------------------------------------------
def _places(parts: Parts, report: Reader) -> None:
    """Locate bodies: given positions first, then along joints, meshes and couplings, breadth first."""
    links = _links(parts, report)
    for name, body in parts.bodies.items():
        parts.bodies[name] = replace(body, origin=body.position)
    parts.mechanism = hang(parts)
    _spread_all(parts, links)
    # one gear train needs no position: its first body is at the origin
    carried = parts.mechanism.carried
    first = next((n for n, b in parts.bodies.items() if b.origin is None and n not in carried), None)
    if first is not None:
        parts.bodies[first] = replace(parts.bodies[first], origin=(0.0, 0.0, 0.0))
        _spread_all(parts, links)
    line_up(parts, report)
    if not all_linked_known(parts, report):
        return
    for name, body in parts.bodies.items():
        if body.of_housing and ("housing",) in report.tainted:
            continue
        if body.origin is None and name not in carried:
            report.problem(
                ("bodies", name),
                "has no position: no mesh or coupling connects it to the bodies before it",
                remedy="give position: [x, y, z]",
            )


def _spread_all(parts: Parts, links: dict[str, list[tuple[str, str]]]) -> None:
    """Locate all bodies that follow from bodies of known position, by joints, meshes and couplings in
    turn; meshes with a direction are first, those without one are at 0 deg."""
    for given in (True, False):
        before = -1
        while len(placed := [n for n, b in parts.bodies.items() if b.origin is not None]) > before:
            before = len(placed)
            place_planets(parts)
            place_free_halves(parts)
            place_nodes(parts)
            place_joined(parts)
            _spread(parts, links, [n for n, b in parts.bodies.items() if b.origin is not None], given)


def _spread(parts: Parts, links: dict[str, list[tuple[str, str]]], placed: list[str], given: bool) -> None:
    """Locate all bodies linked to bodies of known position by couplings and meshes.

    `given`: only by meshes with a direction.
    """
    queue = deque(placed)
    while queue:
        here = queue.popleft()
        for kind, link in links.get(here, ()):
            if given and (kind != "mesh" or parts.meshes[link].direction is None):
                continue
            there = _place_next(parts, here, kind, link)
            if there is not None:
                queue.append(there)


def all_linked_known(parts: Parts, report: Reader) -> bool:
    """Whether all links are readable and valid, so that a missing position is not a consequential error."""
    return all_links_read(parts) and not any((g,) in report.tainted for g in LINKS)


def all_links_read(parts: Parts) -> bool:
    """Whether all components that locate bodies could be read."""
    return not parts.misshapen and all(set(getattr(parts, g)) == parts.known(g) for g in LINKS)


def _links(parts: Parts, report: Reader) -> dict[str, list[tuple[str, str]]]:
    links: dict[str, list[tuple[str, str]]] = {}

    def add(kind: str, link: str, ends: Iterable[str | None]) -> None:
        """Register a link at both of its bodies."""
        for end in ends:
            if end is not None:
                links.setdefault(end, []).append((kind, link))

    for name, mesh in parts.meshes.items():
        if mesh.a_w is not None and mesh.stage is None and ("meshes", name, "gears") not in report.tainted:
            add("mesh", name, [parts.body_of(g) for g in mesh.gears])
    for name, coupling in parts.couplings.items():
        add("coupling", name, coupling.bodies)
    return links


def _place_next(parts: Parts, here: str, kind: str, link: str) -> str | None:
    """Locate the body at the other end of a link and return its name; None if it is located already."""
    origin = parts.bodies[here].origin
    if origin is None:
        return None
    if kind == "coupling":
        coupling = parts.couplings[link]
        first, second = coupling.bodies
        there = second if first == here else first
        step = coupling.position[2] if first == here else -coupling.position[2]
        way = step * body_frame(parts, first)[1][:, 2]
        place = (origin[0] + float(way[0]), origin[1] + float(way[1]), origin[2] + float(way[2]))
    else:
        mesh = parts.meshes[link]
        bodies = [parts.body_of(g) for g in mesh.gears]
        if None in bodies or bodies[0] == bodies[1] or mesh.a_w is None:
            return None
        forward = bodies[0] == here
        there = str(bodies[1] if forward else bodies[0])
        step = abs(mesh.a_w) if forward else -abs(mesh.a_w)
        angle = mesh.direction or 0.0
        near, far = mesh.gears if forward else mesh.gears[::-1]
        rise = parts.bodies[here].gears[near] - parts.bodies[there].gears[far]
        way = mesh_frame(parts, bodies[0]) @ np.array((step * math.cos(angle), step * math.sin(angle), rise))
        place = (origin[0] + float(way[0]), origin[1] + float(way[1]), origin[2] + float(way[2]))
    if there not in parts.bodies or parts.bodies[there].origin is not None:
        return None
    parts.bodies[there] = replace(parts.bodies[there], origin=place)
    parts.placed[there] = (kind, link, here)
    return there


def _widths(parts: Parts, report: Reader) -> None:
    """Compute the common face width of every mesh and the axial position of its middle on both gears."""
    for name, mesh in parts.meshes.items():
        if not all(g in parts.gears for g in mesh.gears) or ("meshes", name, "gears") in report.tainted:
            continue
        axis = mesh_frame(parts, ends_of(parts, mesh)[0])[:, 2]
        middle = [_middle(parts, g, axis) for g in mesh.gears]
        if middle[0] is None or middle[1] is None:
            middle = [0.0, 0.0]
        half = [0.5 * parts.gears[g].face_width for g in mesh.gears]
        low = max(m - h for m, h in zip(middle, half, strict=True))  # type: ignore[operator]
        high = min(m + h for m, h in zip(middle, half, strict=True))  # type: ignore[operator]
        if high <= low:
            bodies = {parts.body_of(g) for g in mesh.gears}
            if bodies & parts.placed.keys() and not all_links_read(parts):
                continue  # the link that locates them may be one of those that cannot be read
            report.problem(
                ("meshes", name, "gears"),
                f"do not overlap axially; the gap between their faces is {1e3 * (low - high):.6g} mm",
                value=" and ".join(mesh.gears),
                remedy="correct the axial offsets of the gears or the positions of the bodies"
                + by_couplings(parts, mesh),
            )
            continue
        at = 0.5 * (low + high)
        if name in parts.pairs and high - low < 0.999999 * 2.0 * min(half):
            # the pair has the common face width
            pair = parts.pairs[name]
            parts.pairs[name] = replace(pair, gear1=pair.gear1.replace(b=high - low))
        parts.meshes[name] = replace(
            mesh, b_w=high - low, offset1=at - (middle[0] or 0.0), offset2=at - (middle[1] or 0.0)
        )


def _middle(parts: Parts, gear: str, axis: Array) -> float | None:
    """Position of the mid-face of a gear along an axis through the origin of the world [m]."""
    body = parts.body_of(gear)
    if body is None:
        return None
    origin = body_frame(parts, body)[0]
    return None if origin is None else float(axis @ origin) + parts.bodies[body].gears[gear]
