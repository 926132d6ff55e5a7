# SPDX-License-Identifier: Apache-2.0
"""Speed sweeps: step length, state carried, what is left after a failure or an interruption."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.status import INTERRUPTED, OK
from pitchpoint.sweep.speed import run_sweep, sweep_speed
from tests.support.machines import compiled

TRAIN = """\
gears:
  a: {number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  b: {number_of_teeth: 80, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  c: {number_of_teeth: 20, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  d: {number_of_teeth: 60, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  input: {gears: [a], motion: torsion, inertia: 0.0005 kg m^2}
  middle: {gears: [b, c], motion: torsion, inertia: 0.02 kg m^2}
  output: {gears: [d], motion: torsion, inertia: 0.02 kg m^2}
meshes:
  fast: {gears: [a, b], stiffness: {law: fourier, mean: 3e8 N/m, cosine: [-0.2]}, damper: {ratio: 0.05}}
  slow: {gears: [c, d], direction: 180 deg, stiffness: {law: fourier, mean: 3e8 N/m, cosine: [-0.2]},
         damper: {ratio: 0.05}}
loads:
  input: {body: input, torque: 20 N m}
  output: {body: output, torque: balance}
scenarios:
  coarse: {sweep: {body: output, mesh: slow, mesh_frequency: [100 Hz, 200 Hz], points: 3, direction: both,
                   settle_periods: 20, measure_periods: 20}}
  fine: {sweep: {body: output, mesh: slow, mesh_frequency: [100 Hz, 200 Hz], points: 3, direction: both,
                 settle_periods: 20, measure_periods: 20, steps_per_period: 20000}}
"""


def test_steps_are_short_enough_for_every_mesh():
    """The mesh that is not swept turns four times as fast and is what limits the step."""
    coarse, fine = (run_sweep(compiled(TRAIN, name)[1]) for name in ("coarse", "fine"))
    for one, other in zip(coarse.points, fine.points, strict=True):
        for mesh in ("fast", "slow"):
            found, expected = (p["channels"][f"deflection[{mesh}]"]["rms"] for p in (one, other))
            assert found == pytest.approx(expected, rel=2e-3)


def test_interruption_keeps_the_points_before_it():
    def stop(done, total, note=""):
        if done == 2:
            raise KeyboardInterrupt

    found = run_sweep(compiled(TRAIN, "coarse")[1], progress=stop)
    assert found.status == INTERRUPTED
    assert [p["mesh_frequency"] for p in found.points] == pytest.approx([100.0, 150.0])


def test_dataset_has_both_directions_on_one_grid():
    data = sweep_speed(compiled(TRAIN, "coarse")[1])
    assert data.attrs["status"] == OK
    assert list(data.direction.values) == ["up", "down"]
    np.testing.assert_allclose(data.mesh_frequency, [100.0, 150.0, 200.0])
    assert np.isfinite(data.deflection_rms).all()
    # no jump here: both ways give the same, the first point of all apart, which still carries the start
    np.testing.assert_allclose(data.deflection_rms[0, 1:], data.deflection_rms[1, 1:], rtol=1e-2)
