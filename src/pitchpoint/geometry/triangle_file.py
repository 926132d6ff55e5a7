# SPDX-License-Identifier: Apache-2.0
"""Read and check triangulated surfaces from STL (binary and text) and NumPy files.

Binary STL: a header of 80 bytes, the number of triangles as 32-bit integer, then for each triangle the normal
and three corners as 32-bit floats and two spare bytes. Text: `facet normal x y z`, three `vertex x y z`,
`endfacet`; a file may have several solids. A file whose length matches its number of triangles is binary,
even if it begins with the word solid, as some do.
"""

from __future__ import annotations

import functools
import re
from dataclasses import dataclass
from pathlib import Path
from tokenize import TokenError

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import GeometryError, Message

FloatArray = NDArray[np.float64]

MAX_BYTES = 100_000_000
MAX_TRIANGLES = 50_000
"""Maximum number of triangles of a contact surface, limited by the time of preparation."""
SMALLEST, LARGEST = 2e-4, 20.0
"""Plausible sizes of a contact body [m]; others indicate a wrong unit."""
FLAT = 1e-9
"""Height of a triangle relative to the size of the surface below which it is degenerate."""

_FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("spare", "<u2")])
_HEAD = 84
_AGAIN = "export it again"
_COARSER = "export it coarser, or only the part that is touched"
_VECTOR = rb"\s+(\S+)\s+(\S+)\s+(\S+)"
_UNREADABLE = (
    ValueError,
    TypeError,
    SyntaxError,
    LookupError,
    ArithmeticError,
    EOFError,
    MemoryError,
    TokenError,
)
"""Exceptions that NumPy raises for a damaged header, which it parses as Python."""
_NORMAL = re.compile(rb"\bfacet\s+normal" + _VECTOR, re.IGNORECASE)
_VERTEX = re.compile(rb"\bvertex" + _VECTOR, re.IGNORECASE)
_END = re.compile(rb"\bendfacet\b", re.IGNORECASE)


