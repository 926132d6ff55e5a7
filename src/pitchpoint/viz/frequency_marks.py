# SPDX-License-Identifier: Apache-2.0
"""Known frequencies in a drawn spectrum or map: a line and a name at each of them and at its harmonics."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.viz import theme
from pitchpoint.viz.label_placement import Label, outside, placed
from pitchpoint.viz.quantities import Array
from pitchpoint.viz.same_curves import grouped

if TYPE_CHECKING:
    import plotly.graph_objects as go

FAINT = 0.35
"""Opacity of the lines of harmonics above the first."""
NARROW = 240.0
"""Width of the axis of the narrowest plot, one of two next to each other on paper [pixels]."""
LETTER, GAP, LIFT = 6.2, 8.0, 13
"""Mean width of a letter, smallest distance of names in one line, and distance of lines [pixels]."""
EQUAL = 1e-6
"""Relative difference up to which two frequencies are one."""
PALE, BEHIND = "#ffffff", "rgba(0,32,77,0.65)"
"""Colours of lines and names above a map, and behind these names: its cells are dark and bright."""
MAP = (520.0, 260.0)
"""Width and height of the axes of a map on paper, where it is smallest [pixels]."""
MOST = 6
"""Number of curves in a map up to which harmonics are drawn."""
ASIDE = 12.0
"""Distance of the name of a curve from its highest point [pixels]."""
LONGEST = 36
"""Maximum number of letters of a name."""


def mark_frequencies(
    figure: go.Figure,
    frequencies: Mapping[str, float],
    *,
    harmonics: int = 1,
    factor: float = 1.0,
    over_map: bool = False,
) -> int:
    """Draw upright lines into a spectrum or map, named at the first harmonic, in a map also at the others.

    Parameters
    ----------
    figure
        Made by `spectrum_plots.plot_spectrum`; what lies beyond its axis is omitted.
    frequencies
        Frequencies [Hz] by name.
    harmonics
        How many multiples of each are marked [-].
    factor
        From hertz, or from orders, to the unit of the axis.
    over_map
        Lines in one pale colour above the cells of a map.

    Returns
    -------
    int
        Number of lines of text with names, one below the other.

    Notes
    -----
    Names are placed so that they do not overlap in a plot of half the width of a page, in a map of its width;
    harmonics in a map are named where the lines of text of the first harmonics have room. Equal frequencies,
    as of the meshes of planets, have one line with all names. The names have the attribute `name`, which
    distinguishes them from numbers at peaks.
    """
    end = axis_end(figure)
    shared: dict[float, str] = {}
    for name, frequency in frequencies.items():
        same = next((f for f in shared if abs(f - frequency) < EQUAL * frequency), frequency)
        shared[same] = f"{shared[same]}, {name}" if same in shared else name
    lines: list[list[tuple[float, float]]] = []
    width = MAP[0] if over_map else NARROW
    drawn = [
        (k, index, k * frequency * factor, name)
        for k in range(1, harmonics + 1)
        for index, (frequency, name) in enumerate(shared.items())
        if k * frequency * factor <= end
    ]
    for k, index, at, name in drawn:
        colour = PALE if over_map else theme.SERIES[(index + 1) % len(theme.SERIES)]
        figure.add_vline(
            x=at,
            line={"color": colour, "width": 1.4, "dash": "dot"},
            opacity=1.0 if k == 1 else FAINT,
            layer="above" if over_map else "below",
        )
        if k > 1 and not over_map:
            continue
        words = harmonic_name(_short(name), k)
        anchor, (left, right), beside = _extent(words, at / end, width)
        row = _line_of(left, right, lines, new=k == 1)
        if row is None or (k > 1 and not beside):
            continue
        figure.add_annotation(
            x=at if beside else end * left / width,
            y=1.0,
            yref="paper",
            yanchor="top",
            yshift=-LIFT * row,
            text=words,
            name="frequency",
            showarrow=False,
            xanchor=anchor,
            xshift=0 if not beside else 2 if anchor == "left" else -2,
            font={"size": 11, "color": colour},
            **({"bgcolor": BEHIND, "borderpad": 1} if over_map else {}),
        )
    return len(lines)


def mark_curves(
    figure: go.Figure, x: Array, curves: Mapping[str, Array], top: float, *, harmonics: int = 1
) -> None:
    """Draw frequencies that change with the speed into a map over time, named at their highest point in it.

    Parameters
    ----------
    figure
        Map over time and frequency.
    x
        Times in the unit of the axis, shape (n,).
    curves
        Frequencies in the unit of the axis by name, shape (n,) each; equal ones have one line.
    top
        Highest frequency of the map.
    harmonics
        How many multiples of each are drawn [-], fewer of many frequencies.
    """
    width, height = MAP
    span = max(float(np.ptp(x)), 1e-300)
    found: list[tuple[int, float, Label]] = []
    shared = {name: curve for name, curve in _shared(curves).items() if np.any(curve <= top)}
    drawn = [
        (k, harmonic_name(name, k), k * curve)
        for k in range(1, min(harmonics, max(1, MOST // max(1, len(shared)))) + 1)
        for name, curve in shared.items()
    ]
    for multiple, name, curve in drawn:
        inside = curve <= top
        if not inside.any():
            continue
        figure.add_scatter(
            x=x.astype(np.float32),
            y=np.where(inside, curve, np.nan).astype(np.float32),
            mode="lines",
            line={"color": PALE, "width": 1.4, "dash": "dot"},
            opacity=1.0 if multiple == 1 else FAINT,
            name=name,
            showlegend=False,
            hovertemplate=f"{name}: %{{y:.5g}}<extra></extra>",
        )
        k = int(np.argmax(np.where(inside, curve, -np.inf)))
        across, down = width * float(x[k] - x[0]) / span, height * (1.0 - float(curve[k]) / top)
        # next to the highest point, on the side from which the curve rises to it
        side, anchor = (-ASIDE, "end") if across > 0.5 * width else (ASIDE, "start")
        label = Label(across + side, max(down - 4.0, 14.0), anchor, ((_short(name), "pp-small"),))
        found.append((k, float(curve[k]), label))
    labels = placed([label for _, _, label in found], outside(height))
    for (k, y, wanted), label in zip(found, labels, strict=True):
        left = wanted.anchor == "end"
        figure.add_annotation(
            x=float(x[k]),
            y=y,
            text=wanted.lines[0][0],
            name="frequency",
            ax=-ASIDE if left else ASIDE,
            # from the baseline to the middle of the text
            ay=label.y - 4.0 - height * (1.0 - y / top),
            xanchor="right" if left else "left",
            showarrow=True,
            arrowhead=0,
            arrowwidth=0.8,
            arrowcolor=PALE,
            font={"size": 11, "color": PALE},
            bgcolor=BEHIND,
            borderpad=1,
        )


def _shared(curves: Mapping[str, Array]) -> dict[str, Array]:
    """Curves by name; equal ones once, with all names."""
    found = grouped(curves, lambda one, other: np.allclose(one, other, rtol=EQUAL, atol=0.0))
    return {", ".join(names): curve for names, curve in found}


def harmonic_name(name: str, k: int) -> str:
    """Name of a harmonic of a frequency.

    Examples
    --------
    >>> harmonic_name("stage", 1), harmonic_name("stage", 2)
    ('stage', '2 × stage')
    """
    return name if k == 1 else f"{k} × {name}"


def _extent(words: str, share: float, room: float) -> tuple[str, tuple[float, float], bool]:
    """Anchor and ends of a name in a plot of some width [pixels], and whether it is next to its line.

    A name without room on either side of its line ends at the end of the axis.
    """
    width, at = LETTER * len(words), room * share
    if at + width <= room:
        return "left", (at, at + width), True
    if at >= width:
        return "right", (at - width, at), True
    return "left", (room - width, room), False


def _line_of(left: float, right: float, lines: list[list[tuple[float, float]]], new: bool) -> int | None:
    """First line of text with room between two ends [pixels], which are then taken; a new one, or None."""
    for k, taken in enumerate(lines):
        if all(right + GAP <= begin or end + GAP <= left for begin, end in taken):
            taken.append((left, right))
            return k
    if not new:
        return None
    lines.append([(left, right)])
    return len(lines) - 1


def axis_end(figure: go.Figure) -> float:
    """End of the horizontal axis: its range, else the largest value of the first trace."""
    if figure.layout.xaxis.range is not None:
        return float(figure.layout.xaxis.range[1])
    return max(map(float, figure.data[0].x), default=0.0)


def _short(name: str) -> str:
    """Name without its end if it is long: several meshes share one frequency."""
    return name if len(name) <= LONGEST else f"{name[: LONGEST - 1].rstrip(', ')}…"
