# SPDX-License-Identifier: Apache-2.0
"""Loads and scenarios as external loads and load cases of REXS."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.io.rexs.conversion.frames import TO_MODEL
from pitchpoint.io.rexs.document import RexsAttribute, RexsLoadCase, RexsLoadSpectrum
from pitchpoint.io.rexs.exporting.draft import Draft, attribute

if TYPE_CHECKING:
    from collections.abc import Mapping

Values = dict[int, dict[str, RexsAttribute]]


def add_loads(draft: Draft) -> Values:
    """Add the external loads; their values by component are returned."""
    from pitchpoint.model.components.law import Balance, Constant

    found: Values = {}
    for name, load in draft.model.loads.items():
        path = f"loads.{name}"
        shaft = draft.shafts.get(load.body)
        if shaft is None or load.reaction is not None or load.marker is not None:
            draft.omit(path, "only loads at a position of a shaft are written")
            continue
        if max(map(abs, load.position[:2])) > 0.0:
            draft.omit(f"{path}.position", "only the position along the axis is written")
        values: dict[str, float] = {}
        balance = isinstance(load.torque, Balance)
        if isinstance(load.torque, Constant):
            values["torque_around_u_axis"] = load.torque.value
        elif load.torque is not None and not balance:
            draft.omit(f"{path}.torque", "only constant values are written")
        for key, name_of in (("force", "force_{}_direction"), ("moment", "torque_around_{}_axis")):
            laws = getattr(load, key)
            if laws is None:
                continue
            if not all(isinstance(law, Constant) for law in laws):
                draft.omit(f"{path}.{key}", "only constant values are written")
                continue
            along = TO_MODEL @ (draft.frame(load.body)[1].T @ np.array([law.value for law in laws]))
            for axis, value in zip("uvw", along, strict=True):
                given = name_of.format(axis)
                if value or key == "force":
                    values[given] = values.get(given, 0.0) + float(value)
        id = draft.part(
            "external_load",
            name,
            shaft,
            u_coordinate_on_shaft=float(load.position[2]),
            transmits_torque=True if load.torque is not None else None,
        )
        draft.loads[name] = id
        found[id] = {key: attribute(key, value, "external_load") for key, value in values.items()}
    return found


def load_spectra(draft: Draft, loads: Values, results: Mapping[str, Values]) -> tuple[RexsLoadSpectrum, ...]:
    """One load case for each scenario with speeds, with the results of its run; one without any.

    Parameters
    ----------
    draft
        The draft, with all loads and shafts.
    loads
        Values of the external loads.
    results
        Results of the scenarios, by component.
    """
    from dataclasses import replace

    model = draft.model
    scenarios = {n: s for n, s in model.scenarios.items() if s.speed or n in results}
    cases: list[RexsLoadCase] = []
    # the import takes the first load case: one with speeds
    for name in sorted(scenarios, key=lambda n: not scenarios[n].speed) or ([""] if loads else []):
        values: Values = {id: dict(one) for id, one in loads.items()}
        scenario = scenarios.get(name)
        for body, speed in ({} if scenario is None else scenario.speed).items():
            id = draft.shafts.get(body)
            if id is None:
                draft.omit(f"scenarios.{name}.speed.{body}", "is not a shaft of the file")
                continue
            one = draft.components[id]
            flag = attribute("defines_speed", True, "shaft")
            draft.components[id] = replace(one, attributes={**one.attributes, "defines_speed": flag})
            values.setdefault(id, {})["rotational_speed"] = attribute("rotational_speed", speed, "shaft")
        for id, more in results.get(name, {}).items():
            values.setdefault(id, {}).update(more)
        cases.append(RexsLoadCase(len(cases) + 1, values))
    for name in model.scenarios:
        if name not in scenarios:
            draft.omit(f"scenarios.{name}", "scenarios without speeds are not written")
    return (RexsLoadSpectrum(1, tuple(cases)),) if cases else ()
