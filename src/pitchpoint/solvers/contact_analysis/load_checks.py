# SPDX-License-Identifier: Apache-2.0
"""Torques and misalignments of contact analyses, checked."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, SolverError
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.model.components.mesh import STEEPEST

Array = NDArray[np.float64]


def checked_torques(torque: Any) -> Array:
    """Torques on gear 1 [N m], shape (n,).

    Parameters
    ----------
    torque
        A number other than 0, or a sequence of them.

    Raises
    ------
    SolverError
        If there is none, or one is not a finite number other than 0.

    Examples
    --------
    >>> checked_torques(300).tolist()
    [300.0]
    """
    found = _numbers(torque)
    if found is None or found.ndim > 1 or not found.size or not np.all(np.isfinite(found) & (found != 0.0)):
        raise SolverError(
            f"torque {torque!r} is not a load; give a number other than 0, in N m, or several", INCONSISTENT
        )
    return np.atleast_1d(found)


def checked_torque(torque: Any) -> float:
    """A single torque on gear 1 [N m].

    Parameters
    ----------
    torque
        A number other than 0.

    Raises
    ------
    SolverError
        If it is not a finite number other than 0.
    """
    found = checked_torques(torque)
    if found.size != 1:
        raise SolverError(f"torque {torque!r} has {found.size} values; give one", INCONSISTENT)
    return float(found[0])


def check_misalignment(angle: Any) -> None:
    """Refuse a misalignment of the flanks in the plane of action [rad] above that of the keys of a mesh.

    Parameters
    ----------
    angle
        Misalignment [rad]; None: that of the housing.

    Raises
    ------
    SolverError
        If it is not a number, or above `STEEPEST`.

    Examples
    --------
    >>> check_misalignment(1.0)
    Traceback (most recent call last):
    pitchpoint.core.errors.SolverError: misalignment: 1.0 is out of range (limit -0.1 to 0.1 rad); give ...
    """
    if angle is None:
        return
    found = _numbers(angle)
    if found is None or found.ndim or not abs(found) <= STEEPEST:
        words = Message(
            "misalignment",
            "is out of range",
            repr(angle),
            f"-{STEEPEST:g} to {STEEPEST:g} rad",
            "give the gap in the plane of action over the common face width, such as 20e-6 / 0.03",
        )
        raise SolverError(words, INCONSISTENT)


def _numbers(value: Any) -> Array | None:
    """Real numbers as an array; None for texts, truth values and anything else."""
    try:
        found = np.asarray(value)
    except (TypeError, ValueError):  # rows of different lengths
        return None
    return found.astype(np.float64) if found.dtype.kind in "iuf" else None
