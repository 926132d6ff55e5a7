# SPDX-License-Identifier: Apache-2.0
"""Contact-loss time over backlash and torque: a load on gear 2 is held, then released.

Varies one mesh of `release-backlash.yaml`, prints a table beside the closed form and draws the curves.
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
TORQUES = (5.0, 10.0, 15.0, 20.0, 50.0, 55.0, 60.0)
RELEASE = 0.1
STIFFNESS, INERTIA = 1.0e5, 3.06


def contact_loss_share(model: Model, backlash: float, torque: float) -> float:
    """Share of the first half swing after the release in which no flank touches.

    Parameters
    ----------
    model
        `release-backlash.yaml`.
    backlash
        Total gap along the base tangent [m], > 0.
    torque
        Load that is released [N m], > 0.
    """
    case = model.replace("meshes.gap_015.backlash.base_tangent", backlash)
    case = case.replace("loads.load_gap_015.torque", f"{torque} N m * (1 - step(t - {RELEASE}))")
    case = case.replace("scenarios.release.duration", 0.6)
    done = run_time(compile_model(case, "release"))
    gaps = [k for k, name in enumerate(done.event_names) if "gap_015" in name and "_gap" in name]
    times = [t for t, which, _ in done.events if int(which) in gaps and t > RELEASE]
    # front parts, back touches, back parts: from one parting to the next is half a period
    parted, touched, parted_again = times[:3]
    return float((touched - parted) / (parted_again - parted))


def closed_form(backlash: float, torque: float, base_radius: float) -> float:
    """r/(pi + r) with r the gap over the static deflection, for an undamped mass between two springs."""
    r = backlash * base_radius * STIFFNESS / torque
    return r / (math.pi + r)


def table(model: Model) -> tuple[np.ndarray, np.ndarray]:
    """Shares computed and by the closed form, shape (backlashes, torques) each."""
    base_radius = 0.5 * model.gears["idler_gap_015"].geometry.d_b
    computed = [[contact_loss_share(model, j, T) for T in TORQUES] for j in BACKLASHES]
    expected = [[closed_form(j, T, base_radius) for T in TORQUES] for j in BACKLASHES]
    return np.array(computed), np.array(expected)


def draw(shares: np.ndarray, target: Path) -> None:
    """Draw one curve per backlash into an HTML file."""
    import plotly.graph_objects as go

    figure = go.Figure()
    for j, row in zip(BACKLASHES, shares, strict=True):
        figure.add_scatter(x=TORQUES, y=100.0 * row, mode="lines+markers", name=f"backlash {j * 1e3:.2f} mm")
    figure.update_layout(
        template="plotly_white", xaxis_title="torque released [N m]", yaxis_title="time without contact [%]"
    )
    figure.write_html(target)


def main() -> None:
    """Print the table; draw it if a file is named."""
    shares, expected = table(load_model(HERE / "release-backlash.yaml"))
    print("time without contact [%]; columns: torque [N m]")
    print("backlash   " + "".join(f"{T:8g}" for T in TORQUES))
    for j, row in zip(BACKLASHES, shares, strict=True):
        print(f"{j * 1e3:5.2f} mm   " + "".join(f"{100.0 * share:8.3f}" for share in row))
    print(f"largest difference from the closed form: {np.abs(shares - expected).max():.1e}")
    if len(sys.argv) > 1:
        draw(shares, Path(sys.argv[1]))
        print(f"{sys.argv[1]} written")


if __name__ == "__main__":
    main()
