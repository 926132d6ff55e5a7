# SPDX-License-Identifier: Apache-2.0
"""Mean power dissipated by the damping of elastic elements: bearings, springs, shafts.

P_d = (f(q, 0) - f(q, v)) v with the generalised forces f of the elements, which at rest are the elastic ones.
Rates are differences of the recorded coordinates, so the record must contain all steps.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import registry
from pitchpoint.elements.kind import RAYLEIGH, WITH_STATE
from pitchpoint.report.scene.motion import coordinates
from pitchpoint.report.stored_energy import move_to
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
    q, _, _ = coordinates(system, time.size, read)
    v = np.gradient(q, time, axis=0, edge_order=2)
    chosen, weights = _drawn(time)
    lost = np.zeros(chosen.size)
    # inertia forces are in both residuals
    for sign, elements in ((1.0, on), (-1.0, {})):
        with switched(system, elements):
            lost += sign * _powers(system, q[chosen], v[chosen], time[chosen])
    return float(weights @ lost)


def _powers(system: System, q: Array, v: Array, time: Array) -> Array:
    """Power against the rates, without that of the same positions at rest [W], shape (n,)."""
    found, state = np.empty(time.size), system.initial_state()
    for k, t in enumerate(time):
        move_to(system, state, q[k])
        state.t = float(t)
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
