# SPDX-License-Identifier: Apache-2.0
"""Velocities of the wind at points: profiles, transients of IEC 61400-1, boxes carried downwind."""

from __future__ import annotations

import math
import pickle
import tracemalloc
from dataclasses import replace

import numpy as np
import pytest
from scipy.interpolate import RegularGridInterpolator
from scipy.optimize import minimize_scalar

from pitchpoint.core.errors import ModelError, SolverError
from pitchpoint.core.status import NOT_FINITE, OK, TABLE_RANGE
from pitchpoint.model.wind.box import WindBox
from pitchpoint.model.wind.iec import Gust, RotorSite, WindClass
from pitchpoint.model.wind.steady import SteadyWind
from pitchpoint.system.wind import WindField, add_mean

STEADY = SteadyWind(speed=12.0, hub_height=90.0, exponent=0.2)
SITE = RotorSite(WindClass("I", "B"), hub_height=90.0, diameter=126.0)


def at(field: WindField, t: float = 0.0, *, x: float = 0.0, y: float = 0.0, z: float = 90.0) -> np.ndarray:
    return field.velocity([[x, y, z]], t)[0]


@pytest.mark.nojit
@pytest.mark.stock
@pytest.mark.parametrize("z", [1.0, 45.0, 90.0, 153.0])
def test_profiles_over_the_height(z: float) -> None:
    power = at(WindField(STEADY), z=z)
    logarithmic = replace(STEADY, profile="logarithmic", roughness_length=0.05)
    assert power == pytest.approx([12.0 * (z / 90.0) ** 0.2, 0.0, 0.0], rel=1e-14)
    expected = 12.0 * math.log(z / 0.05) / math.log(90.0 / 0.05)
    assert at(WindField(logarithmic), z=z)[0] == pytest.approx(expected, rel=1e-14)
    assert at(WindField(replace(STEADY, profile="uniform")), z=z)[0] == 12.0


def test_no_wind_at_and_below_the_ground() -> None:
    for profile in ("uniform", "power", "logarithmic"):
        for z in (0.0, -3.0):
            assert not at(WindField(replace(STEADY, profile=profile)), z=z).any()
            assert not at(WindField(STEADY, box=some_box()), z=z).any()
    assert at(WindField(replace(STEADY, profile="logarithmic")), z=0.02)[0] == 0.0


def test_directions_of_the_wind() -> None:
    """Inflow upward, direction counter-clockwise seen from above, veer with the height."""
    wind = replace(STEADY, inflow_angle=0.1, direction=0.3, veer=0.002)
    v = at(WindField(wind), z=140.0)
    speed = 12.0 * (140.0 / 90.0) ** 0.2
    assert np.linalg.norm(v) == pytest.approx(speed)
    assert v[2] == pytest.approx(speed * math.sin(0.1))
    assert math.atan2(v[1], v[0]) == pytest.approx(0.3 + 0.002 * 50.0)


# ------------------------------------------------------------------------------------------------ transients

# amplitudes from the formulas of IECWind 5.01.02 (NREL), evaluated for I, B, 11.4 m/s, hub 90 m, rotor 126 m
V_GUST, THETA_E, SHEAR, THETA_CG = 5.0286923, math.radians(30.4545417), 5.8371426, math.radians(63.1578947)


def test_operating_gust_at_its_peak_and_dips() -> None:
    field = WindField(replace(STEADY, speed=11.4), SITE.operating_gust(11.4, start=20.0))
    assert at(field, 20.0 + 5.25)[0] - 11.4 == pytest.approx(0.74 * V_GUST, rel=1e-7)
    dip = minimize_scalar(
        lambda t: at(field, t)[0], bounds=(20.0, 23.5), method="bounded", options={"xatol": 1e-9}
    )
    # the dip is where the derivative of sin(3 π s)(1 - cos(2 π s)) vanishes
    s = (dip.x - 20.0) / 10.5
    slope = 3 * math.cos(3 * math.pi * s) * (1 - math.cos(2 * math.pi * s))
    slope += 2 * math.sin(3 * math.pi * s) * math.sin(2 * math.pi * s)
    assert slope == pytest.approx(0.0, abs=1e-6)
    expected = 11.4 - 0.37 * V_GUST * math.sin(3 * math.pi * s) * (1 - math.cos(2 * math.pi * s))
    assert dip.fun == pytest.approx(expected, rel=1e-8)
    for t in (0.0, 20.0, 30.5, 100.0):
        assert at(field, t)[0] == pytest.approx(11.4, abs=1e-12)


