# SPDX-License-Identifier: Apache-2.0
"""Data of gears, pairs and mesh stiffness for commands and reports, by their ISO symbols.

Each quantity is defined once, with meaning and dimension; JSON and tables use the same rows. Values are in SI
units and radians. Numbers of teeth, diameters, centre distances and helix angles are positive here, without
the signs of ISO 21771 in the geometry (the hand is given next to the helix angle).
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from pitchpoint.report.bevel_numbers import bevel_cycles, bevel_gear_numbers, bevel_mesh_numbers
from pitchpoint.report.number_rows import C_PRIME_B, MEAN, ONE_PAIR, Row, law_numbers, pick

if TYPE_CHECKING:
    from pitchpoint.contact.mesh_cycle import MeshCycle
    from pitchpoint.contact.stiffness.description import Description
    from pitchpoint.contact.stiffness.din3990 import SingleStiffness
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    from pitchpoint.geometry.gear_pair import GearPair
    from pitchpoint.model.model import Model

GEAR_ROWS: tuple[Row, ...] = (
    ("z", "number of teeth", "dimensionless"),
    ("m_n", "normal module", "length"),
    ("m_t", "transverse module", "length"),
    ("alpha_n", "normal pressure angle", "angle"),
    ("alpha_t", "transverse pressure angle", "angle"),
    ("beta", "helix angle", "angle"),
    ("beta_b", "base helix angle", "angle"),
    ("x", "profile shift coefficient", "dimensionless"),
    ("x_E", "generating profile shift coefficient", "dimensionless"),
    ("b", "face width", "length"),
    ("z_n", "virtual number of teeth", "dimensionless"),
    ("d", "reference diameter", "length"),
    ("d_b", "base diameter", "length"),
    ("d_a", "tip diameter", "length"),
    ("d_f", "root diameter", "length"),
    ("d_Fa", "tip form diameter", "length"),
    ("d_Ff", "root form diameter", "length"),
    ("s_n", "normal tooth thickness", "length"),
    ("s_t", "transverse tooth thickness", "length"),
    ("p_n", "normal pitch", "length"),
    ("p_t", "transverse pitch", "length"),
    ("p_bt", "transverse base pitch", "length"),
    ("p_et", "transverse pitch on the path of contact", "length"),
)

EDGE_ROWS: tuple[Row, ...] = (
    ("tip_chamfer", "radial height of the tip chamfer", "length"),
    ("tip_rounding", "radius of the tip rounding", "length"),
)
"""Rows of gears with broken tip edges; None where an edge has another shape."""

_GEAR_POSITIVE = {"z", "z_n", "beta", "beta_b", "d", "d_b", "d_a", "d_f", "d_Fa", "d_Ff"}

PAIR_ROWS: tuple[Row, ...] = (
    ("a_d", "reference centre distance", "length"),
    ("a_w", "working centre distance", "length"),
    ("alpha_wt", "working pressure angle", "angle"),
    ("x_sum", "sum of profile shifts without backlash", "dimensionless"),
    ("x_sum_given", "sum of given profile shifts", "dimensionless"),
    ("b_w", "common face width", "length"),
    ("d_w1", "working pitch diameter, gear 1", "length"),
    ("d_w2", "working pitch diameter, gear 2", "length"),
    ("d_Na1", "active tip diameter, gear 1", "length"),
    ("d_Na2", "active tip diameter, gear 2", "length"),
    ("d_Nf1", "active root diameter, gear 1", "length"),
    ("d_Nf2", "active root diameter, gear 2", "length"),
    ("g_alpha", "length of the path of contact", "length"),
    ("g_f", "length of approach", "length"),
    ("g_a", "length of recess", "length"),
    ("T1A", "path from T1 to A", "length"),
    ("T1B", "path from T1 to B", "length"),
    ("T1C", "path from T1 to C", "length"),
    ("T1D", "path from T1 to D", "length"),
    ("T1E", "path from T1 to E", "length"),
    ("T1T2", "length T1 to T2", "length"),
    ("eps_alpha", "transverse contact ratio", "dimensionless"),
    ("eps_beta", "overlap ratio", "dimensionless"),
    ("eps_gamma", "total contact ratio", "dimensionless"),
    ("c_1", "tip clearance, tip of gear 1", "length"),
    ("c_2", "tip clearance, tip of gear 2", "length"),
    ("j_bt", "backlash along the base tangent", "length"),
    ("j_wt", "circumferential backlash", "length"),
    ("j_bn", "normal backlash", "length"),
)

_PAIR_POSITIVE = {"a_d", "a_w", "d_w1", "d_w2", "d_Na1", "d_Na2", "d_Nf1", "d_Nf2"}

SLIDING_ROWS: tuple[Row, ...] = (
    ("zeta_f1", "specific sliding at the root, gear 1", "dimensionless"),
    ("zeta_a1", "specific sliding at the tip, gear 1", "dimensionless"),
    ("zeta_f2", "specific sliding at the root, gear 2", "dimensionless"),
    ("zeta_a2", "specific sliding at the tip, gear 2", "dimensionless"),
)

STIFFNESS_ROWS: tuple[Row, ...] = (
    ("c_prime", "single stiffness by ISO 6336", "stiffness_per_width"),
    ("c_gamma_alpha", "mesh stiffness by ISO 6336", "stiffness_per_width"),
    ("C_R", "gear blank factor", "dimensionless"),
    ("C_B", "basic rack factor", "dimensionless"),
)


def gear_numbers(model: Model, name: str) -> dict[str, Any]:
    """Collect macro-geometry, mass and moments of inertia of a gear."""
    from pitchpoint.model.inertia import gear_inertia

    gear = model.gears[name]
    numbers = pick(gear.geometry, GEAR_ROWS, _GEAR_POSITIVE)
    numbers |= pick(gear, EDGE_ROWS, set())
    numbers["type"] = gear.type
    numbers["hand"] = gear.hand
    numbers["undercut"] = bool(gear.geometry.undercut)
    numbers["mass"], numbers["polar_inertia"], numbers["transverse_inertia"] = gear_inertia(gear)
    return numbers


def measure_numbers(gear: CylindricalGear) -> dict[str, Any]:
    """Collect the inspection dimensions of a gear; None if a dimension does not exist."""
    from pitchpoint.core.errors import GeometryError
    from pitchpoint.geometry import measures
    from pitchpoint.geometry.tooth_thickness import tip_thickness

    k = measures.span_tooth_count(gear)
    found: dict[str, Any] = {
        "tip_thickness": tip_thickness(gear),
        "span_teeth": k,
        "span": measures.span(gear, k),
        "span_measurable": gear.b > measures.span(gear, k) * math.sin(abs(gear.beta_b)),
    }
    try:
        ball = measures.ideal_ball_diameter(gear)
        found |= {"ball_diameter": ball, "dimension_over_balls": measures.dimension_over_balls(gear, ball)}
    except GeometryError:
        found |= {"ball_diameter": None, "dimension_over_balls": None}
    return found


def mesh_numbers(model: Model, name: str) -> dict[str, Any]:
    """Collect geometry and stiffness of a mesh: of its law, and by DIN 3990 / ISO 6336 for comparison.

    Backlash and stiffness of the law are the simulated ones: values given in the file take precedence.
    """
    from pitchpoint.geometry.sliding import specific_sliding
    from pitchpoint.system.rules.stiffness import single_stiffness_of

    pair = model.pairs[name]
    numbers = pick(pair, PAIR_ROWS, _PAIR_POSITIVE)
    j_bt = model.backlash(name)
    numbers |= {
        "j_bt": j_bt,
        "j_wt": j_bt / math.cos(pair.alpha_wt),
        "j_bn": j_bt * math.cos(pair.gear1.beta_b),
        "gears": list(model.meshes[name].gears),
    }
    numbers |= specific_sliding(pair)._asdict()
    numbers |= _law_numbers(model, name)
    return numbers | stiffness_numbers(single_stiffness_of(model, name))


def _law_numbers(model: Model, name: str) -> dict[str, Any]:
    """Collect the stiffness of the law of a mesh; tooth surfaces in contact have none in advance."""
    from pitchpoint.system.rules.stiffness import describe_stiffness

    part = model.meshes[name]
    if part.contact is not None:
        return law_numbers(part.contact.law, None, None)
    law = describe_stiffness(model, name)
    cycle, _, unit = _cycle(model.pairs[name], law, 2)
    return law_numbers(part.stiffness.law, law, None if unit is None else cycle.mean * unit)


def cycles_of_model(model: Model, points: int) -> dict[str, tuple[MeshCycle, str, float | None]]:
    """Stiffness cycle of every mesh, with its reference value in words and as a number [N/m].

    None if the reference value does not have the unit of a stiffness.
    """
    from pitchpoint.system.rules.stiffness import describe_stiffness

    cycles = {
        name: _cycle(pair, describe_stiffness(model, name), points) for name, pair in model.pairs.items()
    }
    return cycles | bevel_cycles(model, points)


def _cycle(pair: GearPair, law: Description, points: int) -> tuple[MeshCycle, str, float | None]:
    """Stiffness cycle of a law with its reference value, see `cycles_of_model`."""
    from pitchpoint.contact.mesh_cycle import pair_cycle, phase_cycle
    from pitchpoint.contact.stiffness.description import PairShape

    if not isinstance(law, PairShape):
        return phase_cycle(law, points), MEAN, law.mean
    linear = law.power == 1.0
    unit = law.c_prime * pair.b_w if linear else None
    cycle = pair_cycle(law, pair.eps_alpha, pair.eps_beta, points)
    return cycle, C_PRIME_B if linear else ONE_PAIR, unit


def geometry_of_model(model: Model) -> dict[str, Any]:
    """Output of `gears --json`."""

    from pitchpoint.report.planets import stages_of_model

    stages = {"planetary_stages": stages_of_model(model)} if model.planetary_stages else {}
    return {
        "gears": {
            name: gear_numbers(model, name) | measure_numbers(gear.geometry)
            for name, gear in model.gears.items()
        },
        "meshes": {name: mesh_numbers(model, name) for name in model.meshes},
        "bevel_gears": {name: bevel_gear_numbers(model, name) for name in model.bevel_gears},
        "bevel_meshes": {name: bevel_mesh_numbers(model, name) for name in model.bevel_meshes},
        **stages,
    }


def stiffness_numbers(single: SingleStiffness) -> dict[str, Any]:
    """Collect the stiffness of a pair by DIN 3990 / ISO 6336, independent of the law of its mesh."""
    return pick(single, STIFFNESS_ROWS, set())


def cycle_numbers(cycle: MeshCycle, relative_to: str, unit_stiffness: float | None) -> dict[str, Any]:
    """Collect the stiffness over a mesh cycle; `unit_stiffness` is the reference of its ratios [N/m]."""
    return {
        "phase": cycle.phase,
        "stiffness_ratio": cycle.stiffness_ratio,
        "mean": cycle.mean,
        "minimum": cycle.minimum,
        "maximum": cycle.maximum,
        "peak_to_peak": cycle.peak_to_peak,
        "jumps": list(cycle.jumps),
        "relative_to": relative_to,
        "unit_stiffness": unit_stiffness,
    }
