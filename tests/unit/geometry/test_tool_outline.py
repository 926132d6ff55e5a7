# SPDX-License-Identifier: Apache-2.0
"""The tool rolls in the gear that it has cut: it touches the whole tooth and never enters it."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.geometry.cutter import PinionCutter
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.outline_distance import FILLET, FLANK, gear_line
from pitchpoint.geometry.rack import BasicRack
from pitchpoint.geometry.tool_outline import CUTTER, RACK, tool_tooth

M = 2e-3
GEARS = {
    "spur": CylindricalGear(z=24, m_n=M),
    "undercut": CylindricalGear(z=9, m_n=M, x=0.1),
    "helical": CylindricalGear(z=20, m_n=M, beta=0.4, x=0.2, thickness_allowance=-60e-6),
    "rounded": CylindricalGear(z=200, m_n=M, rack=BasicRack(rho_fP_star=0.9)),
    "ring": CylindricalGear.internal(z=60, m_n=M, cutter=PinionCutter(z_0=20, x_0=0.1, rho_aP0_star=0.2)),
    "helical ring": CylindricalGear.internal(z=71, m_n=M, beta=0.3, x=-0.3, cutter=PinionCutter(z_0=23)),
}


@pytest.mark.parametrize("name", GEARS)
def test_the_tool_touches_the_tooth_and_stays_outside(name: str) -> None:
    """Law of gearing: at every rotation some point of the tool lies on the tooth, and none inside it."""
    gear = GEARS[name]
    tool, line = tool_tooth(gear, 120), gear_line(gear)
    assert tool is not None and tool.kind == (CUTTER if gear.is_internal else RACK)
    half_space = math.pi / abs(gear.z)
    parts = set()
    for phi in np.linspace(-1.0, 1.0, 15) * half_space:
        # the tooth of the outline stands next to the space on the +x axis
        teeth = np.concatenate([tool.at(phi, tooth) for tooth in range(-1, 2)])
        points = teeth * np.exp(-1j * (phi + half_space))
        near = line.nearest(points)
        k = int(near.distance.argmin())
        assert abs(near.distance[k]) < 1e-4 * M
        parts.add(int(near.part[k]))
    assert parts & {FILLET, FLANK}


def test_a_ring_without_cutter_has_no_tool() -> None:
    assert tool_tooth(CylindricalGear.internal(z=60, m_n=M)) is None


def test_neighbouring_teeth_of_the_tool_fit_the_next_spaces() -> None:
    for gear in (GEARS["helical"], GEARS["ring"]):
        tool = tool_tooth(gear)
        assert tool is not None
        # after one pitch of the gear the next tooth of the tool is where this one was
        pitch = 2.0 * math.pi / abs(gear.z)
        np.testing.assert_allclose(tool.at(-pitch, 1), tool.at(0.0), atol=1e-15)
