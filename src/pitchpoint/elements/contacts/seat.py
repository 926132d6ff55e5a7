# SPDX-License-Identifier: Apache-2.0
"""Contact of a sphere in a hollow cone along a circle: the ball of a check valve in its seat.

Every generator of the cone is a line in a plane tangent to it, and the inside of the cone is the intersection
of these planes. A part of the circle in the direction e = (cos a, sin a, 0) has the gap of its plane,

    h(a) = -(c . e cos g + c_z sin g) - r

for the centre c of the sphere, its radius r and the half angle g: the smallest of all h is the distance of
the sphere from the cone. The law for the whole circle is divided equally among its parts, so a centred ball
is pressed along the axis only, and one that is displaced is pushed back by the parts that are deeper.
"""

from __future__ import annotations

import math

from pitchpoint.core.kernel import kernel
from pitchpoint.elements.contacts.surface_place import point_place
from pitchpoint.elements.contacts.swept import SAMPLES
from pitchpoint.elements.contacts.wrench import act
from pitchpoint.multibody.vectors import dot, into_world, triple


@kernel
def circle_of_contact(b, c, f, g, kk):
    """Add the contact of the sphere of body i with the hollow cone of body j all around."""
    cosine = math.cos(b["size_j"][0])
    sine = math.sin(b["size_j"][0])
    for row in range(3):
        for column in range(3):
            b["W"][row, column] = 0.0
    for k in range(SAMPLES):
        angle = k * (2.0 * math.pi / SAMPLES)
        n = (-cosine * math.cos(angle), -cosine * math.sin(angle), -sine)
        h = dot(n, triple(b["d"], 0)) - b["radius"]
        point_place(b, f, g, triple(b["oi"], 0), into_world(b["Ej"], n), h, b["radius"], 1.0 / SAMPLES)
        act(b, c, f, g, kk)
