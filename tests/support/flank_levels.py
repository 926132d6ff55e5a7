# SPDX-License-Identifier: Apache-2.0
"""Laws of a mesh with contact of tooth surfaces, for a pair without a model."""

import numpy as np

from pitchpoint.contact.compliance.gear import flank_compliance
from pitchpoint.contact.potential_build import NominalValues, build_potential_table
from pitchpoint.contact.potential_range import TableSize
from pitchpoint.contact.stiffness.description import PairShape
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.contact_analysis.precompute import (
    PotentialEvaluator,
    TableRequest,
    quantities,
    table_span,
)
from pitchpoint.system.rules.flank_contact import SurfaceContact
from pitchpoint.system.rules.flexible_teeth import ElasticFlanks, GearInfluence
from pitchpoint.system.rules.mesh_laws import MeshLaws

PLANES = 11
N_PAIR = 7
"""Tooth pairs with numbers of their own in the tables, as in the tests."""
COARSE = TableSize(phase=8, approach=6, misalignment=5, centre_distance=3)


def rigid(pair, c_prime=14e9, power=1.0, **more):
    """Rigid surfaces."""
    return MeshLaws(
        stiffness=PairShape(c_prime=c_prime, S_R=1.0, power=power), surface=SurfaceContact(**more)
    )


def flexible(pair, planes=PLANES, scale=1.0, order=(0, 1), **more):
    """Flexible teeth with a depth of the local contact that varies over the height.

    `scale`: size of the pair, for its additional compliance; `order`: materials of both gears.
    """
    depth = pair.gear1.m_n * np.array([0.8, -0.3, 0.02, 0.0])
    gears = tuple(
        GearInfluence(flank_compliance(gear, planes=planes), depth) for gear in (pair.gear1, pair.gear2)
    )
    moduli, poisson = (tuple(pair[k] for k in order) for pair in ((206e9, 190e9), (0.3, 0.28)))
    elastic = ElasticFlanks(gears=gears, moduli=moduli, poisson=poisson, overlap=1e-11 / scale)
    surface = SurfaceContact(planes=planes, elastic=elastic, **more)
    return MeshLaws(stiffness=PairShape(c_prime=14e9, S_R=1.0), surface=surface)


def model_of(pair, contact="level: flexible, planes: 5"):
    """Model of a pair on its own, without bodies."""
    gears = []
    for gear in (pair.gear1, pair.gear2):
        hand = "right" if gear.beta > 0 else "left"
        helix = "" if gear.beta == 0 else f", helix_angle: {abs(gear.beta)!r}, hand: {hand}"
        inside = ", type: internal" if gear.z < 0 else ""
        gears.append(
            f"{{number_of_teeth: {abs(gear.z)}, normal_module: {gear.m_n!r}, face_width: {gear.b!r}, "
            f"profile_shift_coefficient: {gear.x!r}{helix}{inside}}}"
        )
    return loads_model(
        f"gears:\n  g1: {gears[0]}\n  g2: {gears[1]}\n"
        f"meshes:\n  stage: {{gears: [g1, g2], center_distance: {abs(pair.a_w)!r}, contact: {{{contact}}}}}\n"
    )


def table(pair, flank, size=COARSE, scale=1.0):
    """Small table of the potential of flexible teeth, as an array; its errors do not matter here.

    Up to 800 N m, misalignments of 2e-3 and deviations of the centre distance of 0.1 mm, times the powers of
    `scale`.
    """
    source = PotentialEvaluator(model_of(pair), "stage", flank)
    source.pairs = N_PAIR
    request = TableRequest(torque=800.0 * scale**3, misalignment=2e-3, centre_distance=1e-4 * scale)
    span = table_span(source, request)
    nominal = NominalValues(source.flanks.force_of(request.torque), source.pitch, pair.b_w)
    return build_potential_table(source.copy, span, nominal, size, quantities(N_PAIR), checks=1).packed


def precomputed(pair, scale=1.0, **more):
    """Forces from a table of the potential of each flank."""
    tables = (table(pair, 1, scale=scale), table(pair, -1, scale=scale))
    return flexible(pair, tables=tables, scale=scale, **more)
