# SPDX-License-Identifier: Apache-2.0
"""Description of turbulence with Kaimal spectra and exponential coherence."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.core.errors import Message
from pitchpoint.model.wind.ranges import Ranges

LARGEST = 4 << 30
"""Maximum memory of a box [bytes]."""


@dataclass(frozen=True, kw_only=True)
class KaimalTurbulence:
    """Turbulence of IEC 61400-1 on a grid around the hub.

    Parameters
    ----------
    mean_speed
        Mean speed at hub height [m/s].
    deviation
        Standard deviation σ_1 of the longitudinal velocity [m/s]; the lateral one has 0.8, the vertical one
        0.5 of it.
    hub_height
        Height of the hub, centre of the grid [m].
    size
        Width and height of the grid [m].
    points
        Number of grid points along y and z.
    duration, time_step
        Duration and time step [s]; the box repeats after its duration.
    coherent
        Components with coherence: "u" as in the standard, or "uvw", where v and w have coherence lengths in
        the ratio of their integral scales.

    Examples
    --------
    >>> wind = KaimalTurbulence(mean_speed=12.0, deviation=1.8, hub_height=90.0, size=(150.0, 150.0),
    ...                         points=(31, 31), duration=600.0, time_step=0.05)
    >>> wind.samples
    12000
    """

    mean_speed: float
    deviation: float
    hub_height: float
    size: tuple[float, float]
    points: tuple[int, int]
    duration: float
    time_step: float
    coherent: str = "u"

    def __post_init__(self) -> None:
        found = Ranges("turbulence")
        found.within("mean_speed", self.mean_speed, 0.1, 150.0, "m/s")
        found.within("deviation", self.deviation, 0.0, 50.0, "m/s")
        hub = found.within("hub_height", self.hub_height, 1.0, 1000.0, "m")
        found.within("width", self.size[0], 0.0, 10_000.0, "m")
        found.within("height", self.size[1], 0.0, 2.0 * self.hub_height if hub else 2000.0, "m")
        good = [found.count(f"points in {n}", p, 1, 1000) for n, p in zip("yz", self.points, strict=True)]
        for name, length, number in zip(("width", "height"), self.size, self.points, strict=True):
            if all(good) and (number > 1) != (length > 0.0):
                text = f"has a {name} that contradicts its number of points"
                remedy = "write 0 m for one point, a length for several"
                found.problems.append(
                    Message("turbulence", text, f"{length:g} m, {number} points", None, remedy)
                )
        step = found.within("time_step", self.time_step, 1e-4, 100.0, "s")
        longest = found.within("duration", self.duration, 0.01, 1e6, "s")
        found.choice("coherent", self.coherent, ("u", "uvw"))
        if step and longest and all(good):
            needed = self.samples * self.points[0] * self.points[1] * 12
            if self.samples < 4:
                remedy = "use a shorter time step or a longer duration"
                found.problems.append(
                    Message("turbulence", "are too few", f"{self.samples} samples", "4", remedy)
                )
            if needed > LARGEST:
                remedy = "use fewer points or samples"
                value = f"{needed / 2**30:.1f} GiB"
                limit = f"{LARGEST / 2**30:.0f} GiB"
                found.problems.append(Message("turbulence", "are needed for the box", value, limit, remedy))
        found.finish()

    @property
    def samples(self) -> int:
        """Number of samples in time."""
        return round(self.duration / self.time_step)
