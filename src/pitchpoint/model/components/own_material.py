# SPDX-License-Identifier: Apache-2.0
"""Materials of a model: elastic properties and density with a name of their own."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.geometry.materials import Material
from pitchpoint.model.component import Component
from pitchpoint.model.keys import positive, quantity


@dataclass(frozen=True, kw_only=True)
class OwnMaterial(Component):
    """Properties of an isotropic elastic material."""

    youngs_modulus: float = positive(
        "pressure", "modulus E", also=("E", "elastic_modulus", "modulus_of_elasticity")
    )
    poisson_ratio: float = quantity(
        "dimensionless",
        "ratio of transverse to axial strain",
        minimum=0.0,
        maximum=0.5,
        below=True,
        sample="0.3",
        also=("nu", "poisson"),
    )
    density: float = positive("density", "mass per volume", also=("rho",))

    def named(self, name: str = "custom") -> Material:
        """The material with a name.

        Examples
        --------
        >>> OwnMaterial(youngs_modulus=7e10, poisson_ratio=0.33, density=2700.0).named("cast").name
        'cast'
        """
        return Material(
            name=name,
            youngs_modulus=self.youngs_modulus,
            poisson_ratio=self.poisson_ratio,
            density=self.density,
        )
