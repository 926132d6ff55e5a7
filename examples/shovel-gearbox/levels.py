# SPDX-License-Identifier: Apache-2.0
"""Comparison of three contact laws on the same gearbox: impact force, restitution, DIN 3990.

Run it with `python levels.py [SECONDS]`. Forces are means and alternating rms of the left side once the
motors run at their rated speed, penetrations the mean and largest overlap of the flanks normal to them.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pitchpoint import Model, compile_model, load_model
from pitchpoint.solvers.time import run_time

HERE = Path(__file__).parent
STAGES = ("stage_1", "stage_2", "stage_3")
SHAFTS = ("input", "second", "third", "output")
LAWS: dict[str, dict[str, Any]] = {
    "impact": {},
    "restitution": {"damping": {"restitution": 0.8, "speed": "10 mm/s"}},
    "din3990": {"stiffness": {"law": "din3990"}, "damping": {"ratio": 0.02}},
}
"""What a law changes in every mesh of `paper.yaml`."""


@dataclass(frozen=True)
class Level:
    """What one law gives: (mean, alternating rms, largest) by channel, time that the run took [s]."""

    channels: dict[str, tuple[float, float, float]]
    wall_s: float


def with_law(model: Model, law: str) -> Model:
    """The gearbox with one of the laws in all of its meshes."""
    return model.replace_all({f"meshes.{m}.{k}": v for m in model.meshes for k, v in LAWS[law].items()})


def run(law: str, duration: float = 15.0) -> Level:
    """Run the rated scenario with a law; statistics from 3 s on, or over the last third."""
    model = with_law(load_model(HERE / "paper.yaml"), law)
    settle = min(3.0, 2.0 / 3.0 * duration)
    model = model.replace_all({"scenarios.rated.duration": duration, "scenarios.rated.settle_time": settle})
    done = run_time(compile_model(model, "rated"))
    rows = {
        name: (row["mean"], row["rms"], max(row["max"], -row["min"])) for name, row in done.channels.items()
    }
    return Level(channels=rows, wall_s=done.wall_s)


def table(duration: float) -> list[str]:
    """Lines of the table."""
    levels = {law: run(law, duration) for law in LAWS}
    head = f"{'':34}" + "".join(f"{law:>24}" for law in levels)
    lines = [head]

    def row(name: str, channel: str, scale: float, which: tuple[int, int]) -> None:
        cells = [found.channels[channel] for found in levels.values()]
        lines.append(
            f"{name:34}" + "".join(f"{c[which[0]] / scale:14.1f} {c[which[1]] / scale:9.2f}" for c in cells)
        )

    for stage in STAGES:
        row(f"{stage}: tooth force [kN], mean, rms", f"normal_force[{stage}]", 1e3, (0, 1))
        row(f"{stage}: penetration [um], mean, max", f"penetration[{stage}]", 1e-6, (0, 2))
    for shaft in SHAFTS:
        for name in (f"{shaft}_a_x", f"{shaft}_a_y", f"{shaft}_b_x", f"{shaft}_b_y"):
            row(f"bearing {name} [kN], mean, rms", f"signal[{name}]", 1e3, (0, 1))
        row(f"shaft {shaft}, axial [kN], mean, rms", f"signal[{shaft}_force_z]", 1e3, (0, 1))
    lines.append(
        f"{f'run time of {duration:g} s [s]':34}" + "".join(f"{x.wall_s:24.2f}" for x in levels.values())
    )
    return lines


if __name__ == "__main__":
    print("\n".join(table(float(sys.argv[1]) if len(sys.argv) > 1 else 15.0)))
