# SPDX-License-Identifier: Apache-2.0
"""A model written in a turned world: every place and direction of its file is turned by one rotation."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.model.components.law import Constant
from pitchpoint.model.components.marker import Axes
from pitchpoint.model.frames import body_frame, joint_axes


def about(axis, angle):
    """Rotation about an axis by an angle [rad] (Rodrigues)."""
    x, y, z = np.array(axis, float) / np.linalg.norm(axis)
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + np.sin(angle) * K + (1.0 - np.cos(angle)) * K @ K


def turned(model, R):
    """The same machine in a world turned by R, read back from the text of its file."""

    def triple(v):
        return None if v is None else tuple(float(x) for x in R @ np.array(v, float))

    def directions(columns):
        return Axes(z=triple(columns[:, 2]), x=triple(columns[:, 0]))

    def standing(name, part):
        return replace(part, position=triple(part.position), axes=directions(body_frame(model, name)[1]))

    def hinged(joint):
        given = joint.axes is not None or not any("." in end for end in joint.bodies)
        return replace(
            joint,
            position=triple(joint.position),
            axes=directions(joint_axes(model, joint)) if given else None,
        )

    def pushed(load):
        if load.force is None or load.along == "marker":
            return load
        assert all(isinstance(f, Constant) for f in load.force)
        return replace(load, force=tuple(Constant(x) for x in triple([f.value for f in load.force])))

    bodies = {n: standing(n, b) for n, b in model.bodies.items() if not b.stands_in}
    new = replace(
        model,
        gravity=triple(model.gravity),
        bodies=bodies,
        shafts={n: standing(n, s) for n, s in model.shafts.items()},
        elastic_bodies={n: standing(n, e) for n, e in model.elastic_bodies.items()},
        joints={n: hinged(j) for n, j in model.joints.items()},
        loads={n: pushed(p) for n, p in model.loads.items()},
    )
    return loads_model(dump_model(new), allow_code=True)
