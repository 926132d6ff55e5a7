# SPDX-License-Identifier: Apache-2.0
"""Campbell diagram: natural frequencies over speed, excitation orders, ranked critical speeds."""

from __future__ import annotations

import math
from collections.abc import Sequence
from html import escape
from textwrap import wrap
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.analysis.campbell_ranking import SIDEBAND, ranked_speeds
from pitchpoint.viz import theme
from pitchpoint.viz.labels import around, spread
from pitchpoint.viz.quantities import Array, Scale, number, scale

if TYPE_CHECKING:
    import plotly.graph_objects as go
    import xarray as xr

HEIGHT, BOTTOM, LEGEND, ROW = 574, 62, 34, 26
"""Height of the figure without labels above the plot, margin below, height of the legend of one row, and of
each further row [pixels]."""
SAMPLE = 52
"""Width of an entry of the legend without its text [pixels]."""
ROOM = HEIGHT - BOTTOM - LEGEND
"""Height of the plot [pixels]."""
WIDTH = 560
"""Width of the plot on narrow pages [pixels]."""
PAPER = 360
"""Least width of the plot, on paper, for the distance of labels above it [pixels]."""
LINE, LETTER = 14, 6.3
"""Distance of two labels and mean width of a letter at 11 points [pixels]."""
LEADER = 22
"""Length of the leader lines from curves to their names [pixels]."""
LETTERS = (30, 36, 44, 60)
"""Letters per line of a name right of the plot: the first for which all names fit into its height."""
UPRIGHT = 15
"""Letters per line of a name above the plot."""
FEWEST = 3
"""Minimum number of names of shaft orders at one place that are replaced by their range."""
NUMBERED = 12
"""Number of critical speeds marked with their rank."""
RANK = 13
"""Size of a rank, and its distance from its circle [pixels]."""
WAYS = {
    "forward": (theme.RED, "forward whirl"),
    "backward": (theme.BLUE, "backward whirl"),
    "": (theme.TEAL, "other modes"),
}
"""Colour and legend of modes by whirl."""
RIGID = 1e-6
"""Frequency over the highest up to which a mode is not drawn."""


def plot_campbell(
    diagram: xr.Dataset,
    *,
    frequency: tuple[float, float] | None = None,
    speed: tuple[float, float] | None = None,
) -> go.Figure:
    """Campbell diagram with named curves and ranked critical speeds.

    Parameters
    ----------
    diagram
        Dataset of `solve_campbell`, or a part of it from `select_modes`.
    frequency
        Range of the frequencies [Hz]; default from zero to above the highest curve or order line.
    speed
        Range of the speeds [rad/s]; default that of the dataset. Order lines outside the ranges are omitted.
    """
    omega = np.abs(np.asarray(diagram["speed"].values, dtype=np.float64))
    order = np.argsort(omega, kind="stable")
    omega, curves = omega[order], np.asarray(diagram["frequency"].values, dtype=np.float64)[order]
    names = [str(name) for name in diagram["name"].values]
    moving = curves.max(axis=0, initial=0.0) > RIGID * max(float(curves.max(initial=0.0)), 1e-300)
    curves, names = curves[:, moving], [n for n, m in zip(names, moving, strict=True) if m]
    wide = speed or ((float(omega[0]), float(omega[-1])) if omega.size else (0.0, 1.0))
    high = frequency or (0.0, 1.06 * float(curves.max(initial=1.0)))
    revolutions, pitch = scale("rad/s"), scale("Hz", [high[1]])
    figure = theme.figure(
        revolutions.title(f"speed of {diagram.attrs.get('body', '')}".rstrip()), pitch.title("frequency")
    )
    place = _Places(wide, high, revolutions, pitch)
    at_right, above = _orders(figure, diagram, place)
    at_right = _modes(figure, omega, curves, names, place) + at_right
    _operating(figure, diagram, place)
    _critical(figure, diagram, place)
    right = _at_the_right(figure, at_right, place)
    top = _above(figure, above) + _more_rows(figure)
    figure.update_layout(
        height=HEIGHT + top,
        # labels have distances in pixels: automatic margins would change the height of the plot
        margin={"l": 64, "r": right, "t": LEGEND + top, "b": BOTTOM},
        xaxis={"automargin": False},
        yaxis={"automargin": False},
        legend={
            "orientation": "h",
            "x": 0,
            "y": 1.0,
            "yanchor": "top",
            "yref": "container",
            "font": {"size": 11},
        },
    )
    figure.update_xaxes(range=[x * revolutions.factor for x in wide], showgrid=False)
    figure.update_yaxes(range=[y * pitch.factor for y in high], showgrid=False, zeroline=False)
    return figure


