# SPDX-License-Identifier: Apache-2.0
"""Levels of bearing parts in all detectors, on measured and simulated machines whose state is known."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from math import ceil

import numpy as np

from pitchpoint.analysis.bearing_detectors import LIMITS, PartLevels, part_levels
from pitchpoint.analysis.shaft_tests import SLIP
from pitchpoint.analysis.turning_parts import Shaft, TurningParts
from pitchpoint.report.diagnosis.bearings import given_bearing
from pitchpoint.report.diagnosis.steady_speed import at_speed
from tests.support.measured_sets import gearbox_records, motor_records
from tests.support.simulated_bearings import PARTS, bearing_machine

BEARINGS = ("6203-2RS JEM", "6205-2RS JEM", "6208")
FALSE_ALARM = 0.01
MARGIN = 1.0
"""Least distance of a limit from the highest level of a sound part [dB]; limits are whole numbers."""


@dataclass(frozen=True)
class Levels:
    """Levels of one part in one record [dB], by detector, the damaged part, and whether the part is named.

    A part that a detector does not distinguish from the damaged one is named together with it: `alike`.
    """

    machine: str
    record: str
    part: str
    damaged: str
    levels: dict[str, float]
    named: bool
    alike: bool

    @property
    def sound(self) -> bool:
        """Whether the part is not damaged; a cage has the lines of its damaged rolling elements, too."""
        with_balls = (self.part, self.damaged) == ("cage", "rolling element")
        return self.part != self.damaged and not with_balls and not self.alike


def levels_of(values: np.ndarray, rate: float, speed: float, parts: TurningParts) -> list[PartLevels]:
    """Levels of all parts at a nominal speed [Hz], as `diagnose` determines them."""
    over = at_speed({"x": values}, rate, parts, speed, 0.02)
    found, _ = part_levels(
        over.signals["x"],
        over.samples_per_turn,
        parts,
        tolerance=over.tolerance,
        slip=SLIP,
        false_alarm=FALSE_ALARM,
    )
    return found


def rows(machine: str, record: str, damaged: str, found: list[PartLevels]) -> Iterator[Levels]:
    """One row per part."""
    for part in found:
        levels = {name: family.strength for name, family in part.families.items()}
        same = {name for family in part.families.values() if family.named for name in family.same_lines}
        alike = bool(damaged) and any(name.startswith(damaged) for name in same)
        yield Levels(machine, record, part.part, damaged, levels, part.named, alike)


def of_motor(bearing: str = BEARINGS[1]) -> Iterator[Levels]:
    """The motor of Case Western Reserve University, sensor at the drive end."""
    from scipy.io import loadmat

    for record in motor_records():
        x = loadmat(record.file)[record.channel].ravel().astype(np.float64)
        found = levels_of(x, 12_000.0, record.speed / 60.0, rotor_with(bearing))
        yield from rows("motor", record.file.stem, record.part, found)


def of_gearbox() -> Iterator[Levels]:
    """The gearbox simulator as a machine whose gears are not given, with three bearings it does not have."""
    from pandas import read_csv

    for file, _ in gearbox_records():
        channels = read_csv(file).to_numpy(dtype=np.float64)
        for number in range(4):
            for bearing in BEARINGS:
                found = levels_of(channels[:, number], 12_800.0, 29.7, rotor_with(bearing))
                yield from rows("gearbox", f"{file.name} {number} {bearing}", "", found)


def of_simulations(machines: range) -> Iterator[Levels]:
    """Simulated machines, each with three records of every state at three levels of the impacts."""
    for number in machines:
        machine = bearing_machine(number)
        for k in range(3 * len(PARTS)):
            part, level = PARTS[k % len(PARTS)], -24.0 + 8.0 * (k // len(PARTS)) + 2.0 * (number % 4)
            x = machine.record(part, level, 1000 * number + k)
            found = levels_of(x, machine.sample_rate, machine.speed, machine.parts)
            yield from rows("simulated", f"{number} {part} {level:g} dB", part, found)


def rotor_with(bearing: str) -> TurningParts:
    """A rotor with one bearing of a designation."""
    rotor = TurningParts((Shaft("rotor", Fraction(1)),), ())
    given = given_bearing(f"bearing:{bearing}", rotor, {})
    return TurningParts(rotor.shafts, (), (given.bearing,))


def highest_sound(table: list[Levels]) -> dict[str, float]:
    """Highest level of a sound part by detector [dB], cages omitted: they share lines with rings."""
    return {
        name: max(row.levels.get(name, -np.inf) for row in table if row.sound and row.part != "cage")
        for name in LIMITS
    }


def limits_of(table: list[Levels]) -> dict[str, int]:
    """Limits counted on records: the whole number at least 1 dB above the highest level of a sound part."""
    return {name: ceil(level + MARGIN) for name, level in highest_sound(table).items()}


def above(table: list[Levels], limits: dict[str, float]) -> tuple[int, int]:
    """Numbers of damaged and sound parts with a level above its limit in a detector."""
    over = [r for r in table if r.part != "cage" and any(r.levels[k] >= limits[k] for k in r.levels)]
    return sum(r.part == r.damaged for r in over), sum(r.sound for r in over)
