# SPDX-License-Identifier: Apache-2.0
"""Sentences about the comparison of records with healthy ones."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from pitchpoint.analysis.record_features import Feature
from pitchpoint.report.diagnosis.words import percent

if TYPE_CHECKING:
    from pitchpoint.report.diagnosis.reference import Change, Trend

NAMED, SINGLE = 4, 0.01
"""Number of features in a sentence, and their largest probability."""
UNKNOWN = (
    "{} does not show how much healthy records differ from each other: differences without a limit, and "
    "without a rate of false alarms"
)


def feature_words(feature: Feature) -> str:
    """Name of a feature without its channel.

    Examples
    --------
    >>> feature_words(Feature("a", "mesh", "mesh 1", "harmonic 2"))
    'harmonic 2 of mesh 1'
    >>> feature_words(Feature("a", "sidebands", "mesh 1", "of shaft 1, harmonic 2"))
    'sidebands of shaft 1 about harmonic 2 of mesh 1'
    """
    part, detail = feature.part, feature.detail
    if feature.kind == "sidebands":
        shaft, _, harmonic = detail.partition(", ")
        return f"sidebands {shaft} about {harmonic} of {part}"
    texts = {
        "level": "rms",
        "shape": detail,
        "band": f"band {part}",
        "residual": f"residual of {part}",
        "residual shape": f"{detail} of the residual of {part}",
        "bearing": f"{detail} of {part}",
    }
    return texts.get(feature.kind, f"{detail} of {part}")


def change_sentences(change: Change) -> list[str]:
    """Result of the comparison of one record, and the part if the features name one."""
    found, limits = change.found, change.limits
    records = _records(len(change.healthy))
    over = f", interpolated over {' and '.join(change.points)}" if change.points else ""
    if limits is None:
        what = _listed(change, largest_features(change))
        return [f"largest differences from {records}{over}: {what}", UNKNOWN.format(records)]
    chance = percent(limits.probability(found.distance))
    ratio = f"distance {found.distance:.2f}, limit {limits.limit:.2f}"
    if not change.differs:
        return [
            f"within the range of {records}{over}: {ratio}; {chance} of healthy records are as far "
            "from the others"
        ]
    listed = largest_features(change)
    what = _listed(change, listed) if listed else "many features by little"
    first = f"differs from {records}{over}: {what} ({ratio}, p ≤ {chance})"
    by = change.by_channel
    each = [f"distance by channel: {', '.join(f'{name} {value:.2f}' for name, value in by.items())}"] * (
        len(by) > 1
    )
    parts = [_part(change, k) for k in change.named]
    return [first, *each, *(parts or ["a change, not a named part: no feature of a single part stands out"])]


def trend_sentences(trend: Trend) -> list[str]:
    """Whether and where the records left the healthy range."""
    changes, limit = trend.changes, trend.limits.limit
    healthy = len(trend.limits.distances)
    above = [change for change in changes if change.found.distance > limit]
    rate = f"limit {limit:.2f} from {_records(healthy)}, p ≤ {percent(trend.limits.rate)} for a single record"
    if trend.left is None:
        names = ", ".join(change.file.file.name for change in above)
        single = f"; single records above it: {names}" if above else ""
        return [f"no two consecutive records are above the limit ({rate}){single}"]
    first, second = changes[trend.left], changes[trend.left + 1]
    text = (
        f"left the healthy range at {first.file.file.name}, record {trend.left + 1} of {len(changes)}: "
        f"distances {first.found.distance:.2f} and {second.found.distance:.2f} ({rate})"
    )
    later = changes[trend.left :]
    back = [change for change in later if change.found.distance <= limit]
    rest = f"; {len(back)} of the {len(later)} records from there are below the limit" if back else ""
    return [text + rest]


def change_in_short(change: Change) -> str:
    """Result of the comparison in few words."""
    records = _records(len(change.healthy))
    if change.limits is None:
        return f"compared with {records}, without a limit"
    ratio = f"distance {change.found.distance:.2f}, limit {change.limits.limit:.2f}"
    if not change.differs:
        return f"within the range of {records} ({ratio})"
    named = ", ".join(change.features[k].part for k in change.named)
    return f"differs from {records} ({ratio}), {f'named: {named}' if named else 'no part named'}"


def largest_features(change: Change, count: int = NAMED) -> list[int]:
    """Most significant features, one of each kind and channel; without a spread the largest deviations."""
    known = not math.isnan(change.found.freedom) and change.found.freedom > 0.0
    found: dict[tuple[str, str], int] = {}
    for k in change.largest:
        if known and change.found.probability[k] > SINGLE:
            continue
        feature = change.features[k]
        found.setdefault((feature.channel, feature.kind), k)
    return list(found.values())[:count]


def _listed(change: Change, numbers: list[int]) -> str:
    """Features with their deviations."""
    return ", ".join(
        f"{feature_words(feature)} {change.found.deviation[k]:+.1f} dB in {feature.channel}"
        for k, feature in ((k, change.features[k]) for k in numbers)
    )


def _part(change: Change, k: int) -> str:
    """Sentence about a part that a feature names."""
    feature, by = change.features[k], f"{change.found.deviation[k]:+.1f} dB in {change.features[k].channel}"
    if feature.kind == "bearing":
        return f"named: {feature.part}, whose lines in the envelope spectrum rise most ({by})"
    what = (
        "residual rises more than that"
        if feature.kind == "residual"
        else f"residual rises in {feature.detail}, unlike those"
    )
    return f"named: {feature.part}, whose {what} of the other gears ({by})"


def _records(count: int) -> str:
    return "1 healthy record" if count == 1 else f"{count} healthy records"
