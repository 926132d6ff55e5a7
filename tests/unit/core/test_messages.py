# SPDX-License-Identifier: Apache-2.0
"""Messages are sentences that keep their parts; one rule finds the name that was meant."""

from __future__ import annotations

import copy
import json
import pickle
import warnings

import pytest

from pitchpoint.core.errors import (
    GeometryError,
    Message,
    ModelError,
    ValidityWarning,
    join_notes,
    note,
    remark,
    split_notes,
)
from pitchpoint.core.nearest import did_you_mean, hint, nearest

WHOLE = Message("gears.g1.face_width", "is out of range", "-1 mm", "> 0", "write 1 mm", line=4)


@pytest.mark.parametrize(
    ("message", "sentence"),
    [
        (WHOLE, "gears.g1.face_width (line 4): -1 mm is out of range (limit > 0); write 1 mm"),
        (Message("", "cannot be read"), "cannot be read"),
        (Message("a.b", "is empty"), "a.b: is empty"),
        (remark("a.b", "has no effect", "remove it", 7), "a.b (line 7): has no effect; remove it"),
        (note("the loads do not balance"), "the loads do not balance"),
        (note("takes no load", "rod"), "rod: takes no load"),
    ],
)
def test_the_sentence(message: Message, sentence: str) -> None:
    assert message == str(message) == f"{message}" == sentence
    assert "; ".join([message, message]) == f"{sentence}; {sentence}"
    assert json.loads(json.dumps([message])) == [sentence]


def test_joined_notes_are_divided_between_notes_only() -> None:
    notes = ["one; two", note("the loads do not balance", remedy="set one"), "", "one; two"]
    assert split_notes(join_notes(notes)) == ["one: two", "the loads do not balance: set one"]
    assert split_notes(join_notes(split_notes(join_notes(notes)))) == split_notes(join_notes(notes))


def test_the_parts_survive_copies_and_processes() -> None:
    for again in (copy.copy(WHOLE), copy.deepcopy(WHOLE), pickle.loads(pickle.dumps(WHOLE))):
        assert again == WHOLE
        assert again.parts == WHOLE.parts
    error = pickle.loads(pickle.dumps(ModelError([WHOLE]).problems))
    assert error[0].remedy == "write 1 mm"


def test_changed_makes_a_new_sentence() -> None:
    moved = WHOLE.changed(where="gears.g2.face_width", line=None)
    assert moved == "gears.g2.face_width: -1 mm is out of range (limit > 0); write 1 mm"
    assert (moved.kind, WHOLE.line) == ("problem", 4)


def test_kinds() -> None:
    assert [m.kind for m in (WHOLE, remark("a", "b"), note("c"))] == ["problem", "remark", "note"]
    assert GeometryError("is pointed", where="gears.a").problem.kind == "problem"


def test_warnings_carry_the_message() -> None:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        warnings.warn(remark("gears.a", "has no effect"), ValidityWarning, stacklevel=1)
    assert caught[0].message.args[0].where == "gears.a"


def test_nearest_names() -> None:
    names = ["tip_diameter", "normal_module", "steel"]
    assert nearest("Tip Diameter", names) == ["tip_diameter"]
    assert nearest("normal-modul", names) == ["normal_module"]
    assert nearest(3, names) == []
    assert did_you_mean("stel", names) == "did you mean steel? "
    assert did_you_mean("x", names) == ""
    assert hint("x", [f"n{k}" for k in range(20)]).endswith("n11, ...")
    assert hint("speedd", ["speed", "speeds"], 2) == ("did you mean speed or speeds? there are speed, speeds")
    assert hint("m9", ["m0", "m1", "m2"]) == "there are m0, m1, m2"
    assert hint("tacho", ["acc"]) == "there are acc"
