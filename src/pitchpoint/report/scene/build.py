# SPDX-License-Identifier: Apache-2.0
"""Assemble the scene of a model, or of a result and its stored model."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import PitchpointError
from pitchpoint.core.provenance import content_hash
from pitchpoint.report.main_channels import main_channels
from pitchpoint.report.scene.bearings import cage_bodies
from pitchpoint.report.scene.contact_lines import ContactLines
from pitchpoint.report.scene.curves import scene_curves
from pitchpoint.report.scene.elastic import elastic_parts
from pitchpoint.report.scene.flexible_rims import with_rims
from pitchpoint.report.scene.forces import force_arrows
from pitchpoint.report.scene.marks import scene_marks
from pitchpoint.report.scene.modes import modes_of_result, scene_modes, with_parts
from pitchpoint.report.scene.motion import motion, scene_bodies, shown_bodies
from pitchpoint.report.scene.places import Places
from pitchpoint.report.scene.planets import grouped
from pitchpoint.report.scene.solids import scene_solids
from pitchpoint.report.scene.spectra import scene_spectra
from pitchpoint.report.scene.tooth_contacts import scene_contacts
from pitchpoint.viz.quantities import settle_time_of
from pitchpoint.viz.scene.contacts import SceneContact
from pitchpoint.viz.scene.content import Scene, SceneArrow, SceneChannel, SceneMark
from pitchpoint.viz.scene.spectrum import SceneMap, SceneSpectrum

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

MAX_FRAMES = 2000
NUMBERS = 8e5
"""Maximum count of numbers of all tracks: more bodies have fewer frames."""


def scene_of(
    model: Model, result: xr.Dataset | None = None, scenario: str | None = None, modes: int = 0
) -> Scene:
    """Scene of a model at rest, or of a result over time.

    Parameters
    ----------
    model
        Model; for a result the stored model.
    result
        Result of a time run, or of modes.
    scenario
        Scenario of the result; default: the scenario named in it.
    modes
        Number of lowest modes to compute.

    Raises
    ------
    PitchpointError
        If the model cannot be compiled, or the result contains no positions of the bodies.
    """
    from pitchpoint.system.compile import compile_model

    whole = result
    if result is not None and "time" in result.dims:
        result = _known(result)
    chosen = scenario or (None if result is None else result.attrs.get("scenario")) or None
    system = compile_model(model, chosen)
    names = system.layout.bodies
    still = motion(system, 1, lambda _: np.zeros(1), np.zeros(1))
    shapes = result if result is not None and "mode" in result.dims else None
    result = result if shapes is None else None
    record = _Record.of(result, len(names))
    lines = ContactLines(system, record.at_frames, len(record.times))
    moved = motion(system, len(record.times), record.at_frames, record.times, lines.look)
    bodies = scene_bodies(system, moved, still)
    numbers = {b: k for k, b in enumerate(shown_bodies(system))}
    places = Places(model, numbers, {names[b]: k for b, k in numbers.items()})
    labels = [body.name for body in bodies]
    if result is not None:
        cages = cage_bodies(system, model, places, moved, bodies)
        for name, cage in cages.items():
            places.cages[name] = len(bodies), (cage.parent, cage.place, cage.axes)
            bodies.append(cage)
    solids, notes = scene_solids(model, places)
    bending, remarks = elastic_parts(model, places, record.at_frames)
    solids, notes = [*with_rims(model, solids, record.at_frames), *bending], notes + remarks
    if result is not None and whole is not None and result.sizes["time"] < whole.sizes["time"]:
        notes.append(
            f"shown up to {float(result['time'][-1]):.6g} s: later values of the result are not finite"
        )
    if result is not None and moved.unknown:
        notes.append("not in the result, drawn at rest: " + ", ".join(moved.unknown))
    arrows: list[SceneArrow] = []
    contacts: list[SceneContact] = []
    marks: list[SceneMark] = []
    spectra: list[SceneSpectrum] = []
    maps: list[SceneMap] = []
    if result is not None:
        arrows, remarks = force_arrows(system, moved, record.at_frames)
        contacts, lacking = scene_contacts(model, system, lines, moved, record.at_frames)
        marks, coarse = scene_marks(model, result, contacts, record.times)
        spectra, maps = scene_spectra(model, result, settle_time_of(result.attrs))
        notes += [*_another_state(model, result), *remarks, *lacking, *coarse]
    found = scene_modes(system, modes, labels, solids) if modes else []
    if shapes is not None:
        found = modes_of_result(shapes, labels, solids)
    return Scene(
        title=model.title or "Gears",
        subtitle="" if result is None else _subtitle(result),
        up=_up(model),
        bodies=bodies,
        solids=solids,
        times=record.times,
        arrows=arrows,
        contacts=contacts,
        channels=grouped(record.curves(model), model),
        marks=marks,
        spectra=spectra,
        maps=maps,
        modes=[with_parts(mode, bodies) for mode in found],
        notes=notes,
    )


def _known(result: xr.Dataset) -> xr.Dataset:
    """Result up to the first sample with a non-finite position, as at the end of a failed run."""
    moving = [n for n in result.data_vars if str(n).startswith(("angle[", "displacement["))]
    known = np.isfinite(result["time"].values)
    for name in moving:
        if result[name].dims == ("time",):
            known = known & np.isfinite(result[name].values)
    count = int(known.size if known.all() else np.argmin(known))
    if count == 0:
        raise PitchpointError("the result contains no sample with finite positions of all bodies; rerun it")
    return result if count == known.size else result.isel(time=slice(0, count))


def _another_state(model: Model, result: xr.Dataset) -> list[str]:
    """Remark if the result was computed with other values than those of the model."""
    known = str(result.attrs.get("model_hash", ""))
    if known in ("", content_hash(model)):
        return []
    return [
        "computed with a different version of the model than the stored one; teeth, faults and scenario are "
        "those of the stored model, forces and motion those of the run"
    ]


def _up(model: Model) -> tuple[float, float, float]:
    """Upward direction, opposite to gravity; y without gravity."""
    size = math.hypot(*(model.gravity or ()))
    if model.gravity is None or size == 0.0:
        return (0.0, 1.0, 0.0)
    x, y, z = (-g / size for g in model.gravity)
    return (x, y, z)


def _subtitle(result: xr.Dataset) -> str:
    """Scenario and time span of a result in words."""
    span = float(result["time"][-1] - result["time"][0])
    name = result.attrs.get("scenario")
    return f"scenario {name}, {span:.4g} s" if name else f"{span:.4g} s"


@dataclass(frozen=True)
class _Record:
    """Result and the samples used as frames."""

    result: xr.Dataset | None
    samples: NDArray[np.int64]
    times: Array

    @classmethod
    def of(cls, result: xr.Dataset | None, bodies: int) -> _Record:
        """Select frames: fewer for many bodies; one, at rest, without a result."""
        if result is None:
            return cls(None, np.zeros(1, np.int64), np.zeros(1))
        time = np.asarray(result["time"].values, dtype=np.float64)
        most = int(min(MAX_FRAMES, max(100.0, NUMBERS / (7.0 * bodies))))
        step = max(1, -(-(time.size - 1) // (most - 1)))
        samples = np.arange(0, time.size, step)
        return cls(result, samples, time[samples])

    def at_frames(self, name: str) -> Array | None:
        """Channel at the frames; None if the result does not contain it as numbers."""
        if self.result is None:
            return np.zeros(1)
        if name not in self.result:
            return None
        values = np.asarray(self.result[name].values[self.samples], dtype=np.float64)
        return values if np.isfinite(values).all() else None

    def curves(self, model: Model) -> Sequence[SceneChannel]:
        """All channels over time."""
        if self.result is None:
            return []
        names, scenario = map(str, self.result.data_vars), str(self.result.attrs.get("scenario", ""))
        return scene_curves(self.result, main_channels(model, names, scenario))
