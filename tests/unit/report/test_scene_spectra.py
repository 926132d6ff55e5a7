# SPDX-License-Identifier: Apache-2.0
"""Spectra of a scene: orders of shafts whose speed changes, maps over time."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.scene.spectra import scene_spectra
from pitchpoint.viz.scene.entries import map_levels

MODEL = """
gears:
  pinion: {number_of_teeth: 23, normal_module: 2 mm, face_width: 20 mm}
  wheel: {number_of_teeth: 41, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies: {pinion: {gears: [pinion]}, second: {gears: [wheel]}}
meshes: {stage: {gears: [pinion, wheel], center_distance: 64 mm}}
"""
TIME = np.arange(20_001) / 2000.0


def record(angle, values, name="transmission_error[stage]", body="pinion"):
    return xr.Dataset(
        {name: ("time", values, {"units": "m"}), f"angle[{body}]": ("time", angle, {"units": "rad"})},
        coords={"time": TIME},
    )


@pytest.fixture(scope="module")
def model():
    return loads_model(MODEL)


def test_orders_stand_still_in_a_run_up(model):
    """Amplitude and order of the mesh, 23 of the pinion, whatever the speed; its frequency sweeps."""
    angle = 2.0 * np.pi * (1.0 * TIME + 0.1 * TIME**2)
    spectra, maps = scene_spectra(model, record(angle, 3e-6 * np.cos(23 * angle)))
    by = {s.of: s for s in spectra}
    assert set(by) == {"", "pinion"}
    orders = by["pinion"]
    assert orders.lines[np.argmax(orders.amplitude)] == pytest.approx(23.0, abs=1e-9)
    assert orders.amplitude.max() == pytest.approx(3e-6, rel=1e-3)
    assert by[""].amplitude.max() < 0.5 * 3e-6
    (found,) = maps
    assert found.of == "pinion" and found.times[0] < 1.0 and found.times[-1] > 9.0
    step = found.lines[1] - found.lines[0]
    largest = found.lines[np.argmax(found.amplitude, axis=1)]
    assert np.abs(largest - 23.0).max() <= step
    assert found.amplitude.max(axis=1) == pytest.approx(3e-6, rel=5e-3)


@pytest.mark.parametrize("angle", [np.sin(TIME), 0.4 * np.pi * TIME / TIME[-1]], ids=["back", "short"])
def test_a_shaft_that_turns_back_or_hardly_turns_has_no_orders(model, angle):
    """The map is then over frequencies, with the line where it is."""
    spectra, (found,) = scene_spectra(model, record(angle, np.cos(2 * np.pi * 100.0 * TIME)))
    assert [s.of for s in spectra] == [""] and found.of == ""
    assert found.lines[np.argmax(found.amplitude.max(axis=0))] == pytest.approx(100.0, abs=8.0)


def test_a_quarter_turn_has_orders_and_two_turns_have_a_map_over_them(model):
    """The same turns as in reports; a map over frequencies replaces that of too short a record."""
    for turns, lines, drawn in ((0.24, [""], ""), (1.2, ["", "pinion"], ""), (2.0, ["", "pinion"], "pinion")):
        angle = 2.0 * np.pi * turns * TIME / TIME[-1]
        spectra, (found,) = scene_spectra(model, record(angle, np.cos(23 * angle)))
        assert [s.of for s in spectra] == lines and found.of == drawn, turns


def test_levels_of_a_map_are_decibels_below_the_largest():
    """Half an amplitude is 6.02 dB, 19 of the 255 levels that make 80 dB."""
    assert map_levels(np.array([[2.0, 1.0], [2e-4, 0.0]])).tolist() == [[255, 236], [0, 0]]
    assert map_levels(np.zeros((2, 2))).tolist() == [[0, 0], [0, 0]]


def test_a_record_says_how_far_apart_its_lines_are(model):
    """One in 10 s; one in 1.25 turns; as many lines as are kept, the one where the mesh is among them."""
    angle = 2.0 * np.pi * 1.25 * TIME / TIME[-1]
    spectra, _ = scene_spectra(model, record(angle, np.cos(23 * angle)))
    hertz, orders = spectra
    assert hertz.resolution == pytest.approx(0.1, rel=1e-4) and hertz.lines.size <= 1500 < 0.5 * TIME.size
    assert orders.resolution == pytest.approx(1.0 / 1.25, rel=1e-2)
    mesh = orders.lines[np.argmax(orders.amplitude)]
    assert abs(mesh - 23.0) <= 0.5 * orders.resolution < abs(mesh + orders.resolution - 23.0)


def test_what_only_rounding_changes_has_no_spectrum(model):
    """A force of 1 kN ± 1 N, one of 0 ± 1e-7 N next to it, and a transmission error that alone is small."""
    wave = np.cos(2 * np.pi * 100.0 * TIME)
    force = {"bearing_force[a.fx]": 1e3 + wave, "bearing_force[a.fz]": 1e-7 * wave}
    result = record(2 * np.pi * TIME, 1e-10 * wave).assign(
        {name: ("time", values, {"units": "N"}) for name, values in force.items()}
    )
    spectra, _ = scene_spectra(model, result)
    assert {s.channel for s in spectra} == {"transmission_error[stage]", "bearing_force[a.fx]"}
