# SPDX-License-Identifier: Apache-2.0
"""A sweep on disk comes back as the JSON of the command line, complete or not."""

from __future__ import annotations

from pathlib import Path

import pytest

from pitchpoint.io.container import Header, ResultError
from pitchpoint.io.reading import open_result
from pitchpoint.io.results import Channel, ResultWriter
from pitchpoint.io.sweep_store import SweepWriter, read_sweep


def point(level: float) -> dict[str, object]:
    """Make the values of one point."""
    statistics = {"mean": 2.0 * level, "rms": level, "min": -level, "max": 3.0 * level}
    quantities = ("transmission_error", "deflection", "mesh_force")
    return dict.fromkeys(quantities, statistics) | {"contact_loss_share": 0.25, "back_contact_share": 0.0}


def test_round_trip_while_running_and_after(tmp_path: Path) -> None:
    path = tmp_path / "sweep.h5"
    with SweepWriter(path, Header("sweep"), "stage", ["up", "down"], [20.0, 40.0], [1000.0, 2000.0]) as sweep:
        sweep.put("up", 0, point(1.0))
        sweep.put("up", 1, point(2.0))
        sweep.put("down", 1, point(4.0))
        assert len(read_sweep(path)["points"]) == 3
        sweep.put("down", 0, point(1.0), status=5)
        sweep.put_jumps([{"direction": "down", "mesh_frequency": 1500.0}])
    found = read_sweep(path)
    assert found["mesh"] == "stage"
    assert [(p["direction"], p["mesh_frequency"]) for p in found["points"]] == [
        ("up", 1000.0), ("up", 2000.0), ("down", 2000.0), ("down", 1000.0)
    ]  # fmt: skip
    assert found["points"][2]["deflection"] == {
        "unit": "m",
        "mean": 8.0,
        "rms": 4.0,
        "min": -4.0,
        "max": 12.0,
    }
    assert found["points"][2]["mesh_force"]["unit"] == "N"
    assert found["points"][2]["speed"] == 40.0
    assert found["points"][3]["status"] == 5
    assert found["points"][0]["contact_loss_share"] == 0.25
    assert found["jumps"] == [{"direction": "down", "mesh_frequency": 1500.0}]
    with open_result(path) as ds:
        rms = ds["deflection[stage]"].sel(direction="up", statistic="rms", mesh_frequency=2000.0)
        assert rms == 2.0
        assert ds["mesh_frequency"].attrs["units"] == "Hz"


def test_other_files_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    with ResultWriter(path, Header("time"), [Channel("mesh_force[stage]", "N")]):
        pass
    with pytest.raises(ResultError, match="holds time results"):
        read_sweep(path)


def test_the_status_of_a_point_is_stored_after_its_values_and_read_before(
    tmp_path: Path, monkeypatch
) -> None:
    """A flush writes what it covers in any order: a kill within it must not leave a status without values."""
    path = tmp_path / "sweep.h5"
    seen = []
    with SweepWriter(path, Header("sweep"), "stage", ["up"], [20.0, 40.0], [1000.0, 2000.0]) as sweep:
        flush = sweep.flush
        monkeypatch.setattr(
            sweep,
            "flush",
            lambda: (flush(), seen.append(open_result(path)["point_status"].values[0, 0])),
        )
        sweep.put("up", 0, {})
    assert seen == [-1, 1]
    with open_result(path) as data:
        assert next(iter(data.data_vars)) == "point_status"
