# SPDX-License-Identifier: Apache-2.0
"""Polars, their extrapolation, blades and rotors: values in closed form, and what is refused."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from pitchpoint.core.errors import GeometryError, ModelError
from pitchpoint.geometry.rotor.blade import Blade, Rotor
from pitchpoint.geometry.rotor.polar import Polar
from pitchpoint.geometry.rotor.polar_range import extrapolate_polar
from tests.support.rotors import aerodyn


def test_lines_are_exact_and_steps_do_not_overshoot() -> None:
    alpha = np.array([-0.3, -0.1, 0.0, 0.15, 0.3])
    line = Polar(alpha=alpha, lift=2.0 * alpha + 0.1, drag=np.full(5, 0.01))
    step = Polar(alpha=alpha, lift=[0, 0, 0, 1, 1], drag=np.zeros(5))
    for a in np.linspace(-0.3, 0.3, 101):
        assert line.at(a) == pytest.approx([2 * a + 0.1, 0.01, 0.0], abs=1e-14)
        assert 0.0 <= step.at(a)[0] <= 1.0


def test_complete_polar_is_periodic() -> None:
    for polar in aerodyn().blade.polars:
        knots = polar.knots
        assert polar.complete
        assert knots[0, 1:] == pytest.approx(knots[-1, 1:])


def short(within: float = 15.0) -> Polar:
    """Part of a complete polar around 0."""
    polar = aerodyn().blade.polars[-1]
    kept = np.abs(polar.alpha) <= np.radians(within + 1e-6)
    return Polar(
        alpha=polar.alpha[kept], lift=polar.lift[kept], drag=polar.drag[kept], moment=polar.moment[kept]
    )


def test_extrapolation_by_viterna() -> None:
    """Table kept; drag C = 1.11 + 0.018 AR and no lift at 90°; values of the formula at 40° by hand."""
    table = short()
    full = extrapolate_polar(table, aspect_ratio=17.0)
    assert full.complete and len(full.alpha) > 60
    for k, alpha in enumerate(table.alpha):
        assert full.at(alpha)[:2] == pytest.approx([table.lift[k], table.drag[k]])
    most = 1.11 + 0.018 * 17.0
    assert full.at(np.pi / 2)[:2] == pytest.approx([0.0, most], abs=1e-12)
    s, c, lift, drag = np.sin(table.alpha[-1]), np.cos(table.alpha[-1]), table.lift[-1], table.drag[-1]
    a2, b2 = (lift - most * s * c) * s / c**2, (drag - most * s**2) / c
    x = np.radians(40.0)
    expected = (
        most / 2 * np.sin(2 * x) + a2 * np.cos(x) ** 2 / np.sin(x),
        most * np.sin(x) ** 2 + b2 * np.cos(x),
    )
    assert full.at(x)[:2] == pytest.approx(expected, rel=1e-12)
    assert full.at(-x)[0] == pytest.approx(-0.7 * expected[0]) and full.at(-x)[1] == pytest.approx(
        expected[1]
    )
    assert full.at(np.pi - x)[0] == pytest.approx(-0.7 * expected[0])
    assert full.lift[0] == pytest.approx(0.0, abs=1e-12) and full.drag.min() >= 0.0
    assert extrapolate_polar(full) is full


def test_extrapolated_polar_is_near_the_measured_one() -> None:
    """NACA 64-618 in stall, 20° to 90°: within 0.25 of the table, which is also partly Viterna's."""
    full, measured = extrapolate_polar(short(), 17.0), aerodyn().blade.polars[-1]
    for degrees in range(20, 95, 5):
        x = np.radians(degrees)
        assert full.at(x)[:2] == pytest.approx(measured.at(x)[:2], abs=0.25)


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        ({"alpha": [0.0, 0.1]}, "2 points are too few"),
        ({"alpha": [0.0, 0.1, 0.1]}, "at point 3 does not increase"),
        ({"alpha": [0.0, 0.1, np.nan]}, "not finite"),
        ({"alpha": [-180.0, 0.0, 180.0]}, "give angles in radians"),
        ({"alpha": [0.0, 0.1, 0.2], "lift": [0.0, 1.0]}, "shapes of its columns"),
    ],
)
def test_bad_polars(arguments: dict, expected: str) -> None:
    n = len(arguments["alpha"])
    with pytest.raises(GeometryError) as error:
        Polar(**{"lift": np.zeros(n), "drag": np.zeros(n), **arguments})
    assert expected in str(error.value)


def test_tables_that_cannot_be_extrapolated() -> None:
    with pytest.raises(GeometryError, match="is the range of angles of attack"):
        extrapolate_polar(Polar(alpha=[0.1, 0.2, 0.3], lift=np.zeros(3), drag=np.zeros(3)))


def blade(**changes: object) -> Blade:
    """Blade of three stations with changes."""
    values = {
        "span": [0.0, 10.0, 20.0],
        "chord": [2.0, 1.5, 1.0],
        "twist": [0.1, 0.05, 0.0],
        "polars": aerodyn().blade.polars[:1],
        "polar_index": [0, 0, 0],
    }
    return Blade(**{**values, **changes})  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        ({"span": [0.0, 10.0, 10.0]}, "blade.span, station 3: 10 m does not increase (limit > 10 m)"),
        ({"chord": [2.0, 0.0, 1.0]}, "blade.chord, station 2: 0 m is out of range (limit > 0)"),
        ({"twist": [0.1, np.inf, 0.0]}, "blade.twist, station 2: is not finite"),
        ({"polar_index": [0, 1, 0]}, "station 2: 2 is not the number of a polar (limit 1 to 1)"),
        ({"chord": [1.0, 2.0]}, "blade.chord: (2,) is the shape"),
        ({"span": [1.0]}, "stations are too few"),
        ({"polars": [short()]}, "use extrapolate_polar(polar)"),
        ({"polars": []}, "none is given"),
    ],
)
def test_bad_blades(changes: dict, expected: str) -> None:
    with pytest.raises(ModelError) as error:
        blade(**changes)
    assert expected in str(error.value)


def test_all_problems_of_a_rotor() -> None:
    with pytest.raises(ModelError, match="4 problems"):
        Rotor(blade=blade(), blades=0, hub_radius=-1.0, precone=2.5, tilt=5.0)


def test_position_of_stations() -> None:
    """Precone inclines upwind; prebend is along x of the inclined blade; sections are normal to the blade."""
    found = Rotor(blade=blade(prebend=[0.0, -0.5, -2.0]), hub_radius=1.0, precone=0.05)
    c, s = np.cos(0.05), np.sin(0.05)
    assert found.radius == pytest.approx([c, 11 * c - 0.5 * s, 21 * c - 2 * s])
    assert found.axial == pytest.approx([-s, -0.5 * c - 11 * s, -2 * c - 21 * s])
    assert found.inclination == pytest.approx(0.05 - np.arctan([-0.05, -0.1, -0.15]))
    straight = replace(found, blade=blade(curve_angle=np.zeros(3)))
    assert straight.inclination == pytest.approx(np.full(3, 0.05))
    assert straight.area == pytest.approx(np.pi * (21 * c) ** 2)
