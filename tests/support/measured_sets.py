# SPDX-License-Identifier: Apache-2.0
"""Measured records in `shared/data/measured` next to the repository or above it, and what is damaged in
them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import pytest

FOLDER = next((p for above in Path(__file__).parents if (p := above / "shared/data/measured").is_dir()), None)
needs_measured = pytest.mark.skipif(
    FOLDER is None, reason="measured records (shared/data/measured) are not next to the repository"
)
OFFSETS = (0.0, 0.008, -0.008, 0.02, -0.02)
"""Relative errors of the speed that is given."""


@dataclass(frozen=True)
class MotorRecord:
    """Record of the motor of Case Western Reserve University, drive end, 12 kHz.

    Attributes
    ----------
    file
        The file.
    channel
        Channel of the accelerometer at the drive end.
    speed
        Nominal speed of the load [rpm].
    part
        Damaged part of the bearing 6205 at the drive end; empty for the healthy motor.
    diagnosable
        Whether the damage is visible with standard means (W. A. Smith, R. B. Randall, MSSP 64-65, 2015,
        100-131): the outer ring with 0.014 in and the balls are not.
    """

    file: Path
    channel: str
    speed: float
    part: str
    diagnosable: bool


def motor_records() -> list[MotorRecord]:
    """All records of the motor that are there."""
    from scipy.io import whosmat

    kinds = {"IR": "inner ring", "OR": "outer ring", "B0": "rolling element", "no": ""}
    found = []
    for file in sorted((FOLDER or Path()).glob("cwru/*.mat")):
        (channel,) = (name for name, *_ in whosmat(file) if name.endswith("DE_time"))
        part = kinds[file.stem[:2]]
        diagnosable = part == "inner ring" or file.stem.startswith(("OR007", "OR021"))
        speed = {"0": 1797.0, "2": 1750.0}[file.stem[-1]]
        found.append(MotorRecord(file, channel, speed, part, diagnosable))
    return found


def gearbox_records() -> list[tuple[Path, bool]]:
    """Records of the gearbox simulator, and whether a tooth is broken."""
    return [
        (file, file.name.startswith("b")) for file in sorted((FOLDER or Path()).glob("spectraquest/*.csv.gz"))
    ]
