# SPDX-License-Identifier: Apache-2.0
"""Reading of the model file of a command, with progress for large files."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

LARGE = 200_000
"""File size above which a progress display is shown [bytes]."""


def read_model(file: str, allow_code: bool, quiet: bool = False, *, remarks: bool = True) -> Model:
    """Read a model file, with a progress display for large files, and apply the values of `--set`.

    `remarks` prints those on numbers of `--set` without unit.
    """
    from pitchpoint.cli.settings import settings_of_command, with_settings

    return with_settings(_read(file, allow_code, quiet), settings_of_command(), remarks=remarks)


def _read(file: str, allow_code: bool, quiet: bool) -> Model:
    from pitchpoint.io.yaml_model import load_model

    path = Path(file)
    if quiet or not path.is_file() or path.stat().st_size < LARGE:
        return load_model(file, allow_code=allow_code)
    from pitchpoint.cli.progress import ProgressDisplay

    with ProgressDisplay(f"read {path.name}", "characters") as progress:
        return load_model(file, allow_code=allow_code, progress=progress)
