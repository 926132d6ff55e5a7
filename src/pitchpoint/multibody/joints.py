# SPDX-License-Identifier: Apache-2.0
"""Joint types: selection and order of the six displacements that are joint coordinates.

A joint moves its body by three translations along the axes of the joint frame on the parent, followed by
three rotations: alpha about the first axis, beta about the second axis of the rotated frame, spin about the
third axis of the result. Each joint type selects some of these six; the spin is always the last one. A screw
moves along its axis in proportion to its spin. Floating and spherical bodies reset the reference attitude of
their rotations when beta becomes large, which avoids the singularity. Shafts do not, because the total spin
angle is counted.
"""

from __future__ import annotations

#: The six displacements in the order of application: (name, unit).
DISPLACEMENTS: tuple[tuple[str, str], ...] = (
    ("x", "m"),
    ("y", "m"),
    ("z", "m"),
    ("alpha", "rad"),
    ("beta", "rad"),
    ("spin", "rad"),
)
Z, SPIN = 2, 5

FIXED = 0
TORSION = 1
PLANAR = 3
FREE = 6
"""Six coordinates, spin last: shaft on bearings. Its tilt must be below a right angle."""
PRISMATIC = 11
CYLINDRICAL = 12
UNIVERSAL = 13
SPHERICAL = 14
SCREW = 15
FLOATING = 16
"""Six coordinates for bodies that tumble."""
GUIDED = 17
"""Displacements are functions of time and of any number of coordinates up to six."""

#: Displacements that are the coordinates of each joint, as indices of `DISPLACEMENTS`.
AXES: dict[int, tuple[int, ...]] = {
    FIXED: (),
    TORSION: (5,),
    PLANAR: (0, 1, 5),
    FREE: (0, 1, 2, 3, 4, 5),
    PRISMATIC: (2,),
    CYLINDRICAL: (2, 5),
    UNIVERSAL: (3, 4),
    SPHERICAL: (3, 4, 5),
    SCREW: (5,),
    FLOATING: (0, 1, 2, 3, 4, 5),
    GUIDED: (),
}

#: Coordinates of each joint: (name, unit). Rates have the same names.
JOINTS: dict[int, tuple[tuple[str, str], ...]] = {
    code: tuple(DISPLACEMENTS[m] for m in axes) for code, axes in AXES.items()
}

#: Joints of round bodies (on ground, axisymmetric about the spin axis), which have separate kernels.
ROUND = (FIXED, TORSION, PLANAR, FREE)

#: Joints that reset their reference attitude before beta reaches a right angle.
TUMBLING = (SPHERICAL, FLOATING)
