# SPDX-License-Identifier: Apache-2.0
"""Loops of meshes, couplings and ratios whose ratios contradict each other, so that nothing in them can
rotate."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.model.carried_trains import SAME, line_carrier, null_space, relation, spin_row
from pitchpoint.model.keys import Place
from pitchpoint.model.speed_ratios import Link, fixed_bodies, links_of

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts

GEARED = ("meshes", "bevel_meshes", "ratios")
"""Sections of links that are not elastic."""


@dataclass(frozen=True)
class LockedLoop:
    """A link that contradicts the others of its train.

    Attributes
    ----------
    link
        Key of the link.
    bodies
        Its bodies.
    ratio, other
        Speed of the second over that of the first body, relative to the carrier of their line of centres: by
        the link, and by the others.
    through
        Keys of the others.
    """

    link: Place
    bodies: tuple[str, str]
    ratio: float
    other: float
    through: tuple[Place, ...]

    @property
    def words(self) -> tuple[str, str]:
        """Ratio of the link and of the others, in words."""
        one, two = self.bodies
        names = ", ".join(".".join(map(str, place)) for place in self.through)
        return f"{two}/{one} = {self.ratio:.7g}", f"{self.other:.7g} through {names}"


def locked_loops(parts: Parts) -> list[LockedLoop]:
    """One link for every train that its own ratios lock.

    Trains with a fixed body are held, not locked.

    Parameters
    ----------
    parts
        A model or the parts of one.
    """
    turning = [name for name, seat in parts.mechanism.seats.items() if "spin" in seat.coordinates]
    place = {name: k for k, name in enumerate(turning)}
    fixed = fixed_bodies(parts)
    groups: list[tuple[set[int], list[tuple[Link, np.ndarray]]]] = []
    for link in links_of(parts):
        row = relation(parts, place, link)
        spins = set(np.flatnonzero(row).tolist())
        if not spins:
            continue
        joined = [g for g in groups if g[0] & spins]
        groups = [g for g in groups if not g[0] & spins]
        groups.append(
            (spins.union(*(g[0] for g in joined)), [*(e for g in joined for e in g[1]), (link, row)])
        )
    found = []
    for _, links in groups:
        if not any({*link[1:3]} & fixed for link, _ in links) and (loop := _locked(parts, place, links)):
            found.append(loop)
    return found


def loop_with(loops: Sequence[LockedLoop], link: Place) -> LockedLoop | None:
    """Loop that contains a link, if any."""
    return next((loop for loop in loops if link in (loop.link, *loop.through)), None)


def _locked(parts: Parts, place: dict[str, int], links: list[tuple[Link, np.ndarray]]) -> LockedLoop | None:
    """Last link of a train without which it can rotate; None if it can rotate with all of them."""
    if len(links) == 1 and links[0][0][0][0] not in GEARED:
        return None  # a spring between a body and the one that carries it holds their joint
    spins = sorted({s for _, row in links for s in np.flatnonzero(row).tolist()})
    if null_space(np.array([row for _, row in links])[:, spins], len(spins)).shape[1]:
        return None
    for k in reversed(range(len(links))):
        (where, one, two, ratio), _ = links[k]
        others = [each for j, each in enumerate(links) if j != k]
        free = null_space(np.array([row for _, row in others]).reshape(-1, len(place))[:, spins], len(spins))
        if free.shape[1] != 1:
            continue
        speeds = np.zeros(len(place))
        speeds[spins] = free[:, 0]
        carrier = line_carrier(parts, one, two) if where[0] in ("meshes", "bevel_meshes") else None
        turns = []
        for body in (one, two):
            base = spin_row(parts, place, carrier, about=body) if carrier is not None else 0.0
            turns.append(float((spin_row(parts, place, body) - base) @ speeds))
        if abs(turns[0]) > SAME:
            through = tuple(link[0] for link, _ in others)
            return LockedLoop(where, (one, two), ratio, turns[1] / turns[0], through)
    return None
