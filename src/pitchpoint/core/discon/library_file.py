# SPDX-License-Identifier: Apache-2.0
"""Headers of shared libraries: system, processor and exported names, read without loading the library."""

from __future__ import annotations

import platform
import struct
import sys
from pathlib import Path

from pitchpoint.core.errors import Message

ELF_PROCESSORS = {3: "x86 (32 bit)", 62: "x86-64", 40: "ARM (32 bit)", 183: "ARM64", 243: "RISC-V"}
PE_PROCESSORS = {0x14C: "x86 (32 bit)", 0x8664: "x86-64", 0x1C0: "ARM (32 bit)", 0xAA64: "ARM64"}
MACH_PROCESSORS = {0x7: "x86 (32 bit)", 0x01000007: "x86-64", 0x0100000C: "ARM64"}
OWN_PROCESSORS = {"x86_64": "x86-64", "amd64": "x86-64", "aarch64": "ARM64", "arm64": "ARM64"}
SYSTEMS = {"linux": "Linux", "win32": "Windows", "darwin": "macOS"}
DYNAMIC, SYMBOLS = 3, 11
"""ELF: type of a shared library, type of the section with the exported names."""


def own_platform() -> str:
    """System and processor of this Python, such as `Linux x86-64`."""
    machine = platform.machine().lower()
    processor = OWN_PROCESSORS.get(machine, machine)
    if sys.maxsize < 2**32:
        processor = {"x86-64": "x86 (32 bit)", "ARM64": "ARM (32 bit)"}.get(processor, processor)
    return f"{SYSTEMS.get(sys.platform, sys.platform)} {processor}"


def platforms_of(data: bytes) -> tuple[str, ...]:
    """Systems and processors of a library; empty if the data are not a library.

    Parameters
    ----------
    data
        Start of the file, with all headers.

    Examples
    --------
    >>> platforms_of(b"\\x7fELF" + bytes([2, 1]) + bytes(10) + struct.pack("<HH", 3, 183))
    ('Linux ARM64',)
    """
    try:
        if data[:4] == b"\x7fELF":
            kind, processor = struct.unpack_from("<HH" if data[5] == 1 else ">HH", data, 16)
            return (f"Linux {ELF_PROCESSORS.get(processor, f'processor {processor}')}",) * (kind == DYNAMIC)
        if data[:2] == b"MZ":
            (at,) = struct.unpack_from("<I", data, 60)
            (processor,) = struct.unpack_from("<H", data, at + 4)
            known = PE_PROCESSORS.get(processor, f"processor {processor}")
            return (f"Windows {known}",) * (data[at : at + 4] == b"PE\0\0")
        if data[:4] in (b"\xcf\xfa\xed\xfe", b"\xce\xfa\xed\xfe"):
            return (_mac(struct.unpack_from("<I", data, 4)[0]),)
        if data[:4] == b"\xca\xfe\xba\xbe":
            (count,) = struct.unpack_from(">I", data, 4)
            return tuple(_mac(struct.unpack_from(">I", data, 8 + 20 * k)[0]) for k in range(min(count, 8)))
    except (struct.error, IndexError):
        pass
    return ()


def _mac(processor: int) -> str:
    return f"macOS {MACH_PROCESSORS.get(processor, f'processor {processor}')}"


def exported_names(data: bytes) -> tuple[str, ...] | None:
    """Names that a 64-bit ELF library exports; None if they are not known, as for other formats.

    Parameters
    ----------
    data
        Contents of the library.
    """
    if data[:6] != b"\x7fELF\x02\x01":
        return None
    found = []
    try:
        (start,) = struct.unpack_from("<Q", data, 40)
        width, count = struct.unpack_from("<HH", data, 58)
        sections = [struct.unpack_from("<IIQQQQIIQQ", data, start + width * k) for k in range(count)]
        for section in sections:
            if section[1] != SYMBOLS:
                continue
            texts = sections[section[6]][4]
            for at in range(section[4], section[4] + section[5], 24):
                name, info, _, index = struct.unpack_from("<IBBH", data, at)
                if index and info >> 4 and name:  # defined, and not local
                    end = data.index(b"\0", texts + name)
                    found.append(data[texts + name : end].decode("utf-8", "replace"))
    except (struct.error, IndexError, ValueError):
        return None
    return tuple(found) or None


def library_problem(path: str, procedure: str) -> Message | None:
    """What prevents a library from being loaded here, without its path in the model; None if nothing does.

    Parameters
    ----------
    path
        The library.
    procedure
        Name of the procedure to be called.
    """
    name = Path(path).name
    try:
        data = Path(path).read_bytes()
    except OSError as error:
        return Message("", f"names the library '{name}', which cannot be read: {error.strerror}")
    found, own = platforms_of(data), own_platform()
    if not found:
        return Message(
            "",
            f"names '{name}', which is not a shared library",
            remedy="give a library that is built for this system, such as libdiscon.so or DISCON.dll",
        )
    if own not in found:
        remedy = "build the library for this system, or get it from its supplier"
        return Message(
            "", f"names the library '{name}', which is for another system", ", ".join(found), own, remedy
        )
    names = exported_names(data)
    if names is not None and procedure not in names:
        near = [n for n in names if procedure.lower() in n.lower()]
        remedy = f"write procedure: {near[0]}" if near else "give the name with the key procedure"
        return Message("", f"names the library '{name}', which has no procedure {procedure}", remedy=remedy)
    return None
