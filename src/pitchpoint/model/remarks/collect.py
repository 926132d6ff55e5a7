# SPDX-License-Identifier: Apache-2.0
"""Remarks and warnings of a model: valid data without effect or with a rarely intended one."""

from __future__ import annotations

import math
import warnings
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import GeometryError, Message, ValidityWarning, remark
from pitchpoint.core.units import format_quantity
from pitchpoint.geometry.meshing_problems import NO_PAIR_IN_CONTACT
from pitchpoint.model.checks.bearing_faults import track_radius
from pitchpoint.model.checks.gear_pairs import at_tip_diameter
from pitchpoint.model.components.stiffness import OF_PAIRS
from pitchpoint.model.frames import GROUND, place_of
from pitchpoint.model.planetary_stages import at_stages
from pitchpoint.model.remarks.beam_sections import implausible_sections, parts_of_other_files
from pitchpoint.model.remarks.beams import ends_left_behind, sections_not_flat
from pitchpoint.model.remarks.bores import bores_off_their_shafts, gears_thinner_than_their_shafts
from pitchpoint.model.remarks.clutches import couplings_without_torque, idle_clutches
from pitchpoint.model.remarks.file import (
    numbers_without_unit,
    temperatures_without_oil,
    unused_materials,
    unused_parameters,
)
from pitchpoint.model.remarks.flank_contact import inaccurate_tables
from pitchpoint.model.remarks.keys_without_effect import keys_without_effect
from pitchpoint.model.remarks.places import places_left_open
from pitchpoint.model.remarks.scissor_gears import weak_springs
from pitchpoint.model.remarks.space import bearings_in_gears, gears_in_one_place
from pitchpoint.model.remarks.stage_keys import stage_keys
from pitchpoint.model.remarks.supports import axially_free, tilting
from pitchpoint.model.remarks.trains import contradictory_loops, unconnected_shafts
from pitchpoint.model.remarks.unusual_values import (
    odd_materials,
    overdamped_meshes,
    overdamped_supports,
    preloads_above_the_rating,
)
from pitchpoint.model.remarks.wind_rotors import (
    flat_blades,
    low_rotors,
    repeated_turbulence,
    unused_polars,
    upwind_axes,
)

if TYPE_CHECKING:
    from pitchpoint.geometry.gear_pair import GearPair
    from pitchpoint.model.model import Model

INTERFERENCE = 1e-7
"""Negative backlash [m] up to which it is attributed to rounded profile shifts and centre distances."""

NEAR_WHOLE = 0.05
"""Distance of eps_alpha from an integer that a small change of the centre distance can bridge."""

_DISTANCE = ("centre distance", "center_distance or a tip diameter")
"""Quantity that varies the contact ratio of cylindrical gears, and the keys to change."""

DRAWN_APART = 1e-6
"""Initial distance of the ends of a bushing [m] that is attributed to rounded positions."""


def follows_flanks(model: Model, mesh: str) -> bool:
    """Whether modifications, deviations or tooth profiles of the gears of a mesh have an effect."""
    found = model.meshes[mesh]
    return found.law.of_pairs and any(model.gears[g].is_modified for g in found.gears)


def ignored_flanks(model: Model) -> tuple[Message, ...]:
    """A remark for every mesh whose law describes the whole mesh while its gears have modified flanks."""
    found = []
    for name, mesh in model.meshes.items():
        gears = [g for g in mesh.gears if model.gears[g].is_modified]
        if gears and not mesh.law.of_pairs:
            found.append(
                remark(
                    f"meshes.{name}",
                    f"the law {mesh.law.law} describes the stiffness of the whole mesh, so "
                    f"modifications, deviations and profiles of {' and '.join(gears)} have no effect",
                    f"{', '.join(OF_PAIRS[:-1])} and {OF_PAIRS[-1]} include them",
                )
            )
    return tuple(found)


def bushings_at_a_distance(model: Model) -> tuple[Message, ...]:
    """A remark for every bushing that is preloaded because its ends do not coincide initially."""
    found = []
    for name, bushing in model.bushings.items():
        one, two = (place_of(model, end) for end in bushing.ends)
        if GROUND in bushing.ends or one is None or two is None:
            continue
        apart = float(np.linalg.norm(one - two))
        if apart > DRAWN_APART:
            found.append(
                remark(
                    f"bushings.{name}",
                    f"{' and '.join(bushing.ends)} are {format_quantity(apart, 'length', 3)} apart in the "
                    "initial position, and the bushing pulls them together",
                    line=model.line(("bushings", name)),
                )
            )
    return tuple(found)


