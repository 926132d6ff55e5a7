# SPDX-License-Identifier: Apache-2.0
"""Evidence of bearing damage on machines without gears: families of lines in the whitened signal."""

from __future__ import annotations

from dataclasses import replace

from pitchpoint.analysis.bearing_tests import MIN_SAMPLES, alike
from pitchpoint.analysis.envelope import whitened_square
from pitchpoint.analysis.family_search import highest_order
from pitchpoint.analysis.fault_families import fault_families
from pitchpoint.analysis.findings import Evidence
from pitchpoint.analysis.remarks import Note
from pitchpoint.analysis.sampled import Array, SignalError
from pitchpoint.analysis.turning_parts import TurningParts

LEAST = 12.0
"""Minimum level of the first three harmonics of a damaged part above the surroundings [dB]."""
BACKGROUND_ABOVE = 1.25
"""Highest order of the squared envelope over that of the search: the background of its last lines."""
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
) -> tuple[list[Evidence], list[Note]]:
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
        Probability that noise alone leads to a detection in this channel [-].

    Returns
    -------
    list of Evidence
        One test per part.
    list of Note
        Remarks on parts that were not tested.

    Notes
    -----
    Squared envelope of the whitened signal [1]_, and `fault_families`. Without gears no sidebands of meshes
    need to be removed, and the whole band serves. Valid for steady speed or signals over the angle.

    References
    ----------
    .. [1] P. Borghesani, P. Pennacchi, R. B. Randall, N. Sawalhi, R. Ricci, Application of cepstrum
       pre-whitening for the diagnosis of bearing faults under variable speed conditions, Mechanical Systems
       and Signal Processing 36(2), 2013, 370-384.
    """
    if values.size < MIN_SAMPLES:
        return [], [
            Note(f"record: {values.size} samples are too few for bearings, needs about {MIN_SAMPLES}")
        ]
    merged = replace(parts, bearings=tuple(alike(parts.bearings)))
    square, rate = whitened_square(values, samples_per_turn, BACKGROUND_ABOVE * highest_order(merged))
    try:
        found = fault_families(
            square,
            rate,
            merged,
            tolerance=tolerance,
            slip=slip,
            prominence=LEAST,
            false_alarm=false_alarm,
        )
    except SignalError as error:
        return [], [Note(f"{channel}: {error}")]
    rows = []
    for family in found.families:
        explained = ""
        if not family.named and family.same_lines:
            explained = " and ".join(family.same_lines)
        elif not family.named and family.probability < false_alarm:
            explained = PARTLY
        rows.append(
            Evidence(
                channel=channel,
                kind="bearing",
                shaft=family.part,
                gear=family.bearing,
                # levels of averaged lines are not exact
                value=max(family.strength, LEAST) if family.named else family.strength,
                threshold=LEAST,
                probability=float(min(1.0, family.probability * len(found.families))),
                order=family.order * family.scale,
                amplitude=0.0,
                sideband=0,
                found=family.named,
                allowed=false_alarm,
                explained=explained,
                alike=family.same_lines if family.named else (),
            )
        )
    return rows, [Note(text) for text in found.notes]
