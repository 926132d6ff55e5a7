# SPDX-License-Identifier: Apache-2.0
"""Campbell diagram: natural frequencies over speed with mode tracking, and mesh frequencies."""

from __future__ import annotations

import time
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.model.scenario import Scenario
from pitchpoint.multibody.bodies import GENERAL
from pitchpoint.solvers.constraints.free_directions import free_directions
from pitchpoint.solvers.eigen import best_match, ratio_of, symmetric
from pitchpoint.solvers.element_tangents import inertial_stiffness
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.gear_trains import mesh_orders
from pitchpoint.solvers.initial_state.start import body_rates
from pitchpoint.solvers.linear_system import (
    Linearised,
    damped_modes,
    linearise,
    lowest,
)
from pitchpoint.solvers.modal import energy_shares
from pitchpoint.solvers.mode_names import mode_names
from pitchpoint.solvers.operating_point import scenario_named
from pitchpoint.solvers.stiffness_parts import Array
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True)
class Campbell:
    """Natural frequencies over the speed of one body.

    Parameters
    ----------
    body
        Reference body of the speed.
    speed
        Its speeds [rad/s], shape (n_speed,).
    frequency
        Damped natural frequencies [Hz], shape (n_speed, n_mode); 0 where a mode does not oscillate.
    damping_ratio
        Damping ratios, shape (n_speed, n_mode); 1 where a mode is overdamped.
    names
        Names of the modes at rest.
    orders
        Mesh frequency over the rotational frequency of the body, by mesh.
    """

    body: str
    speed: Array
    frequency: Array
    damping_ratio: Array
    names: tuple[str, ...]
    orders: dict[str, float]


def follow_modes(
    system: System,
    speeds: ArrayLike,
    body: str | None = None,
    scenario: Scenario | str | None = None,
    *,
    count: int | None = None,
    progress: Progress = silent,
    linear: Linearised | None = None,
) -> Campbell:
    """Natural frequencies over speed; parameters as in `solve_campbell`, `linear` if already computed."""
    body = body or system.layout.bodies[1]
    if body not in system.layout.bodies[1:]:
        known = ", ".join(system.layout.bodies[1:] if system.model is None else system.model.bodies)
        raise SolverError(f"no body {body!r}; there are: {known}", INCONSISTENT)
    omega = np.atleast_1d(np.asarray(speeds, dtype=np.float64))
    linear = linear or linearise(system, scenario)
    own, parts = linear.system, linear.at_rest
    rates = body_rates(own, body, scenario_named(own, scenario))
    modes = lowest(linear, count)
    values, shapes, n = modes.omega, modes.shapes, len(modes.omega)
    found, last = np.zeros((omega.size, n), complex), shapes.astype(complex)
    for s, speed in enumerate(omega):
        at = at_speeds(linear, speed * rates)
        roots, z = damped_modes(at, modes if at.at_rest is parts else lowest(at, count))
        roots, z = roots[:n], z[:n]
        # track each mode by the most similar shape
        order = best_match(np.abs(last.conj() @ parts.M @ z.T))
        found[s], last = roots[order], z[order]
        progress(s + 1, omega.size, "speeds")
    _, potential = energy_shares(parts, shapes, values)
    names = mode_names(own.layout, parts, values, shapes, potential)
    return Campbell(body, omega, found.imag / (2.0 * np.pi), ratio_of(found), names, mesh_orders(own, rates))


def at_speeds(linear: Linearised, rates: Array) -> Linearised:
    """The linear system at other speeds; with bodies in trees, about the equilibrium at these speeds."""
    stopped = _at_zero_speed(linear)
    if np.any(linear.system.program["body"]["joint"] == GENERAL):
        return _steady(linear, stopped, rates)
    return _turning(linear, stopped, rates)


def _at_zero_speed(linear: Linearised) -> State:
    """Copy of the operating point with zero speeds."""
    stopped = linear.state.copy()
    stopped.v[:] = 0.0
    return stopped


def _turning(linear: Linearised, stopped: State, rates: Array) -> Linearised:
    """The linear system at other speeds in the same position, for systems without trees of bodies."""
    at_rest, turning = linear.at_rest, stopped.copy()
    turning.v = rates
    D, K = (
        evaluate.matrix(linear.system, turning, 0.0, cd, ck)
        - evaluate.matrix(linear.system, stopped, 0.0, cd, ck)
        for cd, ck in ((1.0, 0.0), (0.0, 1.0))
    )
    return replace(linear, D=at_rest.D + D, K=at_rest.K + K)


