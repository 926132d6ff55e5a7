# SPDX-License-Identifier: Apache-2.0
"""Tooth faults in the terms of the model file: location, size, severity."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from pitchpoint.model.component import Component
from pitchpoint.model.keys import choice, component, integer, key, positive, quantity

if TYPE_CHECKING:
    from pitchpoint.geometry import pits
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

ENDS = ("start", "end")
SHAPES = ("straight", "corner")


def _tooth() -> Any:
    return integer("tooth number, counted counter-clockwise from tooth 0", minimum=0)


def _flank(meaning: str) -> Any:
    return choice(("left", "right", "both"), meaning)


def _severity(meaning: str) -> Any:
    return quantity("dimensionless", meaning, 1.0, minimum=0.0, maximum=1.0)


@dataclass(frozen=True, kw_only=True)
class BrokenTooth(Component):
    """A broken tooth: a corner, one end, a band along the tip or the whole tooth is missing.

    An omitted size is that of the whole tooth.
    """

    form: ClassVar[str] = "broken_tooth"
    tooth: int = _tooth()
    at: str = choice(
        ENDS,
        "end of the face width from which `width` is measured; start: the end of the smallest z",
        "start",
    )
    width: float | None = positive(
        "length", "missing width at the tip, along the face", None, display="the whole face"
    )
    height: float | None = positive(
        "length",
        "missing height at the end of the face, radially from the tip",
        None,
        display="the whole tooth",
    )
    shape: str = choice(
        SHAPES,
        "missing area; straight: rectangle of width and height; corner: triangle of width and height",
        "straight",
    )
    severity: float = _severity("scales the given sizes, or the height if none is given")

    def sizes(self, face_width: float, tooth_height: float) -> tuple[float, float]:
        """Missing width and height [m]; omitted sizes are those of the whole tooth."""
        width, height = self.width or face_width, self.height or tooth_height
        scaled = self.shape == "corner"
        if scaled or self.width is not None:
            width *= self.severity
        if scaled or self.height is not None or self.width is None:
            height *= self.severity
        return width, height


@dataclass(frozen=True, kw_only=True)
class PitchError(Component):
    """Pitch error of one tooth: both flanks are displaced by the same amount."""

    form: ClassVar[str] = "pitch_error"
    tooth: int = _tooth()
    amount: float = quantity(
        "length",
        "displacement of the tooth on the reference circle, counter-clockwise positive",
        sample="10 um",
    )
    severity: float = _severity("scales the amount")


@dataclass(frozen=True, kw_only=True)
class BrokenBevelTooth(Component):
    """A broken tooth of a bevel gear: one end or the whole tooth is missing."""

    form: ClassVar[str] = "broken_tooth"
    tooth: int = _tooth()
    at: str = choice(("outer", "inner"), "end of the face from which `width` is measured", "outer")
    width: float | None = positive(
        "length", "missing width along the pitch cone", None, display="the whole face"
    )
    severity: float = _severity("scales the width")

    def left(self, R_i: float, R_e: float) -> tuple[float, float]:
        """Cone distances [m] of the ends of the remaining tooth; nothing remains if they cross."""
        missing = self.severity * (R_e - R_i if self.width is None else self.width)
        return (R_i, R_e - missing) if self.at == "outer" else (R_i + missing, R_e)


@dataclass(frozen=True, kw_only=True)
class RootCrack(Component):
    """A tooth root crack, which reduces the stiffness under loads that open it."""

    form: ClassVar[str] = "root_crack"
    tooth: int = _tooth()
    flank: str = _flank(
        "flank at whose root the crack starts: loads on this flank open it, loads on the other close it"
    )
    depth: float = positive("length", "maximum depth: length of the crack in the transverse section")
    angle: float = quantity(
        "angle",
        "angle between the crack and the centre line of the tooth",
        math.radians(70.0),
        minimum=math.radians(10.0),
        maximum=math.radians(90.0),
        display="70 deg",
    )
    length: float | None = positive(
        "length",
        "length along the face over which the depth decreases to zero; constant depth if omitted",
        None,
        display="the whole face, constant depth",
    )
    at: str = choice(ENDS, "with `length`: end of the face width where the crack is deepest", "start")
    severity: float = _severity("scales the depth")


@dataclass(frozen=True, kw_only=True)
class Patch(Component):
    """A pit or spall with an elliptical outline, deepest at its centre."""

    position: float = quantity("length", "centre along the face width, from its start", minimum=0.0)
    diameter: float = positive("length", "diameter of the centre on the flank")
    length: float = positive("length", "axis of the ellipse along the face")
    height: float = positive("length", "axis of the ellipse along the profile, radially")
    depth: float = positive("length", "depth at the centre, normal to the flank")


@dataclass(frozen=True, kw_only=True)
class Pattern(Component):
    """Pits at uniformly distributed random positions, of 0.5 to 1 times the given sizes."""

    number: int = integer("number of pits", minimum=1, maximum=10000)
    seed: int = integer("seed of the random numbers; the same seed gives the same pits", 0, minimum=0)
    length: float = positive("length", "largest axis along the face")
    height: float = positive("length", "largest axis along the profile, radially")
    depth: float = positive("length", "largest depth, normal to the flank")


@dataclass(frozen=True, kw_only=True)
class Pitting(Component):
    """Pits and spalls on a flank: individual `patches`, or a random `pattern`."""

    form: ClassVar[str] = "pitting"
    tooth: int = _tooth()
    flank: str = _flank("flank with the pits")
    patches: tuple[Patch, ...] = key("list", "individual pits and spalls", (), of=Patch)
    pattern: Pattern | None = component(Pattern, "random pits, instead of patches")
    severity: float = _severity("scales the axes of all ellipses, and its square the depths")

    def on(self, gear: CylindricalGear) -> tuple[pits.Patch, ...]:
        """All patches, converted to the geometry layer."""
        from pitchpoint.geometry import pits

        if self.pattern is not None:
            return pits.random_patches(gear, **vars(self.pattern))
        return tuple(pits.Patch(**vars(patch)) for patch in self.patches)


@dataclass(frozen=True, kw_only=True)
class Wear(Component):
    """Wear of all teeth by Archard's law: pressure times sliding distance, zero at the pitch point.

    Give the maximum `depth`, or `coefficient`, `cycles` and `torque`.
    """

    form: ClassVar[str] = "wear"
    flank: str = _flank("worn flanks")
    depth: float | None = positive("length", "maximum depth, normal to the flank", None)
    coefficient: float | None = positive(
        "wear_coefficient", "wear coefficient: volume per force and sliding distance", None
    )
    cycles: float | None = positive("dimensionless", "number of revolutions of the gear under load", None)
    torque: float | None = positive("torque", "torque on the gear during wear", None)
    severity: float = _severity("scales the depth")


ToothFault = BrokenTooth | RootCrack | Pitting | Wear | PitchError

FAULTS: dict[str, type[ToothFault]] = {
    cls.form: cls for cls in (BrokenTooth, RootCrack, Pitting, Wear, PitchError)
}
"""Fault classes by the value of the key `type`."""

BevelFault = BrokenBevelTooth | PitchError

BEVEL_FAULTS: dict[str, type[BevelFault]] = {cls.form: cls for cls in (BrokenBevelTooth, PitchError)}
"""Fault classes of bevel gears by the value of the key `type`."""
