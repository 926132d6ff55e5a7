# SPDX-License-Identifier: Apache-2.0
"""Remedies of messages on slips of the pen: what was meant is written out."""

from __future__ import annotations

import pytest

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.remarks.collect import remarks_of

TEXT = """
gears:
  p: {number_of_teeth: 24, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  w: {number_of_teeth: 48, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies: {a: {gears: [p]}, b: {gears: [w]}}
meshes: {m: {gears: [p, w]}}
loads: {l: {body: a, torque: 100 N m}, k: {body: b, torque: balance}}
scenarios:
  s: {speed: {a: 3000 rpm}, duration: 1 s, step: 1 us}
"""


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("gears: [p]}", "gears: p}", "bodies.a.gears (line 5): 'p' is not a list; write [p]"),
        (
            "normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}\nbodies",
            "normal_module: 2,5 mm, face_width: 20 mm, profile_shift_coefficient: 0}\nbodies",
            "gears.w.normal_module (line 4): has a decimal comma, in 2,5 mm; write 2.5 mm",
        ),
        (
            "balance",
            "ballance",
            "loads.k.torque (line 7): 'ballance' is neither balance nor a torque; write balance, or",
        ),
        ("a: 3000 rpm}", "a: 3000 rpm, b: 10 Hz}", "speed.b (line 9): 10 Hz does not match"),
        ("a: 3000 rpm}", "a: 3000 rpm, b: 10 Hz}", "(limit -25 Hz)"),
        ("a: 3000 rpm}", "b: 10 Hz, a: 3000 rpm}", "3000 rpm does not match"),
        ("a: 3000 rpm}", "b: 10 Hz, a: 3000 rpm}", "(limit -1200 rpm)"),
        ("a: 3000 rpm}", "b: 10 Hz, a: 100}", "100 rad/s does not match"),
        ("a: 3000 rpm}", "b: 10 Hz, a: 10*300 rpm}", "(limit -1200 rpm)"),
        ("a: 3000 rpm}", "a: 10 Hz}, drive: {a: {speed: 300 rpm}}", "10 Hz differs from"),
    ],
)
def test_what_was_meant(old: str, new: str, said: str) -> None:
    with pytest.raises(ModelError) as caught:
        loads_model(TEXT.replace(old, new, 1))
    assert any(said in problem for problem in caught.value.problems)


def test_a_formula_with_commas_is_still_rejoined() -> None:
    """Only a whole number before and a digit after the comma are a decimal comma."""
    text = TEXT.replace("torque: 100 N m", "torque: 100 N m * min(1, 0.5)")
    with pytest.raises(ModelError, match="is split at its commas"):
        loads_model(text)


def test_a_message_without_remedy_ends_without_semicolon() -> None:
    assert str(Message("a", "is wrong", remedy="")) == "a: is wrong"
    sweep = TEXT.replace("duration: 1 s", "sweep: {body: a, speed: [100 rpm, 200 rpm]}")
    text = sweep.replace("speed: {a: 3000 rpm}, ", "")
    [message] = [m for m in remarks_of(loads_model(text)) if "no effect" in m]
    assert str(message) == "scenarios.s (line 9): step has no effect with sweep" and message.remedy is None
