# SPDX-License-Identifier: Apache-2.0
"""Numbers that measured files state: sample rates, speeds, fault orders; structures and repeated names."""

from __future__ import annotations

import io
import struct
import warnings
from pathlib import Path

import h5py
import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from scipy.io import loadmat, savemat

from pitchpoint.io.measured.reading import read_measured
from pitchpoint.io.measured.record import MeasuredError
from tests.support import measured_files as files

REAL = next(
    (found for p in Path(__file__).parents if (found := p / "shared" / "data" / "measured").is_dir()), None
)
SIGNAL = np.random.default_rng(1).standard_normal(2000)
RPM = np.pi / 30.0


def mat(tmp_path, **content):
    savemat(tmp_path / "a.mat", content)
    return tmp_path / "a.mat"


@pytest.mark.parametrize(
    "header, source",
    [
        ({"SampFreq": 12800.0}, "Header.SampFreq"),
        ({"SamplingRate": 12800.0, "XInc": 1 / 12800.0}, "Header.SamplingRate"),
        ({"XInc": 1 / 12800.0, "fs": 12800}, "Header.fs"),
        ({"XDelta": 7.8125e-5}, "Header.XDelta"),
        ({"dx": 7.8125e-5}, "Header.dx"),
        ({"dt_us": 78.125}, "Header.dt_us"),
        ({"sample_rate": "12.8 kHz"}, "Header.sample_rate"),
        ({"sr": 12800.0, "dx": 0.02}, "Header.sr"),
        ({"rate": 12800.0}, "Header.rate"),
        ({"x_values": {"increment": 7.8125e-5, "quantity": {"label": "s"}}}, "Header.x_values.increment"),
        ({"XInc": 0.078125, "XUnit": "ms"}, "Header.XInc"),
    ],
)
def test_the_sample_rate_of_a_header(tmp_path, header, source):
    """78.125 µs is the inverse of 12.8 kHz; a date in the header is no channel."""
    data = read_measured(mat(tmp_path, Header=header | {"Date": np.arange(6.0)}, x=SIGNAL[None, :]))
    assert data.sample_rate == pytest.approx(12800.0, rel=1e-12) and data.sample_rate_from == source
    assert list(data.data_vars) == ["x"] and "Header.Date (6)" in data.notes
    assert ("dx = 0.02 is not the sampling interval" in data.notes) == ("sr" in header)


@pytest.mark.parametrize(
    "header",
    [
        {"x_values": {"increment": 0.5, "quantity": {"label": "Hz"}}},  # a spectrum
        {"XInc": 0.5, "XUnit": "mm"},  # a profile
        {"dx": 25.0},
        {"rate": 25.0},
        {"increment": 1e-3},
        {"fs": np.arange(3.0)},
    ],
)
def test_numbers_that_are_no_sample_rate(tmp_path, header):
    with pytest.raises(MeasuredError, match="neither a time axis nor a sample rate"):
        read_measured(mat(tmp_path, Header=header, x=SIGNAL))


def test_contradictory_sample_rates_are_named_and_the_option_decides(tmp_path):
    path = mat(tmp_path, Header={"SampFreq": 12800.0, "XInc": 1e-4}, x=SIGNAL)
    with pytest.raises(MeasuredError) as caught:
        read_measured(path)
    assert "Header.SampFreq 12800 Hz, Header.XInc 0.0001 s (10000 Hz) contradict" in str(caught.value)
    assert "give the correct one by sample_rate=" in str(caught.value)
    data = read_measured(path, sample_rate=10000.0)
    assert data.sample_rate == 10000.0 and "Header.SampFreq = 12800 Hz contradicts" in data.notes
    with pytest.raises(MeasuredError, match="1000 Hz contradicts the file"):
        read_measured(path, sample_rate=1000.0)
    path = mat(tmp_path, fs=12800.0, time=np.arange(2000) / 1e4, x=SIGNAL)
    with pytest.raises(MeasuredError, match=r"fs: fs 12800 Hz contradicts the time axis \(limit 10000 Hz\)"):
        read_measured(path)
    assert read_measured(path, sample_rate=1e4).sample_rate == pytest.approx(1e4)


def test_a_rate_applies_to_the_channels_of_its_own_structure(tmp_path):
    path = mat(tmp_path, a={"x": SIGNAL, "fs": 1000.0}, b={"y": SIGNAL, "fs": 500.0})
    assert read_measured(path, channels="a.x").sample_rate == 1000.0
    assert read_measured(path, channels="b.y").sample_rate == 500.0
    with pytest.raises(MeasuredError, match="a.fs 1000 Hz, b.fs 500 Hz contradict each other"):
        read_measured(path)


