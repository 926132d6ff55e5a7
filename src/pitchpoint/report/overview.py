# SPDX-License-Identifier: Apache-2.0
"""First sections of a report: components of the model, scene, power flow of the runs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import PitchpointError
from pitchpoint.core.progress import report_step
from pitchpoint.core.units import format_quantity
from pitchpoint.report.housing import housing_facts
from pitchpoint.report.load_cases import lubricant_facts
from pitchpoint.viz.report.build import SceneData, TimeRun
from pitchpoint.viz.run_record import FORCE_PARTS, TIME_QUANTITIES

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model
    from pitchpoint.viz.power_flow import PowerFlow

READ = {*TIME_QUANTITIES, *FORCE_PARTS, "normal_force"} - {"bearing_force", "coupling_force"}
"""Quantities available as curves below the scene of a report."""
NO_PARTS = ("lines", "pairs")
"""Mappings of a model that are not sections of its file."""
SPRINGS = ("torsion_springs", "couplings")
"""Sections with parts of scissor gears."""
MAX_NAMES = 6
"""Maximum number of listed names."""


def counts_of(model: Model) -> list[tuple[str, str]]:
    """Number and names of the components of each section of a model."""
    found = []
    for field in fields(model):
        section, parts = field.name, getattr(model, field.name)
        if isinstance(parts, Mapping) and section not in NO_PARTS:
            own = {*model.scissor_gears} if section in SPRINGS else set()  # parts of scissor gears
            own |= {f"{name}-friction" for name in model.scissor_gears} if section == "clutches" else set()
            parts = [
                n for n, part in parts.items() if n not in own and not getattr(part, "of_housing", False)
            ]
            if not parts:
                continue
            names = [_named(model, section, name) for name in parts[:MAX_NAMES]]
            more = f" and {len(parts) - MAX_NAMES} more" if len(parts) > MAX_NAMES else ""
            found.append((f"{section.replace('_', ' ')}: {len(parts)}", f"{', '.join(names)}{more}"))
    if model.housing is not None:
        found.append(("housing", housing_facts(model)["words"]))
    if oil := lubricant_facts(model):
        found.append(("lubricant", f"{oil['name']}, {format_quantity(oil['temperature'], 'temperature', 4)}"))
    return found


def _named(model: Model, section: str, name: str) -> str:
    """Name of a component; for gears and meshes with the numbers of teeth."""
    if section in ("gears", "bevel_gears"):
        return f"{name} ({model.toothed[name].number_of_teeth})"
    if section in ("meshes", "bevel_meshes"):
        teeth = "/".join(str(model.toothed[gear].number_of_teeth) for gear in model.every_mesh[name].gears)
        return f"{name} ({teeth})"
    return str(name)


def scene_part(model: Model, runs: Mapping[str, TimeRun]) -> SceneData:
    """Scene of the first complete run, else of the first run, else of the model at rest."""
    from pitchpoint.report.scene.build import scene_of

    names = [*(name for name, run in runs.items() if not run.note), *runs]
    words = ""
    for name in names[:1]:
        data, lost = _finite(runs[name].data)
        try:
            scene = scene_of(_own_model(model, data), data)
        except PitchpointError as error:
            words = f"The motion of {name} cannot be shown: {error}."
            break
        if scene.solids:
            # the page contains all curves; only the most important channels are shown below the scene
            kept = [c for c in scene.channels if c.first or c.name.partition("[")[0] in READ]
            scene = replace(scene, channels=kept)
            hint = "Click a curve of this run to set the time of the scene."
            hint += "" if len(runs) < 2 else " Use pitchpoint view for other runs or two side by side."
            words = f"The scene shows {name}. {lost}".strip()
            return SceneData(scene=scene, run=name, words=words, hint=hint)
    try:
        scene = scene_of(model)
    except PitchpointError as error:
        return SceneData(words=f"There is no scene: {error}")
    if not scene.solids:
        return SceneData(
            words="There is no scene: the model defines no geometry (no gears on bodies, no solid files)."
        )
    at_rest = "The scene shows the machine at rest."
    return SceneData(scene=replace(scene, channels=()), words=f"{words} {at_rest}".strip())


def _own_model(model: Model, data: xr.Dataset) -> Model:
    """Model of a run: the one stored in its result if its values differ from those of the given model."""
    from pitchpoint.core.provenance import content_hash
    from pitchpoint.report.stored_model import model_of

    known = str(data.attrs.get("model_hash", ""))
    if known in ("", content_hash(model)):
        return model
    try:
        own = model_of(data)
    except PitchpointError:
        return model
    return own if content_hash(own) == known else model


def _finite(data: xr.Dataset) -> tuple[xr.Dataset, str]:
    """Result up to the first non-finite sample of a failed run, and a sentence about it."""
    fine = np.ones(data.sizes["time"], dtype=bool)
    for values in data.data_vars.values():
        if values.dims == ("time",) and values.dtype.kind == "f":
            fine &= np.isfinite(values.values)
    if fine.all():
        return data, ""
    end = int(np.argmin(fine))
    words = f"It ends at {float(data['time'][end]):.6g} s, where the result becomes non-finite."
    return data.isel(time=slice(0, max(end, 1))), words


def power_part(model: Model, runs: Mapping[str, TimeRun]) -> dict[str, Any]:
    """Power flow of every run, or a sentence with the reason why there is none; empty without connections."""
    from pitchpoint.report.power_flow import power_flow

    found: dict[str, PowerFlow | str] = {}
    for name, run in runs.items():
        report_step(f"power flow of {name}")
        try:
            flow = power_flow(model, _finite(run.data)[0], run.settle_time)
        except PitchpointError as error:
            found[name] = f"No power flow of {name}: {error}."
            continue
        if flow is not None and flow.links:
            found[name] = flow
    return found
