# SPDX-License-Identifier: Apache-2.0
"""Flank modifications and tooth deviations of a gear in the terms of the model file."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any

from pitchpoint.model.component import Component
from pitchpoint.model.keys import choice, component, integer, key, positive, quantities, quantity

if TYPE_CHECKING:
    from pitchpoint.geometry import deviations as real
    from pitchpoint.geometry import modifications as intended

SHAPES = ("linear", "parabolic")


@dataclass(frozen=True, kw_only=True)
class Relief(Component):
    """Relief of the flank towards the tip or root."""

    amount: float = quantity(
        "length", "material removed at the end of the flank, normal to it", minimum=0.0, sample="20 um"
    )
    start_diameter: float | None = positive(
        "length", "diameter where the relief starts", None, one_of="extent"
    )
    length: float | None = positive(
        "length", "length of the relief along the path of contact", None, one_of="extent"
    )
    shape: str = choice(SHAPES, "shape of the relief curve", "linear")


@dataclass(frozen=True, kw_only=True)
class EndRelief(Component):
    """Relief of the flank towards both ends of the face width."""

    amount: float = quantity(
        "length", "material removed at the end of the tooth, normal to the flank", minimum=0.0, sample="20 um"
    )
    length: float = positive("length", "length of the relief from each end")
    shape: str = choice(SHAPES, "shape of the relief curve", "linear")


@dataclass(frozen=True, kw_only=True)
class FlankModifications(Component):
    """Modifications of the left, the right or both flanks."""

    tip_relief: Relief | None = component(Relief, "relief at the tip")
    root_relief: Relief | None = component(Relief, "relief at the root")
    profile_crowning: float = quantity("length", "profile crowning", 0.0)
    lead_crowning: float = quantity("length", "crowning along the face width", 0.0)
    profile_slope: float = quantity(
        "length", "profile slope over the active flank, > 0 adds material at the tip", 0.0
    )
    helix_slope: float = quantity(
        "length", "helix slope over the face width, > 0 adds material at the end of the largest z", 0.0
    )
    end_relief: EndRelief | None = component(EndRelief, "relief at both ends of the teeth")

    def of_geometry(self) -> intended.FlankModifications:
        """Convert to the geometry layer; raise GeometryError for values that no flank can have."""
        from pitchpoint.geometry import modifications as target

        parts = {f.name: getattr(self, f.name) for f in fields(target.FlankModifications)}
        for name in ("tip_relief", "root_relief"):
            parts[name] = _as(target.Relief, parts[name])
        parts["end_relief"] = _as(target.EndRelief, parts["end_relief"])
        return target.FlankModifications(**parts)


@dataclass(frozen=True, kw_only=True)
class Modifications(Component):
    """Flank modifications by side, seen from the positive axis with the tooth pointing up.
    They require a stiffness law of single tooth pairs (din3990, energy, pair_table). An omitted side takes
    `both`; the two are not added.
    """

    left: FlankModifications | None = component(FlankModifications, "left flanks")
    right: FlankModifications | None = component(FlankModifications, "right flanks")
    both: FlankModifications | None = component(FlankModifications, "both flanks")

    def side(self, name: str) -> FlankModifications | None:
        """Modifications of the 'left' or 'right' flanks."""
        own: FlankModifications | None = getattr(self, name)
        return own if own is not None else self.both


@dataclass(frozen=True, kw_only=True)
class Runout(Component):
    """Eccentricity of the teeth against the axis of rotation."""

    amount: float = quantity("length", "runout, twice the eccentricity", minimum=0.0, sample="20 um")
    phase: float = quantity(
        "angle", "direction of the eccentricity, measured from the centre of tooth 0", 0.0
    )


@dataclass(frozen=True, kw_only=True)
class FlankMap(Component):
    """Measured deviation of one flank of one tooth on a regular grid."""

    tooth: int = integer("tooth number, counted from 0", minimum=0)
    flank: str = choice(("left", "right"), "flank of the tooth")
    values: tuple[tuple[float, ...], ...] = key(
        "grid",
        "deviation along the transverse base tangent, > 0 is excess material. Rows: equal steps of the "
        "length of roll from root form to tip form circle; columns: equal steps over the face width. Or the "
        "name of a text file with one row per line, numbers separated by commas, semicolons, tabs or "
        "blanks; a first line such as [um] gives the unit",
        dimension="length",
    )


@dataclass(frozen=True, kw_only=True)
class FlankPitch(Component):
    """Single pitch deviations that differ between left and right flanks; an omitted side has none."""

    left: tuple[float, ...] = quantities(
        "length", "left flanks: single pitch deviations, one per tooth, or the name of a text file", ()
    )
    right: tuple[float, ...] = quantities(
        "length", "right flanks: single pitch deviations, one per tooth, or the name of a text file", ()
    )


@dataclass(frozen=True, kw_only=True)
class Deviations(Component):
    """Deviations of single teeth, counted counter-clockwise from tooth 0."""

    pitch: tuple[float, ...] | FlankPitch = key(
        "pitch",
        "single pitch deviations f_p (ISO 1328-1; not cumulative), one per tooth: entry i is the excess of "
        "the pitch from tooth i - 1 to tooth i on the reference circle; a list or the name of a text file "
        "(one number per line, a first line such as [um] gives the unit) for both flanks, or {left: ..., "
        "right: ...}",
        (),
        dimension="length",
        of=FlankPitch,
    )
    runout: Runout | None = component(Runout, "runout of the teeth")
    flank_maps: tuple[FlankMap, ...] = key("list", "measured flank maps", (), of=FlankMap)

    def pitch_of(self, flank: str) -> tuple[float, ...]:
        """Single pitch deviations of the 'left' or 'right' flanks [m]; empty = none."""
        if isinstance(self.pitch, FlankPitch):
            own: tuple[float, ...] = getattr(self.pitch, flank)
            return own
        return self.pitch

    def of_geometry(self) -> real.Deviations:
        """Convert to the geometry layer."""
        from pitchpoint.geometry import deviations as target

        return target.Deviations(
            pitch=self.pitch_of("left"),
            pitch_right=self.pitch_of("right"),
            runout=_as(target.Runout, self.runout),
            flank_maps=[_as(target.FlankMap, one) for one in self.flank_maps],
        )


def _as(kind: type[Any], part: Any) -> Any:
    """Copy the fields into the dataclass `kind` of another layer."""
    return None if part is None else kind(**{f.name: getattr(part, f.name) for f in fields(kind)})
