# SPDX-License-Identifier: Apache-2.0
"""Loop-closing joints and rods as constraint rows."""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.errors import CompileError
from pitchpoint.elements import closure as element
from pitchpoint.elements.closure_rows import cut_joint, rod
from pitchpoint.model.frames import joint_axes, joint_place, split
from pitchpoint.system.rules.bank import Bank
from pitchpoint.system.rules.bodies import CODES, end_of, frame_at, world_place
from pitchpoint.system.rules.places import Places


def closure_bank(places: Places) -> Bank:
    """Rows of all cut joints and rods, named by the constrained direction as JOINT.x, JOINT.xy etc."""
    model, tree = places.model, places.tree
    records, names = [np.zeros(0, element.RECORD)], []
    for name in model.mechanism.cut:
        joint = model.joints[name]
        place = joint_place(model, joint)
        if place is None:
            raise CompileError(f"joints.{name}: has no position")
        base, moved = (frame_at(model, split(e)[0], place)[0] for e in joint.bodies)
        lead = (joint.lead or 0.0) / math.tau
        axes = joint_axes(model, joint)
        rows, words = cut_joint(CODES[joint.type], tree, moved, base, place, axes, lead)
        records.append(rows)
        names += [f"{name}.{word}" for word in words]
    for name, part in model.rods.items():
        one, two = part.ends
        ends = end_of(model, one)[0], end_of(model, two)[0]
        records.append(rod(tree, *ends, world_place(model, one), world_place(model, two), part.length))
        names.append(name)
    return Bank("closure", np.concatenate(records), tuple(names))
