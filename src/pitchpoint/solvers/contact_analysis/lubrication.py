# SPDX-License-Identifier: Apache-2.0
"""Oil film and flash temperature of a contact analysis at a speed, with the speeds of the flanks."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.film_thickness import film_thickness
from pitchpoint.contact.flash_temperature import STEEL, flash_temperature
from pitchpoint.contact.hertz import plane_strain_compliance
from pitchpoint.core.errors import Message
from pitchpoint.core.nomenclature import attributes
from pitchpoint.solvers.contact_analysis.load_checks import is_positive, number_problem, refuse

if TYPE_CHECKING:
    import xarray as xr

Array = NDArray[np.float64]

OVER = ("torque", "mesh_phase_position", "tooth_pair", "plane")
MINERAL = 20e-9
"""Pressure-viscosity coefficient, typical of mineral oils [1/Pa]."""


LIMITS: tuple[tuple[str, Callable[[float], bool], str, str], ...] = (
    ("speed", lambda value: value != 0.0, "not 0, in rad/s", "give the speed of gear 1, or None"),
    ("friction", lambda value: 0.0 <= value <= 2.0, "0 to 2", "give a coefficient such as 0.05, or None"),
    ("viscosity", is_positive, "above 0, in Pa s", "give the dynamic viscosity, such as 0.02, or None"),
    ("pressure_viscosity", is_positive, "above 0, in 1/Pa", "omit it, or give a value such as 20e-9"),
)
"""Operating conditions: names, tests, limits and remedies."""


@dataclass(frozen=True, kw_only=True)
class Operation:
    """Operating conditions for oil film, friction and flash temperature; None: not computed.

    Parameters
    ----------
    speed
        Speed of gear 1 [rad/s].
    friction
        Mean coefficient of friction [-].
    viscosity
        Dynamic viscosity at the temperature of the flanks [Pa s].
    pressure_viscosity
        Pressure-viscosity coefficient [1/Pa].
    thermal_contact
        Thermal contact coefficients of both gears [W s^0.5/(m² K)].

    Raises
    ------
    SolverError
        With all conditions that are out of range.
    """

    speed: float | None = None
    friction: float | None = None
    viscosity: float | None = None
    pressure_viscosity: float = MINERAL
    thermal_contact: tuple[float, float] = (STEEL, STEEL)

    def __post_init__(self) -> None:
        found = [
            number_problem(name, getattr(self, name), fits, limit, remedy)
            for name, fits, limit, remedy in LIMITS
            if getattr(self, name) is not None or name == "pressure_viscosity"
        ]
        if self.viscosity is not None and self.speed is None:
            found.append(Message("viscosity", "has no effect without a speed", remedy="give `speed`, too"))
        pair = self.thermal_contact
        if np.shape(pair) != (2,):
            remedy = "give those of gear 1 and gear 2"
            found.append(Message("thermal_contact", "is not a pair", repr(pair), "two numbers", remedy))
        else:
            limit, remedy = "above 0, in W s^0.5/(m² K)", "give that of a material, such as 13 795 of steel"
            found += [number_problem("thermal_contact", one, is_positive, limit, remedy) for one in pair]
        refuse(*found, of="operating conditions")


def with_operation(data: xr.Dataset, operation: Operation) -> xr.Dataset:
    """Add the coefficient of friction, speeds, film thickness and flash temperature to a contact analysis.

    Parameters
    ----------
    data
        Dataset of `solve_contact`.
    operation
        Operating conditions.

    Returns
    -------
    xarray.Dataset
        With `friction_coefficient` over the torque, and over the contact nodes `sliding_speed` and
        `rolling_speed` (mean of both flanks) [m/s], `film_thickness` [m], `flash_temperature` [K], as far as
        the operation defines them; the latter two are NaN where the pressure is unknown, and inside a base
        circle, where no involute has a radius of curvature.
    """
    found = data.copy()
    if operation.friction is not None:
        mu = np.full(data.sizes["torque"], operation.friction)
        found["friction_coefficient"] = ("torque",), mu, attributes("friction_coefficient")
    if operation.speed is None:
        return found
    load, roll_1, roll_2 = (_values(data, name) for name in ("line_load", "roll_1", "roll_2"))
    teeth = np.asarray(data["number_of_teeth"].values, dtype=np.float64)
    v_1 = abs(operation.speed) * roll_1
    v_2 = abs(operation.speed) * float(teeth[0] / teeth[1]) * roll_2
    soft = sum(
        plane_strain_compliance(float(E), float(nu))
        for E, nu in zip(data["youngs_modulus"].values, data["poisson_ratio"].values, strict=True)
    )
    pressure = np.fmax(_values(data, "pressure"), _values(data, "edge_pressure"))
    b_H = 2.0 * load / (math.pi * pressure)
    fields = {"sliding_speed": np.abs(v_1 - v_2), "rolling_speed": 0.5 * (v_1 + v_2)}
    on_involutes = np.minimum(roll_1, roll_2) > 0.0
    v_1, v_2 = np.where(on_involutes, (v_1, v_2), np.nan)
    if operation.viscosity is not None:
        radius = math.pi * b_H * b_H / (4.0 * load * soft)
        oil = (operation.viscosity, operation.pressure_viscosity)
        fields["film_thickness"] = film_thickness(load, radius, 0.5 * (v_1 + v_2), soft, *oil)
    if operation.friction is not None:
        fields["flash_temperature"] = flash_temperature(
            load, b_H, v_1, v_2, operation.friction, operation.thermal_contact
        )
    for name, values in fields.items():
        found[name] = OVER, values, attributes(name)
    return found


def _values(data: xr.Dataset, name: str) -> Array:
    return np.asarray(data[name].transpose(*OVER).values, dtype=np.float64)
