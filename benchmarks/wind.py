# SPDX-License-Identifier: Apache-2.0
"""Wind-turbine drive train in real time, a planetary set in all directions, a box of turbulence."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

from benchmarks.rows import Row, cpu_seconds

HERE = Path(__file__).parent
DRIVE = HERE.parent / "examples" / "wind-drive-grc"
STEPS = 40_000


def rows() -> list[Row]:
    """10 s of rated operation of the GRC drive train, and the steps per second of a planetary set."""
    return [
        _operation("torsion", "11 degrees of freedom"),
        _operation("linear_bearings", "all directions: elastic shafts, 8 meshes, gearbox on mounts"),
        _operation("model", "the same, with rolling bearings on the high-speed shaft", ""),
        planetary_set(),
        *turbulence(),
    ]


def _operation(file: str, text: str, target: str = "<= 10") -> Row:
    """CPU time of 10 s of operation [s], statistics of all channels at every step, everything compiled."""
    from pitchpoint.io.yaml_model import load_model
    from pitchpoint.solvers.time import run_time
    from pitchpoint.system.compile import compile_model

    model = load_model(DRIVE / f"{file}.yaml").replace("scenarios.rated.duration", 10.0)
    short = {"scenarios.rated.duration": 0.02, "scenarios.rated.settle_time": 0.0}
    run_time(compile_model(model.replace_all(short), "rated"))
    system = compile_model(model, "rated")
    begun = time.process_time()
    done = run_time(system)
    taken = time.process_time() - begun
    assert done.status == 1, done.sentence
    return Row(
        f"GRC drive train, 10 s, {file}",
        taken,
        "s",
        "<= 10",
        f"{text}; {done.steps} steps, CPU time of one core",
    )


def planetary_set() -> Row:
    """Steps per second of CPU time of a set of 7 bodies, h 10 us, 231 steps per mesh period."""
    run = _started()
    run.advance(2000)
    taken = cpu_seconds(lambda: run.advance(STEPS), 5)
    text = f"{run.system.sizes['nd']} degrees of freedom, 6 helical meshes, h 10 us"
    return Row("planetary set in all directions", STEPS / taken, "steps/s", ">= 40000", text)


def _started() -> Any:
    from pitchpoint.io.yaml_model import load_model
    from pitchpoint.solvers.implicit import generalized_alpha
    from pitchpoint.solvers.initial_state.start import prepare_start
    from pitchpoint.system.compile import compile_model

    model = load_model(HERE / "planetary_3d.yaml")
    system = compile_model(model, "steady")
    start = prepare_start(system, model.scenarios["steady"])
    return generalized_alpha.start(start.system, start.state, 1e-5)


def turbulence() -> list[Row]:
    """Box of 31 × 31 points, 600 s at 20 Hz, and velocities at points of it."""
    import numpy as np

    from pitchpoint.model.wind.steady import SteadyWind
    from pitchpoint.model.wind.turbulence import KaimalTurbulence
    from pitchpoint.solvers.turbulence.box import make_turbulence
    from pitchpoint.system.wind import WindField

    wind = KaimalTurbulence(
        mean_speed=12.0,
        deviation=2.0,
        hub_height=90.0,
        size=(150.0, 150.0),
        points=(31, 31),
        duration=600.0,
        time_step=0.05,
    )
    taken = cpu_seconds(lambda: make_turbulence(wind, 1), 1)
    field = WindField(SteadyWind(speed=12.0, hub_height=90.0), box=make_turbulence(wind, 1))
    # stations of three blades
    turn, radius = np.meshgrid(np.arange(3) * 2.1, np.linspace(2.0, 62.0, 19))
    y, z = (radius * np.cos(turn)).ravel(), 90.0 + (radius * np.sin(turn)).ravel()
    at, found = np.stack([np.zeros_like(y), y, z], axis=1), np.empty((y.size, 3))
    field.fill(at, 0.0, found)

    def evaluate() -> None:
        """All stations at 2000 times."""
        for k in range(2000):
            field.fill(at, 0.01 * k, found)

    each = cpu_seconds(evaluate) / (2000 * len(at))
    return [
        Row("box of turbulence", taken, "s", "<= 20", "31 x 31 points, 600 s at 20 Hz, three components"),
        Row(
            "velocity of the wind at a point",
            each * 1e9,
            "ns",
            "",
            "57 stations per call, called from Python",
        ),
    ]
