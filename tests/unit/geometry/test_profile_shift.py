# SPDX-License-Identifier: Apache-2.0
"""Profile shifts and centre distance, there and back, and where there is no answer."""

from __future__ import annotations

import math

import pytest

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry import (
    center_distance_for_profile_shift,
    missing_profile_shift,
    pressure_angle_at_center_distance,
    profile_shift_for_center_distance,
    reference_center_distance,
)

PAIR = {"z_sum": 61, "m_n": 3.5e-3, "alpha_n": math.radians(20.0), "beta": math.radians(21.0)}


def test_there_and_back():
    a_w = center_distance_for_profile_shift(**PAIR, x_sum=0.6518771)
    assert a_w == pytest.approx(0.1165, abs=1e-9)
    assert profile_shift_for_center_distance(**PAIR, a_w=a_w) == pytest.approx(0.6518771, rel=1e-12)
    assert missing_profile_shift(**PAIR, a_w=a_w, x_known=0.3) == pytest.approx(0.3518771, rel=1e-12)


def test_no_shift_at_the_reference_centre_distance():
    a_d = reference_center_distance(61, 3.5e-3, PAIR["beta"])
    assert profile_shift_for_center_distance(**PAIR, a_w=a_d) == pytest.approx(0.0, abs=1e-13)


@pytest.mark.parametrize("a_w", [0.1, -0.1165, math.nan])
def test_no_common_tangent(a_w):
    with pytest.raises(GeometryError, match="common tangent"):
        pressure_angle_at_center_distance(**PAIR, a_w=a_w)


def test_shift_too_negative():
    with pytest.raises(GeometryError, match="profile shift"):
        center_distance_for_profile_shift(**PAIR, x_sum=-3.0)