class _Places:
    """Ranges of a diagram in SI units, and its display units."""

    def __init__(
        self, speed: tuple[float, float], frequency: tuple[float, float], revolutions: Scale, pitch: Scale
    ) -> None:
        self.speed, self.frequency = speed, frequency
        self.revolutions, self.pitch = revolutions, pitch

    def across(self, frequency: float) -> float:
        """Height of a frequency over that of the plot."""
        low, high = self.frequency
        return (frequency - low) / max(high - low, 1e-300)

    def along(self, speed: float) -> float:
        """Position of a speed over the width of the plot."""
        low, high = self.speed
        return (speed - low) / max(high - low, 1e-300)

    def inside(self, speed: float, frequency: float) -> bool:
        """Whether a point is in the plot."""
        return 0.0 <= self.along(speed) <= 1.0 and 0.0 <= self.across(frequency) <= 1.0


def _way(name: str) -> str:
    """Whirl in the name of a mode."""
    return next((way for way in WAYS if way and f"({way}" in name), "")


def _modes(
    figure: go.Figure, omega: Array, curves: Array, names: Sequence[str], place: _Places
) -> list[tuple[float, str, str]]:
    """Curves of the modes; returns position, text and colour of their names at the right edge."""
    listed: list[tuple[float, str, str]] = []
    low, high = place.frequency
    inside = (omega >= place.speed[0])[:, None] & (omega <= place.speed[1])[:, None]
    seen = np.any(inside & (curves >= low) & (curves <= high), axis=0).tolist()
    ways = {_way(name) for k, name in enumerate(names) if seen[k]}
    shown = set(WAYS) - ways
    for k, name in enumerate(names):
        way = _way(name)
        colour, legend = WAYS[way]
        legend = "modes" if way == "" and ways == {""} else legend
        figure.add_scatter(
            x=omega * place.revolutions.factor,
            y=curves[:, k] * place.pitch.factor,
            mode="lines",
            name=legend,
            legendgroup=legend,
            showlegend=way not in shown,
            line={"color": colour, "width": 2},
            hovertemplate=f"{name}<br>%{{x:.5g}} {place.revolutions.unit}, "
            f"%{{y:.5g}} {place.pitch.unit}<extra></extra>",
        )
        shown.add(way)
        end = float(np.interp(place.speed[1], omega, curves[:, k]))
        if 0.0 <= place.across(end) <= 1.0:
            listed.append((end, name, colour))
    return listed


def _orders(
    figure: go.Figure, diagram: xr.Dataset, place: _Places
) -> tuple[list[tuple[float, str, str]], list[tuple[float, str]]]:
    """Lines of the orders that enter the plot; returns the names at its right edge and above it."""
    at_right, above = [], []
    shafts: list[tuple[float, str]] = []
    shown: set[bool] = set()
    values = np.asarray(diagram["excitation_order"].values, dtype=np.float64)
    kinds = [str(kind) for kind in diagram["excitation_kind"].values]
    for name, order, kind in zip(map(str, diagram["excitation"].values), values, kinds, strict=True):
        per = order / (2.0 * np.pi)
        start = max(place.speed[0], place.frequency[0] / per)
        end = min(place.speed[1], place.frequency[1] / per)
        if start >= end:
            continue
        band = kind == SIDEBAND
        legend = "sidebands" if band else "orders"
        figure.add_scatter(
            x=[x * place.revolutions.factor for x in (start, end)],
            y=[per * x * place.pitch.factor for x in (start, end)],
            mode="lines",
            name=legend,
            legendgroup=legend,
            showlegend=band not in shown,
            line={"color": theme.GREY, "width": 0.7 if band else 1.2, "dash": "dot" if band else "dash"},
            hovertemplate=f"{name}<extra></extra>",
        )
        shown.add(band)
        if band:
            continue
        if end < place.speed[1]:
            above.append((place.along(end), name))
        elif kind == "shaft":
            shafts.append((per * end, name))
        else:
            at_right.append((per * end, name, theme.LIGHT["soft"]))
    at_right += [(at, name, theme.LIGHT["soft"]) for at, name in _ranges(shafts, place)]
    return at_right, above