def test_direction_change_and_coherent_gust() -> None:
    steady = replace(STEADY, speed=11.4, direction=0.2)
    for gust, angle, rise in (
        (SITE.direction_change(11.4, start=5.0), THETA_E, 0.0),
        (SITE.direction_change(11.4, start=5.0, sign=-1), -THETA_E, 0.0),
        (SITE.coherent_gust(11.4, start=5.0, sign=-1), -THETA_CG, 15.0),
    ):
        field = WindField(steady, gust)
        for part, share in (
            (0.0, 0.0),
            (0.25, 0.5 * (1 - math.sqrt(0.5))),
            (0.5, 0.5),
            (1.0, 1.0),
            (9.0, 1.0),
        ):
            v = at(field, 5.0 + part * gust.duration)
            assert np.linalg.norm(v) == pytest.approx(11.4 + share * rise, rel=1e-7)
            assert math.atan2(v[1], v[0]) == pytest.approx(0.2 + share * angle, rel=1e-7)


def test_extreme_shear_at_the_edges_of_the_rotor() -> None:
    steady = replace(STEADY, speed=11.4)
    middle, radius = 3.0 + 6.0, 63.0
    for sign in (1, -1):
        field = WindField(steady, SITE.wind_shear(11.4, "vertical", start=3.0, sign=sign))
        for z in (90.0 + radius, 90.0 - radius):
            change = at(field, middle, z=z)[0] - 11.4 * (z / 90.0) ** 0.2
            assert change == pytest.approx(sign * math.copysign(SHEAR, z - 90.0), rel=1e-7)
        field = WindField(steady, SITE.wind_shear(11.4, "horizontal", start=3.0, sign=sign))
        assert at(field, middle, y=radius)[0] - 11.4 == pytest.approx(sign * SHEAR, rel=1e-7)
        assert at(field, middle, y=-radius)[0] - 11.4 == pytest.approx(-sign * SHEAR, rel=1e-7)
        assert at(field, middle, y=radius)[0] != at(field, 3.0 + 3.0, y=radius)[0]
        assert at(field, 16.0, y=radius)[0] == pytest.approx(11.4, abs=1e-12)


# ----------------------------------------------------------------------------------------------------- boxes


def some_box(**more: object) -> WindBox:
    rng = np.random.default_rng(3)
    numbers = {
        "time_step": 0.5,
        "spacing": (4.0, 6.0),
        "bottom": 80.0,
        "hub_height": 90.0,
        "mean_speed": 10.0,
    }
    return WindBox(velocity=rng.standard_normal((12, 5, 4, 3)).astype(np.float32), **{**numbers, **more})


@pytest.mark.nojit
@pytest.mark.stock
def test_interpolation_against_that_of_scipy() -> None:
    box = some_box(periodic=False, with_mean=True)
    reference = RegularGridInterpolator((box.time, box.z, box.y), box.velocity.astype(float))
    rng = np.random.default_rng(4)
    points = np.column_stack([rng.uniform(-2, 2, 50), rng.uniform(-6, 6, 50), rng.uniform(80, 104, 50)])
    found = WindField(box=box).velocity(points, 2.3)
    times = 2.3 - points[:, 0] / 10.0
    np.testing.assert_allclose(
        found, reference(np.column_stack([times, points[:, 2], points[:, 1]])), atol=1e-6
    )


def test_the_box_moves_with_the_mean_wind_and_repeats() -> None:
    field = WindField(STEADY, box=some_box())
    here = at(field, 1.7, y=2.0)
    assert at(field, 1.7 + 3.0, x=30.0, y=2.0) == pytest.approx(here, abs=1e-12)
    for turns in (-3, 1, 1000):
        assert at(field, 1.7 + 6.0 * turns, y=2.0) == pytest.approx(here, abs=1e-9)
    first = some_box().velocity[0].astype(float)
    assert at(field, 0.0, y=-6.0, z=80.0)[1] == pytest.approx(first[0, 0, 1])
    # half-way between the last sample and the first of the next period
    last = 0.5 * (some_box().velocity[-1] + some_box().velocity[0])
    assert at(field, 5.75, y=6.0, z=104.0)[2] == pytest.approx(last[-1, -1, 2], rel=1e-6)


def test_the_box_has_the_direction_of_the_wind() -> None:
    straight, turned = (WindField(replace(STEADY, direction=d), box=some_box()) for d in (0.0, 0.4))
    c, s = math.cos(0.4), math.sin(0.4)
    v, w = at(straight, 1.0, x=3.0, y=2.0), at(turned, 1.0, x=3.0 * c - 2.0 * s, y=3.0 * s + 2.0 * c)
    assert w == pytest.approx([c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]], abs=1e-12)


