# SPDX-License-Identifier: Apache-2.0
"""Headers of shared libraries (ELF, PE, Mach-O), read without loading: platform, size, exported names.

Sources: System V ABI, chapters 4 and 5 (ELF); Microsoft PE format; Apple mach-o/loader.h and mach-o/fat.h.
"""

from __future__ import annotations

import platform
import struct
import sys
from collections.abc import Iterator
from dataclasses import dataclass

ELF_PROCESSORS = {
    3: "x86",
    62: "x86-64",
    40: "ARM",
    183: "ARM64",
    243: "RISC-V",
    20: "PowerPC",
    21: "PowerPC64",
}
PE_PROCESSORS = {
    0x14C: "x86 (32 bit)",
    0x8664: "x86-64",
    0x1C0: "ARM (32 bit)",
    0x1C4: "ARM (32 bit)",
    0xAA64: "ARM64",
}
MACH_PROCESSORS = {0x7: "x86 (32 bit)", 0xC: "ARM (32 bit)", 0x01000007: "x86-64", 0x0100000C: "ARM64"}
OWN_PROCESSORS = {"x86_64": "x86-64", "amd64": "x86-64", "aarch64": "ARM64", "arm64": "ARM64"}
SYSTEMS = {"linux": "Linux", "win32": "Windows", "darwin": "macOS"}
LIBRARY, OBJECT, PROGRAM, OTHER = "shared library", "object file", "program", "other file"
_ELF_KINDS = {1: OBJECT, 2: PROGRAM, 3: LIBRARY}
_MACH_KINDS = {1: OBJECT, 2: PROGRAM, 6: LIBRARY, 8: LIBRARY}
_BEYOND = (struct.error, IndexError, ValueError, OverflowError)
"""Errors of places that the file does not have."""
_MOST = 1 << 20
"""Largest number of entries of a table that is read."""


@dataclass(frozen=True)
class LibraryHeader:
    """Header of a library, or of a part of it for one processor.

    Attributes
    ----------
    platform
        System and processor, such as `Linux x86-64`.
    kind
        One of `LIBRARY`, `OBJECT`, `PROGRAM`, `OTHER`.
    size
        Size of the file that its tables require [bytes].
    names
        Exported names; None if they are not known.
    """

    platform: str
    kind: str
    size: int
    names: tuple[str, ...] | None


def own_platform() -> str:
    """System and processor of this Python, such as `Linux x86-64`."""
    machine = platform.machine().lower()
    processor = OWN_PROCESSORS.get(machine, machine)
    if sys.maxsize < 2**32:
        processor = {"x86-64": "x86 (32 bit)", "ARM64": "ARM (32 bit)"}.get(processor, processor)
    return f"{SYSTEMS.get(sys.platform, sys.platform)} {processor}"


def read_headers(data: bytes) -> tuple[LibraryHeader, ...]:
    """Headers of a library; several for a universal library of macOS, none if the data are not a library.

    Parameters
    ----------
    data
        Contents of the file, which may be cut off.

    Examples
    --------
    >>> start = b"\\x7fELF" + bytes([2, 1]) + bytes(10) + struct.pack("<HH", 3, 183)
    >>> [(each.platform, each.size > len(start)) for each in read_headers(start)]
    [('Linux ARM64', True)]
    """
    if data[:4] == b"\x7fELF" and len(data) >= 20:
        return _elf(data)
    if data[:2] == b"MZ":
        return _pe(data)
    if data[:4] in (b"\xca\xfe\xba\xbe", b"\xca\xfe\xba\xbf"):
        return _universal(data)
    if data[:4] in (b"\xcf\xfa\xed\xfe", b"\xce\xfa\xed\xfe") and len(data) >= 16:
        return (_mach(data, 0),)
    return ()


# ------------------------------------------------------------------------------------------------------- ELF


def _elf(data: bytes) -> tuple[LibraryHeader, ...]:
    wide, order = data[4] == 2, "<" if data[5] == 1 else ">"
    if data[4] not in (1, 2) or data[5] not in (1, 2):
        return ()
    kind, machine = struct.unpack_from(f"{order}HH", data, 16)
    processor = ELF_PROCESSORS.get(machine, f"processor {machine}")
    if not wide:
        processor = "x32 (x86-64 with 32-bit addresses)" if machine == 62 else f"{processor} (32 bit)"
    if order == ">" and machine in (3, 62):
        processor += ", big-endian"
    size, names = (64 if wide else 52), None
    try:
        heads = struct.unpack_from(f"{order}{'QQ' if wide else 'II'}IHHHHH", data, 32 if wide else 28)
        programs, sections, _, _, program_size, n_programs, section_size, n_sections = heads
        size = max(size, programs + program_size * n_programs, sections + section_size * n_sections)
        for k in range(n_programs):
            at = programs + program_size * k
            (what,) = struct.unpack_from(f"{order}I", data, at)
            place, _, _, length = struct.unpack_from(
                f"{order}{'QQQQ' if wide else 'IIII'}", data, at + (8 if wide else 4)
            )
            size = max(size, place + length * (what == 1))  # loaded segments
        rows = [
            struct.unpack_from(
                f"{order}{'IIQQQQIIQQ' if wide else 'IIIIIIIIII'}", data, sections + section_size * k
            )
            for k in range(n_sections)
        ]
        size = max([size, *(row[4] + row[5] for row in rows if row[1] != 8)])  # 8: without contents
        names = _elf_names(data, rows, wide, order)
    except _BEYOND:
        pass
    return (LibraryHeader(f"Linux {processor}", _ELF_KINDS.get(kind, OTHER), size, names),)


