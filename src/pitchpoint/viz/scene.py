# SPDX-License-Identifier: Apache-2.0
"""What a 3-D scene shows, as plain numbers: bodies that move, solids on them, arrows, curves, marks.

Metres, radians, seconds, newtons. `docs/scene_format.md` says how the viewer reads them, `scene_file` writes
them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Indices = NDArray[np.int64]


@dataclass(frozen=True, kw_only=True)
class SceneBody:
    """A frame that moves.

    Attributes
    ----------
    name
        Name of the body.
    parent
        Number of the body in whose spinning frame it is placed; -1 is the world.
    place, axes
        Origin at rest, shape (3,) [m], and axes at rest, shape (3, 3), columns, both in the parent.
    position, turn
        Displacement of the origin [m] and small rotation vector [rad] from rest, in the axes at rest, shape
        (n, 3); none where it does not move.
    angle
        Angle about the third axis, whole turns included, shape (n,) [rad].
    gross
        Part of the angle that the kinematics ask for: that of the guiding body, times `ratio`, shape (n,).
    ratio
        Turns of this body per turn of the guiding one.
    """

    name: str
    parent: int = -1
    place: Array
    axes: Array
    position: Array | None = None
    turn: Array | None = None
    angle: Array | None = None
    gross: Array | None = None
    ratio: float = 1.0


@dataclass(frozen=True)
class Skin:
    """How a solid follows several bodies.

    Attributes
    ----------
    bodies
        Numbers of the bodies; points of the solid are in the frame at rest of the first of them.
    first, second
        The two in this list between which each point lies, shape (n,).
    weight
        Part of the second, shape (n,), 0 to 1.
    """

    bodies: Sequence[int]
    first: Indices
    second: Indices
    weight: Array


@dataclass(frozen=True, kw_only=True)
class SceneSolid:
    """Triangles on a body.

    Attributes
    ----------
    name, kind
        Name, and gear, shaft, bearing, housing, carrier or body.
    body
        Number of the body.
    points, triangles
        Corners, shape (n, 3) [m], in the frame of the body; triangles, shape (m, 3), counter-clockwise seen
        from outside.
    teeth
        Number of teeth of a gear, 0 for others.
    see_through
        Whether what lies behind it shall be seen.
    creases
        Angle above which an edge is sharp [deg].
    skin
        How it bends between several bodies; none for rigid solids.
    """

    name: str
    kind: str
    body: int
    points: Array
    triangles: Indices
    teeth: int = 0
    see_through: bool = False
    creases: float = 35.0
    skin: Skin | None = None


@dataclass(frozen=True, kw_only=True)
class SceneArrow:
    """A force and where it acts.

    Attributes
    ----------
    name, kind
        Name of the mesh, bearing or load, and mesh, bearing or load.
    body
        Body in whose frame at rest `at` and the components count; -1 is the world.
    at
        Shape (1, 3) or (n, 3) [m].
    components
        Vectors by role (circumferential, radial, axial), shape (n, 3) [N].
    state
        Of meshes, shape (n,): 1 front, -1 back flank, 2 both, 0 no contact.
    """

    name: str
    kind: str
    body: int = -1
    at: Array
    components: Mapping[str, Array]
    state: Array | None = None


@dataclass(frozen=True, kw_only=True)
class SceneChannel:
    """A curve below the scene: least and most value of every piece of the record.

    Attributes
    ----------
    name, label
        Name in the result, and words for people.
    unit, shown_unit, scale
        SI unit, the one shown, and the factor between them.
    times, least, most
        Shape (k,), [s] and SI.
    first
        Whether it is shown without asking.
    """

    name: str
    label: str
    unit: str
    shown_unit: str
    scale: float
    times: Array
    least: Array
    most: Array
    first: bool = False


@dataclass(frozen=True)
class SceneMark:
    """An instant worth looking at.

    Attributes
    ----------
    time
        When it is or begins [s].
    kind
        contact_loss, impact, back_flank or front_flank (where the other one works), faulty_tooth.
    what
        Where, in words.
    until
        When it ends, none where it is an instant [s].
    """

    time: float
    kind: str
    what: str
    until: float | None = None


@dataclass(frozen=True, kw_only=True)
class FlankSurface:
    """The part of a flank that the path of contact reaches, of the tooth of pair 0.

    Attributes
    ----------
    body
        Number of the body it is fixed to.
    gear
        Name of the gear.
    teeth
        Its number of teeth.
    points
        Shape (nz, nx, 3) [m] in the frame of the body, over the width and along the path from A to E.
    turn
        Angle about the third axis of the body from one pair to the next [rad].
    tooth, step
        Number of the tooth of pair 0, and from one pair to the next.
    """

    body: int
    gear: str
    teeth: int
    points: Array
    turn: float
    tooth: int
    step: int


@dataclass(frozen=True, kw_only=True)
class ContactFlank:
    """What the front or the back flanks of a mesh carry.

    Attributes
    ----------
    side
        1 front, -1 back.
    travel
        Place of the contact line of pair 0 on the path of contact, in the plane of the pitch point, shape
        (n,) [m]; pair N is N base pitches behind.
    forces
        Of the slots, along the base tangent, front positive, shape (n, p) [N]; pair N has slot N mod p.
    loads
        Per width at s even places on each line, shape (n, p, s) [N/m].
    surfaces
        Flanks of gear 1 and 2.
    """

    side: int
    travel: Array
    forces: Array
    loads: Array
    surfaces: Sequence[FlankSurface]


@dataclass(frozen=True, kw_only=True)
class SceneContact:
    """Where and how the teeth of a mesh touch. Contact lines are straight in the plane of action.

    Attributes
    ----------
    name
        Name of the mesh.
    at
        Pitch point, shape (1, 3) or (n, 3) [m], world.
    axes
        Radial (towards gear 2), tangential and axial direction as columns, shape (1, 3, 3) or (n, 3, 3).
    pressure_angle
        Transverse working pressure angle, shape (1,) or (n,) [rad].
    base_helix
        Base helix angle of gear 1, right hand positive [rad].
    base_pitch
        Transverse base pitch [m].
    width
        Ends of the shared face width, from the plane of the pitch point [m].
    path
        Ends A and E of the path of contact, from the pitch point [m].
    penetration
        Of front and back flanks normal to them at the pitch point, below 0 their distance, shape (n, 2) [m].
    flanks
        The front flanks, and the back flanks where they ever touch.
    """

    name: str
    at: Array
    axes: Array
    pressure_angle: Array
    base_helix: float
    base_pitch: float
    width: tuple[float, float]
    path: tuple[float, float]
    penetration: Array
    flanks: Sequence[ContactFlank]


@dataclass(frozen=True, kw_only=True)
class Scene:
    """All of it.

    Attributes
    ----------
    title, subtitle
        Words above the scene.
    up
        Direction that points up on the screen, shape (3,).
    bodies, solids, arrows, contacts, channels, marks
        What there is.
    times
        Of the frames, shape (n,) [s]; a single one for a model without result.
    notes
        What is not shown, and why.
    """

    title: str
    subtitle: str = ""
    up: tuple[float, float, float] = (0.0, 1.0, 0.0)
    bodies: Sequence[SceneBody] = ()
    solids: Sequence[SceneSolid] = ()
    times: Array = field(default_factory=lambda: np.zeros(1))
    arrows: Sequence[SceneArrow] = ()
    contacts: Sequence[SceneContact] = ()
    channels: Sequence[SceneChannel] = ()
    marks: Sequence[SceneMark] = ()
    notes: Sequence[str] = ()
