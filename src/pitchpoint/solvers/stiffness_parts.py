# SPDX-License-Identifier: Apache-2.0
"""Stiffness of a system by element, with the mean over the mesh cycles.

The contribution of an element is the difference between the matrix with it and without elements (see
`element_tangents`).
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import registry
from pitchpoint.elements.kind import FRICTION, MESH, MOTION
from pitchpoint.solvers.cycle_means import cycle_means
from pitchpoint.solvers.element_batches import share_of_blocks, stiffness_by_element
from pitchpoint.solvers.element_tangents import Share, bare_blocks, element_names, share_of
from pitchpoint.solvers.tooth_wave import ToothWave, tooth_wave
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import mesh_places
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

ROTATION = "rotation"
"""Substitute for the kind of the inertial stiffness of prescribed motion."""

NONE = 1e-14
"""Stiffness over the largest below which it counts as zero."""


@dataclass(frozen=True)
class Parts:
    """Linearised system about one operating point, with the stiffness of each element.

    Parameters
    ----------
    M, D, K
        Mass, damping and stiffness matrix of the whole system, shape (nd, nd).
    elements
        Names of the elements with stiffness, "KIND NAME"; includes follower loads and loop reactions with
        geometric stiffness.
    kinds
        Their kinds.
    bodies
        The two bodies of each element, 0 is ground, shape (ne, 2).
    shares
        Their contributions to K.
    damping
        Contributions of the meshes to D, by name of the element.
    waves
        Excitation by the varying stiffness and errors of the meshes that carry load, over their cycle, by
        name of the element.
    """

    M: Array
    D: Array
    K: Array
    elements: tuple[str, ...]
    kinds: tuple[str, ...]
    bodies: NDArray[np.int64]
    shares: tuple[Share, ...]
    damping: Mapping[str, Share]
    waves: Mapping[str, ToothWave]


def element_list(system: System) -> list[tuple[str, int, str]]:
    """All elements: kind, record index, label "KIND NAME"."""
    found = []
    for kind in sorted(system.records, key=_rank):
        described = registry.find(kind)
        if described.channel in (MOTION, FRICTION):
            continue
        for k, name in enumerate(element_names(system, kind)):
            found.append((kind, k, f"{described.label_of(system.records[kind][k])} {name}"))
    return found


def _rank(kind: str) -> tuple[bool, bool, str]:
    """Sort key: bearings and couplings first, then meshes, then all others by name."""
    described = registry.find(kind)
    return not described.main, described.role == MESH, kind


def split(
    system: System,
    state: State,
    held: tuple[int, ...],
    mean: bool = True,
    touched: Collection[str] = (),
    progress: Callable[..., None] | None = None,
    rates: Array | None = None,
    settled: bool = True,
) -> Parts:
    """Linearise about a state, with the stiffness by element.

    Parameters
    ----------
    system
        The system; its mesh records are changed temporarily, so pass a copy if another thread uses it.
    state
        Operating point; its speeds contribute to D and K.
    held
        Spins held during the mesh cycles.
    mean
        Use the mean over the mesh cycle for every mesh instead of the value at its phase.
    touched
        Unloaded meshes, which are set to first contact.
    progress
        Called after every element.
    rates
        Rates of the speed-dependent loads (bearing drag, motors) during the mesh cycles; default those of
        `state`.
    settled
        Whether bodies find their equilibrium at every phase of the cycles, see `cycle_means`.
    """
    under = state.v if rates is None else rates
    M, D, K = (
        evaluate.blocks(system, state, *f) for f in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    )
    bare = bare_blocks(system, state, 0.0, 0.0, 1.0)
    least = NONE * float(np.abs(K).max(initial=0.0))
    found: list[tuple[str, str, tuple[int, int], Share]] = []
    listed = element_list(system)
    means = cycle_means(system, state, held, touched, under, settled) if mean else {}
    numbers = {place: m for m, place in enumerate(mesh_places(system))}
    damping: dict[str, Share] = {}
    waves: dict[str, ToothWave] = {}
    at_phase = stiffness_by_element(system, state, [(kind, k) for kind, k, _ in listed])
    for e, ((kind, k, name), (blocks, d, own)) in enumerate(zip(listed, at_phase, strict=True)):
        described = registry.find(kind)
        if described.role == MESH and mean:
            cycle = means[numbers[kind, k]]
            D[blocks.places] += cycle.damping - d
            K[blocks.places] += cycle.stiffness - own
            d, own = cycle.damping, cycle.stiffness
            if cycle.phases.size:
                waves[name] = tooth_wave(share_of_blocks(system, blocks, own), cycle)
        if described.role == MESH:
            damping[name] = share_of_blocks(system, blocks, d)
        if described.main or np.abs(own).max(initial=0.0) > least:
            found.append((kind, name, _ends(system.records[kind][k]), share_of_blocks(system, blocks, own)))
        if progress is not None:
            progress(e + 1, len(listed), name)
    if np.abs(bare).max(initial=0.0) > least:  # inertia of bodies on joints with prescribed rotation
        found.append((ROTATION, "guided motion", (0, 0), share_of(evaluate.dense(system, bare))))
    kinds, names, bodies, shares = zip(*found, strict=True) if found else ((), (), (), ())
    ends = np.array(bodies, np.int64).reshape(-1, 2)
    M, D, K = (evaluate.dense(system, blocks) for blocks in (M, D, K))
    return Parts(M, D, K, tuple(names), tuple(kinds), ends, tuple(shares), damping, waves)


def _ends(record: np.void) -> tuple[int, int]:
    """Both bodies of an element."""
    fields = record.dtype.names or ()
    return int(record["i"]), int(record["j"]) if "j" in fields else 0
