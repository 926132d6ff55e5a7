# SPDX-License-Identifier: Apache-2.0
"""Beams as stations (bodies with six coordinates) and the beam elements between them.

The stations are children of the body at the first end: a beam on a rotating hub starts with the correct
speed, and its coordinates are deflections relative to that body.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.beams.record import RECORD, beam_row
from pitchpoint.model.frames import axes_of, beam_frame, beam_length, carrying_end
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.joints import FLOATING
from pitchpoint.system.rules.bank import Bank
from pitchpoint.system.rules.beam_pieces import beam_pieces
from pitchpoint.system.rules.bodies import beam_numbers, end_of

if TYPE_CHECKING:
    from pitchpoint.model.components.beam import Beam as BeamPart
    from pitchpoint.model.model import Model
    from pitchpoint.system.rules.places import Places

Array = NDArray[np.float64]

BARE = 1e-9
"""Mass and inertia of a station relative to those of a beam element; a body must not be massless."""


def beam_stations(model: Model) -> dict[int, Body]:
    """Stations of all beams by their number in the records."""
    found, first = {}, beam_numbers(model)
    for name, part in model.beams.items():
        (root, axes), length = _line(model, part)
        pieces = beam_pieces(model, name, length)
        parent = end_of(model, carrying_end(model, part.ends[0]))[0]
        for k, (number, share) in enumerate(part.stations.items()):
            mass = BARE * pieces[k].mass
            found[first[name] + k] = Body(
                name=f"{name}.{number}",
                motion=FLOATING,
                parent=parent,
                position=tuple(root + axes[:, 2] * share * length),
                axes=axes,
                mass=mass,
                inertia=mass * pieces[k].beam.length ** 2 * np.eye(3),
            )
    return found


def beam_bank(places: Places) -> Bank:
    """Elements of all beams."""
    model = places.model
    rows, names = [np.zeros(0, RECORD)], []
    for name, part in model.beams.items():
        _, length = _line(model, part)
        nodes = beam_nodes(places, name)
        for k, (one, two, piece) in enumerate(
            zip(nodes[:-1], nodes[1:], beam_pieces(model, name, length), strict=True), start=1
        ):
            for end, beam, off in piece.parts:
                rows.append(
                    beam_row(
                        beam,
                        bodies=(one[0], two[0]),
                        nodes=(one[1] + one[2] @ off[0], two[1] + two[2] @ off[1]),
                        axes=(one[2] @ piece.axes, two[2] @ piece.axes),
                        eta=part.internal_damping,
                        gravity=model.gravity or (0.0, 0.0, 0.0),
                    )
                )
                names.append((name if part.pieces == 1 else f"{name}.{k}") + end)
    return Bank("beam", np.concatenate(rows), tuple(names))


def beam_nodes(places: Places, name: str) -> list[tuple[int, Array, Array]]:
    """Nodes of a beam from its first end: body, position and section axes in the frame of that body."""
    model = places.model
    part, first = model.beams[name], beam_numbers(model)[name]
    axes = beam_frame(model, part)[1]
    inner = [(first + k, np.zeros(3), np.eye(3)) for k in range(part.pieces - 1)]
    return [_clamped(model, places, part.ends[0], axes), *inner, _clamped(model, places, part.ends[1], axes)]


def _line(model: Model, part: BeamPart) -> tuple[tuple[Array, Array], float]:
    """First end in world axes with all coordinates zero [m], section axes as columns, and length [m]."""
    (root, axes), length = beam_frame(model, part), beam_length(model, part)
    assert root is not None and length is not None  # all bodies of a model have a position
    return (root, axes), length


def _clamped(model: Model, places: Places, end: str, axes: Array) -> tuple[int, Array, Array]:
    """Number of the body at an end; node and section axes in the frame of that body."""
    number, node, own = places.end(end)
    return number, node, own @ axes_of(model, end).T @ axes
