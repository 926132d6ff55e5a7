# SPDX-License-Identifier: Apache-2.0
"""Lines of one damaged bearing part in several channels.

A fault is strongest in the nearest channel. In another one only some of its lines may be above the noise, and
these may be all lines of another part.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pitchpoint.analysis.bearing_tests import alike
from pitchpoint.analysis.findings import Evidence
from pitchpoint.analysis.sampled import Array
from pitchpoint.analysis.turning_parts import Bearing, TurningParts

HARMONICS, SIDEBANDS = 3, 3
"""Harmonics of a part that must all be explained, and sidebands on either side of those of the other."""
SEPARATE = 2.5
"""Distance of lines of a record from which they are separate with a Hann window."""
COVERED = 0.25
"""Share of all orders next to lines of a part above which it explains nothing: any line would be near one."""


def fundamental(e: Evidence, parts: TurningParts) -> float:
    """Measured order of the fundamental of a bearing part [-]; the evidence is one of its harmonics.

    Parameters
    ----------
    e
        Test of a bearing part.
    parts
        Rotating parts of the machine.
    """
    if e.kind != "bearing":
        return e.order
    return e.order / max(round(e.order / _bearing(e, parts).orders[e.shaft]), 1)


def same_lines(one: float, other: float, turns: float) -> bool:
    """Whether two orders are not separate in a record.

    Parameters
    ----------
    one, other
        Orders [-].
    turns
        Revolutions of the reference shaft in the record [-].

    Examples
    --------
    >>> same_lines(5.412, 5.414, 300.0), same_lines(5.412, 5.444, 300.0)
    (True, False)
    """
    return abs(one - other) * turns < SEPARATE


def across_channels(evidence: Sequence[Evidence], parts: TurningParts, turns: float) -> tuple[Evidence, ...]:
    """Mark bearing parts that are lines of a clearer part in another channel.

    A part that is itself found in the channel of the other one, or the other one in its channel, has lines
    of its own and remains.

    Parameters
    ----------
    evidence
        All tests.
    parts
        Rotating parts of the machine.
    turns
        Revolutions of the reference shaft in the record [-].

    Notes
    -----
    The most certain part comes first, see `is_weaker_copy` [1]_. Valid for channels of one record.

    References
    ----------
    .. [1] R. B. Randall, J. Antoni, Rolling element bearing diagnostics - a tutorial, Mechanical Systems and
       Signal Processing 25(2), 2011, 485-520.

    Examples
    --------
    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> across_channels((), train_parts([(21, 40)]), 300.0)
    ()
    """
    bearings = [e for e in evidence if e.kind == "bearing" and e.found]
    bearings.sort(key=lambda e: (e.probability, e.threshold - e.value))
    seen = {(e.channel, e.gear, e.shaft) for e in bearings}
    kept: list[Evidence] = []
    causes: dict[tuple[str, str, str], str] = {}
    for e in bearings:
        for other in kept:
            apart = (e.channel, other.gear, other.shaft) not in seen and (
                other.channel,
                e.gear,
                e.shaft,
            ) not in seen
            if apart and is_weaker_copy(e, other, parts, turns):
                causes[e.channel, e.gear, e.shaft] = f"{other.shaft} of {other.gear} in {other.channel}"
                break
        else:
            kept.append(e)
    return tuple(
        replace(e, found=False, explained=causes[key])
        if e.kind == "bearing" and (key := (e.channel, e.gear, e.shaft)) in causes
        else e
        for e in evidence
    )


def is_weaker_copy(e: Evidence, stronger: Evidence, parts: TurningParts, turns: float) -> bool:
    """Whether all lines of a part are lines of a clearer part in another channel.

    Parameters
    ----------
    e
        Test of the part.
    stronger
        More certain test of another part, in another channel.
    parts
        Rotating parts of the machine.
    turns
        Revolutions of the reference shaft in the record [-].

    Returns
    -------
    bool
        False, too, if the lines of the clearer part are not separate in this record.

    Notes
    -----
    A damaged part has lines k f ± j n, where n is the speed at which it passes the load zone: that of the
    shaft for a ring, that of the cage for a rolling element [1]_, whose two contacts may differ. Valid for
    speeds that are constant within the resolution of the record, or signals over the angle.

    References
    ----------
    .. [1] P. D. McFadden, J. D. Smith, Model for the vibration produced by a single point defect in a rolling
       element bearing, Journal of Sound and Vibration 96(1), 1984, 69-82.

    Examples
    --------
    An inner ring with 5.42 impacts per revolution has sidebands at 4.42, 8.84 and 13.26:

    >>> from fractions import Fraction
    >>> from pitchpoint.analysis.turning_parts import Shaft
    >>> left = Bearing("left", {"inner ring": 5.42}, "rotor")
    >>> right = Bearing("right", {"inner ring": 4.42}, "rotor")
    >>> parts = TurningParts((Shaft("rotor", Fraction(1)),), (), (left, right))
    >>> test = {"kind": "bearing", "shaft": "inner ring", "value": 20.0, "threshold": 12.0}
    >>> test |= {"probability": 1e-9, "amplitude": 0.0, "sideband": 0, "found": True}
    >>> strong = Evidence("a", gear="left", order=5.42, **test)
    >>> weak = Evidence("b", gear="right", order=4.42, **test)
    >>> is_weaker_copy(weak, strong, parts, 300.0), is_weaker_copy(weak, strong, parts, 20.0)
    (True, False)
    """
    if e.channel == stronger.channel:
        return False
    return _among(fundamental(e, parts), stronger, parts, turns)


def _among(order: float, other: Evidence, parts: TurningParts, turns: float) -> bool:
    """Whether the first harmonics of an order are lines of a part."""
    own = order * np.arange(1, HARMONICS + 1)
    bearing = _bearing(other, parts)
    ball = other.shaft == "rolling element"
    step = fundamental(other, parts) * (0.5 if ball else 1.0)
    shafts = {shaft.name: float(shaft.order) for shaft in parts.shafts}
    beside = (
        bearing.orders.get("cage", 0.0) if ball else shafts.get(bearing.shaft, float(parts.shafts[0].order))
    )
    lines = _lines(step, beside if other.shaft != "cage" else 0.0, float(own[-1]))
    reach = SEPARATE / turns
    covered = float(np.minimum(np.diff(lines), 2.0 * reach).sum())
    if covered > COVERED * float(lines[-1] - lines[0]):
        return False
    distance = np.abs(own[:, None] - lines).min(axis=1)
    return bool(np.all(distance < reach))


def _lines(step: float, beside: float, highest: float) -> Array:
    """Orders of the lines k f ± j n."""
    harmonics = step * np.arange(1.0, np.ceil(highest / step) + SIDEBANDS + 1.0)
    sides = beside * np.arange(-SIDEBANDS, SIDEBANDS + 1) if beside else np.zeros(1)
    lines = np.add.outer(harmonics, sides).ravel()
    return np.sort(np.asarray(lines[lines > 0.0], dtype=np.float64))


def _bearing(e: Evidence, parts: TurningParts) -> Bearing:
    """Bearing of a test; those of equal orders are merged."""
    bearings: Sequence[Bearing] = alike(parts.bearings)
    return next(b for b in bearings if b.name == e.gear)
