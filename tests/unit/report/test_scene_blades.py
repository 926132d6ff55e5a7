# SPDX-License-Identifier: Apache-2.0
"""Blades of wind turbines in scenes: shape from the aerodynamic file, on beams and on rigid bodies."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model
from pitchpoint.report.scene.rest import rest_scene
from tests.support.rotors import FOLDER


@pytest.fixture(scope="module")
def model():
    return load_model(FOLDER.parent / "model.yaml")


def solids(model):
    return {solid.name: solid for solid in rest_scene(model).solids}


@pytest.mark.parametrize("beams", [True, False])
def test_blades_have_their_chords_and_reach_to_the_tip(model, beams):
    """61.5 m from the root, 4.652 m at the widest station; the root is a cylinder of 3.542 m."""
    drawn = solids(model if beams else model.replace("wind_rotors.rotor.beams", ()))
    name = "blade_1" if beams else "rotor, blade 1"
    points = drawn[name].points
    rings = points.reshape(-1, 32, 3)
    widths = np.array([np.linalg.norm(r[:, None] - r[None], axis=-1).max() for r in rings])
    assert widths[0] == pytest.approx(3.542, rel=1e-3)
    assert widths.max() == pytest.approx(4.652, rel=2e-2)
    assert np.linalg.norm(rings[-1].mean(axis=0) - rings[0].mean(axis=0)) == pytest.approx(61.5, rel=1e-2)
    assert (drawn[name].blend is not None) == beams


def test_blades_have_no_steps(model):
    """From the root to the thin tip, neighbouring sections differ little in thickness and chord."""
    rings = solids(model)["blade_1"].points.reshape(-1, 32, 3)
    extents = np.array([np.linalg.svd(r - r.mean(axis=0), compute_uv=False) for r in rings])
    for size in extents[:-8, :2].T:
        assert (np.abs(np.diff(size)) / size[:-1]).max() < 0.15


def test_bodies_without_mass_at_the_ends_of_beams_are_not_drawn(model):
    names = set(solids(model))
    assert not names & {"tip_1", "root_1", "tower_top"}
    assert {"tower", "blade_2", "nacelle.cover", "hub.spinner"} <= names
