# SPDX-License-Identifier: Apache-2.0
"""Input of contact analyses, checked: torques, misalignments, numbers of positions, flanks, methods."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, SolverError
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.model.components.mesh import STEEPEST

Array = NDArray[np.float64]

POSITIONS = 4, 100_000
"""Least and largest number of mesh phases of a contact analysis; mesh orders need four."""
MAX_DEFLECTION = 0.5
"""Largest deflection of a mesh, in normal modules, five times the one from which runs give a note."""
METHODS = ("tangent", "finite_elements")
"""Methods of root stress; the second one includes the first."""


def refuse(*problems: Message | None, of: str = "") -> None:
    """Raise for problems, all of them in one error.

    Parameters
    ----------
    problems
        Problems; None: no problem.
    of
        What has them, for the beginning of the message.

    Raises
    ------
    SolverError
        If there is a problem.

    Examples
    --------
    >>> refuse(None, flank_problem(0), of="contact analysis")
    Traceback (most recent call last):
    pitchpoint.core.errors.SolverError: contact analysis: flank: 0 is not a flank (limit 1 or -1); give 1 ...
    """
    found = [str(problem) for problem in problems if problem is not None]
    if not found:
        return
    text = found[0] if len(found) == 1 else "\n  ".join([f"{len(found)} problems", *found])
    raise SolverError(f"{of}: {text}" if of else text, INCONSISTENT)


def torque_problem(torque: Any, *, several: bool = True) -> Message | None:
    """Problem of a torque on gear 1, or of several ones [N m]; None for finite numbers other than 0."""
    found = _numbers(torque)
    if found is None or found.ndim > 1 or not found.size or not np.all(np.isfinite(found) & (found != 0.0)):
        remedy = "give a number other than 0, in N m" + (", or several" if several else "")
        return Message("", f"torque {torque!r} is not a load", remedy=remedy)
    if found.size > 1 and not several:
        return Message("", f"torque {torque!r} has {found.size} values", remedy="give one")
    return None


def misalignment_problem(angle: Any) -> Message | None:
    """Problem of a misalignment in the plane of action [rad]; None: that of the housing."""
    return None if angle is None else angle_problem(angle)


def angle_problem(angle: Any) -> Message | None:
    """Problem of an angle between the flanks in the plane of action [rad]; there is none up to `STEEPEST`."""
    found = _numbers(angle)
    if found is not None and not found.ndim and abs(found) <= STEEPEST:
        return None
    return Message(
        "misalignment",
        "is out of range",
        repr(angle),
        f"-{STEEPEST:g} to {STEEPEST:g} rad",
        "give the gap in the plane of action over the common face width, such as 20e-6 / 0.03",
    )


def flank_problem(flank: Any) -> Message | None:
    """Problem of a flank: 1 and -1 have none."""
    if count_problem("flank", flank, -1) is None and flank in (1, -1):
        return None
    remedy = "give 1 for front flanks (gear 1 drives counter-clockwise), -1 for back flanks"
    return Message("flank", "is not a flank", repr(flank), "1 or -1", remedy)


def positions_problem(positions: Any, limits: tuple[int, int] = POSITIONS) -> Message | None:
    """Problem of a number of mesh phases over one base pitch."""
    return count_problem("positions", positions, *limits)


def count_problem(where: str, count: Any, least: int, most: float = math.inf) -> Message | None:
    """Problem of a whole number."""
    whole = isinstance(count, int | np.integer) and not isinstance(count, bool)
    if whole and least <= count <= most:
        return None
    limit = f"{least} to {most}" if math.isfinite(most) else f"at least {least}"
    return Message(where, "is out of range", repr(count), limit, "give a whole number")


def number_problem(
    where: str, value: Any, fits: Callable[[float], bool], limit: str, remedy: str
) -> Message | None:
    """Problem of a value that is not a finite number that fits; the limit in words includes the unit."""
    found = _numbers(value)
    if found is not None and not found.ndim and math.isfinite(found) and fits(float(found)):
        return None
    return Message(where, "is out of range", repr(value), limit, remedy)


def is_positive(value: float) -> bool:
    """Whether a number is above 0."""
    return value > 0.0


def deflection_problem(mesh: str, deflection: float, m_n: float, torque: float) -> Message | None:
    """Problem of a torque on gear 1 [N m] under which flanks approach by a deflection [m]."""
    if deflection <= MAX_DEFLECTION * m_n:
        return None
    return Message(
        "",
        f"torque {torque:.4g} N m deflects the flanks of {mesh} by {1e3 * deflection:.4g} mm",
        limit=f"half of the normal module, {1e3 * MAX_DEFLECTION * m_n:.4g} mm",
        remedy="give a smaller torque",
    )


def method_problem(method: Any) -> Message | None:
    """Problem of a method of root stress: None and `METHODS` have none."""
    if method is None or method in METHODS:
        return None
    return Message("", f"root_stress {method!r} is not a method", remedy=f"choose {' or '.join(METHODS)}")


def _numbers(value: Any) -> Array | None:
    """Real numbers as an array; None for texts, truth values and anything else."""
    try:
        found = np.asarray(value)
    except (TypeError, ValueError):  # rows of different lengths
        return None
    return found.astype(np.float64) if found.dtype.kind in "iuf" else None
