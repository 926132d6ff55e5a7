# SPDX-License-Identifier: Apache-2.0
"""Colours, fonts and layout of every picture: one meaning, one colour, in light and in dark.

Trace colours are of middle lightness, so that they stand out on white and on near-black alike; everything
else (paper, ink, grid) comes in two sets, and a report switches between them with the reader's system.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import plotly.graph_objects as go

FONT = "system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif"

BLUE, ORANGE, GREEN, RED = "#3a7fc4", "#d9782d", "#2f9e62", "#d2484f"
PURPLE, TEAL, OCHRE, GREY = "#8a68c4", "#2296a0", "#a88a1e", "#8a8f98"
MAGENTA, BROWN = "#b8429e", "#8f6248"

# The three parts of a tooth force keep their colour in every plot, drawing and animation; the lines of other
# quantities take theirs from a series that holds none of the three. Its first three differ most for readers
# who cannot distinguish red from green or blue from yellow.
FORCE_PARTS = {"circumferential": BLUE, "radial": ORANGE, "axial": PURPLE}
SERIES = (TEAL, OCHRE, RED, MAGENTA, BROWN, GREEN, GREY)

# Sweeps: upwards green, downwards red; the symbols show the same to readers who cannot
# distinguish these colours.
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

# Notebooks and sites have a theme of their own, which the system may contradict, and mark their pages with
# it: JupyterLab and the pages of nbconvert, the editor of VS Code, sites made with Sphinx.
LIGHT_PAGE = ':is(body[data-jp-theme-light="true"],body.vscode-light,[data-theme="light"])'
DARK_PAGE = (
    ':is(body[data-jp-theme-light="false"],body.vscode-dark,'
    'body.vscode-high-contrast:not(.vscode-high-contrast-light),[data-theme="dark"])'
)

# Maps: perceptually even, dark = little in both modes, so that a map reads the same on screen and on paper.
MAP_SCALE = "Cividis"
MAP_RANGE_DB = 60.0


def colour_of(name: str, index: int) -> str:
    """Colour of a channel: that of its force part if its name reports this, else the next of the series.

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
    """Settings of one axis; `title` carries the unit."""
    look = {
        "title": {"text": title, "standoff": 8},
        "automargin": True,
        "gridcolor": LIGHT["grid"],
        "zerolinecolor": LIGHT["grid"],
        "linecolor": LIGHT["soft"],
        "showline": True,
        "ticks": "outside",
        "tickcolor": LIGHT["soft"],
        # units carry the prefix: 5000 rpm and 2 kHz, no powers of ten next to them
        "exponentformat": "none",
        "hoverformat": ".5g",
        "nticks": 8,
    }
    return look | more


def figure(x_title: str, y_title: str, *, height: int = 380, **more: Any) -> go.Figure:
    """An empty figure with one pair of axes and a legend above it."""
    import plotly.graph_objects as go

    look: dict[str, Any] = {
        "font": {"family": FONT, "size": 13, "color": LIGHT["ink"]},
        # a decimal point, nothing between thousands
        "separators": ".",
        "paper_bgcolor": LIGHT["paper"],
        "plot_bgcolor": LIGHT["paper"],
        "height": height,
        "margin": {"l": 56, "r": 16, "t": 30, "b": 48},
        "colorway": list(SERIES),
        "hovermode": "closest",
        "legend": {"orientation": "h", "x": 0, "y": 1.02, "yanchor": "bottom"},
        "xaxis": axis(x_title),
        "yaxis": axis(y_title),
    }
    for key, value in more.items():
        look[key] = (
            look[key] | value if isinstance(look.get(key), dict) and isinstance(value, dict) else value
        )
    return go.Figure(layout=look)


def title_above(text: str) -> dict[str, Any]:
    """Title of a figure in small letters, above the left end of its axes."""
    where = {"x": 0, "xref": "paper", "xanchor": "left", "y": 0.98, "yanchor": "top"}
    return {"text": text, "font": {"size": 13}, **where}
