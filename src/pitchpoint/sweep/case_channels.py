# SPDX-License-Identifier: Apache-2.0
"""Channels with statistics of a case, before it is computed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pitchpoint.model.scenario import Scenario

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def case_channels(model: Model, scenario: Scenario) -> tuple[list[tuple[str, str, str]], dict[str, Any]]:
    """Channels with statistics in the table, meshes with contact numbers, and the size of the sweeps."""
    from pitchpoint.sweep.speed import plan_sweep
    from pitchpoint.system.compile import compile_model
    from pitchpoint.system.meshes import mesh_names
    from pitchpoint.system.planet_loads import factor_quantities

    if scenario.sweep is not None:
        both = scenario.sweep.direction == "both"
        directions = ["up", "down"] if both else [scenario.sweep.direction]
        system = compile_model(model, scenario)
        swept = plan_sweep(system, scenario).mesh
        meshes = [swept, *(name for name in mesh_names(system) if name != swept)]
        sizes = {"directions": directions, "n_points": scenario.sweep.points}
        return factor_quantities(model), {**sizes, "meshes": meshes}
    channels = [(c.name, c.unit, c.long_name) for c in compile_model(model, scenario).layout.channels]
    channels += factor_quantities(model)
    if scenario.kind == "quasi_static":
        for mesh in model.every_mesh:
            words = "transmission error without load"
            channels.append((f"unloaded_transmission_error[{mesh}]", "m", words))
            channels.append((f"tangent_stiffness[{mesh}]", "N/m", "slope of the mesh force"))
        return channels, {}
    state = "contact_state["
    return channels, {"meshes": [n[len(state) : -1] for n, _, _ in channels if n.startswith(state)]}
