# SPDX-License-Identifier: Apache-2.0
"""Signal and its wavelet levels over time, one row each."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.viz.quantities import Array, Channel, number
from pitchpoint.viz.signals_plot import plot_signals

if TYPE_CHECKING:
    import plotly.graph_objects as go

    from pitchpoint.analysis.wavelets import WaveletLevels


def plot_signal_and_levels(
    time: Array, values: Array, levels: WaveletLevels, *, unit: str, name: str = "S"
) -> go.Figure:
    """Plot of a signal, its approximation and its details from low to high frequency.

    Parameters
    ----------
    time
        Times [s], shape (n,).
    values
        The signal, shape (n,).
    levels
        Result of `wavelet_levels`.
    unit
        SI unit of the signal.
    name
        Name of the signal.
    """
    rows = [Channel(name, values, unit)]
    for level, signal, (low, high) in zip(levels.names, levels.signals, levels.band, strict=True):
        band = f"{level}: {number(float(low), 4)} to {number(float(high), 4)} Hz"
        rows.append(Channel(band, signal, unit))
    return plot_signals(time, rows, rows=[[k] for k in range(len(rows))], points=3000)
