# SPDX-License-Identifier: Apache-2.0
"""Levels of a finding in all tested channels: the nearest of the given sensors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from pitchpoint.analysis.diagnosis import Diagnosis
from pitchpoint.analysis.findings import COMBS, Evidence, Finding
from pitchpoint.analysis.same_fault import fundamental, same_lines
from pitchpoint.analysis.turning_parts import TurningParts
from pitchpoint.report.diagnosis.channels import Places, each
from pitchpoint.report.diagnosis.words import NOT_VISIBLE, evidence_in, unit_of

LISTED = 3
"""Maximum number of channels in a sentence."""
_KINDS = {kind: rank for rank, kind in enumerate(COMBS)}


@dataclass(frozen=True)
class ChannelLevel:
    """Evidence of one finding in one channel.

    Attributes
    ----------
    channel
        Name of the channel.
    value, limit
        Test value and its limit, in dB, for combs and periods in standard deviations.
    unit
        Unit of both.
    visible
        Whether the channel has the lines of the finding above their limit.
    """

    channel: str
    value: float
    limit: float
    unit: str
    visible: bool


def at_sensors(
    diagnosis: Diagnosis, parts: TurningParts, turns: float, places: Places
) -> tuple[Diagnosis, tuple[tuple[ChannelLevel, ...], ...]]:
    """Diagnosis that agrees with the places of the channels, and the levels by finding.

    Of bearings with the same lines, the one next to the nearest sensor is named first. A bearing whose own
    sensor does not show the fault is not named.

    Parameters
    ----------
    diagnosis
        The diagnosis.
    parts
        Rotating parts.
    turns
        Revolutions of the reference shaft in the record [-].
    places
        Where the channels are.
    """
    kept, levels, notes, evidence = [], [], [], list(diagnosis.evidence)
    for finding in diagnosis.findings:
        rows = levels_of(finding, diagnosis, parts, turns)
        own = [row for row in rows if places.near(row.channel) & _candidates(finding)]
        if not own or any(row.visible for row in own):
            kept.append(at_nearest(finding, rows, places))
            levels.append(rows)
            continue
        hidden = f"{NOT_VISIBLE}{', '.join(row.channel for row in own)}"
        notes.append(
            f"{finding.shaft} of {finding.gears[0]} in {finding.channel}: {hidden}, next to this bearing; "
            "the fault is that of another part, or check the bearings and the places of the sensors"
        )
        mine = evidence_in(finding, diagnosis)
        evidence = [replace(e, found=False, explained=hidden) if e in mine else e for e in evidence]
    found = replace(
        diagnosis,
        findings=tuple(kept),
        evidence=tuple(evidence),
        unreported=(*diagnosis.unreported, *notes),
    )
    return found, tuple(levels)


def _candidates(finding: Finding) -> set[str]:
    """Names of the bearings that a finding may be about; empty for shafts and gears."""
    if finding.kind != "bearing":
        return set()
    merged = [finding.gears[0], *(part.rpartition(" of ")[2] for part in finding.bearings)]
    return {name for one in merged for name in each(one)}


def levels_of(
    finding: Finding, diagnosis: Diagnosis, parts: TurningParts, turns: float
) -> tuple[ChannelLevel, ...]:
    """Levels of a finding in all channels, the highest first.

    The levels of a part of a bearing are those of one detector, that of the finding. A channel in which the
    test of the part has other lines than the finding does not show the fault.

    Parameters
    ----------
    finding
        The finding.
    diagnosis
        Diagnosis with the finding.
    parts
        Rotating parts.
    turns
        Revolutions of the reference shaft in the record [-].
    """
    mine = [e for e in diagnosis.evidence if e.shaft == finding.shaft and _is_of(e, finding)]
    first = [e for e in mine if e.channel == finding.channel and e.found]
    if not first:
        return ()
    best = min(first, key=lambda e: (_KINDS.get(e.kind, 2), e.probability, e.threshold - e.value))
    mine = [e for e in mine if (e.kind, e.gear) == (best.kind, best.gear)]
    order, detector = fundamental(best, parts), next(iter(best.detectors), "")
    same = [e for e in mine if e.kind != "bearing" or same_lines(fundamental(e, parts), order, turns)]
    rows = []
    for e in (best, *(e for e in mine if e.channel != best.channel)):
        value, limit = e.levels.get(detector, (e.value, e.threshold))
        rows.append(ChannelLevel(e.channel, value, limit, unit_of(e.kind), e.found and e in same))
    rows.sort(key=lambda row: (not row.visible, row.limit - row.value))
    return tuple(rows)


def _is_of(e: Evidence, finding: Finding) -> bool:
    """Whether a test is one of the part of a finding."""
    if finding.kind == "bearing":
        return e.kind == "bearing" and e.gear == finding.gears[0]
    return e.kind in (*COMBS, "sidebands")


def nearest_sensor(finding: Finding, rows: Sequence[ChannelLevel], places: Places) -> str:
    """Sentence about the channel with the highest level; empty for a single channel.

    Parameters
    ----------
    finding
        The finding.
    rows
        Levels of `levels_of`.
    places
        Where the channels are.
    """
    if len(rows) < 2:
        return ""
    best, others = rows[0], rows[1:]
    seen = [row for row in others if row.visible]
    # the other lines of an invisible one are an upper limit of the level at those of the finding
    apart = best.value - best.limit - max(max(row.value - row.limit for row in seen or others), -best.limit)
    at = f"{best.channel}{_beside(finding, best.channel, places)}"
    if apart >= 0.5:
        at += f" (by {'' if seen else 'more than '}{apart:.0f} {best.unit})"
    listed = [
        f"{row.value - row.limit:.0f} {row.unit} above the limit in {row.channel}"
        if row.value >= row.limit
        else f"visible to another detector in {row.channel}"
        for row in seen[:LISTED]
    ]
    listed += [f"less in {len(seen) - LISTED} more"] * (len(seen) > LISTED)
    hidden = [row.channel for row in others if not row.visible]
    named = ", ".join(hidden) if len(hidden) <= LISTED else f"{len(hidden)} others"
    listed += [f"below the limit in {named}"] * bool(hidden)
    text = f"nearest of the given sensors: {at}; {'; '.join(listed)}"
    return text + _elsewhere(finding, best.channel, [row.channel for row in others], places)


def _beside(finding: Finding, channel: str, places: Places) -> str:
    """Which of several candidates a channel is near to; empty if it is near all or none."""
    candidates = _candidates(finding)
    near = sorted(candidates & places.near(channel))
    return f", near {' and '.join(near)}" if near and len(near) < len(candidates) else ""


def _elsewhere(finding: Finding, best: str, others: Sequence[str], places: Places) -> str:
    """Remark if the nearest sensor is that of another bearing although the damaged one has its own."""
    if finding.kind != "bearing":
        return ""
    bearings = {bearing.name for bearing in places.parts.bearings}
    named = set(each(finding.gears[0]))
    at = sorted(places.near(best) & bearings)
    own = [channel for channel in others if places.near(channel) & named]
    if not at or named & set(at) or not own:
        return ""
    return (
        f"; it is near {', '.join(at)}, and {own[0]} is near {' or '.join(sorted(named))}: check the "
        "bearings and the places of the sensors"
    )


def at_nearest(finding: Finding, rows: Sequence[ChannelLevel], places: Places) -> Finding:
    """Finding that names first the bearing next to its nearest sensor, among those with the same lines.

    Parameters
    ----------
    finding
        The finding; bearings of equal orders are merged in its name.
    rows
        Levels of `levels_of`.
    places
        Where the channels are.
    """
    if finding.kind != "bearing" or len(rows) < 2:
        return finding
    near = places.near(rows[0].channel)
    others = {name: part for part in finding.bearings for name in each(part.rpartition(" of ")[2])}
    if near & set(each(finding.gears[0])) or len(near & set(others)) != 1:
        return finding
    (name,) = near & set(others)
    part = others[name].rpartition(" of ")[0]
    rest = tuple(one for one in finding.bearings if one != others[name])
    return replace(
        finding,
        shaft=part,
        gears=(others[name].rpartition(" of ")[2],),
        bearings=(f"{finding.shaft} of {finding.gears[0]}", *rest),
    )
