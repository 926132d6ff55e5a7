# SPDX-License-Identifier: Apache-2.0
"""Files of turbulence that a model names: cut, of another kind, or too small for rotor and scenario."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pitchpoint.core.errors import ModelError
from pitchpoint.io.wind.turbsim import write_turbsim
from pitchpoint.io.yaml_model import load_model
from pitchpoint.model.remarks.wind_rotors import repeated_turbulence
from pitchpoint.model.wind.box import WindBox
from pitchpoint.model.wind.file_errors import WindFileError
from pitchpoint.model.wind.turbsim import read_turbsim, turbsim_extent

BOX = WindBox(
    velocity=np.full((20, 3, 3, 3), (8.0, 0.0, 0.0), np.float32),
    time_step=0.5,
    spacing=(60.0, 60.0),
    bottom=30.0,
    hub_height=90.0,
    mean_speed=10.0,
    with_mean=True,
)
MODEL = """\
bodies:
  hub: {inertia: 4e7 kg m^2, position: [-5 m, 0, 90 m], axes: {z: [1, 0, 0], x: [0, 0, 1]}}
winds:
  calm: {speed: 8 m/s, height: 90 m}
  rough: {box: wind.bts}
wind_rotors:
  rotor:
    hub: hub
    hub_radius: 2 m
    wind: calm
    blade:
      radius: [2 m, 50 m]
      chord: [3 m, 1 m]
      twist: [10 deg, 0 deg]
      airfoils: [plate, plate]
      polars: {plate: {angle: [-180 deg, 0, 180 deg], lift: [0, 0, 0], drag: [0.1, 0.1, 0.1]}}
scenarios:
  turbulent: {wind: rough, speed: {hub: 9 rpm}, duration: 8 s}
"""


@pytest.fixture
def told(tmp_path):
    def problems(box, text=MODEL):
        """Problems of a model with a box, without the directory."""
        (tmp_path / "model.yaml").write_text(text, encoding="utf-8")
        if isinstance(box, bytes):
            (tmp_path / "wind.bts").write_bytes(box)
        else:
            (tmp_path / "wind.bts").unlink(missing_ok=True)
            write_turbsim(tmp_path / "wind.bts", box)
        try:
            return load_model(tmp_path / "model.yaml")
        except ModelError as error:
            return [str(p).replace(f"{tmp_path}/", "") for p in error.problems]

    return problems


def test_a_box_that_contains_the_rotor(told):
    model = told(BOX)
    assert repeated_turbulence(model) == ()
    [remark] = repeated_turbulence(model.replace("scenarios.turbulent.duration", 30.0))
    assert "lasts 30 s, and the turbulence of wind rough repeats after 10 s" in remark


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        (
            {"spacing": (40.0, 40.0), "bottom": 50.0},
            "y -40 to 40 m, z to 130 m are covered by wind.bts, not the whole of wind_rotors.rotor (limit y "
            "-50 to 50 m, z to 140 m); make a larger one, such as with pitchpoint wind --height '90 m' "
            "--width '105 m'",
        ),
        ({"spacing": (40.0, 60.0)}, "y -40 to 40 m, z to 150 m are covered"),
        ({"bottom": 5.0}, "z to 125 m are covered"),
        ({"bottom": 5.0, "spacing": (60.0, 30.0)}, "z to 65 m are covered"),
        (
            {"periodic": False, "velocity": BOX.velocity[:12]},
            "-6.5 to -1 s are covered by wind.bts, which does not repeat (limit 0 to 8 s, the duration of "
            "scenario turbulent)",
        ),
    ],
)
def test_a_box_that_is_too_small(told, changes, words):
    """The rotor of 50 m radius, at 90 m, needs 140 m; a box that does not repeat begins 60 m upwind, so that
    the last of 5.5 s reaches the rotor, 5 m upwind, at 5.5 - 6.5 s."""
    [problem] = told(replace(BOX, **changes))
    assert problem.startswith("winds.rough.box (line 5): ")
    assert words in problem


def test_one_point_is_uniform_wind(told):
    assert told(replace(BOX, velocity=np.ascontiguousarray(BOX.velocity[:, :1, :1]))).winds["rough"].box


def test_the_extent_is_that_of_the_box(told, tmp_path):
    for periodic in (True, False):
        told(replace(BOX, periodic=periodic, time_step=40.0))
        extent, box = turbsim_extent(tmp_path / "wind.bts"), read_turbsim(tmp_path / "wind.bts")
        assert (extent.half_width, extent.top) == (box.y[-1], box.z[-1])
        assert (extent.duration, extent.periodic, extent.shift) == (box.duration, box.periodic, box.shift)


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "header: 0 bytes are there: the file is cut off (limit 70 bytes)"),
        (b"gears:\n" * 30, "byte 0: 25959 is not the number of this format (limit 7 or 8)"),
    ],
)
def test_files_of_another_kind(told, data, words):
    [problem] = told(data)
    assert problem.startswith(f"winds.rough.box (line 5): wind.bts: {words}")


def test_missing_files_with_the_nearest_name(told):
    [problem] = told(BOX, MODEL.replace("wind.bts", "wnd.bts"))
    assert "'wnd.bts' names a file that does not exist; did you mean wind.bts? file names are" in problem


@settings(max_examples=60, deadline=None)
@given(data=st.data())
def test_damaged_headers_are_refused_or_read(tmp_path_factory, data):
    """A header with any bytes changed, and any length: a sentence, or the extent of the box."""
    file = tmp_path_factory.mktemp("damaged") / "wind.bts"
    write_turbsim(file, BOX)
    whole = bytearray(file.read_bytes())
    for _ in range(data.draw(st.integers(0, 3))):
        whole[data.draw(st.integers(0, 69))] = data.draw(st.integers(0, 255))
    file.write_bytes(bytes(whole)[: data.draw(st.sampled_from([len(whole), len(whole), 69, 75, 500]))])
    try:
        extent = turbsim_extent(file)
    except WindFileError as error:
        assert str(file) in str(error)
        return
    try:
        box = read_turbsim(file)
    except WindFileError as error:
        assert "velocity" in str(error) or "scale" in str(error)  # values are read in a run only
    else:
        assert extent.duration == box.duration
