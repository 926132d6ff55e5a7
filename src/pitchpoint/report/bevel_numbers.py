# SPDX-License-Identifier: Apache-2.0
"""Geometry tables of bevel gears and pairs, by their ISO 23509 symbols."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from pitchpoint.report.number_rows import C_PRIME_B, MEAN, Row, law_numbers, pick

if TYPE_CHECKING:
    from pitchpoint.contact.mesh_cycle import MeshCycle
    from pitchpoint.model.model import Model

BEVEL_GEAR_ROWS: tuple[Row, ...] = (
    ("z", "number of teeth", "dimensionless"),
    ("m_mn", "mean normal module", "length"),
    ("m_et", "outer transverse module", "length"),
    ("alpha_n", "normal pressure angle", "angle"),
    ("alpha_t", "transverse pressure angle", "angle"),
    ("beta_m", "mean spiral angle", "angle"),
    ("beta_b", "base spiral angle", "angle"),
    ("x_hm", "profile shift coefficient", "dimensionless"),
    ("x_sm", "thickness modification coefficient", "dimensionless"),
    ("b", "face width", "length"),
    ("delta", "pitch cone angle", "angle"),
    ("delta_a", "tip cone angle", "angle"),
    ("delta_f", "root cone angle", "angle"),
    ("delta_b", "base cone angle", "angle"),
    ("R_e", "outer cone distance", "length"),
    ("R_m", "mean cone distance", "length"),
    ("R_i", "inner cone distance", "length"),
    ("d_e", "outer pitch diameter", "length"),
    ("d_m", "mean pitch diameter", "length"),
    ("d_ae", "outside diameter", "length"),
    ("t_xo", "apex to crown", "length"),
    ("h_ae", "outer addendum", "length"),
    ("h_fe", "outer dedendum", "length"),
    ("s_mn", "mean normal tooth thickness", "length"),
    ("z_v", "virtual number of teeth", "dimensionless"),
)

BEVEL_PAIR_ROWS: tuple[Row, ...] = (
    ("Sigma", "shaft angle", "angle"),
    ("u", "gear ratio", "dimensionless"),
    ("b", "common face width", "length"),
    ("sigma_p", "base pitch in the plane of action", "angle"),
    ("sigma_A", "start of contact", "angle"),
    ("sigma_w", "angle of the pitch ray", "angle"),
    ("sigma_E", "end of contact", "angle"),
    ("sigma_T", "angle between the rays on both base cones", "angle"),
    ("eps_alpha", "transverse contact ratio", "dimensionless"),
    ("eps_beta", "overlap ratio", "dimensionless"),
    ("eps_gamma", "total contact ratio", "dimensionless"),
    ("j_mt", "mean circumferential backlash", "length"),
    ("j_mn", "mean normal backlash", "length"),
)

BEVEL_STIFFNESS_ROWS: tuple[Row, ...] = (
    ("c_prime", "single stiffness by ISO 6336", "stiffness_per_width"),
    ("c_gamma_alpha", "mesh stiffness by ISO 6336", "stiffness_per_width"),
    ("C_B", "basic rack factor", "dimensionless"),
)


def bevel_gear_numbers(model: Model, name: str) -> dict[str, Any]:
    """Collect geometry, mass and moments of inertia of a bevel gear; spiral angles are positive.

    The centre of mass is measured from the apex into the gear.
    """
    from pitchpoint.geometry.bevel.tooth import bevel_tooth
    from pitchpoint.model.inertia import bevel_gear_inertia

    gear = model.bevel_gears[name]
    numbers = pick(gear.geometry, BEVEL_GEAR_ROWS, {"beta_m", "beta_b"})
    numbers["hand"] = gear.hand
    numbers["undercut"] = bevel_tooth(gear.geometry).undercut
    mass, polar, transverse, at = bevel_gear_inertia(gear)
    numbers |= {"mass": mass, "polar_inertia": polar, "transverse_inertia": transverse}
    return numbers | {"center_of_mass": gear.direction * at}


def bevel_mesh_numbers(model: Model, name: str) -> dict[str, Any]:
    """Collect geometry and stiffness of a bevel mesh, see `numbers.mesh_numbers`."""
    from pitchpoint.system.rules.bevel_mesh import bevel_single_stiffness, bevel_stiffness, mean_stiffness

    pair = model.bevel_pairs[name]
    numbers = pick(pair, BEVEL_PAIR_ROWS, set())
    gap = model.backlash(name)
    numbers |= {"j_mt": gap / math.cos(pair.alpha_t), "j_mn": gap * math.cos(pair.beta_b)}
    law = bevel_stiffness(model, name)
    numbers |= law_numbers(model.bevel_meshes[name].stiffness.law, law, mean_stiffness(pair, law))
    numbers |= pick(bevel_single_stiffness(model, name), BEVEL_STIFFNESS_ROWS, set())
    return numbers | {"gears": list(model.bevel_meshes[name].gears)}


def bevel_cycles(model: Model, points: int) -> dict[str, tuple[MeshCycle, str, float | None]]:
    """Stiffness cycle of every bevel mesh, see `numbers.cycles_of_model`."""
    from pitchpoint.contact.bevel_cycle import bevel_cycle
    from pitchpoint.contact.mesh_cycle import phase_cycle
    from pitchpoint.contact.stiffness.description import PhaseStiffness
    from pitchpoint.system.rules.bevel_mesh import bevel_stiffness, square_mean

    cycles: dict[str, tuple[MeshCycle, str, float | None]] = {}
    for name, pair in model.bevel_pairs.items():
        law = bevel_stiffness(model, name)
        if isinstance(law, PhaseStiffness):
            cycles[name] = phase_cycle(law, points), MEAN, law.mean
            continue
        face = (pair.R_i / pair.R_m, pair.R_e / pair.R_m)
        rate = math.tan(pair.beta_b) / pair.sigma_p
        cycle = bevel_cycle(law, pair.eps_alpha, rate, face, points)
        cycles[name] = cycle, C_PRIME_B, law.c_prime * square_mean(pair)
    return cycles
