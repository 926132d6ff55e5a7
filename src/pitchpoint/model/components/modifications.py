# SPDX-License-Identifier: Apache-2.0
"""Flank modifications and deviations of a gear as a user states them: amounts, starts, shapes."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.keys import choice, component, integer, key, positive, quantities, quantity

SHAPES = ("linear", "parabolic")


@dataclass(frozen=True, kw_only=True)
class Relief:
    """Material taken off towards the tip or root of the flank."""

    amount: float = quantity("length", "material removed at the end of the flank, normal to it", minimum=0.0)
    start_diameter: float | None = positive("length", "diameter where the relief starts", None)
    length: float | None = positive("length", "length of the relief along the path of contact", None)
    shape: str = choice(SHAPES, "growth of the relief from its start", "linear")


@dataclass(frozen=True, kw_only=True)
class EndRelief:
    """Material taken off towards both ends of the face width."""

    amount: float = quantity("length", "material removed at the end of the tooth", minimum=0.0)
    length: float = positive("length", "length of the relief from each end")
    shape: str = choice(SHAPES, "growth of the relief from its start", "linear")


@dataclass(frozen=True, kw_only=True)
class FlankModifications:
    """Modifications of one kind of flank."""

    tip_relief: Relief | None = component(Relief, "relief at the tip")
    root_relief: Relief | None = component(Relief, "relief at the root")
    profile_crowning: float = quantity("length", "height of the profile crowning", 0.0)
    lead_crowning: float = quantity("length", "height of the crowning along the face width", 0.0)
    profile_slope: float = quantity("length", "profile slope over the active flank, > 0 adds at the tip", 0.0)
    helix_slope: float = quantity(
        "length", "helix slope over the face width, > 0 adds at the upper face", 0.0
    )
    end_relief: EndRelief | None = component(EndRelief, "relief at both ends of the teeth")


@dataclass(frozen=True, kw_only=True)
class Modifications:
    """Flank modifications by side, seen from the positive axis with the tooth pointing up.

    A side that is left out takes `both`; nothing is added up.
    """

    left: FlankModifications | None = component(FlankModifications, "left flanks")
    right: FlankModifications | None = component(FlankModifications, "right flanks")
    both: FlankModifications | None = component(FlankModifications, "both flanks")

    def side(self, name: str) -> FlankModifications | None:
        """Modifications of the 'left' or 'right' flanks."""
        own: FlankModifications | None = getattr(self, name)
        return own if own is not None else self.both


@dataclass(frozen=True, kw_only=True)
class Runout:
    """Eccentricity of the teeth against the axis of rotation."""

    amount: float = quantity("length", "runout, twice the eccentricity", minimum=0.0)
    phase: float = quantity("angle", "direction of the eccentricity from the centre of tooth 0", 0.0)


@dataclass(frozen=True, kw_only=True)
class FlankMap:
    """Measured deviation of one flank of one tooth on a regular grid."""

    tooth: int = integer("number of the tooth, from 0", minimum=0)
    flank: str = choice(("left", "right"), "flank of the tooth")
    values: tuple[tuple[float, ...], ...] = key(
        "grid",
        "deviation, rows from root to tip, columns along the face width; > 0 is more material",
        dimension="length",
    )


@dataclass(frozen=True, kw_only=True)
class Deviations:
    """Deviations of single teeth."""

    pitch: tuple[float, ...] = quantities(
        "length", "individual pitch deviations, one per tooth, or the name of a text file", ()
    )
    runout: Runout | None = component(Runout, "runout of the teeth")
    flank_maps: tuple[FlankMap, ...] = key("list", "measured flank maps", (), of=FlankMap)
