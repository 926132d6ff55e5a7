# SPDX-License-Identifier: Apache-2.0
"""Export gears and shafts of one side of the gearbox as CAD solids, and import their mass and inertia.

Writes Z1 to Z6 and the four shafts, as STEP (with OCC, the extra `cad`) or STL, gives them to the model as
`solid` and prints what the masses differ by. Usage: ``python solids.py FOLDER [stl]``.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from pitchpoint import Model, load_model
from pitchpoint.io.gear_export import export_gear, export_shaft
from pitchpoint.report.masses import masses

HERE = Path(__file__).parent
GEARS = ("Z1", "Z2", "Z3", "Z4", "Z5", "Z6")
SHAFTS = ("input", "second", "third", "output")


def write(model: Model, folder: Path, ending: str = "step") -> Model:
    """Write all solids; gives the model that takes its masses from them."""
    changes: dict[str, Any] = {}
    for group, names in (("gears", GEARS), ("shafts", SHAFTS)):
        for name in names:
            file = folder / f"{name}.{ending}"
            if group == "gears":
                gear = model.gears[name]
                export_gear(gear.geometry, file, bore_diameter=gear.bore_diameter)
            else:
                export_shaft(model.shafts[name].dimensions, file)
            unit = {"unit": "1 mm"} if ending == "stl" else {}
            changes[f"{group}.{name}.solid"] = {"file": str(file.absolute()), **unit}
    return model.replace_all(changes)


def compared(model: Model) -> list[tuple[str, float, float, float]]:
    """Name, mass by geometry [kg], and what mass and polar inertia of the solid differ by."""
    rows = []
    for entry in masses(model):
        if "solid" in entry["sources"]:
            exact, found = entry["sources"]["geometry"], entry["sources"]["solid"]
            gap = (found[key] / exact[key] - 1.0 for key in ("mass", "polar_inertia"))
            rows.append((entry["name"], exact["mass"], *gap))
    return rows


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[2:] not in ([], ["stl"], ["step"]):
        sys.exit("usage: python solids.py FOLDER [stl|step]")
    for row in compared(write(load_model(HERE / "model.yaml"), Path(sys.argv[1]), *sys.argv[2:])):
        print("{:8} {:9.3f} kg by geometry; solid {:+.1e} in mass, {:+.1e} in polar inertia".format(*row))
