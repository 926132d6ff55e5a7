# SPDX-License-Identifier: Apache-2.0
"""Beams of which one end begins at rest on ground while the other turns: told, and only then."""

from __future__ import annotations

from pathlib import Path

import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.remarks.beams import ends_left_behind
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.system.compile import compile_model

TIP = "mass: 1 g, inertia_tensor: [1e-7, 1e-7, 1e-7, 0, 0, 0], position: [0.5, 0, 0]"
BLADE = f"""\
bodies:
  hub: {{mass: 1 kg, inertia: 0.01 kg m^2, position: [0, 0, 0]}}
  disc: {{mass: 1 kg, inertia: 0.01 kg m^2, transverse_inertia: 0.01 kg m^2, position: [0, 0, 0]}}
  tip: {{motion: free, {TIP}}}
joints:
  axle: {{type: revolute, bodies: [ground, hub], position: [0, 0, 0]}}
  seat: {{type: fixed, bodies: [hub, disc]}}
beams:
  blade: {{ends: [disc, tip], section: {{width: 40 mm, height: 8 mm}}, axis: [0, 1, 0], pieces: 2}}
scenarios:
  run: {{duration: 0.1 ms, step: 10 us, settle_time: 0 s}}
"""
CARRIED = BLADE.replace("motion: free, ", "").replace(
    "  seat:", "  held: {type: free, bodies: [disc, tip]}\n  seat:"
)
SPINNING = {
    "speed": "speed: {hub: 100 rpm}, ",
    "drive": "drive: {hub: {speed: 100 rpm}}, ",
    "formula": "drive: {axle.spin: {angle: 100 rpm*t}}, ",
    "table": "drive: {hub: {speed: {table: [[0 s, 100 rpm], [1 s, 0 rpm]]}}}, ",
    "hold": "speed: {hub: 100 rpm}, hold: [hub], ",
}
STILL = {
    "nothing": "",
    "ramp": "drive: {hub: {speed: {table: [[0 s, 0 rpm], [1 s, 100 rpm]]}}}, ",
    "swing": "drive: {hub: {angle: '0.1*cos(10 rad/s*t)'}}, ",
    "place": "drive: {hub: {angle: 10 deg}}, ",
}


def with_(scenario: str, text: str = BLADE) -> str:
    return text.replace("run: {", f"run: {{{scenario}")


@pytest.mark.parametrize("how", SPINNING)
def test_an_end_that_is_left_behind_is_told_with_its_line(how: str) -> None:
    (said,) = ends_left_behind(loads_model(with_(SPINNING[how])))
    assert said.startswith(
        "beams.blade (line 9): tip moves against ground (motion: free) and starts at rest while"
    )
    assert "disc moves in run" in said
    assert "{type: free, bodies: [disc, tip]}" in said


def test_a_rate_of_the_joint_counts() -> None:
    text = BLADE.replace("ground, hub], ", "ground, hub], speed: {spin: 100 rpm}, ")
    assert len(ends_left_behind(loads_model(text))) == 1
    turned = text.replace("ends: [disc, tip]", "ends: [tip, disc]")
    assert len(ends_left_behind(loads_model(turned))) == 1


def test_an_end_at_a_station_moves_with_the_body_that_carries_the_beam() -> None:
    spoke = "  spoke: {ends: [disc, far], section: {diameter: 10 mm}, axis: [0, 1, 0], pieces: 2}\n"
    far = "  far: {mass: 1 g, inertia_tensor: [1e-7, 1e-7, 1e-7, 0, 0, 0], position: [0.4, 0, 0]}\n"
    text = with_(SPINNING["speed"]).replace("ends: [disc, tip]", "ends: [spoke.2, tip]")
    text = text.replace("joints:\n", f"{far}joints:\n  at: {{type: free, bodies: [disc, far]}}\n")
    text = text.replace("beams:\n", f"beams:\n{spoke}")
    (said,) = ends_left_behind(loads_model(text))
    assert "while disc moves in run" in said


@pytest.mark.parametrize("how", STILL)
def test_what_begins_at_rest_needs_no_remark(how: str) -> None:
    assert ends_left_behind(loads_model(with_(STILL[how]))) == ()


def test_the_remedy_works() -> None:
    """Carried by the hub the tip begins with the speed of the hub, and nothing is said."""
    model = loads_model(with_(SPINNING["speed"], CARRIED))
    assert ends_left_behind(model) == ()
    start = prepare_start(compile_model(model, "run"), model.scenarios["run"])
    assert not [note for note in start.notes if "beams" in note]


@pytest.mark.filterwarnings("default::pitchpoint.core.errors.ValidityWarning")
def test_check_and_run_say_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "blade.yaml"
    file.write_text(with_(SPINNING["speed"]), encoding="utf-8")
    for command in (["check", str(file)], ["run", str(file), "-o", str(tmp_path / "out.h5")]):
        assert run_command(command) == 0
        shown = capsys.readouterr()
        assert (shown.out + shown.err).count("beams.blade (line 9)") == 1
