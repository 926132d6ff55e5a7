# SPDX-License-Identifier: Apache-2.0
"""Modes: where their strain energy is, as bars with names and natural frequencies."""

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
LINE, LEGEND, BOTTOM = 22, 20, 52
"""Heights of a mode, of a line of the legend, and of the axis with its title [pixels]."""
LETTERS, BOX = 88, 5
"""Letters per line of the legend on paper, and space of the mark of a name [letters]."""
LEGEND_AT = {"x": 0, "y": 1, "xref": "container", "pad": {"t": 12}, "font": {"size": 12}}
"""Place of the legend: at the left edge of the figure."""
NAMED = 0.2
"""Share of the components without colour from which the largest of them is named."""


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
        labels.append(f"{k + 1} {names[k]}, {scale('Hz', [hertz[k]]).text(hertz[k])}{damping}")
    order = np.argsort(-share.sum(axis=0), kind="stable")
    largest = [int(c) for c in order[:MAX_PARTS] if share[:, c].max(initial=0.0) > 1e-3]
    bars = {components[c]: share[:, c] for c in largest}
    rest = share.sum(axis=1) - sum((bar for bar in bars.values()), np.zeros(n))
    if rest.max(initial=0.0) > 5e-3:
        bars["others"] = rest
    legend, lines = _legend(list(bars))
    top = 22 + LEGEND * lines
    height = top + BOTTOM + LINE * max(n, 2)
    figure = theme.figure("share in the strain energy [%]", "", height=height, margin={"t": top})
    for k, (name, values) in enumerate(bars.items()):
        others = name == "others"
        colour = _colour(name, k)
        words = _largest_others(components, share, largest, rest) if others else None
        figure.add_bar(
            y=labels,
            x=100.0 * values,
            orientation="h",
            name=name,
            marker={"color": colour},
            text=words,
            textposition="inside",
            insidetextanchor="middle",
            insidetextfont={"color": theme.LIGHT["paper"], "size": 11},
            hovertemplate=f"{name}: %{{x:.3g}} %<extra></extra>",
        )
    figure.update_layout(
        barmode="stack",
        bargap=0.3,
        showlegend=False,
        # the legend of the library would be as narrow as the axis, next to the names of the modes
        title={**theme.title_above(legend), **LEGEND_AT},
        xaxis={"range": [0.0, 100.0]},
        yaxis={"autorange": "reversed", "ticks": "", "showgrid": False, "nticks": n, "dtick": 1},
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


def _largest_others(
    components: Sequence[str], share: Array, coloured: Sequence[int], rest: Array
) -> list[str]:
    """Name of the largest component without colour per mode, if the others have much of the energy."""
    left = share.copy()
    left[:, list(coloured)] = 0.0
    return [
        f"{components[int(np.argmax(row))]} {number(100.0 * row.max(), 2)} %" if part >= NAMED else ""
        for row, part in zip(left, rest, strict=True)
    ]
