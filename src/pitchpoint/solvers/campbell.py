# SPDX-License-Identifier: Apache-2.0
"""Natural frequencies over speed, followed from speed to speed, and the mesh frequencies that cross them."""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.model.scenario import Scenario
from pitchpoint.solvers.eigen import best_match, damped, ratio_of, symmetric, undamped
from pitchpoint.solvers.modal import Linearised, energy_shares, linearise, rigid_rotations
from pitchpoint.solvers.mode_names import mode_names
from pitchpoint.solvers.stiffness_parts import Array, mesh_names
from pitchpoint.system import evaluate
from pitchpoint.system.system import System

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True)
class Campbell:
    """Natural frequencies over the speed of one body.

    Parameters
    ----------
    body
        Body whose speed counts.
    speed
        Its speeds [rad/s], shape (n_speed,).
    frequency
        Damped natural frequencies [Hz], shape (n_speed, n_mode); 0 where a mode does not oscillate.
    damping_ratio
        Their shares of critical damping, shape (n_speed, n_mode), nan where a mode creeps.
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
    progress: Progress = silent,
) -> Campbell:
    """Natural frequencies over speed; parameters as in `solve_campbell`."""
    if system.model is None:
        raise SolverError("Campbell data need a system made from a model, for its gear ratios", INCONSISTENT)
    body = body or next(iter(system.model.bodies))
    if body not in system.model.bodies:
        raise SolverError(f"no body {body!r}; there are: {', '.join(system.model.bodies)}", INCONSISTENT)
    omega = np.atleast_1d(np.asarray(speeds, dtype=np.float64))
    linear = linearise(system, scenario)
    parts = linear.at_rest
    values, shapes = undamped(parts.M, parts.K, linear.basis, rigid_rotations(linear.system))
    ratios = system.model.start_speeds(Scenario(speed={body: 1.0}))
    n = len(values)
    found, last = np.zeros((omega.size, n), complex), np.eye(n, dtype=complex)
    for s, speed in enumerate(omega):
        D, K = _at_speed(linear, {name: ratio * speed for name, ratio in ratios.items()})
        roots, z = damped(D, K, shapes, values)
        # each mode goes on in the one that resembles it most
        order = best_match(np.abs(last.conj().T @ z))
        found[s], last = roots[order], z[:, order]
        progress(s + 1, omega.size, "speeds")
    kinetic, potential = energy_shares(parts, shapes, values)
    names = mode_names(linear.system.layout, parts, values, shapes, kinetic, potential)
    return Campbell(body, omega, found.imag / (2.0 * np.pi), ratio_of(found), names, _orders(system, ratios))


def _at_speed(linear: Linearised, speeds: dict[str, float]) -> tuple[Array, Array]:
    """Damping matrix at some speeds, and the stiffness matrix less its symmetric part at rest."""
    system, still = linear.system, linear.state.copy()
    still.v[:] = 0.0
    turning = still.copy()
    for name, speed in speeds.items():
        if speed != 0.0:
            turning.v[system.spin(name)] = speed
    D, K = (
        evaluate.matrix(system, turning, 0.0, cd, ck) - evaluate.matrix(system, still, 0.0, cd, ck)
        for cd, ck in ((1.0, 0.0), (0.0, 1.0))
    )
    at_rest = linear.at_rest
    return at_rest.D + D, K + at_rest.K - symmetric(at_rest.K)


def _orders(system: System, ratios: dict[str, float]) -> dict[str, float]:
    """Mesh frequency over rotational frequency of the body with ratio 1, by mesh."""
    found = {}
    for name, record in zip(mesh_names(system), system.records.get("gear_mesh", ()), strict=True):
        one, two = (system.layout.bodies[int(record[e])] for e in ("i", "j"))
        teeth, ratio = (record["z1"], ratios.get(one, 0.0))
        if ratio == 0.0:
            teeth, ratio = record["z2"], ratios.get(two, 0.0)
        found[name] = float(abs(teeth * ratio))
    return found


def solve_campbell(
    system: System,
    speeds: ArrayLike,
    body: str | None = None,
    scenario: Scenario | str | None = None,
    *,
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
        The body whose speed counts; default the first. The others follow from the gear ratios.
    scenario
        Gives loads and the operating point; meshes count with the mean over their cycle.
    progress
        Told after every speed.

    Returns
    -------
    xarray.Dataset
        Over `speed` [rad/s] and `mode`: frequency [Hz], 0 where a mode does not oscillate, and damping_ratio,
        NaN where it creeps; over `mode`: name, from its shape at rest; over `mesh`: order (mesh frequency
        over rotational frequency of the body); over `speed` and `mesh`: mesh_frequency [Hz]. Each mode is
        followed from speed to speed by its shape, so `frequency[:, k]` is one curve of the diagram.

    Raises
    ------
    SolverError
        If there is no such body or scenario, or no equilibrium.
    """
    import xarray as xr

    from pitchpoint.solvers.dataset import attributes

    began = time.perf_counter()
    c = follow_modes(system, speeds, body, scenario, progress=progress)
    orders: NDArray[np.float64] = np.array(list(c.orders.values()), dtype=np.float64)
    both = ("speed", "mode")
    data = {
        "frequency": (both, c.frequency, {"units": "Hz", "long_name": "damped natural frequency"}),
        "damping_ratio": (both, c.damping_ratio, {"units": "1", "long_name": "share of critical damping"}),
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
