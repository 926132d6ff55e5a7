# SPDX-License-Identifier: Apache-2.0
"""Weight of a body at its centre of mass.

One record per body, from `gravity_records`. A body with its centre of mass on the spin axis does not need its
spin angle; the centre of mass of any other body rotates with it.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.kernel import kernel, view
from pitchpoint.core.status import OK
from pitchpoint.elements.kind import FRAME, SINGLE, WEIGHT, Kind
from pitchpoint.elements.wrench import push, put, spin_axis
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.channels import frame_args
from pitchpoint.multibody.vectors import cross, into_world, times, triple, unit

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("weight", "f8", 3),  # mass times acceleration of gravity, world axes [N]
        ("com", "f8", 3),  # centre of mass from the origin, axes of the body [m]
        ("round", "i8"),  # 1: centre of mass on the spin axis
        ("out", "i8"),
    ],
    align=True,
)


def gravity_records(bodies: Sequence[Body], acceleration: ArrayLike) -> NDArray[np.void]:
    """Weight records of all bodies that have a mass.

    Parameters
    ----------
    bodies
        Bodies without ground, in the order of the system.
    acceleration
        Acceleration of gravity in world axes, shape (3,) [m/s^2].

    Returns
    -------
    ndarray of RECORD, one per body with a mass

    Examples
    --------
    >>> bodies = [Body(mass=2.0, polar_inertia=1.0), Body(polar_inertia=1.0)]
    >>> records = gravity_records(bodies, (0.0, 0.0, -9.81))
    >>> records["i"], records["weight"]
    (array([1]), array([[  0.  ,   0.  , -19.62]]))
    """
    heavy = [(k, body) for k, body in enumerate(bodies, start=1) if body.mass > 0.0]
    records = np.zeros(len(heavy), RECORD)
    for record, (k, body) in zip(records, heavy, strict=True):
        record["i"], record["com"] = k, body.center_of_mass()
        record["weight"] = body.mass * np.asarray(acceleration, float)
        record["round"] = not np.any(record["com"][:2])
    return records


@kernel
def gravity(rec, ctl, fr, kk):
    """Weights and their tangents."""
    c = ctl[0]
    for e in range(rec.size):
        b = rec[e]
        f = fr[b["i"]]
        weight = triple(b["weight"], 0)
        arm = times(b["com"][2], spin_axis(f)) if b["round"] != 0 else into_world(f["S"], triple(b["com"], 0))
        nothing = (0.0, 0.0, 0.0)
        push(f, arm, weight, nothing, 1.0)
        if c["jac"] != 0:
            for k in range(3):
                put(kk[b["ii"]], 3 + k, -c["ck"], nothing, cross(cross(unit(k), arm), weight))
    return OK


@kernel
def entry(ctl, rec, n):
    """Entry point of the kind."""
    c, fr, kk = frame_args(ctl)
    return gravity(view(rec, n, RECORD), c, fr, kk)


KIND = Kind(
    name="gravity",
    channel=FRAME,
    record=RECORD,
    entry=entry,
    scope=SINGLE,
    massless=True,
    resists=WEIGHT,
    linear=True,
    excites=False,
    names_modes=False,
)
