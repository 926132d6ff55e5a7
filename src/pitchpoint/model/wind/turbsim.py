# SPDX-License-Identifier: Apache-2.0
"""Full-field files of TurbSim (.bts), read: velocities as 16-bit integers with a scale for each component.

The layout is that of TurbSim User's Guide 2.00, appendix D, and of the routines `WrBinTURBSIM` of TurbSim and
`IfW_TurbSim_Init` of InflowWind in OpenFAST: 70 bytes of header, a text, then for each time the grid, y
fastest, then z from bottom to top, each point with u, v, w; then the points of the tower below the grid.
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import ModelError
from pitchpoint.model.wind.box import BoxExtent, WindBox
from pitchpoint.model.wind.file_errors import (
    WindFileError,
    check_finite,
    check_memory,
    check_size,
    refused,
    size_of,
    unreadable,
)

HEADER = np.dtype(
    [
        ("id", "<i2"),  # 7: the wind does not repeat, 8: it repeats
        ("n_z", "<i4"),
        ("n_y", "<i4"),
        ("n_tower", "<i4"),
        ("n_t", "<i4"),  # numbers of points
        ("dz", "<f4"),
        ("dy", "<f4"),
        ("dt", "<f4"),  # steps [m], [m], [s]
        ("mean_speed", "<f4"),  # at hub height [m/s]
        ("hub_height", "<f4"),
        ("bottom", "<f4"),  # heights of the hub and of the lowest row [m]
        ("scale", "<f4", (3, 2)),  # integer = slope velocity + offset, for u, v, w
        ("n_text", "<i4"),  # length of the text
    ]
)
"""Header, 70 bytes without gaps."""
LONGEST_TEXT = 200
PERIODIC, ONCE = 8, 7
BLOCK = 1 << 22
"""Velocities read or written at once."""
_REMEDY = "copy the file again, or run TurbSim again"


def read_turbsim(path: str | os.PathLike[str]) -> WindBox:
    """Read a full-field file of TurbSim.

    The velocities contain the mean wind. Points of the tower are skipped. A file that does not repeat begins
    half a grid width upwind of x = 0, as in InflowWind.

    Parameters
    ----------
    path
        The file (.bts).

    Raises
    ------
    WindFileError
        If the file is missing, cut off or damaged.
    """
    name = Path(path)
    with _opened(name) as (file, head, numbers):
        file.seek(HEADER.itemsize + numbers["n_text"])
        velocity = _velocities(name, file, numbers, head["scale"].astype(float))
    return _box(name, head, velocity)


def turbsim_extent(path: str | os.PathLike[str]) -> BoxExtent:
    """Space and time of a full-field file of TurbSim, from its header and its size only.

    Parameters
    ----------
    path
        The file (.bts).

    Raises
    ------
    WindFileError
        If the file is missing, cut off or damaged.
    """
    name = Path(path)
    with _opened(name) as (_, head, numbers):
        pass
    n_t, n_z, n_y = (numbers[key] for key in ("n_t", "n_z", "n_y"))
    box = _box(name, head, np.zeros((1, n_z, n_y, 3), np.float32))
    return BoxExtent(
        half_width=float(box.y[-1]) if n_y > 1 else math.inf,
        top=float(box.z[-1]) if n_z > 1 else math.inf,
        duration=(n_t if box.periodic else n_t - 1) * box.time_step,
        mean_speed=box.mean_speed,
        periodic=box.periodic,
        shift=box.shift,
    )


@contextmanager
def _opened(path: Path) -> Iterator[tuple[IO[bytes], Any, dict[str, int]]]:
    """Open file, its header and its numbers of points, checked together with its size."""
    there = size_of(path)
    try:
        with path.open("rb") as file:
            if there < HEADER.itemsize:
                raise refused(path, "header", f"{there} bytes", "are there: the file is cut off",
                              f"{HEADER.itemsize} bytes", _REMEDY)  # fmt: skip
            head = np.frombuffer(file.read(HEADER.itemsize), HEADER)[0]
            yield file, head, _checked(path, head, there)
    except (OSError, ValueError) as error:
        if isinstance(error, WindFileError):
            raise
        raise unreadable(path, error) from error


def _box(name: Path, head: Any, velocity: NDArray[np.float32]) -> WindBox:
    """Box of the velocities of a file."""
    spacing = (float(head["dy"]), float(head["dz"]))
    periodic = int(head["id"]) == PERIODIC
    try:
        return WindBox(
            velocity=velocity,
            time_step=float(head["dt"]),
            spacing=spacing,
            bottom=float(head["bottom"]),
            hub_height=float(head["hub_height"]),
            mean_speed=float(head["mean_speed"]),
            with_mean=True,
            periodic=periodic,
            shift=0.0 if periodic else 0.5 * (velocity.shape[2] - 1) * spacing[0],
        )
    except ModelError as error:
        raise WindFileError(f"{name}: {'; '.join(map(str, error.problems))}") from error


def _checked(path: Path, head: Any, there: int) -> dict[str, int]:
    """Numbers of points; the header is checked together with the size of the file."""
    numbers = {key: int(head[key]) for key in ("n_z", "n_y", "n_tower", "n_t", "n_text")}
    if int(head["id"]) not in (PERIODIC, ONCE):
        raise refused(path, "byte 0", f"{int(head['id'])}", "is not the number of this format", "7 or 8",
                      "use a full-field file of TurbSim (.bts)")  # fmt: skip
    lowest = {"n_z": 1, "n_y": 1, "n_tower": 0, "n_t": 1, "n_text": 0}
    for key, words in (
        ("n_z", "points along z"),
        ("n_y", "points along y"),
        ("n_tower", "points of the tower"),
        ("n_t", "time steps"),
        ("n_text", "characters of the text"),
    ):
        if numbers[key] < lowest[key] or (key == "n_text" and numbers[key] > LONGEST_TEXT):
            limit = f"0 to {LONGEST_TEXT}" if key == "n_text" else f">= {lowest[key]}"
            raise refused(path, words, f"{numbers[key]}", "is not possible", limit, _REMEDY)
    check_finite(
        path,
        dz=float(head["dz"]),
        dy=float(head["dy"]),
        dt=float(head["dt"]),
        mean_speed=float(head["mean_speed"]),
    )
    scale = head["scale"].astype(float)
    if not np.isfinite(scale).all() or (scale[:, 0] == 0.0).any():
        raise refused(path, "scale", "", "has a slope of 0 or a number that is not finite", None, _REMEDY)
    samples = numbers["n_t"] * (numbers["n_z"] * numbers["n_y"] + numbers["n_tower"]) * 3
    check_size(path, there, HEADER.itemsize + numbers["n_text"] + 2 * samples, _REMEDY)
    check_memory(path, samples)
    return numbers


def _velocities(path: Path, file: Any, numbers: dict[str, int], scale: NDArray[Any]) -> NDArray[np.float32]:
    """Velocities of the grid, read in blocks."""
    n_t, grid = numbers["n_t"], numbers["n_z"] * numbers["n_y"]
    row = 3 * (grid + numbers["n_tower"])
    found = np.empty((n_t, numbers["n_z"], numbers["n_y"], 3), np.float32)
    step = max(1, BLOCK // row)
    with np.errstate(over="ignore"):
        for k in range(0, n_t, step):
            count = min(step, n_t - k)
            raw = np.frombuffer(file.read(2 * row * count), "<i2")
            if raw.size != row * count:
                raise refused(path, "", "", "became shorter while it was read", None, _REMEDY)
            points = raw.reshape(count, -1, 3)[:, :grid].reshape(found[k : k + count].shape)
            found[k : k + count] = (points - scale[:, 1]) / scale[:, 0]
    return found
