# SPDX-License-Identifier: Apache-2.0
"""A plot of a report as a frame in a notebook: interactive, without network access."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.viz import theme
from pitchpoint.viz.report.page import POLICY, figure_html, plot_scripts
from pitchpoint.viz.scene.page import cell_frame

if TYPE_CHECKING:
    import plotly.graph_objects as go

ROOM = 16
"""Height of the frame above that of the plot [pixels]."""


def figure_frame(figure: go.Figure, title: str) -> str:
    """Plot as a frame within another document; 0.7 MB for the plot library, and its numbers.

    Parameters
    ----------
    figure
        The plot.
    title
        Name of the frame for screen readers.
    """
    colours = "".join(
        f"@media(prefers-color-scheme:{mode}){{:root{{background:{c['paper']};color:{c['ink']}}}}}"
        for mode, c in (("light", theme.LIGHT), ("dark", theme.DARK))
    )
    document = (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">'
        f"<style>:root{{color-scheme:light dark}}html,body,figure{{margin:0}}{colours}</style></head>\n"
        f"<body><main>{figure_html(figure)}</main>{plot_scripts()}</body></html>\n"
    )
    return cell_frame(title, document, f"{int(figure.layout.height or 380) + ROOM}px")
