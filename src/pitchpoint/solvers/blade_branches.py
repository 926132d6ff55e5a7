# SPDX-License-Identifier: Apache-2.0
"""Blades as branches of a hub: their bodies, coordinates and states, and what makes them equal.

The coordinates of a blade are compared with those of the first one by the motions of its bodies in axes that
are turned with the blade, so that the axes of the bodies do not matter.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.elements.kind import SIGNAL
from pitchpoint.elements.registry import find
from pitchpoint.solvers.body_shapes import body_motions
from pitchpoint.system import evaluate
from pitchpoint.system.system import System

Array = NDArray[np.float64]

LEAST = 3
"""Least number of blades."""
ALIKE = 1e-3
"""Largest difference of motions, masses and angles of the blades, relative to the largest."""


@dataclass(frozen=True)
class BladedHub:
    """Body of the hub; bodies, coordinates and states of each blade, azimuths relative to the first [rad]."""

    hub: int
    bodies: list[list[int]]
    coordinates: list[list[int]]
    states: list[list[int]]
    angles: Array

    @property
    def columns(self) -> list[list[int]]:
        """Coordinates of each blade, states last."""
        return [one + two for one, two in zip(self.coordinates, self.states, strict=True)]


def bladed_hub(system: System, hub: str, blades: Sequence[str]) -> BladedHub:
    """Bodies and coordinates of the blades, and their azimuths, as drawn."""
    names, table = list(system.layout.bodies), system.program["body"]
    beams = system.model.beams if system.model is not None else {}
    if unknown := [name for name in (hub, *blades) if name not in names and name not in beams]:
        raise CompileError(
            f"{', '.join(unknown)}: no body or beam has this name; name hub and blades of the model"
        )
    if len(blades) < LEAST:
        raise CompileError(
            f"blades: {len(blades)} blades (limit {LEAST}); matrices of rotors with fewer remain periodic"
        )
    center = names.index(hub)
    branches = [_branch(system, center, _first_body(names, beams, name), name) for name in blades]
    coordinates = [
        [int(table[b]["dof"]) + c for b in branch for c in range(table[b]["n"])] for branch in branches
    ]
    states = [_states_of(system, branch) for branch in branches]
    numbers = {(len(own), len(more)) for own, more in zip(coordinates, states, strict=True)}
    if len(numbers) > 1 or len({body for branch in branches for body in branch}) < sum(map(len, branches)):
        raise CompileError(
            "blades: are not equal branches of the hub; give blades of the same bodies and beams"
        )
    evaluate.residual(system, system.initial_state())
    frames = system.workspace.fr
    places = frames["r"] + np.einsum("bij,bj->bi", frames["S"], table["com"])
    arms = np.array([places[branch].mean(axis=0) for branch in branches]) - frames["r"][center]
    x, y = (arms @ frames["R"][center][:, :2]).T
    angles = np.arctan2(y, x)
    return BladedHub(center, branches, coordinates, states, angles - angles[0])


def _first_body(names: list[str], beams: Mapping[str, Any], name: str) -> int:
    """Body of a blade, the one at the first end of a beam."""
    return names.index(beams[name].ends[0].partition(".")[0] if name in beams else name)


def _branch(system: System, center: int, at: int, name: str) -> list[int]:
    """All bodies of the branch of the hub that carries a body."""
    table = system.program["body"]
    while at and table[at]["parent"] != center:
        at = int(table[at]["parent"])
    if not at:
        raise CompileError(
            f"{name}: is not carried by {system.layout.bodies[center]}; name a blade of this hub"
        )
    branch = [at]
    for k in range(at + 1, len(table)):
        if table[k]["parent"] in branch and not table[k]["state"]:
            branch.append(k)
    return branch


def _states_of(system: System, branch: list[int]) -> list[int]:
    """Coordinates whose rates are states of elements on a blade, such as those of the air, not of control."""
    table, found = system.program["body"], []
    for name, bank in system.records.items():
        kind = find(name)
        fields = dict.fromkeys(field for pair in kind.pairs if kind.role != SIGNAL for field in pair)
        for record in bank:
            ends = [int(record[field]) for field in fields]
            if not set(ends).isdisjoint(branch):
                found += [int(table[b]["spin"]) for b in ends if table[b]["state"]]
    return list(dict.fromkeys(found))


def _change(one: Array, other: Array) -> float:
    """Largest difference over the largest value."""
    return float(np.abs(one - other).max() / np.abs(other).max())


def equal_coordinates(system: System, rotor: BladedHub) -> list[Array]:
    """Coordinates of every blade for unit coordinates of the first blade, with the same motions, as drawn."""
    from scipy.linalg import block_diag

    drawn = system.initial_state()
    evaluate.residual(system, drawn)
    axis = system.workspace.fr["R"][rotor.hub][:, 2].copy()
    own = []
    for branch, at, angle in zip(rotor.bodies, rotor.coordinates, rotor.angles, strict=True):
        unit = np.zeros((len(at), system.sizes["nd"]))
        unit[np.arange(len(at)), at] = 1.0
        moved = body_motions(system, drawn, unit)[:, branch]
        back = rotation(axis, -angle)
        turned = np.concatenate([moved[..., :3] @ back.T, moved[..., 3:] @ back.T], axis=-1)
        own.append(turned.reshape(len(at), -1).T)
    found = [np.linalg.lstsq(X, own[0], rcond=None)[0] for X in own]
    M = evaluate.matrix(system, drawn, 1.0, 0.0, 0.0)
    masses = [Q.T @ M[np.ix_(at, at)] @ Q for Q, at in zip(found, rotor.coordinates, strict=True)]
    steps = np.diff(np.sort(np.mod(rotor.angles + ALIKE, math.tau)))
    for what, worst in (
        ("motions", max(_change(X @ Q, own[0]) for X, Q in zip(own, found, strict=True))),
        ("masses", max(_change(mass, masses[0]) for mass in masses)),
        ("angles between them", float(np.abs(steps * len(own) / math.tau - 1.0).max())),
    ):
        if worst > ALIKE:
            raise CompileError(
                f"blades: their {what} differ by {100.0 * worst:.2g} % (limit {100.0 * ALIKE:g} %); "
                "give equal blades with equal angles between them"
            )
    return [block_diag(Q, np.eye(len(own))) for Q, own in zip(found, rotor.states, strict=True)]


def rotation(axis: Array, angle: float) -> Array:
    """Rotation matrix about a unit vector, shape (3, 3)."""
    S = np.array([[0.0, -axis[2], axis[1]], [axis[2], 0.0, -axis[0]], [-axis[1], axis[0], 0.0]])
    return np.asarray(np.eye(3) + math.sin(angle) * S + (1.0 - math.cos(angle)) * S @ S)
