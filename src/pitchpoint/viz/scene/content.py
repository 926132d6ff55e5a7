# SPDX-License-Identifier: Apache-2.0
"""What a 3-D scene shows, as plain numbers: bodies that move, solids on them, arrows, curves, marks.

Metres, radians, seconds, newtons. `docs/scene_format.md` states how the viewer reads them, `file`
writes them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from pitchpoint.viz.scene.contacts import SceneContact
from pitchpoint.viz.scene.spectrum import SceneMap, SceneSpectrum

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
    travel
        Displacement of the origin that is not a vibration, in place of `position`, shape (n, 3) [m].
    quaternion
        Attitude against that at rest (x, y, z, w), in place of `turn`, shape (n, 4).
    angle
        Angle about the third axis, whole turns included, shape (n,) [rad].
    gross
        Part of the angle prescribed by the kinematics: that of the guiding body, times `ratio`, shape (n,).
    ratio
        Turns of this body per turn of the guiding one.
    """

    name: str
    parent: int = -1
    place: Array
    axes: Array
    position: Array | None = None
    turn: Array | None = None
    travel: Array | None = None
    quaternion: Array | None = None
    angle: Array | None = None
    gross: Array | None = None
    ratio: float = 1.0


@dataclass(frozen=True)
class Blend:
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


@dataclass(frozen=True)
class SceneLevel:
    """A surface in one fineness: how far off it lies [m], points (n, 3) [m], triangles (m, 3)."""

    error: float
    points: Array
    triangles: Indices


@dataclass(frozen=True)
class ScenePiece:
    """A part of a surface that is repeated around the third axis.

    Attributes
    ----------
    turns
        Angles of its copies [rad].
    levels
        The part from coarse to fine.
    fault
        What is wrong with it, if anything.
    """

    turns: Array
    levels: Sequence[SceneLevel]
    fault: str = ""


@dataclass(frozen=True)
class Between:
    """The two ends of a solid that is stretched between two bodies: numbers, and places in their frames."""

    bodies: tuple[int, int]
    ends: tuple[Array, Array]


@dataclass(frozen=True)
class ModalShape:
    """How a solid bends in modal coordinates.

    Attributes
    ----------
    shapes
        Displacement of every node per unit of each coordinate, shape (k, nodes, 3), in the frame of the body.
    node
        Node that each point of the solid goes with, shape (n,).
    coordinates
        The coordinates over the frames, shape (n, k); none at rest.
    """

    shapes: Array
    node: Indices
    coordinates: Array | None = None


@dataclass(frozen=True, kw_only=True)
class SceneSolid:
    """Triangles on a body.

    Attributes
    ----------
    name, kind
        Name, and gear, shaft, bearing, housing, carrier, spring or body.
    body
        Number of the body.
    points, triangles
        Corners, shape (n, 3) [m], in the frame of the solid; triangles, shape (m, 3), counter-clockwise seen
        from outside.
    pieces
        In their place the parts of a gear.
    place, axes
        Frame of the solid in that of the body, shape (3,) [m] and (3, 3); none where it is the same.
    between
        The points that it is stretched between: its third axis goes from 0 at the first to 1 at the second.
    schematic
        Whether it only represents something whose shape is not known.
    teeth
        Number of teeth of a gear, 0 for others.
    see_through
        Whether what lies behind it shall be seen.
    creases
        Angle above which an edge is sharp [deg].
    blend, modal
        How it bends between several bodies, or in modal coordinates; none for rigid solids.
    """

    name: str
    kind: str
    body: int
    points: Array | None = None
    triangles: Indices | None = None
    pieces: Sequence[ScenePiece] = ()
    place: Array | None = None
    axes: Array | None = None
    between: Between | None = None
    schematic: bool = False
    teeth: int = 0
    see_through: bool = False
    creases: float = 35.0
    blend: Blend | None = None
    modal: ModalShape | None = None


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
class SceneMode:
    """A mode shape.

    Attributes
    ----------
    name, frequency, damping
        What moves, [Hz], share of critical damping; none where it has no meaning.
    position, turn
        Complex displacements of the bodies, shape (nb, 3), world axes.
    modal
        Complex modal coordinates of the solids that bend in them, by name.
    """

    name: str
    frequency: float
    damping: float | None
    position: NDArray[np.complex128]
    turn: NDArray[np.complex128]
    modal: Mapping[str, NDArray[np.complex128]] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class Scene:
    """All of it.

    Attributes
    ----------
    title, subtitle
        Words above the scene.
    label
        Name of the file that it shows, to distinguishes it from another next to it.
    up
        Direction that points up on the screen, shape (3,).
    bodies, solids, arrows, contacts, channels, spectra, maps, marks, modes
        What there is.
    times
        Of the frames, shape (n,) [s]; a single one for a model without result.
    notes
        What is not shown, and why.
    """

    title: str
    subtitle: str = ""
    label: str = ""
    up: tuple[float, float, float] = (0.0, 1.0, 0.0)
    bodies: Sequence[SceneBody] = ()
    solids: Sequence[SceneSolid] = ()
    times: Array = field(default_factory=lambda: np.zeros(1))
    arrows: Sequence[SceneArrow] = ()
    contacts: Sequence[SceneContact] = ()
    channels: Sequence[SceneChannel] = ()
    spectra: Sequence[SceneSpectrum] = ()
    maps: Sequence[SceneMap] = ()
    marks: Sequence[SceneMark] = ()
    modes: Sequence[SceneMode] = ()
    notes: Sequence[str] = ()
