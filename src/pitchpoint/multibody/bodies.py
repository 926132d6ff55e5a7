# SPDX-License-Identifier: Apache-2.0
"""The body record: where a body hangs, how it may move, what it weighs.

Every body hangs on its parent, another body or ground, by one joint at its origin; parents come before their
children. A body has a *frame* R whose third axis is its spin axis and which does not spin; the spin is an
angle next to it, and S is R turned by that angle, the frame that is fixed to the body. Bodies on ground whose
mass is round about the spin axis ("round" bodies: gears, shafts) never need S: their inertia is constant in
R and no sine of the spin is taken.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.multibody.joints import (
    AXES,
    FIXED,
    FREE,
    GUIDED,
    JOINTS,
    PLANAR,
    ROUND,
    SCREW,
    TORSION,
    TUMBLING,
)

__all__ = ["BODY", "FIXED", "FREE", "GENERAL", "PATH", "PLANAR", "TORSION", "Body", "body_records"]

GENERAL = 7
"""Code of every joint that is not that of a round body."""

BODY = np.dtype(
    [
        ("joint", "i8"),  # FIXED, TORSION, PLANAR, FREE of a round body, else GENERAL
        ("n", "i8"),  # number of coordinates
        ("parent", "i8"),  # body it hangs on, 0 = ground
        ("dof", "i8"),  # index of its first coordinate
        ("spin", "i8"),  # index of its spin coordinate, -1 if it has none
        ("path", "i8"),  # its own entry in the list of paths, -1 without coordinates
        ("first", "i8"),  # first entry of its path from ground
        ("count", "i8"),  # entries of its path
        ("ii", "i8"),  # its diagonal pair block, 0 = dump
        ("axis", "i8", 6),  # displacements that are its coordinates
        ("chart", "i8"),  # attitude from which its turns count, -1 for none
        ("guide", "i8"),  # displacements given by functions, -1 for none
        ("shares", "i8"),  # body whose coordinates are its own too, 0 for none
        ("spinner", "i8"),  # body whose spin counts as its own, 0 for none
        ("upright", "f8", (3, 3)),  # frame from which that counts, columns in axes S of the spinner's parent
        ("fixed_axes", "i8"),  # 1: S is requested
        ("state", "i8"),  # 1: no body, its spin rate is the state of an element
        ("lead", "f8"),  # screw: way along the axis per radian [m/rad]
        ("sense", "f8"),  # spin axis against that of the parent: 1 parallel, -1 opposite, 0 neither
        ("pos", "f8", 3),  # reference position of the origin, axes S of the parent [m]
        ("axes", "f8", (3, 3)),  # reference frame, columns in axes S of the parent; third = spin axis
        ("mass", "f8"),  # [kg]
        ("i_p", "f8"),  # round: inertia about the spin axis [kg m^2]
        ("i_t", "f8"),  # round: inertia about any transverse axis through the centre of mass [kg m^2]
        ("c_z", "f8"),  # round: centre of mass along the spin axis, from the origin [m]
        ("com", "f8", 3),  # centre of mass from the origin, axes S [m]
        ("inertia", "f8", (3, 3)),  # inertia about the origin, axes S [kg m^2]
    ],
    align=True,
)

# One row per joint on the way from ground to a body, bodies in order, each from the root to its own joint.
PATH = np.dtype(
    [
        ("body", "i8"),
        ("joint", "i8"),  # TORSION, FREE of a round body (shortcuts) or GENERAL
        ("dof", "i8"),
        ("n", "i8"),
        ("owner", "i8"),  # body whose joint it is
    ],
    align=True,
)


@dataclass(frozen=True, kw_only=True)
class Body:
    """One rigid body, as numbers.

    Parameters
    ----------
    motion
        Code of the joint to the parent (see joints.py).
    parent
        Number of the body it hangs on, counted from 1 in the order of the list; 0 = ground.
    position
        Position of the origin (the place of the joint) in world axes with all coordinates zero [m].
    axes
        Frame of the joint then (3, 3), columns in world axes, right-handed; the third is the spin axis.
    mass, polar_inertia, transverse_inertia
        [kg], [kg m^2] about the spin axis, [kg m^2] about a transverse axis through the centre of mass.
    center
        Centre of mass along the spin axis from the origin [m].
    com, inertia
        For bodies that are not round: centre of mass (3,) from the origin [m] and inertia (3, 3) about the
        centre of mass [kg m^2], both in the axes of the body; they replace the four numbers but the mass.
    lead
        Way of a screw along its axis per radian of its spin [m/rad].
    guided_by
        Coordinates (name, unit) of a guided body, at most six; it may have none and follow time alone.
    spinner
        Number of an earlier body on which a fixed one hangs without moving much against it, z axis along z
        axis: that spin counts as its own, and its frame R does not turn with it. 0 = none.
    shares
        Number of an earlier body whose coordinates guide this body too, in place of own ones; 0 = none.
    state
        whether it is not a body at all: its spin rate is the state of an element, with c' = f_c for the
        torque.
    angle
        Initial spin [rad]; any number of turns.
    start, rate
        Initial values of all coordinates of its joint and of their rates, in their order [m, rad],
        [m/s, rad/s]; empty for zeros. Turns of bodies that tumble must leave beta below a right angle.
    """

    motion: int = TORSION
    parent: int = 0
    position: ArrayLike = (0.0, 0.0, 0.0)
    axes: ArrayLike = field(default_factory=lambda: np.eye(3))
    mass: float = 0.0
    polar_inertia: float = 0.0
    transverse_inertia: float = 0.0
    center: float = 0.0
    com: ArrayLike = (0.0, 0.0, 0.0)
    inertia: ArrayLike | None = None
    lead: float = 0.0
    guided_by: tuple[tuple[str, str], ...] = ()
    shares: int = 0
    spinner: int = 0
    state: bool = False
    angle: float = 0.0
    start: tuple[float, ...] = ()
    rate: tuple[float, ...] = ()
    name: str = ""

    @property
    def is_round(self) -> bool:
        """Whether the body hangs on ground and is round about its spin axis."""
        return self.parent == 0 and self.motion in ROUND and self.inertia is None

    @property
    def coordinates(self) -> tuple[tuple[str, str], ...]:
        """Names and units of the coordinates of its joint."""
        return self.guided_by if self.motion == GUIDED else JOINTS[self.motion]

    def tensor(self) -> NDArray[np.float64]:
        """Inertia about the origin in the axes of the body, shape (3, 3) [kg m^2]."""
        com = self.center_of_mass()
        about = self.inertia
        if about is None:
            about = np.diag([self.transverse_inertia, self.transverse_inertia, self.polar_inertia])
        return np.asarray(about, float) + self.mass * (com @ com * np.eye(3) - np.outer(com, com))

    def center_of_mass(self) -> NDArray[np.float64]:
        """Centre of mass from the origin in the axes of the body, shape (3,) [m]."""
        if self.inertia is None:
            return np.array([0.0, 0.0, self.center])
        return np.asarray(self.com, float)

    def faults(self) -> list[str]:
        """List the reasons why the body cannot be computed; empty if there are none."""
        if self.motion not in JOINTS:
            return [f"motion {self.motion} is none of {sorted(JOINTS)}"]
        found = []
        axes = np.asarray(self.axes, float)
        if axes.shape != (3, 3) or np.abs(axes.T @ axes - np.eye(3)).max() > 1e-9 or np.linalg.det(axes) < 0:
            found.append("axes must be a right-handed orthonormal frame")
        numbers = (self.mass, self.polar_inertia, self.transverse_inertia, self.center, self.angle, self.lead)
        places = np.concatenate([np.asarray(self.position, float), np.asarray(self.com, float)])
        if not np.all(np.isfinite(numbers)) or not np.all(np.isfinite(places)):
            found.append("every number must be finite")
        if self.motion == SCREW and self.lead == 0.0:
            found.append("a screw needs a lead")
        for given in (self.start, self.rate):
            if len(given) not in (0, len(self.coordinates)) or not np.all(np.isfinite(given)):
                found.append(f"start values are {len(self.coordinates)} finite numbers")
        if self.shares and (self.motion != GUIDED or self.guided_by):
            found.append("only a guided body without coordinates of its own can share those of another")
        if self.spinner and (self.motion != FIXED or self.parent == 0):
            found.append("only a body that is fixed to another one can turn with a spin that is not its own")
        return found + (self._round_faults() if self.is_round else self._tensor_faults())

    def _round_faults(self) -> list[str]:
        found = []
        if self.motion != FIXED and not self.polar_inertia > 0.0:
            found.append("polar_inertia must be positive for a body that spins")
        if self.motion in (PLANAR, FREE) and not self.mass > 0.0:
            found.append("mass must be positive for a body that translates")
        if self.motion == FREE and not self.transverse_inertia > 0.0:
            found.append("transverse_inertia must be positive for a body that tilts")
        return found

    def _tensor_faults(self) -> list[str]:
        """A body in a tree may be without mass, if what hangs on it has some."""
        if min(self.mass, self.polar_inertia, self.transverse_inertia) < 0.0:
            return ["mass and inertia must not be negative"]
        if self.inertia is None:
            return []
        about = np.asarray(self.inertia, float)
        if about.shape != (3, 3) or not np.all(np.isfinite(about)):
            return ["inertia must be a finite matrix (3, 3)"]
        scale = np.abs(about).max(initial=0.0)
        if np.abs(about - about.T).max() > 1e-9 * scale:
            return ["inertia must be symmetric"]
        least, middle, most = np.linalg.eigvalsh(about)
        if least < -1e-9 * scale or least + middle < most * (1.0 - 1e-6):
            return ["inertia that no mass has: principal moments are >= 0, none above the sum of the others"]
        return []


def body_records(bodies: Sequence[Body]) -> NDArray[np.void]:
    """Fill the body records, ground first; coordinate and path indices are left to the layout.

    Parameters
    ----------
    bodies
        The bodies without ground; body k of this list gets index k + 1, parents come first.

    Returns
    -------
    ndarray of BODY, shape (len(bodies) + 1,)
    """
    records = np.zeros(len(bodies) + 1, BODY)
    records["axes"] = np.eye(3)
    for name in ("spin", "path", "chart", "guide"):
        records[name] = -1
    charts = guides = 0
    for record, body in zip(records[1:], bodies, strict=True):
        axes = AXES[body.motion]
        record["joint"] = body.motion if body.is_round else GENERAL
        own = bodies[body.shares - 1] if body.shares else body
        record["state"] = body.state
        record["n"], record["parent"], record["shares"] = len(own.coordinates), body.parent, body.shares
        record["axis"][: len(axes)] = axes
        record["lead"] = body.lead if body.motion == SCREW else 0.0
        if body.motion in TUMBLING:
            record["chart"] = charts
            charts += 1
        if body.motion == GUIDED:
            record["guide"] = guides
            guides += 1
        _hang(record, body, bodies)
        if body.spinner:
            below = bodies[body.spinner - 1].parent
            turned = np.asarray(bodies[below - 1].axes, float) if below else np.eye(3)
            record["spinner"], record["upright"] = body.spinner, turned.T @ np.asarray(body.axes, float)
        record["mass"], record["i_p"] = body.mass, body.polar_inertia
        record["i_t"], record["c_z"] = body.transverse_inertia, body.center
        record["com"], record["inertia"] = body.center_of_mass(), body.tensor()
        if not body.is_round:
            record["fixed_axes"] = 1
            records[body.parent]["fixed_axes"] = 1
    return records


def base_of(records: NDArray[np.void], b: int) -> int:
    """Body against which the spin of body b counts: its parent, or that of the body whose spin it has."""
    return int(records[int(records[b]["spinner"]) or b]["parent"])


def spin_of(records: NDArray[np.void], b: int) -> int:
    """Coordinate that is the spin of body b, its own or that of the body whose spin it has; -1 for none."""
    return int(records[int(records[b]["spinner"]) or b]["spin"])


def _hang(record: np.void, body: Body, bodies: Sequence[Body]) -> None:
    """Place of the joint in the axes of the parent."""
    position, axes = np.asarray(body.position, float), np.asarray(body.axes, float)
    if body.parent == 0:
        record["pos"], record["axes"] = position, axes
        return
    parent = bodies[body.parent - 1]
    turned = np.asarray(parent.axes, float)
    record["pos"] = turned.T @ (position - np.asarray(parent.position, float))
    record["axes"] = turned.T @ axes
    along = float(record["axes"][2, 2])
    record["sense"] = np.sign(along) if abs(abs(along) - 1.0) < 1e-9 else 0.0
