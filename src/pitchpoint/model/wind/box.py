# SPDX-License-Identifier: Apache-2.0
"""Box of velocities over time and the plane of the rotor, which the mean wind carries downwind."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message
from pitchpoint.model.wind.ranges import Ranges


@dataclass(frozen=True, kw_only=True)
class BoxExtent:
    """Space and time that a box of turbulence covers.

    Parameters
    ----------
    half_width
        Largest lateral position [m]; infinite for one point along y.
    top
        Highest position above ground [m]; infinite for one point along z. Below its lowest row a box has the
        velocities of that row.
    duration
        Duration [s]; of one period if the box repeats.
    mean_speed, periodic, shift
        As for `WindBox`.
    """

    half_width: float
    top: float
    duration: float
    mean_speed: float
    periodic: bool
    shift: float

    def times_at(self, x: float) -> tuple[float, float]:
        """First and last time at which a box that does not repeat has velocities at a position x [m]."""
        first = (x - self.shift) / self.mean_speed
        return first, first + self.duration


@dataclass(frozen=True, kw_only=True, eq=False)
class WindBox:
    """Velocities on a grid over y and z, sampled in time.

    A pattern moves downwind with `mean_speed` (Taylor 1938): the velocity at (x, y, z, t) is that of the grid
    at the time t - (x - shift)/mean_speed.

    Parameters
    ----------
    velocity
        Velocities along x, y and z [m/s], shape (n_t, n_z, n_y, 3), float32; z from bottom to top, y from
        right to left for a view downwind. Along an axis with one point the wind is uniform.
    time_step
        Time between samples [s].
    spacing
        Distances of the grid along y and z [m].
    bottom
        Height of the lowest row above ground [m].
    hub_height
        Height of the hub [m].
    mean_speed
        Speed of convection [m/s].
    with_mean
        Whether the velocities contain the mean wind; otherwise they are fluctuations.
    periodic
        Whether the box repeats in time.
    shift
        Position along x of the samples at their own time [m].
    """

    velocity: NDArray[np.float32]
    time_step: float
    spacing: tuple[float, float]
    bottom: float
    hub_height: float
    mean_speed: float
    with_mean: bool = False
    periodic: bool = True
    shift: float = 0.0

    def __post_init__(self) -> None:
        found = Ranges("wind box")
        found.within("time_step", self.time_step, 1e-6, 1e4, "s")
        for name, value in zip(("y", "z"), self.spacing, strict=True):
            found.within(f"spacing in {name}", value, 1e-6, 1e4, "m")
        found.within("bottom", self.bottom, 0.0, 1e4, "m")
        found.within("hub_height", self.hub_height, 0.0, 1e4, "m")
        found.within("mean_speed", self.mean_speed, 1e-3, 200.0, "m/s")
        found.within("shift", self.shift, -1e6, 1e6, "m")
        v = self.velocity
        good = v.ndim == 4 and v.shape[-1] == 3 and v.size > 0 and v.dtype == np.float32
        if not (good and v.flags.c_contiguous):
            limit = "shape (n_t, n_z, n_y, 3), float32, C order"
            text = "is not an array of velocities"
            found.problems.append(
                Message("wind box.velocity", text, f"{v.dtype} {v.shape}", limit, "convert the array")
            )
        elif not np.isfinite([v.min(), v.max()]).all():
            remedy = "make the box again"
            found.problems.append(
                Message("wind box.velocity", "has values that are not finite", remedy=remedy)
            )
        found.finish()

    @property
    def duration(self) -> float:
        """Duration of the box [s]; of one period if it repeats."""
        n = self.velocity.shape[0]
        return (n if self.periodic else n - 1) * self.time_step

    @property
    def y(self) -> NDArray[np.float64]:
        """Lateral positions [m], shape (n_y,), centred."""
        n = self.velocity.shape[2]
        return np.asarray((np.arange(n) - 0.5 * (n - 1)) * self.spacing[0], float)

    @property
    def z(self) -> NDArray[np.float64]:
        """Heights [m], shape (n_z,)."""
        return np.asarray(self.bottom + np.arange(self.velocity.shape[1]) * self.spacing[1], float)

    @property
    def time(self) -> NDArray[np.float64]:
        """Times of the samples [s], shape (n_t,)."""
        return np.asarray(np.arange(self.velocity.shape[0]) * self.time_step, float)
