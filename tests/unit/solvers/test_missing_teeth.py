# SPDX-License-Identifier: Apache-2.0
"""Slow rolls and equilibria where a tooth is missing: the next pair carries, or it is said why none does."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import SolverError
from pitchpoint.io.results import open_result
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.quasistatic.roll import roll_through
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from tests.validation.test_flank_deviations import teeth_in_contact

TEXT = """\
gears:
  g1:
    number_of_teeth: 21
    normal_module: 3 mm
    face_width: {width} mm
    profile_shift_coefficient: 0{one}
    faults: {{gone: {{type: broken_tooth, tooth: 4}}}}
  g2: {{number_of_teeth: 34, normal_module: 3 mm, face_width: {width} mm, profile_shift_coefficient: 0{two}}}
bodies: {{driver: {{gears: [g1]}}, driven: {{gears: [g2]}}}}
meshes:
  stage: {{gears: [g1, g2], center_distance: {distance} mm, stiffness: {{law: {law}}}}}
loads:
  motor: {{body: driver, torque: balance}}
  brake: {{body: driven, torque: 200 N m}}
scenarios:
  roll: {{quasi_static: {{points: 24, periods: 21}}}}
  begin: {{start: assembled, speed: {{driver: 600 rpm}}, duration: 5 ms, step: 5 us}}
"""
SPUR = dict(width=20, one="", two="", distance=82.7)
#: Overlap ratio above two: around a missing tooth other pairs always carry.
HELICAL = dict(
    width=60,
    one="\n    helix_angle: 20 deg\n    hand: right",
    two=", helix_angle: 20 deg, hand: left",
    distance=88.0,
)
WORDS = (
    r"no tooth pair carries load in the mesh stage in this position, where gears\.g1\.faults\.gone \(line 7\)"
)


def model(kind, law="din3990"):
    return loads_model(TEXT.format(**kind, law=law))


@pytest.mark.parametrize("law", ["din3990", "hertz", "din3990, tip_relief_factor: 0.5"])
def test_a_roll_stops_where_only_the_missing_tooth_would_carry(law):
    """At the first place of which the angles of the teeth say so; what was rolled before is kept."""
    machine = model(SPUR, law)
    system = compile_model(machine)
    roll = roll_through(system, "roll")
    assert roll.status != 0 and "no tooth pair carries load" in roll.sentence and "(line 7)" in roll.sentence
    assert "(after " in roll.sentence and 0 < len(roll.position) < 505
    angles = roll.rows[:, system.layout.channel("angle[driver]")]
    step = angles[1] - angles[0]
    assert all(any(p[0] != 4 for p in teeth_in_contact(machine, a)) for a in angles)
    # deflected pairs stay in contact a little longer, on the ramps of the relief too
    behind = [teeth_in_contact(machine, angles[-1] + k * step) for k in (1, 2)]
    assert all(p[0] == 4 for p in behind[1]) and len(behind[1]) == 1
    assert not roll.notes or "flank penetration reaches" not in roll.notes[-1]


def test_where_other_pairs_overlap_the_roll_goes_on():
    system = compile_model(model(HELICAL))
    roll = roll_through(system, "roll")
    assert roll.status == 1, roll.sentence
    force = roll.rows[:, system.layout.channel("mesh_force[stage]")]
    deflection = roll.rows[:, system.layout.channel("deflection[stage]")]
    assert force == pytest.approx(force[0], rel=1e-6)
    # the missing tooth leaves more to the others, and no less than half of the stiffness
    carried = deflection - 0.5 * model(HELICAL).backlash("stage")
    assert 1.2 < carried.max() / np.median(carried) < 2.0


def test_an_equilibrium_in_the_gap_says_what_is_missing():
    machine = model(SPUR)
    system = compile_model(machine)
    inside = [
        a
        for a in np.linspace(-2.0 * math.pi, 0.0, 500)
        if [p[0] for p in teeth_in_contact(machine, a)] == [4]
    ]
    middle = float(np.median(inside))
    with pytest.raises(SolverError, match=WORDS):
        solve_equilibrium(system, {"driver": middle})
    whole = compile_model(machine.replace("gears.g1.faults.gone.severity", 0.0))
    assert float(solve_equilibrium(whole, {"driver": middle})["mesh_force[stage]"]) > 0.0


def test_a_run_over_time_goes_through_the_gap():
    """Begun assembled, as the sentence says; the turn lasts 100 ms, tooth 4 comes after four pitches."""
    machine = model(SPUR).replace_all(
        {
            "scenarios.begin.duration": 0.1,
            "loads.motor.torque": 200.0 * 21 / 34,
            "meshes.stage.damper": {"ratio": 0.1},
        }
    )
    data = solve_time(compile_model(machine, "begin"))
    state = data["contact_state[stage]"].values
    assert (state == 0.0).any() and state[-1] == 1.0


def test_the_command_keeps_the_part_and_exits_3(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, out = tmp_path / "gone.yaml", tmp_path / "out.h5"
    file.write_text(TEXT.format(**SPUR, law="din3990"), encoding="utf-8")
    assert run_command(["run", str(file), "-s", "roll", "-o", str(out), "--quiet"]) == 3
    assert "no tooth pair carries load in the mesh stage" in capsys.readouterr().err
    with open_result(out) as data:
        assert 0 < data.sizes["mesh_phase_position"] < 505
        assert np.isfinite(data["deflection[stage]"].values).all()


BEVEL = """\
bevel_gears:
  p: {number_of_teeth: 21, mate_teeth: 34, outer_transverse_module: 3 mm, face_width: 18 mm, faults: {FAULT}}
  w: {number_of_teeth: 34, mate_teeth: 21, outer_transverse_module: 3 mm, face_width: 18 mm}
