# SPDX-License-Identifier: Apache-2.0
"""Pressure where the curvature of the flanks changes within the contact: parabolic reliefs, tip roundings.

Crownings, slopes and reliefs add to the curvature of the involutes. Within the contact of the start of a
parabolic relief, and next to the rounding of a tip edge, the pressure is that of elastic half-planes in
strips (`contact.strip_pressure`). The start of a linear relief is a sharp edge, where no finite pressure
exists; contacts there have the pressure without the edge.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.hertz import plane_strain_compliance
from pitchpoint.contact.strip_pressure import RANGE, least_curvature, stepped_pressure
from pitchpoint.contact.tip_contact import tip_gap_from_mean
from pitchpoint.elements.mesh.surface.nodes import TIP_1, TIP_2
from pitchpoint.geometry.modifications import Relief, flank_range, roll_length

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    from pitchpoint.solvers.contact_analysis.flank_states import FlankStates

Array = NDArray[np.float64]

SAME = 1e-9
"""Relative difference of lengths of roll of a tip edge."""
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
    by_roll, slope
        Second derivative of the removed material over the length of roll [1/m], and its slope at the length
        of roll 0, extrapolated [-].
    radius
        Radius of the tip rounding [m] instead; 0 for modifications.
    """

    gear: int
    start: float
    towards_tip: bool
    by_roll: float = 0.0
    slope: float = 0.0
    radius: float = 0.0

    @property
    def is_step(self) -> bool:
        """Whether the curvature changes at the start; a change of the slope alone is a sharp edge."""
        return self.by_roll != 0.0 or self.radius > 0.0


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
    """Changes of curvature of crowning, slope and reliefs."""
    root, tip = flank_range(gear)
    crowning = float(getattr(made, "profile_crowning", 0.0))
    if crowning:
        by_roll = 8.0 * crowning / (tip - root) ** 2
        yield Bend(k, root, True, by_roll=by_roll, slope=-0.5 * by_roll * (root + tip))
    slope = float(getattr(made, "profile_slope", 0.0))
    if slope:
        yield Bend(k, root, True, slope=-slope / (tip - root))
    for name, end, towards_tip in (("tip_relief", tip, True), ("root_relief", root, False)):
        relief: Relief | None = getattr(made, name)
        if relief is None or relief.amount == 0.0:
            continue
        extent = relief.length
        if extent is None:
            assert relief.start_diameter is not None
            extent = abs(end - float(roll_length(gear, relief.start_diameter)))
        outwards = gear.sign if towards_tip else -gear.sign
        start = end - outwards * extent
        if relief.shape == "parabolic":
            by_roll = 2.0 * relief.amount / extent**2
            yield Bend(k, start, towards_tip, by_roll=by_roll, slope=-by_roll * start)
        else:
            yield Bend(k, start, towards_tip, slope=outwards * relief.amount / extent)


def edge_turns(record: np.void, node: NDArray[np.void]) -> Array:
    """Angle on the rounding of a tip edge between its start and the contact [rad], 0 for other contacts.

    Parameters
    ----------
    record
        Record of the mesh; its line of action is that of the last state.
    node
        Contact nodes, shape (n,).
    """
    now = record["now"]
    end = float(now["xi_A"] + now["eps"] * record["p_bt"])
    r_b = float(record["r_b1"]), float(record["r_b2"])
    tips = float(record["rho_a1"]), float(record["rho_a2"])
    found = np.zeros(node.size)
    rounded = [
        edge for edge, r in ((TIP_1, record["rounding"][0]), (TIP_2, record["rounding"][1])) if r > 0.0
    ]
    for n in np.flatnonzero(np.isin(node["place"], rounded)):
        edge = int(node["place"][n]) - 1
        eta = float(node["xi"][n]) - end if edge == 0 else float(now["xi_A"] - node["xi"][n])
        centre = tips[edge] - float(record["rounding"][edge])
        found[n] = abs(tip_gap_from_mean(eta, r_b[edge], r_b[1 - edge], centre, float(now["tan_a"]))[6])
    return found


