# SPDX-License-Identifier: Apache-2.0
"""Plots for the results of the tools of `analyse`."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.analysis.orders import OrderMap
from pitchpoint.analysis.spectra import Spectrum
from pitchpoint.analysis.time_frequency import TimeFrequencyMap
from pitchpoint.viz import (
    coherence_plot,
    kurtogram_plot,
    period_plot,
    prominence_plot,
    spectrum_plots,
    wavelet_plots,
)
from pitchpoint.viz.quantities import Channel
from pitchpoint.viz.signals_plot import plot_signals

if TYPE_CHECKING:
    import plotly.graph_objects as go
    import xarray as xr


def spectrum_of(result: xr.Dataset, axis: str) -> Spectrum:
    """Spectrum dataclass from its dataset; `axis` is `frequency` or `order`."""
    return Spectrum(
        frequency=result[axis].values,
        amplitude=result["amplitude"].values,
        mean=float(result["mean"]),
        resolution=float(result["resolution"]),
        noise_bandwidth=float(result["noise_bandwidth"]),
    )


def _spectrum(result: xr.Dataset, channel: str, over: str = "frequency") -> list[go.Figure]:
    spectra = {channel: spectrum_of(result, over)}
    return [spectrum_plots.plot_spectrum(spectra, unit=_unit(result), over=over)]


def _order_spectrum(result: xr.Dataset, channel: str) -> list[go.Figure]:
    return _spectrum(result, channel, "order")


def _order_map(result: xr.Dataset, channel: str) -> list[go.Figure]:
    data = OrderMap(**{str(name): result[name].values for name in result.variables})
    return [spectrum_plots.plot_order_map(data, unit=_unit(result), quantity=channel)]


def _time_frequency(result: xr.Dataset, channel: str) -> list[go.Figure]:
    data = TimeFrequencyMap(**{str(name): result[name].values for name in result.variables})
    return [spectrum_plots.plot_time_frequency(data, unit=_unit(result), quantity=channel)]


def _tones(result: xr.Dataset, channel: str) -> list[go.Figure]:
    parts = (result[name].values for name in ("frequency", "amplitude", "background"))
    return [spectrum_plots.plot_tones(*parts, unit=_unit(result), name=channel)]


def _gear_signals(result: xr.Dataset, channel: str) -> list[go.Figure]:
    """Synchronous average, residual and difference signal (as in FM4) over one angle axis."""
    unit = str(result["residual"].attrs["units"])
    regular, residual = result["regular"].values, result["residual"].values
    rows = {
        f"average less its mean, {channel}": regular + residual,
        "residual: without mesh and lowest orders": residual,
        "difference: also without the first sidebands": result["difference"].values,
    }
    parts = [Channel(name, values, unit) for name, values in rows.items()]
    figure = plot_signals(result["angle"].values, parts, rows=[[k] for k in range(len(parts))], over="angle")
    # common scale: a difference signal scaled up to the residual would look like damage
    limit = 1.05 * max(float(np.abs(trace.y).max()) for trace in figure.data[1:])
    figure.update_layout({axis: {"range": [-limit, limit]} for axis in ("yaxis2", "yaxis3")})
    figure.update_xaxes(range=[0.0, 360.0], dtick=45)
    return [figure]


def _unit(result: xr.Dataset) -> str:
    return str(result["amplitude"].attrs["units"])


PICTURES: dict[str, Callable[[xr.Dataset, str], list[go.Figure]]] = {
    "spectrum": _spectrum,
    "order_spectrum": _order_spectrum,
    "order_map": _order_map,
    "time_frequency": _time_frequency,
    "tones": _tones,
    "gear_signals": _gear_signals,
    "wavelet_levels": wavelet_plots.plot_levels,
    "wavelet_packets": wavelet_plots.plot_packets,
    "scalogram": wavelet_plots.plot_scalogram,
    "kurtogram": kurtogram_plot.plot_kurtogram,
    "line_prominence": prominence_plot.plot_line_prominence,
    "order_prominence": prominence_plot.plot_order_prominence,
    "spectral_coherence": coherence_plot.plot_spectral_coherence,
    "find_period": period_plot.plot_search,
    "period_evidence": period_plot.plot_evidence,
}
"""Functions that plot the result of one channel, by `Tool.picture`."""
