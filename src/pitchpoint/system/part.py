# SPDX-License-Identifier: Apache-2.0
"""Parts of a system whose coordinates are integrated while all others follow a given motion.

A part shares frames, records and coordinates with its system, and has control record, matrix and programmes of its
own: residual, Newton iteration and observation of the package run on the part as on a whole system. Rows and columns of
the matrix of other coordinates are those of the unit matrix, and their corrections are zero.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.kernel import address, kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements import registry
from pitchpoint.multibody.block_lu import FACTOR, INVERT, SCALE, SOLVE, SWEEP, factorise, substitute
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.system.residual import COLUMNS
from pitchpoint.system.system import System
from pitchpoint.system.workspace import FACTORISATIONS, MACH, STAGE_ROWS

_OWN_ARRAYS = {"x": "nd", "shift": "nd", "clock": "16", "real": "16"}
"""Arrays of the drivers that a part does not share with its system."""


@kernel
def factor_entry(at, mass, other):
    """Factor the matrix of a part, with the rows and columns of other coordinates fixed."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    A = view(c["A"], (c["na"], 6, 6), F8)
    fixes = view(m["fixes"], (m["nfixes"], 4), I8)
    for k in range(fixes.shape[0]):
        A[fixes[k, 0], fixes[k, 1], fixes[k, 2]] = 1.0 * fixes[k, 3]
    view(m["clock"], 16, I8)[FACTORISATIONS] += 1
    return factorise(
        view(m["factor"], m["nfactor"], FACTOR), A, view(m["T"], (6, 6), F8), view(m["order6"], 6, I8)
    )


@kernel
def solve_entry(at, spare, other):
    """Solve A x = -R for the coordinates of a part; the other corrections are zero."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    nd = c["nd"]
    x = view(m["x"], nd, F8)
    R = view(c["R"], nd, F8)
    own = view(m["own"], m["nown"], I8)
    shift = view(m["shift"], nd, F8)
    for i in range(nd):
        x[i] = 0.0
    for k in range(own.size):
        x[own[k]] = -R[own[k]] - shift[own[k]]
    substitute(
        view(m["solve"], m["nsolve"], SOLVE), view(c["A"], (c["na"], 6, 6), F8), x, view(m["y6"], 6, F8)
    )
    return OK


class Part:
    """Part of a system with a control record of its own; valid as long as the workspace of the system.

    Parameters
    ----------
    system
        The system; its workspace holds the state of all parts.
    own
        Coordinates of the part.
    bodies
        Evaluate only the bodies up to the last one of these, and the elements at them; None: the whole system.
    """

    def __init__(self, system: System, own: Collection[int], bodies: Collection[int] | None = None) -> None:
        w, sizes = system.workspace, system.sizes
        self.own = np.array(sorted(own), np.int64)
        self.ctl, self.mach = w.ctl.copy(), w.mach.copy()
        self.A = np.zeros_like(w.A)
        self.arrays: dict[str, NDArray[Any]] = {"own": self.own, "fixes": _fixes(system, self.own)}
        self.arrays |= {n: np.zeros(16 if d == "16" else sizes[d]) for n, d in _OWN_ARRAYS.items()}
        self.arrays["clock"] = self.arrays["clock"].astype(np.int64)
        self.arrays["stage"] = np.zeros((STAGE_ROWS, 2 * sizes["nd"]))
        program = {"factor": w.program["factor"], "solve": w.program["solve"]}
        if bodies is not None:
            program = _programmes(system, self.own)
            self._limit(system, bodies)
        mine = np.isin(w.program["spins"][:, 0], self.own)
        self.arrays |= {**program, "spins": np.ascontiguousarray(w.program["spins"][mine])}
        mach, ctl = self.mach[0], self.ctl[0]
        for name, array in self.arrays.items():
            mach[name] = array.ctypes.data
        for name in ("own", "fixes", "factor", "solve", "spins", *(("proj", "forces") if bodies else ())):
            mach[f"n{name}"] = len(self.arrays[name])
        mach["solve_now"], mach["nsolve_now"] = mach["solve"], mach["nsolve"]
        mach["factor_entry"], mach["solve_entry"] = address(factor_entry), address(solve_entry)
        ctl["A"], ctl["mach"], ctl["at"] = self.A.ctypes.data, self.mach.ctypes.data, self.ctl.ctypes.data

    def _limit(self, system: System, bodies: Collection[int]) -> None:
        """Restrict the evaluation to elements at the bodies, and to all bodies up to the last one of their ends."""
        w = system.workspace
        rows, ends = [], set(bodies)
        for row in w.tables["forces"]:
            name = next(n for n, bank in system.records.items() if bank.ctypes.data == row[1])
            bank, kind = system.records[name], registry.find(name)
            touched = np.zeros(bank.size, bool)
            for end in kind.ends:
                touched |= np.isin(bank[end], list(bodies))
            if kind.role == "signal":
                touched &= np.isin(bank["op"], (30, 31, 32))
            for end in kind.ends:
                ends |= {int(b) for b in bank[end][touched]}
            rows += [
                (row[0], row[1] + first * bank.itemsize, count, *row[3:]) for first, count in _runs(touched)
            ]
        last = max(ends) + 1
        body, path = w.program["body"], w.program["path"]
        self.ctl[0]["nb"] = last
        self.mach[0]["npath"] = int(body["first"][:last].max() + 0 if False else (body["first"] + body["count"])[:last].max())
        proj = w.program["proj"]
        here = np.isin(path["body"][proj["pi"]], np.arange(last)) & np.isin(path["body"][proj["pj"]], np.arange(last))
        self.arrays["proj"] = np.ascontiguousarray(proj[here])
        self.arrays["forces"] = np.array(rows, np.int64).reshape(-1, COLUMNS)

    @property
    def at(self) -> int:
        """Address of the control record."""
        return int(self.ctl.ctypes.data)


def _runs(chosen: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First index and length of each run of true values."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], chosen, [False]]).astype(int)))
    return [(int(a), int(b - a)) for a, b in edges.reshape(-1, 2)]


def _nodes(system: System) -> NDArray[np.int64]:
    """Node of every coordinate."""
    layout = system.layout
    return np.repeat(np.arange(len(layout.node_size)), layout.node_size)


def _fixes(system: System, own: NDArray[np.int64]) -> NDArray[np.int64]:
    """Matrix entries (block, row, column, value) of all other coordinates in the nodes of a part."""
    rows, columns, places = system.layout.entries
    mine = np.zeros(system.sizes["nd"], bool)
    mine[own] = True
    other = ~(mine[rows] & mine[columns])
    value = (rows == columns) & other
    where = np.stack([places // 36, places % 36 // 6, places % 6, value], axis=1)
    return np.ascontiguousarray(where[other], np.int64)


def _programmes(system: System, own: NDArray[np.int64]) -> dict[str, NDArray[np.void]]:
    """Rows of the factor and solve programmes whose nodes all have coordinates of the part."""
    nodes = set(_nodes(system)[own].tolist())
    ends = {block: pair for pair, block in system.layout.blocks.items()}
    inside = lambda block: set(ends[int(block)]) <= nodes  # noqa: E731
    factor, solve = system.workspace.program["factor"], system.workspace.program["solve"]
    used = {INVERT: ("a",), SCALE: ("a", "b")}
    kept = [all(inside(row[n]) for n in used.get(int(row["op"]), ("a", "b", "c"))) for row in factor]
    found = [inside(row["blk"]) for row in solve]
    return {"factor": np.ascontiguousarray(factor[kept]), "solve": np.ascontiguousarray(solve[found])}
