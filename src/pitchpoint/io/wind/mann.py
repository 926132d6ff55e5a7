# SPDX-License-Identifier: Apache-2.0
"""Boxes of the Mann generator: three files of 32-bit floats without header, one for each component.

The order is that of HAWC2 and of the routine `IfW_HAWC_Init` of InflowWind in OpenFAST: z fastest, from
bottom to top, then y from left to right, then x in the order of time. The files contain fluctuations.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import ModelError
from pitchpoint.io.target import check_place, write_file
from pitchpoint.model.wind.box import WindBox
from pitchpoint.model.wind.file_errors import (
    WindFileError,
    check_memory,
    check_size,
    refused,
    size_of,
    unreadable,
)
from pitchpoint.model.wind.ranges import Ranges

_FLOAT = np.dtype("<f4")


@dataclass(frozen=True, kw_only=True)
class MannGeometry:
    """Geometry of a box of the Mann generator, which its files do not contain.

    Parameters
    ----------
    points
        Number of points along x, y and z.
    spacing
        Distances along x, y and z [m].
    mean_speed
        Speed of convection [m/s]; the time step is the distance along x over it.
    hub_height
        Height of the centre of the box [m].
    """

    points: tuple[int, int, int]
    spacing: tuple[float, float, float]
    mean_speed: float
    hub_height: float

    def __post_init__(self) -> None:
        found = Ranges("Mann box")
        for name, number in zip("xyz", self.points, strict=True):
            found.count(f"points in {name}", number, 1, 1 << 24)
        for name, length in zip("xyz", self.spacing, strict=True):
            found.within(f"spacing in {name}", length, 1e-6, 1e4, "m")
        found.within("mean_speed", self.mean_speed, 1e-3, 200.0, "m/s")
        found.within("hub_height", self.hub_height, 0.0, 1e4, "m")
        if not found.problems:
            found.within("bottom", self.bottom, 0.0, 1e4, "m")
        found.finish()

    @property
    def bottom(self) -> float:
        """Height of the lowest row [m]."""
        return self.hub_height - 0.5 * (self.points[2] - 1) * self.spacing[2]


def read_mann(paths: Sequence[str | os.PathLike[str]], geometry: MannGeometry) -> WindBox:
    """Read the three files of a Mann box.

    Parameters
    ----------
    paths
        Files of u, v and w.
    geometry
        Geometry of the box.

    Returns
    -------
    WindBox
        Fluctuations, periodic in time.

    Raises
    ------
    WindFileError
        If a file is missing, its size contradicts the geometry, or it has values that are not finite.
    """
    names = [Path(path) for path in paths]
    if len(names) != 3:
        raise WindFileError(f"Mann box: {len(names)} files (limit 3); name the files of u, v and w")
    n_x, n_y, n_z = geometry.points
    remedy = f"correct the points, {n_x} x {n_y} x {n_z} are stated, or copy the file again"
    for name in names:
        check_size(name, size_of(name), 4 * n_x * n_y * n_z, remedy)
    check_memory(names[0], 3 * n_x * n_y * n_z)
    velocity = np.empty((n_x, n_z, n_y, 3), np.float32)
    for k, name in enumerate(names):
        velocity[..., k] = _component(name, geometry)
    try:
        return WindBox(
            velocity=velocity,
            time_step=geometry.spacing[0] / geometry.mean_speed,
            spacing=geometry.spacing[1:],
            bottom=geometry.bottom,
            hub_height=geometry.hub_height,
            mean_speed=geometry.mean_speed,
        )
    except ModelError as error:
        raise WindFileError(f"{names[0]}: {'; '.join(map(str, error.problems))}") from error


def _component(path: Path, geometry: MannGeometry) -> NDArray[np.float32]:
    """Velocities of one file, shape (n_x, n_z, n_y), y from right to left."""
    try:
        values = np.fromfile(path, _FLOAT)
    except (OSError, ValueError) as error:
        raise unreadable(path, error) from error
    if values.size != np.prod(geometry.points):
        raise refused(path, "", "", "changed while it was read", None, "read it again")
    if not np.isfinite([values.min(), values.max()]).all():
        first = int(np.flatnonzero(~np.isfinite(values))[0])
        remedy = "the file is damaged or has another format; make it again"
        raise refused(path, f"value {first}", f"{values[first]}", "is not a finite number", None, remedy)
    return values.reshape(geometry.points)[:, ::-1].transpose(0, 2, 1)


def write_mann(paths: Sequence[str | os.PathLike[str]], box: WindBox) -> MannGeometry:
    """Write the three files of a box in the order of the Mann generator.

    Parameters
    ----------
    paths
        Files of u, v and w.
    box
        Fluctuations on a grid that is centred at the hub.

    Returns
    -------
    MannGeometry
        What a reader of the files must know.

    Raises
    ------
    WindFileError
        If the box contains the mean wind, does not repeat or is not centred at the hub, or if a file exists:
        these files have no mark by which older ones could be identified.
    OutputError
        If a file cannot be written.
    """
    names = [Path(path) for path in paths]
    if len(names) != 3:
        raise WindFileError(f"Mann box: {len(names)} files (limit 3); name the files of u, v and w")
    n_t, n_z, n_y, _ = box.velocity.shape
    middle = box.bottom + 0.5 * (n_z - 1) * box.spacing[1]
    for wrong, text, remedy in (
        (box.with_mean, "would contain the mean wind", "write a box of fluctuations"),
        (not box.periodic, "would not repeat in time", "write a periodic box"),
        (abs(middle - box.hub_height) > 1e-6 * middle, "is not centred at the hub", "use a centred grid"),
    ):
        if wrong:
            raise refused(names[0], "", "", text, None, remedy)
    for name in names:
        check_place(name)
        if name.is_file() and name.stat().st_size:
            limit = "a new or empty file"
            raise refused(name, "", "", "exists", limit, "name another file, or delete this one first")
    for k, name in enumerate(names):
        values = box.velocity[..., k].transpose(0, 2, 1)[:, ::-1]
        write_file(name, np.ascontiguousarray(values, _FLOAT).tobytes())
    return MannGeometry(
        points=(n_t, n_y, n_z),
        spacing=(box.mean_speed * box.time_step, *box.spacing),
        mean_speed=box.mean_speed,
        hub_height=box.hub_height,
    )
