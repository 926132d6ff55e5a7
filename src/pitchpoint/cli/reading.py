# SPDX-License-Identifier: Apache-2.0
"""Reading the model file of a command, with progress where a large file takes seconds."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

LARGE = 200_000
"""Size of a file from which reading may take longer than people wait without a sign [bytes]."""


def read_model(file: str, allow_code: bool, quiet: bool = False) -> Model:
    """Read a model file; a large one shows how far it is."""
    from pitchpoint.io.yaml_model import load_model

    path = Path(file)
    if quiet or not path.is_file() or path.stat().st_size < LARGE:
        return load_model(file, allow_code=allow_code)
    from pitchpoint.cli.progress import ProgressDisplay

    with ProgressDisplay(f"read {path.name}", "characters") as progress:
        return load_model(file, allow_code=allow_code, progress=progress)
