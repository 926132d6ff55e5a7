# SPDX-License-Identifier: Apache-2.0
"""Hashes that follow content and nothing else; attributes of a result."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass

import numpy as np
import pytest

from pitchpoint.core.progress import silent
from pitchpoint.core.provenance import content_hash, package_version, provenance


@dataclass(frozen=True)
class Sample:
    a: float
    b: tuple[int, ...] = ()


@pytest.mark.parametrize(
    "other",
    [Sample(1.0, (2,)), Sample(math.nan), Sample(-1.0), {"a": 1.0}, np.array([1.0]), [1.0], None, "x", {1}],
)
def test_different_content_has_a_different_hash(other):
    assert content_hash(other) != content_hash(Sample(1.0))
    assert content_hash(other) == content_hash(other)


def test_hash_is_the_same_in_every_process():
    assert content_hash({"z": 17, "m_n": 0.008}) == "66f4d12b8f2497f3"


def test_attributes_are_plain():
    attributes = provenance(model_hash="ab", solver="time", options={"step": 5e-6}, status=1, wall_s=0.5)
    assert attributes["status_text"] == "finished"
    assert json.loads(str(attributes["options"])) == {"step": 5e-6}
    assert attributes["pitchpoint_version"] == package_version()
    assert all(isinstance(v, str | int | float) for v in attributes.values())


def test_nobody_listens():
    assert silent(1.0, 2.0, "half") is None


def test_keys_that_came_later_leave_models_without_them_as_they_were():
    """The noise of a data set is drawn from the hash of its model: other bits would be another data set."""
    from pitchpoint.model.keys import key

    @dataclass
    class Part:
        a: float = 1.0

    with_key = dataclass(type("Part", (), {"__annotations__": {"a": float, "b": dict}, "a": 1.0,
                                           "b": key("gears", "x", {}, later=True)}))  # fmt: skip
    assert content_hash(with_key()) == content_hash(Part())
    assert content_hash(with_key(b={"c": 1.0})) != content_hash(Part())
