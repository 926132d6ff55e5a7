# SPDX-License-Identifier: Apache-2.0
"""Files of functional mock-up units: model description, and extraction that writes to its folder only.

A file may come from anywhere: names of its entries, their sizes and the description are checked before
anything is written. Source: FMI 2.0.4 and FMI 3.0.2, chapter "FMI description schema".
"""

from __future__ import annotations

import lzma
import math
import platform as host
import stat
import xml.etree.ElementTree as ET
import zipfile
import zlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path, PurePosixPath

from pitchpoint.core.errors import Message, PitchpointError
from pitchpoint.core.library_header import own_platform as this_platform
from pitchpoint.core.library_header import read_headers

DAMAGED = (zipfile.BadZipFile, zlib.error, EOFError, RuntimeError, UnicodeDecodeError, lzma.LZMAError)
"""Errors of damaged archives."""
DESCRIPTION = "modelDescription.xml"
LARGEST = 2_000_000_000
"""Maximum size of all entries [bytes]."""
LARGEST_DESCRIPTION = 100_000_000
"""Maximum size of the model description [bytes]."""
UNSAFE = "do not use this file"
ENTRIES = 20_000
"""Maximum number of entries."""
INTEGERS = ("Integer", "Enumeration", *(f"{sign}Int{bits}" for sign in ("", "U") for bits in (8, 16, 32, 64)))
TYPES = ("Real", "Float64", "Float32", "Boolean", *INTEGERS)
"""Types of variables that a signal can be connected to."""
FORMER = {"x86_64-linux": "linux64", "x86_64-windows": "win64", "x86_64-darwin": "darwin64"}
"""Names of platforms in FMI 2.0."""
ENDINGS = {"linux": ".so", "windows": ".dll", "darwin": ".dylib"}


class FmuFileError(PitchpointError, ValueError):
    """File that is not a functional mock-up unit, or cannot be used here; `problem` is a `Message`."""

    def __init__(self, text: str, limit: str | None = None, remedy: str = "") -> None:
        self.problem = Message("", text, None, limit, remedy or "export the FMU again")
        super().__init__(str(self.problem))


@dataclass(frozen=True)
class FmuVariable:
    """Variable of a unit.

    Parameters
    ----------
    reference
        Value reference.
    type
        Type of FMI, such as "Real" or "Float64".
    causality
        "input", "output", "parameter", "local", ...
    start
        Whether it has a start value.
    unit
        Name of its unit, "" if none.
    factor, offset
        Value in SI units = factor * value + offset.
    scalar
        False for arrays.
    """

    reference: int
    type: str
    causality: str
    start: bool
    unit: str
    factor: float
    offset: float
    scalar: bool


@dataclass(frozen=True)
class FmuFile:
    """Checked file of a unit for co-simulation.

    Parameters
    ----------
    path
        Path of the file.
    version
        Version of FMI, 2 or 3.
    token
        Identifier of the model that the library checks.
    identifier
        Name of the library.
    library
        Entry of the library for this computer.
    variables
        Variables by name.
    saves
        Whether it can save and restore its state.
    """

    path: str
    version: int
    token: str
    identifier: str
    library: str
    variables: Mapping[str, FmuVariable]
    saves: bool = False

    def extract(self, folder: Path) -> None:
        """Write all entries to a folder; the entries are checked again."""
        with _opened(self.path) as archive:
            entries = _checked(archive)
            try:
                for entry in entries:
                    archive.extract(entry, folder)
            except DAMAGED as error:
                raise FmuFileError(_damage(error)) from error


def _damage(error: BaseException) -> str:
    """Reason of a damaged archive; that of Python may contain half of the file."""
    reason = " ".join(str(error).split())
    return f"is damaged: {reason[:120]}{'...' if reason[120:] else ''}"


def own_platform() -> str:
    """Name of the platform of this computer in FMI 3.0."""
    machine = {"AMD64": "x86_64", "arm64": "aarch64"}.get(host.machine(), host.machine())
    return f"{machine}-{host.system().lower()}"


