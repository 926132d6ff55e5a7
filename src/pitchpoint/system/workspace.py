# SPDX-License-Identifier: Apache-2.0
"""Memory of one compiled system: all arrays are allocated once and accessible from a single address.

Drivers receive this address instead of forty arrays and create views. A workspace is used by one `System`
and one thread at a time. Addresses are valid only in their process, so a workspace is never stored but
rebuilt.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.multibody.channels import CTL, FRAME, GUIDE
from pitchpoint.multibody.tree import MOTION

# slots of the clock (int64): counters and flags that drivers keep between chunks
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

#: Rows of the stage array: 16 stages, two states, 7 coefficients of the dense output.
STAGE_ROWS = 25

#: Rows of the values at the interface of two parts, see `solvers.implicit.interface`.
EXCHANGE_ROWS = 18

#: Programmes with a separate version for the mass matrix.
PROGRAMMES = ("proj", "factor", "solve")

#: Private arrays of the drivers: (name, dtype, shape in terms of the sizes). Address and sizes go to MACH.
_ARRAYS: tuple[tuple[str, Any, tuple[str, ...]], ...] = (
    ("J", "f8", ("npath", "6", "6")),  # joint columns
    ("Tq", "f8", ("npath", "6", "6")),  # d twist / dq
    ("Av", "f8", ("npath", "6", "6")),  # d acceleration / dv
    ("Aq", "f8", ("npath", "6", "6")),  # d acceleration / dq
    ("motions", MOTION, ("nb",)),  # displacements of each joint and their columns
    ("guides", GUIDE, ("nguides",)),  # displacements of guided joints
    ("charts", "f8", ("ncharts", "3", "3")),  # reference attitudes of tumbling bodies
    ("T", "f8", ("6", "6")),  # scratch block
    ("y6", "f8", ("6",)),  # scratch column
    ("order6", "i8", ("6",)),  # scratch of the block inversion
    ("Y", "f8", ("nc", "nd")),  # A^-1 G^T, one row per constraint
    ("S", "f8", ("nc", "nc")),  # Schur complement
    ("diag", "f8", ("nc",)),
    ("order", "i8", ("nc",)),
    ("used", "i8", ("nc",)),  # 0 = redundant row
    ("y", "f8", ("nc",)),
    ("z", "f8", ("nc",)),
    ("pull", "f8", ("nc",)),  # right-hand side of the acceleration constraints
    ("weight", "f8", ("nd",)),  # length per unit of each coordinate in error norms [m/m, m/rad]
    ("relative", "f8", ("nd",)),  # 0 for spins, whose size is unrelated to their error
    ("x", "f8", ("nd",)),  # right-hand side and solution
    ("step", "f8", ("nd",)),  # scaled trial correction in the friction iteration
    ("step_lam", "f8", ("nc",)),  # scaled trial correction of the multipliers
    ("al", "f8", ("nd",)),  # algorithmic acceleration of the generalised-alpha family
    ("ap", "f8", ("nd",)),  # acceleration of the previous step, for the predictor
    ("lp", "f8", ("nc",)),  # multipliers of the previous step, for the predictor
    ("stage", "f8", ("stages", "nd2")),  # stages of the explicit methods
    ("clock", "i8", ("16",)),
    ("real", "f8", ("16",)),  # contraction rate, step size, error of the last step
    ("row", "f8", ("no",)),  # observation of the step
    ("heard", "f8", ("no",)),  # observations that signals read
    ("ev0", "f8", ("ne",)),  # event functions before the step
    ("ev1", "f8", ("ne",)),  # event functions after the step
)

MACH = np.dtype(
    [
        (name, "i8")
        for name in (
            *("body", "path", "path_of", "proj", "factor", "solve", "spins", "body_out", "rows"),
            *("mass_proj", "mass_factor", "mass_solve"),  # of the mass matrix
            *("solve_now", "nsolve_now"),  # programme of the current factors
            *("forces", "cons", "guiding", "frictions"),
            *(name for name, _, _ in _ARRAYS),
            *("npath", "nproj", "nfactor", "nsolve", "nspins", "nbody_out", "nforces", "ncons"),
            *("nmass_proj", "nmass_factor", "nmass_solve"),
            *("nguiding", "nfrictions", "ncharts"),
            *("residual", "factor_entry", "solve_entry"),  # addresses of the core kernels of all drivers
            *("tree", "tumble"),  # addresses of the core kernels of trees, 0 if not used
            "part",  # kinds that observe, see `residual.ALL`
            "shares",  # 1: some kinds can be observed before the accelerations are known
            "later",  # 1: some kinds can be observed only with the accelerations
            "watch",  # address of `heard` if signals read observations, else 0
            "constant_mass",  # 1: M is independent of q, and forces are independent of accelerations
            "settles",  # 1: forces depend on accelerations, see `linear.solve_acceleration`
            *(
                "own",
                "nown",
                "fixes",
                "nfixes",
                "chosen",
                "nchosen",
                "shift",
                *("edge", "nedge", "transfer", "exchange", "places"),
                *("driven", "ndriven", "demand"),
            ),  # of a part of the coordinates, see `system.part`
        )
    ],
    align=True,
)


class Workspace:
    """Arrays of one system, accessible from the address `at`.

    Parameters
    ----------
    program
        Structure arrays of the layout: body, path, path_of, proj, factor, solve, spins, body_out, rows; and
        mass_proj, mass_factor, mass_solve for the mass matrix.
    sizes
        Sizes nb, nd, np, na, nc, no, ne (see `CTL`).
    tables
        Address tables of the kinds (`link.TABLES`) with rows (entry, records, count, channel, early).
    parts
        Addresses of the core kernels (`link.link_parts`).
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
        self.ready = False  # whether constant parts of frames and columns are written
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
        """Address of the control record, the only argument of a driver."""
        return int(self.ctl.ctypes.data)

    @property
    def clock(self) -> NDArray[np.int64]:
        """Counters and flags of the drivers, by slots such as `STEPS`."""
        return self.arrays["clock"]
