# SPDX-License-Identifier: Apache-2.0
"""Wind of a model file."""

from __future__ import annotations

import math
from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.keys import choice, component, key, positive, quantity
from pitchpoint.model.wind.iec import GUSTS, Gust
from pitchpoint.model.wind.steady import PROFILES, SteadyWind


@dataclass(frozen=True, kw_only=True)
class WindGust(Component):
    """Transient of IEC 61400-1 with its amplitude."""

    shape: str = choice(GUSTS, "operating_gust, rise, vertical_shear or horizontal_shear")
    start: float = quantity("time", "begin of the transient", 0.0)
    duration: float = positive("time", "duration of the transient", sample="10.5 s")
    amplitude: float = quantity("speed", "amplitude of the speed", 0.0, sample="5 m/s")
    angle: float = quantity("angle", "rise: change of the direction", 0.0)
    diameter: float = positive("length", "shears: length over which the amplitude acts", 1.0, sample="126 m")

    @property
    def data(self) -> Gust:
        """The transient."""
        return Gust(
            shape=self.shape,
            start=self.start,
            duration=self.duration,
            amplitude=self.amplitude,
            angle=self.angle,
            diameter=self.diameter,
        )


@dataclass(frozen=True, kw_only=True)
class Wind(Component):
    """Wind over the height; x of the world is downwind for direction 0, z upward from the ground."""

    speed: float | None = quantity(
        "speed", "speed at the reference height", None, minimum=0.0, maximum=150.0, one_of="mean"
    )
    box: str | None = key(
        "file",
        "instead of speed: full-field turbulence of TurbSim (.bts), with the mean wind",
        None,
        one_of="mean",
    )
    height: float | None = quantity(
        "length",
        "reference height, that of the hub; required with speed",
        None,
        minimum=1.0,
        maximum=1000.0,
        also=("hub_height",),
    )
    profile: str = choice(PROFILES, "power law, logarithmic law, or the same speed at all heights", "power")
    exponent: float = quantity(
        "dimensionless", "exponent of the power law", 0.2, minimum=-1.0, maximum=1.0, also=("shear",)
    )
    roughness_length: float = quantity(
        "length", "roughness length of the logarithmic law", 0.03, minimum=1e-6, sample="30 mm"
    )
    inflow_angle: float = quantity(
        "angle", "angle of the wind above the horizontal plane", 0.0, minimum=-0.5, maximum=0.5
    )
    direction: float = quantity(
        "angle",
        "direction, from x towards y of the world",
        0.0,
        minimum=-2.0 * math.pi,
        maximum=2.0 * math.pi,
    )
    gust: WindGust | None = component(WindGust, "transient of the wind")

    @property
    def steady(self) -> SteadyWind | None:
        """The wind without transient; None with a box."""
        if self.speed is None or self.height is None:
            return None
        return SteadyWind(
            speed=self.speed,
            hub_height=self.height,
            profile=self.profile,
            exponent=self.exponent,
            roughness_length=self.roughness_length,
            inflow_angle=self.inflow_angle,
            direction=self.direction,
        )
