# SPDX-License-Identifier: Apache-2.0
"""Joint friction as records; loads of tree joints from outboard bodies, of cut joints from their rows."""

from __future__ import annotations

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
            row["i"], row["j"] = number[seat.body], frame_at(model, seat.parent, joint_place(model, joint))[0]
            beyond = element.bodies_beyond(bodies, number[seat.body])
            row["n_beyond"], row["beyond"] = beyond.size, pool.add(beyond.view(np.float64))
        else:
            at = joint_place(model, joint)
            row["j"], row["i"] = (frame_at(model, split(e)[0], at)[0] for e in joint.bodies)
            row["n_rows"], row["rows"] = rows_of(joint), first[name]
        _place(row, model, joint, seat)
        _law(row, joint)
        rows.append(row)
        names.append(name)
    return pack("joint_friction", element.RECORD, rows, names, pool=pool.array())


def _place(row: Any, model: Model, joint: Joint, seat: Seat | None) -> None:
    """Set position and axis of the joint in the frames of both bodies."""
    place = joint_place(model, joint)
    axis = joint_axes(model, joint)[:, 2] if seat is None else seat_frame(model, seat)[1][:, 2]
    ends = [split(e)[0] for e in joint.bodies] if seat is None else [seat.parent, seat.body]
    for end, body in zip("ji", ends, strict=True):
        _, at, axes = frame_at(model, body, place)
        row[f"p_{end}"] = axes.T @ ((at if place is None else place) - at)
        if end == "j":
            row["axis"] = axes.T @ axis


def _law(row: Any, joint: Joint) -> None:
    """Set lever arms and coefficients; those of a pin refer to its radius, those of a slide to travel."""
    part = joint.friction
    if part is None:
        return
    radius = (part.radius or 0.0) if joint.type == "revolute" else 1.0
    row["form"] = element.TURN if joint.type == "revolute" else element.WAY
    row["c_r"], row["c_a"] = radius, part.shoulder_radius if joint.type == "revolute" else 0.0
    row["c_m"] = 2.0 * radius / part.length if part.length is not None else 0.0
    row["preload"] = part.preload * radius
    row["mu"], row["ratio"] = part.coefficient, part.static_ratio
    row["v_s"], row["v_eps"] = part.stribeck_speed / radius, part.slip_speed / radius
