# SPDX-License-Identifier: Apache-2.0
"""Bad measured files: each ends in a sentence that says where, value, limit and remedy."""

from __future__ import annotations

import os
import struct
import tracemalloc
import zlib

import h5py
import numpy as np
import pytest
from scipy.io import savemat

from pitchpoint.io.measured.reading import read_measured
from pitchpoint.io.measured.record import MeasuredError
from tests.support import measured_files as files

TEXTS = {
    "empty": ("", "a.csv: is empty; copy it again"),
    "zeros": ("\0" * 40, "contains only zeros"),
    "remarks only": ("# a\n% b\n", "holds numbers"),
    "header only": ("time,x\n", "has a header and no rows"),
    "one row": ("time,x\n0,1\n", "is too short for a record (limit 2 or more)"),
    "no numbers": ("a,b\nx,y\nu,v\n", "line 1: 'a,b' has no numbers below it; begin the lines before"),
    "no time": (
        "x,y\n1,2\n3,4\n",
        "neither a time axis nor a sample rate (limit one of them); give sample_rate=",
    ),
    "text in numbers": ("time,x\n0,1\n1,oops\n2,3\n", "x (line 3): 'oops' is not a number"),
    "text far below": (
        "time,x\n" + "".join(f"{k},1\n" for k in range(90)) + "90,?\n91,2\n",
        "x (line 92): '?' is no",
    ),
    "short line": ("time,x\n0,1\n1\n2,3\n", "(line 3): 1 cells are in this line (limit 2)"),
    "header of other width": ("time,x,y\n0,1\n1,2\n", "(line 2): 2 cells are under a header"),
    "nan and inf": (
        "time,x,y\n0,1,1\n1,nan,2\n2,nan,inf\n",
        "x: 2 of 3 samples, first nan at sample 1; y: 1 of 3 samples, first inf at sample 2: are not finite",
    ),
    "empty cell": ("time,x\n0,1\n1,\n2,3\n", "x: 1 of 3 samples, first nan at sample 1"),
    "time stands still": ("time,x\n0,1\n1,2\n1,3\n", "sample 2 at 1 s after 1 s does not increase"),
    "lost samples": (
        "time,x\n0,1\n1,2\n2,3\n9,4\n10,5\n",
        "step 7 s after sample 2 differs from the usual 1 s",
    ),
    "same name": ("time,x,x [N]\n0,1,2\n1,3,4\n", "'x' 2 times are in the file (limit each name once)"),
    "unit of time": ("time [m],x\n0,1\n1,2\n", "time: 'm' is not a unit of time"),
    "thousands": ("time;x\n0;1,5\n1;1.234,5\n", "x (line 3): '1.234,5' is not a number"),
    "comma or column": (
        "1,2\n3,4\n",
        "(line 1): '1,2' may be two columns or one number with a decimal comma",
    ),
    "wrong rate in a remark": ("# sample_rate: 5 m\nx\n1\n2\n", "sample_rate (line 1): '5 m'"),
    "binary": ("x\1\2\3", "holds neither text nor a known measured format"),
}


def refusal(path, **options):
    with pytest.raises(MeasuredError) as caught:
        read_measured(path, **options)
    text = str(caught.value)
    assert text.startswith(str(path)) and "\n" not in text
    return text


@pytest.mark.parametrize("text, sentence", TEXTS.values(), ids=TEXTS.keys())
def test_bad_text_files(tmp_path, text, sentence):
    path = tmp_path / "a.csv"
    path.write_text(text, encoding="utf-8")
    assert sentence in refusal(path)


