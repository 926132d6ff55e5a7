# SPDX-License-Identifier: Apache-2.0
"""Quantities: every dimension's own example, rotation, refusals and the way back to text."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import UnitError
from pitchpoint.core.units import (
    DIMENSIONS,
    display_unit,
    format_quantity,
    in_unit,
    natural_si,
    parse_quantity,
)


@pytest.mark.parametrize(
    ("text", "dimension", "expected"),
    [
        ("3 mm", "length", 0.003),
        ("159.66mm", "length", 0.15966),
        ("5 µm", "length", 5e-6),
        ("5 μm", "length", 5e-6),
        ("0.0115 kg m^2", "inertia", 0.0115),
        ("0.0115 kg·m²", "inertia", 0.0115),
        ("0.0115 kg*m**2", "inertia", 0.0115),
        ("150 N m", "torque", 150.0),
        ("0.1 kN·m", "torque", 100.0),
        ("4.0e8 N/m", "stiffness", 4.0e8),
        ("14 N/(mm um)", "stiffness_per_width", 14e9),
        ("14 N/mm/µm", "stiffness_per_width", 14e9),
        ("210 GPa", "pressure", 210e9),
        ("0.1 N m s/rad", "torsional_damping", 0.1),
        ("1e5 N m/rad", "torsional_stiffness", 1e5),
        ("1 N m/deg", "torsional_stiffness", 180 / math.pi),
        ("7850 kg/m^3", "density", 7850.0),
        ("7.85 kg m⁻³", "density", 7.85),
        ("2 h", "time", 7200.0),
        ("5 %", "dimensionless", 0.05),
        ("20 deg", "angle", math.radians(20)),
        ("0.5 rev", "angle", math.pi),
        ("−3 mm", "length", -0.003),
        ("2 yards", "length", 1.8288),
        ("0.5 1/s", "rate", 0.5),
        ("150 Nm", "torque", 150.0),
        ("1.5 kNm", "torque", 1500.0),
        ("3 Nmm", "torque", 0.003),
        ("3 mNm", "torque", 0.003),
        ("2 MNm", "torque", 2e6),
        ("150 N.m", "torque", 150.0),
        ("1.5 kN.mm", "torque", 1.5),
        ("0.5 kg.m^2", "inertia", 0.5),
        ("5. N.m.s/rad", "torsional_damping", 5.0),
        ("2000 Ns/m", "damping", 2000.0),
        ("2 kNs/m", "damping", 2000.0),
        ("0.1 Nms/rad", "torsional_damping", 0.1),
        ("0.1 kNmms/rad", "torsional_damping", 0.1),
        ("8 kNm/rad", "torsional_stiffness", 8000.0),
        ("3 ms", "time", 0.003),
        ("3 mN", "force", 0.003),
        ("3", "length", 3.0),
        (3, "length", 3.0),
        (np.float64(0.25), "length", 0.25),
        (np.int64(2), "length", 2.0),
    ],
)
def test_common_quantities(text, dimension, expected):
    assert parse_quantity(text, dimension) == pytest.approx(expected, rel=1e-15, abs=0.0)


@pytest.mark.parametrize(
    ("text", "speed", "frequency"),
    [
        ("60 rpm", 2 * math.pi, 1.0),
        ("1 Hz", 2 * math.pi, 1.0),
        ("1 rev/s", 2 * math.pi, 1.0),
        ("6.283185307179586 rad/s", 2 * math.pi, 1.0),
        ("360 deg/s", 2 * math.pi, 1.0),
        ("60 1/min", 2 * math.pi, 1.0),
        ("60 min^-1", 2 * math.pi, 1.0),
    ],
)
def test_rotation_is_counted_once(text, speed, frequency):
    """One turn per second is 2 pi rad/s and 1 Hz, however it is written."""
    assert parse_quantity(text, "angular_speed") == pytest.approx(speed, rel=1e-15)
    assert parse_quantity(text, "frequency") == pytest.approx(frequency, rel=1e-15)


def test_a_bare_rate_is_no_rotational_speed():
    assert parse_quantity("25 1/s", "frequency") == 25.0
    with pytest.raises(UnitError, match="what is counted"):
        parse_quantity("25 1/s", "angular_speed")


@pytest.mark.parametrize(
    "bad",
    [
        True,
        np.True_,
        None,
        [1.0],
        math.nan,
        math.inf,
        "nan",
        "inf m",
        "",
        "mm",
        "4 kg",
        "3 mm mm",
        "1,5 mm",
        "1e999 m",
        "3 m^",
        "3 (m",
        "3 m)",
        "3 /m",
        "3 m^99",
        "3 ((deg^12)^12)^-12",
        "3 ((1/deg)^12)^12",
        "3 ((Gm^12)^12)",
        "20 C",
        "3 parsnips",
        "3 " + "m*" * 100,
        "3 mm; import os",
        "3 m\x00",
        "3 N/mm um",
        "3 volt",
    ],
)
def test_refusals_say_what_was_expected(bad):
    with pytest.raises(UnitError, match="expected a length such as 3 mm"):
        parse_quantity(bad, "length")


@pytest.mark.parametrize("text", ["3 nm", "3 NM", "3 nN m/s", "3 Nms", "3 kNmss", "3 N.", "3 .N m", "3 N..m"])
def test_joined_units_are_read_by_their_case_and_nothing_is_guessed(text):
    with pytest.raises(UnitError, match="expected a torque"):
        parse_quantity(text, "torque")


def test_signs():
    with pytest.raises(UnitError, match="greater than zero"):
        parse_quantity("0 mm", "length", positive=True)
    with pytest.raises(UnitError, match="not be negative"):
        parse_quantity(-1, "length", nonnegative=True)
    assert parse_quantity("0 mm", "length", nonnegative=True) == 0.0


def test_unknown_dimension():
    with pytest.raises(UnitError, match="no known dimension"):
        parse_quantity(1, "lenght")


def test_quantity_objects_of_pint_are_accepted():
    import pint

    registry = pint.UnitRegistry(cache_folder=None)
    assert parse_quantity(registry.Quantity(5.0, "inch"), "length") == pytest.approx(0.127, rel=1e-15)
    assert parse_quantity(registry.Quantity(2.0, "kilogram*meter**2"), "inertia") == 2.0


def test_literals_of_formulas():
    assert natural_si("Hz") == 1.0
    assert natural_si("rpm") == pytest.approx(2 * math.pi / 60)
    assert natural_si("N m") == natural_si("Nm") == natural_si("N.m") == 1.0


@pytest.mark.parametrize("name", sorted(DIMENSIONS))
def test_every_dimension_reads_its_example_and_its_display_units(name):
    row = DIMENSIONS[name]
    example = row.example.split(" or ")[0]
    assert parse_quantity(example, name) > 0.0
    if row.si:
        assert parse_quantity(f"1 {row.si}", name) == 1.0
    levels = [level for level, _ in row.display]
    assert levels == sorted(levels)
    for _, unit in row.display:
        assert in_unit(parse_quantity(f"7 {unit}", name), name, unit) == pytest.approx(7.0, rel=1e-14)
    text = format_quantity(1.2345, name)
    assert parse_quantity(text, name) == pytest.approx(1.2345, rel=1e-4)


def test_display_follows_the_size():
    assert format_quantity(0.15, "length") == "150 mm"
    assert format_quantity(-2e-6, "length") == "-2 µm"
    assert format_quantity(0.0, "length") == "0 mm"
    assert format_quantity(math.radians(20), "angle") == "20 deg"
    assert format_quantity(50 * math.pi, "angular_speed") == "1500 rpm"
    assert format_quantity(12e3, "force") == "12 kN"
    assert format_quantity(math.nan, "force") == "nan N"
    assert display_unit("inertia") == "kg m^2"
