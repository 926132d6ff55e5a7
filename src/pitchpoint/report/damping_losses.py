# SPDX-License-Identifier: Apache-2.0
"""Mean power dissipated by the damping of elastic elements: bearings, springs, shafts.

P_d = (f(q, 0) - f(q, v)) v with the generalised forces f of the elements, which at rest are the elastic ones.
With distributed mass, P_d = (f(q, -v) - f(q, v)) v / 2: centrifugal and Coriolis forces do not depend on the
sign of the rates. Rates are differences of the recorded coordinates, so the record must contain all steps.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import registry
from pitchpoint.elements.kind import RAYLEIGH, WITH_STATE
from pitchpoint.report.scene.motion import coordinates
from pitchpoint.report.stored_energy import move_to, rates_of_tilts, rotation_vectors
from pitchpoint.solvers.element_tangents import switched
from pitchpoint.solvers.model_damping import with_damping
from pitchpoint.system import evaluate

if TYPE_CHECKING:
    from collections.abc import Callable

    from pitchpoint.system.system import System

Array = NDArray[np.float64]

SAMPLES = 5000
"""Largest number of evaluated samples. A longer record is divided into so many pieces, each with one sample
at random, so that the samples are not synchronous with the teeth."""


def damped_kinds(system: System, elastic: tuple[str, ...]) -> tuple[str, ...]:
    """Elastic kinds whose forces follow from position and rates alone, and the damping of all coordinates."""
    found = [name for name in elastic if registry.find(name).pairs != WITH_STATE]
    return (*found, *system.kinds(RAYLEIGH))


def started(system: System, first: Callable[[str], Array | None]) -> System:
    """System with the Rayleigh and modal damping of a run, which is that about its initial state.

    Parameters
    ----------
    system
        The machine.
    first
        Function that returns the first sample of a channel, shape (1,), or None.
    """
    if not system.kinds(RAYLEIGH):
        return system
    q, _, _ = coordinates(system, 1, first)
    state = system.initial_state()
    move_to(system, state, q[0])
    return with_damping(system, state)


def damping_loss(
    system: System,
    read: Callable[[str], Array | None],
    time: Array,
    on: Mapping[str, slice | NDArray[np.int64]],
) -> float:
    """Mean power dissipated by some elements [W].

    Parameters
    ----------
    system
        The machine.
    read
        Function that returns a channel at the times, shape (n,), or None.
    time
        Times of all steps [s], shape (n,).
    on
        Numbers of the elements by kind.
    """
    if not on or time.size < 3:
        return 0.0
    q, charts, _ = coordinates(system, time.size, read)
    v = np.gradient(q, time, axis=0, edge_order=2)
    v += rates_of_tilts(system, _angular_velocities(charts, time))
    chosen, weights = _drawn(time)
    places, v, time = (q[chosen], charts[chosen]), v[chosen], time[chosen]
    light = {name: rows for name, rows in on.items() if registry.find(name).massless}
    lost = np.zeros(chosen.size)
    # inertia forces of the bodies are in both residuals
    for sign, elements in ((1.0, light), (-1.0, {})) if light else ():
        with switched(system, elements):
            lost += sign * _powers(system, places, v, time, 0.0)
    heavy = {name: rows for name, rows in on.items() if name not in light}
    if heavy:
        with switched(system, heavy):
            lost += 0.5 * _powers(system, places, v, time, -1.0)
    return float(weights @ lost)


def _angular_velocities(charts: Array, time: Array) -> Array:
    """Angular velocities of tumbling bodies relative to their parents, body axes, shape (n, charts, 3)."""
    low, high = np.maximum(np.arange(time.size) - 1, 0), np.minimum(np.arange(time.size) + 1, time.size - 1)
    turned = np.swapaxes(charts[low], -1, -2) @ charts[high]
    return rotation_vectors(turned) / (time[high] - time[low])[:, None, None]


def _powers(system: System, places: tuple[Array, Array], v: Array, time: Array, other: float) -> Array:
    """Power against the rates, without that of the forces at `other` times the rates [W], shape (n,)."""
    found, state = np.empty(time.size), system.initial_state()
    for k, t in enumerate(time):
        move_to(system, state, places[0][k])
        state.charts[:] = places[1][k]
        state.t = float(t)
        state.v[:] = other * v[k]
        rest = evaluate.residual(system, state)
        state.v[:] = v[k]
        found[k] = (evaluate.residual(system, state) - rest) @ v[k]
    return found


def _drawn(time: Array) -> tuple[NDArray[np.int64], Array]:
    """Numbers of the evaluated samples, and their weights in the mean."""
    steps = np.diff(time)
    own = 0.5 * (np.append(0.0, steps) + np.append(steps, 0.0)) / (time[-1] - time[0])
    edges = np.unique(np.linspace(0, time.size, min(SAMPLES, time.size) + 1).astype(np.int64))
    return np.random.default_rng(0).integers(edges[:-1], edges[1:]), np.add.reduceat(own, edges[:-1])
