# SPDX-License-Identifier: Apache-2.0
"""What a report computes itself, because it takes a second: slow roll of every mesh, modes, Campbell data.

The loads of the first scenario at t = 0 count. What cannot be computed (loads that no tooth resists, say) is
left out with a sentence.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import PitchpointError

if TYPE_CHECKING:
    from pitchpoint.core.progress import Progress
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.solvers.quasistatic import Roll
    from pitchpoint.system.system import System
    from pitchpoint.viz.report import CampbellData, MeshCycleData, ModeData

POINTS = 96
SPEEDS = 41
HARMONICS = 3
SAME = 1e-3
"""Relative difference up to which the stiffness under load counts as that of the law."""


def with_rolls(
    model: Model, cycles: dict[str, tuple[MeshCycleData, float]], progress: Progress
) -> tuple[dict[str, MeshCycleData], list[str]]:
    """Add transmission errors and load sharing to mesh cycles (with the stiffness of their ratio 1 [N/m])."""
    from pitchpoint.solvers.quasistatic import roll_through
    from pitchpoint.system.compile import compile_model

    plain = {name: data for name, (data, _) in cycles.items()}
    scenario = loaded_scenario(model)
    found, notes = dict(plain), []
    for k, (name, (data, unit)) in enumerate(cycles.items()):
        if not rolls(model, name):
            continue
        try:
            system = compile_model(model, scenario)
            still = replace(scenario, quasi_static=None) if scenario is not None else None
            roll = roll_through(system, still, POINTS, mesh=name)
            if roll.sentence != "finished":
                notes.append(f"{name}: the slow roll stopped: {roll.sentence}.")
            if len(roll.position) > 2:
                found[name] = from_roll(model, name, data, unit, system, roll)
        except PitchpointError as error:
            notes.append(f"{name}: no slow roll: {error}.")
        progress(k + 1, len(cycles), name)
    return found, notes


def rolls(model: Model, mesh: str) -> bool:
    """Whether both gears of a mesh sit on bodies and one of them turns."""
    bodies = [model.body_of(g) for g in model.meshes[mesh].gears]
    return all(bodies) and any(model.bodies[str(b)].motion != "fixed" for b in bodies)


def loaded_scenario(model: Model) -> Scenario | None:
    """Scenario whose loads and drives count: a slow roll, else a time response, else a sweep."""
    for kind in ("quasi_static", "time", "sweep"):
        for scenario in model.scenarios.values():
            if scenario.kind == kind:
                return scenario
    return None


def from_roll(
    model: Model, mesh: str, data: MeshCycleData, unit: float, system: System, roll: Roll
) -> MeshCycleData:
    """Mesh cycle with what a roll found, over the mesh phase."""
    from pitchpoint.analysis.load_sharing import share_along_path
    from pitchpoint.core.units import format_quantity

    def channel(name: str) -> np.ndarray:
        values: np.ndarray = roll.rows[:, system.layout.channel(f"{name}[{mesh}]")]
        return values

    pair, one = model.pairs[mesh], roll.meshes[mesh]
    force = float(channel("mesh_force").mean())
    sharing = share_along_path(
        channel("mesh_phase"), one.share, pair.eps_alpha, pair.eps_beta, other_flank=force < 0.0
    )
    phase = (channel("mesh_phase") - sharing.offset) % 1.0
    order = np.argsort(phase[:-1], kind="stable")
    loaded = bool(np.all(channel("mesh_force") != 0.0))
    errors = {"without load": closed(one.unloaded[order])}
    if loaded:
        title = f"mesh force {format_quantity(abs(force), 'force', 4)}"
        errors[title] = closed(channel("transmission_error")[order])
    slope = closed(one.tangent_stiffness[order]) / unit
    where = closed(phase[order], 1.0)
    law = np.interp(where, data.stiffness.phase, data.stiffness.stiffness_ratio)
    # a jump of the law lies between two points of the roll
    differs = float(np.median(np.abs(slope - law))) > SAME * float(data.stiffness.mean)
    return replace(
        data,
        error_phase=where,
        errors=errors,
        loaded_ratio=slope if loaded and differs else (),
        share_way=sharing.way if loaded else (),
        share=sharing.share if loaded else (),
    )


def closed(values: np.ndarray, further: float = 0.0) -> np.ndarray:
    """One cycle with its first value again at the end."""
    return np.append(values, values[0] + further)


def linear_parts(model: Model) -> tuple[ModeData | None, CampbellData | None, list[str]]:
    """Modes about the loaded state and Campbell data over the speed of the first body in mesh."""
    from pitchpoint.solvers.campbell import follow_modes
    from pitchpoint.solvers.modal import find_modes
    from pitchpoint.system.compile import compile_model
    from pitchpoint.viz.report import CampbellData, ModeData

    if not model.bodies:
        return None, None, []
    scenario = loaded_scenario(model)
    try:
        system = compile_model(model, scenario)
        found = find_modes(system, scenario)
        modes = ModeData(
            names=found.names, frequency=found.frequency.tolist(), damping_ratio=found.damping_ratio.tolist()
        )
        body = reference_body(model)
        top = highest_speed(model, body, found.frequency) if body else 0.0
        if not top > 0.0:
            return modes, None, []
        data = follow_modes(system, np.linspace(0.0, top, SPEEDS), body, scenario)
    except PitchpointError as error:
        return None, None, [f"No modes: {error}."]
    vibrating = data.frequency.max(axis=0) > 1e-6 * max(float(data.frequency.max()), 1e-300)
    orders = {
        f"{mesh} × {k}": k * order
        for mesh, order in data.orders.items()
        if order > 0.0
        for k in range(1, HARMONICS + 1)
    }
    campbell = CampbellData(
        speed=data.speed,
        mode_frequencies=data.frequency[:, vibrating],
        orders=orders,
        mode_names=[name for name, moves in zip(data.names, vibrating, strict=True) if moves],
    )
    return modes, campbell if vibrating.any() and orders else None, []


def reference_body(model: Model) -> str | None:
    """First body with a gear in mesh that turns."""
    in_mesh = {g for mesh in model.meshes.values() for g in mesh.gears}
    for name, body in model.bodies.items():
        if body.motion != "fixed" and in_mesh & set(body.gears):
            return name
    return None


def highest_speed(model: Model, body: str, frequency: Any) -> float:
    """End of the Campbell diagram [rad/s]: the mesh frequency has met every mode, and every scenario fits."""
    from pitchpoint.model.scenario import Scenario

    ratios = model.start_speeds(Scenario(speed={body: 1.0}))
    orders = []
    for mesh in model.meshes.values():
        turning = str(model.body_of(mesh.gears[0]))
        orders.append(abs(ratios.get(turning, 0.0)) * model.gears[mesh.gears[0]].number_of_teeth)
    lowest = min((o for o in orders if o > 0.0), default=math.inf)
    speeds = [abs(model.start_speeds(s).get(body, 0.0)) for s in model.scenarios.values() if s.speed]
    return 1.2 * max(2.0 * math.pi * float(np.max(frequency, initial=0.0)) / lowest, *speeds, 0.0)
