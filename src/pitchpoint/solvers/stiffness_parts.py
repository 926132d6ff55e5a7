# SPDX-License-Identifier: Apache-2.0
"""Stiffness of a system split into its elements, and its mean over the mesh cycles.

What an element contributes is the difference between the matrix with it alone and with none (see
`element_tangents`), so every kind keeps its physics in its kernel. A mesh is turned through its cycle by
moving its path of contact, all bodies staying where they are: meshes of a train get their own mean each,
whatever the periods of the others.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import gear_mesh_record as mesh
from pitchpoint.elements import registry
from pitchpoint.elements.mesh_pairs import MOST_SPLIT
from pitchpoint.solvers.element_tangents import (
    Share,
    bare_blocks,
    element_names,
    share_of_blocks,
    stiffness_of,
    tangents,
)
from pitchpoint.solvers.equilibrium import find_equilibrium
from pitchpoint.solvers.flanks import pressed_flanks
from pitchpoint.system import evaluate
from pitchpoint.system.meshes import KINDS, is_bevel, mesh_names, mesh_places, mesh_record, mesh_records
from pitchpoint.system.system import State, System

Array = NDArray[np.float64]

#: Field that holds the stiffness of a mesh; without it there is none.
STIFFNESS_FIELD = dict.fromkeys(KINDS, "c_prime")

NONE = 1e-14
"""Stiffness over the largest below which an element has none."""

FIRST = ("bearing", "coupling", *KINDS)
"""Kinds that are listed before all others."""

WORDS = {**dict.fromkeys(KINDS, "mesh"), "closure": "reaction", "shaft_beam": "beam"}
"""Words for kinds where they differ from the name."""

TOUCH = 1e-9
"""Penetration at which an unloaded flank is looked at [m]."""

_GAUSS_X, _GAUSS_W = np.polynomial.legendre.leggauss(3)


@dataclass(frozen=True)
class Parts:
    """Linearised system about one operating point, elements apart.

    Parameters
    ----------
    M, D, K
        Mass, damping and stiffness matrix, shape (nd, nd); D and K are those of the whole system.
    elements
        Names of the elements with stiffness, "KIND NAME"; loads and reactions of loops have one too where
        they turn with what moves.
    kinds
        Their kinds.
    bodies
        The two bodies of each element, 0 is ground, shape (ne, 2).
    shares
        Their shares of K.
    """

    M: Array
    D: Array
    K: Array
    elements: tuple[str, ...]
    kinds: tuple[str, ...]
    bodies: NDArray[np.int64]
    shares: tuple[Share, ...]


def element_list(system: System) -> list[tuple[str, int, str]]:
    """All elements: kind, number of the record, "WORD NAME" for people."""
    found = []
    for kind in sorted(system.records, key=_rank):
        if registry.find(kind).channel in (registry.MOTION, registry.FRICTION):
            continue
        for k, name in enumerate(element_names(system, kind)):
            word = WORDS.get(kind, kind.replace("_", " "))
            if kind == "bearing" and system.records[kind][k]["j"] != 0:
                word = "coupling"
            found.append((kind, k, f"{word} {name}"))
    return found


def _rank(kind: str) -> tuple[int, str]:
    """Springs first, then all others by name."""
    return (FIRST.index(kind) if kind in FIRST else len(FIRST), kind)


def shift(record: np.void, share: float) -> None:
    """Move a mesh on by a share of its cycle; no body moves."""
    record["xi_0"] += share * record["p_bt"]
    record["xi_b"] -= share * record["p_bt"]


def cycle_nodes(record: np.void, flank: int, pool: Array, both: bool = False) -> tuple[Array, Array]:
    """Phases of a flank and weights whose sum is the mean over one mesh cycle.

    Exact for the closed forms and for tables of a pair of up to `MOST_SPLIT` points: three Gauss points
    between kinks (the total is a polynomial of at most degree four there), equal steps for a Fourier series,
    the middles of the segments of a table of the mesh. Longer tables of a pair count as smooth on sixteen
    pieces. Slices and user laws are sampled at 128 points. `both`: the other flank carries too, and has kinks
    of its own.
    """
    if record["source"] == mesh.PHASE:
        n = int(record["n_k"])
        if record["form"] == 0:
            return _equal(max(8, 2 * n + 2))
        if record["form"] == 1:
            return _equal(n if n >= 32 else n * (32 // n + 1))
        if record["form"] == mesh.USER:
            return _equal(128)
    elif record["slices"] > 0:
        return _equal(128)
    kinks = _kinks(record, flank, pool)
    if both:
        # one phase falls as the other rises: both travel with the gears
        turned = float(record["start"].sum() + (record["xi_0"] + record["xi_b"]) / record["p_bt"])
        kinks = np.append(kinks, turned - _kinks(record, -flank, pool))
    kinks = np.unique(kinks % 1.0)
    lengths = np.diff(np.append(kinks, kinks[0] + 1.0))
    middle = kinks + 0.5 * lengths
    phases = middle[:, None] + 0.5 * lengths[:, None] * _GAUSS_X
    return phases.ravel(), (0.5 * lengths[:, None] * _GAUSS_W).ravel()


def _kinks(record: np.void, flank: int, pool: Array) -> Array:
    """Phases of a flank where its total stiffness has a kink or jumps, whole base pitches apart from any."""
    if record["source"] == mesh.PHASE:
        return np.array([0.0, pool[int(record["cosine"]) + 2]])
    lam = flank * record["tan_b"] / record["p_bt"]
    eps, L, n = float(record["eps"]), float(record["L"]), int(record["n_table"])
    places = [0.0, eps, L, eps - L, 0.5 * eps]
    if n > 2:
        places += list(np.linspace(0.0, eps, n if n <= MOST_SPLIT else 17)[1:-1])
    ends = lam * np.array([record["z_lo"], record["z_hi"]], dtype=float)
    if is_bevel(record):  # contact lines of bevel gears are spirals
        ends = lam * record["R_m"] * np.log1p(ends / (lam * record["R_m"])) if lam != 0.0 else ends
    return np.asarray(np.subtract.outer(places, ends).ravel())


def _equal(n: int) -> tuple[Array, Array]:
    return (np.arange(n) + 0.5) / n, np.full(n, 1.0 / n)


def touching(system: System, state: State) -> dict[str, int]:
    """Bring the flanks of unloaded meshes into touch by shifting the assembly; gives them by mesh.

    1 is the front flank and -1 the back: the one that the mesh leans on already, else that which a small
    torque through the train presses. Changes the records of the system: give it a copy.
    """
    leaning: dict[int, int] = {}
    loose = []
    for k, record in enumerate(mesh_records(system)):
        evaluate.residual(system, state)
        depth = abs(record["u"] - record["e_t"]) - 0.5 * record["gap"] - record["sep_min"]
        # without backlash round-off presses both flanks of an unloaded mesh
        if depth < TOUCH:
            loose.append(k)
            if depth > 0.0 and record["gap"] > TOUCH:
                leaning[k] = -1 if record["u"] < record["e_t"] else 1
    names, found = mesh_names(system), pressed_flanks(system, loose, leaning)
    for k in loose:
        _touch(system, state, mesh_record(system, k), found[k])
    return {names[k]: found[k] for k in loose}


def _touch(system: System, state: State, record: np.void, flank: int) -> None:
    for _ in range(2):  # the excitation follows the phase
        evaluate.residual(system, state)
        aim = flank * (0.5 * record["gap"] + record["sep_min"] + TOUCH)
        record["u0"] += aim - (record["u"] - record["e_t"])


def split(
    system: System,
    state: State,
    held: tuple[int, ...],
    mean: bool = True,
    touched: Collection[str] = (),
    progress: Callable[..., None] | None = None,
    rates: Array | None = None,
) -> Parts:
    """Linearise about a state and split the stiffness.

    Parameters
    ----------
    system
        The system; its mesh records are moved to and fro, so give a copy if another thread uses it.
    state
        Operating point; its speeds count in D and K.
    held
        Spins that are kept while a mesh goes through its cycle.
    mean
        Take every mesh at its mean over the mesh cycle instead of at its phase.
    touched
        Meshes that carry nothing and are kept at the edge of contact.
    progress
        Told after every element.
    rates
        Speeds whose forces (drag of bearings, motors) load the meshes through their cycles; those of `state`
        if left out.
    """
    under = state.v if rates is None else rates
    M, D, K = (
        evaluate.blocks(system, state, *f) for f in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    )
    bare = bare_blocks(system, state, 0.0, 0.0, 1.0)
    least = NONE * float(np.abs(K).max(initial=0.0))
    found: list[tuple[str, str, tuple[int, int], Share]] = []
    listed = element_list(system)
    for e, (kind, k, name) in enumerate(listed):
        if kind in KINDS:
            d, own = tangents(system, state, {kind: slice(k, k + 1)})
            if mean:
                loose = name.partition(" ")[2] in touched
                m = mesh_places(system).index((kind, k))
                D_mean, K_mean = _cycle_mean(system, state, held, m, loose, under)
                D, K, own = D + D_mean - d, K + K_mean - own, K_mean
        else:
            own = stiffness_of(system, state, {kind: slice(k, k + 1)}, bare)
        if kind in FIRST or np.abs(own).max(initial=0.0) > least:
            found.append((kind, name, _ends(system.records[kind][k]), share_of_blocks(system, own)))
        if progress is not None:
            progress(e + 1, len(listed), name)
    if np.abs(bare).max(initial=0.0) > least:  # joints that turn over time make the bodies heavy or light
        found.append(("rotation", "guided motion", (0, 0), share_of_blocks(system, bare)))
    kinds, names, bodies, shares = zip(*found, strict=True) if found else ((), (), (), ())
    ends = np.array(bodies, np.int64).reshape(-1, 2)
    whole = [evaluate.dense(system, blocks) for blocks in (M, D, K)]
    return Parts(whole[0], whole[1], whole[2], tuple(names), tuple(kinds), ends, tuple(shares))


def _ends(record: np.void) -> tuple[int, int]:
    """Both bodies of an element."""
    fields = record.dtype.names or ()
    return int(record["i"]), int(record["j"]) if "j" in fields else 0


def _cycle_mean(
    system: System, state: State, held: tuple[int, ...], k: int, loose: bool, rates: Array
) -> tuple[Array, Array]:
    """Mean damping and stiffness of mesh k over its cycle as blocks, the other meshes at their phase."""
    record, (kind, n) = mesh_record(system, k), mesh_places(system)[k]
    kept = record.copy()
    names = mesh_names(system)
    values = evaluate.observe(system, state)
    contact = values[system.layout.channel(f"contact_state[{names[k]}]")]
    flank = -1 if contact < 0.0 else 1
    now = _phase(system, state, k, flank)
    both = bool(contact == 2.0 or record["gap"] < 0.0)
    phases, weights = cycle_nodes(record, flank, system.pools.get(kind, np.zeros(0)), both)
    total = np.zeros((2, *system.workspace.A.shape))
    at = state
    try:
        for psi, weight in zip(phases, weights, strict=True):
            for name in ("xi_0", "xi_b", "u0"):
                record[name] = kept[name]
            shift(record, flank * (float(psi) - now))
            if loose:
                _touch(system, at, record, flank)
            else:
                for _ in range(2):  # the deflection there moves the phase a little
                    at = _rest_at(system, at, held, state, rates)
                    shift(record, flank * _nearest(float(psi) - _phase(system, at, k, flank)))
            total += weight * np.array(tangents(system, at, {kind: slice(n, n + 1)}))
    finally:
        for name in ("xi_0", "xi_b", "u0"):
            record[name] = kept[name]
        evaluate.residual(system, state)
    return total[0], total[1]


def _phase(system: System, state: State, k: int, flank: int) -> float:
    """Phase of one flank of mesh k; that of the back flank is left in the record by its own sum."""
    values = evaluate.observe(system, state)
    if flank < 0:
        return float(mesh_record(system, k)["psi"])
    return float(values[system.layout.channel(f"mesh_phase[{mesh_names(system)[k]}]")])


def _nearest(difference: float) -> float:
    """Difference of two phases in [-1/2, 1/2)."""
    return (difference + 0.5) % 1.0 - 0.5


def _rest_at(system: System, near: State, held: tuple[int, ...], like: State, rates: Array) -> State:
    """Equilibrium under the loads at some rates, with the rates of `like` put into it."""
    start = near.copy()
    start.v[:] = rates
    found = find_equilibrium(system, start, held).state
    found.v[:] = like.v
    return found
