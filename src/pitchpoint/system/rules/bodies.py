# SPDX-License-Identifier: Apache-2.0
"""Bodies of a model as bodies of the multibody layer, and positions in their frames.

The frame of a body on a joint has its origin at the joint and the axes of the joint. All model data given in
body axes are transformed here.
"""

from __future__ import annotations

import math
import weakref
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.model.frames import (
    GROUND,
    axes_of,
    beam_frame,
    beam_length,
    beam_of,
    body_frame,
    joint_place,
    place_of,
    split,
)
from pitchpoint.model.mechanism import ONE_WAY, Seat, axial_offset, seat_frame, spinner_of
from pitchpoint.model.shafts import nearest_station
from pitchpoint.multibody import joints
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.unbalance import with_point_mass
from pitchpoint.system.rules.elastic_body import elastic_count, elastic_of, node_at
from pitchpoint.system.rules.flexible_rim import rim_count, rim_parts
from pitchpoint.system.rules.shaft import shaft_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from pitchpoint.model.components.joint import Joint
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

#: Codes of the joint types.
CODES = {
    "fixed": joints.FIXED,
    "planar": joints.PLANAR,
    "revolute": joints.TORSION,
    "prismatic": joints.PRISMATIC,
    "cylindrical": joints.CYLINDRICAL,
    "screw": joints.SCREW,
    "universal": joints.UNIVERSAL,
    "spherical": joints.SPHERICAL,
    "shaft": joints.FREE,
    "free": joints.FLOATING,
    "moved": joints.GUIDED,
    "user": joints.GUIDED,
}
UNITS = {"length": "m", "angle": "rad"}
ROUND = 1e-12
"""Relative tolerance of moments of inertia and centre of mass below which a body is round."""


def bodies(model: Model) -> dict[int, Body]:
    """All bodies by their number in the records, parents first, shafts as stations."""
    number = body_numbers(model)
    found: dict[int, Body] = {}
    for n, seat in model.mechanism.seats.items():
        if n in model.elastic_bodies:
            found |= dict(enumerate(elastic_of(model, n, number[n]).bodies, start=number[n]))
        elif n in model.shafts:
            found |= dict(enumerate(shaft_of(model, n, number[n]).bodies, start=number[n]))
        else:
            found[number[n]] = _body(model, seat, _parent(model, seat))
            rims = [b for rim in rim_parts(model, n, number[n]) for b in rim.bodies]
            found |= dict(enumerate(rims, start=number[n] + 1))
    for part in model.unbalances.values():
        if part.body in model.shafts:
            k, z = seat_at(model, part.body, part.position[2])
            found[k] = with_point_mass(found[k], part.mass, np.array([*part.position[:2], z]))
            continue
        k = number[part.body]
        body, place = found[k], point_on(model, part.body, part.position)
        if model.bodies[part.body].moves in ("torsion", "planar") and body.inertia is None:
            # the body does not tilt: the transverse inertia has no effect but must be physical
            body = replace(body, transverse_inertia=max(body.transverse_inertia, body.polar_inertia))
        found[k] = with_point_mass(body, part.mass, place)
    return found


def body_numbers(model: Model) -> dict[str, int]:
    """Number of each body in the records; ground is 0, a shaft has the number of its first station."""
    return _numbers(model)[0]


def beam_numbers(model: Model) -> dict[str, int]:
    """Number of the first station of each beam."""
    return _numbers(model)[1]


def _numbers(model: Model) -> tuple[dict[str, int], dict[str, int]]:
    """Numbers of bodies and of beams; the stations of a beam precede the bodies on them, others are last."""
    known, found = _LAST.get("model", (None, ({}, {})))
    if known is None or known() is not model:  # cached, as rules call this once per component
        found, k = ({GROUND: 0}, {}), 1
        seats = model.mechanism.seats
        order = [(seats[name].beam, name) for name in seats] + [(beam, None) for beam in model.beams]
        for beam, name in order:
            if beam is not None and beam not in found[1]:
                found[1][beam] = k
                k += len(model.beams[beam].stations)
            if name is not None:
                found[0][name] = k
                k += count_of(model, name)
        if not model.elastic_bodies:  # their number of bodies depends on files, which may change
            _LAST["model"] = weakref.ref(model), found
    return found


_LAST: dict[str, tuple[weakref.ref[Model], tuple[dict[str, int], dict[str, int]]]] = {}
"""Numbers of bodies and beams of the last model."""


def count_of(model: Model, body: str) -> int:
    """Number of records of a body: stations of a shaft; frame, modes and nodes of an elastic body; rims."""
    if body in model.elastic_bodies:
        return elastic_count(model, body)
    return len(model.stations.get(body, (0.0,))) + rim_count(model, body)


def _parent(model: Model, seat: Seat) -> int:
    """Number of the parent body: of the node or station that the joint names, or of that at the joint."""
    if seat.joint is None:
        return body_numbers(model)[seat.parent]
    marked = bool(split(seat.end)[1])
    place = place_of(model, seat.end) if marked else joint_place(model, model.joints[seat.joint])
    return frame_at(model, seat.base, place)[0]


def _spinner(model: Model, seat: Seat) -> int:
    """Number of the body whose spin a fixed body takes over; for a shaft that of the station."""
    name = spinner_of(model, model.mechanism, seat.body)
    if name is None:
        return 0
    while seat.parent != name:
        seat = model.mechanism.seats[seat.parent]
    return _parent(model, seat) if name in model.shafts else body_numbers(model)[name]


