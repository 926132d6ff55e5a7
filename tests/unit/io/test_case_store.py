# SPDX-License-Identifier: Apache-2.0
"""Cases on disk: values, numbers and the sentence of each, while the table fills and after."""

from __future__ import annotations

from pathlib import Path

import pytest

from pitchpoint.io.case_store import LETTERS, CaseWriter, read_cases
from pitchpoint.io.container import Header, ResultError
from pitchpoint.io.reading import open_result
from pitchpoint.sweep.cases import CaseResult

CHANNELS = [("deflection[stage]", "m", "deflection")]


def test_every_case_keeps_its_sentence(tmp_path: Path) -> None:
    path = tmp_path / "cases.h5"
    words = "größer als ✓"
    # the last letter that has room ends in the middle of a character of three bytes
    long = "x" * (LETTERS - 1) + "✓"
    with CaseWriter(path, Header("cases"), {"a.b": ["1", "2", "3", "4"]}, CHANNELS) as table:
        table.put(CaseResult(1, {"a.b": 2}, 4, words))
        assert [(c["case"], c["sentence"]) for c in read_cases(path)] == [(1, words)]
        table.put(CaseResult(0, {"a.b": 1}, 1, "finished"))
        table.put(CaseResult(3, {"a.b": 4}, 2, long))
    assert [c["sentence"] for c in read_cases(path)] == ["finished", words, long[:-1]]
    with open_result(path) as data:
        assert data["case_sentence"].dims == ("case",)
        assert data["case_sentence"].values.tolist() == ["finished", words, "", long[:-1]]
        assert "letter" not in data.variables


def test_a_damaged_sentence_is_an_error_with_the_name_of_the_file(tmp_path: Path) -> None:
    path = tmp_path / "cases.h5"
    with CaseWriter(path, Header("cases"), {"a.b": ["1"]}, CHANNELS) as table:
        table.put(CaseResult(0, {"a.b": 1}, 1, "as it was"))
    data = path.read_bytes()
    assert data.count(b"as it was") == 1
    path.write_bytes(data.replace(b"as it was", b"as it \x80as"))
    with open_result(path) as opened, pytest.raises(ResultError, match=r"cases\.h5.*damaged"):
        opened["case_sentence"].load()
