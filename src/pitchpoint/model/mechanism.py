# SPDX-License-Identifier: Apache-2.0
"""Kinematic tree of a model: a spanning tree of joints; the remaining joints close loops.

Bodies with `motion` are connected to ground. Then, repeatedly, the first joint of the file whose first body
is in the tree and whose second is not adds the second body. If there is none, the first joint between a body
in the tree and one outside it is reversed. The remaining joints connect bodies of the tree: they are cut
joints.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from heapq import heappop, heappush
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.model.components.joint import COORDINATES, FUNCTIONS, TUMBLING, Joint
from pitchpoint.model.frames import (
    GROUND,
    Array,
    Machine,
    arm,
    beam_of,
    body_frame,
    carrier_of,
    joint_axes,
    joint_place,
    split,
)

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts

MOTIONS = {"fixed": "fixed", "torsion": "revolute", "planar": "planar", "free": "shaft"}
"""Type of the joint to ground for each `motion`."""

#: Columns of the frame of a reversed joint, as (column, sign): in the new axes, the coordinates of the first
#: body relative to the second equal those of the second relative to the first.
_TURNED = {"universal": ((1, -1), (0, -1), (2, -1)), "spherical": ((2, -1), (1, -1), (0, -1))}
_FLIPPED = ((0, 1), (1, -1), (2, -1))
#: Coordinates of a reversed joint, in the order of the displacements.
_RENAMED = {"universal": ("beta", "alpha"), "spherical": ("spin", "beta", "alpha")}
COUNTED = ("revolute", "cylindrical", "screw", "planar", "shaft")
"""Joints whose spin is counted in whole revolutions."""
ONE_WAY = ("planar", "shaft", "free")
"""Joints whose coordinates cannot be expressed in the reversed joint."""


@dataclass(frozen=True)
class Seat:
    """Parent of a body in the kinematic tree, and the joint to it."""

    body: str
    parent: str = GROUND
    joint: str | None = None
    """Name of the joint, None for a motion against ground."""
    kind: str = "revolute"
    """Type of the joint, or joint type of the motion."""
    turned: bool = False
    """Whether the joint is reversed: it moves its first body."""
    coordinates: tuple[str, ...] = ()
    """Names of the coordinates, in the order of the displacements."""
    beam: str | None = None
    """Beam whose station carries the joint; `parent` is the body that carries the beam."""
    end: str = GROUND
    """End of the joint that carries the body: ground, BODY, BODY.MARKER or BEAM.STATION."""

    @property
    def base(self) -> str:
        """What the joint moves with: the parent, or the beam whose station carries the joint."""
        return self.beam or self.parent


@dataclass(frozen=True)
class Mechanism:
    """Kinematic tree of the bodies and the cut joints that close its loops."""

    seats: Mapping[str, Seat] = field(default_factory=dict)
    """Seat of every body in the tree, parents first."""
    cut: tuple[str, ...] = ()
    """Cut joints, which close loops."""
    floating: tuple[str, ...] = ()
    """Bodies outside the tree."""

    @property
    def carried(self) -> frozenset[str]:
        """Bodies on a joint, and bodies that need one."""
        return frozenset(n for n, s in self.seats.items() if s.joint is not None) | frozenset(self.floating)

    def carrier(self, joint: str) -> Seat | None:
        """Seat of the body on a joint; None for a cut joint."""
        return self._carriers.get(joint)

    def carried_by(self, body: str) -> list[str]:
        """All descendants of a body in the tree, in the order of the seats."""
        found, open_ = {body}, [body]
        while open_:
            for name in self._children.get(open_.pop(), ()):
                found.add(name)
                open_.append(name)
        return [n for n in self.seats if n in found and n != body] if len(found) > 1 else []

    @cached_property
    def _children(self) -> dict[str, list[str]]:
        found: dict[str, list[str]] = {}
        for name, seat in self.seats.items():
            found.setdefault(seat.parent, []).append(name)
        return found

    @cached_property
    def _carriers(self) -> dict[str, Seat]:
        return {s.joint: s for s in self.seats.values() if s.joint is not None}


def hang(parts: Parts) -> Mechanism:
    """Build the kinematic tree and set the field `joint` of every body."""
    joints = {n: j for n, j in parts.joints.items() if _usable(parts, j)}
    roots = _roots(parts, joints)
    seats = {n: roots[n] for n in parts.bodies if n in roots}
    _seat_by_joints(parts, joints, seats)
    used = {s.joint for s in seats.values()}
    order = _sorted(parts, seats)
    for name in parts.bodies:
        seat = seats.get(name)
        parts.bodies[name] = replace(parts.bodies[name], joint=seat.joint if seat is not None else None)
    return Mechanism(
        order,
        tuple(
            n
            for n, j in joints.items()
            if n not in used and all(_hangs(carrier_of(parts, e), seats) for e in j.bodies)
        ),
        tuple(n for n in parts.bodies if n not in seats),
    )


def _usable(parts: Parts, joint: Joint) -> bool:
    ends = [split(e)[0] for e in joint.bodies]
    on_beams = [beam_of(parts, e) is not None for e in joint.bodies]
    known = all(on or e == GROUND or e in parts.bodies for on, e in zip(on_beams, ends, strict=True))
    return known and (ends[0] != ends[1] or (all(on_beams) and joint.bodies[0] != joint.bodies[1]))


def _hangs(body: str, seats: Mapping[str, Seat]) -> bool:
    return body == GROUND or body in seats


def _roots(parts: Parts, joints: Mapping[str, Joint]) -> dict[str, Seat]:
    """Seats of the bodies that move directly against ground: `motion` as given, or torsion for gears and
    discs."""
    ends = {n: [split(e)[0] for e in j.bodies] for n, j in joints.items()}
    moved = {e[1] for n, e in ends.items() if not joints[n].cut}
    standing = {n for n, j in joints.items() if beam_of(parts, j.bodies[1]) is not None} | {
        n for n, e in ends.items() if e[1] == GROUND
    }
    moved |= {ends[n][0] for n in standing if not joints[n].cut}
    found = {}
    for name, body in parts.bodies.items():
        if body.motion is None and (
            name in moved or not (body.gears or body.bevel_gears or (body.is_round and not body.markers))
        ):
            continue
        kind = MOTIONS[body.motion or "torsion"]
        if body.elastic is not None and not body.elastic.rotor:
            kind = "free"  # may tumble
        found[name] = Seat(name, kind=kind, coordinates=COORDINATES[kind])
    return found


def _seat_by_joints(parts: Parts, joints: Mapping[str, Joint], seats: dict[str, Seat]) -> None:
    """Add bodies to the tree by the first joint that can carry its second body, else by a reversed joint.

    A station of a beam is in the tree with the body that carries the beam; joints do not carry stations.
    """
    names = [n for n, j in joints.items() if not j.cut]
    ends = [tuple(carrier_of(parts, e) for e in joints[n].bodies) for n in names]
    beams = [
        tuple(split(e)[0] if beam_of(parts, e) is not None else None for e in joints[n].bodies) for n in names
    ]
    touching: dict[str, list[int]] = {}
    for k, pair in enumerate(ends):
        for body in pair:
            touching.setdefault(body, []).append(k)
    onward: list[int] = []  # heaps of joints whose first (second: `back`) body is in the tree
    back: list[int] = []

    def hangs(body: str) -> None:
        """Register the joints of a body that was added to the tree."""
        for k in touching.get(body, ()):
            if ends[k][0] == body and beams[k][1] is None:
                heappush(onward, k)
            elif ends[k][1] == body and beams[k][0] is None and joints[names[k]].type not in FUNCTIONS:
                heappush(back, k)

    for body in (GROUND, *seats):
        hangs(body)
    while onward or back:
        turned = not onward
        k = heappop(back if turned else onward)
        first, second = ends[k]
        carrier, carried = (second, first) if turned else (first, second)
        if carried == GROUND or carried in seats:
            continue
        joint = joints[names[k]]
        words = _RENAMED.get(joint.type, joint.names) if turned else joint.names
        end = joint.bodies[turned]
        seats[carried] = Seat(carried, carrier, names[k], joint.type, turned, words, beams[k][turned], end)
        hangs(carried)


def _sorted(parts: Parts, seats: Mapping[str, Seat]) -> dict[str, Seat]:
    """Seats with parents first, otherwise in the order of the file."""
    out: dict[str, Seat] = {}
    for name in parts.bodies:
        path, here = [], name if name in seats else GROUND
        while here != GROUND and here not in out:
            path.append(here)
            here = seats[here].parent
        for body in reversed(path):
            out[body] = seats[body]
    return out


def spinner_of(machine: Machine, mechanism: Mechanism, body: str) -> str | None:
    """Body whose spin equals that of `body`, because fixed joints connect them with parallel z axes.

    None for bodies without a fixed joint, and if the revolutions are not counted.
    """
    seat = mechanism.seats.get(body)
    if seat is None or seat.joint is None or seat.kind != "fixed":
        return None
    axis = seat_frame(machine, seat)[1][:, 2]
    while seat is not None and seat.kind == "fixed":
        seat = mechanism.seats.get(seat.parent) if seat.beam is None else None
    if seat is None or seat.kind not in COUNTED:
        return None
    return seat.body if axis @ seat_frame(machine, seat)[1][:, 2] > 1.0 - 1e-12 else None


def base_of(machine: Machine, mechanism: Mechanism, body: str) -> str:
    """Body to which the spin of a body refers: its parent, or the parent of the body whose spin it shares."""
    seat = mechanism.seats.get(spinner_of(machine, mechanism, body) or body)
    return GROUND if seat is None else seat.base


def place_joined(parts: Parts) -> None:
    """Locate bodies from joints to bodies of known position: their markers coincide at the joint.

    Each pass covers the joints in the order of the file; later passes only the joints of bodies that were
    located in the pass before.
    """
    joints = [j for j in parts.joints.values() if j.stage is None and _usable(parts, j)]
    touching: dict[str, list[int]] = {}
    for k, joint in enumerate(joints):
        for body in {b for end in joint.bodies for b in _placing(parts, end)}:
            touching.setdefault(body, []).append(k)
    queue = [(0, k) for k in range(len(joints))]  # round and number, a heap
    while queue:
        turn, k = heappop(queue)
        place = joint_place(parts, joints[k])
        for end in joints[k].bodies:
            body = split(end)[0]
            if place is not None and body in parts.bodies and parts.bodies[body].origin is None:
                x, y, z = (float(v) for v in place - arm(parts, end))
                parts.bodies[body] = replace(parts.bodies[body], origin=(x, y, z))
                for other in touching[body]:
                    heappush(queue, (turn + (other <= k), other))


def _placing(parts: Parts, end: str) -> set[str]:
    """Bodies whose positions define that of an end: for a station those at both ends of its beam."""
    beam = beam_of(parts, end)
    return {split(end)[0]} if beam is None else {b for e in beam.ends for b in _placing(parts, e)}


def seat_frame(machine: Machine, seat: Seat) -> tuple[Array, Array]:
    """Position [m] and axes of the joint frame of a body, or of its own frame for a body with `motion`."""
    if seat.joint is None:
        origin, axes = body_frame(machine, seat.body)
        return (np.zeros(3) if origin is None else origin), axes
    joint = machine.joints[seat.joint]
    place = joint_place(machine, joint)
    axes = joint_axes(machine, joint)
    if seat.turned:
        columns = _TURNED.get(seat.kind, _FLIPPED)
        axes = np.column_stack([sign * axes[:, c] for c, sign in columns])
    return (np.zeros(3) if place is None else place), axes


def axial_offset(machine: Machine, seat: Seat) -> float | None:
    """Axial position of the origin of a body on its spin axis, from the joint [m].

    None if the origin is off the axis or the z axis of the body has another direction.
    """
    place, axes = seat_frame(machine, seat)
    origin, own = body_frame(machine, seat.body)
    if origin is None:
        return None
    apart = origin - place
    along = float(axes[:, 2] @ apart)
    off_axis = float(np.linalg.norm(apart - along * axes[:, 2]))
    if axes[:, 2] @ own[:, 2] < 1.0 - 1e-12 or off_axis > 1e-6 * max(1e-3, abs(along)):
        return None
    return along


def coordinate(mechanism: Mechanism, machine: Machine, name: str) -> tuple[str, int, str] | str:
    """Find a coordinate named JOINT.COORDINATE, or BODY for its spin.

    Returns
    -------
    tuple or str
        Body, index of the coordinate and dimension (length or angle); or the text of the problem.
    """
    part, _, word = name.partition(".")
    if not word:
        return _spin(mechanism, machine, part)
    if part not in machine.joints:
        return f"names the joint {part[:40]!r}, which does not exist"
    joint = machine.joints[part]
    if word not in joint.names:
        listed = ", ".join(joint.names) or "none"
        return f"names {word[:40]!r}, which is not a coordinate of {part} ({joint.type}); it has {listed}"
    seat = mechanism.carrier(part)
    if seat is None:
        return f"names a coordinate of {part}, which closes a loop and has no independent coordinates"
    if seat.turned and joint.type in ONE_WAY:
        return (
            f"names a coordinate of {part}, which is reversed because {seat.end} carries {seat.body}; "
            f"write its bodies as [{', '.join(reversed(joint.bodies))}]"
        )
    if joint.type in TUMBLING and joint.dimension(word) == "angle":
        return f"names a rotation of {part} ({joint.type}), whose rotations are re-referenced during a run"
    return seat.body, seat.coordinates.index(word), joint.dimension(word)


def _spin(mechanism: Mechanism, machine: Machine, body: str) -> tuple[str, int, str] | str:
    if body not in machine.bodies:
        return f"names the body {body[:40]!r}, which does not exist"
    seat = mechanism.seats.get(body)
    if seat is None or seat.kind in (*TUMBLING, *FUNCTIONS) or "spin" not in seat.coordinates:
        how = "" if seat is None or seat.joint is None else f" ({seat.joint}: {seat.kind})"
        own = spinner_of(machine, mechanism, body)
        with_it = f" of its own; it rotates with {own}" if own not in (None, body) else ""
        return f"names {body}{how}, which has no spin{with_it}"
    return body, seat.coordinates.index("spin"), "angle"


def given(mechanism: Mechanism, machine: Machine, key: str) -> tuple[str, ...]:
    """Coordinates with initial values in the joints, by their system names BODY.DISPLACEMENT.

    Parameters
    ----------
    mechanism, machine
        Tree and parts.
    key
        "start" for their values, "speed" for their rates.
    """
    found = []
    for seat in mechanism.seats.values():
        if seat.joint is not None:
            words = COORDINATES[seat.kind] or seat.coordinates
            values = getattr(machine.joints[seat.joint], key)
            pairs = zip(words, seat.coordinates, strict=True)
            found += [f"{seat.body}.{word}" for word, own in pairs if own in values]
    return tuple(found)


def rows_of(joint: Joint) -> int:
    """Number of constraint rows of a joint."""
    return 6 - len(joint.names)


def freedoms(mechanism: Mechanism, machine: Machine, others: int = 0) -> tuple[int, int]:
    """Number of tree coordinates, and degrees of freedom by Gruebler's formula (ignores redundant
    constraints).

    Parameters
    ----------
    mechanism, machine
        Tree and parts.
    others
        Further constraint rows: rods and ratios.
    """
    count = sum(len(s.coordinates) for s in mechanism.seats.values())
    return count, count - sum(rows_of(machine.joints[j]) for j in mechanism.cut) - others


def same_base(parts: Parts, one: str, two: str) -> bool:
    """Whether two bodies have the same parent, so that their spins refer to the same frame."""
    seats = parts.mechanism.seats
    return one not in seats or two not in seats or seats[one].base == seats[two].base
