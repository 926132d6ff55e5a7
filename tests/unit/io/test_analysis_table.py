# SPDX-License-Identifier: Apache-2.0
"""Tables of analyses: every number is in the file, in the order of its grid."""

from __future__ import annotations

import numpy as np
import xarray as xr

from pitchpoint.io.analysis_table import table_text


def test_numbers_curves_and_maps():
    data = xr.Dataset(
        {
            "mean": ((), 2.5, {"units": "N"}),
            "speed": ("time", [7.0, 8.0], {"units": "rad/s"}),
            "amplitude": (("time", "line"), [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]], {"units": "N"}),
            "other": ("group", [0.1, 0.2], {"units": "1"}),
        },
        coords={"time": ("time", [0.5, 1.0], {"units": "s"})},
        attrs={"tool": "made up", "notes": ""},
    )
    lines = table_text(data).splitlines()
    assert lines[:4] == [
        "# pitchpoint analysis",
        "# tool: made up",
        "# mean [N]: 2.5",
        "# other [1] over group: [0.1, 0.2]",
    ]
    assert lines[4] == "time [s],line,speed [rad/s],amplitude [N]"
    rows = np.array([line.split(",") for line in lines[5:]], dtype=float)
    assert rows[:, 0].tolist() == [0.5] * 3 + [1.0] * 3
    assert rows[:, 1].tolist() == [0, 1, 2] * 2
    assert rows[:, 2].tolist() == [7.0] * 3 + [8.0] * 3
    assert rows[:, 3].tolist() == [1, 2, 3, 4, 5, 6]


def test_numbers_alone():
    data = xr.Dataset({"rms": ((), 1.0, {"units": "m"})}, attrs={"tool": "x"})
    assert table_text(data).splitlines() == ["# pitchpoint analysis", "# tool: x", "# rms [m]: 1.0"]
