# SPDX-License-Identifier: Apache-2.0
"""Part of a system whose coordinates are integrated while all others follow a given motion.

A part shares frames, records and coordinates with its system, and has a control record, matrix and programmes
of its own: the residual, Newton iteration and observation of the package run on a part as on a whole system.
Rows and columns of other coordinates in its matrix are those of the unit matrix.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.kernel import address, invoke, kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements import registry
from pitchpoint.elements.kind import EVERYWHERE, SIGNAL
from pitchpoint.elements.signals.record import FORCE, STRUT, TORQUE
from pitchpoint.multibody.block_lu import FACTOR, INVERT, SCALE, SOLVE, factorise, substitute
from pitchpoint.multibody.channels import CTL, F8, I8
from pitchpoint.system import evaluate, residual
from pitchpoint.system.residual import COLUMNS, NEWTON
from pitchpoint.system.system import System
from pitchpoint.system.workspace import FACTORISATIONS, MACH, STAGE_ROWS, VALID

LISTS = ("own", "fixes", "chosen", "factor", "solve", "spins", "proj", "forces", "driven", "body_out")
"""Arrays of a part whose lengths the drivers read."""


@kernel
def factor_entry(at, mass, other):
    """Factor the matrix of a part."""
    c = view(at, 1, CTL)[0]
    m = view(c["mach"], 1, MACH)[0]
    A = view(c["A"], (c["na"], 6, 6), F8)
    fixes = view(m["fixes"], (m["nfixes"], 4), I8)
    for k in range(fixes.shape[0]):
        A[fixes[k, 0], fixes[k, 1], fixes[k, 2]] = 1.0 * fixes[k, 3]
    view(m["clock"], 16, I8)[FACTORISATIONS] += 1
    programme = view(m["factor"], m["nfactor"], FACTOR)
    return factorise(programme, A, view(m["T"], (6, 6), F8), view(m["order6"], 6, I8))


@kernel
def solve_entry(at, spare, other):
    """Solve A x = -(R + shift) for the coordinates of a part; the corrections of all others are zero."""
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
    programme = view(m["solve"], m["nsolve"], SOLVE)
    substitute(programme, view(c["A"], (c["na"], 6, 6), F8), x, view(m["y6"], 6, F8))
    return OK


class Part:
    """Part of a system; valid as long as the workspace of the system.

    Parameters
    ----------
    system
        The system, without constraint rows. Its workspace contains the state of all parts.
    own
        Coordinates of the part.
    bodies
        Bodies whose elements are evaluated, with all bodies up to the last one at their ends; None: all.

    Attributes
    ----------
    at
        Address of the control record of the part.
    own
        Coordinates of the part.
    loaded
        Coordinates of all bodies at the ends of its elements and of those that carry them.
    arrays
        Arrays that it does not share with the system, by their names in `workspace.MACH`.
    """

    def __init__(self, system: System, own: Collection[int], bodies: Collection[int] | None = None) -> None:
        w, nd = system.workspace, system.sizes["nd"]
        self.system, self._factor = system, factor_entry
        self.own = self.loaded = np.array(sorted(own), np.int64)
        self._ctl, self._mach, self._A = w.ctl.copy(), w.mach.copy(), np.zeros_like(w.A)
        self.arrays: dict[str, NDArray[Any]] = {
            "own": self.own,
            "fixes": _fixes(system, self.own),
            "chosen": np.arange(system.sizes["no"]),
            "x": np.zeros(nd),
            "shift": np.zeros(nd),
            "real": np.zeros(16),
            "clock": np.zeros(16, np.int64),
            "stage": np.zeros((STAGE_ROWS, 2 * nd)),
            "spins": w.program["spins"][np.isin(w.program["spins"][:, 0], self.own)],
        }
        self.arrays["real"][0] = 0.1  # contraction rate of a new matrix
        if bodies is not None:
            self.arrays |= _programmes(system, self.own)
            self._limit(set(bodies))
        ctl, mach = self._ctl[0], self._mach[0]
        for name, array in self.arrays.items():
            mach[name] = array.ctypes.data
        for name in LISTS:
            if name in self.arrays:
                mach[f"n{name}"] = len(self.arrays[name])
        mach["solve_now"], mach["nsolve_now"] = mach["solve"], mach["nsolve"]
        mach["factor_entry"], mach["solve_entry"] = address(factor_entry), address(solve_entry)
        if bodies is not None:
            mach["tumble"] = 0  # charts change when all coordinates are those of the same time
        ctl["A"], ctl["mach"] = self._A.ctypes.data, self._mach.ctypes.data
        ctl["at"] = self.at = int(self._ctl.ctypes.data)

    def attach(self, shared: dict[str, NDArray[Any]], solve: Any, factor: Any = factor_entry) -> None:
        """Use arrays that both parts share, and entries with coupling to the other part."""
        mach = self._mach[0]
        for name, array in shared.items():
            self.arrays[name] = array
            mach[name] = array.ctypes.data
        mach["nedge"], self._factor = len(shared["edge"]), factor
        mach["solve_entry"], mach["factor_entry"] = address(solve), address(factor)

    def run(self, kernel_entry: Any, t: float) -> int:
        """Call an entry with the part at the state in the workspace and time t; returns its status."""
        self._ctl[0]["t"] = t
        return invoke(kernel_entry, self.at, 0, 0)

    def refactor(self, t: float, cm: float, cd: float) -> int:
        """Compute and factor the iteration matrix of the part at the state in the workspace; its status."""
        ctl = self._ctl[0]
        ctl["t"], ctl["cm"], ctl["cd"], ctl["ck"] = t, cm, cd, 1.0
        status = invoke(residual.entry, self.at, NEWTON, 0)
        if status == OK:
            status = invoke(self._factor, self.at, 0, 0)
        self.arrays["clock"][VALID] = 0
        return status

    def run_events(self, t: float, values: NDArray[np.float64]) -> None:
        """Write the event functions that the part evaluates at the state in the workspace, shape (ne,)."""
        ctl = self._ctl[0]
        ctl["t"], ctl["ev"] = t, values.ctypes.data
        status = invoke(residual.entry, self.at, residual.FORCES, 0)
        ctl["ev"] = 0
        evaluate.check(self.system, status)

    def _limit(self, bodies: set[int]) -> None:
        """Evaluate elements and inertia of the bodies only, and all bodies up to the last at their ends."""
        w, system = self.system.workspace, self.system
        rows, ends, seen, driven = [], set(bodies), [], set()
        for row in w.tables["forces"]:
            name = next(n for n, bank in system.records.items() if bank.ctypes.data == row[1])
            bank, kind = system.records[name], registry.find(name)
            if kind.scope == EVERYWHERE:
                continue
            touched = np.zeros(bank.size, bool)
            for end in kind.ends:
                touched |= np.isin(bank[end], list(bodies))
            if kind.role == SIGNAL:  # signals have the values of the whole system
                touched &= np.isin(bank["op"], (TORQUE, STRUT, FORCE))
                driven |= {int(b["pool"]) + 8 * int(b["a"]) for b in bank[touched]}
            for end in kind.ends:
                ends |= {int(b) for b in bank[end][touched]}
            rows += [(row[0], row[1] + first * bank.itemsize, n, *row[3:]) for first, n in _runs(touched)]
            if "out" in (bank.dtype.names or ()):
                seen += [int(b["out"]) + k for b in bank[touched] for k in range(len(kind.outputs_of(b)))]
        path, proj = w.program["path"], w.program["proj"]
        last = max(ends) + 1
        joints = path[np.isin(path["body"], list(ends))]
        self.loaded = np.unique([d + k for d, n in joints[["dof", "n"]] for k in range(n)]).astype(np.int64)
        inside = path["body"] < last
        self._ctl[0]["nb"], self._mach[0]["npath"] = last, int(inside.sum())
        table = w.program["body_out"]
        own = np.isin(table[:, 1], list(bodies)) & (table[:, 0] < 3)
        self.arrays["chosen"] = np.array(sorted({*seen, *table[own, 3].tolist()}), np.int64)
        self.arrays["body_out"] = table[own]
        self.arrays["proj"] = proj[inside[proj["pi"]] & inside[proj["pj"]]]
        self.arrays["driven"] = np.array(sorted(driven), np.int64)
        self.arrays["demand"] = np.zeros((2, len(driven) + 1))
        self.arrays["body"] = _massless(w.program["body"], bodies)
        self.arrays["forces"] = np.array(rows, np.int64).reshape(-1, COLUMNS)

    def matrix(self, t: float, cm: float, cd: float, ck: float) -> NDArray[np.float64]:
        """Newton matrix cm M + cd D + ck K of the part at the state in the workspace, shape (nd, nd)."""
        ctl = self._ctl[0]
        ctl["t"], ctl["cm"], ctl["cd"], ctl["ck"] = t, cm, cd, ck
        evaluate.check(self.system, invoke(residual.entry, self.at, NEWTON, 0))
        found = self._A.copy()
        found[0] = 0.0
        return evaluate.dense(self.system, found)


def _massless(table: NDArray[np.void], bodies: set[int]) -> NDArray[np.void]:
    """Bodies without inertia, except the given ones and those fixed to them."""
    found, heavy = table.copy(), set(bodies)
    for b in range(1, table.size):
        if {int(table[b]["parent"]), int(table[b]["spinner"])} & heavy:
            heavy.add(b)
        if b not in heavy:
            for name in ("mass", "i_p", "i_t", "inertia"):
                found[b][name] = 0.0
    return found


def _runs(chosen: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First index and length of each run of true values.

    Examples
    --------
    >>> _runs(np.array([True, True, False, True]))
    [(0, 2), (3, 1)]
    """
    edges = np.flatnonzero(np.diff(np.concatenate([[False], chosen, [False]]).astype(int)))
    return [(int(a), int(b - a)) for a, b in edges.reshape(-1, 2)]


