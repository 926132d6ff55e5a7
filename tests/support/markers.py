# SPDX-License-Identifier: Apache-2.0
"""Markers of elements from one place in the assembled world."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.multibody.bodies import Body


def set_markers(
    record: Any, bodies: Sequence[Body], position: ArrayLike, axes: ArrayLike | None = None
) -> None:
    """Let the markers of a record coincide in a place of the world with all coordinates zero.

    Parameters
    ----------
    record
        Record with the bodies i and j and the fields p_i, p_j and, if it has them, A_i, A_j.
    bodies
        The bodies without ground, in the order of the system.
    position
        Place in world axes, shape (3,) [m].
    axes
        Axes of the markers in world axes, columns, shape (3, 3); those of the world if omitted.
    """
    turned = np.eye(3) if axes is None else np.asarray(axes, float)
    for end in "ij":
        number = int(record[end])
        own = bodies[number - 1] if number else Body()
        frame = np.asarray(own.axes, float)
        record["p_" + end] = frame.T @ (np.asarray(position, float) - np.asarray(own.position, float))
        if "A_" + end in record.dtype.names:
            record["A_" + end] = frame.T @ turned
