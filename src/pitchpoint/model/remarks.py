# SPDX-License-Identifier: Apache-2.0
"""What a model says that has no effect, or one that few users want: allowed, but a user should know."""

from __future__ import annotations

import math
import warnings
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import GeometryError, Problem, ValidityWarning
from pitchpoint.core.units import format_quantity
from pitchpoint.geometry.tooth_problems import NO_PAIR_IN_CONTACT
from pitchpoint.model.beam_remarks import ends_left_behind
from pitchpoint.model.components.stiffness import OF_PAIRS
from pitchpoint.model.frames import GROUND, place_of
from pitchpoint.model.idle_keys import idle_keys
from pitchpoint.model.pair_check import at_tip_diameter
from pitchpoint.model.place_remarks import places_left_open

if TYPE_CHECKING:
    from pitchpoint.geometry.gear_pair import GearPair
    from pitchpoint.model.model import Model

INTERFERENCE = 1e-7
"""Negative backlash [m] that comes from rounded profile shifts and centre distances and bends nothing."""

NEAR_WHOLE = 0.05
"""Distance of eps_alpha from a whole number up to which a small change of the centre distance passes it."""

_DISTANCE = ("centre distance", "center_distance or a tip diameter")
"""What moves the contact ratio of cylindrical gears, and what to change about it."""

DRAWN_APART = 1e-6
"""Distance of the ends of a bushing as drawn [m] that comes from rounded places."""


def follows_flanks(model: Model, mesh: str) -> bool:
    """Whether modifications, deviations or profiles of the gears of a mesh have an effect."""
    found = model.meshes[mesh]
    return found.stiffness.law in OF_PAIRS and any(model.gears[g].is_modified for g in found.gears)


def ignored_flanks(model: Model) -> tuple[str, ...]:
    """A sentence for every mesh whose law knows no tooth pairs while its gears have flanks of their own."""
    found = []
    for name, mesh in model.meshes.items():
        gears = [g for g in mesh.gears if model.gears[g].is_modified]
        if gears and mesh.stiffness.law not in OF_PAIRS:
            found.append(
                f"meshes.{name}: the law {mesh.stiffness.law} prescribes the stiffness of the whole mesh, so "
                f"modifications, deviations and profiles of {' and '.join(gears)} have no effect; "
                f"{', '.join(OF_PAIRS[:-1])} and {OF_PAIRS[-1]} follow them"
            )
    return tuple(found)


def bushings_apart(model: Model) -> tuple[str, ...]:
    """A sentence for every bushing whose ends have different places as drawn, and which is loaded by that."""
    found = []
    for name, bushing in model.bushings.items():
        one, two = (place_of(model, end) for end in bushing.ends)
        if GROUND in bushing.ends or one is None or two is None:
            continue
        apart = float(np.linalg.norm(one - two))
        if apart > DRAWN_APART:
            line = model.line(("bushings", name))
            found.append(
                f"bushings.{name}{'' if line is None else f' (line {line})'}: {' and '.join(bushing.ends)} "
                f"lie {format_quantity(apart, 'length', 3)} apart as drawn, "
                "and the bushing pulls them together"
            )
    return tuple(found)


def negative_backlash(model: Model) -> tuple[str, ...]:
    """A sentence for every mesh whose teeth are too thick for its centre distance."""
    found = []
    for name in model.every_mesh:
        gap = model.backlash(name)
        if gap < -INTERFERENCE:
            at, size = f"{model.section_of(name)}.{name}", format_quantity(gap, "length", 3)
            found.append(
                f"{at}: the backlash along the base tangent is {size}: both flanks carry without load; "
                f"if that is not wanted, {_more_room(model, name)}"
            )
    return tuple(found)


def _more_room(model: Model, name: str) -> str:
    """What to do about the negative backlash of a mesh."""
    if model.every_mesh[name].backlash is not None:
        return "give a backlash >= 0"
    if name in model.bevel_meshes:
        return "use opposite profile shifts, tooth_thickness_allowance < 0 or a backlash >= 0"
    return _wider(model.pairs[name])


