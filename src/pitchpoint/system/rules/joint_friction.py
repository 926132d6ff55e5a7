# SPDX-License-Identifier: Apache-2.0
"""Joint friction as records; loads of tree joints from outboard bodies, of cut joints from their rows."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.elements import joint_friction as element
from pitchpoint.elements.signal import Pool
from pitchpoint.model.frames import joint_axes, joint_place, split
from pitchpoint.model.mechanism import Seat, rows_of, seat_frame
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bodies import body_numbers, frame_at
from pitchpoint.system.rules.places import Places

if TYPE_CHECKING:
    from pitchpoint.model.components.joint import Joint
    from pitchpoint.model.model import Model


def friction_bank(places: Places) -> Bank:
    """Friction of all joints with friction."""
    model, bodies = places.model, places.tree
    number = body_numbers(model)
    pool = Pool()
    rows, names = [], []
    first = {}  # first closure record of each cut joint
    count = 0
    for name in model.mechanism.cut:
        first[name] = count
        count += rows_of(model.joints[name])
    for name, joint in model.joints.items():
        if joint.friction is None:
            continue
        row = np.zeros(1, element.RECORD)[0]
        seat = model.mechanism.carrier(name)
        if seat is not None:
            row["i"], row["j"] = number[seat.body], frame_at(model, seat.base, joint_place(model, joint))[0]
            beyond = element.bodies_beyond(bodies, number[seat.body])
            row["n_beyond"], row["beyond"] = beyond.size, pool.add(beyond.view(np.float64))
        else:
            at = joint_place(model, joint)
            row["j"], row["i"] = (frame_at(model, split(e)[0], at)[0] for e in joint.bodies)
            row["n_rows"], row["rows"] = rows_of(joint), first[name]
        for axis, coordinate in _pins(joint):
            one = row.copy()
            _place(one, model, joint, seat, axis)
            _law(one, joint)
            rows.append(one)
            names.append(f"{name}.{coordinate}" if coordinate else name)
    return pack("joint_friction", element.RECORD, rows, names, pool=pool.array())


def _pins(joint: Joint) -> tuple[tuple[int, str], ...]:
    """Axes of the joint frame with friction, and names of the coordinates if there are several.

    The cross of a universal joint turns about x of the body that carries it and about y of the moved body.
    """
    return ((0, "alpha"), (1, "beta")) if joint.type == "universal" else ((2, ""),)


def _place(row: Any, model: Model, joint: Joint, seat: Seat | None, column: int) -> None:
    """Set position and axis (column of its frame) of the joint in the frames of both bodies."""
    place = joint_place(model, joint)
    axis = (joint_axes(model, joint) if seat is None else seat_frame(model, seat)[1])[:, column]
    row["on_i"] = column == 1
    ends = [split(e)[0] for e in joint.bodies] if seat is None else [seat.base, seat.body]
    for end, body in zip("ji", ends, strict=True):
        _, at, axes = frame_at(model, body, place)
        row[f"p_{end}"] = axes.T @ ((at if place is None else place) - at)
        if end == "ji"[column == 1]:
            row["axis"] = axes.T @ axis


FORMS = {
    "revolute": element.TURN,
    "universal": element.TURN,
    "prismatic": element.WAY,
    "screw": element.THREAD,
    "cylindrical": element.BUSH,
    "spherical": element.BALL,
    "planar": element.PLATE,
}


def _law(row: Any, joint: Joint) -> None:
    """Set lever arms and coefficients.

    Those of pins and balls refer to their radius, as the friction is a torque; all others to forces.
    """
    part = joint.friction
    if part is None:
        return
    form = row["form"] = FORMS[joint.type]
    turns = form in (element.TURN, element.BALL)
    arm = (part.radius or 0.0) if turns else 1.0
    row["radius"] = part.radius or 0.0
    row["c_r"] = 0.0 if form == element.PLATE else arm
    row["c_a"] = 1.0 if form == element.PLATE else part.shoulder_radius
    if form == element.THREAD:
        row["lead"] = (joint.lead or 0.0) / (2.0 * math.pi)
        row["c_a"] = math.hypot(row["radius"], row["lead"]) / row["radius"]
    row["c_m"] = 2.0 * arm / part.length if part.length is not None else 0.0
    row["preload"] = part.preload * arm
    row["mu"], row["ratio"] = part.coefficient, part.static_ratio
    row["v_s"], row["v_eps"] = part.stribeck_speed / arm, part.slip_speed / arm
