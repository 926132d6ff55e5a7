# SPDX-License-Identifier: Apache-2.0
"""Mechanisms as they stand in files: a slider-crank, chains, and how to move or reverse one."""

from __future__ import annotations

import copy

import numpy as np

from pitchpoint.model.build import build_model
from pitchpoint.model.reading.reader import Reader
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.engine import frame
from tests.support.trees import positive_inertia

SLIDER_CRANK = """\
bodies:
  crank:
    mass: 1 kg
    center_of_mass: [40 mm, 5 mm, 0]
    inertia_tensor: [2e-4, 1.1e-3, 1.2e-3, 0, 0, 0]
    markers: {pin: {position: [100 mm, 0, 0]}}
  rod:
    mass: 0.8 kg
    center_of_mass: [120 mm, 0, 0]
    inertia_tensor: [1e-4, 8e-3, 8e-3, 0, 0, 0]
    markers: {big: {}, small: {position: [300 mm, 0, 0]}}
  piston: {mass: 0.5 kg}
joints:
  main: {type: revolute, bodies: [ground, crank], position: [0, 0, 0]}
  crank_pin: {type: revolute, bodies: [crank.pin, rod.big]}
  cylinder: {type: prismatic, bodies: [ground, piston], axes: {z: [1, 0, 0]}}
  piston_pin: {type: revolute, bodies: [rod.small, piston]}
"""


def model_of(data):
    """Model of a mapping."""
    return build_model(copy.deepcopy(data), Reader())


def system_of(data, scenario=None):
    """Model and system of a mapping."""
    model = model_of(data)
    return model, compile_model(model, scenario)


def vector(x):
    """Array as it stands in a file."""
    return [float(v) for v in x]


def axes(columns):
    """Frame as it stands in a file."""
    return {"z": vector(columns[:, 2]), "x": vector(columns[:, 0])}


def heavy(rng):
    """Keys of a body with a mass of its own."""
    about = positive_inertia(rng)
    return {
        "mass": float(rng.uniform(0.5, 2.0)),
        "center_of_mass": vector(0.3 * rng.normal(size=3)),
        "inertia_tensor": vector(about[(0, 1, 2, 0, 1, 2), (0, 1, 2, 1, 2, 0)]),
    }


def random_chain(rng, types, parents):
    """Bodies b1, b2 ... with random places, axes and masses on joints j1, j2 ...; parent 0 is ground."""
    bodies, joints = {}, {}
    for k, (word, parent) in enumerate(zip(types, parents, strict=True), start=1):
        bodies[f"b{k}"] = heavy(rng) | {"position": vector(rng.normal(size=3)), "axes": axes(frame(rng))}
        joints[f"j{k}"] = {
            "type": word,
            "bodies": [f"b{parent}" if parent else "ground", f"b{k}"],
            "position": vector(rng.normal(size=3)),
            "axes": axes(frame(rng)),
        } | ({"lead": 0.3} if word == "screw" else {})
    return {"bodies": bodies, "joints": joints}


def moved(data, shift, turn):
    """The same mechanism with the world moved and turned."""
    data = copy.deepcopy(data)
    for part in (*data["bodies"].values(), *data.get("joints", {}).values()):
        if "position" in part:
            part["position"] = vector(turn @ np.array(part["position"]) + shift)
        given = part.get("axes")
        if given is None:
            given = axes(np.eye(3)) if "mass" in part else None
        if given is not None:
            part["axes"] = {word: vector(turn @ np.array(v)) for word, v in given.items()}
    if "gravity" in data:
        data["gravity"] = vector(turn @ np.array(data["gravity"]))
    return data


def reversed_joints(data):
    """The same mechanism with the bodies of every joint exchanged."""
    data = copy.deepcopy(data)
    for joint in data["joints"].values():
        joint["bodies"] = joint["bodies"][::-1]
    return data


def accelerations(system, state):
    """Accelerations of all coordinates, and the frames that go with them."""
    evaluate.prepare(system)
    evaluate.load(system, state)
    evaluate.check(system, evaluate.send_request(system.workspace, evaluate.ACCELERATE, state.t))
    found = evaluate.store(system, state.t)
    evaluate.residual(system, found)
    return found.a, system.workspace.fr.copy()


def centers(system, frames):
    """Acceleration of the centre of mass and angular acceleration of every body by name, world axes."""
    found = {}
    for k, body in enumerate(system.bodies, start=1):
        f = frames[k]
        S = f["R"] @ np.array(
            [
                [np.cos(f["phi"]), -np.sin(f["phi"]), 0.0],
                [np.sin(f["phi"]), np.cos(f["phi"]), 0.0],
                [0.0, 0.0, 1.0],
            ]
        )
        arm = S @ body.center_of_mass()
        w, e = f["tw"][3:], f["ac"][3:]
        found[body.name] = np.concatenate([f["ac"][:3] + np.cross(e, arm) + np.cross(w, np.cross(w, arm)), e])
    return found
