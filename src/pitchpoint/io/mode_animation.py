# SPDX-License-Identifier: Apache-2.0
"""Mode shapes for animation: motion of bodies and nodes of elastic bodies over one cycle, as JSON or NPZ.

A frame of the animation rotates a body by the small rotation vector and moves its origin by the displacement.
The shapes are scaled so that the largest displacement of an origin, or rotation times a radius, has a given
length.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.io.container import ResultError
from pitchpoint.io.target import write_file

RADIUS = 0.1
"""Radius that converts a rotation to a displacement [m]."""
MAX_NUMBERS = 6_000_000
"""Maximum count of numbers for the nodes of one body in a file; more nodes are decimated."""
Array = NDArray[np.float64]
FORMATS = (".json", ".npz")


def cycle(shape: ArrayLike, frames: int = 24) -> NDArray[np.float64]:
    """One cycle of vibration: Re(shape e^(i 2 pi k/frames)), with a new first axis of length `frames`.

    Examples
    --------
    >>> cycle(np.array([1.0, 1.0j]), 4).round(12) + 0.0
    array([[ 1.,  0.],
           [ 0., -1.],
           [-1.,  0.],
           [ 0.,  1.]])
    """
    turn = np.exp(2j * np.pi * np.arange(frames) / frames)
    found = np.multiply.outer(turn, np.asarray(shape, dtype=np.complex128)).real
    return np.asarray(found, dtype=np.float64)


def write_mode_animation(
    path: str | Path,
    *,
    bodies: Sequence[str],
    names: Sequence[str],
    frequency: ArrayLike,
    place: ArrayLike,
    axes: ArrayLike,
    body_shape: ArrayLike,
    nodes: Mapping[str, tuple[ArrayLike, ArrayLike]] | None = None,
    frames: int = 24,
    amplitude: float = 0.01,
) -> None:
    """Write modes for animation.

    Parameters
    ----------
    path
        File that ends in .json or .npz.
    bodies
        Names of the bodies, ground first.
    names, frequency
        Names and natural frequencies [Hz] of the modes, shape (n,).
    place, axes
        Frames at rest, world axes, shape (nb, 3) [m] and (nb, 3, 3), columns are the axes.
    body_shape
        Displacement of the origin and small rotation vector of every body, real or complex, world axes,
        (n, nb, 6).
    nodes
        For every elastic body the rest positions of its nodes, (k, 3) [m], and their displacements in the
        modes, real or complex, world axes, (n, k, 3).
    frames
        Number of frames per cycle.
    amplitude
        Largest displacement [m] after scaling; rotations count with a radius of 0.1 m.

    Raises
    ------
    ResultError
        If the file has another extension.
    """
    target = Path(path)
    if target.suffix not in FORMATS:
        raise ResultError(f"{target.name}: modes are written as {' or '.join(FORMATS)}")
    shape = np.asarray(body_shape, dtype=np.complex128)
    reach = np.maximum(
        np.linalg.norm(shape[..., :3], axis=-1), RADIUS * np.linalg.norm(shape[..., 3:], axis=-1)
    ).max(axis=1, initial=0.0)
    swing = {name: (np.asarray(at, float), np.asarray(u, complex)) for name, (at, u) in (nodes or {}).items()}
    for _, shapes in swing.values():
        reach = np.maximum(reach, np.linalg.norm(shapes, axis=-1).max(axis=1, initial=0.0))
    factor = np.divide(amplitude, reach, out=np.zeros_like(reach), where=reach > 0.0)
    motion = np.moveaxis(cycle(shape * factor[:, None, None], frames), 0, 1)  # mode, frame, body, 6
    content = {
        "bodies": np.array(list(bodies)),
        "modes": np.array(list(names)),
        "frequency": np.asarray(frequency, dtype=np.float64),
        "place": np.asarray(place, dtype=np.float64),
        "axes": np.asarray(axes, dtype=np.float64),
        "scale": factor,
        "motion": motion,
    }
    elastic = {name: _node_motion(at, u * factor[:, None, None], frames) for name, (at, u) in swing.items()}
    if target.suffix == ".npz":
        flat = {f"{key}[{name}]": value for name, part in elastic.items() for key, value in part.items()}
        everything: dict[str, Any] = {**content, **flat}
        packed = BytesIO()
        np.savez_compressed(packed, **everything)
        write_file(target, packed.getvalue())
        return
    about = "motion: mode, frame of the cycle, body, displacement [m] and turn [rad] in world axes"
    lists: dict[str, Any] = {key: value.tolist() for key, value in content.items()}
    if elastic:
        about += "; of nodes: mode, frame of the cycle, node, displacement [m]"
        lists["nodes"] = {
            name: {key.removeprefix("node_"): value.tolist() for key, value in part.items()}
            for name, part in elastic.items()
        }
    write_file(target, json.dumps({"about": about, **lists}))


def _node_motion(place: Array, shape: NDArray[np.complex128], frames: int) -> dict[str, NDArray[Any]]:
    """Indices of the stored nodes, their rest positions, and their motion (mode, frame, node, 3)."""
    stride = -(-shape.size * frames // MAX_NUMBERS) or 1
    kept = np.arange(0, len(place), stride)
    motion = np.moveaxis(cycle(shape[:, kept], frames), 0, 1)
    return {"node_number": kept, "node_place": place[kept], "node_motion": motion}
