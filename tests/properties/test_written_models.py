# SPDX-License-Identifier: Apache-2.0
"""Every model is written so that it reads back to the same model, whatever its numbers, names and texts."""

from __future__ import annotations

import math
from typing import Any

from hypothesis import given, settings
from hypothesis import strategies as st

import pitchpoint as pp
from pitchpoint.core.provenance import content_hash
from pitchpoint.io.yaml_model import loads_model


def numbers(low: float, high: float) -> st.SearchStrategy[float]:
    """Floats whose digits are used up to the last one; numbers below 1e-60 are refused by models."""
    if low >= 0.0:
        return st.floats(max(low, 1e-12), high)
    return st.one_of(st.just(0.0), st.floats(low, -1e-12), st.floats(min(1e-12, high), high))


LETTERS = st.characters(codec="utf-8", exclude_categories=("C", "Z"), include_characters=" ")
TEXTS = st.text(LETTERS, max_size=200)
NAMES = st.from_regex(r"[A-Za-zäöü_][A-Za-z0-9_ -]{0,20}[A-Za-z0-9]", fullmatch=True)
GEARS = st.builds(
    pp.Gear,
    number_of_teeth=st.integers(25, 200),
    normal_module=numbers(1e-4, 0.1),
    normal_pressure_angle=numbers(math.radians(18.0), math.radians(22.0)),
    profile_shift_coefficient=numbers(0.0, 0.2),
    face_width=numbers(1e-3, 1.0),
    tip_alteration=numbers(-1e-6, 1e-6),
)
BODIES = st.builds(
    pp.Body,
    inertia=numbers(1e-9, 1e6),
    position=st.tuples(numbers(-10.0, 10.0), numbers(-10.0, 10.0), numbers(-10.0, 10.0)),
    motion=st.just("torsion"),
)
TORQUES = st.one_of(numbers(-1e6, 1e6), st.just("balance"), st.just("3 N m * sin(2 * pi * 5 Hz * t)"))


@st.composite
def models(draw: Any) -> pp.Model:
    """Models of gears and bodies, with loads and a scenario."""
    bodies = draw(st.dictionaries(NAMES, BODIES, min_size=1, max_size=3))
    first = next(iter(bodies))
    return pp.Model(
        title=draw(TEXTS),
        gears=draw(st.dictionaries(NAMES, GEARS, max_size=3)),
        bodies=bodies,
        loads={"load": {"body": first, "torque": draw(TORQUES)}},
        scenarios={"run": {"speed": {first: draw(numbers(-1e4, 1e4))}, "duration": draw(numbers(1e-6, 1e3))}},
    )


@settings(max_examples=15, deadline=None)
@given(models())
def test_a_written_model_reads_back(model: pp.Model) -> None:
    text = model.to_yaml()
    again = loads_model(text)
    assert again == model and content_hash(again) == content_hash(model)
    assert again.to_yaml() == text


@settings(max_examples=30, deadline=None)
@given(st.one_of(GEARS, BODIES))
def test_the_representation_of_a_component_makes_it_again(part: object) -> None:
    assert eval(repr(part), {"Gear": pp.Gear, "Body": pp.Body}) == part
