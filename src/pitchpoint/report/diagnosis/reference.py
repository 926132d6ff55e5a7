# SPDX-License-Identifier: Apache-2.0
"""Comparison of a record, or of the records of a folder, with healthy records of the same machine."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
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
from pitchpoint.analysis.record_features import Feature
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.report.diagnosis.described_record import (
    Described,
    described,
    matched_features,
    operating_points,
    read_described,
)
from pitchpoint.report.diagnosis.record_files import RecordFile, record_file, record_files, unmatched
from pitchpoint.report.diagnosis.request import Request
from pitchpoint.report.diagnosis.study import Study


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
    missing
        Number of records that were not compared because the user interrupted the command.
    """

    changes: tuple[Change, ...]
    limits: HealthyRange
    left: int | None
    notes: tuple[str, ...] = ()
    missing: int = 0

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


def compared_files(request: Request) -> tuple[list[RecordFile], list[RecordFile]]:
    """Records to compare, one or those of a folder, and healthy records, with their loads; nothing is read.

    Raises
    ------
    SignalError
        If there is no such file, a load is not known in the stated way, or a record would be compared with
        itself; all problems at once.
    """
    problems: list[str] = []

    def listed(find: Callable[[], list[RecordFile]]) -> list[RecordFile]:
        """Files, or a problem."""
        try:
            return find()
        except SignalError as error:
            problems.append(str(error))
            return []

    pattern = request.load_from
    if Path(request.file).is_dir():
        files = listed(lambda: record_files([request.file], pattern, "FILES"))
        if request.load is not None:
            problems.append(
                "--load: is the load of one record; give --load-from, or the column load of records.csv"
            )
    else:
        files = listed(lambda: [record_file(request.file, pattern, request.load)])
    healthy = listed(lambda: record_files(request.references, pattern, "--reference"))
    if len(files) == 1 and healthy and all(_same_file(one, files[0]) for one in healthy):
        problems.append(f"--reference: {request.file} is compared with itself; name other records")
    if not problems:
        problems += unmatched([*files, *healthy], pattern)
    if problems:
        raise SignalError("; ".join(dict.fromkeys(problems)))
    return files, healthy


def compare(request: Request, study: Study) -> Change:
    """Compare a record with the healthy records of a request.

    Parameters
    ----------
    request
        Options of the command.
    study
        Diagnosis of the record.

    Raises
    ------
    SignalError
        If a healthy record cannot be read, or has nothing in common with the record.
    """
    (file,), records = compared_files(request)
    own = [one for one in records if _same_file(one, file)]
    records = [one for one in records if not _same_file(one, file)]
    healthy = read_described(request, records)
    notes = [f"{one.name} is one of the healthy records; it is compared with the others" for one in own]
    return change_of(described(file, study.over, study.parts, request.slip), healthy, notes)


def trend(request: Request) -> Trend:
    """Compare all records of a folder with the healthy records of a request.

    Raises
    ------
    SignalError
        If a record cannot be read, or there are too few healthy records for a limit.
    """
    files, healthy_files = compared_files(request)
    others = [one for one in files if not any(_same_file(one, two) for two in healthy_files)]
    healthy = read_described(request, healthy_files)
    later = {one.file.path: one for one in read_described(request, others, partial=True)}
    changes = []
    for file in files:
        same = next((one for one in healthy if _same_file(one.file, file)), None)
        if same is None and file.path not in later:
            continue
        rest = [one for one in healthy if one is not same]
        changes.append(change_of(same or later[file.path], rest, every=healthy))
    outside = next((change for change in changes if change.file not in healthy), None)
    limits = outside.limits if outside is not None else None
    if limits is None:
        least = FEWEST + len(changes[0].points)
        raise SignalError(
            f"--reference: {len(healthy)} healthy records, {len(others)} others (limit {least} and 1): no "
            "trend; give more healthy records"
        )
    left = left_at([change.found.distance for change in changes], limits.limit)
    # a healthy record at the end of the range is always extrapolated from the others
    notes = dict.fromkeys(n for change in changes if change.file not in healthy for n in change.notes)
    missing = len(files) - len(changes)
    if missing:
        notes[f"interrupted by the user: {missing} of {len(files)} records are not compared"] = None
    return Trend(tuple(changes), limits, left, tuple(notes), missing)


def change_of(
    record: Described,
    healthy: Sequence[Described],
    notes: Sequence[str] = (),
    every: Sequence[Described] = (),
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
    matched = [matched_features(one, record) for one in healthy]
    values, remarks = [found for found, _ in matched], [*notes, *dict.fromkeys(t for _, t in matched if t)]
    common = [f for f in record.features if all(f in one for one in values)]
    if not common:
        raise SignalError(
            f"--reference: {record.file.name} has no channel in common with all healthy records, or another "
            "machine; give records of the same sensors"
        )
    lost = len({f for one in (record.features, *values) for f in one}) - len(common)
    remarks += [
        f"{lost} of {lost + len(common)} features are not in all records; they are not compared"
    ] * bool(lost)
    names, points, more = operating_points(record, healthy, every or healthy)
    y = np.array([[one[f] for f in common] for one in values])
    own = np.array([record.features[f] for f in common])
    found = deviations(y, own, points[:-1], points[-1])
    limits = healthy_range(y, points[:-1])
    change = Change(record, tuple(healthy), tuple(common), found, limits, names, notes=(*remarks, *more))
    return replace(change, named=tuple(changed_parts(common, found))) if change.differs else change


def _same_file(one: RecordFile, other: RecordFile) -> bool:
    return Path(one.path).resolve() == Path(other.path).resolve()
