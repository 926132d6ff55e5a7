# SPDX-License-Identifier: Apache-2.0
"""Modes: map of the shares of the components in their strain energy."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from textwrap import wrap
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.viz import theme
from pitchpoint.viz.quantities import scale

if TYPE_CHECKING:
    import plotly.graph_objects as go

MAX_MODES, MAX_PARTS = 20, 16
"""Maximum numbers of modes and of components with a column."""
LEAST, WRITTEN = 0.05, 0.005
"""Share in some mode from which a component has a column, and share from which a cell has a number."""
ROW, LINE, GAP = 22, 14, 10
"""Heights of a row and of a line of its name, and distance of names from the map [pixels]."""
LETTERS, UPRIGHT = 44, 24
"""Letters per line of the names of modes, and of the names of components that are written upright."""
WIDTH, LETTER = 560, 6.3
"""Width of the map on narrow pages and mean width of a letter [pixels]."""
OTHERS = "others"
SCALE = [[0.0, "rgba(58,127,196,0)"], [1.0, "rgba(58,127,196,0.85)"]]
"""From the colour of the paper to the first colour of the series, in light and dark mode."""


def plot_modes(
    names: Sequence[str], frequency: ArrayLike, components: Sequence[str], strain_share: ArrayLike
) -> go.Figure:
    """Shares of the components in the strain energy of the lowest modes that vibrate, the lowest at the top.

    Parameters
    ----------
    names
        Names of the modes, lowest first.
    frequency
        Natural frequencies [Hz], shape (n,).
    components
        Names of the components.
    strain_share
        Shares [-], shape (n, number of components).
    """
    hertz = np.asarray(frequency, dtype=np.float64)[:MAX_MODES]
    share = np.nan_to_num(np.asarray(strain_share, dtype=np.float64))[:MAX_MODES]
    rows = np.flatnonzero(share.sum(axis=1) > 0.0)
    share = share[rows]
    # in the order of the model, so that the two bearings of a shaft are neighbours
    largest = np.argsort(-share.max(axis=0, initial=0.0), kind="stable")[:MAX_PARTS]
    columns = sorted(int(c) for c in largest if share[:, c].max(initial=0.0) >= LEAST)
    heads, z = [components[c] for c in columns], share[:, columns]
    rest = share.sum(axis=1) - z.sum(axis=1)
    if rest.max(initial=0.0) >= LEAST:
        heads, z = [*heads, OTHERS], np.column_stack([z, rest])
    labels = [_label(k, names[k], float(hertz[k])) for k in rows.tolist()]
    across = int(WIDTH / max(len(heads), 1) / LETTER)
    upright = max((len(word) for head in heads for word in head.split()), default=0) > across
    words = [wrap(head, UPRIGHT if upright else across) for head in heads]
    longest = max((len(line) for lines in words for line in lines), default=0)
    most = max(map(len, words), default=1)
    top = GAP + round(LETTER * longest if upright else LINE * most)
    row = max([ROW, *(LINE * (label.count("<br>") + 1) + 2 for label in labels)])
    figure = theme.figure(
        "", "", height=top + GAP + row * max(len(labels), 1), margin={"t": top, "b": GAP, "l": 8}
    )
    figure.add_heatmap(
        z=100.0 * z,
        text=[[f"{100.0 * x:.0f}" if x >= WRITTEN else "" for x in row] for row in z],
        texttemplate="%{text}",
        textfont={"size": 11},
        colorscale=SCALE,
        zmin=0.0,
        zmax=100.0,
        xgap=1,
        ygap=1,
        showscale=False,
        customdata=[heads for _ in rows],
        hovertemplate="%{customdata}: %{z:.3g} %<extra></extra>",
    )
    look = {"showgrid": False, "zeroline": False, "ticks": "", "showline": False, "tickfont": {"size": 11}}
    figure.update_xaxes(
        tickvals=list(range(len(words))),
        ticktext=["<br>".join(map(escape, lines)) for lines in words],
        side="top",
        tickangle=-90 if upright else 0,
        **look,
    )
    figure.update_yaxes(tickvals=list(range(len(rows))), ticktext=labels, autorange="reversed", **look)
    return figure


def _label(index: int, name: str, hertz: float) -> str:
    """Number, name and natural frequency of a mode."""
    text = f"{index + 1}: {name}, {scale('Hz', [hertz]).text(hertz)}"
    return "<br>".join(escape(line) for line in wrap(text, LETTERS))
