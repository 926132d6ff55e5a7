# SPDX-License-Identifier: Apache-2.0
"""Triangulated surfaces of solids of STEP files, for drawing; through OCC, installed by the extra `cad`."""

from __future__ import annotations

import functools
import json
import sys
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.step_file import ask, named_solids, refused

FloatArray = NDArray[np.float64]

CHORDS = (1e-3, 4e-3, 1.6e-2)
"""Chord errors relative to the size of a solid; the finest with at most `MAX_TRIANGLES` triangles is used."""
MAX_TRIANGLES = 50_000
"""Maximum number of triangles of one drawn solid."""
_ANGLE = 0.3
"""Maximum angle of the surface along a chord [rad]: resolves small radii, below that of sharp edges."""
_MM = 1e-3


def step_triangles(file: str | Path, part: str) -> FloatArray:
    """Surface of a solid of a STEP file, counter-clockwise seen from outside.

    Parameters
    ----------
    file
        Path of the file.
    part
        Name of the solid, as `step_file.read_step` gives it.

    Returns
    -------
    ndarray
        Corners, shape (n, 3, 3) [m].

    Raises
    ------
    GeometryError
        If the file cannot be read or has no such solid, or if the solid needs too many triangles.
    MissingDependencyError
        If OCC is not installed.
    """
    path = Path(file)
    try:
        status = path.stat()
    except OSError as error:
        raise refused(path.name, f"cannot be read: {error.strerror}") from None
    return _divided(str(path), part, status.st_mtime_ns, status.st_size)


@functools.lru_cache(maxsize=16)
def _divided(file: str, part: str, stamp: int, size: int) -> FloatArray:
    """Triangulate in a separate process, cached by modification time and size of the file."""
    with TemporaryDirectory() as folder:
        target = Path(folder) / "corners.npy"
        ask("pitchpoint.geometry.step_triangles", file, part, str(target))
        corners: FloatArray = np.load(target)
    corners.setflags(write=False)
    return corners


def _answer(file: str, part: str, target: str) -> dict[str, Any]:
    """Write the corners to the file `target`; the result is empty."""
    name = Path(file).name
    shape = next((shape for label, shape in named_solids(file)[1] if label == part), None)
    if shape is None:
        raise refused(name, f"holds no solid '{part}'")
    for chord in CHORDS:
        corners = _corners(shape, chord)
        if len(corners) <= MAX_TRIANGLES:
            break
    if not 0 < len(corners) <= MAX_TRIANGLES:
        raise GeometryError(
            f"the solid '{part}' of the file '{name}' has more triangles than can be drawn",
            where="file",
            value=str(len(corners)),
            limit=str(MAX_TRIANGLES),
            remedy="omit small parts",
        )
    np.save(target, corners * _MM)
    return {}


def _corners(shape: Any, chord: float) -> FloatArray:
    """Triangles of an OCC shape [mm]."""
    from OCP.Bnd import Bnd_Box
    from OCP.BRepBndLib import BRepBndLib
    from OCP.BRepMesh import BRepMesh_IncrementalMesh
    from OCP.BRepTools import BRepTools

    box = Bnd_Box()
    BRepBndLib.AddOptimal_s(shape, box, False)
    BRepTools.Clean_s(shape)
    BRepMesh_IncrementalMesh(shape, chord * float(box.SquareExtent()) ** 0.5, False, _ANGLE, False)
    found = [corners for face in _faces(shape) for corners in _of_face(face)]
    return np.concatenate(found) if found else np.zeros((0, 3, 3))


def _faces(shape: Any) -> Iterator[Any]:
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    explorer = TopExp_Explorer(shape, TopAbs_ShapeEnum.TopAbs_FACE)
    while explorer.More():
        yield TopoDS.Face(explorer.Current())
        explorer.Next()


def _of_face(face: Any) -> Iterator[FloatArray]:
    """Triangles of a face in its assembly position, oriented outwards."""
    from OCP.BRep import BRep_Tool
    from OCP.TopAbs import TopAbs_Orientation
    from OCP.TopLoc import TopLoc_Location

    place = TopLoc_Location()
    surface = BRep_Tool.Triangulation_s(face, place)
    if surface is None:
        return
    nodes = [surface.Node(k).Transformed(place.Transformation()) for k in range(1, surface.NbNodes() + 1)]
    points = np.array([(p.X(), p.Y(), p.Z()) for p in nodes])
    numbers = np.array([surface.Triangle(k).Get() for k in range(1, surface.NbTriangles() + 1)], np.int64) - 1
    if face.Orientation() == TopAbs_Orientation.TopAbs_REVERSED:
        numbers = numbers[:, ::-1]
    yield points[numbers]


if __name__ == "__main__":
    from pitchpoint.geometry.step_file import answered

    sys.stdout.write(json.dumps(answered(_answer, *sys.argv[1:])))
