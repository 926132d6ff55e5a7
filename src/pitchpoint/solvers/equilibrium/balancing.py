# SPDX-License-Identifier: Apache-2.0
"""Balancing torques of a model: their records and the spins of their bodies."""

from __future__ import annotations

from pitchpoint.elements import torque
from pitchpoint.model.components.law import Balance
from pitchpoint.system.system import System

LOAD = torque.KIND.name


def balancing_loads(system: System) -> list[int]:
    """Record indices of the balancing torques of the model."""
    loads = {} if system.model is None else system.model.loads
    torques = [load.torque for load in loads.values() if load.torque is not None]
    return [k for k, torque in enumerate(torques) if isinstance(torque, Balance)]


def balancing_spins(system: System) -> list[int]:
    """Spins of the bodies of the balancing torques, for a shaft of the station of the torque; same order."""
    loads = balancing_loads(system)
    acting = system.records[LOAD]["i"][loads] if loads else ()
    return [system.spin(system.layout.bodies[int(body)]) for body in acting]
