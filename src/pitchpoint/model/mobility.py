# SPDX-License-Identifier: Apache-2.0
"""Mass matrix of a mechanism where the file places it: every free direction needs inertia."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import GeometryError
from pitchpoint.model.components.joint import COORDINATES, DISPLACEMENTS
from pitchpoint.model.frames import GROUND, Array, body_frame, split
from pitchpoint.model.inertia import body_inertia
from pitchpoint.model.mechanism import Seat, seat_frame
from pitchpoint.model.read import Reader

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts

NOTHING = 1e-20
"""Share of mass times size squared that is round-off: places are off by 1e-16 of their size at most."""
SINGULAR = 1e-11
"""Least eigenvalue of the scaled mass matrix; its entries are sums of a few products."""

Column = tuple[Array, Array, Array]
"""Translation, axis of turn and a point of that axis: how one coordinate moves what hangs on it."""


def columns(parts: Parts, seat: Seat) -> list[tuple[str, Column]]:
    """Columns of the coordinates of one body, by name; none for joints made of functions."""
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


def mass_matrix(parts: Parts) -> tuple[list[str], Array, float]:
    """Mass matrix where all coordinates are zero.

    Returns
    -------
    names, M, least
        Names of the coordinates, their mass matrix, and what counts as nothing in it.
    """
    names: list[str] = []
    paths: dict[str, list[tuple[int, Column]]] = {GROUND: []}
    rows = []
    scale = 0.0
    for name, seat in parts.mechanism.seats.items():
        own = columns(parts, seat)
        if parts.bodies[name].elastic is not None:
            paths[name] = []  # its mass is in its file: what hangs on it counts as if it stood
            continue
        paths[name] = paths[seat.parent] + [(len(names) + k, c) for k, (_, c) in enumerate(own)]
        names += [n for n, _ in own]
        inertia = body_inertia(parts.bodies[name], parts.gears, parts.bevel_gears)
        origin, axes = body_frame(parts, name)
        center = (np.zeros(3) if origin is None else origin) + axes @ np.array(inertia.place)
        rows.append((paths[name], inertia.mass, center, axes @ inertia.about_center() @ axes.T))
        scale += inertia.mass * max(1.0, float(center @ center))
    M = np.zeros((len(names), len(names)))
    for path, mass, center, about in rows:
        moved = [(k, shift + np.cross(turn, center - at), turn) for k, (shift, turn, at) in path]
        for i, v, w in moved:
            for j, u, o in moved:
                M[i, j] += mass * (v @ u) + w @ about @ o
    return names, M, NOTHING * scale


def check_inertia(parts: Parts, report: Reader) -> None:
    """Report coordinates, or motions of several of them, that no inertia resists."""
    if not parts.joints and all(b.is_round for b in parts.bodies.values()):
        return
    try:
        names, M, least = mass_matrix(parts)
    except GeometryError:
        return  # a gear that cannot be, reported where its shape is checked
    diagonal = M.diagonal()
    for name, value in zip(names, diagonal, strict=True):
        if not value > least:
            _report(parts, name, report)
    if not names or not np.all(diagonal > least):
        return
    size = np.sqrt(diagonal)
    values, vectors = np.linalg.eigh(M / np.outer(size, size))
    if values[0] > SINGULAR:
        return
    shares = np.abs(vectors[:, 0])
    involved = [n for n, s in zip(names, shares, strict=True) if s > 0.1 * shares.max()]
    report.problem(
        _place(parts, involved[0]),
        f"has no inertia when {' and '.join(involved)} move together in some way",
        remedy="give mass or inertia to a body between them, or take one of these coordinates out",
    )


def _place(parts: Parts, coordinate: str) -> tuple[str, str]:
    name = coordinate.rsplit(".", 1)[0]
    return ("joints", name) if name in parts.joints else ("bodies", name)


def _report(parts: Parts, coordinate: str, report: Reader) -> None:
    name, word = coordinate.rsplit(".", 1)
    seat = parts.mechanism.carrier(name) or parts.mechanism.seats[name]
    turn = DISPLACEMENTS.get(word) == "angle" and seat.kind != "screw"
    remedy = f"give {seat.body} {'inertia_tensor' if turn else 'mass'}"
    others = [n for n in parts.mechanism.cut if seat.body in {split(e)[0] for e in parts.joints[n].bodies}]
    if others and seat.joint is not None:
        remedy += f", or write cut: true at {seat.joint}, so that {others[0]} carries {seat.body}"
    report.problem(
        _place(parts, coordinate),
        f"moves nothing that has {'inertia' if turn else 'mass'} by its {word}",
        limit="> 0",
        remedy=remedy,
    )
