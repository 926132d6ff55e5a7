# SPDX-License-Identifier: Apache-2.0
"""Frames of bodies, markers, stations of beams and joints in the world, at zero coordinates."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.model.components.marker import Axes, Marker

if TYPE_CHECKING:
    from pitchpoint.model.components.beam import Beam
    from pitchpoint.model.components.body import Body
    from pitchpoint.model.components.joint import Joint
    from pitchpoint.model.components.marker import Axes

Array = NDArray[np.float64]
GROUND = "ground"
ALONG = 0.999999
"""Cosine of the angle below which two directions are treated as equal."""


class Machine(Protocol):
    """Anything with bodies and joints: a model or its parts."""

    @property
    def bodies(self) -> Mapping[str, Body]:
        """Bodies by name."""

    @property
    def joints(self) -> Mapping[str, Joint]:
        """Joints by name."""

    @property
    def beams(self) -> Mapping[str, Beam]:
        """Beams by name."""


def unit(vector: ArrayLike) -> Array:
    """Unit vector; a zero vector is returned unchanged."""
    v = np.asarray(vector, float)
    size = float(np.linalg.norm(v))
    return v / size if size > 0.0 else v


def frame(axes: Axes | None, base: Array | None = None) -> Array:
    """Right-handed frame (3, 3), columns, from two directions in the axes of `base`.

    Without an x axis, x is the projection of the base x axis onto the plane perpendicular to z, or that of
    the base y axis if z is along x.

    Examples
    --------
    >>> from pitchpoint.model.components.marker import Axes
    >>> frame(Axes(z=(1.0, 0.0, 0.0))).tolist()
    [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
    """
    outer = np.eye(3) if base is None else base
    if axes is None:
        return outer
    z = unit(axes.z)
    x = unit((1.0, 0.0, 0.0) if axes.x is None else axes.x)
    if axes.x is None and abs(z[0]) > ALONG:
        x = np.array([0.0, 1.0, 0.0])
    y = unit(np.cross(z, x))
    return np.asarray(outer @ np.column_stack([np.cross(y, z), y, z]))


def split(end: str) -> tuple[str, str]:
    """Body and marker ('' for the origin) of an end BODY or BODY.MARKER; beam and station of BEAM.STATION."""
    body, _, marker = end.partition(".")
    return body, marker


def bodies_of(ends: Iterable[str]) -> tuple[str, ...]:
    """Bodies of ends, see `split`.

    Examples
    --------
    >>> bodies_of(("A.end", "B"))
    ('A', 'B')
    """
    return tuple(split(end)[0] for end in ends)


def beam_of(machine: Machine, end: str) -> Beam | None:
    """Beam of an end BEAM.STATION; None for other ends. A body takes precedence over a beam of its name."""
    name = split(end)[0]
    return None if name in machine.bodies or name == GROUND else machine.beams.get(name)


def carrying_end(machine: Machine, end: str) -> str:
    """The end itself; for a station of a beam the end at the body that carries the beam, its first one."""
    beam = beam_of(machine, end)
    return end if beam is None else carrying_end(machine, beam.ends[0])


def carrier_of(machine: Machine, end: str) -> str:
    """Body of an end, or ground; for a station of a beam the body that carries the beam."""
    return split(carrying_end(machine, end))[0]


def marker_of(machine: Machine, end: str) -> Marker | None:
    """Marker of an end, or station of a beam; None for an origin and for unknown names."""
    body, name = split(end)
    beam = beam_of(machine, end)
    if beam is not None:
        share = beam.stations.get(name)
        length = beam_length(machine, beam)
        return None if share is None or length is None else Marker(position=(0.0, 0.0, share * length))
    return machine.bodies[body].markers.get(name) if body in machine.bodies else None


def beam_length(machine: Machine, beam: Beam) -> float | None:
    """Distance of the ends of a beam [m]; None if the position of an end is unknown."""
    root, tip = (place_of(machine, end) for end in beam.ends)
    return None if root is None or tip is None else float(np.linalg.norm(tip - root))


def beam_frame(machine: Machine, beam: Beam) -> tuple[Array | None, Array]:
    """First end of a beam [m], and its axes: z along the beam, x along axis 1 of its section."""
    root, tip = (place_of(machine, end) for end in beam.ends)
    if root is None or tip is None:
        return None, np.eye(3)
    return root, frame(Axes(z=tuple(tip - root), x=beam.axis))


def body_frame(machine: Machine, body: str) -> tuple[Array | None, Array]:
    """Origin and axes of a body or a beam in the world.

    The origin is None if it is not known yet. A body that does not exist has no origin and the axes of the
    world: the checks of references report it, the checks of positions skip it.
    """
    if body == GROUND:
        return np.zeros(3), np.eye(3)
    part = machine.bodies.get(body)
    if part is None:
        beam = beam_of(machine, body)
        return (None, np.eye(3)) if beam is None else beam_frame(machine, beam)
    origin = None if part.origin is None else np.array(part.origin, float)
    return origin, frame(part.orientation or part.axes)


def arm(machine: Machine, end: str) -> Array:
    """Position of an end relative to the origin of its body, in world axes [m]."""
    marker = marker_of(machine, end)
    if marker is None:
        return np.zeros(3)
    return np.asarray(body_frame(machine, split(end)[0])[1] @ np.array(marker.position))


def place_of(machine: Machine, end: str) -> Array | None:
    """Position of an end in the world [m]; None if that of its body is unknown."""
    origin = body_frame(machine, split(end)[0])[0]
    return None if origin is None else origin + arm(machine, end)


def axes_of(machine: Machine, end: str) -> Array:
    """Axes of an end in the world."""
    axes = body_frame(machine, split(end)[0])[1]
    marker = marker_of(machine, end)
    return axes if marker is None else frame(marker.axes, axes)


def joint_place(machine: Machine, joint: Joint) -> Array | None:
    """Position of a joint in the world [m]: as given, or of its markers, or the origin of the moved body.

    The pin of a planet is at the origin of the planet, which pin errors move from the node of the carrier.
    """
    if joint.position is not None:
        return np.array(joint.position, float)
    marked = _marked(joint)
    for end in marked or [e for e in reversed(joint.bodies) if e != GROUND][:1]:
        place = place_of(machine, end)
        if place is not None:
            return place
    return None


def joint_axes(machine: Machine, joint: Joint) -> Array:
    """Axes of a joint in the world, columns: as given, or those of a marker, or those of the world."""
    if joint.axes is not None:
        return frame(joint.axes)
    marked = _marked(joint)
    own = [e for e in marked if (m := marker_of(machine, e)) is not None and m.axes is not None]
    for end in own or marked:
        return axes_of(machine, end)
    return np.eye(3)


def _marked(joint: Joint) -> list[str]:
    """Ends at markers that define the joint; none for the pin of a planet."""
    return [e for e in joint.bodies if split(e)[1]] if joint.stage is None else []
