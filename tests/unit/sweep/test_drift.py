# SPDX-License-Identifier: Apache-2.0
"""Remark of a sweep on mean speeds: numbers without exponent."""

from __future__ import annotations

import pytest

from pitchpoint.sweep.drift import drift_notes


@pytest.mark.parametrize("share, words", [(-0.4, "-140 %"), (0.994, "-0.6 %"), (13.34, "+1200 %")])
def test_the_deviation_is_written_as_a_plain_number(share: float, words: str) -> None:
    point = {"speed": 100.0, "mesh_frequency": 400.0, "channels": {"speed[pin]": {"mean": 100.0 * share}}}
    (note,) = drift_notes([point], "pin", 48, lambda speed, span: 0.0, lambda speed: "")
    assert f"deviates by up to {words} from" in note
