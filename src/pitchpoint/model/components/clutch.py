# SPDX-License-Identifier: Apache-2.0
"""Clutches and brakes with dry friction."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.components.law import Law
from pitchpoint.model.keys import choice, derived, key, positive, quantity


@dataclass(frozen=True, kw_only=True)
class Clutch(Component):
    """Friction clutch between two bodies, or brake between a body and ground."""

    bodies: tuple[str, ...] = key(
        "names",
        "names of the two bodies, BODY or BODY.MARKER (a place on a shaft; without it the start of "
        "the shaft); one name: a brake against ground",
        length=(1, 2),
    )
    capacity: Law = key(
        "law",
        "torque capacity: friction torque at high slip, 0 when open; a quantity, a formula of t, angle, "
        "speed, {table: [[t, T], ...]}, {python: 'file.py:function', parameters: [...]}",
        dimension="torque",
        also=("torque", "torque_capacity", "friction_torque"),
    )
    static_ratio: float = quantity(
        "dimensionless", "ratio of static to sliding friction torque", 1.0, minimum=1.0, maximum=10.0
    )
    stribeck_speed: float = quantity(
        "angular_speed",
        "Stribeck speed: slip speed over which friction falls from static to sliding",
        0.0,
        minimum=0.0,
    )
    law: str = choice(
        ("bristles", "smooth"),
        "bristles: elastic sticking without creep, then slip; smooth: friction increases with the slip "
        "speed up to slip_speed, so that the clutch creeps under load",
        "bristles",
    )
    wind_up: float = positive("angle", "bristles: angle of twist at the capacity", 1e-3)
    holding: float = quantity(
        "dimensionless",
        "bristles: fraction of the capacity below which the clutch sticks",
        0.8,
        minimum=0.0,
        maximum=1.0,
        below=True,
        sample="0.8",
    )
    damping_time: float = quantity(
        "time", "bristles: ratio of damping to stiffness of the bristles", 1e-3, minimum=0.0
    )
    slip_speed: float = positive("angular_speed", "smooth: slip speed of full friction", 0.1)
    stage: str | None = derived()
    """Scissor gear that contains the clutch, if any."""
