# SPDX-License-Identifier: Apache-2.0
"""Plots of a time response: main channels, quantities, channels, spectra, orders, maps."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.errors import PitchpointError
from pitchpoint.report.picture_names import pick, unknown
from pitchpoint.viz.report.build import TimeRun

if TYPE_CHECKING:
    import plotly.graph_objects as go
    import xarray as xr

    from pitchpoint.model.model import Model

MAIN = "main"
SPECTRA = ("spectrum", "order_spectrum", "order_map", "time_frequency")


def plot_run(data: xr.Dataset, name: str = "") -> go.Figure:
    """Plot of a time response; names as for `plot`, and `main`."""
    names = channel_names(data)
    if not names or data.sizes["time"] < 2:
        raise PitchpointError("this time response has no channel with two samples or more")
    kind, _, rest = name.partition("[")
    quantities = list(dict.fromkeys(n.partition("[")[0] for n in names))
    if not name or name == MAIN:
        return _main(data, names)
    if kind in SPECTRA:
        of = rest.removesuffix("]") or _first(names)
        if of in names:
            figures = _spectra(data, names, of)
            return pick(figures, name, "time response") if figures else _too_short(of)
    elif name in names:
        return _signals(data, [name])
    elif name in quantities:
        return _quantity(data, [n for n in names if n.partition("[")[0] == name], names)
    elif name == "tooth_force" or kind == "tooth_force":
        return pick(_tooth_forces(data, names), name, "time response")
    raise unknown(name, [MAIN, *quantities, *SPECTRA, "tooth_force", *names], "time response")


def channel_names(data: xr.Dataset) -> list[str]:
    """Names of the numeric channels over time, without reading them."""
    return [
        str(name)
        for name, variable in data.variables.items()
        if name != "time" and variable.dims == ("time",) and variable.dtype.kind in "fiub"
    ]


def _model(data: xr.Dataset) -> Model | None:
    """Model of the run, if it contains one."""
    from pitchpoint.report.stored_model import model_of

    try:
        return model_of(data)
    except PitchpointError:
        return None


def _run(data: xr.Dataset, wanted: list[str], names: list[str]) -> TimeRun:
    """Run with some channels, and those from which reference shafts and contact states are taken."""
    from pitchpoint.report.collect import time_run
    from pitchpoint.viz.quantities import settle_time_of

    also = [n for n in names if n.partition("[")[0] in ("angle", "speed", "contact_state")]
    part = data[list(dict.fromkeys([*wanted, *also]))]
    model = _model(data)
    if model is None:
        return TimeRun(data=part, settle_time=settle_time_of(data.attrs))
    return time_run(model, part, data.attrs)


def _main(data: xr.Dataset, names: list[str]) -> go.Figure:
    """Main channels of the model; without one, the first channels."""
    from pitchpoint.viz.main_plot import plot_main_channels
    from pitchpoint.viz.quantities import channels

    chosen = chosen_channels(data, names)
    time, found = channels(data[chosen])
    # channels that are zero throughout would take the place of others
    drawn = [found[n] for n in chosen if not n.startswith("contact_state[") and found[n].values.any()]
    return plot_main_channels(time, drawn or list(found.values()))


def chosen_channels(data: xr.Dataset, names: list[str]) -> list[str]:
    """Main channels by the model of the result; without a model all."""
    from pitchpoint.report.main_channels import main_channels

    model = _model(data)
    return names if model is None else main_channels(model, names, str(data.attrs.get("scenario", "")))


def _signals(data: xr.Dataset, wanted: list[str]) -> go.Figure:
    """Channels of one unit over time."""
    from pitchpoint.viz.quantities import channels
    from pitchpoint.viz.signals_plot import plot_signals

    time, found = channels(data[wanted])
    drawn = list(found.values())
    return plot_signals(time, [c for c in drawn if c.unit == drawn[0].unit])


def _quantity(data: xr.Dataset, wanted: list[str], names: list[str]) -> go.Figure:
    """Channels of one quantity, as in a report; quantities that a report omits as signals."""
    from pitchpoint.viz.report.time import MAX_LINES, time_section

    quantity = wanted[0].partition("[")[0]
    part = _run(data, wanted, names)
    figures = time_section({"": part}).figures
    return figures[quantity] if quantity in figures else _signals(data, wanted[:MAX_LINES])


def _tooth_forces(data: xr.Dataset, names: list[str]) -> dict[str, go.Figure]:
    """Components of the tooth forces."""
    from pitchpoint.viz.report.time import time_section
    from pitchpoint.viz.run_record import FORCE_PARTS

    wanted = [n for n in names if n.partition("[")[0] in FORCE_PARTS]
    found: dict[str, go.Figure] = {}
    for mesh in dict.fromkeys(n.partition("[")[2] for n in wanted):
        own = [n for n in wanted if n.partition("[")[2] == mesh]
        found |= time_section({"": _run(data, own, names)}).figures
    return {key: figure for key, figure in found.items() if key.startswith("tooth_force")}


def _first(names: list[str]) -> str:
    """Channel of a spectrum without a given channel: a mesh force, a deflection, else the first channel."""
    for quantity in ("mesh_force", "deflection"):
        for name in names:
            if name.startswith(f"{quantity}["):
                return name
    return names[0]


def _spectra(data: xr.Dataset, names: list[str], of: str) -> dict[str, go.Figure]:
    """Spectra and maps of one channel."""
    from pitchpoint.viz.report.spectra import default_highest_order, spectrum_section

    model = _model(data)
    teeth = [] if model is None else [int(gear.number_of_teeth) for gear in model.toothed.values()]
    bodies = {} if model is None else {m: model.body_of(x.gears[0]) for m, x in model.every_mesh.items()}
    shafts = {mesh: body for mesh, body in bodies.items() if body}
    run = _run(data, [of], names)
    return spectrum_section({"": run}, default_highest_order(teeth), shafts, (of,)).figures


def _too_short(name: str) -> go.Figure:
    raise PitchpointError(f"{name}: too few samples for a spectrum (limit 64); use a longer run")
