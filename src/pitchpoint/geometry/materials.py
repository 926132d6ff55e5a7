# SPDX-License-Identifier: Apache-2.0
"""Elastic properties and densities of gear materials.

The constants are the usual values at 20 °C. E and ν of steels, grey irons and tin bronzes are those of the
table of elastic constants in ISO 6336-2 and DIN 3990-2 (steel 206 GPa, cast steel 202 GPa, nodular iron
173 GPa, grey iron 118 to 126 GPa, tin bronze 103 to 113 GPa; ν = 0.3), so that Z_E and c' agree with gear
rating. The values of nodular grades are those of EN 1563. The modulus of grey iron decreases with stress,
EN 1561 gives 88 to 118 GPa for the grades here; that of plastics decreases steeply with temperature, that of
polyamides with humidity: use measured values where it matters.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from pitchpoint.core.errors import GeometryError
from pitchpoint.core.nearest import did_you_mean
from pitchpoint.core.plain_numbers import real_number


@dataclass(frozen=True, kw_only=True)
class Material:
    """An isotropic elastic material.

    Parameters
    ----------
    name
        Name in the library, or any other name for a user-defined material; materials of equal properties are
        equal.
    youngs_modulus
        E [Pa], > 0.
    poisson_ratio
        ν [-], 0 ≤ ν < 0.5.
    density
        ρ [kg/m³], > 0.
    source
        Source of the values.

    Raises
    ------
    GeometryError
        If a value is outside these limits.

    Examples
    --------
    >>> Material(name="own", youngs_modulus=2.0e11, poisson_ratio=0.28, density=7800.0).shear_modulus
    78125000000.0
    """

    name: str = field(default="custom", compare=False)
    youngs_modulus: float
    poisson_ratio: float
    density: float
    source: str = ""

    def __post_init__(self) -> None:
        for where, low, high, limit in (
            ("youngs_modulus", 0.0, math.inf, "above 0"),
            ("poisson_ratio", -1e-300, 0.5, "from 0, below 0.5"),
            ("density", 0.0, math.inf, "above 0"),
        ):
            value = getattr(self, where)
            if (number := real_number(value)) is None or not low < number < high:
                raise GeometryError(
                    "is not a property of a material", where=where, value=f"{value!r}", limit=limit
                )

    @property
    def shear_modulus(self) -> float:
        """G = E / (2 (1 + ν)) [Pa]."""
        return 0.5 * self.youngs_modulus / (1.0 + self.poisson_ratio)


_STEEL = "E, ν: ISO 6336-2; ρ: 7830 kg/m³ as in KISSsoft's gear reports"
_GREY = "E, ν: ISO 6336-2; ρ: EN 1561, typical"
_BRONZE = "E, ν: ISO 6336-2; ρ: typical of CuSn12 in EN 1982 and CuSn8 in EN 12163 (8.7 to 8.8 g/cm³)"

_ROWS: tuple[tuple[str, float, float, float, str], ...] = (
    ("steel", 206e9, 0.30, 7830.0, _STEEL),
    ("16MnCr5", 206e9, 0.30, 7830.0, _STEEL),
    ("18CrNiMo7-6", 206e9, 0.30, 7830.0, _STEEL),
    ("20MnCr5", 206e9, 0.30, 7830.0, _STEEL),
    ("42CrMo4", 206e9, 0.30, 7830.0, _STEEL),
    ("34CrNiMo6", 206e9, 0.30, 7830.0, _STEEL),
    ("C45", 206e9, 0.30, 7830.0, _STEEL),
    ("X20Cr13", 215e9, 0.30, 7700.0, "E, ρ: EN 10088-1, martensitic stainless steel"),
    ("cast_steel", 202e9, 0.30, 7830.0, _STEEL),
    ("grey_iron", 118e9, 0.30, 7200.0, _GREY),
    ("EN-GJL-200", 118e9, 0.30, 7150.0, _GREY),
    ("EN-GJL-250", 126e9, 0.30, 7200.0, _GREY),
    ("nodular_iron", 173e9, 0.30, 7100.0, "E, ν: ISO 6336-2; ρ: EN 1563, typical"),
    ("EN-GJS-400", 169e9, 0.275, 7100.0, "EN 1563, typical properties"),
    ("EN-GJS-700", 176e9, 0.275, 7200.0, "EN 1563, typical properties"),
    ("cast_tin_bronze", 103e9, 0.30, 8700.0, _BRONZE),
    ("tin_bronze", 113e9, 0.30, 8800.0, _BRONZE),
    ("aluminium_bronze", 118e9, 0.34, 7600.0, "typical of CuAl10Fe5Ni5 in EN 1982"),
    ("POM", 2.8e9, 0.35, 1410.0, "makers' data, 23 °C; copolymers 2.5 to 2.9 GPa, homopolymers 3.0 GPa"),
    ("PA66", 3.0e9, 0.38, 1140.0, "makers' data, dry, 23 °C; half of it at 50 % humidity"),
)

LIBRARY: dict[str, Material] = {
    name: Material(name=name, youngs_modulus=e, poisson_ratio=nu, density=rho, source=source)
    for name, e, nu, rho, source in _ROWS
}
"""Materials by name; "steel" is the default of the model."""


def material(name: str) -> Material:
    """Look up a material of the library.

    Parameters
    ----------
    name
        A key of `LIBRARY`; case, blanks, hyphens and underscores are ignored.

    Raises
    ------
    GeometryError
        If the library does not have the material; the message suggests the nearest spelling.

    Examples
    --------
    >>> material("en-gjs-400").youngs_modulus, material("POM").density
    (169000000000.0, 1410.0)
    """
    if name in LIBRARY:
        return LIBRARY[name]
    plain = {_plain(known): known for known in LIBRARY}
    found = plain.get(_plain(name))
    if found is None:
        raise GeometryError(
            "is not a material of the library",
            where="material",
            value=repr(name),
            remedy=f"{did_you_mean(name, LIBRARY)}known are {', '.join(LIBRARY)}",
        )
    return LIBRARY[found]


def _plain(name: str) -> str:
    return "".join(c for c in str(name).lower() if c not in " -_")
