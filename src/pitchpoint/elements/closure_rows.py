# SPDX-License-Identifier: Apache-2.0
"""Joints outside the spanning tree (cut joints) as rows of the kind `closure`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.elements.closure import DISTANCE, POINT, RECORD, RIGHT, SCREW
from pitchpoint.multibody import joints
from pitchpoint.multibody.bodies import Body

#: Pairs of perpendicular directions (of body i, of body j) for the free rotations of a joint.
_RIGHT: dict[tuple[int, ...], tuple[tuple[int, int], ...]] = {
    (): ((0, 1), (1, 2), (2, 0)),
    (5,): ((2, 0), (2, 1)),
    (3, 4): ((1, 0),),
    (3, 4, 5): (),
}
_WORDS = "xyz"


def cut_joint(
    motion: int,
    bodies: Sequence[Body],
    i: int,
    j: int,
    position: ArrayLike,
    axes: ArrayLike,
    lead: float = 0.0,
) -> tuple[NDArray[np.void], list[str]]:
    """Constraint rows of a joint between body i and body j.

    Parameters
    ----------
    motion
        Code of the joint, see `pitchpoint.multibody.joints`.
    bodies
        All bodies without ground; i and j count from 1, 0 is ground.
    i, j
        Body that the joint moves and body that it is attached to.
    position, axes
        Position of the joint and its frame (columns), world axes, with all coordinates of the tree zero.
    lead
        Travel of a screw per radian [m/rad].

    Returns
    -------
    records, words
        Records of the kind and the constrained direction of each row, such as "x" or "xy".

    Examples
    --------
    >>> records, words = cut_joint(joints.TORSION, [Body(polar_inertia=1.0)], 1, 0, np.zeros(3), np.eye(3))
    >>> words
    ['x', 'y', 'z', 'zx', 'zy']
    """
    free = joints.AXES[motion]
    frame = np.asarray(axes, float)
    rows: list[tuple[str, dict[str, Any]]] = []
    for m in range(3):
        if m not in free:
            form = SCREW if motion == joints.SCREW and m == joints.Z else POINT
            more = {"b_i": frame[:, 0], "x_j": frame[:, 0], "lead": lead} if form == SCREW else {}
            rows.append((_WORDS[m], {"form": form, "a_j": frame[:, m], **more}))
    for one, two in _RIGHT[tuple(m for m in free if m > 2)]:
        rows.append((_WORDS[one] + _WORDS[two], {"form": RIGHT, "b_i": frame[:, one], "a_j": frame[:, two]}))
    records = np.zeros(len(rows), RECORD)
    for record, (_, values) in zip(records, rows, strict=True):
        _fill(record, bodies, i, j, position, position, values)
    return records, [word for word, _ in rows]


def rod(
    bodies: Sequence[Body],
    i: int,
    j: int,
    point_i: ArrayLike,
    point_j: ArrayLike,
    length: float | None = None,
) -> NDArray[np.void]:
    """Row of a massless rod with a spherical joint at either end: constant distance of two points.

    Parameters
    ----------
    bodies, i, j
        As in `cut_joint`.
    point_i, point_j
        Ends of the rod in world axes, with all coordinates of the tree zero.
    length
        Length of the rod [m]; None: distance of the ends.
    """
    record = np.zeros(1, RECORD)
    distance = float(np.linalg.norm(np.subtract(point_i, point_j)))
    values = {"form": DISTANCE, "length": distance if length is None else length}
    _fill(record[0], bodies, i, j, point_i, point_j, values)
    return record


def _fill(
    record: np.void,
    bodies: Sequence[Body],
    i: int,
    j: int,
    point_i: ArrayLike,
    point_j: ArrayLike,
    values: dict[str, Any],
) -> None:
    """Fill one record; world directions and points are stored in body axes."""
    record["i"], record["j"] = i, j
    record["p_i"] = _seen(bodies, i, point_i, True)
    record["p_j"] = _seen(bodies, j, point_j, True)
    for name, value in values.items():
        if name in ("b_i", "a_j", "x_j"):
            value = _seen(bodies, i if name == "b_i" else j, value, False)
        record[name] = value


def _seen(bodies: Sequence[Body], k: int, vector: ArrayLike, is_place: bool) -> NDArray[np.float64]:
    """Point or direction in the axes of a body, from world components."""
    x = np.asarray(vector, float)
    if k == 0:
        return x
    body = bodies[k - 1]
    return np.asarray(body.axes, float).T @ (x - np.asarray(body.position, float) if is_place else x)
