# SPDX-License-Identifier: Apache-2.0
"""Quantities: any text is a finite number or a UnitError; what is written can be read back."""

from __future__ import annotations

import math

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from pitchpoint.core.errors import UnitError
from pitchpoint.core.unit_table import UNITS
from pitchpoint.core.units import DIMENSIONS, format_quantity, in_unit, parse_quantity

dimensions = st.sampled_from(sorted(DIMENSIONS))
pieces = st.sampled_from([*UNITS, *" */^()-²³·12", "**", "1e", ".5", "nan", "inf"])
texts = st.one_of(st.text(max_size=40), st.lists(pieces, max_size=12).map("".join))


@given(texts, dimensions)
@example("1e308 Gm", "length")
@example("3 ((deg^12)^12)^-12", "angle")
@example("1 K^-12*K^12", "dimensionless")
def test_any_text_is_a_quantity_or_a_clean_error(text, dimension):
    for candidate in (text, f"2.5 {text}"):
        try:
            value = parse_quantity(candidate, dimension)
        except UnitError as error:
            assert "expected" in str(error)
        else:
            assert math.isfinite(value)


@given(
    st.one_of(st.none(), st.booleans(), st.binary(), st.lists(st.integers()), st.complex_numbers()),
    dimensions,
)
def test_other_types_are_refused(value, dimension):
    with pytest.raises(UnitError):
        parse_quantity(value, dimension)


@given(st.floats(1e-12, 1e12), dimensions)
def test_what_is_written_can_be_read_back(value, dimension):
    """Temperatures are written in degrees Celsius, with 12 digits of 273.15 K at least."""
    zero = 1e-9 if dimension == "temperature" else 0.0
    read = parse_quantity(format_quantity(value, dimension, 12), dimension)
    assert read == pytest.approx(value, rel=1e-11, abs=zero)


@given(st.floats(-1e6, 1e6), dimensions)
def test_every_display_unit_goes_both_ways(value, dimension):
    """Temperatures in degrees Celsius are exact to the last digit of 273.15 K."""
    zero = 1e-13 if dimension == "temperature" else 1e-300
    for _, unit in DIMENSIONS[dimension].display:
        there = in_unit(value, dimension, unit)
        assert parse_quantity(f"{there!r} {unit}", dimension) == pytest.approx(value, rel=1e-13, abs=zero)


@given(st.decimals(min_value="0.001", max_value="1000", places=3))
def test_millimetres_give_the_nearest_double(value):
    assert parse_quantity(f"{value} mm", "length") == float(value / 1000)
