# SPDX-License-Identifier: Apache-2.0
"""Spectra of a scene over frequency or shaft orders, and spectral maps over time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.orders import highest_resolved_order, order_map, tracked_spectrum
from pitchpoint.analysis.sampled import SignalError, one_way
from pitchpoint.analysis.spectra import amplitude_spectrum
from pitchpoint.analysis.time_frequency import time_frequency_map
from pitchpoint.viz.run_record import MAP_TURNS, ORDER_TURNS, settled_part, turns_of, uniform
from pitchpoint.viz.scene.spectrum import SceneMap, SceneSpectrum

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

QUANTITIES = (
    "transmission_error",
    "normal_force",
    "mesh_force",
    "acceleration",
    "bearing_force",
    "contact_force",
    "torque",
    "speed",
)
"""Quantities with spectra, the main ones first."""
MAX_LINES = 12
MAPS = 4
"""Maximum number of channels with spectra, and of those with maps over time."""
LINES, MAP_LINES, PIECES = 1500, 256, 160
"""Maximum numbers of lines of a spectrum and of a map (reduced by group maxima), and of segments of a map."""
ROUND_OFF = 1e-9
"""Relative variation up to which a channel counts as constant."""
MIN_SAMPLES = 64
"""Minimum number of samples for a spectrum."""
ORDERS = 4.5
"""Maximum order in numbers of teeth of the first gear: four mesh harmonics."""


@dataclass(frozen=True)
class _Shaft:
    """Body with constant sense of rotation: its angle [rad] and the highest required order."""

    name: str
    angle: Array
    highest: float

    @property
    def turns(self) -> float:
        """Total rotation [revolutions]."""
        return turns_of(self.angle)


def scene_spectra(
    model: Model, result: xr.Dataset, settle_time: float = 0.0
) -> tuple[list[SceneSpectrum], list[SceneMap]]:
    """Spectra of the main channels, and maps over time for some of them.

    Parameters
    ----------
    model
        Model, which defines the shafts of the gears of a mesh.
    result
        A time response.
    settle_time
        Settling time omitted from spectra [s]; maps include it.
    """
    time = np.asarray(result["time"].values, dtype=np.float64)
    if time.size < MIN_SAMPLES:
        return [], []
    inside = settled_part(time, settle_time)
    spectra: list[SceneSpectrum] = []
    maps: list[SceneMap] = []
    shafts = _shafts(model, result)
    for name in _chosen(result, inside):
        unit = str(result[name].attrs.get("units", "1"))
        values = np.asarray(result[name].values, dtype=np.float64)
        signal, rate = uniform(time[inside], values[inside])
        spectrum = amplitude_spectrum(signal - signal.mean(), rate)
        lines, amplitude = _fewer(spectrum.frequency[1:], spectrum.amplitude[1:], LINES)
        spectra.append(SceneSpectrum(name, unit, lines, amplitude, "", spectrum.resolution))
        shaft = shafts.get(_owner(name), shafts.get(""))
        spectra += _orders(name, unit, values[inside], shaft, inside)
        if len(maps) < MAPS:
            maps += _map(name, unit, values, time, shaft)
    return spectra, maps


def _chosen(result: xr.Dataset, inside: NDArray[np.bool_]) -> list[str]:
    """Channels with a spectrum: the first varying ones."""
    names = [str(n) for n, x in result.data_vars.items() if x.dims == ("time",)]
    found: list[str] = []
    for quantity in QUANTITIES:
        same = {n: np.asarray(result[n].values, np.float64) for n in names if n.split("[")[0] == quantity}
        same = {n: values for n, values in same.items() if np.isfinite(values).all()}
        largest = max((float(np.abs(values).max()) for values in same.values()), default=0.0)
        found += [n for n, values in same.items() if np.ptp(values[inside]) > ROUND_OFF * largest]
    return found[:MAX_LINES]


def _owner(channel: str) -> str:
    """Element that a channel belongs to: `shaft` of `displacement[shaft.x]`."""
    return channel.partition("[")[2].rstrip("]").partition(".")[0]


def _shafts(model: Model, result: xr.Dataset) -> Mapping[str, _Shaft]:
    """Shafts with constant sense of rotation, by the mesh of their first gear; the first also unnamed."""
    found: dict[str, _Shaft] = {}
    for name, mesh in model.every_mesh.items():
        body = model.body_of(mesh.gears[0])
        channel = f"angle[{body}]"
        if channel not in result:
            continue
        try:
            angle = one_way(np.asarray(result[channel].values, dtype=np.float64))
        except SignalError:
            continue
        teeth = model.toothed[mesh.gears[0]].number_of_teeth
        shaft = _Shaft(str(body), angle, ORDERS * teeth)
        if shaft.turns >= ORDER_TURNS:
            found[name] = shaft
            found.setdefault("", shaft)
    return found


def _orders(
    name: str, unit: str, values: Array, shaft: _Shaft | None, inside: NDArray[np.bool_]
) -> list[SceneSpectrum]:
    """Spectrum over the orders of a shaft, if it has enough revolutions after settling."""
    if shaft is None or turns_of(shaft.angle[inside]) < ORDER_TURNS:
        return []
    try:
        spectrum = tracked_spectrum(values - values.mean(), shaft.angle[inside], highest_order=shaft.highest)
    except SignalError:
        return []
    lines, amplitude = _fewer(spectrum.frequency[1:], spectrum.amplitude[1:], LINES)
    if not lines.size:
        return []
    return [SceneSpectrum(name, unit, lines, amplitude, shaft.name, spectrum.resolution)]


def _map(name: str, unit: str, values: Array, time: Array, shaft: _Shaft | None) -> list[SceneMap]:
    """Spectral map over time: over the orders of a shaft, or over frequencies without shaft."""
    if shaft is not None and shaft.turns < MAP_TURNS:
        shaft = None
    try:
        if shaft is None:
            signal, rate = uniform(time, values)
            passed = time_frequency_map(signal, rate, frames=PIECES, start=float(time[0]))
            lines, times, amplitude = passed.frequency, passed.time, passed.amplitude
        else:
            # a segment is short enough to show changes and long enough to resolve orders
            turns = float(np.clip(np.floor(shaft.turns / 40.0), 1.0, 8.0))
            highest = min(shaft.highest, highest_resolved_order(shaft.angle))
            tracked = order_map(
                values, shaft.angle, time, highest_order=highest, revolutions=turns, frames=PIECES
            )
            lines, times, amplitude = tracked.order, tracked.time, tracked.amplitude
    except SignalError:
        return []
    # the mean of a segment is not a line of its spectrum
    lines, amplitude = lines[1:], amplitude[:, 1:]
    size = -(-lines.size // MAP_LINES)
    whole = lines.size // size * size
    if times.size < 2 or whole // max(size, 1) < 2:
        return []
    kept = amplitude[:, :whole].reshape(times.size, -1, size).max(axis=2)
    middle = lines[:whole].reshape(-1, size).mean(axis=1)
    return [SceneMap(name, unit, middle, times, kept, "" if shaft is None else shaft.name)]


def _fewer(lines: Array, amplitude: Array, most: int) -> tuple[Array, Array]:
    """Maximum of every group of lines if there are too many lines."""
    size = max(1, -(-lines.size // most))
    if size == 1:
        return lines, amplitude
    starts = np.arange(0, lines.size, size)
    largest = [s + int(np.argmax(amplitude[s : s + size])) for s in starts]
    return lines[largest], amplitude[largest]
