# SPDX-License-Identifier: Apache-2.0
"""Self-contained HTML page of a report, without network access or server."""

from __future__ import annotations

import base64
import json
import re
import zlib
from collections.abc import Sequence, Sized
from dataclasses import dataclass, field
from functools import cache
from html import escape
from importlib.resources import files
from typing import TYPE_CHECKING

from pitchpoint.viz import theme
from pitchpoint.viz.figure_file import figure_json

if TYPE_CHECKING:
    import plotly.graph_objects as go

# No external resources: the file works offline and sends no data.
POLICY = (
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
    "img-src data: blob:; font-src data:; form-action 'none'; base-uri 'none'"
)


@dataclass
class Section:
    """Part of a report: anchor, heading and finished HTML; a section without HTML is not shown.

    `figures` are its plots by name, for `report.pictures.plot`.
    """

    anchor: str
    heading: str
    parts: list[str] = field(default_factory=list)
    figures: dict[str, go.Figure] = field(default_factory=dict)

    def add(self, html: str) -> None:
        """Append a piece of HTML unless it is empty."""
        if html:
            self.parts.append(html)

    def add_name(self, name: str, among: Sized) -> None:
        """Append a name as a heading if it is one of several."""
        if len(among) > 1:
            self.parts.append(f"<h3>{escape(name)}</h3>")

    def add_figure(
        self,
        figure: go.Figure,
        caption: str = "",
        *,
        name: str = "",
        beside: go.Figure | None = None,
        beside_caption: str = "The last periods, magnified.",
        beside_name: str = "",
    ) -> None:
        """Append a plot, or two next to each other; plots without data are omitted.

        The name in Python is a kind, or kind and owner: `mesh_stiffness[stage]`.
        """
        if not any(_has_data(trace) for trace in figure.data):
            return
        known = (name or self.anchor, *(f"{name or self.anchor} {k}" for k in range(2, 100)))
        self.figures[next(n for n in known if n not in self.figures)] = figure
        html = figure_html(figure, caption)
        if beside is not None:
            self.figures |= {beside_name: beside} if beside_name else {}
            end = figure_html(beside, beside_caption)
            html = f'<div class="pair">{html}{end}</div>'
        self.parts.append(html)


def keep_height(figure: go.Figure) -> None:
    """Keep the height of a plot on paper, where others are lower: its labels need it."""
    figure.update_layout(meta={**(figure.layout.meta or {}), "whole": True})


def figure_html(figure: go.Figure, caption: str = "") -> str:
    """Plot as data; the script of the page draws it in light or dark colours."""
    # the default template only repeats settings of the layout
    figure.update_layout(template={})
    data = figure_json(figure).replace("</", "<\\/")
    words = f"<figcaption>{escape(caption)}</figcaption>" if caption else ""
    return (
        f'<figure><div class="plot" style="min-height:{int(figure.layout.height or 380)}px"></div>'
        f'<script type="application/json">{data}</script>{words}</figure>'
    )


def page(
    title: str,
    facts: Sequence[tuple[str, str]],
    sections: Sequence[Section],
    footer: str,
    alerts: Sequence[str] = (),
) -> str:
    """Complete HTML document.

    Parameters
    ----------
    title
        Title of the page.
    facts
        Pairs of name and text for the line below the title; those without text are omitted.
    sections
        Sections; those without parts are omitted.
    footer
        Last line.
    alerts
        Prominent warnings.
    """
    shown = [s for s in sections if s.parts]
    with_plots = any('<div class="plot"' in part for s in shown for part in s.parts)
    variables = {
        mode: "".join(f"--pp-{key}:{value};" for key, value in colours.items())
        for mode, colours in (("light", theme.LIGHT), ("dark", theme.DARK))
    }
    style = (
        f":root{{color-scheme:light dark;--pp-font:{theme.FONT};{variables['light']}}}"
        f"@media screen and (prefers-color-scheme:dark){{:root{{{variables['dark']}}}}}"
        f"{asset('report.css')}"
    )
    items = "".join(f"<li>{escape(name)} <b>{escape(value)}</b></li>" for name, value in facts if value)
    links = "".join(f'<a href="#{s.anchor}">{escape(s.heading)}</a>' for s in shown)
    alert = "".join(f'<p class="alert" role="note">{escape(sentence)}</p>' for sentence in alerts)
    body = "".join(
        f'<section id="{s.anchor}" aria-labelledby="{s.anchor}-head">'
        f'<h2 id="{s.anchor}-head">{escape(s.heading)}</h2>{"".join(s.parts)}</section>'
        for s in shown
    )
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        '<meta name="generator" content="pitchpoint">'
        f"<title>{escape(title)}</title><style>{style}</style></head>\n<body>"
        '<a class="skip" href="#content">Skip to the content</a>'
        f'<header><h1>{escape(title)}</h1><ul class="facts">{items}</ul>{alert}</header>\n'
        f'<nav aria-label="Sections">{links}</nav>\n'
        f'<main id="content" tabindex="-1">{body}</main>\n<footer>{escape(footer)}</footer>\n'
        f"{plot_scripts(with_plots)}</body></html>\n"
    )


def plot_scripts(with_plots: bool = True) -> str:
    """Scripts of the page; the plot library only if there are plots."""
    colours = json.dumps({"light": theme.LIGHT, "dark": theme.DARK}, sort_keys=True)
    library = packed_plots() if with_plots else ""
    return (
        f'<script type="application/json" id="pp-colours">{colours}</script>\n'
        f"{library}<script>{asset('report.js')}</script>\n"
    )


@cache
def packed_plots() -> str:
    """Plot library, compressed (DEFLATE, base64) below its licence in plain text; `report.js` unpacks it."""
    notices = re.match(r"(/\*.*?\*/\s*)+", asset("plots.js"), re.DOTALL)
    plain = asset("plots.js").encode("utf-8")
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    text = base64.b64encode(packer.compress(plain) + packer.flush()).decode("ascii")
    head = notices.group() if notices else ""
    element = f'<script type="text/plain" id="pp-plots" data-size="{len(plain)}">{text}</script>'
    return f"<script>{head}</script>\n{element}\n<script>{asset('inflate.js')}</script>\n"


def asset(name: str) -> str:
    """Text of an asset file of the pages."""
    return (files("pitchpoint.viz") / "assets" / name).read_text(encoding="utf-8")


def _has_data(trace: object) -> bool:
    """Whether a trace has data."""
    values = (
        getattr(trace, "z", None) if getattr(trace, "type", "") == "heatmap" else getattr(trace, "y", None)
    )
    return values is not None and any(value is not None for value in values)