def test_bad_questions(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text(files.csv_text(), encoding="utf-8")
    assert "did you mean speed?" in refusal(path, channels=["sped"])
    assert "there are force, speed" in refusal(path, channels="zzz")
    assert "'xyz' is not a channel of the file" in refusal(path, units={"xyz": "N"})
    assert "asked for more than once" in refusal(path, channels=["speed", "speed"])
    assert "none is requested" in refusal(path, channels=[])
    assert "2000 Hz contradicts the file (limit 1000 Hz)" in refusal(path, sample_rate=2000.0)
    assert "expected a frequency" in refusal(path, sample_rate="5 m")
    for rate in (0.0, -1.0, float("nan"), float("inf")):
        assert "sample_rate" in refusal(path, sample_rate=rate)


def test_what_is_no_file(tmp_path):
    assert "there is no such file" in refusal(tmp_path / "nothing.wav")
    assert "is not an ordinary file" in refusal(tmp_path)
    pipe = tmp_path / "pipe.csv"
    os.mkfifo(pipe)
    assert "is not an ordinary file" in refusal(pipe)  # and does not wait for a writer


@pytest.mark.parametrize("ending", ["wav", "mat", "h5", "uff"])
def test_wrong_magic(tmp_path, ending):
    path = tmp_path / f"a.{ending}"
    path.write_text("time,x\n0,1\n1,2\n", encoding="utf-8")
    text = refusal(path)
    assert (
        "first bytes: 'time,x\\n0' identify no known format" in text
        and f"but the extension is .{ending}" in text
    )
    files.write_wav(path)
    if ending != "wav":
        assert "identify WAV, but" in refusal(path)


def test_channels_of_different_length(tmp_path):
    path = tmp_path / "a.mat"
    savemat(path, {"time": files.TIME, "force": files.FORCE, "calibration": np.ones(3)})
    assert "samples: calibration 3 differ in length from the rest (limit 64)" in refusal(path)
    assert read_measured(path, channels=["force"]).sizes == {"time": 64}


def test_matrices_that_do_not_say_which_way(tmp_path):
    path = tmp_path / "a.mat"
    savemat(path, {"m": np.ones((4, 4))})
    assert "4 × 4 does not define the direction of time" in refusal(path, sample_rate=1.0)


def test_two_time_axes_and_two_rates(tmp_path):
    path = tmp_path / "a.h5"
    with h5py.File(path, "w") as file:
        for name, rate in (("a", 10.0), ("b", 20.0)):
            file[f"{name}/time"] = np.arange(5) / rate
            file[f"{name}/x"] = np.arange(5.0)
    assert "are different time axes" in refusal(path)
    assert read_measured(path, channels="b/x").sample_rate == pytest.approx(20.0)
    with h5py.File(path, "w") as file:
        for name, rate in (("a", 10.0), ("b", 20.0)):
            file.create_dataset(name, data=np.arange(5.0)).attrs["fs"] = rate
    assert "a/fs 10 Hz, b/fs 20 Hz contradict each other" in refusal(path)


def test_headers_that_promise_four_gigabytes(tmp_path):
    wav = tmp_path / "a.wav"
    files.write_wav(wav)
    data = bytearray(wav.read_bytes())
    data[40:44] = struct.pack("<I", 0xFFFFFFF0)
    wav.write_bytes(data)
    assert "the file promises more" in refusal(wav)

    mat = tmp_path / "a.mat"
    files.write_plain_mat(mat)
    data = bytearray(mat.read_bytes())
    for at, value in ((132, 0xFFFFFFF0), (160, 1 << 30)):  # length of the variable; its number of rows
        broken = data.copy()
        broken[at : at + 4] = struct.pack("<I", value)
        mat.write_bytes(broken)
        assert "the file promises more" in refusal(mat) or "do not fill the array" in refusal(mat)

    hdf = tmp_path / "a.h5"
    with h5py.File(hdf, "w") as file:
        file.create_dataset("x", shape=(1 << 26,), dtype="f8", chunks=(1024,))
        file.create_dataset("y", shape=(1 << 40,), dtype="f8", chunks=(1024,))
    assert "536870912 bytes are promised where 0 are stored" in refusal(hdf, sample_rate=1.0, channels="x")
    assert "1099512 million samples are chosen at once" in refusal(hdf, sample_rate=1.0, channels="y")


def test_a_result_without_signals_over_time(tmp_path):
    from pitchpoint.io.results import Axis, Header, write_tables

    path = tmp_path / "modes.h5"
    write_tables(path, Header("modes"), [Axis("mode", [0, 1])], [])
    assert "is a result of kind modes, without time signals" in refusal(path)


def test_damaged_universal_files(tmp_path):
    path = tmp_path / "a.uff"
    files.write_uff(path)
    text = path.read_text()
    path.write_text(text[: len(text) // 3])
    assert "begins a data set that does not end" in refusal(path)
    path.write_text("    -1\n    58\n    -1\n")
    assert "is not a readable universal file" in refusal(path)
    path.write_text("    -1\n   151\nmodel\n    -1\n")
    assert "no data set 58 hold no time response" in refusal(path)


def packed_zeros(path, count: int, kind: int = 2) -> None:
    """A MAT file with `count` packed bytes of zeros as `x`, as a program that packs its arrays writes it."""
    size = count + (-count % 8)
    head = struct.pack("<IIII", 6, 8, 9, 0) + struct.pack("<IIii", 5, 8, count, 1)
    head += struct.pack("<HH4s", 1, 1, b"x") + struct.pack("<II", kind, count)
    machine = zlib.compressobj(9)
    parts = [machine.compress(struct.pack("<II", 14, len(head) + size) + head)]
    zeros = bytes(1 << 20)
    parts += [machine.compress(zeros[: min(len(zeros), size - k)]) for k in range(0, size, len(zeros))]
    body = b"".join([*parts, machine.flush()])
    mark = b"MATLAB 5.0 MAT-file".ljust(124) + struct.pack("<H2s", 0x0100, b"IM")
    path.write_bytes(mark + struct.pack("<II", 15, len(body)) + body)


def test_packed_arrays_are_bounded_by_their_declared_size(tmp_path, monkeypatch):
    """As many bytes are unpacked as the limit allows, and none of an array that declares more."""
    path = tmp_path / "zeros.mat"
    packed_zeros(path, 1_000_000)
    assert read_measured(path, sample_rate=1.0)["x"].size == 1_000_000
    monkeypatch.setattr("pitchpoint.io.measured.mat.MAX_BYTES", 3_000_000)
    assert "1 million samples are chosen at once (limit 0 million)" in refusal(path, sample_rate=1.0)
    packed_zeros(path, 40_000_000)
    assert path.stat().st_size < 50_000
    tracemalloc.start()
    try:
        assert "40 MB are what its arrays take unpacked (limit 3 MB)" in refusal(path, sample_rate=1.0)
        assert tracemalloc.get_traced_memory()[1] < 1_000_000
    finally:
        tracemalloc.stop()
    data = path.read_bytes()
    lying = zlib.compress(struct.pack("<II", 14, 64) + bytes(5_000_000))
    path.write_bytes(data[:128] + struct.pack("<II", 15, len(lying)) + lying)
    assert "a packed array does not end" in refusal(path, sample_rate=1.0)


@pytest.mark.parametrize("name", ["x", "time"])
def test_packed_hdf5_arrays_are_bounded(name, tmp_path):
    """500 packed blocks of 32 MB of zeros, 16 MB on the disk, would take 16 GB of memory."""
    path = tmp_path / "zeros.h5"
    block = 4_000_000
    packed = zlib.compress(bytes(8 * block))
    with h5py.File(path, "w") as file:
        file["short"] = np.zeros(3)
        made = file.create_dataset(name, (500 * block,), "f8", chunks=(block,), compression="gzip")
        for k in range(500):
            made.id.write_direct_chunk((k * block,), packed)
    assert "2000 million samples are chosen at once (limit 125 million)" in refusal(path, sample_rate=1.0)
