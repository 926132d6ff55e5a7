# SPDX-License-Identifier: Apache-2.0
"""Suggestions for unknown keys: also those that have another name in other components."""

from __future__ import annotations

import pytest

import pitchpoint as pp
from pitchpoint.model.component import Component
from pitchpoint.model.components.contact import ContactFriction
from pitchpoint.model.components.gear_faults import Eccentricity, Wobble
from pitchpoint.model.components.joint import JointFriction
from pitchpoint.model.components.mesh import Friction
from pitchpoint.model.components.modifications import EndRelief, Runout
from pitchpoint.model.components.tooth_faults import PitchError
from pitchpoint.model.reading.reader import Reader


@pytest.mark.parametrize(
    ("cls", "written", "meant"),
    [
        (Friction, "coefficient", "mu"),
        (Friction, "coeficient", "mu"),
        (Friction, "mue", "mu"),
        (JointFriction, "mu", "coefficient"),
        (JointFriction, "coeficient", "coefficient"),
        (ContactFriction, "mu", "dynamic"),
        (ContactFriction, "coefficient", "dynamic"),
    ],
)
def test_names_of_the_coefficient_of_friction(cls: type[Component], written: str, meant: str) -> None:
    reader = Reader()
    reader.component(cls, {written: 0.1}, ("friction",))
    (problem,) = (p for p in reader.problems if "unknown key" in p)
    assert problem.startswith(f"friction.{written}: is an unknown key; did you mean {meant}? allowed are ")
    with pytest.raises(pp.ModelError, match=f"did you mean {meant}"):
        cls(**{written: 0.1})


@pytest.mark.parametrize(
    ("cls", "example"),
    [
        (Eccentricity, "0.02 mm"),
        (Wobble, "0.05 deg"),
        (PitchError, "10 um"),
        (EndRelief, "20 um"),
        (Runout, "20 um"),
    ],
)
def test_the_example_of_a_missing_deviation_has_its_usual_size(cls: type[Component], example: str) -> None:
    reader = Reader()
    reader.component(cls, {}, ("fault",))
    (problem,) = (p for p in reader.problems if p.startswith("fault.amount"))
    assert problem.endswith(f"add amount: {example}")
