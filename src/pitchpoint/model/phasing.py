# SPDX-License-Identifier: Apache-2.0
"""Assembly of the gears of a model: angle of tooth 0 of every gear at zero spin.

Two gears are assembled centred in their backlash: when a tooth of gear 1 is centred on the line of
centres, a space of gear 2 is centred on it. With gamma the angle of the centre of tooth 0 (at mid-face, from
the x axis of its body), theta_1 and theta_2 the directions from either axis to the pitch point, and signed z,

    z_1 (gamma_1 - theta_1) + z_2 (gamma_2 - theta_2) = pi   (mod 2 pi),

in the middle of the common face width, where a tooth of a helical gear is at gamma + o tan(beta)/r.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from pitchpoint.model.components.mesh import Mesh

if TYPE_CHECKING:
    from pitchpoint.model.components.gear import Gear


SMALL = 0.1
"""Base pitches up to which a loop of meshes misses by errors. Sets of up to nine planets whose teeth do not
fit miss by a ninth of a pitch at least."""
ROUNDING = 1e-9
"""Base pitches by which a loop of meshes misses by rounding."""


@dataclass(frozen=True)
class Phasing:
    """Result of the assembly."""

    tooth_angle: Mapping[str, float]
    """Angle from the x axis of the body to the centre of tooth 0 at mid-face and zero spin, by gear [rad], in
    (-pi, pi]."""
    offset: Mapping[str, float]
    """Base-tangent distance from the middle of the backlash at zero spin, by mesh [m], in (-p_bt/2, p_bt/2];
    zero unless both gears have an initial_angle or the meshes form a loop. It is added to u_bt."""
    travel: Mapping[str, float]
    """Base-tangent travel of gear 1 past the state where its nearest tooth is centred on the line of centres,
    in the middle of the common face width, by mesh [m], in (-p_bt/2, p_bt/2]."""
    loops_close: bool
    """Whether the teeth of all loops of meshes meet except for small errors, such as those of pins. These are
    divided over the meshes of the loop."""


def pitch_directions(mesh: Mesh, gear1: Gear, gear2: Gear) -> tuple[float, float]:
    """Directions from the axes of gear 1 and gear 2 to the pitch point, from the x axis of either body [rad].

    In an internal pair both axes are on the same side of the pitch point, which lies beyond the external gear
    as seen from the internal gear.
    """
    forward, back = mesh.theta, mesh.theta + math.pi
    if gear2.type == "internal":
        return back, back - mesh.twist
    if gear1.type == "internal":
        return forward, forward - mesh.twist
    return forward, back - mesh.twist


def tooth_twist(gear: Gear, offset: float) -> float:
    """Angle by which a helical tooth advances from mid-face to the axial position `offset` [rad].

    A right-hand tooth advances counter-clockwise along the positive axis, on external and internal gears.
    """
    radius = gear.normal_module * gear.number_of_teeth / (2.0 * math.cos(gear.helix_angle))
    return offset * math.tan(gear.beta) / radius


def _phase(gear: Gear, angle: float, direction: float, offset: float) -> float:
    """Signed tooth phase of one gear at the pitch point, z (gamma + twist - theta) [rad]."""
    return _teeth(gear) * (angle + tooth_twist(gear, offset) - direction)


def assemble(gears: Mapping[str, Gear], meshes: Mapping[str, Mesh]) -> Phasing:
    """Rotate all gears so that all meshes are centred in their backlash.

    Gears with an `initial_angle` keep it, and aligned gears the angle between them; in a train without any,
    gear 1 of the first mesh is at 0. The residual of a mesh between two gears of known angle is its `offset`.

    Parameters
    ----------
    gears, meshes
        The gears and meshes of a model, with `theta`, `offset1` and `offset2` of the meshes filled in.
    """
    angle = {name: g.initial_angle for name, g in gears.items() if g.initial_angle is not None}
    of_gear: dict[str, list[str]] = {}
    for name, mesh in meshes.items():
        for gear in mesh.gears:
            of_gear.setdefault(gear, []).append(name)
    order = {name: k for k, name in enumerate(meshes)}
    loose = dict(meshes)
    fresh = list(angle)
    while loose:
        fresh += _aligned(gears, angle)
        ready = {n for gear in fresh for n in of_gear.get(gear, ()) if n in loose}
        if not ready:
            fresh = [next(iter(loose.values())).gears[0]]
            angle[fresh[0]] = 0.0
            continue
        fresh = []
        for name in sorted(ready, key=order.__getitem__):
            mesh = loose.pop(name)
            for this, other in ((0, 1), (1, 0)):
                if mesh.gears[other] not in angle:
                    angle[mesh.gears[other]] = _turned(gears, mesh, this, angle[mesh.gears[this]])
                    fresh.append(mesh.gears[other])
    _aligned(gears, angle)
    for name in gears:
        angle.setdefault(name, 0.0)
    missed = {name: _pitches(gears, mesh, angle)[0] for name, mesh in meshes.items()}
    loops_close = max(map(abs, missed.values()), default=0.0) <= SMALL
    if loops_close and max(map(abs, missed.values()), default=0.0) > ROUNDING:
        _centre(gears, meshes, angle, missed)
    offset, travel = {}, {}
    for name, mesh in meshes.items():
        p_bt = _base_pitch(gears[mesh.gears[0]])
        off, moved = _pitches(gears, mesh, angle)
        offset[name], travel[name] = off * p_bt, moved * p_bt
    wrapped = {name: math.remainder(a, math.tau) for name, a in angle.items()}
    return Phasing(wrapped, offset, travel, loops_close)


def pitches_off(gears: Mapping[str, Gear], mesh: Mesh, angle: Mapping[str, float]) -> float:
    """Distance of a mesh from the middle of its backlash at given angles of its gears [base pitches]."""
    return _pitches(gears, mesh, angle)[0]


def _pitches(gears: Mapping[str, Gear], mesh: Mesh, angle: Mapping[str, float]) -> tuple[float, float]:
    """Distance of a mesh from the middle of its backlash, and travel of gear 1 [base pitches]."""
    one, two = gears[mesh.gears[0]], gears[mesh.gears[1]]
    directions = pitch_directions(mesh, one, two)
    phase1 = _phase(one, angle[mesh.gears[0]], directions[0], mesh.offset1)
    phase2 = _phase(two, angle[mesh.gears[1]], directions[1], mesh.offset2)
    off = math.remainder(phase1 + phase2 - math.pi, math.tau) / math.tau
    return off, math.remainder(phase1, math.tau) / math.tau


def _centre(
    gears: Mapping[str, Gear],
    meshes: Mapping[str, Mesh],
    angle: dict[str, float],
    missed: Mapping[str, float],
) -> None:
    """Divide what the loops of meshes miss [base pitches] over their meshes, by least squares.

    Gears with an `initial_angle` keep it.
    """
    import numpy as np

    free = [n for n, g in gears.items() if g.initial_angle is None and g.aligned is None]
    place = {name: k for k, name in enumerate(free)}
    rows = np.zeros((len(meshes), len(free)))
    for row, mesh in zip(rows, meshes.values(), strict=True):
        for name in mesh.gears:
            base = (gears[name].aligned or (name,))[0]
            if base in place:
                row[place[base]] += _teeth(gears[name]) / _teeth(gears[base])
    # the least change of all: trains without errors stay as they are
    moved = np.linalg.lstsq(rows, -np.array(list(missed.values())), rcond=None)[0]
    for name, pitches in zip(free, moved.tolist(), strict=True):
        if abs(pitches) > ROUNDING:
            angle[name] += math.tau * pitches / _teeth(gears[name])
    for name, gear in gears.items():
        if gear.aligned is not None:
            angle[name] = angle[gear.aligned[0]] + gear.aligned[1]


def _teeth(gear: Gear) -> int:
    """Number of teeth, negative for internal gears."""
    return gear.sign * gear.number_of_teeth


def _aligned(gears: Mapping[str, Gear], angle: dict[str, float]) -> list[str]:
    """Set the angles of gears aligned with another one of known angle, or reverse; the gears set."""
    found = []
    for name, gear in gears.items():
        if gear.aligned is None:
            continue
        base, turned = gear.aligned
        if base in angle and name not in angle:
            angle[name] = angle[base] + turned
            found.append(name)
        elif name in angle and base not in angle:
            angle[base] = angle[name] - turned
            found.append(base)
    return found


def _turned(gears: Mapping[str, Gear], mesh: Mesh, fixed: int, angle: float) -> float:
    """Angle of the other gear of a mesh, centred in the backlash, with tooth 0 nearest to the pitch point."""
    pair = [gears[n] for n in mesh.gears]
    directions = pitch_directions(mesh, pair[0], pair[1])
    offsets = (mesh.offset1, mesh.offset2)
    moved = 1 - fixed
    rest = math.pi - _phase(pair[fixed], angle, directions[fixed], offsets[fixed])
    z = _teeth(pair[moved])
    return directions[moved] - tooth_twist(pair[moved], offsets[moved]) + math.remainder(rest, math.tau) / z


def _base_pitch(gear: Gear) -> float:
    """Transverse base pitch [m]."""
    alpha_t = math.atan(math.tan(gear.normal_pressure_angle) / math.cos(gear.helix_angle))
    return math.pi * gear.normal_module / math.cos(gear.helix_angle) * math.cos(alpha_t)
