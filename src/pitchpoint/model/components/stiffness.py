# SPDX-License-Identifier: Apache-2.0
"""Mesh stiffness laws of the model file; `contact/stiffness` evaluates them.

A new law is a class of this file, listed in `LAWS`, and a function of its name in `contact/stiffness`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar, TypeAlias

from pitchpoint.model.component import Component
from pitchpoint.model.components.law import PythonLaw
from pitchpoint.model.keys import choice, key, keys_of, positive, quantities, quantity

if TYPE_CHECKING:
    from pitchpoint.model.components.gear import Gear


def _ratio() -> float:
    value: float = quantity(
        "dimensionless",
        "ratio S_R of minimum to maximum stiffness of one pair; with 0 the stiffness is zero at A and E",
        0.8,
        minimum=0.0,
        maximum=1.0,
    )
    return value


def _relief() -> float:
    value: float = quantity(
        "dimensionless",
        "length of the ramps at A and E over frac(eps_alpha), T_R; 0: no ramps",
        0.0,
        minimum=0.0,
        maximum=1.0,
    )
    return value


class StiffnessLaw(Component):
    """Base class of the stiffness laws: the name of a law and the arguments of its function."""

    law: ClassVar[str]
    """Name in model files; also the name of the module in `contact.stiffness` and of its function."""
    of_pairs: ClassVar[bool] = False
    """Whether the law describes one tooth pair; all others give the stiffness of the whole mesh."""

    def options(self, gears: Sequence[Gear]) -> dict[str, Any]:
        """Arguments of the function besides the gear pair; by default the keys of the law."""
        return {name: getattr(self, name) for name in keys_of(type(self))}


def standard_options(gears: Sequence[Gear], virtual_teeth: str = "iso") -> dict[str, Any]:
    """Blank factor, moduli and formula of virtual teeth for the single stiffness by DIN 3990 / ISO 6336-1."""
    return {
        "C_R": min(gear.blank_factor for gear in gears),
        "moduli": tuple(gear.material_data.youngs_modulus for gear in gears),
        "virtual_teeth_formula": virtual_teeth,
    }


def _moduli(gears: Sequence[Gear]) -> dict[str, Any]:
    materials = [gear.material_data for gear in gears]
    return {
        "moduli": tuple(m.youngs_modulus for m in materials),
        "poisson": tuple(m.poisson_ratio for m in materials),
    }


@dataclass(frozen=True, kw_only=True)
class BevelDin3990(StiffnessLaw):
    """Single tooth stiffness by DIN 3990 of the virtual cylindrical gears, parabolic along the path."""

    law: ClassVar[str] = "din3990"
    of_pairs: ClassVar[bool] = True
    stiffness_ratio: float = _ratio()
    tip_relief_factor: float = _relief()
    single_stiffness: float | None = positive(
        "stiffness_per_width",
        "single tooth stiffness c' per face width",
        None,
        display="from the standard",
    )
    low_load: bool = key("boolean", "reduce the stiffness at specific loads below 100 N/mm", False)


@dataclass(frozen=True, kw_only=True)
class Din3990(BevelDin3990):
    """Single tooth stiffness by DIN 3990 / ISO 6336, parabolic along the path of contact."""

    virtual_teeth: str = choice(
        ("iso", "cos3"), "virtual number of teeth; iso: z/(cos^2 beta_b cos beta); cos3: z/cos^3 beta", "iso"
    )

    def options(self, gears: Sequence[Gear]) -> dict[str, Any]:
        """Arguments of the function, including the factors of the gears."""
        return {
            "S_R": self.stiffness_ratio,
            "T_R": self.tip_relief_factor,
            "c_prime": self.single_stiffness,
            "low_load": self.low_load,
            **standard_options(gears, self.virtual_teeth),
        }


@dataclass(frozen=True, kw_only=True)
class ConstantStiffness(StiffnessLaw):
    """Constant total mesh stiffness."""

    law: ClassVar[str] = "constant"
    value: float = positive("stiffness", "total mesh stiffness along the base tangent")

    def options(self, gears: Sequence[Gear]) -> dict[str, Any]:
        """Arguments of the function."""
        return {"mean": self.value}


@dataclass(frozen=True, kw_only=True)
class Rectangular(StiffnessLaw):
    """Total mesh stiffness that jumps between two values once per base pitch."""

    law: ClassVar[str] = "rectangular"
    high: float = positive("stiffness", "total stiffness with the larger number of tooth pairs")
    low: float = positive("stiffness", "total stiffness with the smaller number of tooth pairs")
    duty: float | None = quantity(
        "dimensionless",
        "duty cycle: fraction of the base pitch with the high value, from psi = 0",
        None,
        minimum=0.0,
        maximum=1.0,
        display="fractional part of eps_alpha",
    )


@dataclass(frozen=True, kw_only=True)
class Fourier(StiffnessLaw):
    """Total mesh stiffness as a Fourier series over the mesh phase."""

    law: ClassVar[str] = "fourier"
    mean: float = positive("stiffness", "mean total stiffness along the base tangent")
    cosine: tuple[float, ...] = quantities("dimensionless", "cosine amplitudes relative to the mean", ())
    sine: tuple[float, ...] = quantities("dimensionless", "sine amplitudes relative to the mean", ())


@dataclass(frozen=True, kw_only=True)
class Table(StiffnessLaw):
    """Total mesh stiffness as a table over one base pitch, linear between its equally spaced points."""

    law: ClassVar[str] = "table"
    values: tuple[float, ...] = quantities(
        "stiffness",
        "total stiffness along the base tangent at psi = 0, 1/n, ..., (n-1)/n",
        length=(2, 100000),
        minimum=0.0,
        above=True,
    )


@dataclass(frozen=True, kw_only=True)
class PairTable(StiffnessLaw):
    """Stiffness of one tooth pair as a table along the path of contact from A to E."""

    law: ClassVar[str] = "pair_table"
    of_pairs: ClassVar[bool] = True
    single_stiffness: float = positive("stiffness_per_width", "single tooth stiffness c' per face width")
    values: tuple[float, ...] = quantities(
        "dimensionless",
        "stiffness over c' at equally spaced points from A to E",
        length=(2, 100000),
        minimum=0.0,
    )
    tip_relief_factor: float = _relief()


@dataclass(frozen=True, kw_only=True)
class Energy(StiffnessLaw):
    """Stiffness by the energy method: bending, shear, axial, Hertz and body compliance of the tooth form."""

    law: ClassVar[str] = "energy"
    of_pairs: ClassVar[bool] = True
    tip_relief_factor: float = _relief()
    body: bool = key("boolean", "includes the compliance of the gear body", True)

    def options(self, gears: Sequence[Gear]) -> dict[str, Any]:
        """Arguments of the function, including materials and bores of the gears."""
        return {
            "T_R": self.tip_relief_factor,
            "bores": tuple(gear.bore_diameter or None for gear in gears),
            "body": "load_line" if self.body else "rigid",
            **_moduli(gears),
        }


@dataclass(frozen=True, kw_only=True)
class Hertz(StiffnessLaw):
    """Impact force K u^e of one tooth pair at the penetration u, constant along the path of contact.

    K from Hertz with the curvatures at the pitch point, or from `force` at `depth`.
    """

    law: ClassVar[str] = "hertz"
    of_pairs: ClassVar[bool] = True
    diameter: str = choice(
        ("reference", "operating"),
        "diameter of gear 1 in the formula of the curvature; reference is exact, operating is too large by "
        "the factor cos(alpha_t)/cos(alpha_wt)",
        "reference",
    )
    exponent: float = quantity(
        "dimensionless", "exponent e of the penetration", 1.5, minimum=1.0, maximum=5.0
    )
    force: float | None = positive(
        "force",
        "elastic force normal to the flanks at the penetration `depth`",
        None,
        display="by Hertz",
        needs="depth",
    )
    depth: float | None = positive(
        "length", "penetration normal to the flanks at which the force is `force`", None, needs="force"
    )
    tip_relief_factor: float = _relief()

    def options(self, gears: Sequence[Gear]) -> dict[str, Any]:
        """Arguments of the function, including the materials of the gears."""
        given = self.force is not None and self.depth is not None
        return {
            "diameter": self.diameter,
            "constant": self.force / self.depth**self.exponent if given else None,  # type: ignore[operator]
            "exponent": self.exponent,
            "T_R": self.tip_relief_factor,
            **_moduli(gears),
        }


@dataclass(frozen=True, kw_only=True)
class UserStiffness(StiffnessLaw):
    """Total mesh stiffness k(t, psi) from a user-defined Python function; requires --allow-code."""

    law: ClassVar[str] = "user"
    python: PythonLaw = key(
        "python", "'file.py:function' with f(t, psi, parameters) in N/m; t in s, psi in base pitches, 0 to 1"
    )


LAWS: dict[str, type[StiffnessLaw]] = {
    c.law: c
    for c in (
        Din3990,
        ConstantStiffness,
        Rectangular,
        Fourier,
        Table,
        PairTable,
        Energy,
        Hertz,
        UserStiffness,
    )
}

BevelStiffnessLaw: TypeAlias = BevelDin3990 | ConstantStiffness
BEVEL_LAWS: dict[str, type] = {c.law: c for c in (BevelDin3990, ConstantStiffness)}
"""Laws of bevel meshes."""

OF_PAIRS = tuple(sorted(name for name, found in LAWS.items() if found.of_pairs))
"""Laws that describe one tooth pair; all others give the stiffness of the whole mesh."""
