# SPDX-License-Identifier: Apache-2.0
"""The six gears of the shovel gearbox as solids for CAD programs, and their masses against the closed form.

Writes Z1.step to Z6.step (with OCC, the extra `cad`) or Z1.stl to Z6.stl. Pinions have odd numbers.
Usage: ``python solids.py FOLDER [stl]``.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

from pitchpoint.geometry import CylindricalGear, profile_shift_for_center_distance
from pitchpoint.geometry.mass_properties import gear_mass_properties
from pitchpoint.geometry.materials import material
from pitchpoint.geometry.solid_file import read_solids, round_inertia
from pitchpoint.io.gear_export import export_gear

STAGES = {
    1: (11, 81, 12.0, 16.0, 580.0, (130.0, 120.0), 0.40),
    2: (12, 68, 16.0, 12.0, 665.0, (210.0, 200.0), 0.45),
    3: (11, 36, 30.0, 12.0, 750.0, (280.0, 270.0), 0.50),
}
"""Teeth, normal module, helix angle [deg], centre distance, face widths [mm], profile shift of the pinion.

The paper prints no profile shifts; the sum follows from the centre distance. The pinion takes what keeps it
free of undercut, the wheel the rest."""


def gears() -> dict[str, CylindricalGear]:
    """All six gears by name; pinions are right-handed in every stage, wheels left-handed."""
    found = {}
    for stage, (z1, z2, m_n, beta, a, (b1, b2), x1) in STAGES.items():
        common = {"m_n": m_n * 1e-3, "alpha_n": math.radians(20.0)}
        x_sum = profile_shift_for_center_distance(
            z_sum=z1 + z2, beta=math.radians(beta), a_w=a * 1e-3, **common
        )
        turn = math.radians(beta)
        found[f"Z{2 * stage - 1}"] = CylindricalGear(z=z1, beta=turn, x=x1, b=b1 * 1e-3, **common)
        found[f"Z{2 * stage}"] = CylindricalGear(z=z2, beta=-turn, x=x_sum - x1, b=b2 * 1e-3, **common)
    return found


def write(folder: Path, ending: str = "step") -> list[tuple[str, float, float, float]]:
    """Write all gears; gives name, mass [kg], and what mass and polar inertia of the file differ by."""
    density, rows = material("steel").density, []
    for name, gear in gears().items():
        # slices of half a degree, 40 points a flank: 1e-4 of the mass in STL, 1e-8 in STEP
        file = export_gear(gear, folder / f"{name}.{ending}")
        solid = read_solids(file, 1e-3 if ending == "stl" else None).part()
        exact = gear_mass_properties(gear, density)
        mass, polar = density * solid.volume, density * round_inertia(solid, (0.0, 0.0, 1.0)).polar
        rows.append((name, exact.mass, mass / exact.mass - 1.0, polar / exact.polar_inertia - 1.0))
    return rows


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[2:] not in ([], ["stl"], ["step"]):
        sys.exit("usage: python solids.py FOLDER [stl|step]")
    target = Path(sys.argv[1])
    for row in write(target, *sys.argv[2:]):
        print("{}: {:9.3f} kg; the file differs by {:+.1e} in mass, {:+.1e} in polar inertia".format(*row))
