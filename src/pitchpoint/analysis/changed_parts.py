# SPDX-License-Identifier: Apache-2.0
"""Parts that the changes of a record point to: a gear by its residual, a bearing part by its lines."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pitchpoint.analysis.healthy_reference import Deviations
from pitchpoint.analysis.record_features import Feature

RESIDUALS = ("residual", "residual shape")
"""Kinds of features of one gear."""
BEYOND = 3.0
"""Rise of a residual beyond that of the whole signal over its spread."""
CHANCE = 0.01
"""Probability that any feature of a part of a healthy record has risen as much."""
TIMES = 4.0
"""Rise of the power of a residual over that of any other gear: averages have at least eight revolutions."""


def changed_parts(features: Sequence[Feature], found: Deviations) -> list[int]:
    """Numbers of the features that name a part, at most one per part, the most certain first.

    Parameters
    ----------
    features
        Features, length m.
    found
        Deviations of the record.

    Returns
    -------
    list of int
        Numbers of features; empty if the changes name no part.

    Notes
    -----
    Features of single parts are residuals of gears and lines of bearing parts. One has risen if its one-sided
    probability, times their number (Bonferroni) [1]_, is at most 1 %. A gear is named if the power of
    its residual has risen by four times as much as that of any other gear in the channel, and not merely as
    the whole signal, or if only its residual has become more peaked: impacts of a gear remain in the averages
    of others, divided by the number of revolutions. A bearing part is named if its lines have risen most of
    all in the channel. Valid for features that scatter like Gaussian variables.

    References
    ----------
    .. [1] O. J. Dunn, Multiple comparisons among means, Journal of the American Statistical Association 56,
       1961, 52-64.

    Examples
    --------
    >>> from pitchpoint.analysis.healthy_reference import deviations
    >>> features = [Feature("a", "residual", "Z1", "rms"), Feature("a", "residual", "Z2", "rms")]
    >>> healthy = 0.1 * np.random.default_rng(1).standard_normal((8, 2))
    >>> changed_parts(features, deviations(healthy, [0.1, 3.0]))
    [1]
    """
    own = [k for k, feature in enumerate(features) if feature.kind in (*RESIDUALS, "bearing")]
    one_sided = np.where(found.score > 0.0, 0.5 * found.probability, 1.0)
    risen = [k for k in own if one_sided[k] * len(own) <= CHANCE]
    levels = {f.channel: float(found.deviation[k]) for k, f in enumerate(features) if f.kind == "level"}
    named: dict[tuple[bool, str], int] = {}
    for k in sorted(risen, key=lambda k: float(one_sided[k])):
        feature = features[k]
        bearing = feature.kind == "bearing"
        rivals = [
            j
            for j in own
            if features[j].channel == feature.channel
            and features[j].part != feature.part
            and (features[j].kind == "bearing") == bearing
        ]
        if bearing:
            alone = all(found.score[j] <= found.score[k] for j in rivals)
        elif feature.kind == "residual":
            level = max(levels.get(feature.channel, 0.0), 0.0)
            alone = bool(found.deviation[k] > level + BEYOND * found.spread[k])
            same = [j for j in rivals if features[j].kind == feature.kind]
            alone &= all(_rise(found, k) > TIMES * _rise(found, j) for j in same)
        else:
            alone = all(one_sided[j] > CHANCE for j in rivals)
        if alone:
            named.setdefault((bearing, feature.part), k)
    return list(named.values())


def _rise(found: Deviations, k: int) -> float:
    """Power of a feature less its healthy value."""
    return float(10.0 ** (0.1 * (found.expected[k] + found.deviation[k])) - 10.0 ** (0.1 * found.expected[k]))
