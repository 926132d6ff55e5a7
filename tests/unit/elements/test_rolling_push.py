# SPDX-License-Identifier: Apache-2.0
"""Forces of rolling elements without slopes against those with them."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model

MODEL = """\
bodies:
  shaft: {mass: 2 kg, inertia: 1e-3 kg m^2, transverse_inertia: 5e-3 kg m^2, motion: free}
rolling_bearings:
  one: {ends: [shaft, ground], elements: 9, element_diameter: 8 mm, pitch_diameter: 40 mm, damping: 0.7, KIND}
"""
KINDS = {
    "grooves": "grooves: [0.52, 0.53], clearance: -6 um",
    "grooves, angle": "grooves: [0.52, 0.53], contact_angle: 15 deg, clearance: 4 um",
    "grooves passed": "grooves: [0.52, 0.53], contact_angle: 60 deg, clearance: 398 um, "
    "preload_distance: 80 um",
    "constant angle": "stiffness: 1e10, contact_angle: -20 deg",
    "rollers": "type: roller, stiffness: 1e9, clearance: -2 um",
    "rollers in slices": "type: roller, effective_length: 9 mm, contact_angle: 15 deg, clearance: -2 um",
    "floating": "type: roller, effective_length: 9 mm, contact_angle: 15 deg, "
    "axial_force_absorption: no_direction",
    "preload": "grooves: [0.52, 0.53], contact_angle: 15 deg, preload_distance: 5 um",
}


@pytest.mark.nojit
@pytest.mark.parametrize("kind", KINDS)
def test_with_and_without_slopes(kind: str) -> None:
    check(MODEL.replace("KIND", KINDS[kind]))


@pytest.mark.nojit
def test_two_rows_with_and_without_slopes() -> None:
    check(
        MODEL.partition("  one")[0]
        + "  one: {body: shaft, designation: 22208, damping: 0.7, clearance: -5 um, slices: 5}\n"
    )


def check(text: str) -> None:
    """Ten states, displacements of 10 um, tilts of 1 mrad, all azimuths; rounding is all that differs."""
    system = compile_model(loads_model(text))
    state = system.initial_state()
    rng = np.random.default_rng(7)
    evaluate.prepare(system)
    loaded = 0
    for _ in range(10):
        state.q[:] = 1e-5 * rng.normal(size=6)
        state.q[3:5] *= 100.0
        state.q[5] = rng.uniform(-3.0, 3.0)
        state.v[:] = 0.1 * rng.normal(size=6)
        evaluate.residual(system, state)
        bare = system.workspace.R.copy()
        evaluate.matrix(system, state, 0.0, 0.0, 1.0)
        whole = system.workspace.R.copy()
        np.testing.assert_allclose(bare, whole, rtol=1e-11, atol=1e-11 * np.abs(whole).max())
        loaded += bool(np.abs(whole[:3]).max() > 1.0)
    assert loaded >= 5
