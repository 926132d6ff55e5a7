# SPDX-License-Identifier: Apache-2.0
"""Values within their range that are far from usual ones: damping, materials, preload of bearings."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, remark
from pitchpoint.core.units import format_quantity

if TYPE_CHECKING:
    from pitchpoint.geometry.materials import Material
    from pitchpoint.model.components.own_material import OwnMaterial
    from pitchpoint.model.model import Model

OVERDAMPED = 1.0
"""Damping ratio from which a mesh does not vibrate."""

SOFT = 1e9
"""Modulus of elasticity below which a gear or shaft is not a solid of plastic or metal [Pa]."""

HARD = 1.3e12
"""Modulus of elasticity above which no material exists: diamond has 1.2e12 [Pa]."""
LIGHT, HEAVY = 500.0, 23000.0
"""Densities between which solid gears and shafts are [kg/m³]; osmium, the heaviest metal, has 22 600."""
SLENDER = 0.1
"""Poisson ratio below that of metals and plastics, 0.2 to 0.45."""

MEASURED = "0.03 to 0.17"
"""Damping ratios of gear meshes: Kasuba, Evans, An extended model for determining dynamic loads in spur
gearing, ASME J. Mech. Des. 103 (1981) 398-409."""


def overdamped_meshes(model: Model) -> Iterator[Message]:
    """A remark for every damping of a mesh above the critical one."""
    for name, mesh in model.every_mesh.items():
        for key in ("damper", "damping"):
            ratio = getattr(getattr(mesh, key), "ratio", None)
            if ratio is not None and ratio >= OVERDAMPED:
                yield remark(
                    f"{model.section_of(name)}.{name}.{key}.ratio",
                    f"{ratio:g} is {100.0 * ratio:.4g} % of the critical damping, so that the mesh does not "
                    f"vibrate; usual values are {MEASURED}",
                    f"write a ratio such as 0.05; {ratio:g} % are {ratio / 100.0:g}",
                )


def overdamped_supports(model: Model) -> Iterator[Message]:
    """A remark for every damping ratio of bearings and couplings above the critical one, and for coefficients
    that a ratio overrides."""
    for group in ("bearings", "couplings"):
        for name, part in getattr(model, group).items():
            ratio = None if part.damping is None else part.damping.ratio
            if ratio is None:
                continue
            if ratio >= OVERDAMPED:
                yield remark(
                    f"{group}.{name}.damping.ratio",
                    f"{ratio:g} is {100.0 * ratio:.4g} % of the critical damping",
                    f"write a ratio such as 0.02; {ratio:g} % are {ratio / 100.0:g}",
                )
            if any(value != 0.0 for row in part.damping.matrix6() for value in row):
                yield remark(
                    f"{group}.{name}.damping",
                    "has a ratio and coefficients: only the ratio has an effect",
                    "remove one of them",
                )


def odd_materials(model: Model) -> Iterator[Message]:
    """A remark for every property of a material that no solid gear or shaft has."""
    own: list[tuple[str, OwnMaterial | Material]] = [
        (f"materials.{name}", part) for name, part in model.materials.items()
    ]
    for group in ("gears", "shafts"):
        for name, part in getattr(model, group).items():
            if not isinstance(part.material, str) and part.material.name not in model.materials:
                own.append((f"{group}.{name}.material", part.material))
    for at, material in own:
        modulus, density = material.youngs_modulus, material.density
        if not SOFT <= modulus <= HARD:
            far = "below that of plastics" if modulus < SOFT else "above that of any material"
            yield remark(
                f"{at}.youngs_modulus",
                f"{format_quantity(modulus, 'pressure', 4)} is {far}, "
                f"{format_quantity(SOFT if modulus < SOFT else HARD, 'pressure', 4)}",
                "correct the value or its unit; steel has 210 GPa",
            )
        if not LIGHT <= density <= HEAVY:
            yield remark(
                f"{at}.density",
                f"{density:.4g} kg/m^3 is not that of a solid gear or shaft, {LIGHT:g} to {HEAVY:g} kg/m^3",
                "correct the value or its unit; steel has 7850 kg/m^3",
            )
        if material.poisson_ratio < SLENDER:
            yield remark(
                f"{at}.poisson_ratio",
                f"{material.poisson_ratio:g} is below that of metals and plastics, 0.2 to 0.45",
                "correct the value; steel has 0.3",
            )


def preloads_above_the_rating(model: Model) -> Iterator[Message]:
    """A remark for every axial preload above the static load rating.

    C0 is the load of a permanent deformation of 1e-4 of the element diameter (ISO 76).
    """
    for name, bearing in model.rolling_bearings.items():
        rating = bearing.geometry.static
        if bearing.preload is None or rating is None or bearing.preload <= rating:
            continue
        yield remark(
            f"rolling_bearings.{name}.preload",
            f"{format_quantity(bearing.preload, 'force', 4)} exceeds the static load rating C0 = "
            f"{format_quantity(rating, 'force', 4)} of the bearing; usual preloads are a few percent of C0",
            "correct the value or its unit",
        )
