# SPDX-License-Identifier: Apache-2.0
"""Contacts of the scene of `scene_data`, made up with closed forms: helical lines that go through a mesh.

Pair N has its line at travel - N pitch + slope z, carries FORCE (1 + N mod 4 / 10) and loads that rise along
the line from LOAD to three times of it, times the same.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.support.scene_data import LENGTH, MODULE, SPEED, TEETH, TIMES, Block, gears

Array = NDArray[np.float64]

ALPHA, HELIX = np.radians(20.0), 0.2
PITCH = np.pi * MODULE * np.cos(ALPHA)
WIDTH, PATH = (-0.012, 0.012), (-0.010, 0.009)
SLOPE = np.tan(HELIX)
SLOTS, STATIONS = 4, 5
FORCE, LOAD = 1000.0, 20e3
POINT = np.array([TEETH[0] * MODULE / 2, 0.0, 0.0])
NORMAL = np.array([np.sin(ALPHA), np.cos(ALPHA), 0.0])
UNIT = 2e5
"""Pressure of 1 N/m at the pitch point [Pa]; it falls to nothing 50 mm beyond."""
FIRST = -0.004
"""Travel at the start [m]."""
PENETRATION = (4e-6, -96e-6)
"""Of front and back flanks in the middle of the record [m]; both sway by 1 um."""
TOOTH, STEP = (2, 7), (-1, 1)
"""Teeth of pair 0, and to the next pair."""


def travel(t: Array | float) -> Array | float:
    return FIRST + 0.5 * TEETH[0] * MODULE * np.cos(ALPHA) * SPEED * t


def reached(place: float) -> tuple[float, float] | None:
    """Part of the width on which a line lies on the flanks."""
    low = max(WIDTH[0], (PATH[0] - place) / SLOPE)
    high = min(WIDTH[1], (PATH[1] - place) / SLOPE)
    return (low, high) if high >= low else None


def pairs_at(t: float) -> dict[int, tuple[Array, Array]]:
    """Ends of the lines of all pairs in the world."""
    found = {}
    for pair in range(-40, 400):
        place = float(travel(t)) - pair * PITCH
        ends = reached(place)
        if ends is not None:
            low, high = (POINT + (place + SLOPE * z) * NORMAL + np.array([0.0, 0.0, z]) for z in ends)
            found[pair] = (low, high)
    return found


def pressure(place: Array, load: Array) -> Array:
    """Of a load at a place from the pitch point [Pa]."""
    return UNIT * (1.0 - place / 0.05) * np.sqrt(load)


def share(pair: int) -> float:
    return 1.0 + 0.1 * (pair % SLOTS)


def touching() -> tuple[dict[str, Any], Block]:
    """Header and numbers of two gears with a contact, and a mark that lasts."""
    header, block = gears()
    n = len(TIMES)
    forces, loads = np.zeros((n, SLOTS)), np.zeros((n, SLOTS, STATIONS))
    for frame, t in enumerate(TIMES):
        for pair in pairs_at(float(t)):
            forces[frame, pair % SLOTS] = FORCE * share(pair)
            loads[frame, pair % SLOTS] = LOAD * share(pair) * np.linspace(1.0, 3.0, STATIONS)
    step = loads.max() / 255
    grid = np.stack(np.meshgrid(np.linspace(*WIDTH, 5), np.linspace(*PATH, 7), indexing="ij"), axis=-1)
    surfaces = []
    for body, (radius, teeth) in enumerate(zip((0.048, 0.072), TEETH, strict=True)):
        points = np.concatenate([radius + 0.3 * grid[..., 1:], 0.0 * grid[..., 1:], grid[..., :1]], axis=-1)
        surfaces.append(
            {
                "body": body,
                "gear": f"Z{body + 1}",
                "teeth": teeth,
                "points": block.put(points, "f4"),
                "turn": (-1) ** (body + 1) * 2 * np.pi / teeth * (1 if body == 0 else -1),
                "tooth": TOOTH[body],
                "step": STEP[body],
            }
        )
    sway = 1e-6 * np.sin(2 * np.pi * TIMES / LENGTH)[:, None]
    header["contacts"] = [
        {
            "name": "stage_1",
            "at": block.put([POINT], "f8"),
            "axes": block.put([[0, 0, 0, 1]], "f8"),
            "pressure_angle": block.put([ALPHA], "f8"),
            "base_helix": HELIX,
            "base_pitch": PITCH,
            "width": list(WIDTH),
            "path": list(PATH),
            "unit_pressure": block.put(pressure(np.linspace(*PATH, 9), np.ones(9))),
            "penetration": block.put(np.array(PENETRATION) + sway * [1, -1], "f8"),
            "flanks": [
                {
                    "side": 1,
                    "travel": block.put(travel(TIMES)),
                    "forces": block.coarse(forces),
                    "loads": {
                        **block.put(np.rint(loads / step), "u1"),
                        "scale": [step] * STATIONS,
                        "offset": [0.0] * STATIONS,
                    },
                    "surfaces": surfaces,
                }
            ],
        }
    ]
    header["marks"].append({"time": 0.03, "kind": "faulty_tooth", "what": "Z1, tooth 3", "until": 0.05})
    return header, block
