# SPDX-License-Identifier: Apache-2.0
"""Note of a speed sweep on mean speeds that deviate from the prescribed ones."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import Message, note
from pitchpoint.solvers.speed_stability import REMEDY

if TYPE_CHECKING:
    from pitchpoint.solvers.speed_stability import UnstableSpeed

DRIFT = 0.005
"""Relative deviation of the mean speed from the prescribed speed above which a note is added."""


def drift_notes(
    points: Sequence[dict[str, Any]],
    body: str,
    measure: int,
    cut: Callable[[float, float], float],
    unstable: Callable[[float], UnstableSpeed | None],
) -> tuple[Message, ...]:
    """Note if the mean speed deviates from the prescribed speed by more than a cut wave of a ripple explains.

    Statistics extend over whole mesh cycles, not over whole waves of a drive or of a load.

    Parameters
    ----------
    points
        Points of the sweep (`sweep.speed.SweepSummary`).
    body
        The swept body.
    measure
        Mesh cycles of the statistics.
    cut
        Function of speed [rad/s] and time of the statistics [s]: deviation of the mean speed [rad/s] because
        of waves of which the statistics contain a part.
    unstable
        Growth of a deviation from a speed [rad/s], if it is unstable.
    """
    off = []
    for point in points:
        speed = abs(point["speed"])
        if speed > 0.0:
            deviation = point["channels"][f"speed[{body}]"]["mean"] / point["speed"] - 1.0
            if abs(deviation) >= DRIFT + cut(point["speed"], measure / point["mesh_frequency"]) / speed:
                off.append((deviation, point["speed"]))
    if not off:
        return ()
    largest, speed = max(off, key=lambda one: abs(one[0]))
    worst = float(f"{100.0 * largest:.2g}")
    text = f"{body}: the mean speed deviates by up to {worst:+g} % from the prescribed speed"
    if found := unstable(speed):
        return (note(f"{text}: {found}", remedy=REMEDY),)
    remedy = "drive or hold a body, or reduce settle_periods"
    return (note(f"{text}: loads and losses do not balance there", remedy=remedy),)
