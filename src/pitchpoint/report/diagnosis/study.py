# SPDX-License-Identifier: Apache-2.0
"""Diagnosis of a record of a known machine, with findings in words."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from shlex import quote
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.diagnosis import Diagnosis, diagnose
from pitchpoint.analysis.pulse_trains import is_pulse_train
from pitchpoint.analysis.remarks import Note, grouped
from pitchpoint.analysis.sampled import SignalError, as_signal
from pitchpoint.analysis.shaft_tests import SLIP
from pitchpoint.analysis.turning_parts import TurningParts
from pitchpoint.report.diagnosis.channels import Places
from pitchpoint.report.diagnosis.levels import ChannelLevel, at_sensors, nearest_sensor
from pitchpoint.report.diagnosis.over_angle import OverAngle
from pitchpoint.report.diagnosis.record import strongest_lines
from pitchpoint.report.diagnosis.severity import ChannelSeverity, verdicts
from pitchpoint.report.diagnosis.tooth_places import GearTurn, local_turns, one_gear, place_sentence
from pitchpoint.report.diagnosis.words import (
    evidence_rows,
    mesh_remarks,
    nothing_found,
    observation,
    sentence,
)

if TYPE_CHECKING:
    from pitchpoint.report.diagnosis.reference import Change

Array = NDArray[np.float64]

RESIDUE = 1e-6
"""Variation over that of another channel of the unit below which a simulated channel shows solver errors."""


@dataclass(frozen=True)
class Study:
    """Result of a diagnosis.

    Attributes
    ----------
    diagnosis
        Findings and all tests.
    over
        Channels over the angle.
    parts
        Rotating parts.
    sentences
        One per finding, or one stating that nothing was found.
    observed
        One sentence per observation.
    remarks
        Remarks.
    places
        For each local fault the mean turns of the suspected gears.
    place_sentences
        One sentence about these per finding; empty for findings without mean turns.
    file
        Name of the file.
    origin
        Rows of quantity, value, origin.
    units
        Unit of each channel, if known.
    levels
        Levels of each finding by channel, the highest first.
    sensors
        One sentence about the nearest sensor per finding; empty with one channel.
    severity
        Vibration severity of the channels of acceleration or velocity.
    change
        Comparison with healthy records, if there are any.
    """

    diagnosis: Diagnosis
    over: OverAngle
    parts: TurningParts
    sentences: tuple[str, ...]
    observed: tuple[str, ...]
    remarks: tuple[str, ...]
    places: tuple[tuple[GearTurn, ...], ...] = ()
    place_sentences: tuple[str, ...] = ()
    file: str = ""
    origin: tuple[tuple[str, str, str], ...] = ()
    units: Mapping[str, str] = field(default_factory=dict)
    levels: tuple[tuple[ChannelLevel, ...], ...] = ()
    sensors: tuple[str, ...] = ()
    severity: tuple[ChannelSeverity, ...] = ()
    change: Change | None = None

    def with_severity(self, rows: tuple[ChannelSeverity, ...], remarks: Sequence[str]) -> Study:
        """Add the vibration severity, with a verdict in zones C and D."""
        words, more = self.sentences, verdicts(rows)
        return replace(
            self,
            severity=rows,
            sentences=(*words, *more) if self.diagnosis.findings else (*more, *words),
            remarks=(*self.remarks, *remarks),
        )

    def with_change(self, change: Change) -> Study:
        """Add the comparison with healthy records; its result precedes that nothing is found."""
        from pitchpoint.report.diagnosis.change_words import change_in_short

        words = self.sentences
        if not self.diagnosis.findings:
            words = (*words[:-1], f"{change_in_short(change)}; by itself {words[-1]}")
        return replace(self, change=change, sentences=words)

    def details(self, number: int) -> list[str]:
        """Sentences on the nearest sensor and the damaged tooth of a finding."""
        return [
            texts[number]
            for texts in (self.sensors, self.place_sentences)
            if number < len(texts) and texts[number]
        ]

    def as_data(self) -> dict[str, Any]:
        """Complete result as plain data."""
        hertz = self.over.frequency
        found = self.diagnosis
        return {
            "findings": [
                {
                    "kind": finding.kind,
                    "shaft": finding.shaft,
                    "gears": list(finding.gears),
                    "bearings": list(finding.bearings),
                    "channel": finding.channel,
                    "by_noise": finding.probability,
                    "sentence": words,
                    "mean_turn": [
                        {"gears": list(turn.gears)}
                        | turn.as_data(found.false_alarm, one_gear(finding, turns))
                        for turn in turns
                    ],
                    "place": place,
                    "levels": [asdict(row) for row in levels],
                    "nearest_sensor": sensor,
                }
                for finding, words, turns, place, levels, sensor in zip(
                    found.findings,
                    self.sentences,
                    self.places,
                    self.place_sentences,
                    self.levels,
                    self.sensors,
                    strict=False,
                )
            ]
            + [row.as_data() for row in self.severity if row.is_verdict],
            "severity": [row.as_data() for row in self.severity],
            "sentences": list(self.sentences),
            "observations": [
                {
                    "kind": one.kind,
                    "shaft": one.shaft,
                    "gears": list(one.gears),
                    "channel": one.channel,
                    "amplitude": one.amplitude,
                    "sentence": words,
                }
                for one, words in zip(found.observations, self.observed, strict=True)
            ],
            "evidence": evidence_rows(found, hertz),
            "meshes": {
                channel: [
                    {
                        "mesh": row.mesh,
                        "frequency": row.order * hertz,
                        "amplitude": row.amplitude.tolist(),
                        "seen": row.seen,
                        "lost_harmonics": list(row.lost),
                    }
                    for row in rows
                ]
                for channel, rows in found.meshes.items()
            },
            "turns": dict(found.turns),
            "origin": [list(row) for row in self.origin],
            "reference_frequency": hertz,
            "tests": found.tests,
            "false_alarm_in_noise": found.false_alarm,
            "not_tested": list(found.untested),
            "not_reported": list(found.unreported),
            "remarks": list(self.remarks),
            "change": None if self.change is None else self.change.as_data(),
        }


def study(
    over: OverAngle,
    parts: TurningParts,
    *,
    false_alarm: float,
    remarks: Sequence[str] = (),
    units: Mapping[str, str] | None = None,
    slip: float = SLIP,
    sensors: Places | None = None,
) -> Study:
    """Diagnose channels over an angle and describe the findings in words.

    Raises
    ------
    SignalError
        If no mesh line is visible although the record covers it: tooth counts or speed are wrong, and
        findings would be meaningless.
    """
    found = diagnose(
        over.signals,
        over.samples_per_turn,
        parts,
        false_alarm=false_alarm,
        sampled_per_turn=over.sampled_per_turn,
        speed_tolerance=over.tolerance,
        slip=slip,
    )
    found, unnamed = _named(found, parts, over.names_gears)
    where = sensors or Places(parts)
    turns = next(iter(over.signals.values())).size / over.samples_per_turn
    found, levels = at_sensors(found, parts, turns, where)
    listed = over.signals if parts.meshes else {}
    strongest = {name: strongest_lines(x, over.samples_per_turn) for name, x in listed.items()}
    about_meshes, nothing = mesh_remarks(found, parts, over.frequency, strongest)
    if nothing:
        why = [text for text in about_meshes if "no mesh line" in text]
        raise SignalError("; ".join(filter(None, (*why, over.advice))))
    if not found.tests:
        raise SignalError(
            "; ".join(
                (
                    *over.remarks,
                    *found.untested,
                    over.advice or "give the speed more closely, --tacho or --angle",
                )
            )
        )
    doubt = f"; {over.doubt}" if over.doubt else ""
    words = tuple(sentence(finding, found, parts, over.frequency) + doubt for finding in found.findings)
    notes = (
        *over.remarks,
        *filter(None, (over.advice,)),
        *remarks,
        *about_meshes,
        *unnamed,
        *_whole_ratios(parts),
    )
    places = local_turns(found, over, parts)
    return Study(
        diagnosis=found,
        over=over,
        parts=parts,
        sentences=words or (nothing_found(found),),
        observed=tuple(
            observation(one, found, parts, over.frequency, (units or {}).get(one.channel, ""))
            for one in found.observations
        ),
        remarks=tuple(dict.fromkeys(notes)),
        places=places,
        place_sentences=tuple(
            place_sentence(finding, turns, found.false_alarm)
            for finding, turns in zip(found.findings, places, strict=True)
        ),
        units=units or {},
        levels=levels,
        sensors=tuple(
            nearest_sensor(finding, rows, where) for finding, rows in zip(found.findings, levels, strict=True)
        ),
    )


def _named(found: Diagnosis, parts: TurningParts, names_gears: bool) -> tuple[Diagnosis, list[str]]:
    """Remove gears without a visible mesh line from findings: their tooth counts are not confirmed."""
    if not names_gears:
        every = (one if one.kind == "bearing" else replace(one, gears=()) for one in found.findings)
        return replace(found, findings=tuple(every)), []
    seen = {row.mesh for rows in found.meshes.values() for row in rows if row.seen}
    shown = {gear for mesh in parts.meshes if mesh.name in seen for gear in mesh.gears}
    findings, remarks = [], []
    for one in found.findings:
        unseen = [gear for gear in one.gears if one.kind != "bearing" and gear not in shown]
        if unseen:
            # naming one of several gears would be a guess, too
            remarks.append(f"no gear of {one.shaft} is named: no mesh line of {', '.join(unseen)} is visible")
        findings.append(replace(one, gears=()) if unseen else one)
    return replace(found, findings=tuple(findings)), remarks


def usable(
    channels: Mapping[str, Array], time: Array | None = None, units: Mapping[str, str] | None = None
) -> tuple[dict[str, Array], list[str]]:
    """Varying, finite channels, and remarks on the omitted ones.

    With `time` [s], that of all or of the first samples, tacho channels are omitted, too: their harmonics are
    not vibration. Internal quantities of simulations are none, even if they look like pulses. With the
    `units` of simulated channels, so are those that only contain errors of the solution: in a machine with
    two symmetric sides, for example, the vibration along the axes of the shafts cancels.
    """
    kept, remarks, units = {}, [], units or {}
    for name, values in channels.items():
        try:
            x = as_signal(values, name, 64)
        except SignalError as reason:
            remarks.append(f"{reason}; omitted")
            continue
        spread = float(np.ptp(x))
        if spread <= 1e-12 * max(float(x.max()), -float(x.min())):
            remarks.append(f"{name}: is constant; omitted")
            continue
        measured = not units or name.startswith("signal[")
        if time is not None and measured and is_pulse_train(x[: time.size], time):
            word = quote(name)
            remarks.append(
                f"{name}: looks like tacho pulses, not vibration; omitted; --tacho {word} "
                f"--pulses N takes the speed from it, -c {word} includes it in the diagnosis"
            )
            continue
        kept[name] = x
    for name in _residues(kept, units):
        remarks.append(
            f"{name}: varies by less than {RESIDUE:g} of another channel in {units[name]}, an error "
            f"of the solution and not vibration; omitted; -c {quote(name)} includes it in the diagnosis"
        )
        del kept[name]
    return kept, remarks


def _residues(channels: Mapping[str, Array], units: Mapping[str, str]) -> list[str]:
    """Channels whose variation is negligible next to that of another one with the same unit."""
    rms = {name: float(np.std(x)) for name, x in channels.items() if units.get(name)}
    largest: dict[str, float] = {}
    for name, value in rms.items():
        largest[units[name]] = max(value, largest.get(units[name], 0.0))
    return [name for name, value in rms.items() if value < RESIDUE * largest[units[name]]]


def _whole_ratios(parts: TurningParts) -> list[str]:
    """Remarks on shafts with integer speed ratios, whose synchronous averages mix."""
    why = (
        "integer speed ratios: {}; synchronous averaging cannot separate the gears of these shafts, and "
        "equal faults at equal angles on the slower shaft look like one fault on the faster shaft"
    )
    shafts = parts.shafts if parts.meshes else ()
    pairs = [(fast, slow) for fast in shafts for slow in shafts if fast.order > slow.order]
    return grouped(
        Note(why, f"{fast.name} rotates {fast.order / slow.order} times as fast as {slow.name}")
        for fast, slow in pairs
        if (fast.order / slow.order).denominator == 1
    )
