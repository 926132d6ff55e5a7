# SPDX-License-Identifier: Apache-2.0
"""Bevel gears of a scene: where the file puts them, with their mass and their backlash."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from pitchpoint.geometry.bevel.blank import bevel_mass
from pitchpoint.geometry.bevel.tooth import placed
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.bevel_places import apex_of
from pitchpoint.model.frames import body_frame
from pitchpoint.report.scene.bevel_gears import bevel_axes
from pitchpoint.report.scene.build import scene_of
from pitchpoint.report.scene.solids import drawn_allowances
from pitchpoint.viz.scene.file import scene_texts
from tests.support.bevel_teeth import PAIR, angles_inside
from tests.support.scene_reader import Seen


@pytest.fixture(scope="module")
def model():
    return loads_model(PAIR)


@pytest.fixture(scope="module")
def found(model):
    return Seen(*scene_texts(scene_of(model)))


def drawn(model, name):
    """Apex and axes of a drawn gear in the world, and its teeth with the backlash of the mesh."""
    axes = body_frame(model, model.body_of(name))[1]
    gear = model.bevel_gears[name]
    thin = replace(gear.geometry, thickness_allowance=-drawn_allowances(model)[name])
    return apex_of(model, name)[0], axes @ bevel_axes(gear, model.bevel_angles[name]), thin


@pytest.mark.parametrize("name", ["pinion", "wheel"])
def test_a_bevel_gear_is_where_the_file_puts_it_and_weighs_what_it_should(model, found, name):
    """Its apex is that of the file; circles are polygons of 51 and 62 corners, which lack 0.25 % at most."""
    points = found.placed(name, 0)
    gear = model.bevel_gears[name].geometry
    apex, axes, thin = drawn(model, name)
    own = (points - apex) @ axes
    farthest = math.hypot(*model.bevel_gears[name].blank.back)
    assert np.linalg.norm(own, axis=1).max() == pytest.approx(farthest, rel=1e-6)
    assert np.hypot(own[:, 0], own[:, 1]).max() == pytest.approx(0.5 * gear.d_ae, rel=1e-6)
    corners = found.mesh(name)[0][found.mesh(name)[1]]
    volume = np.einsum("ni,ni->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6.0
    bore = model.bevel_gears[name].bore_diameter
    assert volume == pytest.approx(bevel_mass(thin, 1.0, bore_diameter=bore).mass, rel=2.5e-3)


def test_drawn_teeth_stand_apart_by_half_of_the_backlash_on_both_sides(model, found):
    """From one flank to the other it is σ_j / 2 in the plane of action, or that over sin δ_b as an angle."""
    pair = model.bevel_pairs["stage"]
    sigma_j = 200e-6 / math.cos(pair.beta_b) / pair.R_m
    for name, mate in (("pinion", "wheel"), ("wheel", "pinion")):
        apex, axes, thin = drawn(model, mate)
        points = (found.placed(name, 0) - apex) @ axes
        R = np.linalg.norm(points, axis=1)
        face = (thin.R_i < R) & (thin.R_e > R) & (points[:, 2] > 0.0)
        nearest = angles_inside(thin, 0.0, points[face]).max()
        # corners stand up to a tenth of the gap next to the contact lines
        half = 0.5 * sigma_j / math.sin(thin.delta_b)
        assert -1.1 * half < nearest < -half * (1.0 - 1e-6)


def test_tooth_0_stands_at_its_angle(model, found):
    """Tip of tooth 0 in the middle of the face, from the x axis of the body about its z axis."""
    for name in ("pinion", "wheel"):
        apex, axes, thin = drawn(model, name)
        angle, gear = model.bevel_angles[name], model.bevel_gears[name]
        tip = placed(thin, np.array([thin.delta_a]), np.array([0.0]), thin.R_m)[0]
        body = body_frame(model, model.body_of(name))[1]
        x, y, z = body.T @ axes @ tip
        assert math.remainder(math.atan2(y, x) - angle, math.tau) == pytest.approx(0.0, abs=1e-12)
        assert z * gear.direction > 0.0
        assert np.min(np.linalg.norm((found.placed(name, 0) - apex) @ axes - tip, axis=1)) < 1e-3
