# SPDX-License-Identifier: Apache-2.0
"""Load pulses of single teeth: each tooth of a gear has one at every passage of a mesh (ISO 6336-6:2006)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.analysis.rainflow import equivalent_load
from pitchpoint.analysis.sampled import Array, as_signal, same_length, whole

FLANKS = {1: "front", -1: "back"}


@dataclass(frozen=True)
class Pulses:
    """Load pulses of tooth pairs in a mesh.

    Attributes
    ----------
    force
        Shape (n,). Largest force of each pulse, with its sign.
    place
        Shape (n,). Rotation of the gear at the middle of each pulse [teeth].
    """

    force: Array
    place: Array


def find_pulses(pair_forces: Sequence[ArrayLike], rotation: ArrayLike, teeth: int) -> Pulses:
    """Pulses of tooth pairs, each from entry to exit; pulses cut off by the ends of the record are omitted.

    Parameters
    ----------
    pair_forces
        Shape (n_pair, n). Force of the pairs, zero without contact [N]; a pair keeps its row while it is in
        contact, as in the channels `pair_force[MESH.k]`.
    rotation
        Shape (n,). Angle of the gear relative to the line of centres [rad].
    teeth
        Number of teeth.

    Notes
    -----
    A pair that separates within its contact, as in rattle, has one pulse: in one row, passages are `n_pair`
    teeth apart. The largest sample counts: with fewer than about ten samples per mesh period the peaks are
    too low. Counting by tooth as in ISO 6336-6:2006, with the force of the pair instead of the torque.
    """
    turned = as_signal(rotation, "rotation") * whole(teeth, "teeth") / (2.0 * np.pi)
    rows = [np.asarray(row, float) for row in pair_forces]
    found: list[tuple[float, float]] = []
    for row in rows:
        same_length(row, turned, "pair_forces and rotation")
        sense = np.sign(row)
        edges = np.flatnonzero(np.diff(sense)) + 1
        begins, ends = np.concatenate([[0], edges]), np.concatenate([edges, [row.size]])
        last: tuple[float, float, int] | None = None  # force, start, sense of the passage
        for k, end in zip(begins, ends, strict=True):
            if sense[k] == 0.0 or k == 0 or end == row.size:
                continue
            part = row[k:end]
            peak, at = float(part[np.argmax(np.abs(part))]), 0.5 * float(turned[k] + turned[end - 1])
            same = last is not None and last[2] == sense[k] and abs(at - last[1]) < 0.5 * len(rows)
            if same and last is not None:
                if abs(peak) > abs(found[-1][0]):
                    found[-1] = (peak, found[-1][1])
                continue
            last = (peak, at, int(sense[k]))
            found.append((peak, at))
    force, place = np.array(found).reshape(-1, 2).T
    return Pulses(force, place)


def find_passages(force: ArrayLike, rotation: ArrayLike, teeth: int) -> Pulses:
    """One pulse per tooth from the force of the whole mesh: its largest value while the tooth is the nearest.

    For meshes whose stiffness does not have single tooth pairs; the loads are too high, as the pairs share
    the force (ISO 6336-6:2006 counts the torque likewise).

    Parameters
    ----------
    force
        Shape (n,). Force of the mesh [N].
    rotation, teeth
        As for `find_pulses`.
    """
    f = np.asarray(force, float)
    turned = as_signal(rotation, "rotation") * whole(teeth, "teeth") / (2.0 * np.pi)
    same_length(f, turned, "force and rotation")
    nearest = np.rint(turned).astype(np.int64)
    edges = np.flatnonzero(np.diff(nearest)) + 1
    if edges.size < 2:
        return Pulses(np.zeros(0), np.zeros(0))
    parts = [f[a:b] for a, b in zip(edges[:-1], edges[1:], strict=True)]
    peaks = np.array([part[np.argmax(np.abs(part))] for part in parts])
    return Pulses(peaks, nearest[edges[:-1]].astype(float))


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
        Pulses of each mesh; their places refer to the same zero of the gear, so that the angle between the
        planets of a sun counts.
    teeth
        Number of teeth.
    slope
        Exponent of the Wöhler line, of force over life [-].

    Examples
    --------
    Two teeth, every second pulse twice as large:

    >>> from pitchpoint.analysis.tooth_pulses import Pulses
    >>> pulses = Pulses(np.array([1.0, 2.0] * 10), np.arange(20) + 0.3)
    >>> found = tooth_loads([pulses], 2, 6.0)["front"]
    >>> found.pulses, found.equivalent.round(12)
    (array([10, 10]), array([1., 2.]))
    """
    found = {}
    for sign, flank in FLANKS.items():
        force = np.concatenate([m.force[np.sign(m.force) == sign] for m in meshes])
        place = np.concatenate([m.place[np.sign(m.force) == sign] for m in meshes])
        if not force.size:
            continue
        offset = np.angle(np.exp(2j * np.pi * place).sum()) / (2.0 * np.pi)
        tooth = np.mod(np.rint(place - offset).astype(np.int64), teeth)
        sizes = np.abs(force)
        pulses = np.bincount(tooth, minlength=teeth)
        largest = np.zeros(teeth)
        np.maximum.at(largest, tooth, sizes)
        number = float(force.size) / teeth
        own = [sizes[tooth == k] for k in range(teeth)]
        equivalent = np.array([equivalent_load(one, np.ones(one.size), slope, number) for one in own])
        found[flank] = ToothLoads(pulses, largest, equivalent, sizes)
    return found
