# SPDX-License-Identifier: Apache-2.0
"""Small models that are exported as units, and their units; only where they can be linked and run."""

from __future__ import annotations

import platform

import pytest

from pitchpoint.core.errors import MissingDependencyError
from pitchpoint.core.fmi.fmu_file import own_platform
from pitchpoint.io.fmu.linking import check_linker
from pitchpoint.io.fmu.writing import fmu_bytes
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.exported_model import begin_export, fmu_model
from pitchpoint.solvers.exported_run import started
from pitchpoint.solvers.fixed_steps import start_fixed_steps
from pitchpoint.solvers.step_choice import choose_step
from pitchpoint.system.compile import compile_model

PAIR = """
title: pair with backlash
gears:
  g1: {number_of_teeth: 50, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  g2: {number_of_teeth: 50, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  driver: {gears: [g1], motion: torsion, inertia: 0.0115 kg m^2}
  driven: {gears: [g2], motion: torsion, inertia: 0.0115 kg m^2}
meshes:
  stage:
    gears: [g1, g2]
    center_distance: 150 mm
    backlash: {normal: 0.1 mm}
    stiffness: {law: din3990, stiffness_ratio: 0.8, tip_relief_factor: 0.0}
    damper: {ratio: 0.05}
loads:
  input: {body: driver, torque: 150 N m}
  output: {body: driven, torque: 150 N m}
scenarios:
  steady: {speed: {driver: 3300 rpm}, duration: 20 ms, step: 10 us, method: METHOD}
"""


DRIVEN = """
title: driven shaft with a speed controller of blocks
bodies:
  motor: {motion: torsion, inertia: 0.02 kg m^2}
  drum: {motion: torsion, inertia: 0.05 kg m^2}
  fan: {motion: torsion, inertia: 0.02 kg m^2, position: [1 m, 0 m, 0 m]}
couplings:
  shaft: {bodies: [motor, drum], stiffness: {torsion: 1000 N m/rad}, damping: {torsion: 1 N m s/rad}}
sensors:
  speed: {type: joint, coordinate: fan, derivative: 1}
blocks:
  error: {type: sum, inputs: {speed: -1}, unit: rad/s}
  wanted: {type: pid, input: error, proportional: 0.5, integral: 2, unit: N m}
actuators:
  fan_torque: {type: torque, signal: wanted, bodies: [fan]}
loads:
  brake: {body: drum, torque: -10 N m}
scenarios:
  steady: {drive: {motor: {speed: 1000 rpm}}, duration: 0.1 s, step: 50 us, method: adams}
"""


def need_linker() -> None:
    """Skip where the library cannot be linked or run."""
    if own_platform() != "x86_64-linux":
        pytest.skip(f"the tests run units of x86_64-linux, and this is {own_platform()}")
    if "avx2" not in _flags() or "fma" not in _flags():
        pytest.skip(f"the processor {platform.processor()} has no AVX2 and FMA")
    try:
        check_linker(own_platform())
    except MissingDependencyError as error:
        pytest.skip(str(error))


def _flags() -> str:
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        return file.read()


def pair(method: str):
    """The model with a method."""
    return loads_model(PAIR.replace("METHOD", method), False, "pair.yaml")


def unit_of(method: str, folder, version: int, *parameters: str, model=None, inputs=()):
    """File of the unit of the pair, or of another model with the scenario `steady`."""
    model = model or pair(method)
    run, tunable = begin_export(model, "steady", parameters, inputs)
    data, _ = fmu_bytes(fmu_model(run, tunable, "pair", model.title), version, ["x86_64-linux"])
    file = folder / f"{method}{version}.fmu"
    file.write_bytes(data)
    return file


def own_start(method: str, model=None):
    """Start of the pair in this process."""
    system = compile_model(model or pair(method), "steady")
    return started(system, system.scenario)


def own_run(method: str, model=None):
    """Run of the pair in this process, begun."""
    start = own_start(method, model)
    scenario = start.system.scenario
    h, _ = choose_step(start, scenario)
    return start_fixed_steps(start.system, start.state, scenario, h)
