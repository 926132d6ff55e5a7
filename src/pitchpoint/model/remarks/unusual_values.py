# SPDX-License-Identifier: Apache-2.0
"""Values within their range that are far from usual ones: damping of meshes, preload of bearings."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, remark
from pitchpoint.core.units import format_quantity

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

OVERDAMPED = 1.0
"""Damping ratio from which a mesh does not vibrate."""

SOFT = 1e9
"""Modulus of elasticity below which a gear or shaft is not a solid of plastic or metal [Pa]."""

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


def soft_materials(model: Model) -> Iterator[Message]:
    """A remark for every material with a modulus of elasticity that no solid gear or shaft has."""
    own: list[tuple[str, float]] = [
        (f"materials.{name}", part.youngs_modulus) for name, part in model.materials.items()
    ]
    for group in ("gears", "shafts"):
        for name, part in getattr(model, group).items():
            if not isinstance(part.material, str):
                own.append((f"{group}.{name}.material", part.material_data.youngs_modulus))
    for at, modulus in own:
        if modulus < SOFT:
            yield remark(
                f"{at}.youngs_modulus",
                f"{format_quantity(modulus, 'pressure', 4)} is below that of plastics, "
                f"{format_quantity(SOFT, 'pressure', 4)}",
                "correct the value or its unit; steel has 210 GPa",
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
