# SPDX-License-Identifier: Apache-2.0
"""Angles between planets at which their teeth fit, for any chain of equal planets on one carrier.

Planets fit into the places that the first ones have left, turned by psi about the axis of the carrier, if
every mesh then is off by whole pitches. With signed numbers of teeth z, psi/2pi = y and the rotation of each
planet x in turns, that is z_p x - z_c y = whole for a mesh with a central gear c, and z_p x + z_q x' = whole
for a mesh of two planets. Derivation: docs/theory/planetary_stages.md, "Assembly".
"""

from __future__ import annotations

import math
from collections.abc import Hashable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from pitchpoint.model.planet_places import inner_stage

if TYPE_CHECKING:
    from pitchpoint.model.components.planetary_stage import PlanetaryStage


def spacing_teeth(meshes: Sequence[tuple[Mapping[Hashable, int], int]]) -> int:
    """Number of places on a turn of the carrier at which planets fit; 0: at any angle.

    Parameters
    ----------
    meshes
        For each mesh the numbers of teeth of the planets by rotating part, and the signed number of teeth of
        the central gear (negative for a ring), 0 between planets.

    Examples
    --------
    Sun of 21 and ring of 99 teeth with single planets of 39; stepped planets of 39/30 teeth with a ring of
    90; and planets of 20 and 24 in series between a sun of 30 and a ring of 84:

    >>> spacing_teeth([({"p": 39}, 21), ({"p": 39}, -99)])
    120
    >>> spacing_teeth([({"p": 39}, 21), ({"p": 30}, -90)])
    1380
    >>> spacing_teeth([({"in": 20}, 30), ({"in": 20, "out": 24}, 0), ({"out": 24}, -84)])
    54
    """
    parts = list(dict.fromkeys(part for teeth, _ in meshes for part in teeth))
    rows = [[*(teeth.get(part, 0) for part in parts), central] for teeth, central in meshes]
    for column in range(len(parts)):  # whole combinations of the rows without this rotation
        while len(busy := [row for row in rows if row[column]]) > 1:
            least = min(busy, key=lambda row: abs(row[column]))
            for row in busy:
                if row is not least:
                    times = row[column] // least[column]
                    row[:] = [a - times * b for a, b in zip(row, least, strict=True)]
        rows = [row for row in rows if not row[column]]
    return math.gcd(*(row[-1] for row in rows))


def stage_meshes(parts: Any, stages: Sequence[PlanetaryStage]) -> list[tuple[dict[Hashable, int], int]]:
    """Meshes of the first planets of stages that mesh with each other, as for `spacing_teeth`.

    Parameters
    ----------
    parts
        The parts of a model, with readable gears.
    stages
        Stages whose planets are connected by meshes.
    """
    found: list[tuple[dict[Hashable, int], int]] = []
    for stage in stages:
        for group in stage.groups:
            teeth = {_part(stage, group.wheel.step): group.wheel.gear.number_of_teeth}
            central = 0
            if group.side == "planet":
                inner = inner_stage(parts, stage)
                if inner is not None:
                    teeth[_part(inner, "")] = inner.planet.number_of_teeth
            else:
                gear = parts.gears[group.mate]
                central = gear.sign * gear.number_of_teeth
            found.append((teeth, central))
    return found


def _part(stage: PlanetaryStage, step: str) -> Hashable:
    """Rotating part of a gear of the planets: the planet, or a step whose teeth are oriented at assembly."""
    fitted = bool(step) and stage.steps[step].fitted
    return stage.planet_name, step if fitted else ""


def connected(parts: Any) -> list[list[str]]:
    """Names of stages by chains of planets in mesh, those without inner planets first."""
    chains: dict[str, list[str]] = {}
    for name, stage in parts.planetary_stages.items():
        root, seen = stage, 0
        while (inner := inner_stage(parts, root)) is not None and seen < len(parts.planetary_stages):
            root, seen = inner, seen + 1
        chains.setdefault(root.planet_name, []).append(name)
    return [
        sorted(names, key=lambda n: inner_stage(parts, parts.planetary_stages[n]) is not None)
        for names in chains.values()
    ]