def _wider(pair: GearPair) -> str:
    """What to do about teeth that are too thick for their centre distance."""
    a = pair.a_w
    try:
        for _ in range(8):  # dj_bt/da = 2 sin alpha_wt: converges in three or four steps
            a -= pair.backlash(a).j_bt / (2.0 * math.sin(pair.working_pressure_angle(a)))
    except GeometryError:
        return "change center_distance or give tooth_thickness_allowance < 0"
    # rounded to the side with the gap
    edge = (math.floor if pair.is_internal else math.ceil)(abs(a) * 1e6) * 1e-6
    distance = f"center_distance {'<=' if pair.is_internal else '>='} {edge * 1e3:.3f} mm"
    return f"give {distance}, or tooth_thickness_allowance < 0"


def jumping_ramps(model: Model) -> tuple[str, ...]:
    """A sentence for every mesh whose relief ramps jump with a small change of its contact ratio.

    Their length T_R frac(eps_alpha) is that of the published law; it falls from T_R to 0 base pitches where
    eps_alpha passes a whole number.
    """
    found = []
    for name, mesh in model.every_mesh.items():
        ramp = getattr(mesh.stiffness, "tip_relief_factor", 0.0)
        bevel = name in model.bevel_meshes
        eps_alpha = model.bevel_pairs[name].eps_alpha if bevel else model.pairs[name].eps_alpha
        moves, cure = ("shaft angle", "an addendum") if bevel else _DISTANCE
        whole, at = round(eps_alpha), f"{model.section_of(name)}.{name}"
        if ramp > 0.0 and whole >= 1 and abs(eps_alpha - whole) <= NEAR_WHOLE:
            found.append(
                f"{at}: eps_alpha = {eps_alpha:.4f} is nearly {whole}, where the ramps of "
                f"tip_relief_factor jump: T_R frac(eps_alpha) is nearly {ramp:g} base pitches below {whole} "
                f"and nearly none above, and the stiffness jumps with it, also in a run where the {moves} "
                f"moves; if that is not wanted, write tip_relief_factor: 0 or change {cure}"
            )
    return tuple(found)


def odd_shapes(model: Model) -> tuple[str, ...]:
    """A sentence for all that is odd about the shape of a gear or of a pair that can be made."""
    found = []
    for name, gear in model.gears.items():
        found += [f"gears.{at_tip_diameter(gear, problem, name)}" for problem in gear.geometry.warnings(name)]
    for name, cone in model.bevel_gears.items():
        found += [f"bevel_gears.{problem}" for problem in cone.geometry.warnings(name)]
    found += [f"{at}.{problem}" for at, problem in _odd_pairs(model) if problem.message != NO_PAIR_IN_CONTACT]
    return tuple(found)


def gaps_in_contact(model: Model) -> tuple[str, ...]:
    """A sentence for every mesh that leaves moments without a pair of teeth in contact."""
    odd = _odd_pairs(model)
    return tuple(f"{at}.{problem}" for at, problem in odd if problem.message == NO_PAIR_IN_CONTACT)


def _odd_pairs(model: Model) -> list[tuple[str, Problem]]:
    """All that is odd about the pairs of a model, with their sections."""
    return [
        (model.section_of(name), problem)
        for pairs in (model.pairs, model.bevel_pairs)
        for name, pair in pairs.items()
        for problem in pair.warnings(name, model.every_mesh[name].gears)
    ]


def warn_of_remarks(model: Model) -> None:
    """Issue the sentences of this module and of those that it imports them from as `ValidityWarning`."""
    remarks = (
        ignored_flanks,
        negative_backlash,
        jumping_ramps,
        gaps_in_contact,
        bushings_apart,
        places_left_open,
        ends_left_behind,
        idle_keys,
    )
    for text in (sentence for find in remarks for sentence in find(model)):
        warnings.warn(text, ValidityWarning, stacklevel=2)