def step_pressures(flanks: FlankStates, fields: dict[str, Array], turns: Array) -> int:
    """Replace pressures where the curvature differs from that of the involutes, or changes in the contact.

    Parameters
    ----------
    flanks
        The mesh.
    fields
        Fields of the contact nodes, as in the dataset of `solve_contact`; `pressure` and `edge_pressure` are
        changed.
    turns
        Angles of `edge_turns`, shape of the fields.

    Returns
    -------
    int
        Number of contacts whose pressure becomes NaN: a flank that is more concave than its mate is convex,
        by negative profile crowning or a steep relief in a ring, is not in line contact with it.
    """
    bends, hollow = bends_of(flanks), 0
    if not bends:
        return hollow
    gears = [flanks.model.gears[name] for name in flanks.model.meshes[flanks.mesh].gears]
    soft = sum(
        plane_strain_compliance(g.material_data.youngs_modulus, g.material_data.poisson_ratio) for g in gears
    )
    for name in ("pressure", "edge_pressure"):
        there = np.isfinite(fields[name]) & (fields["line_load"] > 0.0)
        load = fields["line_load"][there]
        rolls = [fields[f"roll_{k + 1}"][there] for k in (0, 1)]
        curvature = math.pi * soft * fields[name][there] ** 2 / load
        places, steps = np.zeros((len(bends), load.size)), np.zeros((len(bends), load.size))
        for row, bend in enumerate(bends):
            gear = gears[bend.gear].geometry
            if name == "pressure":
                inside, places[row], steps[row] = _seen(bend, gear, rolls[bend.gear])
                curvature = curvature + inside
            elif bend.radius > 0.0:
                own = np.abs(rolls[bend.gear] - bend.start) < SAME * bend.start
                # contact on the rounding: its own involute begins behind it
                places[row] = -bend.radius * turns[there]
                steps[row] = np.where(own, _rounded(bend, gear, bend.start), 0.0) * -1.0
        found = _pressures(load, curvature, places, steps, soft)
        fields[name][there] = found
        hollow += int(np.isnan(found).sum())
    return hollow


def _pressures(load: Array, curvature: Array, places: Array, steps: Array, soft: float) -> Array:
    """Maximum pressures of contacts with a base curvature, and steps of it, shape (n_step, n).

    NaN where the flanks are not convex within the contact.
    """
    near, least = np.zeros(steps.shape, dtype=bool), curvature
    for _ in range(len(steps) + 1):  # the contact extends towards the smaller curvature
        with np.errstate(divide="ignore"):
            reach = RANGE * np.sqrt(4.0 * load * soft / (math.pi * np.maximum(least, 0.0)))
        near |= (steps != 0.0) & (np.abs(places) < reach)
        least = least_curvature(curvature, places, np.where(near, steps, 0.0))
    convex = least > 0.0
    pressure = np.sqrt(load * np.where(convex, curvature, np.nan) / (math.pi * soft))
    known: dict[tuple[float, ...], float] = {}
    for n in np.flatnonzero(near.any(axis=0) & convex):
        kept = near[:, n]
        values = (curvature[n], load[n], *places[kept, n], *steps[kept, n])
        key = tuple(float(f"{value:.{_DIGITS}g}") for value in values)
        if key not in known:
            listed = list(zip(places[kept, n].tolist(), steps[kept, n].tolist(), strict=True))
            known[key] = stepped_pressure(float(curvature[n]), listed, float(load[n]), soft).maximum
        pressure[n] = known[key]
    return pressure


def _rounded(bend: Bend, gear: CylindricalGear, roll: Array | float) -> Array:
    """Additional curvature of a tip rounding over the involute, normal to the contact line."""
    return np.asarray((1.0 / bend.radius - 1.0 / np.asarray(roll)) * math.cos(gear.beta_b))


def _seen(bend: Bend, gear: CylindricalGear, roll: Array) -> tuple[Array, Array, Array]:
    """Curvature of a bend at contacts, and its step: place along the section and additional curvature there.

    The section normal to the contact line has the tangent of the transverse profile, whose arc is
    ds = L dL/r_b. There L² has the second derivative 2 sin²β_b over the arc, so that removed material h(L)
    has d²h/ds² = (r_b/L)² (h″ − h′/L) + h′ sin²β_b/L; h″ − h′/L is −1/L times the slope extrapolated to
    L = 0. Positive places are towards the tip of gear 1.
    """
    r_b, sin_b = abs(gear.r_b), math.sin(gear.beta_b)
    with np.errstate(divide="ignore", invalid="ignore"):
        added = -bend.slope / roll * (r_b / roll) ** 2 + (bend.by_roll + bend.slope / roll) * sin_b**2
        if bend.radius > 0.0:
            added = _rounded(bend, gear, roll)
    added = np.where(np.isfinite(added), added, 0.0)
    # positive before the start, seen in the direction in which the bend applies
    outwards = gear.sign if bend.towards_tip else -gear.sign
    ahead = outwards * (bend.start**2 - roll**2) / (2.0 * r_b)
    way = 1.0 if bend.towards_tip == (bend.gear == 0) else -1.0
    beyond = ahead < 0.0
    step = np.where(beyond, -added, added) if bend.is_step else np.zeros_like(added)
    return np.where(beyond, added, 0.0), way * ahead, step
