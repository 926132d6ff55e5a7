# SPDX-License-Identifier: Apache-2.0
"""Keys of gears, meshes and six-component springs of which exactly one or at most one is allowed."""

from __future__ import annotations

from typing import Any

from pitchpoint.model.components.modifications import FlankPitch
from pitchpoint.model.keys import Place
from pitchpoint.model.mesh_check import check_meshes
from pitchpoint.model.parts import Parts
from pitchpoint.model.read import Reader


def check_choices(parts: Parts, report: Reader) -> None:
    """Keys of which exactly one or at most one is allowed."""
    check_meshes(parts, report)
    for group in ("bearings", "couplings", "bushings"):
        for name, part in getattr(parts, group).items():
            for key in ("stiffness", "damping"):
                if getattr(part, key) is not None:
                    _six(getattr(part, key), (group, name, key), report)
    for name, gear in parts.gears.items():
        _gear_choices(name, gear, report)


def _six(part: Any, at: Place, report: Reader) -> None:
    if part.matrix is not None:
        others = [k for k in ("radial", "x", "y", "tilt", "rx", "ry") if getattr(part, k) is not None]
        others += [k for k in ("axial", "torsion") if getattr(part, k) != 0.0]
        if others:
            report.problem(
                (*at, "matrix"),
                f"cannot be combined with {', '.join(others)}",
                remedy="give the matrix alone",
            )
    for both, single in (("radial", "xy"), ("tilt", ("rx", "ry"))):
        if getattr(part, both) is not None:
            for key in single:
                if getattr(part, key) is not None:
                    report.problem(
                        (*at, key),
                        f"cannot be combined with {both}",
                        remedy=f"give {both}, or x and y separately",
                    )


def _gear_choices(name: str, gear: Any, report: Reader) -> None:
    at: Place = ("gears", name)
    if gear.cutter is not None and gear.type == "external":
        report.problem(
            (*at, "cutter"), "is for internal gears only", remedy="remove it, or set type: internal"
        )
    given = gear.deviations.pitch if gear.deviations is not None else ()
    by_flank = isinstance(given, FlankPitch)
    for side in ("left", "right") if by_flank else ("both",):
        pitch = getattr(given, side) if by_flank else given
        if pitch and len(pitch) != gear.number_of_teeth:
            report.problem(
                (*at, "deviations", "pitch", *((side,) if by_flank else ())),
                f"has {len(pitch)} entries for {gear.number_of_teeth} teeth",
                remedy="give one deviation per tooth",
            )
    maps = gear.deviations.flank_maps if gear.deviations is not None else ()
    for i, flank_map in enumerate(maps):
        if flank_map.tooth >= gear.number_of_teeth:
            report.problem(
                (*at, "deviations", "flank_maps", i, "tooth"),
                "is not a tooth of this gear",
                value=str(flank_map.tooth),
                limit=f"<= {gear.number_of_teeth - 1}",
            )

    profile = gear.tooth_profile
    if (
        profile is not None
        and (*at, "tooth_profile") not in report.tainted
        and profile.given
        not in (
            ("tooth",),
            ("both",),
            ("left",),
            ("right",),
            ("left", "right"),
        )
    ):
        report.problem(
            (*at, "tooth_profile"),
            f"gives {' and '.join(profile.given)} at once" if profile.given else "gives no points",
            remedy="give tooth, or both, or left and right",
        )
