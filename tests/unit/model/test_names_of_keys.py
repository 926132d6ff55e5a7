# SPDX-License-Identifier: Apache-2.0
"""Suggestions for unknown keys: also those that have another name in other components."""

from __future__ import annotations

import pytest

import pitchpoint as pp
from pitchpoint.model.component import Component
from pitchpoint.model.components.contact import ContactFriction
from pitchpoint.model.components.joint import JointFriction
from pitchpoint.model.components.mesh import Friction
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
