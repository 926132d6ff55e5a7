# SPDX-License-Identifier: Apache-2.0
"""Planetary sets from numbers: planets hang on the carrier, meshes of constant stiffness without play."""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.contact.stiffness.constant import constant
from pitchpoint.elements import bushing
from pitchpoint.elements.mesh.record import RECORD
from pitchpoint.elements.signal import Pool
from pitchpoint.geometry import CylindricalGear, GearPair
from pitchpoint.multibody.bodies import PLANAR, TORSION, Body
from pitchpoint.system.rules.gear_mesh import Placement, mesh_row
from pitchpoint.system.rules.mesh_laws import MeshLaws
from pitchpoint.system.system import assemble
from tests.support.engine import bearings
from tests.support.markers import set_markers

SUN, CARRIER, RING, FIRST = 1, 2, 3, 4
"""Numbers of the bodies; planets follow from the first."""


def gear_pairs(z_sun, z_planet, module, alpha):
    """Sun with planet and planet with ring, without profile shift."""
    sun, planet, ring = (
        CylindricalGear(z=z, m_n=module, alpha_n=alpha, b=0.02)
        for z in (z_sun, z_planet, -z_sun - 2 * z_planet)
    )
    return GearPair.from_profile_shifts(sun, planet), GearPair.from_profile_shifts(planet, ring)


def _mesh(pair, stiffness, bodies, places, pool, damping=0.0):
    """Record of a mesh between two bodies at places (2,) in the plane of the world; no play at all."""
    one, two = (np.array([*p, 0.0]) for p in places)
    theta = math.atan2(*(two - one)[1::-1])
    towards = theta + (math.pi if pair.a_w < 0.0 else 0.0)
    phi2 = towards + (0.0 if pair.a_w < 0.0 else math.pi) - math.pi / pair.gear2.z
    place = Placement(origin1=one, origin2=two, phi1=towards, phi2=phi2)
    laws = MeshLaws(stiffness=constant(pair, mean=stiffness), d_in=damping, d_out=damping)
    row = mesh_row(pair, place, laws, pool.add, 0.0)
    row["i"], row["j"] = bodies
    return row


def planetary(pairs, inertias, meshes, masses=None, supports=None, n=3, damping=0.0):
    """A set of n planets; inertias and masses by sun, carrier, ring, planet, mesh stiffness sun and ring.

    Without masses everything only spins. `supports` gives stiffness of the bearings of sun, carrier, ring,
    planets [N/m] and torsional stiffness of the ring to ground [N m/rad].
    """
    a = pairs[0].a_w
    motion = TORSION if masses is None else PLANAR
    masses = masses or (0.0, 0.0, 0.0, 0.0)
    angles = 2.0 * np.pi * np.arange(n) / n
    places = [(a * math.cos(psi), a * math.sin(psi)) for psi in angles]
    bodies = [
        Body(motion=motion, mass=m, polar_inertia=j, transverse_inertia=j, name=name)
        for name, m, j in zip(("sun", "carrier", "ring"), masses, inertias, strict=False)
    ]
    bodies += [
        Body(
            motion=motion,
            parent=CARRIER,
            position=(*place, 0.0),
            mass=masses[3],
            polar_inertia=inertias[3],
            transverse_inertia=inertias[3],
            name=f"planet{k + 1}",
        )
        for k, place in enumerate(places)
    ]
    pool, rows = Pool(), []
    for k, place in enumerate(places):
        rows.append(_mesh(pairs[0], meshes[0], (SUN, FIRST + k), ((0, 0), place), pool, damping))
        rows.append(_mesh(pairs[1], meshes[1], (FIRST + k, RING), (place, (0, 0)), pool, damping))
    banks = {"gear_mesh": np.array(rows, RECORD)}
    *radial, torsional = supports or (0.0, 0.0, 0.0, 0.0, 0.0)
    to_ground = [np.diag([k, k, 0.0, 0.0, 0.0, 0.0]) for k in radial[:3]]
    to_ground[2][5, 5] = torsional
    banks["bearing"] = bearings([(k, 0, K, damping / 1e9 * K) for k, K in enumerate(to_ground, start=1)])
    if supports:
        pins = np.zeros(n, bushing.RECORD)
        pins["i"], pins["j"] = np.arange(n) + FIRST, CARRIER
        for pin, place in zip(pins, places, strict=True):
            set_markers(pin, bodies, (*place, 0.0))
            pin["K"] = np.diag([radial[3], radial[3], 0.0, 0.0, 0.0, 0.0])
            pin["D"] = damping / 1e9 * pin["K"]
        banks["bushing"] = pins
    return assemble(bodies, banks, pools={"gear_mesh": pool.array()})


def lin_parker(n=3, damping=0.0):
    """The planar set of Lin and Parker (1999) with n planets: 9 + 3 n degrees of freedom."""
    pairs = gear_pairs(24, 31, 3.2e-3, math.radians(24.6))
    r_s, r_p, r_r = (0.5 * abs(g.d_b) for g in (pairs[0].gear1, pairs[0].gear2, pairs[1].gear2))
    a = pairs[0].a_w
    inertias = (0.39 * r_s**2, 6.29 * a**2, 3.0 * r_r**2, 0.61 * r_p**2)
    supports = (1e8, 1e8, 1e8, 1e8, 1e9 * r_r**2)
    masses = (0.4, 5.43, 2.35, 0.66)
    return planetary(pairs, inertias, (5e8, 5e8), masses, supports, n, damping)
