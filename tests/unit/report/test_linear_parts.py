# SPDX-License-Identifier: Apache-2.0
"""Modes and Campbell diagrams of reports: any machine, one per set of prescribed motions, or the reason."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.cli.main import run_command
from pitchpoint.core.progress import silent
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.collect import collect
from pitchpoint.report.linear_parts import conditions_of, linear_parts
from tests.support.machines import pair as text_of_pair
from tests.unit.report.test_variants import text as pair

RPM = np.pi / 30.0
ROTOR = """
title: overhung rotor
shafts:
  spindle:
    sections: [{length: 500 mm, diameter: 40 mm}]
    position: [0, 0, 0]
    largest_piece: 250 mm
    markers: {tip: {position: [0, 0, 500 mm]}}
bodies:
  impeller: {mass: 12 kg, inertia: 0.15 kg m^2, transverse_inertia: 0.08 kg m^2}
joints:
  seat: {type: fixed, bodies: [spindle.tip, impeller]}
bearings:
  front: {body: spindle, position: [0, 0, 300 mm], stiffness: {radial: 2e7, axial: 1e8},
    damping: {radial: 2000, axial: 500}}
  rear: {body: spindle, position: [0, 0, 0 mm], stiffness: {radial: 2e7}, damping: {radial: 2000}}
unbalances:
  mass: {body: impeller, mass: 10 g, position: [100 mm, 0, 0]}
scenarios:
  up: {drive: {spindle: {speed: {table: [[0 s, 3000 rpm], [1 s, 6000 rpm]]}}}, duration: 1 s,
    step: 0.2 ms, settle_time: 0 s}
