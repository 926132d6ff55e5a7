# SPDX-License-Identifier: Apache-2.0
"""Wind field: steady wind, gust and box as one record for kernels, and velocities at points for Python."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import Message, ModelError, SolverError
from pitchpoint.core.kernel import invoke
from pitchpoint.core.status import OK, TABLE_RANGE, sentence
from pitchpoint.elements import wind as kernels
from pitchpoint.model.wind.box import WindBox
from pitchpoint.model.wind.iec import GUSTS, Gust
from pitchpoint.model.wind.steady import PROFILES, SteadyWind

if TYPE_CHECKING:
    from pitchpoint.system.system import System

Array = NDArray[np.float64]


class WindField:
    """Wind at points in space and time.

    The velocities are the sum of a steady wind with its gust and of a box of turbulence. Frame: x downwind at
    direction 0, y to the left for a view downwind, z upward from the ground.

    Parameters
    ----------
    steady
        Steady wind; None with a box that contains the mean wind.
    gust
        Transient of the steady wind.
    box
        Turbulence; its axes have the direction of the steady wind.

    Examples
    --------
    >>> field = WindField(SteadyWind(speed=10.0, hub_height=90.0, exponent=0.2))
    >>> field.velocity([[0.0, 0.0, 45.0]], 0.0).round(4)
    array([[8.7055, 0.    , 0.    ]])
    """

    def __init__(
        self, steady: SteadyWind | None = None, gust: Gust | None = None, box: WindBox | None = None
    ) -> None:
        self.steady, self.gust, self.box = steady, gust, box
        self._check()
        self.record = np.zeros(1, kernels.WIND)
        row = self.record[0]
        if steady is not None:
            row["speed"], row["z_hub"] = steady.speed, steady.hub_height
            row["profile"] = PROFILES.index(steady.profile)
            row["exponent"], row["roughness"] = steady.exponent, steady.roughness_length
            row["level"], row["rise"] = math.cos(steady.inflow_angle), math.sin(steady.inflow_angle)
            row["veer"] = steady.veer
        direction = steady.direction if steady is not None else 0.0
        row["cos"], row["sin"] = math.cos(direction), math.sin(direction)
        if gust is not None:
            row["gust"] = 1 + GUSTS.index(gust.shape)
            for name in ("start", "duration", "amplitude", "angle", "diameter"):
                row[name] = getattr(gust, name)
        if box is not None:
            row["box"] = box.velocity.ctypes.data
            row["n_t"], row["n_z"], row["n_y"], _ = box.velocity.shape
            row["dt"], (row["dy"], row["dz"]) = box.time_step, box.spacing
            row["bottom"], row["right"] = box.bottom, box.y[0]
            row["convection"], row["shift"] = box.mean_speed, box.shift
            row["periodic"] = int(box.periodic)
        self._query = np.zeros(1, kernels.QUERY)
        self._query["wind"] = self.record.ctypes.data

    def _check(self) -> None:
        problems = []
        if self.steady is None and self.box is None:
            problems.append(Message("wind", "has neither steady wind nor box", remedy="give one of them"))
        if self.gust is not None and self.steady is None:
            problems.append(Message("wind.gust", "has no steady wind to change", remedy="add a steady wind"))
        if self.box is not None and self.steady is not None and self.box.with_mean:
            remedy = "omit the steady wind, or use a box of fluctuations"
            problems.append(Message("wind.box", "contains the mean wind of its own", remedy=remedy))
        if problems:
            raise ModelError(problems)

    def __reduce__(self) -> tuple[type[WindField], tuple[object, ...]]:
        return WindField, (self.steady, self.gust, self.box)

    def velocity(self, positions: ArrayLike, t: float) -> Array:
        """Velocities [m/s], shape (n, 3).

        Parameters
        ----------
        positions
            Points [m], shape (n, 3).
        t
            Time [s].

        Raises
        ------
        SolverError
            If a point is outside the box.
        """
        at = np.ascontiguousarray(positions, float).reshape(-1, 3)
        found = np.empty_like(at)
        status = self.fill(at, t, found)
        if status != OK:
            raise SolverError(self._message(status, at[int(self._query["point"][0])], t), status)
        return found

    def fill(self, positions: Array, t: float, velocities: Array) -> int:
        """Write velocities into an array without allocating any; returns the status.

        Parameters
        ----------
        positions
            Points [m], shape (n, 3), float64 in C order.
        t
            Time [s].
        velocities
            Result [m/s], shape (n, 3), float64 in C order.
        """
        for array in (positions, velocities):
            if array.dtype != np.float64 or array.ndim != 2 or not array.flags.c_contiguous:
                raise ModelError([_not_an_array(array)])
        if positions.shape[1] != 3 or velocities.shape != positions.shape:
            raise ModelError([_not_an_array(velocities)])
        query = self._query[0]
        query["positions"], query["velocities"] = positions.ctypes.data, velocities.ctypes.data
        query["t"] = t
        return invoke(kernels.evaluate_wind, 0, self._query.ctypes.data, len(positions))

    def _message(self, status: int, point: Array, t: float) -> str:
        place = "wind at x {:g}, y {:g}, z {:g} m, t {:g} s".format(*point, t)
        if status != TABLE_RANGE or self.box is None:
            return f"{place}: {sentence(status)}"
        box = self.box
        limit = f"y {box.y[0]:g} to {box.y[-1]:g} m, z to {box.z[-1]:g} m"
        if not box.periodic:
            limit += f", t - (x - {box.shift:g} m)/({box.mean_speed:g} m/s) from 0 to {box.duration:g} s"
        return str(Message(place, "is outside the box of turbulence", None, limit, "use a larger box"))


def _not_an_array(array: NDArray[np.generic]) -> Message:
    limit = "two arrays of shape (n, 3), float64, C order"
    return Message(
        "wind", "is not an array of points", f"{array.dtype} {array.shape}", limit, "convert the array"
    )


def add_mean(box: WindBox, steady: SteadyWind) -> WindBox:
    """Box of velocities with the mean wind, as files of TurbSim contain it.

    Parameters
    ----------
    box
        Fluctuations.
    steady
        Mean wind, in the direction of the box.

    Raises
    ------
    ModelError
        If the box contains the mean wind already, or the steady wind has another direction.
    """
    if box.with_mean or steady.direction != 0.0:
        text = "contains the mean wind already" if box.with_mean else "has the direction of the steady wind"
        raise ModelError([Message("wind box", text, remedy="use fluctuations and direction 0")])
    y, z = np.meshgrid(box.y, box.z)
    at = np.stack([np.zeros_like(y), y, z], axis=-1).reshape(-1, 3)
    mean = WindField(steady).velocity(at, 0.0).reshape(*y.shape, 3)
    return replace(box, velocity=(box.velocity + mean).astype(np.float32), with_mean=True)


def has_wind(system: System) -> bool:
    """Whether a system has rotors in the wind."""
    return any("wind" in (bank.dtype.names or ()) for bank in system.records.values())


def with_wind(system: System, factor: float) -> System:
    """Copy of a system with all steady winds and gusts multiplied by a factor, in the same directions.

    Boxes of turbulence are unchanged.

    Parameters
    ----------
    system
        The system.
    factor
        The factor.
    """
    found = system.copy()
    for bank in found.records.values():
        if "wind" in (bank.dtype.names or ()):
            for field in ("level", "rise"):
                bank["wind"][field] *= factor
    return found
