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
"""Share of the axis below which two names would overlap, and how far one of them is then lifted [pixels]."""


def mark_frequencies(
    figure: go.Figure, frequencies: Mapping[str, float], *, harmonics: int = 1, factor: float = 1.0
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
        From hertz to the unit of the axis.
    """
    end = figure.layout.xaxis.range[1]
    named: list[tuple[float, int]] = []
    for index, (name, frequency) in enumerate(frequencies.items()):
        colour = theme.SERIES[(index + 1) % len(theme.SERIES)]
        for k in range(1, harmonics + 1):
            at = k * frequency * factor
            if at > end:
                break
            figure.add_vline(
                x=at,
                line={"color": colour, "width": 1.4, "dash": "dot"},
                opacity=1.0 if k == 1 else FAINT,
                layer="below",
            )
            if k == 1:
                taken = {level for other, level in named if abs(at - other) < CLOSE * end}
                lift = next(n for n in range(len(named) + 1) if n not in taken)
                named.append((at, lift))
                figure.add_annotation(
                    x=at,
                    y=1.0,
                    yref="paper",
                    yanchor="bottom",
                    yshift=LIFT * lift,
                    text=name,
                    showarrow=False,
                    xanchor="left" if at < 0.03 * end else "center",
                    font={"size": 11, "color": colour},
                )
