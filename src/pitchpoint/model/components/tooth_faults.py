# SPDX-License-Identifier: Apache-2.0
"""Faults of teeth as a user states them: where, how large, how severe."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from pitchpoint.model.keys import choice, integer, positive, quantity

ENDS = ("start", "end")
SHAPES = ("straight", "corner")


def _tooth() -> Any:
    return integer("number of the tooth, counter-clockwise from tooth 0", minimum=0)


def _severity(meaning: str) -> Any:
    return quantity("dimensionless", meaning, 1.0, minimum=0.0, maximum=1.0)


@dataclass(frozen=True, kw_only=True)
class BrokenTooth:
    """A tooth of which a part is missing, on both flanks: a corner, a piece of one end, a band along the tip,
    or all of it.

    A size that is left out is the whole of the tooth.
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
        """Width and height that are missing [m]; sizes of the whole tooth stand in for those left out."""
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


ToothFault = BrokenTooth | PitchError

FAULTS: dict[str, type[ToothFault]] = {cls.form: cls for cls in (BrokenTooth, PitchError)}
"""Classes of faults by the word of their key `type`."""
