# SPDX-License-Identifier: Apache-2.0
"""Power of mesh forces on both gears and on the bodies that carry them, from torques about fixed axes.

A force F along the base tangent (mesh damper included) exerts the torque -r_bk F on gear k; friction exerts
the torques recorded by the mesh. The torques M_1 and M_2 about both axes determine the torque about any axis
in their plane: the wrenches on the gears are opposite, so the force on gear 2 has the torque -M_1 about the
axis of gear 1. About an axis outside this plane the other force components contribute, too.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.system.meshes import is_bevel

if TYPE_CHECKING:
    from pitchpoint.report.power_flow import Machine

Array = NDArray[np.float64]

PARTS = ("circumferential", "radial", "axial")
FRICTION = ("friction_torque_1", "friction_torque_2")


@dataclass(frozen=True)
class Arms:
    """Torque of the force on gear 2 about an axis.

    Attributes
    ----------
    shares
        Factors of -M_1 and M_2.
    aside
        Lever arms of the force components [m].
    """

    shares: tuple[float, float]
    aside: Array


def shows_friction(machine: Machine, name: str) -> bool:
    """Whether a result contains the friction torques on each gear of a mesh."""
    return all(f"{word}[{name}]" in machine.result for word in FRICTION)


def mesh_powers(machine: Machine, mesh: int, record: np.void, name: str) -> list[float]:
    """Mean powers supplied by a mesh to both gears and to the bodies that carry them [W].

    Parameters
    ----------
    machine
        Machine with its result.
    mesh, record, name
        Number, record and name of the mesh.
    """
    rubs = shows_friction(machine, name)
    pair = int(record["i"]), int(record["j"])
    found = []
    for side, b in enumerate(pair):
        power = 0.0
        for a in machine.carriers(b):
            arms = _arms(machine, mesh, record, pair, a)
            speed = machine.spin[a] * (1.0, -1.0)[side]
            for k, sign in enumerate((1.0, -1.0)):
                share = sign * arms.shares[k]
                if share:
                    power -= machine.power(
                        f"mesh_force[{name}]", share * float(record[f"r_b{k + 1}"]) * speed
                    )
                    power += machine.power(f"{FRICTION[k]}[{name}]", share * speed) if rubs else 0.0
            for arm, part in zip(arms.aside, PARTS, strict=True):
                power -= machine.power(f"{part}_force[{name}]", arm * speed) if arm else 0.0
        found.append(power)
    return found


def _arms(machine: Machine, mesh: int, record: np.void, pair: tuple[int, int], a: int) -> Arms:
    """Torque about the axis of body `a` from the torques about the axes of both gears."""
    if a in pair:
        return Arms((float(a == pair[0]), float(a == pair[1])), np.zeros(3))
    axis, at = machine.axis[a], machine.place[a]
    rows = machine.directions[mesh]
    if not is_bevel(record):
        t, e, m = rows
        first, second = (machine.place[b] for b in pair)
        along = float((at - first) @ e) / float((second - first) @ e)
        sense = float(axis @ m)
        aside = float((at - first) @ t)
        return Arms(
            _rounded(sense * (1.0 - along), sense * along), _near(np.array([0.0, sense * aside, 0.0]))
        )
    one, two = (machine.axis[b] for b in pair)
    apex = machine.place[pair[1]] + float(record["apex"][1]) * two
    across = np.cross(one, two)
    across /= np.linalg.norm(across)
    shares = np.linalg.solve(np.column_stack((one, two, across)), axis)
    arm = shares[2] * np.cross(across, machine.pitch_points[mesh] - apex) + np.cross(axis, apex - at)
    return Arms(_rounded(*shares[:2]), _near(rows @ arm))


def _rounded(one: float, two: float) -> tuple[float, float]:
    found = _near(np.array([one, two]))
    return float(found[0]), float(found[1])


def _near(values: Array) -> Array:
    """Values with round-off of positions and axes set to zero."""
    return np.where(np.abs(values) < 1e-12, 0.0, values)
