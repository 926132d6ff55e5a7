# SPDX-License-Identifier: Apache-2.0
"""Units inside formulas: what they give, what is refused and what is left alone."""

from __future__ import annotations

import math

import pytest

from pitchpoint.core.formula.dimension import of_number, of_variable, readable, unit_text
from pitchpoint.core.formula.formula import Amount, Formula, FormulaError, constant
from pitchpoint.core.unit_table import DIMENSIONS

NAMES = ("t", "angle", "speed")

ACCEPTED = {
    "torque": [
        "150 * (1 + 0.1*sin(2*pi*25*t))",
        "150 N m * (1 + 0.1*sin(2*pi*25 Hz*t))",
        "150 N m * (1 + 0.1*sin(157*t))",
        "500 N m + 5 N m * sin(68*angle)",
        "500 N * 50 mm * sin(angle)",
        "10 J * cos(angle)",
        "-0.5 N m s/rad * speed",
        "5 N m/rad * angle",
        "5 N m/s * t",
        "0.5 * 0.01 kg m^2 * speed^2",
        "100 W / max(speed, 10 rpm)",
        "sqrt((5 N m)^2 + (3 N m * sin(angle))^2)",
        "5 % * 150 N m * sin(t)",
        "5 kN m * ramp(t, 0, 8 s) + 1 N m * pulse(mod(t, 40 ms), 10 ms, 20 ms)",
        "5 N m * smoothstep(t, 0, 1)",
        "5 N m * step(t, 1 s) * atan2(t, 1 s) * floor(25 Hz*t)",
        "5 N m * 2^(t/1 s)",
        "5 N m * (t/1 s)^0.5",
        # a number without unit takes the unit of the other side of a sum
        "150 + 5 N m * sin(angle)",
        "0.1*t + 5 N m",
        "100 W / max(speed, 1)",
        "max(0, 5 N m * sin(angle))",
        # and supplies the seconds that a variable needs
        "150 N m * (1 + 0.01*t)",
        "150 N m * min(t, 1)",
        "150 N m * sqrt(0.01 - t)",
        "150 N m * (1 + 0.1*(t - 1 s))",
        "150 N m * (1 + 0.1*(1 s - t))",
        "0.01 N m s/rad * speed * (1 + 0.5*t)",
        # units that cancel leave a plain number, which may be anything again
        "150 * (1 - t/10 ms)",
        "150 * 25 Hz * t",
        "150*(t/10 ms) + 5 N m",
        # arguments without units are SI
        "150 N m * exp(-t)",
        "150 N m * sin(t)",
        # without units nothing is refused
        "sin(t) + t + angle",
        "t^angle",
    ],
    "force": ["5 kN * sin(angle)", "2 kg * 9.81 m/s^2 * cos(angle)", "2 N/m * 3 mm * sin(angle)"],
    "angular_speed": [
        "1500 rpm * min(t/1 s, 1)",
        "1500 rpm * min(t, 1)",
        "1500 rpm + 10*sin(t)",
        "10 rad/s^2 * t",
        "2*pi*25 Hz * (1 + 0.1*sin(5*t))",
        "6.2832 * 25 Hz * (1 + 0.1*sin(5*t))",
        "1 rev * 25 Hz * step(t)",
        "2*pi*25 Hz + 10 rad/s * sin(t)",
        "157 * min(t, 1)",
    ],
    "angle": ["1500 rpm * t", "2*pi*25 Hz*t", "10 deg * sin(t)", "360 deg * 25 Hz * t", "0.1*t^2", "t"],
}


@pytest.mark.parametrize(("dimension", "text"), [(d, x) for d, texts in ACCEPTED.items() for x in texts])
def test_what_may_be_right_is_accepted(dimension: str, text: str) -> None:
    Formula.parse(text, NAMES, dimension)


