# SPDX-License-Identifier: Apache-2.0
"""Faults of teeth as a user states them: where, how large, how severe."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from pitchpoint.model.keys import choice, component, integer, key, positive, quantity

if TYPE_CHECKING:
    from pitchpoint.geometry import pits
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

ENDS = ("start", "end")
SHAPES = ("straight", "corner")


def _tooth() -> Any:
    return integer("number of the tooth, counter-clockwise from tooth 0", minimum=0)


def _flank(meaning: str) -> Any:
    return choice(("left", "right", "both"), meaning)


def _severity(meaning: str) -> Any:
    return quantity("dimensionless", meaning, 1.0, minimum=0.0, maximum=1.0)


@dataclass(frozen=True, kw_only=True)
class BrokenTooth:
    """A tooth of which a part is missing, on both flanks: a corner, a piece of one end, a band along the tip,
    or all of it.

    A size that is omitted is the whole of the tooth.
    """

    form: ClassVar[str] = "broken_tooth"
    tooth: int = _tooth()
    at: str = choice(
        ENDS, "end of the face width from which width counts: start is the end of the lowest z", "start"
    )
    width: float | None = positive(
        "length", "width that is missing at the tip, along the face", None, display="the whole face"
    )
    height: float | None = positive(
        "length",
        "height that is missing at the end of the face, radially from the tip",
        None,
        display="the whole tooth",
    )
    shape: str = choice(
        SHAPES,
        "straight: width times height is missing; corner: the triangle between width and height",
        "straight",
    )
    severity: float = _severity("scales the given sizes; without any of them, the height")

    def sizes(self, face_width: float, tooth_height: float) -> tuple[float, float]:
        """Width and height that are missing [m]; omitted sizes are those of the whole tooth."""
        width, height = self.width or face_width, self.height or tooth_height
        scaled = self.shape == "corner"
        if scaled or self.width is not None:
            width *= self.severity
        if scaled or self.height is not None or self.width is None:
            height *= self.severity
        return width, height


@dataclass(frozen=True, kw_only=True)
class PitchError:
    """A tooth out of its place: both of its flanks are displaced by the same amount."""

    form: ClassVar[str] = "pitch_error"
    tooth: int = _tooth()
    amount: float = quantity(
        "length", "displacement of the tooth on the reference circle, counter-clockwise positive"
    )
    severity: float = _severity("scales the amount")


@dataclass(frozen=True, kw_only=True)
class BrokenBevelTooth:
    """A bevel gear's tooth of which one end is missing, or all of it."""

    form: ClassVar[str] = "broken_tooth"
    tooth: int = _tooth()
    at: str = choice(("outer", "inner"), "end of the face from which width counts", "outer")
    width: float | None = positive(
        "length", "width that is missing along the pitch cone", None, display="the whole face"
    )
    severity: float = _severity("scales the width")

    def left(self, R_i: float, R_e: float) -> tuple[float, float]:
        """Cone distances between which the tooth is left [m], from those of the face; none if they cross."""
        missing = self.severity * (R_e - R_i if self.width is None else self.width)
        return (R_i, R_e - missing) if self.at == "outer" else (R_i + missing, R_e)


@dataclass(frozen=True, kw_only=True)
class RootCrack:
    """A crack at the root of a tooth, which makes it softer under loads that open it."""

    form: ClassVar[str] = "root_crack"
    tooth: int = _tooth()
    flank: str = _flank("side of the root where it starts: loads on this flank open it, others close it")
    depth: float = positive("length", "length of the crack in the transverse section, where it is deepest")
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
        "length along the face, over which the depth falls to nothing; without it the same depth everywhere",
        None,
        display="the whole face, at even depth",
    )
    at: str = choice(ENDS, "end of the face width where a crack with a length is deepest", "start")
    severity: float = _severity("scales the depth")


@dataclass(frozen=True, kw_only=True)
class Patch:
    """A pit or spall: a hollow with an elliptic edge, deepest in its middle."""

    position: float = quantity("length", "middle along the face width, from its start", minimum=0.0)
    diameter: float = positive("length", "diameter of its middle on the flank")
    length: float = positive("length", "axis of the ellipse along the face")
    height: float = positive("length", "axis of the ellipse along the profile, radially")
    depth: float = positive("length", "depth in the middle, normal to the flank")


@dataclass(frozen=True, kw_only=True)
class Pattern:
    """Pits scattered evenly over a flank, of half to all of the given sizes."""

    number: int = integer("number of pits", minimum=1, maximum=10000)
    seed: int = integer("start of the random numbers; the same seed gives the same pits", 0, minimum=0)
    length: float = positive("length", "largest axis along the face")
    height: float = positive("length", "largest axis along the profile, radially")
    depth: float = positive("length", "largest depth, normal to the flank")


@dataclass(frozen=True, kw_only=True)
class Pitting:
    """Pits and spalls on a flank: `patches` one by one, or a random `pattern`."""

    form: ClassVar[str] = "pitting"
    tooth: int = _tooth()
    flank: str = _flank("flank they are on")
    patches: tuple[Patch, ...] = key("list", "pits and spalls one by one", (), of=Patch)
    pattern: Pattern | None = component(Pattern, "random pits instead")
    severity: float = _severity("scales the axes of all ellipses, and with its square the depths")

    def on(self, gear: CylindricalGear) -> tuple[pits.Patch, ...]:
        """All patches in the terms of the geometry layer."""
        from pitchpoint.geometry import pits

        if self.pattern is not None:
            return pits.random_patches(gear, **vars(self.pattern))
        return tuple(pits.Patch(**vars(patch)) for patch in self.patches)


@dataclass(frozen=True, kw_only=True)
class Wear:
    """Wear of all teeth of a gear after Archard: pressure times sliding, nothing at the pitch point.

    Its size is either the largest `depth`, or follows from `coefficient`, `cycles` and `torque`.
    """

    form: ClassVar[str] = "wear"
    flank: str = _flank("flanks that are worn")
    depth: float | None = positive("length", "largest depth, normal to the flank", None)
    coefficient: float | None = positive(
        "wear_coefficient", "volume worn off per force and sliding distance", None
    )
    cycles: float | None = positive("dimensionless", "turns of the gear under load", None)
    torque: float | None = positive("torque", "torque on the gear under which its flanks wear", None)
    severity: float = _severity("scales the depth")


ToothFault = BrokenTooth | RootCrack | Pitting | Wear | PitchError

FAULTS: dict[str, type[ToothFault]] = {
    cls.form: cls for cls in (BrokenTooth, RootCrack, Pitting, Wear, PitchError)
}
"""Classes of faults by the word of their key `type`."""

BevelFault = BrokenBevelTooth | PitchError

BEVEL_FAULTS: dict[str, type[BevelFault]] = {cls.form: cls for cls in (BrokenBevelTooth, PitchError)}
"""Those of bevel gears."""