def test_below_the_lowest_row_its_fluctuations_hold() -> None:
    field = WindField(STEADY, box=some_box())
    low = at(field, 1.0, z=30.0) - [12.0 * (30.0 / 90.0) ** 0.2, 0.0, 0.0]
    row = at(field, 1.0, z=80.0) - [12.0 * (80.0 / 90.0) ** 0.2, 0.0, 0.0]
    assert low == pytest.approx(row, abs=1e-12)


def test_points_outside_are_named() -> None:
    field = WindField(box=some_box(periodic=False, shift=5.0, with_mean=True))
    limit = r"limit y -6 to 6 m, z to 104 m, t - \(x - 5 m\)/\(10 m/s\) from 0 to 5.5 s"
    inside = [0.0, 6.0, 104.0]
    for point, t in (([0.0, 6.1, 90.0], 1.0), ([0.0, 0.0, 104.1], 1.0), ([0.0, 0.0, 90.0], 5.1)):
        with pytest.raises(SolverError, match=limit) as raised:
            field.velocity([inside, point], t)
        assert "x 0, y {1:g}, z {2:g} m".format(*point) in str(raised.value) or t == 5.1
        assert raised.value.status == TABLE_RANGE
    assert np.isfinite(field.velocity([inside], 5.0)).all()
    with pytest.raises(SolverError, match="not a number") as raised:
        WindField(STEADY, box=some_box()).velocity([inside], math.nan)
    assert raised.value.status == NOT_FINITE


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
@pytest.mark.parametrize("place", range(4))
def test_points_and_times_that_are_no_numbers(place: int, bad: float) -> None:
    """No index of a grid is computed from them."""
    values = [0.0, 1.0, 90.0, 2.0]
    values[place] = bad
    for field in (
        WindField(STEADY),
        WindField(STEADY, box=some_box()),
        WindField(box=some_box(periodic=False)),
    ):
        found = np.zeros((1, 3))
        assert field.fill(np.array([values[:3]]), values[3], found) == NOT_FINITE


@pytest.mark.nojit
def test_huge_places_and_times_are_outside_or_wrapped() -> None:
    for periodic in (True, False):
        field = WindField(STEADY, box=some_box(periodic=periodic))
        for size in (1e6, 1e11, 1e14, 1e300):
            for x, y, z, t in ((size, 0, 90, 0), (-size, 0, 90, 0), (0, 0, 90, size), (0, 0, 90, -size)):
                found = np.zeros((1, 3))
                status = field.fill(np.array([[x, y, z]], float), t, found)
                assert status == (OK if periodic and size < 1e12 else TABLE_RANGE)
                assert np.abs(found).max() < 20.0
            for y, z in ((size, 90.0), (-size, 90.0), (0.0, size)):
                assert field.fill(np.array([[0.0, y, z]]), 0.0, np.zeros((1, 3))) == TABLE_RANGE


def test_evaluation_allocates_no_arrays() -> None:
    field = WindField(STEADY, box=some_box())
    points, found = np.tile([0.0, 1.0, 90.0], (20_000, 1)), np.empty((20_000, 3))
    assert field.fill(points, 0.0, found) == OK
    tracemalloc.start()
    field.fill(points, 1.0, found)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 20_000
    assert (found == found[0]).all()


def test_arrays_that_the_kernel_cannot_read_are_refused() -> None:
    field, good = WindField(STEADY), np.zeros((4, 3))
    for points, found in (
        (good.astype(np.float32), good),
        (good[::2], good[:2].copy()),
        (np.zeros((4, 2)), np.zeros((4, 2))),
        (good, np.zeros((3, 3))),
    ):
        with pytest.raises(ModelError, match=r"limit two arrays of shape \(n, 3\)"):
            field.fill(points, 0.0, found)


def test_a_field_survives_pickling() -> None:
    field = WindField(STEADY, SITE.operating_gust(12.0, start=0.0), some_box())
    assert (at(pickle.loads(pickle.dumps(field)), 4.0, y=1.0) == at(field, 4.0, y=1.0)).all()


def test_boxes_with_the_mean_wind() -> None:
    box = some_box()
    whole = add_mean(box, STEADY)
    for z in (80.0, 92.0):  # on rows of the grid
        assert at(WindField(box=whole), 1.3, y=1.0, z=z) == pytest.approx(
            at(WindField(STEADY, box=box), 1.3, y=1.0, z=z), abs=2e-6
        )
    for wrong in (
        lambda: add_mean(whole, STEADY),
        lambda: add_mean(box, replace(STEADY, direction=0.1)),
        lambda: WindField(STEADY, box=whole),
        lambda: WindField(),
        lambda: WindField(None, Gust(shape="rise", start=0.0, duration=1.0, amplitude=1.0), box),
    ):
        with pytest.raises(ModelError, match="1 problem"):
            wrong()
