# SPDX-License-Identifier: Apache-2.0
"""Inertia of a mechanism in its initial position: every free coordinate requires inertia.

Instead of the full mass matrix, whose size is quadratic in the number of bodies, articulated-body inertias
are computed from the leaves of the tree to its roots: a body adds to its parent its inertia less the part
released by its joint (R. Featherstone, Rigid Body Dynamics Algorithms, 2008, ch. 7). The mass matrix is
singular if the articulated-body inertia projected on the coordinates of a joint is singular."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import GeometryError
from pitchpoint.model.components.joint import COORDINATES, DISPLACEMENTS
from pitchpoint.model.frames import GROUND, Array, body_frame, split
from pitchpoint.model.inertia import body_inertia
from pitchpoint.model.mechanism import Seat, seat_frame
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts

NOTHING = 1e-20
"""Fraction of mass times size squared that is round-off: positions have a relative error of 1e-16."""
SINGULAR = 1e-11
"""Minimum eigenvalue of the projected inertia of a joint, relative to that with all outboard joints
locked."""
ROUND_OFF = 1e-3
"""Fraction of mass times distance squared added to the reference inertia: sums over bodies lose 1e-14 of
it."""

Column = tuple[Array, Array, Array]
"""Motion by one coordinate: translation, axis of rotation and a point on the axis."""


@dataclass
class Link:
    """A body of the tree with the coordinates of its joint, in world axes."""

    parent: int
    """Index of the parent body, -1 for ground."""
    names: list[str]
    own: list[Column]
    mass: float
    center: Array
    """Centre of mass, reference point of inertia and motion of the body [m]."""
    about: Array
    """Inertia tensor about the centre of mass [kg m^2]."""
    felt: Array = field(default_factory=lambda: np.zeros((6, 6)))
    """Articulated-body inertia of the body, rotations first."""
    locked: Array = field(default_factory=lambda: np.zeros((6, 6)))
    """Inertia of the body with all outboard joints locked."""

    def __post_init__(self) -> None:
        for whole in (self.felt, self.locked):
            whole[:3, :3] = self.about
            whole[3:, 3:] = self.mass * np.eye(3)

    @property
    def moves(self) -> Array:
        """Motion of the centre of mass by each coordinate, columns (6, n): rotation, then translation."""
        moved = [np.append(turn, shift + _cross(turn, self.center - at)) for shift, turn, at in self.own]
        return np.array(moved).reshape(-1, 6).T


def _cross(a: Array, b: Array) -> Array:
    """Cross product of two vectors; faster than NumPy for single vectors."""
    return np.array((a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]))


def columns(parts: Parts, seat: Seat) -> list[tuple[str, Column]]:
    """Columns of the coordinates of a body, by name; empty for joints defined by functions."""
    if seat.kind == "user":
        return []
    place, axes = seat_frame(parts, seat)
    joint = parts.joints[seat.joint] if seat.joint is not None else None
    words = COORDINATES[seat.kind]
    nothing = np.zeros(3)
    found = []
    for word, own in zip(words, seat.coordinates, strict=True):
        m = list(DISPLACEMENTS).index(word)
        shift, turn = (axes[:, m], nothing) if m < 3 else (nothing, axes[:, m - 3])
        if seat.kind == "screw" and joint is not None:
            shift = (joint.lead or 0.0) / math.tau * axes[:, 2]
        found.append((f"{seat.joint or seat.body}.{own}", (shift, turn, place)))
    return found


def tree_of(parts: Parts) -> list[Link]:
    """Bodies of the tree, parents first; elastic bodies are treated as ground, their mass is in their
    files."""
    links: list[Link] = []
    numbers = {GROUND: -1}
    for name, seat in parts.mechanism.seats.items():
        if parts.bodies[name].elastic is not None:
            numbers[name] = -1
            continue
        own = columns(parts, seat)
        inertia = body_inertia(parts.bodies[name], parts.gears, parts.bevel_gears)
        origin, axes = body_frame(parts, name)
        center = (np.zeros(3) if origin is None else origin) + axes @ np.array(inertia.place)
        about = axes @ inertia.about_center() @ axes.T
        names = [n for n, _ in own]
        numbers[name] = len(links)
        links.append(Link(numbers[seat.parent], names, [c for _, c in own], inertia.mass, center, about))
    return links


def alone(links: list[Link]) -> list[tuple[str, float]]:
    """Inertia moved by every coordinate with all others fixed [kg or kg m^2], by name."""
    children: dict[int, list[int]] = {}
    for k, link in enumerate(links):
        children.setdefault(link.parent, []).append(k)
    order: list[int] = []  # depth first: the descendants of a body follow it contiguously
    ends: dict[int, int] = {}
    stack = [(k, False) for k in reversed(children.get(-1, []))]
    while stack:
        k, done = stack.pop()
        if done:
            ends[k] = len(order)
            continue
        order.append(k)
        stack += [(k, True), *((c, False) for c in reversed(children.get(k, [])))]
    starts = {k: place for place, k in enumerate(order)}
    mass = np.array([links[k].mass for k in order])
    center = np.array([links[k].center for k in order]).reshape(-1, 3)
    about = np.array([links[k].about for k in order]).reshape(-1, 3, 3)
    found = []
    for k, link in enumerate(links):
        part = slice(starts[k], ends[k])
        for name, (shift, turn, at) in zip(link.names, link.own, strict=True):
            v = shift + np.cross(turn, center[part] - at)
            found.append((name, float(mass[part] @ (v * v).sum(axis=1) + (about[part] @ turn @ turn).sum())))
    return found


def yielding(links: list[Link]) -> list[tuple[str, float]]:
    """Coordinates of a combined motion without inertia, with their rates; empty if there is none."""
    pivots: dict[int, tuple[Array, Any]] = {}
    for k in reversed(range(len(links))):
        link = links[k]
        S = link.moves
        D = S.T @ link.felt @ S
        size = np.sqrt((S * (link.locked @ S)).sum(axis=0))
        values, vectors = np.linalg.eigh(D / np.outer(size, size)) if size.size else (np.ones(1), D)
        if not values[0] > SINGULAR:
            return _motion(links, pivots, k, vectors[:, 0] / size)
        F = link.felt @ S
        pivots[k] = (F, np.linalg.inv(D))
        if link.parent < 0:
            continue
        parent = links[link.parent]
        X = _shifted(link.center - parent.center)
        parent.felt += X.T @ (link.felt - F @ pivots[k][1] @ F.T) @ X
        parent.locked += X.T @ link.felt @ X
        reach = float((link.center - parent.center) @ (link.center - parent.center))
        parent.locked[:3, :3] += ROUND_OFF * link.mass * reach * np.eye(3)
    return []


def _shifted(apart: Array) -> Array:
    """Transformation of the motion of a body to another reference point at the offset `apart` [m], (6, 6)."""
    X = np.eye(6)
    X[3:, :3] = [
        [0.0, apart[2], -apart[1]],
        [-apart[2], 0.0, apart[0]],
        [apart[1], -apart[0], 0.0],
    ]
    return X


def _motion(
    links: list[Link], pivots: dict[int, tuple[Array, Any]], root: int, x: Array
) -> list[tuple[str, float]]:
    """Rates of all outboard coordinates of a joint moving at `x` for which the inertia vanishes."""
    motion = {root: links[root].moves @ x}
    found = list(zip(links[root].names, x.tolist(), strict=True))
    for k in range(root + 1, len(links)):
        link = links[k]
        if link.parent not in motion:
            continue
        before = _shifted(link.center - links[link.parent].center) @ motion[link.parent]
        F, inverse = pivots[k]
        y = -inverse @ F.T @ before
        motion[k] = before + link.moves @ y
        found += zip(link.names, y.tolist(), strict=True)
    return found


def check_inertia(parts: Parts, report: Reader) -> None:
    """Report coordinates, or combined motions of several coordinates, without inertia."""
    if not parts.joints and all(b.is_round for b in parts.bodies.values()):
        return
    try:
        links = tree_of(parts)
    except GeometryError:
        return  # invalid gear geometry is reported elsewhere
    inertia = dict(diagonal := alone(links))
    least = NOTHING * sum(k.mass * max(1.0, float(k.center @ k.center)) for k in links)
    for name, value in diagonal:
        if not value > least:
            _report(parts, name, report)
    if not all(value > least for _, value in diagonal) or _spins_without_inertia(parts):
        return
    shares = {name: abs(rate) * math.sqrt(inertia[name]) for name, rate in yielding(links)}
    involved = [n for n, s in shares.items() if s > 0.1 * max(shares.values())]
    if not involved:
        return
    report.problem(
        _place(parts, involved[0]),
        f"has no inertia in a combined motion of {' and '.join(involved)}",
        remedy="give mass or inertia to a body between them, or remove one of these coordinates",
    )


def _spins_without_inertia(parts: Parts) -> bool:
    """Whether a body without a joint has no polar inertia of its own, which `checks.masses` reports."""
    bodies = [parts.bodies[name] for name, seat in parts.mechanism.seats.items() if seat.joint is None]
    return any(
        body.moves in ("torsion", "planar", "free")
        and body.is_round
        and body.elastic is None
        and not body_inertia(body, parts.gears, parts.bevel_gears).polar > 0.0
        for body in bodies
    )


def _place(parts: Parts, coordinate: str) -> tuple[str, str]:
    name = coordinate.rsplit(".", 1)[0]
    return ("joints", name) if name in parts.joints else ("bodies", name)


def _report(parts: Parts, coordinate: str, report: Reader) -> None:
    name, word = coordinate.rsplit(".", 1)
    seat = parts.mechanism.carrier(name) or parts.mechanism.seats[name]
    turn = DISPLACEMENTS.get(word) == "angle" and seat.kind != "screw"
    body = parts.bodies[seat.body]
    if body.stage in parts.planetary_stages:
        key = "planet_inertia" if turn else "planet_mass"
        what = f"is zero, but the planets {'rotate' if turn else 'move'} on their pins"
        report.problem(("planetary_stages", body.stage, key), what, limit="> 0", remedy=f"give {key}")
        return
    remedy = f"give {seat.body} {'inertia_tensor' if turn else 'mass'}"
    others = [n for n in parts.mechanism.cut if seat.body in {split(e)[0] for e in parts.joints[n].bodies}]
    if others and seat.joint is not None:
        remedy += f", or write cut: true at {seat.joint}, so that {others[0]} carries {seat.body}"
    report.problem(
        _place(parts, coordinate),
        f"moves no {'inertia' if turn else 'mass'} by its coordinate {word}",
        limit="> 0",
        remedy=remedy,
    )
