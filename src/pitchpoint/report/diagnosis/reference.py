# SPDX-License-Identifier: Apache-2.0
"""Comparison of a record, or of the records of a folder, with healthy records of the same machine."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pitchpoint.analysis.changed_parts import changed_parts
from pitchpoint.analysis.healthy_reference import (
    FEWEST,
    Deviations,
    HealthyRange,
    deviations,
    healthy_range,
    left_at,
)
from pitchpoint.analysis.mesh_angle import mesh_angle
from pitchpoint.analysis.record_features import Feature, record_features
from pitchpoint.analysis.sampled import Array, SignalError
from pitchpoint.analysis.shaft_tests import SLIP
from pitchpoint.core.errors import PitchpointError
from pitchpoint.report.diagnosis.record import over_angle
from pitchpoint.report.diagnosis.record_files import RecordFile, record_file, record_files
from pitchpoint.report.diagnosis.request import Prepared, Request, prepare

SAME_SPEED = 0.02
"""Relative range of the speed within which records have the same operating point."""


@dataclass(frozen=True)
class Described:
    """A record by its features.

    Attributes
    ----------
    file
        File with its load.
    features
        Values of the features [dB].
    frequency
        Rotation frequency of the reference shaft [Hz]; NaN if it varies.
    """

    file: RecordFile
    features: Mapping[Feature, float]
    frequency: float


@dataclass(frozen=True)
class Change:
    """Comparison of one record with healthy records.

    Attributes
    ----------
    file
        The record.
    healthy
        The healthy records.
    features
        Compared features, length m.
    found
        Their deviations.
    limits
        Range of the healthy records; None if there are too few.
    points
        Names of the quantities over which healthy values are interpolated.
    named
        Numbers of the features that name a part.
    notes
        Remarks.
    """

    file: Described
    healthy: tuple[Described, ...]
    features: tuple[Feature, ...]
    found: Deviations
    limits: HealthyRange | None
    points: tuple[str, ...]
    named: tuple[int, ...] = ()
    notes: tuple[str, ...] = ()

    @property
    def differs(self) -> bool:
        """Whether the record is farther from the healthy records than each of them from the others."""
        return self.limits is not None and self.found.distance > self.limits.limit

    @property
    def largest(self) -> list[int]:
        """Numbers of the features, the most significant first; by deviation if there is no spread."""
        by = self.found.deviation if np.isnan(self.found.score).all() else self.found.score
        return [int(k) for k in np.argsort(-np.abs(by), kind="stable")]

    @property
    def by_channel(self) -> dict[str, float]:
        """Distance by channel [-]."""
        squares: dict[str, list[float]] = {}
        for feature, score in zip(self.features, self.found.score, strict=True):
            squares.setdefault(feature.channel, []).append(float(score) ** 2)
        return {channel: math.sqrt(sum(values) / len(values)) for channel, values in squares.items()}

    def as_data(self) -> dict[str, Any]:
        """Complete comparison as plain data."""
        from pitchpoint.report.diagnosis.change_words import change_sentences, feature_words

        found, limits = self.found, self.limits
        return {
            "file": self.file.file.path,
            "healthy": [
                {
                    "file": one.file.path,
                    "load": one.file.load,
                    "frequency": one.frequency,
                    "distance": None if limits is None else float(limits.distances[k]),
                }
                for k, one in enumerate(self.healthy)
            ],
            "interpolated_over": list(self.points),
            "distance": found.distance,
            "distance_by_channel": self.by_channel,
            "limit": None if limits is None else limits.limit,
            "probability": None if limits is None else limits.probability(found.distance),
            "differs": self.differs,
            "named": [self.features[k].part for k in self.named],
            "sentences": change_sentences(self),
            "degrees_of_freedom": found.freedom,
            "features": [
                {
                    "channel": feature.channel,
                    "kind": feature.kind,
                    "feature": feature_words(feature),
                    "healthy": float(found.expected[k]),
                    "deviation": float(found.deviation[k]),
                    "spread": float(found.spread[k]),
                    "score": float(found.score[k]),
                    "probability": float(found.probability[k]),
                }
                for k, feature in enumerate(self.features)
            ],
            "notes": list(self.notes),
        }


@dataclass(frozen=True)
class Trend:
    """Comparison of records in order with the same healthy records.

    Attributes
    ----------
    changes
        Comparison of every record; that of a healthy one is with the others.
    limits
        Range of the healthy records.
    left
        Number of the record at which the trend left the healthy range; None if it did not.
    notes
        Remarks.
    """

    changes: tuple[Change, ...]
    limits: HealthyRange
    left: int | None
    notes: tuple[str, ...] = ()

    def as_data(self) -> dict[str, Any]:
        """Complete trend as plain data."""
        from pitchpoint.report.diagnosis.change_words import trend_sentences

        return {
            "limit": self.limits.limit,
            "rate": self.limits.rate,
            "left_at": None if self.left is None else self.changes[self.left].file.file.path,
            "sentences": trend_sentences(self),
            "records": [
                {
                    key: value
                    for key, value in change.as_data().items()
                    if key in ("file", "distance", "probability", "differs", "named", "sentences")
                }
                | {"load": change.file.file.load, "frequency": change.file.frequency}
                for change in self.changes
            ],
            "notes": list(self.notes),
        }


def compare(request: Request, prepared: Prepared) -> Change:
    """Compare a record with the healthy records of a request.

    Parameters
    ----------
    request
        Options of the command.
    prepared
        The record.

    Raises
    ------
    SignalError
        If a healthy record cannot be read, or has nothing in common with the record.
    """
    file = record_file(request.file, request.load_from, request.load)
    records = record_files(request.references, request.load_from, "--reference")
    own = [one for one in records if _same_file(one, file)]
    records = [one for one in records if not _same_file(one, file)]
    if not records:
        raise SignalError(f"--reference: {request.file} is compared with itself; name other records")
    healthy = _read(request, records)
    notes = [f"{one.name} is one of the healthy records; it is compared with the others" for one in own]
    return change_of(described(file, prepared, request), healthy, notes)


def trend(request: Request) -> Trend:
    """Compare all records of a folder with the healthy records of a request.

    Raises
    ------
    SignalError
        If a record cannot be read, or there are too few healthy records for a limit.
    """
    files = record_files([request.file], request.load_from, "FILES")
    healthy_files = record_files(request.references, request.load_from, "--reference")
    others = [one for one in files if not any(_same_file(one, two) for two in healthy_files)]
    healthy = _read(request, healthy_files)
    later = {one.file.path: one for one in _read(request, others)}
    changes = []
    for file in files:
        same = next((one for one in healthy if _same_file(one.file, file)), None)
        rest = [one for one in healthy if one is not same]
        changes.append(change_of(same or later[file.path], rest, every=healthy))
    outside = next((change for change in changes if change.file not in healthy), None)
    limits = outside.limits if outside is not None else None
    if limits is None:
        least = FEWEST + len(changes[0].points)
        raise SignalError(
            f"--reference: {len(healthy)} healthy records, {len(others)} others (limit {least} and 1): no trend; "
            "give more healthy records"
        )
    left = left_at([change.found.distance for change in changes], limits.limit)
    # a healthy record at the end of the range is always extrapolated from the others
    notes = dict.fromkeys(n for change in changes if change.file not in healthy for n in change.notes)
    return Trend(tuple(changes), limits, left, tuple(notes))


def described(file: RecordFile, prepared: Prepared, request: Request) -> Described:
    """Features of a record; its angle follows the clearest mesh line if it is not measured."""
    over, parts = prepared.over, prepared.machine.parts
    if over.lines:
        angle = mesh_angle(over.signals, over.samples_per_turn, parts)
        if angle is not None:
            rate = over.samples_per_turn * over.frequency
            clock = np.arange(angle.size) / rate
            over = over_angle(over.signals, clock, angle)
    features = record_features(
        over.signals,
        over.samples_per_turn,
        parts,
        frequency=1.0 if math.isnan(over.frequency) else over.frequency,
        tolerance=over.tolerance,
        slip=SLIP if request.slip is None else request.slip,
    )
    return Described(file, features, over.frequency)


def _read(request: Request, files: Sequence[RecordFile]) -> list[Described]:
    """Records of files; all that cannot be read are named."""
    found, problems = [], []
    for file in files:
        speeds = (file.speed,) if file.speed and not request.speeds else request.speeds
        own = replace(request, file=file.path, more=(), speeds=speeds)
        try:
            found.append(described(file, prepare(own), own))
        except PitchpointError as error:
            problems.append(str(error) if file.path in str(error) else f"{file.path}: {error}")
    if problems:
        raise SignalError("; ".join(problems))
    return found


def change_of(
    record: Described, healthy: Sequence[Described], notes: Sequence[str] = (), every: Sequence[Described] = ()
) -> Change:
    """Compare the common features of a record with those of healthy ones.

    Parameters
    ----------
    record
        The record.
    healthy
        The healthy records with which it is compared.
    notes
        Remarks on these.
    every
        All healthy records, if the record is one of them; default: `healthy`.

    Raises
    ------
    SignalError
        If they have no feature in common.
    """
    matched = [_matched(one, record) for one in healthy]
    values, told = [found for found, _ in matched], [*notes, *dict.fromkeys(t for _, t in matched if t)]
    common = [f for f in record.features if all(f in one for one in values)]
    if not common:
        raise SignalError(
            f"--reference: {record.file.name} has no channel in common with all healthy records, or another machine; "
            "give records of the same sensors"
        )
    lost = len({f for one in (record.features, *values) for f in one}) - len(common)
    told += [f"{lost} of {lost + len(common)} features are not in all records; they are not compared"] * bool(lost)
    names, points, more = operating_points(record, healthy, every or healthy)
    y = np.array([[one[f] for f in common] for one in values])
    own = np.array([record.features[f] for f in common])
    found = deviations(y, own, points[:-1], points[-1])
    limits = healthy_range(y, points[:-1])
    change = Change(
        record, tuple(healthy), tuple(common), found, limits, names, notes=(*told, *more)
    )
    return replace(change, named=tuple(changed_parts(common, found))) if change.differs else change


def _matched(one: Described, record: Described) -> tuple[Mapping[Feature, float], str]:
    """Features of a healthy record under the channel names of the record, and a remark if they differ.

    Names that contain the number of the record, such as X097_DE_time and X105_DE_time, are the same channel.
    """
    own, other = ({f.channel: _plain(f.channel) for f in r.features} for r in (record, one))
    if set(own) & set(other):
        return one.features, ""
    unique = len(set(own.values())) == len(own) and len(set(other.values())) == len(other)
    names = {plain: name for name, plain in own.items()} if unique else {}
    pairs = {name: names[plain] for name, plain in other.items() if plain in names}
    found = {replace(f, channel=pairs[f.channel]): v for f, v in one.features.items() if f.channel in pairs}
    words = ", ".join(f"{new} with {old}" for old, new in pairs.items())
    return found, f"channels are named after the records: {words} is compared" if pairs else ""


def _plain(name: str) -> str:
    """Name of a channel with every number replaced by #."""
    return re.sub(r"\d+", "#", name)


