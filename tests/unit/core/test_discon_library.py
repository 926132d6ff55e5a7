# SPDX-License-Identifier: Apache-2.0
"""Headers of controller libraries: platforms, cut files, files of other kinds, exported names."""

from __future__ import annotations

import struct

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pitchpoint.core.discon.library_file import library_problem
from pitchpoint.core.library_header import LIBRARY, PROGRAM, own_platform, read_headers
from tests.support.discon_library import discon_library

LINUX = pytest.mark.skipif(not own_platform().startswith("Linux"), reason="the probe is a library of Linux")


@pytest.fixture(scope="module")
def probe() -> bytes:
    return discon_library().read_bytes()


@pytest.fixture
def told(tmp_path):
    def problem(data: bytes, procedure: str = "DISCON") -> str:
        """Sentence on a library with these contents."""
        (tmp_path / "lib.so").write_bytes(data)
        return str(library_problem(str(tmp_path / "lib.so"), procedure) or "")

    return problem


def patched(data: bytes, at: int, form: str, *values: int) -> bytes:
    out = bytearray(data)
    struct.pack_into(form, out, at, *values)
    return bytes(out)


@LINUX
def test_the_probe_can_be_loaded(probe, told):
    [header] = read_headers(probe)
    assert (header.platform, header.kind) == (own_platform(), LIBRARY)
    assert header.size <= len(probe) and "DISCON" in header.names
    assert told(probe) == ""
    assert told(probe, "discon") == "'lib.so' has no procedure discon; write procedure: DISCON"
    assert "the library has " in told(probe, "zzzz") and "DISCON" in told(probe, "zzzz")


@LINUX
def test_platforms_and_kinds_of_elf(probe, told):
    other = 183 if own_platform().endswith("x86-64") else 62
    name = {183: "Linux ARM64", 62: "Linux x86-64"}[other]
    assert told(patched(probe, 18, "<H", other)) == (
        f"'lib.so' is for another system, {name} (limit {own_platform()}); build the library for this "
        "system, or get it from its supplier"
    )
    assert "is for another system, Linux x86 (32 bit)" in told(
        patched(patched(probe, 18, "<H", 3), 4, "B", 1)
    )
    assert "Linux x32 (x86-64 with 32-bit addresses)" in told(
        patched(patched(probe, 18, "<H", 62), 4, "B", 1)
    )
    assert "Linux processor 9999" in told(patched(probe, 18, "<H", 9999))
    assert told(patched(probe, 16, "<H", 1)).startswith("'lib.so' is an object file, not a shared library")
    assert told(patched(probe, 16, "<H", 2)).startswith("'lib.so' is a program, not a shared library")


@LINUX
def test_cut_libraries(probe, told):
    """Whatever is missing at the end, the header states it."""
    [header] = read_headers(probe)
    for length in (20, 63, 64, 100, 1000, len(probe) // 2, header.size - 1):
        limit = header.size if length >= 64 + 56 * 20 else 64
        assert f"has {length} bytes and is cut off (limit at least " in told(probe[:length])
        assert int(told(probe[:length]).split("at least ")[1].split()[0]) >= limit
    for place in (32, 40):  # of the program headers and of the section headers, beyond 63 bits
        assert "is cut off" in told(patched(probe, place, "<Q", (1 << 63) + 64))


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "is empty, not a shared library; copy the file again"),
        (b"1 ! LoggingLevel\n" * 9, "is a text file, not a shared library; give a library that is built for"),
        (b"!<arch>\n" + bytes(90), "is a static library, not a shared library; link its objects"),
        (b"PK\x03\x04" + bytes(90), "is a zip archive, not a shared library; extract the library from it"),
        (b"\x7fEL", "is a text file, not"),
        (b"\x89HDF" + bytes(90), "is a binary file of another kind, not a shared library"),
        (b"\xca\xfe\xba\xbe\0\0\0\x41" + bytes(90), "is a binary file of another kind"),  # Java class
    ],
)
def test_files_of_other_kinds(told, data, words):
    assert f"'lib.so' {words}" in told(data)


