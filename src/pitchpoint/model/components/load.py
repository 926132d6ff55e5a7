# SPDX-License-Identifier: Apache-2.0
"""Torques and forces on bodies."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from pitchpoint.model.component import Component
from pitchpoint.model.components.law import Law
from pitchpoint.model.keys import choice, derived, key, quantities, text


@dataclass(frozen=True, kw_only=True)
class Load(Component):
    """A torque about the spin axis of a body, a force and a moment on it; one of them or several."""

    body: str = text("name of the body; or of a beam, with the number of a station as marker")
    torque: Law | None = key(
        "law",
        "torque about the spin axis, counter-clockwise positive: a quantity, a formula of t, angle, speed, "
        "{table: [[t, T], ...] or FILE.csv, over: time|angle, shift: ...}, "
        "{python: 'file.py:function', parameters: [...]}, balance",
        None,
        dimension="torque",
        also=("power",),
    )
    force: tuple[Law, ...] | None = key(
        "laws",
        "force [x, y, z], each entry as for torque (no balance)",
        None,
        dimension="force",
        length=(3, 3),
    )
    moment: tuple[Law, ...] | None = key(
        "laws",
        "moment [x, y, z], such as the bending moment of a rotor hub, each entry as for torque (no balance)",
        None,
        dimension="torque",
        length=(3, 3),
        later=True,
    )
    position: tuple[float, float, float] = quantities(
        "length",
        "point of action relative to the origin of the body; x and y are directions fixed in space that do "
        "not spin with the body, z is along its axis",
        (0.0, 0.0, 0.0),
        length=(3, 3),
    )
    marker: str | None = text(
        "marker of the body at which force and moment act, instead of position; it moves with the body", None
    )
    along: str = choice(
        ("world", "marker"),
        "axes of force and moment at a marker: of the world or of the marker",
        "world",
    )
    reaction: str | None = text(
        "body that takes the reaction, at the same point; angle and speed in laws are relative to it",
        None,
        display="ground",
    )
    given: Any = derived()
    """The load as given, if it has the values of a load case."""