def _ranges(listed: Sequence[tuple[float, str]], place: _Places) -> list[tuple[float, str]]:
    """Names at the right edge; three or more within a line of text each are replaced by their range."""
    groups: list[list[tuple[float, str]]] = []
    for at, name in sorted(listed):
        if groups and ROOM * (place.across(at) - place.across(groups[-1][-1][0])) < LINE:
            groups[-1].append((at, name))
        else:
            groups.append([(at, name)])
    found = []
    for group in groups:
        if len(group) < FEWEST:
            found += group
            continue
        middle = 0.5 * (group[0][0] + group[-1][0])
        first, last = (group[k][1].replace(" ", "\xa0") for k in (0, -1))
        found.append((middle, f"{len(group)} shaft orders, {first} to {last}"))
    return found


def _operating(figure: go.Figure, diagram: xr.Dataset, place: _Places) -> None:
    """Operating speed as line, or operating range as band."""
    given = diagram.attrs.get("operating_speed")
    if given is None:
        return
    low, high = (abs(float(x)) * place.revolutions.factor for x in given)
    if low == high:
        figure.add_vline(x=low, line={"color": theme.GREEN, "width": 1.5})
    else:
        figure.add_vrect(x0=low, x1=high, fillcolor=theme.GREEN, opacity=0.12, line_width=0)
    figure.add_scatter(
        x=[None], y=[None], mode="lines", name="operating speed", line={"color": theme.GREEN, "width": 2}
    )


def _critical(figure: go.Figure, diagram: xr.Dataset, place: _Places) -> None:
    """Circles at critical speeds; the first ranks as numbers, with leader lines where circles are close."""
    ranked = [
        (str(rank), c)
        for rank, c in enumerate(ranked_speeds(diagram), start=1)
        if place.inside(c.speed, c.frequency)
    ]
    if not ranked:
        return
    room = WIDTH, ROOM
    points = np.array([[place.along(c.speed), place.across(c.frequency)] for _, c in ranked]) * room
    # ranks keep clear of all circles, also of those without a number
    first = sum(int(rank) <= NUMBERED for rank, _ in ranked)
    shown = around(points, RANK, room)[:first]
    texts, positions = [""] * len(ranked), ["top left"] * len(ranked)
    for k, way in enumerate(shown):
        if np.abs(way).max() <= RANK:
            texts[k], positions[k] = ranked[k][0], _beside(way)
            continue
        figure.add_annotation(
            x=ranked[k][1].speed * place.revolutions.factor,
            y=ranked[k][1].frequency * place.pitch.factor,
            ax=float(way[0]),
            ay=float(-way[1]),
            text=ranked[k][0],
            showarrow=True,
            arrowhead=0,
            arrowwidth=0.8,
            arrowcolor=theme.LIGHT["ink"],
            startstandoff=0,
            standoff=5,
            borderpad=0,
            font={"size": 11},
        )
    figure.add_scatter(
        x=[c.speed * place.revolutions.factor for _, c in ranked],
        y=[c.frequency * place.pitch.factor for _, c in ranked],
        mode="markers+text",
        name="critical speeds",
        text=texts,
        textposition=positions,
        textfont={"size": 11},
        marker={
            "color": theme.LIGHT["ink"],
            "size": [9 if k < first else 6 for k in range(len(ranked))],
            "symbol": "circle-open",
            "line": {"width": 1.5},
        },
        customdata=[
            f"{c.order} × {c.mode}<br>{c.source}, participation {number(100.0 * c.participation, 3)} %, "
            f"damping ratio {number(100.0 * c.damping_ratio, 3)} %"
            for _, c in ranked
        ],
        hovertemplate="%{customdata}<br>%{x:.5g}, %{y:.5g}<extra></extra>",
    )