def read_fmu(path: str) -> FmuFile:
    """Read and check the file of a unit.

    Parameters
    ----------
    path
        Path of the file.

    Raises
    ------
    FmuFileError
        If the file is none, is hostile, or has no library for this computer.
    """
    try:
        status = Path(path).stat()
        return _read(path, status.st_mtime_ns, status.st_size)
    except OSError as error:
        raise FmuFileError(f"cannot be read: {error.strerror or error}") from error


@lru_cache(maxsize=64)
def _read(path: str, stamp: int, size: int) -> FmuFile:
    """The unit of a file; `stamp` and `size` are keys of the cache."""
    with _opened(path) as archive:
        entries = {entry.filename: entry for entry in _checked(archive)}
        if DESCRIPTION not in entries:
            raise FmuFileError(f"contains no {DESCRIPTION}", remedy="select an FMU")
        if entries[DESCRIPTION].file_size > LARGEST_DESCRIPTION:
            size, limit = entries[DESCRIPTION].file_size, f"{LARGEST_DESCRIPTION} bytes"
            raise FmuFileError(f"has a {DESCRIPTION} of {size} bytes, which is too large", limit)
        try:
            text = archive.read(DESCRIPTION)
            for entry in entries.values():
                _verify(archive, entry)
        except DAMAGED as error:
            raise FmuFileError(_damage(error)) from error
    if b"<!DOCTYPE" in text or b"<!ENTITY" in text:
        raise FmuFileError(f"has a {DESCRIPTION} with entities, which FMI does not permit")
    try:
        root = ET.fromstring(text)
    except ET.ParseError as error:
        raise FmuFileError(f"has a {DESCRIPTION} that is not XML: {error}") from error
    version = (root.get("fmiVersion") or "")[:2]
    if root.tag != "fmiModelDescription" or not version:
        raise FmuFileError(f"has a {DESCRIPTION} that is not one of FMI")
    if version not in ("2.", "3."):
        wrong = f"is of version {root.get('fmiVersion')} of FMI, which is not supported"
        raise FmuFileError(wrong, "2.0 or 3.0", "export it with one of these")
    interface = root.find("CoSimulation")
    if interface is None:
        raise FmuFileError("is not for co-simulation", remedy="export it for co-simulation")
    if interface.get("needsExecutionTool") == "true":
        raise FmuFileError("needs the program that exported it", remedy="export it with its solver inside")
    identifier = interface.get("modelIdentifier") or ""
    token = root.get("guid" if version == "2." else "instantiationToken") or ""
    saves = "true" in (interface.get("canGetAndSetFMUstate"), interface.get("canGetAndSetFMUState"))
    if not identifier:
        raise FmuFileError(f"has a {DESCRIPTION} without modelIdentifier of its library")
    library = _library(entries, identifier)
    with _opened(path) as archive:
        _check_library(library, archive.read(entries[library]))
    return FmuFile(path, int(version[0]), token, identifier, library, _variables(root), saves)


def _opened(path: str) -> zipfile.ZipFile:
    try:
        return zipfile.ZipFile(path)
    except (zipfile.BadZipFile, RuntimeError, ValueError) as error:
        with Path(path).open("rb") as file:
            begin = file.read(4)
        if begin.startswith(b"PK"):
            raise FmuFileError("is cut off or damaged", remedy="copy the FMU again") from error
        what = "is not a ZIP archive" if begin else "is empty and not a ZIP archive"
        raise FmuFileError(what, remedy="select an FMU") from error


def _checked(archive: zipfile.ZipFile) -> list[zipfile.ZipInfo]:
    """Entries of an archive, without folders.

    Raises
    ------
    FmuFileError
        If an entry would be written outside of the folder, is a link, or all are too large.
    """
    entries = archive.infolist()
    size = sum(entry.file_size for entry in entries)
    if len(entries) > ENTRIES or size > LARGEST:
        raise FmuFileError(
            f"is too large when extracted: {len(entries)} entries with {size} bytes",
            f"{ENTRIES} entries with {LARGEST} bytes",
            UNSAFE,
        )
    seen = set()
    for entry in entries:
        name = entry.filename
        parts = PurePosixPath(name).parts
        if not parts or name.startswith("/") or ".." in parts or "\\" in name or ":" in name or "\0" in name:
            text = f"has the entry {name[:80]!r}, which leads out of the folder of the FMU"
            raise FmuFileError(text, remedy=UNSAFE)
        if stat.S_ISLNK(entry.external_attr >> 16):
            raise FmuFileError(f"has the entry {name[:80]!r}, which is a symbolic link", remedy=UNSAFE)
        if name.lower() in seen:
            raise FmuFileError(f"has the entry {name[:80]!r} twice", remedy=UNSAFE)
        seen.add(name.lower())
    return [entry for entry in entries if not entry.is_dir()]