def negative_backlash(model: Model) -> tuple[Message, ...]:
    """A remark for every mesh whose teeth are too thick for its centre distance."""
    found = []
    for name in model.every_mesh:
        gap = model.backlash(name)
        if gap < -INTERFERENCE:
            at, size = f"{model.section_of(name)}.{name}", format_quantity(gap, "length", 3)
            found.append(
                remark(
                    at,
                    f"the backlash along the base tangent is {size}: both flanks are in contact without load",
                    f"if this is not intended, {_more_room(model, name)}",
                )
            )
    return tuple(found)


def no_backlash(model: Model) -> tuple[Message, ...]:
    """A remark for every mesh on elastic supports with zero backlash, unless the file gives it.

    Gears that only rotate about fixed axes keep their distance.
    """
    found = []
    for name, mesh in model.every_mesh.items():
        if mesh.backlash is not None or abs(model.backlash(name)) > INTERFERENCE:
            continue
        bodies = [body for gear in mesh.gears if (body := model.body_of(gear))]
        if all(len(model.mechanism.seats[body].coordinates) <= 1 for body in bodies):
            continue
        gears = [model.toothed[gear] for gear in mesh.gears]
        follows = any(getattr(gear, "profile_shift_coefficient", 0.0) is None for gear in gears)
        distance = "a backlash > 0"
        if name in model.meshes:
            wider = "smaller" if model.pairs[name].is_internal else "larger"
            both = "a profile_shift_coefficient of both gears and " if follows else ""
            distance = f"{both}a {wider} center_distance"
        found.append(
            remark(
                f"{model.section_of(name)}.{name}",
                "the backlash is 0 mm: deflections of shafts and bearings bring both flanks into contact",
                f"if this is not intended, give tooth_thickness_allowance < 0, or {distance}",
            )
        )
    return tuple(found)


def _more_room(model: Model, name: str) -> str:
    """Remedy for the negative backlash of a mesh."""
    if model.every_mesh[name].backlash is not None:
        return "give a backlash >= 0"
    if name in model.bevel_meshes:
        return "use opposite profile shifts, tooth_thickness_allowance < 0 or a backlash >= 0"
    return _wider(model.pairs[name])


def _wider(pair: GearPair) -> str:
    """Remedy for teeth that are too thick for their centre distance."""
    a = pair.a_w
    try:
        for _ in range(8):  # dj_bt/da = 2 sin alpha_wt: converges in three or four steps
            a -= pair.backlash(a).j_bt / (2.0 * math.sin(pair.working_pressure_angle(a)))
    except GeometryError:
        return "change center_distance or give tooth_thickness_allowance < 0"
    # rounded to positive backlash
    edge = (math.floor if pair.is_internal else math.ceil)(abs(a) * 1e6) * 1e-6
    distance = f"center_distance {'<=' if pair.is_internal else '>='} {edge * 1e3:.3f} mm"
    return f"give {distance}, or tooth_thickness_allowance < 0"


def jumping_ramps(model: Model) -> tuple[Message, ...]:
    """A remark for every mesh whose relief ramps are discontinuous in the contact ratio.

    Their length T_R frac(eps_alpha) is that of the published law; it falls from T_R to 0 base pitches where
    eps_alpha passes an integer.
    """
    found = []
    for name, mesh in model.every_mesh.items():
        ramp = getattr(mesh.law, "tip_relief_factor", 0.0)
        bevel = name in model.bevel_meshes
        eps_alpha = model.bevel_pairs[name].eps_alpha if bevel else model.pairs[name].eps_alpha
        moves, cure = ("shaft angle", "an addendum") if bevel else _DISTANCE
        whole, at = round(eps_alpha), f"{model.section_of(name)}.{name}"
        if ramp > 0.0 and whole >= 1 and abs(eps_alpha - whole) <= NEAR_WHOLE:
            found.append(
                remark(
                    at,
                    f"eps_alpha = {eps_alpha:.4f} is nearly {whole}, where the ramps of tip_relief_factor "
                    f"jump: T_R frac(eps_alpha) is nearly {ramp:g} base pitches below {whole} and nearly "
                    f"none above, and the stiffness jumps with it, also in a run where the {moves} moves",
                    f"if this is not intended, write tip_relief_factor: 0 or change {cure}",
                )
            )
    return tuple(found)


