# SPDX-License-Identifier: Apache-2.0
"""Laws of a mesh with contact of tooth surfaces, for a pair without a model."""

import numpy as np

from pitchpoint.contact.compliance.gear import flank_compliance
from pitchpoint.contact.stiffness.description import PairShape
from pitchpoint.system.rules.flank_contact import ElasticFlanks, GearInfluence, SurfaceContact
from pitchpoint.system.rules.mesh_laws import MeshLaws

PLANES = 11


def rigid(pair, c_prime=14e9, power=1.0, **more):
    """Rigid surfaces."""
    return MeshLaws(
        stiffness=PairShape(c_prime=c_prime, S_R=1.0, power=power), surface=SurfaceContact(**more)
    )


def flexible(pair, planes=PLANES, **more):
    """Flexible teeth with a depth of the local contact that varies over the height."""
    depth = pair.gear1.m_n * np.array([0.8, -0.3, 0.02, 0.0])
    gears = tuple(
        GearInfluence(flank_compliance(gear, planes=planes), depth) for gear in (pair.gear1, pair.gear2)
    )
    elastic = ElasticFlanks(gears=gears, moduli=(206e9, 190e9), poisson=(0.3, 0.28), overlap=1e-11)
    surface = SurfaceContact(planes=planes, elastic=elastic, **more)
    return MeshLaws(stiffness=PairShape(c_prime=14e9, S_R=1.0), surface=surface)
