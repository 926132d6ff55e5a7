# SPDX-License-Identifier: Apache-2.0
"""The numbers on the page of the example `backlash-oscillator`, from its files as shipped.

Jumps may move by one step of the sweep (25 Hz), levels by 1 %: the sharpest ones stand next to a fold.
"""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

from pitchpoint import compile_model, load_model
from pitchpoint.solvers.step_choice import mesh_mode
from pitchpoint.sweep.speed import run_sweep

FOLDER = Path(__file__).parents[2] / "examples" / "backlash-oscillator"

CASES = {  # file: natural frequency, jumps, maximum rms, maximum force, longest share without contact
    "model": (
        3173.7,
        [("up", 1387.5), ("up", 2662.5), ("down", 1637.5), ("down", 1237.5)],
        21.93e-6,
        13483.0,
        0.665,
    ),
    "tip-relief": (2845.6, [("up", 2437.5), ("down", 2062.5)], 12.47e-6, 7626.0, 0.538),
}


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[pytest.mark.study] if name == "tip-relief" else []) for name in CASES]
)
def test_sweep_as_on_the_page(name):
    natural, jumps, rms, force, apart = CASES[name]
    system = compile_model(load_model(FOLDER / f"{name}.yaml"), "sweep")
    assert mesh_mode(system.records["gear_mesh"][0], system) == pytest.approx(natural, rel=1e-4)
    done = run_sweep(system)
    assert done.status == 1, done.sentence
    assert [j["direction"] for j in done.jumps] == [d for d, _ in jumps]
    for found, (_, frequency) in zip(done.jumps, jumps, strict=True):
        assert found["mesh_frequency"] == pytest.approx(frequency, abs=25.1)
    assert max(p["deflection"]["rms"] for p in done.points) == pytest.approx(rms, rel=1e-2)
    assert max(p["mesh_force"]["max"] for p in done.points) == pytest.approx(force, rel=1e-2)
    assert max(p["contact_loss_share"] for p in done.points) == pytest.approx(apart, abs=1e-2)


def test_page_says_the_same():
    page = (FOLDER / "README.md").read_text(encoding="utf-8")
    for name, (natural, jumps, rms, force, apart) in CASES.items():
        row = next(line for line in page.splitlines() if line.startswith(f"| `{name}.yaml`"))
        cells = [cell.strip() for cell in row.strip("|").split("|")][1:]
        up = ", ".join(str(math.floor(f)) for d, f in jumps if d == "up")
        down = ", ".join(str(math.floor(f)) for d, f in jumps if d == "down")
        assert cells[0] == f"{natural:.0f} Hz"
        assert (cells[1], cells[2]) == (f"{up} Hz", f"{down} Hz")
        assert [float(re.match(r"[\d.]+", cell).group()) for cell in cells[3:]] == [
            pytest.approx(rms * 1e6, abs=0.05),
            pytest.approx(force * 1e-3, abs=0.05),
            pytest.approx(100.0 * apart, abs=1.0),
        ]


def test_files_differ_in_tip_relief_only():
    one, two = (load_model(FOLDER / f"{name}.yaml") for name in CASES)
    assert one.meshes["stage"].stiffness.tip_relief_factor == 0.0
    assert two.meshes["stage"].stiffness.tip_relief_factor == 0.5
    assert one.gears == two.gears
    assert one.bodies == two.bodies
    assert one.loads == two.loads
    assert one.scenarios == two.scenarios
