# SPDX-License-Identifier: Apache-2.0
"""Clutches and brakes with dry friction."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.components.law import Law
from pitchpoint.model.keys import choice, key, positive, quantity


@dataclass(frozen=True, kw_only=True)
class Clutch:
    """Clutch between two bodies, or brake of one body against ground."""

    bodies: tuple[str, ...] = key(
        "names", "names of its two bodies; one name alone: a brake on ground", length=(1, 2)
    )
    capacity: Law = key(
        "law",
        "torque while it slips fast, 0 where it is open: a quantity, a formula of t, angle, speed, "
        "{table: [[t, T], ...]}, {python: 'file.py:function', parameters: [...]}",
        dimension="torque",
    )
    static_ratio: float = quantity(
        "dimensionless", "friction at rest over that of fast slip", 1.0, minimum=1.0, maximum=10.0
    )
    stribeck_speed: float = quantity(
        "angular_speed", "slip within which friction falls from the one to the other", 0.0, minimum=0.0
    )
    law: str = choice(
        ("bristles", "smooth"),
        "bristles: sticks without creep, elastic until it slips; smooth: friction grows with the slip up to "
        "slip_speed, so it creeps under load",
        "bristles",
    )
    wind_up: float = positive("angle", "bristles: angle of twist at the capacity", 1e-3)
    holding: float = quantity(
        "dimensionless",
        "bristles: share of the capacity up to which nothing slips",
        0.8,
        minimum=0.0,
        maximum=1.0,
        below=True,
    )
    damping_time: float = quantity(
        "time", "bristles: damping over stiffness of the bristles", 1e-3, minimum=0.0
    )
    slip_speed: float = positive("angular_speed", "smooth: slip of full friction", 0.1)
