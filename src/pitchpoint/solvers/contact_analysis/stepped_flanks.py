# SPDX-License-Identifier: Apache-2.0
"""Pressure where the curvature of the flanks changes within the contact: parabolic reliefs, tip roundings.

Crownings and parabolic reliefs add to the curvature of the involutes. Within the contact of their start, and
next to the rounding of a tip edge, the pressure is that of elastic half-planes in strips
(`contact.strip_pressure`). The start of a linear relief is a sharp edge, where no finite pressure exists;
contacts there keep that of the involutes.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.hertz import plane_strain_compliance
from pitchpoint.contact.strip_pressure import RANGE, stepped_pressure
from pitchpoint.geometry.modifications import Relief, flank_range, roll_length

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    from pitchpoint.solvers.contact_analysis.flank_states import FlankStates

Array = NDArray[np.float64]

_DIGITS = 7
"""Digits of loads and places to which equal contacts share their pressure."""


@dataclass(frozen=True)
class Bend:
    """Additional curvature of the flank of one gear beyond a length of roll.

    Parameters
    ----------
    gear
        0 or 1.
    start
        Length of roll at which it starts [m], positive.
    towards_tip
        Whether it applies from there to the tip, else to the root.
    by_roll, centre
        Second derivative of the removed material over the length of roll [1/m], and the length of roll at
        which its slope is zero [m].
    radius
        Radius of the tip rounding [m] instead of `by_roll`; 0 for modifications.
    """

    gear: int
    start: float
    towards_tip: bool
    by_roll: float = 0.0
    centre: float = 0.0
    radius: float = 0.0


def bends_of(flanks: FlankStates) -> list[Bend]:
    """Changes of curvature of both flanks in contact."""
    found: list[Bend] = []
    names = flanks.model.meshes[flanks.mesh].gears
    for k, name in enumerate(names):
        gear = flanks.model.gears[name]
        shape = gear.geometry
        front = "right" if k == 1 and shape.z < 0 else "left"
        side = front if flanks.flank > 0 else {"left": "right", "right": "left"}[front]
        made = None if gear.modifications is None else gear.modifications.side(side)
        if made is not None:
            found += _of_modifications(k, shape, made.of_geometry())
        radius = float(flanks.record["rounding"][k])
        if radius > 0.0:
            found.append(Bend(k, float(roll_length(shape, shape.d_Fa)), True, radius=radius))
    return found


def _of_modifications(k: int, gear: CylindricalGear, made: object) -> Iterator[Bend]:
    """Changes of curvature of crowning and parabolic reliefs."""
    root, tip = flank_range(gear)
    crowning = float(getattr(made, "profile_crowning", 0.0))
    if crowning:
        half = 0.5 * (root + tip)
        yield Bend(k, root, True, by_roll=8.0 * crowning / (tip - root) ** 2, centre=half)
    for name, end, towards_tip in (("tip_relief", tip, True), ("root_relief", root, False)):
        relief: Relief | None = getattr(made, name)
        if relief is None or relief.shape != "parabolic" or relief.amount == 0.0:
            continue
        extent = relief.length
        if extent is None:
            assert relief.start_diameter is not None
            extent = abs(end - float(roll_length(gear, relief.start_diameter)))
        start = end - (gear.sign if towards_tip else -gear.sign) * extent
        yield Bend(k, start, towards_tip, by_roll=2.0 * relief.amount / extent**2, centre=start)


def step_pressures(flanks: FlankStates, fields: dict[str, Array]) -> None:
    """Replace pressures of the flanks where the curvature differs from that of the involutes.

    Parameters
    ----------
    flanks
        The mesh.
    fields
        Fields of the contact nodes, as in the dataset of `solve_contact`; `pressure` is changed.
    """
    bends = bends_of(flanks)
    there = np.isfinite(fields["pressure"]) & (fields["line_load"] > 0.0)
    if not bends or not there.any():
        return
    gears = [flanks.model.gears[name] for name in flanks.model.meshes[flanks.mesh].gears]
    materials = [gear.material_data for gear in gears]
    soft = sum(plane_strain_compliance(m.youngs_modulus, m.poisson_ratio) for m in materials)
    load = fields["line_load"][there]
    rolls = [fields[f"roll_{k + 1}"][there] for k in (0, 1)]
    curvature = math.pi * soft * fields["pressure"][there] ** 2 / load
    places, steps = np.empty((len(bends), load.size)), np.empty((len(bends), load.size))
    for row, bend in enumerate(bends):
        inside, places[row], steps[row] = _seen(bend, gears[bend.gear].geometry, rolls[bend.gear])
        curvature = curvature + inside
    b_H = np.sqrt(4.0 * load * soft / (math.pi * curvature))
    pressure = np.sqrt(load * curvature / (math.pi * soft))
    near = (np.abs(places) < RANGE * b_H).any(axis=0)
    known: dict[tuple[float, ...], float] = {}
    for n in np.flatnonzero(near):
        values = (curvature[n], load[n], *places[:, n], *steps[:, n])
        key = tuple(float(f"{value:.{_DIGITS}g}") for value in values)
        if key not in known:
            kept = np.abs(places[:, n]) < RANGE * b_H[n]
            listed = list(zip(places[kept, n].tolist(), steps[kept, n].tolist(), strict=True))
            known[key] = stepped_pressure(float(curvature[n]), listed, float(load[n]), soft).maximum
        pressure[n] = known[key]
    fields["pressure"][there] = pressure


def _seen(bend: Bend, gear: CylindricalGear, roll: Array) -> tuple[Array, Array, Array]:
    """Curvature of a bend at contacts, and its step: place along the section and additional curvature there.

    Along the flank an arc is ds = L dL/r_b, so that d²h/ds² = (r_b/L)² (h″ − h′/L) of the removed material
    h(L); the section normal to the contact line is inclined to the profile by β_b. Positive places are
    towards the tip of gear 1.
    """
    r_b, cos_b = abs(gear.r_b), math.cos(gear.beta_b)
    with np.errstate(divide="ignore"):
        added = bend.by_roll * (r_b / roll) ** 2 * bend.centre / roll
        if bend.radius > 0.0:
            added = 1.0 / bend.radius - 1.0 / roll
    added = np.where(np.isfinite(added), added, 0.0) * cos_b**2
    # positive before the start, seen in the direction in which the bend applies
    outwards = gear.sign if bend.towards_tip else -gear.sign
    ahead = outwards * (bend.start**2 - roll**2) / (2.0 * r_b) / cos_b
    way = 1.0 if bend.towards_tip == (bend.gear == 0) else -1.0
    beyond = ahead < 0.0
    return np.where(beyond, added, 0.0), way * ahead, np.where(beyond, -added, added)
