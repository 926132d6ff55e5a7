# SPDX-License-Identifier: Apache-2.0
"""`show`: plot or drawing of a gear, a pair, a model, a mesh cycle, a map or a result."""

from __future__ import annotations

from typing import Any

from pitchpoint.core.errors import PitchpointError


class Picture:
    """HTML or SVG for display in Jupyter or as a file."""

    def __init__(self, html: str) -> None:
        self.html = html

    def _repr_html_(self) -> str:
        return self.html

    def save(self, path: str) -> None:
        """Write the picture to a file for a browser."""
        from pathlib import Path

        # a single SVG is a complete file; other content requires an HTML page
        bare = self.html.startswith("<svg")
        text = self.html if bare else f'<!DOCTYPE html><meta charset="utf-8">{self.html}'
        Path(path).write_text(text, encoding="utf-8")


def show(thing: Any) -> Any:
    """Picture of an object.

    Parameters
    ----------
    thing
        A gear, a pair, a model, a mesh cycle, a map of a run-up, or a time result.

    Returns
    -------
    Picture or plotly Figure
        Jupyter displays both; outside, `Picture.save` or `Figure.write_html` write a file.

    Raises
    ------
    PitchpointError
        If there is no picture for such an object.
    """
    from pitchpoint.analysis.orders import OrderMap
    from pitchpoint.analysis.spectra import Spectrum
    from pitchpoint.analysis.time_frequency import TimeFrequencyMap
    from pitchpoint.viz import mesh_cycle_plot, notebook, signals_plot, spectrum_plots
    from pitchpoint.viz.quantities import channels

    for (module, name), function in notebook.SHOWN.items():
        if (type(thing).__module__, type(thing).__name__) == (module, name):
            return Picture(getattr(notebook, function)(thing))
    if isinstance(thing, Spectrum):
        return spectrum_plots.plot_spectrum({"": thing}, unit="")
    if isinstance(thing, OrderMap):
        return spectrum_plots.plot_order_map(thing, unit="")
    if isinstance(thing, TimeFrequencyMap):
        return spectrum_plots.plot_time_frequency(thing, unit="")
    if hasattr(thing, "stiffness_ratio") and hasattr(thing, "phase"):
        return mesh_cycle_plot.plot_mesh_stiffness(thing)
    if hasattr(thing, "data_vars") and "time" in thing:
        time, found = channels(thing)
        first = next(iter(found.values()), None)
        if first is not None:
            return signals_plot.plot_signals(
                time, [c for c in found.values() if c.quantity == first.quantity]
            )
    raise PitchpointError(f"{type(thing).__name__}: no picture available; pass a gear, pair, model or result")
