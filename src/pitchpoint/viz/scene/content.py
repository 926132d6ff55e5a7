# SPDX-License-Identifier: Apache-2.0
"""Contents of a 3-D scene as plain data: moving bodies with solids, arrows, curves, marks.

Metres, radians, seconds, newtons. `docs/scene_format.md` describes the format for the viewer, `file`
writes it.
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
    """Moving frame.

    Attributes
    ----------
    name
        Name of the body.
    parent
        Index of the body whose spinning frame is the reference; -1 is the world.
    place, axes
        Origin at rest, shape (3,) [m], and axes at rest, shape (3, 3), columns, both in the parent.
    position, turn
        Displacement of the origin [m] and small rotation vector [rad] from rest, in the axes at rest, shape
        (n, 3); None without motion.
    travel
        Displacement of the origin other than vibration, instead of `position`, shape (n, 3) [m].
    quaternion
        Rotation from rest (x, y, z, w), instead of `turn`, shape (n, 4).
    angle
        Angle about the third axis, including whole turns, shape (n,) [rad].
    gross
        Kinematic part of the angle: that of the guiding body times `ratio`, shape (n,).
    ratio
        Rotation of this body per rotation of the guiding one.
    part
        Whether it is a part of a component, such as the cage of a bearing, and not a body of the model.
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
    part: bool = False


@dataclass(frozen=True)
class Blend:
    """Deformation of a solid that follows several bodies.

    Attributes
    ----------
    bodies
        Indices of the bodies; points of the solid are in the rest frame of the first.
    first, second
        Indices in this list of the two bodies that move each point, shape (n,).
    weight
        Weight of the second body, shape (n,), 0 to 1.
    """

    bodies: Sequence[int]
    first: Indices
    second: Indices
    weight: Array


@dataclass(frozen=True)
class SceneLevel:
    """Surface in one level of detail: its deviation [m], points (n, 3) [m], triangles (m, 3)."""

    error: float
    points: Array
    triangles: Indices


@dataclass(frozen=True)
class ScenePiece:
    """Part of a surface that is repeated around the third axis.

    Attributes
    ----------
    turns
        Angles of its copies [rad].
    levels
        Surfaces from coarse to fine.
    fault
        Description of its fault, if any.
    """

    turns: Array
    levels: Sequence[SceneLevel]
    fault: str = ""


@dataclass(frozen=True)
class Between:
    """Ends of a solid stretched between two bodies: body indices, and positions in their frames."""

    bodies: tuple[int, int]
    ends: tuple[Array, Array]


@dataclass(frozen=True)
class ModalShape:
    """Deformation of a solid in modal coordinates.

    Attributes
    ----------
    shapes
        Displacement of every node per unit of each coordinate, shape (k, nodes, 3), in the frame of the body.
    node
        Node of each point of the solid, shape (n,).
    coordinates
        Coordinates over the frames, shape (n, k); None at rest.
    names
        Names of the coordinates, as in modes.
    """

    shapes: Array
    node: Indices
    coordinates: Array | None = None
    names: tuple[str, ...] = ()


@dataclass(frozen=True, kw_only=True)
class SceneSolid:
    """Solid on a body, as triangles.

    Attributes
    ----------
    name, kind
        Name, and gear, shaft, bearing, element, housing, carrier, spring or body.
    body
        Number of the body.
    points, triangles
        Corners, shape (n, 3) [m], in the frame of the solid; triangles, shape (m, 3), counter-clockwise seen
        from outside.
    pieces
        Repeated parts, such as teeth or rolling elements, instead of points and triangles.
    place, axes
        Frame of the solid in that of the body, shape (3,) [m] and (3, 3); None if equal.
    between
        End points of a stretched solid: its third axis is 0 at the first and 1 at the second.
    schematic
        Whether it is a symbol for a component of unknown shape.
    teeth
        Number of teeth of a gear, 0 for others.
    see_through
        Whether it is transparent.
    creases
        Angle above which an edge is sharp [deg].
    blend, modal
        Deformation with several bodies, or in modal coordinates; None for rigid solids.
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
    """Force and its point of application.

    Attributes
    ----------
    name, kind
        Name of the mesh, bearing or load, and mesh, bearing or load.
    body
        Body whose rest frame is the reference of `at` and the components; -1 is the world.
    at
        Shape (1, 3) or (n, 3) [m].
    components
        Vectors by role (circumferential, radial, axial), shape (n, 3) [N].
    state
        Contact state of meshes, shape (n,): 1 front, -1 back flank, 2 both, 0 no contact.
    """

    name: str
    kind: str
    body: int = -1
    at: Array
    components: Mapping[str, Array]
    state: Array | None = None


@dataclass(frozen=True, kw_only=True)
class SceneChannel:
    """Curve below the scene: samples, or minimum, maximum and mean of every piece of the record.

    Attributes
    ----------
    name, label
        Name in the result, and readable name.
    unit, shown_unit, scale
        SI unit, displayed unit, and the factor between them.
    times, least, most, mean
        Shape (k,), [s] and SI; all three values are equal for samples.
    first
        Whether it is shown by default.
    group, group_label, planet
        Name and readable name of the group of equal channels of all planets, and number of the planet; empty
        for others.
    """

    name: str
    label: str
    unit: str
    shown_unit: str
    scale: float
    times: Array
    least: Array
    most: Array
    mean: Array
    first: bool = False
    group: str = ""
    group_label: str = ""
    planet: int = 0


@dataclass(frozen=True)
class SceneMark:
    """Marked event.

    Attributes
    ----------
    time
        Time or start [s].
    kind
        contact_loss, impact, back_flank or front_flank (if the other one is the working flank), faulty_tooth.
    what
        Location in words.
    until
        End [s]; None for an instant.
    """

    time: float
    kind: str
    what: str
    until: float | None = None


@dataclass(frozen=True, kw_only=True)
class SceneMode:
    """Mode shape.

    Attributes
    ----------
    name, frequency, damping
        Dominant motion, natural frequency [Hz], damping ratio; None if not defined.
    position, turn
        Complex displacements of the bodies, shape (nb, 3), world axes.
    modal
        Complex modal coordinates of the deformable solids, by name.
    """

    name: str
    frequency: float
    damping: float | None
    position: NDArray[np.complex128]
    turn: NDArray[np.complex128]
    modal: Mapping[str, NDArray[np.complex128]] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class Scene:
    """Complete scene.

    Attributes
    ----------
    title, subtitle
        Texts above the scene.
    label
        Name of its file, to distinguish it from another scene next to it.
    up
        Direction that points up on the screen, shape (3,).
    bodies, solids, arrows, contacts, channels, spectra, maps, marks, modes
        Contents.
    times
        Times of the frames, shape (n,) [s]; a single one for a model without result.
    notes
        Remarks on omitted contents.
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
