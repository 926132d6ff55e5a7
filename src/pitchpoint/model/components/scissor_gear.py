# SPDX-License-Identifier: Apache-2.0
"""Scissor gear: a free gear next to a fixed one, turned against it by a spring to take up the backlash."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.components.six import Damping6, Stiffness6
from pitchpoint.model.components.stiffness import LAWS, StiffnessLaw
from pitchpoint.model.keys import component, key, positive, quantity, text


@dataclass(frozen=True, kw_only=True)
class ScissorGear(Component):
    """Free half of a scissor gear, next to a gear that is fixed to its body.

    It represents a gear, its body, a torsion spring between both halves and its meshes with all gears that
    the fixed half meshes with. Its teeth are those of the fixed half.
    """

    gear: str = text("gear that is fixed to its body or shaft: the fixed half")
    face_width: float = positive("length", "face width of the free half")
    torque: float = quantity(
        "torque",
        "torque of the spring on the free half while both halves are in line, counter-clockwise positive; "
        "the fixed half takes its reaction",
        sample="15 N m",
    )
    stiffness: float = positive(
        "torsional_stiffness", "torsional stiffness of the spring", sample="40 N m/rad"
    )
    damping: float = quantity("torsional_damping", "torsional damping of the spring", 0.0, minimum=0.0)
    friction: float = quantity(
        "torque", "friction torque between both halves", 0.0, minimum=0.0, sample="0.5 N m"
    )
    position: float | None = quantity(
        "length",
        "position of the mid-face of the free half along the axis, from that of the fixed half",
        None,
        display="next to the fixed half, towards larger z",
    )
    mesh_stiffness: StiffnessLaw | None = key(
        "variant",
        "mesh stiffness of the free half; values are of the whole mesh, not per face width",
        None,
        of=LAWS,
        display="law of the meshes of the fixed half",
    )
    mass: float | None = quantity("mass", "mass of the free half", None, minimum=0.0, display="from geometry")
    inertia: float | None = quantity(
        "inertia", "polar moment of inertia of the free half", None, minimum=0.0, display="from geometry"
    )
    transverse_inertia: float | None = quantity(
        "inertia",
        "moment of inertia of the free half about a diameter",
        None,
        minimum=0.0,
        display="from geometry",
    )
    hub_stiffness: Stiffness6 | None = component(
        Stiffness6,
        "stiffness of the guide of the free half on the hub; required on shafts and bodies with motion: "
        "planar or free",
    )
    hub_damping: Damping6 | None = component(
        Damping6, "damping in the same directions, or a damping ratio", needs="hub_stiffness"
    )