bodies:
  driver: {bevel_gears: [p], position: [0, 0, 0]}
  driven: {bevel_gears: [w], position: [0, 0, 0], axes: {z: [1, 0, 0], x: [0, 1, 0]}}
bevel_meshes: {stage: {gears: [p, w], backlash: {normal: 50 um}}}
loads: {motor: {body: driver, torque: balance}, brake: {body: driven, torque: 100 N m}}
scenarios: {roll: {quasi_static: {points: 24, periods: 21}}}
"""


def test_a_roll_of_bevel_gears_names_the_tooth_that_is_missing():
    text = BEVEL.replace("FAULT", "gone: {type: broken_tooth, tooth: 4}")
    roll = roll_through(compile_model(loads_model(text)), "roll")
    assert roll.status != 0 and "where bevel_gears.p.faults.gone (line 2) leaves a gap" in roll.sentence
    assert 0 < len(roll.position) < 505


@pytest.mark.parametrize("amount", [12e-6, -12e-6])
def test_a_displaced_tooth_of_a_bevel_gear_is_the_transmission_error_without_load(amount):
    """One that stands ahead carries alone while it is in mesh: a cos(alpha) between the largest and the
    smallest error; one behind leaves a step of as much only where it is alone, within the contact ratio."""
    text = BEVEL.replace("FAULT", f"late: {{type: pitch_error, tooth: 4, amount: {amount} m}}")
    system = compile_model(loads_model(text))
    roll = roll_through(system, "roll")
    error = roll.meshes["stage"].unloaded
    force = roll.rows[:, system.layout.channel("mesh_force[stage]")]
    eps = system.model.bevel_pairs["stage"].eps_alpha
    full = 12e-6 * math.cos(math.radians(20.0))
    assert np.ptp(error) == pytest.approx(full, rel=1e-6)
    away = abs(error - np.median(error)) > 0.5 * full
    # 24 points per pitch; counter-clockwise is ahead where front flanks carry
    first = eps if amount * force.mean() > 0.0 else 2.0 - eps
    assert away.sum() / 24.0 == pytest.approx(first, abs=1.5 / 24.0)
