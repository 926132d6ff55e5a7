# SPDX-License-Identifier: Apache-2.0
"""Files of TurbSim and of the Mann generator: layout, round trips, damaged files."""

from __future__ import annotations

import base64
import struct
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.target import OutputError
from pitchpoint.io.wind.mann import MannGeometry, read_mann, write_mann
from pitchpoint.io.wind.turbsim import write_turbsim
from pitchpoint.model.wind import file_errors as errors
from pitchpoint.model.wind.box import WindBox
from pitchpoint.model.wind.file_errors import WindFileError
from pitchpoint.model.wind.turbsim import read_turbsim
from pitchpoint.system.wind import WindField


def box_of(shape: tuple[int, int, int] = (7, 3, 4), **more: object) -> WindBox:
    rng = np.random.default_rng(8)
    velocity = rng.normal((9.0, 0.0, 0.0), 1.0, (*shape, 3)).astype(np.float32)
    numbers = {
        "time_step": 0.25,
        "spacing": (5.0, 8.0),
        "bottom": 82.0,
        "hub_height": 90.0,
        "mean_speed": 9.0,
    }
    return WindBox(velocity=velocity, **{"with_mean": True, **numbers, **more})


def turbsim_bytes(n_tower: int = 2, number: int = 7, text: bytes = b"by hand") -> tuple[bytes, np.ndarray]:
    """A file as TurbSim writes it, value by value: 2 heights, 3 columns, 4 times, points of a tower."""
    scale = ((100.0, -900.0), (200.0, 10.0), (400.0, 0.5))
    data = struct.pack("<h4i6f", number, 2, 3, n_tower, 4, 10.0, 5.0, 0.5, 12.0, 90.0, 80.0)
    data += b"".join(struct.pack("<2f", *one) for one in scale) + struct.pack("<i", len(text)) + text
    velocity = np.empty((4, 2, 3, 3))
    for i in range(4):
        for k in range(2):
            for j in range(3):
                for c, (slope, offset) in enumerate(scale):
                    stored = 1000 * i + 100 * k + 10 * j + c
                    data += struct.pack("<h", stored)
                    velocity[i, k, j, c] = (stored - offset) / slope
        data += struct.pack("<h", -77) * 3 * n_tower
    return data, velocity


def test_a_file_of_turbsim_value_by_value(tmp_path: Path) -> None:
    for n_tower, number in ((2, 7), (0, 8)):
        data, velocity = turbsim_bytes(n_tower, number)
        (tmp_path / "a.bts").write_bytes(data)
        box = read_turbsim(tmp_path / "a.bts")
        np.testing.assert_allclose(box.velocity, velocity, rtol=1e-6)
        assert (box.time_step, box.spacing, box.bottom) == (0.5, (5.0, 10.0), 80.0)
        assert (box.mean_speed, box.hub_height, box.with_mean) == (12.0, 90.0, True)
        assert (box.periodic, box.shift) == ((False, 5.0) if number == 7 else (True, 0.0))
        assert box.y.tolist() == [-5.0, 0.0, 5.0]
        found = WindField(box=box).velocity([[box.shift, 5.0, 90.0]], 1.0)
        np.testing.assert_allclose(found[0], velocity[2, 1, 2], rtol=1e-6)


@pytest.mark.parametrize("periodic", [True, False])
def test_round_trip_of_turbsim_within_half_a_step_of_the_integers(tmp_path: Path, periodic: bool) -> None:
    box = box_of(periodic=periodic)
    again = read_turbsim(write_turbsim(tmp_path / "new" / "a.bts", box))
    span = np.ptp(box.velocity, axis=(0, 1, 2)).astype(float)
    # besides half a step, the offset is a number of 24 bits
    limit = 0.51 * span / 65535.0 + 1e-7 * np.abs(box.velocity).max()
    assert (np.abs(again.velocity - box.velocity).max(axis=(0, 1, 2)) < limit).all()
    assert replace(again, velocity=box.velocity, shift=0.0).__dict__ == box.__dict__
    twice = read_turbsim(write_turbsim(tmp_path / "b.bts", again))
    assert np.abs(twice.velocity - again.velocity).max() < 1e-4 * span.max()
    data = (tmp_path / "b.bts").read_bytes()
    assert len(data) == 70 + 47 + 2 * box.velocity.size
    assert struct.unpack("<h4i", data[:18]) == (8 if periodic else 7, 3, 4, 0, 7)


