# SPDX-License-Identifier: Apache-2.0
"""`plot`: the pictures of results, gears and models, the same as in reports.

The sections of a report name their plots; `plot` draws the section of a result and returns one of them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import PitchpointError
from pitchpoint.report.picture_names import pick
from pitchpoint.report.result_kinds import kind_of
from pitchpoint.viz import notebook
from pitchpoint.viz.picture import Picture

if TYPE_CHECKING:
    import plotly.graph_objects as go
    import xarray as xr

    from pitchpoint.model.model import Model

GEARBOX = "gearbox"
Figures = Mapping[str, "go.Figure"]
WORDS = {"cases": "table of cases", "modes": "list of modes"}
"""Kinds of results in messages, where they are not the kind itself."""


def plot(thing: Any, name: str = "") -> go.Figure | Picture:
    """Picture of a result, as in a report; drawing of a gear, a pair or a model.

    Parameters
    ----------
    thing
        Dataset of a solver, of `open_result` or of `analyse`; contact analyses of several meshes; a spectrum,
        order map or time–frequency map; a mesh cycle; a box of wind; a gear, a pair, a model.
    name
        Which picture; default the main one, for a time response its main channels. A kind without owner
        gives the first of that kind. A model: `gearbox`, in section. Results of time: a quantity
        (`mesh_force`), a channel (`bearing_force[left.fx]`), `spectrum`, `order_spectrum`, `order_map` or
        `time_frequency`, also of one channel (`order_map[mesh_force[stage]]`). An unknown name lists all
        others in the message.

    Returns
    -------
    plotly.graph_objects.Figure or Picture
        Notebooks display both; `Figure.write_html` and `Picture.save` write a file.

    Raises
    ------
    PitchpointError
        If there is no such picture, or none of such an object.
    """
    if name == GEARBOX and hasattr(thing, "every_mesh"):
        return _gearbox(thing)
    for (module, word), function in notebook.SHOWN.items():
        if (type(thing).__module__, type(thing).__name__) == (module, word):
            return Picture(getattr(notebook, function)(thing))
    if hasattr(thing, "data_vars"):
        return _of_result(thing, name)
    figures = _of_object(thing)
    if not figures:
        raise PitchpointError(
            f"{type(thing).__name__}: no picture available; pass a result, a gear, a pair or a model"
        )
    return pick(figures, name, type(thing).__name__)


def _gearbox(model: Model) -> Picture:
    """Gearbox of a model in section, with the power flow of its first scenario."""
    from pitchpoint.report.section.build import gearbox_drawing
    from pitchpoint.report.static_power import static_powers

    drawing = gearbox_drawing(model, static_powers(model))
    if drawing is None:
        raise PitchpointError("the model has no gears or shafts on bodies to draw")
    return Picture(drawing)


def _of_result(data: xr.Dataset, name: str) -> go.Figure:
    """Picture of a dataset."""
    from pitchpoint.report import result_pictures, run_pictures

    kind = kind_of(data)
    if kind == "time":
        return run_pictures.plot_run(data, name)
    made: Callable[[xr.Dataset], Figures] = getattr(result_pictures, f"{kind}_figures")
    return pick(made(data), name, WORDS.get(kind, kind.replace("_", " ")))


def _of_object(thing: Any) -> Figures:
    """Pictures of an object that is not a dataset; empty if there is none."""
    from pitchpoint.analysis.orders import OrderMap
    from pitchpoint.analysis.spectra import Spectrum
    from pitchpoint.analysis.time_frequency import TimeFrequencyMap
    from pitchpoint.model.wind.box import WindBox
    from pitchpoint.report.result_pictures import meshes_figures
    from pitchpoint.viz import mesh_cycle_plot, spectrum_plots, wind_plot

    if isinstance(thing, Spectrum):
        return {"spectrum": spectrum_plots.plot_spectrum({"": thing}, unit="")}
    if isinstance(thing, OrderMap):
        return {"order_map": spectrum_plots.plot_order_map(thing, unit="")}
    if isinstance(thing, TimeFrequencyMap):
        return {"time_frequency": spectrum_plots.plot_time_frequency(thing, unit="")}
    if isinstance(thing, WindBox):
        return {"time": wind_plot.plot_wind_over_time(thing), "plane": wind_plot.plot_wind_plane(thing)}
    if hasattr(thing, "stiffness_ratio") and hasattr(thing, "phase"):
        return {"mesh_stiffness": mesh_cycle_plot.plot_mesh_stiffness(thing)}
    analyses = getattr(thing, "meshes", None)
    if isinstance(analyses, Mapping) and all(hasattr(one, "data_vars") for one in analyses.values()):
        return meshes_figures(analyses)
    return {}