@pytest.mark.parametrize(
    "content, hertz, source",
    [
        ({"X097RPM": 1796.0}, 1796.0 / 60.0, "X097RPM"),
        ({"bearing": {"rate": 25.0}}, 25.0, "bearing.rate"),
        ({"shaft_speed": "1500 rpm"}, 25.0, "shaft_speed"),
        ({"info": {"speed_Hz": 25.0}}, 25.0, "info.speed_Hz"),
        ({"speed": "25 Hz"}, 25.0, "speed"),
    ],
)
def test_speeds_are_attributes_and_are_named(tmp_path, content, hertz, source):
    data = read_measured(mat(tmp_path, fs=12800.0, x=SIGNAL, **content))
    assert data.attrs["shaft_speed"] == pytest.approx(2 * np.pi * hertz)
    assert data.attrs["shaft_speed_from"] == source and f"from {source}" in data.notes


def test_a_speed_without_unit_or_two_speeds_are_not_used(tmp_path):
    data = read_measured(mat(tmp_path, fs=12800.0, x=SIGNAL, shaft_speed=1500.0))
    assert "shaft_speed" not in data.attrs and "shaft_speed = 1500 is a speed without unit" in data.notes
    data = read_measured(mat(tmp_path, fs=12800.0, x=SIGNAL, in_rpm=1500.0, out_rpm=500.0))
    assert "shaft_speed" not in data.attrs and "speeds differ, none is used: 1500 rpm" in data.notes


@pytest.mark.parametrize("base, unit", [(1.0, ""), (30.0, ""), (30.0, "_hz")])
def test_fault_orders_in_turns_or_hertz(tmp_path, base, unit):
    """Nine balls: 3.5848 + 5.4152 = 9 tells orders from hertz."""
    faults = {f"BPFO{unit}": 3.5848 * base, f"BPFI{unit}": 5.4152 * base, f"BSF{unit}": 2.357 * base}
    data = read_measured(mat(tmp_path, fs=12000.0, rpm=1800.0, x=SIGNAL, **faults))
    found = [data.attrs[f"fault_order[{name}]"] for name in ("BPFO", "BPFI", "BSF")]
    assert found == pytest.approx([3.5848, 5.4152, 2.357])
    assert "fault orders of the bearing from the file: BPFO 3.585, BPFI 5.415, BSF 2.357" in data.notes
    data = read_measured(mat(tmp_path, fs=12000.0, x=SIGNAL, BPFO=107.5, BPFI=162.5))
    assert "without a definite unit, not used: BPFO 107.5" in data.notes


