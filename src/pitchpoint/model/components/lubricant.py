# SPDX-License-Identifier: Apache-2.0
"""Lubricant of a gearbox."""

from __future__ import annotations

from dataclasses import dataclass, replace

from pitchpoint.contact import lubricant as oil
from pitchpoint.model.component import Component
from pitchpoint.model.keys import choice, positive, quantity, text

COLDEST, HOTTEST = 233.15, 473.15
"""Range of the temperature [K]: -40 to 200 °C."""
THICKEST = 0.1
"""Viscosity that no oil exceeds [m²/s]: 100 000 mm²/s, seventy times that of ISO VG 1500 at 40 °C."""


@dataclass(frozen=True, kw_only=True)
class Lubricant(Component):
    """Oil of all meshes, at one temperature."""

    name: str = text("name for reports", "")
    grade: str | None = choice(
        tuple(oil.GRADES), "viscosity grade to ISO 3448, with a viscosity index of 95", None
    )
    viscosity_at_40_degree_celsius: float | None = positive(
        "kinematic_viscosity",
        "kinematic viscosity at 40 °C",
        None,
        maximum=THICKEST,
        display="of the grade",
    )
    viscosity_at_100_degree_celsius: float | None = positive(
        "kinematic_viscosity",
        "kinematic viscosity at 100 °C",
        None,
        maximum=THICKEST,
        display="of the grade",
    )
    density_at_15_degree_celsius: float = quantity(
        "density", "density at 15 °C", 890.0, minimum=500.0, maximum=2500.0, sample="890 kg/m^3"
    )
    base: str = choice(tuple(oil.BASES), "base oil, for the pressure-viscosity coefficient", "mineral")
    pressure_viscosity: float | None = positive(
        "pressure_viscosity",
        "pressure-viscosity coefficient at the temperature",
        None,
        maximum=1e-6,
        display="of the base oil, to ISO/TR 15144-1",
    )
    temperature: float = quantity(
        "temperature",
        "temperature of the oil, that of the flanks in contact analyses",
        minimum=COLDEST,
        maximum=HOTTEST,
        also=("temperature_lubricant",),
    )

    @property
    def viscosities(self) -> tuple[float, float]:
        """Kinematic viscosity at 40 and 100 °C [m²/s]."""
        usual = oil.GRADES.get(self.grade or "", (0.0, 0.0))
        given = (self.viscosity_at_40_degree_celsius, self.viscosity_at_100_degree_celsius)
        at_40, at_100 = (own if own is not None else of for own, of in zip(given, usual, strict=True))
        return at_40, at_100

    @property
    def dynamic_viscosity(self) -> float:
        """Dynamic viscosity at the temperature [Pa s].

        Examples
        --------
        >>> round(1e3 * Lubricant(grade="ISO VG 320", temperature=343.15).dynamic_viscosity, 1)
        58.9
        """
        return oil.dynamic_viscosity(self.temperature, *self.viscosities, self.density_at_15_degree_celsius)

    @property
    def pressure_coefficient(self) -> float:
        """Pressure-viscosity coefficient at the temperature [1/Pa]."""
        if self.pressure_viscosity is not None:
            return self.pressure_viscosity
        at_38 = oil.dynamic_viscosity(
            oil.ZERO_CELSIUS + 38.0, *self.viscosities, self.density_at_15_degree_celsius
        )
        return oil.pressure_viscosity(self.temperature, at_38, self.base)

    def at(self, temperature: float | None) -> Lubricant:
        """The same oil at another temperature [K]; None: its own."""
        return self if temperature is None else replace(self, temperature=temperature)
