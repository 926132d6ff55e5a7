# SPDX-License-Identifier: Apache-2.0
"""A result file gives the variables, coordinates and values of the function in memory, for every kind."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import pitchpoint as pp
from pitchpoint.cli.main import run_command
from pitchpoint.report.campbell import campbell_of
from pitchpoint.solvers.mesh_response import solve_mesh_response

MODEL = """\
gears:
  p: {number_of_teeth: 25, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  w: {number_of_teeth: 40, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  a: {gears: [p], motion: planar, mass: 1 kg, inertia: 1e-3 kg m^2}
  b: {gears: [w], inertia: 6e-3 kg m^2}
bearings:
  front: {body: a, stiffness: {radial: 2e8}, damping: {radial: 500}}
meshes:
  st: {gears: [p, w], center_distance: 65.05 mm, stiffness: {law: din3990}, damper: {ratio: 0.05}}
loads:
  i: {body: a, torque: 50 N m}
  o: {body: b, torque: balance}
scenarios:
  steady: {speed: {a: 1200 rpm}, duration: 5 ms, sample_rate: 20 kHz}
  slow: {quasi_static: {mesh: st, points: 10}}
"""
RPM = math.pi / 30.0
ORDERS = ["mesh_force[st]", "acceleration[a.uy]"]


def in_memory(kind: str, model: pp.Model) -> xr.Dataset:
    """The result of a function."""
    steady = pp.compile_model(model, "steady")
    if kind == "modes":
        return pp.solve_modal(steady, "steady")
    if kind == "campbell":
        return campbell_of(model, "steady", points=5)
    if kind == "frf":
        names = ["transmission_error[st]"], ["mesh_force[st]", "a.uy"]
        return pp.solve_frequency_response(steady, *names, np.linspace(100.0, 1000.0, 4), "steady")
    if kind == "orders":
        return solve_mesh_response(
            steady, ORDERS, "a", np.linspace(150.0, 3000.0, 4) * RPM, "steady", harmonics=2
        )
    if kind == "slow":
        return pp.solve_quasistatic(pp.compile_model(model, "slow"))
    return pp.solve_time(steady)


COMMANDS = {
    "modes": ["modes", "-s", "steady"],
    "campbell": ["campbell", "-s", "steady", "--points", "5"],
    "frf": [
        *("frf", "-s", "steady", "-i", "transmission_error[st]", "-r", "mesh_force[st]", "-r", "a.uy"),
        *("--from", "100 Hz", "--to", "1000 Hz", "--points", "4", "--linear"),
    ],
    "orders": [
        *("frf", "-s", "steady", "--mesh-orders", "2", "--speed-of", "a", "--to-speed", "3000 rpm"),
        *("--points", "4", "-r", ORDERS[0], "-r", ORDERS[1]),
    ],
    "slow": ["run", "-s", "slow"],
    "time": ["run", "-s", "steady"],
}


@pytest.mark.parametrize("kind", COMMANDS)
def test_a_file_has_the_contents_of_the_function(kind: str, tmp_path: Path) -> None:
    file, target = tmp_path / "pair.yaml", tmp_path / "result.h5"
    file.write_text(MODEL, encoding="utf-8")
    command, *options = COMMANDS[kind]
    assert run_command([command, str(file), *options, "-o", str(target), "-q"]) == 0
    known = in_memory(kind, pp.load_model(file))
    with pp.open_result(target) as found:
        assert set(found.data_vars) == set(known.data_vars)
        assert set(found.coords) == set(known.coords)
        for name, one in known.variables.items():
            other = found[name]
            assert other.dims == one.dims, name
            assert one.dtype.kind in "OU" or other.dtype.kind == one.dtype.kind, name
            if one.dtype.kind in "OU":
                assert other.values.tolist() == one.values.tolist(), name
            else:
                stored = 1e-6 if other.dtype == np.float32 else 1e-9
                np.testing.assert_allclose(other.values, one.values, rtol=stored, atol=1e-12, err_msg=name)
            assert other.attrs.get("units", "") == one.attrs.get("units", ""), name
