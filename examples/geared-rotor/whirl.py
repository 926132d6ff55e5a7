# SPDX-License-Identifier: Apache-2.0
"""Campbell diagram of the lowest modes (whirl of the disc, torsion) with speed and mesh frequency.

Usage: ``python whirl.py`` prints where the lines meet, ``python whirl.py whirl.html`` draws them.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy as np

from pitchpoint import compile_model, load_model
from pitchpoint.analysis.campbell import campbell_crossings
from pitchpoint.solvers.campbell import follow_modes
from pitchpoint.viz.campbell_plot import plot_campbell

MODEL = Path(__file__).with_name("model.yaml")
RPM = math.pi / 30.0
HIGHEST = 250.0
"""Modes that begin below this frequency at rest are drawn [Hz]."""


def main() -> None:
    """Print or draw the lowest modes over the speed of the rotor."""
    speeds = np.linspace(300.0, 7200.0, 24) * RPM
    found = follow_modes(compile_model(load_model(MODEL), "fast"), speeds, "rotor", "fast")
    low = (found.frequency[0] > 1.0) & (found.frequency[0] < HIGHEST)
    modes = found.frequency[:, low]
    orders = {"speed": 1.0, "speed × 2": 2.0, "mesh": found.orders["stage"]}
    for meeting in campbell_crossings(speeds, modes, tuple(orders.values())):
        print(f"{meeting.speed / RPM:7.0f} rpm  {meeting.frequency:7.2f} Hz  order {meeting.order:g}")
    if len(sys.argv) > 1:
        names = ["backward whirl", "forward whirl", "torsion"]
        plot_campbell(speeds, modes, orders, mode_names=names, shaft="rotor").write_html(sys.argv[1])


if __name__ == "__main__":
    main()
