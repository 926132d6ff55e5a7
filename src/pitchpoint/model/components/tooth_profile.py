# SPDX-License-Identifier: Apache-2.0
"""Tooth profile of a gear as points in the transverse plane, and its conversion to a tooth outline."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from pitchpoint.core.errors import GeometryError, Message
from pitchpoint.model.component import Component
from pitchpoint.model.keys import integer, key, quantity

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    from pitchpoint.geometry.tooth_outline import ToothOutline


@dataclass(frozen=True)
class Points:
    """Points (x, y) [m] in the order of an outline, with the name of their file and the line of each
    point."""

    xy: tuple[tuple[float, float], ...]
    file: str = field(default="", compare=False)
    lines: tuple[int, ...] = field(default=(), compare=False)
    teeth: tuple[int, ...] = field(default=(), compare=False)
    """Tooth number of each point, if the file gives it."""

    def of_tooth(self, number: int) -> Points:
        """Points of one tooth; all points if the file does not number the teeth."""
        if not self.teeth:
            return self
        rows = [i for i, tooth in enumerate(self.teeth) if tooth == number]
        return Points(tuple(self.xy[i] for i in rows), self.file, tuple(self.lines[i] for i in rows))


def _points(meaning: str) -> Points | None:
    given: Points | None = key("points", meaning, None, dimension="length")
    return given


@dataclass(frozen=True, kw_only=True)
class ToothProfile(Component):
    """Points of the tooth in the transverse section; give `tooth`, or `both`, or `left` and `right`.
    Drawings, mass and inertia use the outline. The contact of single tooth pairs (laws din3990, energy,
    pair_table) uses the deviations of the flanks from the nominal involute, added to modifications and
    deviations; the stiffness remains that of the generated tooth. A CSV file has a header line with units,
    such as `x [mm],y [mm]`, then one point per line in the order of the outline, as written by
    `pitchpoint gears --export`; a column `tooth` may number the teeth, other columns are ignored. A flank or
    tip that deviates by more than 0.2 modules is rejected, as are points that cross or run back along the
    outline, in any tooth of the file.
    """

    tooth: Points | None = _points("one tooth, root to root: CSV file, or list of [x, y]")
    both: Points | None = _points("one flank, root to tip or tip to root; the other flank is mirrored")
    left: Points | None = _points("left flank, root to tip or tip to root; nominal if omitted")
    right: Points | None = _points("right flank, root to tip or tip to root; nominal if omitted")
    number: int = integer(
        "tooth number of the points; they are rotated back by this number of pitches", 0, minimum=0
    )
    angle: float = quantity("angle", "angle from the x axis of the points to the centre of tooth 0", 0.0)

    @property
    def given(self) -> tuple[str, ...]:
        """Names of the parts that are given."""
        return tuple(n for n in ("tooth", "both", "left", "right") if getattr(self, n) is not None)

    def of_number(self) -> ToothProfile:
        """Profile with the points of tooth `number` only."""
        return replace(self, **{name: getattr(self, name).of_tooth(self.number) for name in self.given})

    def outline(self, gear: CylindricalGear) -> ToothOutline:
        """Tooth outline of a gear; GeometryError with key and line if the points do not fit the gear."""
        from pitchpoint.geometry.tooth_outline import OutlineError, outline_from_flanks, outline_from_tooth

        turn = self.angle + 2.0 * math.pi * self.number / abs(gear.z)
        parts = {name: self._turned(name, -turn) for name in self.given}
        try:
            if "tooth" in parts:
                return outline_from_tooth(gear, parts["tooth"])
            if "both" in parts:
                left = parts["both"].copy()
                # a single flank may be left or right: a right flank is mirrored
                left[:, 1] *= -1.0 if left[:, 1].sum() < 0.0 else 1.0
                mirrored = left * (1.0, -1.0)
                return outline_from_flanks(gear, left=left, right=mirrored)
            return outline_from_flanks(gear, **parts)
        except OutlineError as error:
            name = error.part if error.part in self.given else "both"
            raise self._fault(name, error.problem, error.point) from None

    def check_teeth(self) -> None:
        """Check the order of the points of all teeth of the files but `number`, which `outline` checks.

        Points in the wrong place leave the tooth `number` as it is if they belong to another tooth. The error
        (GeometryError) is that of the first line.
        """
        from pitchpoint.geometry.outline_check import OutlineError, plane_points
        from pitchpoint.geometry.outline_order import check_path

        for name in self.given:
            points: Points = getattr(self, name)
            rows: dict[int, list[int]] = {}
            for row, tooth in enumerate(points.teeth):
                rows.setdefault(tooth, []).append(row)
            rows.pop(self.number, None)
            faults: list[tuple[int, int, Message]] = []
            for tooth, own in rows.items():
                try:
                    plane, index = plane_points([points.xy[i] for i in own], name, 1)
                    check_path(plane, index, name)
                except OutlineError as error:
                    faults.append((own[error.point or 0], tooth, error.problem))
            if faults:
                row, tooth, problem = min(faults)
                raise self._fault(name, problem.changed(text=f"{problem.text} in tooth {tooth}"), row)

    def _fault(self, name: str, problem: Message, point: int | None) -> GeometryError:
        """Error of a point of a part, with key, file and line."""
        return GeometryError(
            f"{problem.text}{self._source(name, point)}",
            where=f"tooth_profile.{name}",
            value=problem.value,
            limit=problem.limit,
            remedy=problem.remedy,
        )

    def _turned(self, name: str, angle: float) -> NDArray[np.float64]:
        import numpy as np

        xy = np.array(getattr(self, name).xy, dtype=float).reshape(-1, 2)
        cos, sin = math.cos(angle), math.sin(angle)
        return xy @ np.array([[cos, sin], [-sin, cos]])

    def _source(self, name: str, point: int | None) -> str:
        """Source of a point (file and line, or index), for messages."""
        points: Points = getattr(self, name)
        if points.file and point is not None:
            return f" (file '{points.file}', line {points.lines[point]})"
        if points.file:
            return f" (file '{points.file}')"
        return "" if point is None else f" (point {point})"