def _steady(linear: Linearised, stopped: State, rates: Array) -> Linearised:
    """The linear system about the relative equilibrium at other speeds: bodies in trees move outwards.

    Mesh stiffness is that at rest.
    """
    system, turning = linear.system, stopped.copy()
    turning.v = rates
    state = find_equilibrium(system, turning, linear.held).state
    at_rest = state.copy()
    at_rest.v[:] = 0.0
    elastic = linear.at_rest.K.copy()
    for kind, share in zip(linear.at_rest.kinds, linear.at_rest.shares, strict=True):
        if kind == "rotation":  # centrifugal part at the speeds of the scenario
            elastic[np.ix_(share.places, share.places)] -= share.matrix
    mean = elastic - evaluate.matrix(system, stopped, 0.0, 0.0, 1.0)
    mean_D = linear.at_rest.D - evaluate.matrix(system, stopped, 0.0, 1.0, 0.0)
    D = mean_D + evaluate.matrix(system, state, 0.0, 1.0, 0.0)
    K = mean + evaluate.matrix(system, state, 0.0, 0.0, 1.0)
    M = evaluate.matrix(system, state, 1.0, 0.0, 0.0)
    K_rest = mean + evaluate.matrix(system, at_rest, 0.0, 0.0, 1.0)
    K_rest = K_rest + symmetric(inertial_stiffness(system, state, at_rest))
    parts = replace(linear.at_rest, M=M, K=K_rest)
    return replace(
        linear, state=state, at_rest=parts, D=D, K=K, basis=free_directions(system, state, linear.states)
    )


def solve_campbell(
    system: System,
    speeds: ArrayLike,
    body: str | None = None,
    scenario: Scenario | str | None = None,
    *,
    count: int | None = None,
    progress: Progress = silent,
) -> xr.Dataset:
    """Campbell data: damped natural frequencies and mesh frequencies over speed.

    Parameters
    ----------
    system
        The compiled model.
    speeds
        Speeds of one body [rad/s], shape (n_speed,).
    body
        Reference body of the speed; default the first. The speeds of the other bodies follow from the gear
        ratios; speeds that these do not determine, as in a planet set of three free members, have the ratio
        of the speeds and drives of the scenario. With bodies in trees, the relative equilibrium is computed
        for every speed.
    scenario
        Gives loads and the operating point; mesh stiffness is the mean over the mesh cycle.
    count
        Number of modes, the lowest at rest. Default: as `modal.find_modes`.
    progress
        Called after every speed.

    Returns
    -------
    xarray.Dataset
        Over `speed` [rad/s] and `mode`: frequency [Hz], 0 where a mode does not oscillate, and damping_ratio,
        1 where it is overdamped; over `mode`: name, from its shape at rest; over `mesh`: order (mesh
        frequency over rotational frequency of the body); over `speed` and `mesh`: mesh_frequency [Hz]. Modes
        are tracked over the speed by their shapes, so `frequency[:, k]` is one curve of the diagram.

    Raises
    ------
    SolverError
        If the body or scenario does not exist, or there is no equilibrium.
    """
    import xarray as xr

    from pitchpoint.solvers.dataset import attributes

    began = time.perf_counter()
    c = follow_modes(system, speeds, body, scenario, count=count, progress=progress)
    orders: NDArray[np.float64] = np.array(list(c.orders.values()), dtype=np.float64)
    both = ("speed", "mode")
    data = {
        "frequency": (both, c.frequency, {"units": "Hz", "long_name": "damped natural frequency"}),
        "damping_ratio": (both, c.damping_ratio, {"units": "1", "long_name": "damping ratio"}),
        "order": ("mesh", orders, {"units": "1", "long_name": f"mesh periods per revolution of {c.body}"}),
        "mesh_frequency": (
            ("speed", "mesh"),
            np.abs(c.speed)[:, None] * orders / (2.0 * np.pi),
            {"units": "Hz", "long_name": "mesh frequency"},
        ),
    }
    coords = {
        "speed": ("speed", c.speed, {"units": "rad/s", "long_name": f"speed of {c.body}"}),
        "mode": np.arange(1, len(c.names) + 1),
        "name": ("mode", list(c.names)),
        "mesh": list(c.orders),
    }
    attrs = attributes(system, "campbell", wall_s=time.perf_counter() - began, body=c.body)
    return xr.Dataset(data, coords=coords, attrs={**attrs, "body": c.body})
