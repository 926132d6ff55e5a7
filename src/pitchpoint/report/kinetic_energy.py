# SPDX-License-Identifier: Apache-2.0
"""Kinetic energy of rotation: bodies at their rest positions, and beams with distributed mass.

The mass of a beam is a part of its forces, R = M a - f. Its energy is v M v / 2 at the positions in which the
span begins and ends. Rates are recorded speeds, and differences of the recorded displacements.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import registry
from pitchpoint.report.scene.motion import coordinates
from pitchpoint.report.stored_energy import move_to, rates_of_tilts, rotation_vectors
from pitchpoint.solvers.element_tangents import switched
from pitchpoint.system import evaluate

if TYPE_CHECKING:
    from pitchpoint.report.power_flow import Machine
    from pitchpoint.system.system import State, System

Array = NDArray[np.float64]


def body_energy(machine: Machine, b: int) -> Array:
    """Kinetic energy of a body at both ends of the span, at its rest position [J].

    Parameters
    ----------
    machine
        Machine with its result.
    b
        Number of the body.
    """
    record, axes = machine.system.program["body"][b], machine.axes[b]
    inertia = axes @ record["inertia"] @ axes.T
    center = axes @ record["com"]
    turn, speed = np.zeros((2, 3)), np.zeros((2, 3))
    for a in machine.carriers(b):
        spin = np.outer(machine.spin[a][[0, -1]], machine.axis[a])
        turn += spin
        speed += np.cross(spin, machine.place[b] - machine.place[a])
    along = (speed * (speed + 2.0 * np.cross(turn, center))).sum(axis=1)
    return np.asarray(0.5 * (float(record["mass"]) * along + ((turn @ inertia) * turn).sum(axis=1)))


def element_energy(machine: Machine, on: Mapping[str, NDArray[np.int64]]) -> Array:
    """Kinetic energy of elements with mass at both ends of the span [J], shape (2,).

    Parameters
    ----------
    machine
        Machine with its result.
    on
        Numbers of the elements by kind.
    """
    system = machine.system
    heavy = {name: rows for name, rows in on.items() if not registry.find(name).massless}
    if not heavy:
        return np.zeros(2)
    found, state = np.zeros(2), system.initial_state()
    for end in (0, 1):
        rates = _place_at_end(machine, state, end)
        for sign, elements in ((1.0, heavy), (-1.0, {})):  # without the bodies
            with switched(system, elements):
                found[end] += sign * 0.5 * float(_inertia(system, state, rates) @ rates)
    return found


def _place_at_end(machine: Machine, state: State, end: int) -> Array:
    """Put a state to rest at the beginning (0) or end (1) of the span; returns the rates."""
    system, rows = machine.system, slice(-3, None) if end else slice(3)
    time = machine.time[rows]

    def read(name: str) -> Array | None:
        """Channel at the samples nearest to the end."""
        values = machine.known(name)
        return None if values is None else values[rows]

    q, charts, _ = coordinates(system, time.size, read)
    at = -1 if end else 0
    move_to(system, state, q[at])
    state.charts[:] = charts[at]
    rates = np.zeros_like(state.v)
    if time.size == 3:
        tilts = rotation_vectors(np.swapaxes(charts[at], -1, -2) @ charts)
        moved = q + rates_of_tilts(system, tilts)
        rates += np.gradient(moved, time, axis=0, edge_order=2)[at]
    for b, speed in machine.spin.items():
        rates[system.program["body"]["spin"][b]] = speed[at]
    return rates


def _inertia(system: System, state: State, a: Array) -> Array:
    """Inertia forces M a of the elements and of the bodies."""
    state.a[:] = 0.0
    rest = evaluate.residual(system, state)
    state.a[:] = a
    return evaluate.residual(system, state) - rest
