# SPDX-License-Identifier: Apache-2.0
"""Controller libraries that are installed as Python packages, found without importing the package."""

from __future__ import annotations

import importlib.util
from pathlib import Path

PACKAGES = {"rosco": "lib/libdiscon"}
"""Packages that contain a controller library, and its place without the suffix of the system."""
SUFFIXES = (".so", ".dll", ".dylib")


def installed_library(name: str) -> Path | None:
    """Controller library of an installed package; None if the package is not installed.

    Parameters
    ----------
    name
        Name of the package, one of `PACKAGES`.

    Examples
    --------
    >>> installed_library("no_package") is None
    True
    """
    found = importlib.util.find_spec(name) if name in PACKAGES else None
    for folder in (found.submodule_search_locations or ()) if found else ():
        for suffix in SUFFIXES:
            file = Path(folder) / (PACKAGES[name] + suffix)
            if file.is_file():
                return file
    return None


def package_of(library: str) -> str | None:
    """Name of the installed package to which a library belongs; None for other files.

    Parameters
    ----------
    library
        Path of the library.

    Examples
    --------
    >>> package_of("libdiscon.so") is None
    True
    """
    for name in PACKAGES:
        found = installed_library(name)
        if found is not None and str(found) == library:
            return name
    return None
