# SPDX-License-Identifier: Apache-2.0
"""Amplitude and phase over frequency."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.viz import theme
from pitchpoint.viz.quantities import channel_label, scale

if TYPE_CHECKING:
    import plotly.graph_objects as go

HEIGHT = 520
FORCES = {"f": "force", "m": "moment"}
"""Words of the components of a load."""


def plot_frequency_response(
    frequency: ArrayLike,
    response: ArrayLike,
    outputs: Sequence[str],
    inputs: Sequence[str],
    units: Sequence[str] = (),
) -> go.Figure:
    """Bode plot: amplitude on a logarithmic scale above, phase below; one curve per output and input.

    Parameters
    ----------
    frequency
        [Hz], shape (nf,).
    response
        Complex response per unit of the inputs, SI, shape (nf, no, ni).
    outputs, inputs
        Channels, and loads or excitations.
    units
        Units of the curves, output by output, input by input; "m/N" and the like.
    """
    hertz = np.asarray(frequency, dtype=np.float64)
    found = np.asarray(response, dtype=np.complex128)
    pitch = scale("Hz", hertz)
    different = sorted(set(units))
    title = f"amplitude [{different[0]}]" if len(different) == 1 else "amplitude [SI]"
    figure = theme.figure(pitch.title("frequency"), title, height=HEIGHT)
    for o, output in enumerate(outputs):
        for i, name in enumerate(inputs):
            k = o * len(inputs) + i
            line = {"color": theme.SERIES[k % len(theme.SERIES)], "width": 1.6}
            label = f"{channel_label(output)} by {input_label(name)}"
            x = hertz * pitch.factor
            figure.add_scatter(x=x, y=np.abs(found[:, o, i]), mode="lines", name=label, line=line)
            angle = np.degrees(np.angle(found[:, o, i]))
            figure.add_scatter(
                x=x, y=angle, mode="lines", name=label, line=line, yaxis="y2", showlegend=False
            )
    figure.update_layout(
        yaxis={"type": "log", "domain": [0.36, 1.0], "exponentformat": "power"},
        yaxis2={
            "domain": [0.0, 0.28],
            "range": [-185.0, 185.0],
            "tickvals": [-180, -90, 0, 90, 180],
            "title": {"text": "phase [deg]"},
        },
        xaxis={"anchor": "y2"},
        showlegend=True,
    )
    return figure


def input_label(name: str) -> str:
    """Readable name of an input: force or moment on a body; other names unchanged.

    Examples
    --------
    >>> input_label("rotor.2.fx"), input_label("shaft.mz"), input_label("transmission_error[stage]")
    ('force x, rotor.2', 'moment z, shaft', 'transmission error, stage')
    """
    body, _, component = name.rpartition(".")
    if body and "[" not in name and component[:1] in FORCES and component[1:] in ("x", "y", "z"):
        return f"{FORCES[component[0]]} {component[1:]}, {body}"
    return channel_label(name) if "[" in name else name


def curve_units(outputs: Sequence[str], inputs: Sequence[str]) -> list[str]:
    """Units of the curves of `plot_frequency_response`, from those of the outputs and inputs.

    Examples
    --------
    >>> curve_units(["m", "N"], ["N m"])
    ['m/(N m)', 'N/(N m)']
    """
    return [f"{o}/({i})" if " " in i else f"{o}/{i}" for o in outputs for i in inputs]
