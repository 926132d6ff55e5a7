# SPDX-License-Identifier: Apache-2.0
"""Known frequencies in a drawn spectrum: a line and a name at each of them and at its harmonics."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from pitchpoint.viz import theme

if TYPE_CHECKING:
    import plotly.graph_objects as go

FAINT = 0.35
"""Opacity of the lines of harmonics above the first."""
CLOSE, LIFT = 0.09, 13
"""Share of the axis below which two names would overlap, and how far one of them is then lowered [pixels]."""
EQUAL = 1e-6
"""Relative difference up to which two frequencies are one."""
PALE = "#ffffff"
LONGEST = 40
"""Maximum number of letters of a name."""


def mark_frequencies(
    figure: go.Figure,
    frequencies: Mapping[str, float],
    *,
    harmonics: int = 1,
    factor: float = 1.0,
    over_map: bool = False,
) -> None:
    """Draw upright lines into a spectrum, named at the first harmonic.

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

    Notes
    -----
    Equal frequencies, as of the meshes of planets, have one line with all names. The names have the attribute
    `name`, which distinguishes them from numbers at peaks.
    """
    end = axis_end(figure)
    shared: dict[float, str] = {}
    for name, frequency in frequencies.items():
        same = next((f for f in shared if abs(f - frequency) < EQUAL * frequency), frequency)
        shared[same] = f"{shared[same]}, {name}" if same in shared else name
    named: list[tuple[float, int]] = []
    for index, (frequency, name) in enumerate(shared.items()):
        colour = theme.SERIES[(index + 1) % len(theme.SERIES)]
        for k in range(1, harmonics + 1):
            at = k * frequency * factor
            if at > end:
                break
            figure.add_vline(
                x=at,
                line={"color": PALE if over_map else colour, "width": 1.4, "dash": "dot"},
                opacity=1.0 if k == 1 else FAINT,
                layer="above" if over_map else "below",
            )
            if k == 1:
                taken = {level for other, level in named if abs(at - other) < CLOSE * end}
                lift = next(n for n in range(len(named) + 1) if n not in taken)
                named.append((at, lift))
                figure.add_annotation(
                    x=at,
                    y=1.0,
                    yref="paper",
                    yanchor="top",
                    yshift=-LIFT * lift,
                    text=_short(name),
                    name="frequency",
                    showarrow=False,
                    xanchor="left",
                    xshift=2,
                    font={"size": 11, "color": PALE if over_map else colour},
                )


def axis_end(figure: go.Figure) -> float:
    """End of the horizontal axis: its range, else the largest value of the first trace."""
    if figure.layout.xaxis.range is not None:
        return float(figure.layout.xaxis.range[1])
    return max(map(float, figure.data[0].x), default=0.0)


def _short(name: str) -> str:
    """Name without its end if it is long: several meshes share one frequency."""
    return name if len(name) <= LONGEST else f"{name[: LONGEST - 1].rstrip(', ')}…"