@pytest.mark.parametrize(
    ("dimension", "text", "message"),
    [
        (
            "torque",
            "150 kg * sin(2*pi*25 Hz*t)",
            r"give kg, not N m \(a torque such as 150 N m\) at character 1",
        ),
        ("torque", "150 kN * (1 + 0.1*sin(157*t))", "give N, not N m"),
        ("torque", "1.2*150 kg*cos(angle)", "give kg, not N m .* at character 5"),
        ("torque", "500 N * 0.05 * sin(angle)", "give N, not N m"),
        ("torque", "5 N m*t", "give N m s, not N m"),
        ("torque", "5 N m*speed", "give N m/s, not N m"),
        ("torque", "sqrt(5 N m)*cos(t)", r"give N\^0.5 m\^0.5, not N m"),
        ("torque", "5 kg/2 kg*cos(t)", "give a plain number or an angle, not N m"),
        ("torque", "5 N m + 3 kg*sin(t)", r"'\+' joins N m and kg at character 7"),
        ("torque", "5 N m - t", "'-' joins N m and s"),
        ("torque", "5 N m + sin(t)", "joins N m and a plain number"),
        ("torque", "5 N m*min(t, 1, 8 N)", "'min' joins s and N"),
        ("torque", "5 N m*mod(t, 8 N)", "'mod' joins s and N"),
        ("torque", "5 N m*ramp(t, 0, 8 N)", "'ramp' joins s and N"),
        ("torque", "5 N m*pulse(t, 1 s, 8 N)", "'pulse' joins s and N"),
        ("torque", "5 N m*step(t, 1 kg)", "'-' joins s and kg"),
        ("torque", "5 N m*atan2(t, 1 kg)", "'atan2' joins s and kg"),
        ("torque", "5 N m*sin(2*pi*25 N*t)", "'sin' needs a plain number or an angle, not N"),
        ("torque", "5 N m*sin(2*pi*25 s*t)", "'sin' needs a plain number or an angle, not s"),
        (
            "torque",
            "5 N m*sin(25 Hz*t)",
            r"argument of 'sin' is in cycles, not radians: Hz needs the factor 2\*pi",
        ),
        ("torque", "5 N m*exp(3 kg*t)", "'exp' needs"),
        ("torque", "5 N m*log(3 mm*t)", "'log' needs"),
        ("torque", "5 N m*asin(3 mm)*t", "'asin' needs"),
        ("torque", "5 N m*2^(t*1 s)", r"an exponent needs a plain number or an angle, not s\^2"),
        ("torque", "5 N m*(2 s)^t", "varying exponent needs"),
        ("force", "5 kN m*sin(angle)", "give N m, not N"),
        ("angular_speed", "1500 rpm*t", "give a plain number or an angle, not rad/s"),
        ("angular_speed", "3 m/s*min(t, 1)", "give m/s, not rad/s"),
        ("angular_speed", "25 Hz*(1 + 0.1*sin(5*t))", r"give cycles, not rad/s: Hz needs the factor 2\*pi"),
        ("angle", "3*25 Hz*t", "give cycles, not rad"),
        ("angle", "10 mm*sin(t)", "give m, not rad"),
        ("angle", "10 rad/s*sin(t)", "give 1/s, not rad"),
    ],
)
def test_what_is_certainly_wrong_is_refused(dimension: str, text: str, message: str) -> None:
    with pytest.raises(FormulaError, match=message) as refused:
        Formula.parse(text, NAMES, dimension)
    assert ("2*pi" if "cycles" in message else "none a unit") in refused.value.remedy


@pytest.mark.parametrize("text", ["5 N m + 3 kg*sin(t)", "sin(3 kg*t)"])
def test_contradictions_are_refused_whatever_is_wanted(text: str) -> None:
    with pytest.raises(FormulaError):
        Formula.parse(text)


def test_any_dimension_is_right_where_none_is_wanted() -> None:
    assert Formula.parse("5 N/m * t")(2.0) == 10.0


@pytest.mark.parametrize("dimension", DIMENSIONS)
def test_the_unit_of_a_dimension_gives_it(dimension: str) -> None:
    si = DIMENSIONS[dimension].si
    quantity = f"2/(1 {si[2:]})" if si.startswith("1/") else f"2 {si}"
    text = f"{quantity} * sin(t)"
    Formula.parse(text, NAMES, dimension)
    with pytest.raises(FormulaError, match="its units give"):
        Formula.parse(f"{text} * 3 kg K", NAMES, dimension)