def operating_points(
    record: Described, healthy: Sequence[Described], among: Sequence[Described]
) -> tuple[tuple[str, ...], Array, list[str]]:
    """Quantities over which healthy values are interpolated, their values (the record last), and remarks.

    Load and speed count if they are known for all records and vary, and if each of the healthy records, all of
    which are `among`, can be compared with the others.
    """
    every = [*healthy, record]
    within = [k for k, one in enumerate(every) if one in among]
    units = {one.file.unit for one in every if one.file.unit}
    if len(units) > 1:
        raise SignalError(f"load: has different units, {', '.join(sorted(units))}; give all loads in one unit")
    notes: list[str] = []
    columns: dict[str, Array] = {}
    loads = [one.file.load for one in every]
    if all(load is not None for load in loads):
        columns["load"] = np.array(loads, dtype=np.float64)
    elif any(load is not None for load in loads):
        unknown = [one.file.name for one in every if one.file.load is None]
        notes.append(f"load: not known for {', '.join(unknown)}; healthy values are not interpolated over it")
    speeds = np.array([one.frequency for one in every])
    if np.isfinite(speeds).all() and np.ptp(speeds) > SAME_SPEED * speeds.mean():
        columns["speed"] = speeds
    used: list[str] = []
    for name, values in columns.items():
        if np.ptp(values) == 0.0:
            continue
        if _determined(np.column_stack([columns[n][within] for n in (*used, name)])):
            used.append(name)
            low, high, own = values[:-1].min(), values[:-1].max(), values[-1]
            if not low <= own <= high:
                notes.append(
                    f"{name} {own:.6g} is outside the healthy records, {low:.6g} to {high:.6g}: extrapolated"
                )
        else:
            notes.append(
                f"{name}: varies, but {len(among)} healthy records do not determine its effect (limit "
                f"{FEWEST + len(used) + 1} records with different values); its effect is part of the deviations"
            )
    points = np.column_stack([columns[name] for name in used]) if used else np.empty((len(every), 0))
    return tuple(used), points, notes


def _determined(points: Array) -> bool:
    """Whether the effect of operating points can be determined without any one of the healthy records."""
    count, columns = points.shape
    if count < FEWEST + columns:
        return False
    design = np.c_[np.ones(count), (points - points.mean(axis=0)) / np.maximum(np.ptp(points, axis=0), 1e-300)]
    return all(
        np.linalg.matrix_rank(np.delete(design, k, axis=0), tol=1e-6) == columns + 1 for k in range(count)
    )


def _same_file(one: RecordFile, other: RecordFile) -> bool:
    from pathlib import Path

    return Path(one.path).resolve() == Path(other.path).resolve()
