# SPDX-License-Identifier: Apache-2.0
"""Remarks on springs, bearings and couplings without force at any motion of their bodies."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, remark
from pitchpoint.model.axial_supports import without_axial_support
from pitchpoint.model.frames import GROUND, split
from pitchpoint.model.rings import ring_bodies
from pitchpoint.model.stand_ins import path_of
from pitchpoint.model.tilt_supports import without_tilt_support

if TYPE_CHECKING:
    from pitchpoint.model.components.bearing import Bearing
    from pitchpoint.model.components.bushing import Bushing
    from pitchpoint.model.components.coupling import Coupling
    from pitchpoint.model.components.rolling_bearing import PlainBearing, RollingBearing
    from pitchpoint.model.model import Model

#: Directions in which a body can move, as columns of a 6x6 matrix (x, y, z, rx, ry, rz).
MOVES: dict[str, tuple[int, ...]] = {
    "fixed": (),
    "torsion": (5,),
    "planar": (0, 1, 5),
    "free": (0, 1, 2, 3, 4, 5),
    "joint": (0, 1, 2, 3, 4, 5),  # its parent may move
}


def idle_springs(model: Model) -> Iterator[Message]:
    """Springs and bushings without any stiffness or damping."""
    for group, own in (("springs", "force"), ("torsion_springs", "torque")):
        for name, spring in getattr(model, group).items():
            if spring.stiffness == spring.damping == 0.0 and getattr(spring, own) is None:
                yield remark(
                    f"{group}.{name}", f"has no effect: it has neither stiffness nor damping nor {own}"
                )
    for name, bushing in model.bushings.items():
        if not _holds(bushing, set(MOVES["joint"])):
            yield remark(f"bushings.{name}", "has no effect: it has neither stiffness nor damping")


def idle_supports(model: Model) -> Iterator[Message]:
    """Bearings and couplings that act only in directions without motion."""
    for name, bearing in model.bearings.items():
        motion = model.bodies[bearing.body].moves
        house = split(bearing.housing)[0] if bearing.housing is not None else GROUND
        moving = set(MOVES[motion])
        if house != GROUND:  # a station of a beam moves in all directions
            moving |= set(MOVES[model.bodies[house].moves if house in model.bodies else "joint"])
        if not _holds(bearing, moving):
            yield remark(
                f"bearings.{name}",
                f"has no effect and no force at any load: it acts in no direction in which "
                f"{bearing.body}{'' if motion == 'joint' else f' (motion: {motion})'} moves",
            )
    for group in ("rolling_bearings", "plain_bearings"):
        for name, part in getattr(model, group).items():
            bodies = [b for b in ring_bodies(part) if b != GROUND]
            if all(b in model.bodies and model.bodies[b].moves in ("torsion", "fixed") for b in bodies):
                force = "" if _preloaded(part) else " and no force at any load"
                both, move = " and ".join(bodies), "move" if bodies[1:] else "moves"
                yield remark(
                    f"{group}.{name}",
                    f"has no effect{force}: {both} {move} neither along nor across the axis of rotation",
                    f"give {both} motion: free or planar, or use an elastic shaft",
                )
    for name, coupling in model.couplings.items():
        if not _holds(coupling, {k for b in coupling.bodies for k in MOVES[model.bodies[b].moves]}):
            yield remark(
                f"couplings.{name}",
                f"has no effect and no force at any load: it acts in no direction in which "
                f"{' or '.join(coupling.bodies)} moves",
            )


def axially_free(model: Model) -> Iterator[Message]:
    """Bodies with axial loads whose bearings hold them in one axial direction or in none."""
    for body, bearings, side in without_axial_support(model):
        where = f"{'shafts' if body in model.shafts else 'bodies'}.{body}"
        one = len(bearings) == 1
        these = _listed(bearings)
        if side == 0:
            yield remark(
                where,
                f"has axial loads, but nothing holds it along its axis: {these} "
                f"support{'s' if one else ''} no axial force",
                "use a bearing that supports axial forces",
            )
            continue
        held, free = ("+z", "-z") if side > 0 else ("-z", "+z")
        yield remark(
            where,
            f"is held along its axis in one direction only: {these} support{'s' if one else ''} axial forces "
            f"on it in its {held} direction, and nothing supports those in {free}",
            "turn one of the bearings around (axial_force_absorption), or add one, unless all axial loads "
            f"are in {held}",
        )


def tilting(model: Model) -> Iterator[Message]:
    """Bodies with helical gears that only their teeth hold against tilting; planets of a stage together."""
    found: dict[str, dict[str, tuple[str, ...]]] = {}
    for body, bearings in without_tilt_support(model):
        stage = model.bodies[body].stage
        own = f"{'shafts' if body in model.shafts else 'bodies'}.{body}"
        found.setdefault(path_of(stage) if stage else own, {})[body] = bearings
    for where, parts in found.items():
        all_bearings = [name for names in parts.values() for name in names]
        support = "supports" if len(all_bearings) == 1 else "support"
        yield remark(
            where,
            f"the axial forces of its helical gears tilt {_listed(list(parts))}; {_listed(all_bearings)}, at "
            f"one position{' each' if len(parts) > 1 else ''}, {support} little or nothing of this moment, "
            "so that the teeth do",
            "use two bearings at a distance along the axis",
        )


def _listed(names: Sequence[str]) -> str:
    """Names with commas and `and`."""
    return " and ".join([", ".join(names[:-1])] * (len(names) > 1) + [names[-1]])


def _preloaded(part: RollingBearing | PlainBearing) -> bool:
    """Whether a bearing has a force without motion and load."""
    if part.clearance is not None and part.clearance < 0.0:
        return True
    return any(getattr(part, key, None) is not None for key in ("preload", "preload_distance"))


def _holds(part: Bearing | Coupling | Bushing, moves: set[int]) -> bool:
    """Whether a spring or damper acts in any of the given directions."""
    matrices = [part.stiffness.matrix6()]
    if part.damping is not None:
        matrices.append(part.damping.matrix6())  # a ratio damps the directions of the stiffness
    return any(row[j] != 0.0 for m in matrices for row in m for j in moves)
