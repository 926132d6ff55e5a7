# SPDX-License-Identifier: Apache-2.0
"""Clearance of flanks with micro-geometry: closed forms on parallel and tilted axes, and a plain search."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.geometry.clearance import BACK, FRONT
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.deviations import Deviations, Runout, separation
from pitchpoint.geometry.flank_clearance import IDEAL, MicroGeometry, below_form, flank_clearances
from pitchpoint.geometry.flank_distance import Mounting
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.geometry.modifications import EndRelief, FlankModifications, Relief
from tests.unit.geometry.test_flank_distance import PAIRS

KINDS = {FRONT: ("left", 1.0), BACK: ("right", -1.0)}


def sides(pair, kind):
    """Sides of both gears that form the front or back flanks."""
    own = KINDS[kind][0]
    other = {"left": "right", "right": "left"}[own]
    return own, other if pair.is_internal else own


@pytest.mark.parametrize("name", PAIRS)
def test_ideal_flanks_are_half_the_backlash_apart(name):
    pair = PAIRS[name]
    found = flank_clearances(Mounting(pair=pair, offset=2e-3))
    for kind in KINDS:
        assert found[kind].distance == pytest.approx(0.5 * pair.j_bt, abs=1e-14)
        assert math.dist(found[kind].place1, found[kind].place2) == pytest.approx(
            found[kind].distance, abs=1e-14
        )


def on_the_path(pair, kind, micro, offset):
    """Least sum of both gaps over the path of contact and the common face width, points on the line [m]."""
    roll = np.linspace(max(pair.T1A, pair.T1A_form), min(pair.T1E, pair.T1E_form), 150)
    mate = np.abs(pair.T1T2 - roll)
    low = max(-0.5 * pair.gear1.b, offset - 0.5 * pair.gear2.b)
    high = min(0.5 * pair.gear1.b, offset + 0.5 * pair.gear2.b)
    z = np.linspace(low, high, 41)
    total = np.zeros((z.size, roll.size))
    for gear, side, own, at, width in zip(
        (pair.gear1, pair.gear2), sides(pair, kind), micro, (roll, mate), (z, z - offset), strict=True
    ):
        total += separation(
            gear,
            side,
            width,
            at,
            modifications=own.left if side == "left" else own.right,
            deviations=own.deviations,
        ).min(axis=0)
    return float(total.min())


SLOPED = FlankModifications(profile_slope=8e-6, helix_slope=-5e-6, lead_crowning=-3e-6)
RELIEVED = FlankModifications(
    tip_relief=Relief(amount=15e-6, length=3e-3), end_relief=EndRelief(amount=9e-6, length=4e-3)
)
LATE = Deviations(pitch=[0.0] * 7 + [9e-6, -4e-6] + [0.0] * 16, runout=Runout(amount=16e-6, phase=0.3))


@pytest.mark.parametrize(
    "micro",
    [
        (MicroGeometry(left=SLOPED, right=RELIEVED), IDEAL),
        (IDEAL, MicroGeometry(left=RELIEVED, right=SLOPED)),
        (MicroGeometry(left=SLOPED, right=SLOPED, deviations=LATE), MicroGeometry(left=RELIEVED)),
    ],
)
@pytest.mark.parametrize("name", ["spur", "helical", "internal spur", "internal helical"])
def test_least_sum_of_the_gaps(name, micro):
    """Points off the line of action add at most slope^2/(4 q) to what those on it say, some 0.2 µm."""
    pair, offset = PAIRS[name], 3e-3
    for kind, found in flank_clearances(Mounting(pair=pair, offset=offset), micro).items():
        expected = 0.5 * pair.j_bt + on_the_path(pair, kind, micro, offset)
        assert expected - 0.3e-6 < found.distance < expected + 0.05e-6
        assert found.distance <= 0.5 * pair.j_bt + 1e-14
        assert found.z is not None and abs(found.z) < 0.5 * pair.gear1.b + 1e-5


@pytest.mark.parametrize("tilt", [(2e-4, 0.0), (-1e-4, 0.0), (0.0, 3e-4)])
@pytest.mark.parametrize("kind", KINDS)
def test_tilted_axes_come_closer_at_one_end_of_the_face(kind, tilt):
    pair, (out, within) = PAIRS["spur"], tilt
    found = flank_clearances(Mounting(pair=pair, in_plane=within, out_of_plane=out))[kind]
    alpha, way = pair.alpha_wt, KINDS[kind][1]
    kappa = way * math.cos(alpha) * out + math.sin(alpha) * within
    assert found.distance == pytest.approx(0.5 * pair.j_bt - 0.5 * abs(kappa) * pair.gear1.b, abs=2e-9)
    assert found.z == pytest.approx(math.copysign(0.5 * pair.gear1.b, -kappa), abs=5e-5)


def test_contact_below_the_root_form_circle():
    gear, long = CylindricalGear(z=25, m_n=3e-3), CylindricalGear(z=80, m_n=3e-3, tip_alteration=0.75e-3)
    assert below_form(GearPair(gear, CylindricalGear(z=80, m_n=3e-3), 0.1575)) == (False, False)
    assert below_form(GearPair(gear, long, 0.1575)) == (True, False)
