# SPDX-License-Identifier: Apache-2.0
"""Evidence of bearing damage on machines without gears: families of lines in the spectra of all detectors."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pitchpoint.analysis.bearing_detectors import LIMITS, PartLevels, part_levels
from pitchpoint.analysis.bearing_tests import MIN_SAMPLES, alike
from pitchpoint.analysis.family_search import SPREAD
from pitchpoint.analysis.fault_families import UNKNOWN
from pitchpoint.analysis.findings import Evidence
from pitchpoint.analysis.remarks import Note
from pitchpoint.analysis.sampled import Array, SignalError
from pitchpoint.analysis.turning_parts import TurningParts

PARTLY = "only some of its harmonics"
"""Why a part is not named although lines of it are significant."""


def family_evidence(
    channel: str,
    values: Array,
    samples_per_turn: float,
    parts: TurningParts,
    *,
    tolerance: float,
    slip: float,
    false_alarm: float,
    channels: int = 1,
) -> tuple[list[Evidence], list[Note], list[Note]]:
    """Test all bearing parts jointly in one channel.

    Parameters
    ----------
    channel
        Name of the channel.
    values
        Signal, shape (n,), any unit.
    samples_per_turn
        Samples per revolution of the reference shaft [-].
    parts
        Rotating parts of the machine.
    tolerance
        Relative tolerance of the speed [-].
    slip
        Maximum relative deviation of the bearing orders due to slip [-].
    false_alarm
        Probability that noise alone leads to a detection in any channel [-].
    channels
        Number of channels that share it [-].

    Returns
    -------
    list of Evidence
        One test per part.
    list of Note
        Remarks on parts that were not tested.
    list of Note
        Remarks on parts whose lines are those of impacts of no given part.

    Notes
    -----
    `bearing_detectors` [1]_. The evidence of a part is that of the first detector that names it, else of the
    one whose level is nearest to its limit. Without gears no sidebands of meshes need to be removed, and the
    whole band serves. Valid for steady speed or signals over the angle.

    References
    ----------
    .. [1] R. B. Randall, J. Antoni, Rolling element bearing diagnostics - a tutorial, Mechanical Systems and
       Signal Processing 25(2), 2011, 485-520.
    """
    if values.size < MIN_SAMPLES:
        few = f"record: {values.size} samples are too few for bearings, needs about {MIN_SAMPLES}"
        return [], [Note(few)], []
    share = -float(np.expm1(np.log1p(-false_alarm) / channels))
    merged = replace(parts, bearings=tuple(alike(parts.bearings)))
    try:
        found, notes = part_levels(
            values, samples_per_turn, merged, tolerance=tolerance, slip=slip, false_alarm=share
        )
    except SignalError as error:
        return [], [Note(f"{channel}: {error}")], []
    tests = channels * sum(len(part.families) for part in found)
    rows = [_evidence(channel, part, tests, false_alarm) for part in found]
    foreign = [
        Note(
            f"{{}} in {channel}: the lines are those of {e.explained}; give all bearings, and a larger slip "
            "if their load is low",
            f"{e.shaft} of {e.gear}",
        )
        for e in rows
        if UNKNOWN in e.explained
    ]
    return rows, [Note(text) for text in notes], foreign


def _evidence(channel: str, part: PartLevels, tests: int, allowed: float) -> Evidence:
    """Evidence of one part, by the first detector that names it, else by that nearest to its limit."""
    family, limit = part.families[part.by[0]], LIMITS[part.by[0]]
    explained, alike = "", set()
    if part.named:
        alike = {name for by in part.by for name in part.families[by].same_lines}
    elif family.same_lines:
        explained = " and ".join(family.same_lines)
    elif family.level.max() >= limit > family.level.min() + SPREAD:
        explained = PARTLY
    return Evidence(
        channel=channel,
        kind="bearing",
        shaft=part.part,
        gear=part.bearing,
        value=family.strength,
        threshold=limit,
        probability=float(min(1.0, family.probability * tests)),
        order=family.order * family.scale,
        amplitude=0.0,
        sideband=0,
        found=part.named,
        allowed=allowed,
        explained=explained,
        alike=tuple(sorted(alike)),
        detectors=part.by,
        levels={name: (one.strength, LIMITS[name]) for name, one in part.families.items()},
    )
