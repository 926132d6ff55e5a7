# SPDX-License-Identifier: Apache-2.0
"""Read solids from CAD files: STL, and STEP through OCC."""

from __future__ import annotations

import functools
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.solid_mass import SolidFile, solid_of_triangles
from pitchpoint.geometry.triangle_file import read_triangles, triangle_faults

FloatArray = NDArray[np.float64]

STEP = (".step", ".stp", ".p21")
STL = (".stl", ".npy")
MAX_TRIANGLES = 2_000_000
"""Maximum number of triangles of one solid."""


def read_solids(file: str | Path, unit: float | None = None) -> SolidFile:
    """Read all solids of an STL or a STEP file.

    Parameters
    ----------
    file
        STL (.stl, binary or text), triangles as a NumPy array (.npy), or STEP (.step, .stp, .p21).
    unit
        Length of one unit of the file [m]: STL files do not contain it and require it; STEP files contain it.

    Returns
    -------
    SolidFile
        An STL file is one solid without a name. A solid of a STEP file has the name of its product; equal
        names are numbered: 'shaft', 'shaft (2)'. Solids of an assembly have their positions in the assembly.

    Raises
    ------
    GeometryError
        If the file cannot be read or is truncated, if it has no solid or one that is open or inside out, or
        if the unit is missing or not allowed.
    MissingDependencyError
        If OCC is needed and not installed.

    Examples
    --------
    >>> import tempfile
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.solid import gear_solid
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder) / "gear.npy"
    ...     np.save(file, gear_solid(CylindricalGear(z=17, m_n=1e-3, b=0.01), 40))
    ...     found = read_solids(file, 1.0)
    >>> round(found.part().volume * 1e9, 1), found.unit    # exact: 2226.3 mm³
    (2226.5, '1 m')
    """
    path = Path(file)
    kind = path.suffix.lower()
    if kind not in STEP + STL:
        raise GeometryError(
            "is not a supported file type",
            where="file",
            value=f"'{path.name}'",
            limit=", ".join(STEP + STL),
            remedy="export it as STEP or STL",
        )
    if kind in STEP and unit is not None:
        raise GeometryError(
            "has no effect: a STEP file contains its unit",
            where="unit",
            value=f"{unit:g} m",
            remedy="remove it",
        )
    if kind in STL and unit is None:
        raise GeometryError(
            "is missing: an STL file does not contain its unit",
            where="unit",
            remedy="add unit: 1 mm, for example",
        )
    try:
        status = path.stat()
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise GeometryError(f"the file '{path.name}' cannot be read: {reason}", where="file") from None
    return _read(str(path), unit, status.st_mtime_ns, status.st_size)


@functools.lru_cache(maxsize=64)
def _read(file: str, unit: float | None, stamp: int, size: int) -> SolidFile:
    """Read a file; a file with the same modification time and size is not read again."""
    if unit is None:
        from pitchpoint.geometry.step_file import read_step

        return read_step(file)
    found = read_triangles(file)
    for wrong in triangle_faults(found, unit, most=MAX_TRIANGLES):
        remedy = "close it" if wrong.text.endswith("the surface is open") else wrong.remedy
        raise GeometryError(wrong.text, where="file", value=wrong.value, limit=wrong.limit, remedy=remedy)
    millimetres = round(1e3 * unit, 9)
    words = f"{unit:g} m" if unit >= 1.0 else f"{millimetres:g} mm"
    return SolidFile((solid_of_triangles(unit * found.corners),), words)