"""


def section(page: str, name: str) -> str:
    """Text of a section of a page, without its pictures."""
    found = re.search(rf'<section id="{name}".*?</section>', page, re.DOTALL)
    assert found, name
    return re.sub(r"<[^>]+>", " ", re.sub(r"<script.*?</script>", "", found[0], flags=re.DOTALL))


def test_a_rotor_without_gears_has_its_critical_speed_and_order_maps(tmp_path: Path) -> None:
    """The page names the speed at which the unbalance meets the first forward bending mode."""
    model = loads_model(ROTOR)
    run = pp.solve_time(pp.compile_model(model, "up"))
    page = pp.write_report(model, tmp_path / "page.html", run).read_text(encoding="utf-8")
    assert "spindle: 3000 to 6000 rpm" in section(page, "summary")
    critical = section(page, "campbell")
    assert "scenario up, prescribed motion: spindle; operating range 3000 to 6000 rpm." in critical
    row = re.search(r"(\d+) rpm\s+[\d.]+ Hz\s+[\d.]+ %\s+1× spindle\s+1st bending", critical)
    assert row and 3000.0 < float(row[1]) < 6000.0
    assert f"within the operating range 3000 to 6000 rpm of spindle: {row[1]} rpm (1× spindle" in section(
        page, "summary"
    )
    # the largest force of a run-up follows within a tenth of the critical speed
    top = int(np.argmax(run["bearing_force[front.radial]"].values))
    assert 1.0 < float(run["speed[spindle]"].values[top]) / RPM / float(row[1]) < 1.1
    assert "orders are vertical lines" in section(page, "spectra")


def test_prescribed_motions_of_the_results_have_their_own_modes(tmp_path: Path) -> None:
    """A free pair has one mesh mode on both inertias, a driven one that of the wheel: lower by sqrt(2)."""
    more = (
        "  runup: {drive: {driver: {speed: {table: [[0 s, 600 rpm], [5 ms, 1800 rpm]]}}}, duration: 5 ms}\n"
        "  fast: {speed: {driver: 9000 rpm}, duration: 5 ms}\n"
    )
    path = tmp_path / "pair.yaml"
    path.write_text(pair() + more, encoding="utf-8")
    model = pp.load_model(path)
    assert [(c.scenarios, c.held, c.same) for c in conditions_of(model, ("runup", "steady", "fast"))] == [
        (("runup",), ("driver",), ("runup",)),
        (("steady", "fast"), (), ("steady", "sweep", "fast")),
    ]
    assert conditions_of(model)[0].scenarios == ("steady",)
    for name in ("steady", "runup"):
        assert run_command(["run", str(path), "-s", name, "-q", "-o", str(tmp_path / f"{name}.h5")]) == 0
    found, _ = collect(model, [str(tmp_path / f"{name}.h5") for name in ("steady", "runup")], silent)
    free, driven = (max(found.modes[name].frequency) for name in ("steady", "runup"))
    assert free == pytest.approx(np.sqrt(2.0) * driven, rel=1e-6)
    ranges = [found.campbells[name].attrs["operating_speed"] for name in ("steady", "runup")]
    assert np.array(ranges) / RPM == pytest.approx(np.array([[1200.0, 9000.0], [600.0, 1800.0]]))
    text = pp.write_report(
        path, tmp_path / "page.html", *(tmp_path / f"{n}.h5" for n in found.modes)
    ).read_text(encoding="utf-8")
    modes = section(text, "modes")
    assert "loaded state of scenario steady with mean mesh stiffness; no prescribed motion." in modes
    assert "loaded state of scenario runup with mean mesh stiffness; prescribed motion: driver." in modes
    assert "scenario runup, prescribed motion: driver; operating range 600 to 1800 rpm" in section(
        text, "campbell"
    )


def test_the_reason_stands_in_place_of_a_diagram(tmp_path: Path) -> None:
    slow = loads_model(pair().replace("1500 rpm", "40 rpm").replace("[1000 Hz, 1200 Hz]", "[10 Hz, 20 Hz]"))
    page = pp.write_report(slow, tmp_path / "slow.html").read_text(encoding="utf-8")
    assert "No critical speed up to 48 rpm of driver: the lowest natural frequency," in section(
        page, "campbell"
    )
    still = loads_model(
        "bodies:\n  disc: {inertia: 1 kg m^2, position: [0, 0, 0]}\ntorsion_springs:\n"
        "  k: {bodies: [disc], stiffness: 1e3 N m/rad}\n"
    )
    words = linear_parts(still).campbells[""]
    assert isinstance(words, str)
    assert words.startswith("No scenario rotates disc")


@pytest.mark.parametrize("beta", ["17 deg", ""])
def test_an_axial_mode_that_helical_teeth_drive_is_named(beta: str, tmp_path: Path) -> None:
    """Wheel of 4 kg on an axial stiffness of 2e7 N/m: 356 Hz, 712 rpm of 30 teeth, near 700 rpm.

    The teeth hardly deflect in this mode, the wheel moves by a multiple of the transmission error.
    """
    rest = "bearings:\n"
    for body, axial in (("driver", 2e8), ("driven", 2e7)):
        stiffness = f"{{radial: 4e8 N/m, axial: {axial} N/m, tilt: 2e6 N m/rad}}"
        rest += f"  on_{body}: {{body: {body}, stiffness: {stiffness}, damping: {{ratio: 0.002}}}}\n"
    rest += "scenarios: {run: {speed: {driver: 700 rpm}, duration: 1 ms}}\n"
    model = loads_model(text_of_pair("{law: constant, value: 3e8 N/m}", beta=beta, motion="free", rest=rest))
    summary = section(pp.write_report(model, tmp_path / "page.html").read_text(encoding="utf-8"), "summary")
    if not beta:
        assert "axial mode" not in summary
        return
    found = re.search(
        r"Nearest critical speed: ([\d.]+) rpm of driver, [\d.]+ % above .*?\(mesh stage, (.*?),", summary
    )
    assert found, summary
    assert found[2] == "axial mode of driven"
    assert float(found[1]) == pytest.approx(712.0, rel=0.01)
    assert "No critical speed" not in summary
