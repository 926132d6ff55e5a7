# SPDX-License-Identifier: Apache-2.0
"""Modes: where their strain energy is, as bars below names and natural frequencies."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.viz import theme
from pitchpoint.viz.quantities import Array, damping_words, number, scale

if TYPE_CHECKING:
    import plotly.graph_objects as go

MAX_MODES, MAX_PARTS = 20, len(theme.SERIES) - 1
"""Maximum numbers of modes and of components with a colour."""
LINE, BAR, LEGEND, BOTTOM = 38, 16, 20, 52
"""Heights of a mode with its name, of its bar, of a line of the legend, and of the axis with its title
[pixels]."""
LETTERS, BOX = 88, 5
"""Letters per line of the legend on paper, and space of the mark of a name [letters]."""
LEGEND_AT = {"x": 0, "y": 1, "xref": "container", "pad": {"t": 12}, "font": {"size": 12}}
"""Place of the legend: at the left edge of the figure."""
INSIDE = 90
"""Letters that fit into a bar over the whole width on paper."""
SMALL = 5e-3
"""Share that is not visible."""


def plot_modes(
    names: Sequence[str],
    frequency: ArrayLike,
    damping_ratio: ArrayLike,
    components: Sequence[str],
    strain_share: ArrayLike,
) -> go.Figure:
    """Shares of the components in the strain energy of the lowest modes, the lowest mode at the top.

    Parameters
    ----------
    names
        Names of the modes, lowest first.
    frequency, damping_ratio
        Natural frequencies [Hz] and damping ratios, shape (n,).
    components
        Names of the components.
    strain_share
        Shares [-], shape (n, number of components).
    """
    hertz = np.asarray(frequency, dtype=np.float64)[:MAX_MODES]
    ratio = np.asarray(damping_ratio, dtype=np.float64)[:MAX_MODES]
    share = np.nan_to_num(np.asarray(strain_share, dtype=np.float64))[:MAX_MODES]
    n = hertz.size
    labels = []
    for k in range(n):
        damping = f", ζ {damping_words(ratio[k], 2)}" if np.isfinite(ratio[k]) and hertz[k] > 0.0 else ""
        labels.append(f"{k + 1}: {names[k]}, {scale('Hz', [hertz[k]]).text(hertz[k])}{damping}")
    order = np.argsort(-share.sum(axis=0), kind="stable")
    largest = [int(c) for c in order[:MAX_PARTS] if share[:, c].max(initial=0.0) > 1e-3]
    bars = {components[c]: share[:, c] for c in largest}
    rest = share.sum(axis=1) - sum((bar for bar in bars.values()), np.zeros(n))
    if rest.max(initial=0.0) > SMALL:
        bars["others"] = rest
    legend, lines = _legend(list(bars))
    top = 22 + LEGEND * lines
    height = top + BOTTOM + LINE * max(n, 1)
    figure = theme.figure("share in the strain energy [%]", "", height=height, margin={"t": top, "l": 16})
    for k, (name, values) in enumerate(bars.items()):
        others = name == "others"
        colour = _colour(name, k)
        words = _others_in_words(components, share, largest) if others else None
        figure.add_bar(
            y=labels,
            x=100.0 * values,
            orientation="h",
            name=name,
            marker={"color": colour},
            text=words,
            textposition="inside",
            insidetextanchor="middle",
            # the texts fit: the library would turn them or make them smaller
            textangle=0,
            constraintext="none",
            insidetextfont={"color": theme.LIGHT["paper"], "size": 11},
            hovertemplate=f"{name}: %{{x:.3g}} %<extra></extra>",
        )
    for k, label in enumerate(labels):
        # long names next to the bars would leave little width for them
        figure.add_annotation(
            x=0,
            xref="paper",
            y=k,
            yshift=0.5 * BAR,
            text=escape(label),
            showarrow=False,
            xanchor="left",
            yanchor="bottom",
            borderpad=0,
            font={"size": 12},
        )
    figure.update_layout(
        barmode="stack",
        bargap=1.0 - BAR / LINE,
        showlegend=False,
        # the legend of the library would be as narrow as the axis, next to the names of the modes
        title={**theme.title_above(legend), **LEGEND_AT},
        xaxis={"range": [0.0, 100.0]},
        yaxis={"autorange": "reversed", "ticks": "", "showgrid": False, "showticklabels": False},
    )
    return figure


def _colour(name: str, index: int) -> str:
    return theme.GREY if name == "others" else theme.SERIES[index % len(theme.SERIES)]


def _legend(names: Sequence[str]) -> tuple[str, int]:
    """Names of the bars with a square in their colour, and the number of lines."""
    lines, width = [""], 0
    for k, name in enumerate(names):
        if width and width + len(name) + BOX > LETTERS:
            lines, width = [*lines, ""], 0
        mark = f'<span style="color:{_colour(name, k)}">■</span>'
        lines[-1] += f"{'&nbsp;&nbsp; ' if width else ''}{mark} {escape(name)}"
        width += len(name) + BOX
    return "<br>".join(lines), len(lines)


def _others_in_words(components: Sequence[str], share: Array, coloured: Sequence[int]) -> list[str]:
    """Largest components without colour per mode, as many as fit into their part of the bar, and the rest."""
    left = share.copy()
    left[:, list(coloured)] = 0.0
    return [_largest(components, row) for row in left]


def _largest(components: Sequence[str], row: Array) -> str:
    """Largest shares of a mode and the sum of the other ones, in the space of their sum."""
    order = [int(k) for k in np.argsort(-row, kind="stable") if row[k] > 0.0]
    found = ""
    for count in range(1, int((row > SMALL).sum()) + 1):
        parts = [f"{components[k]} {number(100.0 * row[k], 2)} %" for k in order[:count]]
        rest = order[count:]
        more = float(row[rest].sum())
        parts += [f"{len(rest)} more {number(100.0 * more, 2)} %"] if more > SMALL else []
        words = ", ".join(parts)
        if len(words) > INSIDE * row.sum():
            break
        found = words
    return found
