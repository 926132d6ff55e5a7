# SPDX-License-Identifier: Apache-2.0
"""Positions of gears at which a loop of meshes closes, for loops whose teeth do not meet.

The axes of a loop are a linkage of the lines of centres. Four neighbours a, b, c, d with a and d fixed leave
it one freedom: b swings about a, and c follows at its distances from b and d. All centre distances, and so
the backlashes, remain. The teeth meet where the residuals of the meshes vanish with their signs alternating.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from pitchpoint.geometry.bisection import bisect
from pitchpoint.model.frames import body_frame
from pitchpoint.model.phasing import pitches_off

if TYPE_CHECKING:
    from pitchpoint.model.components.mesh import Mesh
    from pitchpoint.model.parts import Parts

STEPS = 20
"""Steps of the search in which the swing moves a mesh by one pitch, about."""
JUMP = 0.25
"""Change of the residual [base pitches] in a step above which it passed from one pitch to the next."""
SAME = 1e-9
"""Distance of two axes up to which they coincide [m]."""
PARALLEL = 1e-9
"""Difference of the cosine of an axis from 1 up to which it is parallel to z."""


def loop_through(meshes: Mapping[str, Mesh], name: str) -> list[str]:
    """Gears of the shortest loop of meshes through a mesh, in order; empty without a loop.

    The first and the last gear are those of the mesh.
    """
    start, goal = meshes[name].gears
    paths, seen = [[start]], {start}
    for path in paths:  # grows: breadth first
        if path[-1] == goal:
            return path
        for other, mesh in meshes.items():
            if other == name or path[-1] not in mesh.gears:
                continue
            gear = mesh.gears[1 - mesh.gears.index(path[-1])]
            if gear not in seen:
                seen.add(gear)
                paths.append([*path, gear])
    return []


def closing_places(parts: Parts, meshes: Mapping[str, Mesh], name: str) -> dict[str, complex]:
    """Nearest positions x + iy [m] of one or two bodies at which a loop of meshes closes; empty without any.

    Only for an even number of gears, on different bodies with axes along z, two neighbours of which have no
    other meshes: with an odd number the gears of a loop cannot rotate.

    Parameters
    ----------
    parts
        Gears and bodies.
    meshes
        Meshes by name, with their directions.
    name
        Mesh at which the teeth do not meet.
    """
    loop = loop_through(meshes, name)
    bodies = [str(parts.body_of(gear)) for gear in loop]
    if len(loop) < 4 or len(loop) % 2 or len({*bodies} - {"None"}) < len(loop):
        return {}
    places = {}
    for gear, body in zip(loop, bodies, strict=True):
        origin, axes = body_frame(parts, body)
        if origin is None or axes[2, 2] < 1.0 - PARALLEL:
            return {}
        places[gear] = complex(origin[0], origin[1])
    around = [_between(meshes, pair) for pair in zip(loop, [*loop[1:], loop[0]], strict=True)]
    order = list(parts.gears)
    first = min(range(len(loop)), key=lambda k: order.index(loop[k]))  # rather stays
    turned = [[*loop[k:], *loop[:k]] for k in (*range(first, len(loop)), *range(first))]
    fours = [(one[0], one[-1], one[-2], one[-3]) for one in turned]
    alone = {b: abs(places[a] - places[c]) <= SAME for a, b, c, _ in fours}
    for a, b, c, d in sorted(fours, key=lambda four: -order.index(four[1]) if alone[four[1]] else 1):
        moving = (b,) if alone[b] else (b, c)
        if any(_is_bound(parts, meshes, gear, around) for gear in moving):
            continue
        found = _closed(parts, [meshes[m] for m in around], places, (a, b, c, d))
        return {str(parts.body_of(gear)): place for gear, place in found.items()}
    return {}


def _between(meshes: Mapping[str, Mesh], pair: tuple[str, str]) -> str:
    """Name of the mesh of two gears."""
    return next(n for n, m in meshes.items() if {*m.gears} == {*pair})


def _is_bound(parts: Parts, meshes: Mapping[str, Mesh], gear: str, loop: Sequence[str]) -> bool:
    """Whether a gear is a planet of a stage, or any gear on its body has a mesh outside the loop."""
    body = parts.bodies[str(parts.body_of(gear))]
    meets = any(n not in loop and {*m.gears} & {*body.gears} for n, m in meshes.items())
    return body.stage is not None or meets


def _closed(
    parts: Parts, loop: Sequence[Mesh], places: Mapping[str, complex], four: tuple[str, str, str, str]
) -> dict[str, complex]:
    """Positions of the middle two of four neighbours at the smallest swing that closes a loop.

    A gear between two on one axis, such as a planet, swings alone.
    """
    a, b, c, d = four
    near, far = abs(places[c] - places[b]), abs(places[c] - places[d])
    side = _cross(places[d] - places[b], places[c] - places[b])

    def swung(angle: float) -> dict[str, complex] | None:
        """Positions after a swing of b about a; None beyond the reach of c."""
        new = places[a] + (places[b] - places[a]) * cmath.exp(1j * angle)
        if abs(places[a] - places[c]) <= SAME:
            return {b: new}
        base = places[d] - new
        along = (near**2 - far**2 + abs(base) ** 2) / (2.0 * abs(base))
        if abs(along) >= near:
            return None
        across = math.copysign(math.sqrt(near**2 - along**2), side)
        return {b: new, c: new + base / abs(base) * complex(along, across)}

    def missed(angle: float) -> float | None:
        """Alternating sum of the residuals of the meshes [base pitches]: rotations of the gears cancel."""
        moved = swung(angle)
        if moved is None:
            return None
        there, total = {**places, **moved}, 0.0
        for k, mesh in enumerate(loop):
            one, two = mesh.gears
            turn = cmath.phase((there[two] - there[one]) / (places[two] - places[one]))
            moved_mesh = replace(mesh, theta=mesh.theta + turn)
            total += (-1) ** k * pitches_off(parts.gears, moved_mesh, dict.fromkeys(mesh.gears, 0.0))
        return math.remainder(total, 1.0)

    step = math.tau / (STEPS * sum(parts.gears[gear].number_of_teeth for gear in four))
    roots = [_root(missed, sign * step) for sign in (1.0, -1.0)]
    swing = min((root for root in roots if root is not None), key=abs, default=None)
    return (swung(swing) or {}) if swing is not None else {}


def _root(missed: Callable[[float], float | None], step: float) -> float | None:
    """First root in steps from zero up to half a turn; None without any."""
    before = missed(0.0)
    for k in range(1, int(math.pi / abs(step))):
        here = missed(k * step)
        if here is None or before is None:
            return None
        if before * here <= 0.0 and abs(here - before) < JUMP:
            return bisect(lambda x: missed(x) or 0.0, (k - 1) * step, k * step)
        before = here
    return None


def _cross(one: complex, two: complex) -> float:
    """Component of a vector product along z."""
    return (one.conjugate() * two).imag
