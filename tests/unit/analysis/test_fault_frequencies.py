# SPDX-License-Identifier: Apache-2.0
"""Fault frequencies: what holds for all tooth counts, members held in turn, refused numbers."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pitchpoint.analysis.bearing_frequencies import bearing_frequencies
from pitchpoint.analysis.fault_frequencies import PlanetStage, gear_pair_frequencies, train_frequencies
from pitchpoint.analysis.planet_frequencies import excited_motion, planet_phases, planetary_frequencies
from pitchpoint.analysis.sampled import SignalError

TURN = 2.0 * math.pi
TEETH = {"z_sun": 21, "z_planet": 39, "z_ring": 99, "planets": 3}


@given(st.integers(3, 200), st.integers(3, 200))
def test_the_same_teeth_meet_as_often_as_counting_says(z_1: int, z_2: int) -> None:
    """Tooth 0 meets space 0 again after the first m with m = 0 mod z_1 and mod z_2."""
    found = gear_pair_frequencies(z_1, z_2, TURN)
    m = next(m for m in range(z_1, z_1 * z_2 + 1, z_1) if m % z_2 == 0)
    assert found.mesh / found.hunting_tooth == pytest.approx(m, rel=1e-12)
    # of z_1 z_2 pairs of teeth only m ever meet: as many sets as the assembly phase says
    assert found.mesh / found.assembly_phase == pytest.approx(z_1 * z_2 / m, rel=1e-12)


def test_internal_gears_turn_the_same_way() -> None:
    assert gear_pair_frequencies(20, -60, 3.0).speed_2 == pytest.approx(1.0)
    assert gear_pair_frequencies(20, 60, 3.0).speed_2 == pytest.approx(-1.0)
    assert gear_pair_frequencies(-60, 20, 3.0).mesh == pytest.approx(gear_pair_frequencies(60, 20, 3.0).mesh)


@pytest.mark.parametrize("fixed", ["sun", "carrier", "ring"])
def test_any_member_may_be_held(fixed: str) -> None:
    """Willis in the frame of the carrier; one of the two moving members is given, then the other."""
    moving = [m for m in ("sun", "carrier", "ring") if m != fixed]
    first = planetary_frequencies(**TEETH, **{f"speed_{fixed}": 0.0, f"speed_{moving[0]}": 7.0})
    other = getattr(first, f"speed_{moving[1]}")
    second = planetary_frequencies(**TEETH, **{f"speed_{fixed}": 0.0, f"speed_{moving[1]}": other})
    for name in vars(first):
        assert getattr(second, name) == pytest.approx(getattr(first, name), rel=1e-12), name
    w_s, w_c, w_r = first.speed_sun, first.speed_carrier, first.speed_ring
    assert 21 * (w_s - w_c) == pytest.approx(-99 * (w_r - w_c), rel=1e-12)
    # pitch points do not slip, seen from the carrier
    assert 39 * first.speed_planet == pytest.approx(-21 * (w_s - w_c), rel=1e-12)
    assert 39 * first.speed_planet == pytest.approx(99 * (w_r - w_c), rel=1e-12)
    assert first.mesh == pytest.approx(21 * abs(w_s - w_c) / TURN, rel=1e-12)
    assert first.planet_pass == pytest.approx(3 * abs(w_c) / TURN, rel=1e-12, abs=0.0)


def test_counting_contacts_of_a_turning_set() -> None:
    """Turn a set with its ring held and count how often a marked tooth of each gear passes a mesh."""
    found = planetary_frequencies(**TEETH, speed_carrier=1.0, speed_ring=0.0)
    t = np.linspace(0.0, 4000.0, 4_000_001)
    places = np.arange(3) * TURN / 3

    def passes(angle: np.ndarray) -> int:
        return int(np.abs(np.diff(np.floor(angle / TURN))).sum())

    # offsets keep the marks away from a mesh at the start
    sun = sum(passes((found.speed_sun - 1.0) * t + 0.3 - p) for p in places)
    ring = sum(passes(-t + 0.3 - p) for p in places)
    planet = passes(found.speed_planet * t + 0.3)
    for counted, rate in (
        (sun, found.sun_fault),
        (ring, found.ring_fault),
        (planet, found.planet_fault),
    ):
        assert counted / 4000.0 == pytest.approx(rate, abs=3.0 / 4000.0)  # one count per mark


def test_planet_phases_of_a_set_that_is_assembled_equally() -> None:
    """With (z_s + z_r)/N whole, phases at sun and ring are the same."""
    for z_s, z_r, n in ((48, 80, 4), (54, 90, 4), (19, 56, 3), (31, 95, 3)):
        sun, ring = (planet_phases(z, TURN * np.arange(n) / n) for z in (z_s, -z_r))
        np.testing.assert_allclose(sun, ring, atol=1e-12)


def test_excited_motion_is_that_of_the_sum_of_the_forces() -> None:
    """Forces of the phases l z_s n/N: their sum (rotation), and their sum along turning axes
    (translation)."""
    for z, n in ((48, 4), (51, 4), (54, 4), (19, 3), (31, 3), (25, 5), (27, 5)):
        k = np.arange(n)
        for harmonic, motion in enumerate(excited_motion(z, n, 6), start=1):
            force = np.exp(1j * harmonic * z * TURN * k / n)
            torque = abs(force.sum()) / n > 0.5
            push = max(abs((force * np.exp(s * 1j * TURN * k / n)).sum()) for s in (1, -1)) / n > 0.5
            assert motion == ("rotational" if torque else "translational" if push else "planet")


@given(
    st.integers(3, 40),
    st.floats(0.01, 0.9),
    st.floats(0.0, 1.2),
    st.floats(-500.0, 500.0),
    st.floats(-500.0, 500.0),
)
def test_bearing_frequencies_add_up(z: int, d: float, angle: float, inner: float, outer: float) -> None:
    """Every element passes both rings: BPFO + BPFI = Z times the difference of the turns."""
    f = bearing_frequencies(
        elements=z,
        element_diameter=d,
        pitch_diameter=1.0,
        contact_angle=angle,
        speed_inner=inner,
        speed_outer=outer,
    )
    turns = abs(inner - outer) / TURN
    assert f.bpfo + f.bpfi == pytest.approx(z * turns, rel=1e-12, abs=1e-12)
    assert f.bpfo == pytest.approx(z * abs(f.cage_speed - outer) / TURN, rel=1e-9, abs=1e-9)
    assert f.bpfi == pytest.approx(z * abs(f.cage_speed - inner) / TURN, rel=1e-9, abs=1e-9)


def test_rolling_of_a_ball_between_flat_rings() -> None:
    """Contact angle 90 deg: the cage has the mean speed, a ball of d rolls pi D per turn of one ring
    twice."""
    f = bearing_frequencies(
        elements=10, element_diameter=0.01, pitch_diameter=0.1, contact_angle=math.pi / 2, speed_inner=TURN
    )
    assert (f.ftf, f.bpfo, f.bpfi) == pytest.approx((0.5, 5.0, 5.0), rel=1e-12)
    assert f.bsf == pytest.approx(5.0, rel=1e-12)


def test_trains_go_through_planet_sets() -> None:
    found = train_frequencies(
        [PlanetStage(19, 17, 56), PlanetStage(18, 36, 93), (95, 24)], 12.1 * math.pi / 30
    )
    assert abs(found.speed[-1] / found.speed[0]) == pytest.approx((1 + 56 / 19) * (1 + 93 / 18) * 95 / 24)
    held = train_frequencies([PlanetStage(21, 39, 99, input="sun", fixed="carrier")], 3.0)
    assert held.speed[1] == pytest.approx(-3.0 * 21 / 99)
    assert len(train_frequencies([(11, 30)] * 7, 1.0).mesh) == 7


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: gear_pair_frequencies(0, 20, 1.0), "z_1: 0"),
        (lambda: gear_pair_frequencies(20, 20.5, 1.0), "z_2: 20.5"),  # type: ignore[arg-type]
        (lambda: gear_pair_frequencies(-20, -40, 1.0), "both are internal"),
        (lambda: gear_pair_frequencies(20, 40, math.nan), "speed: nan"),
        (lambda: planetary_frequencies(**TEETH, speed_sun=1.0), r"1 given \(limit 2\)"),
        (lambda: excited_motion(20, 2), "planets: 2"),
        (lambda: train_frequencies([], 1.0), "stages: there are none"),
        (lambda: train_frequencies([(11, 30), (0, 3)], 1.0), "stage 2: z_1: 0"),
        (lambda: train_frequencies([PlanetStage(19, 17, 56, fixed="carrier")], 1.0), "stage 1: input, fixed"),
        (
            lambda: bearing_frequencies(
                elements=8, element_diameter=2.0, pitch_diameter=1.0, speed_inner=1.0
            ),
            "element_diameter: 2",
        ),
    ],
)
def test_numbers_that_cannot_be_are_refused_in_words(call, words: str) -> None:
    with pytest.raises(SignalError, match=words):
        call()
