# SPDX-License-Identifier: Apache-2.0
"""The joints: which of six displacements are the coordinates of each, in which order.

Every joint moves its body by three translations along the axes of its frame on the parent and then by three
turns: alpha about the first axis, beta about the second axis of the turned frame, spin about the third axis
of the result. A joint is the choice of some of these six; the spin is always the last one. A screw moves
along its axis in proportion to its spin. Free and spherical bodies start their turns afresh when beta grows,
so that no attitude is singular; a shaft never does, because its spin is counted.
"""

from __future__ import annotations

#: The six displacements, in the order they are made: (name, unit).
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
"""Six coordinates, spin last: a shaft on bearings. It must not tilt by a right angle."""
PRISMATIC = 11
CYLINDRICAL = 12
UNIVERSAL = 13
SPHERICAL = 14
SCREW = 15
FLOATING = 16
"""Six coordinates for bodies that tumble."""
GUIDED = 17
"""Displacements are functions of the coordinates, of which there may be none, and of time."""

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

#: Joints of bodies that hang on ground and are round about their spin axis: they have kernels of their own.
ROUND = (FIXED, TORSION, PLANAR, FREE)

#: Joints whose turns start afresh before beta reaches a right angle.
TUMBLING = (SPHERICAL, FLOATING)