def test_calm_components_are_written(tmp_path: Path) -> None:
    velocity = box_of().velocity.copy()
    velocity[..., 1] = 0.0
    again = read_turbsim(write_turbsim(tmp_path / "a.bts", replace(box_of(), velocity=velocity)))
    assert not again.velocity[..., 1].any()


def test_what_cannot_be_written_is_refused(tmp_path: Path) -> None:
    with pytest.raises(WindFileError, match="fluctuations without the mean wind; add the mean wind"):
        write_turbsim(tmp_path / "a.bts", box_of(with_mean=False))
    (tmp_path / "other.bts").write_bytes(turbsim_bytes()[0])
    with pytest.raises(OutputError, match="exists and is not a wind file of pitchpoint"):
        write_turbsim(tmp_path / "other.bts", box_of())
    names = [tmp_path / f"{c}.bin" for c in "uvw"]
    for box, message in (
        (box_of(), "would contain the mean wind"),
        (box_of(with_mean=False, periodic=False), "would not repeat"),
        (box_of(with_mean=False, bottom=80.0), "is not centred at the hub"),
    ):
        with pytest.raises(WindFileError, match=message):
            write_mann(names, box)
    names[2].write_bytes(b"mine")
    with pytest.raises(WindFileError, match=r"w.bin: exists \(limit a new or empty file\)"):
        write_mann(names, box_of(with_mean=False))
    assert not names[0].exists()
    assert names[2].read_bytes() == b"mine"


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda d: d[:40], r"header: 40 bytes are there: the file is cut off \(limit 70 bytes\)"),
        (lambda d: d[:-1], r"byte 268: 268 bytes are there: the file is cut off \(limit 269 bytes\)"),
        (lambda d: d + b"x", r"byte 269: 270 bytes are there, more than .* \(limit 269 bytes\)"),
        (lambda d: b"\4\0" + d[2:], r"byte 0: 4 is not the number of this format \(limit 7 or 8\)"),
        (
            lambda d: d[:2] + struct.pack("<i", -2) + d[6:],
            r"points along z: -2 is not possible \(limit >= 1\)",
        ),
        (lambda d: d[:14] + struct.pack("<i", 2**31 - 1) + d[18:], r"the file is cut off \(limit 103079215"),
        (lambda d: d[:26] + struct.pack("<f", 0.0) + d[30:], r"dt: 0 is not a positive number \(limit > 0\)"),
        (lambda d: d[:30] + struct.pack("<f", np.nan) + d[34:], r"mean speed: nan is not a positive number"),
        (lambda d: d[:42] + struct.pack("<f", 0.0) + d[46:], "scale: has a slope of 0"),
        (
            lambda d: d[:66] + struct.pack("<i", 2**31 - 1) + d[70:],
            r"characters of the text: .*limit 0 to 200",
        ),
        (lambda d: d[:38] + struct.pack("<f", -5.0) + d[42:], r"bottom: -5 m is out of range"),
    ],
)
def test_damaged_files_of_turbsim(tmp_path: Path, change: object, message: str) -> None:
    data = turbsim_bytes()[0]
    assert len(data) == 269
    (tmp_path / "a.bts").write_bytes(change(data))  # type: ignore[operator]
    with pytest.raises(WindFileError, match=message) as raised:
        read_turbsim(tmp_path / "a.bts")
    assert str(raised.value).startswith(str(tmp_path / "a.bts"))


def test_missing_files_and_folders(tmp_path: Path) -> None:
    for name in ("none.bts", ".", "a\0b"):
        with pytest.raises(WindFileError, match="is not a file|cannot be read"):
            read_turbsim(tmp_path / name)


def test_boxes_beyond_the_memory_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "a.bts").write_bytes(turbsim_bytes(0)[0])
    monkeypatch.setattr(errors, "LARGEST", 100)
    with pytest.raises(WindFileError, match="GiB are needed for the box"):
        read_turbsim(tmp_path / "a.bts")


# ------------------------------------------------------------------------------------------------ Mann boxes

GEOMETRY = MannGeometry(points=(4, 3, 2), spacing=(6.0, 5.0, 10.0), mean_speed=12.0, hub_height=90.0)


def mann_files(folder: Path) -> list[Path]:
    """Three files; the value of a point is 100 x + 10 y + z + component/4, in its indices of the file."""
    names = []
    for c in range(3):
        data = b"".join(
            struct.pack("<f", 100 * x + 10 * y + z + 0.25 * c)
            for x in range(4)
            for y in range(3)
            for z in range(2)
        )
        names.append(folder / f"{'uvw'[c]}.bin")
        names[-1].write_bytes(data)
    return names


