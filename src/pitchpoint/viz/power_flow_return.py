# SPDX-License-Identifier: Apache-2.0
"""Bands of a power flow that run back to an earlier block: in lanes below all blocks, with an arrow."""

from __future__ import annotations

from pitchpoint.viz.label_placement import Rectangle

LANE = 84.0
"""Free height above a lane [pixels]: the loss of the band above it, and its own name and power."""
INSIDE = 12.0
"""Inner radius of a bend [pixels]."""
ARROW = 8.0
"""Half height of an arrow [pixels]."""


def lanes(bottom: float, widths: list[float]) -> list[float]:
    """Heights of the middles of lanes below `bottom` for bands of some widths, from top to bottom [pixels].

    Examples
    --------
    >>> lanes(100.0, [50.0, 10.0])
    [209.0, 323.0]
    """
    found = []
    for width in widths:
        found.append(bottom + LANE + 0.5 * width)
        bottom = found[-1] + 0.5 * width
    return found


def reach(width: float) -> float:
    """Distance by which a bend of a band of some width protrudes beyond the block [pixels]."""
    return INSIDE + width


def return_band(
    start: tuple[float, float], end: tuple[float, float], lane: float, width: float
) -> tuple[str, str, list[Rectangle]]:
    """Outline and arrow of a band from the right of a block back to the left of another; rectangles along it.

    Parameters
    ----------
    start, end
        Middle of the band at the right side of the first and at the left side of the second block [pixels].
    lane
        Height of its lane, below both [pixels].
    width
        Width of the band [pixels].
    """
    (a, ya), (b, yb), h = start, end, 0.5 * width
    r = INSIDE + h
    out, in_ = r + h, r - h
    path = (
        f"M{a:.1f} {ya - h:.1f}{_arc(out, a + out, ya + r)}V{lane - r:.1f}{_arc(out, a, lane + h)}"
        f"H{b:.1f}{_arc(out, b - out, lane - r)}V{yb + r:.1f}{_arc(out, b, yb - h)}V{yb + h:.1f}"
        f"{_arc(in_, b - in_, yb + r, 0)}V{lane - r:.1f}{_arc(in_, b, lane - h, 0)}"
        f"H{a:.1f}{_arc(in_, a + in_, lane - r, 0)}V{ya + r:.1f}{_arc(in_, a, ya + h, 0)}Z"
    )
    x = 0.5 * (a + b)
    arrow = (
        f"M{x + ARROW:.1f} {lane - ARROW:.1f}L{x - ARROW:.1f} {lane:.1f}L{x + ARROW:.1f} {lane + ARROW:.1f}Z"
    )
    low, high = min(a, b) - out, max(a, b) + out
    slices = [
        (a, ya - h, a + out, lane + h),
        (b - out, yb - h, b, lane + h),
        (low, lane - h, high, lane + h),
    ]
    return path, arrow, slices


def _arc(radius: float, x: float, y: float, clockwise: int = 1) -> str:
    """Quarter of a circle to a point."""
    return f"A{radius:.1f} {radius:.1f} 0 0 {clockwise} {x:.1f} {y:.1f}"
