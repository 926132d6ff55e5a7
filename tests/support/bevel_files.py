# SPDX-License-Identifier: Apache-2.0
"""Model files with one bevel mesh: two gears at any shaft angle, on bearings or spinning only."""

from __future__ import annotations

import math

APEX = (0.0, 0.0, 0.0)


def bevel_file(
    *,
    z=(20, 40),
    shaft=90.0,
    spiral=0.0,
    opens=("+z", "+z"),
    bodies="motion: torsion, inertia: {inertia}",
    inertias=("2e-3 kg m^2", "3e-2 kg m^2"),
    mesh="stiffness: {law: constant, value: 3e8}, backlash: {normal: 0.05 mm}",
    mounting=(0.0, 0.0),
    rest="",
):
    """A file with the bevel gears a and b in the mesh m, 3 mm outer module and 20 mm wide.

    Axis 1 is z of the world, axis 2 lies `shaft` degrees from it in the x-z plane. `mounting` is how far the
    apexes lie from the origins of the bodies along their z axes [m].
    """
    one, two = (1.0 if o == "+z" else -1.0 for o in opens)
    s, c = math.sin(math.radians(shaft)), math.cos(math.radians(shaft))
    axes = [(0.0, 0.0, one), (two * s, 0.0, two * c)]
    hands = ("right", "left") if spiral > 0.0 else ("left", "right")
    twist = [f", spiral_angle: {abs(spiral)} deg, hand: {h}" if spiral else "" for h in hands]
    text = "title: bevel pair\nbevel_gears:\n"
    for k, name in enumerate("ab"):
        text += (
            f"  {name}: {{number_of_teeth: {z[k]}, mate_teeth: {z[1 - k]}, shaft_angle: {shaft} deg, "
            f"outer_transverse_module: 3 mm, face_width: 20 mm, opens: {opens[k]}{twist[k]}}}\n"
        )
    text += "bodies:\n"
    for k, name in enumerate(("first", "second")):
        place = ", ".join(repr(-mounting[k] * x) for x in axes[k])
        way = ", ".join(repr(x) for x in axes[k])
        text += (
            f"  {name}: {{bevel_gears: {{{'ab'[k]}: {mounting[k]!r}}}, position: [{place}], "
            f"axes: {{z: [{way}], x: [0, 1, 0]}}, {bodies.format(inertia=inertias[k])}}}\n"
        )
    return text + f"bevel_meshes:\n  m: {{gears: [a, b], {mesh}}}\n{rest}"
