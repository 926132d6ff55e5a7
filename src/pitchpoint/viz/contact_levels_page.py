# SPDX-License-Identifier: Apache-2.0
"""Levels of contact of the same gears next to each other: table, and HTML page with patterns and curves."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.flank_contact.contact_pattern import contact_pattern, on_path
from pitchpoint.analysis.flank_contact.load_factors import load_over_width
from pitchpoint.analysis.flank_contact.numbers import contact_numbers
from pitchpoint.core.units import format_quantity
from pitchpoint.viz import theme
from pitchpoint.viz.contact_plots import FIELDS, LINE_LOAD, plot_load_over_width
from pitchpoint.viz.contact_table import contact_words, options_of
from pitchpoint.viz.mesh_cycle_plot import plot_transmission_error
from pitchpoint.viz.quantities import scale
from pitchpoint.viz.report.page import Section, page
from pitchpoint.viz.tables import plain_table

if TYPE_CHECKING:
    import plotly.graph_objects as go
    import xarray as xr

    from pitchpoint.analysis.flank_contact.contact_pattern import ContactPattern

NAMES = {
    "rigid": "rigid",
    "flexible": "flexible",
    "precomputed": "pre-computed",
    "law": "law din3990",
}
"""Levels in words."""
HEAD = (
    "level",
    "set-up",
    "evaluation",
    "TE mean",
    "TE p–p",
    "k tangent",
    "K_Hβ",
    "p flank",
    "force, rms",
    "force, max",
)
"""Columns of the comparison."""
_GAP, _LAST = 0.03, 0.94
"""Space between two patterns and right end of the last one, as shares of the width."""


def percent(value: float) -> str:
    """A share in per cent.

    Examples
    --------
    >>> percent(0.01234), percent(0.0)
    ('1.23 %', '0 %')
    """
    return f"{100.0 * value:.3g} %"


def level_rows(
    numbers: Mapping[str, Mapping[str, float]], analyses: Mapping[str, xr.Dataset]
) -> list[list[str]]:
    """Rows of the comparison by level, in the columns of `HEAD`; numbers as from `compare_levels`."""
    rows = []
    for level, one in numbers.items():
        data = analyses.get(level)
        factor, pressure = "–", "–"
        if data is not None:
            main = contact_numbers(data)
            factor = format_quantity(float(main["face_load_factor"][0]), "dimensionless", 4)
            pressure = format_quantity(float(main["flank_pressure"][0]), "pressure", 4)
        rows.append(
            [
                NAMES[level],
                format_quantity(one["setup_s"], "time", 3),
                format_quantity(one["evaluation_s"], "time", 3),
                format_quantity(one["te_mean"], "length", 4),
                format_quantity(one["te_pp"], "length", 4),
                format_quantity(one["stiffness"], "stiffness", 4),
                factor,
                pressure,
                *("–" if level == "flexible" else percent(one[v]) for v in ("force_rms", "force_max")),
            ]
        )
    return rows


def contact_levels_page(
    title: str,
    facts: Sequence[tuple[str, str]],
    numbers: Mapping[str, Mapping[str, float]],
    analyses: Mapping[str, xr.Dataset],
    curves: tuple[ArrayLike, Mapping[str, ArrayLike]],
) -> str:
    """Page with the comparison of the levels.

    Parameters
    ----------
    title
        Title of the model.
    facts
        Names and values for the line below the title.
    numbers
        Cost and results by level, as from `compare_levels`.
    analyses
        Contact analyses by level; flexible contact is among them.
    curves
        Mesh phases [base pitches] and transmission error by level [m], shape (n,) each.
    """
    section = Section("levels", "Levels of contact")
    cells = [
        "".join(f"<td{' class=num' if k > 1 else ''}>{escape(text)}</td>" for k, text in enumerate(row))
        for row in level_rows(numbers, analyses)
    ]
    flexible = {k: v for k, v in options_of(analyses["flexible"]).items() if k != "root_stress"}
    section.add(
        "<p>Force: difference from flexible contact at random mesh phases and approaches over the mesh force."
        f" Flexible contact: {escape(contact_words(flexible))}. Patterns of "
        "pre-computed contact are recomputed at the approaches of its table.</p>"
    )
    section.add(plain_table(HEAD, [f"<tr>{row}</tr>" for row in cells]))
    patterns = {NAMES[level]: contact_pattern(data) for level, data in analyses.items()}
    for name, words in (
        ("line_load", "Line load of one tooth pair: normal force per length of the contact line"),
        ("any_pressure", "Hertzian pressure of one tooth pair, rounded tip edges included"),
    ):
        section.add_figure(
            plot_patterns(patterns, name),
            f"{words}, over the path of contact and the face width; the same colours for all levels.",
        )
    widths = analyses["flexible"]
    loads = {NAMES[level]: load_over_width(data)[0] for level, data in analyses.items()}
    section.add_figure(
        _dashed(plot_load_over_width(widths["plane"].values, loads, widths["plane_width"].values)),
        "Line load over the face width, integrated over the profile, mean over the mesh cycle.",
    )
    errors = {NAMES[level]: values for level, values in curves[1].items()}
    section.add_figure(
        _dashed(plot_transmission_error(curves[0], errors)),
        "Transmission error under load over two mesh cycles.",
    )
    return page(f"{title}: levels of contact", facts, [section], "pitchpoint contact-levels.")


def _dashed(figure: go.Figure) -> go.Figure:
    """Figure with dashes for pre-computed contact, which hides flexible contact otherwise."""
    for trace in figure.data:
        if trace.name.startswith(NAMES["precomputed"]):
            trace.line.dash = "dash"
    return figure


def plot_patterns(patterns: Mapping[str, ContactPattern], name: str) -> go.Figure:
    """Maps of a field over face width and path of contact next to each other, in the same colours.

    Parameters
    ----------
    patterns
        Contact patterns of the same gears by title.
    name
        Field: `pressure`, `any_pressure` (tip edges included) or `line_load`.
    """
    words, unit = FIELDS[name]
    fields = {title: on_path(pattern, name) for title, pattern in patterns.items()}
    highest = max(float(np.nanmax(f.values, initial=0.0)) for f in fields.values())
    shown = LINE_LOAD if unit == "N/m" else scale(unit, np.array([highest]))
    z = next(iter(fields.values())).z
    across = scale("m", z)
    figure = theme.figure("", "", height=420)
    share = (_LAST + _GAP) / len(fields)
    places = np.concatenate([f.place for f in fields.values()])
    for k, (title, field) in enumerate(fields.items()):
        axes = "" if k == 0 else str(k + 1)
        figure.add_heatmap(
            x=(field.z * across.factor).astype(np.float32),
            y=field.place.astype(np.float32),
            z=(field.values * shown.factor).astype(np.float32),
            zmin=0.0,
            zmax=highest * shown.factor,
            xaxis=f"x{axes}",
            yaxis=f"y{axes}",
            colorscale=theme.MAP_SCALE,
            showscale=k == 0,
            colorbar={
                "title": {"text": shown.title(words), "side": "right"},
                "thickness": 12,
                "outlinewidth": 0,
                "x": _LAST + _GAP,
            },
            hovertemplate="z %{x:.4g}, %{y:.4g} from A: %{z:.5g}<extra></extra>",
        )
        domain = [k * share, (k + 1) * share - _GAP]
        more = {"showgrid": False, "zeroline": False}
        figure.update_layout(
            {
                f"xaxis{axes}": theme.axis(
                    across.title("face width z"), domain=domain, anchor=f"y{axes}", **more
                ),
                f"yaxis{axes}": theme.axis(
                    "" if k else "position on the path from A [base pitches]",
                    anchor=f"x{axes}",
                    range=[float(places.min()), float(places.max())],
                    showticklabels=k == 0,
                    **more,
                ),
            }
        )
        figure.add_annotation(
            text=title, showarrow=False, x=0.5, y=1.0, xref=f"x{axes} domain", yref="paper", yanchor="bottom"
        )
        for end in (0.0, patterns[title].teeth.eps_alpha):
            line = {"color": theme.GREY, "dash": "dot", "width": 1}
            figure.add_shape(
                type="line", x0=0, x1=1, y0=end, y1=end, line=line, xref=f"x{axes} domain", yref=f"y{axes}"
            )
    return figure
