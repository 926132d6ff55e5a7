# SPDX-License-Identifier: Apache-2.0
"""Load cases: speeds, loads, temperature and share of the time, by name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.components.lubricant import COLDEST, HOTTEST
from pitchpoint.model.components.marker import Triple
from pitchpoint.model.keys import key, positive, quantities, quantity


@dataclass(frozen=True, kw_only=True)
class CaseLoad(Component):
    """Values of one load in a load case; those that are not given are as in loads."""

    torque: float | None = quantity("torque", "torque, positive about the axis of the body", None)
    power: float | None = quantity(
        "power", "instead of torque: power of the torque at the speed of its body, > 0 drives", None
    )
    force: Triple | None = quantities("force", "force [x, y, z]", None, length=(3, 3))


@dataclass(frozen=True, kw_only=True)
class LoadCase(Component):
    """What differs between the operating conditions of a gearbox: speeds, loads and temperature."""

    speed: dict[str, float] = key(
        "speeds",
        "speeds of bodies; the others follow from the gear ratios. They replace those of the scenarios",
        {},
        dimension="angular_speed",
    )
    loads: Mapping[str, CaseLoad] = key("components", "values by LOAD of the section loads", {}, of=CaseLoad)
    temperature: float | None = quantity(
        "temperature",
        "temperature of the lubricant",
        None,
        minimum=COLDEST,
        maximum=HOTTEST,
        display="that of lubricant",
        also=("temperature_lubricant",),
    )
    load_duration_fraction: float | None = quantity(
        "dimensionless",
        "share of the time",
        None,
        minimum=0.0,
        maximum=1.0,
        also=("share", "fraction"),
        sample="40 %",
    )
    load_duration: float | None = positive(
        "time",
        "time in this load case, instead of load_duration_fraction; its share is that of the sum of all",
        None,
        also=("hours", "duration"),
        sample="5000 h",
        later=True,
    )
