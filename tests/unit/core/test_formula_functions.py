# SPDX-License-Identifier: Apache-2.0
"""The page on formulas lists every function with its arguments, in the order of the evaluation."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from pitchpoint.core.formula.formula import FUNCTIONS, Formula

PAGE = Path(__file__).parents[3] / "docs/howto/parameters.md"


def test_every_function_is_listed_with_its_arguments() -> None:
    rows = [line.split("|")[1] for line in PAGE.read_text().splitlines() if line.startswith("| `")]
    calls = [call for row in rows for call in re.findall(r"`(\w+)\(([^)]*)\)`", row)]
    listed = {name: arguments.count(",") + 1 for name, arguments in calls}
    assert listed == {name: arguments for name, (_, arguments) in FUNCTIONS.items()}


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("atan2(1, 0)", 1.5707963267948966),
        ("mod(-1, 3)", 2.0),
        ("step(0)", 1.0),
        ("ramp(2, 1, 5)", 0.25),
        ("smoothstep(2, 1, 5)", 0.15625),
        ("pulse(1, 1, 2) + pulse(2, 1, 2)", 1.0),
    ],
)
def test_arguments_have_the_order_of_the_page(text: str, value: float) -> None:
    assert Formula.parse(text)(0.0) == pytest.approx(value)
