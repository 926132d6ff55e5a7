# SPDX-License-Identifier: Apache-2.0
"""Inertia and stiffness of an elastic body in its floating frame (docs/decisions/0015-floating-frame.md).

Body i is the floating frame. Its modal coordinates eta are the displacements of massless bodies on ground
that only translate, three coordinates each: j, k, l, m and so on. Their wrenches are the modal forces. With
the integrals of `multibody/mass_invariants.py`, in the axes of the frame, with a its acceleration less
gravity:

    s = s0 + P eta,  J = J0 + sum eta_k (J1_k + sum eta_l J2_kl),  C = C0 + sum eta_k A_k,
    F   = -(m a + alpha x s + omega x (omega x s) + 2 omega x P eta' + P eta'')
    M   = -(s x a + J alpha + omega x J omega + J' omega + C eta'' + omega x C eta')
    Q_k = -(P_k . a + C_k . alpha + m_kl eta_l'' + 2 eta_l' A_l,k . omega - 1/2 omega . dJ/deta_k omega
            + (K + K_g)_kl eta_l + D_kl eta_l')

K_g is the geometric stiffness from the inertia loads: a sum over the components of a and the products of the
components of omega. Its reactions on the frame are of second order in eta and neglected.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import CompileError
from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements import guide
from pitchpoint.elements.floating_frame import coordinates, loads, shares, tangent
from pitchpoint.elements.kind import FRAME, FREE, MODAL, WITH_MODES, Kind
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.channels import frame_args, observations
from pitchpoint.multibody.joints import GUIDED
from pitchpoint.multibody.mass_invariants import MassInvariants

MAX_MODES = 30
"""Maximum number of modal coordinates of one body."""
GROUP = 3
"""Modal coordinates per hidden body."""
LOADS = 9
"""Loads with geometric stiffness: a_x, a_y, a_z, then the products of omega: xx, yy, zz, xy, yz, zx."""

_PAIR = ["i", "j", "ii", "ij", "ji", "jj"]

RECORD = np.dtype(
    [(n, "i8") for n in (*_PAIR, *MODAL[2:])]
    + [
        ("pairs", "i8", (len(MODAL), len(MODAL))),
        ("n", "i8"),  # modal coordinates
        ("mass", "f8"),  # [kg]
        ("first", "f8", 3),  # s0 [kg m]
        ("inertia", "f8", (3, 3)),  # J0 [kg m^2]
        ("gravity", "f8", 3),  # world axes [m/s^2]
        ("P", "f8", (3, MAX_MODES)),
        ("C0", "f8", (3, MAX_MODES)),
        ("A", "f8", (MAX_MODES, 3, MAX_MODES)),
        ("J1", "f8", (MAX_MODES, 3, 3)),
        ("J2", "f8", (MAX_MODES, MAX_MODES, 3, 3)),
        ("modal", "f8", (MAX_MODES, MAX_MODES)),
        ("K", "f8", (MAX_MODES, MAX_MODES)),
        ("D", "f8", (MAX_MODES, MAX_MODES)),
        ("geo", "f8", (LOADS, MAX_MODES, MAX_MODES)),
        # scratch: written and read within one call
        ("eta", "f8", (3, MAX_MODES)),  # coordinates, first and second time derivatives
        ("d_eta", "f8", (3, MAX_MODES)),
        ("x", "f8", (3, 3)),  # a, alpha, omega in the axes of the frame
        ("d_x", "f8", (3, 3)),
        ("s", "f8", (3, 3)),  # s and its two time derivatives relative to the frame
        ("J", "f8", (3, 3)),
        ("dJ", "f8", (3, 3)),  # time derivative of J
        ("Jk", "f8", (MAX_MODES, 3, 3)),
        ("C", "f8", (3, MAX_MODES)),
        ("Kg", "f8", (MAX_MODES, MAX_MODES)),
        ("F", "f8", 6),  # wrench in the axes of the frame
        ("Q", "f8", MAX_MODES),
        ("dF", "f8", 6),
        ("dQ", "f8", MAX_MODES),
        ("out", "i8"),
    ],
    align=True,
)

OUTPUTS = (("strain_energy", "J", "strain energy of the modal coordinates"),)


def flexible_row(
    integrals: MassInvariants,
    stiffness: ArrayLike,
    *,
    frame: int,
    hidden: tuple[int, ...],
    damping: ArrayLike | None = None,
    stiffening: ArrayLike | None = None,
    gravity: ArrayLike = (0.0, 0.0, 0.0),
) -> NDArray[np.void]:
    """Record of one elastic body, shape (1,).

    Parameters
    ----------
    integrals
        Mass integrals about the origin of the frame, in its axes.
    stiffness
        Modal stiffness, (n, n) or the diagonal (n,).
    frame
        Number of the body that is the floating frame; it is massless.
    hidden
        Numbers of the hidden bodies of the modal coordinates, three each, see `modal_bodies`.
    damping
        Modal damping, shape as `stiffness`.
    stiffening
        Geometric stiffness per unit of each of the nine loads, (9, n, n), see `LOADS`.
    gravity
        Gravitational acceleration in world axes [m/s^2].
    """
    n = integrals.modal.shape[0]
    if not 0 < n <= MAX_MODES or len(hidden) != -(-n // GROUP):
        raise CompileError(
            f"{n} modal coordinates on {len(hidden)} bodies (limit 1 to {MAX_MODES}, three on each)"
        )
    row = np.zeros(1, RECORD)
    r = row[0]
    r["i"], r["n"], r["mass"], r["first"] = frame, n, integrals.mass, integrals.first
    for name, number in zip(MODAL[1:], hidden, strict=False):
        r[name] = number
    r["inertia"], r["gravity"] = integrals.inertia, gravity
    r["P"][:, :n], r["C0"][:, :n] = integrals.momentum, integrals.angular
    # A is antisymmetric in the two modes for mass points; the contribution of rotary inertia is neglected
    r["A"][:n, :, :n] = 0.5 * (integrals.angular_1 - integrals.angular_1.transpose(2, 1, 0))
    r["J1"][:n] = integrals.inertia_1
    r["J2"][:n, :n] = 0.5 * (integrals.inertia_2 + integrals.inertia_2.transpose(1, 0, 2, 3))
    r["modal"][:n, :n] = integrals.modal
    for name, given in (("K", stiffness), ("D", damping)):
        if given is not None:
            matrix = np.asarray(given, float)
            r[name][:n, :n] = np.diag(matrix) if matrix.ndim == 1 else matrix
    if stiffening is not None:
        r["geo"][:, :n, :n] = stiffening
    return row


def modal_bodies(
    name: str, n: int, first: int, words: Sequence[str] | None = None
) -> tuple[list[Body], NDArray[np.void]]:
    """Hidden bodies for n modal coordinates, three each, and the guide records that move them.

    Parameters
    ----------
    name
        Name of the elastic body; the hidden bodies are named ``NAME.1`` and so on, the coordinates eta1 ...
    n
        Number of modal coordinates.
    first
        Number of the first hidden body in the records.
    words
        Names of the coordinates instead of eta1 ...

    Returns
    -------
    list of Body, records of the kind guide
    """
    known = words or [f"eta{k + 1}" for k in range(n)]
    bodies, rows = [], []
    for g in range(-(-n // GROUP)):
        mine = range(GROUP * g, min(GROUP * (g + 1), n))
        own = tuple((known[k], "m") for k in mine)
        bodies.append(Body(motion=GUIDED, guided_by=own, name=f"{name}.{g + 1}"))
        for m in range(len(mine)):
            row = np.zeros(1, guide.RECORD)
            row["i"], row["m"], row["k"], row["slope"] = first + g, m, m, 1.0
            row["first"] = m == 0
            rows.append(row)
    return bodies, np.concatenate(rows)


def interface_bodies(
    name: str,
    shape: ArrayLike,
    *,
    place: ArrayLike,
    axes: ArrayLike,
    frame: int,
    hidden: tuple[int, ...],
    first: int,
) -> tuple[list[Body], NDArray[np.void]]:
    """Massless bodies that follow one node of an elastic body, for joints and forces.

    The last body of the chain has the pose of the deflected node; in groups of three modal coordinates, first
    the displacements are added, then the small rotations are applied in sequence.

    Parameters
    ----------
    name
        Name of the last body; the others are named ``NAME.1`` and so on.
    shape
        Displacement and rotation of the node per modal coordinate in the axes of the frame, (6, n).
    place, axes
        Position of the node and axes of the floating frame in world axes, with all coordinates zero.
    frame, hidden
        Numbers of the floating frame and of the bodies of `modal_bodies`.
    first
        Number of the first body of the chain in the records.

    Returns
    -------
    list of Body, records of the kind guide
    """
    phi = np.asarray(shape, float)
    groups = len(hidden)
    # displacements of groups 1 to G-1, then displacements and rotations of G, then rotations of the others:
    # the position is the sum of all displacements and independent of the rotations
    steps = [(g, range(3)) for g in range(groups - 1)]
    steps += [(groups - 1, range(6)), *((g, range(3, 6)) for g in range(groups - 1))]
    bodies, rows = [], []
    for step, (g, directions) in enumerate(steps):
        bodies.append(
            Body(
                motion=GUIDED,
                parent=first + step - 1 if step else frame,
                position=place,
                axes=axes,
                shares=hidden[g],
                name=name if step == len(steps) - 1 else f"{name}.{step + 1}",
            )
        )
        mine = range(GROUP * g, min(GROUP * (g + 1), phi.shape[1]))
        for k in mine:
            for m in directions:
                row = np.zeros(1, guide.RECORD)
                row["i"], row["m"], row["k"], row["slope"] = first + step, m, k - GROUP * g, phi[m, k]
                row["first"] = k == mine[0] and m == directions[0]
                rows.append(row)
    return bodies, np.concatenate(rows)


def interface_count(modes: int) -> int:
    """Number of bodies that `interface_bodies` creates for one node of a body with `modes` modes."""
    return 2 * -(-modes // GROUP) - 1


@kernel
def flexible_body(rec, ctl, fr, kk):
    """Forces, tangents and observations of all elastic bodies."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        coordinates(b, fr)
        loads(b, f)
        shares(b, f, fr)
        if c["jac"] != 0:
            tangent(b, f["S"], kk, c["cm"], c["cd"], c["ck"])
        elif c["cm"] != 0.0:
            tangent(b, f["S"], kk, c["cm"], 0.0, 0.0)
        if c["out"] != 0:
            energy = 0.0
            for k in range(b["n"]):
                for h in range(b["n"]):
                    energy += 0.5 * b["eta"][0, k] * b["K"][k, h] * b["eta"][0, h]
            observations(ctl)[b["out"]] = energy
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return flexible_body(view(rec, n, RECORD), c, fr, kk)


def label(record: np.void) -> str:
    """Word before the name: the rim of a gear has no mass of its own."""
    return "flexible body" if record["mass"] > 0.0 else "bending"


KIND = Kind(
    name="flexible_body",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    outputs=OUTPUTS,
    pairs=WITH_MODES,
    paired=MODAL,
    modal=MODAL[1:],
    body_fixed=True,
    spins=FREE,
    fine=True,
    excites=False,
    sections={"elastic_bodies": "", "gears": ""},
    label=label,
)
