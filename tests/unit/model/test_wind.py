# SPDX-License-Identifier: Apache-2.0
"""Descriptions of wind: numbers of IEC 61400-1, and all problems of a description together."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.model.wind.box import WindBox
from pitchpoint.model.wind.iec import Gust, RotorSite, WindClass
from pitchpoint.model.wind.steady import SteadyWind
from pitchpoint.model.wind.turbulence import KaimalTurbulence


@pytest.mark.parametrize(
    ("name", "v_e50", "v_e1", "normal_15"),
    [("IA", 70.0, 56.0, 2.696), ("IIB", 59.5, 47.6, 2.359), ("IIIC", 52.5, 42.0, 2.022)],
)
def test_speeds_and_deviations_of_the_classes(name: str, v_e50: float, v_e1: float, normal_15: float) -> None:
    found = WindClass(name[:-1], name[-1])
    assert found.extreme_speed(50) == pytest.approx(v_e50)
    assert found.extreme_speed(1) == pytest.approx(v_e1)
    assert found.normal_deviation(15.0) == pytest.approx(normal_15)
    extreme = found.extreme_wind(90.0, 1)
    assert (extreme.speed, extreme.exponent) == (pytest.approx(v_e1), 0.11)


def test_extreme_turbulence_is_that_of_the_formula_of_turbsim() -> None:
    """c I_ref (0.072 (V_ave/c + 3)(V_hub/c - 4) + 10) with c = 2 m/s: 2.8 m/s at 8 m/s, B, for any V_ave."""
    assert WindClass("I", "B").extreme_deviation(8.0) == pytest.approx(2.0 * 0.14 * 10.0)
    assert WindClass("I", "B").extreme_deviation(12.0) == pytest.approx(3.12256)
    assert WindClass("III", "B").extreme_deviation(12.0) == pytest.approx(0.28 * (0.072 * 6.75 * 2.0 + 10.0))


def test_gusts_at_the_limits_of_their_formulas() -> None:
    """The gust is limited by the extreme speed near it, the angle of slow wind by 180°."""
    site = RotorSite(WindClass("III", "A"), hub_height=50.0, diameter=40.0)
    assert site.operating_gust(37.0).amplitude == pytest.approx(1.35 * (42.0 - 37.0))
    assert site.operating_gust(10.0).amplitude == pytest.approx(3.3 * 0.16 * 13.1 / (1.0 + 0.1 * 40.0 / 35.0))
    assert site.coherent_gust(3.0).angle == pytest.approx(math.pi)
    assert site.coherent_gust(16.0, sign=-1).angle == pytest.approx(math.radians(-45.0))
    assert site.direction_change(0.5).angle == math.pi
    turned = 4.0 * math.atan(0.16 * (0.75 * 5.0 + 5.6) / (5.0 * (1.0 + 4.0 / 35.0)))
    assert site.direction_change(5.0, sign=-1).angle == pytest.approx(-turned)


def test_all_problems_of_a_wind_are_reported_together() -> None:
    with pytest.raises(ModelError) as raised:
        SteadyWind(speed=math.nan, hub_height=-1.0, profile="cubic", exponent=True)
    text = str(raised.value)
    assert text.startswith("4 problems")
    assert "steady wind.profile: 'cubic' is not known (limit uniform, power, logarithmic)" in text
    assert "steady wind.speed: nan m/s is not a finite number (limit 0 to 150 m/s)" in text
    assert "steady wind.hub_height: -1 m is out of range (limit 1 to 1000 m)" in text


TURBULENCE = {
    "mean_speed": 12.0, "deviation": 1.8, "hub_height": 90.0, "size": (60.0, 60.0), "points": (3, 3),
    "duration": 60.0, "time_step": 0.1,
}  # fmt: skip
BOX = {"time_step": 0.5, "spacing": (4.0, 6.0), "bottom": 80.0, "hub_height": 90.0, "mean_speed": 10.0}
CALM = np.zeros((2, 2, 2, 3), np.float32)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"points": (3, 1)}, "60 m, 1 points has a height that contradicts its number of points"),
        ({"size": (60.0, 200.0)}, "height: 200 m is out of range .limit 0 to 180 m"),
        ({"time_step": 30.0}, "2 samples are too few .limit 4"),
        ({"points": (900, 900), "time_step": 0.001}, "GiB are needed for the box .limit 4 GiB"),
        ({"coherent": "uv"}, "'uv' is not known .limit u, uvw"),
        ({"points": (3, 2.5)}, "points in z: 2.5 is not a permitted number"),
    ],
)
def test_wrong_turbulence(change: dict, message: str) -> None:
    with pytest.raises(ModelError, match=message):
        KaimalTurbulence(**{**TURBULENCE, **change})


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"velocity": CALM.astype(float)}, "float64 .2, 2, 2, 3. is not an array of velocities"),
        ({"velocity": CALM[..., :2]}, "is not an array of velocities"),
        ({"velocity": CALM + np.float32(np.inf)}, "has values that are not finite"),
        ({"spacing": (0.0, 1.0)}, "spacing in y: 0 m is out of range"),
        ({"mean_speed": 0.0}, "mean_speed: 0 m/s is out of range"),
    ],
)
def test_wrong_boxes(change: dict, message: str) -> None:
    with pytest.raises(ModelError, match=message):
        WindBox(**{"velocity": CALM, **BOX, **change})


def test_wrong_classes_and_gusts() -> None:
    for wrong, message in (
        (lambda: WindClass("IV", "A"), "turbine: 'IV' is not known .limit I, II, III"),
        (lambda: WindClass("I", "A").extreme_speed(10), "years: '10' is not known .limit 1, 50"),
        (lambda: RotorSite(WindClass("I", "A"), 90.0, 200.0), "diameter: 200 m is out of range"),
        (lambda: RotorSite(WindClass("I", "A"), 90.0, 126.0).operating_gust(51.0), "limit 0.1 to 50 m/s"),
        (
            lambda: RotorSite(WindClass("I", "A"), 90.0, 126.0).wind_shear(9.0, "up"),
            "'up' is not known .limit vertical, horizontal",
        ),
        (lambda: Gust(shape="x", start=0.0, duration=0.0, amplitude=1.0), "2 problems"),
    ):
        with pytest.raises(ModelError, match=message):
            wrong()
