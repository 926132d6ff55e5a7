# SPDX-License-Identifier: Apache-2.0
"""Moment of a unit torque between two bodies with inclined spin axes, as in a constant-velocity joint.

The moment (n + o)/(1 + n.o) of the spin axes n and o is along their bisector and has the component 1 along
each. Its power on two bodies that spin about n and o is the difference of their speeds at any angle, so that
it is conjugate to the twist, the difference of their spin angles.
"""

from __future__ import annotations

from pitchpoint.core.kernel import kernel
from pitchpoint.multibody.vectors import add, dot, times


@kernel
def twist_axis(n, other):
    """Moment of a unit torque between bodies with two spin axes, unit vectors; n if they are equal."""
    if n[0] == other[0] and n[1] == other[1] and n[2] == other[2]:
        return n
    return times(1.0 / (1.0 + dot(n, other)), add(n, other))


@kernel
def turned_twist_axis(n, other, dn, d_other):
    """Change of `twist_axis` for changes of both axes."""
    turned = times(-dot(dn, other) - dot(n, d_other), twist_axis(n, other))
    return times(1.0 / (1.0 + dot(n, other)), add(add(dn, d_other), turned))
