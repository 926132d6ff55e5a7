# SPDX-License-Identifier: Apache-2.0
"""Plots as page data: long curves with 16 bits per number, finer than screens, at a quarter of the size."""

from __future__ import annotations

import base64
import zlib
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import plotly.graph_objects as go

Array = NDArray[np.float64]
Packed = tuple[dict[str, Any] | None, list[float]]

FLOATS = {"f4": "<f4", "f8": "<f8"}
LONG = 100
"""Minimum number of points of a packed curve."""
STEPS = 65535
"""Steps between the minimum and maximum of a curve."""


def figure_json(figure: go.Figure) -> str:
    """Plot as JSON; `meta.steps` of a curve lists its packed coordinates and their scaling.

    [value of 0, value of a step] is used with two bytes per number, or with one byte for the difference from
    the previous number. [first value, step, count] represents equally spaced numbers, without further data.
    `meta.means`, the mean for every four numbers of a long record, is packed like a coordinate.

    Parameters
    ----------
    figure
        The plot; coordinates along logarithmic axes are not packed.
    """
    from plotly.io.json import to_json_plotly

    found = figure.to_plotly_json()
    for trace in found["data"]:
        if trace.get("type") != "scatter":
            continue
        steps = {}
        for letter in "xy":
            axis = letter + "axis" + trace.get(f"{letter}axis", letter)[1:]
            values = None if _logarithmic(found["layout"].get(axis)) else _numbers(trace.get(letter))
            if values is not None:
                trace[letter], steps[letter] = _on_grid(values) or _in_steps(values)
        meta = dict(trace.get("meta") or {})
        means = _numbers(meta.pop("means", None))
        if means is not None and "y" in steps:
            meta["means"], steps["means"] = _in_steps(means)
        if steps:
            trace["meta"] = {**meta, "steps": steps}
    return str(to_json_plotly(found))


def _logarithmic(axis: Any) -> bool:
    return bool(axis) and axis.get("type") == "log"


def _numbers(values: Any) -> Array | None:
    """Numbers of a coordinate; None if it is short or has gaps."""
    # plotly has already packed arrays of numbers; lists are short or have gaps
    if not isinstance(values, dict) or values.get("dtype") not in FLOATS:
        return None
    found = np.frombuffer(base64.b64decode(values["bdata"]), FLOATS[values["dtype"]]).astype(np.float64)
    return found if found.size >= LONG and np.isfinite(found).all() else None


def _on_grid(values: Array) -> Packed | None:
    """First number, step and count of equally spaced, ascending numbers, such as sample times.

    Repeated numbers have the distance zero.
    """
    gaps = np.diff(values)
    least = float(np.min(gaps, where=gaps > 0.0, initial=np.inf))
    if gaps.min() < 0.0 or not np.isfinite(least) or gaps.max() > 250.5 * least:
        return None
    # single precision rounds the spacings: single ones differ, their sum gives the step
    counts = np.rint(gaps / least)
    places = np.append(0.0, np.cumsum(counts))
    first, step = float(values[0]), float(values[-1] - values[0]) / float(places[-1])
    if np.abs(first + step * places - values).max() > 0.5 * float(np.ptp(values)) / STEPS:
        return None
    if counts.min() == counts.max() == 1.0:
        return None, [first, step, values.size]
    return _bytes(np.append(0.0, counts), "u1"), [first, step]


def _in_steps(values: Array) -> Packed:
    low, high = float(values.min()), float(values.max())
    step = (high - low) / STEPS or 1.0
    return _bytes((values - low) / step, "u2"), [low, step]


def _bytes(values: Array, kind: str) -> dict[str, Any]:
    """Whole numbers as bytes in base 64; in packed form, DEFLATE, if that is shorter.

    Packed are the differences of numbers of two bytes, as 2 d or -2 d - 1, with all low bytes first.
    """
    whole = np.rint(values).astype(np.int64)
    plain = whole.astype(np.dtype(kind).newbyteorder("<")).tobytes()
    planes = plain
    if kind == "u2":
        gaps = np.diff(whole, prepend=0)
        signed = ((gaps << 1) ^ (gaps >> 63)).astype("<u4")
        planes = b"".join((signed >> shift & 255).astype(np.uint8).tobytes() for shift in (0, 8, 16))
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    packed = packer.compress(planes) + packer.flush()
    if len(packed) < len(plain):
        return {"dtype": kind, "packed": base64.b64encode(packed).decode("ascii"), "size": whole.size}
    return {"dtype": kind, "bdata": base64.b64encode(plain).decode("ascii")}
