# SPDX-License-Identifier: Apache-2.0
"""Deviations of single teeth: signs and amounts against displaced exact profiles."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.deviations import Deviations, FlankMap, Runout, index_deviations, separation
from pitchpoint.geometry.modifications import FlankModifications, Relief, base_tangent, deviation, flank_range
from pitchpoint.geometry.tooth_form import tooth_form

GEAR = CylindricalGear(z=20, m_n=3e-3, x=0.3, beta=0.2, b=0.02)
RING = CylindricalGear(z=-60, m_n=3e-3, b=0.02)
BOTH = pytest.mark.parametrize("gear", [GEAR, RING], ids=["external", "internal"])
SIDES = pytest.mark.parametrize("flank", ["left", "right"])


def flank_point(gear: CylindricalGear, flank: str, tooth: int, roll: float) -> tuple[complex, complex]:
    """Point of a perfect flank and the outward normal there, by differences of the exact profile."""
    form = tooth_form(gear)
    side = 1.0 if flank == "left" else -1.0

    def point(length: float) -> complex:
        r = math.hypot(form.r_b, length)
        return r * np.exp(1j * (2.0 * math.pi * tooth / form.z + side * float(form.involute_half_angle(r))))

    tangent = point(roll + 1e-7) - point(roll - 1e-7)
    normal = 1j * tangent / abs(tangent)
    counter_clockwise = 1j * point(roll)
    return point(roll), normal * np.sign(side * (normal * counter_clockwise.conjugate()).real)


@BOTH
@SIDES
def test_runout_is_the_displacement_of_the_exact_flank(gear: CylindricalGear, flank: str) -> None:
    runout = Runout(amount=40e-6, phase=0.7)
    roll = np.linspace(*flank_range(gear), 4)
    gap = separation(gear, flank, [0.0], roll, deviations=Deviations(runout=runout))
    shift = 20e-6 * np.exp(0.7j)
    for tooth in (0, 7):
        for k, length in enumerate(roll):
            _, normal = flank_point(gear, flank, tooth, length)
            moved_out = (shift * normal.conjugate()).real
            assert gap[tooth, 0, k] == pytest.approx(-moved_out, abs=1e-10)


@BOTH
@SIDES
def test_pitch_turns_the_flank(gear: CylindricalGear, flank: str) -> None:
    z = abs(gear.z)
    pitch = np.random.default_rng(3).normal(scale=5e-6, size=z)
    gap = separation(gear, flank, [0.0], [0.02], deviations=Deviations(pitch=pitch))[:, 0, 0]
    turn = index_deviations(pitch) / (0.5 * abs(gear.d))
    for tooth in (0, 5):
        point, normal = flank_point(gear, flank, tooth, 0.02)
        moved_out = (1j * point * turn[tooth] * normal.conjugate()).real
        assert gap[tooth] == pytest.approx(-moved_out, abs=1e-10)
    assert gap.sum() == pytest.approx(0.0, abs=1e-18)


def test_left_and_right_pitch_may_differ() -> None:
    pitch = [0.0] * 19 + [1e-6]
    own = Deviations(pitch=(), pitch_right=pitch)
    assert not separation(GEAR, "left", [0.0], [0.02], deviations=own).any()
    assert separation(GEAR, "right", [0.0], [0.02], deviations=own).any()


@BOTH
def test_flank_map_is_put_on_its_flank(gear: CylindricalGear) -> None:
    root, tip = flank_range(gear)
    values = np.array([[1.0, 2.0, 3.0], [5.0, 6.0, 7.0]]) * 1e-6
    data = Deviations(flank_maps=[FlankMap(tooth=4, flank="left", values=values)])
    z = np.array([-0.01, 0.0, 0.005])
    gap = separation(gear, "left", z, [root, 0.5 * (root + tip), tip], deviations=data) * 1e6
    assert gap[4] == pytest.approx(-np.array([[1, 3, 5], [2, 4, 6], [2.5, 4.5, 6.5]]), abs=1e-9)
    assert not gap[3].any()
    assert not separation(gear, "right", z, [root, tip], deviations=data).any()


def test_all_parts_add_up() -> None:
    roll, z = np.linspace(*flank_range(GEAR), 5), np.linspace(-0.01, 0.01, 3)
    micro = FlankModifications(tip_relief=Relief(amount=2e-5, length=3e-3), lead_crowning=5e-6)
    data = Deviations(
        pitch=np.sin(np.arange(20.0)) * 1e-6,
        runout=Runout(amount=1e-5),
        flank_maps=[FlankMap(tooth=0, flank="left", values=[[1e-6]])],
    )
    total = separation(GEAR, "left", z, roll, modifications=micro, deviations=data)
    parts = separation(GEAR, "left", z, roll, modifications=micro)
    for one in (
        Deviations(pitch=data.pitch),
        Deviations(runout=data.runout),
        Deviations(flank_maps=data.flank_maps),
    ):
        parts = parts + separation(GEAR, "left", z, roll, deviations=one)
    assert total == pytest.approx(parts, abs=1e-20)
    only = separation(GEAR, "left", z, roll, modifications=micro)
    assert only[11] == pytest.approx(
        base_tangent(deviation(micro, GEAR, roll[None, :], z[:, None]), GEAR), abs=0
    )


@pytest.mark.parametrize(
    "bad",
    [
        Deviations(pitch=[1e-6, 2e-6]),
        Deviations(pitch=[math.nan] * 20),
        Deviations(runout=Runout(amount=-1.0)),
        Deviations(flank_maps=[FlankMap(tooth=20, flank="left", values=[[0.0]])]),
        Deviations(flank_maps=[FlankMap(tooth=0, flank="upper", values=[[0.0]])]),
        Deviations(flank_maps=[FlankMap(tooth=0, flank="left", values=[0.0])]),
    ],
)
def test_data_that_do_not_fit_are_refused(bad: Deviations) -> None:
    with pytest.raises(GeometryError):
        separation(GEAR, "left", [0.0], [0.02], deviations=bad)
    with pytest.raises(GeometryError, match="flank"):
        separation(GEAR, "front", [0.0], [0.02])
