# SPDX-License-Identifier: Apache-2.0
"""Numbers of scissor gears: torque of the spring in mesh and load that it balances."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from pitchpoint.model.scissor_gears import SECTION

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def scissors_of_model(model: Model) -> dict[str, dict[str, Any]]:
    """Numbers of the scissor gears by name.

    Parameters
    ----------
    model
        The model.

    Returns
    -------
    dict
        Gear of the fixed half, its body, face widths [m], torque of the spring with rigid teeth in contact
        [N m], the flank force that it causes along the base tangent [N], and the backlash taken up along the
        base tangent [m] and as an angle [rad]. With several meshes the smallest backlash counts.

    Notes
    -----
    Both halves are twisted by the backlash j_bt/r_b, and the torque of the spring T_0 decreases to
    T = T_0 - k j_bt/r_b (docs/howto/scissor_gears.md).
    """
    found = {}
    for name, scissor in model.scissor_gears.items():
        radius = 0.5 * abs(model.gears[scissor.gear].geometry.d_b)
        gaps = [model.backlash(m) for m, mesh in model.meshes.items() if mesh.stage == f"{SECTION}.{name}"]
        backlash = max(min(gaps, default=0.0), 0.0)
        twist = backlash / radius
        torque = max(abs(scissor.torque) - scissor.stiffness * twist, 0.0)
        found[name] = {
            "gear": scissor.gear,
            "body": model.body_of(scissor.gear),
            "face_widths": [model.gears[scissor.gear].face_width, scissor.face_width],
            "backlash": backlash,
            "twist": twist,
            "spring_torque": math.copysign(torque, scissor.torque),
            "flank_force": torque / radius,
        }
    return found
