# SPDX-License-Identifier: Apache-2.0
"""Mode shapes and spectra of a scene."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import PitchpointError
from pitchpoint.report.scene_elastic import coordinates_of
from pitchpoint.viz.scene import SceneMode, SceneSolid, SceneSpectrum

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.system.system import System

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

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
"""Quantities whose spectra are shown, first those that people look at first."""
MOST = 12
LINES = 1500
"""Lines of a spectrum: of more, every group keeps its largest."""
FEWEST = 64
"""Samples below which there is no spectrum."""


def scene_modes(
    system: System, count: int, bodies: Sequence[str], solids: Sequence[SceneSolid]
) -> list[SceneMode]:
    """The lowest modes of a system about its loaded state.

    Parameters
    ----------
    system
        The machine, compiled with a scenario or at rest.
    count
        How many.
    bodies
        Names of the bodies of the scene.
    solids
        Its solids: those that bend in modal coordinates get theirs.
    """
    from pitchpoint.solvers.modal import find_modes

    found = find_modes(system, count=count)
    return [
        _mode(
            f"{k + 1}: {found.names[k]}",
            (float(found.frequency[k]), float(found.damping_ratio[k])),
            (found.bodies, found.damped_body_shape[k]),
            (found.coordinates, found.damped_shape[k]),
            bodies,
            solids,
        )
        for k in range(min(count, len(found.names)))
    ]


def modes_of_result(
    result: xr.Dataset, bodies: Sequence[str], solids: Sequence[SceneSolid]
) -> list[SceneMode]:
    """The modes that a result of `pitchpoint modes` holds, without damping in their shapes.

    Parameters
    ----------
    result
        The result.
    bodies, solids
        As in `scene_modes`.

    Raises
    ------
    PitchpointError
        If it does not hold what bodies do in them.
    """
    if "body_shape" not in result:
        raise PitchpointError("this result of modes holds no motions of bodies; compute it again")
    names = [str(name) for name in result["body"].values]
    coordinates = [str(name) for name in result["coordinate"].values]
    return [
        _mode(
            f"{k + 1}: {result['name'].values[k]}",
            (float(result["frequency"][k]), float(result["damping_ratio"][k])),
            (names, np.asarray(result["body_shape"].values[k], dtype=complex)),
            (coordinates, np.asarray(result["shape"].values[k], dtype=complex)),
            bodies,
            solids,
        )
        for k in range(result.sizes["mode"])
    ]


def _mode(
    name: str,
    numbers: tuple[float, float],
    motions: tuple[Sequence[str], Complex],
    coordinates: tuple[Sequence[str], Complex],
    bodies: Sequence[str],
    solids: Sequence[SceneSolid],
) -> SceneMode:
    """One mode with the bodies in the order of the scene."""
    frequency, damping = numbers
    at = {body: k for k, body in enumerate(motions[0])}
    moved = np.array([motions[1][at[body]] for body in bodies]).reshape(-1, 6)
    place = {coordinate: k for k, coordinate in enumerate(coordinates[0])}
    sway = {}
    for solid in solids:
        if solid.sway is None:
            continue
        own = coordinates_of(solid.name, len(solid.sway.shapes))
        if all(c in place for c in own):
            sway[solid.name] = coordinates[1][[place[c] for c in own]]
    shown = damping if math.isfinite(damping) and frequency > 0.0 else None
    return SceneMode(
        name=name, frequency=frequency, damping=shown, position=moved[:, :3], turn=moved[:, 3:], sway=sway
    )


def scene_spectra(result: xr.Dataset, settle_time: float = 0.0) -> list[SceneSpectrum]:
    """Amplitude spectra of the channels that people look at first.

    Parameters
    ----------
    result
        A time response.
    settle_time
        Part of it at the beginning that does not count [s].
    """
    from pitchpoint.analysis.spectra import amplitude_spectrum
    from pitchpoint.viz.run_record import settled_part, uniform

    time = np.asarray(result["time"].values, dtype=np.float64)
    if time.size < FEWEST:
        return []
    inside = settled_part(time, settle_time)
    names = [str(n) for n, x in result.data_vars.items() if x.dims == ("time",)]
    chosen = [n for q in QUANTITIES for n in names if n.split("[")[0] == q]
    found = []
    for name in chosen:
        values = np.asarray(result[name].values, dtype=np.float64)[inside]
        if not np.isfinite(values).all() or np.ptp(values) == 0.0:
            continue
        signal, rate = uniform(time[inside], values)
        spectrum = amplitude_spectrum(signal - signal.mean(), rate)
        frequency, amplitude = _fewer(spectrum.frequency[1:], spectrum.amplitude[1:])
        unit = str(result[name].attrs.get("units", "1"))
        found.append(SceneSpectrum(name, unit, frequency, amplitude))
        if len(found) == MOST:
            break
    return found


def _fewer(frequency: Array, amplitude: Array) -> tuple[Array, Array]:
    """The largest line of every group where there are too many lines to be seen."""
    size = -(-frequency.size // LINES)
    if size == 1:
        return frequency, amplitude
    starts = np.arange(0, frequency.size, size)
    largest = [s + int(np.argmax(amplitude[s : s + size])) for s in starts]
    return frequency[largest], amplitude[largest]
