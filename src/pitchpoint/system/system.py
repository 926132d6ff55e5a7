# SPDX-License-Identifier: Apache-2.0
"""Compiled system: record arrays, structure and names; `assemble` creates it from numerical data."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.elements import kind as traits
from pitchpoint.elements import registry
from pitchpoint.multibody.bodies import Body, body_records, spin_of
from pitchpoint.system.layout import Layout, body_channels, products, structure
from pitchpoint.system.link import fit_signals, link, link_parts
from pitchpoint.system.mass_programmes import mass_programmes
from pitchpoint.system.records import checked, fill, number, pairs
from pitchpoint.system.workspace import Workspace

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.system.controller import SampledController

TWO_PI = 6.283185307179586
MAX_PRODUCTS = 12_000_000
"""Maximum number of joint pairs in the matrix (chain of 330 bodies); beyond it the matrix takes gigabytes
and a step takes seconds."""
Law = Callable[..., float] | int


@dataclass
class State:
    """State of a system; the arrays are owned by the caller.

    Parameters
    ----------
    t
        Time [s].
    q, v, a
        Coordinates (spins as remainders), rates, accelerations; shape (nd,).
    lam
        Multipliers of the constraint rows, shape (nc,).
    turns
        Whole turns of each body, ground first, shape (nb,); the spin angle is q + 2 pi turns.
    charts
        Reference attitudes of the rotations of tumbling bodies, shape (number of tumbling bodies, 3, 3).
    """

    t: float
    q: NDArray[np.float64]
    v: NDArray[np.float64]
    a: NDArray[np.float64]
    lam: NDArray[np.float64]
    turns: NDArray[np.int64]
    charts: NDArray[np.float64]

    def __repr__(self) -> str:
        return f"State(t={self.t:g} s, {len(self.q)} coordinates, {len(self.lam)} multipliers)"

    def copy(self) -> State:
        """Independent copy."""
        return replace(self, **{name: x.copy() for name, x in vars(self).items() if name != "t"})

    def unwrapped(self, system: System) -> NDArray[np.float64]:
        """Coordinates with the whole turns of the spins, shape (nd,)."""
        q = self.q.copy()
        for spin, body in system.program["spins"]:
            q[spin] += 2.0 * np.pi * self.turns[body]
        return q


@dataclass(frozen=True)
class System:
    """Flat arrays of one compiled model. Use a separate `copy` for each thread.

    Parameters
    ----------
    bodies
        Bodies without ground.
    layout
        Names and indices.
    records
        Record array of each kind used.
    program
        Structure arrays (see `layout.structure`).
    sizes
        Sizes nb, nd, np, na, nc, no, ne (see `CTL`).
    pools
        Table pool of each kind that has one; its address is stored in the field ``pool`` of the records.
    laws
        User laws of each kind, one per record or None; their addresses are stored in the field ``law``.
    weight
        Length per unit of each coordinate in error norms.
    names
        Names of the records of each kind, for messages.
    controllers
        Sampled controllers, called by time integration at their sample times.
    model, scenario
        Model and scenario from which the system was compiled, if any.
    """

    bodies: tuple[Body, ...]
    layout: Layout
    records: Mapping[str, NDArray[np.void]]
    program: Mapping[str, NDArray[Any]]
    sizes: Mapping[str, int]
    pools: Mapping[str, NDArray[np.float64]] = field(default_factory=dict)
    laws: Mapping[str, Sequence[Law | None]] = field(default_factory=dict)
    weight: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0))
    names: Mapping[str, Sequence[str]] = field(default_factory=dict)
    controllers: tuple[SampledController, ...] = ()
    model: Model | None = None
    scenario: Scenario | None = None

    @cached_property
    def workspace(self) -> Workspace:
        """Memory and addresses, created at first use in this process."""
        tables = link(self.records, self.pools, self.laws)
        parts = link_parts(self.program["body"])
        program = {**self.program, **mass_programmes(self.program, self.records)}
        made = Workspace(program, dict(self.sizes), tables, parts, self.weight)
        fit_signals(made, self.records)
        return made

    def __repr__(self) -> str:
        """Title, size, and number of elements of each kind."""
        title = self.model.title if self.model is not None else ""
        parts = [f"{len(self.bodies)} bodies", f"{self.sizes['nd']} coordinates"]
        parts += [f"{self.sizes['nc']} constraints"] if self.sizes["nc"] else []
        kinds = [f"{kind.replace('_', ' ')} {len(record)}" for kind, record in self.records.items()]
        text = f"System{f' {title!r}' if title else ''}: {', '.join(parts)}"
        return f"{text}; elements: {', '.join(kinds)}" if kinds else text

    def __getstate__(self) -> dict[str, Any]:
        state = dict(self.__dict__)
        state.pop("workspace", None)  # addresses are valid in this process only
        return state

    def copy(self) -> System:
        """Independent copy for another thread."""
        return replace(
            self,
            records={k: r.copy() for k, r in self.records.items()},
            pools={k: p.copy() for k, p in self.pools.items()},
            program={k: a.copy() for k, a in self.program.items()},
        )

    def with_params(self, records: Mapping[str, NDArray[np.void]]) -> System:
        """Copy with other parameters and the same topology.

        Parameters
        ----------
        records
            New record arrays of some kinds with the same dtype and size; index fields must be unchanged.

        Raises
        ------
        CompileError
            If the size, dtype or an index field of a record array changes.
        """
        for name, new in records.items():
            old = self.records.get(name)
            if old is None or old.dtype != new.dtype or old.shape != new.shape:
                raise CompileError(f"with_params cannot change the kind or number of {name!r} elements")
            for key in ("i", "j", "ii", "ij", "ji", "jj", "out", "row"):
                if key in (old.dtype.names or ()) and not np.array_equal(old[key], new[key]):
                    raise CompileError(f"with_params cannot change the field {key!r} of {name!r} elements")
        return replace(self.copy(), records={k: records.get(k, r).copy() for k, r in self.records.items()})

    def initial_state(self) -> State:
        """State with the start values of the bodies, otherwise zero."""
        nd, nb = self.sizes["nd"], self.sizes["nb"]
        q, v, turns = np.zeros(nd), np.zeros(nd), np.zeros(nb, np.int64)
        places = (self.program["body"][name][1:].tolist() for name in ("dof", "spin"))
        for b, (body, first, spin) in enumerate(zip(self.bodies, *places, strict=True), start=1):
            q[first : first + len(body.start)] = body.start
            v[first : first + len(body.rate)] = body.rate
            if spin >= 0:
                q[spin] += body.angle
                turns[b] = round(q[spin] / TWO_PI)
                q[spin] -= TWO_PI * turns[b]
        charts = np.tile(np.eye(3), (int(self.program["body"]["chart"].max()) + 1, 1, 1))
        return State(0.0, q, v, np.zeros(nd), np.zeros(self.sizes["nc"]), turns, charts)

    @property
    def states(self) -> NDArray[np.int64]:
        """Coordinates whose rates are element states, shape (n,); their positions have no meaning."""
        body = self.program["body"]
        return np.asarray(body["spin"][body["state"] == 1])

    def kinds(self, role: str) -> list[str]:
        """Kinds of a role that have records (`elements.kind`), sorted."""
        return registry.of_role(self.records, role)

    def banks(self, role: str) -> list[NDArray[np.void]]:
        """Records of all kinds of a role, as views: writing to them changes the system."""
        return [self.records[kind] for kind in self.kinds(role)]

    def rows(self, role: str) -> list[np.void]:
        """List of all records of a role, as views."""
        return [record for bank in self.banks(role) for record in bank]

    def spin(self, body: str) -> int:
        """Index of the spin coordinate of a body, or of the body whose spin it takes over."""
        found = spin_of(self.program["body"], self.layout.bodies.index(body))
        if found < 0:
            raise CompileError(f"{body}: this body does not spin")
        return found


def assemble(
    bodies: Sequence[Body],
    banks: Mapping[str, NDArray[np.void]],
    constraints: Mapping[str, NDArray[np.void]] | None = None,
    *,
    names: Mapping[str, Sequence[str]] | None = None,
    pools: Mapping[str, NDArray[np.float64]] | None = None,
    laws: Mapping[str, Sequence[Law | None]] | None = None,
    weight_radius: float = 0.05,
) -> System:
    """Assemble a system from bodies, element records and constraint records.

    Parameters
    ----------
    bodies
        Bodies without ground, parents first; body k of the list has index k + 1 in the records, ground is 0.
    banks, constraints
        Record arrays by name of the kind with body numbers and physical parameters; index fields are set
        here.
    names
        Names of the elements of each kind, for the observations.
    pools, laws
        See `System`.
    weight_radius
        Length equivalent to one radian in error norms [m].

    Raises
    ------
    CompileError
        If the data of a body are invalid or a record refers to a body that does not exist.
    """
    named = [body.name or f"body{k}" for k, body in enumerate(bodies, start=1)]
    _check_bodies(bodies, named)
    records = body_records(bodies)
    ordered = _ordered({**banks, **(constraints or {})}, records)
    framed = (traits.FRAME, traits.FRICTION, traits.CONSTRAINT)
    joined: set[tuple[int, int]] = set().union(*(pairs(ordered, c) for c in framed))
    _check_depth(records, named, products(records, joined))
    program, pair_index, parts = structure(records, joined, pairs(ordered, traits.COORDINATE))
    for name, bank in ordered.items():
        fill(registry.find(name), bank, records, pair_index, parts)
    channels, events, rows, row_bodies = number(ordered, names or {})
    of_bodies, program["body_out"] = body_channels(bodies, named, records, len(channels))
    program["rows"] = np.array(row_bodies, np.int64).reshape(-1, 2)
    coordinates = _coordinates(bodies, named, records)
    layout = Layout(
        bodies=("ground", *named),
        coordinates=tuple(name for name, _ in coordinates),
        channels=(*channels, *of_bodies),
        events=tuple(events),
        rows=tuple(rows),
        **parts,
    )
    sizes = {
        "nb": records.size,
        "nd": len(layout.coordinates),
        "np": len(pair_index) + 1,
        "na": len(parts["blocks"]) + 1,
        "nc": len(layout.rows),
        "no": len(layout.channels),
        "ne": len(layout.events),
    }
    return System(
        bodies=tuple(bodies),
        layout=layout,
        records=ordered,
        program=program,
        sizes=sizes,
        pools=dict(pools or {}),
        laws=dict(laws or {}),
        weight=np.array([weight_radius if unit == "rad" else 1.0 for _, unit in coordinates]),
        names=dict(names or {}),
    )


def _check_bodies(bodies: Sequence[Body], named: Sequence[str]) -> None:
    """Raise CompileError for invalid bodies, listing all problems."""
    faults = [f"{n}: {fault}" for n, body in zip(named, bodies, strict=True) for fault in body.faults()]
    if len(set(named)) != len(named):
        faults.append("names of bodies must be unique")
    if faults:
        raise CompileError("; ".join(faults))
    faults = [
        f"{n}: the parent, body {body.parent}, is not among the {k} bodies before it"
        for k, (n, body) in enumerate(zip(named, bodies, strict=True))
        if not 0 <= body.parent <= k
    ]
    faults += [
        f"{n}: shares the coordinates of body {body.shares}, which is not among the {k} bodies before it"
        for k, (n, body) in enumerate(zip(named, bodies, strict=True))
        if not 0 <= body.shares <= k or (body.shares and bodies[body.shares - 1].shares)
    ]
    if faults:
        raise CompileError("; ".join(faults))


def _check_depth(records: NDArray[np.void], named: Sequence[str], count: int) -> None:
    """Raise CompileError for chains of joints too long for the memory and time of the matrix."""
    if count <= MAX_PRODUCTS:
        return
    depth = [0] * records.size
    for b in range(1, records.size):
        depth[b] = depth[int(records[b]["parent"])] + (1 if records[b]["n"] > 0 else 0)
    last = int(np.argmax(depth))
    raise CompileError(
        f"{named[last - 1]}: is at the end of a chain of {depth[last]} joints, and the matrix has "
        f"{count:.2g} pairs of joints (limit {MAX_PRODUCTS:.2g}); shorten the chain of "
        "joints, or let its bodies move freely (motion: free) and connect them by bushings"
    )


def _ordered(given: Mapping[str, NDArray[np.void]], records: NDArray[np.void]) -> dict[str, NDArray[np.void]]:
    """Checked, non-empty banks sorted by kind; marks bodies whose body-fixed frame S they need."""
    banks = {n: checked(registry.find(n), given[n], records.size) for n in sorted(given)}
    banks = {n: bank for n, bank in banks.items() if bank.size}
    for name, bank in banks.items():
        kind = registry.find(name)
        if kind.body_fixed:
            for end in kind.ends:
                records["fixed_axes"][bank[end]] = 1
    return banks


def _coordinates(
    bodies: Sequence[Body], named: Sequence[str], records: NDArray[np.void]
) -> list[tuple[str, str]]:
    """Names and units of all coordinates, in order."""
    found: dict[int, tuple[str, str]] = {}
    for b, (body, name) in enumerate(zip(bodies, named, strict=True), start=1):
        for k, (coordinate, unit) in enumerate(body.coordinates):
            found[int(records[b]["dof"]) + k] = f"{name}.{coordinate}", unit
    return [found[d] for d in sorted(found)]
