# SPDX-License-Identifier: Apache-2.0
"""Live pages: a model that runs in the browser, with the sliders that its user expects."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import ModelError, PitchpointError
from pitchpoint.io.fmu.model import INPUT, OUTPUT, PARAMETER, SPEED, STATE, FmuModel
from pitchpoint.io.fmu.web import web_assembly
from pitchpoint.model.numbers import number_at
from pitchpoint.report.exported_model import begin_export, fmu_model
from pitchpoint.report.scene.live import live_scene
from pitchpoint.solvers.tunable import check_sums, tunable_places
from pitchpoint.system import evaluate
from pitchpoint.viz.live_page import live_page
from pitchpoint.viz.quantities import channel_scale, pretty, scale

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.solvers.exported_run import ExportedRun
    from pitchpoint.solvers.input_places import Place
    from pitchpoint.viz.scene.page import SceneStart

Array = NDArray[np.float64]
STEPS = 10
"""Time steps per sample."""
MESHES = 2
"""Number of meshes up to which sliders are offered without being named."""
NUMBERS = (
    *("backlash.normal", "backlash.circumferential", "backlash.base_tangent", "center_distance"),
    *("damping.ratio", "damping.value", "damper.ratio", "damper.value", "damping", "damper"),
)
"""Numbers of a mesh for which sliders are offered."""


def offered(
    model: Model, scenario: str, inputs: Sequence[str] = ()
) -> tuple[Model, ExportedRun, tuple[Place, ...]]:
    """Model, started run, and the parameters that a page offers: backlash, centre distance, damping.

    A centre distance that follows from the profile shifts becomes a number of the model. Numbers that cannot
    be changed in a running model are omitted.

    Parameters
    ----------
    model, scenario, inputs
        As for `exported_model.begin_export`.
    """
    meshes = list(model.meshes) if len(model.meshes) <= MESHES else []
    for name in meshes:
        path = f"meshes.{name}.center_distance"
        if number_at(model, path) is None and name in model.pairs:
            try:
                model = model.replace(path, abs(float(model.pairs[name].a_w)))
            except PitchpointError:
                continue
    run, _ = begin_export(model, scenario, (), inputs)
    found: list[Place] = []
    for path in (f"meshes.{name}.{number}" for name in meshes for number in NUMBERS):
        if number_at(model, path) is None:
            continue
        try:
            (place,) = tunable_places(model, scenario, run, [path])
            check_sums(model, scenario, run, found, place)
        except ModelError:  # it cannot be changed in a running model
            continue
        found.append(place)
    return model, run, tuple(found)


def live_text(
    run: ExportedRun,
    tunable: Sequence[Place],
    model: Model,
    scenario: str,
    start: SceneStart | None = None,
) -> tuple[str, int]:
    """Live page of a started run, and the size of its code [bytes].

    Parameters
    ----------
    run, tunable
        From `begin_export` or `offered`.
    model, scenario
        Model and name of its scenario.
    start
        Initial view of the scene.
    """
    from pitchpoint.core.compiler.portable import NARROW

    title = model.title or scenario
    unit = fmu_model(run, tunable, "live", title, NARROW)
    code = web_assembly(unit)
    now = evaluate.observe(run.system, run.state)
    channels = [(k, v) for k, v in enumerate(unit.variables) if v.kind == OUTPUT]
    outputs = [
        {"name": v.name, "reference": k, "size": abs(float(now[i]))}
        | _display_of_channel(v.name, v.unit, now[[i]])
        for i, (k, v) in enumerate(channels)
    ]
    settable = [
        {"name": v.name, "reference": k, "start": v.start, **_display(v.name, v.unit, v.start)}
        | {word: limit for word, limit in (("least", v.least), ("most", v.most)) if math.isfinite(limit)}
        for k, v in enumerate(unit.variables)
        if v.kind in (INPUT, SPEED, PARAMETER)
    ]
    times: dict[str, Any] = {"start": run.t0, "sample": STEPS * run.h}
    scene, follow = live_scene(model, scenario, run)
    shown: dict[str, Any] = {}
    if scene.solids:
        shown = {"scene": scene, "follow": follow | {"start": start.words() if start else {}}}
    settable += _initial_speed(run, unit, model, scenario)
    page = live_page(title, code, token=unit.token, settable=settable, outputs=outputs, **times, **shown)
    return page, len(code)


def _display(name: str, unit: str, start: float) -> dict[str, Any]:
    """Unit in which a number is shown, and its factor."""
    if unit == "1":
        return {"unit": unit, "factor": 1.0}
    found = scale(unit, np.array([start]))
    return {"unit": pretty(found.unit), "factor": found.factor}


def _display_of_channel(name: str, unit: str, value: Array) -> dict[str, Any]:
    """Unit in which a channel with this value at the start is shown, and its factor.

    Angles grow during the run, so that their value at the start does not count.
    """
    if unit == "1":
        return {"unit": unit, "factor": 1.0}
    found = channel_scale(name, unit, np.ones(1) if name.startswith("angle[") else value)
    return {"unit": pretty(found.unit), "factor": found.factor}


def _initial_speed(run: ExportedRun, unit: FmuModel, model: Model, scenario: str) -> list[dict[str, Any]]:
    """Slider of the initial speed of a machine without drives: all rates in proportion, from a new start."""
    speeds = {body: w for body, w in model.start_speeds(model.scenarios[scenario]).items() if w}
    named = [body for body in model.scenarios[scenario].speed if speeds.get(body)]
    if run.drives or not named or run.numbers["driven"] or not unit.exchanges:
        return []
    n = len(run.states)
    rates = [k for k in unit.of_kind(STATE) if unit.variables[k].first >= n and unit.variables[k].start]
    start = speeds[named[0]]
    least, most = sorted((0.02 * start, 2.0 * start))
    return [
        {
            "name": f"initial speed of {named[0]}",
            "references": rates,
            "values": [unit.variables[k].start for k in rates],
            "start": start,
            "least": least,
            "most": most,
            **_display("speed", "rad/s", start),
        }
    ]
