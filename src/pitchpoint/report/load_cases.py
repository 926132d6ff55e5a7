# SPDX-License-Identifier: Apache-2.0
"""Lubricant and load cases of a model as data."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pitchpoint.model.load_cases import oil_of, shares_of_time

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def lubricant_facts(model: Model) -> dict[str, Any]:
    """Temperature, viscosities and pressure-viscosity coefficient of the lubricant, SI; empty without one."""
    oil = oil_of(model)
    if oil is None:
        return {}
    at_40, at_100 = oil.viscosities
    return {
        "name": oil.name or oil.grade or "oil",
        "viscosity_at_40_degree_celsius": at_40,
        "viscosity_at_100_degree_celsius": at_100,
        "temperature": oil.temperature,
        "dynamic_viscosity": oil.dynamic_viscosity,
        "pressure_viscosity": oil.pressure_coefficient,
    }


def load_case_facts(model: Model) -> dict[str, dict[str, Any]]:
    """Speeds, loads, temperature, share of the time of every load case, and where it is in effect; SI."""
    shares = shares_of_time(model.load_cases)
    return {
        name: {
            "speed": dict(case.speed),
            "loads": {
                load: {key: value for key, value in vars(change).items() if value is not None}
                for load, change in case.loads.items()
            },
            "temperature": case.temperature,
            "load_duration_fraction": shares[name],
            "load_duration": case.load_duration,
            "in_effect": name == model.load_case,
            "scenarios": [n for n, s in model.scenarios.items() if (model.load_case or s.load_case) == name],
        }
        for name, case in model.load_cases.items()
    }
