# SPDX-License-Identifier: Apache-2.0
"""Blades and rotors: stations along the blade and their position in the rotor."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.geometry.rotor.polar import Polar

FloatArray = NDArray[np.float64]


@dataclass(frozen=True, eq=False, kw_only=True)
class Blade:
    """Stations of a blade.

    The root frame of a blade has x downwind, z along the pitch axis to the tip, y = z × x, towards the
    trailing edge.

    Parameters
    ----------
    span
        Distances from the root along z, increasing, shape (n,) [m].
    chord
        Chord lengths, shape (n,) [m].
    twist
        Angles of the chord from the rotor plane at zero pitch, leading edge upwind positive, shape (n,)
        [rad].
    polars
        Polars of the blade.
    polar_index
        Index of the polar of each station, shape (n,).
    prebend, sweep
        Offsets of the stations along x and y, shape (n,) [m]; empty for zero.
    curve_angle
        Inclination of the blade axis towards x, shape (n,) [rad]; empty for that of `prebend`.

    Raises
    ------
    ModelError
        With all stations that describe no blade.

    Examples
    --------
    >>> plate = Polar(alpha=[-3.14159265359, 0.0, 3.14159265359], lift=[0, 0, 0], drag=[0.0, 0.01, 0.0])
    >>> blade = Blade(span=[0, 10], chord=[2, 1], twist=[0.1, 0.0], polars=[plate], polar_index=[0, 0])
    >>> blade.length
    10.0
    """

    span: FloatArray
    chord: FloatArray
    twist: FloatArray
    polars: Sequence[Polar]
    polar_index: NDArray[np.int64]
    prebend: FloatArray = field(default_factory=lambda: np.zeros(0))
    sweep: FloatArray = field(default_factory=lambda: np.zeros(0))
    curve_angle: FloatArray = field(default_factory=lambda: np.zeros(0))

    def __post_init__(self) -> None:
        for name in ("span", "chord", "twist", "prebend", "sweep", "curve_angle"):
            object.__setattr__(self, name, np.array(getattr(self, name), dtype=float))
        object.__setattr__(self, "polars", tuple(self.polars))
        object.__setattr__(self, "polar_index", np.array(self.polar_index, dtype=np.int64))
        for name in ("prebend", "sweep"):
            if getattr(self, name).size == 0:
                object.__setattr__(self, name, np.zeros(self.span.size))
        if self.curve_angle.size == 0 and self.span.size > 1 and self.prebend.shape == self.span.shape:
            slope = np.gradient(self.prebend, self.span) if (np.diff(self.span) > 0).all() else self.prebend
            object.__setattr__(self, "curve_angle", np.arctan(slope))
        if problems := list(self._problems()):
            raise ModelError(problems)

    def _problems(self) -> Any:
        """Everything that describes no blade."""
        shapes = {name: getattr(self, name).shape for name in ("span", "chord", "twist", "polar_index")}
        shapes |= {name: getattr(self, name).shape for name in ("prebend", "sweep", "curve_angle")}
        n = self.span.size
        if n < 2 or self.span.ndim != 1:
            yield Message("blade.span", "stations are too few", str(n), ">= 2", "give root and tip")
            return
        wrong = [name for name, shape in shapes.items() if shape != (n,)]
        for name in wrong:
            yield Message(f"blade.{name}", "is the shape", str(shapes[name]), f"({n},) as of span")
        for name in set(shapes) - set(wrong):
            bad = np.flatnonzero(~np.isfinite(getattr(self, name)))
            for k in bad[:1]:
                yield Message(f"blade.{name}, station {k + 1}", "is not finite", remedy="give a number")
        for k in np.flatnonzero(np.diff(self.span) <= 0)[:1]:
            yield Message(
                f"blade.span, station {k + 2}",
                "does not increase",
                f"{self.span[k + 1]:g} m",
                f"> {self.span[k]:g} m",
                "sort the stations from root to tip",
            )
        if "chord" not in wrong:
            for k in np.flatnonzero(self.chord <= 0)[:1]:
                yield Message(
                    f"blade.chord, station {k + 1}", "is out of range", f"{self.chord[k]:g} m", "> 0"
                )
        count = len(self.polars)
        if "polar_index" not in wrong:
            for k in np.flatnonzero((self.polar_index < 0) | (self.polar_index >= count))[:1]:
                value = str(self.polar_index[k] + 1)
                yield Message(
                    f"blade.polar_index, station {k + 1}",
                    "is not the number of a polar",
                    value,
                    f"1 to {count}" if count else "none is given",
                )
        for polar in self.polars:
            if not polar.complete:
                low, high = math.degrees(polar.alpha[0]), math.degrees(polar.alpha[-1])
                yield Message(
                    f"polar {polar.name}",
                    "is the range of the table",
                    f"{low:g} to {high:g} deg",
                    "-180 to 180 deg",
                    "use extrapolate_polar(polar)",
                )

    @property
    def length(self) -> float:
        """Distance of the last station from the root [m]."""
        return float(self.span[-1])


@dataclass(frozen=True, eq=False, kw_only=True)
class Rotor:
    """Rotor with identical blades on a horizontal, tilted axis.

    Parameters
    ----------
    blade
        Stations of a blade.
    blades
        Number of blades.
    hub_radius
        Distance of the blade root from the rotor axis, along the blade [m].
    precone
        Inclination of the blades from the rotor plane, positive upwind [rad].
    tilt
        Inclination of the axis, positive with the upwind end raised [rad].
    hub_height
        Height of the rotor centre above ground [m]; used for the wind profile and the tower.
    overhang
        Distance of the rotor centre from the axis of the tower, along the rotor axis, positive upwind [m];
        used for the tower.

    Raises
    ------
    ModelError
        If a value is out of range.

    Examples
    --------
    >>> plate = Polar(alpha=[-3.14159265359, 0.0, 3.14159265359], lift=[0, 0, 0], drag=[0.0, 0.01, 0.0])
    >>> blade = Blade(span=[0, 10], chord=[2, 1], twist=[0.1, 0.0], polars=[plate], polar_index=[0, 0])
    >>> round(Rotor(blade=blade, hub_radius=1.0, precone=0.1).tip_radius, 5)
    10.94505
    """

    blade: Blade
    blades: int = 3
    hub_radius: float
    precone: float = 0.0
    tilt: float = 0.0
    hub_height: float = 90.0
    overhang: float = 0.0

    def __post_init__(self) -> None:
        problems = []
        if self.blades < 1:
            problems.append(Message("rotor.blades", "is out of range", str(self.blades), ">= 1"))
        for name in ("hub_radius", "hub_height"):
            value = getattr(self, name)
            if not (0.0 < value < math.inf):
                problems.append(Message(f"rotor.{name}", "is out of range", f"{value:g} m", "> 0"))
        if not abs(self.overhang) < math.inf:
            problems.append(Message("rotor.overhang", "is not finite", remedy="give a number"))
        for name in ("precone", "tilt"):
            value = getattr(self, name)
            if not abs(value) < 0.5:
                shown = f"{math.degrees(value):g} deg"
                problems.append(
                    Message(f"rotor.{name}", "is out of range", shown, "-28.6 to 28.6 deg", "give radians")
                )
        if problems:
            raise ModelError(problems)
        if (self.radius <= 0.0).any():
            raise ModelError([Message("rotor.precone", "places stations on the rotor axis")])

    @cached_property
    def radius(self) -> FloatArray:
        """Distances of the stations from the rotor axis, shape (n,) [m]."""
        z = self.hub_radius + self.blade.span
        meridional = z * math.cos(self.precone) + self.blade.prebend * math.sin(self.precone)
        return np.hypot(meridional, self.blade.sweep)

    @cached_property
    def axial(self) -> FloatArray:
        """Positions of the stations along the axis, positive downwind, shape (n,) [m]."""
        z = self.hub_radius + self.blade.span
        return np.asarray(self.blade.prebend * math.cos(self.precone) - z * math.sin(self.precone))

    @cached_property
    def inclination(self) -> FloatArray:
        """Inclination of the blade axis from the rotor plane, positive upwind, shape (n,) [rad]."""
        return np.asarray(self.precone - self.blade.curve_angle)

    @property
    def tip_radius(self) -> float:
        """Distance of the last station from the axis [m]."""
        return float(self.radius[-1])

    @property
    def root_radius(self) -> float:
        """Distance of the blade root from the axis [m]."""
        return self.hub_radius * math.cos(self.precone)

    @property
    def area(self) -> float:
        """Swept area, π R² with the tip radius [m²]."""
        return math.pi * self.tip_radius**2
