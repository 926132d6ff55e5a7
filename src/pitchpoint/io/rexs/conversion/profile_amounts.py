# SPDX-License-Identifier: Apache-2.0
"""Amounts of profile modifications between two diameters, converted to the whole usable flank."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from pitchpoint.core.units import parse_quantity
from pitchpoint.io.rexs.conversion.state import Conversion, q
from pitchpoint.io.rexs.document import RexsComponent

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    from pitchpoint.model.model import Model

POWER = {"profile_crowning": 2, "profile_slope": 1}
NEAR = 0.01
"""Relative difference of roll lengths that is rounding."""


@dataclass
class ProfileAmount:
    """Amount of a profile modification that the file gives between two diameters.

    Attributes
    ----------
    values, key
        Modifications of the flank for the model file, and the key of the amount.
    target
        Key of the modifications in the model file.
    component, diameters
        Component of the file, and the diameters at the root and at the tip [m].
    """

    values: dict[str, Any]
    key: str
    target: str
    component: RexsComponent | None = None
    diameters: tuple[float, float] = (0.0, 0.0)


def settle_profile_amounts(conversion: Conversion, model: Model) -> bool:
    """Convert the amounts that files give between two diameters; whether one has changed.

    Parameters
    ----------
    conversion
        The conversion.
    model
        The model with the amounts of the file, whose gears have the ends of the usable flanks.
    """
    changed = False
    for one in conversion.profile_amounts:
        gear = _gear_of(conversion, model, one)
        factor = 1.0 if gear is None else whole_flank(gear, one.diameters) ** POWER[one.key]
        if abs(factor - 1.0) < NEAR:
            continue
        amount = parse_quantity(one.values[one.key], "length")
        one.values[one.key] = q(float(f"{amount * factor:.6g}"), "length")
        changed = True
        low, high = (f"{1e3 * d:.6g}" for d in sorted(one.diameters))
        reason = (
            f"{1e6 * amount:.4g} um between the diameters {low} and {high} mm, here over the usable flank"
        )
        target = f"{one.target}.{one.key}"
        if one.component is not None:
            conversion.changed(one.component, one.key, str(one.values[one.key]), target, reason)
    return changed


def whole_flank(gear: CylindricalGear, diameters: tuple[float, float]) -> float:
    """Roll length of the usable flank over that between two diameters.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=50, m_n=3e-3)
    >>> round(whole_flank(gear, (abs(gear.d_Ff), abs(gear.d_Fa))), 12)
    1.0
    """
    from pitchpoint.geometry.modifications import flank_range, roll_length

    root, tip = flank_range(gear)
    one, two = (float(roll_length(gear, d)) for d in diameters)
    return abs(tip - root) / abs(two - one) if one != two else 1.0


def _gear_of(conversion: Conversion, model: Model, one: ProfileAmount) -> CylindricalGear | None:
    """Geometry of the gear of a modification by its key in the model file."""
    section, name, *keys = one.target.split(".")
    if section == "planetary_stages":
        stage = model.planetary_stages[name]
        name = stage.names[0] if keys[0] == "planet" else f"{stage.names[0]}-{keys[1]}"
    gear = model.gears.get(name)
    return None if gear is None else gear.geometry
