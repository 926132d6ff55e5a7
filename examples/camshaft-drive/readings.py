# SPDX-License-Identifier: Apache-2.0
"""Run-up for other interpretations of the study: each line changes one assumption of `run-up.yaml`.

Prints where the largest force comes, whether the flanks separate there, and whether the back flank is hit.
Usage: ``python readings.py``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from pitchpoint import Model, compile_model, load_model
from pitchpoint.analysis.statistics import contact_statistics
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory

HERE = Path(__file__).parent
MESH, TEETH = "gap_430", 59
BASE_RADIUS, INERTIA, PRINTED_FREQUENCY = 0.2555964, 3.06, 41.4
BY_FREQUENCY = (2.0 * math.pi * PRINTED_FREQUENCY) ** 2 * INERTIA  # N m/rad
BEGIN, END = 15.0, 30.0  # s; the resonance lies inside, fractions of it and the start do not


@dataclass(frozen=True, kw_only=True)
class Reading:
    """One reading: `stiffness` is the mean [N m/rad], or that of one pair if `pair` is given."""

    name: str
    backlash: float = 0.43e-3
    duty: float = 0.5
    damper: float = 100.0
    torque: float = 500.0
    pair: float | None = None

    @property
    def mean(self) -> float:
        """Mean stiffness about the axis of gear 2 [N m/rad]: two and three pairs, three for `duty`."""
        return BY_FREQUENCY if self.pair is None else self.pair * (2.0 + self.duty)

    def changes(self) -> dict[str, Any]:
        """New values of `run-up.yaml`, along the base tangent."""
        pair = self.mean / (2.0 + self.duty) / BASE_RADIUS**2
        mesh = f"meshes.{MESH}"
        return {
            f"{mesh}.backlash.base_tangent": self.backlash,
            f"{mesh}.stiffness.low": 2.0 * pair,
            f"{mesh}.stiffness.high": 3.0 * pair,
            f"{mesh}.stiffness.duty": self.duty,
            f"{mesh}.damper.value": self.damper / BASE_RADIUS**2,
            "loads.load_430.torque": self.torque,
            "scenarios.run_up.duration": END,
        }


READINGS = (
    Reading(name="run-up.yaml"),
    Reading(name="backlash 0", backlash=0.0),
    Reading(name="backlash 0.043 mm", backlash=0.043e-3),
    Reading(name="backlash 0.15 mm", backlash=0.15e-3),
    Reading(name="backlash 0.86 mm (b = 0.43 mm)", backlash=0.86e-3),
    Reading(name="three pairs for 21.07 %", duty=0.2107),
    Reading(name="three pairs for 35 %", duty=0.35),
    Reading(name="three pairs for 65 %", duty=0.65),
    Reading(name="1e5 N m/rad per pair", pair=1.0e5),
    Reading(name="the same, 21.07 %", pair=1.0e5, duty=0.2107),
    Reading(name="damper 50 N m s/rad", damper=50.0),
    Reading(name="damper 150 N m s/rad", damper=150.0),
    Reading(name="damper 200 N m s/rad", damper=200.0),
    Reading(name="load 300 N m", torque=300.0),
    Reading(name="load 800 N m", torque=800.0),
)


@dataclass(frozen=True)
class Found:
    """What one reading gives between `BEGIN` and `END`.

    Attributes
    ----------
    natural_frequency
        Of gear 2 on the mean stiffness [Hz].
    force, time, frequency
        Largest mesh force [N], when it comes [s], and the mesh frequency then [Hz].
    loss_share, crossings
        Share of the time without contact; passages through the gap from one flank to the other.
    """

    natural_frequency: float
    force: float
    time: float
    frequency: float
    loss_share: float
    crossings: int


def run_up(model: Model, reading: Reading) -> Found:
    """Compute one reading; `model` is `run-up.yaml`."""
    system = compile_model(model.replace_all(reading.changes()), "run_up")
    memory = Memory()
    run_time(system, sink=memory)
    time, rows = np.concatenate(memory.times), np.concatenate(memory.rows)
    late = time >= BEGIN
    force = rows[late, system.layout.channel(f"mesh_force[{MESH}]")]
    state = rows[late, system.layout.channel(f"contact_state[{MESH}]")]
    contact = contact_statistics(time[late], state, force)
    top = float(time[late][np.argmax(force)])
    return Found(
        natural_frequency=math.sqrt(reading.mean / INERTIA) / (2.0 * math.pi),
        force=float(force.max()),
        time=top,
        frequency=TEETH * 0.2 * top / (2.0 * math.pi),
        loss_share=contact.loss_share,
        crossings=sum(s.flank_before != s.flank_after for s in contact.separations),
    )


def main() -> None:
    """Print one line per reading."""
    model = load_model(HERE / "run-up.yaml")
    print(f"{'reading':32}   f_n   peak at  f_mesh  f_mesh/f_n   force   lost  crossings")
    print(f"{'':32}  [Hz]       [s]    [Hz]         [-]    [kN]    [%]")
    for reading in READINGS:
        f = run_up(model, reading)
        print(
            f"{reading.name:32} {f.natural_frequency:5.2f} {f.time:9.2f} {f.frequency:7.2f}"
            f" {f.frequency / f.natural_frequency:11.3f} {f.force * 1e-3:7.2f} {100.0 * f.loss_share:6.2f}"
            f" {f.crossings:10d}"
        )


if __name__ == "__main__":
    main()