def test_a_folder(tmp_path):
    assert "cannot be read: Is a directory" in str(library_problem(str(tmp_path), "DISCON"))


def windows(machine: int = 0x8664, flags: int = 0x2000) -> bytes:
    """A library of Windows with one section that has the export table, by the format of Microsoft."""
    head = b"MZ" + bytes(58) + struct.pack("<I", 64)
    optional = struct.pack("<H", 0x20B) + bytes(110) + struct.pack("<II", 0x1000, 40) + bytes(120)
    coff = b"PE\0\0" + struct.pack("<HHIIIHH", machine, 1, 0, 0, 0, len(optional), flags)
    names = b"lib.dll\0DISCON\0other\0"
    table = struct.pack("<IIIIIIIIII", 0, 0, 0, 0x1030, 1, 2, 2, 0, 0x1028, 0)
    table += struct.pack("<II", 0x1038, 0x103F) + names
    section = struct.pack("<8sIIII", b".edata", len(table), 0x1000, len(table), 512) + bytes(16)
    return (head + coff + optional + section).ljust(512, b"\0") + table


def test_libraries_of_windows():
    [header] = read_headers(windows())
    assert header == type(header)("Windows x86-64", LIBRARY, len(windows()), ("DISCON", "other"))
    assert read_headers(windows(0x14C))[0].platform == "Windows x86 (32 bit)"
    assert read_headers(windows(flags=0))[0].kind == PROGRAM
    for length in (70, 100, 300, 511, 520):
        assert read_headers(windows()[:length])[0].size > length


def mac(processor: int = 0x0100000C) -> bytes:
    """A library of macOS with one segment and a symbol table, by mach-o/loader.h."""
    texts, size = b"\0_DISCON\0_hidden\0", 32 + 72 + 24
    symbols = struct.pack("<IBBHQ", 1, 0x0F, 1, 0, 0) + struct.pack("<IBBHQ", 9, 0x0E, 1, 0, 0)
    segment = struct.pack("<II16sQQQQ", 0x19, 72, b"__TEXT", 0, 0, 0, size) + bytes(16)
    table = struct.pack("<IIIIII", 0x2, 24, size, 2, size + len(symbols), len(texts))
    head = b"\xcf\xfa\xed\xfe" + struct.pack("<IIIIIII", processor, 0, 6, 2, 96, 0, 0)
    return head + segment + table + symbols + texts


def test_libraries_of_macos():
    assert read_headers(mac()) == (
        type(read_headers(mac())[0])("macOS ARM64", LIBRARY, 32 + 72 + 24, ("DISCON",)),
    )
    assert read_headers(mac()[:100])[0].size > 100
    parts = mac(), mac(0x01000007)
    start = 48
    head = struct.pack(">II", 0xCAFEBABE, 2)
    for processor, part in zip((0x0100000C, 0x01000007), parts, strict=True):
        head += struct.pack(">IIIII", processor, 0, start, len(part), 0)
        start += len(part)
    whole = head + b"".join(parts)
    found = read_headers(whole)
    assert [(h.platform, h.names) for h in found] == [
        ("macOS ARM64", ("DISCON",)),
        ("macOS x86-64", ("DISCON",)),
    ]
    assert found[1].size == len(whole)
    assert read_headers(whole[:-1])[1].size > len(whole) - 1


@settings(max_examples=300, deadline=None)
@given(data=st.data())
def test_damaged_headers_are_read_without_error(probe, data):
    """Bytes of the headers changed and the end cut: never an exception, always a platform or none."""
    whole = bytearray(data.draw(st.sampled_from([probe, windows(), mac()])))
    for _ in range(data.draw(st.integers(0, 4))):
        whole[data.draw(st.integers(0, min(200, len(whole) - 1)))] = data.draw(st.integers(0, 255))
    cut = data.draw(st.integers(0, len(whole)))
    for header in read_headers(bytes(whole)[: data.draw(st.sampled_from([cut, len(whole)]))]):
        assert header.platform.startswith(("Linux ", "Windows ", "macOS "))
        assert header.size >= 0