def join_corners(corners: ArrayLike, tolerance: float = 1e-9) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Index the corners of triangles, with coincident corners merged.

    Parameters
    ----------
    corners
        Shape (n, 3, 3).
    tolerance
        Distance below which corners are merged, relative to the size of the surface.

    Returns
    -------
    ndarray, shape (m,)
        Index of the first corner at every distinct point, counted over all triangles.
    ndarray, shape (n, 3)
        Index of the distinct point of every corner.

    Examples
    --------
    >>> join_corners(np.eye(3)[None].repeat(2, axis=0))[1].tolist()
    [[2, 1, 0], [2, 1, 0]]
    """
    points = np.asarray(corners, float).reshape(-1, 3)
    grid = max(tolerance * float(np.ptp(points, axis=0).max()), 1e-300)
    cells = np.round((points - points.min(axis=0)) / grid).astype(np.int64)
    _, first, which = np.unique(cells, axis=0, return_index=True, return_inverse=True)
    return first, which.reshape(-1, 3)


@dataclass(frozen=True)
class Triangles:
    """Triangles of a file, in the unit of the file.

    Parameters
    ----------
    corners
        Corners, shape (n, 3, 3).
    normals
        Normals in the file, zero if it has none, shape (n, 3).
    """

    corners: FloatArray
    normals: FloatArray


def _refused(name: str, message: str, limit: str | None = None, remedy: str | None = None) -> GeometryError:
    return GeometryError(f"the file '{name}' {message}", limit=limit, remedy=remedy)


def read_triangles(file: str | Path) -> Triangles:
    """Read the triangles of a file.

    Parameters
    ----------
    file
        A NumPy array (.npy) of shape (n, 3, 3), or an STL file, binary or text.

    Raises
    ------
    GeometryError
        If the file cannot be read or is not one of these.

    Examples
    --------
    >>> import tempfile
    >>> text = "solid s facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet"
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder) / "one.stl"
    ...     _ = file.write_text(text)
    ...     read_triangles(file).corners.tolist()
    [[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]]
    """
    path = Path(file)
    try:
        status = path.stat()
        return _read(str(path), status.st_mtime_ns, status.st_size)
    except (OSError, ValueError) as error:
        if isinstance(error, GeometryError):
            raise
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise _refused(path.name, f"cannot be read: {reason}") from None


@functools.lru_cache(maxsize=4)
def _read(file: str, stamp: int, size: int) -> Triangles:
    """Read a file; a file with the same modification time and size is not read again."""
    name = Path(file).name
    if size > MAX_BYTES:
        raise _refused(name, f"is too large with {size / 1e6:.0f} MB", "100 MB", _COARSER)
    found = _numpy(file) if file.endswith(".npy") else _stl(name, Path(file).read_bytes())
    for array in (found.corners, found.normals):
        array.setflags(write=False)
    return found


def _numpy(file: str) -> Triangles:
    try:
        with open(file, "rb") as stream:
            corners = np.lib.format.read_array(stream, allow_pickle=False)
    except _UNREADABLE as error:
        raise ValueError(f"it is not a NumPy array ({type(error).__name__})") from None
    if corners.dtype.kind not in "fiu":
        raise ValueError("it is not an array of numbers")
    if corners.ndim != 3 or corners.shape[1:] != (3, 3):
        raise ValueError(f"it has the shape {corners.shape}, not (n, 3, 3)")
    return Triangles(corners.astype(float), np.zeros((len(corners), 3)))


def _stl(name: str, data: bytes) -> Triangles:
    count = int.from_bytes(data[80:_HEAD], "little")
    if len(data) >= _HEAD and len(data) == _HEAD + _FACET.itemsize * count:
        rows = np.frombuffer(data, _FACET, count, _HEAD)
        return Triangles(rows["corners"].astype(float), rows["normal"].astype(float))
    if data[:5].lower() != b"solid" and b"facet" not in data[:2000].lower():
        if len(data) < _HEAD:
            raise _refused(name, f"is not an STL file: it has {len(data)} bytes", f">= {_HEAD} bytes", _AGAIN)
        whole = _HEAD + _FACET.itemsize * count
        message = f"has {len(data)} bytes and names {count} triangles, which is not a whole STL file"
        raise _refused(name, message, f"{whole} bytes", _AGAIN)
    normals, corners = list(_NORMAL.finditer(data)), list(_VERTEX.finditer(data))
    facets = len(_END.findall(data))
    if len(normals) != facets or len(corners) != 3 * facets:
        seen = f"{len(normals)} facets, {len(corners)} corners, {facets} ends of facets"
        raise _refused(name, f"is not a whole STL file: {seen}", "3 corners and an end for each", _AGAIN)
    return Triangles(_numbers(name, data, corners).reshape(-1, 3, 3), _numbers(name, data, normals))


def _numbers(name: str, data: bytes, found: list[re.Match[bytes]]) -> FloatArray:
    """Vectors of all matches; raise with the line of the first that is not a vector."""
    try:
        return np.array([match.groups() for match in found]).astype(float).reshape(-1, 3)
    except ValueError:
        for match in found:
            try:
                [float(x) for x in match.groups()]
            except ValueError:
                line = data.count(b"\n", 0, match.start()) + 1
                shown = match.group().decode("ascii", "replace")[:60]
                raise _refused(name, f"has no vector in line {line}: {shown!r}", remedy=_AGAIN) from None
        raise


def triangle_faults(
    found: Triangles,
    unit: float,
    open_edges: bool = False,
    hollow: bool = False,
    *,
    most: int = MAX_TRIANGLES,
) -> list[Message]:
    """Faults of a triangulated surface, the most severe first; a fault that prevents other checks is alone.

    Parameters
    ----------
    found
        The triangles.
    unit
        Length of one unit of the file [m].
    open_edges
        Whether the surface may be open.
    hollow
        Whether the material is outside the surface, so that the triangles will be reversed.
    most
        Maximum number of triangles.

    Examples
    --------
    >>> one = Triangles(np.eye(3)[None], np.zeros((1, 3)))
    >>> [fault.text for fault in triangle_faults(one, 1.0)]
    ['belong to one triangle only: the surface is open']
    """
    corners = found.corners
    n = len(corners)
    if not 1 <= n <= most:
        few = Message("", "has no triangles", remedy=_AGAIN)
        return [Message("", "are too many", f"{n} triangles", f"<= {most}", _COARSER) if n else few]
    bad = np.asarray(~np.isfinite(corners).all(axis=(1, 2)))
    if bad.any():
        found_bad = f"have corners that are not finite numbers, the first is number {_first(bad)}"
        return [Message("", found_bad, f"{int(bad.sum())} triangles", remedy=_AGAIN)]
    size = float(np.ptp(corners.reshape(-1, 3), axis=0).max()) * unit
    if not SMALLEST <= size <= LARGEST:
        limit = f"{SMALLEST:g} m to {LARGEST:g} m"
        return [Message("", "is an unlikely size", f"{size:.3g} m", limit, "check unit: 1 mm, for example")]
    return [*_of_triangles(found), *_of_edges(corners, open_edges, hollow)]


def _first(bad: NDArray[np.bool_]) -> int:
    """Number of the first true element, counted from 1 as in STL viewers."""
    return int(np.argmax(bad)) + 1


def _of_triangles(found: Triangles) -> list[Message]:
    """Faults of degenerate triangles and reversed normals."""
    corners = found.corners
    edges = np.roll(corners, -1, axis=1) - corners
    across = np.cross(edges[:, 0], edges[:, 1])
    longest = np.linalg.norm(edges, axis=2).max(axis=1)
    size = np.linalg.norm(across, axis=1)
    faces = join_corners(corners)[1]
    points = (faces == np.roll(faces, 1, axis=1)).any(axis=1)  # coincident corners: harmless, omitted later
    whole = float(np.ptp(corners.reshape(-1, 3), axis=0).max())
    looked_at = np.full(len(points), True) if points.all() else ~points
    flat = looked_at & (size <= FLAT * whole * np.maximum(longest, 1e-300))
    faults = []
    if flat.any():
        faults.append(
            Message(
                "",
                f"have no area, the first is number {_first(flat)}",
                f"{int(flat.sum())} triangles",
                remedy="correct the surface, or export it with another tolerance",
            )
        )
    against = np.einsum("ij,ij->i", found.normals, across) < 0.0
    if against.any():
        faults.append(
            Message(
                "",
                f"are opposite to their normals, the first is number {_first(against)}",
                f"{int(against.sum())} of {len(corners)} triangles",
                remedy="correct the normals in the program that created it: corners are counter-clockwise "
                "seen from outside",
            )
        )
    return faults


def _of_edges(corners: FloatArray, open_edges: bool, hollow: bool) -> list[Message]:
    """Faults of edges used twice in one direction or only once, and of the sign of the volume."""
    faces = join_corners(corners)[1]
    faces = faces[(faces != np.roll(faces, 1, axis=1)).all(axis=1)]
    one, two = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    many = int(faces.max(initial=0)) + 1
    walked, counts = np.unique(one.astype(np.int64) * many + two, return_counts=True)
    twice = int((counts > 1).sum())
    if twice:
        return [
            Message(
                "",
                "are used in the same direction by two triangles",
                f"{twice} edges",
                "0",
                "reverse the flipped triangles; no more than two triangles may share an edge",
            )
        ]
    back = (walked % many) * many + walked // many
    border = int((~np.isin(back, walked)).sum())
    if border and not open_edges:
        return [
            Message(
                "",
                "belong to one triangle only: the surface is open",
                f"{border} edges",
                "0",
                "close it; if nothing gets near its border, write open: true",
            )
        ]
    volume = float(np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))) / 6.0
    if not border and volume < 0.0:
        more = "; hollow: true reverses them a second time" if hollow else ""
        return [Message("", "is inside out", None, None, f"reverse its triangles{more}")]
    return []


def placed_triangles(found: Triangles, unit: float, hollow: bool = False) -> FloatArray:
    """Corners in metres, counter-clockwise seen from outside the material, shape (n, 3, 3).

    Parameters
    ----------
    found
        The triangles.
    unit
        Length of one unit of the file [m].
    hollow
        Whether the material is outside the surface; the triangles are then reversed.

    Examples
    --------
    >>> one = Triangles(np.eye(3)[None], np.zeros((1, 3)))
    >>> placed_triangles(one, 1e-3, True)[0].tolist()
    [[0.0, 0.0, 0.001], [0.0, 0.001, 0.0], [0.001, 0.0, 0.0]]
    """
    corners = unit * np.asarray(found.corners)
    return corners[:, ::-1] if hollow else corners
