# SPDX-License-Identifier: Apache-2.0
"""WAV files: integer samples relative to full scale, floating-point samples unchanged.

The chunks are read here and not by a library, because libraries allocate the size given in the header without
checking the data.

References
----------
Microsoft and IBM, Multimedia Programming Interface and Data Specifications 1.0, 1991; EBU Tech 3306 (RF64).
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.io.measured.record import Column, Record, Wanted, as_floats, header_rate, refused, truncated

_PCM, _FLOAT, _EXTENSIBLE = 1, 3, 0xFFFE
_MAX_CHANNELS = 4096


def read_wav(path: Path, data: bytes, wanted: Wanted) -> Record:
    """Read a RIFF, RIFX or RF64 file with linear samples."""
    order = ">" if data[:4] == b"RIFX" else "<"
    if len(data) < 12 or data[8:12] != b"WAVE":
        raise refused(
            path, "byte 8", repr(data[8:12]), "is not a WAVE file", "WAVE", "export the sound as WAV"
        )
    description, samples = _chunks(path, data, order)
    code, channels, rate, _, block, bits = np.frombuffer(
        description[:16], np.dtype(f"{order}u2,{order}u2,{order}u4,{order}u4,{order}u2,{order}u2")
    )[0].tolist()
    if code == _EXTENSIBLE and len(description) >= 26:
        code = int.from_bytes(description[24:26], "big" if order == ">" else "little")
    if not 1 <= channels <= _MAX_CHANNELS or rate < 1 or block * 8 != channels * ((bits + 7) // 8) * 8:
        value = f"{channels} channels at {rate} Hz, {bits} bits in blocks of {block} bytes"
        raise refused(
            path, "fmt", value, "contradict each other", None, "the header is damaged; export it again"
        )
    if len(samples) % block:
        raise truncated(path, (len(samples) // block + 1) * block, len(samples), "bytes of samples")
    values, scale = _decoded(path, samples, code, bits, order)
    table = values.reshape(-1, channels)
    names = [f"channel {k + 1}" for k in range(channels)]
    columns = [
        Column(name, as_floats(table[:, k]), "1" if code == _PCM else "", scale=scale)
        for k, name in enumerate(names)
        if wanted.takes(name)
    ]
    return Record(
        "WAV", tuple(columns), rates=(header_rate(rate),), attributes={"bits_per_sample": int(bits)}
    )


def _chunks(path: Path, data: bytes, order: str) -> tuple[bytes, bytes]:
    """Format and samples."""
    byte_order = "big" if order == ">" else "little"
    description = b""
    long_size: int | None = None
    at = 12
    while at + 8 <= len(data):
        kind, size = data[at : at + 4], int.from_bytes(data[at + 4 : at + 8], byte_order)  # type: ignore[arg-type]
        if kind == b"data" and size == 0xFFFFFFFF and long_size is not None:
            size = long_size
        if at + 8 + size > len(data):
            raise truncated(path, at + 8 + size, len(data))
        body = data[at + 8 : at + 8 + size]
        if kind == b"ds64" and size >= 16:
            long_size = int.from_bytes(body[8:16], "little")
        elif kind == b"fmt " and size >= 16:
            description = body
        elif kind == b"data":
            if not description:
                break
            return description, body
        at += 8 + size + size % 2
    missing = "fmt" if not description else "data"
    raise refused(
        path, "", "", f"has no chunk {missing!r}", "one of each", "the file was cut off or is damaged"
    )


def _decoded(path: Path, samples: bytes, code: int, bits: int, order: str) -> tuple[NDArray[Any], str]:
    """Interleaved numbers of all channels, and their scaling in words."""
    if code == _FLOAT and bits in (32, 64):
        return np.frombuffer(samples, f"{order}f{bits // 8}"), "as stored, floating point"
    if code == _PCM and bits in (8, 16, 24, 32):
        full = float(2 ** (bits - 1))
        scale = f"1 is full scale, {full:.0f} counts of {bits} bits"
        if bits == 8:  # the only unsigned format
            return (np.frombuffer(samples, np.uint8) - 128.0) / full, scale
        if bits == 24:
            raw = np.frombuffer(samples, np.uint8).reshape(-1, 3).astype(np.int32)
            low, high = (0, 2) if order == "<" else (2, 0)
            counts = raw[:, low] | raw[:, 1] << 8 | raw[:, high] << 16
            return (counts - (counts >= 1 << 23) * (1 << 24)) / full, scale
        return np.frombuffer(samples, f"{order}i{bits // 8}") / full, scale
    raise refused(
        path,
        "fmt",
        f"format {code} with {bits} bits",
        "is not supported",
        "8, 16, 24, 32 bits integer or 32, 64 bits float",
        "export it as linear PCM or float",
    )
