# SPDX-License-Identifier: Apache-2.0
"""Clearances of pairs against closed forms: backlash, tip clearance, tips of internal pairs, fillets."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.geometry.clearance import ACCURACY, BACK, FRONT, KINDS, clearances
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.geometry.outline_distance import FILLET, FLANK, ROOT, TIP, gear_line
from pitchpoint.geometry.placement import mesh_offset
from pitchpoint.geometry.problems import tip_overlap_gap
from pitchpoint.geometry.tooth_form import gear_outline, tooth_form
from pitchpoint.geometry.tooth_outline import outline_from_flanks

M = 3e-3
THIN = {"thickness_allowance": -60e-6}


def external(z1: int, z2: int, x1: float, x2: float, beta: float = 0.0, more: float = 50e-6) -> GearPair:
    pair = GearPair.from_profile_shifts(
        CylindricalGear(z=z1, m_n=M, x=x1, beta=beta, **THIN), CylindricalGear(z=z2, m_n=M, x=x2, beta=-beta)
    )
    return pair.at_center_distance(pair.a_w + more)


def internal(z1: int, z2: int, short: float, distance: float | None = None) -> GearPair:
    """Unshifted pair with teeth shortened by `short` modules, without backlash at the reference distance."""
    return GearPair(
        CylindricalGear(z=z1, m_n=M, tip_alteration=-short * M),
        CylindricalGear.internal(z=z2, m_n=M, tip_alteration=-short * M),
        -0.5 * M * (z2 - z1) if distance is None else -distance,
    )


PAIRS = {
    "spur": external(20, 50, 0.2, 0.1),
    "helical": external(17, 40, 0.3, 0.0, 0.35),
    "few teeth": external(8, 200, 0.5, -0.3),
    "ring": internal(20, 70, 0.1, 0.0748),
}


@pytest.mark.parametrize("name", PAIRS)
def test_flanks_and_roots_are_as_far_apart_as_the_formulas_say(name: str) -> None:
    """Half of the backlash along the base tangent; a_w less both radii, the root as deep as the tool went."""
    pair = PAIRS[name]
    found = clearances(pair)
    for kind in (FRONT, BACK):
        assert found[kind].distance == pytest.approx(0.5 * pair.j_bt, abs=1e-6 * M)
    g1, g2 = pair.gear1, pair.gear2
    for kind, tip, root in (("tip_1_root_2", g1.d_a, g2.d_fE), ("tip_2_root_1", g2.d_a, g1.d_fE)):
        assert found[kind].distance == pytest.approx(pair.a_w - 0.5 * (tip + root), abs=1e-9 * M)
    assert ("tips" in found) == pair.is_internal
    for kind, one in found.items():
        # what is reported to be the distance is that of the two places, which lie on the outlines
        apart = math.dist(one.place1, one.place2)
        assert apart == pytest.approx(abs(one.distance), abs=1e-9 * M), kind


def test_the_places_lie_on_the_teeth_as_they_stand() -> None:
    pair = PAIRS["helical"]
    for one in clearances(pair).values():
        ends = (complex(*one.place1), complex(*one.place2) - pair.a_w)
        turns = (one.phi1, mesh_offset(pair) + one.phi2)
        for gear, end, turn in zip((pair.gear1, pair.gear2), ends, turns, strict=True):
            near = gear_line(gear).nearest(np.array([end * np.exp(-1j * turn)]))
            assert abs(near.distance[0]) < ACCURACY * M


def corner_to_fillet(pair: GearPair) -> float:
    """Least distance of the tip corner of gear 2 from the fillet of gear 1, front flanks touching, by force.

    The path of the corner in the frame of gear 1 and the closed form of the fillet, nothing else.
    """
    one, two = tooth_form(pair.gear1), tooth_form(pair.gear2)
    r, half = one.fillet_polar(np.linspace(one.fillet.theta_root, one.theta_form, 3000))
    phi = np.linspace(-1.2, -0.6, 2401) * 2.0 * math.pi / pair.gear1.z
    best = math.inf
    turn1 = np.exp(-1j * phi)
    phi2 = -phi * pair.gear1.z / pair.gear2.z + 0.5 * pair.j_bt / pair.gear2.r_b
    for side in (1.0, -1.0):
        for tooth in range(-2, 3):
            at = mesh_offset(pair) + phi2 + 2.0 * math.pi * tooth / pair.gear2.z
            corner = (pair.a_w + two.r_a * np.exp(1j * (at + side * two.tip_half_angle))) * turn1
            for flank in (1.0, -1.0):
                line = r * np.exp(1j * flank * half)
                near = np.abs(corner - line[1500]) < 1.0 * M
                if near.any():
                    best = min(best, float(np.abs(corner[near, None] - line[None, ::-4]).min()))
    return best


def test_distance_of_a_tip_from_the_fillet_by_force() -> None:
    """No outline, no search: the trochoid of the corner against the formula of the fillet."""
    pair = PAIRS["spur"]
    assert pair.d_Nf1 > pair.gear1.d_Ff
    expected = corner_to_fillet(pair)
    assert expected > 20 * ACCURACY * M
    found = clearances(pair)["tip_2_fillet_1"].distance
    assert found == pytest.approx(expected, abs=2.0 * ACCURACY * M)


@pytest.mark.parametrize("longer, hits", [(0.0, False), (0.25, True)])
def test_a_tip_below_the_form_circle_runs_into_the_fillet(longer: float, hits: bool) -> None:
    """ISO 21771: contact must not begin below the root form circle, d_Nf1 >= d_Ff1."""
    pair = GearPair(
        CylindricalGear(z=25, m_n=M, **THIN),
        CylindricalGear(z=80, m_n=M, tip_alteration=longer * M),
        0.5 * M * 105,
    )
    assert (pair.d_Nf1 < pair.gear1.d_Ff) == hits
    found = clearances(pair)
    assert (found["tip_2_fillet_1"].distance < -ACCURACY * M) == hits
    assert found["tip_2_root_1"].distance > 0.0  # it is the fillet alone
    assert found["tip_1_fillet_2"].distance > 0.0


def test_straight_ends_of_flanks_inside_the_base_circle_collide() -> None:
    """The angular gap counts tips at the base circle; this ring continues inside it, and that end hits."""
    pair = internal(20, 28, 0.0)
    assert abs(pair.gear2.d_a) < abs(pair.gear2.d_b) and tip_overlap_gap(pair) > 0.0
    tips = clearances(pair)["tips"]
    assert tips.distance < -0.02 * M
    # the corner of the ring lies inside the pinion, told by the crossings of a ray
    ring = gear_outline(pair.gear1, 400, rotation=tips.phi1)
    x, y = tips.place2
    a, b = ring[:-1], ring[1:]
    cut = (a[:, 1] > y) != (b[:, 1] > y)
    beyond = a[cut, 0] + (y - a[cut, 1]) / (b - a)[cut, 1] * (b - a)[cut, 0] > x
    assert beyond.sum() % 2 == 1
    assert math.dist((x, y), (pair.a_w, 0.0)) == pytest.approx(0.5 * abs(pair.gear2.d_a), rel=1e-6)


@pytest.mark.parametrize("z2, short", [(26, 0.3), (27, 0.2), (25, 0.3), (26, 0.2), (60, 0.1)])
def test_tips_of_internal_pairs_collide_where_the_formula_says(z2: int, short: float) -> None:
    """Trochoid interference: the sign of the angular gap of the tips, and about its arc where it is small."""
    pair = internal(20, z2, short)
    arc = tip_overlap_gap(pair) * 0.5 * abs(pair.gear2.d_a)
    tips = clearances(pair)["tips"].distance
    assert math.copysign(1.0, tips) == math.copysign(1.0, arc)
    if abs(arc) < 0.05 * M:
        assert 0.5 * abs(arc) < abs(tips) <= 1.1 * abs(arc)


def test_swapped_gears_swap_their_clearances() -> None:
    pair = PAIRS["spur"]
    here, there = clearances(pair), clearances(GearPair(pair.gear2, pair.gear1, pair.a_w))
    for kind in KINDS[2:6]:
        other = kind.translate(str.maketrans("12", "21"))
        swapped = f"tip_{other[4]}_{kind[6:-1]}{other[-1]}"
        assert there[swapped].distance == pytest.approx(here[kind].distance, abs=1e-2 * ACCURACY * M)


def test_a_real_tooth_counts() -> None:
    """A left flank that lacks 1 mrad stands r_b mrad farther from its mate, the right one does not."""
    pair = PAIRS["spur"]
    form = tooth_form(pair.gear1)
    r, half, n = form.flank(120)
    left = r[n - 1 :] * np.exp(1j * (half[n - 1 :] - 1e-3))
    outline = outline_from_flanks(pair.gear1, left=np.column_stack([left.real, left.imag]))
    found = clearances(GearPair(pair.gear1.replace(outline=outline), pair.gear2, pair.a_w))
    thinner = 0.5 * pair.j_bt + 1e-3 * pair.gear1.r_b
    assert found[FRONT].distance == pytest.approx(thinner, abs=ACCURACY * M)
    assert found[BACK].distance == pytest.approx(0.5 * pair.j_bt, abs=ACCURACY * M)


SHORT_RING = CylindricalGear.internal(z=28, m_n=M)
"""Its tips lie inside the base circle: the flanks end in straight lines."""
GEARS = {"pinion": PAIRS["helical"].gear1, "ring": PAIRS["ring"].gear2, "inside base": SHORT_RING}


@pytest.mark.parametrize("gear", GEARS.values(), ids=GEARS)
def test_distances_from_an_outline_are_those_of_its_polygon(gear: CylindricalGear) -> None:
    """Random points: distance to every segment, and inside or outside by the crossings of a ray."""
    ring = gear_outline(gear, 60)
    a, b = ring[:-1], ring[1:]
    rng = np.random.default_rng(3)
    radius = 0.5 * np.abs(rng.uniform(gear.d_f - M, gear.d_a + M, 300))
    angle = rng.uniform(-math.pi, math.pi, 300)
    near = gear_line(gear, 60).nearest(radius * np.exp(1j * angle))
    for k, (x, y) in enumerate(zip(radius * np.cos(angle), radius * np.sin(angle), strict=True)):
        away, along = np.array([x, y]) - a, b - a
        share = np.clip((away * along).sum(1) / (along**2).sum(1), 0.0, 1.0)
        far = np.hypot(*(away - share[:, None] * along).T).min()
        cut = (a[:, 1] > y) != (b[:, 1] > y)
        right = a[cut, 0] + (y - a[cut, 1]) / along[cut, 1] * along[cut, 0] > x
        within = bool(right.sum() % 2) != gear.is_internal
        assert near.distance[k] == pytest.approx(-far if within else far, abs=1e-3 * M * 0.05)
    assert set(near.part.tolist()) | {ROOT} == {ROOT, FILLET, FLANK, TIP}