def test_a_mann_box_value_by_value(tmp_path: Path) -> None:
    """As InflowWind reads it: x in the order of time, y from left (positive) to right, z upward."""
    box = read_mann(mann_files(tmp_path), GEOMETRY)
    assert (box.time_step, box.spacing, box.bottom) == (0.5, (5.0, 10.0), 85.0)
    assert (box.periodic, box.with_mean) == (True, False)
    found = WindField(box=box).velocity([[0.0, 5.0, 85.0], [0.0, -5.0, 95.0], [-12.0, 0.0, 85.0]], 0.5)
    np.testing.assert_allclose(found[:, 0], [100.0, 121.0, 310.0], rtol=1e-6)
    np.testing.assert_allclose(found[:, 2] - found[:, 0], 0.5)


PUBLIC = (
    "LpWPwL0NgcCt3JDAaNyPwDEOGsAiaV7AkqdcwA+UnsCyr9a/wE1Hv+pRfr8nEZc/Ku4DQHeZJkA2C6U+eeC2v68Wjj+du94/LfgN"
    "QKHWskBFPQRBkqABQclUhEAlQCNAYKI6wJHXCcBkkvG/wnYjv3tRT0BG5DpAHrX5PtI9DsCeFZbAGJN3wIode8C8aYnAyx0owICX"
    "asDaCFzAkeSbwN4V7L8gaC6/a1Crv6lzsT94hR5ALUUVQM/9fD9ZRZi/zjAUPyc2wj+nqgVA6y2zQJeHBUFrNPJA0yqUQMvRIkA8"
    "py3AR0cBwLbtAsBe9C2/q4RgQMprF0DMLzc++gMOwA=="
)
"""`MannBox_2x4x8.bin` of openfast_toolbox (Apache 2.0): 2 planes along x, 4 columns, 8 rows."""


def test_a_public_mann_box(tmp_path: Path) -> None:
    """The value in the test of openfast_toolbox, of the leftmost column: second plane, row 5. InflowWind has
    the first column of the file at the left, too, and the planes in the order of time."""
    names = [tmp_path / f"{c}.bin" for c in "uvw"]
    for name in names:
        name.write_bytes(base64.b64decode("".join(PUBLIC)))
    geometry = MannGeometry(points=(2, 4, 8), spacing=(3.0, 10.0, 10.0), mean_speed=6.0, hub_height=90.0)
    wind = WindField(box=read_mann(names, geometry))
    found = wind.velocity([[0.0, 15.0, 105.0], [0.0, -15.0, 105.0]], 0.5)
    np.testing.assert_allclose(found[0], -3.6654968, rtol=1e-7)
    assert abs(found[1, 0] + 3.6654968) > 0.1


def test_round_trip_of_a_mann_box_is_exact(tmp_path: Path) -> None:
    box = box_of(with_mean=False)
    names = [tmp_path / f"{c}.bin" for c in "uvw"]
    geometry = write_mann(names, box)
    assert geometry.points == (7, 4, 3)
    again = read_mann(names, geometry)
    assert (again.velocity == box.velocity).all()
    assert replace(again, velocity=box.velocity).__dict__ == box.__dict__


def test_damaged_mann_boxes(tmp_path: Path) -> None:
    names = mann_files(tmp_path)
    with pytest.raises(WindFileError, match="2 files .limit 3.; name the files of u, v and w"):
        read_mann(names[:2], GEOMETRY)
    wrong = replace(GEOMETRY, points=(4, 3, 3))
    with pytest.raises(WindFileError, match=r"byte 96: 96 bytes .* cut off \(limit 144 bytes\); .*4 x 3 x 3"):
        read_mann(names, wrong)
    with pytest.raises(WindFileError, match="more than the numbers of points require .limit 48 bytes"):
        read_mann(names, replace(GEOMETRY, points=(2, 3, 2)))
    names[1].write_bytes(names[1].read_bytes()[:20] + struct.pack("<f", np.inf) + names[1].read_bytes()[24:])
    with pytest.raises(WindFileError, match="v.bin: value 5: inf is not a finite number"):
        read_mann(names, GEOMETRY)
    names[1].unlink()
    with pytest.raises(WindFileError, match="v.bin: is not a file"):
        read_mann(names, GEOMETRY)


def test_geometries_that_no_box_has() -> None:
    with pytest.raises(ModelError, match="2 problems"):
        replace(GEOMETRY, points=(4, 3, 0), mean_speed=0.0)
    with pytest.raises(ModelError, match="bottom: -10 m is out of range"):
        replace(GEOMETRY, points=(4, 3, 21))