def _elf_names(data: bytes, rows: list[tuple[int, ...]], wide: bool, order: str) -> tuple[str, ...] | None:
    """Defined names of the dynamic symbols (section type 11)."""
    found = []
    for row in rows:
        if row[1] != 11:
            continue
        texts, step = rows[row[6]][4], 24 if wide else 16
        for at in range(row[4], row[4] + min(row[5], step * _MOST), step):
            if wide:
                name, info, _, index = struct.unpack_from(f"{order}IBBH", data, at)
            else:
                name, _, _, info, _, index = struct.unpack_from(f"{order}IIIBBH", data, at)
            if index and info >> 4 and name:  # defined, and not local
                found.append(_text(data, texts + name))
    return tuple(found) or None


def _text(data: bytes, at: int) -> str:
    """Text of a table, which ends with a zero."""
    return data[at : data.index(b"\0", at)].decode("utf-8", "replace")


# -------------------------------------------------------------------------------------------------------- PE


def _pe(data: bytes) -> tuple[LibraryHeader, ...]:
    if len(data) < 64:
        return ()
    (at,) = struct.unpack_from("<I", data, 60)
    if data[at : at + 4] != b"PE\0\0" or len(data) < at + 6:
        return ()
    (machine,) = struct.unpack_from("<H", data, at + 4)
    size, kind, names = at + 24, LIBRARY, None
    try:
        count, _, _, _, optional, flags = struct.unpack_from("<HIIIHH", data, at + 6)
        kind = LIBRARY if flags & 0x2000 else PROGRAM
        table = at + 24 + optional
        size = table + 40 * count
        sections = [struct.unpack_from("<IIII", data, table + 40 * k + 8) for k in range(count)]
        size = max([size, *(place + length for _, _, length, place in sections if place)])
        (magic,) = struct.unpack_from("<H", data, at + 24)
        (exports,) = struct.unpack_from("<I", data, at + 24 + (112 if magic == 0x20B else 96))
        names = _pe_names(data, exports, sections) if exports else ()
    except (*_BEYOND, StopIteration):
        pass
    platform = f"Windows {PE_PROCESSORS.get(machine, f'processor {machine}')}"
    return (LibraryHeader(platform, kind, size, names),)


def _pe_names(data: bytes, exports: int, sections: list[tuple[int, ...]]) -> tuple[str, ...]:
    """Names of the export table."""

    def place(address: int) -> int:
        """Place in the file of an address in memory."""
        return next(p + address - a for _, a, length, p in sections if a <= address < a + length)

    at = place(exports)
    (count,) = struct.unpack_from("<I", data, at + 24)
    (table,) = struct.unpack_from("<I", data, at + 32)
    entries = struct.unpack_from(f"<{min(count, _MOST)}I", data, place(table)) if count else ()
    return tuple(_text(data, place(each)) for each in entries)


# ---------------------------------------------------------------------------------------------------- Mach-O


def _universal(data: bytes) -> tuple[LibraryHeader, ...]:
    """Parts of a universal library. Java classes begin alike, with a large number of parts."""
    if len(data) < 8 or (count := struct.unpack_from(">I", data, 4)[0]) > 20:
        return ()
    form = ">IIIII" if data[3] == 0xBE else ">IIQQII"
    found = []
    for k in range(count):
        place = 8 + struct.calcsize(form) * k
        if place + struct.calcsize(form) > len(data):
            break
        processor, _, at, length, *_ = struct.unpack_from(form, data, place)
        part = data[at : at + length]
        inner = (
            _mach(part, processor) if len(part) >= 16 else LibraryHeader(_mac(processor), LIBRARY, 0, None)
        )
        found.append(LibraryHeader(_mac(processor), inner.kind, at + max(length, inner.size), inner.names))
    return tuple(found)


def _mac(processor: int) -> str:
    return f"macOS {MACH_PROCESSORS.get(processor, f'processor {processor}')}"


def _mach(data: bytes, processor: int) -> LibraryHeader:
    own, _, kind = struct.unpack_from("<III", data, 4)
    wide = data[0] == 0xCF
    names: list[str] | None = None
    size = 32 if wide else 28
    try:
        count, length = struct.unpack_from("<II", data, 16)
        at, size = size, size + length
        for _ in range(min(count, _MOST)):
            command, step = struct.unpack_from("<II", data, at)
            if command in (0x1, 0x19):  # segments
                place, there = struct.unpack_from(
                    "<QQ" if command == 0x19 else "<II", data, at + (40 if command == 0x19 else 32)
                )
                size = max(size, place + there)
            elif command == 0x2:
                names = list(_mach_names(data, at, wide))
            if step < 8:
                break
            at += step
    except _BEYOND:
        pass
    found = tuple(names) if names else None
    return LibraryHeader(_mac(processor or own), _MACH_KINDS.get(kind, OTHER), size, found)


def _mach_names(data: bytes, at: int, wide: bool) -> Iterator[str]:
    """Defined external names of the symbol table, without the underscore of C."""
    first, count, texts, _ = struct.unpack_from("<IIII", data, at + 8)
    for k in range(min(count, _MOST)):
        name, kind = struct.unpack_from("<IB", data, first + (16 if wide else 12) * k)
        if kind & 0x0F == 0x0F:  # external, in a section
            yield _text(data, texts + name).removeprefix("_")
