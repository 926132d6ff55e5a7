# SPDX-License-Identifier: Apache-2.0
"""What is said when nothing is found although a test exceeds its limit."""

from __future__ import annotations

import pytest

from pitchpoint.analysis.diagnosis import Diagnosis
from pitchpoint.analysis.findings import Evidence
from pitchpoint.report.diagnosis_words import nothing_found, outcome


def _evidence(*, found: bool, explained: str = "") -> Evidence:
    return Evidence("acc", "comb", "shaft 1", "", 9.0, 3.0, 1e-9, 4.0, 0.1, 0, found, 0.01, explained)


@pytest.mark.parametrize(
    ("beyond", "words"),
    [
        (0, "none of 5 tests exceeds its limit (a healthy record does so with 1 %)"),
        (1, "of 5 tests 1 exceeds its limit, but not as damage does: what stands out is told below"),
        (3, "of 5 tests 3 exceed their limits, but not as damage does: what stands out is told below"),
    ],
)
def test_limits_that_are_exceeded_are_not_denied(beyond: int, words: str) -> None:
    evidence = tuple(_evidence(found=k < beyond) for k in range(5))
    assert nothing_found(Diagnosis((), evidence, {}, (), (), {}, 5, 0.01)) == f"nothing found: {words}"


def test_a_test_is_found_explained_or_neither() -> None:
    rows = [_evidence(found=True), _evidence(found=False, explained="cage"), _evidence(found=False)]
    assert [outcome(row) for row in rows] == ["found", "explained", ""]
