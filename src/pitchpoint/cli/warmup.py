# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint warmup`: compile all kernels once; the machine code is stored in the cache of the user."""

from __future__ import annotations

import contextlib
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import click

from pitchpoint.cli.options import debug, quiet
from pitchpoint.cli.output import show

# Two shafts with all components that have kernels: bearings, damping, friction, laws, drives, events.
MODEL = """
title: warm-up
gears:
  one: {number_of_teeth: 20, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  two: {number_of_teeth: 30, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  a: {gears: [one], motion: planar}
  b: {gears: [two], motion: free}
meshes:
  m: {gears: [one, two], center_distance: 50.1 mm, damping: {ratio: 0.05}, friction: {mu: 0.05}}
bearings:
  at_a: {body: a, stiffness: {radial: 1e8 N/m}}
  at_b: {body: b, stiffness: {radial: 1e8 N/m, axial: 1e8 N/m, tilt: 1e5 N m/rad}}
loads:
  input: {body: a, torque: 10 N m}
  output: {body: b, torque: 15 N m}
scenarios:
  generalized_alpha: {speed: {a: 500 rpm}, duration: 1 ms, events: [pair_entry]}
  rk4: {speed: {a: 500 rpm}, duration: 1 ms, method: rk4, step: 1 us, events: [pair_entry]}
  runge_kutta: {speed: {a: 500 rpm}, duration: 1 ms, method: runge_kutta, events: [pair_entry]}
  gstiff: {speed: {a: 500 rpm}, duration: 1 ms, method: gstiff, events: [pair_entry]}
  driven: {drive: {a: {speed: 500 rpm}}, duration: 1 ms}
  sweep: {sweep: {body: a, mesh_frequency: [500 Hz, 600 Hz], points: 2,
                  settle_periods: 1, measure_periods: 1}}
"""

Job = tuple[str, Callable[[], object]]
COST = {
    "core": 50.0,
    "element gear_mesh": 18.0,
    "contact": 9.0,
    "generalized_alpha": 8.0,
    "runge_kutta": 4.0,
    "gstiff": 4.0,
    "rk4": 3.0,
    "modes": 3.0,
}
"""Measured shares of the jobs in the compilation time [%]; all others together 1 %."""
OTHERS = 0.03


@click.command()
@quiet
@debug
def warmup(quiet: bool) -> None:
    """Compile all kernels in advance, so that later commands start within a second."""
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.core.errors import SolverError
    from pitchpoint.core.kernel import cache_folder

    begun = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder, ProgressDisplay("warm-up", quiet=quiet) as progress:
        found = jobs(Path(folder))
        cost = [COST.get(name, OTHERS) for name, _ in found]
        for k, (name, job) in enumerate(found):
            progress(sum(cost[:k]), sum(cost), name)
            with contextlib.suppress(SolverError):  # only the compilation matters, not the result
                job()
        progress(sum(cost), sum(cost))
    if not quiet:
        seconds = time.perf_counter() - begun
        show(f"{len(found)} jobs in {seconds:.1f} s; the machine code is in {cache_folder()}")


def jobs(folder: Path) -> list[Job]:
    """List of compilation jobs: core and kinds in two processes, then every solver on a small model."""
    from pitchpoint.cli import run as run_command
    from pitchpoint.cli import sweep as sweep_command
    from pitchpoint.core.kernel import address
    from pitchpoint.elements import registry
    from pitchpoint.io.yaml_model import load_model
    from pitchpoint.solvers.contact_analysis.solve import solve_contact
    from pitchpoint.solvers.modal import find_modes
    from pitchpoint.system.compile import compile_model
    from pitchpoint.system.link import prepare_kernels

    file = folder / "warmup.yaml"
    file.write_text(MODEL, encoding="utf-8")
    model = load_model(file)

    def kind(name: str) -> Job:
        """Job that compiles one kind of element, with the kernels of all its variants."""
        found = registry.find(name)
        entries = [found.entry, *(entry for entry, _ in found.some.values())]
        return f"element {name}", lambda: [address(entry) for entry in entries]

    def time_response(name: str) -> Job:
        """Job that runs one scenario and compiles the required kernels."""
        target = folder / f"{name}.h5"
        return name, lambda: run_command.compute(model, str(file), name, target, quiet=True)

    listed: list[Job] = [("core", lambda: prepare_kernels(registry.names(), trees=True))]
    listed += [time_response(name) for name, scenario in model.scenarios.items() if scenario.kind == "time"]
    target = folder / "sweep.h5"
    listed.append(("sweep", lambda: sweep_command.compute(model, str(file), "sweep", target, quiet=True)))
    listed.append(("modes", lambda: find_modes(compile_model(model))))
    touching = model.replace("meshes.m.contact", {"level": "flexible", "planes": 2})
    listed.append(("contact", lambda: solve_contact(touching, torque=10.0, positions=4)))
    return listed + [kind(name) for name in registry.names()]
