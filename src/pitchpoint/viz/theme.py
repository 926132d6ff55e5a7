# SPDX-License-Identifier: Apache-2.0
"""Colours, fonts and layout of all plots and drawings, for light and dark mode.

Trace colours have medium lightness, so that they are visible on white and near-black; all other colours
(paper, ink, grid) exist in two sets, selected by the system setting of the reader.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import plotly.graph_objects as go

FONT = "system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif"

BLUE, ORANGE, GREEN, RED = "#3a7fc4", "#d9782d", "#2f9e62", "#d2484f"
PURPLE, TEAL, OCHRE, GREY = "#8a68c4", "#2296a0", "#a88a1e", "#8a8f98"
MAGENTA, BROWN = "#b8429e", "#8f6248"

# The three components of a tooth force have the same colours in all plots, drawings and animations; curves of
# other quantities use a series without these colours. Its first three differ most for colour-blind readers
# (red-green or blue-yellow).
FORCE_PARTS = {"circumferential": BLUE, "radial": ORANGE, "axial": PURPLE}
SERIES = (TEAL, OCHRE, RED, MAGENTA, BROWN, GREEN, GREY)

# Sweeps: up green, down red; the symbols distinguish them for colour-blind readers.
SWEEP = {"up": (GREEN, "triangle-up"), "down": (RED, "triangle-down")}

LIGHT = {
    "paper": "#ffffff",
    "ink": "#1f2933",
    "soft": "#5b6672",
    "grid": "#e3e7ec",
    "gear": "#dfe6ee",
    "mate": "#cfe0f2",
    "edge": "#51606f",
}
DARK = {
    "paper": "#14181d",
    "ink": "#e6e9ed",
    "soft": "#a3adb8",
    "grid": "#2c343d",
    "gear": "#2b3641",
    "mate": "#28455f",
    "edge": "#9aa9b8",
}

# Notebooks and sites have themes that may differ from the system setting and mark their pages accordingly:
# JupyterLab and nbconvert pages, VS Code, Sphinx sites.
LIGHT_PAGE = ':is(body[data-jp-theme-light="true"],body.vscode-light,[data-theme="light"])'
DARK_PAGE = (
    ':is(body[data-jp-theme-light="false"],body.vscode-dark,'
    'body.vscode-high-contrast:not(.vscode-high-contrast-light),[data-theme="dark"])'
)

# Maps: perceptually uniform, dark = low in both modes, so that screen and paper look the same.
MAP_SCALE = "Cividis"
MAP_RANGE_DB = 60.0


def colour_of(name: str, index: int) -> str:
    """Colour of a channel: that of its force component, if any, else the next of the series.

    Examples
    --------
    >>> colour_of("radial_force[stage]", 0) == FORCE_PARTS["radial"], colour_of("speed[g1]", 1) == OCHRE
    (True, True)
    """
    for part, colour in FORCE_PARTS.items():
        if name.startswith(f"{part}_force"):
            return colour
    return SERIES[index % len(SERIES)]


def axis(title: str, **more: Any) -> dict[str, Any]:
    """Settings of one axis; `title` includes the unit."""
    look = {
        "title": {"text": title, "standoff": 8},
        "automargin": True,
        "gridcolor": LIGHT["grid"],
        "zerolinecolor": LIGHT["grid"],
        "linecolor": LIGHT["soft"],
        "showline": True,
        "ticks": "outside",
        "tickcolor": LIGHT["soft"],
        # units include the prefix: 5000 rpm and 2 kHz, no powers of ten
        "exponentformat": "none",
        "hoverformat": ".5g",
        "nticks": 8,
    }
    return look | more


def figure(x_title: str, y_title: str, *, height: int = 380, **more: Any) -> go.Figure:
    """Empty figure with one pair of axes and a legend above it."""
    import plotly.graph_objects as go

    look: dict[str, Any] = {
        "font": {"family": FONT, "size": 13, "color": LIGHT["ink"]},
        # decimal point, no thousands separator
        "separators": ".",
        "paper_bgcolor": LIGHT["paper"],
        "plot_bgcolor": LIGHT["paper"],
        "height": height,
        "margin": {"l": 56, "r": 16, "t": 30, "b": 48},
        "colorway": list(SERIES),
        "hovermode": "closest",
        "legend": {"orientation": "h", "x": 0, "y": 1.02, "yanchor": "bottom"},
        # as many ticks as the width has room for: two plots may be next to each other
        "xaxis": axis(x_title, nticks=0),
        "yaxis": axis(y_title),
    }
    for key, value in more.items():
        look[key] = (
            look[key] | value if isinstance(look.get(key), dict) and isinstance(value, dict) else value
        )
    return go.Figure(layout=look)


def title_above(text: str) -> dict[str, Any]:
    """Small figure title above the left end of the axes."""
    where = {"x": 0, "xref": "paper", "xanchor": "left", "y": 0.98, "yanchor": "top"}
    return {"text": text, "font": {"size": 13}, **where}
