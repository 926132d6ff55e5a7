# SPDX-License-Identifier: Apache-2.0
"""Mean speeds of a sweep that deviate from the prescribed ones: a note, or the end of the sweep."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import Message, note
from pitchpoint.core.status import OFF_SPEED, sentence
from pitchpoint.core.units import format_quantity
from pitchpoint.solvers.speed_stability import REMEDY

if TYPE_CHECKING:
    from pitchpoint.solvers.speed_stability import UnstableSpeed

DRIFT = 0.005
"""Relative deviation of the mean speed from the prescribed speed above which a note is added."""
LEFT = 0.02
"""The same from which a point is not one of the sweep: the half-power width of a resonance with a damping
ratio of 1 %."""
UNBALANCED = "loads and losses do not balance there"
HOLD = "drive or hold a body"


def deviation(
    point: Mapping[str, Any], body: str, measure: int, cut: Callable[[float, float], float]
) -> tuple[float, float]:
    """Relative deviation of the mean speed of a point, and the part of it that a cut wave explains.

    Statistics extend over whole mesh cycles, not over whole waves of a drive or of a load.

    Parameters
    ----------
    point
        Point of the sweep (`sweep.speed.SweepSummary`).
    body
        The swept body.
    measure
        Mesh cycles of the statistics.
    cut
        Function of speed [rad/s] and time of the statistics [s]: deviation of the mean speed [rad/s] because
        of waves of which the statistics contain a part.
    """
    speed = float(point["speed"])
    allowed = cut(speed, measure / point["mesh_frequency"]) / abs(speed)
    return float(point["channels"][f"speed[{body}]"]["mean"]) / speed - 1.0, allowed


def left_sentence(point: Mapping[str, Any], body: str, unstable: UnstableSpeed | None) -> str:
    """Sentence of a sweep that ends because the mean speed left it.

    Parameters
    ----------
    point
        First point that is not one of the sweep.
    body
        The swept body.
    unstable
        Growth of a deviation from its speed, if it is unstable.
    """
    mean = point["channels"][f"speed[{body}]"]["mean"]
    at, mean = (format_quantity(float(one), "angular_speed", 5) for one in (point["speed"], mean))
    cause, remedy = (str(unstable), REMEDY) if unstable else (UNBALANCED, HOLD)
    where = f"at {at} of {body} ({point['direction']}), where the mean speed is {mean}"
    return f"{sentence(OFF_SPEED)} {where}: {cause}; {remedy}"


def drift_notes(
    points: Sequence[Mapping[str, Any]],
    body: str,
    measure: int,
    cut: Callable[[float, float], float],
    unstable: Callable[[float], UnstableSpeed | None],
) -> tuple[Message, ...]:
    """Note if the mean speed deviates from the prescribed speed by more than a cut wave of a ripple explains.

    Parameters
    ----------
    points
        Points of the sweep (`sweep.speed.SweepSummary`).
    body, measure, cut
        As in `deviation`.
    unstable
        Growth of a deviation from a speed [rad/s], if it is unstable.
    """
    off = []
    for point in points:
        found, allowed = deviation(point, body, measure, cut)
        if abs(found) >= DRIFT + allowed:
            off.append((found, point["speed"]))
    if not off:
        return ()
    largest, speed = max(off, key=lambda one: abs(one[0]))
    worst = float(f"{100.0 * largest:.2g}")
    text = f"{body}: the mean speed deviates by up to {worst:+g} % from the prescribed speed"
    if growth := unstable(speed):
        return (note(f"{text}: {growth}", remedy=REMEDY),)
    return (note(f"{text}: {UNBALANCED}", remedy=f"{HOLD}, or reduce settle_periods"),)
