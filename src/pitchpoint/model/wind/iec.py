# SPDX-License-Identifier: Apache-2.0
"""Wind conditions of IEC 61400-1: classes, turbulence levels, extreme speeds, gusts and changes.

Edition 3 (IEC 61400-1:2005), clause 6.3; numbers and formulas agree with the program IECWind 5.01.02 of NREL,
which writes files for this edition.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from pitchpoint.model.wind.ranges import Ranges
from pitchpoint.model.wind.steady import SteadyWind

REFERENCE_SPEED = {"I": 50.0, "II": 42.5, "III": 37.5}
"""Reference wind speed V_ref of the classes [m/s], table 1."""
REFERENCE_INTENSITY = {"A": 0.16, "B": 0.14, "C": 0.12}
"""Expected turbulence intensity at 15 m/s I_ref of the categories, table 1."""
GUSTS = ("operating_gust", "rise", "vertical_shear", "horizontal_shear")
"""Shapes of transients over time."""


def turbulence_scale(hub_height: float) -> float:
    """Longitudinal turbulence scale Λ_1 [m] (IEC 61400-1:2005, equation 5).

    Examples
    --------
    >>> turbulence_scale(90.0), turbulence_scale(50.0)
    (42.0, 35.0)
    """
    return 0.7 * min(hub_height, 60.0)


@dataclass(frozen=True)
class WindClass:
    """Class of a wind turbine, such as IB.

    Parameters
    ----------
    turbine
        "I", "II" or "III".
    turbulence
        Category of turbulence: "A", "B" or "C".

    Examples
    --------
    >>> round(WindClass("I", "B").normal_deviation(12.0), 3)
    2.044
    >>> round(WindClass("I", "B").extreme_deviation(12.0), 3)
    3.123
    """

    turbine: str
    turbulence: str

    def __post_init__(self) -> None:
        found = Ranges("wind class")
        found.choice("turbine", self.turbine, tuple(REFERENCE_SPEED))
        found.choice("turbulence", self.turbulence, tuple(REFERENCE_INTENSITY))
        found.finish()

    @property
    def reference_speed(self) -> float:
        """Reference wind speed V_ref [m/s], ten-minute mean with a return period of 50 years."""
        return REFERENCE_SPEED[self.turbine]

    @property
    def reference_intensity(self) -> float:
        """Expected turbulence intensity at 15 m/s, I_ref."""
        return REFERENCE_INTENSITY[self.turbulence]

    def normal_deviation(self, speed: float) -> float:
        """Standard deviation σ_1 of the normal turbulence model [m/s] at a hub speed [m/s] (equation 11)."""
        return self.reference_intensity * (0.75 * speed + 5.6)

    def extreme_deviation(self, speed: float) -> float:
        """Standard deviation σ_1 of the extreme turbulence model [m/s] at a hub speed [m/s] (equation 19)."""
        c, mean = 2.0, 0.2 * self.reference_speed
        return c * self.reference_intensity * (0.072 * (mean / c + 3.0) * (speed / c - 4.0) + 10.0)

    def extreme_speed(self, years: int) -> float:
        """Extreme speed at hub height [m/s], mean over 3 s, with a return period of 1 or 50 years.

        V_e50 = 1.4 V_ref and V_e1 = 0.8 V_e50 (equations 14 and 15).
        """
        found = Ranges("wind class")
        found.choice("years", str(years), ("1", "50"))
        found.finish()
        return (1.0 if years == 50 else 0.8) * 1.4 * self.reference_speed

    def extreme_wind(self, hub_height: float, years: int) -> SteadyWind:
        """Steady extreme wind (EWM): the extreme speed with the exponent 0.11 over the height.

        Parameters
        ----------
        hub_height
            Height of the hub [m].
        years
            Return period, 1 or 50.

        Examples
        --------
        >>> round(WindClass("II", "A").extreme_wind(90.0, 50).speed, 6)
        59.5
        """
        return SteadyWind(speed=self.extreme_speed(years), hub_height=hub_height, exponent=0.11)


@dataclass(frozen=True, kw_only=True)
class Gust:
    """Transient of a steady wind, as a closed function of time.

    With s = (t - start)/duration from 0 to 1:

    * "operating_gust": speed -0.37 V sin(3 π s)(1 - cos(2 π s)), V the `amplitude`;
    * "rise": speed ½ V (1 - cos(π s)) and direction ½ θ (1 - cos(π s)), which remain afterwards;
    * "vertical_shear", "horizontal_shear": speed (z - z_hub)/D or y/D times V (1 - cos(2 π s)).

    Parameters
    ----------
    shape
        One of `GUSTS`.
    start, duration
        Begin and duration [s].
    amplitude
        V [m/s].
    angle
        Change of direction θ [rad], positive counter-clockwise seen from above.
    diameter
        Diameter of the rotor D [m].
    """

    shape: str
    start: float
    duration: float
    amplitude: float
    angle: float = 0.0
    diameter: float = 1.0

    def __post_init__(self) -> None:
        found = Ranges("gust")
        found.choice("shape", self.shape, GUSTS)
        found.within("start", self.start, -1e6, 1e6, "s")
        found.within("duration", self.duration, 0.1, 3600.0, "s")
        found.within("amplitude", self.amplitude, -100.0, 100.0, "m/s")
        found.within("angle", self.angle, -math.pi, math.pi, "rad")
        found.within("diameter", self.diameter, 0.1, 1000.0, "m")
        found.finish()


@dataclass(frozen=True)
class RotorSite:
    """What the gusts of a site depend on.

    Parameters
    ----------
    wind_class
        Class of the turbine.
    hub_height
        Height of the hub [m].
    diameter
        Diameter of the rotor [m].

    Examples
    --------
    Gust of the 5 MW turbine of NREL at 11.4 m/s:

    >>> site = RotorSite(WindClass("I", "B"), hub_height=90.0, diameter=126.0)
    >>> round(site.operating_gust(11.4).amplitude, 3)
    5.029
    >>> round(math.degrees(site.direction_change(11.4).angle), 2)
    30.45
    >>> round(site.wind_shear(11.4, "vertical").amplitude, 3)
    5.837
    >>> round(math.degrees(site.coherent_gust(11.4).angle), 2)
    63.16
    """

    wind_class: WindClass
    hub_height: float
    diameter: float

    def __post_init__(self) -> None:
        found = Ranges("rotor site")
        hub = found.within("hub_height", self.hub_height, 1.0, 1000.0, "m")
        found.within("diameter", self.diameter, 0.1, 2.0 * self.hub_height if hub else 1000.0, "m")
        found.finish()

    @property
    def _ratio(self) -> float:
        return self.diameter / turbulence_scale(self.hub_height)

    def _speed(self, speed: float) -> None:
        found = Ranges("rotor site")
        found.within("speed", speed, 0.1, self.wind_class.reference_speed, "m/s")
        found.finish()

    def operating_gust(self, speed: float, start: float = 0.0) -> Gust:
        """Extreme operating gust (EOG) of 10.5 s (equations 17 and 18).

        V_gust = min(1.35 (V_e1 - V_hub), 3.3 σ_1/(1 + 0.1 D/Λ_1)); the rise at its peak is 0.74 V_gust.

        Parameters
        ----------
        speed
            Speed at hub height V_hub [m/s].
        start
            Begin [s].
        """
        self._speed(speed)
        deviation = self.wind_class.normal_deviation(speed)
        by_extreme = 1.35 * (self.wind_class.extreme_speed(1) - speed)
        amplitude = min(by_extreme, 3.3 * deviation / (1.0 + 0.1 * self._ratio))
        return Gust(shape="operating_gust", start=start, duration=10.5, amplitude=amplitude)

    def direction_change(self, speed: float, start: float = 0.0, sign: int = 1) -> Gust:
        """Extreme direction change (EDC) within 6 s (equations 20 and 21).

        θ_e = 4 arctan(σ_1/(V_hub (1 + 0.1 D/Λ_1))), 180° at most.

        Parameters
        ----------
        speed
            Speed at hub height V_hub [m/s].
        start
            Begin [s].
        sign
            1 or -1: the side to which the wind turns.
        """
        self._speed(speed)
        deviation = self.wind_class.normal_deviation(speed)
        angle = min(4.0 * math.atan(deviation / (speed * (1.0 + 0.1 * self._ratio))), math.pi)
        return Gust(shape="rise", start=start, duration=6.0, amplitude=0.0, angle=math.copysign(angle, sign))

    def coherent_gust(self, speed: float, start: float = 0.0, sign: int = 1) -> Gust:
        """Extreme coherent gust with direction change (ECD) within 10 s (equations 22 to 25).

        The speed rises by 15 m/s, the direction changes by 180° up to 4 m/s, by 720° m/s / V_hub above.

        Parameters
        ----------
        speed
            Speed at hub height V_hub [m/s].
        start
            Begin [s].
        sign
            1 or -1: the side to which the wind turns.
        """
        self._speed(speed)
        angle = math.radians(720.0 / max(speed, 4.0))
        return Gust(
            shape="rise", start=start, duration=10.0, amplitude=15.0, angle=math.copysign(angle, sign)
        )

    def wind_shear(self, speed: float, direction: str, start: float = 0.0, sign: int = 1) -> Gust:
        """Extreme wind shear (EWS) of 12 s (equations 26 and 27).

        The amplitude is 2.5 m/s + 0.2 β σ_1 (D/Λ_1)^¼ with β = 6.4; at half time the speed at the edge of the
        rotor has changed by this amplitude.

        Parameters
        ----------
        speed
            Speed at hub height V_hub [m/s].
        direction
            "vertical" or "horizontal".
        start
            Begin [s].
        sign
            1: faster above, or at positive y; -1: slower there.
        """
        self._speed(speed)
        found = Ranges("rotor site")
        found.choice("direction", direction, ("vertical", "horizontal"))
        found.finish()
        deviation = self.wind_class.normal_deviation(speed)
        amplitude = 2.5 + 0.2 * 6.4 * deviation * self._ratio**0.25
        return Gust(
            shape=f"{direction}_shear",
            start=start,
            duration=12.0,
            amplitude=math.copysign(amplitude, sign),
            diameter=self.diameter,
        )
