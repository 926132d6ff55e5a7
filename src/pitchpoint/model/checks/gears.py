# SPDX-License-Identifier: Apache-2.0
"""Checks of contradicting keys of gears, meshes and six-component springs."""

from __future__ import annotations

import math
from typing import Any

from pitchpoint.model.components.bevel_mesh import BevelMesh
from pitchpoint.model.components.mesh import Mesh
from pitchpoint.model.components.modifications import FlankPitch
from pitchpoint.model.components.stiffness import OF_PAIRS, Fourier, Hertz, Rectangular
from pitchpoint.model.keys import Place
from pitchpoint.model.parts import Parts
from pitchpoint.model.reading.reader import Reader


def check_meshes(parts: Parts, report: Reader) -> None:
    """Check keys and laws of meshes."""
    every = [(group, *item) for group in ("meshes", "bevel_meshes") for item in getattr(parts, group).items()]
    for group, name, mesh in every:
        at: Place = (group, name)
        _losses(mesh, at, report)
        _stiffness(mesh.stiffness, (*at, "stiffness"), report)


def _losses(mesh: Mesh | BevelMesh, at: Place, report: Reader) -> None:
    """Check that damping and friction are compatible with the stiffness law of a mesh."""
    law, damping, friction = mesh.law, mesh.damping, mesh.friction
    if isinstance(law, Hertz):
        for name, part in (("damping", damping), ("damper", mesh.damper)):
            if part is not None and part.ratio is not None:
                report.problem(
                    (*at, name, "ratio"),
                    "is not defined for the law hertz, whose stiffness depends on the load",
                    remedy="give a damping",
                )
    if damping is not None and damping.pair is not None and not law.of_pairs:
        report.problem(
            (*at, "damping", "pair"),
            f"is for single tooth pairs, and the law {law.law} describes the whole mesh",
            remedy=f"give d_in, or use one of the laws {', '.join(OF_PAIRS)}",
        )
    if friction is not None:
        speed = friction.static_speed
        if speed is not None and speed >= friction.v_eps:
            report.problem(
                (*at, "friction", "static_speed"),
                f"{speed:g} m/s is not below v_eps",
                limit=f"< {friction.v_eps:g} m/s",
                remedy="increase v_eps or reduce it",
            )


def _stiffness(law: Any, at: Place, report: Reader) -> None:
    if isinstance(law, Fourier):
        depth = math.fsum(
            math.hypot(c, s)
            for c, s in zip(
                [*law.cosine, *[0.0] * len(law.sine)], [*law.sine, *[0.0] * len(law.cosine)], strict=True
            )
        )
        if depth >= 1.0 and _fourier_minimum(law) <= 0.0:
            report.problem(
                at, "becomes zero or negative in the mesh cycle", limit="> 0", remedy="reduce the amplitudes"
            )
    elif isinstance(law, Rectangular) and law.low > law.high:
        report.problem((*at, "low"), "is larger than high", remedy="exchange low and high")


def _fourier_minimum(law: Fourier) -> float:
    """Minimum relative stiffness over one period, from 32 points per harmonic."""
    count = max(len(law.cosine), len(law.sine))
    steps = 32 * count
    return min(
        1.0
        + math.fsum(c * math.cos(math.tau * (n + 1) * i / steps) for n, c in enumerate(law.cosine))
        + math.fsum(s * math.sin(math.tau * (n + 1) * i / steps) for n, s in enumerate(law.sine))
        for i in range(steps)
    )


def check_choices(parts: Parts, report: Reader) -> None:
    """Check mutually exclusive keys of meshes, six-component springs and gears."""
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
            f"gives {' and '.join(profile.given)} together" if profile.given else "gives no points",
            remedy="give tooth, or both, or left and right",
        )
