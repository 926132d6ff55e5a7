# SPDX-License-Identifier: Apache-2.0
"""Remarks on scissor gears whose spring cannot take up the backlash, and on faces out of mesh."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, remark
from pitchpoint.core.units import format_quantity
from pitchpoint.model.scissor_gears import SECTION

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

TURN = math.tau
"""Angle by which the spring of a scissor gear is never wound [rad]."""
EDGE = 1e-6
"""Face width out of mesh that is rounding [m]."""


def weak_springs(model: Model) -> Iterator[Message]:
    """Springs that are weaker than backlash or friction, wound by more than a turn; faces out of mesh."""
    for name, scissor in model.scissor_gears.items():
        at = f"{SECTION}.{name}"
        meshes = {n: mesh for n, mesh in model.meshes.items() if mesh.stage == at}
        radius = 0.5 * abs(model.gears[scissor.gear].geometry.d_b)
        gap = max(min(map(model.backlash, meshes), default=0.0), 0.0)
        needed = scissor.stiffness * gap / radius
        torque, words = abs(scissor.torque), format_quantity(abs(scissor.torque), "torque", 4)
        wound = torque / scissor.stiffness
        if torque <= needed:
            yield remark(
                f"{at}.torque",
                f"{words} is used up by a rotation of {wound * 1e3:.4g} mrad, before the free half has "
                f"crossed the backlash, {1e3 * gap / radius:.4g} mrad: it does not rest on the flanks",
                f"give a torque above {format_quantity(needed, 'torque', 4)}, or a softer spring",
            )
        elif torque - needed <= scissor.friction:
            yield remark(
                f"{at}.friction",
                f"{format_quantity(scissor.friction, 'torque', 4)} is not less than the torque of the spring "
                f"in mesh, {format_quantity(torque - needed, 'torque', 4)}: the free half can stick away "
                "from the flanks",
                "give a smaller friction torque or a larger torque of the spring",
            )
        if wound > TURN:
            yield remark(
                f"{at}.torque",
                f"{words} winds the spring by {wound / TURN:.4g} revolutions",
                "correct the torque, the stiffness, or their units",
            )
        for mesh, part in meshes.items():
            width = part.b_w
            if width is not None and scissor.face_width - width > EDGE:
                mate = next(gear for gear in part.gears if gear != name)
                yield remark(
                    f"{at}.face_width",
                    f"only {1e3 * width:.4g} of {1e3 * scissor.face_width:.4g} mm are in the face width of "
                    f"{mate} ({mesh})",
                    "reduce the face width, or correct position, or the position of the gear on its body",
                )
