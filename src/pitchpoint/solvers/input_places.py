# SPDX-License-Identifier: Apache-2.0
"""Inputs of a run that another program advances: constant loads and constant speeds of drives.

The speed of a drive is the value at the end of a communication step; it varies linearly within the step. Thus
the angle, the integral of the speed, and the acceleration, its derivative, are consistent, and no torque is
infinite.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from pitchpoint.elements.drive import RAMP, SPEED
from pitchpoint.elements.kind import DRIVE, FORCE, TORQUE
from pitchpoint.elements.signal import CONSTANT
from pitchpoint.system.system import System

SAME = 1e-14
"""Relative difference up to which two speeds are equal: round-off of a ramp."""


@dataclass(frozen=True)
class Place:
    """Number in the memory of a model that may be changed: a load, or a parameter with all words it is in.

    Parameters
    ----------
    name, unit, text
        Name, unit and description.
    start
        Value in the image.
    words
        Offset of each word, and coefficients c of its change c[0] d + c[1] d^2 + ... for a change d of the
        value; of a drive, the offset of its record.
    least, most
        Range of the value.
    """

    name: str
    unit: str
    text: str
    start: float
    words: tuple[tuple[int, tuple[float, ...]], ...]
    least: float = -math.inf
    most: float = math.inf


def polynomial(coefficients: Sequence[float], change: float) -> float:
    """Change of a word for a change of the value, see `Place`.

    Examples
    --------
    >>> polynomial((2.0, 3.0), 10.0)
    320.0
    """
    total = 0.0
    for each in reversed(coefficients):
        total = (total + each) * change
    return total


def load_places(system: System, at: Mapping[str, int]) -> list[Place]:
    """Constant loads of a system as inputs.

    Parameters
    ----------
    system
        The system.
    at
        Offset of each of its arrays, see `system.image.offsets`.
    """
    found = []
    for role in (TORQUE, FORCE):
        for kind in system.kinds(role):
            bank = system.records[kind]
            base, width = at[f"records.{kind}"], bank.dtype.itemsize
            value = bank.dtype.fields["value"][1]  # type: ignore[index]
            for k, label in enumerate(system.names[kind]):
                if bank[k]["form"] == CONSTANT and bank[k]["ramp"] == 0.0:
                    name, unit, text = _load_words(role, label)
                    words = ((base + k * width + value, (1.0,)),)
                    found.append(Place(name, unit, text, float(bank[k]["value"]), words))
    return found


def drive_places(system: System, at: Mapping[str, int]) -> list[Place]:
    """Constant speeds of drives as inputs.

    Parameters
    ----------
    system, at
        As for `load_places`.
    """
    found = []
    for name, (kind, k) in constant_drives(system).items():
        bank, word = system.records[kind], name.rpartition(".")[2]
        text = f"prescribed {word}, at the end of a communication step"
        place = ((at[f"records.{kind}"] + k * bank.dtype.itemsize, ()),)
        unit = "m/s" if bank[k]["linear"] else "rad/s"
        found.append(Place(name, unit, text, float(bank[k]["speed"]), place))
    return found


def constant_drives(system: System) -> dict[str, tuple[str, int]]:
    """Name of the input, kind and number of each drive with a constant speed and without a ripple."""
    held = () if system.scenario is None else system.scenario.hold
    return {
        f"drive.{label}.{'velocity' if record['linear'] else 'speed'}": (kind, k)
        for kind in system.kinds(DRIVE)
        for k, (record, label) in enumerate(zip(system.records[kind], system.names[kind], strict=True))
        if record["form"] == SPEED and record["waves"] == 0 and label not in held
    }


def lead(record: np.void, value: float, t: float, size: float) -> bool:
    """Let the speed of a drive vary linearly to a value in the next communication step.

    Parameters
    ----------
    record
        Record of the drive (`elements.drive.RECORD`), changed in place.
    value
        Speed at the end of the step [rad/s, m/s].
    t, size
        Start of the step, and its size [s].

    Returns
    -------
    bool
        Whether the acceleration jumps at t.
    """
    gain = float(record["gain"]) if record["form"] == RAMP else 0.0
    x = t - float(record["since"]) if record["form"] == RAMP else t
    angle = float(record["angle"]) + x * (float(record["speed"]) + 0.5 * gain * x)
    speed = float(record["speed"]) + gain * x
    if abs(value - speed) <= SAME * (abs(value) + abs(speed)):
        speed = value
    new = (value - speed) / size
    if new == 0.0 and gain == 0.0:
        return False
    record["form"], record["angle"], record["since"] = RAMP, angle, t
    record["speed"], record["gain"] = speed, new
    return True


def shafts(system: System) -> Iterator[tuple[str, str, str, str]]:
    """Variables of every shaft with a torque or a drive: name, torque, angle, speed."""
    for kind in system.kinds(TORQUE):
        for record, label in zip(system.records[kind], system.names[kind], strict=True):
            torque, body = _load_words(TORQUE, label)[0], system.layout.bodies[int(record["i"])]
            yield torque, torque, f"angle[{body}]", f"speed[{body}]"
    for kind in system.kinds(DRIVE):
        for record, label in zip(system.records[kind], system.names[kind], strict=True):
            body, speed = system.layout.bodies[int(record["i"])], f"drive.{label}.speed"
            yield speed, f"torque[{label}]", f"angle[{body}]", speed


def _load_words(role: str, label: str) -> tuple[str, str, str]:
    """Name, unit and description of a load.

    Examples
    --------
    >>> _load_words("torque", "drive")
    ('loads.drive.torque', 'N m', 'torque about the spin axis')
    >>> _load_words("force", "rotor.mx")
    ('loads.rotor.moment_x', 'N m', 'moment x')
    """
    if role == TORQUE:
        return f"loads.{label}.torque", "N m", "torque about the spin axis"
    load, _, part = label.rpartition(".")
    word, unit = ("moment", "N m") if part.startswith("m") else ("force", "N")
    return f"loads.{load}.{word}_{part[-1]}", unit, f"{word} {part[-1]}"
