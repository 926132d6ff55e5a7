# SPDX-License-Identifier: Apache-2.0
"""Sweeps in the negative direction of rotation: those of the mirrored machine."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import ModelError
from pitchpoint.io.reading import open_result
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.operating_range import speed_range
from pitchpoint.solvers.sweep_speeds import at_one_speed
from pitchpoint.sweep.speed import run_sweep, sweep_speed
from pitchpoint.system.compile import compile_model

RPM = math.pi / 30.0
PAIR = """\
gears:
  a: {number_of_teeth: 25, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0.1,
      tooth_thickness_allowance: -60 um}
  b: {number_of_teeth: 57, normal_module: 3 mm, face_width: 30 mm, profile_shift_coefficient: 0.1,
      tooth_thickness_allowance: -60 um}
bodies:
  m: {gears: [a], inertia: 0.02 kg m^2}
  l: {gears: [b], inertia: 1.5 kg m^2}
meshes:
  s: {gears: [a, b], center_distance: 123.6 mm, stiffness: {law: din3990}, damping: {ratio: 0.05},
      friction: {mu: 0.06}}
loads:
  drv: {body: m, torque: balance}
  brk: {body: l, torque: LOAD N m}
scenarios:
  sw: {sweep: {body: m, speed: SPEEDS, points: 3, direction: both, settle_periods: 60, measure_periods: 25}}
"""
SIGNS = {"": ("[1500 rpm, 1800 rpm]", "250"), "-": ("[-1500 rpm, -1800 rpm]", "-250")}


def text_of(speeds: str, load: str) -> str:
    return PAIR.replace("SPEEDS", speeds).replace("LOAD", load)


def test_the_mirrored_machine_has_the_same_numbers() -> None:
    """Negative speeds and loads: the other flanks in work, opposite forces and torques, equal losses."""
    found = {
        sign: run_sweep(compile_model(loads_model(text_of(*given)), "sw")) for sign, given in SIGNS.items()
    }
    assert [p["speed"] / RPM for p in found["-"].points] == pytest.approx(
        [-1500.0, -1650.0, -1800.0, -1800.0, -1650.0, -1500.0]
    )
    for one, other in zip(found[""].points, found["-"].points, strict=True):
        assert other["direction"] == one["direction"]
        for key in ("mesh_frequency", "contact_loss_share"):
            assert other[key] == pytest.approx(one[key], rel=1e-9)
        assert other["deflection"]["rms"] == pytest.approx(one["deflection"]["rms"], rel=1e-6)
        assert other["mesh_force"]["min"] == pytest.approx(-one["mesh_force"]["max"], rel=1e-6)
        for name in ("torque[drv]", "speed[l]"):
            mean, mirrored = (p["channels"][name]["mean"] for p in (one, other))
            assert mirrored == pytest.approx(-mean, rel=1e-6)
        assert other["channels"]["friction_power[s]"]["mean"] == pytest.approx(
            one["channels"]["friction_power[s]"]["mean"], rel=1e-6
        )
    assert found["-"].notes == found[""].notes


def test_the_load_that_brakes_one_direction_drives_the_other() -> None:
    """Losses increase the torque of the pinion if it drives, and decrease it if it is driven."""
    torques = {}
    for sign, (speeds, _) in SIGNS.items():
        data = sweep_speed(compile_model(loads_model(text_of(speeds, "-250")), "sw"))
        assert np.all(np.sign(data.speed) == (-1.0 if sign else 1.0))
        torques[sign] = float(data["torque[drv]"][0, -1, 0])
    ideal = -250.0 * 25.0 / 57.0
    assert torques["-"] < ideal < torques[""] < 0.0
    assert 0.5 * (torques["-"] + torques[""]) == pytest.approx(ideal, rel=1e-3)


def test_tables_and_files_have_the_speeds_as_given(tmp_path, capsys) -> None:
    file, target = tmp_path / "m.yaml", tmp_path / "s.h5"
    file.write_text(text_of(*SIGNS["-"]), encoding="utf-8")
    assert run_command(["sweep", str(file), "-o", str(target)]) == 0
    shown = capsys.readouterr().out
    assert "up, -1500 rpm to -1800 rpm" in shown
    assert "down, -1800 rpm to -1500 rpm" in shown
    data = open_result(target)
    assert data.speed.values / RPM == pytest.approx([-1500.0, -1650.0, -1800.0])
    assert np.all(np.diff(data.mesh_frequency) > 0.0)


def test_analyses_of_one_state_have_the_speed_of_lowest_magnitude() -> None:
    model = loads_model(text_of(*SIGNS["-"]))
    system, scenario = compile_model(model, "sw"), model.scenarios["sw"]
    _, at, words = at_one_speed(system, scenario)
    assert at.speed["m"] == pytest.approx(-1500.0 * RPM)
    assert words == "-1500 rpm of m, the lowest speed of the sweep"
    assert speed_range(system, scenario, "m") == pytest.approx((1500.0 * RPM, 1800.0 * RPM))


@pytest.mark.parametrize(
    ("speeds", "message"),
    [
        ("[-1800 rpm, 1500 rpm]", "-1800 rpm to 1500 rpm reverses the rotation.*both > 0 or both < 0.*one"),
        ("[0 rpm, 1500 rpm]", "0 rpm to 1500 rpm contains zero"),
        ("[-1800 rpm, -1500 rpm]", "does not increase in magnitude; write the lowest magnitude first"),
        ("[1800 rpm, 1500 rpm]", "does not increase in magnitude"),
    ],
)
def test_ranges_that_are_none(speeds: str, message: str) -> None:
    with pytest.raises(ModelError, match=message):
        loads_model(text_of(speeds, "250"))


def test_a_speed_beside_a_sweep_is_told_where_the_direction_goes() -> None:
    from pitchpoint.model.remarks.collect import remarks_of

    text = text_of(*SIGNS[""]).replace("sw: {", "sw: {speed: {m: -1500 rpm}, ")
    told = [str(one) for one in remarks_of(loads_model(text))]
    assert any("the sign of sweep.speed gives the direction of rotation" in one for one in told)
