# SPDX-License-Identifier: Apache-2.0
"""All memory of one compiled system: every array is made once, and one address leads to all of them.

Drivers receive that address instead of forty arrays; they make views at their top. A workspace belongs to one
`System` and to one thread at a time. Addresses are per process: a workspace is never stored, only rebuilt.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.multibody.channels import CTL, FRAME, GUIDE
from pitchpoint.multibody.tree import MOTION

# slots of the clock (int64): what a driver counts and remembers between chunks
(
    STEPS,
    EVALUATIONS,
    FACTORISATIONS,
    ITERATIONS,
    VALID,
    BAD_KIND,
    BAD_RECORD,
    REDUNDANT,
    REJECTED,
    RECHARTED,
) = range(10)

#: Rows of the array of stages: 16 stages, two states, 7 coefficients of the dense output.
STAGE_ROWS = 25

#: Programmes of which the mass matrix has its own.
PROGRAMMES = ("proj", "factor", "solve")

#: Private arrays of the drivers: (name, dtype, shape in terms of the sizes). Address and sizes go to MACH.
_ARRAYS: tuple[tuple[str, Any, tuple[str, ...]], ...] = (
    ("J", "f8", ("npath", "6", "6")),  # joint columns
    ("Tq", "f8", ("npath", "6", "6")),  # d twist / dq
    ("Av", "f8", ("npath", "6", "6")),  # d acceleration / dv
    ("Aq", "f8", ("npath", "6", "6")),  # d acceleration / dq
    ("motions", MOTION, ("nb",)),  # displacements of every joint and their columns
    ("guides", GUIDE, ("nguides",)),  # displacements that are functions
    ("charts", "f8", ("ncharts", "3", "3")),  # attitudes from which the turns of tumbling bodies count
    ("T", "f8", ("6", "6")),  # scratch block
    ("y6", "f8", ("6",)),  # scratch column
    ("order6", "i8", ("6",)),  # scratch of the block inversion
    ("Y", "f8", ("nc", "nd")),  # A^-1 G^T, row by row
    ("S", "f8", ("nc", "nc")),  # Schur complement
    ("diag", "f8", ("nc",)),
    ("order", "i8", ("nc",)),
    ("used", "i8", ("nc",)),  # 0 = redundant row
    ("y", "f8", ("nc",)),
    ("z", "f8", ("nc",)),
    ("pull", "f8", ("nc",)),  # right-hand side of the rows of an acceleration
    ("weight", "f8", ("nd",)),  # length per unit of each coordinate in error norms [m/m, m/rad]
    ("relative", "f8", ("nd",)),  # 0 for spins, whose size is unrelated to their error
    ("x", "f8", ("nd",)),  # right-hand side and solution
    ("step", "f8", ("nd",)),  # correction on trial where friction is settled
    ("step_lam", "f8", ("nc",)),  # and that of the multipliers
    ("al", "f8", ("nd",)),  # algorithmic acceleration of the generalised-alpha family
    ("ap", "f8", ("nd",)),  # acceleration of the step before, for the prediction
    ("lp", "f8", ("nc",)),  # multipliers of the step before, for the prediction
    ("stage", "f8", ("stages", "nd2")),  # of the explicit methods
    ("clock", "i8", ("16",)),
    ("real", "f8", ("16",)),  # remembered contraction rate, step size, error of the last step
    ("row", "f8", ("no",)),  # observation of the step
    ("heard", "f8", ("no",)),  # observations that signals read
    ("ev0", "f8", ("ne",)),  # event functions before the step
    ("ev1", "f8", ("ne",)),  # and after it
)

MACH = np.dtype(
    [
        (name, "i8")
        for name in (
            *("body", "path", "path_of", "proj", "factor", "solve", "spins", "body_out", "rows"),
            *("mass_proj", "mass_factor", "mass_solve"),  # of the mass matrix alone
            *("solve_now", "nsolve_now"),  # programme that belongs to the factors at hand
            *("forces", "cons", "guiding", "frictions"),
            *(name for name, _, _ in _ARRAYS),
            *("npath", "nproj", "nfactor", "nsolve", "nspins", "nbody_out", "nforces", "ncons"),
            *("nmass_proj", "nmass_factor", "nmass_solve"),
            *("nguiding", "nfrictions", "ncharts"),
            *("residual", "factor_entry", "solve_entry"),  # addresses of the parts that all drivers share
            *("tree", "tumble"),  # and of those that only trees need, 0 without
            "part",  # which kinds observe, see `residual.ALL`
            "shares",  # 1: some of them may do so where the slope of the state is computed
            "later",  # 1: and some only with the accelerations
            "watch",  # address of `heard` if signals read observations, else 0
            "constant_mass",  # 1: M does not depend on q, and no force on the accelerations
            "settles",  # 1: forces depend on accelerations, see `linear.solve_acceleration`
        )
    ],
    align=True,
)


class Workspace:
    """Arrays of one system, reachable from the integer `at`.

    Parameters
    ----------
    program
        Structure arrays made by the layout: body, path, path_of, proj, factor, solve, spins, body_out, rows;
        mass_proj, mass_factor, mass_solve likewise of the mass matrix alone.
    sizes
        nb, nd, np, na, nc, no, ne.
    tables
        Address tables of the kinds (`link.TABLES`): rows (entry, records, count, channel, early).
    parts
        Addresses of the residual and of the linear algebra (`link.link_parts`).
    weight
        Length per unit of each coordinate in error norms.
    """

    def __init__(
        self,
        program: dict[str, NDArray[Any]],
        sizes: dict[str, int],
        tables: dict[str, NDArray[np.int64]],
        parts: dict[str, int],
        weight: NDArray[np.float64],
    ) -> None:
        nb, nd, nc = sizes["nb"], sizes["nd"], sizes["nc"]
        dims = {**sizes, "npath": program["path"].size, "nd2": 2 * nd, "3": 3, "6": 6, "16": 16}
        body = program["body"]
        dims["nguides"] = int(body["guide"].max()) + 1
        dims["ncharts"] = int(body["chart"].max()) + 1
        dims["stages"] = STAGE_ROWS
        self.ctl = np.zeros(1, CTL)
        self.mach = np.zeros(1, MACH)
        self.fr = np.zeros(nb, FRAME)
        self.q, self.v, self.a, self.R = (np.zeros(nd) for _ in range(4))
        self.kk = np.zeros((sizes["np"], 6, 6))
        self.A = np.zeros((sizes["na"], 6, 6))
        self.g, self.gt, self.gtt, self.lam = (np.zeros(nc) for _ in range(4))
        self.G, self.Gf = np.zeros((nc, nd)), np.zeros((nc, 2, 6))
        self.program = program
        self.tables = tables
        self.arrays = {name: np.zeros([int(dims[d]) for d in shape], dtype) for name, dtype, shape in _ARRAYS}
        self.arrays["weight"][:] = weight
        self.arrays["relative"][:] = 1.0
        self.arrays["relative"][program["spins"][:, 0]] = 0.0
        self.arrays["charts"][:] = np.eye(3)
        self.ready = False  # constant parts of frames and columns written yet?
        self._fill(sizes, parts)

    def _fill(self, sizes: dict[str, int], parts: dict[str, int]) -> None:
        ctl, mach, program = self.ctl[0], self.mach[0], self.program
        for name in ("nb", "nd", "np", "na", "nc", "no", "ne"):
            ctl[name] = sizes[name]
        for name in ("fr", "q", "v", "a", "R", "kk", "A", "g", "G", "Gf", "gt", "gtt", "lam"):
            ctl[name] = getattr(self, name).ctypes.data
        for name, array in {**program, **self.arrays, **self.tables}.items():
            mach[name] = array.ctypes.data
        for name in (*("path", "spins", "body_out"), *PROGRAMMES, *(f"mass_{name}" for name in PROGRAMMES)):
            mach[f"n{name}"] = len(program[name])
        mach["solve_now"], mach["nsolve_now"] = mach["solve"], mach["nsolve"]
        for name, table in self.tables.items():
            mach[f"n{name}"] = len(table)
        mach["ncharts"] = len(self.arrays["charts"])
        ctl["guides"], ctl["ng"] = self.arrays["guides"].ctypes.data, len(self.arrays["guides"])
        for name, where in parts.items():
            mach[name] = where
        early = self.tables["forces"][:, -1] == 1
        mach["shares"] = int(np.any(early) and not len(self.tables["frictions"]))
        mach["later"] = int(not np.all(early) or len(self.tables["cons"]) > 0)
        ctl["mach"] = self.mach.ctypes.data
        ctl["at"] = self.ctl.ctypes.data
        ctl["bad"] = ctl["badkind"] = -1

    @property
    def at(self) -> int:
        """Address of the control record: all a driver needs."""
        return int(self.ctl.ctypes.data)

    @property
    def clock(self) -> NDArray[np.int64]:
        """Counters of the drivers (see the slots above)."""
        return self.arrays["clock"]
