# SPDX-License-Identifier: Apache-2.0
"""Eccentric and wobbling gears: position and tilt of the gears on their bodies for the mesh element."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.mesh.eccentricity import displaced
from pitchpoint.model.components.gear_faults import Eccentricity, Wobble

if TYPE_CHECKING:
    from pitchpoint.model.components.gear import Gear


def is_displaced(gear: Gear) -> bool:
    """Whether a gear has eccentricity or wobble above zero."""
    seats = (fault for fault in gear.faults.values() if isinstance(fault, Eccentricity | Wobble))
    return any(fault.severity * fault.amount > 0.0 for fault in seats)


def set_displacements(
    row: Any, gears: Sequence[Gear], tooth_0: Sequence[float], keep: Callable[[NDArray[np.float64]], int]
) -> None:
    """Set the fields of displaced gears of a mesh record; unchanged for ideally mounted rigid gears.

    `tooth_0`: angles of the centres of teeth 0 at spin 0, from the x axes of the bodies [rad].
    """
    if any(is_displaced(gear) or gear.flexible_rim is not None for gear in gears):
        places = np.array([_place(g, angle) for g, angle in zip(gears, tooth_0, strict=True)])
        row["displaced"], row["seats"] = 1, keep(displaced(places))


def _place(gear: Gear, tooth_0: float) -> NDArray[np.float64]:
    """Displacement x, y [m] of the gear centre, and x, y of the gear axis (unit vector), in body axes."""
    shift, lean = 0j, 0j
    for fault in gear.faults.values():
        if not isinstance(fault, Eccentricity | Wobble):
            continue
        angle = tooth_0 + fault.phase
        towards = complex(math.cos(angle), math.sin(angle)) * fault.severity * fault.amount
        if isinstance(fault, Eccentricity):
            shift += towards
        else:
            lean += towards
    if lean:
        lean *= math.sin(abs(lean)) / abs(lean)
    return np.array([shift.real, shift.imag, lean.real, lean.imag])
