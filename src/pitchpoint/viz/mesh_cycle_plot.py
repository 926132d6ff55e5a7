# SPDX-License-Identifier: Apache-2.0
"""Mesh stiffness and transmission error over one mesh cycle."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.viz import theme
from pitchpoint.viz.quantities import number, scale

if TYPE_CHECKING:
    import plotly.graph_objects as go

LOW: dict[str, Any] = {"height": 340, "meta": {"low": True}}
"""Height of the plots; on paper those of a mesh share a page."""
ROUND_OFF = 1e-9
"""Transmission errors below this are round-off [m]."""


def plot_mesh_stiffness(
    cycle: Any,
    *,
    name: str = "",
    unit: str = "c′·b",
    reference: float | None = None,
    loaded: tuple[ArrayLike, ArrayLike] | None = None,
    cycles: int = 2,
) -> go.Figure:
    """Plot of the stiffness over mesh cycles, with its mean.

    Parameters
    ----------
    cycle
        Anything with `phase` and `stiffness_ratio`, shape (n,) over one base pitch, and `mean`, `minimum`,
        `maximum`.
    name
        Name of the mesh, for the legend.
    unit
        Reference of the ratio: c′·b for tooth pair laws, the mean for prescribed stiffness.
    reference
        Value of the reference [N/m]: the stiffness itself is drawn; None: the ratio.
    loaded
        Phases and slopes of the force under load, in the same unit, if they differ from the law; a single
        cycle is repeated like that of the law.
    cycles
        Number of cycles drawn.
    """
    factor = 1.0
    if reference is not None:
        shown = scale("N/m", [reference * float(cycle.maximum)])
        factor, unit = reference * shown.factor, shown.unit
    phase, ratio = repeated(cycle.phase, factor * np.asarray(cycle.stiffness_ratio, dtype=float), cycles)
    mean, low, high = (factor * float(x) for x in (cycle.mean, cycle.minimum, cycle.maximum))
    figure = theme.figure("mesh phase ψ [base pitches]", f"mesh stiffness [{unit}]", **LOW)
    figure.add_scatter(
        x=phase,
        y=ratio,
        mode="lines",
        name=name or "stiffness",
        line={"color": theme.SERIES[0], "width": 2, "simplify": False},
    )
    if loaded is not None:
        under = factor * np.asarray(loaded[1], dtype=float)
        low, high = min(low, float(under.min())), max(high, float(under.max()))
        x, y = repeated(loaded[0], under, cycles)
        figure.add_scatter(x=x, y=y, mode="lines", name="under load", line={"color": theme.RED, "width": 2})
    figure.add_hline(y=mean, line={"color": theme.GREY, "dash": "dash", "width": 1})
    figure.add_scatter(
        x=[None],
        y=[None],
        mode="lines",
        line={"color": theme.GREY, "dash": "dash", "width": 1},
        name=f"mean {number(mean)}" + (f" {unit}" if reference is not None else ""),
    )
    margin = max(0.08 * (high - low), 0.02 * abs(mean))
    figure.update_yaxes(range=[low - margin, high + margin])
    figure.update_xaxes(range=[0.0, cycles])
    return figure


def plot_transmission_error(
    phase: ArrayLike,
    errors: Mapping[str, ArrayLike],
    *,
    cycles: int = 2,
    title: str = "mesh phase ψ [base pitches]",
) -> go.Figure:
    """Plot of the transmission error over mesh cycles about its mean, one line per load case.

    The means (half the backlash and the deflection under load) are many times larger than the variation that
    excites vibration; they are given in the legend.

    Parameters
    ----------
    phase
        Mesh phase [base pitches], shape (n,).
    errors
        Transmission error along the line of action [m], shape (n,) each, by the name of the load case.
    cycles
        Number of cycles drawn: a single cycle is repeated, longer curves are drawn unchanged.
    title
        Title of the horizontal axis.
    """
    data = {name: np.asarray(values, dtype=np.float64) for name, values in errors.items()}
    means = {name: float(values.mean()) if values.size else 0.0 for name, values in data.items()}
    means = {name: mean if abs(mean) > ROUND_OFF else 0.0 for name, mean in means.items()}
    sizes = [np.atleast_1d(v - means[name]) for name, v in data.items()]
    shown = scale("m", np.concatenate([*sizes, [ROUND_OFF]]))
    figure = theme.figure(title, shown.title("transmission error<br>− mean"), **LOW)
    for index, (name, values) in enumerate(data.items()):
        x, y = repeated(phase, values - means[name], cycles)
        whole = scale("m", [means[name]]) if means[name] else shown
        figure.add_scatter(
            x=x,
            y=y * shown.factor,
            mode="lines",
            name=f"{name} (mean {whole.text(means[name])})",
            line={"color": theme.SERIES[index % len(theme.SERIES)], "width": 2, "simplify": False},
        )
    figure.update_layout(showlegend=True)
    # round-off would fill the plot
    if max((float(np.abs(v).max()) for v in sizes if v.size), default=0.0) < ROUND_OFF:
        figure.update_yaxes(range=[-ROUND_OFF * shown.factor, ROUND_OFF * shown.factor])
    return figure


def plot_load_sharing(way: ArrayLike, share: ArrayLike) -> go.Figure:
    """Plot of the load share of one tooth pair, from its first to its last contact.

    Parameters
    ----------
    way
        Travel since the start of contact at mid-face [base pitches], shape (n,); negative for helical teeth
        that touch earlier.
    share
        Load share, shape (n,).
    """
    figure = theme.figure(
        "travel of a tooth pair from the start of contact at mid-face [base pitches]",
        "load share [%]",
        **LOW,
    )
    figure.add_scatter(
        x=np.asarray(way, dtype=np.float64),
        y=100.0 * np.asarray(share, dtype=np.float64),
        mode="lines",
        line={"color": theme.SERIES[0], "width": 2, "simplify": False},
    )
    figure.update_yaxes(range=[0.0, 105.0])
    return figure


def repeated(phase: ArrayLike, values: ArrayLike, cycles: int = 2) -> tuple[np.ndarray, np.ndarray]:
    """Curve over whole cycles from one cycle, with its end; longer curves unchanged.

    Parameters
    ----------
    phase
        Mesh phases over one cycle [base pitches], shape (n,), with or without the repeated end.
    values
        Curve, shape (n,).
    cycles
        Number of cycles.

    Examples
    --------
    >>> repeated([0.0, 0.5], [1.0, 2.0])[0].tolist()
    [0.0, 0.5, 1.0, 1.5, 2.0]
    """
    x, y = np.asarray(phase, dtype=np.float64), np.asarray(values, dtype=np.float64)
    if x.size == 0 or x[-1] - x[0] > 1.5:
        return x, y
    if x.size > 1 and np.isclose(x[-1] - x[0], 1.0):
        x, y = x[:-1], y[:-1]
    ways = [*(x + k for k in range(cycles)), x[:1] + cycles]
    return np.concatenate(ways), np.concatenate([*([y] * cycles), y[:1]])
