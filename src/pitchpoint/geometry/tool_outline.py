# SPDX-License-Identifier: Apache-2.0
"""The tool that generates a gear, in the space that it cuts: a tooth of a rack or of a pinion-type cutter.

Frame: the axis of the gear in the origin, the middle of the space on the +x axis, points x + iy [m] in the
transverse section. Turning the gear by φ, the tool moves with it as given by `ToolTooth.at`.

Derivation: docs/theory/geometry.md, "A pair".
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.cutter import CutterFillet
from pitchpoint.geometry.involute import inv
from pitchpoint.geometry.rack_fillet import RackFillet
from pitchpoint.geometry.tooth_form import tooth_form

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

ComplexArray = NDArray[np.complex128]

RACK, CUTTER = "rack", "pinion-type cutter"
_ABOVE = 0.25
"""How far a rack is drawn beyond the tip circle of the gear, in modules."""
_HEIGHT = 2.5
"""Height of the teeth of a cutter as they are drawn, in modules."""


@dataclass(frozen=True)
class ToolTooth:
    """One tooth of a generating tool where it fills a space of the gear.

    Attributes
    ----------
    kind
        `RACK` or `CUTTER`.
    points
        Its outline, from the body over the tip and back, the side with y > 0 last.
    step
        What brings it to its next tooth: a distance along y for a rack [m], an angle about its axis [rad].
    axis
        Place of the axis of a cutter on the x axis [m]; the reference radius for a rack.
    travel
        What it moves by when the gear turns by one radian, in the measure of `step`.
    """

    kind: str
    points: ComplexArray
    step: float
    axis: float
    travel: float

    def at(self, phi: float, tooth: int = 0) -> ComplexArray:
        """Points x + iy of a tool tooth [m], shape (n,), after a counter-clockwise rotation of the gear.

        Parameters
        ----------
        phi
            Rotation of the gear [rad].
        tooth
            Which tooth, counted counter-clockwise.
        """
        moved = phi * self.travel + tooth * self.step
        if self.kind == RACK:
            return self.points + 1j * moved
        return np.asarray(self.axis + (self.points - self.axis) * np.exp(1j * moved))


def tool_tooth(gear: CylindricalGear, n: int = 60) -> ToolTooth | None:
    """The tool of a gear; None for an internal gear without a cutter.

    Parameters
    ----------
    gear
        External gear, made by the rack that its basic rack represents, or internal gear.
    n
        Points of every rounding and flank.

    Raises
    ------
    GeometryError
        If the gear has no such tooth.

    Notes
    -----
    The tool is at the position that also makes the thickness allowance, as for `tooth_form`. The transverse
    section of a rack is that of its normal section stretched by 1/cos β along its datum line.

    Examples
    --------
    The tip of the tool touches the root circle, d_f = 20 · 2 mm − 2 · 1.25 · 2 mm:

    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> tool = tool_tooth(CylindricalGear(z=20, m_n=2e-3))
    >>> round(2e3 * float(tool.points.real.min()), 6)
    35.0
    """
    form = tooth_form(gear)
    if isinstance(form.fillet, RackFillet):
        return _rack(gear, form.fillet, form.r_a, n)
    return None if gear.cutter is None else _cutter(gear, form.fillet, n)


def _rack(gear: CylindricalGear, fillet: RackFillet, r_a: float, n: int) -> ToolTooth:
    """Tip rounding of the fillet, straight flanks up to beyond the tip of the gear."""
    theta = np.linspace(0.5 * math.pi, fillet.theta_flank, n)
    depth = fillet.depth_c + fillet.rho * np.sin(theta)
    across = fillet.x_c + fillet.rho * np.cos(theta)
    top = r_a - fillet.r + _ABOVE * gear.m_n
    straight = np.linspace(depth[-1], -top, n)[1:]
    across = np.append(across, across[-1] + (depth[-1] - straight) * math.tan(gear.alpha_n))
    half = fillet.r - np.append(depth, straight) + 1j * across / fillet.cos_beta
    return ToolTooth(RACK, np.concatenate([half[::-1].conj(), half]), gear.p_t, fillet.r, fillet.r)


def _cutter(gear: CylindricalGear, fillet: CutterFillet, n: int) -> ToolTooth:
    """Tip land and rounding of the fillet, involutes, and straight lines below the base circle."""
    assert gear.cutter is not None
    axis = fillet.r_w2 - fillet.r_w0
    r_b0 = fillet.ratio * abs(gear.r_b)
    land = (fillet.r_c + fillet.rho) * np.exp(1j * np.linspace(0.0, fillet.psi_c, n)[:-1])
    theta = np.linspace(0.0, fillet.theta_flank, n)
    center = fillet.r_c * np.exp(1j * fillet.psi_c)
    rounding = center + fillet.rho * np.exp(1j * (fillet.psi_c + theta))
    r_end, angle = abs(rounding[-1]), float(np.angle(rounding[-1]))
    psi_b0 = angle + inv(math.acos(min(1.0, r_b0 / r_end)))
    r_root = fillet.r_c + fillet.rho - _HEIGHT * gear.m_n
    start, end = (math.sqrt(max(0.0, (r / r_b0) ** 2 - 1.0)) for r in (r_end, r_root))
    roll = np.linspace(start, end, n)[1:]
    flank = r_b0 * np.hypot(1.0, roll) * np.exp(1j * (psi_b0 - roll + np.arctan(roll)))
    foot = flank[-1:] / abs(flank[-1]) * min(r_root, r_b0)
    half = axis + np.concatenate([land, rounding, flank, foot])
    points = np.concatenate([half[:0:-1].conj(), half])
    return ToolTooth(CUTTER, points, 2.0 * math.pi / gear.cutter.z_0, axis, 1.0 / fillet.ratio)