def _body(model: Model, seat: Seat, parent: int) -> Body:
    inertia = model.body_inertia(seat.body)
    place, axes = seat_frame(model, seat)
    origin, own = body_frame(model, seat.body)
    turn = axes.T @ own
    com = turn @ np.array(inertia.place) + axes.T @ ((place if origin is None else origin) - place)
    about = turn @ inertia.about_center() @ turn.T
    joint = model.joints[seat.joint] if seat.joint is not None else None
    start, rate = _start(joint, seat)
    body = Body(
        name=seat.body,
        motion=CODES[seat.kind],
        parent=parent,
        position=tuple(float(x) for x in place),
        axes=axes,
        mass=inertia.mass,
        lead=(joint.lead or 0.0) / math.tau if joint is not None and seat.kind == "screw" else 0.0,
        guided_by=tuple((n, UNITS[d]) for n, d in joint.coordinates.items()) if joint is not None else (),
        start=start,
        rate=rate,
        spinner=_spinner(model, seat),
    )
    if not _is_round(com, about):
        return replace(body, com=com, inertia=about)
    if joint is None:  # bit-identical to the model
        i_p, i_t, c = inertia.polar, inertia.central, inertia.center
    else:
        i_p, i_t, c = float(about[2, 2]), 0.5 * float(about[0, 0] + about[1, 1]), float(com[2])
    return replace(body, polar_inertia=i_p, transverse_inertia=i_t, center=c)


def _is_round(com: Array, about: Array) -> bool:
    """Whether mass and inertia are axisymmetric about the z axis."""
    size = float(np.abs(about).max(initial=0.0))
    beside = max(abs(about[0, 0] - about[1, 1]), abs(about[0, 1]), abs(about[1, 2]), abs(about[2, 0]))
    on_axis = np.abs(com[:2]).max() <= ROUND * np.abs(com).max()
    return bool(on_axis) and beside <= ROUND * size


def _start(joint: Joint | None, seat: Seat) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Start values of the joint coordinates of a body and of their rates, in the order of `AXES`."""
    if joint is None or not (joint.start or joint.speed) or (seat.turned and seat.kind in ONE_WAY):
        return (), ()
    return (
        tuple(joint.start.get(c, 0.0) for c in seat.coordinates),
        tuple(joint.speed.get(c, 0.0) for c in seat.coordinates),
    )


# --- positions on bodies ------------------------------------------------------------------------------------
def end_of(model: Model, end: str) -> tuple[int, Array, Array]:
    """Body, point and axes of an end given as ground, BODY, BODY.MARKER or BEAM.STATION.

    Parameters
    ----------
    model
        The model.
    end
        Name of the end.

    Returns
    -------
    number, point, axes
        Number of the body; point from its origin [m] and axes (columns), both in its body-fixed frame S.
    """
    body = split(end)[0]
    place, turned = place_of(model, end), axes_of(model, end)
    if body == GROUND or place is None:
        return 0, np.zeros(3) if place is None else place, turned
    number, at, axes = frame_at(model, body, place)
    return number, axes.T @ (place - at), axes.T @ turned


def frame_at(model: Model, body: str, place: Array | None) -> tuple[int, Array, Array]:
    """Number, origin [m] and axes of the frame of a body; for shafts and beams of the station nearest to
    `place`.

    Parameters
    ----------
    model
        The model.
    body
        Name of the body or beam, or ground.
    place
        Position in world axes with all coordinates zero [m]; None: first station of a shaft.
    """
    if body == GROUND:
        return 0, np.zeros(3), np.eye(3)
    beam = beam_of(model, body)
    if beam is not None:
        root, axes = beam_frame(model, beam)
        length = beam_length(model, beam)
        assert root is not None and length is not None and place is not None
        shares = [*beam.stations.values()]
        k = nearest_station(shares, float(axes[:, 2] @ (place - root)) / length)
        return beam_numbers(model)[body] + k, root + axes[:, 2] * shares[k] * length, axes
    number = body_numbers(model)[body]
    at, axes = seat_frame(model, model.mechanism.seats[body])
    if body in model.elastic_bodies and place is not None:
        here, node = node_at(model, body, place)
        return number + here, node, axes
    if body in model.shafts and place is not None:
        places = model.stations[body]
        k = nearest_station(places, float(axes[:, 2] @ (place - at)))
        return number + k, at + axes[:, 2] * places[k], axes
    return number, at, axes


def point_on(model: Model, body: str, position: Sequence[float]) -> Array:
    """Point of a body relative to the origin of its joint frame, in the axes S of that frame [m].

    Parameters
    ----------
    model
        The model.
    body
        Name of the body.
    position
        Position from the body origin in body axes [m].
    """
    place, axes = seat_frame(model, model.mechanism.seats[body])
    origin, own = body_frame(model, body)
    return np.asarray(axes.T @ (own @ np.array(position) + ((place if origin is None else origin) - place)))


def world_place(model: Model, end: str) -> Array:
    """Position of a named end in world axes with all coordinates zero [m]."""
    place = place_of(model, end)
    return np.zeros(3) if place is None else place


def seat_at(model: Model, body: str, z: float) -> tuple[int, float]:
    """Body number at an axial position on a body, and the position relative to its frame [m].

    Parameters
    ----------
    model
        The model.
    body
        Name of the body.
    z
        Position from the body origin along the z axis [m].
    """
    number = body_numbers(model)[body]
    if body in model.shafts:
        places = model.stations[body]
        k = nearest_station(places, z)
        return number + k, z - places[k]
    return number, z + (axial_offset(model, model.mechanism.seats[body]) or 0.0)
