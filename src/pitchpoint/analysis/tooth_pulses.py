# SPDX-License-Identifier: Apache-2.0
"""Load pulses of single teeth: each tooth of a gear has one at every passage of a mesh (ISO 6336-6:2006)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.analysis.rainflow import equivalent_load
from pitchpoint.analysis.sampled import Array, as_signal, same_length

FLANKS = {1: "front", -1: "back"}


@dataclass(frozen=True)
class Pulses:
    """Load pulses of tooth pairs in a mesh.

    Attributes
    ----------
    force
        Shape (n,). Largest force of each pulse, with its sign.
    tooth
        Shape (n,). Number of the pair of the flank in contact, or of the tooth of a gear.
    """

    force: Array
    tooth: NDArray[np.int64]


def find_pulses(pair_forces: Sequence[ArrayLike], places: Sequence[ArrayLike]) -> Pulses:
    """Pulses of tooth pairs, each from entry to exit; pulses cut off by the ends of the record are omitted.

    Parameters
    ----------
    pair_forces
        Shape (n_pair, n). Force of the pairs, zero without contact [N]: pair N is in row N mod n_pair, as in
        the channels `pair_force[MESH.k]`.
    places
        Shape (2, n). Number of the pair in the middle of its path, of front and back flanks: pair N is there
        where the value is N.

    Notes
    -----
    A pair that separates within its contact, as in rattle, has one pulse per flank. The largest sample
    counts: with fewer than about ten samples per mesh period the peaks are too low. Counting by tooth as in
    ISO 6336-6:2006, with the force of the pair instead of the torque.
    """
    middle = {1: as_signal(places[0], "places"), -1: as_signal(places[1], "places")}
    rows = [np.asarray(row, float) for row in pair_forces]
    found: list[tuple[float, int]] = []
    for slot, row in enumerate(rows):
        same_length(row, middle[1], "pair_forces and places")
        sense = np.sign(row).astype(np.int64)
        edges = np.flatnonzero(np.diff(sense)) + 1
        begins, ends = np.concatenate([[0], edges]), np.concatenate([edges, [row.size]])
        last: dict[int, int] = {}  # of each flank: the entry in `found`
        for k, end in zip(begins, ends, strict=True):
            side = int(sense[k])
            if side == 0 or k == 0 or end == row.size:
                continue
            part = row[k:end]
            peak = float(part[np.argmax(np.abs(part))])
            at = 0.5 * float(middle[side][k] + middle[side][end - 1])
            pair = slot + len(rows) * round((at - slot) / len(rows))
            if side in last and found[last[side]][1] == pair:
                if abs(peak) > abs(found[last[side]][0]):
                    found[last[side]] = (peak, pair)
                continue
            last[side] = len(found)
            found.append((peak, pair))
    return _pulses(found)


def _pulses(found: Sequence[tuple[float, int]]) -> Pulses:
    return Pulses(np.array([f for f, _ in found]), np.array([n for _, n in found], np.int64))


def find_passages(force: ArrayLike, places: Sequence[ArrayLike]) -> Pulses:
    """One pulse per pair from the force of the whole mesh: its largest value while it is the nearest.

    For meshes whose stiffness does not have single tooth pairs; the loads are too high, as the pairs share
    the force (ISO 6336-6:2006 counts the torque likewise).

    Parameters
    ----------
    force
        Shape (n,). Force of the mesh [N].
    places
        As for `find_pulses`.
    """
    f = np.asarray(force, float)
    found: list[tuple[float, int]] = []
    for side, place in zip(FLANKS, places, strict=True):
        middle = as_signal(place, "places")
        same_length(f, middle, "force and places")
        nearest = np.rint(middle).astype(np.int64)
        edges = np.flatnonzero(np.diff(nearest)) + 1
        for a, b in zip(edges[:-1], edges[1:], strict=True):
            peak = side * float(max(0.0, np.max(side * f[a:b])))
            if peak != 0.0:
                found.append((peak, int(nearest[a])))
    return _pulses(found)


@dataclass(frozen=True)
class ToothLoads:
    """Load pulses of every tooth of a gear on one flank.

    Attributes
    ----------
    pulses
        Shape (teeth,). Number of pulses.
    largest
        Shape (teeth,). Largest force [N].
    equivalent
        Shape (teeth,). Equivalent force [N]: as many constant pulses as the teeth have in the mean.
    forces
        Shape (n,). Forces of all pulses [N].
    """

    pulses: NDArray[np.int64]
    largest: Array
    equivalent: Array
    forces: Array


def tooth_loads(meshes: Sequence[Pulses], teeth: int, slope: float) -> Mapping[str, ToothLoads]:
    """Loads of the teeth of a gear from the pulses of all its meshes, by flank (ISO 6336-6:2006).

    Parameters
    ----------
    meshes
        Pulses of each mesh, with numbers of the teeth of the gear.
    teeth
        Number of teeth.
    slope
        Exponent of the Wöhler line, of force over life [-].

    Examples
    --------
    Two teeth, every second pulse twice as large:

    >>> from pitchpoint.analysis.tooth_pulses import Pulses
    >>> pulses = Pulses(np.array([1.0, 2.0] * 10), np.arange(20))
    >>> found = tooth_loads([pulses], 2, 6.0)["front"]
    >>> found.pulses, found.equivalent.round(12)
    (array([10, 10]), array([1., 2.]))
    """
    found = {}
    for sign, flank in FLANKS.items():
        force = np.concatenate([m.force[np.sign(m.force) == sign] for m in meshes])
        tooth = np.concatenate([m.tooth[np.sign(m.force) == sign] for m in meshes]) % teeth
        if not force.size:
            continue
        sizes = np.abs(force)
        pulses = np.bincount(tooth, minlength=teeth)
        largest = np.zeros(teeth)
        np.maximum.at(largest, tooth, sizes)
        number = float(force.size) / teeth
        own = [sizes[tooth == k] for k in range(teeth)]
        equivalent = np.array([equivalent_load(one, np.ones(one.size), slope, number) for one in own])
        found[flank] = ToothLoads(pulses, largest, equivalent, sizes)
    return found
