# SPDX-License-Identifier: Apache-2.0
"""A plot as data of a page: long lines in 16 bits, finer than any screen and a quarter of the size."""

from __future__ import annotations

import base64
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import plotly.graph_objects as go

FLOATS = {"f4": "<f4", "f8": "<f8"}
LONG = 100
"""Points from which on a line is worth it."""
STEPS = 65535
"""Steps between the least and the largest number of a line."""


def figure_json(figure: go.Figure) -> str:
    """A plot as JSON; what is in steps says so in `meta.steps` of its line: value of 0, and of a step.

    Parameters
    ----------
    figure
        The plot; coordinates along logarithmic axes keep their digits.
    """
    from plotly.io.json import to_json_plotly

    found = figure.to_plotly_json()
    for trace in found["data"]:
        if trace.get("type") != "scatter":
            continue
        steps = {}
        for letter in "xy":
            axis = letter + "axis" + trace.get(f"{letter}axis", letter)[1:]
            packed = None if _logarithmic(found["layout"].get(axis)) else _in_steps(trace.get(letter))
            if packed is not None:
                trace[letter], steps[letter] = packed
        if steps:
            trace["meta"] = {**(trace.get("meta") or {}), "steps": steps}
    return str(to_json_plotly(found))


def _logarithmic(axis: Any) -> bool:
    return bool(axis) and axis.get("type") == "log"


def _in_steps(values: Any) -> tuple[dict[str, str], list[float]] | None:
    """Numbers as steps, the value of 0 and that of a step; None of what is short or has gaps."""
    # plotly has packed arrays of numbers already; lists are short, or hold gaps
    if not isinstance(values, dict) or values.get("dtype") not in FLOATS:
        return None
    exact = np.frombuffer(base64.b64decode(values["bdata"]), FLOATS[values["dtype"]]).astype(np.float64)
    if exact.size < LONG or not np.isfinite(exact).all():
        return None
    low, high = float(exact.min()), float(exact.max())
    step = (high - low) / STEPS or 1.0
    levels = np.rint((exact - low) / step).astype("<u2")
    return {"dtype": "u2", "bdata": base64.b64encode(levels.tobytes()).decode("ascii")}, [low, step]