def test_an_unknown_variable_may_be_anything() -> None:
    Formula.parse("5 N m * sin(x) + x", ("x",), "torque")


def test_units_in_messages_are_short() -> None:
    units = ["kN mm", "MPa", "g mm^2", "rpm", "kg/m^3", "K", "N s/m", "m/(N s)"]
    shown = [unit_text(of_number(1.0, unit)) for unit in units]
    assert shown == ["N m", "N/m^2", "kg m^2", "1/s", "kg/m^3", "K", "kg/s", "s/kg"]
    assert unit_text(of_variable("t")) == "s"


CONSTANTS = {
    "gap": Amount(4e-5, "m"),
    "z": Amount(20.0, ""),
    "n": Amount(50.0, "s^-1 rad"),
    "f": Amount(25.0, "Hz"),
}


@pytest.mark.parametrize(
    ("text", "dimension", "value"),
    [
        ("302.585 mm * cos(120 deg)", "length", -0.1512925),
        ("2*gap + 1 um", "length", 8.1e-5),
        ("z*1 mm", "length", 0.02),
        ("z/3 + 1", "dimensionless", 23.0 / 3.0),
        ("2*pi*5 Hz", "angular_speed", 31.41592653589793),
        ("2*pi*f", "angular_speed", 157.07963267948966),
        ("n/2", "angular_speed", 25.0),
        ("z*n/(1 rev)", "frequency", 159.15494309189535),
        ("z*f", "frequency", 500.0),
        ("tanh(gap/(40 um))", "dimensionless", 0.7615941559557649),
        ("sqrt(9 mm^2)", "length", 0.003),
    ],
)
def test_constants_keep_their_dimension(text: str, dimension: str, value: float) -> None:
    assert constant(text, dimension, CONSTANTS)[0].value == pytest.approx(value, rel=1e-14)


@pytest.mark.parametrize(
    ("text", "dimension", "message"),
    [
        ("2*z", "length", "its units give a plain number"),
        ("z + 1 mm", "length", "'\\+' joins a plain number or an angle and m"),
        ("gap*z", "angle", "its units give m, not rad"),
        ("2*n", "frequency", "its units give rad/s, not Hz"),
        ("3000 rpm / 2", "frequency", "its units give rad/s, not Hz"),
        ("2*f", "angular_speed", "its units give cycles"),
        ("sinh(gap)", "", "'sinh' needs a plain number or an angle, not m"),
        ("gpa", "length", "unknown name 'gpa'; did you mean gap\\?"),
    ],
)
def test_constants_of_another_dimension_are_refused(text: str, dimension: str, message: str) -> None:
    with pytest.raises(FormulaError, match=message):
        constant(text, dimension, CONSTANTS)


def test_the_unit_of_a_constant_reads_back() -> None:
    for text in ("3 N m/rad", "1500 rpm", "25 Hz", "2 kg m^2/s^3", "20 deg", "2*pi*25 Hz", "5 K", "7"):
        amount = constant(text)[0]
        again = constant(f"{amount.value!r} {amount.unit}")[0]
        assert again == amount
        assert readable(again.unit) == readable(amount.unit)


def test_an_angle_is_not_divided_by_an_angle():
    """180/60 deg is 180/(60 deg) = 171.9 1/rad: no angle, and hardly meant."""
    for dimension in ("", "angle"):
        with pytest.raises(FormulaError, match="a unit belongs to the number before it") as caught:
            constant("180/60 deg", dimension)
        assert caught.value.remedy.startswith("write 180/60 * 1 deg, or")
    assert constant("180/60 * 1 deg", "angle")[0].value == pytest.approx(math.radians(3.0), rel=1e-15)
    assert constant("180/(60 deg)")[0].unit == "rad^-1"
    with pytest.raises(FormulaError, match="its units give 1/rad, not rad"):
        constant("180/(60 deg)", "angle")
    assert constant("360 deg/3", "angle")[0].unit == constant("2*(3 deg)")[0].unit == "rad"
    assert constant("5 N m/2 deg")[0].unit == "kg m^2 s^-2 rad^-1"
