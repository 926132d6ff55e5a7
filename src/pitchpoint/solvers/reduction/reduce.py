# SPDX-License-Identifier: Apache-2.0
"""Model reduction: linear parts are condensed about an operating point; meshes and other laws are unchanged.

Bodies with linear elements only (bearings, bushings, couplings, springs, beams) are condensed onto the other
bodies by static shapes and fixed-interface modes (Craig and Bampton). Retained bodies and elements are
evaluated by their own kernels, including large rotation; a condensed part is a linear element between the
retained bodies and a few modal coordinates, with gyroscopic terms at the operating speed. Parts can be
condensed if their linearisation is time-invariant (`reduction.condensable`). The retained bodies of a part
are assumed to stay near the operating point unless they are rotationally symmetric.

References
----------
.. [1] R. R. Craig, M. C. C. Bampton: Coupling of substructures for dynamic analyses, AIAA Journal 6 (1968)
   1313-1319.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import registry
from pitchpoint.elements.kind import CONSTRAINT
from pitchpoint.model.scenario import Scenario
from pitchpoint.multibody.bodies import Body
from pitchpoint.solvers.controls import held_outputs, refuse_loads
from pitchpoint.solvers.element_tangents import element_names, switched
from pitchpoint.solvers.operating_point import operating_point
from pitchpoint.solvers.position_dependence import FACTORS
from pitchpoint.solvers.reduction.condensable import (
    Choice,
    Split,
    coordinates_of,
    split_up,
    sum_over,
)
from pitchpoint.solvers.reduction.condensed_part import (
    HOLD,
    MODES,
    PART,
    TWIST,
    Linear,
    Rows,
    condense,
    damp_across,
)
from pitchpoint.solvers.reduction.error import ReductionError, compare
from pitchpoint.system import evaluate
from pitchpoint.system.system import State, System, assemble

NAMED = 5
"""Maximum number of elements listed in a note."""
BEYOND = (4.0, 8.0, 16.0, 32.0, 64.0)
"""Multiples of the highest frequency of interest up to which fixed-interface modes are retained: the first is
enough for shafts; heavy bodies on soft springs between stiffly supported ones need more."""
WANTED = 1e-3, 2e-2
"""Target errors of the natural frequencies and of the compliance of the meshes."""


@dataclass(frozen=True)
class Reduced:
    """A reduced system.

    Parameters
    ----------
    system
        The system: retained bodies, and modal coordinates as bodies `PART.mode1` ...
    state
        The operating point in its coordinates.
    full, full_state
        The full system and its operating point.
    error
        Error of the reduced system up to the highest frequency of interest.
    kept
        Names of the retained bodies.
    reasons
        Why each of them is retained.
    notes
        Notes on bodies and elements that are retained unexpectedly, and of the operating point.
    """

    system: System
    state: State
    full: System
    full_state: State
    error: ReductionError
    kept: tuple[str, ...] = ()
    reasons: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()


def reduce_system(
    system: System,
    scenario: Scenario | str | None = None,
    *,
    limit: float,
    keep: Sequence[str] = (),
    start: State | None = None,
) -> Reduced:
    """Condense the linear parts of a system about an operating point.

    Parameters
    ----------
    system
        The compiled system.
    scenario, start
        Define the operating point, as in `modal.find_modes`.
    limit
        Highest frequency of interest [Hz].
    keep
        Names of bodies and of elements ("KIND NAME") to retain.

    Returns
    -------
    Reduced

    Raises
    ------
    SolverError
        If a name is unknown or there is no equilibrium.
    """
    refuse_loads(system, "a reduced system")
    point = operating_point(system, scenario, start)
    own, state = point.system, point.state
    split = split_up(own, state, keep)
    whole = _linear(own, state, split)
    modes = -1
    for beyond in BEYOND:
        found, count = _condensed(own, state, split, whole, beyond * limit)
        if count == modes:
            continue
        begun, modes = _state_of(own, state, found, split.kept), count
        reduced = found, begun, compare(own, state, found, begun, limit)
        if reduced[2].frequency <= WANTED[0] and reduced[2].compliance <= WANTED[1]:
            break
    names = tuple(own.layout.bodies[b] for b in split.kept)
    return Reduced(
        reduced[0],
        reduced[1],
        own,
        state,
        reduced[2],
        names,
        split.reasons,
        (
            *(n for n in point.notes if n not in held_outputs(own)),
            *split.notes,
        ),
    )


def lost_channels(full: System, reduced: System) -> tuple[str, ...]:
    """Note on the channels of condensed bodies and elements, which a reduced system does not have."""
    kept = {c.name for c in reduced.layout.channels}
    lost: dict[str, list[str]] = {}
    for name in (c.name for c in full.layout.channels if c.name not in kept):
        quantity, _, rest = name.partition("[")
        element = rest.rstrip("]").partition(".")[0]
        if element not in lost.setdefault(quantity, []):
            lost[quantity].append(element)
    if not lost:
        return ()
    parts = [
        f"{quantity} of {', '.join(names[:NAMED])}"
        + (f" and {more} more" if (more := len(names) - NAMED) > 0 else "")
        for quantity, names in lost.items()
    ]
    return (
        f"not recorded for condensed bodies and elements: {'; '.join(parts)}; run the full system to "
        "record them",
    )


def _bodies(system: System, split: Split) -> tuple[list[Body], dict[int, int]]:
    """Retained bodies, and their new indices."""
    number = {0: 0} | {b: k for k, b in enumerate(split.kept, start=1)}
    old = {b: system.bodies[b - 1] for b in split.kept}
    bodies = [
        replace(
            body,
            parent=number[body.parent],
            shares=number[body.shares],
            spinner=number[body.spinner],
            name=system.layout.bodies[b],
        )
        for b, body in old.items()
    ]
    return bodies, number


def _condensed(system: System, state: State, split: Split, whole: Linear, limit: float) -> tuple[System, int]:
    """The reduced system with fixed-interface modes up to a frequency [Hz], and their number."""
    bodies, number = _bodies(system, split)
    rows: Rows = {kind: [] for kind in (PART, HOLD, MODES, TWIST)}
    parts = []
    for p, part in enumerate(split.parts):
        sides = [b for b in part if b in number], [b for b in part if b not in number]
        parts.append(condense(system, state, whole, sides, limit, f"part{p + 1}", number, bodies, rows))
    damp_across(whole.D, state, parts, rows[MODES])
    return _assembled(system, split.condensed, number, bodies, rows), len(rows[TWIST])


def _linear(system: System, state: State, split: Split) -> Linear:
    """Matrices of the condensed parts: all bodies and the condensed elements, less the retained bodies."""
    bodies, number = _bodies(system, split)
    kept = _assembled(system, split.condensed, number, bodies, {})
    near = _state_of(system, state, kept, split.kept)
    at = coordinates_of(system, split.kept)
    own = coordinates_of(kept, range(1, len(split.kept) + 1))
    found = []
    for factors in FACTORS:
        A = sum_over(system, split.condensed, lambda f=factors: evaluate.matrix(system, state, *f))  # type: ignore[misc]
        with switched(kept, {}):
            A[np.ix_(at, at)] -= evaluate.matrix(kept, near, *factors)[np.ix_(own, own)]
        found.append(A)
    for s in (still := state.copy(), near):
        s.a[:] = 0.0
        s.lam[:] = 0.0
    f = sum_over(system, split.condensed, lambda: evaluate.residual(system, still))
    with switched(kept, {}):
        f[at] -= evaluate.residual(kept, near)[own]
    return Linear(found[0], found[1], found[2], f)


def _assembled(
    system: System,
    condensed: Choice,
    number: dict[int, int],
    bodies: list[Body],
    rows: Rows,
) -> System:
    """Assemble the reduced system from bodies, retained elements and condensed parts."""
    banks: dict[str, NDArray[np.void]] = {}
    names: dict[str, list[str]] = {}
    laws = {}
    for kind, bank in system.records.items():
        rest = np.setdiff1d(np.arange(bank.size), condensed.get(kind, np.zeros(0, np.int64)))
        kept = bank[rest].copy()
        for field in registry.find(kind).ends:
            kept[field] = [number[int(b)] for b in kept[field]]
        banks[kind] = kept
        names[kind] = [element_names(system, kind)[k] for k in rest]
        if kind in system.laws:
            laws[kind] = [system.laws[kind][k] for k in rest]
    for kind, more in rows.items():
        if more:
            names[kind] = [*names.get(kind, ()), *(f"condensed{k + 1}" for k in range(len(more)))]
            banks[kind] = np.concatenate([*([banks[kind]] if kind in banks else []), *more])
    constraints = {k: b for k, b in banks.items() if registry.find(k).channel == CONSTRAINT}
    others = {k: b for k, b in banks.items() if k not in constraints and b.size}
    own = assemble(bodies, others, constraints, names=names, pools=system.pools, laws=laws)
    return replace(own, controllers=system.controllers)


def _state_of(system: System, state: State, found: System, kept: Sequence[int]) -> State:
    """The operating point in the retained coordinates; modal coordinates are zero."""
    begun = found.initial_state()
    begun.t = state.t
    for new, old in enumerate(kept, start=1):
        a, b = found.program["body"][new], system.program["body"][old]
        n = int(a["n"])
        begun.q[a["dof"] : a["dof"] + n] = state.q[b["dof"] : b["dof"] + n]
        begun.v[a["dof"] : a["dof"] + n] = state.v[b["dof"] : b["dof"] + n]
        begun.turns[new] = state.turns[old]
        if a["chart"] >= 0:
            begun.charts[a["chart"]] = state.charts[b["chart"]]
    if begun.lam.size == state.lam.size:
        begun.lam[:] = state.lam
    return begun
