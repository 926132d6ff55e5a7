# SPDX-License-Identifier: Apache-2.0
"""Sample rates of scenarios that are too low for the meshes of the model."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.model.remarks.sampling import coarse_samples

if TYPE_CHECKING:
    from pitchpoint.core.errors import Message
    from pitchpoint.model.model import Model


def coarse_scenarios(model: Model) -> tuple[Message, ...]:
    """A remark for every scenario whose sample rate is too low for a mesh at its highest speed.

    Speeds that only a run can evaluate are omitted: there the run reports it.
    """
    from pitchpoint.report.frequencies import frequencies_of
    from pitchpoint.report.operating_range import drive_speeds, moments_of

    found: list[Message] = []
    for name, scenario in model.scenarios.items():
        if scenario.sample_rate is None or scenario.duration is None:
            continue
        fastest = dict(scenario.speed)
        moments = moments_of(scenario)
        for body, drive in scenario.drive.items():
            speeds = drive_speeds(drive, moments) if body in model.bodies else None
            if speeds is not None:
                fastest[body] = float(speeds[np.argmax(np.abs(speeds))])
        spins = model.start_speeds(replace(scenario, speed=fastest))
        meshes = {m: float(row["frequency"]) for m, row in frequencies_of(model, spins)["meshes"].items()}
        place = ("scenarios", name, "sample_rate")
        remarks = coarse_samples(scenario.sample_rate, meshes, ".".join(place))
        found += [each.changed(kind="remark", line=model.line(place)) for each in remarks]
    return tuple(found)
