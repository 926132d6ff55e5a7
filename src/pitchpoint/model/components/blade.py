# SPDX-License-Identifier: Apache-2.0
"""Blade of a wind turbine as lists: radius, chord, twist and airfoils."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.keys import key, positive, quantities


@dataclass(frozen=True, kw_only=True)
class BladePolar(Component):
    """Coefficients of an airfoil over the angle of attack, from -180° to 180°: a file, or lists."""

    file: str | None = key("file", "airfoil file of AeroDyn v15, instead of lists", None)
    angle: tuple[float, ...] = quantities("angle", "angles of attack, increasing", ())
    lift: tuple[float, ...] = quantities("dimensionless", "coefficients of lift at these angles", ())
    drag: tuple[float, ...] = quantities("dimensionless", "coefficients of drag", ())
    moment: tuple[float, ...] = quantities(
        "dimensionless",
        "coefficients of the pitching moment about the aerodynamic centre, nose up positive",
        (),
        display="0",
    )
    aspect_ratio: float | None = positive(
        "dimensionless",
        "length of the blade over its mean chord: continues a table that ends beyond stall to -180° and "
        "180° as a stalled flat plate (Viterna and Corrigan)",
        None,
    )

    @property
    def lists(self) -> dict[str, tuple[float, ...]]:
        """The lists that are given, by key."""
        return {name: values for name in LISTS if (values := getattr(self, name))}


LISTS = ("angle", "lift", "drag", "moment")
"""Lists of a polar."""


@dataclass(frozen=True, kw_only=True)
class BladeStations(Component):
    """Stations of a blade from the root to the tip; loads are linear between them and vanish at both ends."""

    radius: tuple[float, ...] = quantities(
        "length",
        "distances of the stations from the rotor axis along the pitch axis, increasing",
        length=(2, 1000),
        minimum=0.0,
        above=True,
        sample="[1.5 m, 20 m, 63 m]",
    )
    chord: tuple[float, ...] = quantities(
        "length",
        "chord lengths",
        length=(2, 1000),
        minimum=0.0,
        above=True,
        sample="[3.5 m, 4.5 m, 1.4 m]",
    )
    twist: tuple[float, ...] = quantities(
        "angle",
        "angles of the chord from the rotor plane, leading edge upwind positive",
        length=(2, 1000),
        minimum=-3.2,
        maximum=3.2,
        sample="[13 deg, 10 deg, 0 deg]",
    )
    airfoils: tuple[str, ...] = key(
        "names", "polar of each station", length=(2, 1000), sample="[cylinder, thick, thin]"
    )
    prebend: tuple[float, ...] = quantities(
        "length", "positions of the aerodynamic centres downwind of the pitch axis", (), display="0"
    )
    sweep: tuple[float, ...] = quantities(
        "length", "positions of the aerodynamic centres behind the pitch axis", (), display="0"
    )
    polars: Mapping[str, BladePolar] = key("components", "polars by name", of=BladePolar)
