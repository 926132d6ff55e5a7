# SPDX-License-Identifier: Apache-2.0
"""Response of a speed sweep over mesh frequency: up green, down red, with jumps and contact loss.

Plots of several meshes have a colour for each mesh: up solid, down dotted.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.analysis.jumps import branch, sweep_jumps
from pitchpoint.analysis.mesh_sweep import points_of_mesh, swept_meshes
from pitchpoint.viz import theme
from pitchpoint.viz.quantities import Array, Scale, channel_scale, number, scale
from pitchpoint.viz.sweep_meshes import mesh_names

if TYPE_CHECKING:
    import plotly.graph_objects as go

WORDS = {"magnitude": "maximum magnitude"}
"""Statistics in words, of those whose name is not one."""
LINE = 5e-3
"""Difference of two curves relative to the height of the plot that is within the width of a line."""
UNITS = {"mesh_force": "N"}  # of the quantities of a sweep; all others are lengths along the line of action


def plot_sweep(
    points: Sequence[Mapping[str, Any]],
    jumps: Sequence[Mapping[str, Any]] = (),
    *,
    quantity: str = "deflection",
    statistic: str = "rms",
    mesh: str = "",
    swept: str = "",
) -> go.Figure:
    """Plot of one statistic of one quantity along a sweep.

    Parameters
    ----------
    points
        Points in the order of computation: `direction`, `mesh_frequency` [Hz] and, under `quantity`, its
        statistics in SI.
    jumps
        `direction` and `mesh_frequency` [Hz] of each jump.
    quantity, statistic
        Plotted data: `deflection`, `transmission_error`, `mesh_force`; `rms`, `min`, `max`, `mean`, of mesh
        forces also `magnitude` (`analysis.mesh_sweep.points_of_mesh`).
    mesh, swept
        Name of the mesh, and of the swept mesh, whose frequency is that of the axis; of one of several.
    """
    branches = {d: branch(points, d, quantity, statistic) for d in theme.SWEEP}
    levels = np.concatenate([level for _, level in branches.values()])
    pitch = scale("Hz", np.concatenate([f for f, _ in branches.values()]))
    shown = channel_scale(quantity, UNITS.get(quantity, "m"), levels)
    title = f"{WORDS.get(statistic, statistic)} of {quantity.replace('_', ' ')}{f', {mesh}' if mesh else ''}"
    figure = theme.figure(pitch.title(frequency_words(swept)), shown.title(title), height=400)
    for direction, (colour, symbol) in theme.SWEEP.items():
        frequency, level = branches[direction]
        if frequency.size:
            figure.add_scatter(
                x=frequency * pitch.factor,
                y=level * shown.factor,
                mode="lines+markers",
                name=f"speed {direction}",
                line={"color": colour, "width": 1.6},
                marker={"symbol": symbol, "size": 6},
            )
    _mark_jumps(figure, branches, jumps, pitch.factor, shown.factor)
    if levels.size:
        figure.update_xaxes(range=_padded(np.concatenate([f for f, _ in branches.values()]), pitch.factor))
    figure.update_yaxes(rangemode="tozero" if statistic in ("rms", "magnitude") else "normal")
    figure.update_layout(showlegend=True)
    return figure


@dataclass(frozen=True)
class _Curves:
    """Title, unit and values of a quantity of several meshes, by the name of its plot."""

    title: str
    unit: str
    quantity: str
    statistic: str = ""


OF_MESHES = {
    "deflection": _Curves("rms of deflection", "m", "deflection", "rms"),
    "mesh_force": _Curves("maximum magnitude of mesh force", "N", "mesh_force", "magnitude"),
    "contact_shares": _Curves("time without contact", "%", "contact_loss_share"),
    "closing_speed_max": _Curves("maximum closing speed", "m/s", "closing_speed_max"),
}
"""Plots of several meshes."""


def plot_meshes(
    points: Sequence[Mapping[str, Any]], name: str, *, mesh: str = "", swept: str = ""
) -> tuple[go.Figure, str]:
    """Plot of one quantity of all meshes along a sweep, and a sentence on meshes that are not drawn.

    Meshes with equal curves, as of planets, have one curve. If there are more curves than colours, those of
    the swept mesh and of the meshes with the largest values are drawn. A single mesh has the colours of the
    directions.

    Parameters
    ----------
    points
        Points in the order of computation, with `meshes`.
    name
        One of `OF_MESHES`.
    mesh, swept
        Names as in `plot_sweep`, of the points of a single mesh.
    """
    what = OF_MESHES[name]
    curves: list[tuple[list[str], dict[str, tuple[Array, Array]]]] = []
    found = {owner: _both(points_of_mesh(points, owner), what) for owner in swept_meshes(points)}
    top = max((float(y.max()) for own in found.values() for _, y in own.values()), default=0.0)
    for owner, own in found.items():
        same = next((names for names, one in curves if _equal(one, own, LINE * top)), None)
        if same is not None:
            same.append(owner)
        elif own:
            curves.append(([owner], own))
    pitch = scale("Hz", [float(p["mesh_frequency"]) for p in points])
    share = what.unit == "%"
    shown = Scale("%", 100.0) if share else channel_scale(what.quantity, what.unit, np.array([top]))
    single = len(found) == 1
    words = frequency_words(swept if single else next(iter(found)))
    title = shown.title(f"{what.title}{f', {mesh}' if mesh else ''}")
    # the long titles and legends need their height, also on paper
    figure = theme.figure(pitch.title(words), title, height=400, meta={"whole": True})
    order = sorted(range(1, len(curves)), key=lambda k: -max(y.max() for _, y in curves[k][1].values()))
    drawn = sorted([0, *order][: len(theme.SERIES)]) if curves else []
    for colour, k in zip(theme.SERIES, drawn, strict=False):
        names, own = curves[k]
        for direction, (frequency, level) in own.items():
            dash = "solid" if direction == "up" or single else "dot"
            line = {"color": theme.SWEEP[direction][0] if single else colour, "width": 1.6, "dash": dash}
            name = f"speed {direction}" if single else f"{mesh_names(names)}, {direction}"
            figure.add_scatter(
                x=frequency * pitch.factor, y=level * shown.factor, mode="lines", name=name, line=line
            )
    if points:
        figure.update_xaxes(range=_padded([float(p["mesh_frequency"]) for p in points], pitch.factor))
    figure.update_yaxes(rangemode="tozero")
    figure.update_layout(showlegend=True)
    left = sum(len(names) for k, (names, _) in enumerate(curves) if k not in drawn)
    return figure, f"{left} more meshes with smaller values are not drawn." if left else ""


def _both(points: Sequence[Mapping[str, Any]], what: _Curves) -> dict[str, tuple[Array, Array]]:
    """Mesh frequencies [Hz] and values of one mesh, by direction."""
    key = what.statistic or "value"
    known = [p for p in points if p.get(what.quantity) is not None]
    if not what.statistic:  # a single number
        known = [{**p, what.quantity: {key: p[what.quantity]}} for p in known]
    lines = {direction: branch(known, direction, what.quantity, key) for direction in theme.SWEEP}
    return {direction: line for direction, line in lines.items() if line[0].size}


def _equal(
    one: Mapping[str, tuple[Array, Array]], other: Mapping[str, tuple[Array, Array]], limit: float
) -> bool:
    """Whether the curves of two meshes differ by less than a limit in both directions."""
    return one.keys() == other.keys() and all(
        y.shape == other[d][1].shape and bool(np.all(np.abs(y - other[d][1]) <= limit))
        for d, (_, y) in one.items()
    )


def plots_of_each(
    points: Sequence[Mapping[str, Any]], jumps: Sequence[Mapping[str, Any]]
) -> dict[str, go.Figure]:
    """Plots of every single mesh of a sweep, by the name of the plot with the mesh in brackets.

    Parameters
    ----------
    points, jumps
        See `plot_sweep`; the jumps are those of the swept mesh.
    """
    found: dict[str, go.Figure] = {}
    meshes = swept_meshes(points)
    for k, mesh in enumerate(meshes):
        names = {"mesh": mesh, "swept": meshes[0]} if len(meshes) > 1 else {}
        own = points_of_mesh(points, mesh)
        here = [vars(j) | {"mesh_frequency": j.frequency} for j in sweep_jumps(own)] if k else jumps
        for name in ("deflection", "mesh_force"):
            statistic = OF_MESHES[name].statistic
            found[f"{name}[{mesh}]"] = plot_sweep(own, here, quantity=name, statistic=statistic, **names)
        if any(p.get("contact_loss_share") is not None for p in own):
            found[f"contact_shares[{mesh}]"] = plot_contact_shares(own, **names)
        if any(p.get("closing_speed_max") is not None for p in own):
            found[f"closing_speed_max[{mesh}]"] = plot_meshes(own, "closing_speed_max", **names)[0]
    return found


def frequency_words(swept: str = "") -> str:
    """Words of the frequency axis, with the name of the swept mesh of several."""
    return f"mesh frequency of {swept}" if swept else "mesh frequency"


def plot_contact_shares(points: Sequence[Mapping[str, Any]], *, mesh: str = "", swept: str = "") -> go.Figure:
    """Plot of the shares of time without contact and with contact on the back flank, along a sweep.

    `mesh` and `swept`: names as in `plot_sweep`.
    """
    all_frequencies = [float(p["mesh_frequency"]) for p in points]
    pitch = scale("Hz", all_frequencies)
    title = f"share of time{f', {mesh}' if mesh else ''} [%]"
    figure = theme.figure(pitch.title(frequency_words(swept)), title, height=300)
    words = {"contact_loss_share": ("contact loss", "solid"), "back_contact_share": ("back contact", "dot")}
    for key, (name, dash) in words.items():
        for direction, (colour, _) in theme.SWEEP.items():
            rows = [
                (float(p["mesh_frequency"]) * pitch.factor, 100.0 * float(p[key]))
                for p in points
                if p["direction"] == direction and p.get(key) is not None
            ]
            # back flanks without contact would only add a flat line and a legend entry
            if rows and (key == "contact_loss_share" or any(share > 0.0 for _, share in rows)):
                x, y = zip(*rows, strict=True)
                figure.add_scatter(
                    x=x,
                    y=y,
                    mode="lines",
                    name=f"{name}, {direction}",
                    line={"color": colour, "width": 1.6, "dash": dash},
                )
    if all_frequencies:
        figure.update_xaxes(range=_padded(all_frequencies, pitch.factor))
    figure.update_yaxes(rangemode="tozero")
    figure.update_layout(showlegend=True)
    return figure


def _padded(frequencies: Sequence[float] | np.ndarray, factor: float) -> list[float]:
    """Set a common horizontal range for all plots of one sweep."""
    low, high = float(np.min(frequencies)) * factor, float(np.max(frequencies)) * factor
    room = 0.03 * (high - low) or 0.05 * abs(high) or 1.0
    return [low - room, high + room]


def _mark_jumps(
    figure: go.Figure,
    branches: Mapping[str, tuple[np.ndarray, np.ndarray]],
    jumps: Sequence[Mapping[str, Any]],
    x_factor: float,
    y_factor: float,
) -> None:
    """Draw an arrow from the old to the new level with the frequency, in the colour of the direction."""
    for jump in jumps:
        direction, middle = str(jump["direction"]), float(jump["mesh_frequency"])
        frequency, level = branches[direction]
        if frequency.size < 2:
            continue
        forward = frequency if frequency[-1] > frequency[0] else -frequency
        after = int(
            np.clip(
                np.searchsorted(forward, middle if frequency[-1] > frequency[0] else -middle),
                1,
                level.size - 1,
            )
        )
        colour = theme.SWEEP[direction][0]
        low, high = level[after - 1] * y_factor, level[after] * y_factor
        figure.add_annotation(
            x=middle * x_factor,
            y=high,
            ax=middle * x_factor,
            ay=low,
            axref="x",
            ayref="y",
            text="",
            showarrow=True,
            arrowhead=2,
            arrowsize=1.2,
            arrowwidth=1.8,
            arrowcolor=colour,
        )
        figure.add_annotation(
            x=middle * x_factor,
            y=max(low, high),
            text=number(middle * x_factor),
            showarrow=False,
            yshift=10,
            xanchor="right" if direction == "down" else "left",
            font={"size": 11, "color": colour},
        )
