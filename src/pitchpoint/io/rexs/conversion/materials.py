# SPDX-License-Identifier: Apache-2.0
"""Materials of shafts and gears."""

from __future__ import annotations

from typing import Any

from pitchpoint.io.rexs.conversion.state import Conversion, q
from pitchpoint.io.rexs.document import RexsComponent

STEEL = "steel"


def material_of(conversion: Conversion, part: RexsComponent, target: str) -> Any:
    """Material of a part for the model file; steel if the part has none.

    Parameters
    ----------
    conversion
        The conversion.
    part
        The part.
    target
        Key of the material in the model file.
    """
    from pitchpoint.geometry.materials import material

    found = conversion.referenced(part, "material")
    if not found:
        conversion.default(part, "material", STEEL, target, "the part has no relation to a material")
        return STEEL
    one, steel = found[0], material(STEEL)
    conversion.done.add(one.id)
    values: dict[str, Any] = {}
    for key, attribute, dimension in (
        ("youngs_modulus", "elastic_modulus", "pressure"),
        ("poisson_ratio", "poisson_ratio", "dimensionless"),
        ("density", "density", "density"),
    ):
        value = conversion.number(one, attribute, f"{target}.{key}")
        if value is None:
            value = float(getattr(steel, key))
            conversion.default(one, attribute, str(q(value, dimension)), f"{target}.{key}", "that of steel")
        values[key] = q(value, dimension)
    return values


def density_of(conversion: Conversion, part: RexsComponent, target: str) -> float:
    """Density of a part [kg/m^3]; that of steel if it is not given."""
    from pitchpoint.geometry.materials import material

    for one in conversion.referenced(part, "material"):
        conversion.done.add(one.id)
        value = conversion.number(one, "density", target)
        if value is not None:
            return value
    density = material(STEEL).density
    conversion.default(part, "density", str(q(density, "density")), target, "that of steel")
    return density
