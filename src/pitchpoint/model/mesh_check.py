# SPDX-License-Identifier: Apache-2.0
"""Keys of meshes that contradict themselves or each other."""

from __future__ import annotations

import math
from typing import Any

from pitchpoint.model.components.bevel_mesh import BevelMesh
from pitchpoint.model.components.mesh import Mesh
from pitchpoint.model.components.stiffness import OF_PAIRS, Fourier, Hertz, Rectangular
from pitchpoint.model.keys import Place
from pitchpoint.model.parts import Parts
from pitchpoint.model.read import Reader


def check_meshes(parts: Parts, report: Reader) -> None:
    """Keys and laws of meshes that do not go together."""
    every = [(group, *item) for group in ("meshes", "bevel_meshes") for item in getattr(parts, group).items()]
    for group, name, mesh in every:
        at: Place = (group, name)
        _losses(mesh, at, report)
        _stiffness(mesh.stiffness, (*at, "stiffness"), report)


def _losses(mesh: Mesh | BevelMesh, at: Place, report: Reader) -> None:
    """Damping and friction that the stiffness law of a mesh does not know, or that contradict themselves."""
    law, damping, friction = mesh.stiffness, mesh.damping, mesh.friction
    if isinstance(law, Hertz):
        for name, part in (("damping", damping), ("damper", mesh.damper)):
            if part is not None and part.ratio is not None:
                report.problem(
                    (*at, name, "ratio"),
                    "has no meaning for the law hertz, whose stiffness grows with the load",
                    remedy="give a damping",
                )
    if damping is not None and damping.pair is not None and law.law not in OF_PAIRS:
        report.problem(
            (*at, "damping", "pair"),
            f"belongs to a tooth pair, and the law {law.law} knows none",
            remedy=f"give d_in, or take one of the laws {', '.join(OF_PAIRS)}",
        )
    if friction is not None:
        speed = friction.static_speed
        if speed is not None and speed >= friction.v_eps:
            report.problem(
                (*at, "friction", "static_speed"),
                f"{speed:g} m/s is not below v_eps",
                limit=f"< {friction.v_eps:g} m/s",
                remedy="raise v_eps or lower it",
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
    """Smallest relative stiffness over one period, from 32 points per harmonic."""
    count = max(len(law.cosine), len(law.sine))
    steps = 32 * count
    return min(
        1.0
        + math.fsum(c * math.cos(math.tau * (n + 1) * i / steps) for n, c in enumerate(law.cosine))
        + math.fsum(s * math.sin(math.tau * (n + 1) * i / steps) for n, s in enumerate(law.sine))
        for i in range(steps)
    )