def test_comments_of_text_files(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("# fs [kHz] = 12.8\n# XInc: 78.125 us\n# shaft speed = 1800 rpm\nx;y\n1,5;2\n2;3\n")
    data = read_measured(path)
    assert data.sample_rate == 12800.0 and data.attrs["shaft_speed"] == pytest.approx(1800 * RPM)
    path.write_text("# fs = 12800\n# dt = 1e-4\nx\n1\n2\n")
    with pytest.raises(MeasuredError, match=r"fs 12800 Hz, dt 0.0001 s \(10000 Hz\) contradict"):
        read_measured(path)


def test_a_repeated_variable_is_read_under_another_name(tmp_path):
    """The second x is written by hand, because no library writes one; that of the tests keeps one only."""
    path = mat(tmp_path, x=SIGNAL, y=2.0 * SIGNAL, x_2=3.0 * SIGNAL)
    short = struct.pack("<HH", 1, 1)
    path.write_bytes(path.read_bytes().replace(short + b"y\0\0\0", short + b"x\0\0\0"))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        assert sorted(k for k in loadmat(path) if not k.startswith("_")) == ["x", "x_2"]
    data = read_measured(path, sample_rate=1000.0)
    assert len(data.data_vars) == 3
    sums = sorted(float(v.values @ SIGNAL / (SIGNAL @ SIGNAL)) for v in data.data_vars.values())
    assert sums == pytest.approx([1.0, 2.0, 3.0]) and "x is in the file more than once" in data.notes


def test_a_repeated_rate_must_agree(tmp_path):
    path = mat(tmp_path, fs=1000.0, gs=500.0, x=SIGNAL)
    short = struct.pack("<HH", 1, 2)
    path.write_bytes(path.read_bytes().replace(short + b"gs\0\0", short + b"fs\0\0"))
    with pytest.raises(MeasuredError, match="fs 1000 Hz, fs 500 Hz contradict"):
        read_measured(path)


def test_arrays_of_structures_give_channels_their_names_and_time_axes(tmp_path):
    path = mat(tmp_path, N15=files.structures())
    with pytest.raises(MeasuredError, match=r"N15.X\[0\].Data, N15.X\[1\].Data are different time axes"):
        read_measured(path)
    data = read_measured(path, channels=["speed", "force"])
    assert list(data.data_vars) == ["speed", "force"] and data.sample_rate_from == "N15.X[0].Data"
    np.testing.assert_allclose(data["force"], 1000.0 * files.FORCE, rtol=1e-14)
    assert data["speed"].units == "rad/s" and data.sample_rate == pytest.approx(1000.0)
    assert read_measured(path, channels="temperature").sample_rate == pytest.approx(250.0)
    twice = mat(tmp_path, N15=files.structures(names=("a", "a")))
    names = ["N15.Y[0].Data", "N15.Y[2].Data"]
    assert list(read_measured(twice, channels=names).data_vars) == names


def test_cells_and_structures_of_version_73(tmp_path):
    raw = io.BytesIO()
    with h5py.File(raw, "w", userblock_size=512) as file:
        parts = file.create_group("#refs#")
        parts["a"], parts["b"] = files.FORCE[None, :], files.SPEED[None, :]
        words = []
        for name in ("force", "speed"):
            letters = np.array([[ord(c)] for c in name], "u2")
            words.append(parts.create_dataset(f"name {name}", data=letters))
            words[-1].attrs["MATLAB_class"] = np.bytes_("char")
        group = file.create_group("Y")
        group.attrs["MATLAB_class"] = np.bytes_("struct")
        pointers = [[parts["a"].ref], [parts["b"].ref]]
        group.create_dataset("Data", data=np.array(pointers, h5py.ref_dtype))
        group.create_dataset("Name", data=np.array([[w.ref] for w in words], h5py.ref_dtype))
        file["info/SampFreq"] = np.array([[files.RATE]])
        table = file.create_dataset("table", data=np.zeros((1, 6), "u4"))
        table.attrs["MATLAB_object_decode"] = 3
    head = b"MATLAB 7.3 MAT-file".ljust(124) + b"\0\2IM"
    path = tmp_path / "a.mat"
    path.write_bytes(head.ljust(512, b"\0") + raw.getvalue()[512:])
    data = read_measured(path)
    assert list(data.data_vars) == ["force", "speed"] and data.sample_rate_from == "info/SampFreq"
    np.testing.assert_array_equal(data["speed"], files.SPEED)
    assert "an object, such as a table: table" in data.notes


@pytest.mark.parametrize("order", ["<", ">"])
def test_version_4_as_scipy_and_by_hand(tmp_path, order):
    path = tmp_path / "a.mat"
    files.write_mat4(path)
    data = read_measured(path)
    np.testing.assert_array_equal(data["force"], files.FORCE)
    np.testing.assert_array_equal(data["speed"], files.SPEED)
    assert data.attrs["format"] == "MAT 4" and data.sample_rate == 1000.0 and data.attrs["rig"] == "north"
    counts = np.arange(40).astype(f"{order}i2")
    kind = 30 + (1000 if order == ">" else 0)
    path.write_bytes(struct.pack(f"{order}5i", kind, 40, 1, 0, 2) + b"x\0" + counts.tobytes())
    assert read_measured(path, sample_rate=1.0)["x"].values.tolist() == list(range(40))
    path.write_bytes(path.read_bytes()[:-1])
    with pytest.raises(MeasuredError, match="the file promises more"):
        read_measured(path, sample_rate=1.0)
    path.write_bytes(struct.pack("<5i", 0, 1 << 20, 1 << 20, 0, 2) + b"x\0" + bytes(64))
    with pytest.raises(MeasuredError, match=r"8796093022230 bytes"):
        read_measured(path, sample_rate=1.0)


def test_packed_text(tmp_path, monkeypatch):
    path = tmp_path / "a.csv.gz"
    files.write_packed_csv(path)
    data = read_measured(path)
    np.testing.assert_allclose(data["force"], 1000.0 * files.FORCE, rtol=1e-14)
    assert data.attrs["format"] == "CSV" and data.attrs["shaft_speed"] == pytest.approx(1500 * RPM)
    packed = path.read_bytes()
    path.write_bytes(packed[:-20])
    with pytest.raises(MeasuredError, match="packed bytes are there, the file promises more"):
        read_measured(path)
    path.write_bytes(packed)
    monkeypatch.setattr("pitchpoint.io.measured.packed.MAX_BYTES", 1000)
    with pytest.raises(MeasuredError, match="are its contents unpacked"):
        read_measured(path)


def test_records_of_different_length_in_one_file(tmp_path):
    """A file of a well-known bearing rig holds the record before it, too."""
    content = {"X098_DE_time": SIGNAL, "X098RPM": 1772.0, "X099_DE_time": SIGNAL[:-9], "X099RPM": 1750.0}
    path = mat(tmp_path, **content)
    with pytest.raises(MeasuredError, match=r"X098 2000, X099 1991 are records.*\['X099_DE_time'\]"):
        read_measured(path, sample_rate=12000.0)
    data = read_measured(path, sample_rate=12000.0, channels="X099_DE_time")
    assert data.attrs["shaft_speed"] == pytest.approx(1750.0 * RPM)


@pytest.mark.skipif(REAL is None, reason="the records of real rigs are not here")
def test_real_records():
    assert REAL is not None
    with pytest.raises(MeasuredError, match=r"give sample_rate="):
        read_measured(REAL / "cwru" / "normal_0.mat")
    data = read_measured(REAL / "cwru" / "normal_0.mat", sample_rate="12 kHz")
    assert list(data.data_vars) == ["X097_DE_time", "X097_FE_time"] and data.sizes["time"] == 243938
    assert data.attrs["shaft_speed"] == pytest.approx(1796.0 * RPM)
    assert "speed 1796 rpm from X097RPM" in data.notes
    data = read_measured(REAL / "spectraquest" / "b30hz0.csv.gz", sample_rate=12800.0)
    assert list(data.data_vars) == ["a1", "a2", "a3", "a4"] and data.sizes["time"] == 88320
    assert data["a1"].values[0] == 2.35039


def test_a_scale_next_to_whole_numbers_is_named_and_not_used(tmp_path):
    """Whether it multiplies or divides, and in which unit, is not certain."""
    samples = np.round(1000.0 * SIGNAL).astype(np.int16)
    file = mat(tmp_path, rig={"x": samples, "gain": 0.001, "fs": 12800.0}, gain=2.0)
    data = read_measured(file)
    np.testing.assert_array_equal(data["rig.x"].values, samples)
    assert (
        "rig.x has whole numbers, and rig.gain = 0.001 is not used (if it is the value of 1, give"
        in data.notes
    )
    assert "gain = 2" not in data.notes
    given = read_measured(file, units={"rig.x": "0.001 m/s^2"})
    np.testing.assert_allclose(given["rig.x"].values, 0.001 * samples, rtol=1e-15)
    unsigned = mat(tmp_path, x=(samples.astype(int) + 32768).astype(np.uint16), fs=12800.0)
    np.testing.assert_array_equal(read_measured(unsigned)["x"].values, samples + 32768.0)


def test_lines_before_the_names_of_columns_are_named(tmp_path):
    file = tmp_path / "scope.csv"
    rows = "\n".join(f"{k / 12800:.9f},{value:.6f}" for k, value in enumerate(SIGNAL))
    head = "Device PXI\nsample rate: 12.8 kHz\ntime,acc\n"
    file.write_text(head + rows, encoding="utf-8")
    with pytest.raises(MeasuredError, match=r"line 1: 'Device PXI' has no numbers below it; begin the lines"):
        read_measured(file)
    file.write_text("# " + head.replace("\ns", "\n# s") + rows, encoding="utf-8")
    assert read_measured(file).sample_rate == pytest.approx(12800.0, rel=1e-6)


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    separator=st.sampled_from(",;\t "),
    comma=st.booleans(),
    head=st.sampled_from(["", "acc", "acc [m/s^2]", '"acc"']),
    clock=st.booleans(),
    end=st.sampled_from(["\n", "\r\n", "\n\n"]),
    code=st.sampled_from(["utf-8", "utf-8-sig", "utf-16", "latin-1"]),
    form=st.sampled_from(["{:.6f}", "{:.9e}", "{:+.4f}"]),
    values=st.lists(st.floats(-1e4, 1e4, allow_nan=False), min_size=4, max_size=12),
)
def test_texts_of_any_form_are_read_or_refused(
    tmp_path, separator, comma, head, clock, end, code, form, values
):
    """The numbers as written, or a message: never other numbers, never another error.

    Commas that separate and are decimal signs at once are columns of their own.
    """
    assume(separator != "," or not comma)
    rows = [[f"{k / 64:.6f}"] * clock + [form.format(value)] for k, value in enumerate(values)]
    lines = [separator.join(["time [s]"] * clock + [head])] * bool(head)
    lines += [separator.join(cell.replace(".", "," if comma else ".") for cell in row) for row in rows]
    file = tmp_path / "any.txt"
    file.write_bytes((end.join(lines) + end).encode(code))
    try:
        data = read_measured(file, sample_rate=64.0)
    except MeasuredError as error:
        # commas that may be decimal signs or separators; a first column of even steps without a name
        assert comma or not head, str(error)
        return
    found = list(data.data_vars)[-1]
    np.testing.assert_allclose(data[found].values, [float(row[-1]) for row in rows], rtol=1e-12)
