# SPDX-License-Identifier: Apache-2.0
"""Measured files: the same record comes out of every format, with units, sample rate and provenance."""

from __future__ import annotations

import hashlib
import sys

import numpy as np
import pytest
from scipy.io import savemat, wavfile

from pitchpoint.core.errors import MissingDependencyError
from pitchpoint.io.measured.reading import read_measured
from pitchpoint.io.measured.record import MeasuredError
from tests.support import measured_files as files

RPM = np.pi / 30.0


def file_of(tmp_path, name, text):
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize(
    "separator, decimal, name",
    [
        (",", ".", "a.csv"),
        (";", ",", "a.csv"),
        ("\t", ",", "a.tsv"),
        (";", ".", "a.txt"),
        (" ", ".", "a.dat"),
        (" ", ",", "a.asc"),
    ],
)
def test_text_files_say_how_they_are_written(tmp_path, separator, decimal, name):
    data = read_measured(file_of(tmp_path, name, files.csv_text(separator, decimal)))
    assert dict(data.sizes) == {"time": 64}
    assert data["force"].units == "N" and data["speed"].units == "rad/s"
    np.testing.assert_allclose(data["time"], files.TIME, rtol=0, atol=1e-12)
    np.testing.assert_allclose(data["force"], 1000.0 * files.FORCE, rtol=1e-14)
    np.testing.assert_allclose(data["speed"], RPM * files.SPEED, rtol=1e-14)
    assert data.sample_rate == pytest.approx(1000.0, rel=1e-9)
    assert data["force"].attrs["units_in_file"] == "kN" and "1000 times" in data["force"].attrs["scale"]


def test_provenance_is_name_format_and_hash(tmp_path):
    path = file_of(tmp_path, "run 1.csv", files.csv_text())
    data = read_measured(path)
    assert data.source_file == "run 1.csv" and data.attrs["format"] == "CSV"
    assert data.sha256 == hashlib.sha256(path.read_bytes()).hexdigest()


def test_remarks_quotes_and_a_row_of_units(tmp_path):
    text = '# rig 4\n% sample rate: 25.6 kHz\n"a;b";"plain"\n"(mm/s)";"V"\n// pause\n1,5;"2"\n\n2,5;3\n'
    data = read_measured(file_of(tmp_path, "a.csv", text))
    assert list(data.data_vars) == ["a;b", "plain"]
    assert data["a;b"].values.tolist() == [0.0015, 0.0025] and data["a;b"].units == "m/s"
    assert data["plain"].units == "V" and "'V' is not converted" in data.notes
    assert data.sample_rate == 25600.0 and data["time"].values.tolist() == [0.0, 1 / 25600]


def test_text_columns_are_left_out_and_named(tmp_path):
    data = read_measured(file_of(tmp_path, "a.csv", "time,state,x\n0,on,1\n1,off,2\n"))
    assert list(data.data_vars) == ["x"]
    assert "omitted because they hold text: state" in data.notes
    with pytest.raises(MeasuredError, match="state: holds text and no numbers"):
        read_measured(tmp_path / "a.csv", channels="state")


def test_utf_16_and_windows_letters(tmp_path):
    text = "time [s]\tweg [µm]\n0\t1\n1\t2\n"
    for code in ("utf-16", "cp1252", "utf-8-sig"):
        (tmp_path / "a.tsv").write_bytes(text.encode(code))
        data = read_measured(tmp_path / "a.tsv")
        assert data["weg"].values.tolist() == pytest.approx([1e-6, 2e-6])


def test_rounded_times_go_back_on_their_grid(tmp_path):
    rate = 25600.0
    rows = "".join(f"{k / rate:.6f},{k}\n" for k in range(500))
    data = read_measured(file_of(tmp_path, "a.csv", "time [s],x\n" + rows))
    # ends rounded to 1 µs over 19.5 ms: the rate is known to 5e-5
    assert data.sample_rate == pytest.approx(rate, rel=1e-4) and "1e-06 s" in data.notes
    exact = read_measured(tmp_path / "a.csv", sample_rate=rate)
    assert exact.sample_rate == rate
    np.testing.assert_allclose(exact["time"], np.arange(500) / rate, atol=1e-15)
    coarse = "".join(f"{k / rate:.4f},{k}\n" for k in range(50))
    with pytest.raises(MeasuredError, match=r"written to 0.0001 s only.*give sample_rate="):
        read_measured(file_of(tmp_path, "b.csv", "time [s],x\n" + coarse))


@pytest.mark.parametrize("name", ["mat", "v73.mat", "h5", "plain.mat"])
def test_files_of_arrays(tmp_path, name):
    path = tmp_path / f"record.{name}"
    files.WRITERS[name](path)
    data = read_measured(path)
    force, speed = (next(n for n in data.data_vars if n.endswith(w)) for w in ("force", "speed"))
    factor, turns = (1000.0, RPM) if name == "h5" else (1.0, 1.0)
    np.testing.assert_allclose(data[force], factor * files.FORCE, rtol=1e-14)
    np.testing.assert_allclose(data[speed], turns * files.SPEED, rtol=1e-6)  # single precision in HDF5
    assert data.sample_rate == pytest.approx(1000.0)
    assert data[force].units == ("N" if name == "h5" else "")
    if name == "mat":
        assert data.attrs["rig.name"] == "north"


