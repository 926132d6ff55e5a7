# SPDX-License-Identifier: Apache-2.0
"""Fixed ratios in a scene: friction wheels, belt drives, rack and pinion.

A ratio is an equation between coordinates; it is drawn as the simplest mechanism that satisfies it at the
positions of the bodies: wheels and racks with equal speeds at the contact.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pitchpoint.model.components.ratio import Arm
from pitchpoint.model.frames import GROUND
from pitchpoint.model.mechanism import coordinate, seat_frame
from pitchpoint.report.scene import shapes
from pitchpoint.report.scene.schematics import stand_in
from pitchpoint.viz.scene.content import SceneSolid

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.report.scene.places import Places

Array = NDArray[np.float64]

COLUMNS = {"x": 0, "y": 1, "z": 2, "alpha": 0, "beta": 1, "spin": 2}
"""Axis of a joint for each of its coordinates."""
WIDTH = 0.025
"""Width of wheels and racks, relative to the size of the machine."""
PULLEY = 0.4
"""Radius of the larger of two pulleys without given radii, relative to their distance."""
RACK = 6.0
"""Length of a rack relative to the radius of its pinion."""
PARALLEL = 1e-6


class _Term(NamedTuple):
    """Coordinate in a ratio: its body, position and axis of its motion, and its factor."""

    body: str
    parent: str
    place: Array
    axis: Array
    turns: bool
    factor: float


def ratio_parts(model: Model, at: Places) -> tuple[list[SceneSolid], list[str]]:
    """Symbols of the ratios of a model, and remarks on omitted ones.

    Parameters
    ----------
    model
        The model.
    at
        Where things sit in the scene.
    """
    found: list[SceneSolid] = []
    notes: list[str] = []
    for name, ratio in model.ratios.items():
        terms = [_term(model, word, factor) for word, factor in ratio.terms.items()]
        known = [term for term in terms if term is not None]
        # a body that carries another one does not touch it
        carrying = {term.parent for term in known}
        pair = [term for term in known if term.body not in carrying]
        solids = _pair(at, f"ratio {name}", *pair) if len(known) == len(terms) and len(pair) == 2 else []
        found += solids
        if not solids:
            notes.append(f"ratio {name} is not drawn: not representable by two wheels or a wheel and a rack")
    return found, notes


def _term(model: Model, word: str, factor: float) -> _Term | None:
    """Coordinate of a term of a ratio; None for coordinates defined by functions."""
    named = coordinate(model.mechanism, model, word)
    if isinstance(named, str):
        return None
    body, number, dimension = named
    seat = model.mechanism.seats[body]
    column = COLUMNS.get(seat.coordinates[number])
    if column is None or seat.kind == "user":
        return None
    place, axes = seat_frame(model, seat)
    return _Term(body, seat.parent, place, axes[:, column], dimension == "angle", factor)


def _pair(at: Places, name: str, one: _Term, other: _Term) -> list[SceneSolid]:
    """Solids for two coupled coordinates; empty if no simple mechanism exists."""
    if one.turns and other.turns:
        return _wheels(at, name, one, other)
    if one.turns != other.turns:
        pinion, rack = (one, other) if one.turns else (other, one)
        return _rack(at, name, pinion, rack)
    return []


def _wheel(at: Places, name: str, term: _Term, place: Array, radius: float) -> SceneSolid:
    width = WIDTH * at.size
    ring = shapes.disc(radius, width, max(radius - 1.5 * width, 0.7 * radius), 64)
    spoke = shapes.box((1.8 * radius, 0.5 * width, 0.5 * width))
    whole = shapes.joined([ring, spoke, shapes.disc(0.15 * radius, width)])
    surface = shapes.moved(whole, place, shapes.across(term.axis))
    return stand_in(at, f"{name}, {term.body}", "body", term.body, surface, place)


def _wheels(at: Places, name: str, one: _Term, other: _Term) -> list[SceneSolid]:
    """Friction wheels for opposite rotation, pulleys with a belt for equal rotation."""
    sense = float(one.axis @ other.axis)
    way = other.place - one.place
    way -= one.axis * (way @ one.axis)
    far = float(np.linalg.norm(way))
    if abs(sense) < 1.0 - PARALLEL or far < PARALLEL * at.size:
        return []
    places = (one.place, one.place + way)
    sizes = abs(one.factor), abs(other.factor)
    if one.factor * other.factor * sense > 0.0:
        radii = [far * size / sum(sizes) for size in sizes]
        return [_wheel(at, name, t, p, r) for t, p, r in zip((one, other), places, radii, strict=True)]
    given = isinstance(one.factor, Arm) and sum(sizes) < far
    scale = 1.0 if given else PULLEY * far / max(sizes)
    radii = [scale * size for size in sizes]
    solids = [_wheel(at, name, t, p, r) for t, p, r in zip((one, other), places, radii, strict=True)]
    parent = one.parent if one.parent == other.parent else GROUND
    return [
        *solids,
        stand_in(at, f"{name}, belt", "body", parent, _belt(at, one.axis, places, radii), places[0]),
    ]


def _belt(at: Places, axis: Array, places: tuple[Array, Array], radii: list[float]) -> shapes.Surface:
    """Both strands of an open belt around two circles."""
    way = places[1] - places[0]
    far = float(np.linalg.norm(way))
    along, thick = way / far, 0.25 * WIDTH * at.size
    lean = (radii[0] - radii[1]) / far
    strands = []
    for side in (1.0, -1.0):
        normal = lean * along + side * np.sqrt(1.0 - lean**2) * np.cross(axis, along)
        start, end = (p + (r + thick) * normal for p, r in zip(places, radii, strict=True))
        strands.append(shapes.rod(start, end, thick, 8))
    return shapes.joined(strands)


def _rack(at: Places, name: str, pinion: _Term, rack: _Term) -> list[SceneSolid]:
    """Wheel and rack with the speed of the rim at the contact."""
    if abs(pinion.axis @ rack.axis) > PARALLEL:
        return []
    slope = -pinion.factor / rack.factor
    radius = abs(slope)
    # the rim has the direction axis x normal there, which must be that of the rack
    normal = np.sign(slope) * np.cross(rack.axis, pinion.axis)
    thick = WIDTH * at.size
    middle = pinion.place + (radius + 0.5 * thick) * normal
    frame = np.column_stack([rack.axis, normal, np.cross(rack.axis, normal)])
    bar = shapes.box((RACK * radius, thick, thick), middle, frame)
    return [
        _wheel(at, name, pinion, pinion.place, radius),
        stand_in(at, f"{name}, {rack.body}", "body", rack.body, bar, middle),
    ]
