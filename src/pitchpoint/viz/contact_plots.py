# SPDX-License-Identifier: Apache-2.0
"""Plots of a contact analysis: contact pattern, path, face width, torque."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.flank_contact.contact_pattern import (
    ContactField,
    ContactPattern,
    on_flank,
    on_path,
)
from pitchpoint.analysis.flank_contact.teeth import MARKS, MeshTeeth, diameter_at
from pitchpoint.viz import theme
from pitchpoint.viz.mesh_cycle_plot import repeated
from pitchpoint.viz.quantities import Array, Scale, number, scale

if TYPE_CHECKING:
    import plotly.graph_objects as go

FIELDS = {
    "pressure": ("pressure", "Pa"),
    "any_pressure": ("pressure", "Pa"),
    "line_load": ("line load", "N/m"),
}
"""Fields of a contact pattern: name and unit."""
LINE_LOAD = Scale("N/mm", 1e-3)
"""Loads per width; channels in N/m are stiffnesses elsewhere."""
HEIGHT, MARGINS, TEXT_HEIGHT = 420, 90, 15
"""Height of a pattern, its margins, and a line of text [pixels]."""
HALO = 0.04
"""Space around the range of contact, as a share of it."""


def plot_path_pattern(pattern: ContactPattern, name: str) -> go.Figure:
    """Map of a field of one tooth pair over face width and position on the path of contact.

    The position is the roll angle of gear 1 on the line of action; it continues before A and beyond E, where
    tip edges are in contact.

    Parameters
    ----------
    pattern
        Contact pattern of one tooth pair.
    name
        Field: `pressure`, `any_pressure` (tip edges included) or `line_load`.
    """
    field, teeth = on_path(pattern, name), pattern.teeth
    roll = teeth.mark_roll[0, 0] + teeth.base_pitch * field.place
    return _map(field, roll, name, teeth, 1, "roll angle of gear 1 on the path [°]")


def plot_flank_pattern(pattern: ContactPattern, name: str, gear: int = 1) -> go.Figure:
    """Map of a field on the flank of one gear over face width and roll angle: maxima during contact.

    Parameters
    ----------
    pattern
        Contact pattern of one tooth pair.
    name
        Field: `pressure`, `any_pressure` (tip edges included) or `line_load`.
    gear
        1 or 2.
    """
    field = on_flank(pattern, name, gear)
    return _map(field, field.place, name, pattern.teeth, gear, f"roll angle of gear {gear} [°]")


def _map(
    field: ContactField, roll: Array, name: str, teeth: MeshTeeth, gear: int, vertical: str
) -> go.Figure:
    """Map over face width and roll angle, with diameters at A to E."""
    words, unit = FIELDS[name]
    shown = LINE_LOAD if unit == "N/m" else scale(unit, field.values)
    edges = np.append(teeth.z - 0.5 * teeth.width, teeth.z[-1] + 0.5 * teeth.width[-1])
    across = scale("m", edges)
    angle = np.degrees(roll / teeth.base_radius[gear - 1])
    figure = theme.figure(across.title("face width z"), vertical, height=HEIGHT)
    most = float(np.nanmax(field.values)) if np.isfinite(field.values).any() else 1.0
    figure.add_heatmap(
        x=(edges * across.factor).astype(np.float32),
        y=angle.astype(np.float32),
        z=(field.values * shown.factor).astype(np.float32),
        zmin=0.0,
        zmax=most * shown.factor,
        colorscale=theme.MAP_SCALE,
        colorbar={
            "title": {"text": shown.title(words), "side": "right"},
            "thickness": 12,
            "outlinewidth": 0,
            "x": 1.0,
            "xpad": 116,  # diameters at two marks that coincide
        },
        hovertemplate="z %{x:.4g}, roll angle %{y:.4g}°: %{z:.5g}<extra></extra>",
    )
    _mark_diameters(figure, teeth, gear, (float(angle[0]), float(angle[-1])))
    figure.update_xaxes(showgrid=False, zeroline=False)
    figure.update_yaxes(showgrid=False, zeroline=False)
    return figure


def _mark_diameters(figure: go.Figure, teeth: MeshTeeth, gear: int, ends: tuple[float, float]) -> None:
    """Lines at A to E, and a second axis with their diameters."""
    base = float(teeth.base_radius[gear - 1])
    rolls = teeth.mark_roll[gear - 1]
    places = {mark: float(np.degrees(roll / base)) for mark, roll in zip(MARKS, rolls, strict=True)}
    halo = HALO * (ends[1] - ends[0])
    low, high = ends[0] - halo, ends[1] + halo
    closest = TEXT_HEIGHT / (HEIGHT - MARGINS) * (high - low)
    ticks: list[tuple[float, list[str]]] = []
    for mark, place in sorted(places.items(), key=lambda item: item[1]):
        figure.add_hline(y=place, line={"color": theme.GREY, "dash": "dot", "width": 1})
        if ticks and place - ticks[-1][0] < closest:
            ticks[-1][1].append(mark)
        else:
            ticks.append((place, [mark]))
    rings = [float(diameter_at(np.radians(place) * base, base)) for place, _ in ticks]
    texts = [f"{', '.join(marks)}  {1e3 * d:.2f}" for (_, marks), d in zip(ticks, rings, strict=True)]
    figure.add_scatter(x=[None], y=[None], yaxis="y2", showlegend=False, hoverinfo="skip")
    figure.update_layout(
        yaxis={"range": [low, high]},
        yaxis2=theme.axis(
            "diameter [mm]",
            side="right",
            overlaying="y",
            range=[low, high],
            tickvals=[place for place, _ in ticks],
            ticktext=texts,
        ),
    )


def plot_along_path(
    curves: Mapping[str, tuple[ArrayLike, ArrayLike]],
    teeth: MeshTeeth,
    title: str,
    unit: str = "1",
    *,
    of_pair: bool = True,
) -> go.Figure:
    """Curves along the path of contact, with A to E.

    Parameters
    ----------
    curves
        Positions [base pitches from A] and values in SI by name; drawn from the first to the last that is not
        zero.
    teeth
        Geometry of the mesh.
    title
        Name of the vertical axis.
    unit
        SI unit of the values; "%" for shares.
    of_pair
        Whether the position is that of a tooth pair in the middle of the face, or of each contact.
    """
    data = {name: np.asarray(values, dtype=np.float64) for name, (_, values) in curves.items()}
    every = np.concatenate([*data.values(), np.zeros(1)])
    shown = scale(unit, every) if unit != "%" else None
    factor = shown.factor if shown else 100.0
    figure = theme.figure(
        f"position {'of the tooth pair' if of_pair else 'on the path'} from A [base pitches]",
        shown.title(title) if shown else f"{title} [%]",
        height=360,
        margin={"t": 52},
        legend={"y": 1.08},
    )
    for k, (name, (way, _)) in enumerate(curves.items()):
        figure.add_scatter(
            x=np.asarray(way, dtype=np.float64),
            y=data[name] * factor,
            mode="lines",
            name=name,
            connectgaps=False,
            line={"color": theme.SERIES[k % len(theme.SERIES)], "width": 2, "simplify": False},
        )
    top = float(np.nanmax(every)) * factor
    figure.update_yaxes(range=[0.0, 1.06 * top if top > 0.0 else 1.0])
    ways = [np.asarray(way)[np.nan_to_num(data[name]) != 0.0] for name, (way, _) in curves.items()]
    drawn = np.concatenate([*ways, [0.0, teeth.eps_alpha]])
    edge = 0.03 * float(np.ptp(drawn))
    figure.update_xaxes(range=[float(drawn.min()) - edge, float(drawn.max()) + edge])
    mark_path(figure, teeth)
    figure.update_layout(showlegend=len(curves) > 1)
    return figure


def mark_path(figure: go.Figure, teeth: MeshTeeth) -> None:
    """Vertical lines at A to E over positions in base pitches, with letters above the plot."""
    places = (teeth.mark_roll[0] - teeth.mark_roll[0, 0]) / teeth.base_pitch
    closest = 0.02 * (teeth.eps_alpha + 1.0)
    labels: list[tuple[float, list[str]]] = []
    for place, mark in sorted(zip(places.tolist(), MARKS, strict=True)):
        figure.add_vline(x=place, line={"color": theme.GREY, "dash": "dot", "width": 1})
        if labels and place - labels[-1][0] < closest:
            labels[-1][1].append(mark)
        else:
            labels.append((place, [mark]))
    for place, marks in labels:
        figure.add_annotation(
            x=place, y=1, yref="paper", text=", ".join(marks), showarrow=False, yanchor="bottom", yshift=1
        )


def plot_load_over_width(z: ArrayLike, loads: Mapping[str, ArrayLike], width: ArrayLike) -> go.Figure:
    """Plot of the line load integrated over the profile, over the face width, as steps of the planes.

    Parameters
    ----------
    z, width
        Middles and widths of the contact planes [m], shape (n_plane,).
    loads
        Line loads [N/m], shape (n_plane,), by load case.
    """
    middle, plane = np.asarray(z, dtype=np.float64), np.asarray(width, dtype=np.float64)
    edges = np.append(middle - 0.5 * plane, middle[-1] + 0.5 * plane[-1])
    data = {name: np.asarray(values, dtype=np.float64) for name, values in loads.items()}
    shown, across = LINE_LOAD, scale("m", edges)
    figure = theme.figure(across.title("face width z"), shown.title("line load over the width"), height=340)
    for k, (name, values) in enumerate(data.items()):
        figure.add_scatter(
            x=np.repeat(edges, 2)[1:-1] * across.factor,
            y=np.repeat(values, 2) * shown.factor,
            mode="lines",
            name=name,
            line={"color": theme.SERIES[k % len(theme.SERIES)], "width": 2},
        )
    figure.update_yaxes(rangemode="tozero")
    figure.update_layout(showlegend=len(data) > 1)
    return figure


def plot_relative_loads(meshes: Mapping[str, tuple[ArrayLike, ArrayLike, ArrayLike]]) -> go.Figure:
    """Plot of line loads over their means, over the relative face width, of several meshes.

    Parameters
    ----------
    meshes
        Middles of the contact planes [m], line loads [N/m] and widths of the planes [m], each of shape
        (n_plane,), by mesh.
    """
    figure = theme.figure("position over the common face width [%]", "line load over its mean", height=340)
    for k, (name, parts) in enumerate(meshes.items()):
        middle, load, width = (np.asarray(values, dtype=np.float64) for values in parts)
        edges = np.append(middle - 0.5 * width, middle[-1] + 0.5 * width[-1])
        place = 100.0 * (edges - edges[0]) / (edges[-1] - edges[0])
        figure.add_scatter(
            x=np.repeat(place, 2)[1:-1],
            y=np.repeat(load / load.mean(), 2),
            mode="lines",
            name=name,
            line={"color": theme.SERIES[k % len(theme.SERIES)], "width": 2},
        )
    figure.update_yaxes(rangemode="tozero")
    return figure


def plot_stiffness(phase: ArrayLike, tangent: ArrayLike, secant: ArrayLike) -> go.Figure:
    """Plot of tangent and secant stiffness over two mesh cycles, with their means in the legend.

    Parameters
    ----------
    phase
        Mesh phases over one cycle [base pitches], shape (n,), without the repeated end.
    tangent, secant
        Derivative of the mesh force, and force over approach [N/m], shape (n,).
    """
    data = {
        "tangent": np.asarray(tangent, dtype=np.float64),
        "secant": np.asarray(secant, dtype=np.float64),
    }
    shown = scale("N/m", np.concatenate([*data.values()]))
    figure = theme.figure("mesh phase ψ [base pitches]", shown.title("mesh stiffness"), height=340)
    for k, (name, values) in enumerate(data.items()):
        x, y = repeated(phase, values, 2)
        figure.add_scatter(
            x=x,
            y=y * shown.factor,
            mode="lines",
            name=f"{name} (mean {shown.text(float(values.mean()))})",
            line={"color": theme.SERIES[k], "width": 2, "simplify": False},
        )
    figure.update_yaxes(rangemode="tozero")
    figure.update_xaxes(range=[0.0, 2.0])
    return figure


def plot_harris_map(torque: ArrayLike, error: ArrayLike, orders: ArrayLike) -> go.Figure:
    """Plot of the transmission error over torque: peak to peak, and amplitudes of the mesh orders.

    Parameters
    ----------
    torque
        Torques on gear 1 [N m], shape (n,).
    error
        Transmission error from minimum to maximum [m], shape (n,).
    orders
        Amplitudes of the mesh orders [m], shape (n, n_order).
    """
    load, most, lines = (np.asarray(x, dtype=np.float64) for x in (torque, error, orders))
    order = np.argsort(load, kind="stable")
    across, shown = scale("N m", load), scale("m", most)
    figure = theme.figure(across.title("torque on gear 1"), shown.title("transmission error"), height=360)
    curves: Sequence[tuple[str, Array]] = [
        ("peak to peak", most),
        *((f"order {number(k + 1)}", lines[:, k]) for k in range(min(lines.shape[1], 3))),
    ]
    for k, (name, values) in enumerate(curves):
        figure.add_scatter(
            x=load[order] * across.factor,
            y=values[order] * shown.factor,
            mode="lines+markers",
            name=name,
            line={"color": theme.SERIES[k % len(theme.SERIES)], "width": 2},
        )
    figure.update_xaxes(rangemode="tozero")
    figure.update_yaxes(rangemode="tozero")
    return figure
