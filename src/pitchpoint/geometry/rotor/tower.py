# SPDX-License-Identifier: Apache-2.0
"""Tower of a wind turbine, as far as the wind at the rotor depends on it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, ModelError

FloatArray = NDArray[np.float64]


@dataclass(frozen=True, eq=False, kw_only=True)
class Tower:
    """Vertical tower with circular sections.

    Parameters
    ----------
    elevation
        Heights above ground, increasing, shape (n,) [m].
    diameter
        Diameters at these heights, shape (n,) [m].

    Raises
    ------
    ModelError
        If heights do not increase, or diameters are not positive.

    Examples
    --------
    >>> Tower(elevation=[0.0, 80.0], diameter=[6.0, 4.0]).radius_at(40.0).tolist()
    2.5
    """

    elevation: FloatArray
    diameter: FloatArray

    def __post_init__(self) -> None:
        for name in ("elevation", "diameter"):
            object.__setattr__(self, name, np.array(getattr(self, name), dtype=float))
        z, d = self.elevation, self.diameter
        problems = []
        if z.ndim != 1 or z.shape != d.shape or z.size < 2:
            shapes = f"{z.shape}, {d.shape}"
            problems.append(Message("tower", "are shapes of elevation and diameter", shapes, "(n,), n >= 2"))
        else:
            for k in np.flatnonzero(~(np.diff(z) > 0.0))[:1]:
                where, limit = f"tower.elevation, row {k + 2}", f"> {z[k]:g} m"
                problems.append(Message(where, "does not increase", f"{z[k + 1]:g} m", limit))
            for k in np.flatnonzero(~((d > 0.0) & np.isfinite(d)))[:1]:
                problems.append(
                    Message(f"tower.diameter, row {k + 1}", "is out of range", f"{d[k]:g} m", "> 0")
                )
        if problems:
            raise ModelError(problems)

    def radius_at(self, height: FloatArray | float) -> FloatArray:
        """Radius at heights of any shape, of the same shape [m]; zero above the tower."""
        inside = np.interp(height, self.elevation, self.diameter, right=0.0)
        return 0.5 * np.asarray(inside)
