# SPDX-License-Identifier: Apache-2.0
"""Body record: parent, joint, mass and inertia.

Each body is connected to its parent, another body or ground, by one joint at its origin; parents come before
children. The *frame* R of a body does not rotate with its spin; its third axis is the spin axis. The spin
angle is stored separately. S is R rotated by the spin angle, the body-fixed frame. Bodies on ground that are
axisymmetric about the spin axis ("round" bodies: gears, shafts) do not need S: their inertia is constant in
R, and no trigonometric function of the spin is evaluated.
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
"""Joint code of all bodies that are not round."""

BODY = np.dtype(
    [
        ("joint", "i8"),  # FIXED, TORSION, PLANAR, FREE of a round body, else GENERAL
        ("n", "i8"),  # number of coordinates
        ("parent", "i8"),  # parent body, 0 = ground
        ("dof", "i8"),  # index of its first coordinate
        ("spin", "i8"),  # index of its spin coordinate, -1 if it has none
        ("path", "i8"),  # its own entry in the list of paths, -1 without coordinates
        ("first", "i8"),  # first entry of its path from ground
        ("count", "i8"),  # entries of its path
        ("ii", "i8"),  # its diagonal pair block, 0 = sink
        ("axis", "i8", 6),  # displacements that are its coordinates
        ("chart", "i8"),  # index of the reference attitude of its rotations, -1 for none
        ("guide", "i8"),  # index of displacements given by functions, -1 for none
        ("shares", "i8"),  # body whose coordinates it shares, 0 for none
        ("spinner", "i8"),  # body whose spin it takes over, 0 for none
        ("upright", "f8", (3, 3)),  # reference frame of that spin, columns in axes S of the spinner's parent
        ("fixed_axes", "i8"),  # 1: S is computed
        ("state", "i8"),  # 1: not a body; its spin rate is a state of an element
        ("lead", "f8"),  # screw: travel along the axis per radian [m/rad]
        ("sense", "f8"),  # spin axis relative to that of the parent: 1 parallel, -1 opposite, 0 neither
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

# One row per joint on the path from ground to each body; bodies in order, joints from the root outwards.
PATH = np.dtype(
    [
        ("body", "i8"),
        ("joint", "i8"),  # TORSION or FREE of a round body (fast paths), else GENERAL
        ("dof", "i8"),
        ("n", "i8"),
        ("owner", "i8"),  # body moved by the joint
    ],
    align=True,
)


@dataclass(frozen=True, kw_only=True)
class Body:
    """Numerical data of one rigid body.

    Parameters
    ----------
    motion
        Code of the joint to the parent (see joints.py).
    parent
        Number of the parent body, counted from 1 in the order of the list; 0 = ground.
    position
        Position of the origin (location of the joint) in world axes with all coordinates zero [m].
    axes
        Joint frame with all coordinates zero (3, 3), columns in world axes, right-handed; the third is the
        spin axis.
    mass, polar_inertia, transverse_inertia
        Mass [kg]; moments of inertia [kg m^2] about the spin axis and about a transverse axis through the
        centre of mass.
    center
        Centre of mass along the spin axis from the origin [m].
    com, inertia
        For bodies that are not round: centre of mass (3,) from the origin [m] and inertia (3, 3) about the
        centre of mass [kg m^2], both in body axes; they replace polar_inertia, transverse_inertia and
        center.
    lead
        Travel of a screw joint along its axis per radian of its spin [m/rad].
    guided_by
        Coordinates (name, unit) of a guided body, at most six; without any it is a function of time only.
    spinner
        Number of an earlier body to which a fixed body is attached, with parallel z axes and small relative
        motion: the body takes over that spin, and its frame R does not rotate with it. 0 = none.
    shares
        Number of an earlier body whose coordinates also guide this body, which then has none itself; 0 =
        none.
    state
        Whether this is not a body but a dynamic state c of an element: the spin rate is c, and c' = f_c
        replaces the torque balance.
    angle
        Initial spin angle [rad], may exceed one revolution.
    start, rate
        Initial values of all joint coordinates [m, rad] and of their rates [m/s, rad/s], in order; empty for
        zeros. For tumbling bodies |beta| must be below a right angle.
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
        """Whether the body is on ground and axisymmetric about its spin axis."""
        return self.parent == 0 and self.motion in ROUND and self.inertia is None

    @property
    def coordinates(self) -> tuple[tuple[str, str], ...]:
        """Names and units of the joint coordinates."""
        return self.guided_by if self.motion == GUIDED else JOINTS[self.motion]

    def tensor(self) -> NDArray[np.float64]:
        """Inertia about the origin in body axes, shape (3, 3) [kg m^2]."""
        com = self.center_of_mass()
        about = self.inertia
        if about is None:
            about = np.diag([self.transverse_inertia, self.transverse_inertia, self.polar_inertia])
        return np.asarray(about, float) + self.mass * (com @ com * np.eye(3) - np.outer(com, com))

    def center_of_mass(self) -> NDArray[np.float64]:
        """Centre of mass from the origin in body axes, shape (3,) [m]."""
        if self.inertia is None:
            return np.array([0.0, 0.0, self.center])
        return np.asarray(self.com, float)

    def faults(self) -> list[str]:
        """List of problems of the data; empty if the body is valid."""
        if self.motion not in JOINTS:
            return [f"motion {self.motion} is not a joint code (limit {sorted(JOINTS)})"]
        found = []
        axes = np.asarray(self.axes, float)
        if axes.shape != (3, 3) or np.abs(axes.T @ axes - np.eye(3)).max() > 1e-9 or np.linalg.det(axes) < 0:
            found.append("axes must be a right-handed orthonormal frame")
        numbers = (self.mass, self.polar_inertia, self.transverse_inertia, self.center, self.angle, self.lead)
        places = np.concatenate([np.asarray(self.position, float), np.asarray(self.com, float)])
        if not np.all(np.isfinite(numbers)) or not np.all(np.isfinite(places)):
            found.append("all numbers must be finite")
        if self.motion == SCREW and self.lead == 0.0:
            found.append("a screw joint requires a lead other than 0")
        for given in (self.start, self.rate):
            if len(given) not in (0, len(self.coordinates)) or not np.all(np.isfinite(given)):
                found.append(f"start values must be {len(self.coordinates)} finite numbers")
        if self.shares and (self.motion != GUIDED or self.guided_by):
            found.append("only a guided body without own coordinates can share those of another body")
        if self.spinner and (self.motion != FIXED or self.parent == 0):
            found.append("only a body fixed to another body can take over a spin")
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
        """Problems of mass and inertia in a tree; zero is permitted, since further bodies may add mass."""
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
            return ["inertia must be physical: principal moments >= 0, none above the sum of the other two"]
        return []


def body_records(bodies: Sequence[Body]) -> NDArray[np.void]:
    """Body records with ground first; coordinate and path indices are set by the layout.

    Parameters
    ----------
    bodies
        Bodies without ground, parents first; body k of this list has index k + 1.

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
        _place_joint(record, body, bodies)
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
    """Reference body of the spin of body b: its parent, or the parent of its spinner."""
    return int(records[int(records[b]["spinner"]) or b]["parent"])


def spin_of(records: NDArray[np.void], b: int) -> int:
    """Spin coordinate of body b, or of its spinner; -1 for none."""
    return int(records[int(records[b]["spinner"]) or b]["spin"])


def _place_joint(record: np.void, body: Body, bodies: Sequence[Body]) -> None:
    """Set position and axes of the joint in the axes of the parent."""
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
