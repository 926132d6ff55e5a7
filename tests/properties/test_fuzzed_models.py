# SPDX-License-Identifier: Apache-2.0
"""Shipped and documented models with wrong edits: refused or computed, in a short form of the long study."""

from __future__ import annotations

import copy
import random

import pytest

from tests.support.mutation import counted, edit, model_trees, outcome

ALLOWED = {"refused", "loaded", "computed"}


def test_every_shipped_and_documented_model_is_among_them():
    names = set(model_trees())
    assert {f"examples/{n}/model.yaml" for n in ("shovel-gearbox", "speed-control")} <= names
    assert len([n for n in names if n.startswith("docs/")]) >= 10


def test_faults_of_the_code_have_a_word(monkeypatch: pytest.MonkeyPatch):
    """What the study counts is seen: an exception of another kind has its place and is not a refusal."""
    data, folder = model_trees()["examples/speed-control/model.yaml"]
    data = copy.deepcopy(data)
    assert outcome(data, folder, compute=False) == "loaded"
    monkeypatch.setattr("pitchpoint.model.build.Model", None)
    assert outcome(data, folder, compute=False).startswith("raw TypeError at keys.py")


def test_edited_models():
    words, first = counted(seed=5, cases=400, every=20)
    assert not set(words) - ALLOWED, first
    assert words["refused"] > 100 and words["loaded"] > 20 and words["computed"] > 0


def test_edits_change_something():
    chance = random.Random(1)
    changed = 0
    for data, _ in model_trees().values():
        other = copy.deepcopy(data)
        for _ in range(3):
            edit(other, chance)
        changed += other != data
    assert changed > 30
