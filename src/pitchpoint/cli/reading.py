# SPDX-License-Identifier: Apache-2.0
"""Reading of the model file of a command, with progress for large files."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

LARGE = 200_000
"""File size above which a progress display is shown [bytes]."""


def read_model(
    file: str,
    allow_code: bool,
    quiet: bool = False,
    *,
    remarks: bool = True,
    case: Mapping[str, Any] | None = None,
) -> Model:
    """Read a model file, with a progress display for large files, with the values of `--set`.

    `remarks` prints those on numbers of `--set` without unit. `case` has the values of a case of `--vary`.
    """
    from pitchpoint.cli.settings import changes_of, load_case_of_command, say_bare, settings_of_command
    from pitchpoint.model.signal_units import doubtful

    settings = changes_of(settings_of_command(), file)
    case = case or {}
    chosen = load_case_of_command()
    options = dict.fromkeys(settings, "--set") | dict.fromkeys(chosen, "--load-case")
    options |= dict.fromkeys(case, "--vary")
    model = _read(file, allow_code, quiet, {**settings, **chosen, **case}, options)
    if remarks and settings:
        new = (bare for bare in model.origin.bare if not bare.in_file)
        say_bare(doubtful(model, new), options)
    return model


def _read(
    file: str, allow_code: bool, quiet: bool, changes: Mapping[str, Any], options: Mapping[str, str]
) -> Model:
    from pitchpoint.core.progress import silent
    from pitchpoint.io.yaml_model import loads_model
    from pitchpoint.model.reading.yaml_tree import text_of

    path = Path(file)
    text = text_of(file)
    how: Any = {"changes": changes, "options": options}
    if quiet or path.stat().st_size < LARGE:
        return loads_model(text, allow_code, file, silent, **how)
    from pitchpoint.cli.progress import ProgressDisplay

    with ProgressDisplay(f"read {path.name}", "characters") as progress:
        return loads_model(text, allow_code, file, progress, **how)
