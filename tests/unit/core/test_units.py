# SPDX-License-Identifier: Apache-2.0
"""Quantities: every dimension's own example, rotation, refusals and the way back to text."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import UnitError
from pitchpoint.core.unit_expression import parse_unit
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
        ("0.5 sec", "time", 0.5),
        ("3 Seconds", "time", 3.0),
        ("100 kilohertz", "frequency", 1e5),
        ("150 Newton meter", "torque", 150.0),
        ("2 millimetres", "length", 0.002),
        ("1.5 krpm", "angular_speed", 50 * math.pi),
        ("25 rps", "angular_speed", 50 * math.pi),
        ("1 mil", "length", 25.4e-6),
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
        ("0.0115 kg m2", "inertia", 0.0115),
        ("0.0115 kg-m^2", "inertia", 0.0115),
        ("0.0115 kgm²", "inertia", 0.0115),
        ("120 gcm2", "inertia", 1.2e-5),
        ("7.85 kg m-3", "density", 7.85),
        ("150 N-m", "torque", 150.0),
        ("150 N×m", "torque", 150.0),
        ("8 kN-m/rad", "torsional_stiffness", 8000.0),
        ("3*mm", "length", 0.003),
        ("3 · mm", "length", 0.003),
        ("400 N/um", "stiffness", 4e8),
        ("400 N/\u00b5m", "stiffness", 4e8),
        ("400 N/\u03bcm", "stiffness", 4e8),
        ("8 kN/m", "stiffness", 8000.0),
        ("22.2 gon", "angle", 0.111 * math.pi),
        ("20 º", "angle", math.radians(20)),
        ("10 deg/s2", "angular_acceleration", math.radians(10)),
        ("5 s^(-1)", "rate", 5.0),
        ("5/s", "rate", 5.0),
        ("20 /m", "curvature", 20.0),
        ("3 in", "length", 0.0762),
        ("3 ft", "length", 0.9144),
        ("2 t", "mass", 2000.0),
        ("16 oz", "mass", 0.45359237),
        ("100 lbf", "force", 444.82216152605),
        ("5 kgf", "force", 49.03325),
        ("5 kp", "force", 49.03325),
        ("5 dyn", "force", 5e-5),
        ("16 ozf-in", "torque", 4.4482216152605 * 0.0254),
        ("100 lbf-ft", "torque", 444.82216152605 * 0.3048),
        ("1 hp", "power", 745.69987158227022),
        ("1 PS", "power", 735.49875),
        ("11 kW", "power", 11e3),
        ("14.5 psi", "pressure", 14.5 * 4.4482216152605 / 0.0254**2),
        ("2 bar", "pressure", 2e5),
        ("500 mbar", "pressure", 5e4),
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
        ("60/min", 2 * math.pi, 1.0),
        ("60 min-1", 2 * math.pi, 1.0),
        ("60 U/min", 2 * math.pi, 1.0),
        ("60 r/min", 2 * math.pi, 1.0),
        ("60 r·min⁻¹", 2 * math.pi, 1.0),
        ("60 revs/min", 2 * math.pi, 1.0),
        ("60 RPM", 2 * math.pi, 1.0),
        ("60 cpm", 2 * math.pi, 1.0),
    ],
)
def test_rotation_is_counted_once(text, speed, frequency):
    """One turn per second is 2 pi rad/s and 1 Hz, however it is written."""
    assert parse_quantity(text, "angular_speed") == pytest.approx(speed, rel=1e-15)
    assert parse_quantity(text, "frequency") == pytest.approx(frequency, rel=1e-15)


@pytest.mark.parametrize("text", ["25 1/s", "25/s", "25 s^-1", "25 s-1", "25 1/h"])
def test_a_bare_rate_is_no_rotational_speed(text):
    assert parse_quantity("25 1/s", "frequency") == 25.0
    with pytest.raises(UnitError, match="what is counted"):
        parse_quantity(text, "angular_speed")


@pytest.mark.parametrize(
    ("text", "dimension", "reason"),
    [
        ("20 Grad", "angle", "write deg for degrees, gon for"),
        ("20 grad", "angle", "write deg for degrees, gon for"),
        ("3 ton", "mass", "write t for 1000 kg"),
        ("1 r", "angle", r"a revolution in r/min only; write rev or rad"),
        ("1 N m/U", "torsional_stiffness", "a revolution in U/min only"),
        ("100 ft-lb", "torque", "'lb' is a mass; write lbf for the force"),
        ("10 oz in", "torque", "'oz' is a mass; write ozf for the force"),
        ("10 kg m", "torque", "'kg' is a mass; write N or kgf for the force"),
        ("14 N/mm-um", "stiffness_per_width", "everything below the line into brackets"),
        ("5 KN", "force", "did you mean kN"),
        ("3 N - m", "torque", "unexpected '-'"),
        ("3 N -m", "torque", "unexpected '-'"),
        ("3-mm", "length", "unexpected '-'"),
        ("3 m 2", "area", "unexpected '2'"),
        ("3 m -2", "area", "unexpected '-'"),
        ("3 m 1", "length", "unexpected '1'"),
        ("2 1 mm", "length", "unexpected '1'"),
        ("1 500 rpm", "angular_speed", "unexpected '5'"),
        ("3 m2^2", "area", "is not a unit"),
        ("3 m*/s", "speed", "is not a unit"),
        ("3 *", "length", "is not a unit"),
    ],
)
def test_what_could_mean_two_things_is_refused_with_the_reason(text, dimension, reason):
    with pytest.raises(UnitError, match=reason):
        parse_quantity(text, dimension)


def test_a_power_behind_one_word_belongs_to_its_last_symbol():
    assert parse_unit("Nm2") == parse_unit("N m^2") == parse_unit("Nm²")
    assert parse_unit("1/Nm2") == parse_unit("1/(N m^2)")
    assert parse_unit("kgmm2") == parse_unit("kg mm^2")


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
    with pytest.raises(UnitError, match="not a known dimension"):
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
    value = 300.2345 if name == "temperature" else 1.2345  # with a zero of its own
    text = format_quantity(value, name)
    assert parse_quantity(text, name) == pytest.approx(value, rel=1e-4)


def test_display_follows_the_size():
    assert format_quantity(0.15, "length") == "150 mm"
    assert format_quantity(-2e-6, "length") == "-2 µm"
    assert format_quantity(0.0, "length") == "0 mm"
    assert format_quantity(math.radians(20), "angle") == "20 deg"
    assert format_quantity(50 * math.pi, "angular_speed") == "1500 rpm"
    assert format_quantity(12e3, "force") == "12 kN"
    assert format_quantity(math.nan, "force") == "nan N"
    assert display_unit("inertia") == "kg m^2"
