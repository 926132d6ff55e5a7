# SPDX-License-Identifier: Apache-2.0
"""Speed sweeps: step length, state carried, what is left after a failure or an interruption."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.status import INTERRUPTED, OK
from pitchpoint.io.container import Header
from pitchpoint.io.reading import open_result
from pitchpoint.io.sweep_store import SweepWriter, read_sweep
from pitchpoint.sweep.speed import run_sweep, sweep_speed
from tests.support.machines import compiled
from tests.support.model_files import TORSIONAL_PAIR

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
                 settle_periods: 20, measure_periods: 20, steps_per_period: 10000}}
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


PLANAR = (
    TRAIN.replace("motion: torsion", "motion: planar, mass: 5 kg")
    .replace(
        "loads:",
        "bearings:\n"
        + "".join(
            f"  b_{b}: {{body: {b}, stiffness: {{radial: 2e8 N/m}}}}\n" for b in ("input", "middle", "output")
        )
        + "loads:",
    )
    .replace("settle_periods: 20, measure_periods: 20", "settle_periods: 2, measure_periods: 4")
)


def test_the_dataset_and_the_file_have_the_same_channels_and_jumps(tmp_path):
    """Every channel with its statistics, the mesh that is not swept and the bearings included."""
    system = compiled(PLANAR, "coarse")[1]
    found, data = run_sweep(system), sweep_speed(system)
    force = data["bearing_force[b_middle.fx]"]
    assert force.dims == ("direction", "mesh_frequency", "statistic")
    for p in found.points:
        at = {"direction": p["direction"], "mesh_frequency": p["mesh_frequency"]}
        for name in ("bearing_force[b_middle.fx]", "deflection[fast]", "displacement[input.y]"):
            row = [p["channels"][name][s] for s in ("mean", "rms", "min", "max")]
            assert data[name].sel(at).values == pytest.approx(row, rel=1e-15)
            assert row[2] < row[0] < row[3]
    np.testing.assert_array_equal(data["deflection[slow]"].sel(statistic="rms"), data["deflection_rms"])
    path = tmp_path / "sweep.h5"
    channels = [(c.name, c.unit, c.long_name) for c in system.layout.channels]
    grid = data.mesh_frequency.values
    with SweepWriter(path, Header("sweep"), "slow", ["up", "down"], grid / 100.0, grid, channels) as writer:
        for p in found.points:
            writer.put(p["direction"], int(np.argmin(np.abs(grid - p["mesh_frequency"]))), p)
        writer.put_jumps(found.jumps)
    with open_result(path) as kept:
        for c in system.layout.channels:
            np.testing.assert_array_equal(kept[c.name], data[c.name])
            assert kept[c.name].dims == data[c.name].dims
            assert kept[c.name].attrs["units"] == data[c.name].attrs["units"]
        assert read_sweep(path)["mesh"] == "slow"


def test_jumps_are_the_same_in_the_dataset_and_in_the_file(tmp_path):
    """A backlash oscillator jumps in both directions at different frequencies."""
    text = TORSIONAL_PAIR.partition("\n")[2].replace(
        "points: 81, direction: both, settle_periods: 200, measure_periods: 50",
        "points: 31, direction: both, settle_periods: 60, measure_periods: 10",
    )
    system = compiled(text, "sweep")[1]
    data = sweep_speed(system)
    found = run_sweep(system)
    assert len(found.jumps) > 0
    path = tmp_path / "sweep.h5"
    grid = data.mesh_frequency.values
    with SweepWriter(path, Header("sweep"), "stage", ["up", "down"], grid, grid) as writer:
        writer.put_jumps(found.jumps)
    with open_result(path) as kept:
        for name in ("jump_direction", "jump_mesh_frequency", "jump"):
            np.testing.assert_array_equal(kept[name], data[name])
        assert kept["jump_mesh_frequency"].attrs["units"] == data["jump_mesh_frequency"].attrs["units"]
    said = [str(data.direction.values[k]) for k in data["jump_direction"].values]
    assert said == [j["direction"] for j in found.jumps]
