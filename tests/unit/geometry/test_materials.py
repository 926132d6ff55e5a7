# SPDX-License-Identifier: Apache-2.0
"""The material library."""

from __future__ import annotations

import math

import pytest

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.materials import LIBRARY, Material, material


def test_library_has_the_kinds_that_gears_are_made_of() -> None:
    assert {"steel", "grey_iron", "nodular_iron", "tin_bronze", "POM", "PA66"} <= set(LIBRARY)
    for name, entry in LIBRARY.items():
        assert entry.name == name
        assert entry.source
        assert 1e9 < entry.youngs_modulus < 2.2e11
        assert 1000.0 < entry.density < 9000.0


def test_steel_is_the_one_of_the_standard() -> None:
    # Z_E = sqrt(E / (2 pi (1 - nu^2))) = 189.8 sqrt(N/mm^2) for steel on steel (ISO 6336-2)
    steel = material("steel")
    z_e = math.sqrt(steel.youngs_modulus / (2.0 * math.pi * (1.0 - steel.poisson_ratio**2))) * 1e-3
    assert z_e == pytest.approx(189.812, abs=1e-3)


@pytest.mark.parametrize(
    ("name", "modulus", "density"),
    [
        # EN 1563, typical properties: E [GPa], rho [kg/dm^3]
        ("EN-GJS-400", 169.0, 7.1),
        ("EN-GJS-700", 176.0, 7.2),
        # EN 10088-1
        ("X20Cr13", 215.0, 7.7),
        # ISO 6336-2, elastic constants
        ("cast_steel", 202.0, 7.83),
        ("nodular_iron", 173.0, 7.1),
        ("EN-GJL-200", 118.0, 7.15),
        ("cast_tin_bronze", 103.0, 8.7),
        ("tin_bronze", 113.0, 8.8),
    ],
)
def test_printed_values(name: str, modulus: float, density: float) -> None:
    found = material(name)
    assert (found.youngs_modulus, found.density) == pytest.approx((modulus * 1e9, density * 1e3), rel=1e-12)


def test_unknown_names_get_the_nearest_spelling() -> None:
    with pytest.raises(GeometryError, match="did you mean nodular_iron"):
        material("nodular irn")


@pytest.mark.parametrize(
    "bad", [{"density": 0.0}, {"poisson_ratio": 0.5}, {"youngs_modulus": math.nan}, {"density": True}]
)
def test_impossible_properties_are_refused(bad: dict[str, float]) -> None:
    with pytest.raises(GeometryError):
        Material(**{"youngs_modulus": 2e11, "poisson_ratio": 0.3, "density": 7800.0, **bad})  # type: ignore[arg-type]
