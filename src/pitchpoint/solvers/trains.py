# SPDX-License-Identifier: Apache-2.0
"""Trains: bodies that can only turn together, and the rotations that nothing hinders.

Bodies turn together through meshes and through bearings and couplings with a stiffness about the axis. What
is stiff in other directions only, like the bearings of a shaft in a housing that moves, lets them turn.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.ratio import is_gear_pair
from pitchpoint.system.system import System

SAME_SPEED = 1e-6
"""Relative difference up to which the ratios round a loop of links fit each other."""


@dataclass(frozen=True)
class Train:
    """Bodies that turn together.

    Parameters
    ----------
    speeds
        Speed of each body, by its index, while the first one turns at 1 rad/s.
    free
        Whether it can turn as a whole: nothing of it stands still or is joined to the ground about its axis,
        and no loop of it is locked by ratios that contradict each other.
    """

    speeds: dict[int, float]
    free: bool


def trains(system: System) -> tuple[Train, ...]:
    """All trains of a system, by their first bodies; a body that nothing turns is a train of its own."""
    links = _links(system)
    found: list[Train] = []
    seen: set[int] = set()
    for first in range(1, len(system.layout.bodies)):
        if first in seen or system.program["body"][first]["spin"] < 0:
            continue
        found.append(_train(first, links))
        seen |= found[-1].speeds.keys()
    return tuple(found)


def _links(system: System) -> dict[int, list[tuple[int, float]]]:
    """Speed of a neighbour per own speed, by body; what stands still is body 0."""
    still = {b for b in range(len(system.layout.bodies)) if system.program["body"][b]["spin"] < 0}
    links: dict[int, list[tuple[int, float]]] = {b: [] for b in range(len(system.layout.bodies))}
    for kind, records in system.records.items():
        for record in records:
            if kind == "gear_mesh":
                ratio = -float(record["z1"]) / float(record["z2"])
            elif kind == "ratio" and is_gear_pair(record):
                ratio = -float(record["c_i"]) / float(record["c_j"])
            elif kind == "coupling" or (kind == "bearing" and record["K"][5, 5] != 0.0):
                ratio = 1.0
            else:
                continue
            i, j = (0 if int(record[end]) in still else int(record[end]) for end in ("i", "j"))
            if i != j:
                links[i].append((j, ratio))
                links[j].append((i, 1.0 / ratio))
    return links


def _train(first: int, links: dict[int, list[tuple[int, float]]]) -> Train:
    """The train of one body."""
    speeds = {first: 1.0}
    free = True
    queue = deque([first])
    while queue:
        here = queue.popleft()
        for there, ratio in links[here]:
            speed = ratio * speeds[here]
            if there == 0:
                free = False
            elif there not in speeds:
                speeds[there] = speed
                queue.append(there)
            elif abs(speeds[there] - speed) > SAME_SPEED * abs(speed):
                free = False
    return Train(speeds, free)


def free_spins(system: System) -> tuple[int, ...]:
    """Spin coordinate of the first body of every train that can turn as a whole."""
    body = system.program["body"]
    return tuple(int(body[next(iter(train.speeds))]["spin"]) for train in trains(system) if train.free)


def same_train(system: System, one: int, two: int) -> bool:
    """Whether two spin coordinates belong to one train, so that holding either holds both."""
    spins = system.program["body"]["spin"]
    return any({one, two} <= {int(spins[b]) for b in train.speeds} for train in trains(system))


def driven_spins(system: System) -> tuple[int, ...]:
    """Spin coordinates of the bodies whose motion is prescribed, in the order of the drives."""
    records = system.records.get("drive", ())
    return tuple(int(system.program["body"][int(r["i"])]["spin"]) for r in records if r["other"] == 0)


def held_spins(system: System) -> tuple[int, ...]:
    """Spins of driven bodies, and one of every train that nothing else keeps from turning."""
    driven = driven_spins(system)
    return (*driven, *(h for h in free_spins(system) if not any(same_train(system, h, d) for d in driven)))


def rotations(system: System, spins: Sequence[int]) -> NDArray[np.float64]:
    """Rates of all coordinates as the trains of some spins turn, those at 1 rad/s, shape (nd, len(spins))."""
    of_body = system.program["body"]["spin"]
    rates = np.zeros((system.sizes["nd"], len(spins)))
    found = trains(system)
    for column, spin in enumerate(spins):
        for train in found:
            speeds = {int(of_body[body]): speed for body, speed in train.speeds.items()}
            if spin in speeds:
                for turning, speed in speeds.items():
                    rates[turning, column] = speed / speeds[spin]
    return rates
