# SPDX-License-Identifier: Apache-2.0
"""Working flanks of unloaded meshes for a small torque through the train.

Idlers and planets carry no external torque, so the mesh forces on them balance: the working flanks of a train
depend on each other. The torques of meshes, couplings and ratios balance at every spin except those where
torque enters or leaves: bodies with loads or drives, bodies held by springs and contacts, ends of the train.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import registry
from pitchpoint.elements.kind import DRIVE, FREE, MESH, Kind
from pitchpoint.multibody.bodies import spin_of
from pitchpoint.solvers.gear_trains import driven_coordinates
from pitchpoint.solvers.null_space import connected, null_space
from pitchpoint.solvers.resistance import SAME, resisted_spins
from pitchpoint.solvers.torque_paths import TorquePath, spins_of, torque_paths, turning
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import mesh_names, mesh_places, mesh_records
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

TOUCH = 1e-9
"""Penetration assumed for an unloaded flank [m]."""
NEAR = 0.01
"""Relative difference from it that is accepted."""
STEPS = 60
"""Largest number of Newton steps to first contact; each at least halves the penetration."""


def pressed_flanks(system: System, loose: Sequence[int], touching: Mapping[int, int]) -> dict[int, int]:
    """Working flanks for a small torque through the train, by unloaded mesh: 1 front, -1 back.

    The torque enters at the first end of a train, in the direction that loads the front flank of its first
    unloaded mesh. Meshes outside this torque path have their front flank loaded.

    Parameters
    ----------
    system
        The system.
    loose
        Indices of the unloaded meshes.
    touching
        Flanks of those already in contact; they define the torque direction of their train.
    """
    if len(loose) == len(touching):
        return dict(touching)
    paths, places = torque_paths(system), mesh_places(system)
    number = {(p.kind, p.number): c for c, p in enumerate(paths)}
    ends = _ends(system, paths)
    trains = connected([p.row for p in paths], spins_of(system))
    train_of = {spin: k for k, spins in enumerate(trains) for spin in spins}
    members: dict[int, list[int]] = {}
    for c, path in enumerate(paths):
        members.setdefault(train_of[next(iter(path.row))], []).append(c)
    meshes: dict[int, dict[int, int]] = {}
    for m in (m for m in loose if places[m] in number):
        c = number[places[m]]
        meshes.setdefault(train_of[next(iter(paths[c].row))], {})[m] = c
    found = dict(touching)
    for k, wanted in meshes.items():
        patterns = _patterns(paths, members[k], [s for s in trains[k] if s not in ends])
        entries = [s for s in trains[k] if s in ends]
        _add_signs(found, paths, members[k], patterns, entries, wanted)
    return {m: found.get(m, 1) for m in loose}


def _ends(system: System, paths: Sequence[TorquePath]) -> set[int]:
    """Spins where torque enters or leaves a train."""
    body = system.program["body"]
    found = {*resisted_spins(system), *driven_coordinates(system)}
    for kind, records in system.records.items():
        for record in records if _brings_torque(registry.find(kind)) else ():
            found |= {spin_of(body, int(record[end])) for end in "ij" if end in (record.dtype.names or ())}
    joints: dict[int, set[object]] = {}
    riding = set()
    for c, path in enumerate(paths):
        gears = set()
        if registry.find(path.kind).role == MESH:
            record = system.records[path.kind][path.number]
            gears = {b for b in (int(record["i"]), int(record["j"])) if spin_of(body, b) >= 0}
            riding |= {spin_of(body, b) for b in gears if len(turning(system, b)) > 1}
        carriers = path.row.keys() - {spin_of(body, b) for b in gears} if gears else set()
        for spin in path.row:  # all meshes of a planetary set count as one joint
            joints.setdefault(spin, set()).add(("carried", *sorted(carriers)) if carriers else c)
    return (found | {spin for spin, joined in joints.items() if len(joined) == 1}) - riding


def _brings_torque(kind: Kind) -> bool:
    """Whether a kind exerts torques without constraining the rotation: loads, clutches, dampers."""
    return kind.power is not None and bool(kind.power.torque) and kind.spins == FREE and kind.role != DRIVE


def _patterns(paths: Sequence[TorquePath], own: Sequence[int], inner: Sequence[int]) -> Array:
    """Element torques in balance at the inner spins: orthonormal columns, shape (len(own), patterns)."""
    rows = [{c: paths[c].row[s] for c in own if s in paths[c].row} for s in inner]
    space = null_space([row for row in rows if row], own)
    place = {c: k for k, c in enumerate(own)}
    found = np.zeros((len(own), sum(basis.shape[1] for _, basis in space.groups)))
    column = 0
    for elements, basis in space.groups:
        found[[place[c] for c in elements], column : column + basis.shape[1]] = basis
        column += basis.shape[1]
    return found


def _add_signs(
    found: dict[int, int],
    paths: Sequence[TorquePath],
    own: Sequence[int],
    patterns: Array,
    entries: Sequence[int],
    wanted: dict[int, int],
) -> None:
    """Add the flanks of the meshes of one train: for a torque through its ends first, then mesh by mesh."""
    place = {c: k for k, c in enumerate(own)}
    entering = [np.array([paths[c].row.get(spin, 0.0) for c in own]) for spin in entries[:1]]
    single = [np.eye(len(own))[place[c]] for c in wanted.values()]
    for torque in [*entering, *single]:
        forces = patterns @ (patterns.T @ torque)
        least = SAME * np.abs(torque).max()
        pressed = {m: forces[place[c]] for m, c in wanted.items() if abs(forces[place[c]]) > least}
        new = [m for m in pressed if m not in found]
        if not new:
            continue
        known = [m for m in pressed if m in found]
        sense = np.sign(pressed[known[0]]) * found[known[0]] if known else np.sign(pressed[new[0]])
        found.update({m: int(np.sign(pressed[m]) * sense) for m in new})


def close_backlash(system: System, state: State, known: Mapping[str, int] | None = None) -> dict[str, int]:
    """Bring the flanks of unloaded meshes into contact by shifting the assembly; returns the flank by mesh.

    1 front, -1 back: the flank given in `known`, or in contact already, or the working flank for a small
    torque through the train. Changes the records of the system: pass a copy.
    """
    flanks: dict[int, int] = {}
    loose = []
    still = state.copy()
    still.v[:] = 0.0
    names, records = mesh_names(system), mesh_records(system)
    for k, (depth, touching) in enumerate(_contacts(system, still, range(len(names)))):
        # without backlash both flanks of an unloaded mesh are in contact by round-off
        if depth < TOUCH:
            loose.append(k)
            if known and names[k] in known:
                flanks[k] = known[names[k]]
            elif touching in (1.0, -1.0) and records[k]["now"]["gap"] > TOUCH:
                flanks[k] = int(touching)
    found = pressed_flanks(system, loose, flanks)
    shift_into_contact(system, still, found)
    return {names[k]: found[k] for k in loose}


def _contacts(system: System, state: State, meshes: Iterable[int]) -> Iterator[tuple[float, float]]:
    """Force over stiffness [m], 0 without contact, and contact state of some meshes.

    Tilted gears may touch at one end of the face with a gap at mid-face: penetration there is no measure.
    """
    values, names, records = evaluate.observe(system, state), mesh_names(system), mesh_records(system)
    for k in meshes:
        touching, force, stiffness = (
            float(values[system.layout.channel(f"{quantity}[{names[k]}]")])
            for quantity in ("contact_state", "normal_force", "mesh_stiffness")
        )
        force /= float(records[k]["contact"]["normal"])
        yield (force / stiffness if stiffness > 0.0 else 0.0), touching


def shift_into_contact(system: System, state: State, flanks: Mapping[int, int]) -> None:
    """Shift the assembly of some meshes, by index, so that the given flank is just in contact.

    A tilted flank then touches at one end of the face. Its force grows more than linearly with the
    penetration, so that Newton steps to a force of zero approach first contact from one side.
    """
    records = mesh_records(system)
    for _ in range(2):  # the excitation depends on the phase
        evaluate.residual(system, state)
        for k, flank in flanks.items():
            record = records[k]
            record["u0"] += flank * (TOUCH - _mid_depth(record, flank))
    for _ in range(STEPS):
        excess = [depth - TOUCH for depth, _ in _contacts(system, state, flanks)]
        if max(excess, default=0.0) <= NEAR * TOUCH:
            return
        for (k, flank), more in zip(flanks.items(), excess, strict=True):
            records[k]["u0"] -= flank * max(more, 0.0)


def touches_at_one_end(record: np.void, flank: int) -> bool:
    """Whether an evaluated mesh at first contact has a gap at mid-face because its gears are tilted."""
    return _mid_depth(record, flank) < 0.0


def _mid_depth(record: np.void, flank: int) -> float:
    """Penetration of a flank at mid-face, over that at which the nearest point of parallel gears touches."""
    now = record["now"]
    return float(flank * (now["u"] - now["e_t"]) - 0.5 * now["gap"] - record["sep_min"])