def _beside(way: Array) -> str:
    """Position of a text in a direction, in words."""
    down = {1: "top", 0: "middle", -1: "bottom"}[int(np.sign(way[1]))]
    return f"{down} {({1: 'right', 0: 'center', -1: 'left'})[int(np.sign(way[0]))]}"


def _more_rows(figure: go.Figure) -> int:
    """Height of the legend beyond its first row [pixels]."""
    entries = [str(trace.name) for trace in figure.data if trace.showlegend is not False]
    column = SAMPLE + LETTER * max((len(text) for text in entries), default=0)  # all are equally wide
    return ROW * (math.ceil(len(entries) / max(1, int(WIDTH // column))) - 1)


def _at_the_right(figure: go.Figure, listed: Sequence[tuple[float, str, str]], place: _Places) -> int:
    """Names right of the plot, a line of text apart, with leader lines; returns the width of the margin."""
    if not listed:
        return 16
    names = [text for _, text, _ in listed]
    folded = [[_folded(text, letters) for text in names] for letters in LETTERS]
    lines = next((one for one in folded if sum(map(len, one)) * LINE <= ROOM), folded[-1])
    heights = [LINE * len(one) for one in lines]
    wanted = [ROOM * place.across(at) for at, _, _ in listed]
    found = spread(wanted, heights, 0.5 * max(heights), ROOM - 0.5 * max(heights))
    for (at, _, colour), text, own, shown in zip(listed, lines, wanted, found, strict=True):
        figure.add_annotation(
            x=1,
            xref="paper",
            y=at * place.pitch.factor,
            ax=LEADER,
            ay=float(own - shown),
            text="<br>".join(map(escape, text)),
            align="left",
            showarrow=True,
            arrowhead=0,
            arrowwidth=0.8,
            arrowcolor=colour,
            xanchor="left",
            yanchor="middle",
            standoff=0,
            font={"size": 11, "color": colour},
        )
    return int(LEADER + 12 + LETTER * max(len(line) for text in lines for line in text))


def _folded(name: str, letters: int) -> list[str]:
    """Lines of a name of at most so many letters, as few as possible and of similar length."""
    lines = wrap(name, letters, break_long_words=False)
    least = math.ceil(len(name) / len(lines))
    tried = (wrap(name, n, break_long_words=False) for n in range(least, letters))
    return next((one for one in tried if len(one) == len(lines)), lines)


def _above(figure: go.Figure, listed: Sequence[tuple[float, str]]) -> int:
    """Upright names above the plot, where lines leave it; returns the height that they need."""
    if not listed:
        return 0
    folded = [_folded(text, UPRIGHT) for _, text in listed]
    lengths = [LINE * len(lines) for lines in folded]
    found = spread([at * PAPER for at, _ in listed], lengths, 0.0, PAPER)
    for (at, _), lines, shown in zip(listed, folded, found, strict=True):
        where = {"x": at, "xref": "paper", "y": 1, "yref": "paper"}
        aside = float(shown - at * PAPER)
        line = {"arrowhead": 0, "arrowwidth": 0.8, "arrowcolor": theme.GREY, "standoff": 0}
        figure.add_annotation(**where, ax=aside, ay=-10, text="", showarrow=True, **line)
        figure.add_annotation(
            **where,
            xshift=aside,
            yshift=11,
            text="<br>".join(map(escape, lines)),
            textangle=-90,
            showarrow=False,
            xanchor="center",
            yanchor="bottom",
            font={"size": 11, "color": theme.LIGHT["soft"]},
        )
    return int(22 + LETTER * max(len(line) for lines in folded for line in lines))
