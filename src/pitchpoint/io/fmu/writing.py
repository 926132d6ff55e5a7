# SPDX-License-Identifier: Apache-2.0
"""Archive of a functional mock-up unit: description and libraries."""

from __future__ import annotations

import io
import tempfile
import zipfile
from collections.abc import Sequence
from pathlib import Path

from pitchpoint.io.fmu.description import description
from pitchpoint.io.fmu.linking import PLATFORMS, library
from pitchpoint.io.fmu.model import FmuModel
from pitchpoint.io.fmu.terminals import terminals

_DATE = (1980, 1, 1, 0, 0, 0)
"""Date of the files in the archive: the same model gives the same bytes."""


def fmu_bytes(model: FmuModel, version: int, platforms: Sequence[str]) -> tuple[bytes, dict[str, int]]:
    """Archive of a unit, and the size of the library of each platform [bytes].

    Parameters
    ----------
    model
        The model.
    version
        Version of FMI, 2 or 3.
    platforms
        Keys of `linking.PLATFORMS`.
    """
    files = {"modelDescription.xml": description(model, version).encode()}
    if version == 3 and (shafts := terminals(model)):
        files["terminalsAndIcons/terminalsAndIcons.xml"] = shafts.encode()
    sizes = {}
    with tempfile.TemporaryDirectory(prefix="pitchpoint-") as folder:
        for name in platforms:
            linked = library(model, name, version, Path(folder, name))
            place = PLATFORMS[name].folder_2 if version == 2 else name
            data = linked.read_bytes()
            files[f"binaries/{place}/{linked.name}"] = data
            sizes[name] = len(data)
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, data in files.items():
            archive.writestr(zipfile.ZipInfo(name, _DATE), data, zipfile.ZIP_DEFLATED)
    return out.getvalue(), sizes
