# SPDX-License-Identifier: Apache-2.0
"""Derivatives of channels at the operating point of a linear system, and channels that have none.

Channels are differentiated by central differences; those of a mesh follow the law in use, such as the mean
over the cycle. A magnitude whose mean is zero increases with a motion in either sense, and the direction of a
force with zero mean jumps: their central differences have no meaning. Such channels are recognised by the
changes to both sides at two steps.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message
from pitchpoint.core.words import listed
from pitchpoint.elements.ring import RESULTANT_OF
from pitchpoint.solvers.cycle_means import observe_at, observed_phases
from pitchpoint.solvers.linear_system import Linearised
from pitchpoint.solvers.mesh_law import mesh_law, stiffness_now
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import mesh_names, mesh_record
from pitchpoint.system.system import System

Array = NDArray[np.float64]

MESH_FORCES = ("mesh_force", "normal_force", "circumferential_force", "radial_force", "axial_force")
"""Channels of a mesh that are parts of its force along the base tangent."""
STEP = 2e-10
"""Step of finite differences [m]: below the penetration at which unloaded flanks are assumed in contact."""
RATE = 1e-6
"""Step of finite differences of the rates [m/s]."""
WIDER = 10.0
"""Factor of the second step: a kink grows in proportion to the step, a parabola with its square."""
NAMES = {"radial": "magnitude", "direction": "direction"}
"""Resultants in words."""
JUMP = 1e-3
"""Change within one step [SI] above which a change that does not grow with the step is a jump."""


@dataclass(frozen=True)
class ChannelSlopes:
    """Derivatives of all channels, and problems of those requested that have none.

    Parameters
    ----------
    place, rate, react, feed
        With respect to coordinates, rates, multipliers and flank errors; shape (no, nd), (no, nd), (no, nc),
        (no, number of meshes).
    problems
        One for each requested channel without a derivative.
    """

    place: Array
    rate: Array
    react: Array
    feed: Array
    problems: tuple[Message, ...]


def channel_slopes(linear: Linearised, names: Sequence[str]) -> ChannelSlopes:
    """Derivatives of all channels at the operating point.

    Parameters
    ----------
    linear
        The linear system.
    names
        Requested channels, which are tested for a derivative in the coordinate, the rate and the multiplier
        that change them most.
    """
    system, meshes = linear.system, mesh_names(linear.system)
    largest = float(np.abs(linear.state.lam).max(initial=0.0))
    # the channels of meshes follow their law, not the differences
    tested = [name for name in names if not any(_is_of(name, mesh) for mesh in meshes)]
    rows = [system.layout.channel(name) for name in tested]
    (place, a), (rate, b), (react, c) = (
        _differences(linear, "q", STEP / system.weight, rows),
        _differences(linear, "v", RATE / system.weight, rows),
        _differences(linear, "lam", np.full(linear.state.lam.size, 1e-3 * (1.0 + largest)), rows),
    )
    feed = np.zeros((system.sizes["no"], len(meshes)))
    for k, mesh in enumerate(meshes):
        by_travel = _by_travel(linear, k)
        by_travel[system.layout.channel(f"transmission_error[{mesh}]")] = 0.0  # independent of the flanks
        _follow_the_law(linear, k, by_travel, (place, rate))
        feed[:, k] = -by_travel
    problems = [_of_no_slope(system, name) for name, bent in zip(tested, a | b | c, strict=True) if bent]
    return ChannelSlopes(place, rate, react, feed, tuple(problems))


def _by_travel(linear: Linearised, k: int) -> Array:
    """Derivative of all channels with respect to the assembled travel of a mesh."""
    record = mesh_record(linear.system, k)
    kept, sides = float(record["u0"]), []
    for sign in (1.0, -1.0):
        record["u0"] = kept + sign * STEP
        sides.append(evaluate.observe(linear.system, linear.state))
    record["u0"] = kept
    return np.asarray((sides[0] - sides[1]) / (2.0 * STEP))


def _follow_the_law(linear: Linearised, k: int, by_travel: Array, slopes: tuple[Array, Array]) -> None:
    """Replace slopes of the channels of a mesh by those of its law; `by_travel`: theirs over the travel.

    A rotation of the gears acts through the travel alone. Forces are parts of the force along the base
    tangent; displaced gears change in addition their direction.
    """
    system, (place, rate) = linear.system, slopes
    law = mesh_law(system, linear.at_rest, k)
    name, turning = mesh_names(system)[k], law.travel != 0.0
    own = [o for o in np.flatnonzero(by_travel).tolist() if _is_of(system.layout.channels[o].name, name)]
    if not law.turn.any():
        return
    stiffness = stiffness_now(system, linear.state, k, law)
    for o in own:
        place[o, turning] = by_travel[o] * law.travel[turning]
        rate[o, turning] = float(rate[o] @ law.turn) * law.travel[turning]
    along = system.layout.channel(f"mesh_force[{name}]")
    found = place[along].copy()
    for word in MESH_FORCES if stiffness > 0.0 else ():
        o = system.layout.channel(f"{word}[{name}]")
        part = 1.0 if o == along else by_travel[o] / stiffness
        of_direction = np.where(turning, 0.0, place[o] - by_travel[o] / by_travel[along] * found)
        place[o] = part * law.force + (0.0 if o == along else of_direction)
        by_travel[o] = float(place[o] @ law.turn)
    rate[along] = law.force_by_rate


def _is_of(channel: str, mesh: str) -> bool:
    """Whether a channel is one of a mesh or of its tooth pairs, such as `pair_force[stage.0]`."""
    inside = channel.partition("[")[2].rstrip("]")
    return inside == mesh or inside.startswith(f"{mesh}.")


def _differences(
    linear: Linearised, key: str, steps: Array, rows: Sequence[int]
) -> tuple[Array, NDArray[np.bool_]]:
    """Central differences of all channels with respect to one part of the state, shape (no, n).

    The phases of the meshes are fixed, as in the matrices; angles do not jump by whole turns. The second
    array: whether each of the channels `rows` has a kink or a jump.
    """
    system, state = linear.system, linear.state
    angles = [o for o, c in enumerate(system.layout.channels) if c.unit == "rad"]
    phases = {
        m: (flank, phase[flank])
        for m, (contact, phase) in observed_phases(system, state, range(len(mesh_names(system))))
        for flank in (-1 if contact < 0.0 else 1,)
    }

    def changes(k: int, step: float) -> Array:
        """Changes of all channels by a step of coordinate k."""
        moved = state.copy()
        getattr(moved, key)[k] += step
        found = observe_at(system, moved, phases if key == "q" else {}) - base
        found[angles] = np.remainder(found[angles] + math.pi, math.tau) - math.pi
        return found

    base = observe_at(system, state, phases if key == "q" else {})
    found = np.zeros((system.sizes["no"], steps.size))
    most, near = np.zeros(len(rows), np.int64), np.zeros((2, len(rows)))
    for k, step in enumerate(steps):
        sides = np.array([changes(k, step), changes(k, -step)])
        found[:, k] = (sides[0] - sides[1]) / (2.0 * step)
        of_rows = sides[:, rows]
        larger = np.abs(of_rows).max(axis=0) > np.abs(near).max(axis=0)
        most[larger], near[:, larger] = k, of_rows[:, larger]
    bent = np.zeros(len(rows), bool)
    for k in np.unique(most[near.any(axis=0)]).tolist():
        own = most == k
        wide = np.array([changes(k, sign * WIDER * steps[k])[rows] for sign in (1.0, -1.0)])
        bent[own] = _has_no_slope(near, wide)[own]
    return found, bent


def _has_no_slope(near: Array, wide: Array) -> NDArray[np.bool_]:
    """Whether changes to both sides, at a step and at a wider one, are those of a kink or a jump.

    Parameters
    ----------
    near, wide
        Changes by a positive and a negative step, shape (2, n), and by steps `WIDER` times as long.

    Examples
    --------
    Magnitude of x, square of x, and direction of x:

    >>> _has_no_slope(np.array([[1.0, 1.0, 0.0], [1.0, 1.0, 3.14]]),
    ...               np.array([[10.0, 100.0, 0.0], [10.0, 100.0, 3.14]]))
    array([ True, False,  True])
    """
    first, second = np.abs(near).max(axis=0), np.abs(wide).max(axis=0)
    alike = np.abs(wide[0] - wide[1]) <= 0.5 * second
    kink = alike & (second > 0.3 * WIDER * first) & (second < 3.0 * WIDER * first)
    return np.asarray(kink | ((first > JUMP) & (second < 0.3 * WIDER * first)))


def _of_no_slope(system: System, name: str) -> Message:
    """Problem of a channel without a derivative."""
    thing, _, word = name.rstrip("]").rpartition(".")
    parts = [f"{thing}.{part}]" for part in RESULTANT_OF.get(word, ())]
    if parts and {c.name for c in system.layout.channels}.issuperset(parts):
        what = f"the mean force is zero, so its {NAMES[word]} has no linear response"
        return Message(name, what, remedy=f"use {listed(parts)}")
    what = "has a kink or jump at the operating point, as a magnitude with zero mean, and no linear response"
    return Message(name, what, remedy="use signed components, or motions of the bodies")
