# SPDX-License-Identifier: Apache-2.0
"""The same short record in every measured format, written by other hands than ours."""

from __future__ import annotations

import gzip
import io
import wave
from pathlib import Path

import h5py
import numpy as np
from scipy.io import savemat, wavfile

RATE = 1000.0
TIME = np.arange(64) / RATE
FORCE = 5.0 + 2.0 * np.sin(2 * np.pi * 125.0 * TIME)
SPEED = np.linspace(10.0, 20.0, TIME.size)


def csv_text(separator: str = ",", decimal: str = ".", header: str = "", stamp: str = "%.6f") -> str:
    """Time, force and speed as text."""
    head = header or separator.join(("time [s]", "force [kN]", "speed [rpm]"))
    rows = (
        separator.join((stamp % t, repr(float(f)), repr(float(v))))
        for t, f, v in zip(TIME, FORCE, SPEED, strict=True)
    )
    body = "\n".join(rows)
    return f"{head}\n{body if decimal == '.' else body.replace('.', decimal)}\n"


def write_csv(path: Path) -> None:
    """A CSV file."""
    path.write_text(csv_text(), encoding="utf-8")


def write_mat(path: Path) -> None:
    """A packed MAT file of version 7 with a structure."""
    savemat(
        path, {"time": TIME, "force": FORCE, "rig": {"speed": SPEED, "name": "north"}}, do_compression=True
    )


def write_plain_mat(path: Path) -> None:
    """A MAT file of version 6."""
    savemat(path, {"force": FORCE, "speed": SPEED, "fs": RATE}, do_compression=False)


def write_mat4(path: Path) -> None:
    """A MAT file of version 4 with a row, a column, a text and the sample rate."""
    content = {"force": FORCE[:, None], "speed": SPEED[None, :], "rig": "north", "fs": RATE, "rpm": 1500.0}
    savemat(path, content, format="4")


def structures(names: tuple[str, ...] = ("force", "speed")) -> dict[str, np.ndarray]:
    """Arrays of structures `X` with a time axis and `Y` with named data, of two rasters."""
    fields = [(name, "O") for name in ("Name", "Data", "Raster", "Unit")]
    x, y = np.zeros((1, 2), fields), np.zeros((1, 3), fields)
    x[0, 0] = ("Time", TIME[None, :], "fast", "s")
    x[0, 1] = ("Time", TIME[None, ::4], "slow", "s")
    y[0, 0] = (names[0], FORCE[None, :], "fast", "kN")
    y[0, 1] = ("temperature", TIME[None, ::4], "slow", "K")
    y[0, 2] = (names[1], SPEED[None, :], "fast", "rpm")
    return {"X": x, "Y": y}


def write_structures(path: Path) -> None:
    """A MAT file with structures in a structure, cells and a header with the sample rate."""
    cells = np.empty(2, dtype=object)
    cells[:] = [FORCE, SPEED]
    header = {"SampFreq": RATE, "XInc": 1.0 / RATE, "XUnit": "s", "Operator": "north"}
    savemat(path, {"Header": header, "c": cells, "Signal": {"y_values": {"values": FORCE}}, "rpm": 1500.0})


def write_packed_csv(path: Path) -> None:
    """A packed CSV file with comments on sample rate and speed."""
    text = "# fs [kHz] = 1\n# rpm: 1500\n" + csv_text()
    path.write_bytes(gzip.compress(text.encode()))


def write_mat73(path: Path) -> None:
    """A MAT file of version 7.3: a block of text, then HDF5 with rows for columns."""
    raw = io.BytesIO()
    with h5py.File(raw, "w", userblock_size=512) as file:
        for name, values in (("time", TIME), ("force", FORCE), ("speed", SPEED)):
            file.create_dataset(name, data=values[None, :]).attrs["MATLAB_class"] = np.bytes_("double")
    head = (
        b"MATLAB 7.3 MAT-file, Platform: GLNXA64, Created on: Mon Jan 01 00:00:00 2024".ljust(124) + b"\0\2IM"
    )
    path.write_bytes(head.ljust(512, b"\0") + raw.getvalue()[512:])


def write_hdf5(path: Path) -> None:
    """An HDF5 file with a group, units, and the sample rate beside the channels."""
    with h5py.File(path, "w") as file:
        group = file.create_group("rig")
        group.create_dataset("force", data=FORCE, compression="gzip").attrs["units"] = "kN"
        group.create_dataset("speed", data=SPEED.astype("f4")).attrs["units"] = "rpm"
        file.attrs["sample_rate"] = RATE


def write_wav(path: Path) -> None:
    """A WAV file of two channels with 16 bits."""
    counts = np.round(np.column_stack((FORCE, SPEED)) * 1000.0).astype(np.int16)
    wavfile.write(path, int(RATE), counts)


def write_float_wav(path: Path) -> None:
    """A WAV file with floating-point samples."""
    wavfile.write(path, int(RATE), np.column_stack((FORCE, SPEED)).astype(np.float32))


def write_24_bit_wav(path: Path, counts: np.ndarray) -> None:
    """A WAV file of one channel with 24 bits."""
    with wave.open(str(path), "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(3)
        file.setframerate(int(RATE))
        file.writeframes(b"".join(int(c).to_bytes(3, "little", signed=True) for c in counts))


def write_uff(path: Path, binary: int = 0) -> None:
    """A universal file with two time responses; needs pyuff."""
    import pyuff

    file = pyuff.UFF(str(path))
    for node, values, unit in ((7, FORCE, "kN"), (9, SPEED, "rpm")):
        data = pyuff.prepare_58(
            binary=binary,
            func_type=1,
            id1="run 12",
            rsp_node=node,
            rsp_dir=3,
            ref_node=0,
            ref_dir=0,
            abscissa_spacing=1,
            abscissa_min=0.0,
            abscissa_inc=1.0 / RATE,
            abscissa_spec_data_type=17,
            ordinate_spec_data_type=13,
            orddenom_spec_data_type=0,
            ordinate_axis_units_lab=unit,
            data=values,
            x=TIME,
        )
        file.write_sets(data, "add")


def write_own(path: Path) -> None:
    """A result file of pitchpoint with a force and a speed."""
    from pitchpoint.io.results import Channel, Header, ResultWriter

    channels = [Channel("mesh_force[stage]", "N"), Channel("speed[g1]", "rad/s")]
    with ResultWriter(path, Header("run", title="pair"), channels) as writer:
        writer.append(TIME, np.column_stack((FORCE, SPEED)))


WRITERS = {
    "csv": write_csv,
    "mat": write_mat,
    "plain.mat": write_plain_mat,
    "v73.mat": write_mat73,
    "h5": write_hdf5,
    "wav": write_wav,
    "float.wav": write_float_wav,
    "own.h5": write_own,
    "v4.mat": write_mat4,
    "structures.mat": write_structures,
    "csv.gz": write_packed_csv,
}
