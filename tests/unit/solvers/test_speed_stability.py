# SPDX-License-Identifier: Apache-2.0
"""Unstable operating points: slope and growth in closed form, and the sentence where the speed runs away."""

from __future__ import annotations

import json

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import split_notes
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.speed_drift import instability
from pitchpoint.solvers.time import solve_time
from pitchpoint.sweep.speed import run_sweep
from pitchpoint.system.compile import compile_model

RPM = np.pi / 30
RATIO = 24 / 49
INERTIA = 4e-2 + 2e-3 / RATIO**2
"""Of both bodies at the output [kg m^2]."""
OUTPUT = 1500.0 * RPM * RATIO
"""Speed of the output [rad/s]; its sense is negative."""
SQUARE = "-60 N m*(speed/(77 rad/s))^2"
"""Drives the output in the sense of its rotation, more so the faster it rotates."""
POWER = "-4.6 kW*speed/(speed^2 + 1 rad^2/s^2)"
"""Brakes with constant power except at the lowest speeds."""
SLOPE = 2.0 * 60.0 * OUTPUT / 77.0**2


def gearbox(fan: str, more: str = "", drive: str = "balance", friction: str = "", run: str = "") -> str:
    gear = "normal_module: 2 mm, face_width: 20 mm"
    return f"""
gears:
  p: {{number_of_teeth: 24, {gear}, profile_shift_coefficient: 0.2}}
  w: {{number_of_teeth: 49, {gear}, profile_shift_coefficient: 0}}
bodies:
  i: {{gears: [p], inertia: 2.0e-3 kg m^2}}
  o: {{gears: [w], inertia: 4.0e-2 kg m^2}}
meshes:
  stage: {{gears: [p, w], center_distance: 73.5 mm, damper: {{ratio: 0.05}}{friction}}}
loads:
  d: {{body: i, torque: {drive}}}
  fan: {{body: o, torque: "{fan}"}}
{more}
scenarios:
  st: {{speed: {{i: 1500 rpm}}, duration: 0.4 s, step: 20 us{run}}}
  sw: {{sweep: {{body: i, speed: [1000 rpm, 2000 rpm], points: 2, settle_periods: 100, measure_periods: 49}}}}
"""


def found_in(text: str):
    model = loads_model(text)
    scenario = model.scenarios["st"]
    return instability(prepare_start(compile_model(model, scenario), scenario))


@pytest.mark.parametrize(
    ("fan", "slope"),
    [
        (SQUARE, SLOPE),
        # load and slope have a factor of up to 1.9, also at the start
        (f"{SQUARE}*(1 + 0.9*cos(3*angle))", SLOPE),
        # constant power: the torque falls with the speed, and so does the brake
        ("-4.6 kW/speed", 4600.0 / OUTPUT**2),
        (POWER, 4600.0 * (OUTPUT**2 - 1.0) / (OUTPUT**2 + 1.0) ** 2),
    ],
)
@pytest.mark.parametrize("friction", ["", ", friction: {mu: 0.08}"])
def test_slope_and_growth_are_those_of_the_rigid_train(fan: str, slope: float, friction: str) -> None:
    found = found_in(gearbox(fan, friction=friction))
    assert found is not None
    assert (found.load, found.body) == ("fan", "o")
    assert found.speed == pytest.approx(-OUTPUT, rel=1e-12)
    assert found.slope == pytest.approx(slope, rel=1e-6)
    assert found.rate == pytest.approx(slope / INERTIA, rel=1e-6)


def brake(share: float) -> str:
    """A brake on the input with a share of the slope of the fan."""
    return f'  brake: {{body: i, torque: "-{share * SLOPE * RATIO**2} N m s/rad*speed"}}'


def test_a_brake_with_more_slope_makes_it_stable() -> None:
    """The slope of the input counts with the square of the ratio."""
    found = found_in(gearbox(SQUARE, brake(0.99)))
    assert found is not None
    assert found.load == "fan"
    assert found.slope == pytest.approx(0.01 * SLOPE, rel=1e-6)
    assert found_in(gearbox(SQUARE, brake(1.01))) is None


STABLE = {
    "a fan": gearbox(SQUARE.replace("-60", "60")),
    "a constant torque": gearbox("30 N m"),
    "over the angle": gearbox("30 N m*(1 + 0.1*sin(angle))"),
    "driven": gearbox(SQUARE).replace("speed: {i: 1500 rpm}", "drive: {i: {speed: 1500 rpm}}"),
    "held": gearbox(SQUARE, run=", hold: [i]"),
    "a motor that falls with the speed": gearbox(
        SQUARE, drive=f'"-{30.0 * OUTPUT / 76.94} N m - 0.5 N m s/rad*(speed - 1500 rpm)"'
    ),
    "at rest": gearbox(SQUARE).replace("1500 rpm", "0 rpm"),
}


@pytest.mark.parametrize("name", STABLE)
def test_stable_operating_points(name: str) -> None:
    assert found_in(STABLE[name]) is None


SENTENCE = "the operating point, o at -734.7 rpm, is unstable: because of fan, the sum of the torques rises"


def test_a_run_that_leaves_an_unstable_point_says_so() -> None:
    text = gearbox(POWER).replace("0.4 s", "1 s")
    found = solve_time(compile_model(loads_model(text), "st"))
    said = [one for one in split_notes(found.attrs["notes"]) if "of the scenario" in one]
    assert len(said) == 1
    assert SENTENCE in said[0]
    assert "a load whose braking torque rises with the speed" in said[0]


def test_a_failed_sweep_names_the_unstable_point() -> None:
    """The backlash that closes after the start carries the speed away."""
    text = gearbox(f"{SQUARE}*(1 - 0.05*sin(3*angle))").replace("points: 2", "points: 3")
    text = text.replace("sw: {sweep", "sw: {start: assembled, sweep")
    model = loads_model(text)
    found = run_sweep(compile_model(model, "sw"), model.scenarios["sw"])
    assert "the mean speed left the speed of the sweep at 1000 rpm of i (up)" in found.sentence
    assert SENTENCE.replace("-734.7", "-489.8") in found.sentence
    assert "add a controller" in found.sentence


def test_check_remarks_on_it(tmp_path, capsys) -> None:
    path = tmp_path / "model.yaml"
    path.write_text(gearbox(SQUARE), encoding="utf-8")
    assert run_command(["check", str(path), "--balance"]) == 0
    assert SENTENCE in " ".join(capsys.readouterr().out.split())
    assert run_command(["check", str(path), "--balance", "--json"]) == 0
    notes = json.loads(capsys.readouterr().out)["balance"]["scenarios"]["st"]["notes"]
    assert any(SENTENCE in one for one in notes)
