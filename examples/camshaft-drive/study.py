# SPDX-License-Identifier: Apache-2.0
"""Contact-loss time over backlash and torque: a load on gear 2 is applied, then released.

Varies one mesh of `release-backlash.yaml`, prints tables next to the closed form and draws the curves.
Usage: ``python study.py [FIGURE.html]``.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy as np

from pitchpoint import Model, compile_model, load_model
from pitchpoint.solvers.time import run_time

HERE = Path(__file__).parent
BACKLASHES = (0.05e-3, 0.15e-3, 0.25e-3, 0.35e-3, 0.43e-3)
TORQUES = (5.0, 10.0, 15.0, 20.0, 50.0, 55.0, 60.0, 1000.0, 1200.0, 1500.0)
RELEASE = 0.1
BASE_RADIUS, INERTIA = 0.2555964, 3.06
# the same printed number along the line of action, and about the axis of gear 2
STIFFNESSES = {"1.0e5 N/m": 1.0e5, "1.0e5 N m/rad": 1.0e5 / BASE_RADIUS**2}


def release(model: Model, backlash: float, torque: float, stiffness: float) -> tuple[float, float]:
    """Share of the time without contact and frequency [Hz] of the first half cycle after the release.

    Parameters
    ----------
    model
        `release-backlash.yaml`.
    backlash
        Total gap along the base tangent [m], > 0.
    torque
        Load that is released [N m], > 0.
    stiffness
        Of the mesh along the base tangent [N/m].
    """
    case = model.replace_all(
        {
            "meshes.gap_015.backlash.base_tangent": backlash,
            "meshes.gap_015.stiffness.value": stiffness,
            "loads.load_gap_015.torque": f"{torque} N m * (1 - step(t - {RELEASE}))",
            "scenarios.release.duration": 0.6,
            # the fastest crosses its gap of 0.05 mm in a hundredth of a millisecond
            "scenarios.release.step": 20e-6 if torque < 100.0 else 5e-6,
        }
    )
    done = run_time(compile_model(case, "release"))
    gaps = [k for k, name in enumerate(done.event_names) if "gap_015" in name and "_gap" in name]
    times = [t for t, which, _ in done.events if int(which) in gaps and t > RELEASE]
    # front parts, back touches, back parts: from one parting to the next is half a period
    parted, touched, parted_again = times[:3]
    half = parted_again - parted
    return float((touched - parted) / half), float(0.5 / half)


def closed_form(backlash: float, torque: float, stiffness: float) -> tuple[float, float]:
    """r/(pi + r) and f_n pi/(pi + r), r the gap over the static deflection: no damping."""
    r = backlash * BASE_RADIUS * stiffness / torque
    natural = math.sqrt(stiffness * BASE_RADIUS**2 / INERTIA) / (2.0 * math.pi)
    return r / (math.pi + r), natural * math.pi / (math.pi + r)


def table(model: Model, stiffness: float) -> tuple[np.ndarray, np.ndarray]:
    """Shares and frequencies, computed and by the closed form, shape (backlashes, torques, 2) each."""
    computed = [[release(model, j, T, stiffness) for T in TORQUES] for j in BACKLASHES]
    expected = [[closed_form(j, T, stiffness) for T in TORQUES] for j in BACKLASHES]
    return np.array(computed), np.array(expected)


def draw(found: dict[str, np.ndarray], target: Path) -> None:
    """Draw shares and frequencies over the torque, one curve per backlash, into an HTML file."""
    from plotly.subplots import make_subplots

    colours = ("#1b6ca8", "#2a9d5c", "#d9892b", "#8a4fa3", "#c0392b")
    figure = make_subplots(
        rows=2, cols=len(found), subplot_titles=[f"k = {name}" for name in found], shared_xaxes=True
    )
    for column, values in enumerate(found.values(), start=1):
        for j, row, colour in zip(BACKLASHES, values, colours, strict=False):
            for k, factor in enumerate((100.0, 1.0)):
                figure.add_scatter(
                    x=TORQUES,
                    y=factor * row[:, k],
                    mode="lines+markers",
                    name=f"backlash {j * 1e3:.2f} mm",
                    line_color=colour,
                    showlegend=column == 1 and k == 0,
                    row=k + 1,
                    col=column,
                )
    figure.update_xaxes(type="log")
    figure.update_xaxes(title="torque released [N m]", row=2)
    figure.update_yaxes(title="time without contact [%]", row=1, col=1)
    figure.update_yaxes(title="frequency [Hz]", row=2, col=1)
    figure.update_layout(template="plotly_white", legend_orientation="h", legend_y=-0.12, height=720)
    figure.write_html(target)


def main() -> None:
    """Print the tables; draw them if a file is named."""
    model = load_model(HERE / "release-backlash.yaml")
    found = {}
    for name, stiffness in STIFFNESSES.items():
        computed, expected = table(model, stiffness)
        found[name] = computed
        for k, (words, factor) in enumerate((("time without contact [%]", 100.0), ("frequency [Hz]", 1.0))):
            print(f"k = {name}: {words}; columns: torque [N m]")
            print("backlash   " + "".join(f"{T:8g}" for T in TORQUES))
            for j, row in zip(BACKLASHES, computed, strict=True):
                print(f"{j * 1e3:5.2f} mm   " + "".join(f"{factor * value:8.3f}" for value in row[:, k]))
        share, frequency = np.abs(computed - expected).max(axis=(0, 1))
        print(f"largest difference from the closed form: {share:.1e} of the time, {frequency:.1e} Hz")
        print()
    if len(sys.argv) > 1:
        draw(found, Path(sys.argv[1]))
        print(f"{sys.argv[1]} written")


if __name__ == "__main__":
    main()
