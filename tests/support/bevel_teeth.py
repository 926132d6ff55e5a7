# SPDX-License-Identifier: Apache-2.0
"""Bevel gears for tests: how far points lie inside a tooth, and a pair in a model file."""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.geometry.bevel.tooth import bevel_tooth

PAIR = """\
title: bevel stage
bevel_gears:
  pinion: {number_of_teeth: 17, outer_transverse_module: 3 mm, mate_teeth: 31, shaft_angle: 75 deg,
    spiral_angle: 30 deg, hand: left, face_width: 14 mm, bore_diameter: 12 mm}
  wheel: {number_of_teeth: 31, outer_transverse_module: 3 mm, mate_teeth: 17, shaft_angle: 75 deg,
    spiral_angle: 30 deg, hand: right, face_width: 14 mm, bore_diameter: 25 mm, opens: -z}
bodies:
  one: {bevel_gears: [pinion], position: [10 mm, 20 mm, 30 mm]}
  two: {bevel_gears: {wheel: 80 mm}, position: [87.274066 mm, 20 mm, 50.705524 mm],
    axes: {z: [-0.9659258262890683, 0, -0.25881904510252074], x: [0, 1, 0]}}
bevel_meshes:
  stage: {gears: [pinion, wheel], backlash: {normal: 200 um}}
"""
"""The wheel's cone opens towards -z of its body, whose origin lies 80 mm from the apex at [10, 20, 30] mm."""


RUN = """\
loads:
  drive: {body: one, torque: %s N m}
  brake: {body: two, torque: balance}
scenarios:
  turn: {speed: {one: 300 rpm}, duration: 20 ms, sample_rate: 10 kHz}
"""
"""What makes it run, with the torque of the drive left open [N m]."""
EDGE = 1e-7
"""Angle by which numbers of a page may stand beside an edge [rad]."""


def angles_inside(gear, angle, points):
    """Angles by which points in the frame of a gear lie inside its teeth [rad]; below 0 outside of them.

    Points beyond the tip cone are outside by 1, points below the root cone are inside by its depth.
    """
    tooth = bevel_tooth(gear)
    R = np.linalg.norm(points, axis=1)
    polar = np.arccos(points[:, 2] / R)
    azimuth = np.arctan2(points[:, 1], points[:, 0]) - angle - gear.spiral_rate * np.log(R / gear.R_m)
    azimuth = np.abs(np.remainder(azimuth + math.pi / gear.z, 2.0 * math.pi / gear.z) - math.pi / gear.z)
    low, half = tooth.flank(3, 4001)
    form = tooth.involute(np.array([tooth.sigma_form]))[0][0]
    sigma = np.array([gear.sigma_at(p) for p in np.maximum(polar, form)])
    half = np.where(polar >= form, tooth.involute(sigma)[1], np.interp(polar, low, half))
    depth = np.where(polar > gear.delta_a + EDGE, -1.0, half - azimuth)
    return np.where(polar < gear.delta_f, gear.delta_f - polar, depth)
