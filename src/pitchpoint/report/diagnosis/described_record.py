# SPDX-License-Identifier: Apache-2.0
"""Records by their features and operating points, as compared with healthy records."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pitchpoint.analysis.healthy_reference import FEWEST
from pitchpoint.analysis.mesh_angle import mesh_angle
from pitchpoint.analysis.record_features import Feature, record_features
from pitchpoint.analysis.sampled import Array, SignalError
from pitchpoint.analysis.shaft_tests import SLIP
from pitchpoint.analysis.turning_parts import TurningParts
from pitchpoint.core.errors import PitchpointError
from pitchpoint.report.diagnosis.over_angle import OverAngle, over_angle
from pitchpoint.report.diagnosis.record_files import RecordFile
from pitchpoint.report.diagnosis.request import Request, prepare

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


def described(file: RecordFile, over: OverAngle, parts: TurningParts, slip: float | None) -> Described:
    """Features of a record; its angle follows the clearest mesh line if it is not measured."""
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
        slip=SLIP if slip is None else slip,
    )
    return Described(file, features, over.frequency)


def read_described(
    request: Request, files: Sequence[RecordFile], *, partial: bool = False
) -> list[Described]:
    """Records of files; all that cannot be read are named. With `partial`, Ctrl-C keeps those read so far."""
    found, problems = [], []
    for file in files:
        speeds = (file.speed,) if file.speed and not request.speeds else request.speeds
        own = replace(request, file=file.path, more=(), speeds=speeds)
        try:
            made = prepare(own)
            found.append(described(file, made.over, made.machine.parts, request.slip))
        except PitchpointError as error:
            problems.append(str(error) if file.path in str(error) else f"{file.path}: {error}")
        except KeyboardInterrupt:
            if not partial or not found:
                raise
            break
    if problems:
        raise SignalError("; ".join(problems))
    return found


def matched_features(one: Described, record: Described) -> tuple[Mapping[Feature, float], str]:
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
    words = ", ".join(f"{new} is compared with {old}" for old, new in pairs.items())
    return found, f"channels are named after the records: {words}" if pairs else ""


def _plain(name: str) -> str:
    """Name of a channel with every number replaced by #."""
    return re.sub(r"\d+", "#", name)


def operating_points(
    record: Described, healthy: Sequence[Described], among: Sequence[Described]
) -> tuple[tuple[str, ...], Array, list[str]]:
    """Quantities over which healthy values are interpolated, their values (the record last), and remarks.

    Load and speed count if they are known for all records and vary, and if each of the healthy records, all
    of which are `among`, can be compared with the others.
    """
    every = [*healthy, record]
    within = [k for k, one in enumerate(every) if one in among]
    units = {one.file.unit for one in every if one.file.unit}
    if len(units) > 1:
        raise SignalError(
            f"load: has different units, {', '.join(sorted(units))}; give all loads in one unit"
        )
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
                f"{name}: varies, but healthy records do not suffice to determine its effect: {len(among)} "
                f"(limit {FEWEST + len(used) + 1} with different values); it is part of the deviations"
            )
    points = np.column_stack([columns[name] for name in used]) if used else np.empty((len(every), 0))
    return tuple(used), points, notes


def _determined(points: Array) -> bool:
    """Whether the effect of operating points can be determined without any one of the healthy records."""
    count, columns = points.shape
    if count < FEWEST + columns:
        return False
    design = np.c_[
        np.ones(count), (points - points.mean(axis=0)) / np.maximum(np.ptp(points, axis=0), 1e-300)
    ]
    return all(
        np.linalg.matrix_rank(np.delete(design, k, axis=0), tol=1e-6) == columns + 1 for k in range(count)
    )
