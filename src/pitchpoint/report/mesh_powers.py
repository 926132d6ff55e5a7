# SPDX-License-Identifier: Apache-2.0
"""What the forces of a mesh give to both gears and to all that carries them, by torques about axes at rest.

A force F along the base tangent turns gear k by -r_bk F (mesh damper included), friction by the torques that
the mesh shows. From the torques M_1 and M_2 about both axes follows that about any axis between: the gears
push each other with opposite wrenches, so what acts on gear 2 has the torque -M_1 about the axis of gear 1.
About an axis aside from both the other parts of the force count as well.
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
    """Torque about an axis of what acts on gear 2.

    Attributes
    ----------
    shares
        Factors of -M_1 and M_2.
    aside
        Factors of the parts of the force [m].
    """

    shares: tuple[float, float]
    aside: Array


def shows_friction(machine: Machine, name: str) -> bool:
    """Whether a result states what friction does to each gear of a mesh."""
    return all(f"{word}[{name}]" in machine.result for word in FRICTION)


def mesh_powers(machine: Machine, mesh: int, record: np.void, name: str) -> list[float]:
    """Mean powers that both gears of a mesh, and what carries them, get from it [W].

    Parameters
    ----------
    machine
        The machine and its result.
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
    """Torque about the axis of body `a`, out of torques about those of both gears."""
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
    """Values without the round-off of places and axes."""
    return np.where(np.abs(values) < 1e-12, 0.0, values)