def _fixes(system: System, own: NDArray[np.int64]) -> NDArray[np.int64]:
    """Matrix entries (block, row, column, value) in the rows and columns of all other coordinates."""
    rows, columns, places = system.layout.entries
    mine = np.zeros(system.sizes["nd"], bool)
    mine[own] = True
    other = ~(mine[rows] & mine[columns])
    places = places[other]
    unit = (rows == columns)[other]
    return np.stack([places // 36, places % 36 // 6, places % 6, unit], axis=1).astype(np.int64)


def _programmes(system: System, own: NDArray[np.int64]) -> dict[str, NDArray[np.void]]:
    """Rows of the factor and solve programmes between nodes with coordinates of the part.

    The nodes are eliminated in the same order, so that no further blocks are filled.
    """
    layout = system.layout
    node = np.repeat(np.arange(len(layout.node_size)), layout.node_size)
    nodes = set(node[own].tolist())
    inside = {block for pair, block in layout.blocks.items() if set(pair) <= nodes}
    used = {INVERT: ("a",), SCALE: ("a", "b")}
    factor, solve = (system.workspace.program[name] for name in ("factor", "solve"))
    kept = [all(int(r[n]) in inside for n in used.get(int(r["op"]), ("a", "b", "c"))) for r in factor]
    return {"factor": factor[kept], "solve": solve[[int(r["blk"]) in inside for r in solve]]}
