# SPDX-License-Identifier: Apache-2.0
"""Files of shared libraries: what prevents one from being loaded, found without loading it."""

from __future__ import annotations

import sys
from pathlib import Path

from pitchpoint.core.errors import Message
from pitchpoint.core.library_header import LIBRARY, own_platform, read_headers
from pitchpoint.core.nearest import nearest

ENDINGS = {"linux": "libdiscon.so", "win32": "DISCON.dll", "darwin": "libdiscon.dylib"}
KINDS = (
    (b"!<arch>\n", "static library", "link its objects to a shared library"),
    (b"PK\x03\x04", "zip archive", "extract the library from it"),
    (b"\x1f\x8b", "compressed file", "extract the library from it"),
)
"""First bytes of files that are confused with libraries."""


def library_problem(path: str, procedure: str) -> Message | None:
    """What prevents a library from being loaded here, without its path in the model; None if nothing does.

    Parameters
    ----------
    path
        The library.
    procedure
        Name of the procedure to be called.
    """
    name = f"'{Path(path).name}'"
    try:
        data = Path(path).read_bytes()
    except OSError as error:
        return Message("", f"cannot be read: {error.strerror}", name, remedy="check the file")
    headers, own = read_headers(data), own_platform()
    if not headers:
        what, remedy = _other(data)
        return Message("", f"is {what}, not a shared library", name, remedy=remedy)
    header = next((each for each in headers if each.platform == own), None)
    if header is None:
        platforms = ", ".join(each.platform for each in headers)
        remedy = "build the library for this system, or get it from its supplier"
        return Message("", f"is for another system, {platforms}", name, own, remedy)
    if header.size > len(data):
        text, limit = f"has {len(data)} bytes and is cut off", f"at least {header.size} bytes"
        return Message("", text, name, limit, "copy the file again")
    if header.kind != LIBRARY:
        article = "an" if header.kind[0] in "aeo" else "a"
        remedy = "link it as a shared library"
        return Message("", f"is {article} {header.kind}, not a shared library", name, remedy=remedy)
    if header.names is not None and procedure not in header.names:
        return Message("", f"has no procedure {procedure}", name, remedy=_remedy(procedure, header.names))
    return None


def _remedy(procedure: str, names: tuple[str, ...]) -> str:
    """Procedure that is probably meant."""
    near = [n for n in names if procedure.lower() in n.lower()] or nearest(procedure, names)
    if near:
        return f"write procedure: {near[0]}"
    own = [n for n in names if not n.startswith("_")]
    listed = f": {', '.join(own[:4])}{', ...' if len(own) > 4 else ''}" if own else ""
    return f"give the name with the key procedure; the library has {len(own)} names{listed}"


def _other(data: bytes) -> tuple[str, str]:
    """Kind of a file that is not a library, and a remedy."""
    for start, words, remedy in KINDS:
        if data.startswith(start):
            return f"a {words}", remedy
    remedy = (
        f"give a library that is built for this system, such as {ENDINGS.get(sys.platform, 'libdiscon.so')}"
    )
    if not data:
        return "empty", "copy the file again"
    text = b"\0" not in data[:4096]
    return ("a text file" if text else "a binary file of another kind"), remedy