@pytest.mark.parametrize("kind", ["i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8"])
def test_every_number_type_of_mat_files(tmp_path, kind):
    values = np.arange(40).astype(kind)
    for packed in (False, True):
        savemat(tmp_path / "a.mat", {"x": values, "parts": {"y": values * 1.0}}, do_compression=packed)
        data = read_measured(tmp_path / "a.mat", sample_rate="2 kHz")
        assert data["x"].values.tolist() == list(range(40)) == data["parts.y"].values.tolist()


def test_mat_matrices_cells_and_what_is_left_out(tmp_path):
    cell = np.empty(2, dtype=object)
    cell[:] = [np.arange(5.0), np.arange(5.0) ** 2]
    content = {
        "m": np.arange(10.0).reshape(2, 5),
        "c": cell,
        "z": np.ones(5) * 1j,
        "e": np.zeros((0, 0)),
        "RPM": 1797.0,
    }
    savemat(tmp_path / "a.mat", content)
    data = read_measured(tmp_path / "a.mat", sample_rate=10.0)
    assert sorted(data.data_vars) == ["c[0]", "c[1]", "m[0]", "m[1]"]
    assert data["m[1]"].values.tolist() == [5, 6, 7, 8, 9] and data["c[1]"].values.tolist() == [
        0,
        1,
        4,
        9,
        16,
    ]
    assert data.attrs["RPM"] == 1797.0
    assert "complex numbers: z" in data.notes and "2 channels of 5 samples" in data.notes
    assert list(read_measured(tmp_path / "a.mat", sample_rate=10.0, channels="m").data_vars) == [
        "m[0]",
        "m[1]",
    ]


def test_a_name_that_ends_in_time_is_no_time_axis(tmp_path):
    """Files of a well-known bearing rig call the signal of the drive end X097_DE_time."""
    savemat(
        tmp_path / "97.mat", {"X097_DE_time": files.FORCE, "X097_FE_time": files.SPEED, "X097RPM": 1796.0}
    )
    with pytest.raises(MeasuredError, match="neither a time axis nor a sample rate.*sample_rate="):
        read_measured(tmp_path / "97.mat")
    assert read_measured(tmp_path / "97.mat", sample_rate=12000).sample_rate == 12000.0


def test_integer_wav_is_a_part_of_full_scale(tmp_path):
    path = tmp_path / "a.wav"
    files.write_wav(path)
    rate, counts = wavfile.read(path)
    data = read_measured(path, units={"channel 1": "50 m/s^2"})
    assert data.sample_rate == rate == 1000
    np.testing.assert_allclose(data["channel 2"], counts[:, 1] / 32768.0, rtol=0, atol=0)
    np.testing.assert_allclose(data["channel 1"], 50.0 * counts[:, 0] / 32768.0, rtol=1e-15)
    assert data["channel 1"].units == "m/s^2" and data["channel 2"].units == "1"
    assert data["channel 2"].attrs["scale"] == "1 is full scale, 32768 counts of 16 bits"


def test_other_widths_of_wav(tmp_path):
    path = tmp_path / "a.wav"
    counts = np.array([0, 1, -1, 2**23 - 1, -(2**23)])
    files.write_24_bit_wav(path, counts)
    assert read_measured(path)["channel 1"].values.tolist() == (counts / 2.0**23).tolist()
    wavfile.write(path, 8000, np.array([0, 128, 255], np.uint8))
    assert read_measured(path)["channel 1"].values.tolist() == [-1.0, 0.0, 127 / 128]
    wavfile.write(path, 8000, np.array([-(2**31), 2**30], np.int32))
    assert read_measured(path)["channel 1"].values.tolist() == [-1.0, 0.5]
    files.write_float_wav(path)
    data = read_measured(path)
    np.testing.assert_array_equal(data["channel 1"], files.FORCE.astype("f4").astype(float))
    assert data["channel 1"].units == "" and "floating point" in data["channel 1"].attrs["scale"]


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")  # pyuff leaves a file open
@pytest.mark.parametrize("binary", [0, 1])
def test_universal_files(tmp_path, binary):
    path = tmp_path / "a.uff"
    files.write_uff(path, binary)
    data = read_measured(path)
    assert list(data.data_vars) == ["7+z", "9+z"] and data.attrs["format"] == "UFF 58"
    np.testing.assert_allclose(data["7+z"], 1000.0 * files.FORCE, rtol=1e-10)
    assert data["9+z"].units == "rad/s" and data.sample_rate == pytest.approx(1000.0)


def test_a_universal_file_without_the_extra_names_it(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "pyuff", None)
    path = file_of(tmp_path, "a.unv", "    -1\n    58\n    -1\n")
    with pytest.raises(MissingDependencyError, match=r"pip install 'pitchpoint\[uff\]'"):
        read_measured(path)


def test_our_results_go_through_the_same_door(tmp_path):
    path = tmp_path / "run.h5"
    files.write_own(path)
    data = read_measured(path, channels=["mesh_force[stage]"])
    assert list(data.data_vars) == ["mesh_force[stage]"] and data["mesh_force[stage]"].units == "N"
    assert data.attrs["format"] == "pitchpoint result" and data.attrs["title"] == "pair"
    np.testing.assert_allclose(
        data["mesh_force[stage]"], files.FORCE, rtol=1e-7
    )  # stored in single precision


def test_constant_channels_are_named_and_kept(tmp_path):
    data = read_measured(file_of(tmp_path, "a.csv", "time,x [N],y\n0,1,1\n1,1,2\n2,1,3\n"))
    assert "x: is constant (1 N)" in data.notes and "x" in data