def flat_grooves(model: Model) -> tuple[Message, ...]:
    """A remark for every groove of a ball bearing whose radius exceeds that of its raceway."""
    found = []
    for name, bearing in model.rolling_bearings.items():
        if bearing.geometry.aligns:  # the outer raceway is a sphere
            continue
        for k, (ring, ratio) in enumerate(
            zip(("inner", "outer"), bearing.geometry.grooves or (), strict=False)
        ):
            groove, race = ratio * bearing.geometry.element_diameter, track_radius(bearing, k == 0)
            if groove > race:
                found.append(
                    remark(
                        f"rolling_bearings.{name}.grooves",
                        f"the groove of the {ring} ring has a radius of {groove * 1e3:.4g} mm, more than its "
                        f"raceway with {race * 1e3:.4g} mm",
                        "give it over the ball diameter, such as 0.52, unless the raceway has no groove",
                    )
                )
    return tuple(found)


def odd_shapes(model: Model) -> tuple[Message, ...]:
    """A warning for every unusual feature of the geometry of a gear or of a gear pair."""
    found: list[tuple[str, Message]] = []
    for name, gear in model.gears.items():
        thin = [at_tip_diameter(gear, problem, name) for problem in gear.geometry.warnings(name)]
        found += [("gears", each) for each in thin]
    for name, cone in model.bevel_gears.items():
        found += [("bevel_gears", each) for each in cone.geometry.warnings(name)]
    found += [(at, each) for at, each in _odd_pairs(model) if each.text != NO_PAIR_IN_CONTACT]
    return at_stages(
        model, (each.changed(where=f"{group}.{each.where}", kind="warning") for group, each in found)
    )


def gaps_in_contact(model: Model) -> tuple[Message, ...]:
    """A warning for every mesh with phases without a tooth pair in contact."""
    found = [(at, each) for at, each in _odd_pairs(model) if each.text == NO_PAIR_IN_CONTACT]
    return tuple(each.changed(where=f"{at}.{each.where}", kind="warning") for at, each in found)


def _odd_pairs(model: Model) -> list[tuple[str, Message]]:
    """All geometry warnings of the gear pairs of a model, with their sections."""
    return [
        (model.section_of(name), problem)
        for pairs in (model.pairs, model.bevel_pairs)
        for name, pair in pairs.items()
        for problem in pair.warnings(name, model.every_mesh[name].gears)
    ]


def remarks_of(model: Model) -> tuple[Message, ...]:
    """All remarks and warnings of a model, with the lines of its file."""
    finders = (
        ignored_flanks,
        negative_backlash,
        jumping_ramps,
        gaps_in_contact,
        bushings_at_a_distance,
        flat_grooves,
        places_left_open,
        ends_left_behind,
        sections_not_flat,
        keys_without_effect,
        idle_clutches,
        inaccurate_tables,
    )
    found = at_stages(model, (each for find in finders for each in find(model)))
    return tuple(e if e.line is not None else e.changed(line=model.line_of(e.where)) for e in found)


def remarks_of_file(model: Model) -> tuple[Message, ...]:
    """Remarks on the values in the file, which runs do not repeat."""
    found = (
        *bores_off_their_shafts(model),
        *gears_thinner_than_their_shafts(model),
        *gears_in_one_place(model),
        *bearings_in_gears(model),
        *preloads_above_the_rating(model),
        *axially_free(model),
        *tilting(model),
        *contradictory_loops(model),
        *unconnected_shafts(model),
        *at_stages(model, overdamped_meshes(model)),
        *at_stages(model, overdamped_supports(model)),
        *odd_materials(model),
        *temperatures_without_oil(model),
        *unused_materials(model),
        *weak_springs(model),
        *couplings_without_torque(model),
        *stage_keys(model),
        *unused_polars(model),
        *repeated_turbulence(model),
        *flat_blades(model),
        *low_rotors(model),
        *upwind_axes(model),
        *implausible_sections(model),
        *parts_of_other_files(model),
        *at_stages(model, no_backlash(model)),
    )
    named = (e if e.line is not None else e.changed(line=model.line_of(e.where)) for e in found)
    return (*numbers_without_unit(model), *unused_parameters(model), *named)


def warn_of_remarks(model: Model) -> None:
    """Issue `remarks_of` as `ValidityWarning`."""
    for each in remarks_of(model):
        warnings.warn(each, ValidityWarning, stacklevel=2)