def _verify(archive: zipfile.ZipFile, entry: zipfile.ZipInfo) -> None:
    """Read an entry completely, which verifies its size and check sum."""
    with archive.open(entry) as file:
        while file.read(1 << 20):
            pass


def _check_library(name: str, data: bytes) -> None:
    """Raise FmuFileError for a library that is none, is for another processor, or is cut."""
    headers, own = read_headers(data), this_platform()
    if not headers:
        raise FmuFileError(f"has the entry {name!r}, which is not a library")
    header = next((each for each in headers if each.platform == own), None)
    if header is None:
        platforms = ", ".join(each.platform for each in headers)
        raise FmuFileError(f"has the library {name!r}, which is for another system, {platforms}", own)
    if header.size > len(data):
        text = f"has the library {name!r}, which has {len(data)} bytes and is cut off"
        raise FmuFileError(text, f"at least {header.size} bytes")


def _library(entries: Mapping[str, zipfile.ZipInfo], identifier: str) -> str:
    """Entry of the library for this computer."""
    own = own_platform()
    ending = ENDINGS.get(own.partition("-")[2], ".so")
    for name in (own, FORMER.get(own, own)):
        if f"binaries/{name}/{identifier}{ending}" in entries:
            return f"binaries/{name}/{identifier}{ending}"
    folders = [e.split("/") for e in entries if e.startswith("binaries/") and e.count("/") >= 2]
    have = sorted({folder[1] for folder in folders})
    if own in have or FORMER.get(own) in have:
        wrong = ", ".join(folder[2] for folder in folders if folder[1] in (own, FORMER.get(own)))
        raise FmuFileError(f"has no library {identifier[:80]}{ending} for {own}, but {wrong}")
    listed = f"libraries for {', '.join(have)}" if have else "no libraries"
    raise FmuFileError(
        f"has no library for this computer, {own}",
        remedy=f"it has {listed}: export it for this platform",
    )


def _variables(root: ET.Element) -> dict[str, FmuVariable]:
    units = dict(_units(root))
    declared = {each.get("name"): each for each in root.iterfind("TypeDefinitions/*")}
    found = {}
    for each in root.iterfind("ModelVariables/*"):
        typed = each if each.tag != "ScalarVariable" else next(iter(each), each)
        kind = declared.get(typed.get("declaredType"))
        if kind is not None and len(kind):
            kind = kind[0]  # FMI 2.0: the type is an element of its own
        unit = typed.get("unit") or (kind.get("unit") if kind is not None else None) or ""
        factor, offset = units.get(unit, (1.0, 0.0))
        found[each.get("name") or ""] = FmuVariable(
            int(_number(each, "valueReference", 0)),
            typed.tag,
            each.get("causality") or "local",
            "start" in typed.attrib or typed.find("Start") is not None,
            unit,
            factor,
            offset,
            each.find("Dimension") is None,
        )
    return found


def _number(element: ET.Element, key: str, default: float) -> float:
    """Finite number of an attribute; factors are not zero."""
    text = element.get(key) or default
    try:
        found = int(text) if key == "valueReference" else float(text)
        if not math.isfinite(found) or (key == "factor" and found == 0.0):
            raise ValueError
        return found
    except (ValueError, OverflowError):
        place = f"{element.get('name') or element.tag}: {key}"
        text = f"has a {DESCRIPTION} with a wrong number, {place} '{text}'"
        raise FmuFileError(text) from None


def _units(root: ET.Element) -> Iterator[tuple[str, tuple[float, float]]]:
    """Factor and offset of every unit to its SI units."""
    for unit in root.iterfind("UnitDefinitions/Unit"):
        base = unit.find("BaseUnit")
        if base is not None:
            values = _number(base, "factor", 1.0), _number(base, "offset", 0.0)
            yield unit.get("name") or "", values
