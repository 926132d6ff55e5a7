# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint run --communication-error`: error of the communication steps of FMUs."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from pitchpoint.cli.output import table

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def communication_error(
    model: Model, name: str, target: Path, *, quiet: bool
) -> dict[str, tuple[float, str]]:
    """Error and unit of every channel of a result, from a run with half of the communication steps.

    Parameters
    ----------
    model, name
        Model with samples that do not depend on the steps, and its scenario.
    target
        Result of the run with the given steps.
    quiet
        Disable the display.
    """
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.io.reading import open_result
    from pitchpoint.solvers.communication_error import finer_run

    title = f"run {name} with half of the communication steps"
    with open_result(target) as coarse, ProgressDisplay(title, "s", quiet=quiet) as progress:
        fine = finer_run(model, name, coarse, progress=progress)
    found = fine.data_vars.items()
    return {
        str(n): (2.0 * float(x.attrs["communication_error"]), str(x.attrs["units"]))
        for n, x in found
        if "communication_error" in x.attrs
    }


def show_error(title: str, errors: Mapping[str, tuple[float, str]]) -> None:
    """Print the errors that are not zero."""
    rows = [[name, f"{error:.3g} {unit}"] for name, (error, unit) in errors.items() if error > 0.0]
    table(f"{title}: error of the communication steps", ["channel", "largest error"], rows)
