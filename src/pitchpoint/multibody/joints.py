# SPDX-License-Identifier: Apache-2.0
"""The joints: which coordinates each has, in which order. The spin is always the last one.

The code of a joint is its number of coordinates. Translations run along the axes of the reference frame; a
free body turns by alpha about the first reference axis, by beta about the second axis of the turned frame,
and spins about the third axis of the result.
"""

from __future__ import annotations

FIXED = 0
TORSION = 1
PLANAR = 3
FREE = 6

#: Coordinates of each joint: (name, unit). Rates have the same names.
JOINTS: dict[int, tuple[tuple[str, str], ...]] = {
    FIXED: (),
    TORSION: (("spin", "rad"),),
    PLANAR: (("x", "m"), ("y", "m"), ("spin", "rad")),
    FREE: (("x", "m"), ("y", "m"), ("z", "m"), ("alpha", "rad"), ("beta", "rad"), ("spin", "rad")),
}
